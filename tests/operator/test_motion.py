"""An operator at the main window: clicks and keys in, bytes at the arm and words on screen out."""

import errno
from concurrent.futures import Future

import can
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMessageBox

from armui.control.link.link_state import LinkState
from armui.control.operating_state import StopState
from armui.protocol.frame import Frame
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.widgets.stop_button import StopButton
from tests.control.test_started import outside_limits

STOP = Frame(0x150, bytes.fromhex("01 00 00 00 00 00 00 00"))
RESUME = Frame(0x150, bytes.fromhex("02 00 00 00 00 00 00 00"))
ENABLE = Frame(0x471, bytes.fromhex("07 02 00 00 00 00 00 00"))
DISABLE = Frame(0x471, bytes.fromhex("07 01 00 00 00 00 00 00"))


def angles(app_driver):
    return [round(angle, 3) for angle in app_driver.firmware.joints_deg]


@pytest.fixture
def online(app_driver):
    """Connected, not enabled."""
    app_driver.connect_by_hand()
    app_driver.heard()
    return app_driver


@pytest.fixture
def ready(online):
    """Connected and enabled by hand."""
    online.enable_by_hand()
    online.heard()
    return online


# Connecting --------------------------------------------------------------------------------------


def test_before_connecting_nothing_is_made_up(app_driver):
    for joint in range(1, 7):
        assert app_driver.read(f"measured_{joint}") == "—"
        assert app_driver.find(f"target_field_{joint}").text() == ""
    assert app_driver.read("status_arm").endswith("—")
    assert "No arm is connected" in app_driver.read("recovery_text")
    assert app_driver.read("motion_message") == ""  # said once


def test_connecting_shows_the_arm_online_and_its_angles(any_driver):
    app_driver = any_driver
    app_driver.connect_by_hand()
    app_driver.step()
    assert "Online" in app_driver.find("communication_button").accessibleName()
    assert app_driver.read("measured_3") == "0.000°"
    assert app_driver.find("target_field_3").text() == "0.000"
    assert "Normal" in app_driver.read("status_arm")
    assert app_driver.heard() == []  # looking at an arm commands nothing


def test_a_device_that_cannot_be_opened_says_why_where_the_operator_looks(app_driver):
    app_driver.broken = OSError(errno.EACCES, "Permission denied")
    app_driver.click("communication_button")
    dialog = app_driver.dialog(ConnectDialog)
    app_driver.wait(lambda: dialog._table.model().rowCount() > 0)
    dialog._table.selectRow(0)
    app_driver.click(dialog.connect_button)
    app_driver.wait(lambda: "connect_failed" in app_driver.codes())
    assert "You may not open" in dialog._message.text()
    app_driver.broken = None
    app_driver.click(dialog.connect_button)
    app_driver.run_until(lambda: app_driver.controller.operating_state.link is LinkState.ONLINE)


def test_disconnecting_by_hand_leaves_no_value_standing(online):
    online.click("communication_button")
    dialog = online.dialog(ConnectDialog)
    online.click(dialog.disconnect_button)
    online.wait(lambda: online.controller.operating_state.link is LinkState.NO_DEVICE)
    assert online.read("measured_1") == "—"


def test_an_arm_that_falls_silent_is_offline_and_cannot_be_moved(ready):
    ready.powered = False
    ready.run(0.6)
    assert "Offline" in ready.find("communication_button").accessibleName()
    assert not ready.find("send_button").isEnabled()
    assert "nothing is heard" in ready.find("send_button").toolTip()
    assert "Nothing is heard" in ready.read("recovery_text")
    assert ready.read("motion_message") == ""
    ready.powered = True
    ready.run_until(lambda: ready.controller.operating_state.cannot_move is None)
    assert ready.find("send_button").isEnabled()


def test_an_unplugged_device_is_shown_and_comes_back(ready):
    ready.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    ready.wait(lambda: "link_lost" in ready.codes())
    assert "Online" not in ready.find("communication_button").accessibleName()
    assert "gone" in ready.read("recovery_text")
    ready.plug_in()
    ready.wait(lambda: "reconnected" in ready.codes())
    ready.run_until(lambda: ready.controller.operating_state.cannot_move is None)
    assert ready.heard() == []


# Enabling ----------------------------------------------------------------------------------------


def test_enabling_shows_six_motors_on(any_driver):
    app_driver = any_driver
    app_driver.connect_by_hand()
    app_driver.heard()
    assert "Disabled" in app_driver.find("enable_button").accessibleName()
    app_driver.click("enable_button")
    app_driver.run_until(lambda: "enabled" in app_driver.codes())
    assert app_driver.heard() == [ENABLE]
    assert app_driver.firmware.enabled == (True,) * 6
    assert app_driver.find("enable_button").accessibleName().startswith("Enabled")


def test_disabling_warns_that_the_arm_falls_and_only_then_does_it(ready):
    ready.click("enable_button")
    question = ready.dialog(ConfirmDialog)
    ready.run(0.1)
    assert ready.heard() == []
    ready.click(question.cancel_button)
    ready.run(0.1)
    assert ready.firmware.enabled == (True,) * 6
    ready.click("enable_button")
    ready.confirm()
    ready.run_until(lambda: "disabled" in ready.codes())
    assert ready.heard() == [DISABLE]


# Moving ------------------------------------------------------------------------------------------


def test_without_enabled_motors_moving_is_refused_with_the_reason(online):
    for name in ("send_button", "home_button", "jog_plus_1", "jog_minus_6"):
        assert not online.find(name).isEnabled()
        assert "not enabled" in online.find(name).toolTip()
        online.click(name)
    assert "motors are off" in online.read("recovery_text")
    online.run(0.1)
    assert online.heard() == []


def test_plus_moves_one_joint_by_one_step(ready):
    ready.click("jog_plus_2")
    ready.run_until(lambda: angles(ready)[1] == 1)
    ready.run(0.1)
    assert angles(ready) == [0, 1, 0, 0, 0, 0]
    assert ready.read("measured_2") == "1.000°"
    assert ready.find("target_field_2").text() == "1.000"


def test_jogging_sends_no_angle_that_was_only_typed(ready):
    ready.type_into("target_field_1", "90")
    ready.click("jog_plus_2")
    ready.run_until(lambda: angles(ready)[1] == 1)
    ready.run(0.2)
    assert angles(ready) == [0, 1, 0, 0, 0, 0]
    assert ready.find("target_field_1").text() == "90.000"


def test_a_jog_over_the_limit_is_refused_and_says_so(ready):
    ready.click("jog_minus_2")
    ready.run(0.1)
    assert ready.heard() == []
    message = ready.read("motion_message")
    assert message == "J2 is at its limit of 0°. Jog the other way."


def test_typed_angles_are_sent_by_the_send_button_only(ready):
    ready.type_into("target_field_1", "12")
    ready.type_into("target_field_2", "30.5")
    ready.run(0.2)
    assert ready.heard() == []
    ready.click("send_button")
    ready.step()
    assert ready.heard() == [
        Frame(0x155, bytes.fromhex("00002EE0 00007724")),  # 12000, 30500
        Frame(0x156, bytes.fromhex("00000000 00000000")),
        Frame(0x157, bytes.fromhex("00000000 00000000")),
        Frame(0x151, bytes.fromhex("01 01 1E 00 00 00 00 00")),
    ]
    ready.run_until(lambda: angles(ready) == [12, 30.5, 0, 0, 0, 0])
    ready.run(0.1)
    assert ready.read("measured_2") == "30.500°"
    assert "12" in ready.read("notice_label")


def test_angles_out_of_limits_are_kept_marked_and_refused(ready):
    ready.type_into("target_field_5", "70.5")
    assert ready.find("target_field_5").text() == "70.500"
    ready.click("send_button")
    ready.run(0.1)
    assert ready.heard() == []
    message = ready.read("motion_message")
    assert "70.5" in message
    assert "70°" in message


def test_load_fills_the_fields_with_what_was_measured(ready):
    ready.click("jog_plus_2")
    ready.run_until(lambda: angles(ready)[1] == 1)
    ready.run(0.1)
    ready.type_into("target_field_1", "55")
    ready.click("load_button")
    fields = [ready.find(f"target_field_{joint}").text() for joint in range(1, 7)]
    assert fields == ["0.000", "1.000", "0.000", "0.000", "0.000", "0.000"]


def test_home_sends_all_zeros(ready):
    ready.type_into("target_field_1", "20")
    ready.click("send_button")
    ready.run_until(lambda: angles(ready)[0] == 20)
    ready.click("home_button")
    ready.run_until(lambda: angles(ready) == [0] * 6)


def test_the_speed_slider_reaches_the_arm(ready):
    ready.find("speed_field").setFocus()
    ready.find("speed_field").selectAll()
    QTest.keyClicks(ready.find("speed_field"), "75")
    QTest.keyClick(ready.find("speed_field"), Qt.Key.Key_Return)
    ready.run_until(lambda: ready.firmware.condition.speed_percent == 75)
    assert ready.find("speed_slider").value() == 75
    ready.click("jog_plus_1")
    ready.step()
    assert ready.heard()[-1] == Frame(0x151, bytes.fromhex("01 01 4B 00 00 00 00 00"))


# Stopping ----------------------------------------------------------------------------------------


def test_stop_recover_enable_and_go_on(any_driver):
    app_driver = any_driver
    app_driver.connect_by_hand()
    app_driver.enable_by_hand()
    app_driver.type_into("target_field_1", "90")
    app_driver.click("send_button")
    app_driver.run(0.5)
    app_driver.heard()

    app_driver.press(app_driver.find("stop_button"))
    assert app_driver.heard() == [STOP]  # on the press, before the button is let go
    QTest.mouseRelease(app_driver.find("stop_button"), Qt.MouseButton.LeftButton)
    app_driver.run_until(lambda: app_driver.controller.operating_state.stop is StopState.STOPPED)
    assert "Emergency stop" in app_driver.read("status_arm")
    assert "stop" in app_driver.read("recovery_text").lower()
    assert not app_driver.find("send_button").isEnabled()
    app_driver.click("stop_button")  # the red place stops again
    app_driver.run(0.3)
    heard = app_driver.heard()
    assert STOP in heard
    assert RESUME not in heard
    app_driver.hold_button("recovery_hold_button")
    app_driver.run_until(lambda: app_driver.controller.operating_state.stop is StopState.RUNNING)
    assert RESUME in app_driver.heard()
    app_driver.run_until(lambda: app_driver.controller.operating_state.enabled == (False,) * 6)

    app_driver.enable_by_hand()
    app_driver.click("home_button")
    app_driver.run_until(lambda: angles(app_driver) == [0] * 6)


def test_a_hasty_second_press_stops_again_and_never_resumes(ready):
    ready.press(ready.find("stop_button"))
    ready.run_until(lambda: ready.controller.operating_state.stop is StopState.STOPPED)
    ready.heard()
    ready.press(ready.find("stop_button"))
    assert ready.heard() == [STOP]


@pytest.mark.parametrize("key", [Qt.Key.Key_F12, Qt.Key.Key_Pause])
def test_a_key_stops_from_a_field_being_typed_in(ready, key):
    ready.find("target_field_1").setFocus()
    QTest.keyClick(ready.find("target_field_1"), key)
    assert STOP in ready.heard()


@pytest.mark.parametrize("opener", ["communication_button", "settings_button"])
def test_the_stop_works_from_every_dialog_and_beside_it(ready, opener):
    ready.click(opener)
    dialog = next(
        widget
        for widget in QApplication.topLevelWidgets()
        if widget is not ready.window and widget.isVisible()
    )
    ready.press(dialog.findChild(StopButton))
    assert STOP in ready.heard()
    assert not dialog.isModal()
    ready.press(ready.find("stop_button"))
    assert STOP in ready.heard()
    QTest.keyClick(dialog, Qt.Key.Key_F12)
    assert STOP in ready.heard()


def test_the_stop_key_works_while_a_foreign_modal_dialog_is_open(ready):
    box = QMessageBox(ready.window)
    box.setModal(True)
    box.show()
    assert QApplication.activeModalWidget() is box
    QTest.keyClick(box, Qt.Key.Key_F12)
    assert STOP in ready.heard()
    ready.run_until(lambda: ready.controller.operating_state.stop is StopState.STOPPED)
    box.close()


# The window --------------------------------------------------------------------------------------


@pytest.mark.styled
def test_the_language_and_the_theme_change_while_the_arm_moves(ready):
    ready.type_into("target_field_1", "90")
    ready.click("send_button")
    ready.run(0.3)
    ready.store.change(language="zh", theme="dark")
    ready.step()
    assert ready.find("send_button").text() == "发送"
    assert "正常" in ready.read("status_arm")
    assert ready.window.palette().window().color().lightness() < 128
    ready.store.change(language="en", theme="light")
    ready.step()
    assert ready.find("send_button").text() == "Send"
    ready.run_until(lambda: angles(ready)[0] == 90)


def test_closing_while_the_arm_moves_asks_first(ready):
    ready.type_into("target_field_1", "90")
    ready.click("send_button")
    ready.run_until(lambda: ready.controller.operating_state.moving)
    ready.window.close()
    assert ready.window.isVisible()
    ready.confirm()
    ready.run_until(lambda: not ready.window.isVisible())


def test_targets_refused_by_a_check_that_takes_long_stay_and_the_panel_says_why(ready, monkeypatch):
    monkeypatch.setattr("armui.control.safety.gate._AT_ONCE", 0.0)
    ready.store.change(jog_floor_mm=-500)  # how low it goes is not asked
    done: Future[object] = Future()
    checks = []

    def begin(check):
        checks.append(check)
        return done

    ready.controller.gate._background = begin
    for joint, target in ((2, "45"), (5, "30")):
        ready.type_into(f"target_field_{joint}", target)
    ready.click("send_button")
    assert ready.read("motion_message") == ""
    done.set_result(checks[0]())
    ready.run_until(lambda: "refused" in ready.codes())
    assert "would hit itself" in ready.read("motion_message")
    assert ready.find("target_field_2").text() == "45.000"
    assert ready.find("target_field_5").text() == "30.000"
    assert ready.find("target_field_1").text() == "0.000"
    ready.type_into("target_field_5", "0")
    assert ready.read("motion_message") == ""


def test_a_refusal_outside_the_limits_goes_once_the_arm_is_inside(ready):
    outside_limits(ready)
    ready.click("jog_plus_2")
    assert "Outside the limits" in ready.read("motion_message")
    ready.hold_button("recovery_hold_button")
    ready.run_until(lambda: ready.controller.operating_state.outside == "")
    assert ready.read("motion_message") == ""
