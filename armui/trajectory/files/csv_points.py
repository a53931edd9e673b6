"""One point of a trajectory as the cells of a row, and back."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from armui.arm.refusal_codes import RefusalCode
from armui.protocol.codes import ALL_LAMPS
from armui.trajectory.files.errors import broken
from armui.trajectory.files.log_points import LETTER_OF, LETTERS
from armui.trajectory.files.model import verified_point
from armui.trajectory.files.text import number, parse_number
from armui.trajectory.points.program import (
    GripperAction,
    GripperAngle,
    GripperOpening,
    LightAction,
    Values,
    Waypoint,
)

_JOINTS: Final = tuple(f"j{joint}_deg" for joint in range(1, 7))
_POSE: Final = ("x_mm", "y_mm", "z_mm", "rx_deg", "ry_deg", "rz_deg")
_MIDDLE: Final = tuple(f"middle_{title}" for title in _POSE)
_OPENING: Final = ("gripper_opening_mm", "gripper_torque_nm")
_ANGLE: Final = ("gripper_angle_deg", "gripper_speed_rad_s")
_LIGHT: Final = ("light_joint", "light_red", "light_green", "light_blue")
_LAMP: Final = "light_lamp"

TITLES: Final = (
    *("move", *_JOINTS, *_POSE, *_MIDDLE, "speed_percent", "dwell_s"),
    *(*_OPENING, *_ANGLE, *_LIGHT, _LAMP, "note"),
)
_WHOLE_DEFAULT: Final = 30


def write_cells(point: Waypoint) -> list[str]:
    """The cells of a point, in the order of :data:`TITLES`."""
    cells = {
        "move": f"MOVE {LETTER_OF[point.move]}",
        "speed_percent": str(point.speed_percent),
        "dwell_s": number(point.dwell_s),
        "note": point.note,
    }
    cells |= _named(_JOINTS if point.is_joint else _POSE, point.target)
    if point.middle is not None:
        cells |= _named(_MIDDLE, point.middle)
    gripper, light = point.gripper, point.light
    if isinstance(gripper, GripperOpening):
        cells |= _named(_OPENING, (gripper.opening_mm, gripper.torque_nm))
    elif gripper is not None:
        cells |= _named(_ANGLE, (gripper.angle_deg, gripper.speed_rad_s))
    if light is not None:
        cells |= _named(_LIGHT, (light.joint, light.red, light.green, light.blue))
        cells[_LAMP] = "all" if light.lamp == ALL_LAMPS else str(light.lamp)
    return [cells.get(title, "") for title in TITLES]


class Columns:
    """Where each title stands.

    Raises:
        TrajectoryFileError: A title is unknown or there twice.
    """

    def __init__(self, titles: Sequence[str]) -> None:
        self._places: dict[str, int] = {}
        for place, title in enumerate(titles):
            if title not in TITLES:
                raise broken(RefusalCode.COLUMN_UNKNOWN, 1, place + 1, value=title)
            if title in self._places:
                raise broken(RefusalCode.COLUMN_TWICE, 1, place + 1, field=title)
            self._places[title] = place
        self.count = len(titles)

    def column(self, title: str) -> int:
        """The cell's number, from 1; 0 where there is no such column."""
        return self._places.get(title, -1) + 1

    def cell(self, cells: Sequence[str], title: str) -> str:
        """The cell under a title, "" where there is no such column."""
        place = self._places.get(title)
        return "" if place is None else cells[place]


def read_cells(
    columns: Columns, cells: Sequence[str], line: int, comments: tuple[str, ...]
) -> Waypoint:
    """The point of a row.

    Raises:
        TrajectoryFileError: With the cell as column.
    """
    if len(cells) != columns.count:
        raise broken(RefusalCode.CELLS_COUNT, line, value=len(cells), expected=columns.count)
    row = _Row(columns, cells, line)
    text = row.text("move")
    move = LETTERS.get(text.upper().removeprefix("MOVE").strip())
    if move is None:
        raise broken(RefusalCode.POINT_MOVE_UNKNOWN, line, columns.column("move"), value=text)
    target = row.numbers(_JOINTS if move.name == "MOVE_J" else _POSE)
    middle = row.numbers(_MIDDLE) if move.name == "MOVE_C" else None
    point = Waypoint(
        move,
        target,
        middle,
        row.whole("speed_percent") if row.text("speed_percent") else _WHOLE_DEFAULT,
        row.number("dwell_s") if row.text("dwell_s") else 0.0,
        row.gripper(),
        row.light(),
        columns.cell(cells, "note"),
        comments,
    )
    return verified_point(point, line)


class _Row:
    """One row, its cells asked for by title."""

    def __init__(self, columns: Columns, cells: Sequence[str], line: int) -> None:
        self._columns = columns
        self._cells = cells
        self._line = line

    def text(self, title: str) -> str:
        return self._columns.cell(self._cells, title).strip()

    def number(self, title: str) -> float:
        column = self._columns.column(title)
        if not column:
            raise broken(RefusalCode.COLUMN_MISSING, self._line, field=title)
        return parse_number(self.text(title), self._line, column)

    def numbers(self, titles: Sequence[str]) -> Values:
        return tuple([self.number(title) for title in titles])

    def whole(self, title: str) -> int:
        value = self.number(title)
        if value != int(value):
            column = self._columns.column(title)
            raise broken(RefusalCode.POINT_NOT_WHOLE, self._line, column, field=title, value=value)
        return int(value)

    def gripper(self) -> GripperAction | None:
        if any(map(self.text, _OPENING)):
            return GripperOpening(*self.numbers(_OPENING))
        if any(map(self.text, _ANGLE)):
            return GripperAngle(*self.numbers(_ANGLE))
        return None

    def light(self) -> LightAction | None:
        if not any(map(self.text, _LIGHT)):
            return None
        joint, red, green, blue = map(self.whole, _LIGHT)
        every = self.text(_LAMP) in ("", "all")
        return LightAction(joint, red, green, blue, ALL_LAMPS if every else self.whole(_LAMP))


def _named(titles: Sequence[str], values: Sequence[float]) -> dict[str, str]:
    return dict(zip(titles, map(number, values), strict=True))
