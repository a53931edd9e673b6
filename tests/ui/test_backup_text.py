"""What 参数备份 says of a file, whatever stands in it."""

from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest

from armui.arm.backup import Backup
from armui.control.events import Level
from armui.control.link.link_state import LINK_LOST
from armui.protocol.generation import Generation, PiperModel
from armui.ui.dialogs.backup import difference_text, origin_text, restored_text, saved_text

PATH = Path("arm.json")


def backup(generation=2, firmware="S-V1.8-5"):
    return Backup(
        saved_at=datetime(2026, 3, 4, 5, 6, tzinfo=UTC),
        program="armui 0.1.0",
        device="can0",
        generation=generation,
        firmware=firmware,
        values={},
    )


def test_a_file_says_where_it_is_from(qapp):
    assert "arm.json: saved" in origin_text(backup(), PATH)
    assert origin_text(backup(1, None), PATH).endswith("can0, generation 1, —")
    assert "No file is open" in origin_text(None, None)


@pytest.mark.parametrize(
    ("generation", "firmware", "said"),
    [
        (Generation.TWO, "S-V1.8-5", ""),
        (None, None, ""),
        (Generation.ONE, None, "generation 2, this one speaks generation 1"),
        (Generation.TWO, "S-V1.5-2", "firmware S-V1.8-5, this arm has S-V1.5-2"),
        (Generation.TWO, None, "this arm has —"),
    ],
)
def test_what_sets_the_arms_apart(qapp, generation, firmware, said):
    text = difference_text(backup(), generation, firmware)
    assert (said in text) if said else text == ""


@pytest.mark.parametrize(
    ("filed", "here", "said"),
    [
        (PiperModel.PIPER_L, PiperModel.PIPER, "from a PiPER L, this arm is a PiPER:"),
        (PiperModel.PIPER_L, PiperModel.PIPER_L, ""),
        (None, PiperModel.PIPER_L, ""),
    ],
)
def test_a_backup_of_another_model_is_said(qapp, filed, here, said):
    one = replace(backup(), model=filed)
    text = difference_text(one, Generation.TWO, "S-V1.8-5", here)
    assert (said in text) if said else text == ""


def test_what_is_missing_in_a_file_is_said(qapp):
    text, level = saved_text(PATH, 35, 0)
    assert (text, level) == ("Saved 35 parameters to arm.json.", Level.DONE)
    text, level = saved_text(PATH, 30, 5)
    assert text.endswith("5 could not be read from the arm and are not in the file.")
    assert level is Level.WARNING


def test_what_was_not_restored_is_told_with_the_first_reason(qapp):
    assert restored_text(3, [])[1] is Level.DONE
    text, level = restored_text(3, [LINK_LOST(), None])
    assert text.startswith("2 of 3 parameters were not restored. ")
    assert "device is gone" in text
    assert level is Level.FAULT
    assert restored_text(3, [None])[0] == "1 of 3 parameters were not restored."
