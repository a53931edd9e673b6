"""Converts a recording to .mf4, if asammdf is installed.

python-can's writer of that format keeps everything in memory and writes at its end: a program that
is killed would lose all of it. So a session is recorded as .blf, and this is made of it afterwards.
"""

from __future__ import annotations

import contextlib
import importlib.util
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Final

import can

from armui.session.recording.folder import files_of
from armui.session.recording.kinds import MF4_SUFFIX, RecordingFormat
from armui.system.atomic import WholeFile, remove_abandoned
from armui.system.files import open_file

PACKAGE: Final = "asammdf"
_TOLD_EVERY: Final = 2_000
_TAKEN_IN: Final = 0.9
"""The share of the work done when every frame is read; the rest is its writing."""


def can_write() -> bool:
    """Return whether asammdf is installed; may wait for a disk."""
    return importlib.util.find_spec(PACKAGE) is not None


@contextlib.contextmanager
def told_in(path: Path) -> Iterator[Callable[[float], None]]:
    """Write the progress to a file as a number, for another process."""
    with open_file(path, "wb") as file:

        def tell(share: float) -> None:
            file.seek(0)
            file.write(f"{share:.4f}".encode())
            file.flush()

        yield tell


def make_mf4(
    folder: Path,
    name: str,
    tell: Callable[[float], object] = lambda _share: None,
    *,
    unfinished: Path | None = None,
) -> Path:
    """Make an .mf4 file of a recording, beside it.

    Args:
        folder: The recording's folder.
        name: The recording's name.
        tell: Called now and then with the share done, 0 to 1; an exception cancels the work.
        unfinished: The file's name until it is complete.

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
    write_mf4(paths, target, tell=tell, unfinished=unfinished)
    return target


def write_mf4(
    paths: Sequence[Path],
    target: Path,
    *,
    tell: Callable[[float], object] = lambda _share: None,
    unfinished: Path | None = None,
) -> None:
    """Write the frames of some logs, one after another, into one .mf4 file.

    Args:
        paths: The logs.
        target: The file; it must not exist, and appears only when it is complete.
        tell: As for `make_mf4`.
        unfinished: Likewise.

    Raises:
        FileExistsError: There is one of this name.
        OSError: It could not be written; the incomplete file is removed.
    """
    remove_abandoned(target.parent)
    sizes = [path.stat().st_size for path in paths]
    with WholeFile(target, replace=False, unfinished=unfinished) as whole:
        whole.stream.close()
        writer = can.MF4Writer(whole.unfinished)
        try:
            for place, path in enumerate(paths):
                with open_file(path) as file, can.BLFReader(file) as reader:
                    for number, message in enumerate(reader):
                        writer.on_message_received(message)
                        if number % _TOLD_EVERY == 0:
                            read = sum(sizes[:place]) + reader.file.tell()
                            tell(_TAKEN_IN * min(1.0, read / max(1, sum(sizes))))
            writer.stop()
        except BaseException:
            # `stop` would write all of it first
            with contextlib.suppress(AttributeError, OSError):
                writer.file.close()
            raise
        whole.finish()
