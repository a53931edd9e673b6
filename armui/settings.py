"""The operator's settings of the program, kept between its runs.

One small JSON file in the user's configuration folder. An invalid setting falls back to its default
alone; a file that is no JSON is moved aside, never overwritten. No file keeps the program from
starting, whatever it holds (safety S22). Two programs may use one file: a change writes only the
changed settings, and leaves the others in the file (S21).
"""

from __future__ import annotations

import contextlib
import errno
import hashlib
import json
import os
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, TypedDict, Unpack

from filelock import FileLock, Timeout

from armui.arm.refusal import Reason, Refusal
from armui.setting_checks import (
    SETTING_BAD,
    GamepadButtons,
    GamepadMode,
    Language,
    MountingName,
    PictureDirection,
    SessionFormat,
    ThemeName,
    check,
    shown,
)
from armui.system import paths
from armui.system.atomic import write_whole
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


_MOST_BYTES: Final = 1_000_000
"""A thousand times what the settings need: a larger file is something else."""
_LOCK_S: Final = 0.05
"""The longest time for which a change waits for another program that writes the same file."""


class Choices(TypedDict, total=False):
    """The settings to change, by name."""

    language: Language
    theme: ThemeName
    jog_step_deg: float
    urdf_path: str | None
    tool: tuple[float, ...]
    mountings: Mapping[str, MountingName]
    home_poses: Mapping[str, Sequence[float]]
    stop_again: bool
    jog_floor_mm: int | None
    session_folder: str | None
    session_format: SessionFormat
    session_rotate_mb: int
    session_save_at_faults: bool
    has_jogged: bool
    picture_direction: PictureDirection
    picture_orthographic: bool
    picture_tool_frame: bool
    picture_trail_s: int
    gamepad: bool
    gamepad_mode: GamepadMode
    gamepad_one_axis: bool
    gamepad_buttons: GamepadButtons
    models: Mapping[str, str]
    references: Mapping[str, Mapping[str, object]]
    cells: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Settings:
    """The settings of the program.

    Attributes:
        language: The language of the windows.
        theme: Light, dark, or as the system.
        jog_step_deg: The step of − and + for a joint.
        urdf_path: The robot description in the 3D picture; ``None`` for the built-in one.
        tool: The tool centre point in the flange: X, Y, Z in mm, RX, RY, RZ in degrees.
        mountings: The mounting last set for each arm, by the adapter's serial number with the arm's
            node number.
        home_poses: The operator's own home pose of each arm, six angles in degrees, by the same
            key.
        stop_again: True if an emergency stop that another host undoes is sent again automatically.
        jog_floor_mm: The least height of the fingertip over the base plane for jogs; ``None`` for
            any.
        session_folder: The folder for recordings of sessions; ``None`` for the user's folder for
            data.
        session_format: The suffix of their files.
        session_rotate_mb: A file that has reached this size is followed by another.
        models: The chosen model by the adapter's serial number, with the node number if known; the
            last choice last.
        references: What is known of each arm's reference, by the key of `home_poses`; see
            `armui.arm.reference_record`.
        cells: The name of each arm's cell, by the adapter's serial number; the last choice last.
        session_save_at_faults: True if the last minutes are saved automatically at a fault or a
            stop.
        has_jogged: True if the operator has moved an arm before: the first step is not shown any
            more.
        picture_direction: The first direction of the 3D picture.
        picture_orthographic: True if it is drawn without perspective.
        picture_tool_frame: True if it shows the axes of the tool centre point.
        picture_trail_s: The seconds of the tool's way that it shows; 0 for none.
        gamepad: True if a gamepad or SpaceMouse may jog the arm.
        gamepad_mode: The mode of its axes.
        gamepad_one_axis: True if only one of them moves at a time.
        gamepad_buttons: The operator's own assignments of its buttons.
    """

    language: Language = "zh"
    theme: ThemeName = "light"
    jog_step_deg: float = 1.0
    urdf_path: str | None = None
    tool: tuple[float, ...] = (0.0,) * 6
    mountings: Mapping[str, MountingName] = field(default_factory=dict)
    home_poses: Mapping[str, Sequence[float]] = field(default_factory=dict)
    stop_again: bool = False
    jog_floor_mm: int | None = None
    session_folder: str | None = None
    session_format: SessionFormat = ".blf"
    session_rotate_mb: int = 100
    session_save_at_faults: bool = False
    has_jogged: bool = False
    picture_direction: PictureDirection = "iso"
    picture_orthographic: bool = False
    picture_tool_frame: bool = True
    picture_trail_s: int = 15
    gamepad: bool = False
    gamepad_mode: GamepadMode = "joint"
    gamepad_one_axis: bool = True
    gamepad_buttons: GamepadButtons = field(default_factory=dict)
    models: Mapping[str, str] = field(default_factory=dict)
    references: Mapping[str, Mapping[str, object]] = field(default_factory=dict)
    cells: Mapping[str, str] = field(default_factory=dict)


Subscriber = Callable[[Settings], None]


def default_path() -> Path:
    """Return the path of the settings in the operating system's folder for a user's programs."""
    return paths.settings_file()


class SettingsStore:
    """Keeps the settings in a file, and notifies subscribers of changes.

    Args:
        path: The file; it need not exist.
        for_this_run: Settings that override those of the file, and are not saved.
        language: The language until one is chosen, as that of the system.

    Attributes:
        problems: The faults of the file when it was read.
    """

    def __init__(
        self, path: Path, for_this_run: Choices | None = None, *, language: Language = "zh"
    ) -> None:
        self._path = path
        self._subscribers: list[Subscriber] = []
        self._files: Executor | None = None
        self._on_problem: Callable[[Refusal], object] = lambda _problem: None
        self._unsaved: dict[str, Any] = {}
        self._turn, self._writing = threading.Lock(), threading.Lock()
        self._kept, self.problems = _read(path, Settings(language=language))
        self._settings = replace(self._kept, **(for_this_run or {}))

    @property
    def settings(self) -> Settings:
        """The present settings."""
        return self._settings

    def change(self, **choices: Unpack[Choices]) -> Refusal | None:
        """Change settings, save them, and notify the subscribers.

        Returns:
            ``None``, or why a setting is not possible (then nothing is changed), or why the file
            could not be written (then the settings hold, and are written with the next change).
            Later errors go to the function given to `write_by`.
        """
        for name, value in choices.items():
            refusal = check(name, value)
            if refusal is not None:
                return refusal
        kept, before = self._kept, self._settings
        self._kept = replace(kept, **choices)
        self._settings = replace(before, **choices)
        problem = None
        if self._kept != kept:
            values = asdict(self._kept)
            with self._turn:
                self._unsaved |= {name: values[name] for name in choices}
            problem = self._save()
        if self._settings != before:
            for subscriber in list(self._subscribers):
                subscriber(self._settings)
        return problem

    def write_by(self, files: Executor, on_problem: Callable[[Refusal], object]) -> None:
        """Have a thread write the file from now on, so that nobody waits for the disk.

        Args:
            files: The thread's executor, which finishes its work before it ends.
            on_problem: Called in that thread with the reason why a change could not be written.
        """
        self._files, self._on_problem = files, on_problem

    def subscribe(self, subscriber: Subscriber) -> Callable[[], None]:
        """Have a function called with the settings after each change.

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
        """The file."""
        return self._path

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
            # a disk holds whoever writes it; he goes on with this once it lets go of him
            return self._not_saved(TimeoutError(errno.ETIMEDOUT, os.strerror(errno.ETIMEDOUT)))
        try:
            while self._unsaved:
                with self._turn:
                    choices, self._unsaved = self._unsaved, {}
                problem = self._write_choices(choices)
                if problem is not None:
                    with self._turn:
                        self._unsaved = choices | self._unsaved
                    return problem
        finally:
            self._writing.release()
        return None

    def _write_choices(self, choices: Mapping[str, Any]) -> Refusal | None:
        """Write what was chosen; what another program has written meanwhile stays."""
        try:
            with _alone_with(self._path):
                in_file = _entries(self._path)
                entries = asdict(self._kept) | in_file | dict(choices)
                self._path.parent.mkdir(parents=True, exist_ok=True)
                write_whole(self._path, f"{json.dumps(entries, indent=2)}\n".encode())
        except Timeout:
            return SETTINGS_IN_USE(path=str(self._path))
        except (OSError, ValueError, RecursionError) as error:
            return self._not_saved(error)
        return None

    def _not_saved(self, error: BaseException) -> Refusal:
        params = {"path": str(self._path), "text": error_text(error)}
        return SETTINGS_NOT_SAVED(**params)


@contextlib.contextmanager
def _alone_with(path: Path) -> Iterator[None]:
    """Keep other programs of the user from writing a file; where no lock can be had, nobody is.

    Raises:
        Timeout: Another one is writing it.
    """
    with contextlib.ExitStack() as locked:
        try:
            locked.enter_context(FileLock(_lock_path(path), timeout=_LOCK_S))
        except Timeout:
            raise
        except (OSError, NotImplementedError):
            pass  # that nobody can be met there is said by whoever looks for others
        yield


def _lock_path(path: Path) -> Path:
    """Where programs wait for each other to write a file; not beside it: that folder is not ours.

    Raises:
        OSError: The folder cannot be made, or is another user's.
    """
    folder = paths.runtime()
    paths.make_private(folder)
    name = hashlib.sha256(str(path.absolute()).encode("utf-8", "surrogatepass")).hexdigest()[:16]
    return folder / f"settings-{name}.lock"


def _entries(path: Path) -> dict[str, Any]:
    """What stands in a file now; nothing, if it is none of ours."""
    try:
        entries = _parsed(path)
    except (OSError, ValueError, RecursionError):
        return {}
    return entries if isinstance(entries, dict) else {}


def _parsed(path: Path) -> object:
    """The JSON in a file.

    Raises:
        OSError: It cannot be read, or is no file: opening a pipe would wait for ever.
        ValueError: It is no JSON, no UTF-8, or far too large.
        RecursionError: Its lists are nested too deep.
    """
    with open_file(path) as file:
        data = file.read(_MOST_BYTES + 1)
    if len(data) > _MOST_BYTES:
        raise ValueError("it is too large")
    return json.loads(data.decode("utf-8"))


def _read(path: Path, first: Settings) -> tuple[Settings, tuple[Refusal, ...]]:
    try:
        entries = _parsed(path)
    except FileNotFoundError:
        return first, ()
    except OSError as error:
        params = {"path": str(path), "text": error_text(error)}
        return first, (SETTINGS_UNREADABLE(**params),)
    except (ValueError, RecursionError):
        return first, (_put_aside(path),)
    if not isinstance(entries, dict):
        return first, (_put_aside(path),)
    return _from_entries(entries, first)


def _from_entries(
    entries: Mapping[str, Any], first: Settings
) -> tuple[Settings, tuple[Refusal, ...]]:
    """The settings of a file; what it says that is not possible is left at its first value."""
    good: dict[str, Any] = {}
    problems = []
    for each in fields(Settings):
        if each.name not in entries:
            continue
        value = entries[each.name]
        if check(each.name, value) is None:
            good[each.name] = tuple(value) if isinstance(value, list) else value
        else:
            params = {"field": each.name, "value": shown(value)}
            problems.append(SETTING_BAD(**params))
    return replace(first, **good), tuple(problems)


def _put_aside(path: Path) -> Refusal:
    """Keep a broken file for whoever wants to mend it."""
    kept = path.with_name(path.name + ".broken")
    try:
        path.replace(kept)
    except OSError as error:
        params = {"path": str(path), "text": error_text(error)}
        return SETTINGS_UNREADABLE(**params)
    return SETTINGS_BROKEN(kept=str(kept))
