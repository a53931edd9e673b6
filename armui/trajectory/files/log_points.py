"""One point of a trajectory as one line of our text format, and back.

    J  10 70 -60 10 25 -20  speed=30 dwell=1.5 gripper=35mm@1Nm light=1/all:255,128,0 note="tray"

First the kind of motion, then six values (for C the six of the middle, a slash, and the six of the
end), then options in any order. A # begins a comment.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import Any, Final

from armui.arm.refusal import Reason
from armui.protocol.codes import ALL_LAMPS, MoveMode
from armui.trajectory.files.errors import broken
from armui.trajectory.files.model import verified_point
from armui.trajectory.files.text import number, parse_number
from armui.trajectory.points.program import (
    VALUE_COUNT,
    GripperAction,
    GripperAngle,
    GripperOpening,
    LightAction,
    Values,
    Waypoint,
)

LINE_UNKNOWN = Reason(
    "line_unknown", "“{value}” is not a kind of line. A line begins with J, P, L, C or #."
)
OPTION_UNKNOWN = Reason(
    "option_unknown",
    "“{value}” is not an option of a point; use frame, speed, dwell, gripper, holds, light or "
    "note.",
)
OPTION_TWICE = Reason("option_twice", "“{value}” is given twice. Keep one.")
TEXT_UNCLOSED = Reason("text_unclosed", "The closing quotation mark is missing.")
VALUES_COUNT = Reason("values_count", "{value} numbers where {expected} belong.")
OPTION_BAD = Reason("option_bad", "“{value}” is not a valid {field}. Write it as {example}.")


LETTERS: Final = {
    "J": MoveMode.MOVE_J,
    "P": MoveMode.MOVE_P,
    "L": MoveMode.MOVE_L,
    "C": MoveMode.MOVE_C,
}
LETTER_OF: Final = {move: letter for letter, move in LETTERS.items()}

_TOKEN: Final = re.compile(r'[ \t]*((?:[^\s"#]|"(?:[^"\\]|\\.)*")+)')
_GRIPPER: Final = re.compile(r"([^@]+?)(mm|°|deg)@([^@]+?)(Nm|rad/s)")
_LIGHT: Final = re.compile(r"([1-6])/(all|\d{1,3}):(\d{1,3}),(\d{1,3}),(\d{1,3})")

Token = tuple[str, int]
"""A word of a line, and the column where it begins, from 1."""

_UNTOLD_PERCENT: Final = 30
"""The speed in percent of a line that names none."""


def write_point(point: Waypoint) -> str:
    """Return the line of a point, without its comments and without a line end."""
    parts = [LETTER_OF[point.move]]
    if point.middle is not None:
        parts += [*map(number, point.middle), "/"]
    parts += map(number, point.target)
    if point.frame:
        parts.append(f"frame={json.dumps(point.frame, ensure_ascii=False)}")
    parts.append(f"speed={point.speed_percent}")
    if point.dwell_s:
        parts.append(f"dwell={number(point.dwell_s)}")
    if point.gripper is not None:
        parts.append(f"gripper={gripper_text(point.gripper)}")
    if point.holds is not None:
        parts.append(f"holds={json.dumps(point.holds, ensure_ascii=False)}")
    if point.light is not None:
        parts.append(f"light={light_text(point.light)}")
    if point.note:
        parts.append(f"note={json.dumps(point.note, ensure_ascii=False)}")
    return " ".join(parts)


def read_point(text: str, line: int, comments: tuple[str, ...]) -> Waypoint:
    """Return the point in a line; a comment at its end is added to the comments before it.

    Args:
        text: The line.
        line: Its number, from 1.
        comments: The comment lines before it.

    Raises:
        TrajectoryFileError: With the column.
    """
    words, comment = _split(text, line)
    if comment is not None:
        comments = (*comments, comment)
    letter, letter_column = words[0]
    move = LETTERS.get(letter)
    if move is None:
        raise broken(LINE_UNKNOWN, line, letter_column, value=letter)
    count = next((k for k, (word, _) in enumerate(words[1:]) if "=" in word), len(words) - 1)
    values, options = words[1 : 1 + count], words[1 + count :]
    middle = None
    if move is MoveMode.MOVE_C:
        slash = next((k for k, (word, _) in enumerate(values) if word == "/"), len(values))
        middle = _six(values[:slash], line, letter_column)
        values = values[slash + 1 :]
    target = _six(values, line, letter_column)
    fields: dict[str, Any] = {}
    for word, column in options:
        name, sign, value = word.partition("=")
        reader = _READERS.get(name) if sign else None
        if reader is None:
            raise broken(OPTION_UNKNOWN, line, column, value=name)
        field, read = reader
        if field in fields:
            raise broken(OPTION_TWICE, line, column, value=name)
        fields[field] = read(value, line, column + len(name) + 1)
    fields.setdefault("speed_percent", _UNTOLD_PERCENT)
    point = Waypoint(move, target, middle, comments=comments, **fields)
    return verified_point(point, line, letter_column)


def _split(text: str, line: int) -> tuple[list[Token], str | None]:
    """Return the words of a line and its comment; blanks in quotation marks belong to a word."""
    words: list[Token] = []
    position = 0
    for match in _TOKEN.finditer(text):
        if match.start() != position:
            break
        words.append((match.group(1), match.start(1) + 1))
        position = match.end()
    rest = text[position:].lstrip()
    column = len(text) - len(rest) + 1
    if not rest:
        return words, None
    if rest.startswith("#") and words:
        return words, rest[1:]
    if rest.startswith('"'):
        raise broken(TEXT_UNCLOSED, line, column)
    raise broken(LINE_UNKNOWN, line, column, value=rest)


def _six(words: list[Token], line: int, column: int) -> Values:
    if len(words) != VALUE_COUNT:
        raise broken(VALUES_COUNT, line, column, value=len(words), expected=VALUE_COUNT)
    return tuple([parse_number(word, line, at) for word, at in words])


def _read_speed(text: str, line: int, column: int) -> int:
    if not (text.isascii() and text.isdigit()):
        raise broken(OPTION_BAD, line, column, value=text, field="speed", example="speed=30")
    return int(text[:9])


def read_gripper(text: str, line: int, column: int) -> GripperAction:
    """Return the gripper's action in a text like ``35mm@1Nm`` or ``20°@1rad/s``.

    Raises:
        TrajectoryFileError: The text has another form; the error names `line` and `column`.
    """
    match = _GRIPPER.fullmatch(text)
    if match is None or (match.group(2) == "mm") != (match.group(4) == "Nm"):
        example = "gripper=35mm@1Nm or gripper=20°@1rad/s"
        raise broken(OPTION_BAD, line, column, value=text, field="gripper", example=example)
    first = parse_number(match.group(1), line, column)
    second = parse_number(match.group(3), line, column + match.start(3))
    return GripperOpening(first, second) if match.group(2) == "mm" else GripperAngle(first, second)


def gripper_text(action: GripperAction) -> str:
    """Return the text that :func:`read_gripper` reads."""
    if isinstance(action, GripperOpening):
        return f"{number(action.opening_mm)}mm@{number(action.torque_nm)}Nm"
    return f"{number(action.angle_deg)}°@{number(action.speed_rad_s)}rad/s"


def read_light(text: str, line: int, column: int) -> LightAction:
    """Return the lamps' action in a text like ``1/all:255,128,0``: joint, lamp, red, green, blue.

    Raises:
        TrajectoryFileError: The text has another form; the error names `line` and `column`.
    """
    match = _LIGHT.fullmatch(text)
    if match is None or not match.group(0).isascii():
        example = "light=1/all:255,128,0"
        raise broken(OPTION_BAD, line, column, value=text, field="light", example=example)
    joint, lamp, *colors = match.groups()
    red, green, blue = map(int, colors)
    return LightAction(int(joint), red, green, blue, ALL_LAMPS if lamp == "all" else int(lamp))


def light_text(light: LightAction) -> str:
    """Return the text that :func:`read_light` reads."""
    lamp = "all" if light.lamp == ALL_LAMPS else str(light.lamp)
    return f"{light.joint}/{lamp}:{light.red},{light.green},{light.blue}"


def read_text(text: str, line: int, column: int) -> str:
    """Return a text written in quotation marks as in JSON; one without them unchanged.

    Raises:
        TrajectoryFileError: A quotation mark or an escape is wrong.
    """
    if not text.startswith('"'):
        return text
    try:
        value = json.loads(text)
    except ValueError:
        raise broken(TEXT_UNCLOSED, line, column) from None
    return str(value)


_READERS: Final[dict[str, tuple[str, Callable[[str, int, int], Any]]]] = {
    "speed": ("speed_percent", _read_speed),
    "dwell": ("dwell_s", parse_number),
    "gripper": ("gripper", read_gripper),
    "light": ("light", read_light),
    "note": ("note", read_text),
    "frame": ("frame", read_text),
    "holds": ("holds", read_text),
}
"""The attribute that each option sets, and the function that reads it."""
