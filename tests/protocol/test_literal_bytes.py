"""Every message of both generations, against bytes worked out by hand from the protocol text."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from armui.protocol.codec import Codec, Message
from armui.protocol.firmware_version import FirmwareVersion
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.protocol.layout import load_database
from tests.each import check_each
from tests.protocol.rows import ROWS, UNTIL_1_8_7, Row

OLDER = FirmwareVersion(1, 8, 7)
CASES: list[tuple[Codec, Row]] = [
    *((Codec(generation), row) for generation, rows in ROWS.items() for row in rows),
    *((Codec(Generation.TWO, firmware=OLDER), row) for row in UNTIL_1_8_7),
]
IDS = [
    f"gen{int(codec.generation)}{'-' + str(codec.firmware) if codec.firmware else ''}-{row}"
    for codec, row in CASES
]


@pytest.mark.parametrize("generation", Generation)
def test_every_message_of_the_dbc_file_has_its_row(generation):
    names = sorted(message.name for message in load_database(generation).messages)
    assert sorted({row.name for row in ROWS[generation]}) == names


def test_every_message_that_differs_up_to_1_8_7_has_its_row():
    assert [row.name for row in UNTIL_1_8_7] == [f"MitControl{joint}" for joint in range(1, 7)]


def test_each_meaning_of_a_frame_has_its_row():
    """A frame with a selector has as many meanings as the selector has codes."""
    for generation, rows in ROWS.items():
        for message in load_database(generation).messages:
            ids = (signal.multiplexer_ids or [] for signal in message.signals)
            wanted = {code for each in ids for code in each}
            family = message.name.rstrip("0123456789")
            selectors = [signal.name for signal in message.signals if signal.is_multiplexer]
            for selector in selectors:
                known = {
                    row.signals.get(selector, 0) for row in rows if row.name.startswith(family)
                }
                assert wanted <= known, (message.name, wanted - known)


def check_each_row(check: Callable[[Codec, Row], None]) -> None:
    named = dict(zip(IDS, CASES, strict=True))
    check_each(named, lambda name: check(*named[name]))


def test_decodes():
    def check(codec: Codec, row: Row) -> None:
        payload = bytes.fromhex(row.payload)
        decoded = codec.decode(Frame(row.arbitration_id, payload))
        assert isinstance(decoded, Message), decoded
        assert decoded.name == row.name
        signals = codec.layout(row.arbitration_id).variant(payload).signals
        expected = dict.fromkeys(signals, 0) | row.signals
        # Decimal scales come out as the nearest double, only MIT control has others.
        tolerance = 1e-7 if row.name.startswith("MitControl") else 0
        assert decoded.signals == pytest.approx(expected, abs=tolerance, rel=0)

    check_each_row(check)


def test_encodes():
    def check(codec: Codec, row: Row) -> None:
        frame = codec.encode(row.name, **row.signals)
        assert frame == Frame(row.arbitration_id, bytes.fromhex(row.payload)), str(frame)

    check_each_row(check)


def test_cantools_by_itself_reads_the_same_from_the_file():
    """The codec takes a short cut through cantools; users of the DBC file take the long way."""

    def check(codec: Codec, row: Row) -> None:
        database = load_database(codec.generation, codec.quirks.mit_layout)
        message = database.get_message_by_name(row.name)
        signals = message.decode(bytes.fromhex(row.payload), decode_choices=False)
        expected = dict.fromkeys(signals, 0) | row.signals
        assert signals == pytest.approx(expected, abs=1e-7, rel=1e-12)

    check_each_row(check)
