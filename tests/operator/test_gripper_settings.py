"""An operator at 夹爪设置: bytes at the arm, what it then holds, words."""

import pytest

from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.faulty_arm import HardOfHearing

NAMES = ("teaching_range_percent", "stroke_limit_mm", "teaching_friction")


def settled(app_driver):
    app_driver.run_until(lambda: not app_driver.controller.settings.busy)


def at(app_driver):
    app_driver.connect()
    app_driver.ear = HardOfHearing(app_driver.firmware)
    app_driver.click("menu_gripper_settings")
    settled(app_driver)
    return app_driver


def sent(app_driver):
    return [frame for frame in app_driver.ear.heard if frame.arbitration_id == 0x47D]


def save(app_driver, name, text):
    app_driver.click("gripper_settings_edit_button")
    app_driver.type_into(name, text)
    app_driver.click("gripper_settings_save_button")
    settled(app_driver)


def test_what_the_arm_keeps_is_read_and_changed(app_driver):
    at(app_driver)
    held = app_driver.firmware.settings.teaching
    assert [float(app_driver.find(name).text().split()[0]) for name in NAMES] == list(held)
    save(app_driver, "stroke_limit_mm", "100")
    # range and friction go along as they were read; 100 mm = 64
    payload = bytes((int(held.range_percent), 100, int(held.friction))) + bytes(5)
    assert sent(app_driver) == [Frame(0x47D, payload)]
    assert app_driver.firmware.settings.teaching.stroke_limit_mm == 100
    assert (
        app_driver.read("gripper_settings_message") == "Saved; reading back gave the same values."
    )


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("stroke_limit_mm", "50", "Choose one of 0, 70, 100"),
        ("teaching_range_percent", "201", "from 100 % to 200 %"),
        ("teaching_friction", "0", "from 1 to 10"),
    ],
)
def test_what_cannot_be_is_said_and_not_sent(app_driver, name, text, said):
    at(app_driver)
    app_driver.click("gripper_settings_edit_button")
    app_driver.type_into(name, text)
    assert not app_driver.find("gripper_settings_save_button").isEnabled()
    assert said in app_driver.read("gripper_settings_message")
    assert sent(app_driver) == []


def test_an_arm_that_does_not_take_it(app_driver):
    at(app_driver)
    app_driver.ear.deaf_to = {0x47D}
    save(app_driver, "teaching_friction", "9")
    assert app_driver.firmware.settings.teaching.friction != 9
    assert "did not answer" in app_driver.read("gripper_settings_message")


@pytest.mark.parametrize("generation", [Generation.ONE])
def test_generation_1_has_none_and_is_not_asked(any_driver):
    app_driver = at(any_driver)
    assert "generation 1" in app_driver.read("gripper_settings_message")
    assert not app_driver.find("gripper_settings_edit_button").isEnabled()
    assert [frame for frame in app_driver.ear.heard if frame.arbitration_id == 0x477] == []
