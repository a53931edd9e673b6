"""The reference check as an operator clicks through it, and what is read meanwhile."""

import pytest
from PySide6.QtTest import QTest

from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.reference_check import ReferenceDialog
from tests.accepted import accepted
from tests.moments import now


@pytest.fixture
def lost(app_driver):
    """An enabled arm whose joint 5 has just lost its reference, with its window open."""
    app_driver.ready()
    app_driver.run(1.5)
    app_driver.firmware.lost_reference.begin(4)
    app_driver.run(2.0)
    return app_driver


def opened(driver):
    driver.click("recovery_button")
    return driver.dialog(ReferenceDialog)


def task(dialog):
    return dialog._task.text()


def by_hand(driver, dialog):
    """Switch the motor off of the joint in doubt; it is turned by hand."""
    driver.click(dialog.off_button)
    assert "hold the arm with both hands" in driver.dialog(ConfirmDialog).text()
    driver.hold()
    driver.run(1.0)
    assert driver.firmware.enabled == (True, True, True, True, False, True)


def result(dialog, joint):
    return dialog._labels[joint][3].text()


def test_enter_begins_the_check_and_never_the_way_round_it(lost):
    dialog = opened(lost)
    assert dialog.allow_button.isVisible()
    assert dialog.focusWidget() is dialog.begin_button
    assert dialog.begin_button.property("primary")


def test_it_is_said_in_the_line_the_joint_status_and_the_events(lost):
    line = lost.find("recovery_text").text()
    assert line.startswith("Joint 5 left its place uncommanded while it was enabled")
    assert lost.find("recovery_button").text() == "Reference check…"
    assert lost.find("recovery_button").property("primary")
    assert not lost.find("recovery_other_button").property("primary")
    lost.click("joint_status_button")
    assert lost.find("joint_status_reference").text().startswith("Joint 5 may stand elsewhere")
    (event,) = [each for each in lost.events if each.code == "reference_left"]
    assert (event.params["joint"], event.params["place"]) == (5, 0.0)


def test_moving_anyway_is_asked_about_and_held(lost):
    assert lost.find("send_button").isEnabled() is False
    lost.click("recovery_other_button")
    question = lost.dialog(ConfirmDialog)
    assert "may strike itself or the table" in question.text()
    lost.hold()
    lost.run(0.1)
    assert "Motions are agreed to" in lost.find("recovery_text").text()
    assert lost.controller.operating_state.cannot_move is None


def test_from_the_first_click_to_the_result(lost):
    dialog = opened(lost)
    assert "Joint 5 in doubt since" in task(dialog)
    lost.click(dialog.begin_button)
    assert "Look at the whole arm" in task(dialog)
    assert dialog._elsewhere[5].isChecked()
    lost.click(dialog.look_button)
    assert "nothing drives it" in task(dialog)
    assert not dialog.drive_button.isVisible()
    assert now(dialog.mark_button.isEnabled()) is False
    by_hand(lost, dialog)
    lost.click(dialog.mark_button)
    assert now(result(dialog, 5)) == "fits"  # it reports its mark, whatever is true
    lost.click(dialog.back_button)
    QTest.keyClicks(dialog.off_field, "-60")
    lost.click(dialog.differs_button)
    assert now(result(dialog, 5)) == "off by -60.000°"
    assert "Hold “Drive to the mark”" in task(dialog)
    assert dialog.drive_button.isVisible()
    for joint in (1, 2, 3, 4, 6):
        assert f"oint {joint}" in task(dialog)
        lost.click(dialog.mark_button)
    assert "some are off" in task(dialog)
    lost.click(dialog.finish_button)
    assert "What can be done: (1) Reset with the arm held" in task(dialog)
    assert lost.controller.operating_state.reference.doubtful == (5,)


def test_a_check_where_all_fits_ends_the_doubt_and_is_dated(lost):
    dialog = opened(lost)
    lost.click(dialog.begin_button)
    lost.click(dialog.look_button)
    by_hand(lost, dialog)
    for _ in range(6):
        lost.click(dialog.mark_button)
    assert dialog.finish_button.isVisible()
    lost.click(dialog.finish_button)
    assert "all joints fit" in task(dialog)
    accepted(lost.controller.motors.enable())
    lost.run(0.5)
    assert lost.find("recovery_text").text() == "Ready"
    lost.program.window.pages.show("about_arm")
    about = lost.program.window.pages.existing("about_arm")
    row = next(each for each in about._rows if each.key == "reference")
    assert row.value.startswith("Last checked 20")
    assert row.value.endswith(": all joints fit")


def test_closing_it_leaves_the_doubt(lost):
    dialog = opened(lost)
    lost.click(dialog.begin_button)
    assert lost.controller.operating_state.reference.checking
    dialog.reject()
    assert not lost.controller.operating_state.reference.checking
    assert lost.controller.operating_state.reference.doubtful == (5,)
    assert lost.codes()[-1] == "reference_check_left"


def test_joints_without_a_mark_are_compared_with_the_taught_pose(app_driver, tmp_path):
    driver = app_driver
    driver.ready()
    accepted(driver.controller.motion.send_joints((0.0, 40.0, -30.0, 0.0, 0.0, 0.0)))
    driver.run(4.0)
    accepted(driver.controller.reference.teach())
    driver.controller.reference.keep_photo(str(tmp_path / "none.jpg"))
    driver.program.window.pages.show("reference")
    dialog = driver.dialog(ReferenceDialog)
    driver.click(dialog.begin_button)
    driver.click(dialog.look_button)
    driver.click(dialog.mark_button)
    assert dialog._labels[2][2].text() == "40.000°"
    assert "its place in the reference pose" in task(dialog)
    assert dialog._picture.text() == "The photo cannot be read."
    driver.click(dialog.mark_button)
    assert result(dialog, 2) == "fits"
