"""Every message of both generations, against bytes worked out by hand from the protocol text."""

from __future__ import annotations

import pytest

from armui.protocol.codec import Codec, Message
from armui.protocol.database import load_database
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.protocol.rows import ROWS, Row

CASES = [(generation, row) for generation, rows in ROWS.items() for row in rows]
IDS = [f"gen{int(generation)}-{row}" for generation, row in CASES]


@pytest.mark.parametrize("generation", Generation)
def test_every_message_of_the_dbc_file_has_its_row(generation):
    names = sorted(message.name for message in load_database(generation).messages)
    assert sorted(row.name for row in ROWS[generation]) == names


@pytest.mark.parametrize(("generation", "row"), CASES, ids=IDS)
def test_decodes(generation: Generation, row: Row):
    codec = Codec(generation)
    decoded = codec.decode(Frame(row.arbitration_id, bytes.fromhex(row.payload)))
    assert isinstance(decoded, Message), decoded
    assert decoded.name == row.name
    expected = dict.fromkeys(codec.signals(row.name), 0) | row.signals
    # Decimal scales come out as the nearest double, only MIT control has others.
    tolerance = 1e-7 if row.name.startswith("MitControl") else 0
    assert decoded.signals == pytest.approx(expected, abs=tolerance, rel=0)


@pytest.mark.parametrize(("generation", "row"), CASES, ids=IDS)
def test_encodes(generation: Generation, row: Row):
    frame = Codec(generation).encode(row.name, **row.signals)
    assert frame == Frame(row.arbitration_id, bytes.fromhex(row.payload)), str(frame)


@pytest.mark.parametrize(("generation", "row"), CASES, ids=IDS)
def test_cantools_by_itself_reads_the_same_from_the_file(generation: Generation, row: Row):
    """The codec takes a short cut through cantools; users of the DBC file take the long way."""
    message = load_database(generation).get_message_by_name(row.name)
    signals = message.decode(bytes.fromhex(row.payload), decode_choices=False)
    expected = dict.fromkeys(signals, 0) | row.signals
    assert signals == pytest.approx(expected, abs=1e-7, rel=1e-12)
