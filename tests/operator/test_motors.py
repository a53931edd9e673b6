"""An operator at 电机设置 of the main window: bytes at the arm, words on screen."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from armui.arm.state import ArmState
from armui.protocol.codes import ALL_JOINTS
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.ui import words
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from tests.faulty_arm import FaultyDrivers, HardOfHearing
from tests.generations import ONE_IS_ENOUGH
from tests.operator.workspace.actions import rect_in_window

JOINTS = range(1, 7)


@pytest.fixture
def motors(any_driver):
    any_driver.connect()
    any_driver.click("menu_motor")
    any_driver.ear = HardOfHearing(any_driver.firmware)
    return any_driver


def frame(arbitration_id, payload):
    return Frame(arbitration_id, bytes.fromhex(payload))


def sent(app_driver, arbitration_id):
    return [each for each in app_driver.ear.heard if each.arbitration_id == arbitration_id]


def powers(app_driver):
    return [app_driver.read(f"motor_power_{joint}") for joint in JOINTS]


@pytest.mark.styled
def test_the_buttons_for_all_joints_stand_in_the_columns_of_the_joints(motors):
    for act in ("enable", "disable", "zero", "clear"):
        alone, every = (rect_in_window(motors.find(f"{act}_motor_{n}")) for n in (1, ALL_JOINTS))
        assert (alone.left(), alone.width()) == (every.left(), every.width())


def message(app_driver):
    return app_driver.read("motor_message")


def test_one_motor_on_and_off(motors):
    assert powers(motors) == ["Disabled"] * 6
    motors.click("enable_motor_4")
    motors.run(0.4)
    assert sent(motors, 0x471) == [frame(0x471, "04 02 00 00 00 00 00 00")]
    assert motors.firmware.mechanics.powered == (False, False, False, True, False, False)
    assert powers(motors) == ["Disabled"] * 3 + ["Enabled"] + ["Disabled"] * 2
    assert message(motors) == "Joint 4 is enabled."

    motors.click("disable_motor_4")
    question = motors.dialog(ConfirmDialog)
    assert question.windowTitle() == "Disable the motor of joint 4"
    assert "The arm will drop" in question.text()
    motors.run(0.1)
    assert len(sent(motors, 0x471)) == 1  # nothing before the answer
    motors.hold()
    motors.run(0.4)
    assert sent(motors, 0x471)[1:] == [frame(0x471, "04 01 00 00 00 00 00 00")]
    assert powers(motors) == ["Disabled"] * 6
    assert message(motors) == "Joint 4 is disabled."


def test_all_motors_on_and_off(motors):
    motors.click("enable_motor_7")
    motors.run(0.4)
    assert sent(motors, 0x471) == [frame(0x471, "07 02 00 00 00 00 00 00")]
    assert powers(motors) == ["Enabled"] * 6
    motors.click("disable_motor_7")
    assert "Hold the arm" in motors.dialog(ConfirmDialog).text()
    motors.hold()
    motors.run(0.4)
    assert sent(motors, 0x471)[1:] == [frame(0x471, "07 01 00 00 00 00 00 00")]
    assert motors.firmware.mechanics.powered == (False,) * 6


DROPS = "The arm will drop when its motors are disabled. Hold the arm."
LETS_GO = (
    "The gripper lets go, too, and what it holds falls. To keep it, disable joints 1–6 singly."
)
MAY_LET_GO = f"From firmware S-V1.9-0 on t{LETS_GO[1:]}"


@pytest.mark.parametrize(
    ("version", "added"), [("S-V1.8-9", ""), ("S-V1.9-0", LETS_GO), ("S-V2.0-0", LETS_GO)]
)
def test_disabling_all_says_that_the_gripper_lets_go_where_it_does(app_driver, version, added):
    app_driver.lie((0.0,) * 6, version=version)
    app_driver.ready()
    app_driver.click("enable_button")
    assert app_driver.dialog(ConfirmDialog).text().removeprefix(DROPS).strip() == added
    app_driver.dialog(ConfirmDialog).reject()
    app_driver.click("menu_motor")
    for joint in (7, 2):
        app_driver.click(f"disable_motor_{joint}")
        text = app_driver.dialog(ConfirmDialog).text()
        assert text.endswith(LETS_GO) is bool(added and joint == 7)
        app_driver.dialog(ConfirmDialog).reject()


@pytest.mark.parametrize(
    ("generation", "firmware", "added"),
    [
        (Generation.ONE, None, ""),
        (Generation.TWO, None, MAY_LET_GO),
        (Generation.TWO, "?", MAY_LET_GO),
        (None, None, MAY_LET_GO),
    ],
)
def test_of_a_version_that_is_not_known_it_is_said_with_the_version(
    qapp, generation, firmware, added
):
    text = words.disabling(DROPS, generation, ArmState(firmware=firmware))
    assert text.removeprefix(DROPS).strip() == added


@pytest.mark.parametrize("name", ["disable_motor_2", "zero_motor_2", "zero_motor_7"])
@ONE_IS_ENOUGH
def test_neither_a_double_click_nor_letting_go_early_does_it(motors, name):
    motors.click("enable_motor_7")
    motors.run(0.4)
    motors.ear.heard.clear()
    motors.click(name)
    button = motors.dialog(ConfirmDialog).action_button
    motors.click(button)
    QTest.mouseDClick(button, Qt.MouseButton.LeftButton)
    motors.hold(share=0.9)
    motors.run(0.5)
    assert sent(motors, 0x471) == []
    assert sent(motors, 0x475) == []
    assert motors.dialog(ConfirmDialog).isVisible()
    motors.click(motors.dialog(ConfirmDialog).cancel_button)
    motors.run(0.5)
    assert motors.firmware.mechanics.powered == (True,) * 6


def test_a_zero_is_set_and_the_answer_shown(motors, generation):
    motors.firmware.mechanics.count_anew((0.0, 12.0, -3.0, 0.0, 0.0, 0.0))
    motors.run(0.1)
    motors.click("zero_motor_2")
    question = motors.dialog(ConfirmDialog)
    assert question.windowTitle() == "Set the zero of joint 2"
    assert "Where joint 2 stands now becomes its 0°." in question.text()
    assert "runs into its stops" in question.text()
    motors.hold()
    motors.run(0.3)
    left_alone = "00 00" if generation == 1 else "7F FF"
    assert sent(motors, 0x475) == [frame(0x475, f"02 AE 00 {left_alone} 00 00 00")]
    assert motors.firmware.settings.zeros_deg[1] == 12.0
    assert message(motors) == "The arm has set the zero of joint 2; its angle now reads 0."


def test_a_zero_that_the_arm_refuses(motors):
    motors.firmware.settings_applier.set_zero = lambda _indices: False
    motors.click("zero_motor_7")
    motors.hold()
    motors.run(0.3)
    assert "did not set the zero of these joints: 1, 2, 3, 4, 5, 6" in message(motors)
    assert "did not set the zero" in motors.read("notice_label")


def test_an_error_is_cleared(motors, generation):
    motors.click("clear_motor_3")
    motors.run(0.3)
    left_alone = "00 00" if generation == 1 else "7F FF"
    assert sent(motors, 0x475) == [frame(0x475, f"03 00 00 {left_alone} AE 00 00")]
    assert "Joint 3: the arm has confirmed the command to clear the error" in message(motors)


@ONE_IS_ENOUGH
def test_the_errors_of_all_joints_are_told_of_all(motors):
    motors.click("clear_motor_7")
    motors.run(0.3)
    assert "Joint 1–6: the arm has confirmed" in message(motors)


def test_an_arm_that_does_not_answer_says_so(motors):
    motors.ear.deaf_to = {0x471, 0x475}
    motors.click("enable_motor_1")
    motors.run(2.0)
    assert len(sent(motors, 0x471)) == 0
    assert "did not enable: 1" in message(motors)
    motors.click("clear_motor_1")
    motors.run(1.5)
    assert "did not confirm within a second" in message(motors)


@ONE_IS_ENOUGH
def test_the_figures_beside_and_when_they_are_old(motors):
    motors.run(0.2)
    driver = motors.controller.state.drivers_slow[2].value
    assert motors.read("motor_temperature_3") == f"{driver.motor_temperature_c:.0f} °C"
    assert motors.read("driver_temperature_3") == f"{driver.driver_temperature_c:.0f} °C"
    assert motors.read("voltage_3") == f"{driver.voltage_v:.1f} V"
    assert motors.read("current_3").endswith(" A")
    drivers = FaultyDrivers(motors.firmware)
    drivers.silent = {3}
    motors.run(0.8)
    assert motors.find("voltage_3").is_stale()
    assert motors.find("motor_power_3").is_stale()
    assert not motors.find("current_3").is_stale()  # 0x253 is still heard
    assert not motors.find("voltage_4").is_stale()
    drivers.mend()


@ONE_IS_ENOUGH
def test_nothing_is_made_up_before_an_arm_is_heard(any_driver):
    any_driver.click("menu_motor")
    assert powers(any_driver) == ["—"] * 6
    assert any_driver.read("voltage_1") == any_driver.read("current_1") == "—"
    for act in ("enable", "disable", "zero", "clear"):
        button = any_driver.find(f"{act}_motor_1")
        assert not button.isEnabled()
        assert "No arm is connected" in button.toolTip()


@ONE_IS_ENOUGH
def test_in_an_emergency_stop_only_errors_can_be_cleared(motors):
    motors.click("stop_button")
    motors.run_until(lambda: "stop_confirmed" in motors.codes())
    motors.step()
    for act in ("enable", "disable", "zero"):
        assert not motors.find(f"{act}_motor_7").isEnabled()
        assert "emergency stop" in motors.find(f"{act}_motor_7").toolTip()
    assert motors.find("clear_motor_7").isEnabled()
    assert message(motors) == ""  # the line above the panels says it


@ONE_IS_ENOUGH
def test_a_stop_during_the_question_keeps_it_from_acting(motors):
    motors.click("zero_motor_1")
    motors.click(motors.dialog(ConfirmDialog).stop_button)
    motors.run_until(lambda: "stop_confirmed" in motors.codes())
    motors.hold()
    motors.run(0.3)
    assert sent(motors, 0x475) == []
    assert "emergency stop" in message(motors)


@ONE_IS_ENOUGH
def test_the_manuals_words(motors):
    motors.store.change(language="zh")
    motors.step()
    motors.click("disable_motor_1")
    try:
        assert [
            motors.read(f"{act}_motor_1") for act in ("enable", "disable", "zero", "clear")
        ] == [
            "使能",
            "失能",
            "零点设置",
            "清除错误",
        ]
        assert motors.read("menu_motor").strip() == "电机设置"
        assert "失能后机械臂会下落，请扶住机械臂" in motors.dialog(ConfirmDialog).text()
    finally:
        motors.store.change(language="en")
        QApplication.processEvents()


@ONE_IS_ENOUGH
def test_a_link_picked_in_3d_leads_to_its_motor(motors):
    motors.window.activateWindow()
    motors.program.view.joint_picked.emit(5)
    assert motors.window.focusWidget() is motors.find("enable_motor_5")
