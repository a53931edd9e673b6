"""What the operator has chosen for the program itself, kept between its runs.

One small JSON file in the user's configuration folder. A setting that is not possible falls back
to its first value by itself; a file that is no JSON is put aside, never overwritten unseen. No file
keeps the program from starting, whatever it holds (safety S22). Two programs may use one file: a
change writes the settings that were changed and leaves the others as they are in the file (S21).
"""

from __future__ import annotations

import contextlib
import errno
import json
import stat
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import Any, Final, Literal, TypedDict, Unpack, get_args

import platformdirs

from armui.arm.json_fields import finite
from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.system import paths
from armui.system.atomic import write_whole
from armui.system.error_text import error_text

Language = Literal["zh", "en"]
ThemeName = Literal["light", "dark", "system"]
PictureDirection = Literal["iso", "front", "side", "top"]
SessionFormat = Literal[".blf", ".asc", ".log", ".mf4"]
GamepadMode = Literal["joint", "base", "tool"]
GamepadButtons = Mapping[str, Mapping[str, str]]
"""By the name of a device, which button (its name) does what (`armui.gamepad.layout.ACTIONS`)."""

_MOST_BYTES: Final = 1_000_000
"""A thousand times what the settings need: a larger file is something else."""
_MOST_SHOWN: Final = 60
"""Characters of a value that is told to be wrong."""
_LONGEST_PATH: Final = 4096
_MOST_DEVICES: Final = 200
_LONGEST_NAME: Final = 200
_LOCK_S: Final = 0.05
"""So long a change waits for another program that is writing the same file."""

JOG_STEP_MIN_DEG: Final = 0.001
"""The resolution of an angle on the bus."""
JOG_STEP_MAX_DEG: Final = 30.0

TRAIL_LONGEST_S: Final = 600

ROTATE_MIN_MB: Final = 1
ROTATE_MAX_MB: Final = 4000
"""What every file system takes."""

TOOL_LONGEST_MM: Final = 500.0
_TOOL_LONGEST: Final = (TOOL_LONGEST_MM,) * 3 + (180.0,) * 3


class Choices(TypedDict, total=False):
    """The settings to change, by name."""

    language: Language
    theme: ThemeName
    jog_step_deg: float
    urdf_path: str | None
    tool: tuple[float, ...]
    stop_again: bool
    session_folder: str | None
    session_format: SessionFormat
    session_rotate_mb: int
    session_save_at_faults: bool
    picture_direction: PictureDirection
    picture_orthographic: bool
    picture_tool_frame: bool
    picture_trail_s: int
    gamepad: bool
    gamepad_mode: GamepadMode
    gamepad_one_axis: bool
    gamepad_buttons: GamepadButtons


@dataclass(frozen=True, slots=True)
class Settings:
    """The settings of the program.

    Attributes:
        language: Of the windows.
        theme: Light, dark, or as the system is.
        jog_step_deg: How far − and + move a joint.
        urdf_path: The robot description in the 3D picture; ``None`` for the built-in one.
        tool: The tool centre point in the flange: X, Y, Z in mm, RX, RY, RZ in degrees.
        stop_again: An emergency stop that another host undoes is sent again by itself.
        session_folder: Where sessions are recorded; ``None``: in the user's folder for data.
        session_format: The suffix of their files.
        session_rotate_mb: A file that is as large is followed by another.
        session_save_at_faults: The last minutes are saved by themselves at a fault or a stop.
        picture_direction: From where the 3D picture shows the arm to begin with.
        picture_orthographic: It is drawn without perspective.
        picture_tool_frame: It shows the axes of the tool centre point.
        picture_trail_s: So many seconds of the tool's way are shown in it; 0: none.
        gamepad: A gamepad or SpaceMouse jogs the arm.
        gamepad_mode: What its axes move.
        gamepad_one_axis: Only one of them at a time.
        gamepad_buttons: What its buttons do, where the operator has chosen otherwise.
    """

    language: Language = "zh"
    theme: ThemeName = "light"
    jog_step_deg: float = 1.0
    urdf_path: str | None = None
    tool: tuple[float, ...] = (0.0,) * 6
    stop_again: bool = False
    session_folder: str | None = None
    session_format: SessionFormat = ".blf"
    session_rotate_mb: int = 100
    session_save_at_faults: bool = False
    picture_direction: PictureDirection = "iso"
    picture_orthographic: bool = False
    picture_tool_frame: bool = True
    picture_trail_s: int = 15
    gamepad: bool = False
    gamepad_mode: GamepadMode = "joint"
    gamepad_one_axis: bool = True
    gamepad_buttons: GamepadButtons = field(default_factory=dict)


Subscriber = Callable[[Settings], None]


def default_path() -> Path:
    """Where the operating system keeps settings of a user's programs."""
    return platformdirs.user_config_path("armui", appauthor=False) / "settings.json"


def check(name: str, value: object) -> Refusal | None:
    """Whether a setting may have a value: None, or the reason against it."""
    if name == "jog_step_deg":
        return _check_jog_step(value)
    if name == "tool":
        return _check_tool(value)
    allowed = {
        "language": value in get_args(Language),
        "theme": value in get_args(ThemeName),
        "stop_again": isinstance(value, bool),
        "urdf_path": value is None or _is_path(value),
        "session_folder": value is None or _is_path(value),
        "session_format": value in get_args(SessionFormat),
        "session_rotate_mb": _is_whole(value, ROTATE_MIN_MB, ROTATE_MAX_MB),
        "session_save_at_faults": isinstance(value, bool),
        "picture_direction": value in get_args(PictureDirection),
        "picture_orthographic": isinstance(value, bool),
        "picture_tool_frame": isinstance(value, bool),
        "picture_trail_s": _is_whole(value, 0, TRAIL_LONGEST_S),
        "gamepad": isinstance(value, bool),
        "gamepad_mode": value in get_args(GamepadMode),
        "gamepad_one_axis": isinstance(value, bool),
        "gamepad_buttons": _are_buttons(value),
    }
    if allowed.get(name, False):
        return None
    return Refusal(RefusalCode.SETTING_BAD, {"field": name, "value": _shown(value)})


def _shown(value: object) -> str:
    """A value for a sentence, whatever it is: cut where it is long."""
    try:
        text = str(value)
    except (ValueError, RecursionError):  # a number of thousands of digits; lists in lists in lists
        text = f"({type(value).__name__})"
    return text if len(text) <= _MOST_SHOWN else text[:_MOST_SHOWN] + "…"


def _is_path(value: object) -> bool:
    """Whether a value can be the name of a file, here and in Qt."""
    if not isinstance(value, str) or not 0 < len(value) <= _LONGEST_PATH or "\0" in value:
        return False
    try:
        value.encode("utf-8")
    except UnicodeEncodeError:
        return False
    return True


def _is_whole(value: object, least: int, most: int) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and least <= value <= most


def _are_buttons(value: object) -> bool:
    """Names to names to names, none of them longer than any device has."""
    if not isinstance(value, Mapping) or len(value) > _MOST_DEVICES:
        return False
    return all(
        _is_name(device)
        and isinstance(buttons, Mapping)
        and all(_is_name(what) and _is_name(button) for what, button in buttons.items())
        for device, buttons in value.items()
    )


def _is_name(value: object) -> bool:
    return isinstance(value, str) and len(value) <= _LONGEST_NAME


def _check_jog_step(value: object) -> Refusal | None:
    figure = finite(value)
    if figure is None:
        return Refusal(RefusalCode.JOG_STEP_NOT_A_NUMBER, {"value": _shown(value)})
    if not JOG_STEP_MIN_DEG <= figure <= JOG_STEP_MAX_DEG:
        bounds = {"minimum": JOG_STEP_MIN_DEG, "maximum": JOG_STEP_MAX_DEG}
        return Refusal(RefusalCode.JOG_STEP_OUT_OF_RANGE, {"value": figure, **bounds})
    return None


def _check_tool(value: object) -> Refusal | None:
    """Six finite figures: three lengths of a tool this arm can carry, three angles."""
    figures = list(value) if isinstance(value, list | tuple) else []
    if len(figures) != len(_TOOL_LONGEST):
        figures = [value] * len(_TOOL_LONGEST)
    for figure, longest in zip(figures, _TOOL_LONGEST, strict=True):
        size = finite(figure)
        if size is None or abs(size) > longest:
            return Refusal(
                RefusalCode.TOOL_NOT_POSSIBLE,
                {"value": _shown(figure), "maximum": round(TOOL_LONGEST_MM)},
            )
    return None


class SettingsStore:
    """Keeps the settings in a file and tells those who want to know of a change.

    Args:
        path: The file; it need not exist.
        for_this_run: Settings that go before those of the file, and are not saved.

    Attributes:
        problems: What was wrong with the file when it was read.
    """

    def __init__(self, path: Path, for_this_run: Choices | None = None) -> None:
        self._path = path
        self._subscribers: list[Subscriber] = []
        self._kept, self.problems = _read(path)
        self._settings = replace(self._kept, **(for_this_run or {}))

    @property
    def settings(self) -> Settings:
        """The settings now."""
        return self._settings

    def change(self, **choices: Unpack[Choices]) -> Refusal | None:
        """Change settings, save them, and tell the subscribers.

        Returns:
            ``None``, or why a setting is not possible (then nothing is changed), or why the file
            could not be written (then the settings hold until the program ends).
        """
        for name, value in choices.items():
            refusal = check(name, value)
            if refusal is not None:
                return refusal
        kept, before = self._kept, self._settings
        self._kept = replace(kept, **choices)
        self._settings = replace(before, **choices)
        problem = self._save(choices) if self._kept != kept else None
        if self._settings != before:
            for subscriber in list(self._subscribers):
                subscriber(self._settings)
        return problem

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

    def _save(self, choices: Choices) -> Refusal | None:
        """Write what was chosen; what another program has written meanwhile stays."""
        from filelock import FileLock, Timeout  # noqa: PLC0415 - faster start

        params = {"path": str(self._path)}
        try:
            with FileLock(_lock_path(self._path), timeout=_LOCK_S):
                in_file = _entries(self._path)
                kept = asdict(self._kept)
                entries = kept | in_file | {name: kept[name] for name in choices}
                self._path.parent.mkdir(parents=True, exist_ok=True)
                write_whole(self._path, f"{json.dumps(entries, indent=2)}\n".encode())
        except Timeout:
            return Refusal(RefusalCode.SETTINGS_IN_USE, params)
        except (OSError, ValueError, RecursionError) as error:
            return Refusal(RefusalCode.SETTINGS_NOT_SAVED, params | {"text": error_text(error)})
        return None


def _lock_path(path: Path) -> Path:
    """Where programs wait for each other to write a file; not beside it: that folder is not ours.

    Raises:
        OSError: The folder cannot be made.
    """
    folder = paths.runtime()
    folder.mkdir(parents=True, exist_ok=True)
    import hashlib  # noqa: PLC0415 - brings OpenSSL, faster start

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
    found = path.stat()
    if not stat.S_ISREG(found.st_mode):
        raise IsADirectoryError(errno.EISDIR, "it is not a file", str(path))
    if found.st_size > _MOST_BYTES:
        raise ValueError("it is too large")
    return json.loads(path.read_bytes().decode("utf-8"))


def _read(path: Path) -> tuple[Settings, tuple[Refusal, ...]]:
    try:
        entries = _parsed(path)
    except FileNotFoundError:
        return Settings(), ()
    except OSError as error:
        params = {"path": str(path), "text": error_text(error)}
        return Settings(), (Refusal(RefusalCode.SETTINGS_UNREADABLE, params),)
    except (ValueError, RecursionError):
        return Settings(), (_put_aside(path),)
    if not isinstance(entries, dict):
        return Settings(), (_put_aside(path),)
    return _from_entries(entries)


def _from_entries(entries: Mapping[str, Any]) -> tuple[Settings, tuple[Refusal, ...]]:
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
            params = {"field": each.name, "value": _shown(value)}
            problems.append(Refusal(RefusalCode.SETTING_BAD, params))
    return Settings(**good), tuple(problems)


def _put_aside(path: Path) -> Refusal:
    """Keep a broken file for whoever wants to mend it."""
    kept = path.with_name(path.name + ".broken")
    try:
        path.replace(kept)
    except OSError as error:
        params = {"path": str(path), "text": error_text(error)}
        return Refusal(RefusalCode.SETTINGS_UNREADABLE, params)
    return Refusal(RefusalCode.SETTINGS_BROKEN, {"kept": str(kept)})
