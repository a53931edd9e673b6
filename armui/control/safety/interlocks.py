"""Checks whether the arm may be moved or enabled now: pure; they return the reason why not."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState, Six
from armui.control.operating_state import BUSY, Busy, StopState
from armui.control.safety.feedback_freshness import FEEDBACK_SILENT
from armui.protocol.codes import TARGET_REFUSALS, ArmStatusCode, ControlMode

STOP_REQUESTED = Reason(
    "stop_requested",
    "The emergency stop has been sent and the arm has not confirmed it yet. Wait for the "
    "confirmation.",
)
STOPPED = Reason(
    "stopped",
    "The arm is in emergency stop. Support it, hold Release above the panel, then enable the "
    "motors.",
)
NOT_ENABLED = Reason(
    "not_enabled", "The motors of these joints are not enabled: {joints}. Press Enable first."
)
ENABLED_UNKNOWN = Reason(
    "enabled_unknown",
    "Not every motor has reported yet whether it is enabled. Wait a moment; if it stays so, "
    "check the arm's power and the CAN cable.",
)
JOINTS_UNKNOWN = Reason(
    "joints_unknown",
    "Not all of the arm's joint angles are heard now. Wait until all six are shown, none muted.",
)
OTHER_CONTROL = Reason(
    "other_control", "The arm takes its commands from elsewhere: {mode}. Leave that mode first."
)
ARM_FAULT = Reason(
    "arm_fault",
    "The arm reports: {status}. The line above the panels says what helps.",
)
CONTROL_OFFSET_UNKNOWN = Reason(
    "control_offset_unknown",
    "Which identifiers the arm obeys is not proven, so it is not moved; stop and halt reach it. "
    "Set the offsets again in Linkage with the arm in standby.",
)
SPEED_ZERO = Reason(
    "speed_zero",
    "The speed is set to 0 %: the arm would not move. Set a speed from 1 to 100 % at the top.",
)

PASSING: Final = frozenset({ENABLED_UNKNOWN, JOINTS_UNKNOWN, FEEDBACK_SILENT})
"""The reasons that the next frame may remove."""

MOVABLE_MODES: Final = frozenset({ControlMode.STANDBY, ControlMode.CAN_CONTROL})

MOVABLE_STATUSES: Final = TARGET_REFUSALS | {ArmStatusCode.NORMAL}
"""An arm of any other status (0x2A1 byte 1) takes no motion, and has ended the one under way."""


def why_no_command(
    unreachable: Refusal | None, stop: StopState, busy: Busy | None
) -> Refusal | None:
    """Return the reason against any command but the stop, or ``None``.

    Args:
        unreachable: Why nothing can be sent at all.
        stop: The state of the emergency stop.
        busy: The effect that the program waits for.
    """
    if unreachable is not None:
        return unreachable
    if stop is StopState.REQUESTED:
        return STOP_REQUESTED()
    if stop is StopState.STOPPED:
        return STOPPED()
    if busy is not None:
        return BUSY(what=busy.value)
    return None


def why_not_enabled(enabled: Six[bool | None]) -> Refusal | None:
    """Return why the motors prevent a motion (off or not heard), or ``None``."""
    off = [joint for joint, on in enumerate(enabled, start=1) if on is False]
    if off:
        return NOT_ENABLED(joints=joint_list(off))
    return ENABLED_UNKNOWN() if None in enabled else None


def why_not_ready(state: ArmState) -> Refusal | None:
    """Return why the arm's control mode or status prevents a motion, or ``None``."""
    if state.status is None or state.angles_deg() is None:
        return JOINTS_UNKNOWN()
    status = state.status.value
    if status.control_mode not in MOVABLE_MODES:
        return OTHER_CONTROL(mode=status.control_mode)
    if status.arm_status not in MOVABLE_STATUSES:
        return ARM_FAULT(status=status.arm_status)
    return None


def joint_list(joints: list[int]) -> str:
    """Return joint numbers for a sentence, as ``1, 3``."""
    return ", ".join(str(joint) for joint in joints)
