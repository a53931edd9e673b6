"""What the operator chose for the recordings of sessions."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

from armui.session.recording.kinds import MF4_SUFFIX, RecordingFormat
from armui.settings import Settings
from armui.system import paths

MEGABYTE: Final = 1_000_000


@dataclass(frozen=True, slots=True)
class SessionChoices:
    """How and where sessions are recorded.

    Attributes:
        folder: Where.
        kind: The format of what is recorded next.
        as_mf4: Whether an .mf4 file is made of it when it has ended.
        rotate_bytes: A file that is as large is followed by another.
        save_at_faults: Whether the ring is saved by itself when a fault or a stop happens.
    """

    folder: Path
    kind: RecordingFormat = RecordingFormat.BLF
    as_mf4: bool = False
    rotate_bytes: int = 100 * MEGABYTE
    save_at_faults: bool = False


def choices_of(settings: Settings) -> SessionChoices:
    """Return the choices as they stand in the settings."""
    as_mf4 = settings.session_format == MF4_SUFFIX
    return SessionChoices(
        folder=Path(settings.session_folder) if settings.session_folder else paths.sessions(),
        kind=RecordingFormat.BLF if as_mf4 else RecordingFormat(settings.session_format),
        as_mf4=as_mf4,
        rotate_bytes=settings.session_rotate_mb * MEGABYTE,
        save_at_faults=settings.session_save_at_faults,
    )
