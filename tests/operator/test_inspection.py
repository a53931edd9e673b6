"""The joint inspection as an operator does it: with a healthy arm, a stiff joint, a hot one."""

import pytest
from PySide6.QtGui import QFont

from armui.arm.inspection_record import JointSign
from armui.control.motion.abort import RUN_STOPPED
from armui.control.run.inspection import INSPECTION_NOT_READY
from armui.sim.faults.schedule import fault
from armui.ui.dialogs.inspection import InspectionDialog
from armui.ui.dialogs.inspection_report import write_pdf
from tests.accepted import accepted
from tests.cell.areas import put, wall

PLACE = (0.0, 70.0, -60.0, 0.0, 20.0, 0.0)


def at_place(driver, place=PLACE):
    driver.lie(place)
    driver.ready()
    driver.run(1.0)
    return driver


@pytest.fixture
def ready(app_driver):
    app_driver.repeat_nothing()
    return at_place(app_driver)


def opened(driver):
    """The window, by the way that an operator sees."""
    driver.window.pages.show("about_arm")
    about = driver.window.pages.existing("about_arm")
    driver.click(about.inspect_button)
    about.close()
    dialog = driver.dialog(InspectionDialog)
    dialog.amplitude.setValue(10)
    driver.run_until(dialog.begin_button.isEnabled)
    return dialog


def begun(driver):
    dialog = opened(driver)
    driver.hold_button(dialog.begin_button)
    driver.run(0.1)
    assert driver.controller.replayer.running
    assert "% of the inspection" in driver.read("run_text")
    return dialog


def inspected(driver):
    dialog = begun(driver)
    inspection = driver.controller.inspection
    driver.run_until(lambda: not driver.controller.replayer.running, seconds=200.0)
    driver.run(0.2)
    assert inspection.report is not None
    return dialog, inspection.report


def stands_out(report):
    return {(each.joint, each.sign) for each in report.findings}


def swing(dialog, joint):
    return dialog._labels[joint][1].text()


def about(driver, key):
    """A line of «About this arm»."""
    driver.window.pages.show("about_arm")
    return next(
        each.value for each in driver.window.pages.existing("about_arm")._rows if each.key == key
    )


def test_of_a_healthy_arm_nothing_stands_out_and_that_is_kept(ready):
    assert about(ready, "inspection") == "Never inspected"
    dialog, report = inspected(ready)
    assert report.findings == ()
    assert report.unmeasured == {}
    text = dialog.report_view.toPlainText()
    assert "Nothing stands out." in text
    assert "Swings of ±10° at 10.0°/s" in text
    assert dialog.report_view.isVisible()
    assert about(ready, "inspection").endswith(": nothing stands out")
    assert ready.codes()[-1] == "inspected"
    assert ready.firmware.joints_deg == pytest.approx(PLACE, abs=0.2)


def test_a_stiff_and_a_hot_joint_stand_out_with_what_helps(ready, tmp_path):
    ready.node.faults.start(fault("stiff-joint", 3))
    ready.node.faults.start(fault("hot-joint", 5))
    dialog, report = inspected(ready)
    assert stands_out(report) == {
        *((3, JointSign.BEHIND), (3, JointSign.CURRENT)),
        *((5, JointSign.MOTOR), (5, JointSign.DRIVER)),
    }
    text = dialog.report_view.toPlainText()
    assert "J3 needs" in text
    assert "turn it by hand: does it grind or catch?" in text
    assert "The motor of J5 is at" in text
    assert "Let the arm cool" in text
    assert about(ready, "inspection").endswith(": joint 3, 5 stands out")
    path = tmp_path / "report.pdf"
    write_pdf(report, ["Model: PiPER"], QFont(), path)
    assert path.read_bytes().startswith(b"%PDF")
    assert path.read_bytes().count(b"/Type /Page\n") == 1


def test_what_has_grown_since_earlier_stands_out(ready):
    inspected(ready)
    ready.firmware.mechanics.drag_nm = (0.0, 0.0, 0.0, 0.0, 0.35, 0.0)
    dialog, report = inspected(ready)
    assert stands_out(report) == {(5, JointSign.CURRENT)}
    assert report.findings[-1].earlier
    assert "earlier 0.0" in dialog.report_view.toPlainText()
    assert "compared with 1 earlier inspections" in dialog.report_view.toPlainText()


def test_the_swings_are_shortened_by_limits_and_zones_and_that_is_said(app_driver):
    app_driver.repeat_nothing()
    driver = at_place(app_driver, (0.0, 70.0, -60.0, 94.0, 20.0, 0.0))
    dialog = opened(driver)
    assert swing(dialog, 4) == "−10° +5°"
    assert "100" in dialog._labels[4][2].text()
    assert swing(dialog, 1) == "−10° +10°"
    put(driver.controller, wall(330.0))
    driver.run(1.0)
    assert swing(dialog, 2) != "−10° +10°"
    assert "wall" in dialog._labels[2][2].text()


def test_the_room_is_looked_for_anew_where_the_arm_has_gone(ready):
    dialog = opened(ready)
    accepted(ready.controller.motion.send_joints((0.0, 70.0, -60.0, 95.0, 20.0, 0.0)))
    ready.run(0.3)
    assert not dialog.begin_button.isEnabled()
    ready.run(6.0)
    assert dialog.begin_button.isEnabled()
    assert swing(dialog, 4) == "−10° +3.75°"


def test_a_short_press_moves_nothing(ready):
    dialog = opened(ready)
    ready.heard()
    ready.hold_button(dialog.begin_button, share=0.5)
    ready.run(0.5)
    assert not ready.controller.replayer.running


def test_nothing_begins_before_the_room_is_known(ready):
    refusal = ready.controller.inspection.start(20.0)
    assert refusal.reason == INSPECTION_NOT_READY
    assert not ready.controller.replayer.running


def cut_off(driver, dialog):
    """What the report says of an inspection that ended early, in its third joint's turn."""
    report = driver.controller.inspection.report
    assert report is not None
    assert [figures is None for figures in report.entry.joints] == [False] * 2 + [True] * 4
    assert set(report.unmeasured) == {3, 4, 5, 6}
    text = dialog.report_view.toPlainText()
    assert "It ended early." in text
    assert "J3: The inspection ended before its turn was over." in text
    assert "inspection_incomplete" in driver.codes()
    return report


def is_kept(driver):
    assert about(driver, "inspection").endswith(
        ": nothing stands out; joint 3, 4, 5, 6 was not measured"
    )


def in_the_third_turn(driver):
    dialog = begun(driver)
    driver.run_until(lambda: driver.controller.inspection.joint == 3, seconds=60.0)
    driver.run(1.0)
    assert "J3 swings." in dialog._message.text()
    return dialog


def test_a_stop_in_the_middle_ends_it_and_the_report_says_so(ready):
    dialog = in_the_third_turn(ready)
    ready.click(dialog.stop_button)
    ready.run(0.5)
    report = cut_off(ready, dialog)
    is_kept(ready)
    assert report.ended.reason == RUN_STOPPED
    assert not ready.controller.replayer.running


def test_so_does_the_end_of_the_run_by_the_operator(ready):
    dialog = in_the_third_turn(ready)
    ready.click("run_stop")
    ready.run(2.0)
    cut_off(ready, dialog)
    assert ready.firmware.enabled == (True,) * 6


def test_and_silence(ready):
    dialog = in_the_third_turn(ready)
    ready.firmware.feedback_stopped = True
    ready.run(3.0)
    cut_off(ready, dialog)
    ready.firmware.feedback_stopped = False
    ready.run(3.0)
    is_kept(ready)


def test_and_another_host(ready, other_host):
    dialog = in_the_third_turn(ready)
    other_host.say("155#0000000000000000")
    ready.run(1.0)
    assert "0x155" in str(cut_off(ready, dialog).ended.params)


def test_and_a_lost_connection(ready):
    in_the_third_turn(ready)
    ready.controller.disconnect_device()
    ready.run(0.5)
    report = ready.controller.inspection.report
    assert [figures is None for figures in report.entry.joints] == [False] * 2 + [True] * 4


def test_a_speed_that_is_changed_meanwhile_is_no_measurement(ready):
    dialog = begun(ready)
    ready.run_until(lambda: ready.controller.inspection.joint == 2, seconds=60.0)
    accepted(ready.controller.motion.set_speed_percent(15))
    ready.run_until(lambda: ready.controller.inspection.joint == 3, seconds=60.0)
    ready.click("run_stop")
    ready.run(2.0)
    report = ready.controller.inspection.report
    assert report.entry.joints[0] is not None
    assert str(report.unmeasured[2].reason) == "swing_not_heard"
    assert "the speed was changed meanwhile" in dialog.report_view.toPlainText()
