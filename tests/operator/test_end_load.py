"""An operator at 末端负载 of the main window: bytes at the arm, frames heard, words on screen."""

import pytest

from armui.protocol.codes import EndLoad
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.faulty_arm import HardOfHearing
from tests.generations import ONE_IS_ENOUGH

FIGURE = "linear_speed_m_s_2"


@pytest.fixture
def load(any_driver):
    any_driver.connect()
    any_driver.click("menu_end_load")
    any_driver.ear = HardOfHearing(any_driver.firmware)
    return any_driver


def sent(app_driver):
    return [frame for frame in app_driver.ear.heard if frame.arbitration_id == 0x477]


def parameter(payload):
    return Frame(0x477, bytes.fromhex(payload))


def message(app_driver):
    return app_driver.read("end_load_message")


@pytest.mark.each_value(full="each load in both generations")
@pytest.mark.parametrize(("name", "code"), [("empty", 0), ("half", 1), ("full", 2)])
def test_a_load_is_told_and_answered(load, name, code):
    load.click(f"load_{name}")
    load.run(0.1)
    assert sent(load) == []
    load.click("load_confirm_button")
    load.run(0.2)
    assert sent(load) == [parameter(f"00 00 00 AE 0{code} 00 00 00")]
    assert load.firmware.settings.load is EndLoad(code)
    assert "The arm has answered the end load" in message(load)
    assert "cannot be asked" in message(load)


@ONE_IS_ENOUGH
def test_without_a_choice_nothing_is_sent(load):
    confirm = load.find("load_confirm_button")
    assert not confirm.isEnabled()
    assert confirm.toolTip() == "No end load is chosen. Choose one first."
    load.click(confirm)
    load.run(0.2)
    assert sent(load) == []
    load.click("load_empty")
    assert confirm.isEnabled()


@ONE_IS_ENOUGH
def test_no_answer(load):
    load.ear.deaf_to = {0x477}
    load.click("load_full")
    load.click("load_confirm_button")
    load.run(1.3)
    assert "End load not confirmed" in message(load)


def test_the_feedback_on_and_off(load, generation):
    assert load.read("end_feedback_state") == "Not heard"
    assert load.read(FIGURE) == "—"
    load.click("end_feedback_button")
    load.run(0.5)
    assert sent(load) == [parameter("00 00 01 00 00 00 00 00")]
    assert load.read("end_feedback_state") == "The arm reports"
    assert load.read(FIGURE) == "0.000"
    assert "The arm reports the motion of its end." in message(load)
    load.click("end_feedback_button")
    load.run(1.0)
    off = "00" if generation is Generation.ONE else "02"
    assert sent(load)[1:] == [parameter(f"00 00 {off} 00 00 00 00 00")]
    assert load.read("end_feedback_state") == "Not heard"
    assert "no longer reports" in message(load)
    assert load.find(FIGURE).is_stale()


def test_an_arm_that_answers_and_goes_on(load):
    load.click("end_feedback_button")
    load.run(0.5)
    load.firmware.settings_applier.report_end_motion = lambda *, on: None
    load.click("end_feedback_button")
    load.run(1.5)
    assert "goes on reporting" in message(load)
    assert load.read("end_feedback_state") == "The arm reports"


def test_an_arm_that_answers_and_says_nothing(load):
    load.firmware.settings_applier.report_end_motion = lambda *, on: None
    load.click("end_feedback_button")
    load.run(1.5)
    assert "is not switched" in message(load)
    assert load.read("end_feedback_state") == "Not heard"


@ONE_IS_ENOUGH
def test_without_an_arm(any_driver):
    any_driver.click("menu_end_load")
    for name in ("load_confirm_button", "end_feedback_button"):
        assert not any_driver.find(name).isEnabled()
    assert "No arm is connected" in any_driver.read("recovery_text")
