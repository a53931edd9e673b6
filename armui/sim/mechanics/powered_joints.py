"""The motion of six powered joints: limited in speed and acceleration, planned by ruckig.

The joints start and arrive together. The speed percentage changes only the speed; the acceleration
stays the joints' own, so that an arm slowed down in the middle of a motion brakes as hard as before
and never runs past a target at a limit.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Final

from ruckig import (
    ControlInterface,
    InputParameter,
    Result,
    Ruckig,
    RuckigError,
    Synchronization,
    Trajectory,
)

JOINT_COUNT: Final = 6

SixValues = tuple[float, ...]
"""Six values, joint 1 first."""

STANDSTILL: Final[SixValues] = (0.0,) * JOINT_COUNT

SLOWEST_DEG_S: Final = 0.05
"""The slowest speed planned: ruckig refuses motions that take more than two hours."""

_SLACKS: Final = (1.0, 1.0 + 1e-7, 1.0 + 1e-5)
"""Factors on the acceleration, tried in this order."""


class MotionError(RuntimeError):
    """The planner found no motion, for example with an acceleration of 0."""


class JointMotion:
    """The motion of six joints in time, without a clock of its own.

    Attributes:
        positions_deg: The joints' positions.
        speeds_deg_s: Their speeds.
        accelerations_deg_s2: Their accelerations.
        moving: True while a plan is in progress.
    """

    def __init__(self, positions_deg: Iterable[float]) -> None:
        self._planner = Ruckig(JOINT_COUNT)
        self._plan = Trajectory(JOINT_COUNT)
        self._elapsed_s = 0.0
        self._end_deg: SixValues | None = None
        self._asked: tuple[SixValues, SixValues, SixValues] | None = None
        self._acceleration_deg_s2 = STANDSTILL
        self.positions_deg: SixValues = tuple(positions_deg)
        self.speeds_deg_s: SixValues = STANDSTILL
        self.accelerations_deg_s2: SixValues = STANDSTILL
        self.moving = False

    def place(self, positions_deg: Iterable[float]) -> None:
        """Sets the joints' positions at standstill; a plan in progress is dropped."""
        self.positions_deg = tuple(positions_deg)
        self.speeds_deg_s = STANDSTILL
        self.accelerations_deg_s2 = STANDSTILL
        self.moving = False

    def carry(
        self, positions_deg: SixValues, speeds_deg_s: SixValues, accelerations_deg_s2: SixValues
    ) -> None:
        """Sets the state of joints that something else moves; the next plan starts from there."""
        self.positions_deg = positions_deg
        self.speeds_deg_s = speeds_deg_s
        self.accelerations_deg_s2 = accelerations_deg_s2
        self.moving = any(speeds_deg_s)
        self._asked = None
        self._acceleration_deg_s2 = STANDSTILL

    def move_to(
        self,
        targets_deg: Iterable[float],
        speeds_deg_s: Sequence[float],
        accelerations_deg_s2: Sequence[float],
    ) -> None:
        """Plans from the present position and speed to a target; a plan in progress is replaced.

        Args:
            targets_deg: The target angles.
            speeds_deg_s: Highest speed of each joint, at least `SLOWEST_DEG_S`.
            accelerations_deg_s2: Highest acceleration of each joint, above 0.

        Raises:
            MotionError: An acceleration that is not above 0, or a value that is not finite.
        """
        end_deg = tuple(targets_deg)
        asked = end_deg, tuple(speeds_deg_s), tuple(accelerations_deg_s2)
        if self.moving and asked == self._asked:
            return  # hosts repeat a target at 200 Hz: it is in force already
        request = self._request(accelerations_deg_s2)
        request.target_position = list(end_deg)
        request.max_velocity = [max(speed, SLOWEST_DEG_S) for speed in speeds_deg_s]
        self._start(request, end_deg)
        self._asked = asked

    def brake(self, accelerations_deg_s2: Sequence[float]) -> None:
        """Brings every joint to a standstill as fast as its acceleration allows."""
        if not self.moving:
            return
        request = self._request(accelerations_deg_s2)
        request.control_interface = ControlInterface.Velocity
        request.synchronization = Synchronization.No
        request.target_velocity = list(STANDSTILL)
        request.max_velocity = [max(abs(v), SLOWEST_DEG_S) for v in self.speeds_deg_s]
        self._start(request, end_deg=None)
        self._asked = None

    def step(self, dt_s: float) -> None:
        """Advances by `dt_s` seconds along the plan."""
        if not self.moving:
            return
        self._elapsed_s += dt_s
        plan = self._plan
        if self._elapsed_s < plan.duration:
            positions, speeds, accelerations = plan.at_time(self._elapsed_s)
            self.positions_deg = tuple(positions)
            self.speeds_deg_s = tuple(speeds)
            self.accelerations_deg_s2 = tuple(accelerations)
        else:
            self.place(self._end_deg or plan.at_time(plan.duration)[0])

    def _request(self, accelerations_deg_s2: Sequence[float]) -> InputParameter:
        """Return the planner's input with the present state, common to all plans.

        While the joints turn, the acceleration of their plan stays available: with less of it
        they could not stop before a target that lies at a limit.
        """
        if self.moving:
            accelerations_deg_s2 = tuple(map(max, accelerations_deg_s2, self._acceleration_deg_s2))
        self._acceleration_deg_s2 = tuple(accelerations_deg_s2)
        request = InputParameter(JOINT_COUNT)
        request.current_position = list(self.positions_deg)
        request.current_velocity = list(self.speeds_deg_s)
        request.max_acceleration = list(accelerations_deg_s2)
        return request

    def _start(self, request: InputParameter, end_deg: SixValues | None) -> None:
        plan = self._first_plan(request)
        self._plan = plan
        self._elapsed_s = 0.0
        self._end_deg = end_deg
        self.moving = plan.duration > 0.0
        if not self.moving and end_deg is not None:
            self.place(end_deg)

    def _first_plan(self, request: InputParameter) -> Trajectory:
        """Return the first plan that ruckig finds, with as little extra acceleration as possible.

        A joint that is braking already, and has just the way it needs, has no solution in floating
        point; a trace more acceleration gives it one. A joint that turns very slowly cannot
        always be stretched to a long common duration; each joint for itself can be planned.
        """
        accelerations = request.max_acceleration
        for synchronization in (request.synchronization, Synchronization.No):
            request.synchronization = synchronization
            for slack in _SLACKS:
                request.max_acceleration = [slack * value for value in accelerations]
                plan = self._planned(request)
                if plan is not None:
                    return plan
        raise MotionError(f"ruckig cannot plan {request}")

    def _planned(self, request: InputParameter) -> Trajectory | None:
        plan = Trajectory(JOINT_COUNT)
        try:
            result = self._planner.calculate(request, plan)
        except (RuckigError, ValueError):  # ValueError: an unnamed result code
            return None
        return plan if result in (Result.Working, Result.Finished) else None
