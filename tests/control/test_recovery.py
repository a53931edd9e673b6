"""From every fault of the simulated arm back to a ready arm, by doing what the next step says."""

from __future__ import annotations

from typing import Any

import pytest

from armui.control.link.link_state import LinkState
from armui.control.operating_state import BUSY
from armui.control.safety.recovery import STEP_GONE
from armui.control.safety.recovery_rules import STEP_ANSWERED, STEP_IN_VAIN
from armui.control.safety.recovery_steps import Action, StepKind
from armui.protocol.codes import ControlMode, TeachingState
from armui.protocol.frame import Frame
from armui.sim.faults.schedule import FAULTS, fault
from tests.accepted import accepted
from tests.arm_rig import ArmRig

REST_DEG = (0.0,) * 6
AWAY_DEG = (0.0, 40.0, -20.0, 0.0, 0.0, 0.0)
BEYOND = "0007A120 00000000"  # 500 deg

UNSEEN = {"corrupt-limits", "garbage", "lost-frames", "latency", "stiff-joint", "hot-joint", "slip"}
"""They break the bus, a setting or a joint's ease, and leave the arm as ready as it was."""


def test_every_action_is_carried_out_here_or_opens_a_window(rig):
    windows = {Action.CONNECT, Action.CHECK_REFERENCE}
    assert rig.controller.recovery._acts.keys() == set(Action) - windows


def step_of(rig: ArmRig):
    return rig.controller.recovery.step


def obey(rig: ArmRig, seconds: float = 30.0) -> list[StepKind]:
    """Do what the line says until the arm is ready, as an operator with both hands would."""
    kinds: list[StepKind] = []
    end_s = rig.time_s + seconds
    while step_of(rig).kind is not StepKind.READY:
        assert rig.time_s < end_s, f"no way out: {kinds}, {rig.codes()[-8:]}"
        step = step_of(rig)
        if not kinds or kinds[-1] is not step.kind:
            kinds.append(step.kind)
        if step.kind is StepKind.RECORDING and max(map(abs, rig.firmware.joints_deg)) > 1.0:
            rig.firmware.hand_guiding.lead_to(REST_DEG, speed_deg_s=40.0)
        elif rig.controller.recovery.why_not(step) is not None:
            pass  # its button is off, and says why
        elif step.action is Action.CHECK_REFERENCE:
            check_reference(rig)
        elif step.action not in {None, Action.CONNECT} and not step.waiting:
            refusal = rig.controller.recovery.act(step)
            # the arm may have changed since the step was shown: then the next one is
            assert refusal is None or refusal.reason == STEP_GONE, step
        rig.step()
    return kinds


def check_reference(rig: ArmRig) -> None:
    """Reset the arm, and answer that each joint stands at its mark."""
    controller, reference = rig.controller, rig.controller.reference
    controller.emergency_stop()
    rig.run(1.0)
    accepted(controller.motors.resume())
    rig.run(1.0)
    accepted(reference.begin())
    reference.note_elsewhere(())
    for joint in range(1, 7):
        reference.answer(joint, 0.0)
    accepted(reference.finish())


def until(rig: ArmRig, kind: StepKind) -> None:
    rig.run_until(lambda: step_of(rig).kind is kind)


def move(rig: ArmRig, angles_deg) -> None:
    accepted(rig.controller.motion.send_joints(angles_deg))
    rig.run_until(lambda: rig.firmware.joints_deg == pytest.approx(angles_deg))


@pytest.mark.each_value(full="each fault in both generations")
@pytest.mark.parametrize("name", sorted(FAULTS))
def test_no_fault_is_a_dead_end(any_rig, name):
    rig = any_rig
    rig.ready()
    broken = fault(name)
    rig.node.faults.start(broken)
    if name == "lost-reference":  # just enabled, it may still have sunk
        rig.run(3.0)
        rig.node.faults.end(broken)
        rig.node.faults.start(broken)
    if name == "stall":
        accepted(rig.controller.motion.send_joints((30.0, *REST_DEG[1:])))
    rig.run(1.0)
    if name not in UNSEEN:
        assert step_of(rig).kind is not StepKind.READY
    rig.node.faults.end(broken)
    if "overtemperature" in name:  # cooling takes minutes
        drivers = rig.firmware.drivers
        drivers.motor_temperatures_c[0] = drivers.driver_temperatures_c[0] = 30.0
    obey(rig)
    assert rig.controller.operating_state.cannot_move is None
    if name != "corrupt-limits":  # joint settings mend those
        move(rig, (5.0, *REST_DEG[1:]))


def test_after_a_stop_resume_and_enable_lead_back(any_rig):
    rig = any_rig
    rig.ready()
    rig.controller.emergency_stop()
    until(rig, StepKind.STOPPED)
    assert step_of(rig).dangerous
    assert obey(rig) == [StepKind.STOPPED, StepKind.MOTORS_OFF]


def test_a_collision_is_cleared_without_dropping_the_arm(any_rig):
    rig = any_rig
    rig.ready()
    push = fault("collision", 2)
    rig.node.faults.start(push)
    until(rig, StepKind.COLLISION)
    assert step_of(rig).joints == ((2,) if int(rig.firmware.generation) == 2 else ())
    rig.node.faults.end(push)
    rig.run(0.1)
    assert obey(rig) == [StepKind.COLLISION]
    assert rig.firmware.enabled == (True,) * 6


def test_only_an_arm_that_answers_no_clearing_is_to_be_reset(any_rig):
    """A reset drops the arm and takes no cause away."""
    rig = any_rig
    rig.ready()
    rig.node.faults.start(fault("collision", 2))
    until(rig, StepKind.COLLISION)

    def outcome_of_clearing():
        step = step_of(rig)
        assert (step.kind, step.action) == (StepKind.COLLISION, Action.CLEAR_ERRORS)
        assert rig.controller.recovery.act(step) is None
        assert step_of(rig).waiting
        rig.run_until(lambda: not step_of(rig).waiting)
        return step_of(rig).failed

    assert [outcome_of_clearing() for _ in range(3)] == [STEP_ANSWERED()] * 3
    assert rig.codes()[-1] == "clear_error_answered"
    assert step_of(rig).alternative is Action.RESET, "no dead end, where the arm keeps its fault"
    hears = rig.firmware.on_frame
    rig.firmware.on_frame = lambda frame: [] if frame.arbitration_id == 0x475 else hears(frame)
    assert [outcome_of_clearing() for _ in range(2)] == [STEP_IN_VAIN()] * 2
    assert rig.codes()[-1] == "step_in_vain"
    assert step_of(rig).action is Action.RESET
    del rig.firmware.on_frame


def test_a_step_that_has_passed_is_not_taken(rig):
    rig.connect()
    until(rig, StepKind.MOTORS_OFF)
    enable = step_of(rig)
    rig.controller.emergency_stop()
    until(rig, StepKind.STOPPED)
    rig.heard()
    assert rig.controller.recovery.act(enable).reason == STEP_GONE
    rig.run(0.2)
    assert Frame(0x471, bytes.fromhex("07 02 00 00 00 00 00 00")) not in rig.heard()


def test_a_step_under_way_is_not_taken_twice(rig):
    rig.connect()
    rig.node.faults.start(fault("overcurrent", 3))
    until(rig, StepKind.OVERCURRENT)
    step = step_of(rig)
    assert rig.controller.recovery.act(step) is None
    assert rig.controller.recovery.act(step).reason == BUSY


def test_an_arm_that_leads_becomes_a_motion_output_again(any_rig):
    rig = any_rig
    rig.firmware.on_frame(Frame(0x470, bytes.fromhex("FA 00 00 00")))
    rig.controller.connect_device(rig.device)
    until(rig, StepKind.TEACHING_INPUT)
    assert rig.controller.recovery.act(step_of(rig)) is None
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.ONLINE)
    assert not rig.firmware.leads
    assert StepKind.OFFLINE not in obey(rig)


def test_an_arm_that_goes_on_leading_is_said_to(rig):
    rig.firmware.on_frame(Frame(0x470, bytes.fromhex("FA 00 00 00")))
    rig.firmware.on_frame = lambda _frame: []  # deaf from now on
    rig.controller.connect_device(rig.device)
    until(rig, StepKind.TEACHING_INPUT)
    assert rig.controller.recovery.act(step_of(rig)) is None
    rig.run_until(lambda: "step_in_vain" in rig.codes())
    assert step_of(rig).failed is not None
    assert not step_of(rig).waiting
    del rig.firmware.on_frame


def test_left_over_drag_teaching_far_from_rest_is_left_by_hand_and_reset(any_rig):
    rig = any_rig
    rig.ready()
    move(rig, AWAY_DEG)
    accepted(rig.controller.teaching.command(TeachingState.START_RECORDING))
    rig.run(0.5)
    accepted(rig.controller.teaching.command(TeachingState.STOP_RECORDING))
    until(rig, StepKind.DRAG_MODE)
    kinds = obey(rig)
    assert kinds[:4] == [
        StepKind.DRAG_MODE,
        StepKind.RECORDING,
        StepKind.DRAG_MODE_AT_REST,
        StepKind.STOPPED,
    ]
    # while the arm drops each moment is told, also that in which only some motors are off
    assert kinds[4] in {StepKind.MOTORS_OFF, StepKind.MOTORS_MIXED}
    assert rig.firmware.condition.control_mode is ControlMode.STANDBY


def test_drag_teaching_without_power_is_enabled_first(rig):
    rig.ready()
    move(rig, AWAY_DEG)
    rig.controller.teaching.command(TeachingState.START_RECORDING)
    rig.run(0.3)
    rig.controller.teaching.command(TeachingState.STOP_RECORDING)
    until(rig, StepKind.DRAG_MODE)
    rig.controller.motors.disable()
    rig.run_until(lambda: "disabled" in rig.codes())
    rig.run(0.3)
    assert step_of(rig).kind is StepKind.DRAG_MODE_WITHOUT_POWER
    obey(rig)


def test_dragging_too_fast_is_no_dead_end(rig):
    rig.ready()
    rig.controller.teaching.command(TeachingState.START_RECORDING)
    rig.run(0.1)
    rig.firmware.hand_guiding.push((0.0, 200.0, 0.0, 0.0, 0.0, 0.0))
    rig.run_until(lambda: not rig.firmware.mechanics.gives_way)
    rig.firmware.hand_guiding.release()
    obey(rig)


@pytest.mark.parametrize("command", [TeachingState.RUN_RECORDING, TeachingState.PAUSE])
def test_a_replay_under_way_is_no_dead_end(rig, command):
    rig.ready()
    rig.controller.teaching.command(TeachingState.START_RECORDING)
    rig.run(0.1)
    rig.firmware.hand_guiding.lead_to(AWAY_DEG, speed_deg_s=20.0)
    rig.run(2.5)
    rig.controller.teaching.command(TeachingState.STOP_RECORDING)
    rig.run(0.2)
    rig.controller.teaching.command(TeachingState.RUN_RECORDING)
    rig.run_until(lambda: rig.firmware.condition.status == 0x0C and rig.firmware.mechanics.moving)
    rig.run(2.5)
    if command is TeachingState.PAUSE:
        rig.controller.teaching.command(command)
        until(rig, StepKind.REPLAY_PAUSED)
    assert step_of(rig).action is Action.ABORT_REPLAY
    obey(rig)


@pytest.mark.parametrize("mode", [ControlMode.ETHERNET_CONTROL, ControlMode.REMOTE_CONTROL])
def test_the_command_is_taken_without_a_motion(any_rig, mode):
    rig = any_rig
    rig.ready()
    rig.firmware.condition.control_mode = mode
    until(rig, StepKind.OTHER_CONTROL)
    rig.heard()
    assert rig.controller.recovery.act(step_of(rig)) is None
    obey(rig)
    assert rig.heard() == [Frame(0x151, bytes.fromhex("00 01 00 00 00 00 00 00"))]


def test_a_refused_target_wants_another(any_rig):
    rig = any_rig
    rig.ready()
    move(rig, (5.0, *REST_DEG[1:]))
    for target_id in (0x155, 0x156, 0x157):  # another host asks too much
        rig.firmware.on_frame(Frame(target_id, bytes.fromhex(BEYOND)))
    rig.run_until(
        lambda: step_of(rig).kind in {StepKind.BEYOND_LIMIT, StepKind.TARGET_BEYOND_LIMIT}
    )
    assert step_of(rig).action is None
    move(rig, (6.0, *REST_DEG[1:]))
    until(rig, StepKind.READY)


def test_power_comes_back_to_a_joint_and_no_motor_is_switched_on_unasked(rig):
    rig.ready()
    lost = fault("joint-communication", 4)
    rig.node.faults.start(lost)
    until(rig, StepKind.COMMUNICATION)
    assert step_of(rig).joints == (4,)
    rig.heard()
    rig.node.faults.end(lost)
    until(rig, StepKind.READY)
    assert rig.heard() == []


def test_connecting_and_leaving_is_followed(rig):
    assert step_of(rig).kind is StepKind.NO_DEVICE
    steps: list[Any] = []
    rig.controller.step_changed.connect(steps.append)
    rig.connect()
    until(rig, StepKind.MOTORS_OFF)
    rig.powered = False
    until(rig, StepKind.OFFLINE)
    rig.controller.disconnect_device()
    assert step_of(rig).kind is StepKind.NO_DEVICE
    assert [step.kind for step in steps if step.kind is not StepKind.HANDSHAKE] == [
        StepKind.OPENING,
        StepKind.OFFLINE,
        StepKind.MOTORS_OFF,
        StepKind.OFFLINE,
        StepKind.NO_DEVICE,
    ]
