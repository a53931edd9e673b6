"""Recognizes CAN logs among imported files: they are for the replay, and hold no points."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from armui.arm.refusal import Reason
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.importing import find_or_import, import_files

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from armui.trajectory.library.importing import Imported

FILE_CAN_LOG = Reason(
    "file_can_log",
    "This is a CAN log, which holds no points. Under Log, “Replay another log…” opens it.",
)


def find_or_import_but_logs(folder: Path, path: Path, new_in: str = "") -> Imported:
    """Find a file's content in the library, or import it; a CAN log is refused as one."""
    return _refused_if_log(find_or_import(folder, path, new_in))


def import_all_but_logs(folder: Path, paths: Sequence[Path], new_in: str = "") -> list[Imported]:
    """Import files into the library; CAN logs among them are refused as such."""
    return [_refused_if_log(each) for each in import_files(folder, paths, new_in)]


def _refused_if_log(imported: Imported) -> Imported:
    """Return the result for a file; a CAN log is refused, although it has columns."""
    # imported here, because the window starts without python-can
    from armui.session.frames import NotALogError  # noqa: PLC0415
    from armui.session.reader import LogFile  # noqa: PLC0415

    if not isinstance(imported.error, TrajectoryFileError):
        return imported
    try:
        with LogFile(imported.path):
            error = TrajectoryFileError(FILE_CAN_LOG(), file=imported.path.name)
            return replace(imported, error=error, is_table=False)
    except NotALogError:
        return imported
