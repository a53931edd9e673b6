"""From every fault of the simulated arm back to a ready arm, by doing what the next step says."""

from __future__ import annotations

import pytest

from armui.control.recovery_steps import Action, Kind
from armui.control.situation import LinkState
from armui.protocol.codes import ControlMode, TeachingState
from armui.protocol.frame import Frame
from armui.sim.faults import FAULTS, fault
from tests.bench import Bench

REST_DEG = (0.0,) * 6
AWAY_DEG = (0.0, 40.0, -20.0, 0.0, 0.0, 0.0)
BEYOND = "0007A120 00000000"  # 500 deg

UNSEEN = {"corrupt-limits", "garbage", "lost-frames", "latency"}
"""They break the bus or a setting, and leave the arm as ready as it was."""


def step_of(bench: Bench):
    return bench.controller.recovery.step


def obey(bench: Bench, seconds: float = 30.0) -> list[Kind]:
    """Do what the line says until the arm is ready, as an operator with both hands would."""
    kinds: list[Kind] = []
    end_s = bench.time_s + seconds
    while step_of(bench).kind is not Kind.READY:
        assert bench.time_s < end_s, f"no way out: {kinds}, {bench.codes()[-8:]}"
        step = step_of(bench)
        if not kinds or kinds[-1] is not step.kind:
            kinds.append(step.kind)
        if step.kind is Kind.RECORDING and max(map(abs, bench.firmware.joints_deg)) > 1.0:
            bench.firmware.hand.lead_to(REST_DEG, speed_deg_s=40.0)
        elif bench.controller.recovery.why_not(step) is not None:
            pass  # its button is off, and says why
        elif step.action not in {None, Action.CONNECT} and not step.waiting:
            refusal = bench.controller.recovery.act(step)
            # the arm may have changed since the step was shown: then the next one is
            assert refusal is None or refusal.code == "step_gone", step
        bench.step()
    return kinds


def until(bench: Bench, kind: Kind) -> None:
    bench.run_until(lambda: step_of(bench).kind is kind)


def move(bench: Bench, angles_deg) -> None:
    assert bench.controller.motion.send_joints(angles_deg) is None
    bench.run_until(lambda: bench.firmware.joints_deg == pytest.approx(angles_deg))


@pytest.mark.parametrize("name", sorted(FAULTS))
def test_no_fault_is_a_dead_end(any_bench, name):
    bench = any_bench
    bench.ready()
    broken = fault(name)
    bench.node.faults.start(broken)
    if name == "stall":
        assert bench.controller.motion.send_joints((30.0, *REST_DEG[1:])) is None
    bench.run(1.0)
    if name not in UNSEEN:
        assert step_of(bench).kind is not Kind.READY
    bench.node.faults.end(broken)
    if "overtemperature" in name:  # cooling takes minutes
        drivers = bench.firmware.drivers
        drivers.motor_temperatures_c[0] = drivers.driver_temperatures_c[0] = 30.0
    obey(bench)
    assert bench.controller.situation.cannot_move is None
    if name != "corrupt-limits":  # joint settings mend those
        move(bench, (5.0, *REST_DEG[1:]))


def test_after_a_stop_resume_and_enable_lead_back(any_bench):
    bench = any_bench
    bench.ready()
    bench.controller.emergency_stop()
    until(bench, Kind.STOPPED)
    assert step_of(bench).dangerous
    assert obey(bench) == [Kind.STOPPED, Kind.MOTORS_OFF]


def test_a_collision_is_cleared_without_dropping_the_arm(any_bench):
    bench = any_bench
    bench.ready()
    push = fault("collision", 2)
    bench.node.faults.start(push)
    until(bench, Kind.COLLISION)
    assert step_of(bench).joints == ((2,) if int(bench.firmware.generation) == 2 else ())
    bench.node.faults.end(push)
    bench.run(0.1)
    assert obey(bench) == [Kind.COLLISION]
    assert bench.firmware.enabled == (True,) * 6


def test_a_fault_whose_cause_stays_is_said_to_stay_and_leads_to_a_reset(any_bench):
    bench = any_bench
    bench.ready()
    bench.node.faults.start(fault("collision", 2))
    until(bench, Kind.COLLISION)
    for action in (Action.CLEAR_ERRORS, Action.CLEAR_ERRORS, Action.RESET):
        step = step_of(bench)
        assert (step.kind, step.action) == (Kind.COLLISION, action)
        if action is Action.CLEAR_ERRORS:
            assert bench.controller.recovery.act(step) is None
            assert step_of(bench).waiting
            bench.run_until(lambda: not step_of(bench).waiting)
    assert step.failed is not None
    assert bench.codes()[-1] == "step_in_vain"


def test_a_step_that_has_passed_is_not_taken(bench):
    bench.connect()
    until(bench, Kind.MOTORS_OFF)
    enable = step_of(bench)
    bench.controller.emergency_stop()
    until(bench, Kind.STOPPED)
    bench.heard()
    assert bench.controller.recovery.act(enable).code == "step_gone"
    bench.run(0.2)
    assert Frame(0x471, bytes.fromhex("07 02 00 00 00 00 00 00")) not in bench.heard()


def test_a_step_under_way_is_not_taken_twice(bench):
    bench.connect()
    bench.node.faults.start(fault("overcurrent", 3))
    until(bench, Kind.OVERCURRENT)
    step = step_of(bench)
    assert bench.controller.recovery.act(step) is None
    assert bench.controller.recovery.act(step).code == "busy"


def test_an_arm_that_leads_becomes_a_motion_output_again(any_bench):
    bench = any_bench
    bench.firmware.on_frame(Frame(0x470, bytes.fromhex("FA 00 00 00")))
    bench.controller.connect_device(bench.device)
    until(bench, Kind.TEACHING_INPUT)
    assert bench.controller.recovery.act(step_of(bench)) is None
    bench.run_until(lambda: bench.controller.situation.link is LinkState.ONLINE)
    assert not bench.firmware.leads
    assert Kind.OFFLINE not in obey(bench)


def test_an_arm_that_goes_on_leading_is_said_to(bench):
    bench.firmware.on_frame(Frame(0x470, bytes.fromhex("FA 00 00 00")))
    bench.firmware.on_frame = lambda _frame: []  # deaf from now on
    bench.controller.connect_device(bench.device)
    until(bench, Kind.TEACHING_INPUT)
    assert bench.controller.recovery.act(step_of(bench)) is None
    bench.run_until(lambda: "step_in_vain" in bench.codes())
    assert step_of(bench).failed is not None
    assert not step_of(bench).waiting
    del bench.firmware.on_frame


def test_left_over_drag_teaching_far_from_rest_is_left_by_hand_and_reset(any_bench):
    bench = any_bench
    bench.ready()
    move(bench, AWAY_DEG)
    assert bench.controller.teaching.command(TeachingState.START_RECORDING) is None
    bench.run(0.5)
    assert bench.controller.teaching.command(TeachingState.STOP_RECORDING) is None
    until(bench, Kind.DRAG_MODE)
    kinds = obey(bench)
    assert kinds[:5] == [
        Kind.DRAG_MODE,
        Kind.RECORDING,
        Kind.DRAG_MODE_AT_REST,
        Kind.STOPPED,
        Kind.MOTORS_OFF,
    ]
    assert bench.firmware.control_mode is ControlMode.STANDBY


def test_drag_teaching_without_power_is_enabled_first(bench):
    bench.ready()
    move(bench, AWAY_DEG)
    bench.controller.teaching.command(TeachingState.START_RECORDING)
    bench.run(0.3)
    bench.controller.teaching.command(TeachingState.STOP_RECORDING)
    until(bench, Kind.DRAG_MODE)
    bench.controller.motors.disable()
    bench.run_until(lambda: "disabled" in bench.codes())
    bench.run(0.3)
    assert step_of(bench).kind is Kind.DRAG_MODE_WITHOUT_POWER
    obey(bench)


def test_dragging_too_fast_is_no_dead_end(bench):
    bench.ready()
    bench.controller.teaching.command(TeachingState.START_RECORDING)
    bench.run(0.1)
    bench.firmware.hand.push((0.0, 200.0, 0.0, 0.0, 0.0, 0.0))
    bench.run_until(lambda: not bench.firmware.body.gives_way)
    bench.firmware.hand.let_go()
    obey(bench)


@pytest.mark.parametrize("command", [TeachingState.RUN_RECORDING, TeachingState.PAUSE])
def test_a_replay_under_way_is_no_dead_end(bench, command):
    bench.ready()
    bench.controller.teaching.command(TeachingState.START_RECORDING)
    bench.run(0.1)
    bench.firmware.hand.lead_to(AWAY_DEG, speed_deg_s=20.0)
    bench.run(2.5)
    bench.controller.teaching.command(TeachingState.STOP_RECORDING)
    bench.run(0.2)
    bench.controller.teaching.command(TeachingState.RUN_RECORDING)
    bench.run_until(lambda: bench.firmware.status == 0x0C and bench.firmware.body.moving)
    bench.run(2.5)
    if command is TeachingState.PAUSE:
        bench.controller.teaching.command(command)
        until(bench, Kind.REPLAY_PAUSED)
    assert step_of(bench).action is Action.ABORT_REPLAY
    obey(bench)


@pytest.mark.parametrize("mode", [ControlMode.ETHERNET_CONTROL, ControlMode.REMOTE_CONTROL])
def test_the_command_is_taken_without_a_motion(any_bench, mode):
    bench = any_bench
    bench.ready()
    bench.firmware.condition.control_mode = mode
    until(bench, Kind.OTHER_CONTROL)
    bench.heard()
    assert bench.controller.recovery.act(step_of(bench)) is None
    obey(bench)
    assert bench.heard() == [Frame(0x151, bytes.fromhex("00 01 00 00 00 00 00 00"))]


def test_a_refused_target_wants_another(any_bench):
    bench = any_bench
    bench.ready()
    move(bench, (5.0, *REST_DEG[1:]))
    for target_id in (0x155, 0x156, 0x157):  # another host asks too much
        bench.firmware.on_frame(Frame(target_id, bytes.fromhex(BEYOND)))
    bench.run_until(lambda: step_of(bench).kind in {Kind.BEYOND_LIMIT, Kind.TARGET_BEYOND_LIMIT})
    assert step_of(bench).action is None
    move(bench, (6.0, *REST_DEG[1:]))
    until(bench, Kind.READY)


def test_power_comes_back_to_a_joint_and_no_motor_is_switched_on_unasked(bench):
    bench.ready()
    lost = fault("joint-communication", 4)
    bench.node.faults.start(lost)
    until(bench, Kind.COMMUNICATION)
    assert step_of(bench).joints == (4,)
    bench.heard()
    bench.node.faults.end(lost)
    until(bench, Kind.READY)
    assert bench.heard() == []


def test_connecting_and_leaving_is_followed(bench):
    assert step_of(bench).kind is Kind.NO_DEVICE
    steps = []
    bench.controller.step_changed.connect(steps.append)
    bench.connect()
    until(bench, Kind.MOTORS_OFF)
    bench.powered = False
    until(bench, Kind.OFFLINE)
    bench.controller.disconnect_device()
    assert step_of(bench).kind is Kind.NO_DEVICE
    assert [step.kind for step in steps if step.kind is not Kind.HANDSHAKE] == [
        Kind.OPENING,
        Kind.OFFLINE,
        Kind.MOTORS_OFF,
        Kind.OFFLINE,
        Kind.NO_DEVICE,
    ]
