"""An operator at 关节设置, 配速设置, 碰撞等级: bytes at the arm, what it then holds, words."""

import errno

import can
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from armui.control.situation import LinkState
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.ui.dialogs.confirm import ConfirmDialog
from armui.ui.dialogs.connect import ConnectDialog
from tests.faulty_arm import HardOfHearing

SETTINGS_IDS = {0x474, 0x475, 0x477, 0x479, 0x47A}


def frame(arbitration_id, payload):
    return Frame(arbitration_id, bytes.fromhex(payload))


def at(desk, panel):
    desk.connect_by_hand()
    desk.ear = HardOfHearing(desk.firmware)
    desk.click(f"menu_{panel}")
    settled(desk)
    desk.ear.heard.clear()
    return desk


@pytest.fixture
def joints(any_desk):
    """Connected, the panel 关节设置 open and read."""
    return at(any_desk, "joint_settings")


@pytest.fixture
def end(any_desk):
    return at(any_desk, "end_limits")


@pytest.fixture
def collision(any_desk):
    return at(any_desk, "collision")


def settled(desk):
    desk.run_until(lambda: not desk.controller.settings.busy)


def sent(desk):
    """What the arm heard but for questions."""
    return [each for each in desk.ear.heard if each.arbitration_id in SETTINGS_IDS]


def generation(desk):
    return desk.controller.situation.generation


def note(desk, name):
    return desk.read(f"{name}_note")


def questions():
    return [
        each
        for each in QApplication.topLevelWidgets()
        if isinstance(each, ConfirmDialog) and each.isVisible()
    ]


def notes(desk):
    """Every word below a value of 关节设置."""
    names = ("max_angle_deg", "min_angle_deg", "max_speed_deg_s", "max_acceleration_deg_s2")
    return {note(desk, f"{name}_{joint}") for name in names for joint in range(1, 7)}


# Reading ------------------------------------------------------------------------------------------


def test_what_the_arm_holds_is_read_when_the_panel_opens(any_desk):
    any_desk.connect_by_hand()
    any_desk.firmware.settings.accelerations_deg_s2[3] = 60.0
    any_desk.ear = HardOfHearing(any_desk.firmware)
    any_desk.click("menu_joint_settings")
    assert notes(any_desk) == {"reading…"}
    assert not any_desk.find("joint_settings_save_button").isEnabled()
    settled(any_desk)
    assert notes(any_desk) == {""}
    assert any_desk.read("max_angle_deg_2") == "180.0"
    assert any_desk.read("min_angle_deg_3") == "-170.0"
    # 60 °/s² are 1.05 rad/s² or 10 rpm/s on the bus
    second = generation(any_desk) is Generation.TWO
    assert any_desk.read("max_acceleration_deg_s2_4") == ("60.2" if second else "60.0")
    # 3 rad/s are 28.65 rpm: generation 1 rounds to 29
    assert any_desk.read("max_speed_deg_s_1") == ("171.9" if second else "174.0")
    asked = [each for each in any_desk.ear.heard if each.arbitration_id == 0x472]
    assert len(asked) == 12


def test_nothing_can_be_typed_before_edit_is_pressed(joints):
    joints.type_into("max_angle_deg_2", "170")
    assert joints.read("max_angle_deg_2") == "180.0"
    assert not joints.find("joint_settings_cancel_button").isVisible()


def test_without_an_arm_there_are_no_figures_and_a_reason(any_desk):
    any_desk.click("menu_joint_settings")
    assert any_desk.read("max_angle_deg_1") == ""
    assert notes(any_desk) == {"not read"}
    assert "No arm is connected" in any_desk.read("joint_settings_message")
    assert not any_desk.find("joint_settings_edit_button").isEnabled()
    any_desk.connect_by_hand()
    settled(any_desk)
    assert any_desk.read("max_angle_deg_1") == "150.0"  # read by itself, now that it is there
    assert any_desk.read("joint_settings_message") == ""


def test_an_arm_that_does_not_say_what_it_holds(end):
    end.ear.deaf_to = {0x477}
    end.click("end_limits_read_button")
    assert note(end, "max_linear_speed_m_s") == "reading…"
    settled(end)
    assert note(end, "max_linear_speed_m_s") == "not read"
    assert "what it holds is not known" in end.read("end_limits_message")
    end.ear.deaf_to = set()
    end.click("end_limits_read_button")
    settled(end)
    assert note(end, "max_linear_speed_m_s") == ""
    assert end.read("end_limits_message") == ""


def test_a_corrupt_memory_is_flagged_and_mended(joints):
    joints.firmware.corrupt_limits(2)
    joints.click("joint_settings_read_button")
    settled(joints)
    assert note(joints, "max_angle_deg_2") == "corrupt"
    assert note(joints, "max_angle_deg_3") == ""
    assert "0xFFFF" in joints.read("joint_settings_message")
    assert "0xFFFF" in joints.find("max_angle_deg_2").toolTip()
    joints.click("joint_settings_edit_button")
    joints.type_into("max_angle_deg_2", "170")
    joints.type_into("min_angle_deg_2", "1")
    joints.type_into("max_speed_deg_s_2", "90")
    joints.click("joint_settings_save_button")
    settled(joints)
    assert (joints.firmware.settings.limits[1].max_deg, note(joints, "max_angle_deg_2")) == (
        170.0,
        "saved",
    )


# Saving -------------------------------------------------------------------------------------------


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
    assert "read back from the arm, and the same" in joints.read("joint_settings_message")
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


def test_a_value_the_arm_answers_and_does_not_take(joints):
    joints.click("joint_settings_edit_button")
    joints.type_into("max_speed_deg_s_3", "300")
    joints.type_into("max_angle_deg_1", "140")
    joints.click("joint_settings_save_button")
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


def test_a_link_lost_half_way(joints):
    joints.ear.deaf_to = {0x474, 0x472}
    joints.click("joint_settings_edit_button")
    joints.type_into("max_angle_deg_2", "170")
    joints.type_into("max_angle_deg_1", "140")
    joints.click("joint_settings_save_button")
    joints.step()
    joints.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    joints.wait(lambda: joints.controller.situation.link is LinkState.LOST)
    assert note(joints, "max_angle_deg_2") == note(joints, "max_angle_deg_1") == "not saved"
    assert "device is gone" in joints.read("joint_settings_message")
    assert not joints.find("joint_settings_save_button").isEnabled()
    joints.ear.deaf_to = set()
    joints.plug_in()
    joints.wait(lambda: joints.controller.situation.link is not LinkState.LOST)
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
        ("max_angle_deg_5", "-80", "Joint 5: the min. angle -70.000° must be below the max."),
    ],
)
def test_what_cannot_be_is_said_at_the_cell_and_not_sent(joints, name, text, said):
    joints.click("joint_settings_edit_button")
    joints.type_into(name, text or " ")
    assert note(joints, name) == "not possible"
    assert said in joints.read("joint_settings_message")
    assert said in joints.find(name).toolTip()
    assert joints.find(name).property("attention")
    assert not joints.find("joint_settings_save_button").isEnabled()
    assert said in joints.find("joint_settings_save_button").toolTip()
    joints.click("joint_settings_save_button")
    joints.run(0.1)
    assert sent(joints) == []


def test_typing_what_is_there_already_changes_nothing(joints):
    joints.click("joint_settings_edit_button")
    joints.type_into("max_angle_deg_2", "170")
    joints.type_into("max_angle_deg_2", "180")
    assert note(joints, "max_angle_deg_2") == ""
    assert not joints.find("joint_settings_save_button").isEnabled()
    assert "Nothing has been changed" in joints.find("joint_settings_save_button").toolTip()


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


# 初始化 -------------------------------------------------------------------------------------------


def test_the_ends_factory_values_are_asked_about_and_read_back(end):
    end.click("end_limits_edit_button")
    end.type_into("max_linear_speed_m_s", "0.5")
    assert "Save or cancel" in end.find("end_limits_reset_button").toolTip()
    end.click("end_limits_save_button")
    settled(end)
    end.ear.heard.clear()
    end.click("end_limits_reset_button")
    assert "may run faster" in end.dialog(ConfirmDialog).text()
    end.run(0.1)
    assert sent(end) == []
    end.confirm()
    settled(end)
    # the reset, then the question
    assert sent(end) == [
        frame(0x477, "00 01 00 00 00 00 00 00"),
        frame(0x477, "01 00 00 00 00 00 00 00"),
    ]
    assert end.read("max_linear_speed_m_s") == "1.000"


def test_factory_limits_of_the_joints_are_there_in_generation_2_only(joints):
    joints.click("joint_settings_edit_button")
    joints.type_into("max_angle_deg_2", "170")
    joints.click("joint_settings_save_button")
    settled(joints)
    if generation(joints) is Generation.ONE:
        assert not joints.find("joint_settings_reset_button").isEnabled()
        assert "generation 1" in joints.find("joint_settings_reset_button").toolTip()
        return
    joints.click("joint_settings_reset_button")
    joints.confirm()
    settled(joints)
    assert frame(0x477, "00 02 00 00 00 00 00 00") in sent(joints)
    assert joints.firmware.settings.limits[1].max_deg == 180.0
    assert joints.read("max_angle_deg_2") == "180.0"


# 碰撞等级 -----------------------------------------------------------------------------------------


def test_a_level_is_chosen_by_a_click(collision):
    collision.click("collision_level_3_level_5")
    assert collision.find("collision_level_3_level_1").isChecked()  # locked
    collision.click("collision_edit_button")
    collision.click("collision_level_3_level_5")
    assert note(collision, "collision_level_3") == "was 1"
    collision.click("collision_save_button")
    settled(collision)
    assert frame(0x47A, "01 01 05 01 01 01 00 00") in sent(collision)
    assert collision.firmware.settings.collision_levels == (1, 1, 5, 1, 1, 1)
    assert note(collision, "collision_level_3") == "saved"


def test_one_click_sets_all(collision):
    collision.click("collision_edit_button")
    collision.click("collision_all_level_8")
    collision.click("collision_save_button")
    settled(collision)
    assert collision.firmware.settings.collision_levels == (8,) * 6


def test_switching_the_detection_off_is_called_a_danger_and_asked_about(collision):
    collision.click("collision_edit_button")
    collision.click("collision_level_2_level_0")
    assert "J2 will not stop when they hit" in collision.read("collision_message")
    collision.click("collision_save_button")
    assert "Keep everyone out of its reach" in collision.dialog(ConfirmDialog).text()
    collision.run(0.1)
    assert sent(collision) == []
    collision.confirm()
    settled(collision)
    assert collision.firmware.settings.collision_levels == (1, 0, 1, 1, 1, 1)
    assert "will not stop" in collision.read("collision_message")


# Leaving ------------------------------------------------------------------------------------------


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


def test_leaving_without_changes_does_not_ask(end):
    end.click("end_limits_edit_button")
    end.click("menu_motion")
    assert questions() == []
    assert end.find("send_button").isVisible()


def test_closing_the_window_with_unsaved_changes_asks(end):
    end.click("end_limits_edit_button")
    end.type_into("max_linear_speed_m_s", "0.5")
    assert not end.window.close()
    assert end.window.isVisible()
    end.confirm()
    assert not end.window.isVisible()


def test_disconnecting_with_unsaved_changes_asks(end):
    end.click("end_limits_edit_button")
    end.type_into("max_linear_speed_m_s", "0.5")
    end.click("communication_button")
    dialog = end.dialog(ConnectDialog)
    end.click(dialog.disconnect_button)
    end.dialog(ConfirmDialog).reject()
    assert end.controller.situation.link is LinkState.ONLINE
    end.click(dialog.disconnect_button)
    end.confirm()
    assert end.controller.situation.link is LinkState.NO_DEVICE
    assert end.read("max_linear_speed_m_s") == ""
    assert note(end, "max_linear_speed_m_s") == "not read"
