"""Decides whether a value of the arm still counts as present."""

from __future__ import annotations

from typing import Any

from armui.arm.state import ArmState, Reading
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState


def is_stale(heard: Reading[Any] | None, state: ArmState, operating_state: OperatingState) -> bool:
    """Return whether a reported value is too old.

    While the arm is online, time is taken from its last frame: a value is stale if others have
    arrived for half a second without it. Offline, every value is stale.
    """
    if heard is None:
        return False
    if operating_state.link is not LinkState.ONLINE or state.last_feedback_s is None:
        return True
    return not heard.fresh(state.last_feedback_s)
