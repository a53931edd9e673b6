"""Whether joints move, by the speeds their drivers report (0x251–0x256): pure."""

from __future__ import annotations

from typing import Final

from armui.arm.limits import JOINTS
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.safety.interlocks import joint_list

STILL_DEG_S: Final = 1.0
"""Slower than this a joint stands still: drivers report a little noise at rest."""


def why_moving(state: ArmState) -> Refusal | None:
    """The joints that are measured to move, as a reason; one that tells nothing is no reason."""
    moving = [
        joint
        for joint, speed in zip(JOINTS, _speeds_deg_s(state), strict=True)
        if speed is not None and abs(speed) >= STILL_DEG_S
    ]
    return Refusal("joints_moving", {"joints": joint_list(moving)}) if moving else None


def why_not_still(state: ArmState) -> Refusal | None:
    """The same, and for each joint its speed must be known."""
    speeds = zip(JOINTS, _speeds_deg_s(state), strict=True)
    unknown = [joint for joint, speed in speeds if speed is None]
    if unknown:
        return Refusal("speed_unknown", {"joints": joint_list(unknown)})
    return why_moving(state)


def _speeds_deg_s(state: ArmState) -> list[float | None]:
    """Of each joint; ``None`` where its driver has not been heard beside the newest feedback."""
    return [
        heard.value.speed_deg_s
        if heard is not None
        and state.last_feedback_s is not None
        and heard.fresh(state.last_feedback_s)
        else None
        for heard in state.drivers_fast
    ]
