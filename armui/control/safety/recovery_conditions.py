"""The conditions of the rules of recovery: pure."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from armui.arm.limits import JOINTS
from armui.arm.model_check import MODEL_OTHER
from armui.arm.quirks import exits_by_mode_word
from armui.arm.refusal import Reason
from armui.arm.state import ArmState, DriverSlow, Status
from armui.control.devices.teaching_phase import (
    NEAR_REST_DEG,
    TeachingPhase,
    farthest_from_rest,
    is_near_rest,
    phase_of,
)
from armui.control.link.link_state import LinkState
from armui.control.motion.motion_command import Hold
from armui.control.operating_state import RUN_UNDER_WAY, OperatingState, StopState
from armui.control.run.progress import RunPhase
from armui.control.safety import interlocks
from armui.control.safety.feedback_freshness import FEEDBACK_SILENT
from armui.control.safety.other_command import OTHER_MODE
from armui.control.safety.recovery_steps import Params
from armui.protocol.codes import ArmStatusCode, ControlMode

_NONE: Final[Params] = {}
_KNOWN_CODES: Final = frozenset(map(int, ArmStatusCode))

_AWAY: Final = frozenset({LinkState.NO_DEVICE, LinkState.OPENING, LinkState.LOST})
"""The states of the link in which no device is open and nothing can be sent."""


@dataclass(frozen=True, slots=True)
class RecoveryView:
    """The data that the rules look at; only recent feedback counts."""

    state: ArmState
    operating_state: OperatingState
    status: Status | None
    drivers: tuple[DriverSlow | None, ...]

    @property
    def code(self) -> int | None:
        """The status code, or ``None`` if it is not heard."""
        return None if self.status is None else self.status.arm_status

    @property
    def phase(self) -> TeachingPhase:
        """The phase of drag teaching."""
        return TeachingPhase.OFF if self.status is None else phase_of(self.status)

    @property
    def in_drag_mode(self) -> bool:
        """True if the arm may be led by hand."""
        return self.status is not None and self.status.control_mode == ControlMode.TEACHING

    @property
    def enabled(self) -> bool:
        """True if all six motors are on."""
        return all(self.operating_state.enabled)


Applies = Callable[[RecoveryView], Params | None]
"""Returns the figures of a rule's sentence if the rule applies, else ``None``."""


def when(condition: Callable[[RecoveryView], bool]) -> Applies:
    """Return a check that applies while a condition holds; its sentence has no figures."""
    return lambda view: _NONE if condition(view) else None


def when_now(condition: Callable[[OperatingState], bool]) -> Applies:
    """Return the same for a condition on the operating state alone."""
    return when(lambda view: condition(view.operating_state))


def link_is(link: LinkState) -> Applies:
    """Return a check that applies in one state of the link."""
    return when_now(lambda now: now.link is link)


def adapter_is(code: str) -> Applies:
    """Return a check that applies while no arm is heard for a problem of an open adapter."""

    def applies(view: RecoveryView) -> Params | None:
        now = view.operating_state
        problem = now.link_problem if now.link is LinkState.OFFLINE else None
        return problem.params if problem is not None and problem.code == code else None

    return applies


def has_code(code: ArmStatusCode) -> Applies:
    """Return a check that applies while the arm reports one status code (0x2A1 byte 1)."""
    return when(lambda view: view.code == code)


def in_phase(phase: TeachingPhase) -> Applies:
    """Return a check that applies in one phase of drag teaching."""
    return when(lambda view: view.phase is phase)


def joints_flagged(
    flagged: Callable[[RecoveryView], list[bool]], code: ArmStatusCode | None = None
) -> Applies:
    """Return a check that applies if joints are flagged, or the status reports it unnamed."""

    def applies(view: RecoveryView) -> Params | None:
        flags = flagged(view)
        if True in flags:
            numbers = [joint for joint, flag in zip(JOINTS, flags, strict=True) if flag]
            return {"joints": interlocks.joint_list(numbers), "numbers": tuple(numbers)}
        return _NONE if code is not None and view.code == code else None

    return applies


def drivers(fault: Callable[[DriverSlow], bool | None]) -> Callable[[RecoveryView], list[bool]]:
    """Return a function for the flags of the joints whose drivers report a fault (0x261–0x266)."""
    return lambda view: [each is not None and bool(fault(each)) for each in view.drivers]


def too_hot(view: RecoveryView) -> Params | None:
    """Return the joints whose motor or driver is too hot and the highest temperature, if any is."""
    hot_c: dict[int, float] = {}
    for joint, each in zip(JOINTS, view.drivers, strict=True):
        parts_c = [] if each is None else _hot_parts_c(each)
        if parts_c:
            hot_c[joint] = max(parts_c)
    if not hot_c:
        return None
    hottest = f"{max(hot_c.values()):.0f}"
    joints = list(hot_c)
    return {
        "joints": interlocks.joint_list(joints),
        "numbers": tuple(joints),
        "temperature": hottest,
    }


def _hot_parts_c(driver: DriverSlow) -> list[float]:
    parts = (
        (driver.motor_overtemperature, driver.motor_temperature_c),
        (driver.driver_overtemperature, driver.driver_temperature_c),
    )
    return [temperature_c for hot, temperature_c in parts if hot]


def status_flags(
    flags: Callable[[Status], tuple[bool, ...]],
) -> Callable[[RecoveryView], list[bool]]:
    """Return a function for the joint flags in the status (0x2A1 bytes 6–7)."""
    return lambda view: [False] * len(JOINTS) if view.status is None else list(flags(view.status))


def stop_waits(view: RecoveryView) -> bool:
    """Return whether a stop was asked for and no device is there to send it."""
    operating_state = view.operating_state
    return operating_state.link in _AWAY and operating_state.stop is StopState.REQUESTED


def stop_lapsed_away(view: RecoveryView) -> bool:
    """Return whether a stop has lapsed and no device is there."""
    return view.operating_state.stop_lapsed and view.operating_state.link in _AWAY


def is_teaching_input(view: RecoveryView) -> bool:
    """Return whether the arm is a teaching input, which obeys only its linkage."""
    status = view.status
    told = status is not None and status.control_mode == ControlMode.LINKED_TEACHING_INPUT
    return view.operating_state.teaching_input or told


def working(view: RecoveryView) -> Params | None:
    """Return the activity with which the program is busy, as figures, or ``None``."""
    busy = view.operating_state.busy
    return None if busy is None else {"what": busy.value}


def unknown_status(view: RecoveryView) -> Params | None:
    """Return the reported status code if the protocol does not list it, or ``None``."""
    known = view.code in _KNOWN_CODES
    return None if known or view.code is None else {"status": view.code}


def other_control(view: RecoveryView) -> Params | None:
    """Return the control mode if it takes no motions, or ``None``."""
    mode = None if view.status is None else view.status.control_mode
    if mode is None or mode in interlocks.MOVABLE_MODES or mode == ControlMode.TEACHING:
        return None
    return {"mode": mode}


def not_heard(view: RecoveryView) -> bool:
    """Return whether feedback that a motion needs is missing."""
    silent = view.operating_state.cannot_send_motion
    return view.status is None or (silent is not None and silent.reason == FEEDBACK_SILENT)


def other_mode(view: RecoveryView) -> Params | None:
    """Return the mode (MIT, CPV, high-follow) another host has set, or ``None``."""
    other = view.operating_state.other_host
    if other is None or other.refusal.reason != OTHER_MODE:
        return None
    return {"other_mode": other.refusal.params["other_mode"]}


def other_mode_that_ends(view: RecoveryView) -> Params | None:
    """Return the same if the arm's firmware leaves such a mode by a mode word."""
    return other_mode(view) if exits_by_mode_word(view.state) else None


def other_model(view: RecoveryView) -> Params | None:
    """Return that another model of the family fits the arm than the chosen one, or ``None``."""
    wrong = view.operating_state.model_fit.wrong
    return {"reason": wrong} if wrong is not None and wrong.reason == MODEL_OTHER else None


def other_host_is(code: Reason) -> Applies:
    """Return a check that applies while another host moves the arm, for one reason."""

    def applies(view: RecoveryView) -> Params | None:
        other = view.operating_state.other_host
        if other is None or other.refusal.reason != code:
            return None
        since = f"{other.since:%H:%M:%S}"
        return {"frames": other.frames, "since": since, "rate": other.rate_hz}

    return applies


def held_back(hold: Hold) -> Applies:
    """Return a check that applies while a motion is held back, but not by a run's own pause."""

    def applies(view: RecoveryView) -> Params | None:
        operating_state = view.operating_state
        if hold not in operating_state.holds or operating_state.running:
            return None
        return {"target": operating_state.held_target_deg}

    return applies


def run_is(*phases: RunPhase) -> Applies:
    """Return a check that applies while a run or a replay is in one of these phases."""
    return when_now(lambda now: now.run_phase in phases)


def otherwise_locked(view: RecoveryView) -> Params | None:
    """Return the reason against every motion that no step of its own tells, or ``None``."""
    reason = view.operating_state.cannot_move
    if reason is None or reason == RUN_UNDER_WAY():
        return None
    return {"reason": reason}


def moves(view: RecoveryView) -> bool:
    """Return whether the arm is on its way, or comes to rest after a run was ended."""
    return view.operating_state.moving or view.operating_state.running


def too_low(depth_mm: Callable[[OperatingState], int | None]) -> Applies:
    """Return a check that applies while the arm is lower than one height; with the depth in mm."""

    def applies(view: RecoveryView) -> Params | None:
        below = depth_mm(view.operating_state)
        return None if below is None else {"value": below}

    return applies


def outside(view: RecoveryView) -> Params | None:
    """Return the joints that an arm at rest has outside its limits, or ``None``."""
    operating_state = view.operating_state
    if not operating_state.outside or operating_state.moving:
        return None
    return {"outside": operating_state.outside}


def in_area(view: RecoveryView) -> Params | None:
    """Return where the arm is too near to its work area, or ``None``."""
    found = view.operating_state.intrusion
    if found is None:
        return None
    return {"name": found.name, "part": found.part, "value": found.value_mm}


def reference_in_doubt(*, agreed: bool) -> Applies:
    """Return a check that applies to a reference in doubt, agreed to or not; with the joints."""

    def applies(view: RecoveryView) -> Params | None:
        reference = view.operating_state.reference
        if not reference.doubtful or reference.allowed is not agreed:
            return None
        return {"joints": reference.joints, "numbers": reference.doubtful}

    return applies


def slipped(view: RecoveryView) -> Params | None:
    """Apply to what slipped at a resume and was not noted; with the joints and degrees."""
    joints = view.operating_state.reference.slipped
    return {"joints": joints} if joints else None


def when_off(applies: Applies) -> Applies:
    """Return a check that applies as another one does, while not all motors are enabled."""
    return lambda view: None if view.enabled else applies(view)


def near_rest(view: RecoveryView) -> bool:
    """Return whether the arm is led by hand and near the rest pose."""
    return view.in_drag_mode and is_near_rest(view.state)


def far_from_rest(condition: Callable[[RecoveryView], bool]) -> Applies:
    """Return a check for an arm led by hand away from the rest pose, with a condition."""

    def applies(view: RecoveryView) -> Params | None:
        farthest = farthest_from_rest(view.state) if view.in_drag_mode else None
        if farthest is None or not condition(view):
            return None
        joint, angle_deg = farthest
        return {"joint": joint, "angle": angle_deg, "near": f"{NEAR_REST_DEG:g}"}

    return applies


def motors_mixed(view: RecoveryView) -> list[bool]:
    """Return a flag for each motor that is off while others are on."""
    enabled = view.operating_state.enabled
    return [on is False and any(enabled) for on in enabled]


overspeed = has_code(ArmStatusCode.OVERSPEED_WHILE_TEACHING)


def cell_waits(reason: Reason) -> Applies:
    """Return a check that applies while the cell kept for the adapter is not in force for this."""

    def applies(view: RecoveryView) -> Params | None:
        waits = view.operating_state.unconfirmed_cell
        return waits.params if waits is not None and waits.reason == reason else None

    return applies
