"""Operations on the files of recordings, for the file thread; failures are returned as data."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from armui.arm.refusal import Reason, Refusal
from armui.control.sessions.session_recorder import SESSION_NAME_BAD
from armui.session.recording.kinds import SESSION_FAILED
from armui.system.files import error_text

if TYPE_CHECKING:
    from armui.session.recording.folder import RecordingEntry

SESSION_NAME_TAKEN = Reason(
    "session_name_taken",
    "There is a file called “{name}” in the folder already. Choose another name.",
)
SESSION_GONE = Reason(
    "session_gone", "The log “{name}” is not in the folder any more, or cannot be read: {text}."
)


def listing(folder: Path) -> list[RecordingEntry] | Refusal:
    """Return the recordings of a folder, or why it cannot be read."""
    from armui.session.recording.folder import list_recordings  # noqa: PLC0415 - numpy

    try:
        return list_recordings(folder)
    except OSError as error:
        params = {"folder": str(folder), "text": error_text(error)}
        return SESSION_FAILED(**params)


def renamed(folder: Path, name: str, new_name: str) -> str | Refusal:
    """Return the new name of a recording, or why it keeps its own."""
    from armui.session.recording.folder import rename  # noqa: PLC0415 - numpy

    try:
        rename(folder, name, new_name)
    except FileExistsError as error:
        return SESSION_NAME_TAKEN(name=str(error))
    except ValueError:
        return SESSION_NAME_BAD(name=new_name)
    except OSError as error:
        return SESSION_GONE(name=name, text=error_text(error))
    return new_name


def thrown_away(folder: Path, names: tuple[str, ...]) -> Path | Refusal:
    """Move recordings to the bin; return the new folder of the last, or why one stays."""
    from armui.session.recording.folder import BIN, throw_away  # noqa: PLC0415 - numpy

    place = folder / BIN
    for name in names:
        try:
            place = throw_away(folder, name)
        except (OSError, ValueError) as error:
            return SESSION_GONE(name=name, text=error_text(error))
    return place
