"""Frames as records of a line: literal bytes, and what was packed is unpacked."""

from hypothesis import given
from hypothesis import strategies as st

from armui.protocol.frame import Frame
from armui.protocol.frame_records import RECORD_BYTES, pack, unpack

FRAMES = st.builds(Frame, st.integers(0, 0x7FF), st.binary(max_size=8))


def test_the_bytes():
    records = pack([Frame(0x151, bytes.fromhex("0101320000000000")), Frame(0x4AF, b"\1")])
    assert records.hex() == "5101080101320000000000af04010100000000000000"
    assert len(records) == 2 * RECORD_BYTES


@given(st.lists(FRAMES, max_size=20))
def test_what_was_packed_is_unpacked(frames):
    assert unpack(pack(frames)) == frames
