"""An operator at 夹爪控制 of the main window: bytes at the arm, words on screen."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.arm.refusal import Refusal
from armui.arm.state import GripperFault
from armui.control.run.progress import Run
from armui.protocol.codes import MoveMode
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.trajectory.points.program import Waypoint
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from tests.accepted import accepted
from tests.faulty_arm import FaultyDrivers, HardOfHearing
from tests.generations import ONE_IS_ENOUGH


@pytest.fixture
def grip(any_driver, generation):
    any_driver.connect()
    any_driver.click("menu_gripper")
    any_driver.run(0.3)
    any_driver.ear = HardOfHearing(any_driver.firmware)
    two = generation is Generation.TWO
    any_driver.travel, any_driver.effort = ("opening", "torque") if two else ("angle", "speed")
    any_driver.unit = " mm" if two else "°"
    return any_driver


@pytest.fixture
def grip2(app_driver):
    app_driver.connect()
    app_driver.click("menu_gripper")
    app_driver.run(0.3)
    app_driver.ear = HardOfHearing(app_driver.firmware)
    return app_driver


def sent(app_driver):
    return [frame for frame in app_driver.ear.heard if frame.arbitration_id == 0x159]


def command(payload):
    return Frame(0x159, bytes.fromhex(payload))


def message(app_driver):
    return app_driver.read("gripper_message")


def test_typed_and_sent(grip):
    assert grip.read("gripper_power") == "Disabled"
    grip.type_into(f"gripper_{grip.travel}_field", "30")
    grip.type_into(f"gripper_{grip.effort}_field", "2")
    grip.run(0.1)
    assert sent(grip) == []
    grip.click("gripper_send_button")
    grip.run(1.5)
    # 30 = 30000 = 7530; 2 = 2000 = 07D0
    assert sent(grip) == [command("00007530 07D0 01 00")]
    assert grip.read(f"gripper_{grip.travel}_measured") == f"30.000{grip.unit}"
    assert grip.read("gripper_power") == "Enabled"
    assert message(grip).startswith("The gripper is at 30 ")


def test_the_other_generations_figures_are_not_there(grip, generation):
    shown = {
        name: grip.find(f"gripper_{name}_field").isVisible()
        for name in ("opening", "torque", "angle", "speed")
    }
    two = generation is Generation.TWO
    assert shown == {"opening": two, "torque": two, "angle": not two, "speed": not two}
    assert grip.find("gripper_zero_button").isVisible() is two


def test_minus_and_plus_act_at_once(grip):
    grip.type_into(f"gripper_{grip.travel}_field", "10")
    grip.click(f"gripper_{grip.travel}_plus")
    grip.step()
    assert sent(grip) == [command("00002AF8 03E8 01 00")]  # 11 = 11000 = 2AF8
    assert grip.read(f"gripper_{grip.travel}_field") == "11.000"
    grip.click(f"gripper_{grip.travel}_minus")
    grip.step()
    assert sent(grip)[1:] == [command("00002710 03E8 01 00")]


def test_the_target_follows_the_gripper_until_one_is_set(grip2):
    """What a run did is never taken back by a target that nobody set."""
    field, send = grip2.find("gripper_opening_field"), grip2.find("gripper_send_button")
    assert field.text() == "0.000"
    assert not send.property("primary")
    grip2.firmware.gripper.travel = grip2.firmware.gripper._target = 32.1  # as by a run
    grip2.run(0.1)
    assert field.text() == "32.100"
    assert not send.property("primary")
    grip2.type_into("gripper_opening_field", "30")
    assert field.property("typed")
    assert send.property("primary")
    grip2.firmware.gripper.travel = grip2.firmware.gripper._target = 20.0
    grip2.run(0.1)
    assert grip2.read("gripper_opening_field") == "30.000"
    grip2.click("gripper_send_button")
    grip2.run(0.1)
    assert field.text() == "30.000"  # it is on its way there
    assert not send.property("primary")
    assert not field.property("typed")
    grip2.run(2.0)
    grip2.firmware.gripper.travel = grip2.firmware.gripper._target = 10.0
    grip2.run(0.1)
    assert field.text() == "10.000"


def test_the_slider_fills_the_field(grip):
    slider = grip.find(f"gripper_{grip.effort}_slider")
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_End)
    assert grip.read(f"gripper_{grip.effort}_field") == (
        "5.000" if grip.effort == "torque" else "6.000"
    )
    grip.run(0.1)
    assert sent(grip) == []


def test_beyond_the_stroke_it_is_refused(grip2):
    assert not grip2.find("gripper_stroke_note").isVisible()  # read on opening: 70 mm
    grip2.type_into("gripper_opening_field", "71")
    assert "Opening: 71 mm is out of range" in message(grip2)
    grip2.click("gripper_send_button")
    grip2.run(0.1)
    assert sent(grip2) == []
    assert "from 0 to 70 mm" in message(grip2)
    grip2.type_into("gripper_torque_field", "much")
    grip2.type_into("gripper_opening_field", "7")
    grip2.click("gripper_send_button")
    grip2.run(0.1)
    assert sent(grip2) == []
    assert "Torque: “much” is not a number" in message(grip2)


@ONE_IS_ENOUGH
def test_enable_holds_and_disable_asks(grip):
    grip.click("gripper_enable_button")
    grip.run(0.3)
    assert sent(grip) == [command("00000000 03E8 01 00")]
    assert grip.read("gripper_power") == "Enabled"
    assert message(grip) == "Gripper: Enable done, by its own feedback."
    grip.click("gripper_disable_button")
    assert "drops what it holds" in grip.dialog(ConfirmDialog).text()
    grip.click(grip.dialog(ConfirmDialog).action_button)
    grip.run(0.1)
    assert len(sent(grip)) == 1
    grip.hold()
    grip.run(0.3)
    assert sent(grip)[1:] == [command("00000000 0000 00 00")]
    assert grip.read("gripper_power") == "Disabled"


def test_its_errors_in_words(grip2):
    grip2.firmware.gripper.fail(GripperFault.MOTOR_OVERTEMPERATURE)
    grip2.firmware.gripper.fail(GripperFault.UNDERVOLTAGE)
    grip2.run(0.1)
    assert grip2.read("gripper_power") == "Fault"
    assert grip2.read("gripper_faults") == "motor too hot; supply voltage too low"
    grip2.click("gripper_clear_button")
    grip2.run(0.3)
    assert sent(grip2) == [command("00000000 0000 02 00")]
    assert not grip2.find("gripper_faults").isVisible()


def test_its_zero_is_asked_about(grip2):
    grip2.firmware.gripper.travel = grip2.firmware.gripper._target = 4.0
    grip2.run(0.1)
    grip2.click("gripper_zero_button")
    assert "becomes its 0 mm" in grip2.dialog(ConfirmDialog).text()
    grip2.hold()
    grip2.run(0.4)
    assert sent(grip2) == [command("00000000 0000 00 AE")]
    assert grip2.firmware.gripper.travel == 0.0
    assert message(grip2) == "Gripper: Set zero done, by its own feedback."


def test_an_arm_without_a_gripper(grip):
    feedback = FaultyDrivers(grip.firmware)
    feedback.missing = {0x2A8}
    grip.run(0.8)
    assert grip.read("gripper_power") == "No gripper heard"
    assert grip.find(f"gripper_{grip.travel}_measured").is_stale()
    assert not grip.find("gripper_send_button").isEnabled()
    assert "No gripper is heard" in grip.find("gripper_send_button").toolTip()
    feedback.mend()


@ONE_IS_ENOUGH
def test_one_that_does_not_hear(grip):
    grip.ear.deaf_to = {0x159}
    grip.type_into(f"gripper_{grip.travel}_field", "30")
    grip.click("gripper_send_button")
    grip.run(1.0)
    assert "stopped at 0 " in message(grip)
    assert "instead of 30 " in message(grip)


@ONE_IS_ENOUGH
def test_in_a_stop_nothing_can_be_sent(grip):
    grip.click("stop_button")
    grip.run_until(lambda: "stop_confirmed" in grip.codes())
    grip.step()
    for name in ("send", "enable", "disable", "clear"):
        assert not grip.find(f"gripper_{name}_button").isEnabled()
    assert message(grip) == ""  # the line above the panels says it


@ONE_IS_ENOUGH
def test_before_an_arm_is_heard(any_driver):
    any_driver.click("menu_gripper")
    assert any_driver.read("gripper_opening_measured") == "—"
    assert any_driver.read("gripper_power") == "No gripper heard"
    assert not any_driver.find("gripper_send_button").isEnabled()
    assert message(any_driver) == ""  # the line above the panels says it


@ONE_IS_ENOUGH
def test_the_chinese_words(grip):
    grip.store.change(language="zh")
    grip.step()
    try:
        assert grip.read("menu_gripper").strip() == "夹爪控制"
        assert [grip.read(f"gripper_{act}_button") for act in ("enable", "disable", "clear")] == [
            "使能",
            "失能",
            "清除错误",
        ]
        assert grip.read("gripper_power") == "已失能"
    finally:
        grip.store.change(language="en")
        grip.step()


def test_it_is_opened_to_the_stroke_limit_and_closed_by_buttons(grip2):
    grip2.type_into("gripper_torque_field", "2")
    grip2.click("gripper_open_fully_button")
    grip2.step()
    assert sent(grip2) == [command("00011170 07D0 01 00")]  # 70 = 70000 = 11170; 2 = 2000 = 07D0
    assert grip2.read("gripper_opening_field") == "70.000"
    grip2.run(2.0)
    assert grip2.read("gripper_opening_measured") == "70.000 mm"
    grip2.click("gripper_close_fully_button")
    grip2.run(2.0)
    assert sent(grip2)[1:] == [command("00000000 07D0 01 00")]
    assert grip2.read("gripper_opening_measured") == "0.000 mm"


@pytest.mark.parametrize("generation", [Generation.ONE], ids=["gen1"])
def test_how_far_it_opens_is_said_to_be_unknown(grip):
    """How far the gripper of generation 1 turns is not published."""
    button = grip.find("gripper_open_fully_button")
    assert not button.isEnabled()
    assert "How far this gripper opens is not known" in button.toolTip()
    assert grip.find("gripper_close_fully_button").isEnabled()


def test_it_is_not_moved_in_a_run(grip2):
    grip2.controller.motors.enable()
    grip2.run(1.0)
    run = Run("run", [Waypoint(MoveMode.MOVE_J, (60.0, 0, 0, 0, 0, 0))], [3.0])
    accepted(grip2.controller.player.start(run))
    grip2.run(0.2)
    for name in ("gripper_open_fully_button", "gripper_close_fully_button"):
        assert not grip2.find(name).isEnabled()
    assert isinstance(grip2.controller.gripper.move_to_end(opened=True), Refusal)
    assert sent(grip2) == []
