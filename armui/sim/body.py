"""The arm's mechanics: joints that are driven, held, or gone limp."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from armui.arm.limits import JointLimits
from armui.sim.gravity import Weight
from armui.sim.hand import Hand
from armui.sim.limp import Limp, LimpJoints
from armui.sim.motion import JOINT_COUNT, STANDSTILL, JointMotion, SixValues
from armui.sim.tool_plan import PathMotion


class Body:
    """Six joints, their power and their motion through time.

    At the start no motor has power and the arm rests, supported, where it is put.

    Attributes:
        positions_deg: Where the joints are, joint 1 first.
        speeds_deg_s: How fast they turn.
        accelerations_deg_s2: How their speeds change under power.
        powered: Which motors have power.
        weight: What gravity pulls at.
    """

    def __init__(self, positions_deg: Iterable[float], weight: Weight | None = None) -> None:
        self.weight = weight or Weight()
        self._motion = JointMotion(positions_deg)
        self._path: PathMotion | None = None
        self._hand: Hand | None = None
        self._limp = LimpJoints(self.weight)
        self.positions_deg: SixValues = self._motion.positions_deg
        self.speeds_deg_s: SixValues = STANDSTILL
        self.accelerations_deg_s2: SixValues = STANDSTILL
        self.powered: tuple[bool, ...] = (False,) * JOINT_COUNT

    @property
    def moving(self) -> bool:
        """Whether the motors are moving joints along a plan."""
        return self._motion.moving if self._path is None else self._path.moving

    @property
    def gives_way(self) -> bool:
        """Whether it goes where a hand leads it."""
        return self._hand is not None

    def power_on(self, indices: Iterable[int]) -> None:
        """Powers motors; each holds its joint where it is."""
        for index in indices:
            if index in self._limp:
                self._limp.catch(index)
                self._place()
            self._set_power(index, on=True)
        self._read_motion()

    def power_off(self, indices: Iterable[int], limp: Limp) -> None:
        """Takes the power from motors; their joints give way to gravity.

        A joint that never had power lies supported, and stays; one that is limp already gives way
        as asked now.
        """
        self._hand = None
        indices = [index for index in indices if self.powered[index] or index in self._limp]
        self._limp.release(indices, limp)
        for index in indices:
            self._set_power(index, on=False)
        if not any(self.powered):
            self._place()
        self._read_motion()

    def move_to(
        self,
        targets_deg: Iterable[float],
        speeds_deg_s: Sequence[float],
        accelerations_deg_s2: Sequence[float],
    ) -> None:
        """Moves all joints; every motor must have power. A motion under way is replaced."""
        self._path = None
        self._motion.move_to(targets_deg, speeds_deg_s, accelerations_deg_s2)

    def follow(self, path: PathMotion) -> None:
        """Moves all joints along a path that begins where they stand; the path says how fast."""
        self._path = path

    def brake(self, accelerations_deg_s2: Sequence[float]) -> None:
        """Brings a motion to its end as fast as the joints allow, along a path where it has one."""
        if self._path is None:
            self._motion.brake(accelerations_deg_s2)
        else:
            self._path.run(0.0)

    def give_way(self, hand: Hand) -> None:
        """Powers all motors to carry the arm's weight and no more; a hand leads it."""
        self.power_on(range(JOINT_COUNT))
        self.halt()
        self._hand = hand

    def hold(self) -> None:
        """Holds the joints against any hand."""
        if self._hand is not None:
            self._hand = None
            self.halt()

    def halt(self) -> None:
        """Stands at once, without regard for what the joints can do."""
        self._place()
        self._read_motion()

    def count_anew(self, positions_deg: Iterable[float]) -> None:
        """Reads other angles where the joints stand, as after a zero was set; nothing moves.

        A plan under way would lead elsewhere: let it end first.
        """
        self.positions_deg = tuple(positions_deg)
        self._place()
        self._read_motion()

    def advance(self, dt_s: float, limits: Sequence[JointLimits]) -> None:
        """Lets time pass."""
        if self._hand is not None:
            led_to, speeds_deg_s = self._hand.advance(self.positions_deg, limits, dt_s)
            self._motion.carry(led_to, speeds_deg_s, STANDSTILL)
            self._read_motion()
            return
        was_moving = self.moving
        self._advance_motion(dt_s)
        if self._limp:
            driven = self._motion.positions_deg
            merged = (
                self.positions_deg[i] if i in self._limp else driven[i] for i in range(JOINT_COUNT)
            )
            self.positions_deg = self._limp.advance(tuple(merged), limits, dt_s)
            self._read_speeds()
        elif was_moving:
            self._read_motion()

    def _advance_motion(self, dt_s: float) -> None:
        path = self._path
        if path is None:
            self._motion.advance(dt_s)
            return
        path.advance(dt_s)
        self._motion.carry(path.positions_deg, path.speeds_deg_s, path.accelerations_deg_s2)
        if not path.moving:
            self._path = None

    def _place(self) -> None:
        self._path = None
        self._motion.place(self.positions_deg)

    def _set_power(self, index: int, *, on: bool) -> None:
        self.powered = (*self.powered[:index], on, *self.powered[index + 1 :])

    def _read_motion(self) -> None:
        """Takes over what the plan says of the joints that are not limp."""
        if self._limp:
            driven = self._motion.positions_deg
            self.positions_deg = tuple(
                self.positions_deg[i] if i in self._limp else driven[i] for i in range(JOINT_COUNT)
            )
        else:
            self.positions_deg = self._motion.positions_deg
        self._read_speeds()

    def _read_speeds(self) -> None:
        motion = self._motion
        if not self._limp:
            self.speeds_deg_s = motion.speeds_deg_s
            self.accelerations_deg_s2 = motion.accelerations_deg_s2
            return
        limp_speeds = self._limp.speeds_deg_s
        self.speeds_deg_s = tuple(
            limp_speeds[i] if i in self._limp else motion.speeds_deg_s[i]
            for i in range(JOINT_COUNT)
        )
        self.accelerations_deg_s2 = tuple(
            0.0 if i in self._limp else motion.accelerations_deg_s2[i] for i in range(JOINT_COUNT)
        )
