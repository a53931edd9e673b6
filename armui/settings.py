"""What the operator has chosen for the program itself, kept between its runs.

One small JSON file in the user's configuration folder. A setting that is not possible falls back
to its first value by itself; a file that is no JSON is put aside, never overwritten unseen.
"""

from __future__ import annotations

import contextlib
import json
import math
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path
from typing import Any, Final, Literal, TypedDict, Unpack, get_args

import platformdirs

from armui.arm.refusal import Refusal
from armui.atomic import write_whole

Language = Literal["zh", "en"]
ThemeName = Literal["light", "dark", "system"]

JOG_STEP_MIN_DEG: Final = 0.001
"""The resolution of an angle on the bus."""
JOG_STEP_MAX_DEG: Final = 30.0

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
    """

    language: Language = "zh"
    theme: ThemeName = "light"
    jog_step_deg: float = 1.0
    urdf_path: str | None = None
    tool: tuple[float, ...] = (0.0,) * 6
    stop_again: bool = False


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
        "urdf_path": value is None or (isinstance(value, str) and value != ""),
    }
    if allowed.get(name, False):
        return None
    return Refusal("setting_bad", {"field": name, "value": str(value)})


def _check_jog_step(value: object) -> Refusal | None:
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        return Refusal("jog_step_not_a_number", {"value": str(value)})
    if not JOG_STEP_MIN_DEG <= value <= JOG_STEP_MAX_DEG:
        return Refusal(
            "jog_step_out_of_range",
            {"value": float(value), "minimum": JOG_STEP_MIN_DEG, "maximum": JOG_STEP_MAX_DEG},
        )
    return None


def _check_tool(value: object) -> Refusal | None:
    """Six finite figures: three lengths of a tool this arm can carry, three angles."""
    figures = list(value) if isinstance(value, list | tuple) else []
    if len(figures) != len(_TOOL_LONGEST):
        figures = [value] * len(_TOOL_LONGEST)
    for figure, longest in zip(figures, _TOOL_LONGEST, strict=True):
        good = isinstance(figure, int | float) and not isinstance(figure, bool)
        if not good or not abs(figure) <= longest:
            return Refusal(
                "tool_not_possible", {"value": str(figure), "maximum": round(TOOL_LONGEST_MM)}
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
        problem = self._save() if self._kept != kept else None
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

    def _save(self) -> Refusal | None:
        try:
            write_whole(self._path, json.dumps(asdict(self._kept), indent=2) + "\n")
        except OSError as error:
            text = error.strerror or str(error)
            return Refusal("settings_not_saved", {"path": str(self._path), "text": text})
        return None


def _read(path: Path) -> tuple[Settings, tuple[Refusal, ...]]:
    try:
        entries = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return Settings(), ()
    except OSError as error:
        params = {"path": str(path), "text": error.strerror or str(error)}
        return Settings(), (Refusal("settings_unreadable", params),)
    except ValueError:  # no JSON, or no UTF-8
        return Settings(), (_put_aside(path),)
    if not isinstance(entries, dict):
        return Settings(), (_put_aside(path),)
    return _from_entries(entries)


def _from_entries(entries: Mapping[str, Any]) -> tuple[Settings, tuple[Refusal, ...]]:
    """The settings of a file; what it says that is not possible is left at its first value."""
    good: dict[str, Any] = {}
    problems = []
    for field in fields(Settings):
        if field.name not in entries:
            continue
        value = entries[field.name]
        if check(field.name, value) is None:
            good[field.name] = tuple(value) if isinstance(value, list) else value
        else:
            params = {"field": field.name, "value": str(value)}
            problems.append(Refusal("setting_bad", params))
    return Settings(**good), tuple(problems)


def _put_aside(path: Path) -> Refusal:
    """Keep a broken file for whoever wants to mend it."""
    kept = path.with_name(path.name + ".broken")
    try:
        path.replace(kept)
    except OSError as error:
        params = {"path": str(path), "text": error.strerror or str(error)}
        return Refusal("settings_unreadable", params)
    return Refusal("settings_broken", {"kept": str(kept)})
