"""Watches the forbidden side of a cell's work area.

The gate keeps our own motions out of it. An arm moved by a hand, gravity or another host cannot be
kept out: an intrusion is reported at once, and ends the motion if the operator has chosen that.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from armui.control.cell.intrusion import AreaIntrusion
from armui.control.context import ControllerPart
from armui.control.events import Notice
from armui.control.motion.motion_command import Mover
from armui.control.operating_state import StopState
from armui.telemetry.events import Asker, EventKind, Level

# The checks bring numpy along. They are loaded for the first area: the window starts without them.
if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.cell.area_check import AreaCheck, AreaEntry
    from armui.cell.cell import Cell
    from armui.cell.work_area import Area
    from armui.control.context import Context

AREA_ENTERED = Notice(
    "area_entered",
    "The arm has come too near to “{name}” of the work area: {part}, by {value} mm.",
    Level.WARNING,
    EventKind.STATUS,
    Asker.PROGRAM,
)
AREA_AROUND = Notice(
    "area_around",
    "The arm stands too near to “{name}” of the work area as it is now: {part}, by {value} mm.",
    Level.WARNING,
    EventKind.STATUS,
    Asker.PROGRAM,
)
AREA_BELOW = Notice(
    "area_below",
    "After an emergency stop the arm may sink, and the work area does not hold it: below it is "
    "{names}. Hold the arm.",
    Level.WARNING,
    EventKind.STATUS,
    Asker.PROGRAM,
)
AREA_LEFT = Notice(
    "area_left", "The arm is clear of the work area again.", Level.INFO, EventKind.STATUS
)


_DEEPER_MM: Final = 5.0
"""An intruding arm that goes deeper by this much is stopped once more."""
_OTHERS: Final = frozenset({Mover.HAND, Mover.OTHER_HOST, Mover.LEADER})


class AreaGuard(ControllerPart):
    """Knows the work area of the cell, and watches who comes into it.

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
        self._inside: dict[str, float] = {}
        self._looked_by: AreaCheck | None = None
        self._ran = True

    # State ------------------------------------------------------------------------------------

    @property
    def area(self) -> Area | None:
        """The work area of the cell, or ``None`` if the arm may go anywhere."""
        cell = self._cell()
        return None if cell is None or cell.area.is_free else cell.area

    def nearest_entries(self, state: ArmState) -> tuple[AreaEntry, ...]:
        """Return what of the measured arm is nearest to each plane and box, nearest first."""
        joints_deg, check = state.angles_deg(), self.check()
        if joints_deg is None or check is None:
            return ()
        measured = (joints_deg, check)
        if measured != self._measured:  # cached: mostly the arm stands still
            self._measured, self._seen = measured, check.nearest_entries(joints_deg)
        return self._seen

    def below(self) -> str:
        """Return the names of what the arm may sink into without its motors; "" for nothing."""
        joints_deg, check = self._context.state().angles_deg(), self.check()
        return "" if joints_deg is None or check is None else ", ".join(check.below(joints_deg))

    def entered(self, state: ArmState) -> tuple[AreaEntry, ...]:
        """Return the planes and boxes that the measured arm is too near to, nearest first."""
        check = self.check()
        if check is None:
            return ()
        return tuple(each for each in self.nearest_entries(state) if check.is_too_near(each))

    def intrusion(self, state: ArmState) -> AreaIntrusion | None:
        """Return the worst place at which the measured arm is too near to its area, or ``None``."""
        entered = self.entered(state)
        if not entered:
            return None
        nearest = entered[0]
        return AreaIntrusion(nearest.zone.name, nearest.part, self._too_near(nearest))

    def _too_near(self, entry: AreaEntry) -> int:
        check = self.check()
        return 0 if check is None else max(1, round(check.margin_mm - entry.gap_mm))

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

    # The controller's tick --------------------------------------------------------------------

    def follow_arm(self) -> None:
        """Report entering and leaving the area; stop an arm that others move if that is chosen.

        Each plane and box counts by itself: an arm inside one may enter another. Without feedback
        nothing counts as entered or left.
        """
        context = self._context
        state, check = context.connection.newest, self.check()
        if check is None or state.angles_deg() is not None:
            self._follow_measured(state, check)
        runs = context.operating_state().stop is StopState.RUNNING
        if self._ran and not runs and (names := self.below()):
            context.emit_event(AREA_BELOW, names=names)
        self._ran = runs

    def _follow_measured(self, state: ArmState, check: AreaCheck | None) -> None:
        context = self._context
        inside = {each.zone.name: each for each in self.entered(state)}
        # The notice differs where the area was changed around the arm, and not entered by it.
        notice = AREA_ENTERED if check is self._looked_by else AREA_AROUND
        self._looked_by = check
        for name, entry in inside.items():
            if name not in self._inside:
                context.emit_event(notice, name=name, part=entry.part, value=self._too_near(entry))
        if self._inside and not inside:
            context.emit_event(AREA_LEFT)
        deeper = [
            name
            for name, entry in inside.items()
            if entry.gap_mm < self._inside.get(name, math.inf) - _DEEPER_MM
        ]
        self._inside = {
            name: entry.gap_mm if name in deeper else self._inside[name]
            for name, entry in inside.items()
        }
        area, others = self.area, context.authority.mover in _OTHERS
        if deeper and others and area is not None and area.stops_others:
            self._halt()

    def forget_arm(self) -> None:
        """Forget where the arm was: it may be another one that comes."""
        self._measured, self._seen = (), ()
        self._looked_by = None
        self._inside = {}
