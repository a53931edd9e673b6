"""An operator at 联动控制 of the main window: bytes at the arm, words on screen."""

import pytest

from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from tests.accepted import accepted
from tests.faulty_arm import HardOfHearing
from tests.generations import ONE_IS_ENOUGH
from tests.operator.test_lit_buttons import lit


@pytest.fixture
def link(any_driver):
    any_driver.connect()
    any_driver.click("menu_linkage")
    any_driver.ear = HardOfHearing(any_driver.firmware)
    return any_driver


def choose(app_driver, name, place):
    app_driver.find(f"linkage_{name}_offset").setCurrentIndex(place)


def sent(app_driver):
    return [frame for frame in app_driver.ear.heard if frame.arbitration_id == 0x470]


def test_offsets_asked_about_sent_and_followed(link, generation):
    assert link.read("linkage_in_use") == ("In use: feedback 0x2A1–0x2A8, commands 0x150–0x15F")
    choose(link, "feedback", 1)
    choose(link, "control", 2)
    link.click("linkage_confirm_button")
    text = link.dialog(ConfirmDialog).text()
    assert "Every arm on this bus obeys this setting" in text
    assert "keeps it when switched off" in text
    link.run(0.1)
    assert sent(link) == []
    link.confirm()
    link.run_until(lambda: "linkage_in_use" in link.codes())
    padding = "" if generation is Generation.ONE else "00 00 00 00"
    assert sent(link) == [Frame(0x470, bytes.fromhex("FC 10 20 00" + padding))]
    assert link.firmware.settings.linkage.control_offset == 0x20
    link.step()
    assert link.read("linkage_in_use") == "In use: feedback 0x2B1–0x2B8, commands 0x170–0x17F"
    assert "feedback from 0x2B1, commands from 0x170" in link.read("linkage_message")
    assert "feedback comes from 0x2B1" in link.find("communication_button").toolTip()
    link.run_until(lambda: link.controller.state.angles_deg() is not None)


def test_a_teaching_input_is_explained_and_led_back(link):
    assert not link.find("linkage_back_button").isVisible()
    link.click("linkage_input")
    link.click("linkage_confirm_button")
    text = link.dialog(ConfirmDialog).text()
    assert "goes deaf: it obeys no command, not even the emergency stop" in text
    link.hold(0.9)
    link.run(0.2)
    assert sent(link) == []
    link.hold()
    link.run_until(lambda: link.find("linkage_back_button").isVisible())
    assert "is a teaching input" in link.read("linkage_teaching_input")
    assert link.read("linkage_in_use") == "In use: —"
    assert "has acknowledged the linkage setting" in link.read("linkage_message")
    assert not lit(link, "linkage_confirm_button")
    link.click("linkage_back_button")
    link.run_until(lambda: not link.find("linkage_back_button").isVisible())
    assert "has acknowledged" not in link.read("linkage_message")
    assert link.find("linkage_output").isChecked()
    assert not lit(link, "linkage_confirm_button")
    assert sent(link)[-1].data[:4] == bytes.fromhex("FC 00 00 00")
    assert not link.firmware.leads


@ONE_IS_ENOUGH
def test_a_role_that_waits_for_standby_stays_visible(link):
    link.enable_by_hand()
    accepted(link.controller.motion.jog(1, 0.1))
    link.run(1.0)
    link.click("linkage_input")
    link.click("linkage_confirm_button")
    link.confirm()
    link.run_until(lambda: link.find("linkage_back_button").isVisible())
    link.run(1.0)
    assert "The arm still obeys" in link.read("linkage_teaching_input")
    link.controller.emergency_stop()
    link.run_until(lambda: link.find("recovery_hold_button").isVisible())
    assert "deaf even to the stop" in link.read("recovery_text")


@ONE_IS_ENOUGH
def test_no_answer_is_said(link):
    link.ear.deaf_to = {0x470}
    choose(link, "feedback", 1)
    link.click("linkage_confirm_button")
    link.confirm()
    link.run(1.5)
    assert "Linkage setting not confirmed" in link.read("linkage_message")
    assert link.read("linkage_in_use").startswith("In use: feedback 0x2A1")


@ONE_IS_ENOUGH
def test_cancelled_nothing_is_sent(link):
    link.click("linkage_input")
    link.click("linkage_confirm_button")
    link.click(link.dialog(ConfirmDialog).cancel_button)
    link.run(0.3)
    assert sent(link) == []


@ONE_IS_ENOUGH
def test_without_an_arm(any_driver):
    any_driver.click("menu_linkage")
    assert not any_driver.find("linkage_confirm_button").isEnabled()
    assert any_driver.read("linkage_message") == ""  # the line above the panels says it
    assert any_driver.read("linkage_in_use") == "In use: —"


@ONE_IS_ENOUGH
def test_the_makers_words(link):
    link.store.change(language="zh")
    link.step()
    try:
        assert link.read("menu_linkage").strip() == "联动控制"
        assert link.read("linkage_input") == "主臂（示教输入臂）"
        assert link.read("linkage_output") == "从臂（运动输出臂）"
        assert link.read("linkage_confirm_button") == "确认"
    finally:
        link.store.change(language="en")
        link.step()
