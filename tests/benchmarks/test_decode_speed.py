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
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.protocol.layout import load_database

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
                    and signal not in {"BusCurrent", "Angle"}  # no sign; in place of Opening
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
    """As its own interface calls it: every frame into one object, over what was there before."""
    decode = C_PiperParserV2().DecodeMessage
    values = PiperMessage()

    def all_frames():
        for message in second.messages:
            decode(message, values)

    benchmark.pedantic(all_frames, rounds=ROUNDS, warmup_rounds=2)
    best_s["piper-sdk"] = benchmark.stats.stats.min


@pytest.mark.benchmark(group="decode 3,040 frames")
def test_piper_sdk_with_fresh_values(benchmark, second, best_s):
    """As the codec does it: each frame's values in an object of their own, safe to pass on."""
    decode = C_PiperParserV2().DecodeMessage

    def all_frames():
        for message in second.messages:
            decode(message, PiperMessage())

    benchmark.pedantic(all_frames, rounds=ROUNDS, warmup_rounds=2)
    best_s["piper-sdk, fresh values"] = benchmark.stats.stats.min


def test_ratio(best_s, second, capsys):
    if len(best_s) < 3:
        pytest.skip("needs all contestants: run the whole file")
    ours_s = best_s.pop("codec")
    count = len(second.frames)
    with capsys.disabled():
        print(f"\ndecoding: {ours_s / count * 1e6:.2f} µs a frame (aim: {AIM} times as fast)")
        for name, theirs_s in best_s.items():
            each_us = theirs_s / count * 1e6
            print(f"  {name}: {each_us:.2f} µs, the codec is {theirs_s / ours_s:.1f} times as fast")
