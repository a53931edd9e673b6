"""The next step over all combinations of what an arm and its link can be in."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import replace
from datetime import datetime
from typing import Any

import pytest

from armui.arm.device import Device
from armui.arm.model_check import ModelFit
from armui.arm.other_hosts import OtherHosts, OtherTraffic
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, DriverSlow, Reading, Status
from armui.bus.link import BUS_DEAF, BUS_OFF
from armui.control.assessment import assess
from armui.control.authority import MET_MOVING, PART_FAILED, Authority
from armui.control.cell.cell_reasons import (
    CELL_HOLDING_NOT_CONFIRMED,
    CELL_NOT_CONFIRMED,
    CELL_NOT_READ,
)
from armui.control.cell.intrusion import AreaIntrusion
from armui.control.devices.teaching_phase import why_not_teach
from armui.control.events import Level
from armui.control.link.link_state import LinkState
from armui.control.link.offsets import OffsetFollower
from armui.control.motion.motion_command import Hold, Observation
from armui.control.operating_state import (
    BUSY,
    RUN_UNDER_WAY,
    Busy,
    OperatingState,
    OtherHostReport,
    StopState,
)
from armui.control.run.progress import OVER, RunPhase
from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN, SPEED_ZERO
from armui.control.safety.recovery_rules import _RULES, STEP_IN_VAIN, next_step
from armui.control.safety.recovery_steps import ARM_FAULTS, UNHINDERED, Action, Step, StepKind
from armui.control.safety.reference_status import ReferenceStatus
from armui.protocol.codes import ArmStatusCode, ControlMode, TeachingState
from armui.protocol.generation import Generation, PiperModel
from armui.ui import words
from tests.ui.arm_states import heard_six

NOW_S = 100.0
FALSE = (False,) * 6
JOINT_2 = (False, True, False, False, False, False)
UNKNOWN_CODE = 0x2F
OTHER_MODEL = ModelFit(PiperModel.PIPER, frozenset({PiperModel.PIPER_H}))

HEALTHY = DriverSlow(
    voltage_v=24.0,
    driver_temperature_c=30.0,
    motor_temperature_c=30.0,
    bus_current_a=0.0,
    undervoltage=False,
    motor_overtemperature=False,
    overcurrent=False,
    driver_overtemperature=False,
    driver_fault=False,
    enabled=True,
    sensor_fault=None,
    homed=None,
    collision_protection=False,
    stall_protection=False,
)
PROTECTIONS: tuple[dict[str, Any], ...] = (
    {},
    {"undervoltage": True},
    {"motor_overtemperature": True},
    {"driver_overtemperature": True},
    {"overcurrent": True},
    {"driver_fault": True},
    {"sensor_fault": True, "collision_protection": None, "stall_protection": None},  # generation 1
    {"collision_protection": True},
    {"stall_protection": True},
)
ENABLED = ((True,) * 6, FALSE, (True, False, True, True, True, True), (None, *(True,) * 5))
CONTROL_MODES = (*ControlMode, UNKNOWN_CODE)
STATUSES = (*ArmStatusCode, UNKNOWN_CODE)
FLAGS: tuple[dict[str, Any], ...] = (
    {},
    {"communication_fault": JOINT_2},
    {"limit_exceeded": JOINT_2},
)
POSES_DEG = ((0.0,) * 6, (0.0, 40.0, 0.0, 0.0, 0.0, 0.0))
STOPS = (
    # stop, unconfirmed, busy; how a stop stands while the arm's own status is not «stopped»
    (StopState.RUNNING, False, None),
    (StopState.REQUESTED, False, None),
    (StopState.REQUESTED, True, None),
    (StopState.RESUMING, False, Busy.RESUMING),
    (StopState.RUNNING, False, Busy.ENABLING),
    (StopState.RUNNING, False, Busy.DISABLING),
)


def status(**changes) -> Status:
    normal = Status(
        control_mode=ControlMode.CAN_CONTROL,
        arm_status=ArmStatusCode.NORMAL,
        move_mode=1,
        teaching=TeachingState.OFF,
        reached=True,
        speed_percent=None,
        trajectory_point=None,
        limit_exceeded=FALSE,
        communication_fault=FALSE,
    )
    return normal._replace(**changes)


def arm(heard: Status, enabled=ENABLED[0], protection=None, pose_deg=POSES_DEG[0]) -> ArmState:
    """An arm heard just now; joint 2 has the protection, ``None`` in enabled says nothing."""
    one, two, *others = (
        None if on is None else Reading(HEALTHY._replace(enabled=on), NOW_S) for on in enabled
    )
    if protection and two is not None:
        two = Reading(two.value._replace(**protection), NOW_S)
    three, four, five, six = others
    return ArmState(
        sequence=1,
        last_feedback_s=NOW_S,
        status=Reading(heard, NOW_S),
        joints_deg=heard_six(pose_deg, NOW_S),
        drivers_slow=(one, two, three, four, five, six),
    )


def operating_state(state: ArmState, link=LinkState.ONLINE, **changes) -> OperatingState:
    stopped = state.status is not None and state.status.value.arm_status == 1
    authority = changes.pop("authority", None) or Authority()
    traffic = changes.pop("traffic", OtherTraffic())
    authority.observe(
        Observation(state, traffic, (0,), link is LinkState.ONLINE, NOW_S, waiting=False)
    )
    if (reason := authority.other.why_not()) is not None:
        since = datetime(2026, 1, 2, 3, 4, 5).astimezone()
        changes["other_host"] = OtherHostReport("0x151", since, 200, reason, True)
    known = OperatingState(
        link=link,
        device=Device("virtual", "test"),
        link_problem=None,
        stop=StopState.STOPPED if stopped and link is LinkState.ONLINE else StopState.RUNNING,
        stop_unconfirmed=False,
        busy=None,
        speed_percent=30,
        generation=Generation.TWO,
    )
    offsets = changes.pop("offsets", None) or OffsetFollower()
    return assess(state, replace(known, **changes), authority, offsets, NOW_S)


def step_of(state: ArmState, **changes) -> Step:
    return next_step(state, operating_state(state, **changes), NOW_S)


def without_link() -> Iterator[tuple[ArmState, OperatingState]]:
    led = ArmState()._replace(foreign_targets_s=NOW_S)
    deaf = Refusal(BUS_DEAF, {"device": "can0", "count": "3"})
    now = operating_state(ArmState(), link=LinkState.OFFLINE)
    yield ArmState(), replace(now, link_problem=deaf)
    yield ArmState(), replace(now, link_problem=Refusal(BUS_OFF, {"device": "can0"}))
    # a picture from before, as old as it may be
    states = (ArmState(), led, arm(status()), arm(status(arm_status=ArmStatusCode.EMERGENCY_STOP)))
    for link, state, unconfirmed in itertools.product(LinkState, states, (False, True)):
        if link is LinkState.ONLINE:
            continue
        for stop in (StopState.RUNNING, StopState.REQUESTED):
            unheard = unconfirmed and stop is StopState.REQUESTED
            yield state, operating_state(state, link=link, stop=stop, stop_unconfirmed=unheard)
            if unheard:
                lapsed = {"stop_unconfirmed": True, "stop_lapsed": True}
                yield state, operating_state(state, link=link, stop=stop, **lapsed)


def online() -> Iterator[tuple[ArmState, OperatingState]]:
    told = itertools.product(CONTROL_MODES, STATUSES, (*TeachingState, UNKNOWN_CODE), FLAGS)
    for mode, code, teaching, flags in told:
        for reached in (True, False) if teaching in {3, 5, 7} else (True,):
            heard = status(
                control_mode=mode, arm_status=code, teaching=teaching, reached=reached, **flags
            )
            poses = POSES_DEG if mode == ControlMode.TEACHING else POSES_DEG[:1]
            for enabled, pose_deg in itertools.product(ENABLED, poses):
                state = arm(heard, enabled, None, pose_deg)
                yield state, operating_state(state)
    for code, protection, enabled in itertools.product(STATUSES, PROTECTIONS, ENABLED):
        for mode in CONTROL_MODES:
            state = arm(status(control_mode=mode, arm_status=code), enabled, protection)
            yield state, operating_state(state)
    for code, mode, enabled, (stop, unconfirmed, busy) in itertools.product(
        STATUSES, CONTROL_MODES, ENABLED, STOPS
    ):
        if stop is StopState.RUNNING and code == ArmStatusCode.EMERGENCY_STOP:
            continue
        state = arm(status(control_mode=mode, arm_status=code), enabled)
        yield state, operating_state(state, stop=stop, stop_unconfirmed=unconfirmed, busy=busy)
    stopped, keeps_input = arm(status(arm_status=ArmStatusCode.EMERGENCY_STOP)), OffsetFollower()
    keeps_input.keeps_input = True
    yield stopped, operating_state(stopped, stop=StopState.STOPPED, offsets=keeps_input)
    yield from in_company()
    yield from in_a_cell()
    yield from locked_otherwise()
    for enabled in ENABLED:
        yield arm(status(), enabled), operating_state(arm(status(), enabled), model_fit=OTHER_MODEL)
    state = arm(status())
    yield state, operating_state(state, below_base_mm=40)
    yield state, operating_state(state, below_lowest_mm=40)
    resting = arm(status(), pose_deg=(0.0, -2.0, 2.0, 0.0, 22.0, 0.0))
    yield resting, operating_state(resting)
    for generation in (None, *Generation):
        yield ArmState(last_feedback_s=NOW_S), operating_state(ArmState(), generation=generation)


def locked_otherwise() -> Iterator[tuple[ArmState, OperatingState]]:
    """Arms without a fault and with their motors on, of which nothing may move for one reason."""
    state = arm(status())
    yield state, operating_state(state, speed_percent=0)
    yield state, operating_state(state, altering="linkage")
    unproven = OffsetFollower()
    unproven.control_known = False
    yield state, operating_state(state, offsets=unproven)
    failed = Authority()
    failed.failed = True
    yield state, operating_state(state, authority=failed)
    joints_deg = (*state.joints_deg[:5], None)
    unheard = state._replace(joints_deg=joints_deg)
    yield unheard, operating_state(unheard)


def in_a_cell() -> Iterator[tuple[ArmState, OperatingState]]:
    """A cell not confirmed, its area entered; a reference in doubt or after a slip."""
    inside = AreaIntrusion("table", "gripper", 4)
    yield arm(status()), operating_state(arm(status()), intrusion=inside, keeps_area=True)
    for enabled, allowed, checking in itertools.product(ENABLED, (False, True), (False, True)):
        doubt = ReferenceStatus((2, 5), allowed, checking)
        yield arm(status(), enabled), operating_state(arm(status(), enabled), reference=doubt)
    for enabled in ENABLED:
        slip = ReferenceStatus(slipped="J1 -5.0°")
        yield arm(status(), enabled), operating_state(arm(status(), enabled), reference=slip)
    holding = CELL_HOLDING_NOT_CONFIRMED(name="bench", held="cube")
    for waits in (holding, CELL_NOT_CONFIRMED(name="bench"), CELL_NOT_READ(name="bench")):
        authority, state = Authority(), arm(status())
        authority.unconfirmed_cell = waits
        yield state, operating_state(state, authority=authority)


def in_company() -> Iterator[tuple[ArmState, OperatingState]]:
    """Other hosts, leaders, foreign modes, motions held back, a cancel that is not heeded."""
    streams = {
        "another host": [(0x155, bytes(8), 1)],
        "a leader": [(each, bytes(8), 40) for each in (0x151, 0x155, 0x156, 0x157, 0x159)],
        "MIT": [(0x151, bytes.fromhex("010400AD00000000"), 1)],
    }
    for stream in streams.values():
        hosts = OtherHosts()
        for arbitration_id, data, count in stream:
            for k in range(count):
                hosts.note(arbitration_id, data, NOW_S - 0.005 * (count - 1 - k))
        state = arm(status())
        yield state, operating_state(state, traffic=hosts.traffic())
    for hold in Hold:
        state, authority = arm(status(reached=False)), Authority()
        authority.holds = frozenset({hold})
        yield state, operating_state(state, authority=authority)
    state, authority = arm(status(reached=False)), Authority()
    authority.cancelled(NOW_S - 2.0)
    yield state, operating_state(state, authority=authority)
    for phase in set(RunPhase) - OVER:
        state = arm(status(reached=phase is not RunPhase.MOVING))
        yield state, operating_state(state, running=True, run_phase=phase)
    yield arm(status()), replace(operating_state(arm(status())), may_hold_another=True)
    device = Device("virtual", "test", listen_only=True)
    yield state, operating_state(state, device=device)


def is_valid(action: Action, state: ArmState, now: OperatingState) -> bool:
    """Whether the controller would take the action now."""
    commanded = {
        Action.STOP_RECORDING: TeachingState.STOP_RECORDING,
        Action.ABORT_REPLAY: TeachingState.ABORT,
        Action.LEAD_BY_HAND: TeachingState.START_RECORDING,
    }
    if action in commanded:
        return why_not_teach(now, commanded[action]) is None
    if action is Action.RESUME:
        return now.stop is StopState.STOPPED
    if action is Action.ENABLE:
        return now.cannot_enable is None and not all(now.enabled)
    if action is Action.LEAVE_TEACHING_INPUT:
        return now.link in {LinkState.OFFLINE, LinkState.ONLINE}
    if action in {Action.CLEAR_ERRORS, Action.STANDBY, Action.RESET}:
        return now.link is LinkState.ONLINE and now.busy is None
    if action is Action.WITHDRAW_STOP:
        return now.stop is StopState.REQUESTED
    if action is Action.TAKE_OVER:
        return now.other_host is not None and now.other_host.may_be_taken_over
    if action is Action.STOP:
        return now.stop is StopState.RUNNING
    return action in {Action.CONNECT, Action.CHECK_REFERENCE} or is_agreed_to(action, now)


def is_agreed_to(action: Action, now: OperatingState) -> bool:
    """Whether it agrees to something that waits for that, or ends what waits."""
    reference = now.reference
    if action in {Action.GO_ON, Action.GIVE_UP}:
        return bool(now.holds) or (action is Action.GIVE_UP and now.may_hold_another)
    if action is Action.COME_INSIDE:
        return now.outside != "" and now.cannot_move is None
    if action is Action.NOTED:
        return reference.slipped != ""
    if action is Action.ALLOW:
        return bool(reference.doubtful) and not (reference.allowed or reference.checking)
    asks_for_cell = action in {Action.CONFIRM_CELL, Action.LEAVE_CELL}
    return asks_for_cell and now.unconfirmed_cell is not None


WAITS = {
    # what goes on by itself, is the operator's at the arm, or wants another target
    *(
        StepKind.OPENING,
        StepKind.STOP_UNCONFIRMED,
        StepKind.STOP_REQUESTED,
        StepKind.WORKING,
        StepKind.HANDSHAKE,
        StepKind.NO_MOTION,
    ),
    *(StepKind.UNDERVOLTAGE, StepKind.OVERTEMPERATURE),
    *(
        StepKind.BEYOND_LIMIT,
        StepKind.TARGET_BEYOND_LIMIT,
        StepKind.NO_SOLUTION,
        StepKind.SINGULARITY,
    ),
    *UNHINDERED,
}


def test_every_combination_has_one_next_step_that_can_be_taken(qapp):
    seen: dict[tuple[StepKind, frozenset[str], bool], Step] = {}
    for state, now in itertools.chain(without_link(), online()):
        step = next_step(state, now, NOW_S)
        told = (step, state.status, now.link, now.stop)
        if step.action is None:
            assert step.kind in WAITS, told
        else:
            for action in step.actions:
                assert is_valid(action, state, now), told
            again = next_step(state, now, NOW_S, {step.kind: 2})
            assert again.kind is step.kind
            assert again.action is not None
            assert is_valid(again.action, state, now), told
        if step.kind in UNHINDERED:
            assert now.cannot_move in (None, RUN_UNDER_WAY()), told
        seen.setdefault((step.kind, frozenset(step.params), bool(step.joints)), step)
    assert {kind for kind, _, _ in seen} == set(StepKind)
    for step in seen.values():
        assert "—" not in words.step(step), step


@pytest.mark.parametrize("code", STATUSES)
def test_each_code_of_the_status_has_a_step_of_its_own(code):
    kinds = [step_of(arm(status(arm_status=each))).kind for each in STATUSES]
    assert kinds.count(kinds[STATUSES.index(code)]) == 1
    assert (kinds[STATUSES.index(code)] is StepKind.READY) is (code == ArmStatusCode.NORMAL)


@pytest.mark.parametrize(
    ("phase", "kind"),
    [
        (RunPhase.MOVING, StepKind.RUNNING),
        (RunPhase.DWELLING, StepKind.RUNNING),
        (RunPhase.WAITING, StepKind.RUN_WAITS),
        (RunPhase.PAUSED, StepKind.RUN_PAUSED),
        (RunPhase.STOPPING, StepKind.MOVING),
    ],
)
def test_a_run_is_not_called_ready(phase, kind):
    assert step_of(arm(status()), running=True, run_phase=phase).kind is kind
    # a fault is said first
    state = arm(status(arm_status=ArmStatusCode.SINGULARITY))
    assert step_of(state, running=True, run_phase=phase).kind is StepKind.SINGULARITY


def test_an_arm_on_its_way_is_not_called_ready():
    authority = Authority()
    state = arm(status(reached=False))
    assert not authority.at_rest
    met = step_of(state, authority=authority)  # by somebody before us: nothing of ours may move
    assert (met.kind, met.params) == (StepKind.NO_MOTION, {"reason": MET_MOVING()})
    ours = replace(operating_state(state), cannot_move=None)
    assert next_step(state, ours, NOW_S).kind is StepKind.MOVING


PRESENT_DANGERS = ARM_FAULTS | {
    StepKind.CANCEL_UNHEEDED,
    StepKind.LEADER_ARM,
    StepKind.OTHER_HOST,
}
DOUBTS = frozenset(
    {
        StepKind.CELL_UNREADABLE,
        StepKind.OTHER_MODE,
        StepKind.OTHER_CONTROL,
        StepKind.MOTORS_UNKNOWN,
        StepKind.MOTORS_MIXED,
        StepKind.PAUSED,
        StepKind.HELD_AT_ZERO,
        StepKind.REFERENCE_IN_DOUBT,
        StepKind.WRONG_MODEL,
    }
)
OFFERS_AFTER_THE_CELL = frozenset(
    {
        *(StepKind.MOTORS_OFF, StepKind.OUTSIDE),
        *(StepKind.RUN_PAUSED, StepKind.RUN_WAITS, StepKind.RUNNING),
        *(StepKind.MOVING, StepKind.READY),
    }
)
# a cell that is not confirmed is asked about before any doubt further down: nothing moves till then
OFFERS = OFFERS_AFTER_THE_CELL | {StepKind.CELL_HOLDING, StepKind.CELL_UNCONFIRMED}
OF_DRAG_TEACHING = frozenset({StepKind.RECORDING, StepKind.REPLAYING, StepKind.REPLAY_PAUSED})


@pytest.mark.parametrize(
    ("greater", "lesser"),
    [
        (PRESENT_DANGERS, DOUBTS),
        (PRESENT_DANGERS, OFFERS),
        (ARM_FAULTS | {StepKind.CANCEL_UNHEEDED}, OF_DRAG_TEACHING),
        (DOUBTS, OFFERS_AFTER_THE_CELL),
    ],
)
def test_danger_is_told_before_doubt_and_doubt_before_an_offer(greater, lesser):
    order = [rule.kind for rule in _RULES]
    last = max(place for place, kind in enumerate(order) if kind in greater)
    assert last < min(order.index(kind) for kind in lesser)


@pytest.mark.parametrize(
    "waits", [CELL_NOT_CONFIRMED(name="bench"), CELL_NOT_READ(name="bench")], ids=str
)
def test_who_moves_the_arm_is_told_before_the_cell_is_asked_about(waits):
    hosts, authority = OtherHosts(), Authority()
    hosts.note(0x155, bytes(8), NOW_S)
    authority.unconfirmed_cell = waits
    step = step_of(arm(status()), traffic=hosts.traffic(), authority=authority)
    assert step.kind is StepKind.OTHER_HOST


def test_a_reference_in_doubt_leaves_the_button_of_enabling_its_place():
    doubt = ReferenceStatus((2, 5), False, False)
    off = step_of(arm(status(), (False,) * 6), reference=doubt)
    assert (off.kind, off.action) == (StepKind.REFERENCE_IN_DOUBT, Action.ENABLE)
    assert off.alternative is Action.CHECK_REFERENCE
    on = step_of(arm(status()), reference=doubt)
    assert (on.kind, on.action) == (StepKind.REFERENCE_IN_DOUBT, Action.CHECK_REFERENCE)
    assert on.alternative is Action.ALLOW


def test_a_wrong_model_is_settled_before_the_motors_are_enabled(qapp):
    off = step_of(arm(status(), (False,) * 6), model_fit=OTHER_MODEL)
    assert (off.kind, off.action) == (StepKind.WRONG_MODEL, Action.CONNECT)
    assert off.alternative is Action.ENABLE
    assert words.step(off).startswith("Connected as a PiPER, but the pose it reports is that of a")
    on = step_of(arm(status()), model_fit=OTHER_MODEL)
    assert (on.kind, on.action, on.alternative) == (StepKind.WRONG_MODEL, Action.CONNECT, None)
    # no model of the family fits: another one would help nothing, moving the joints does
    unlike = OTHER_MODEL._replace(fitting=frozenset())
    assert step_of(arm(status(), FALSE), model_fit=unlike).kind is StepKind.MOTORS_OFF


def test_what_a_step_is_about_is_named():
    step = step_of(arm(status(arm_status=7), protection={"collision_protection": True}))
    assert (step.kind, step.joints, step.params) == (StepKind.COLLISION, (2,), {"joints": "2"})
    assert "joint 2" in words.step(step)
    step = step_of(arm(status(arm_status=7)))
    assert (step.kind, step.joints) == (StepKind.COLLISION, ())
    step = step_of(arm(status(control_mode=ControlMode.TEACHING), pose_deg=POSES_DEG[1]))
    assert step.params == {"joint": 2, "angle": 40.0, "near": "15"}


def test_the_line_tells_what_is_too_hot_how_hot_that_nothing_moves_and_what_to_do(qapp):
    hot = {"motor_overtemperature": True, "motor_temperature_c": 94.2}
    step = step_of(arm(status(arm_status=9), protection=hot))
    assert words.step(step) == (
        "Motion is locked: Too hot, joint 2: 94 °C. Let the arm cool down; the message goes by "
        "itself."
    )
    still_moves = step_of(arm(status(), protection=hot))
    assert words.step(still_moves).startswith("Too hot, joint 2: 94 °C.")


def test_the_line_tells_every_reason_that_locks_all_motion(qapp):
    """Those without a step of their own are told in their own words."""
    told = set()
    for state, now in locked_otherwise():
        step = next_step(state, now, NOW_S)
        assert now.cannot_move is not None
        assert step.kind in {StepKind.NO_MOTION, StepKind.STATUS_UNKNOWN}, now.cannot_move
        if step.kind is StepKind.NO_MOTION:
            assert words.step(step) == words.refusal(now.cannot_move)
            told.add(now.cannot_move.reason)
    assert told == {SPEED_ZERO, BUSY, CONTROL_OFFSET_UNKNOWN, PART_FAILED}


def test_what_was_tried_in_vain_leads_to_the_next_stronger_means():
    state = arm(status(arm_status=7), protection={"collision_protection": True})
    first, second = (
        next_step(state, operating_state(state), NOW_S, {StepKind.COLLISION: count})
        for count in (1, 2)
    )
    assert first.action is Action.CLEAR_ERRORS
    assert words.step(first).startswith("The arm did not react.")
    assert (second.action, second.failed) == (Action.RESET, STEP_IN_VAIN())
    assert second.dangerous


def test_an_old_status_is_no_status():
    state = arm(status())._replace(status=Reading(status(), NOW_S - 1.0))
    assert step_of(state).kind is StepKind.STATUS_UNKNOWN


def test_faults_are_red_and_what_can_wait_is_not():
    assert step_of(arm(status(communication_fault=JOINT_2))).level is Level.FAULT
    assert step_of(arm(status(), enabled=FALSE)).level is Level.INFO
    assert step_of(arm(status(arm_status=4))).level is Level.WARNING


def test_the_operator_is_asked_before_what_may_surprise() -> None:
    asked = {
        action for action in Action if Step(StepKind.READY, Level.DONE, action=action).dangerous
    }
    assert asked == {
        *(Action.RESUME, Action.RESET, Action.LEAD_BY_HAND),
        *(Action.LEAVE_MODE, Action.STANDBY, Action.WITHDRAW_STOP),
        *(Action.ALLOW, Action.LEAVE_CELL),
    }
    assert all(words.step_question(action) for action in asked)


def test_danger_is_said_before_power_is_cut(qapp):
    for action in (Action.RESUME, Action.RESET):
        assert "the arm will drop. Hold the arm" in words.step_danger(action)
    assert words.step_action(Action.RESET).endswith("…")
    assert "drops" in words.step_action(Action.RESUME)
