"""Reads and writes the files of 参数备份, and returns errors as data."""

from __future__ import annotations

import errno
from collections.abc import Sequence
from datetime import datetime
from pathlib import Path
from typing import Final

from armui import __version__
from armui.arm.backup import BACKUP_FOREIGN, Backup, from_text, to_text
from armui.arm.parameters import Parameter, reading_of
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.protocol.generation import Generation, PiperModel
from armui.system.atomic import write_whole
from armui.system.files import error_text, read_file

BACKUP_UNREADABLE = Reason(
    "backup_unreadable", "The file {path} cannot be read: {text}. Choose another one."
)
BACKUP_NOT_WRITTEN = Reason(
    "backup_not_written",
    "The backup could not be written to {path}: {text}. Choose another folder.",
)


_LARGEST_BYTES: Final = 1_000_000
"""A backup has a few thousand bytes; a file this large is no backup."""


def read_backup(path: Path) -> Backup | Refusal:
    """Return the backup in a file, or why the file is none."""
    try:
        return from_text(read_file(path, _LARGEST_BYTES).decode("utf-8-sig"))
    except UnicodeDecodeError:
        return BACKUP_FOREIGN()
    except OSError as error:
        if error.errno == errno.EFBIG:
            return BACKUP_FOREIGN()
        return BACKUP_UNREADABLE(path=str(path), text=error_text(error))


def write_backup(path: Path, backup: Backup) -> Refusal | None:
    """Write a backup to a file; return ``None``, or why it could not be written."""
    try:
        write_whole(path, to_text(backup).encode())
    except OSError as error:
        return BACKUP_NOT_WRITTEN(path=str(path), text=error_text(error))
    return None


def backup_of(
    state: ArmState,
    parameters: Sequence[Parameter],
    generation: Generation,
    device: str,
    now: datetime,
    *,
    model: PiperModel | None = None,
) -> Backup:
    """Return a backup of the arm's known values; unread ones are left out."""
    return Backup(
        saved_at=now,
        program=f"armui {__version__}",
        generation=int(generation),
        firmware=state.firmware,
        device=device,
        model=model,
        values={
            parameter: known.value
            for parameter in parameters
            if (known := reading_of(state, parameter)) is not None
        },
    )
