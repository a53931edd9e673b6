"""Decides whether a CAN interface may be switched while an arm is on it."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal import Reason, Refusal
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState, StopState

CARRIES_A_MOVING_ARM = Reason(
    "carries_a_moving_arm",
    "The arm moves, and {interface} is the only way to it: switched off, even for a moment, the "
    "arm goes on with what it was told last, and no emergency stop reaches it. Let the motion end "
    "or stop it first.",
)
_SWITCHING: Final = frozenset({"up", "down", "reset"})


def why_not_switch(verb: str, interface: str, now: OperatingState) -> Refusal | None:
    """Return the reason against a verb of the adapter's helper, or ``None`` if it may be done.

    Setting a bit rate and recovering from bus-off also switch the interface off. An arm that is
    heard and moves is not cut off, whoever moves it; an arm that is no longer heard can be reached
    again only by this.
    """
    device = now.device
    if verb not in _SWITCHING or device is None or device.simulated:
        return None
    if device.interface != "socketcan" or str(device.channel) != interface:
        return None
    stopping = now.link is LinkState.ONLINE and now.stop is StopState.REQUESTED
    if now.moving or now.running or now.jogging or stopping:
        return CARRIES_A_MOVING_ARM(interface=interface)
    return None
