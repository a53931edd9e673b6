"""The state of the link to the arm, with the reasons why nothing can be sent."""

from __future__ import annotations

import enum

from armui.arm.device import Device
from armui.arm.refusal import Reason, Refusal

LISTEN_ONLY = Reason(
    "listen_only",
    "This connection only listens: nothing is sent but the emergency stop. Connect without "
    "Listen only to command the arm.",
)
REPLAYED_LOG = Reason(
    "replayed_log",
    "This is a log that is replayed: nothing can be sent. Whatever is to reach an arm is "
    "done in the main window.",
)
LINK_LOST = Reason(
    "link_lost", "The CAN device is gone. Plug it in again: the program reconnects by itself."
)
OFFLINE = Reason(
    "offline",
    "The device is open, but nothing is heard from the arm. Check its power, the CAN cable "
    "and the bit rate, or whether this computer is too busy.",
)
NOT_CONNECTED = Reason(
    "not_connected",
    "No arm is connected. Click the button at the top left, choose a device and connect it.",
)


class LinkState(enum.Enum):
    """The states of the link to the arm."""

    NO_DEVICE = enum.auto()
    """No device is connected."""
    OPENING = enum.auto()
    OFFLINE = enum.auto()
    """A device is open, and no arm has been heard on it for half a second."""
    ONLINE = enum.auto()
    LOST = enum.auto()
    """The device is gone; the program keeps trying to reopen it."""


def why_only_heard(device: Device | None) -> Refusal | None:
    """Return why an arm that is heard may not be sent anything, or ``None``."""
    if device is None or not device.listen_only:
        return None
    return Refusal(LISTEN_ONLY if device.recorded is None else REPLAYED_LOG)


def why_unreachable(link: LinkState, device: Device | None = None) -> Refusal | None:
    """Return why nothing at all can be sent: no arm is heard, or it is only listened to.

    Args:
        link: The state of the link.
        device: The open device; ``None`` for an action that is also possible on a listen-only link.
    """
    if link is LinkState.ONLINE and (refusal := why_only_heard(device)) is not None:
        return refusal
    if link is LinkState.LOST:
        return LINK_LOST()
    if link is LinkState.OFFLINE:
        return OFFLINE()
    return None if link is LinkState.ONLINE else NOT_CONNECTED()
