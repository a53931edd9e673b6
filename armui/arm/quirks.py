"""The behaviour of the arm's firmware, by the version the arm has named: pure."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.arm.refusal import Reason, Refusal
from armui.protocol.firmware_version import FirmwareVersion, ModeExit, first_with, quirks_of

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.protocol.firmware_version import FirmwareQuirks

FIRMWARE_UNKNOWN = Reason(
    "firmware_unknown",
    "The arm has not named its firmware, and only {since} and later have this. Connect again "
    "to ask for it.",
)
NEEDS_FIRMWARE = Reason(
    "needs_firmware",
    "The arm's firmware {firmware} does not have this: it came with {since}. Updates come from "
    "the maker's support.",
)


def told_quirks(state: ArmState) -> FirmwareQuirks | None:
    """Return the quirks of the arm's firmware; ``None`` while it has named no version."""
    version = None if state.firmware is None else FirmwareVersion.parse(state.firmware)
    return None if version is None else quirks_of(version)


def frees_gripper(state: ArmState) -> bool | None:
    """Return whether disabling all joints frees the gripper; ``None``: no version was named."""
    quirks = told_quirks(state)
    return None if quirks is None else quirks.disable_frees_gripper


def leaves_by_mode_word(version: str) -> bool:
    """Return whether firmware of this version leaves MIT and its like by a mode word."""
    parsed = FirmwareVersion.parse(version)
    return parsed is not None and quirks_of(parsed).mode_exit is ModeExit.MODE_WORD


def exits_by_mode_word(state: ArmState) -> bool:
    """Return whether the arm's firmware is known to leave MIT and its like by a mode word."""
    return state.firmware is not None and leaves_by_mode_word(state.firmware)


def why_not_by_firmware(state: ArmState, field: str) -> Refusal | None:
    """Return the reason why this firmware may lack a frame, or ``None`` if it may be sent.

    Args:
        state: The arm's state.
        field: A field of `FirmwareQuirks` that begins with ``has_``.
    """
    quirks = told_quirks(state)
    since = str(first_with(field))
    if quirks is None:
        return FIRMWARE_UNKNOWN(since=since)
    if getattr(quirks, field):
        return None
    return NEEDS_FIRMWARE(firmware=str(quirks.version), since=since)
