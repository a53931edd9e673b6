"""Checks whether feedback is fresh, motors lack power, or drag teaching is on: pure."""

from __future__ import annotations

from typing import Any

from armui.arm.refusal import Reason, Refusal
from armui.arm.state import FRESH_FOR_S, ArmState, Reading, is_fresh
from armui.protocol.codes import ArmStatusCode, ControlMode

FEEDBACK_SILENT = Reason(
    "feedback_silent",
    "{frames} of the arm has not been heard for {seconds} s: its position is unknown. Check "
    "its power and the CAN cable; nothing is sent until it is heard again.",
)


def why_silent(state: ArmState, now_s: float) -> Refusal | None:
    """Return why feedback that a motion needs is missing, or ``None``.

    A motion needs the status (0x2A1) and the six joint angles (0x2A5 to 0x2A7).
    """
    missing = [] if _fresh(state.status, now_s) else ["0x2A1"]
    missing += late_angles(state, now_s, FRESH_FOR_S)
    if not missing:
        return None
    return FEEDBACK_SILENT(frames=", ".join(missing), seconds=FRESH_FOR_S)


def late_angles(state: ArmState, now_s: float, within_s: float) -> list[str]:
    """Return the frames of joint angles that were not heard within some seconds."""
    return [
        name
        for pair, name in enumerate(("0x2A5", "0x2A6", "0x2A7"))
        if any(
            each is None or now_s - each.at_s > within_s
            for each in state.joints_deg[2 * pair : 2 * pair + 2]
        )
    ]


def _fresh(heard: Reading[Any] | None, now_s: float) -> bool:
    return heard is not None and is_fresh(heard.at_s, now_s)


def any_motor_off(state: ArmState, now_s: float) -> bool | None:
    """Return whether a motor is without power; ``None`` if not every driver has told its state."""
    known = True
    for each in state.drivers_slow:
        if each is None or not is_fresh(each.at_s, now_s):
            known = False
        elif not each.value.enabled:
            return True
    return False if known else None


def in_drag_teaching(state: ArmState) -> bool:
    """Return whether the arm is in drag teaching, or is a teaching input: a hand leads it."""
    status = state.status
    if status is None:
        return False
    recording = status.value.arm_status == ArmStatusCode.TEACHING_RECORDING
    modes = {ControlMode.TEACHING, ControlMode.LINKED_TEACHING_INPUT}
    return recording or status.value.control_mode in modes
