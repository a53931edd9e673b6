"""How fast frames become values, against the maker's parser over the same second of traffic.

Run with `python -m pytest tests/benchmarks/test_decode_speed.py`; nothing fails for being slow.
"""

from __future__ import annotations

import random
from typing import NamedTuple

import can
import pytest
from piper_sdk.piper_msgs.msg_v2 import PiperMessage
from piper_sdk.protocol.protocol_v2 import C_PiperParserV2

from armui.protocol.codec import Codec, Message
from armui.protocol.database import Generation, load_database
from armui.protocol.frame import Frame

AIM = 8
ROUNDS = 15


class Second(NamedTuple):
    """The frames an arm of generation 2 sends within a second, in the order they come."""

    frames: list[Frame]
    messages: list[can.Message]


@pytest.fixture(scope="module")
def second() -> Second:
    """0x2A1-0x2A8 and 0x251-0x256 at 200 Hz, 0x261-0x266 at 40 Hz, with plausible content."""
    draw = random.Random(1)
    codec = Codec(Generation.TWO)
    periods_ms = {
        message.name: message.cycle_time
        for message in load_database(Generation.TWO).messages
        if message.cycle_time and not message.name.startswith("EndMotion")
    }
    frames = []
    for now_ms in range(0, 1000, 5):
        for name, period_ms in periods_ms.items():
            if now_ms % period_ms == 0:
                signals = {
                    signal: draw.uniform(-20, 20)
                    for signal in codec.signals(name)
                    if codec.unit(name, signal) in {"deg", "mm", "rad", "rad/s", "A", "N.m"}
                    and signal != "BusCurrent"
                }
                frames.append(codec.encode(name, **signals))
    messages = [
        can.Message(arbitration_id=f.arbitration_id, data=f.data, is_extended_id=False)
        for f in frames
    ]
    return Second(frames, messages)


@pytest.fixture(scope="module")
def best_s() -> dict[str, float]:
    """Shortest round of each contestant, for the comparison at the end."""
    return {}


def test_one_second_is_3040_frames_that_all_decode(second):
    codec = Codec(Generation.TWO)
    assert len(second.frames) == 3040
    assert all(isinstance(codec.decode(frame), Message) for frame in second.frames)


@pytest.mark.benchmark(group="decode 3,040 frames")
def test_codec(benchmark, second, best_s):
    decode = Codec(Generation.TWO).decode

    def all_frames():
        for frame in second.frames:
            decode(frame)

    benchmark.pedantic(all_frames, rounds=ROUNDS, warmup_rounds=2)
    best_s["codec"] = benchmark.stats.stats.min


@pytest.mark.benchmark(group="decode 3,040 frames")
def test_piper_sdk(benchmark, second, best_s):
    decode = C_PiperParserV2().DecodeMessage
    values = PiperMessage()  # piper-sdk decodes into one object, again and again

    def all_frames():
        for message in second.messages:
            decode(message, values)

    benchmark.pedantic(all_frames, rounds=ROUNDS, warmup_rounds=2)
    best_s["piper-sdk"] = benchmark.stats.stats.min


def test_ratio(best_s, second, capsys):
    if len(best_s) < 2:
        pytest.skip("needs both contestants: run the whole file")
    ratio = best_s["piper-sdk"] / best_s["codec"]
    count = len(second.frames)
    with capsys.disabled():
        print(
            f"\ndecoding: {best_s['codec'] / count * 1e6:.2f} µs a frame, piper-sdk "
            f"{best_s['piper-sdk'] / count * 1e6:.2f} µs: {ratio:.1f} times as fast (aim: {AIM})"
        )
