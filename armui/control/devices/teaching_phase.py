"""The phase of drag teaching as reported, and the commands that fit it: pure."""

from __future__ import annotations

import enum
from collections.abc import Mapping
from typing import Final

from armui.arm.refusal import Reason, Refusal
from armui.arm.rest_pose import from_rest_deg
from armui.arm.state import ArmState, Status
from armui.control.operating_state import OperatingState
from armui.control.safety import interlocks
from armui.control.safety.interlocks import (
    ARM_FAULT,
    CONTROL_OFFSET_UNKNOWN,
    JOINTS_UNKNOWN,
    OTHER_CONTROL,
)
from armui.protocol.codes import TARGET_REFUSALS, ArmStatusCode, ControlMode, TeachingState

TEACHING_OFF = Reason(
    "teaching_off",
    "The arm is not in drag teaching. Start recording first, or press the button on the arm.",
)
TEACHING_IDLE = Reason(
    "teaching_idle", "Nothing is under way in drag teaching. Start recording or replay first."
)
TEACHING_RECORDING = Reason("teaching_recording", "The arm is recording. Stop recording first.")
TEACHING_REPLAYING = Reason(
    "teaching_replaying", "The arm is replaying. Pause or terminate the replay first."
)
AREA_WAY_UNKNOWN = Reason(
    "area_way_unknown",
    "The arm would replay a way that only it knows, and the work area could not be kept. Switch "
    "the area off under Cell, or record and replay with this program.",
)
TEACHING_PAUSED = Reason("teaching_paused", "The replay is paused. Continue or terminate it first.")


NEAR_REST_DEG: Final = 15.0
"""Each joint must be this near to its zero or its rest pose, or between them, for a reset to end
drag teaching. The maker says «near the rest pose» and gives no figure; the simulated arm assumes
this one.
"""

DRIVES: Final = frozenset(
    {TeachingState.RUN_RECORDING, TeachingState.CONTINUE, TeachingState.MOVE_TO_START}
)

_ASKS_MUCH: Final = frozenset(
    {
        TeachingState.START_RECORDING,
        TeachingState.RUN_RECORDING,
        TeachingState.CONTINUE,
        TeachingState.MOVE_TO_START,
    }
)
"""The commands that move the arm or hand it over: they need powered motors and no fault."""


class TeachingPhase(enum.Enum):
    """The phases of drag teaching."""

    OFF = enum.auto()
    """The arm is not in drag teaching."""
    IDLE = enum.auto()
    """The arm is in drag teaching and nothing is under way; it obeys no other commands."""
    RECORDING = enum.auto()
    """The arm gives way to the hand and records its path."""
    REPLAYING = enum.auto()
    """The arm moves along the recording, or to its start."""
    PAUSED = enum.auto()


_BY_STATUS: Final[Mapping[int, TeachingPhase]] = {
    ArmStatusCode.TEACHING_RECORDING: TeachingPhase.RECORDING,
    ArmStatusCode.TEACHING_RUNNING: TeachingPhase.REPLAYING,
    ArmStatusCode.TEACHING_PAUSED: TeachingPhase.PAUSED,
}

_SUITS: Final[Mapping[TeachingState, frozenset[TeachingPhase]]] = {
    TeachingState.START_RECORDING: frozenset({TeachingPhase.OFF, TeachingPhase.IDLE}),
    TeachingState.STOP_RECORDING: frozenset({TeachingPhase.RECORDING}),
    TeachingState.RUN_RECORDING: frozenset({TeachingPhase.IDLE}),
    TeachingState.PAUSE: frozenset({TeachingPhase.REPLAYING}),
    TeachingState.CONTINUE: frozenset({TeachingPhase.PAUSED}),
    TeachingState.ABORT: frozenset({TeachingPhase.REPLAYING, TeachingPhase.PAUSED}),
    TeachingState.MOVE_TO_START: frozenset({TeachingPhase.IDLE}),
}
"""The phases in which each command of 0x150 byte 2 has an effect."""


_SOUND: Final = TARGET_REFUSALS.union(
    {ArmStatusCode.NORMAL, ArmStatusCode.OVERSPEED_WHILE_TEACHING}, _BY_STATUS
)

_UNSUITED: Final[Mapping[TeachingPhase, Reason]] = {
    TeachingPhase.OFF: TEACHING_OFF,
    TeachingPhase.IDLE: TEACHING_IDLE,
    TeachingPhase.RECORDING: TEACHING_RECORDING,
    TeachingPhase.REPLAYING: TEACHING_REPLAYING,
    TeachingPhase.PAUSED: TEACHING_PAUSED,
}
"""The reason that each phase gives against a command that does not suit it."""


def phase_of(status: Status) -> TeachingPhase:
    """Return the phase of drag teaching, from bytes 0, 1, 3 and 4 of 0x2A1.

    Byte 1 has room for one code only, so that a fault hides what drag teaching does: then byte 3
    tells. It names the last command, which says nothing of a replay that has arrived, nor of an
    arm that has left drag teaching.
    """
    told = _BY_STATUS.get(status.arm_status)
    if told is not None:
        return told
    if status.control_mode != ControlMode.TEACHING:
        return TeachingPhase.OFF
    if status.teaching == TeachingState.START_RECORDING:
        return TeachingPhase.RECORDING
    if status.teaching == TeachingState.PAUSE:
        return TeachingPhase.PAUSED
    if status.teaching in DRIVES and not status.reached:
        return TeachingPhase.REPLAYING
    return TeachingPhase.IDLE


def is_own_replay(status: Status) -> bool:
    """Return whether the arm follows its own recording, or goes to its start; paused, too."""
    return phase_of(status) in {TeachingPhase.REPLAYING, TeachingPhase.PAUSED}


def may_replay(status: Status | None) -> bool:
    """Return whether the arm may follow its own recording now; the last status may be outdated.

    A replay begins in drag teaching only, and not while the hand is recorded.
    """
    return status is None or phase_of(status) not in {TeachingPhase.OFF, TeachingPhase.RECORDING}


def why_under_way(phase: TeachingPhase) -> Refusal | None:
    """Return the teaching activity under way as a reason against disturbing it, or ``None``."""
    return None if phase in {TeachingPhase.OFF, TeachingPhase.IDLE} else Refusal(_UNSUITED[phase])


def farthest_from_rest(state: ArmState) -> tuple[int, float] | None:
    """Return the joint farthest from its rest (1–6) and its angle in °; ``None``: not heard."""
    angles_deg = state.angles_deg()
    if angles_deg is None:
        return None
    distances_deg = from_rest_deg(angles_deg)
    joint = max(range(len(angles_deg)), key=distances_deg.__getitem__)
    return joint + 1, angles_deg[joint]


def is_near_rest(state: ArmState) -> bool:
    """Return whether every joint is heard to be so near to its rest that a reset ends teaching."""
    angles_deg = state.angles_deg()
    return angles_deg is not None and max(from_rest_deg(angles_deg)) <= NEAR_REST_DEG


def why_not_teach(now: OperatingState, command: TeachingState) -> Refusal | None:
    """Return why a command of 0x150 byte 2 may not be given, or makes no sense, or ``None``."""
    refusal = now.why_pending("teaching") or interlocks.why_no_command(
        now.unreachable, now.stop, now.busy
    )
    if refusal is None and not now.control_certain:
        refusal = CONTROL_OFFSET_UNKNOWN()
    if refusal is not None:
        return refusal
    status = now.status
    if status is None:
        return JOINTS_UNKNOWN()
    phase = phase_of(status)
    if phase not in _SUITS[command]:
        return Refusal(_UNSUITED[phase])
    if command not in _ASKS_MUCH:
        return None
    refusal = now.occupied or now.cannot_send_motion or _why_not_driven(now, command)
    if refusal is not None:
        return refusal
    if phase is TeachingPhase.OFF and status.control_mode not in interlocks.MOVABLE_MODES:
        return OTHER_CONTROL(mode=status.control_mode)
    if status.arm_status not in _SOUND:
        return ARM_FAULT(status=status.arm_status)
    return interlocks.why_not_enabled(now.enabled)


def _why_not_driven(now: OperatingState, command: TeachingState) -> Refusal | None:
    """Return why the arm may not drive itself; led by hand, nothing drives it."""
    if now.keeps_area and command in DRIVES:
        return AREA_WAY_UNKNOWN()
    if now.reference.checking or command is not TeachingState.START_RECORDING:
        return now.reference.why_not_run()
    return None
