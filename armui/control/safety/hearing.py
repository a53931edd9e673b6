"""Whether the feedback a motion needs is fresh, and whether the joints hold: pure."""

from __future__ import annotations

from typing import Any

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.arm.state import FRESH_FOR_S, ArmState, Reading, is_fresh
from armui.protocol.codes import ArmStatusCode, ControlMode


def why_silent(state: ArmState, now_s: float) -> Refusal | None:
    """Which of the feedback that a motion counts on is not heard: 0x2A1 and six joint angles."""
    missing = [] if _fresh(state.status, now_s) else ["0x2A1"]
    for pair, name in enumerate(("0x2A5", "0x2A6", "0x2A7")):
        if not all(_fresh(each, now_s) for each in state.joints_deg[2 * pair : 2 * pair + 2]):
            missing.append(name)
    if not missing:
        return None
    return Refusal(
        RefusalCode.FEEDBACK_SILENT, {"frames": ", ".join(missing), "seconds": FRESH_FOR_S}
    )


def _fresh(heard: Reading[Any] | None, now_s: float) -> bool:
    return heard is not None and is_fresh(heard.at_s, now_s)


def limp(state: ArmState, now_s: float) -> bool | None:
    """Whether a motor is without power; ``None`` if that is not heard of each."""
    known = True
    for each in state.drivers_slow:
        if each is None or not is_fresh(each.at_s, now_s):
            known = False
        elif not each.value.enabled:
            return True
    return False if known else None


def taught(state: ArmState) -> bool:
    """Whether the arm is in drag teaching, or is a teaching input: a hand leads it."""
    status = state.status
    if status is None:
        return False
    recording = status.value.arm_status == ArmStatusCode.TEACHING_RECORDING
    modes = {ControlMode.TEACHING, ControlMode.LINKED_TEACHING_INPUT}
    return recording or status.value.control_mode in modes
