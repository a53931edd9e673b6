"""Every finding of a check becomes a sentence with its figures."""

from __future__ import annotations

import pytest
from PySide6.QtWidgets import QApplication

from armui.trajectory.planning.collision import PARTS
from armui.trajectory.planning.findings import SEVERITIES, Finding, FindingCode
from armui.ui.words import findings


def test_there_is_a_sentence_for_every_finding_and_for_no_other() -> None:
    assert set(FindingCode) == set(SEVERITIES) == findings.CODES


def test_there_is_a_word_for_every_part_of_the_arm() -> None:
    assert set(PARTS) == findings.PARTS


@pytest.mark.parametrize("code", sorted(SEVERITIES))
def test_a_finding_reads_as_sentences(qapp: QApplication, code: FindingCode) -> None:
    text = findings.finding(Finding(code))

    assert text.endswith(".")
    assert "{" not in text


def test_figures_are_as_short_as_they_can_be(qapp: QApplication) -> None:
    limits = {"joint": 2, "value": 181.25, "minimum": 0.0, "maximum": 180.0}

    assert findings.finding(Finding(FindingCode.TARGET_BEYOND_LIMIT, limits)) == (
        "Joint 2 would be at 181.25°, beyond its limits 0° to 180°. Change the point."
    )


def test_parts_are_named_in_words(qapp: QApplication) -> None:
    assert "the gripper against the upper arm" in findings.finding(
        Finding(FindingCode.LINKS_COLLIDE, {"one": "upper arm", "other": "gripper"})
    )
