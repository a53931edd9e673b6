"""Whether the arm may be moved or enabled now: pure checks that answer with the reason why not."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.arm.state import ArmState, Six
from armui.control.operating_state import Busy, StopState
from armui.protocol.codes import ArmStatusCode, ControlMode

MOVABLE_MODES: Final = frozenset({ControlMode.STANDBY, ControlMode.CAN_CONTROL})

MOVABLE_STATUSES: Final = frozenset(
    {
        ArmStatusCode.NORMAL,
        # the last target was refused; the next may be better
        ArmStatusCode.NO_SOLUTION,
        ArmStatusCode.SINGULARITY,
        ArmStatusCode.TARGET_BEYOND_LIMIT,
    }
)
"""An arm of any other status (0x2A1 byte 1) takes no motion, and has ended the one under way."""


def why_no_command(
    unreachable: Refusal | None, stop: StopState, busy: Busy | None
) -> Refusal | None:
    """The reason against any command but the stop.

    Args:
        unreachable: Why nothing can be sent at all.
        stop: Where the emergency stop stands.
        busy: What the program is waiting for.
    """
    if unreachable is not None:
        return unreachable
    if stop is StopState.REQUESTED:
        return Refusal(RefusalCode.STOP_REQUESTED)
    if stop is StopState.STOPPED:
        return Refusal(RefusalCode.STOPPED)
    if busy is not None:
        return Refusal(RefusalCode.BUSY, {"what": busy.value})
    return None


def why_not_enabled(enabled: Six[bool | None]) -> Refusal | None:
    """The reason motors give against a motion: some are off, or were not heard."""
    off = [joint for joint, on in enumerate(enabled, start=1) if on is False]
    if off:
        return Refusal(RefusalCode.NOT_ENABLED, {"joints": joint_list(off)})
    return Refusal(RefusalCode.ENABLED_UNKNOWN) if None in enabled else None


def why_not_ready(state: ArmState) -> Refusal | None:
    """The reason the arm itself gives against a motion: who controls it, and its status."""
    if state.status is None or state.angles_deg() is None:
        return Refusal(RefusalCode.JOINTS_UNKNOWN)
    status = state.status.value
    if status.control_mode not in MOVABLE_MODES:
        return Refusal(RefusalCode.OTHER_CONTROL, {"mode": status.control_mode})
    if status.arm_status not in MOVABLE_STATUSES:
        return Refusal(RefusalCode.ARM_FAULT, {"status": status.arm_status})
    return None


def joint_list(joints: list[int]) -> str:
    """Joint numbers for a sentence: ``1, 3``."""
    return ", ".join(str(joint) for joint in joints)
