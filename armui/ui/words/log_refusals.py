"""Reasons why a log cannot be replayed."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal_codes import RefusalCode
from armui.ui.words.text import Texts

LOG_REFUSALS: Final = Texts("Refusal") | {
    RefusalCode.REPLAYED_LOG: (
        "This is a recording that is replayed: nothing can be sent. Whatever is to reach an arm is "
        "done in the main window."
    ),
    RefusalCode.REPLAY_EMPTY: (
        "{name} is a log without a single frame: there is nothing to replay. Record again, with "
        "the arm switched on."
    ),
    RefusalCode.REPLAY_NO_LOG: (
        "Nothing in {name} reads as a frame of a CAN log ({text}). Choose the file that the "
        "recording program has written, with its own ending."
    ),
    RefusalCode.REPLAY_NOTHING_READ: (
        "Nothing in {name} reads as a frame of a CAN log of its ending. Choose the file that the "
        "recording program has written, with its own ending."
    ),
    RefusalCode.REPLAY_ARCHIVE: (
        "{name} is a packed archive, whatever its ending says. Unpack it, and open the log that "
        "was in it."
    ),
    RefusalCode.REPLAY_UNKNOWN_KIND: (
        "By its name {name} is no CAN log. Known endings: {known}, most of them also with .gz "
        "behind. Rename the file, or choose another."
    ),
    RefusalCode.REPLAY_UNREADABLE: (
        "{name} cannot be opened: {text}. Look whether it is still there and may be read."
    ),
    RefusalCode.REPLAY_NO_DISK: (
        "The log is read into temporary files, and these cannot be written: {text}. Make room on "
        "the disk, or set TMPDIR to a folder with more."
    ),
    RefusalCode.REPLAY_FAILED: (
        "{name} can be read no further: {text}. Open it again; if that does not help, copy it to "
        "another disk first."
    ),
}
"""Sentences by code; figures in braces."""
