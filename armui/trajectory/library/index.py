"""A cache of the library's entries, so that its files need not be opened, and the check marks.

It is one JSON file beside the trajectories. An entry is valid as long as its file has the same
size, time and inode number; without the cache every file is read once more, and only the marks are
lost.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
from collections.abc import Collection
from dataclasses import asdict, dataclass, replace
from datetime import UTC, datetime
from itertools import starmap
from pathlib import Path
from typing import Any, Final, Literal, NamedTuple, get_args

from armui.arm.refusal import Reason, Refusal
from armui.system.atomic import write_whole
from armui.system.clock import in_calendar_s
from armui.system.files import read_file
from armui.trajectory.files import Content, TrajectoryFileError
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.points.program import SpeedsFrom, frames_in, speeds_of
from armui.trajectory.samples.recording import Recording

Kind = Literal["points", "recording", "draft"]
"""The kind of content. A draft is the unsaved state of a trajectory that was never saved, or is
gone.
"""
Check = Literal["ok", "warnings", "errors"]
"""The result of the check before a run."""

_VERSION: Final = 3
_FULL_SPEED: Final = {"speed_factor": 1}
"""A run once had a speed of its own; older programs read it."""

_MOST_BYTES: Final = 64_000_000
"""More than a hundred thousand entries need; a larger file is ignored."""

_BROKEN: Final = (
    *(OSError, ValueError, TypeError, KeyError, AttributeError),
    RecursionError,  # lists nested too deep
    OverflowError,  # a number of hundreds of digits
)
"""The exceptions that reading a damaged file may raise."""


@dataclass(frozen=True, slots=True)
class IndexEntry:
    """One line of the library's list.

    Attributes:
        name: The trajectory's name; no two entries share one.
        kind: Points, recorded samples, or unsaved points.
        count: The number of points or samples; 0 if the file is damaged.
        length_s: The duration of a recording; ``None`` for points, which have an estimate.
        modified: The time of the last change.
        check: The result of its last check; ``None`` if it has changed since, or was never checked.
        damage: The fault of its file; ``None`` if there is none.
        note: The operator's note.
        checked_for: The `ArmModel.fingerprint_of` its frames that the check was made for.
        ran_with: The options of its last run; ``None`` if it is not known to have run.
        taught_on: The arm it was taught on; "" if not known.
        speeds: The lowest and highest speed percentage of its points from each row on, see
            `speeds_of`.
        estimated_s: How long it will take at its own speed, see `estimate_s`; ``None`` where that
            is not known.
        estimated_for: The same for the estimate; "" if none was made.
        frames: The user frames that its points name.
        folder: The sub-folder its file lies in; "" for the library's folder itself. It is not kept
            in the cache: the file's place says it.
    """

    name: str
    kind: Kind
    count: int
    length_s: float | None
    modified: datetime
    check: Check | None = None
    damage: TrajectoryFileError | None = None
    note: str = ""
    checked_for: str = ""
    ran_with: RunOptions | None = None
    speeds: tuple[SpeedsFrom, ...] = ()
    taught_on: str = ""
    estimated_s: float | None = None
    estimated_for: str = ""
    frames: tuple[str, ...] = ()
    folder: str = ""


@dataclass(frozen=True, slots=True)
class Listing:
    """The content of the library at one time.

    Attributes:
        entries: All entries, sorted by name.
        drafts: The names of entries with unsaved changes.
        folders: The names of its sub-folders, sorted.
        closed: The names of those that cannot be read.
    """

    entries: tuple[IndexEntry, ...]
    drafts: tuple[str, ...]
    folders: tuple[str, ...] = ()
    closed: tuple[str, ...] = ()


def entry_of(content: Content) -> IndexEntry:
    """Return the entry of a trajectory or recording that was not checked yet."""
    name, note, modified = content.name, content.note, content.modified
    if isinstance(content, Recording):
        length = content.duration_s
        count, taught_on = len(content.samples), content.taught_on
        return IndexEntry(
            name, "recording", count, length, modified, note=note, taught_on=taught_on
        )
    speeds, count = speeds_of(content.points), len(content.points)
    entry = IndexEntry(name, "points", count, None, modified, note=note, speeds=speeds)
    return replace(entry, taught_on=content.taught_on, frames=frames_in(content.points))


class Stamp(NamedTuple):
    """The properties of a file that change when its content does."""

    size: int
    time_ns: int
    number: int

    @classmethod
    def of(cls, stat: os.stat_result) -> Stamp:
        """Return the stamp from the operating system's data on a file."""
        return cls(stat.st_size, stat.st_mtime_ns, stat.st_ino)

    def changed(self) -> datetime:
        """Return the time of the file's last change; 1970 if the calendar lacks that time."""
        return datetime.fromtimestamp(in_calendar_s(self.time_ns / 1e9), UTC)


class Index:
    """The entries by their file's path from the library's folder on, with slashes.

    Args:
        path: The cache file; it need not exist.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._changed = False
        self._entries: dict[str, tuple[Stamp, IndexEntry]] = {}
        self._seen: Stamp | None = None

    def follow(self) -> None:
        """Read entries that another program has added or marked since this one last looked."""
        seen = self._stamp()
        if seen is None or seen == self._seen:
            return
        self._seen = seen
        if seen.size > _MOST_BYTES:
            return
        with contextlib.suppress(*_BROKEN):
            theirs = _unpack(json.loads(read_file(self._path, _MOST_BYTES)))
            ours = self._entries if self._changed else {}  # changes not written so far
            self._entries = {**self._entries, **theirs, **ours}

    def _stamp(self) -> Stamp | None:
        with contextlib.suppress(OSError):
            return Stamp.of(self._path.stat())
        return None

    def entry(self, file: str, stamp: Stamp) -> IndexEntry | None:
        """Return the entry of a file, or ``None`` if the file has changed since."""
        known, entry = self._entries.get(file, (None, None))
        return entry if known == stamp else None

    def last_name(self, file: str) -> str | None:
        """Return the name of a file's content when it was last read, or ``None``."""
        known = self._entries.get(file)
        return None if known is None else known[1].name

    def put(self, file: str, stamp: Stamp, entry: IndexEntry) -> None:
        """Store the entry of a file."""
        if self._entries.get(file) != (stamp, entry):
            self._entries[file] = stamp, entry
            self._changed = True

    def keep_only(self, files: Collection[str], closed: Collection[str] = ()) -> None:
        """Drop the entries of all other files: they are gone.

        Args:
            files: The files that were found.
            closed: The sub-folders that could not be read: what is in them may still be there.
        """
        for file in self._entries.keys() - set(files):
            if file.rpartition("/")[0] not in closed:
                del self._entries[file]
                self._changed = True

    def move(self, old: str, new: str, stamp: Stamp) -> None:
        """Give a file's entry, with its marks, to the place the file was moved to.

        Args:
            old: Where it was.
            new: Where it is.
            stamp: Its stamp there.
        """
        known = self._entries.pop(old, None)
        if known is not None:
            self._entries[new] = stamp, known[1]
            self._changed = True

    def save(self) -> None:
        """Write the cache if it has changed. A failure to write it is ignored."""
        if not self._changed:
            return
        data = {file: [*stamp, _pack(entry)] for file, (stamp, entry) in self._entries.items()}
        text = json.dumps({"version": _VERSION, "files": data}, ensure_ascii=True)
        with contextlib.suppress(OSError):
            write_whole(self._path, text.encode(), to_disk=False)
            self._changed = False
            self._seen = self._stamp()


def _pack(entry: IndexEntry) -> dict[str, Any]:
    fields = {
        "name": entry.name,
        "kind": entry.kind,
        "count": entry.count,
        "length_s": entry.length_s,
        "modified": entry.modified.isoformat(),
        "check": entry.check,
        "note": entry.note,
        "checked_for": entry.checked_for,
        "ran_with": None if entry.ran_with is None else {**asdict(entry.ran_with), **_FULL_SPEED},
        "speeds": entry.speeds,
        "taught_on": entry.taught_on,
        "estimated_s": entry.estimated_s,
        "estimated_for": entry.estimated_for,
        "frames": entry.frames,
    }
    if (damage := entry.damage) is not None:
        reason = damage.refusal
        place = [damage.line, damage.column, damage.file]
        fields["damage"] = [reason.code, dict(reason.params), *place]
    return fields


def _unpack(data: dict[str, Any]) -> dict[str, tuple[Stamp, IndexEntry]]:
    """Return the entries of the file; any damage raises an error, and none are used."""
    if data["version"] != _VERSION:
        return {}
    entries = {}
    for file, (size, time_ns, number, fields) in data["files"].items():
        damage = fields.pop("damage", None)
        fields["modified"] = datetime.fromisoformat(fields["modified"])
        ran_with, speeds = fields.pop("ran_with"), fields.pop("speeds")
        if "frames" not in fields:
            continue  # from an older program: read its file again
        frames = tuple(fields.pop("frames"))
        entry = IndexEntry(
            **fields,
            ran_with=None if ran_with is None else _options(ran_with),
            speeds=tuple(starmap(SpeedsFrom, speeds)),
            frames=frames,
        )
        if entry.kind == "points":
            entry = replace(entry, length_s=None)  # once that of a check, from the arm's place then
        if damage is not None:
            code, params, line, column, name = damage
            _require(isinstance(code, str) and isinstance(params, dict) and isinstance(name, str))
            _require(isinstance(line, int) and isinstance(column, int))
            error = TrajectoryFileError(Refusal(Reason(code), params), line, column, name)
            entry = replace(entry, damage=error)
        _require(_is_sound(entry))
        entries[file] = Stamp(size, time_ns, number), entry
    return entries


def _options(ran_with: dict[str, Any]) -> RunOptions:
    """Return the options of a run; the speed of its own that it once had counts no more."""
    return RunOptions(**{name: ran_with[name] for name in ran_with if name not in _FULL_SPEED})


def _is_sound(entry: IndexEntry) -> bool:
    """Return whether every field of an entry is what the list can show."""
    named = (entry.name, entry.note, entry.checked_for, entry.taught_on, entry.estimated_for)
    texts = (*named, *entry.frames)
    return (
        all(isinstance(text, str) and _can_be_shown(text) for text in texts)
        and entry.kind in get_args(Kind)
        and isinstance(entry.count, int)
        and 0 <= entry.count < _MOST_BYTES
        and all(map(_is_time, (entry.length_s, entry.estimated_s)))
        and entry.modified.tzinfo is not None
        and (entry.check is None or entry.check in get_args(Check))
        and (entry.ran_with is None or entry.ran_with.is_sound)
        and _are_speeds(entry.speeds)
    )


def _is_time(seconds: float | None) -> bool:
    return seconds is None or (isinstance(seconds, int | float) and 0 <= seconds < math.inf)


def _are_speeds(speeds: tuple[SpeedsFrom, ...]) -> bool:
    numbers = [number for one in speeds for number in one]
    return all(type(number) is int for number in numbers) and all(
        one.row >= 0 and 1 <= one.low <= one.high <= 100 for one in speeds
    )


def _can_be_shown(text: str) -> bool:
    """Return whether a text holds no half of a character."""
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        return False
    return True


def _require(sound: bool) -> None:
    if not sound:
        raise ValueError("no entry of the library's list")
