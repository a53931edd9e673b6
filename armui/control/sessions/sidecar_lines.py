"""The lines that a recording keeps beside its frames: events, and facts on the arm."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.arm.backup import parameter_row
from armui.arm.parameters import all_batches, reading_of
from armui.cell.cell_in_force import CellInForce, to_entry
from armui.control.events import Level
from armui.control.safety.stopping import (
    HALT_SENT,
    STOP_CONFIRMED,
    STOP_SENT,
    STOP_UNCONFIRMED,
    STOP_UNDONE,
)
from armui.session.session import MarkKind
from armui.telemetry.event_json import to_json
from armui.telemetry.events import EventKind

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.context import Context
    from armui.session.recording.sidecar import Line
    from armui.telemetry.events import EventEntry, EventLog

_STOPS: Final = frozenset(
    {
        STOP_SENT.id,
        STOP_CONFIRMED.id,
        STOP_UNDONE.id,
        STOP_UNCONFIRMED.id,
        HALT_SENT.id,
    }
)


@dataclass(frozen=True, slots=True)
class FedEvent:
    """An event from the log.

    Attributes:
        at_s: The time by the program's clock.
        mark: The kind of moment.
        entry: JSON values, as a line of the sidecar has them.
        is_new: True if it has just happened; false if only its end, or a repeat, was noted.
    """

    at_s: float
    mark: MarkKind
    entry: Mapping[str, object]
    is_new: bool


class EventFeed:
    """Follows the log of events.

    Args:
        log: The event log.
    """

    def __init__(self, log: EventLog) -> None:
        self._log = log
        self._revision = self._newest = 0

    def take_events(self) -> list[FedEvent]:
        """Return the events that are new, or have changed, since the last call."""
        self._revision, entries = self._log.since(self._revision)
        newest = self._newest
        self._newest = self._log.newest
        return [
            FedEvent(each.at_s, _mark_of(each), json.loads(to_json(each)), each.number > newest)
            for each in entries
        ]


def _mark_of(entry: EventEntry) -> MarkKind:
    if entry.code in _STOPS:
        return MarkKind.STOP
    if entry.kind is EventKind.FAULT or entry.level is Level.FAULT:
        return MarkKind.FAULT
    return MarkKind.COMMAND if entry.kind is EventKind.COMMAND else MarkKind.NOTE


class SidecarLines:
    """Makes lines for the sidecar whenever there is something new.

    Args:
        context: The context that the controller's parts share.
        cell: Returns what of a cell holds.
    """

    def __init__(self, context: Context, cell: Callable[[], CellInForce] = CellInForce) -> None:
        self._context = context
        self._cell = cell
        self._written: dict[str, Line] = {}

    def reset(self) -> None:
        """Take everything for new, because another recording begins."""
        self._written = {}

    def new_lines(self) -> list[Line]:
        """Return the lines for everything known now and not yet written."""
        connection = self._context.connection
        state = self._context.state()
        lines: list[Line] = []
        if connection.device is not None:
            generation = connection.generation
            lines.append(
                {
                    "kind": "arm",
                    "device": connection.device.name,
                    "interface": connection.device.interface,
                    "serial": connection.device.serial,
                    "bitrate": connection.device.bitrate,
                    "model": connection.model.value,
                    "listen_only": connection.device.listen_only,
                    "generation": None if generation is None else int(generation),
                    "firmware": state.firmware,
                }
            )
        cell = self._cell()
        if cell != CellInForce() or "cell" in self._written:
            lines.append({"kind": "cell", **to_entry(cell)})
        values = settings_read(state)
        if values:
            lines.append({"kind": "settings", "values": values})
        new = [line for line in lines if self._written.get(str(line["kind"])) != line]
        self._written.update({str(line["kind"]): line for line in new})
        return new


def settings_read(state: ArmState) -> list[dict[str, float | int | str]]:
    """Return the parameters that were read from the arm, as the file of a backup names them."""
    return [
        parameter_row(parameter, known.value)
        for batch in all_batches(teaching=True, drag_assistance=True)
        for parameter in batch.parameters()
        if (known := reading_of(state, parameter)) is not None
    ]
