"""From a decoded message to the figures and codes of its series."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from operator import itemgetter, mul
from typing import Final

from armui.arm.limits import JOINTS
from armui.arm.units import DEGREES_PER
from armui.protocol.codec import Codec, EncodeError
from armui.telemetry.quantities import Field, Record
from armui.telemetry.series import Row

_Signals = Mapping[str, float]
_Maker = Callable[[_Signals], float]
_NAN: Final = math.nan

_UNPROVEN: Final = frozenset(
    {"SpeedPercent", "TrajectoryPoint", *(f"J{joint}LimitExceeded" for joint in JOINTS)}
)
"""What bytes 5 and 6 of 0x2A1 hold is known with the generation."""


def row_of(record: Record, codec: Codec, *, proven: bool) -> Callable[[_Signals], Row] | None:
    """What makes a row of a message's signals; ``None`` if nothing of it can be understood.

    Args:
        record: What is kept of the message.
        codec: How it is decoded.
        proven: The arm is known to speak this generation. Until then only what both of them say
            alike is kept.
    """
    told = told_signals(record, codec, proven=proven)
    if told is None:
        return None
    fields = record.fields
    plain = all(len(field.signals) == 1 and field.signals[0] in told for field in fields)
    if plain and not any(codec.may_lack(record.message, name) for name in told):
        factors = [factor_of(record, field, codec) for field in fields]
        return _plain([field.signals[0] for field in fields], factors)
    makers = tuple(_maker(record, field, codec, told) for field in fields)
    return lambda signals: tuple([make(signals) for make in makers])


def told_signals(record: Record, codec: Codec, *, proven: bool) -> frozenset[str] | None:
    """The signals of a message that are understood; ``None`` if there are none; see `row_of`."""
    if not (proven or record.common):
        return None
    try:
        told = frozenset(codec.signals(record.message))
    except EncodeError:
        return None
    if not proven and record.message == "ArmStatus":
        told -= _UNPROVEN
    return told


def _plain(names: list[str], factors: list[float]) -> Callable[[_Signals], Row]:
    """Two signals and more, each as it is or in another unit."""
    values: Callable[[_Signals], Row] = itemgetter(*names)
    if all(factor == 1 for factor in factors):
        return values
    return lambda signals: tuple(map(mul, values(signals), factors))


def factor_of(record: Record, field: Field, codec: Codec) -> float:
    """What a signal is multiplied by to have the field's unit."""
    if not field.is_angle:
        return 1
    return DEGREES_PER.get(codec.unit(record.message, field.signals[0]), _NAN)


def _maker(record: Record, field: Field, codec: Codec, told: frozenset[str]) -> _Maker:
    """One figure or code of a row."""
    bits = tuple((1 << place, name) for place, name in enumerate(field.signals) if name in told)
    if not bits:
        missing: float = 0 if field.is_code else _NAN
        return lambda _signals: missing
    if len(field.signals) > 1:
        return lambda signals: sum(bit for bit, name in bits if signals[name] == 1)
    name = field.signals[0]
    factor = factor_of(record, field, codec)
    if codec.may_lack(record.message, name):
        return lambda signals: signals.get(name, _NAN) * factor
    if factor == 1:
        return itemgetter(name)
    return lambda signals: signals[name] * factor
