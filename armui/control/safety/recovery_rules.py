"""The next valid step towards an arm that may be moved: pure, a table read from top to bottom.

What stands higher must be settled before what stands lower can be: without a link nothing else
matters, a stop hides every other fault, a driver with a fault keeps its motor off, motors without
power cannot be moved out of a limit.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

from armui.arm.limits import JOINTS
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, DriverSlow, Status
from armui.control.devices.teaching_phase import (
    NEAR_REST_DEG,
    TeachingPhase,
    farthest_from_rest,
    phase_of,
)
from armui.control.motion.motion_command import Hold
from armui.control.operating_state import Level, LinkState, OperatingState, StopState
from armui.control.safety import interlocks
from armui.control.safety.recovery_steps import Action, Params, Step, StepKind
from armui.protocol.codes import ArmStatusCode, ControlMode

_NONE: Final[Params] = {}
_IN_VAIN_TWICE: Final = 2
"""The gentle action is worth a second try, with the cause gone; then a stronger one is offered."""


@dataclass(frozen=True, slots=True)
class _View:
    """What the rules look at: only what is heard of late counts."""

    state: ArmState
    operating_state: OperatingState
    status: Status | None
    drivers: tuple[DriverSlow | None, ...]

    @property
    def code(self) -> int | None:
        return None if self.status is None else self.status.arm_status

    @property
    def phase(self) -> TeachingPhase:
        return TeachingPhase.OFF if self.status is None else phase_of(self.status)

    @property
    def in_drag_mode(self) -> bool:
        return self.status is not None and self.status.control_mode == ControlMode.TEACHING

    @property
    def enabled(self) -> bool:
        return all(self.operating_state.enabled)


_Applies = Callable[[_View], Params | None]
"""The figures of a rule's sentence if the rule applies, else ``None``."""


@dataclass(frozen=True, slots=True)
class _Rule:
    kind: StepKind
    level: Level
    action: Action | None
    applies: _Applies
    escalation: Action | None = None
    """What to offer once the action has come to nothing twice."""
    alternative: Action | None = None
    """What a second button does."""


def next_step(
    state: ArmState,
    operating_state: OperatingState,
    now_s: float,
    in_vain: Mapping[StepKind, int] | None = None,
) -> Step:
    """The one next step.

    Args:
        state: The arm as last heard.
        operating_state: What the operator can do, assessed from the same state.
        now_s: Monotonic time.
        in_vain: How often the action against the present trouble came to nothing.
    """
    heard = state.status
    view = _View(
        state,
        operating_state,
        heard.value if heard is not None and heard.fresh(now_s) else None,
        tuple(
            each.value if each is not None and each.fresh(now_s) else None
            for each in state.drivers_slow
        ),
    )
    for rule in _RULES:
        params = rule.applies(view)
        if params is not None:
            break
    failures = (in_vain or {}).get(rule.kind, 0)
    stronger = failures >= _IN_VAIN_TWICE and rule.escalation is not None
    joints = params.get("numbers", ()) if params else ()
    return Step(
        rule.kind,
        rule.level,
        {name: value for name, value in (params or {}).items() if name != "numbers"},
        rule.escalation if stronger else rule.action,
        joints if isinstance(joints, tuple) else (),
        failed=Refusal("step_in_vain") if failures else None,
        alternative=rule.alternative,
    )


# What the rules ask -------------------------------------------------------------------------------


def _when(condition: Callable[[_View], bool]) -> _Applies:
    return lambda view: _NONE if condition(view) else None


def _link(link: LinkState) -> _Applies:
    return _when(lambda view: view.operating_state.link is link)


def _code(code: ArmStatusCode) -> _Applies:
    return _when(lambda view: view.code == code)


def _phase(phase: TeachingPhase) -> _Applies:
    return _when(lambda view: view.phase is phase)


def _joints(flagged: Callable[[_View], list[bool]], code: ArmStatusCode | None = None) -> _Applies:
    """Some joints are flagged, or the arm's status says so without naming one."""

    def applies(view: _View) -> Params | None:
        numbers = [joint for joint, flag in zip(JOINTS, flagged(view), strict=True) if flag]
        if numbers:
            return {"joints": interlocks.joint_list(numbers), "numbers": tuple(numbers)}
        return _NONE if code is not None and view.code == code else None

    return applies


def _drivers(fault: Callable[[DriverSlow], bool | None]) -> Callable[[_View], list[bool]]:
    return lambda view: [each is not None and bool(fault(each)) for each in view.drivers]


def _status_flags(flags: Callable[[Status], tuple[bool, ...]]) -> Callable[[_View], list[bool]]:
    return lambda view: [False] * len(JOINTS) if view.status is None else list(flags(view.status))


_AWAY: Final = frozenset({LinkState.NO_DEVICE, LinkState.OPENING, LinkState.LOST})
"""No device is open: nothing can be sent."""


def _stop_waits(view: _View) -> bool:
    operating_state = view.operating_state
    return operating_state.link in _AWAY and operating_state.stop is StopState.REQUESTED


def _stop_lapsed_away(view: _View) -> bool:
    return view.operating_state.stop_lapsed and view.operating_state.link in _AWAY


def _is_teaching_input(view: _View) -> bool:
    status = view.status
    told = status is not None and status.control_mode == ControlMode.LINKED_TEACHING_INPUT
    return view.operating_state.teaching_input or told


def _working(view: _View) -> Params | None:
    busy = view.operating_state.busy
    return None if busy is None else {"what": busy.value}


def _unknown_status(view: _View) -> Params | None:
    known = view.code in frozenset(ArmStatusCode)
    return None if known or view.code is None else {"status": view.code}


def _other_control(view: _View) -> Params | None:
    mode = None if view.status is None else view.status.control_mode
    if mode is None or mode in interlocks.MOVABLE_MODES or mode == ControlMode.TEACHING:
        return None
    return {"mode": mode}


def _not_heard(view: _View) -> bool:
    """Whether something is silent that a motion counts on."""
    silent = view.operating_state.cannot_send_motion
    return view.status is None or (silent is not None and silent.code == "feedback_silent")


def _other_mode(view: _View) -> Params | None:
    other = view.operating_state.other_host
    if other is None or other.reason.code != "other_mode":
        return None
    return {"other_mode": other.reason.params["other_mode"]}


def _other_host(code: str) -> _Applies:
    def applies(view: _View) -> Params | None:
        other = view.operating_state.other_host
        if other is None or other.reason.code != code:
            return None
        since = f"{other.since:%H:%M:%S}"
        return {"frames": other.frames, "since": since, "rate": other.rate_hz}

    return applies


def _held(hold: Hold) -> _Applies:
    """A motion is held back, and not by a run, which has a pause of its own."""

    def applies(view: _View) -> Params | None:
        operating_state = view.operating_state
        if hold not in operating_state.holds or operating_state.running:
            return None
        return {"target": operating_state.held_target_deg}

    return applies


def _near_rest(view: _View) -> bool:
    farthest = farthest_from_rest(view.state)
    return view.in_drag_mode and farthest is not None and abs(farthest[1]) <= NEAR_REST_DEG


def _far_from_rest(condition: Callable[[_View], bool]) -> _Applies:
    def applies(view: _View) -> Params | None:
        farthest = farthest_from_rest(view.state)
        if farthest is None or not view.in_drag_mode or not condition(view):
            return None
        joint, angle_deg = farthest
        return {"joint": joint, "angle": angle_deg, "near": f"{NEAR_REST_DEG:g}"}

    return applies


def _motors_mixed(view: _View) -> list[bool]:
    enabled = view.operating_state.enabled
    return [on is False and any(enabled) for on in enabled]


def _latched(kind: StepKind, applies: _Applies) -> _Rule:
    """A fault that stays until it is cleared, even when its cause is gone."""
    return _Rule(kind, Level.FAULT, Action.CLEAR_ERRORS, applies, escalation=Action.RESET)


_overspeed = _code(ArmStatusCode.OVERSPEED_WHILE_TEACHING)


_RULES: Final = (
    _Rule(StepKind.STOP_LAPSED_AWAY, Level.FAULT, Action.CONNECT, _when(_stop_lapsed_away)),
    _Rule(StepKind.STOP_WAITS_FOR_DEVICE, Level.FAULT, Action.CONNECT, _when(_stop_waits)),
    _Rule(StepKind.NO_DEVICE, Level.INFO, Action.CONNECT, _link(LinkState.NO_DEVICE)),
    _Rule(StepKind.OPENING, Level.INFO, None, _link(LinkState.OPENING)),
    _Rule(StepKind.DEVICE_LOST, Level.FAULT, Action.CONNECT, _link(LinkState.LOST)),
    _Rule(
        StepKind.STOP_LAPSED,
        Level.FAULT,
        Action.WITHDRAW_STOP,
        _when(lambda view: view.operating_state.stop_lapsed),
    ),
    # it obeys nothing but this: neither a stop nor a resume
    _Rule(
        StepKind.TEACHING_INPUT,
        Level.WARNING,
        Action.LEAVE_TEACHING_INPUT,
        _when(_is_teaching_input),
    ),
    _Rule(
        StepKind.STOP_UNCONFIRMED,
        Level.FAULT,
        None,
        _when(lambda view: view.operating_state.stop_unconfirmed),
    ),
    _Rule(
        StepKind.STOP_REQUESTED,
        Level.WARNING,
        None,
        _when(lambda view: view.operating_state.stop is StopState.REQUESTED),
    ),
    _Rule(StepKind.OFFLINE, Level.WARNING, Action.CONNECT, _link(LinkState.OFFLINE)),
    _Rule(
        StepKind.LISTEN_ONLY,
        Level.INFO,
        Action.CONNECT,
        _when(lambda view: view.operating_state.listens_only),
    ),
    _Rule(StepKind.WORKING, Level.INFO, None, _working),
    _Rule(
        StepKind.STOPPED,
        Level.WARNING,
        Action.RESUME,
        _when(lambda view: view.operating_state.stop is StopState.STOPPED),
    ),
    _Rule(
        StepKind.HANDSHAKE,
        Level.INFO,
        None,
        _when(lambda view: view.operating_state.generation is None),
    ),
    _Rule(
        StepKind.STATUS_UNKNOWN,
        Level.WARNING,
        Action.CONNECT,
        _when(_not_heard),
    ),
    _Rule(
        StepKind.COMMUNICATION,
        Level.FAULT,
        Action.RESET,
        _joints(
            _status_flags(lambda status: status.communication_fault),
            ArmStatusCode.JOINT_COMMUNICATION_FAULT,
        ),
    ),
    _latched(
        StepKind.COLLISION,
        _joints(_drivers(lambda each: each.collision_protection), ArmStatusCode.COLLISION),
    ),
    _latched(StepKind.DRIVER_FAULT, _joints(_drivers(lambda each: each.driver_fault))),
    _latched(StepKind.OVERCURRENT, _joints(_drivers(lambda each: each.overcurrent))),
    _latched(StepKind.STALL, _joints(_drivers(lambda each: each.stall_protection))),
    _latched(StepKind.SENSOR, _joints(_drivers(lambda each: each.sensor_fault))),
    # these two tell the moment: they go by themselves with their cause
    _Rule(
        StepKind.UNDERVOLTAGE, Level.FAULT, None, _joints(_drivers(lambda each: each.undervoltage))
    ),
    _Rule(
        StepKind.OVERTEMPERATURE,
        Level.FAULT,
        None,
        _joints(_drivers(lambda each: each.motor_overtemperature or each.driver_overtemperature)),
    ),
    _latched(StepKind.JOINT_STATUS, _code(ArmStatusCode.JOINT_STATUS_ABNORMAL)),
    _Rule(
        StepKind.BRAKE_CLOSED, Level.FAULT, Action.RESET, _code(ArmStatusCode.JOINT_BRAKE_CLOSED)
    ),
    _Rule(
        StepKind.CONTROLLER_HOT,
        Level.FAULT,
        Action.RESET,
        _code(ArmStatusCode.MAIN_CONTROLLER_TOO_HOT),
    ),
    _Rule(
        StepKind.RESISTOR_HOT,
        Level.FAULT,
        Action.RESET,
        _code(ArmStatusCode.BRAKE_RESISTOR_TOO_HOT),
    ),
    _Rule(StepKind.OTHER_FAULT, Level.FAULT, Action.RESET, _code(ArmStatusCode.OTHER_FAULT)),
    _Rule(StepKind.UNKNOWN_STATUS, Level.FAULT, Action.RESET, _unknown_status),
    _Rule(StepKind.RECORDING, Level.INFO, Action.STOP_RECORDING, _phase(TeachingPhase.RECORDING)),
    _Rule(StepKind.REPLAYING, Level.INFO, Action.ABORT_REPLAY, _phase(TeachingPhase.REPLAYING)),
    _Rule(StepKind.REPLAY_PAUSED, Level.INFO, Action.ABORT_REPLAY, _phase(TeachingPhase.PAUSED)),
    _Rule(
        StepKind.CANCEL_UNHEEDED,
        Level.FAULT,
        Action.STOP,
        _when(lambda view: view.operating_state.cancel_unheeded),
    ),
    _Rule(StepKind.OTHER_MODE, Level.WARNING, Action.RESET, _other_mode),
    _Rule(StepKind.LEADER_ARM, Level.WARNING, Action.TAKE_OVER, _other_host("leader_arm")),
    _Rule(StepKind.OTHER_HOST, Level.WARNING, Action.TAKE_OVER, _other_host("other_host")),
    _Rule(StepKind.OTHER_CONTROL, Level.WARNING, Action.STANDBY, _other_control),
    _Rule(
        StepKind.MOTORS_UNKNOWN,
        Level.WARNING,
        Action.CONNECT,
        _when(lambda view: None in view.operating_state.enabled),
    ),
    # the way out of drag teaching: near the rest pose, then a reset
    _Rule(StepKind.DRAG_MODE_AT_REST, Level.WARNING, Action.RESET, _when(_near_rest)),
    _Rule(
        StepKind.DRAG_MODE_WITHOUT_POWER,
        Level.WARNING,
        Action.ENABLE,
        _far_from_rest(lambda view: not view.enabled),
    ),
    _Rule(
        StepKind.OVERSPEED,
        Level.WARNING,
        Action.LEAD_BY_HAND,
        _far_from_rest(lambda view: _overspeed(view) is not None),
    ),
    _Rule(
        StepKind.DRAG_MODE, Level.WARNING, Action.LEAD_BY_HAND, _far_from_rest(lambda _view: True)
    ),
    _Rule(StepKind.OVERSPEED_REPORTED, Level.FAULT, Action.RESET, _overspeed),
    _Rule(StepKind.MOTORS_MIXED, Level.WARNING, Action.ENABLE, _joints(_motors_mixed)),
    _Rule(
        StepKind.PAUSED, Level.WARNING, Action.GO_ON, _held(Hold.PAUSE), alternative=Action.GIVE_UP
    ),
    _Rule(
        StepKind.HELD_AT_ZERO,
        Level.WARNING,
        Action.GO_ON,
        _held(Hold.SPEED_ZERO),
        alternative=Action.GIVE_UP,
    ),
    _Rule(StepKind.MOTORS_OFF, Level.INFO, Action.ENABLE, _when(lambda view: not view.enabled)),
    # a target was refused; the arm stands where it was and takes the next
    _Rule(
        StepKind.BEYOND_LIMIT,
        Level.WARNING,
        None,
        _joints(_status_flags(lambda status: status.limit_exceeded)),
    ),
    _Rule(
        StepKind.TARGET_BEYOND_LIMIT, Level.WARNING, None, _code(ArmStatusCode.TARGET_BEYOND_LIMIT)
    ),
    _Rule(StepKind.NO_SOLUTION, Level.WARNING, None, _code(ArmStatusCode.NO_SOLUTION)),
    _Rule(StepKind.SINGULARITY, Level.WARNING, None, _code(ArmStatusCode.SINGULARITY)),
    _Rule(StepKind.READY, Level.DONE, None, _when(lambda _view: True)),
)
