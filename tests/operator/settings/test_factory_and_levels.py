"""初始化 and 碰撞等级."""

from armui.protocol.generation import Generation
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from tests.operator.settings.panels import frame, generation, note, sent, settled

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
    assert "J2 will not stop after hitting" in collision.read("collision_message")
    collision.click("collision_save_button")
    assert "Keep everyone out of its reach" in collision.dialog(ConfirmDialog).text()
    collision.run(0.1)
    assert sent(collision) == []
    collision.confirm()
    settled(collision)
    assert collision.firmware.settings.collision_levels == (1, 0, 1, 1, 1, 1)
    assert "will not stop" in collision.read("collision_message")
