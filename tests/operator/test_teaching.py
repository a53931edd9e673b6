"""An operator at 示教 of the main window: bytes at the arm, what it does, words on screen."""

import errno

import can
import pytest
from shiboken6 import isValid

from armui.control.devices.teaching_phase import TeachingPhase
from armui.control.events import Level
from armui.control.safety.recovery_steps import Step, StepKind
from armui.protocol.codes import ArmStatusCode, ControlMode, TeachingState
from armui.protocol.frame import Frame
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.panels.teaching_panel import TeachingExitSteps
from tests.accepted import accepted
from tests.generations import ONE_IS_ENOUGH

THERE_DEG = (10.0, 40.0, -30.0, 0.0, 0.0, 0.0)
HOME_DEG = (0.0,) * 6


def teach(code):
    return Frame(0x150, bytes((0, 0, code, 0, 0, 0, 0, 0)))


def plan(code):
    return Frame(0x150, bytes((0, code, 0, 0, 0, 0, 0, 0)))


def usable(app_driver):
    """The commands that are offered now."""
    names = "start_recording stop_recording run_recording move_to_start pause continue abort"
    return {name for name in names.split() if app_driver.find(f"teaching_{name}").isEnabled()}


def give(app_driver, name):
    """Press a command that is offered; asked about before the arm is handed over, or moves."""
    assert name in usable(app_driver)
    if name == "continue":
        app_driver.hold_button("teaching_continue")
        return
    app_driver.click(f"teaching_{name}")
    if name in {"start_recording", "run_recording", "move_to_start"}:
        app_driver.confirm()


def phase(app_driver, text):
    app_driver.run_until(lambda: text in app_driver.read("teaching_phase"))
    app_driver.run_until(lambda: app_driver.read("teaching_message") == "")


def lead(app_driver, angles_deg):
    app_driver.firmware.hand_guiding.lead_to(angles_deg, speed_deg_s=20.0)
    app_driver.run_until(lambda: app_driver.firmware.joints_deg == pytest.approx(angles_deg))
    app_driver.run(0.2)


def due(app_driver):
    return app_driver.find("teaching_exit_steps").due


@pytest.fixture
def enabled(any_driver):
    any_driver.connect()
    any_driver.enable_by_hand()
    any_driver.click("menu_teaching")
    any_driver.heard()
    return any_driver


@pytest.fixture
def taught(enabled):
    """The hand has led the arm away and ended the recording."""
    give(enabled, "start_recording")
    phase(enabled, "Recording")
    lead(enabled, THERE_DEG)
    give(enabled, "stop_recording")
    phase(enabled, "nothing under way")
    enabled.heard()
    return enabled


def test_recording_begins_with_a_warning_and_ends_with_the_arms_word(enabled):
    assert usable(enabled) == {"start_recording"}
    enabled.click("teaching_start_recording")
    question = enabled.dialog(ConfirmDialog)
    assert "give way to the hand" in question.text()
    enabled.run(0.1)
    assert enabled.heard() == []
    enabled.confirm()
    enabled.step()
    assert enabled.heard() == [teach(1)]
    phase(enabled, "Recording")
    assert enabled.read("teaching_state") == "Start of recording (drag teaching on)"
    assert usable(enabled) == {"stop_recording"}
    lead(enabled, THERE_DEG)
    give(enabled, "stop_recording")
    phase(enabled, "nothing under way")
    assert enabled.heard() == [teach(2)]
    assert enabled.read("teaching_state") == "Recording ended; still in drag teaching"
    assert usable(enabled) == {"start_recording", "run_recording", "move_to_start"}
    assert enabled.firmware.teaching.recording[-1] == pytest.approx(THERE_DEG)


def withhold(app_driver, monkeypatch, ids):
    """The arm's frames of these identifiers do not come."""
    send = app_driver.node._send

    def send_others(frames):
        return send([each for each in frames if each.arbitration_id not in ids])

    monkeypatch.setattr(app_driver.node, "_send", send_others)


@ONE_IS_ENOUGH
def test_the_question_of_a_recording_outlasts_feedback_that_is_late(enabled, monkeypatch):
    enabled.click("teaching_start_recording")
    with monkeypatch.context() as late:
        withhold(enabled, late, {0x263})
        enabled.run_until(lambda: None in enabled.controller.operating_state.enabled)
        enabled.run(0.2)
        assert isValid(enabled.dialog(ConfirmDialog))
    enabled.run(0.3)
    enabled.heard()
    enabled.confirm()
    enabled.step()
    assert enabled.heard() == [teach(1)]


@ONE_IS_ENOUGH
def test_the_panel_says_that_a_question_was_withdrawn(enabled):
    enabled.click("teaching_start_recording")
    accepted(enabled.controller.motors.disable())
    enabled.run(1.0)
    assert "nothing was done" in enabled.read("teaching_message")


def test_a_replay_is_paused_continued_and_terminated(taught):
    give(taught, "run_recording")
    phase(taught, "Moving along")
    assert usable(taught) == {"pause", "abort"}
    taught.run_until(lambda: max(map(abs, taught.firmware.joints_deg)) < 1.0)
    taught.run(0.5)
    give(taught, "pause")
    phase(taught, "paused")
    assert taught.read("teaching_state") == "Replay paused"
    assert usable(taught) == {"continue", "abort"}
    give(taught, "continue")
    phase(taught, "Moving along")
    give(taught, "abort")
    phase(taught, "nothing under way")
    assert taught.heard() == [teach(3), teach(4), teach(5), teach(6)]


@ONE_IS_ENOUGH
@pytest.mark.parametrize(
    ("name", "says"), [("run_recording", "along the recording"), ("move_to_start", "to the start")]
)
def test_what_sets_the_arm_moving_is_asked_about_before(taught, name, says):
    taught.click(f"teaching_{name}")
    question = taught.dialog(ConfirmDialog)
    assert says in question.text()
    assert "Keep clear" in question.text()
    taught.run(0.3)
    assert taught.heard() == []
    question.reject()
    taught.run(0.3)
    assert taught.heard() == []
    assert taught.firmware.joints_deg == pytest.approx(THERE_DEG)


@ONE_IS_ENOUGH
def test_a_question_does_not_outlive_what_it_is_about(taught):
    """The hand begins a recording at the arm meanwhile: the one asked about is lost."""
    taught.click("teaching_run_recording")
    question = taught.dialog(ConfirmDialog)
    taught.firmware.teaching.command(TeachingState.START_RECORDING)
    taught.run_until(lambda: not isValid(question) or not question.isVisible())
    taught.run(0.2)
    assert taught.heard() == []


@ONE_IS_ENOUGH
def test_a_paused_replay_goes_on_only_by_a_held_press(taught):
    give(taught, "run_recording")
    phase(taught, "Moving along")
    taught.run_until(lambda: max(map(abs, taught.firmware.joints_deg)) < 1.0)
    taught.run(0.5)
    give(taught, "pause")
    phase(taught, "paused")
    taught.heard()
    taught.click("teaching_continue")
    taught.hold_button("teaching_continue", 0.5)
    taught.run(0.3)
    assert taught.heard() == []
    give(taught, "continue")
    phase(taught, "Moving along")
    assert taught.heard() == [teach(5)]


@ONE_IS_ENOUGH
def test_the_start_of_the_recording_is_reached(taught):
    give(taught, "move_to_start")
    phase(taught, "Moving along")
    phase(taught, "nothing under way")
    assert taught.heard() == [teach(7)]
    assert taught.firmware.joints_deg == pytest.approx(HOME_DEG)


@ONE_IS_ENOUGH
def test_a_command_the_arm_does_not_follow_is_said(taught):
    taught.firmware.teaching.recording.clear()
    give(taught, "run_recording")
    assert "Waiting for the arm" in taught.read("teaching_message")
    assert usable(taught) == set()
    taught.run_until(lambda: "did not follow" in taught.read("teaching_message"))
    assert "record first" in taught.read("teaching_message")
    assert taught.heard() == [teach(3)]  # what sets the arm going is not sent again
    assert "run_recording" in usable(taught)


@ONE_IS_ENOUGH
def test_the_end_of_a_recording_is_asked_for_again(enabled):
    give(enabled, "start_recording")
    phase(enabled, "Recording")
    enabled.heard()
    enabled.firmware.teaching.command = lambda _command: None  # deaf to teaching
    give(enabled, "stop_recording")
    enabled.run_until(lambda: "teaching_unanswered" in enabled.codes())
    assert enabled.heard() == [teach(2)] * 3
    del enabled.firmware.teaching.command


@ONE_IS_ENOUGH
def test_motors_off_or_a_stop_keep_teaching_away_and_say_why(any_driver):
    any_driver.connect()
    any_driver.click("menu_teaching")
    any_driver.run(0.2)
    assert usable(any_driver) == set()
    assert "not enabled" in any_driver.find("teaching_start_recording").toolTip()
    assert "not in drag teaching" in any_driver.find("teaching_run_recording").toolTip()
    any_driver.enable_by_hand()
    any_driver.click("stop_button")
    any_driver.run(0.3)
    assert "emergency stop" in any_driver.find("teaching_start_recording").toolTip()
    assert "emergency stop" in any_driver.find("plan_continue").toolTip()


@ONE_IS_ENOUGH
def test_a_link_lost_half_way_ends_the_waiting(enabled):
    enabled.firmware.teaching.command = lambda _command: None
    give(enabled, "start_recording")
    assert "Waiting" in enabled.read("teaching_message")
    enabled.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    enabled.wait(lambda: "link_lost" in enabled.codes())
    assert "device is gone" in enabled.read("recovery_text")
    assert enabled.read("teaching_state") == "—"
    assert usable(enabled) == set()
    enabled.plug_in()
    enabled.wait(lambda: "reconnected" in enabled.codes())
    enabled.run_until(lambda: usable(enabled) == {"start_recording"})
    assert teach(1) not in enabled.heard()[1:]
    del enabled.firmware.teaching.command


def test_what_the_button_on_the_arm_does_is_followed(enabled):
    enabled.firmware.on_frame(teach(1))  # the arm's own button
    phase(enabled, "Recording")
    assert usable(enabled) == {"stop_recording"}
    assert enabled.heard() == []


def assert_the_list_names_the_button(app_driver, name="recovery_button"):
    """The step that is due in the list is the one that the line offers, in the same word."""
    steps = app_driver.find("teaching_exit_steps")
    app_driver.run_until(lambda: app_driver.find(name).isVisible())
    line = steps._lines[steps.due - 1].text()
    assert f"“{app_driver.read(name)}”" in line
    assert "mergency stop" not in line


def test_teaching_is_left_one_step_at_a_time(taught):
    app_driver = taught
    assert due(app_driver) == 1
    assert app_driver.find("teaching_exit_steps").isVisible()
    app_driver.click("recovery_button")
    app_driver.confirm()
    phase(app_driver, "Recording")
    lead(app_driver, HOME_DEG)
    give(app_driver, "stop_recording")
    app_driver.run_until(lambda: due(app_driver) == 2)
    assert_the_list_names_the_button(app_driver)
    app_driver.click("recovery_button")
    assert "the arm will drop" in app_driver.dialog(ConfirmDialog).text()
    app_driver.confirm()
    app_driver.run_until(lambda: due(app_driver) == 3)
    assert_the_list_names_the_button(app_driver, "recovery_hold_button")
    assert app_driver.firmware.condition.status is ArmStatusCode.EMERGENCY_STOP
    app_driver.hold_button("recovery_hold_button")
    app_driver.run_until(lambda: due(app_driver) == 4)
    assert_the_list_names_the_button(app_driver)
    assert app_driver.firmware.condition.control_mode is ControlMode.STANDBY
    app_driver.click("recovery_button")
    app_driver.run_until(lambda: not app_driver.find("teaching_exit_steps").isVisible())
    assert app_driver.controller.operating_state.cannot_move is None


def test_an_arm_that_lies_outside_its_limits_is_out_of_drag_teaching(qtbot):
    """Once enabled, what is left to do is no step of the list."""
    steps = TeachingExitSteps()
    qtbot.addWidget(steps)
    steps.show_step(TeachingPhase.RECORDING, Step(StepKind.DRAG_MODE, Level.WARNING))
    steps.show_step(TeachingPhase.OFF, Step(StepKind.MOTORS_OFF, Level.INFO))
    assert steps.due == 4
    steps.show_step(TeachingPhase.OFF, Step(StepKind.OUTSIDE, Level.WARNING))
    assert steps.due == 0
    assert steps.isHidden()


def test_a_stop_before_the_arm_was_led_back_ticks_no_step_that_was_not_taken(taught):
    steps = taught.find("teaching_exit_steps")
    taught.controller.emergency_stop()
    taught.run_until(lambda: taught.find("recovery_hold_button").isVisible())
    assert [sign.text() for sign in steps._signs] == ["▸", "", "", ""]
    assert "does not end drag teaching" in steps._title.text()
    taught.hold_button("recovery_hold_button")
    taught.run_until(lambda: "To leave drag teaching" in steps._title.text())
    assert [sign.text() for sign in steps._signs] == ["▸", "", "", ""]
    assert taught.firmware.condition.control_mode is ControlMode.TEACHING


def test_closing_while_a_hand_is_recorded_asks(enabled):
    give(enabled, "start_recording")
    phase(enabled, "Recording")
    enabled.window.close()
    question = enabled.dialog(ConfirmDialog)
    assert "goes on giving way to the hand" in question.text()
    assert enabled.window.isVisible()
    enabled.firmware.on_frame(teach(2))
    enabled.run(0.5)  # it is withdrawn: nothing is taught any more
    assert not enabled.window.findChildren(ConfirmDialog)


@ONE_IS_ENOUGH
def test_motions_are_paused_continued_and_cleared(enabled):
    assert not enabled.find("plan_pause").isEnabled()
    assert "nothing to pause" in enabled.find("plan_pause").toolTip()
    enabled.controller.motion.send_joints((60.0, *HOME_DEG[1:]))
    enabled.run_until(lambda: enabled.find("plan_pause").isEnabled())
    enabled.heard()
    enabled.click("plan_pause")
    enabled.run(1.0)
    standing = enabled.firmware.joints_deg
    enabled.run(0.5)
    assert enabled.firmware.joints_deg == standing
    assert "held back" in enabled.read("teaching_message")
    enabled.click("plan_continue")
    enabled.run(0.5)
    assert enabled.firmware.joints_deg == standing
    enabled.hold_button("plan_continue")
    enabled.run(0.5)
    assert enabled.firmware.joints_deg != standing
    enabled.click("plan_clear_current")
    enabled.run(0.5)
    enabled.click("plan_clear_all")
    enabled.click("plan_abort")
    enabled.step()
    assert enabled.heard() == [plan(1), plan(1), plan(2), plan(3), plan(4), plan(6)]
    assert enabled.read("teaching_message") == ""


@ONE_IS_ENOUGH
def test_the_exit_steps_are_not_shown_to_an_arm_that_was_only_stopped(enabled):
    enabled.click("stop_button")
    enabled.run(0.3)
    assert isinstance(enabled.find("teaching_exit_steps"), TeachingExitSteps)
    assert not enabled.find("teaching_exit_steps").isVisible()
