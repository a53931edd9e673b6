"""The motion in progress: started, slowed, paused, continued, ended early or completed."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

from armui.arm.limits import JOINTS, check_joint
from armui.protocol.codes import ArmStatusCode, MotionState, MoveMode
from armui.sim.condition import Condition
from armui.sim.mechanics.mechanics import Mechanics
from armui.sim.mechanics.powered_joints import MotionError, SixValues
from armui.sim.motion.tool_plan import PathMotion, PlanningError
from armui.sim.parameters.settings import ArmSettingsRecord

Leg = SixValues | PathMotion | Callable[[SixValues], PathMotion | None]
"""A part of a motion: six target angles, a path, or a function that plans one from the present
joint angles. It returns None if the arm has no way left to go."""

_NOTHING: Final = object()

_PARTS: Final = 3


class MotionExecutor:
    """Carries out one order of the host at a time; the next replaces it.

    An order is any comparable form of the host's command: hosts repeat themselves at 200 Hz, and an
    order that is in progress, done or refused is not begun again.

    Attributes:
        targets_deg: The end of the last accepted order.
        paused: True while a pause is in force. It holds back an order that replaces the paused one,
            and ends when that is aborted.
    """

    def __init__(
        self, mechanics: Mechanics, condition: Condition, settings: ArmSettingsRecord
    ) -> None:
        self._mechanics = mechanics
        self._condition = condition
        self._settings = settings
        self._legs: list[Leg] = []
        self._running: PathMotion | None = None
        self._move_mode = MoveMode.MOVE_J
        self._order: Hashable = _NOTHING
        self._settled: tuple[object, ...] = ()
        self.paused = False
        self.targets_deg: SixValues = mechanics.positions_deg

    @property
    def may_move(self) -> bool:
        """True if the arm is in a state to accept targets at all."""
        return self._condition.may_move and all(self._mechanics.powered)

    def serves(self, order: Hashable) -> bool:
        """Return whether this order is in progress, or was done or refused just here."""
        return self.pursues(order) or (order == self._order and self._settled == self._conditions())

    def pursues(self, order: Hashable) -> bool:
        """Return whether this order is in progress."""
        return bool(self._legs) and order == self._order

    def begin(
        self, order: Hashable, legs: Sequence[Leg], move_mode: MoveMode, end_deg: SixValues
    ) -> None:
        """Begins an order; the motion before it is replaced.

        Args:
            order: The host's command.
            legs: The parts of the way, in order. A path begins where the leg before it ends.
            move_mode: The kind of motion; another one aborts the order.
            end_deg: The joint angles at its end.
        """
        self._condition.accept_target()
        self._order, self._legs, self._move_mode = order, list(legs), move_mode
        self._running = None
        self.targets_deg = end_deg
        self.drive()

    def refuse(self, order: Hashable, planning_error: PlanningError) -> None:
        """Reports why an order cannot be carried out; the arm stays, or brakes."""
        condition = self._condition
        condition.accept_target()
        condition.no_solution = planning_error.status is ArmStatusCode.NO_SOLUTION
        condition.singular = planning_error.status is ArmStatusCode.SINGULARITY
        condition.beyond_limit = list(planning_error.beyond)
        self.abort_motion()
        self._order, self._settled = order, self._conditions()

    def mode_changed(self) -> None:
        """Ends or adapts the motion after a change of mode or speed in `condition`."""
        if not self._condition.obeys(self._move_mode):
            self.abort_motion()
        else:
            self.drive()

    def pause(self) -> None:
        """Brakes, along the path if there is one, and keeps the order; at rest it does nothing."""
        if self._legs:
            self.paused = True
            self._brake()

    def go_on(self) -> None:
        """Ends a pause."""
        self.paused = False
        self.drive()

    def abort_motion(self) -> None:
        """Brakes; the order counts as not reached. A pause ends with it."""
        self.drop_order()
        self._brake()

    def drop_order(self) -> None:
        """Drops the order and a pause; the caller stops the joints."""
        self._legs.clear()
        self._running = None
        self._order = _NOTHING
        self.paused = False

    def drive(self) -> None:
        """Continues the present leg at the speed percentage."""
        if not self._legs:
            return
        if self.paused or not self._share:
            self._brake()
            return
        leg = self._legs[0]
        if isinstance(leg, tuple):
            self._drive_joints(leg)
        else:
            self._drive_path(leg)

    def time_passed(self) -> None:
        """Detects the end of a leg, and begins the next."""
        if not self._legs:
            return
        leg = self._legs[0]
        if isinstance(leg, tuple):
            if self._mechanics.setpoints_deg == leg:
                self._next_leg()
        elif self._running is None:
            self.drive()
        elif self._running.at_end:
            self._next_leg()

    @property
    def _share(self) -> float:
        return self._condition.speed_percent / 100.0

    def _drive_joints(self, goal_deg: SixValues) -> None:
        limits = self._settings.limits
        speeds = [self._share * each.max_speed_deg_s for each in limits]
        try:
            self._mechanics.move_to(goal_deg, speeds, self._settings.accelerations_deg_s2)
        except MotionError:
            self._mechanics.halt()
            self.refuse(self._order, PlanningError(ArmStatusCode.NO_SOLUTION))
            return
        if self._mechanics.moving:
            self._condition.motion_state = MotionState.NOT_REACHED
        else:
            self._next_leg()

    def _drive_path(self, leg: PathMotion | Callable[[SixValues], PathMotion | None]) -> None:
        """Runs along a path; one not begun waits until the joints stand."""
        if self._running is None:
            if self._mechanics.moving:
                self._brake()
                return
            try:
                path = leg if isinstance(leg, PathMotion) else leg(self._mechanics.setpoints_deg)
            except PlanningError as planning_error:
                self.refuse(self._order, planning_error)
                return
            if path is None:
                self._next_leg()
                return
            self._running = path
            self.targets_deg = path.end_deg
        self._condition.motion_state = MotionState.NOT_REACHED
        self._running.run(self._share)
        self._mechanics.follow_path(self._running)

    def _next_leg(self) -> None:
        self._running = None
        del self._legs[0]
        if self._legs:
            self.drive()
        else:
            self._settled = self._conditions()
            self._condition.motion_state = MotionState.REACHED

    def _brake(self) -> None:
        self._mechanics.brake(self._settings.accelerations_deg_s2)

    def _conditions(self) -> tuple[object, ...]:
        """Return the facts an order's outcome depends on: once they change, it is tried again."""
        settings = self._settings
        return (
            self._mechanics.positions_deg,
            tuple(settings.limits),
            tuple(settings.accelerations_deg_s2),
            settings.end_limits,
        )


@dataclass(eq=False, repr=False)
class JointMoves:
    """Collects the three frames of a joint target and has it carried out.

    A complete target waits until the arm is in CAN control and MOVE J; then it starts at once and
    replaces the one before. Nothing is kept for an arm that cannot move, so neither enabling its
    motors nor ending a stop ever sets it in motion. Targets that are not planned (high-follow) are
    passed on.
    """

    _executor: MotionExecutor
    _condition: Condition
    _settings: ArmSettingsRecord
    _follow: Callable[[SixValues], None]
    _fresh: set[frozenset[int]] = field(default_factory=set, init=False)
    _waiting: SixValues | None = field(default=None, init=False)

    def __post_init__(self) -> None:
        self._staged = list(self._executor.targets_deg)

    def take_angles(self, angles_deg: Mapping[int, float]) -> None:
        """Receives one frame of a target: angles by joint number."""
        if not self._executor.may_move:
            return
        for joint, angle_deg in angles_deg.items():
            self._staged[joint - 1] = angle_deg
        self._fresh.add(frozenset(angles_deg))
        if len(self._fresh) == _PARTS:
            self._fresh.clear()
            self._waiting = tuple(self._staged)
            self.mode_changed()

    def mode_changed(self) -> None:
        """Starts a target that waits, if the mode is right."""
        if self._waiting is not None and self._condition.obeys(MoveMode.MOVE_J):
            target_deg, self._waiting = self._waiting, None
            self._pursue(target_deg)

    def drop_targets(self) -> None:
        """Drops every target, complete or incomplete."""
        self._waiting = None
        self.drop_parts()

    def drop_parts(self) -> None:
        """Drops the frames of an incomplete target."""
        self._fresh.clear()

    def _pursue(self, target_deg: SixValues) -> None:
        """Takes on a complete target, or refuses it and stays."""
        beyond = beyond_limits(target_deg, self._settings)
        if any(beyond):
            planning_error = PlanningError(ArmStatusCode.TARGET_BEYOND_LIMIT, beyond)
            self._executor.refuse(target_deg, planning_error)
        elif self._condition.direct:
            self._executor.drop_order()
            self._condition.accept_target()
            self._follow(target_deg)
        else:
            self._executor.begin(target_deg, [target_deg], MoveMode.MOVE_J, target_deg)


def beyond_limits(joints_deg: SixValues, settings: ArmSettingsRecord) -> list[bool]:
    """Return for each joint whether it would leave its range at these angles."""
    return [
        check_joint(joint, angle_deg, limits) is not None
        for joint, angle_deg, limits in zip(JOINTS, joints_deg, settings.limits, strict=True)
    ]
