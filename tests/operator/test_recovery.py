"""An operator led by the line above the panels: clicks in, bytes at the arm, words on screen."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.control.operating_state import StopState
from armui.control.safety.recovery_steps import StepKind
from armui.protocol.codes import ControlMode, TeachingState
from armui.protocol.frame import Frame
from armui.sim.faults.schedule import fault
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.picture.target_drag import TargetDrag
from tests.generations import ONE_IS_ENOUGH
from tests.operator.test_motion import ENABLE, RESUME, STOP


def line(app_driver):
    return app_driver.read("recovery_text")


def press(app_driver, label):
    """Press the button of the line, which must say so."""
    button = app_driver.find("recovery_button")
    assert button.isVisible()
    assert button.isEnabled()
    assert app_driver.read("recovery_button") == label
    app_driver.click("recovery_button")


def reads(app_driver, text):
    app_driver.run_until(lambda: text in line(app_driver))


@pytest.fixture
def online(any_driver):
    any_driver.connect()
    reads(any_driver, "motors are off")
    any_driver.heard()
    return any_driver


@pytest.fixture
def ready(online):
    press(online, "Enable")
    reads(online, "Ready")
    online.heard()
    return online


@ONE_IS_ENOUGH
def test_an_arm_just_connected_is_enabled_from_the_line(online):
    press(online, "Enable")
    reads(online, "Ready")
    assert online.heard() == [ENABLE]
    assert not online.find("recovery_button").isVisible()
    assert online.firmware.enabled == (True,) * 6


def test_an_arm_that_moves_is_not_called_ready(ready):
    ready.type_into("target_field_1", "40")
    ready.click("send_button")
    reads(ready, "The arm is moving")
    assert ready.controller.operating_state.moving
    ready.run_until(lambda: not ready.controller.operating_state.moving)
    reads(ready, "Ready")
    assert ready.controller.state.joints_deg[0].value == pytest.approx(40, abs=0.1)


def test_from_the_stop_back_to_ready(ready):
    ready.click("stop_button")
    reads(ready, "the motors only brake. Support the arm: released, it drops")
    ready.heard()
    assert "the arm will drop. Hold the arm" in ready.find("recovery_hold_button").toolTip()
    ready.hold_button("recovery_hold_button")
    reads(ready, "motors are off")
    press(ready, "Enable")
    reads(ready, "Ready")
    assert ready.heard() == [RESUME, ENABLE]
    assert ready.controller.operating_state.cannot_move is None


@ONE_IS_ENOUGH
def test_the_question_about_disabling_goes_when_it_no_longer_holds(ready):
    ready.click("enable_button")
    assert ready.dialog(ConfirmDialog).action_button.text() == "Disable"
    ready.firmware.on_frame(STOP)  # another host was quicker
    ready.run(0.5)
    with pytest.raises(AssertionError):
        ready.dialog(ConfirmDialog)


def test_a_collision_is_cleared_once_the_obstacle_is_gone(ready):
    push = fault("collision", 2)
    ready.node.faults.start(push)
    reads(ready, "clear the error")
    generation = int(ready.firmware.generation)
    assert ("joint 2" in line(ready)) is (generation == 2)
    press(ready, "Clear error")
    assert ready.read("recovery_button") == "Waiting…"
    reads(ready, "The arm has answered, but the fault is still there.")
    ready.node.faults.end(push)
    ready.run(0.1)
    ready.heard()
    press(ready, "Clear error")
    reads(ready, "Ready")
    assert [frame.arbitration_id for frame in ready.heard()] == [0x475]
    assert ready.firmware.enabled == (True,) * 6


def test_a_target_beyond_a_limit_only_wants_another(ready):
    for target_id in (0x155, 0x156, 0x157):  # another host asks too much: 500 deg
        ready.firmware.on_frame(Frame(target_id, bytes.fromhex("0007A120 00000000")))
    ready.firmware.on_frame(Frame(0x151, bytes.fromhex("01 01 1E 00 00 00 00 00")))
    reads(ready, "Send")
    assert "limit" in line(ready)
    assert not ready.find("recovery_button").isVisible()
    ready.click("home_button")
    reads(ready, "Ready")


def test_a_joint_lost_and_found(ready):
    lost = fault("joint-communication", 4)
    ready.node.faults.start(lost)
    reads(ready, "No communication with joint 4")
    assert ready.read("recovery_button") == "Reset…"
    ready.node.faults.end(lost)
    reads(ready, "Ready")


def test_a_reset_is_asked_about_and_then_led_to_its_end(ready):
    ready.firmware.condition.communication_fault[3] = True
    reads(ready, "No communication with joint 4")
    press(ready, "Reset…")
    assert "the arm will drop" in ready.dialog(ConfirmDialog).text()
    ready.heard()
    ready.confirm()
    reads(ready, "released, it drops")
    assert STOP in ready.heard()
    ready.firmware.condition.communication_fault[3] = False
    ready.hold_button("recovery_hold_button")
    reads(ready, "motors are off")
    press(ready, "Enable")
    reads(ready, "Ready")


@ONE_IS_ENOUGH
def test_an_arm_that_falls_silent(ready):
    ready.powered = False
    reads(
        ready,
        "Check its power, the CAN cable and the bit rate, or whether this computer is too busy",
    )
    press(ready, "Connect…")
    ready.dialog(ConnectDialog).close()
    ready.powered = True
    reads(ready, "Ready")


def test_a_teaching_input_is_explained_and_led_back_by_one_click(any_driver):
    app_driver = any_driver
    app_driver.firmware.on_frame(Frame(0x470, bytes.fromhex("FA 00 00 00")))
    app_driver.controller.connect_device(app_driver.device)
    reads(app_driver, "teaching input")
    assert not app_driver.find("send_button").isEnabled()
    press(app_driver, "Motion output")
    reads(app_driver, "motors are off") if not all(app_driver.firmware.enabled) else reads(
        app_driver, "Ready"
    )
    assert not app_driver.firmware.leads


def test_left_over_drag_teaching_is_left_step_by_step(ready):
    ready.controller.teaching.command(TeachingState.START_RECORDING)
    reads(ready, "lead it by hand")
    ready.firmware.hand_guiding.lead_to((0.0, 60.0, -40.0, 0.0, 0.0, 0.0), speed_deg_s=60.0)
    ready.run(1.5)
    press(ready, "Stop recording")
    reads(ready, "Still in drag teaching. Lead every joint")
    assert "joint 2: 60°" in line(ready)
    press(ready, "Lead by hand…")
    assert "give way to the hand" in ready.dialog(ConfirmDialog).text()
    ready.confirm()
    reads(ready, "The arm records")
    ready.firmware.hand_guiding.lead_to((0.0,) * 6, speed_deg_s=60.0)
    ready.run(1.5)
    press(ready, "Stop recording")
    reads(ready, "near the rest pose")
    press(ready, "Reset…")
    ready.confirm()
    reads(ready, "released, it drops")
    ready.hold_button("recovery_hold_button")
    reads(ready, "motors are off")
    press(ready, "Enable")
    reads(ready, "Ready")
    assert ready.firmware.condition.control_mode is ControlMode.STANDBY


@ONE_IS_ENOUGH
def test_a_double_click_takes_one_step_only(ready):
    ready.node.faults.start(broken := fault("overcurrent", 3))
    reads(ready, "Overcurrent, joint 3")
    ready.node.faults.end(broken)
    ready.heard()
    ready.click("recovery_button")
    ready.run_until(lambda: ready.controller.recovery.step.kind is StepKind.MOTORS_MIXED)
    button = ready.find("recovery_button")
    assert ready.read("recovery_button") == "Enable"
    QTest.mouseDClick(button, Qt.MouseButton.LeftButton, pos=button.rect().center())
    ready.run(0.3)
    assert ENABLE not in ready.heard()
    press(ready, "Enable")
    reads(ready, "Ready")


@pytest.mark.styled
@ONE_IS_ENOUGH
def test_nothing_moves_in_the_window_when_a_fault_comes_and_goes(ready):
    places = {
        name: ready.find(name).mapTo(ready.window, ready.find(name).rect().center())
        for name in ("recovery_line", "operation_area", "stop_button", "menu_light")
    }
    ready.click("stop_button")
    reads(ready, "released, it drops")
    assert ready.controller.operating_state.stop is StopState.STOPPED
    for name, place in places.items():
        assert ready.find(name).mapTo(ready.window, ready.find(name).rect().center()) == place


REST_DEG = (0.0, -1.999, 1.971, -1.412, 22.11, -2.608)
"""How a real arm lies when it is switched on."""


def test_a_resting_arm_is_brought_inside_from_the_line(app_driver):
    """Enabled, shown before, held, stepped: three presses from the switch to the first motion."""
    inside_deg = pytest.approx((0.0, 0.5, -0.5, -1.412, 15.0), abs=0.1)
    driver = app_driver
    driver.lie(REST_DEG)
    driver.connect()
    reads(driver, "motors are off")
    press(driver, "Enable")
    reads(driver, "J2 -2")
    assert "J3" in line(driver)
    drag = driver.window.findChild(TargetDrag)
    driver.program.view.setVisible(True)
    drag.refresh()
    assert driver.program.view._state.preview.ghost_deg[:5] == inside_deg
    assert "Move inside" in driver.read("picture_note")
    driver.hold_button("recovery_hold_button")
    driver.run_until(lambda: driver.firmware.joints_deg[4] < 15.1)
    reads(driver, "Ready")
    drag.refresh()
    assert driver.program.view._state.preview.ghost_deg is None
    assert driver.firmware.joints_deg[:5] == inside_deg
    driver.click("jog_plus_1")
    driver.run_until(lambda: driver.firmware.joints_deg[0] > 0.5)


@ONE_IS_ENOUGH
def test_a_joint_that_is_too_hot_is_told_with_its_figure_and_its_lamp(ready):
    ready.firmware.drivers.overheat_motor(1, on=True)
    reads(ready, "Motion is locked: Too hot, joint 2: 95 °C. Let the arm cool down")
    ready.run_until(lambda: ready.find("enable_button").faulty == (2,))
    ready.type_into("target_field_1", "40")
    assert not ready.find("send_button").isEnabled()


@ONE_IS_ENOUGH
def test_a_speed_of_zero_is_told_where_the_next_step_is(ready):
    ready.controller.motion.set_speed_percent(0)
    reads(ready, "The speed is set to 0 %: the arm would not move. Set a speed from 1 to 100 %")
    ready.controller.motion.set_speed_percent(30)
    reads(ready, "Ready")
