"""Leaving, closing and disconnecting with changes that are not saved: save, discard or stay."""

import errno

import can
import pytest

from armui.control.link.link_state import LinkState
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.shell.leaving import UnsavedQuestion
from tests.generations import ONE_IS_ENOUGH
from tests.moments import now
from tests.operator.settings.panels import note, questions, sent, settled


@pytest.fixture
def slower(end):
    """配速设置 with one value entered and not saved."""
    end.click("end_limits_edit_button")
    end.type_into("max_linear_speed_m_s", "0.5")
    return end


def asked(app_driver):
    return app_driver.dialog(UnsavedQuestion)


def save(app_driver):
    """Answer the question with 【保存】."""
    app_driver.click(asked(app_driver).save_button)


@ONE_IS_ENOUGH
def test_leaving_with_unsaved_changes_asks(end):
    end.click("end_limits_edit_button")
    end.type_into("max_linear_speed_m_s", "0.5")
    end.click("menu_motion")
    question = end.dialog(ConfirmDialog)
    assert "has not been saved" in question.text()
    assert end.find("max_linear_speed_m_s").isVisible()
    assert end.find("menu_end_limits").isChecked()
    question.reject()
    assert end.read("max_linear_speed_m_s") == "0.500"
    end.click("menu_motion")
    end.confirm()
    assert end.find("send_button").isVisible()
    assert end.find("menu_motion").isChecked()
    end.click("menu_end_limits")
    settled(end)
    assert end.read("max_linear_speed_m_s") == "1.000"
    assert sent(end)[0].arbitration_id == 0x477


@ONE_IS_ENOUGH
def test_leaving_without_changes_does_not_ask(end):
    end.click("end_limits_edit_button")
    end.click("menu_motion")
    assert questions() == []
    assert end.find("send_button").isVisible()


@ONE_IS_ENOUGH
def test_closing_the_window_with_unsaved_changes_asks(end):
    end.click("end_limits_edit_button")
    end.type_into("max_linear_speed_m_s", "0.5")
    assert not end.window.close()
    assert end.window.isVisible()
    end.confirm()
    assert not end.window.isVisible()


@ONE_IS_ENOUGH
def test_disconnecting_with_unsaved_changes_asks(end):
    end.click("end_limits_edit_button")
    end.type_into("max_linear_speed_m_s", "0.5")
    end.click("communication_button")
    dialog = end.dialog(ConnectDialog)
    end.click(dialog.disconnect_button)
    end.dialog(ConfirmDialog).reject()
    assert now(end.controller.operating_state.link) is LinkState.ONLINE
    end.click(dialog.disconnect_button)
    end.confirm()
    assert now(end.controller.operating_state.link) is LinkState.NO_DEVICE
    assert end.read("max_linear_speed_m_s") == ""
    assert note(end, "max_linear_speed_m_s") == "not read"


# Saving first -------------------------------------------------------------------------------------


def test_the_panel_is_left_once_the_arm_holds_what_was_entered(slower):
    slower.click("menu_motion")
    save(slower)
    assert questions() == []
    assert note(slower, "max_linear_speed_m_s") == "saving…"
    assert slower.find("menu_end_limits").isChecked()
    settled(slower)
    slower.wait(slower.find("send_button").isVisible)
    assert slower.find("menu_motion").isChecked()
    assert slower.firmware.settings.end_limits[0] == 0.5
    # set, and asked for what it holds now
    assert [each.arbitration_id for each in sent(slower)] == [0x479, 0x477]
    slower.click("menu_end_limits")
    settled(slower)
    assert slower.read("max_linear_speed_m_s") == "0.500"
    assert slower.find("end_limits_edit_button").isVisible()


def test_a_value_the_arm_does_not_take_keeps_the_panel_with_the_reason(joints):
    joints.click("joint_settings_edit_button")
    joints.type_into("max_speed_deg_s_3", "300")
    joints.type_into("max_angle_deg_1", "140")
    joints.click("menu_motion")
    save(joints)
    joints.wait(lambda: any(each.isVisible() for each in joints.window.findChildren(ConfirmDialog)))
    joints.confirm()  # beyond the factory's value: leaving asks, too
    settled(joints)
    joints.run(0.2)
    assert joints.find("menu_joint_settings").isChecked()
    assert "the arm holds 17" in joints.read("joint_settings_message")
    assert note(joints, "max_angle_deg_1") == "saved"
    # the wish to leave is over: what is saved by hand later does not leave
    joints.type_into("max_speed_deg_s_3", "90")
    joints.click("joint_settings_save_button")
    settled(joints)
    joints.run(0.2)
    assert note(joints, "max_speed_deg_s_3") == "saved"
    assert joints.find("menu_joint_settings").isChecked()


@ONE_IS_ENOUGH
def test_an_arm_that_does_not_answer_keeps_the_panel(slower):
    slower.ear.deaf_to = {0x479}
    slower.click("menu_motion")
    save(slower)
    settled(slower)
    slower.run(0.2)
    assert slower.find("menu_end_limits").isChecked()
    assert "did not answer (0x476)" in slower.read("end_limits_message")
    assert slower.read("max_linear_speed_m_s") == "0.500"


@ONE_IS_ENOUGH
def test_a_link_lost_while_saving_keeps_the_panel(slower):
    slower.ear.deaf_to = {0x479}
    slower.click("menu_motion")
    save(slower)
    slower.step()
    slower.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    slower.wait(lambda: slower.controller.operating_state.link is LinkState.LOST)
    assert slower.find("menu_end_limits").isChecked()
    assert note(slower, "max_linear_speed_m_s") == "not saved"
    assert "device is gone" in slower.read("end_limits_message")


@ONE_IS_ENOUGH
def test_what_cannot_be_saved_is_said_at_the_button(joints):
    joints.click("joint_settings_edit_button")
    joints.type_into("max_angle_deg_1", "400")
    joints.click("menu_motion")
    button = asked(joints).save_button
    assert not button.isEnabled()
    assert "J1 Max. angle: 400.0° is out of range" in button.toolTip()
    asked(joints).reject()
    joints.type_into("max_angle_deg_1", "140")
    joints.click("menu_motion")
    assert asked(joints).save_button.isEnabled()
    joints.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    joints.wait(lambda: joints.controller.operating_state.link is LinkState.LOST)
    assert "device is gone" in asked(joints).save_button.toolTip()
    assert not asked(joints).save_button.isEnabled()


@ONE_IS_ENOUGH
def test_switching_the_detection_off_is_asked_about_here_too(collision):
    collision.click("collision_edit_button")
    collision.click("collision_level_2_level_0")
    collision.click("menu_motion")
    save(collision)
    assert "Keep everyone out of its reach" in collision.dialog(ConfirmDialog).text()
    collision.dialog(ConfirmDialog).reject()
    collision.run(0.2)
    assert sent(collision) == []
    assert collision.find("menu_collision").isChecked()
    collision.click("menu_motion")
    save(collision)
    collision.confirm()
    settled(collision)
    collision.wait(collision.find("send_button").isVisible)
    assert collision.firmware.settings.collision_levels == (1, 0, 1, 1, 1, 1)


@ONE_IS_ENOUGH
def test_the_window_closes_once_it_is_saved(slower):
    assert not slower.window.close()
    save(slower)
    assert slower.window.isVisible()
    settled(slower)
    slower.wait(lambda: not slower.window.isVisible())
    assert slower.firmware.settings.end_limits[0] == 0.5


@ONE_IS_ENOUGH
def test_the_arm_is_disconnected_once_it_is_saved(slower):
    slower.click("communication_button")
    slower.click(slower.dialog(ConnectDialog).disconnect_button)
    save(slower)
    assert now(slower.controller.operating_state.link) is LinkState.ONLINE
    settled(slower)
    slower.wait(lambda: slower.controller.operating_state.link is LinkState.NO_DEVICE)
    assert slower.firmware.settings.end_limits[0] == 0.5


@ONE_IS_ENOUGH
def test_it_stays_connected_if_it_is_not_saved_and_shows_why(slower):
    slower.ear.deaf_to = {0x479}
    slower.click("communication_button")
    slower.click(slower.dialog(ConnectDialog).disconnect_button)
    save(slower)
    settled(slower)
    slower.wait(slower.window.isActiveWindow)
    assert slower.controller.operating_state.link is LinkState.ONLINE
    assert "did not answer (0x476)" in slower.read("end_limits_message")


@ONE_IS_ENOUGH
def test_a_question_that_has_become_idle_is_withdrawn(slower):
    slower.click("menu_motion")
    slower.click("end_limits_cancel_button")
    assert questions() == []
    assert slower.find("menu_end_limits").isChecked()
