"""Records that name the signals of their fields."""

from dataclasses import dataclass
from typing import Annotated

import pytest

from armui.arm.state import RECORDS, ArmState
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.protocol.message_fields import record_reader, signal_names


@dataclass(frozen=True)
class Sample:
    height_mm: Annotated[float, "Height"]
    width_mm: Annotated[float, "Width"]


@dataclass(frozen=True)
class Unnamed:
    height_mm: float


def test_a_record_is_filled_by_its_signals_names():
    assert record_reader(Sample)({"Width": 2.0, "Height": 1.0, "Depth": 3.0}) == Sample(1.0, 2.0)


def test_a_field_without_a_signal_is_named():
    with pytest.raises(TypeError, match=r"Unnamed\.height_mm names no signal"):
        record_reader(Unnamed)


def test_a_message_without_a_signal_is_no_record():
    with pytest.raises(KeyError, match="Width"):
        record_reader(Sample)({"Height": 1.0})


@pytest.mark.parametrize("message", RECORDS)
def test_every_message_kept_as_it_comes_has_the_signals_and_a_place(message):
    field, record = RECORDS[message]
    assert getattr(ArmState(), field) is None
    assert set(signal_names(record).values()) <= set(Codec(Generation.TWO).signals(message))
