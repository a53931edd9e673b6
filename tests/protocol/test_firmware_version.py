"""Versions in order, and what each does: every row of the table of firmware versions."""

from __future__ import annotations

import pytest

from armui.protocol.firmware_version import (
    RECOMMENDED,
    AnswerCollector,
    ArmIdentity,
    FirmwareBug,
    FirmwareVersion,
    MitLayout,
    ModeExit,
    find_identity,
    find_version,
    is_question,
    quirks_of,
)
from armui.protocol.generation import PiperModel

STRAIGHT = (1, 1, 1, 1, 1, 1)


def quirks(text, model=PiperModel.PIPER):
    return quirks_of(FirmwareVersion.parse(text), model)


def test_versions_are_ordered_as_numbers_and_not_as_text():
    texts = ["S-V1.10-1", "S-V1.8-9", "S-V1.8-10", "S-V1.9-0", "S-V1.5-8", "S-V2.0-0"]
    ordered = sorted(version for version in map(FirmwareVersion.parse, texts) if version)
    assert [str(version) for version in ordered] == [
        "S-V1.5-8", "S-V1.8-9", "S-V1.8-10", "S-V1.9-0", "S-V1.10-1", "S-V2.0-0",
    ]  # fmt: skip


@pytest.mark.parametrize("text", ["", "S-V1", "S-V1.8", "1.8-9", "S-V1.8-9x", "S-V1.8-5260716"])
def test_what_is_no_version_is_none(text):
    assert FirmwareVersion.parse(text) is None


@pytest.mark.parametrize(
    ("field", "before", "since", "was", "then"),
    [
        ("shifted_zeros", "S-V1.6-2", "S-V1.6-3", True, False),
        ("mit_signs", "S-V1.7-2", "S-V1.7-3", (-1, -1, 1, -1, 1, -1), STRAIGHT),
        ("has_leader_zero", "S-V1.7-3", "S-V1.7-4", False, True),
        ("has_cpv", "S-V1.7-4", "S-V1.8-1", False, True),
        ("has_drag_assistance", "S-V1.7-4", "S-V1.8-1", False, True),
        ("mit_torque_factors", "S-V1.8-2", "S-V1.8-3", (4, 4, 4, 1, 1, 1), STRAIGHT),
        ("exits_by_mode_word", "S-V1.8-4", "S-V1.8-5", False, True),
        ("mode_exit", "S-V1.8-5", "S-V1.8-6", ModeExit.RESET, ModeExit.MODE_WORD),
        ("mit_code", "S-V1.8-7", "S-V1.8-8", 4, 6),
        ("mit_layout", "S-V1.8-7", "S-V1.8-8", MitLayout.A, MitLayout.B),
        ("has_ik_solution", "S-V1.8-7", "S-V1.8-8", False, True),
        ("has_upside_down", "S-V1.8-7", "S-V1.8-8", False, True),
        ("has_gripper_angle", "S-V1.8-7", "S-V1.8-8", False, True),
        ("disable_frees_gripper", "S-V1.8-9", "S-V1.9-0", False, True),
    ],
)
def test_what_a_version_changed(field, before, since, was, then):
    assert getattr(quirks(before), field) == was
    assert getattr(quirks(since), field) == then
    assert getattr(quirks("S-V1.9-0"), field) == then


@pytest.mark.parametrize(
    ("version", "model", "signs"),
    [
        ("S-V1.7-2", PiperModel.PIPER, (-1, -1, 1, -1, 1, -1)),
        ("S-V1.7-2", PiperModel.PIPER_H, (-1, -1, 1, -1, 1, -1)),
        ("S-V1.7-3", PiperModel.PIPER_L, STRAIGHT),
        ("S-V1.8-7", PiperModel.PIPER_X, STRAIGHT),
        ("S-V1.8-8", PiperModel.PIPER_X, (1, 1, 1, -1, -1, 1)),
        ("S-V1.8-8", PiperModel.PIPER_H, STRAIGHT),
        ("S-V1.8-9", PiperModel.PIPER_X, STRAIGHT),
    ],
)
def test_the_signs_of_mit_depend_on_the_model(version, model, signs):
    assert quirks(version, model).mit_signs == signs


def test_the_signs_of_cpv_are_wrong_in_every_version():
    assert quirks("S-V1.9-0").cpv_position_signs == STRAIGHT
    assert quirks("S-V1.9-0", PiperModel.PIPER_L).cpv_speed_signs == (1, -1, -1, -1, -1, 1)
    x = quirks("S-V1.9-0", PiperModel.PIPER_X)
    assert x.cpv_position_signs == (1, 1, 1, -1, -1, 1)
    assert x.cpv_speed_signs == (1, -1, -1, 1, 1, 1)


def test_a_bug_belongs_to_the_version_it_was_reported_of():
    assert quirks("S-V1.8-6").bugs == {FirmwareBug.FEEDBACK_PARTS}
    assert FirmwareBug.MIT_MOVES_ZERO in quirks("S-V1.8-2").bugs
    assert quirks_of(RECOMMENDED).bugs == frozenset()


def test_a_version_before_generation_2_counts_as_its_first():
    old = quirks("S-V1.4-0")
    assert (old.mit_code, old.mit_layout) == (4, MitLayout.A)


def answer(
    hardware=b"H-V1.2-1", batch=b"10", node=b"ARM_MC", software=b"S-V1.6-5", date=b"250318",
    number=b"15",
) -> bytes:  # fmt: skip
    """88 bytes, each part at its place."""
    text = bytearray(88)
    for start, part in ((0, hardware), (16, batch), (32, node), (60, software), (68, date)):
        text[start : start + len(part)] = part
    text[76 : 76 + len(number)] = number
    return bytes(text)


def frames(text: bytes) -> list[bytes]:
    return [text[start : start + 8] for start in range(0, len(text), 8)]


def collected(payloads, every_s=0.002) -> ArmIdentity | None:
    collector = AnswerCollector()
    for place, payload in enumerate(payloads):
        collector.take(payload, place * every_s)
    return collector.identity


REAL = ArmIdentity("S-V1.6-5", "H-V1.2-1", "ARM_MC", "10", "250318", "15")


def test_a_real_answer():
    assert len(frames(answer())) == 11
    assert collected(frames(answer())) == REAL
    assert REAL.iso_date == "2025-03-18"


def test_without_padding_the_date_follows_at_once():
    """As a field report shows: S-V1.9-0260716 on a PiPER X."""
    text = answer(node=b"Piper_X_MC", software=b"S-V1.9-0", date=b"260716")
    assert b"S-V1.9-0260716" in text
    identity = find_identity(text)
    assert (identity.software, identity.date, identity.node_type) == (
        "S-V1.9-0", "260716", "Piper_X_MC",
    )  # fmt: skip


def test_a_node_type_that_fills_its_place_is_not_mixed_with_the_version():
    node = b"A" * 27 + b"_"
    assert find_identity(answer(node=node)).node_type == node.decode()


@pytest.mark.parametrize("lost", range(11))
def test_one_lost_frame_gives_the_version_or_none_but_no_other(lost):
    payloads = frames(answer())
    del payloads[lost]
    identity = collected(payloads)
    # the version lies in frames 7 and 8
    assert (identity is None) == (lost in {7, 8})
    if identity is not None:
        assert identity.software == "S-V1.6-5"
        assert identity.hardware in {"H-V1.2-1", ""}
        assert identity.node_type in {"ARM_MC", ""}
        assert identity.date in {"250318", ""}


def test_a_cut_read_is_no_version():
    assert find_version(answer()[:64]) is None  # S-V1
    assert collected(frames(answer())[:8]) is None
    assert collected(frames(answer())[:9]).software == "S-V1.6-5"


@pytest.mark.parametrize("cut", range(12))
def test_a_second_answer_in_the_middle_of_the_first(cut):
    payloads = frames(answer())
    identity = collected([*payloads[:cut], *payloads, *payloads[cut:]])
    assert identity.software == "S-V1.6-5"
    assert identity.hardware == "H-V1.2-1"
    assert identity.date in {"250318", ""}


def test_other_frames_among_the_answer_shift_it_and_nothing_else():
    payloads = frames(answer())
    payloads.insert(3, bytes(8))
    assert collected(payloads) == REAL


def test_what_comes_after_a_pause_is_another_answer():
    collector = AnswerCollector()
    first, second = frames(answer()), frames(answer(software=b"S-V1.8-9", date=b"260301"))
    for place, payload in enumerate(first[:8]):  # S-V1, and no more of it
        collector.take(payload, place * 0.002)
    for place, payload in enumerate(second[8:], 1):  # .8-9260301
        collector.take(payload, 1.0 + place * 0.002)
    assert collector.identity is None


def test_an_answer_that_begins_takes_nothing_away_from_the_one_before():
    collector = AnswerCollector()
    payloads = frames(answer())
    for place, payload in enumerate(payloads):
        collector.take(payload, place * 0.002)
    for place, payload in enumerate(payloads):
        assert collector.take(payload, 5.0 + place * 0.002) == REAL


def test_another_version_takes_the_place_of_the_one_before():
    collector = AnswerCollector()
    for payload in frames(answer()):
        collector.take(payload, 0.0)
    for payload in frames(answer(software=b"S-V1.8-9", date=b"260301")):
        collector.take(payload, 5.0)
    assert collector.identity.software == "S-V1.8-9"
    assert collector.identity.date == "260301"


def test_a_date_that_is_none_is_shown_as_it_came():
    assert ArmIdentity("S-V1.8-5", date="991399").iso_date == "991399"
    assert ArmIdentity("S-V1.8-5").iso_date == ""


def test_both_forms_of_the_question():
    assert is_question(bytes.fromhex("01 00 00 00 00 00 00 00"))
    assert is_question(b"\x01")
    assert not is_question(bytes(8))


def test_a_version_is_named_with_its_date_and_the_time_its_text_began():
    collector = AnswerCollector()
    for at, each in enumerate(frames(answer()[:72])):
        collector.take(each, 10.0 + 0.001 * at)
    # the text begins at byte 60, in the eighth frame; half of the date is still to come
    ((software, date, began_s),) = collector.named
    assert (software, date) == ("S-V1.6-5", "")
    assert began_s == pytest.approx(10.007)
    collector.take(frames(answer())[9], 10.009)
    assert collector.named[0].date == "250318"


@pytest.mark.parametrize(
    ("field", "other"),
    [("software", "S-V1.6-4"), ("hardware", "H-V1.3-1"), ("date", "250319"), ("node_number", "16")],
)
def test_another_text_is_another_arm(field, other):
    one = ArmIdentity("S-V1.6-5", "H-V1.2-1", "ARM_MC", "10", "250318", "15")
    assert one.contradicts(one._replace(**{field: other}))
    assert not one.contradicts(one._replace(**{field: ""}))
    assert not one.contradicts(one._replace(batch="11", node_type="ARM"))


def test_a_torn_answer_is_no_other_number_and_a_whole_one_is():
    collector = AnswerCollector()
    for each in frames(answer()):
        collector.take(each, 1.0)
    for each in frames(answer(number=b"16"))[1:]:
        collector.take(each, 3.0)
    assert collector.identity.node_number == "15"
    for each in frames(answer(number=b"16")):
        collector.take(each, 5.0)
    assert collector.identity.node_number == "16"
