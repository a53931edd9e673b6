"""The rules for the next step of recovery: pure, a table read from top to bottom.

A higher row must be settled before a lower one can be: without a link nothing else matters, a stop
hides every other fault, a driver with a fault keeps its motor off, motors without power cannot be
moved out of a limit. Rows that could be settled in any order are sorted by weight: danger, then
doubt, then offers.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from armui.arm.refusal import Reason
from armui.arm.state import ArmState, is_fresh
from armui.control.cell.cell_reasons import (
    CELL_HOLDING_NOT_CONFIRMED,
    CELL_NOT_CONFIRMED,
    CELL_NOT_READ,
)
from armui.control.devices.teaching_phase import TeachingPhase
from armui.control.events import Level
from armui.control.link.link_state import LinkState
from armui.control.motion.motion_command import Hold
from armui.control.operating_state import OperatingState, StopState
from armui.control.run.progress import RunPhase
from armui.control.safety.other_command import LEADER_ARM, OTHER_HOST
from armui.control.safety.recovery_conditions import (
    Applies,
    RecoveryView,
    adapter_is,
    cell_waits,
    drivers,
    far_from_rest,
    has_code,
    held_back,
    in_area,
    in_phase,
    is_teaching_input,
    joints_flagged,
    link_is,
    motors_mixed,
    moves,
    near_rest,
    not_heard,
    other_control,
    other_host_is,
    other_mode,
    other_mode_that_ends,
    other_model,
    otherwise_locked,
    outside,
    overspeed,
    reference_in_doubt,
    run_is,
    slipped,
    status_flags,
    stop_lapsed_away,
    stop_waits,
    too_hot,
    too_low,
    unknown_status,
    when,
    when_now,
    when_off,
    working,
)
from armui.control.safety.recovery_steps import Action, Step, StepKind
from armui.protocol.codes import ArmStatusCode

STEP_IN_VAIN = Reason("step_in_vain", "The arm did not react.")
STEP_ANSWERED = Reason("step_answered", "The arm has answered, but the fault is still there.")


_IN_VAIN_TWICE: Final = 2
"""The gentle action gets a second try; after that a stronger one is offered."""


@dataclass(frozen=True, slots=True)
class _Rule:
    kind: StepKind
    level: Level
    action: Action | None
    applies: Applies
    escalation: Action | None = None
    """The action offered once the arm did not react to the usual one twice."""
    alternative: Action | None = None
    """The action of a second button."""


def next_step(
    state: ArmState,
    operating_state: OperatingState,
    now_s: float,
    in_vain: Mapping[StepKind, int] | None = None,
) -> Step:
    """Return the one next step.

    Args:
        state: The arm as last heard.
        operating_state: The operating state, assessed from the same state.
        now_s: Monotonic time.
        in_vain: The number of times that the arm did not react to the action against the present
            problem; 0 if it has answered, though the problem stays.
    """
    heard = state.status
    view = RecoveryView(
        state,
        operating_state,
        heard.value if heard is not None and heard.fresh(now_s) else None,
        tuple(
            [
                each.value if each is not None and is_fresh(each.at_s, now_s) else None
                for each in state.drivers_slow
            ]
        ),
    )
    for rule in _RULES:
        params = rule.applies(view)
        if params is not None:
            break
    failures = (in_vain or {}).get(rule.kind)
    stronger = (failures or 0) >= _IN_VAIN_TWICE and rule.escalation is not None
    failed = STEP_IN_VAIN() if failures else STEP_ANSWERED()
    joints = params.get("numbers", ()) if params else ()
    motion = operating_state.uncommanded
    warns = motion is not None and motion.is_danger and rule.level is not Level.FAULT
    return Step(
        rule.kind,
        Level.WARNING if warns else rule.level,
        {name: value for name, value in (params or {}).items() if name != "numbers"},
        rule.escalation if stronger else rule.action,
        joints if isinstance(joints, tuple) else (),
        failed=None if failures is None else failed,
        # If the arm answered but keeps its fault, the stronger action is only the alternative.
        alternative=rule.escalation if failures == 0 else rule.alternative,
        motion=motion,
        locked=operating_state.cannot_move is not None,
    )


def _latched(kind: StepKind, applies: Applies) -> _Rule:
    """Return the rule of a fault that stays until it is cleared."""
    return _Rule(kind, Level.FAULT, Action.CLEAR_ERRORS, applies, escalation=Action.RESET)


def _reset(kind: StepKind, applies: Applies) -> _Rule:
    """Return the rule of a fault that only a reset ends."""
    return _Rule(kind, Level.FAULT, Action.RESET, applies)


_RULES: Final = (
    _Rule(StepKind.STOP_LAPSED_AWAY, Level.FAULT, Action.CONNECT, when(stop_lapsed_away)),
    _Rule(StepKind.STOP_WAITS_FOR_DEVICE, Level.FAULT, Action.CONNECT, when(stop_waits)),
    _Rule(StepKind.NO_DEVICE, Level.INFO, Action.CONNECT, link_is(LinkState.NO_DEVICE)),
    _Rule(StepKind.OPENING, Level.INFO, None, link_is(LinkState.OPENING)),
    _Rule(StepKind.DEVICE_LOST, Level.FAULT, Action.CONNECT, link_is(LinkState.LOST)),
    _Rule(
        StepKind.STOP_LAPSED,
        Level.FAULT,
        Action.WITHDRAW_STOP,
        when_now(lambda now: now.stop_lapsed),
    ),
    # An arm that is a teaching input obeys only the command that ends this role, neither stop nor
    # resume: so this step comes before theirs.
    _Rule(
        StepKind.TEACHING_INPUT, Level.WARNING, Action.LEAVE_TEACHING_INPUT, when(is_teaching_input)
    ),
    _Rule(StepKind.STOP_UNCONFIRMED, Level.FAULT, None, when_now(lambda now: now.stop_unconfirmed)),
    _Rule(
        StepKind.STOP_REQUESTED,
        Level.WARNING,
        None,
        when_now(lambda now: now.stop is StopState.REQUESTED),
    ),
    _Rule(StepKind.DEAF, Level.FAULT, Action.CONNECT, adapter_is("bus_deaf")),
    _Rule(StepKind.BUS_OFF, Level.FAULT, Action.CONNECT, adapter_is("bus_off")),
    _Rule(StepKind.OFFLINE, Level.WARNING, Action.CONNECT, link_is(LinkState.OFFLINE)),
    _Rule(StepKind.LISTEN_ONLY, Level.INFO, Action.CONNECT, when_now(lambda now: now.listens_only)),
    _Rule(StepKind.WORKING, Level.INFO, None, working),
    _Rule(
        StepKind.STOPPED_INPUT,
        Level.WARNING,
        Action.RESUME,
        when_now(lambda now: now.stop is StopState.STOPPED and now.becomes_input),
    ),
    _Rule(
        StepKind.STOPPED,
        Level.WARNING,
        Action.RESUME,
        when_now(lambda now: now.stop is StopState.STOPPED),
    ),
    _Rule(StepKind.HANDSHAKE, Level.INFO, None, when_now(lambda now: now.generation is None)),
    _Rule(StepKind.STATUS_UNKNOWN, Level.WARNING, Action.CONNECT, when(not_heard)),
    _Rule(
        StepKind.COMMUNICATION,
        Level.FAULT,
        Action.RESET,
        joints_flagged(
            status_flags(lambda status: status.communication_fault),
            ArmStatusCode.JOINT_COMMUNICATION_FAULT,
        ),
    ),
    _latched(
        StepKind.COLLISION,
        joints_flagged(drivers(lambda each: each.collision_protection), ArmStatusCode.COLLISION),
    ),
    _latched(StepKind.DRIVER_FAULT, joints_flagged(drivers(lambda each: each.driver_fault))),
    _latched(StepKind.OVERCURRENT, joints_flagged(drivers(lambda each: each.overcurrent))),
    _latched(StepKind.STALL, joints_flagged(drivers(lambda each: each.stall_protection))),
    _latched(StepKind.SENSOR, joints_flagged(drivers(lambda each: each.sensor_fault))),
    # These two flags report the present value and clear by themselves with their cause: there is
    # nothing to reset.
    _Rule(
        StepKind.UNDERVOLTAGE,
        Level.FAULT,
        None,
        joints_flagged(drivers(lambda each: each.undervoltage)),
    ),
    _Rule(StepKind.OVERTEMPERATURE, Level.FAULT, None, too_hot),
    _latched(StepKind.JOINT_STATUS, has_code(ArmStatusCode.JOINT_STATUS_ABNORMAL)),
    _reset(StepKind.BRAKE_CLOSED, has_code(ArmStatusCode.JOINT_BRAKE_CLOSED)),
    _reset(StepKind.CONTROLLER_HOT, has_code(ArmStatusCode.MAIN_CONTROLLER_TOO_HOT)),
    _reset(StepKind.RESISTOR_HOT, has_code(ArmStatusCode.BRAKE_RESISTOR_TOO_HOT)),
    _reset(StepKind.OTHER_FAULT, has_code(ArmStatusCode.OTHER_FAULT)),
    _reset(StepKind.UNKNOWN_STATUS, unknown_status),
    _Rule(
        StepKind.CANCEL_UNHEEDED,
        Level.FAULT,
        Action.STOP,
        when_now(lambda now: now.cancel_unheeded),
    ),
    _Rule(StepKind.RECORDING, Level.INFO, Action.STOP_RECORDING, in_phase(TeachingPhase.RECORDING)),
    _Rule(StepKind.REPLAYING, Level.INFO, Action.ABORT_REPLAY, in_phase(TeachingPhase.REPLAYING)),
    _Rule(StepKind.REPLAY_PAUSED, Level.INFO, Action.ABORT_REPLAY, in_phase(TeachingPhase.PAUSED)),
    # Who moves the arm is told before the cell is asked about; taking over moves nothing.
    _Rule(StepKind.LEADER_ARM, Level.WARNING, Action.TAKE_OVER, other_host_is(LEADER_ARM)),
    _Rule(StepKind.OTHER_HOST, Level.WARNING, Action.TAKE_OVER, other_host_is(OTHER_HOST)),
    # Until the cell is settled nothing of ours moves the arm, and steps further down may move it.
    _Rule(StepKind.CELL_UNREADABLE, Level.WARNING, Action.LEAVE_CELL, cell_waits(CELL_NOT_READ)),
    _Rule(
        StepKind.CELL_HOLDING,
        Level.INFO,
        Action.CONFIRM_CELL,
        cell_waits(CELL_HOLDING_NOT_CONFIRMED),
    ),
    _Rule(
        StepKind.CELL_UNCONFIRMED, Level.INFO, Action.CONFIRM_CELL, cell_waits(CELL_NOT_CONFIRMED)
    ),
    _Rule(StepKind.OTHER_MODE, Level.WARNING, Action.LEAVE_MODE, other_mode_that_ends),
    _Rule(StepKind.OTHER_MODE, Level.WARNING, Action.RESET, other_mode),
    _Rule(StepKind.OTHER_CONTROL, Level.WARNING, Action.STANDBY, other_control),
    _Rule(
        StepKind.MOTORS_UNKNOWN,
        Level.WARNING,
        Action.CONNECT,
        joints_flagged(lambda view: [each is None for each in view.operating_state.enabled]),
    ),
    # Drag teaching ends with a reset, which is offered only near the rest pose: elsewhere the arm
    # is enabled, then led there by hand.
    _Rule(StepKind.DRAG_MODE_AT_REST, Level.WARNING, Action.RESET, when(near_rest)),
    _Rule(
        StepKind.DRAG_MODE_WITHOUT_POWER,
        Level.WARNING,
        Action.ENABLE,
        far_from_rest(lambda view: not view.enabled),
    ),
    _Rule(
        StepKind.OVERSPEED,
        Level.WARNING,
        Action.LEAD_BY_HAND,
        far_from_rest(lambda view: overspeed(view) is not None),
    ),
    _Rule(
        StepKind.DRAG_MODE, Level.WARNING, Action.LEAD_BY_HAND, far_from_rest(lambda _view: True)
    ),
    _Rule(StepKind.OVERSPEED_REPORTED, Level.FAULT, Action.RESET, overspeed),
    _Rule(StepKind.MOTORS_MIXED, Level.WARNING, Action.ENABLE, joints_flagged(motors_mixed)),
    _Rule(
        StepKind.PAUSED,
        Level.WARNING,
        Action.GO_ON,
        held_back(Hold.PAUSE),
        alternative=Action.GIVE_UP,
    ),
    _Rule(
        StepKind.HELD_AT_ZERO,
        Level.WARNING,
        Action.GO_ON,
        held_back(Hold.SPEED_ZERO),
        alternative=Action.GIVE_UP,
    ),
    _Rule(
        StepKind.REFERENCE_CHECK,
        Level.WARNING,
        Action.CHECK_REFERENCE,
        when_now(lambda now: now.reference.checking),
    ),
    # Connected as another model nothing is computed rightly; without power joints cannot be moved.
    _Rule(
        StepKind.WRONG_MODEL,
        Level.WARNING,
        Action.CONNECT,
        when_off(other_model),
        alternative=Action.ENABLE,
    ),
    _Rule(StepKind.WRONG_MODEL, Level.WARNING, Action.CONNECT, other_model),
    # Enabling keeps its button: neither check nor agreement is of use to motors without power.
    _Rule(
        StepKind.REFERENCE_IN_DOUBT,
        Level.WARNING,
        Action.ENABLE,
        when_off(reference_in_doubt(agreed=False)),
        alternative=Action.CHECK_REFERENCE,
    ),
    _Rule(
        StepKind.REFERENCE_IN_DOUBT,
        Level.WARNING,
        Action.CHECK_REFERENCE,
        reference_in_doubt(agreed=False),
        alternative=Action.ALLOW,
    ),
    _Rule(
        StepKind.SLIPPED,
        Level.WARNING,
        Action.ENABLE,
        when_off(slipped),
        alternative=Action.CHECK_REFERENCE,
    ),
    _Rule(StepKind.MOTORS_OFF, Level.INFO, Action.ENABLE, when(lambda view: not view.enabled)),
    _Rule(StepKind.NO_MOTION, Level.WARNING, None, otherwise_locked),
    _Rule(StepKind.OUTSIDE, Level.WARNING, Action.COME_INSIDE, outside),
    # a target was refused; the arm stands where it was and takes the next
    _Rule(
        StepKind.BEYOND_LIMIT,
        Level.WARNING,
        None,
        joints_flagged(status_flags(lambda status: status.limit_exceeded)),
    ),
    _Rule(
        StepKind.TARGET_BEYOND_LIMIT,
        Level.WARNING,
        None,
        has_code(ArmStatusCode.TARGET_BEYOND_LIMIT),
    ),
    _Rule(StepKind.NO_SOLUTION, Level.WARNING, None, has_code(ArmStatusCode.NO_SOLUTION)),
    _Rule(StepKind.SINGULARITY, Level.WARNING, None, has_code(ArmStatusCode.SINGULARITY)),
    _Rule(StepKind.RUN_PAUSED, Level.WARNING, None, run_is(RunPhase.PAUSED)),
    _Rule(StepKind.RUN_WAITS, Level.INFO, None, run_is(RunPhase.WAITING)),
    _Rule(StepKind.RUNNING, Level.INFO, None, run_is(RunPhase.MOVING, RunPhase.DWELLING)),
    _Rule(StepKind.IN_AREA, Level.WARNING, None, in_area),
    _Rule(
        StepKind.REFERENCE_AGREED,
        Level.WARNING,
        Action.CHECK_REFERENCE,
        reference_in_doubt(agreed=True),
    ),
    _Rule(
        StepKind.SLIPPED,
        Level.WARNING,
        Action.CHECK_REFERENCE,
        slipped,
        alternative=Action.NOTED,
    ),
    _Rule(StepKind.BELOW_LOWEST, Level.WARNING, None, too_low(lambda now: now.below_lowest_mm)),
    _Rule(StepKind.BELOW_BASE, Level.WARNING, None, too_low(lambda now: now.below_base_mm)),
    _Rule(StepKind.MOVING, Level.INFO, None, when(moves)),
    _Rule(
        StepKind.LEFT_HELD_BACK,
        Level.WARNING,
        Action.GIVE_UP,
        when_now(lambda now: now.may_hold_another),
    ),
    _Rule(StepKind.READY, Level.DONE, None, when(lambda _view: True)),
)
