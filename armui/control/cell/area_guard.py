"""Keeps motions of this program out of the forbidden side of a cell's work area.

A jog ends before it by its setpoints: the arm rests at the last one. A single motion is refused by
its planned way. A hand, gravity and other hosts cannot be kept out: that they have come in is told
at once, and ends their motion if the operator wants that.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Refusal
from armui.control.cell.intrusion import AreaIntrusion
from armui.control.context import ControllerPart
from armui.control.events import Notice
from armui.control.motion.motion_command import Mover
from armui.control.operating_state import StopState
from armui.control.parameters.arm_model import planning_model
from armui.telemetry.events import Asker, EventKind, Level
from armui.trajectory.points.program import Trajectory, Waypoint

# The checks bring numpy along. They are loaded for the first area: the window starts without them.
if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.cell.area_check import AreaCheck, AreaEntry
    from armui.cell.cell import Cell
    from armui.cell.work_area import Area
    from armui.control.context import Context

AREA_ENTERED = Notice(
    "area_entered",
    "The arm has come into the work area's “{name}”: {part}, {value} mm too near.",
    Level.WARNING,
    EventKind.STATUS,
    Asker.PROGRAM,
)
AREA_BELOW = Notice(
    "area_below",
    "The stopped arm sinks, and the work area does not hold it: below it is {names}. Hold the arm.",
    Level.WARNING,
    EventKind.STATUS,
    Asker.PROGRAM,
)
AREA_LEFT = Notice(
    "area_left", "The arm is clear of the work area again.", Level.INFO, EventKind.STATUS
)


_OTHERS: Final = frozenset({Mover.HAND, Mover.OTHER_HOST, Mover.LEADER})


class AreaGuard(ControllerPart):
    """Asks the work area of the cell, for everything that moves.

    Args:
        context: The context that the controller's parts share.
        cell: Returns the chosen cell, also while it is not confirmed.
        tool: Returns the tool centre point in force, in the flange.
        halt: Ends every motion and holds the arm.
    """

    def __init__(
        self,
        context: Context,
        cell: Callable[[], Cell | None],
        tool: Callable[[], Sequence[float]],
        halt: Callable[[], object],
    ) -> None:
        self._context = context
        self._cell = cell
        self._tool = tool
        self._halt = halt
        self._of: tuple[object, ...] = ()
        self._check: AreaCheck | None = None
        self._measured: tuple[object, ...] = ()
        self._seen: tuple[AreaEntry, ...] = ()
        self._was_in = False
        self._ran = True

    # What is known ----------------------------------------------------------------------------

    @property
    def area(self) -> Area | None:
        """The work area of the cell, or ``None`` if the arm may go anywhere."""
        cell = self._cell()
        return None if cell is None or cell.area.is_free else cell.area

    def look(self, state: ArmState) -> tuple[AreaEntry, ...]:
        """Return what of the measured arm is nearest to each plane and box, nearest first."""
        joints_deg, check = state.angles_deg(), self.check()
        if joints_deg is None or check is None:
            return ()
        measured = (joints_deg, check)
        if measured != self._measured:  # it is asked often, mostly of an arm that stands
            self._measured, self._seen = measured, check.look(joints_deg)
        return self._seen

    def below(self) -> str:
        """Return the names of what the arm may sink into without its motors; "" for nothing."""
        joints_deg, check = self._context.state().angles_deg(), self.check()
        return "" if joints_deg is None or check is None else ", ".join(check.below(joints_deg))

    def intrusion(self, state: ArmState) -> AreaIntrusion | None:
        """Return where the measured arm is too near to its area, or ``None``."""
        check, seen = self.check(), self.look(state)
        if check is None or not seen or not check.is_too_near(seen[0]):
            return None
        value_mm = max(1, round(check.margin_mm - seen[0].gap_mm))
        return AreaIntrusion(seen[0].zone.name, seen[0].part, value_mm)

    def check(self) -> AreaCheck | None:
        """Return the checks of the present arm, tool, held object and area; ``None`` if free."""
        cell = self._cell()
        if self.area is None or cell is None:
            self._of, self._check = (), None
            return None
        now = self._context.operating_state()
        of = (cell, now.model, now.model_fit.geometry, self._tool())
        if self._check is None or of != self._of:
            self._of, self._check = of, self._made(cell)
        return self._check

    def check_holding(self, name: str) -> AreaCheck | None:
        """Return the same checks as they will be once the hand holds an object; "" for none."""
        cell = self._cell()
        if cell is None or self.area is None or name == cell.held:
            return self.check()
        return self._made(replace(cell, held=name))

    def _made(self, cell: Cell) -> AreaCheck:
        from armui.cell.area_check import AreaCheck, carried_body  # noqa: PLC0415 - numpy

        now = self._context.operating_state()
        body = carried_body(now.model, now.model_fit.geometry, self._tool(), cell)
        return AreaCheck(cell.area, body, cell.placement.rising)

    # What is asked before something moves -----------------------------------------------------

    def why_no_further(
        self, ahead_deg: Sequence[float], now_deg: Sequence[float], sag_deg: Sequence[float]
    ) -> Refusal | None:
        """Return why a jog may not go on; an arm that is inside may go out.

        Args:
            ahead_deg: The next setpoint.
            now_deg: The present one.
            sag_deg: How far the joints rest behind their setpoints, under load.
        """
        check = self.check()
        if check is None:
            return None
        ahead, now = ((pose, _less(pose, sag_deg)) for pose in (ahead_deg, now_deg))
        return check.why_no_further(ahead, now)

    def why_no_joints(self, target_deg: Sequence[float]) -> Refusal | None:
        """Return why a motion of the joints from where the arm is to six angles is refused."""
        check = self.check()
        if check is None:
            return None
        return check.why_no_way([*self._places(), target_deg])

    def why_no_point(self, point: Waypoint) -> Refusal | None:
        """Return why a motion to a point is refused: somewhere its planned way is too near.

        Args:
            point: The point; its poses are of the flange.
        """
        check = self.check()
        if check is None:
            return None
        if point.is_joint:
            return self.why_no_joints(point.target)
        from armui.trajectory.planning.timing import plan_path  # noqa: PLC0415 - scipy

        context = self._context
        arm = planning_model(context.state(), context.operating_state(), self._tool())
        trajectory = Trajectory("", points=(point,))
        for start_deg in self._places():
            refusal = check.why_no_way(plan_path(trajectory, arm, start_deg).joints_deg)
            if refusal is not None:
                return refusal
        return None

    def _places(self) -> list[tuple[float, ...]]:
        """Return where the next motion may begin: as measured, and where a motion of ours ends."""
        context = self._context
        measured_deg = context.state().angles_deg()
        if measured_deg is None:
            return []
        asked_deg = context.authority.joint_base_deg() if context.authority.moves else None
        return [measured_deg] if asked_deg is None else [measured_deg, tuple(asked_deg)]

    # The controller's tick --------------------------------------------------------------------

    def follow_arm(self) -> None:
        """Tell that the arm has come in or gone out, and stop who else moves it if wanted."""
        context = self._context
        found = self.intrusion(context.connection.newest)
        if found is not None and not self._was_in:
            figures = {"name": found.name, "part": found.part, "value": found.value_mm}
            context.tell(AREA_ENTERED, **figures)
            area = self.area
            stops = area is not None and area.stops_others
            if stops and context.authority.mover in _OTHERS:
                self._halt()
        elif found is None and self._was_in:
            context.tell(AREA_LEFT)
        self._was_in = found is not None
        runs = context.operating_state().stop is StopState.RUNNING
        if self._ran and not runs and (names := self.below()):
            context.tell(AREA_BELOW, names=names)
        self._ran = runs

    def forget_arm(self) -> None:
        """Forget where the arm was: it may be another one that comes."""
        self._measured, self._seen, self._was_in = (), (), False


def _less(pose_deg: Sequence[float], sag_deg: Sequence[float]) -> tuple[float, ...]:
    return tuple(angle - sag for angle, sag in zip(pose_deg, sag_deg, strict=True))
