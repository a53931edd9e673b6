"""Many frames at once give what the codec gives one by one."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest

from armui.protocol.codec import Codec, InvalidFrame
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.protocol.layout import load_database
from armui.protocol.signal_columns import bit_mask, payload_words, signal_column

MESSAGES = [
    (generation, message.frame_id)
    for generation in Generation
    for message in load_database(generation).messages
]


@pytest.mark.parametrize(("generation", "arbitration_id"), MESSAGES)
def test_every_signal_of_every_message(generation, arbitration_id):
    codec = Codec(generation)
    layout = codec.layout(arbitration_id)
    draw = random.Random(arbitration_id)
    payloads = [bytes(8), b"\xff" * 8, b"\x80" + bytes(7), *(draw.randbytes(8) for _ in range(40))]
    selections = {signal.selection for signal in layout.signals.values()} - {None}
    selector = bit_mask([layout.selector]) if layout.selector else 0
    for selection in selections:  # each of the meanings once more
        code = selection.raw << 64 - selection.first_bit - selection.bits
        noise = int.from_bytes(draw.randbytes(8), "big")
        payloads.append((noise & ~selector | code).to_bytes(8, "big"))
    if "Joint" in layout.signals:  # a frame that names a joint no arm has is nothing to compare
        place = layout.signals["Joint"].first_bit // 8
        payloads = [
            each[:place] + bytes([draw.randint(1, 6)]) + each[place + 1 :] for each in payloads
        ]
    words = payload_words(np.frombuffer(b"".join(payloads), np.uint8).reshape(-1, 8))
    expected = []
    for each in payloads:
        decoded = codec.decode(Frame(arbitration_id, each[: layout.length]))
        message = decoded.message if isinstance(decoded, InvalidFrame) else decoded
        expected.append(message.signals)
    for signal in layout.signals.values():
        column = signal_column(words, signal).tolist()
        # NaN stands for a frame that holds something else in its place
        wanted = [each.get(signal.name, math.nan) for each in expected]
        assert column == pytest.approx(wanted, abs=0, rel=0, nan_ok=True)
        whole = not signal.is_scaled and signal.selection is None
        assert {type(each) for each in column} <= {int if whole else float}


def test_the_bits_of_signals_are_those_that_are_not_reserved():
    layout = Codec(Generation.TWO).layout(0x2A1)
    assert bit_mask(layout.signals.values()) == ~layout.reserved_mask & 0xFFFFFFFFFFFFFFFF


def test_no_signal_takes_nothing():
    assert bit_mask([]) == 0
    assert len(payload_words(np.zeros((0, 8), np.uint8))) == 0
