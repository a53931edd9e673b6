"""Every finding of a check becomes a sentence with its figures."""

from __future__ import annotations

from PySide6.QtWidgets import QApplication

from armui.cell.enclosure import PARTS as ENCLOSED
from armui.trajectory.planning.check import LINKS_COLLIDE, TARGET_BEYOND_LIMIT
from armui.ui.words import findings
from armui.ways.own_body import PARTS


def test_there_is_a_word_for_every_part_of_the_arm() -> None:
    assert {*PARTS, *ENCLOSED} == findings.PARTS


def test_figures_are_as_short_as_they_can_be(qapp: QApplication) -> None:
    beyond = TARGET_BEYOND_LIMIT(joint=2, value=181.25, minimum=0.0, maximum=180.0)
    assert findings.finding(beyond) == (
        "Joint 2 would be at 181.25°, beyond its limits 0° to 180°. Change the point."
    )


def test_parts_are_named_in_words(qapp: QApplication) -> None:
    assert "the gripper against the upper arm" in findings.finding(
        LINKS_COLLIDE(one="upper arm", other="gripper")
    )
