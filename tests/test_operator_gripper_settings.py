"""An operator at 夹爪设置: bytes at the arm, what it then holds, words."""

import pytest

from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.faulty_arm import HardOfHearing

NAMES = ("teaching_range_percent", "stroke_limit_mm", "teaching_friction")


def settled(desk):
    desk.run_until(lambda: not desk.controller.settings.busy)


def at(desk):
    desk.connect_by_hand()
    desk.ear = HardOfHearing(desk.firmware)
    desk.click("menu_gripper_settings")
    settled(desk)
    return desk


def sent(desk):
    return [frame for frame in desk.ear.heard if frame.arbitration_id == 0x47D]


def save(desk, name, text):
    desk.click("gripper_settings_edit_button")
    desk.type_into(name, text)
    desk.click("gripper_settings_save_button")
    settled(desk)


def test_what_the_arm_keeps_is_read_and_changed(desk):
    at(desk)
    held = desk.firmware.settings.teaching
    assert [float(desk.find(name).text().split()[0]) for name in NAMES] == list(held)
    save(desk, "stroke_limit_mm", "100")
    # range and friction go along as they were read; 100 mm = 64
    payload = bytes((int(held.range_percent), 100, int(held.friction))) + bytes(5)
    assert sent(desk) == [Frame(0x47D, payload)]
    assert desk.firmware.settings.teaching.stroke_limit_mm == 100
    assert desk.read("gripper_settings_message") == "Saved: read back from the arm, and the same."


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("stroke_limit_mm", "50", "Choose one of 0, 70, 100"),
        ("teaching_range_percent", "201", "from 100 % to 200 %"),
        ("teaching_friction", "0", "from 1 to 10"),
    ],
)
def test_what_cannot_be_is_said_and_not_sent(desk, name, text, said):
    at(desk)
    desk.click("gripper_settings_edit_button")
    desk.type_into(name, text)
    assert not desk.find("gripper_settings_save_button").isEnabled()
    assert said in desk.read("gripper_settings_message")
    assert sent(desk) == []


def test_an_arm_that_does_not_take_it(desk):
    at(desk)
    desk.ear.deaf_to = {0x47D}
    save(desk, "teaching_friction", "9")
    assert desk.firmware.settings.teaching.friction != 9
    assert "did not answer" in desk.read("gripper_settings_message")


@pytest.mark.parametrize("generation", [Generation.ONE])
def test_generation_1_has_none_and_is_not_asked(any_desk):
    desk = at(any_desk)
    assert "generation 1" in desk.read("gripper_settings_message")
    assert not desk.find("gripper_settings_edit_button").isEnabled()
    assert [frame for frame in desk.ear.heard if frame.arbitration_id == 0x477] == []
