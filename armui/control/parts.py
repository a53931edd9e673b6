"""Calls the parts of the controller in turn, even if one of them fails."""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence

from armui.control.context import ControllerPart
from armui.control.events import Notice
from armui.control.operations.outcome_events import EmitEvent
from armui.telemetry.events import EventKind, Level

PART_FAILED_NOTICE = Notice(
    "part_failed",
    "A part of the program has failed ({part}). The emergency stop still works; every motion "
    "of this program is ended. Start the program again.",
    Level.FAULT,
    EventKind.PROGRAM,
)

_LOG = logging.getLogger(__name__)


class Parts:
    """Calls every part even if another fails: a stop must reach all of them.

    A part that fails is called again the next time, because its task may have been the cause. The
    operator is told its first failure; every failure is logged.

    Args:
        emit_event: Takes the events.
        on_failure: Called at each failure: no motion may go on unwatched.
    """

    def __init__(
        self, emit_event: EmitEvent, on_failure: Callable[[], None] = lambda: None
    ) -> None:
        self._parts: Sequence[ControllerPart] = ()
        self._last: Sequence[ControllerPart] = ()
        self._emit_event = emit_event
        self._on_failure = on_failure
        self._failed: set[str] = set()
        self._out_of_order: set[str] = set()

    @property
    def in_order(self) -> bool:
        """True if every part has worked at its last call of :meth:`follow_arm`."""
        return not self._out_of_order

    def set_parts(
        self, parts: Sequence[ControllerPart], last: ControllerPart | None = None
    ) -> None:
        """Set the parts to call from now on.

        Args:
            parts: In the order in which they act.
            last: Acts after the others, once the operating state has been assessed anew.
        """
        self._parts = parts
        self._last = () if last is None else (last,)

    def follow_arm(self) -> None:
        """Have each part take in the feedback; see :meth:`ControllerPart.follow_arm`."""
        self._follow_arm(self._parts)

    def follow_arm_last(self) -> None:
        """Have the last part act, after the others."""
        self._follow_arm(self._last)

    def halt(self) -> None:
        """Have each part end its motions; see :meth:`ControllerPart.halt`."""
        for part in (*self._parts, *self._last):
            self._have(type(part).__name__, part.halt)

    def forget_arm(self) -> None:
        """Tell each that the arm is gone; see :meth:`ControllerPart.forget_arm`."""
        for part in (*self._parts, *self._last):
            self._have(type(part).__name__, part.forget_arm)

    def attempt(self, name: str, function: Callable[[], object], *, step: str = "") -> None:
        """Call something that is no part with the same care.

        Args:
            name: The name told to the operator if it fails.
            function: The function to call.
            step: Distinguishes several calls under the same name.
        """
        if self._have(name, function):
            self._out_of_order.discard(name + step)
        else:
            self._out_of_order.add(name + step)

    def _follow_arm(self, parts: Sequence[ControllerPart]) -> None:
        for part in parts:
            self.attempt(type(part).__name__, part.follow_arm)

    def _have(self, name: str, act: Callable[[], object]) -> bool:
        try:
            act()
        except Exception:  # noqa: BLE001 - whatever it was, a stop must reach the other parts
            self._on_failure()
            _LOG.exception("%s has failed", name)
            if name not in self._failed:
                self._failed.add(name)
                self._emit_event(PART_FAILED_NOTICE, part=name)
            return False
        return True
