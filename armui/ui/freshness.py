"""Whether what the arm said last still stands for the present."""

from __future__ import annotations

from typing import Any

from armui.arm.state import ArmState, Heard
from armui.control.situation import LinkState, Situation


def is_stale(heard: Heard[Any] | None, state: ArmState, situation: Situation) -> bool:
    """Whether a value was heard and is too old by now.

    While the arm is online its last frame is the clock: a value that stays away for half a second
    while others arrive is stale. Without a link everything heard is.
    """
    if heard is None:
        return False
    if situation.link is not LinkState.ONLINE or state.last_feedback_s is None:
        return True
    return not heard.fresh(state.last_feedback_s)
