"""Which frames the filter of the bus monitor lets through."""

import pytest

from armui.telemetry.bus_senders import Sender
from armui.telemetry.bus_statistics import FrameRow
from armui.ui.watch.bus.frame_filter import FrameFilter, IdFilter, parse_ids


def row(arbitration_id=0x2A5, sender=Sender.ARM, changed_s=0.0, invalid_count=0):
    return FrameRow(
        number=0,
        arbitration_id=arbitration_id,
        flags=0,
        sender=sender,
        count=1,
        last_s=1.0,
        data=bytes(8),
        changed_s=(changed_s,) * 8,
        times_s=(1.0,),
        max_gap_s=None,
        invalid=None,
        invalid_count=invalid_count,
        invalid_length=0,
        invalid_s=0.0,
    )


def words(each):
    return f"0x{each.arbitration_id:03X} JointFeedback12 Angles of J1, J2"


@pytest.mark.parametrize(
    ("text", "inside", "outside"),
    [
        ("2A1", [0x2A1], [0x2A2]),
        ("0x2a1", [0x2A1], [0x2A2]),
        ("2A1-2A3", [0x2A1, 0x2A3], [0x2A0, 0x2A4]),
        ("2A3 – 2A1", [0x2A2], [0x2A4]),
        ("150/7F0", [0x150, 0x15F], [0x160, 0x2A1]),
        ("155, 2A1-2A3;471", [0x155, 0x2A2, 0x471], [0x156]),
        ("155 156", [0x155, 0x156], [0x157]),
        ("18FF50E5", [0x18FF50E5], [0x0E5]),
        ("", [0x000, 0x7FF], []),
    ],
)
def test_identifiers(text, inside, outside):
    ids = parse_ids(text)
    assert isinstance(ids, IdFilter)
    assert all(ids.accepts(each) for each in inside)
    assert not any(ids.accepts(each) for each in outside)


@pytest.mark.parametrize(
    ("text", "bad"), [("2A1, xyz", "xyz"), ("2A1-", "2A1-"), ("123456789", "123456789")]
)
def test_what_is_no_identifier_is_named(text, bad):
    assert parse_ids(text) == bad


@pytest.mark.parametrize(
    ("wanted", "each", "shown"),
    [
        (FrameFilter(), row(), True),
        (FrameFilter(text="angles"), row(), True),
        (FrameFilter(text="2a5"), row(), True),
        (FrameFilter(text="gripper"), row(), False),
        (FrameFilter(sender=Sender.OWN), row(), False),
        (FrameFilter(sender=Sender.ARM), row(), True),
        (FrameFilter(only_unknown=True), row(), False),
        (FrameFilter(only_unknown=True), row(invalid_count=1), True),
        (FrameFilter(changed_since_s=5.0), row(changed_s=4.9), False),
        (FrameFilter(changed_since_s=5.0), row(changed_s=5.1), True),
    ],
)
def test_each_wish(wanted, each, shown):
    assert wanted.accepts(each, words) is shown
    assert FrameFilter(ids=IdFilter(((0x100, 0x1FF),))).accepts(each, words) is False
