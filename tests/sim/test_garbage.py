"""Whatever is on the bus: the arm goes on, and what it tells stays valid."""

from __future__ import annotations

import random
from functools import cache

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec, InvalidFrame
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from tests.examples import examples
from tests.sim.talk import frame, heard, tell

HOST_IDS = [
    0x121,
    *range(0x150, 0x160),
    *range(0x160, 0x180),
    0x422,
    *range(0x470, 0x480),
    0x4AF,
]

any_frame = st.builds(Frame, st.integers(0, 0x7FF), st.binary(max_size=8))
host_frame = st.builds(
    Frame,
    st.sampled_from(HOST_IDS),
    st.lists(
        st.one_of(st.sampled_from([0, 1, 2, 7, 50, 100, 0xAE, 0x7F, 0xFF]), st.integers(0, 255)),
        min_size=8,
        max_size=8,
    ).map(bytes),
)
near_target = st.builds(
    lambda part, a, b: Frame(
        0x155 + part, a.to_bytes(4, "big", signed=True) + b.to_bytes(4, "big", signed=True)
    ),
    st.integers(0, 2),
    st.integers(-200_000, 200_000),
    st.integers(-200_000, 200_000),
)
go = st.sampled_from(
    [
        Frame(0x471, bytes.fromhex("0702000000000000")),
        Frame(0x151, bytes.fromhex("0101640000000000")),
        Frame(0x150, bytes.fromhex("0200000000000000")),
        Frame(0x422, bytes.fromhex("0000000000000000")),
        Frame(0x470, bytes.fromhex("FC00000000000000")),
    ]
)
talk = st.lists(
    st.tuples(
        st.one_of(any_frame, host_frame, near_target, go),
        st.sampled_from([0.0, 0.001, 0.005, 0.05, 0.3]),
    ),
    max_size=60,
)


@cache
def codec_of(generation: Generation, addressing: Addressing) -> Codec:
    """Making a codec takes milliseconds."""
    return Codec(generation, addressing)


@settings(max_examples=examples(100), deadline=None)
@given(st.sampled_from(Generation), talk)
def test_the_arm_never_raises_and_always_tells_valid_frames(
    generation: Generation, said: list[tuple[Frame, float]]
) -> None:
    arm = Firmware(generation)
    for each, dt_s in said:
        answers = arm.on_frame(each)
        codec = codec_of(generation, arm.addressing)
        # an answer to a change of offsets still has the identifier before it, which is the same
        for answer in (*answers, *arm.step(dt_s)):
            assert not isinstance(codec.decode(answer), InvalidFrame), answer


@settings(max_examples=examples(100), deadline=None)
@given(st.sampled_from(Generation), st.lists(any_frame, max_size=100))
def test_frames_of_no_meaning_leave_the_arm_at_home(
    generation: Generation, frames: list[Frame]
) -> None:
    """Without motors enabled nothing a host says moves the arm."""
    arm = Firmware(generation)
    for each in frames:
        if each.arbitration_id != 0x471:
            arm.on_frame(each)
    arm.step(0.5)
    assert arm.joints_deg == (0.0,) * 6
    assert arm.enabled == (False,) * 6


@pytest.mark.parametrize("generation", Generation)
def test_half_a_million_frames_of_garbage_leave_the_arm_running_and_truthful(
    generation: Generation,
) -> None:
    """Every identifier, every length, a million frames in all; the arm lives on between them.

    Afterwards the bytes it tells are those of the state it holds, and it obeys as before.
    """
    arm, chance = Firmware(generation), random.Random(generation)
    told: list[Frame] = []
    for _ in range(500_000 // 0x800 + 1):
        frames = [Frame(i, chance.randbytes(8 if i % 3 else i // 3 % 9)) for i in range(0x800)]
        for each in frames:
            arm.on_frame(each)
        told = arm.step(0.005)
    codec = codec_of(generation, arm.addressing)
    assert not [each for each in told if isinstance(codec.decode(each), InvalidFrame)]
    assert sum(arm.ignored.values()) > 400_000
    home = Firmware(generation, flash=arm.flash)
    for line in ("150#0200000000000000", "422#0000000000000000", "470#FC00000000000000"):
        for offset in (0x00, 0x10, 0x20):
            identifier, data = frame(line)
            moved = identifier + offset if identifier == 0x150 else identifier
            arm.on_frame(Frame(moved, data))
    assert arm.addressing == Addressing()
    assert not arm.condition.stopped
    # what it keeps is what it tells, and what an arm started from its flash tells
    for question in ("472#0301000000000000", "472#0302000000000000", "477#0200000000000000"):
        answers = tell(arm, question)
        assert len(answers) == 1
        assert tell(home, "422#0000000000000000", question) == answers
    tell(arm, "477#0002000000000000", "475#0700000000AE0000", "471#0702000000000000")
    assert arm.enabled == (True,) * 6
    frames = arm.step(0.1)
    # J1, J2 as signed 0.001°
    first, second = (round(1000 * angle) for angle in arm.joints_deg[:2])
    words = [value.to_bytes(4, "big", signed=True).hex().upper() for value in (first, second)]
    assert heard(frames, 0x2A5)[-1] == "".join(words)
