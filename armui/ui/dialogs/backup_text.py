"""What the window 参数备份 says of a file and of its way into the arm."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from armui.arm.backup import Backup
from armui.arm.models import model_data
from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.protocol.generation import Generation, PiperModel
from armui.ui import format as fmt
from armui.ui import words

Said = tuple[str, Level]
"""A text and how much it matters."""


def origin(backup: Backup | None, path: Path | None) -> str:
    """Where the values of the file come from; or that there is no file."""
    if backup is None or path is None:
        return QCoreApplication.translate(
            "BackupDialog", "No file is open; the arm's own values are shown."
        )
    text = QCoreApplication.translate(
        "BackupDialog",
        "{name}: saved {time}, {model}, {device}, generation {generation}, {firmware}",
    )
    return text.format(
        name=path.name,
        model=_name(backup.model),
        time=f"{backup.saved_at.astimezone():%Y-%m-%d %H:%M}",
        device=backup.device,
        generation=backup.generation,
        firmware=backup.firmware or fmt.NOTHING,
    )


def difference(
    backup: Backup,
    generation: Generation | None,
    firmware: str | None,
    model: PiperModel | None = None,
) -> str:
    """What sets the arm of the file apart from this one; empty: nothing that is known.

    Args:
        backup: The file.
        generation: What this arm speaks; ``None``: not known yet.
        firmware: Of this arm; ``None``: it has not told.
        model: What this arm was connected as.
    """
    if None not in {backup.model, model} and backup.model is not model:
        text = QCoreApplication.translate(
            "BackupDialog",
            "The file is from a {filed}, this arm is a {here}: the limits of one may be wrong for "
            "the other. Check the values before you restore them.",
        )
        return text.format(filed=_name(backup.model), here=_name(model))
    if generation is None:
        return ""
    if int(generation) != backup.generation:
        text = QCoreApplication.translate(
            "BackupDialog",
            "The file is from an arm of protocol generation {filed}, this one speaks "
            "generation {here}. What both have can be restored; the steps of the values differ.",
        )
        return text.format(filed=backup.generation, here=int(generation))
    if firmware != backup.firmware:
        text = QCoreApplication.translate(
            "BackupDialog",
            "The file is from firmware {filed}, this arm has {here}. Check the values before "
            "you restore them.",
        )
        return text.format(filed=backup.firmware or fmt.NOTHING, here=firmware or fmt.NOTHING)
    return ""


def _name(model: PiperModel | None) -> str:
    return fmt.NOTHING if model is None else model_data(model).name


def saved(path: Path, count: int, missing: int) -> Said:
    """That a file was written, and how many parameters of the arm are not in it."""
    text = QCoreApplication.translate("BackupDialog", "Saved {count} parameters to {path}.")
    if missing > 0:
        rest = QCoreApplication.translate(
            "BackupDialog", "{missing} could not be read from the arm and are not in the file."
        )
        text = f"{text} {rest}"
    text = text.format(count=count, path=path, missing=missing)
    return text, Level.WARNING if missing > 0 else Level.DONE


def restored(count: int, failed: Sequence[Refusal | None]) -> Said:
    """How restoring has ended.

    Args:
        count: How many parameters were to be restored.
        failed: Of each that the arm does not hold, the reason as far as it is known.
    """
    if not failed:
        text = QCoreApplication.translate(
            "BackupDialog", "Restored {count} parameters: read back from the arm, and the same."
        )
        return text.format(count=count), Level.DONE
    text = QCoreApplication.translate(
        "BackupDialog", "{failed} of {count} parameters were not restored."
    )
    text = text.format(failed=len(failed), count=count)
    return f"{text} {words.why_not(failed[0])}".rstrip(), Level.FAULT
