"""Whether what the arm said last still stands for the present."""

from __future__ import annotations

from typing import Any

from armui.arm.state import ArmState, Reading
from armui.control.operating_state import LinkState, OperatingState


def is_stale(heard: Reading[Any] | None, state: ArmState, operating_state: OperatingState) -> bool:
    """Return whether a value was heard and is too old by now.

    While the arm is online its last frame is the clock: a value that stays away for half a second
    while others arrive is stale. Without a link everything heard is.
    """
    if heard is None:
        return False
    if operating_state.link is not LinkState.ONLINE or state.last_feedback_s is None:
        return True
    return not heard.fresh(state.last_feedback_s)
