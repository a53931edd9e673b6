"""The types of settings, and what a value of them may be."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final, Literal, TypeGuard

from armui.arm.json_fields import finite
from armui.arm.limits import JOINTS
from armui.arm.reference_record import read_record
from armui.arm.refusal import Reason, Refusal

SETTING_BAD = Reason(
    "setting_bad", "Setting “{field}”: “{value}” is not valid. The default is used instead."
)
JOG_STEP_NOT_A_NUMBER = Reason(
    "jog_step_not_a_number",
    "Jog step: “{value}” is not an angle. Enter a number of degrees, for example 0.5.",
)
JOG_STEP_OUT_OF_RANGE = Reason(
    "jog_step_out_of_range",
    "Jog step {value}° is out of range. Enter a value from {minimum}° to {maximum}°.",
)
TOOL_NOT_POSSIBLE = Reason(
    "tool_not_possible",
    "Tool centre point: {value} is not possible. Enter lengths up to {maximum} mm and angles "
    "up to 180°.",
)


Language = Literal["zh", "en"]
ThemeName = Literal["light", "dark", "system"]
MountingName = Literal["level", "on_the_left_side", "on_the_right_side", "upside_down"]
PictureDirection = Literal["iso", "front", "side", "top", "below"]
SessionFormat = Literal[".blf", ".asc", ".log"]
GamepadMode = Literal["joint", "base", "tool", "user"]
GamepadButtons = Mapping[str, Mapping[str, str]]
"""The button's name for each action (`armui.gamepad.layout.ACTIONS`), by device."""

Possible = Callable[[object], bool]
"""Returns whether a setting may have a value."""

_MOST_SHOWN: Final = 60
"""The most characters of a wrong value in a message."""
_LONGEST_PATH: Final = 4096
LONGEST_NAME: Final = 200
_TURN_DEG: Final = 360.0
_MOST_ENTRIES: Final = 1000
MOST_KEPT: Final = 200
"""The most arms or devices remembered of a setting, if it does not say more."""

TOOL_LONGEST_MM: Final = 500.0
_TOOL_LONGEST: Final = (TOOL_LONGEST_MM,) * 3 + (180.0,) * 3


@dataclass(frozen=True, slots=True)
class Within:
    """Accepts the finite numbers from one to another.

    Attributes:
        least: The least of them.
        most: The greatest of them.
    """

    least: float
    most: float

    def __call__(self, value: object) -> bool:
        """Return whether a value is one of them."""
        figure = finite(value)
        return figure is not None and self.least <= figure <= self.most


@dataclass(frozen=True, slots=True)
class Whole:
    """Accepts the whole numbers from one to another.

    Attributes:
        least: The least of them.
        most: The greatest of them.
    """

    least: int
    most: int

    def __call__(self, value: object) -> bool:
        """Return whether a value is one of them."""
        return is_whole(value) and self.least <= value <= self.most


@dataclass(frozen=True, slots=True)
class AnyOf:
    """Accepts the values of a choice.

    Attributes:
        choices: The values.
    """

    choices: tuple[object, ...]

    def __call__(self, value: object) -> bool:
        """Return whether a value is one of them."""
        return value in self.choices


@dataclass(frozen=True, slots=True)
class OrNone:
    """Accepts ``None`` besides.

    Attributes:
        possible: Accepts the other values.
    """

    possible: Possible

    def __call__(self, value: object) -> bool:
        """Return whether a value is one of them."""
        return value is None or self.possible(value)


@dataclass(frozen=True, slots=True)
class OfEach:
    """Accepts an entry for each of several arms or devices, by what they are remembered by.

    Attributes:
        entry: Accepts one of them.
        kept: The most that are kept; those chosen longest ago are dropped.
        longest_key: The most characters of what an arm or device is remembered by.
    """

    entry: Possible
    kept: int = MOST_KEPT
    longest_key: int = _LONGEST_PATH

    def __call__(self, value: object) -> bool:
        """Return whether a value consists of such entries, and not of far too many."""
        return (
            isinstance(value, Mapping)
            and len(value) <= _MOST_ENTRIES
            and all(isinstance(key, str) and len(key) <= self.longest_key for key in value)
            and all(self.entry(each) for each in value.values())
        )


def shown(value: object) -> str:
    """Return a value as text for a sentence, shortened if it is long."""
    try:
        text = str(value)
    except (ValueError, RecursionError):  # a number of thousands of digits; lists in lists in lists
        text = f"({type(value).__name__})"
    return text if len(text) <= _MOST_SHOWN else text[:_MOST_SHOWN] + "…"


def never(_value: object) -> bool:
    """Accept no value."""
    return False


def is_bool(value: object) -> bool:
    """Return whether a value is a truth value; 0 and 1 are none."""
    return isinstance(value, bool)


def is_whole(value: object) -> TypeGuard[int]:
    """Return whether a value is a whole number; a truth value is none."""
    return isinstance(value, int) and not isinstance(value, bool)


def is_path(value: object) -> bool:
    """Return whether a value can be the name of a file, here and in Qt."""
    if not isinstance(value, str) or not 0 < len(value) <= _LONGEST_PATH or "\0" in value:
        return False
    try:
        value.encode("utf-8")
    except UnicodeEncodeError:
        return False
    return True


def is_name(value: object) -> bool:
    """Return whether a value is a name as long as a device, a button or a cell may have."""
    return isinstance(value, str) and len(value) <= LONGEST_NAME


def is_pose(value: object) -> bool:
    """Return whether a value consists of six finite angles, none of them more than a turn."""
    return (
        isinstance(value, list | tuple)
        and len(value) == len(JOINTS)
        and all((angle := finite(each)) is not None and abs(angle) <= _TURN_DEG for each in value)
    )


def is_reference(value: object) -> bool:
    """Return whether a value says what is known of an arm's reference."""
    return read_record(value) is not None


def are_buttons(value: object) -> bool:
    """Return whether a value gives the button of each action of a device."""
    return isinstance(value, Mapping) and all(
        is_name(what) and is_name(button) for what, button in value.items()
    )


def is_tool(value: object) -> bool:
    """Return whether a value consists of three lengths of a tool and three angles, all finite."""
    return _wrong_of_tool(value) is None


def why_no_tool(value: object) -> Refusal:
    """Return which figure of a tool is not possible."""
    wrong = _wrong_of_tool(value)
    named = value if wrong is None else wrong[0]
    return TOOL_NOT_POSSIBLE(value=shown(named), maximum=round(TOOL_LONGEST_MM))


def _wrong_of_tool(value: object) -> tuple[object] | None:
    """Return the first figure that is not possible; ``None`` if there is none."""
    figures = list(value) if isinstance(value, list | tuple) else []
    if len(figures) != len(_TOOL_LONGEST):
        return (value,)
    for figure, longest in zip(figures, _TOOL_LONGEST, strict=True):
        if not Within(-longest, longest)(figure):
            return (figure,)
    return None
