"""Whatever is on the bus: the arm goes on, and what it tells stays valid."""

from __future__ import annotations

from functools import cache

from hypothesis import given, settings
from hypothesis import strategies as st

from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec, Oddity
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware

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


@settings(max_examples=100, deadline=None)
@given(st.sampled_from(Generation), talk)
def test_the_arm_never_raises_and_always_tells_valid_frames(
    generation: Generation, heard: list[tuple[Frame, float]]
) -> None:
    arm = Firmware(generation)
    for frame, dt_s in heard:
        answers = arm.on_frame(frame)
        codec = codec_of(generation, arm.addressing)
        # an answer to a change of offsets still has the identifier before it, which is the same
        for said in (*answers, *arm.step(dt_s)):
            assert not isinstance(codec.decode(said), Oddity), said


@settings(max_examples=100, deadline=None)
@given(st.sampled_from(Generation), st.lists(any_frame, max_size=100))
def test_frames_of_no_meaning_leave_the_arm_at_home(
    generation: Generation, frames: list[Frame]
) -> None:
    """Without motors enabled nothing a host says moves the arm."""
    arm = Firmware(generation)
    for frame in frames:
        if frame.arbitration_id != 0x471:
            arm.on_frame(frame)
    arm.step(0.5)
    assert arm.joints_deg == (0.0,) * 6
    assert arm.enabled == (False,) * 6
