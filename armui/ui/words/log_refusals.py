"""Reasons why a log cannot be replayed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.refusal_codes import RefusalCode

LOG_REFUSALS: Final[Mapping[RefusalCode, object]] = {
    RefusalCode.REPLAYED_LOG: QT_TRANSLATE_NOOP(
        "Refusal",
        "This is a recording that is replayed: nothing can be sent. Whatever is to reach an arm is "
        "done in the main window.",
    ),
    RefusalCode.REPLAY_EMPTY: QT_TRANSLATE_NOOP(
        "Refusal",
        "{name} is a log without a single frame: there is nothing to replay. Record again, with "
        "the arm switched on.",
    ),
    RefusalCode.REPLAY_NO_LOG: QT_TRANSLATE_NOOP(
        "Refusal",
        "Nothing in {name} reads as a frame of a CAN log ({text}). Choose the file that the "
        "recording program has written, with its own ending.",
    ),
    RefusalCode.REPLAY_NOTHING_READ: QT_TRANSLATE_NOOP(
        "Refusal",
        "Nothing in {name} reads as a frame of a CAN log of its ending. Choose the file that the "
        "recording program has written, with its own ending.",
    ),
    RefusalCode.REPLAY_ARCHIVE: QT_TRANSLATE_NOOP(
        "Refusal",
        "{name} is a packed archive, whatever its ending says. Unpack it, and open the log that "
        "was in it.",
    ),
    RefusalCode.REPLAY_UNKNOWN_KIND: QT_TRANSLATE_NOOP(
        "Refusal",
        "By its name {name} is no CAN log. Known endings: {known}, most of them also with .gz "
        "behind. Rename the file, or choose another.",
    ),
    RefusalCode.REPLAY_UNREADABLE: QT_TRANSLATE_NOOP(
        "Refusal",
        "{name} cannot be opened: {text}. Look whether it is still there and may be read.",
    ),
    RefusalCode.REPLAY_NO_DISK: QT_TRANSLATE_NOOP(
        "Refusal",
        "The log is read into temporary files, and these cannot be written: {text}. Make room on "
        "the disk, or set TMPDIR to a folder with more.",
    ),
    RefusalCode.REPLAY_FAILED: QT_TRANSLATE_NOOP(
        "Refusal",
        "{name} can be read no further: {text}. Open it again; if that does not help, copy it to "
        "another disk first.",
    ),
}
"""Sentences by code; figures in braces."""
