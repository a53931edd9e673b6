"""An operator looks for what to press: a button is lit while something is to be sent."""

import pytest

from tests.control.jogger import bend


def lit(app_driver, name):
    return bool(app_driver.find(name).property("primary"))


def test_a_colour_that_was_sent_is_not_asked_for_again(app_driver):
    app_driver.connect()
    app_driver.click("menu_light")
    assert lit(app_driver, "light_confirm_button")
    app_driver.click("light_confirm_button")
    assert not lit(app_driver, "light_confirm_button")
    app_driver.click("light_joint_4")
    assert lit(app_driver, "light_confirm_button")


def test_the_gripper_s_target_is_new_until_it_is_sent(app_driver):
    app_driver.connect()
    app_driver.click("menu_gripper")
    app_driver.run(0.3)
    app_driver.type_into("gripper_opening_field", "30")
    assert lit(app_driver, "gripper_send_button")
    app_driver.click("gripper_send_button")
    assert not lit(app_driver, "gripper_send_button")
    app_driver.type_into("gripper_opening_field", "20")
    assert lit(app_driver, "gripper_send_button")
    app_driver.type_into("gripper_opening_field", "2000")
    assert not lit(app_driver, "gripper_send_button")


def test_a_linkage_in_use_is_nothing_to_confirm(app_driver):
    app_driver.connect()
    app_driver.click("menu_linkage")
    assert not lit(app_driver, "linkage_confirm_button")
    app_driver.find("linkage_feedback_offset").setCurrentIndex(1)
    assert lit(app_driver, "linkage_confirm_button")


def test_a_load_is_confirmed_once(app_driver):
    app_driver.connect()
    app_driver.click("menu_end_load")
    assert not lit(app_driver, "load_confirm_button")
    app_driver.click("load_half")
    assert lit(app_driver, "load_confirm_button")
    app_driver.click("load_confirm_button")
    assert not lit(app_driver, "load_confirm_button")


def test_a_mounting_that_was_told_is_not_asked_for_again(app_driver):
    app_driver.connect()
    app_driver.click("menu_end_load")
    assert not lit(app_driver, "mounting_confirm_button")
    app_driver.click("mounting_upside_down")
    assert lit(app_driver, "mounting_confirm_button")
    app_driver.click("mounting_confirm_button")
    app_driver.hold()
    assert not lit(app_driver, "mounting_confirm_button")


@pytest.mark.parametrize("button", ["move_p_button", "move_l_button"])
def test_a_pose_on_its_way_is_not_asked_for_again(app_driver, button):
    bend(app_driver)
    app_driver.click("menu_cartesian")
    app_driver.run(0.1)
    app_driver.type_into("pose_field_X", "300")
    assert lit(app_driver, "move_p_button")
    app_driver.click(button)
    assert not lit(app_driver, "move_p_button")
    app_driver.run(0.2)
    assert app_driver.controller.operating_state.moving
    assert not lit(app_driver, "move_p_button")
    app_driver.type_into("pose_field_X", "310")
    assert lit(app_driver, "move_p_button")


def test_a_target_known_to_be_bad_is_not_recommended(app_driver):
    bend(app_driver)
    app_driver.click("menu_motion")
    app_driver.type_into("target_field_1", "25")
    assert lit(app_driver, "send_button")
    app_driver.type_into("target_field_1", "400")  # beyond its limits
    assert not lit(app_driver, "send_button")
    app_driver.type_into("target_field_1", "25")
    app_driver.controller.motion.set_speed_percent(0)
    app_driver.run(0.1)
    assert not lit(app_driver, "send_button")  # it cannot be pressed


def test_a_refused_target_is_not_recommended_until_another_is_entered(app_driver):
    bend(app_driver)
    app_driver.click("menu_motion")
    for joint, angle in ((2, "170"), (3, "0"), (5, "60")):  # into the floor
        app_driver.type_into(f"target_field_{joint}", angle)
    assert lit(app_driver, "send_button")
    app_driver.click("send_button")
    app_driver.run_until(lambda: "refused" in app_driver.codes())
    app_driver.wait(lambda: app_driver.find("target_field_2").text().startswith("170"))
    assert not lit(app_driver, "send_button")
    app_driver.type_into("target_field_2", "20")
    assert lit(app_driver, "send_button")
