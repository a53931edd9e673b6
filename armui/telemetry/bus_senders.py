"""Finds the sender of a frame, as far as its identifier shows it."""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING, Final

from armui.arm.other_hosts import MOTION_IDS, OTHER_COMMAND_IDS, is_arms_answer
from armui.protocol.frame import FrameFlag

if TYPE_CHECKING:
    from armui.protocol.addressing import Addressing
    from armui.protocol.frame import Frame

VERSION_ID: Final = 0x4AF
"""The identifier with which the host asks for the version, and the arm answers."""
_QUESTION: Final = bytes((1, 0, 0, 0, 0, 0, 0, 0))

_FEEDBACK_OFFSETS: Final = range(0x2A1, 0x2C9)
FIXED_FEEDBACK: Final = frozenset(
    {*range(0x251, 0x257), *range(0x261, 0x267), *range(0x2AA, 0x2AD), *range(0x481, 0x487)}
    | {0x473, 0x476, 0x478, 0x47B, 0x47C, 0x47E, 0x488}
)
_HOSTS: Final = MOTION_IDS | OTHER_COMMAND_IDS
_NO_DATA_FRAME: Final = FrameFlag.EXTENDED | FrameFlag.REMOTE | FrameFlag.FD


class Sender(enum.StrEnum):
    """The sender of a frame."""

    ARM = "arm"
    OWN = "own"
    """This program."""
    OTHER = "other"
    """Another host, or a leader arm, which sends the same frames."""
    OTHER_ARM = "other_arm"
    """An arm with other identifier offsets (0x470)."""
    ADAPTER = "adapter"
    """No node of the bus: error frames are made by the adapter."""
    UNKNOWN = "unknown"


def sender_of(frame: Frame, flags: int, addressing: Addressing) -> Sender:
    """Return the sender of a received frame.

    The drivers' frames and the answers to settings have the same identifiers on every arm, so those
    of a second arm on the bus count as this arm's.

    Args:
        frame: The frame as received.
        flags: Its kind, `FrameFlag` bits.
        addressing: The identifier offsets of the arm.
    """
    if flags & FrameFlag.ERROR:
        return Sender.ADAPTER
    if flags & _NO_DATA_FRAME:
        return Sender.UNKNOWN
    arbitration_id, data = frame
    if arbitration_id in _HOSTS:
        return Sender.ARM if is_arms_answer(arbitration_id, data) else Sender.OTHER
    if arbitration_id == VERSION_ID:
        return Sender.OTHER if data == _QUESTION else Sender.ARM
    if arbitration_id in FIXED_FEEDBACK:
        return Sender.ARM
    if speaks_for_arm(arbitration_id):
        ours = addressing.from_wire(arbitration_id) is not None
        return Sender.ARM if ours else Sender.OTHER_ARM
    return Sender.UNKNOWN


def speaks_for_arm(arbitration_id: int) -> bool:
    """Return whether only arms send frames with this identifier, under any offset (0x470)."""
    return arbitration_id in FIXED_FEEDBACK or (
        arbitration_id in _FEEDBACK_OFFSETS and 1 <= arbitration_id & 0xF <= 8
    )
