"""Decides whether a value of the arm still counts as present."""

from __future__ import annotations

from typing import Any

from armui.arm.state import ArmState, Reading
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState


def is_stale(heard: Reading[Any] | None, state: ArmState, operating_state: OperatingState) -> bool:
    """Return whether a value was heard, but is too old now.

    While the arm is online its last frame is the clock: a value that has not come for half a second
    while others arrive is stale. Offline, everything heard is stale.
    """
    if heard is None:
        return False
    if operating_state.link is not LinkState.ONLINE or state.last_feedback_s is None:
        return True
    return not heard.fresh(state.last_feedback_s)
