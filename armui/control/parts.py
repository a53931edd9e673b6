"""Calls the parts of the controller in turn; one that fails does not stop the others."""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence

from armui.control.context import ControllerPart, Tell
from armui.control.events import EventCode

_LOG = logging.getLogger(__name__)


class Parts:
    """Calls every part even when another fails: a stop must reach all of them.

    A part that fails is tried again the next time, for what it was doing may have been the reason.
    Its first failure is told to the operator, every one is logged.

    Args:
        tell: Takes the notices.
        end_motion: Called with the module of a part that fails after it has worked: the motion it
            is in charge of must not go on unwatched.
    """

    def __init__(
        self, tell: Tell, end_motion: Callable[[str], None] = lambda _module: None
    ) -> None:
        self._parts: Sequence[ControllerPart] = ()
        self._last: Sequence[ControllerPart] = ()
        self._tell = tell
        self._end_motion = end_motion
        self._failed: set[str] = set()
        self._out_of_order: set[str] = set()

    def take(self, parts: Sequence[ControllerPart], last: ControllerPart | None = None) -> None:
        """Call these from now on.

        Args:
            parts: In the order in which they act.
            last: Looks at what the others are doing: it acts after them, once the operating state
                has been assessed anew.
        """
        self._parts = parts
        self._last = () if last is None else (last,)

    def advance(self) -> None:
        """Have each look at what was heard; see :meth:`ControllerPart.advance`."""
        self._advance(self._parts)

    def advance_last(self) -> None:
        """Have the last look at what the others are doing."""
        self._advance(self._last)

    def halt(self) -> None:
        """Have each give up what would move the arm; see :meth:`ControllerPart.halt`."""
        for part in (*self._parts, *self._last):
            self._have(part, part.halt)

    def forget(self) -> None:
        """Tell each that the arm is gone; see :meth:`ControllerPart.forget`."""
        for part in (*self._parts, *self._last):
            self._have(part, part.forget)

    def _advance(self, parts: Sequence[ControllerPart]) -> None:
        for part in parts:
            if self._have(part, part.advance):
                self._out_of_order.discard(type(part).__name__)

    def _have(self, part: ControllerPart, act: Callable[[], None]) -> bool:
        name = type(part).__name__
        try:
            act()
        except Exception:  # noqa: BLE001 - whatever it was, a stop must reach the other parts
            _LOG.exception("%s has failed", name)
            if name not in self._failed:
                self._failed.add(name)
                self._tell(EventCode.PART_FAILED, part=name)
            if name not in self._out_of_order:
                self._out_of_order.add(name)
                self._end_motion(type(part).__module__)
            return False
        return True
