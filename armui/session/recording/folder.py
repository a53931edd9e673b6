"""The recordings in a folder: listing, renaming, deleting."""

from __future__ import annotations

import contextlib
import os
import secrets
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from armui.session.recording import index_file, sidecar
from armui.session.recording.counted import counts_in
from armui.session.recording.kinds import RecordingFormat, file_name, is_name
from armui.system.files import error_text, open_file

BIN: Final = "deleted"
"""The subfolder for deleted recordings, from which they can be restored by hand."""
_HEAD_BYTES: Final = 65_536
_MOST_PARTS: Final = 10_000


@dataclass(frozen=True, slots=True)
class RecordingEntry:
    """One recording of a folder.

    Attributes:
        name: Its name.
        path: Its first file; None while it has no frame.
        begun_unix_s: The time at which it began, in seconds since 1970, which is that of its first
            frame if it was saved from memory; 0 if its sidecar does not hold it.
        length_s: The time from its first frame to its last; None if its index does not hold it.
        total_bytes: The size of all its files.
        files: The number of files with frames.
        faults, stops: The numbers of faults and stops; ``None`` if not counted yet.
        ended: True if it was ended properly; false while it is in progress.
        failure: The error that ended it early, "" if none.
        reason: The source of the request: ``operator``, ``ring``, ``fault``, ``stop``, ``command``.
        damage: The reason why its sidecar cannot be read, "" if it can.
    """

    name: str
    path: Path | None
    begun_unix_s: float
    length_s: float | None
    total_bytes: int
    files: int
    faults: int | None
    stops: int | None
    ended: bool
    failure: str = ""
    reason: str = "operator"
    damage: str = ""


def list_recordings(folder: Path) -> list[RecordingEntry]:
    """Return the recordings of a folder, the newest first; none if the folder does not exist.

    One whose sidecar cannot be read is listed with its damage.

    Raises:
        OSError: It cannot be read.
    """
    try:
        names = [entry.name for entry in os.scandir(folder) if entry.name.endswith(sidecar.SUFFIX)]
    except FileNotFoundError:
        return []
    found = []
    for each in names:
        with contextlib.suppress(OSError):  # gone, or no longer to be read, meanwhile
            found.append(_entry(folder, each.removesuffix(sidecar.SUFFIX)))
    return sorted(found, key=lambda entry: entry.begun_unix_s, reverse=True)


def _entry(folder: Path, name: str) -> RecordingEntry:
    """Return one of them.

    Raises:
        OSError: Its files cannot be looked at.
    """
    damage, lines = "", []
    try:
        with open_file(sidecar.path_of(folder, name)) as stream:
            lines = sidecar.read_lines(stream.read(sidecar.MOST_BYTES))
    except FileNotFoundError:
        raise
    except OSError as error:
        damage = error_text(error)
    first: Mapping[str, Any] = lines[0] if lines else {}
    if not damage and (first.get("kind") != "session" or sidecar.format_in(first) is None):
        damage = f"{name}{sidecar.SUFFIX}"
    paths = _parts(folder, name, sidecar.format_in(first))
    last = next((line for line in reversed(lines) if line["kind"] == "end"), None)
    counts = None if damage else counts_in(lines)
    span_s = _span_s(folder / f"{name}{index_file.SUFFIX}")
    return RecordingEntry(
        name=name,
        path=paths[0] if paths else None,
        begun_unix_s=_begun_s(sidecar.number_in(first, "unix_s") or 0.0, span_s),
        length_s=None if span_s is None else max(0.0, span_s[1] - span_s[0]),
        total_bytes=sum(path.stat().st_size for path in paths),
        files=len(paths),
        faults=None if counts is None else counts.faults,
        stops=None if counts is None else counts.stops,
        ended=last is not None,
        failure="" if last is None else sidecar.text_in(last, "failure"),
        reason=sidecar.text_in(first, "reason", "operator"),
        damage=damage,
    )


def _begun_s(written_s: float, span_s: tuple[float, float] | None) -> float:
    """Return when a recording began: what was saved from memory began before it was written."""
    return written_s if span_s is None else min(written_s, span_s[0])


def _span_s(index: Path) -> tuple[float, float] | None:
    """Return the times of the first and the last frame, without reading all that is between."""
    try:
        with open_file(index) as stream:
            beginning = stream.read(_HEAD_BYTES)
            size = stream.seek(0, os.SEEK_END)
            stream.seek(max(0, size - _HEAD_BYTES))
            end = stream.read(_HEAD_BYTES)
    except OSError:
        return None
    first = next(index_file.read_blocks(beginning), None)
    last = index_file.last_block(end)
    return None if first is None or last is None else (first.first_s, last.last_s)


def _parts(folder: Path, name: str, kind: RecordingFormat | None) -> list[Path]:
    """Return the files with frames; if their format is not named, in the first one found."""
    if kind is None:
        found = (_parts(folder, name, each) for each in RecordingFormat)
        return next((paths for paths in found if paths), [])
    paths = []
    for number in range(1, _MOST_PARTS):
        path = folder / file_name(name, number, kind.value)
        if not path.exists():
            break
        paths.append(path)
    return paths


def files_of(folder: Path, name: str) -> list[Path]:
    """Return every file of a recording, its sidecar last.

    Raises:
        OSError: The folder cannot be read.
    """
    side = sidecar.path_of(folder, name)
    with open_file(side) as stream:
        lines = sidecar.read_lines(stream.readline(_HEAD_BYTES))
    paths = _parts(folder, name, sidecar.format_in(lines[0]) if lines else None)
    index = folder / f"{name}{index_file.SUFFIX}"
    return [*paths, *([index] if index.exists() else []), side]


def rename(folder: Path, name: str, new_name: str) -> None:
    """Rename a recording.

    Raises:
        ValueError: The name is invalid.
        FileExistsError: Another recording or file has this name.
        OSError: The files cannot be moved; those that were have been moved back.
    """
    if not is_name(new_name):
        raise ValueError(new_name)
    paths = files_of(folder, name)
    targets = [folder / f"{new_name}{path.name.removeprefix(name)}" for path in paths]
    for target, path in zip(targets, paths, strict=True):
        if target.exists() and not (target.name.lower() == path.name.lower()):
            raise FileExistsError(target.name)
    _move(paths, targets)


def throw_away(folder: Path, name: str) -> Path:
    """Move a recording into the bin inside its folder.

    Returns:
        Its new folder.

    Raises:
        OSError: It cannot be moved, and is unchanged.
    """
    paths = files_of(folder, name)
    room = folder / BIN / f"{time.strftime('%Y%m%d-%H%M%S')}-{secrets.token_hex(3)}"
    room.mkdir(parents=True)
    _move(paths, [room / path.name for path in paths])
    return room


def _move(paths: Sequence[Path], targets: Sequence[Path]) -> None:
    """Move files, all or none.

    Raises:
        OSError: One cannot be moved.
    """
    moved: list[tuple[Path, Path]] = []
    try:
        for path, target in zip(paths, targets, strict=True):
            path.replace(target)
            moved.append((path, target))
    except OSError:
        for path, target in moved:
            with contextlib.suppress(OSError):
                target.replace(path)
        raise
