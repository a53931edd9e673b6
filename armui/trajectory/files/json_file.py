"""`.json`, for programs: fields of points and samples by name, one point or sample a line."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from dataclasses import asdict
from typing import Any, Final

import numpy as np

from armui.arm.json_fields import FieldError, FieldProblem, Fields, Path
from armui.arm.refusal import Reason
from armui.cell.parts import from_entry, to_entry
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.trajectory.files.errors import FILE_VERSION, TrajectoryFileError, broken, field_refusal
from armui.trajectory.files.log_points import LETTER_OF, LETTERS
from armui.trajectory.files.model import (
    VERSIONS,
    Content,
    parse_time,
    verified,
    verify,
    version_of,
)
from armui.trajectory.points.program import (
    GripperAction,
    GripperAngle,
    GripperOpening,
    LightAction,
    PosesOf,
    Trajectory,
    Waypoint,
    check_point,
)
from armui.trajectory.samples.recording import COLUMN_COUNT, GRIPPER, Recording

JSON_BAD = Reason("json_bad", "This is not valid JSON: {text}.")


_KINDS: Final = ("armui trajectory", "armui recording")
_FORMAT: Final = re.compile(r'"format"\s*:\s*"armui ')
_HEAD: Final = 4096
_EMPTY: Final = {
    "note": "",
    "gripper": None,
    "light": None,
    "comments": (),
    "frame": "",
    "holds": None,
}
"""Fields of a point that are omitted when they hold this value."""

_Scan = Callable[[str, int], tuple[Any, int]]


def is_json(text: str) -> bool:
    """Return whether a text begins as JSON does; no other format of ours begins so."""
    return text.lstrip()[:1] in ("{", "[")


def is_ours(text: str) -> bool:
    """Return whether a text begins as JSON of this program, valid or not."""
    return is_json(text) and _FORMAT.search(text[:_HEAD]) is not None


def write(content: Content) -> str:
    """Return a trajectory or recording as text.

    Raises:
        UnwritableError: The content cannot be written.
    """
    verify(content)
    head: dict[str, Any] = {
        "format": _KINDS[isinstance(content, Recording)],
        "version": version_of(content),
        "name": content.name,
        "note": content.note,
        "modified": content.modified.isoformat(),
    }
    if content.taught_on:
        head["taught_on"] = content.taught_on
    if isinstance(content, Trajectory):
        tool, frames = content.poses_of.tool, content.poses_of.frames
        if tool is not None:
            head["tool"] = to_entry(tool)
        if frames:
            head["frames"] = list(map(to_entry, frames))
        head["closing_comments"] = list(content.closing)
        key, items = "points", [_dump(_point_fields(point)) for point in content.points]
    else:
        key, items = "samples", [_dump(_sample(row)) for row in content.samples.tolist()]
    entries = [f"  {_dump(name)}: {_dump(value)}" for name, value in head.items()]
    body = ",\n".join(f"    {item}" for item in items)
    entries.append(f"  {_dump(key)}: [\n{body}\n  ]" if items else f"  {_dump(key)}: []")
    return "{\n" + ",\n".join(entries) + "\n}\n"


def read(text: str, name: str) -> Content:
    """Return the trajectory or recording in a text.

    Args:
        text: The text of the file.
        name: The name used if the file holds none.

    Raises:
        TrajectoryFileError: With the line and column of the object that is wrong.
    """
    try:
        whole = json.loads(text)
    except json.JSONDecodeError as error:
        raise broken(JSON_BAD, error.lineno, error.colno, text=error.msg) from error
    except (RecursionError, ValueError) as error:  # nested too deep; a number of 5000 digits
        raise broken(JSON_BAD, text=str(error)) from error
    try:
        return _content(Fields(whole), name)
    except FieldError as error:
        line, column = place_of(text, error.path)
        raise TrajectoryFileError(field_refusal(error), line, column) from error


def _dump(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def _sample(row: list[float]) -> list[float]:
    return row[:GRIPPER] if math.isnan(row[GRIPPER]) else row


def _point_fields(point: Waypoint) -> dict[str, Any]:
    fields: dict[str, Any] = {
        "move": f"MOVE {LETTER_OF[point.move]}",
        "joints_deg" if point.is_joint else "pose": point.target,
    }
    if point.middle is not None:
        fields["middle"] = point.middle
    fields |= {"speed_percent": point.speed_percent, "dwell_s": point.dwell_s}
    fields["gripper"] = None if point.gripper is None else asdict(point.gripper)
    fields["light"] = None if point.light is None else asdict(point.light)
    fields |= {"frame": point.frame, "holds": point.holds}
    fields |= {"note": point.note, "comments": point.comments}
    return {
        key: value for key, value in fields.items() if key not in _EMPTY or value != _EMPTY[key]
    }


def _content(whole: Fields, name: str) -> Content:
    kind = whole.text("format")
    if kind not in _KINDS:
        raise whole.bad("format", " / ".join(_KINDS))
    if whole.whole("version") not in VERSIONS:
        raise broken(FILE_VERSION, value=whole.whole("version"), maximum=VERSIONS[-1])
    common = {
        "name": whole.text("name", name),
        "note": whole.text("note", ""),
        "taught_on": whole.text("taught_on", ""),
        "modified": parse_time(whole.text("modified", "1970-01-01"), 0, 0),
    }
    if kind == _KINDS[0]:
        points = tuple(_point(item) for item in whole.objects("points"))
        closing = whole.texts("closing_comments")
        tool = whole.maybe_object("tool")
        frames = whole.objects("frames") if "frames" in whole else ()
        of = PosesOf(
            None if tool is None else from_entry(Tool, tool),
            tuple(from_entry(UserFrame, each) for each in frames),
        )
        whole.nothing_else()
        return verified(Trajectory(points=points, closing=closing, poses_of=of, **common))  # type: ignore[arg-type]  # the three fields of both kinds
    rows = [_row(values) for values in whole.number_lists("samples", (GRIPPER, COLUMN_COUNT))]
    whole.nothing_else()
    samples = np.array(rows, dtype=np.float64).reshape(-1, COLUMN_COUNT)
    return verified(Recording(samples=samples, **common))  # type: ignore[arg-type]  # as above


def _row(values: tuple[float, ...]) -> tuple[float, ...]:
    return values if len(values) == COLUMN_COUNT else (*values, math.nan)


def _point(item: Fields) -> Waypoint:
    text = item.text("move")
    move = LETTERS.get(text.removeprefix("MOVE "))
    if move is None:
        raise item.bad("move", "MOVE J, MOVE P, MOVE L, MOVE C")
    point = Waypoint(
        move,
        item.numbers("joints_deg" if move.name == "MOVE_J" else "pose", (6,)),
        item.numbers("middle", (6,)) if move.name == "MOVE_C" else None,
        item.whole("speed_percent", 30),
        item.number("dwell_s", 0.0),
        _gripper(item.maybe_object("gripper")),
        _light(item.maybe_object("light")),
        item.text("note", ""),
        item.texts("comments"),
        item.text("frame", ""),
        item.maybe_text("holds"),
    )
    item.nothing_else()
    reason = check_point(point)
    if reason is not None:
        raise FieldError(FieldProblem.BAD, item.path, refusal=reason)
    return point


def _gripper(item: Fields | None) -> GripperAction | None:
    if item is None:
        return None
    action: GripperAction
    if "opening_mm" in item:
        action = GripperOpening(item.number("opening_mm"), item.number("torque_nm", 1.0))
    else:
        action = GripperAngle(item.number("angle_deg"), item.number("speed_rad_s", 1.0))
    item.nothing_else()
    return action


def _light(item: Fields | None) -> LightAction | None:
    if item is None:
        return None
    names = ("joint", "red", "green", "blue", "lamp")
    light = LightAction(*[item.whole(name) for name in names])
    item.nothing_else()
    return light


def place_of(text: str, path: Path) -> tuple[int, int]:
    """Return line and column, from 1, of the value at a path, or of the last one found on the way.

    Args:
        text: Valid JSON.
        path: Keys and indices.
    """
    scan = json.JSONDecoder().raw_decode
    position = _skip(text, 0)
    for step in path:
        found = _enter(text, position, step, scan)
        if found is None:
            break
        position = found
    line = text.count("\n", 0, position) + 1
    return line, position - text.rfind("\n", 0, position)


def _enter(text: str, position: int, step: str | int, scan: _Scan) -> int | None:
    """Return the position of a member's value in an object or list; of equal names the last."""
    is_object = isinstance(step, str)
    if text[position : position + 1] != ("{" if is_object else "["):
        return None
    position = _skip(text, position + 1)
    index, found = 0, None
    while position < len(text) and text[position] not in "]}":
        key: object = index
        if is_object:
            key, position = scan(text, position)
            position = _skip(text, _skip(text, position) + 1)
        if key == step:
            found = position
            if not is_object:
                return found
        _, position = scan(text, position)
        position = _skip(text, position)
        if text[position : position + 1] == ",":
            position = _skip(text, position + 1)
        index += 1
    return found


def _skip(text: str, position: int) -> int:
    """Return the position behind white space."""
    while position < len(text) and text[position] in " \t\r\n":
        position += 1
    return position
