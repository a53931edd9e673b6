"""Notes results of a command in its record and reports them to the operator, in one step."""

from __future__ import annotations

from typing import Protocol

from armui.control.events import Notice
from armui.control.operations.started import Ending, Started
from armui.telemetry.events import EventOutcome


class EmitEvent(Protocol):
    """A function that emits an event."""

    def __call__(self, notice: Notice, started: Started | None = None, /, **params: object) -> None:
        """Emit an event; the command is given only with the notice of its beginning."""


def report_and_emit(
    emit_event: EmitEvent, at_s: float, started: Started | None, notice: Notice, **params: object
) -> None:
    """Tell the operator an interim result of a command, and note it in the record.

    Args:
        emit_event: Takes the event.
        at_s: Monotonic time.
        started: The command, or ``None`` if the event belongs to none.
        notice: The sentence.
        **params: Its figures.
    """
    if started is not None:
        started.report(EventOutcome(notice.id, at_s, notice.level, params))
    emit_event(notice, **params)


def close_and_emit(
    emit_event: EmitEvent,
    at_s: float,
    started: Started | None,
    ending: Ending,
    notice: Notice,
    **params: object,
) -> None:
    """Note how a command ended, and tell the operator; see :func:`report_and_emit`."""
    if started is not None:
        started.close(ending, EventOutcome(notice.id, at_s, notice.level, params))
    emit_event(notice, **params)
