"""Files of trajectories and recordings: the format is recognised by content; read and written."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Final

from armui.arm.refusal import Reason
from armui.system.files import error_text, open_file
from armui.trajectory.files import csv_file, json_file, log_file, npz_file
from armui.trajectory.files.errors import TrajectoryFileError, broken
from armui.trajectory.files.log_file import FILE_KIND_UNKNOWN
from armui.trajectory.files.model import LARGEST_BYTES, Content, UnwritableError, verified
from armui.trajectory.files.text import decode
from armui.trajectory.planning.tool_points import KEPT_DECIMALS, ToolPoints, rounded
from armui.trajectory.points.program import OF_FLANGE, PosesOf, Trajectory
from armui.trajectory.samples.recording import Recording

FILE_TOO_LARGE = Reason(
    "file_too_large", "The file has {value} MB; at most {maximum} MB can be read."
)
FILE_UNREADABLE = Reason("file_unreadable", "The file cannot be read: {text}.")
FILE_EMPTY = Reason("file_empty", "The file is empty.")


__all__ = [
    "SUFFIXES",
    "Content",
    "TrajectoryFileError",
    "UnwritableError",
    "is_ours",
    "load",
    "load_bytes",
    "load_with_origin",
    "name_in",
    "read_bytes",
    "read_text",
    "to_bytes",
]

_WRITERS: Final[dict[str, Callable[[Content], bytes]]] = {
    ".log": lambda content: log_file.write(content).encode(),
    # The byte order mark makes spreadsheets read the file as UTF-8.
    ".csv": lambda content: b"\xef\xbb\xbf" + csv_file.write(content).encode(),
    ".json": lambda content: json_file.write(content).encode(),
    # The format of .log under a suffix that desktops do not assign to other programs.
    ".armui": lambda content: log_file.write(content).encode(),
}
SUFFIXES: Final = tuple(_WRITERS)
"""The suffixes of the formats offered to the operator."""
_HEAD_BYTES: Final = 4096
"""The length of a beginning that holds the first two lines with the longest name."""


def to_bytes(content: Content, suffix: str, poses_of: PosesOf = OF_FLANGE) -> bytes:
    """Return a trajectory or recording as the bytes of a file.

    Args:
        content: The content to write.
        suffix: One of :data:`SUFFIXES`; for a recording also ``.npz``.
        poses_of: The tool whose poses are written, by default those of the flange, and where the
            user frames stand. ``.armui``, which no other program reads, is written without.

    Raises:
        UnwritableError: The content cannot be written.
        ValueError: There is no such format for it.
    """
    if isinstance(content, Trajectory) and suffix != ".armui":
        content = _written_for(content, poses_of)
    if suffix == ".npz" and isinstance(content, Recording):
        return npz_file.write(content)
    writer = _WRITERS.get(suffix)
    if writer is None:
        raise ValueError(f"no format {suffix!r} for this; choose one of {', '.join(SUFFIXES)}")
    return writer(content)


def load(path: Path) -> Content:
    """Return the trajectory or recording in a file of any of our formats, or of the maker's.

    Raises:
        TrajectoryFileError: The file cannot be read or has an unknown format; the error names it.
    """
    with _named(path):
        return read_bytes(_bytes_of(path), path.stem)


def load_with_origin(path: Path) -> tuple[Content, PosesOf]:
    """Return the result of :func:`load`, and the tool and frames of the poses in the file.

    Raises:
        TrajectoryFileError: As in :func:`load`.
    """
    with _named(path):
        content = _read_bytes(_bytes_of(path), path.stem)
        return _kept(content), content.poses_of if isinstance(content, Trajectory) else OF_FLANGE


def load_bytes(path: Path) -> bytes:
    """Return the bytes of a file of any kind, for the import by columns.

    Raises:
        TrajectoryFileError: The file cannot be read; the error names it.
    """
    with _named(path):
        return _bytes_of(path)


def name_in(path: Path) -> str | None:
    """Return the name in a file of the library; only the file's beginning is read.

    Raises:
        OSError: It cannot be read.
    """
    with open_file(path) as file:
        head = file.read(_HEAD_BYTES)
        if head.startswith(npz_file.MAGIC):
            return npz_file.name_in(file)
    return log_file.name_in(head.decode(errors="ignore"))


def is_ours(text: str) -> bool:
    """Return whether a text, valid or not, begins as a format of ours other than a plain table."""
    return log_file.is_log(text) or json_file.is_ours(text)


def _bytes_of(path: Path) -> bytes:
    with open_file(path) as file:
        size = os.fstat(file.fileno()).st_size
        if size > LARGEST_BYTES:
            mega, most = 1024 * 1024, LARGEST_BYTES
            raise broken(FILE_TOO_LARGE, value=size // mega, maximum=most // mega)
        return file.read(LARGEST_BYTES)


@contextlib.contextmanager
def _named(path: Path) -> Iterator[None]:
    """Add the file's name to errors raised inside."""
    try:
        yield
    except TrajectoryFileError as error:
        raise TrajectoryFileError(error.refusal, error.line, error.column, path.name) from error
    except OSError as error:
        reason = broken(FILE_UNREADABLE, text=error_text(error)).refusal
        raise TrajectoryFileError(reason, file=path.name) from error


def read_bytes(data: bytes, name: str) -> Content:
    """Return the content of a file's bytes; they decide the format, not the file's name.

    Args:
        data: The bytes.
        name: The name used if the bytes hold none.

    Raises:
        TrajectoryFileError: The format is unknown, or the content is damaged.
    """
    return _kept(_read_bytes(data, name))


def read_text(text: str, name: str) -> Content:
    """Return the content of a text, as from the clipboard; see :func:`read_bytes`.

    Raises:
        TrajectoryFileError: As in :func:`read_bytes`.
    """
    return _kept(_read_text(text, name))


def _written_for(content: Trajectory, poses_of: PosesOf) -> Trajectory:
    """Return a trajectory with poses of a tool, and with what it names of the cell."""
    named = {point.frame for point in content.points}
    frames = tuple(frame for frame in poses_of.frames if frame.name in named)
    tool = poses_of.tool
    if tool is None or not any(tool.pose) or all(point.is_joint for point in content.points):
        return replace(content, poses_of=PosesOf(None, frames))
    # With so many decimals turns are read back unchanged even close to RY 90°.
    points = tuple(ToolPoints(tool.pose, KEPT_DECIMALS).all_shown(content.points))
    return replace(content, points=points, poses_of=PosesOf(tool, frames))


def _kept(content: Content) -> Content:
    """Return content that was read, with its poses converted to those of the flange.

    Raises:
        TrajectoryFileError: A pose is possible for no arm.
    """
    if not isinstance(content, Trajectory) or content.poses_of == OF_FLANGE:
        return content
    tool, points = content.poses_of.tool, content.points
    if tool is not None:
        points = tuple(map(rounded, ToolPoints(tool.pose).all_kept(points)))
    return verified(replace(content, points=points, poses_of=OF_FLANGE))


def _read_bytes(data: bytes, name: str) -> Content:
    if data.startswith(npz_file.MAGIC):
        return npz_file.read(data)
    return _read_text(decode(data), name)


def _read_text(text: str, name: str) -> Content:
    name = name if name.strip() else "?"
    if not text.strip():
        raise broken(FILE_EMPTY)
    if csv_file.is_csv(text):
        return csv_file.read(text, name)
    if log_file.is_log(text):
        return log_file.read(text, name)
    if json_file.is_json(text):
        return json_file.read(text, name)
    if csv_file.is_maker_csv(text):
        return csv_file.read_maker_csv(text, name)
    raise broken(FILE_KIND_UNKNOWN, 1)
