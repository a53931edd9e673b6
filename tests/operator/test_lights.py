"""An operator at 灯光控制 of the main window: bytes at the arm, words on screen."""

import errno

import can
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from armui.protocol.frame import Frame
from tests.generations import ONE_IS_ENOUGH


def light(payload):
    return Frame(0x121, bytes.fromhex(payload))


@pytest.fixture
def lit(any_driver):
    """Connected, motors off, the light panel open."""
    any_driver.connect()
    any_driver.click("menu_light")
    any_driver.heard()
    return any_driver


def test_orange_for_joint_3(lit):
    lit.click("light_joint_3")
    for channel, text in (("red", "255"), ("green", "140"), ("blue", "0")):
        lit.type_into(f"{channel}_field", text)
    lit.run(0.1)
    assert lit.heard() == []  # typing sends nothing
    assert lit.read("effect_strip") == "#FF8C00"
    lit.click("light_confirm_button")
    lit.step()
    assert lit.heard() == [light("01 03 FF FF 8C 00 00 00")]
    assert lit.firmware.settings.lights[3][1:4] == (255, 140, 0)
    assert "all lamps of joint 3: #FF8C00" in lit.read("notice_label")
    lit.click("light_confirm_button")
    lit.step()
    assert lit.heard() == [light("01 03 FF FF 8C 00 00 01")]


def test_one_lamp(lit):
    QTest.mouseClick(lit.find("all_lamps"), Qt.MouseButton.LeftButton, pos=QPoint(8, 10))
    lit.type_into("lamp_field", "12")
    lit.click("light_confirm_button")
    lit.step()
    assert lit.heard() == [light("01 01 0C FF FF FF 00 00")]
    assert "lamp 12 of joint 1" in lit.read("notice_label")


@ONE_IS_ENOUGH
def test_a_grey_value_out_of_range_is_refused_where_it_was_typed(lit):
    lit.type_into("blue_field", "256")
    lit.click("light_confirm_button")
    lit.run(0.1)
    assert lit.heard() == []
    assert "B channel: 256" in lit.read("light_message")
    assert "Not sent" in lit.read("notice_label")


@ONE_IS_ENOUGH
def test_the_values_are_kept_while_another_panel_is_used(lit):
    lit.click("light_joint_5")
    lit.type_into("green_field", "3")
    lit.click("menu_motion")
    assert not lit.find("green_field").isVisible()
    lit.store.change(language="zh")
    lit.step()
    lit.click("menu_light")
    assert lit.read("light_confirm_button") == "确认"
    assert lit.find("light_joint_5").isChecked()
    assert lit.read("green_field") == "3"
    lit.store.change(language="en")
    lit.step()
    assert lit.read("light_confirm_button") == "Send colour"


@ONE_IS_ENOUGH
def test_an_arm_that_falls_silent_gets_no_light(lit):
    lit.powered = False
    lit.run(0.6)
    assert not lit.find("light_confirm_button").isEnabled()
    assert "nothing is heard" in lit.find("light_confirm_button").toolTip()
    assert lit.read("light_message") == ""  # the line above the panels says it
    lit.click("light_confirm_button")
    lit.step()
    assert lit.heard() == []
    lit.powered = True
    lit.run_until(lambda: lit.find("light_confirm_button").isEnabled())
    assert lit.read("light_message") == ""


@ONE_IS_ENOUGH
def test_a_link_picked_in_3d_chooses_the_joint(lit):
    lit.program.view.joint_picked.emit(4)
    lit.click("light_confirm_button")
    lit.step()
    assert lit.heard() == [light("01 04 FF FF FF FF 00 00")]


@ONE_IS_ENOUGH
def test_a_device_unplugged_half_way_gets_no_light_and_comes_back(lit):
    lit.click("light_confirm_button")
    lit.step()
    lit.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    lit.wait(lambda: "link_lost" in lit.codes())
    assert not lit.find("light_confirm_button").isEnabled()
    assert "device is gone" in lit.read("recovery_text")
    lit.plug_in()
    lit.wait(lambda: "reconnected" in lit.codes())
    lit.run_until(lambda: lit.find("light_confirm_button").isEnabled())
    assert lit.read("light_message") == ""
    lit.heard()
    lit.click("light_confirm_button")
    lit.step()
    assert lit.heard() == [light("01 01 FF FF FF FF 00 01")]
