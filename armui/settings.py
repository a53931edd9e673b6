"""The operator's settings of the program, kept between its runs.

One small JSON file in the user's configuration folder. An invalid setting falls back to its default
alone, and so does an invalid entry of one arm; a file that is no JSON is moved aside, never
overwritten. No file keeps the program from starting, whatever it holds (safety S22). Two programs
may use one file: a change is made to what is in the file by then, and leaves everything else there
as it is; what another program keeps of arms and devices is followed (S21).
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Concatenate, Final, ParamSpec, TypeVar

from filelock import Timeout

from armui import setting_maps
from armui.arm.refusal import Reason, Refusal
from armui.setting_checks import SETTING_BAD, shown
from armui.setting_fields import OF_EACH, Settings, check
from armui.setting_maps import KeptMap, Revision
from armui.system import paths
from armui.system.alone import alone_with
from armui.system.atomic import aside_name, write_whole
from armui.system.files import error_text, open_file

if TYPE_CHECKING:
    from concurrent.futures import Executor, Future

SETTINGS_IN_USE = Reason(
    "settings_in_use",
    "Another program is writing the settings file {path}. The settings hold until this program "
    "ends; change them once more to save them.",
)
SETTINGS_NOT_SAVED = Reason(
    "settings_not_saved",
    "The settings could not be saved in {path}: {text}. They hold until the program ends.",
)
SETTINGS_UNREADABLE = Reason(
    "settings_unreadable",
    "The settings file {path} could not be read: {text}. The program starts with default settings.",
)
SETTINGS_BROKEN = Reason(
    "settings_broken",
    "The settings file could not be read and was put aside as {kept}. The program starts with "
    "default settings.",
)
SETTINGS_PUT_ASIDE = Reason(
    "settings_put_aside",
    "The settings file could not be read any more and was put aside as {kept}. The present "
    "settings hold, and are saved with the next change.",
)


_MOST_BYTES: Final = 1_000_000
"""A thousand times what the settings need: a larger file is something else."""


_Choices = ParamSpec("_Choices")
_Answer = TypeVar("_Answer")
_Store = TypeVar("_Store")

Subscriber = Callable[[Settings], None]


def _by_name(
    _settings: Callable[_Choices, Settings],
) -> Callable[[Callable[..., _Answer]], Callable[Concatenate[_Store, _Choices], _Answer]]:
    """Give a method the settings as its keywords, so that mypy knows their names and types."""
    return lambda method: method


def default_path() -> Path:
    """Return the path of the settings in the operating system's folder for a user's programs."""
    return paths.settings_file()


class SettingsStore:
    """Keeps the settings in a file, and notifies subscribers of changes.

    Args:
        path: The file; it need not exist.
        for_this_run: Settings that override those of the file, and are not saved.
        first: Settings in the place of the defaults, where the file has none.

    Attributes:
        problems: The faults of the file when it was read.
    """

    def __init__(
        self,
        path: Path,
        for_this_run: Mapping[str, Any] | None = None,
        first: Mapping[str, Any] | None = None,
    ) -> None:
        self._path = path
        self._subscribers: list[Subscriber] = []
        self._files: Executor | None = None
        self._on_problem: Callable[[Refusal], object] = lambda _problem: None
        self._unsaved: list[Revision] = []
        self._turn, self._writing = threading.Lock(), threading.Lock()
        self._maps: dict[str, KeptMap] = {}
        self._reloaded: dict[str, Any] | None = None
        self._checked_stamp: tuple[int, int, int] | None = None
        self._file_check: Future[None] | None = None
        self._writes = 0
        entries, problems = _read(path)
        self._first = dict(first or {})
        self._kept, more = _from_entries(entries, self._first)
        self._settings = replace(self._kept, **(for_this_run or {}))
        self._take_maps(entries)
        found = [setting_maps.problem_of(*each) for each in self._maps.items()]
        self.problems = (*problems, *more, *(each for each in found if each is not None))

    @property
    def settings(self) -> Settings:
        """The present settings; those of arms and devices as last known to be in the file."""
        with self._turn:
            self._apply_reloaded()
            return self._settings

    def strange(self, name: str, key: str) -> str | None:
        """Return what the file has for an arm or device that is not understood.

        Args:
            name: The setting.
            key: The arm or device.

        Returns:
            It as a text, shortened; ``None`` if there is nothing, or it is understood.
        """
        with self._turn:
            self._apply_reloaded()
            return self._maps[name].strange_at(key)

    @_by_name(Settings)
    def change(self, **choices: object) -> Refusal | None:
        """Change settings, save them, and notify the subscribers.

        Of a setting with an entry for each arm or device, those that differ from the present ones
        are changed.

        Returns:
            ``None``, or why a setting is not possible (then nothing is changed), or why the file
            could not be written (then the settings hold, and are written with the next change).
            Later errors go to the function given to `write_by`.
        """
        for name, value in choices.items():
            refusal = check(name, value)
            if refusal is not None:
                return refusal
        revisions: list[Revision] = []
        for name, value in choices.items():
            if isinstance(value, Mapping) and name in OF_EACH:
                new = setting_maps.changes(getattr(self.settings, name), value)
                revisions.append(_of_map(name, partial(setting_maps.put, name, new)))
            else:
                revisions.append(partial(_choose, name, value))
        return self._revise(revisions)

    def keep(self, name: str, new: Mapping[str, object]) -> Refusal | None:
        """Keep something of arms or devices, whatever another program has kept of others.

        Args:
            name: The setting, one with an entry for each of them.
            new: The entries by arm or device; ``None`` drops one.

        Returns:
            As of `change`.
        """
        for key, entry in new.items():
            refusal = None if entry is None else check(name, {key: entry})
            if refusal is not None:
                return refusal
        return self.revise(name, partial(setting_maps.put, name, new))

    def revise(self, name: str, revision: Revision) -> Refusal | None:
        """Change the entries of arms or devices by what they are when they are written.

        Args:
            name: The setting, one with an entry for each of them.
            revision: Changes entries in place, and leaves what it does not understand; it is called
                with those known now, and by another thread with those in the file.

        Returns:
            As of `change`.
        """
        return self._revise([_of_map(name, revision)])

    def write_by(self, files: Executor, on_problem: Callable[[Refusal], object]) -> None:
        """Have a thread write the file from now on, so that nobody waits for the disk.

        Args:
            files: The thread's executor, which finishes its work before it ends.
            on_problem: Called in that thread with the reason why a change could not be written.
        """
        self._files, self._on_problem = files, on_problem

    def follow(self) -> None:
        """Look what other programs have kept of arms and devices, without waiting for the disk.

        What could not be saved before is tried once more; to be called once a second.
        """
        if self._files is None:
            self._check_file()
        elif self._file_check is None or self._file_check.done():  # a disk that hangs is asked once
            with contextlib.suppress(RuntimeError):  # the thread has ended, and the program ends
                self._file_check = self._files.submit(self._check_file)

    def subscribe(self, subscriber: Subscriber) -> Callable[[], None]:
        """Have a function called with the settings after each change made here.

        Returns:
            A function that ends the subscription; calling it twice does no harm.
        """
        self._subscribers.append(subscriber)

        def unsubscribe() -> None:
            with contextlib.suppress(ValueError):
                self._subscribers.remove(subscriber)

        return unsubscribe

    @property
    def path(self) -> Path:
        """The file that the settings are read from and written to."""
        return self._path

    # What holds in this program -----------------------------------------------------------------

    def _revise(self, revisions: Sequence[Revision]) -> Refusal | None:
        with self._turn:
            self._apply_reloaded()
            before = self._settings
            kept, settings = self._entries_of(self._kept), self._entries_of(before)
            for revision in revisions:
                revision(kept)
                revision(settings)
            self._kept, self._settings = Settings(**kept), Settings(**settings)
            self._take_maps(kept)
            self._unsaved += revisions
        problem = self._save()
        if self.settings != before:
            for subscriber in list(self._subscribers):
                subscriber(self.settings)
        return problem

    def _entries_of(self, settings: Settings) -> dict[str, Any]:
        """Return settings as a file has them, with what is not understood of the maps."""
        values = {each.name: getattr(settings, each.name) for each in fields(Settings)}
        return values | {name: each.whole for name, each in self._maps.items()}

    def _apply_reloaded(self) -> None:
        """Take over what the file was found to have of arms and devices; `_turn` is held."""
        entries, self._reloaded = self._reloaded, None
        if entries is not None:
            for revision in self._unsaved:
                revision(entries)
            self._take_maps(entries)

    def _take_maps(self, entries: Mapping[str, Any]) -> None:
        self._maps = {name: setting_maps.read_map(name, entries.get(name)) for name in OF_EACH}
        understood: dict[str, Any] = {name: each.entries for name, each in self._maps.items()}
        self._kept = replace(self._kept, **understood)
        self._settings = replace(self._settings, **understood)

    # The file ------------------------------------------------------------------------------------

    def _save(self) -> Refusal | None:
        """Have what is unsaved written; why it was not, as far as that is known at once."""
        if self._files is None:
            return self._write()
        try:
            written = self._files.submit(self._write)
        except RuntimeError:  # the thread has ended, and the program ends
            return self._write()
        if written.done():
            return self._problem_of(written)
        written.add_done_callback(self._on_written)
        return None

    def _on_written(self, written: Future[Refusal | None]) -> None:
        problem = self._problem_of(written)
        if problem is not None:
            self._on_problem(problem)

    def _problem_of(self, written: Future[Refusal | None]) -> Refusal | None:
        error = written.exception()
        return written.result() if error is None else self._not_saved(error)

    def _write(self) -> Refusal | None:
        """Write whatever is unsaved by now; waits for a disk."""
        if not self._writing.acquire(blocking=False):
            # Another thread is writing and waits for the disk; it writes this, too, once the disk
            # answers.
            return self._not_saved(TimeoutError(errno.ETIMEDOUT, os.strerror(errno.ETIMEDOUT)))
        try:
            while True:
                with self._turn:
                    unsaved, kept = list(self._unsaved), self._entries_of(self._kept)
                if not unsaved:
                    return None
                problem = self._write_revised(unsaved, kept)
                if problem is not None:
                    return problem
        finally:
            self._writing.release()

    def _write_revised(self, unsaved: Sequence[Revision], kept: dict[str, Any]) -> Refusal | None:
        """Make changes to what the file has by now; without one, all that is kept is written."""
        try:
            with alone_with(self._path):
                try:
                    found = _entries(self._path)
                except (ValueError, RecursionError):
                    return _put_aside(self._path, SETTINGS_PUT_ASIDE)
                entries = self._chosen(kept) if found is None else dict(found)
                for revision in unsaved:
                    revision(entries)
                if found is None or _text(entries) != _text(found):
                    self._path.parent.mkdir(parents=True, exist_ok=True)
                    if found is not None and setting_maps.loses_map(found, entries):
                        write_whole(aside_name(self._path), _as_file(_text(found)))
                    write_whole(self._path, _as_file(_text(entries)))
        except Timeout:
            return SETTINGS_IN_USE(path=str(self._path))
        except (OSError, ValueError, RecursionError) as error:  # lists nested too deep to write
            return self._not_saved(error)
        with self._turn:
            del self._unsaved[: len(unsaved)]
            self._reloaded = entries
            self._writes += 1
        return None

    def _chosen(self, kept: Mapping[str, Any]) -> dict[str, Any]:
        """Return the entries of a new file: what nobody chose goes on following the system."""
        return {
            name: value
            for name, value in kept.items()
            if name not in self._first or value != self._first[name]
        }

    def _check_file(self) -> None:
        """Read the file if another program has written it since; waits for a disk."""
        if self._unsaved:
            self._write()
        writes = self._writes
        try:
            found = self._path.stat()
            stamp = found.st_size, found.st_mtime_ns, found.st_ino
            entries = None if stamp == self._checked_stamp else _entries(self._path)
        except (OSError, ValueError, RecursionError):
            return  # what was read before stays in force
        self._checked_stamp = stamp
        with self._turn:
            if entries is not None and writes == self._writes:
                self._reloaded = entries

    def _not_saved(self, error: BaseException) -> Refusal:
        return SETTINGS_NOT_SAVED(path=str(self._path), text=error_text(error))


def _choose(name: str, value: object, settings: dict[str, Any]) -> None:
    settings[name] = value


def _of_map(name: str, revision: Revision) -> Revision:
    return partial(setting_maps.revise, name, revision)


def _entries(path: Path) -> dict[str, Any] | None:
    """Return the entries of a file; ``None`` if there is no file.

    Raises:
        OSError: It cannot be read, or is no file: opening a pipe would wait for ever.
        ValueError: It is no JSON of ours, no UTF-8, or far too large.
        RecursionError: Its lists are nested too deep.
    """
    try:
        with open_file(path) as file:
            data = file.read(_MOST_BYTES + 1)
    except FileNotFoundError:
        return None
    if len(data) > _MOST_BYTES:
        raise ValueError("it is too large")
    entries = json.loads(data.decode("utf-8"))
    if not isinstance(entries, dict):
        raise ValueError("it holds no settings")  # noqa: TRY004 - as what is no JSON
    return entries


def _text(entries: Mapping[str, Any]) -> str:
    return json.dumps(entries, indent=2)


def _as_file(text: str) -> bytes:
    """Return the bytes of a file.

    Raises:
        OSError: No program would read a file as large as that.
    """
    data = f"{text}\n".encode()
    if len(data) > _MOST_BYTES:
        raise OSError(errno.EFBIG, os.strerror(errno.EFBIG))
    return data


def _read(path: Path) -> tuple[dict[str, Any], tuple[Refusal, ...]]:
    """Return a file's entries for the start of the program, and what to tell the operator (S22)."""
    try:
        return _entries(path) or {}, ()
    except OSError as error:
        return {}, (SETTINGS_UNREADABLE(path=str(path), text=error_text(error)),)
    except (ValueError, RecursionError):
        return {}, (_put_aside(path, SETTINGS_BROKEN),)


def _from_entries(
    entries: Mapping[str, Any], first: Mapping[str, Any]
) -> tuple[Settings, tuple[Refusal, ...]]:
    """The settings of a file but for the maps; what is not possible is left at its first value."""
    good: dict[str, Any] = dict(first)
    problems = []
    for each in fields(Settings):
        if each.name not in entries or each.name in OF_EACH:
            continue
        value = entries[each.name]
        if check(each.name, value) is None:
            good[each.name] = tuple(value) if isinstance(value, list) else value
        else:
            problems.append(SETTING_BAD(field=each.name, value=shown(value)))
    return Settings(**good), tuple(problems)


def _put_aside(path: Path, told: Reason) -> Refusal:
    """Keep a broken file for whoever wants to mend it, and return what is to be told."""
    kept = aside_name(path)
    try:
        path.replace(kept)
    except OSError as error:
        return SETTINGS_UNREADABLE(path=str(path), text=error_text(error))
    return told(kept=str(kept))
