"""The arm's mechanics: joints that are driven, held, or without power."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from math import tanh
from typing import Final, Protocol

from armui.arm.limits import JointLimits
from armui.sim.mechanics.driver_loop import LIMP, DriverLoop, DriverSetpoint
from armui.sim.mechanics.gravity import Weight
from armui.sim.mechanics.joint_dynamics import JointLosses
from armui.sim.mechanics.powered_joints import JOINT_COUNT, STANDSTILL, JointMotion, SixValues
from armui.sim.mechanics.unpowered_joints import LimpJoints, UnpoweredJoints

_STIFF_NM: Final = tuple(5.0 * dry_nm for dry_nm in JointLosses().dry_nm)
"""The friction that a stiff joint has beside that of a healthy one: assumed."""
_YIELDS_DEG_NM: Final = 0.3
"""How far a driver lets its joint stay behind for each N·m of such friction: assumed."""
_BREAKS_LOOSE_DEG_S: Final = 2.0
"""About the speed from which on the friction no longer grows."""


class HandGuiding:
    """Moves the joints that give way, as a person's hand would.

    Attributes:
        gripper_to: The opening at which it holds the jaws, in the gripper's unit; None if it does
            not touch them.
    """

    def __init__(self) -> None:
        self._speeds_deg_s: SixValues = STANDSTILL
        self._goal_deg: SixValues | None = None
        self._speed_deg_s = 0.0
        self.gripper_to: float | None = None

    def push(self, speeds_deg_s: Sequence[float]) -> None:
        """Turns each joint at a speed, until another motion is requested."""
        self._goal_deg = None
        self._speeds_deg_s = tuple(speeds_deg_s)

    def lead_to(self, joints_deg: Sequence[float], speed_deg_s: float = 30.0) -> None:
        """Moves all joints to six angles; the joint with the longest way turns at this speed."""
        self._goal_deg = tuple(joints_deg)
        self._speed_deg_s = speed_deg_s

    def release(self) -> None:
        """Releases the arm and its jaws, which stay where they are."""
        self._goal_deg = None
        self._speeds_deg_s = STANDSTILL
        self.gripper_to = None

    def step(
        self, positions_deg: SixValues, stops: Sequence[JointLimits], dt_s: float
    ) -> tuple[SixValues, SixValues]:
        """Return the joints' positions and speeds after a time.

        Args:
            positions_deg: The present positions.
            stops: The mechanical stops.
            dt_s: The time to advance.
        """
        if dt_s <= 0.0:
            return positions_deg, self._speeds_deg_s
        there = self._goal_deg
        if there is None:
            there = tuple(
                positions_deg[i] + self._speeds_deg_s[i] * dt_s for i in range(JOINT_COUNT)
            )
        else:
            gaps = [there[i] - positions_deg[i] for i in range(JOINT_COUNT)]
            share = self._speed_deg_s * dt_s / max(*map(abs, gaps), 1e-9)
            if share < 1.0 - 1e-9:
                there = tuple(positions_deg[i] + share * gaps[i] for i in range(JOINT_COUNT))
        there = tuple(
            min(max(angle, stop.min_deg), stop.max_deg)
            for angle, stop in zip(there, stops, strict=True)
        )
        speeds = tuple((b - a) / dt_s for a, b in zip(positions_deg, there, strict=True))
        return there, speeds


class JointPath(Protocol):
    """A motion of all joints that controls its own speed.

    Attributes:
        positions_deg: The joints' positions.
        speeds_deg_s: Their speeds.
        accelerations_deg_s2: Their accelerations.
        moving: True if the joints turn, or are about to.
    """

    @property
    def positions_deg(self) -> SixValues: ...  # noqa: D102 - above
    @property
    def speeds_deg_s(self) -> SixValues: ...  # noqa: D102 - above
    @property
    def accelerations_deg_s2(self) -> SixValues: ...  # noqa: D102 - above
    @property
    def moving(self) -> bool: ...  # noqa: D102 - above

    def run(self, share: float) -> None:
        """Goes on with a share of its speed; 0 brakes."""
        ...

    def step(self, dt_s: float) -> None:
        """Advances by `dt_s` seconds."""
        ...


class Mechanics:
    """Six joints, their power and their motion through time.

    At the start no motor has power, and the arm is supported.

    Attributes:
        positions_deg: The joints' positions, joint 1 first.
        speeds_deg_s: Their speeds.
        accelerations_deg_s2: Their accelerations under power.
        powered: For each motor, true if it has power.
        weight: The loads on the joints.
        drag_nm: The dry friction that powered joints have beside the drivers' model, normally none;
            they stay behind by it.
    """

    def __init__(self, positions_deg: Iterable[float], weight: Weight | None = None) -> None:
        self.weight = weight or Weight()
        self._motion = JointMotion(positions_deg)
        self._path: JointPath | None = None
        self._hand: HandGuiding | None = None
        self._loop = DriverLoop(self.weight)
        self._sag_deg: SixValues = STANDSTILL
        self.drag_nm: SixValues = STANDSTILL
        self._limp = LimpJoints(self.weight)
        self.positions_deg: SixValues = self._motion.positions_deg
        self.speeds_deg_s: SixValues = STANDSTILL
        self.accelerations_deg_s2: SixValues = STANDSTILL
        self.powered: tuple[bool, ...] = (False,) * JOINT_COUNT

    @property
    def moving(self) -> bool:
        """True if the motors are moving joints along a plan."""
        return self._motion.moving if self._path is None else self._path.moving

    @property
    def setpoints_deg(self) -> SixValues:
        """The joints' setpoints in the controller; joints differ from them only by their sag."""
        return self._motion.positions_deg

    @property
    def sag_deg(self) -> SixValues:
        """The distance of each powered joint from its setpoint under its load; 0 at first.

        Joints that are caught or halted are held in place without sag; it begins with a motion.
        """
        return self._sag_deg

    @sag_deg.setter
    def sag_deg(self, sag_deg: Iterable[float]) -> None:
        self._sag_deg = tuple(sag_deg)
        self._read_motion()

    @property
    def gives_way(self) -> bool:
        """True if a hand can move the joints."""
        return self._hand is not None

    def stiffen(self, index: int, *, stiff: bool) -> None:
        """Makes a joint (0–5) turn stiffly, or easily again."""
        drag_nm = _STIFF_NM[index] if stiff else 0.0
        self.drag_nm = (*self.drag_nm[:index], drag_nm, *self.drag_nm[index + 1 :])

    def friction_nm(self, index: int) -> float:
        """Return the torque by which its drag resists the present turn of a joint (0–5)."""
        return self.drag_nm[index] * tanh(self._motion.speeds_deg_s[index] / _BREAKS_LOOSE_DEG_S)

    def power_on(self, indices: Iterable[int]) -> None:
        """Powers motors; each holds its joint in place."""
        for index in indices:
            is_caught = index in self._limp or (not self.powered[index] and self._sag_deg[index])
            self._limp.catch(index)
            self._set_power(index, on=True)
            if is_caught:
                self._place()
        self._read_motion()

    def power_off(self, indices: Iterable[int], unpowered: UnpoweredJoints) -> None:
        """Switches motors off; their joints give way to gravity.

        A joint that never had power is supported, and stays; one that is limp already changes to
        this manner of giving way.
        """
        self._hand = None
        indices = [index for index in indices if self.powered[index] or index in self._limp]
        self._loop.void(indices)
        self._limp.release(indices, unpowered)
        for index in indices:
            self._set_power(index, on=False)
        if not any(self.powered):
            self._place()
        self._read_motion()

    @property
    def driver_torques_nm(self) -> Mapping[int, float]:
        """The torques of the drivers that follow setpoints without a plan, by joint (0–5)."""
        return self._loop.torques_nm

    def drop_setpoints(self, indices: Iterable[int]) -> None:
        """Leaves motors powered without a setpoint: their joints fall."""
        self._hand = None
        for index in indices:
            self.steer(index, LIMP)

    def steer(self, index: int, setpoint: DriverSetpoint) -> None:
        """Gives a powered joint a setpoint that its driver follows without a plan.

        A plan in progress is dropped. Without power nothing happens.
        """
        if not self.powered[index]:
            return
        is_new = index not in self._loop
        self._loop.set(index, setpoint, self.speeds_deg_s[index])
        if is_new:
            self._place()

    def move_to(
        self,
        targets_deg: Iterable[float],
        speeds_deg_s: Sequence[float],
        accelerations_deg_s2: Sequence[float],
    ) -> None:
        """Moves all joints; every motor must have power. A motion in progress is replaced."""
        self._take_up()
        self._path = None
        self._motion.move_to(targets_deg, speeds_deg_s, accelerations_deg_s2)

    def follow_path(self, path: JointPath) -> None:
        """Moves all joints along a path that begins at their setpoints and has its own speed."""
        self._take_up()
        self._path = path

    def follows(self, path: JointPath) -> bool:
        """Return whether the joints move along this path."""
        return self._path is path

    def brake(self, accelerations_deg_s2: Sequence[float]) -> None:
        """Ends a motion as fast as the joints allow; on a path, along the path.

        Joints that follow setpoints without a plan go on.
        """
        if self._loop:
            return
        if self._path is None:
            self._motion.brake(accelerations_deg_s2)
        else:
            self._path.run(0.0)

    def give_way(self, hand_guiding: HandGuiding) -> None:
        """Powers all motors only to carry the arm's weight, so that a hand can lead it."""
        self.power_on(range(JOINT_COUNT))
        self.halt()
        self._hand = hand_guiding

    def hold(self) -> None:
        """Holds the joints in place against a hand."""
        if self._hand is not None:
            self._hand = None
            self.halt()

    def halt(self) -> None:
        """Stops the joints instantly, without regard for their limits."""
        self._loop.void()
        self._place()
        self._read_motion()

    def count_anew(self, positions_deg: Iterable[float]) -> None:
        """Sets the angles at which the joints stand, as after a zero was set; nothing moves.

        Let a plan in progress end first, because it would lead elsewhere. So would setpoints
        without a plan, which are dropped: those joints fall until the next setpoint.
        """
        self.positions_deg = tuple(positions_deg)
        self.drop_setpoints(list(self.driver_torques_nm))
        self._place()
        self._read_motion()

    def step(self, dt_s: float, limits: Sequence[JointLimits]) -> None:
        """Advances by `dt_s` seconds."""
        if self._hand is not None:
            led_to, speeds_deg_s = self._hand.step(self.positions_deg, limits, dt_s)
            self._motion.carry(self._without_sag(led_to), speeds_deg_s, STANDSTILL)
            self._read_motion()
            return
        was_moving = self.moving or bool(self._loop)
        self._advance_motion(dt_s, limits)
        if self._limp:
            self.positions_deg = self._limp.step(self._driven_and_limp(), limits, dt_s)
            self._read_speeds()
        elif was_moving:
            self._read_motion()

    def _advance_motion(self, dt_s: float, stops: Sequence[JointLimits]) -> None:
        if self._loop:
            there, speeds_deg_s = self._loop.step(self.positions_deg, stops, dt_s)
            self._motion.carry(self._without_sag(there), speeds_deg_s, STANDSTILL)
            return
        path = self._path
        if path is None:
            self._motion.step(dt_s)
            return
        path.step(dt_s)
        self._motion.carry(path.positions_deg, path.speeds_deg_s, path.accelerations_deg_s2)
        if not path.moving:
            self._path = None

    def _place(self) -> None:
        """Holds every joint where it stands."""
        self._path = None
        self._motion.place(self._without_sag(self.positions_deg))

    def _take_up(self) -> None:
        """Hands joints that fell or followed setpoints over to the planner, with their motion."""
        if self._loop:
            self._loop.void()
            self._motion.carry(self._without_sag(self.positions_deg), self.speeds_deg_s, STANDSTILL)

    def _holds(self, index: int) -> bool:
        return self.powered[index] and index not in self._limp and index not in self._loop

    def _without_sag(self, positions_deg: SixValues) -> SixValues:
        """Return the setpoints with which the joints, with their sag, stand at these positions."""
        return self._shifted(positions_deg, -1.0)

    def _behind(self, setpoints_deg: SixValues) -> SixValues:
        """Return the positions of joints driven to setpoints: off by their sag and drag."""
        there = self._shifted(setpoints_deg, 1.0)
        if self._hand is not None or not any(self.drag_nm):
            return there
        return tuple(
            angle - _YIELDS_DEG_NM * self.friction_nm(i) if self._holds(i) else angle
            for i, angle in enumerate(there)
        )

    def _shifted(self, positions_deg: SixValues, sign: float) -> SixValues:
        """Return the angles moved by the sag of the joints that are held."""
        if not any(self._sag_deg):
            return positions_deg
        return tuple(
            angle + sign * sag if self._holds(i) else angle
            for i, (angle, sag) in enumerate(zip(positions_deg, self._sag_deg, strict=True))
        )

    def _driven_and_limp(self) -> SixValues:
        """Return the planned positions of driven joints, and the present ones of limp joints."""
        driven = self._behind(self._motion.positions_deg)
        return tuple(
            self.positions_deg[i] if i in self._limp else driven[i] for i in range(JOINT_COUNT)
        )

    def _set_power(self, index: int, *, on: bool) -> None:
        self.powered = (*self.powered[:index], on, *self.powered[index + 1 :])

    def _read_motion(self) -> None:
        """Takes over the plan's motion for the joints that are not limp."""
        if self._limp:
            self.positions_deg = self._driven_and_limp()
        else:
            self.positions_deg = self._behind(self._motion.positions_deg)
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
