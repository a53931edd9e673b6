"""Why the session cannot be recorded, or a recording not be kept."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal_codes import RefusalCode
from armui.ui.words.text import Texts

SESSION_REFUSALS: Final = Texts("Refusal") | {
    RefusalCode.SESSION_RECORDED: (
        "The session is being recorded already. Stop that recording first."
    ),
    RefusalCode.SESSION_NONE: "The session is not being recorded: there is nothing to stop.",
    RefusalCode.SESSION_NO_MF4: "MF4 needs the package asammdf (pip install asammdf).",
    RefusalCode.SESSION_MF4_CALLED_OFF: (
        "You called it off. The recording itself is whole, as .blf."
    ),
    RefusalCode.SESSION_SAVING: "The last minutes are being saved already. Wait a moment.",
    RefusalCode.SESSION_RING_EMPTY: (
        "Nothing has been heard on the bus yet: there is nothing to save."
    ),
    RefusalCode.SESSION_DISK_FULL: (
        "The disk of {folder} is full. What was written before can be read. Free some room or "
        "choose another folder, then record again."
    ),
    RefusalCode.SESSION_READ_ONLY: (
        "The folder {folder} cannot be written. Choose another folder for the session recordings, "
        "or allow this one to be written."
    ),
    RefusalCode.SESSION_FOLDER_GONE: (
        "The folder {folder}, or its disk, is gone. Plug it in again or choose another folder, "
        "then record again."
    ),
    RefusalCode.SESSION_FAILED: (
        "The session could not be recorded in {folder}: {text}. What was written before can be "
        "read. Choose another folder, or try again."
    ),
    RefusalCode.SESSION_NAME_BAD: (
        '“{name}” cannot be the name of a recording. Leave out / \\ : * ? " < > | and a dot at '
        "the beginning or the end; 120 characters at most."
    ),
    RefusalCode.SESSION_NAME_TAKEN: (
        "There is a file called “{name}” in the folder already. Choose another name."
    ),
    RefusalCode.SESSION_GONE: (
        "The recording “{name}” is not in the folder any more, or cannot be read: {text}."
    ),
    RefusalCode.SESSION_IN_USE: "“{name}” is still being written. Stop the recording first.",
}
