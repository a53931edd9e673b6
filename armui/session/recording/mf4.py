"""A recording once more as .mf4, where asammdf is installed.

python-can's writer of that format keeps everything in memory and writes at its end: a program that
is killed would lose all of it. So a session is recorded as .blf, and this is made of it afterwards.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Sequence
from pathlib import Path
from typing import Final

import can

from armui.session.recording.folder import files_of
from armui.session.recording.kinds import MF4_SUFFIX, RecordingFormat
from armui.system.atomic import WholeFile, remove_abandoned

PACKAGE: Final = "asammdf"


def can_write() -> bool:
    """Whether the package for it is installed; may wait for a disk."""
    return importlib.util.find_spec(PACKAGE) is not None


def make_mf4(folder: Path, name: str) -> Path:
    """Make an .mf4 file of a recording, beside it.

    Args:
        folder: Where the recording is.
        name: What it is called.

    Returns:
        The new file.

    Raises:
        ModuleNotFoundError: asammdf is not installed.
        FileExistsError: There is a file of this name.
        OSError: It could not be written; nothing remains of it.
        ValueError: There is no such recording.
    """
    if not can_write():
        raise ModuleNotFoundError(PACKAGE, name=PACKAGE)
    target = folder / f"{name}{MF4_SUFFIX}"
    paths = [path for path in files_of(folder, name) if path.suffix == RecordingFormat.BLF.value]
    write_mf4(paths, target)
    return target


def write_mf4(paths: Sequence[Path], target: Path) -> None:
    """Write the frames of some logs, one after another, into one .mf4 file.

    Args:
        paths: The logs.
        target: The file; it must not exist, and does so only when it is whole.

    Raises:
        FileExistsError: There is one of this name.
        OSError: It could not be written; what there was of it is removed.
    """
    remove_abandoned(target.parent)
    with WholeFile(target, replace=False) as whole:
        whole.stream.close()
        writer = can.MF4Writer(whole.unfinished)
        try:
            for path in paths:
                with can.BLFReader(path) as reader:
                    for message in reader:
                        writer.on_message_received(message)
        finally:
            writer.stop()
        whole.finish()
