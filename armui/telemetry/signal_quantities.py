"""Which curve a signal on the bus is drawn as."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Final

from armui.telemetry.bus_senders import Sender
from armui.telemetry.quantities import QUANTITIES, RECORDS, Source

if TYPE_CHECKING:
    from collections.abc import Mapping

_SOURCES: Final = {
    Sender.ARM: Source.ARM,
    Sender.OWN: Source.OWN,
    Sender.OTHER: Source.OTHER,
}


def quantity_key(sender: Sender, message: str, signal: str) -> str | None:
    """The key of a signal's quantity (`armui.telemetry.quantities`); ``None``: it is not kept."""
    source = _SOURCES.get(sender)
    return None if source is None else _keys().get((source, message, signal))


@cache
def _keys() -> Mapping[tuple[Source, str, str], str]:
    places = {(each.series, each.field): each.key for each in QUANTITIES.values()}
    return {
        (record.source, record.message, signal): places[record.name, field.name]
        for record in RECORDS
        for field in record.fields
        for signal in field.signals
        if signal
    }
