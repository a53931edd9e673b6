"""Versions in order, and what each does: every row of the table of firmware versions."""

from __future__ import annotations

import pytest

from armui.protocol.firmware_version import (
    RECOMMENDED,
    FirmwareBug,
    FirmwareVersion,
    MitLayout,
    ModeExit,
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
        ("has_friction", "S-V1.5-2", "S-V1.5-8", False, True),
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
        ("mit_torque_nm", "S-V1.8-7", "S-V1.8-8", 8, 16),
        ("has_ik_solution", "S-V1.8-7", "S-V1.8-8", False, True),
        ("has_upside_down", "S-V1.8-7", "S-V1.8-8", False, True),
        ("has_gripper_angle", "S-V1.8-7", "S-V1.8-8", False, True),
    ],
)
def test_what_a_version_changed(field, before, since, was, then):
    assert getattr(quirks(before), field) == was
    assert getattr(quirks(since), field) == then
    assert getattr(quirks("S-V1.9-0"), field) == then


@pytest.mark.parametrize(
    ("version", "model", "signs", "known"),
    [
        ("S-V1.7-2", PiperModel.PIPER, (-1, -1, 1, -1, 1, -1), True),
        ("S-V1.7-2", PiperModel.PIPER_H, (-1, -1, 1, -1, 1, -1), False),
        ("S-V1.7-3", PiperModel.PIPER_L, STRAIGHT, True),
        ("S-V1.8-7", PiperModel.PIPER_X, STRAIGHT, False),
        ("S-V1.8-8", PiperModel.PIPER_X, (1, 1, 1, -1, -1, 1), True),
        ("S-V1.8-8", PiperModel.PIPER_H, STRAIGHT, True),
        ("S-V1.8-9", PiperModel.PIPER_X, STRAIGHT, True),
    ],
)
def test_the_signs_of_mit_depend_on_the_model(version, model, signs, known):
    assert (quirks(version, model).mit_signs, quirks(version, model).mit_signs_known) == (
        signs,
        known,
    )


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
    assert (old.mit_code, old.mit_layout, old.has_friction) == (4, MitLayout.A, False)
