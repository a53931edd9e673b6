"""Reads logs in ASAM's format (.mf4) with asammdf, in a process of its own.

A damaged file may make asammdf loop forever, take all the memory, or crash: then only this file is
lost.
"""

from __future__ import annotations

import contextlib
import logging
import multiprocessing
import sys
from typing import TYPE_CHECKING, Any, Final

import can

from armui.system.helper_process import configure_process

if TYPE_CHECKING:
    from collections.abc import Generator

    if sys.platform == "win32":
        from multiprocessing.connection import PipeConnection as Connection
    else:
        from multiprocessing.connection import Connection
    from pathlib import Path

_ROWS: Final = 4_096
_ANSWERS_WITHIN_S: Final = 60.0
"""The longest wait: a file of gigabytes is opened, and some thousand rows are read, in some
seconds.
"""
_MOST_MEMORY_BYTES: Final = 4 << 30
"""The memory allowed besides twice the file's size; most of it is unused address space."""
_ENDS_WITHIN_S: Final = 1.0

Rows = list[can.Message]


class Mf4ProcessError(Exception):
    """The file cannot be read, or not from here on; the text tells why."""


def rows_of(path: Path) -> Generator[Rows]:
    """Yield the frames of a file; the first item is empty, once the file is opened.

    Raises:
        Mf4ProcessError: It cannot be read from here on.
    """
    context = multiprocessing.get_context("spawn")
    ours, its = context.Pipe(duplex=False)
    process = context.Process(target=_read, args=(path, its), name="armui-mf4", daemon=True)
    process.start()
    its.close()
    try:
        while (rows := _answer(ours)) is not None:
            yield rows
    finally:
        process.kill()
        process.join(_ENDS_WITHIN_S)
        ours.close()


def _answer(ours: Connection) -> Rows | None:
    """Return what the process has read; ``None``: that was all."""
    if not ours.poll(_ANSWERS_WITHIN_S):
        raise Mf4ProcessError(f"asammdf reads nothing more within {_ANSWERS_WITHIN_S:g} s")
    try:
        answer = ours.recv()
    except (EOFError, OSError):
        raise Mf4ProcessError("asammdf ends without a word when it reads on") from None
    if isinstance(answer, str):
        raise Mf4ProcessError(answer)
    return answer  # type: ignore[no-any-return]


def _read(path: Path, its: Connection) -> None:
    """In the new process: send what it reads, and what goes wrong."""
    configure_process()
    logging.disable()
    with contextlib.redirect_stdout(None), contextlib.redirect_stderr(None):
        try:
            _limit_memory(path.stat().st_size)
            _send_rows(path, its)
            its.send(None)
        except BaseException as error:  # noqa: BLE001 - a damaged file has asammdf raise whatever it hits
            its.send(" ".join(str(error).split())[:_LONGEST] or type(error).__name__)


_LONGEST: Final = 200


def _send_rows(path: Path, its: Connection) -> None:
    reader = can.MF4Reader(path)
    rows: Rows = []
    its.send(rows)
    try:
        for message in reader:
            rows.append(message)
            if len(rows) == _ROWS:
                its.send(rows)
                rows = []
    finally:
        its.send(rows)


def _limit_memory(file_bytes: int) -> None:
    if sys.platform != "win32":
        import resource  # noqa: PLC0415 - not on Windows

        limits: Any = resource.getrlimit(resource.RLIMIT_AS)
        wanted = _MOST_MEMORY_BYTES + 2 * file_bytes
        if limits[0] == resource.RLIM_INFINITY or limits[0] > wanted:
            resource.setrlimit(resource.RLIMIT_AS, (wanted, limits[1]))
