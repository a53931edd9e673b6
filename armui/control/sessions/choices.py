"""The operator's choices for the recordings of sessions."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

from armui.session.recording.kinds import RecordingFormat
from armui.setting_fields import Settings
from armui.system import paths

MEGABYTE: Final = 1_000_000


@dataclass(frozen=True, slots=True)
class SessionChoices:
    """The choices for the recordings of sessions.

    Attributes:
        folder: The folder of the recordings.
        kind: The format of the next recording.
        rotate_bytes: The size at which a file is followed by another.
        save_at_faults: True to save the ring automatically at a fault or a stop.
    """

    folder: Path
    kind: RecordingFormat = RecordingFormat.BLF
    rotate_bytes: int = 100 * MEGABYTE
    save_at_faults: bool = False


def choices_of(settings: Settings) -> SessionChoices:
    """Return the choices for recordings that the settings hold."""
    return SessionChoices(
        folder=Path(settings.session_folder) if settings.session_folder else paths.sessions(),
        kind=RecordingFormat(settings.session_format),
        rotate_bytes=settings.session_rotate_mb * MEGABYTE,
        save_at_faults=settings.session_save_at_faults,
    )
