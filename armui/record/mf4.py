"""A recording once more as .mf4, where asammdf is installed.

python-can's writer of that format keeps everything in memory and writes at its end: a program that
is killed would lose all of it. So a session is recorded as .blf, and this is made of it afterwards.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path

import can

MISSING = "--format mf4 needs asammdf. Install it: pip install asammdf; or record as blf"


def can_write() -> bool:
    """Whether the package for it is installed."""
    return importlib.util.find_spec("asammdf") is not None


def write_mf4(
    paths: Sequence[Path],
    target: Path,
    make_writer: Callable[[Path], can.Listener] = can.MF4Writer,
) -> None:
    """Write the frames of some logs, one after another, into one .mf4 file.

    Args:
        paths: The logs.
        target: The file; it must not exist.
        make_writer: python-can's writer.

    Raises:
        FileExistsError: There is one of this name.
        OSError: It could not be written; what there was of it is removed.
    """
    with target.open("xb"):
        pass
    try:
        writer = make_writer(target)
        for path in paths:
            with can.BLFReader(path) as reader:
                for message in reader:
                    writer.on_message_received(message)
        writer.stop()
    except BaseException:
        with suppress(OSError):
            target.unlink()
        raise
