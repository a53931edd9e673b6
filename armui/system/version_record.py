"""Notes the version that uses the user's files, and the files that it took over from another.

One small file beside the settings, written at the first start of a version.
"""

from __future__ import annotations

import json
import os
from collections.abc import Collection, Mapping
from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path
from typing import Any, Final

from armui.system.atomic import write_whole
from armui.system.files import read_file

FILE: Final = "version.json"
_MOST_BYTES: Final = 100_000


@dataclass(frozen=True, slots=True)
class TakenOver:
    """The files of another version that one found at its first start.

    Attributes:
        before: The other version; "" for 0.2.0 and before, which noted none.
        version: The one that took the files over.
        at: The time of that start, as ISO 8601 with its time zone.
        files: The number of files by kind: ``settings``, ``trajectories``, ``sessions``.
    """

    before: str
    version: str
    at: str
    files: Mapping[str, int]


def note_version(
    version: str,
    settings: Path,
    places: Mapping[str, Path],
    now: datetime,
    *,
    nested: Collection[str] = (),
) -> TakenOver | None:
    """Note that a version runs; waits for the disk.

    Args:
        version: The version that runs.
        settings: The file of settings; the note lies beside it.
        places: The folders whose files are counted, by kind.
        now: The time, with its time zone.
        nested: The kinds whose sub-folders are counted, too.

    Returns:
        The files taken over last, by this version or one before; ``None`` if none ever were.

    Raises:
        OSError: The note could not be written.
    """
    note = settings.with_name(FILE)
    before, taken_over = _read(note)
    if before == version:
        return taken_over
    files = {"settings": int(settings.is_file())}
    files |= {kind: _count(folder, nested=kind in nested) for kind, folder in places.items()}
    if any(files.values()):
        taken_over = TakenOver(before, version, now.isoformat(timespec="seconds"), files)
    kept = None if taken_over is None else asdict(taken_over)
    note.parent.mkdir(parents=True, exist_ok=True)
    text = json.dumps({"version": version, "taken_over": kept}, indent=2)
    write_whole(note, f"{text}\n".encode())
    return taken_over


def taken_over(settings: Path) -> TakenOver | None:
    """Return the files taken over last, or ``None`` if none are known of. Waits for a disk."""
    return _read(settings.with_name(FILE))[1]


def _read(note: Path) -> tuple[str, TakenOver | None]:
    try:
        entries = json.loads(read_file(note, _MOST_BYTES))
        kept = entries["taken_over"]
        return str(entries["version"]), None if kept is None else _understood(kept)
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return "", None


def _understood(kept: dict[str, Any]) -> TakenOver:
    files = {str(kind): int(count) for kind, count in kept["files"].items()}
    datetime.fromisoformat(kept["at"])  # raises ValueError for a file that is none of ours
    return TakenOver(str(kept["before"]), str(kept["version"]), kept["at"], files)


def _count(folder: Path, *, nested: bool) -> int:
    """Return how many files a folder has; one that is not there, or cannot be read, has none."""
    try:
        with os.scandir(folder) as items:
            found = [each for each in items if not each.name.startswith(".")]
            inner = [each for each in found if nested and each.is_dir(follow_symlinks=False)]
            files = sum(each.is_file() for each in found)
    except OSError:
        return 0
    return files + sum(_count(Path(each), nested=False) for each in inner)
