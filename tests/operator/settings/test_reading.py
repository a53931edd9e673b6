"""What the arm holds is read, and what could not be read says so."""

from armui.protocol.generation import Generation
from tests.faulty_arm import HardOfHearing
from tests.generations import ONE_IS_ENOUGH
from tests.operator.settings.panels import generation, lit, note, notes, settled


def test_what_the_arm_holds_is_read_when_the_panel_opens(any_driver):
    any_driver.connect()
    any_driver.firmware.settings.accelerations_deg_s2[3] = 60.0
    any_driver.ear = HardOfHearing(any_driver.firmware)
    any_driver.click("menu_joint_settings")
    assert notes(any_driver) == {"reading…"}
    assert not any_driver.find("joint_settings_save_button").isEnabled()
    settled(any_driver)
    assert notes(any_driver) == {""}
    assert any_driver.read("max_angle_deg_2") == "180.0"
    assert any_driver.read("min_angle_deg_3") == "-170.0"
    # 60 °/s² are 1.05 rad/s² or 10 rpm/s on the bus
    second = generation(any_driver) is Generation.TWO
    assert any_driver.read("max_acceleration_deg_s2_4") == ("60.2" if second else "60.0")
    # 3 rad/s are 28.65 rpm: generation 1 rounds to 29
    assert any_driver.read("max_speed_deg_s_1") == ("171.9" if second else "174.0")
    asked = [each for each in any_driver.ear.heard if each.arbitration_id == 0x472]
    assert len(asked) == 12


@ONE_IS_ENOUGH
def test_nothing_can_be_typed_before_edit_is_pressed(joints):
    joints.type_into("max_angle_deg_2", "170")
    assert joints.read("max_angle_deg_2") == "180.0"
    assert not joints.find("joint_settings_cancel_button").isVisible()


@ONE_IS_ENOUGH
def test_without_an_arm_there_are_no_figures_and_a_reason(any_driver):
    any_driver.click("menu_joint_settings")
    assert any_driver.read("max_angle_deg_1") == ""
    assert notes(any_driver) == {"not read"}
    assert "No arm is connected" in any_driver.find("joint_settings_edit_button").toolTip()
    assert not any_driver.find("joint_settings_edit_button").isEnabled()
    any_driver.connect()
    settled(any_driver)
    assert any_driver.read("max_angle_deg_1") == "150.0"  # read by itself, now that it is there
    assert any_driver.read("joint_settings_message") == ""


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
    assert lit(joints) == ["recovery_button"]  # which enables
    joints.firmware.corrupt_limits(2)
    joints.click("joint_settings_read_button")
    settled(joints)
    assert lit(joints) == ["joint_settings_edit_button"]  # mending them comes before
    assert note(joints, "max_angle_deg_2") == "corrupt"
    assert note(joints, "max_angle_deg_3") == ""
    assert "0xFFFF" in joints.read("joint_settings_message")
    assert "0xFFFF" in joints.find("max_angle_deg_2").toolTip()
    joints.click("joint_settings_edit_button")
    joints.type_into("max_angle_deg_2", "170")
    joints.type_into("min_angle_deg_2", "1")
    joints.type_into("max_speed_deg_s_2", "90")
    assert lit(joints) == ["joint_settings_save_button"]
    joints.click("joint_settings_save_button")
    joints.confirm()  # the joint stands at 0°, beyond the new min. angle
    settled(joints)
    assert (joints.firmware.settings.limits[1].max_deg, note(joints, "max_angle_deg_2")) == (
        170.0,
        "saved",
    )
