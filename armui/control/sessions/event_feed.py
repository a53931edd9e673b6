"""What happened, as a recording keeps it: taken from the notices of the controller."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict
from typing import TYPE_CHECKING, Final, NamedTuple, Protocol

from armui.arm.device import Device
from armui.arm.refusal import Refusal
from armui.control.events import Event, EventCode, Level
from armui.session.session import MarkKind

if TYPE_CHECKING:
    from PySide6.QtCore import SignalInstance

_STOPS: Final = frozenset(
    {
        EventCode.STOP_SENT,
        EventCode.STOP_CONFIRMED,
        EventCode.STOP_UNDONE,
        EventCode.STOP_UNCONFIRMED,
        EventCode.HALT_SENT,
    }
)
_MOST_WAITING: Final = 10_000


class FedEvent(NamedTuple):
    """Something that happened.

    Attributes:
        at_s: By the program's clock.
        mark: What sort of moment it is.
        entry: JSON values, as a line of the sidecar has them.
    """

    at_s: float
    mark: MarkKind
    entry: Mapping[str, object]


class EventFeed(Protocol):
    """Where events come from."""

    def take(self) -> list[FedEvent]:
        """What has happened, or has changed, since the last call."""


class NoticeFeed:
    """Every notice of the controller.

    Args:
        noticed: Emits an :class:`Event` each time.
        clock: The program's, in seconds.
    """

    def __init__(self, noticed: SignalInstance, clock: Callable[[], float]) -> None:
        self._clock = clock
        self._waiting: list[FedEvent] = []
        noticed.connect(self._on_noticed)

    def take(self) -> list[FedEvent]:
        """What has happened since the last call."""
        waiting, self._waiting = self._waiting, []
        return waiting

    def _on_noticed(self, event: Event) -> None:
        if len(self._waiting) >= _MOST_WAITING:
            return
        at_s = self._clock()
        entry = {
            "wall": event.at.isoformat(timespec="milliseconds"),
            "at_s": round(at_s, 6),
            "level": event.level.name.lower(),
            "code": event.code.value,
            "params": {name: _plain(value) for name, value in event.params.items()},
        }
        self._waiting.append(FedEvent(at_s, _mark_of(event), entry))


def _mark_of(event: Event) -> MarkKind:
    if event.code in _STOPS:
        return MarkKind.STOP
    return MarkKind.FAULT if event.level is Level.FAULT else MarkKind.NOTE


def _plain(value: object) -> object:
    if isinstance(value, Refusal):
        figures = {name: _plain(figure) for name, figure in value.params.items()}
        return {"refusal": value.code.value, "params": figures}
    if isinstance(value, Device):
        return {"device": asdict(value)}
    if value is None or isinstance(value, bool | int | float | str):
        return value
    return str(value)
