"""Only what was changed is sent, and only what was read back is called saved."""

import errno

import can
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.control.link.link_state import LinkState
from armui.protocol.generation import Generation
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.widgets.hold_button import HoldButton
from tests.generations import ONE_IS_ENOUGH
from tests.operator.settings.panels import frame, generation, note, sent, settled


def test_only_what_was_changed_is_sent_and_read_back(joints):
    joints.click("joint_settings_edit_button")
    joints.type_into("max_angle_deg_2", "170")
    assert note(joints, "max_angle_deg_2") == "was 180.0"
    joints.run(0.1)
    assert sent(joints) == []
    joints.click("joint_settings_save_button")
    assert note(joints, "max_angle_deg_2") == "saving…"
    assert not joints.find("joint_settings_save_button").isEnabled()
    settled(joints)
    # joint 2, 1700 = 06A4 in 0.1°; 7FFF: leave it. Generation 1: 0°, and 29 = 001D rpm as read
    rest = "7FFF 7FFF" if generation(joints) is Generation.TWO else "0000 001D"
    assert sent(joints) == [frame(0x474, f"02 06A4 {rest} 00")]
    assert joints.firmware.settings.limits[1].max_deg == 170.0
    assert joints.read("max_angle_deg_2") == "170.0"
    assert note(joints, "max_angle_deg_2") == "saved"
    assert "gave the same values" in joints.read("joint_settings_message")
    assert joints.find("joint_settings_edit_button").isVisible()


def test_a_value_between_two_steps_is_saved_as_the_nearest_and_that_is_said(joints):
    joints.click("joint_settings_edit_button")
    joints.type_into("max_speed_deg_s_1", "100")
    joints.click("joint_settings_save_button")
    settled(joints)
    # 1.745 rad/s is 1.75 on the bus, 100.3 °/s; 16.67 rpm is 17, 102 °/s
    nearest = "100.3" if generation(joints) is Generation.TWO else "102.0"
    assert joints.read("max_speed_deg_s_1") == nearest
    assert f"J1 Max. speed {nearest}°/s" in joints.read("joint_settings_message")
    assert "unchanged" not in joints.read("notice_label")


def test_a_value_the_arm_answers_and_does_not_take(joints):
    joints.click("joint_settings_edit_button")
    joints.type_into("max_speed_deg_s_3", "300")
    joints.type_into("max_angle_deg_1", "140")
    joints.click("joint_settings_save_button")
    joints.confirm()
    settled(joints)
    assert note(joints, "max_angle_deg_1") == "saved"
    assert note(joints, "max_speed_deg_s_3") == "not saved"
    assert joints.read("max_speed_deg_s_3") == "300.0"  # kept, to be tried again or given up
    said = joints.read("joint_settings_message")
    assert "J3 Max. speed: 300.0°/s was sent and answered, but the arm holds 17" in said
    assert "the arm holds 17" in joints.find("max_speed_deg_s_3").toolTip()
    joints.type_into("max_speed_deg_s_3", "90")
    assert note(joints, "max_speed_deg_s_3").startswith("was 17")
    joints.ear.heard.clear()
    joints.click("joint_settings_save_button")
    settled(joints)
    assert len(sent(joints)) == 1  # joint 1 is in the arm already
    assert note(joints, "max_speed_deg_s_3") == "saved"


def asked(joints):
    """The question before what was entered is saved, which waits for a held button."""
    dialog = joints.dialog(ConfirmDialog)
    assert isinstance(dialog.action_button, HoldButton)
    return dialog


def test_limits_that_leave_the_arm_outside_are_asked_about(joints):
    joints.click("joint_settings_edit_button")
    joints.type_into("min_angle_deg_2", "60")
    joints.click("joint_settings_save_button")
    stands = round(joints.controller.state.angles_deg()[1], 3)
    assert f"J2 stands at {stands:.3f}°, beyond the limits entered" in asked(joints).text()
    assert sent(joints) == []
    joints.confirm()
    settled(joints)
    assert note(joints, "min_angle_deg_2") == "saved"
    joints.click("joint_settings_edit_button")
    joints.type_into("min_angle_deg_2", "0")
    joints.click("joint_settings_save_button")
    settled(joints)  # the arm is within these, so nothing is asked
    assert note(joints, "min_angle_deg_2") == "saved"


@pytest.mark.each_value(full="each setting in both generations")
@pytest.mark.parametrize(
    ("field", "value", "note_", "said"),
    [
        ("max_angle_deg_1", "200", "factory 150.0", "J1 Max. angle: 200.0° goes beyond"),
        ("min_angle_deg_2", "-20", "factory 0.0", "J2 Min. angle: -20.0° goes beyond"),
        ("max_speed_deg_s_1", "190", "factory 171.9", "J1 Max. speed: 190.0°/s goes beyond"),
        (
            "max_acceleration_deg_s2_6",
            "400",
            "factory 286.5",
            "J6 Max. acceleration: 400.0°/s² goes beyond",
        ),
    ],
)
def test_beyond_the_factory_is_amber_and_saved_by_a_held_press_only(
    joints, field, value, note_, said
):
    joints.click("joint_settings_edit_button")
    joints.type_into(field, value)
    assert note(joints, field) == note_
    assert joints.find(field).property("attention")
    assert said in joints.read("joint_settings_message")
    assert said in joints.find(field).toolTip()
    joints.click("joint_settings_save_button")
    assert said in asked(joints).text()
    assert "mechanical stops" in asked(joints).text()
    joints.click(asked(joints).action_button)  # a click is not enough
    joints.run(0.3)
    assert sent(joints) == []
    asked(joints).reject()
    joints.run(0.3)
    assert sent(joints) == []
    joints.click("joint_settings_save_button")
    joints.confirm()
    settled(joints)
    assert len(sent(joints)) == 1


def test_what_is_within_the_factory_s_values_is_saved_at_once(joints):
    joints.click("joint_settings_edit_button")
    joints.type_into("max_angle_deg_1", "120")
    joints.type_into("max_speed_deg_s_1", "90")
    joints.click("joint_settings_save_button")
    settled(joints)
    assert note(joints, "max_angle_deg_1") == "saved"


def test_an_arm_that_is_beyond_already_is_shown_so(joints):
    limits = list(joints.firmware.settings.limits)
    limits[5] = limits[5]._replace(max_deg=180.0)
    joints.firmware.settings.limits = limits
    joints.click("joint_settings_read_button")
    settled(joints)
    assert note(joints, "max_angle_deg_6") == "factory 120.0"
    assert "180.0° goes beyond the factory's 120.0°" in joints.find("max_angle_deg_6").toolTip()
    assert joints.read("joint_settings_message") == ""  # nothing has to be done


def test_an_arm_that_neither_answers_nor_takes_it(end):
    end.ear.deaf_to = {0x479}
    end.click("end_limits_edit_button")
    end.type_into("max_linear_speed_m_s", "0.5")
    end.click("end_limits_save_button")
    settled(end)
    assert note(end, "max_linear_speed_m_s") == "not saved"
    assert "did not answer (0x476)" in end.read("end_limits_message")
    assert end.firmware.settings.end_limits[0] == 1.0
    end.click("end_limits_cancel_button")
    assert end.read("max_linear_speed_m_s") == "1.000"
    assert note(end, "max_linear_speed_m_s") == ""
    assert end.read("end_limits_message") == ""


@ONE_IS_ENOUGH
def test_a_link_lost_half_way(joints):
    joints.ear.deaf_to = {0x474, 0x472}
    joints.click("joint_settings_edit_button")
    joints.type_into("max_angle_deg_2", "170")
    joints.type_into("max_angle_deg_1", "140")
    joints.click("joint_settings_save_button")
    joints.step()
    joints.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    joints.wait(lambda: joints.controller.operating_state.link is LinkState.LOST)
    assert note(joints, "max_angle_deg_2") == note(joints, "max_angle_deg_1") == "not saved"
    assert "device is gone" in joints.read("joint_settings_message")
    assert not joints.find("joint_settings_save_button").isEnabled()
    joints.ear.deaf_to = set()
    joints.plug_in()
    joints.wait(lambda: joints.controller.operating_state.link is not LinkState.LOST)
    joints.run_until(lambda: joints.find("joint_settings_save_button").isEnabled())
    assert joints.read("max_angle_deg_2") == "170.0"
    joints.run_until(lambda: joints.codes().count("limits_read") == 2)
    joints.click("joint_settings_save_button")
    settled(joints)
    assert joints.firmware.settings.limits[1].max_deg == 170.0
    assert joints.firmware.settings.limits[0].max_deg == 140.0


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("max_angle_deg_1", "400", "J1 Max. angle: 400.0° is out of range. Enter a value from"),
        ("min_angle_deg_2", "abc", "J2 Min. angle: “abc” is not a number"),
        ("max_speed_deg_s_3", "", "J3 Max. speed: “—” is not a number"),
        ("max_acceleration_deg_s2_4", "0", "J4 Max. acceleration: 0.0°/s² is out of range"),
        ("max_angle_deg_5", "-80", "Joint 5: the min. angle -70° must be below the max."),
    ],
)
@ONE_IS_ENOUGH
def test_what_cannot_be_is_said_at_the_cell_and_not_sent(joints, name, text, said):
    joints.click("joint_settings_edit_button")
    joints.type_into(name, text or " ")
    assert note(joints, name) == "invalid"
    assert said in joints.read("joint_settings_message")
    assert said in joints.find(name).toolTip()
    assert joints.find(name).property("attention")
    assert not joints.find("joint_settings_save_button").isEnabled()
    assert said in joints.find("joint_settings_save_button").toolTip()
    joints.click("joint_settings_save_button")
    joints.run(0.1)
    assert sent(joints) == []


@ONE_IS_ENOUGH
def test_typing_what_is_there_already_changes_nothing(joints):
    joints.click("joint_settings_edit_button")
    joints.type_into("max_angle_deg_2", "170")
    joints.type_into("max_angle_deg_2", "180")
    assert note(joints, "max_angle_deg_2") == ""
    assert not joints.find("joint_settings_save_button").isEnabled()
    assert "Nothing has been changed" in joints.find("joint_settings_save_button").toolTip()


@ONE_IS_ENOUGH
def test_escape_gives_up_and_ctrl_enter_saves(end):
    end.window.activateWindow()
    end.wait(end.window.isActiveWindow)
    end.click("end_limits_edit_button")
    end.type_into("max_angular_speed_rad_s", "2")
    QTest.keyClick(end.find("max_angular_speed_rad_s"), Qt.Key.Key_Escape)
    assert end.read("max_angular_speed_rad_s") == "1.000"
    end.click("end_limits_edit_button")
    end.type_into("max_angular_speed_rad_s", "2")
    QTest.keySequence(end.find("max_angular_speed_rad_s"), "Ctrl+Return")
    end.wait(lambda: end.controller.settings.busy)
    settled(end)
    assert end.firmware.settings.end_limits[1] == 2.0


@ONE_IS_ENOUGH
def test_tab_goes_down_the_columns(joints):
    joints.window.activateWindow()
    joints.wait(joints.window.isActiveWindow)
    joints.click("joint_settings_edit_button")
    visited = []
    for _ in range(8):
        visited.append(joints.window.focusWidget().objectName())
        QTest.keyClick(joints.window.focusWidget(), Qt.Key.Key_Tab)
    assert visited == [*(f"max_angle_deg_{joint}" for joint in range(1, 7)), *visited[6:]]
    assert visited[6:] == ["min_angle_deg_1", "min_angle_deg_2"]
