"""A trajectory of points as the operator wrote it; without numpy and without an arm.

A point of MOVE J holds six joint angles; one of MOVE P, L or C the pose of the flange it ends in,
in the base or in a user frame of the cell. An arc of MOVE C begins where the point before it ends
and passes through a middle pose.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, fields
from datetime import UTC, datetime
from itertools import chain, starmap
from operator import attrgetter
from typing import Any, Final, NamedTuple

from armui.arm.figures import Range
from armui.arm.refusal import Reason, Refusal
from armui.cell.checks import check_name as check_cell_name
from armui.cell.tools import Tool, check_tool
from armui.cell.user_frames import UserFrame, check_user_frame
from armui.protocol.codes import ALL_LAMPS, MoveMode

POINT_NOT_WHOLE = Reason("point_not_whole", "{field}: {value} is not a whole number.")
POINT_NOT_A_NUMBER = Reason("point_not_a_number", "{field}: “{value}” is not a number.")
POINT_OUT_OF_RANGE = Reason(
    "point_out_of_range",
    "{field}: {value}{unit} is out of range. Enter a value from {minimum}{unit} to "
    "{maximum}{unit}.",
)
POINT_MOVE_UNKNOWN = Reason(
    "point_move_unknown",
    ("“{value}” is not a kind of motion. Use MOVE J, MOVE P, MOVE L or MOVE C."),
)
POINT_INCOMPLETE = Reason(
    "point_incomplete", "{field}: {value} values; six belong there, and a middle only to MOVE C."
)
POINT_FRAME_OF_JOINTS = Reason(
    "point_frame_of_joints",
    "Joint angles belong to no frame, and this point names “{name}”. Make it MOVE P, L or C, or "
    "take the frame away.",
)
NAME_EMPTY = Reason("name_empty", "A trajectory needs a name. Enter one.")
NAME_TOO_LONG = Reason(
    "name_too_long", "The name has {value} characters; up to {maximum} are kept. Shorten it."
)
TEXT_BAD = Reason("text_bad", "{field}: holds a character that cannot be kept. Remove it.")
TEXT_TOO_LONG = Reason(
    "text_too_long", "{field}: {value} characters; up to {maximum} are kept. Shorten it."
)


Values = tuple[float, ...]
"""Six values: joint angles in degrees, or X Y Z in mm and RX RY RZ in degrees."""

MOVES: Final = (MoveMode.MOVE_J, MoveMode.MOVE_P, MoveMode.MOVE_L, MoveMode.MOVE_C)
"""The kinds of motion a point can have."""

VALUE_COUNT: Final = 6
LONGEST_TEXT: Final = 4000
"""The most characters of a note or a comment."""
LONGEST_NAME: Final = 200


ANGLE: Final = Range(-360.0, 360.0, "°")
PLACE: Final = Range(-2000.0, 2000.0, "mm")
FAR_PLACE: Final = Range(-12000.0, 12000.0, "mm")
"""The range in a user frame, whose origin may be 5 m away along each axis of the base."""
JOINT_NAMES: Final = ("J1", "J2", "J3", "J4", "J5", "J6")
POSE_NAMES: Final = ("X", "Y", "Z", "RX", "RY", "RZ")
RANGES: Final = {
    **dict.fromkeys(JOINT_NAMES, ANGLE),
    **dict.fromkeys(POSE_NAMES, PLACE),
    **dict.fromkeys(POSE_NAMES[3:], ANGLE),
    "speed": Range(1, 100, "%"),
    "dwell": Range(0.0, 3600.0, "s"),
    "opening": Range(0.0, 200.0, "mm"),
    "torque": Range(0.0, 5.0, "N·m"),
    "gripper angle": Range(-360.0, 360.0, "°"),
    "gripper speed": Range(0.0, 60.0, "rad/s"),
    "light joint": Range(1, 6, ""),
    "lamp": Range(0, ALL_LAMPS, ""),
    "red": Range(0, 255, ""),
    "green": Range(0, 255, ""),
    "blue": Range(0, 255, ""),
}
"""The range of each figure of a point for every arm: wider than any arm's own limits.

A motion at 0 % would never arrive. The torque's range is that of 0x159 in generation 2.
"""
WHOLE: Final = frozenset({"speed", "light joint", "lamp", "red", "green", "blue"})
"""The figures that are whole numbers."""


@dataclass(frozen=True, slots=True)
class GripperOpening:
    """Moves the gripper to an opening with a torque, as in generation 2 (0x159)."""

    opening_mm: float
    torque_nm: float = 1.0


@dataclass(frozen=True, slots=True)
class GripperAngle:
    """Moves the gripper to an angle with a speed, as in generation 1 (0x159)."""

    angle_deg: float
    speed_rad_s: float = 1.0


GripperAction = GripperOpening | GripperAngle


@dataclass(frozen=True, slots=True)
class LightAction:
    """Colours the lamps of a joint (0x121)."""

    joint: int
    red: int
    green: int
    blue: int
    lamp: int = ALL_LAMPS


@dataclass(frozen=True, slots=True)
class Waypoint:
    """One step of a trajectory: a motion, then actions, then a pause.

    Attributes:
        move: The kind of motion, one of :data:`MOVES`.
        target: Six joint angles for MOVE J, else the pose of the flange.
        middle: The pose through which an arc of MOVE C passes; ``None`` for every other kind.
        speed_percent: The percentage of the highest speed, 1–100.
        dwell_s: The pause at the target.
        gripper: The gripper's action on arrival.
        light: The lamps' action on arrival.
        note: The operator's own words.
        comments: The comment lines before the point in its file.
        frame: The name of the cell's user frame in which target and middle are; "" for the base.
        holds: The name of the cell's object that the hand holds from here on, "" for none;
            ``None`` if the point changes nothing about that.
    """

    move: MoveMode
    target: Values
    middle: Values | None = None
    speed_percent: int = 100
    dwell_s: float = 0.0
    gripper: GripperAction | None = None
    light: LightAction | None = None
    note: str = ""
    comments: tuple[str, ...] = ()
    frame: str = ""
    holds: str | None = None

    @property
    def is_joint(self) -> bool:
        """True if the target is six joint angles."""
        return self.move is MoveMode.MOVE_J

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the target's six values."""
        return JOINT_NAMES if self.is_joint else POSE_NAMES

    def figures(self) -> Iterator[tuple[str, float]]:
        """Yield every figure of the point with its name in :data:`RANGES`."""
        yield from zip(self.names, self.target, strict=False)
        if self.middle is not None:
            yield from zip(POSE_NAMES, self.middle, strict=False)
        yield "speed", self.speed_percent
        yield "dwell", self.dwell_s
        if isinstance(self.gripper, GripperOpening):
            yield "opening", self.gripper.opening_mm
            yield "torque", self.gripper.torque_nm
        elif self.gripper is not None:
            yield "gripper angle", self.gripper.angle_deg
            yield "gripper speed", self.gripper.speed_rad_s
        if self.light is not None:
            yield "light joint", self.light.joint
            yield "lamp", self.light.lamp
            yield "red", self.light.red
            yield "green", self.light.green
            yield "blue", self.light.blue


@dataclass(frozen=True, slots=True)
class PosesOf:
    """The tool and frames of the poses in a file, with the figures that its writer had.

    Attributes:
        tool: The tool whose poses they are; ``None`` for the flange.
        frames: The user frames that points name, where they stood.
    """

    tool: Tool | None = None
    frames: tuple[UserFrame, ...] = ()


OF_FLANGE: Final = PosesOf()


@dataclass(frozen=True, slots=True)
class Trajectory:
    """A named list of points.

    Attributes:
        name: The name the operator gave it.
        note: The operator's note.
        points: The points in the order of the run.
        modified: The time of the last change, with its time zone.
        closing: Comment lines after the last point of its file.
        taught_on: The arm it was taught on, as in `ModelFit.kind`; "" if not known.
        poses_of: Only as a file is written or read: everywhere else poses are the flange's.
    """

    name: str
    note: str = ""
    points: tuple[Waypoint, ...] = ()
    modified: datetime = datetime(1970, 1, 1, tzinfo=UTC)
    closing: tuple[str, ...] = ()
    taught_on: str = ""
    poses_of: PosesOf = OF_FLANGE

    def __reduce__(self) -> tuple[object, ...]:
        """Pickle the points as bare figures, which takes a fraction of the time."""
        rest = (self.name, self.note, self.modified, self.closing, self.taught_on)
        return _unpacked, (list(map(_FIELDS_OF, self.points)), *rest)


_FIELDS_OF: Final = attrgetter(*(field.name for field in fields(Waypoint)))


def _unpacked(  # noqa: PLR0917 - as pickle hands them on
    points: Iterable[tuple[Any, ...]],
    name: str,
    note: str,
    modified: datetime,
    closing: tuple[str, ...],
    taught_on: str,
) -> Trajectory:
    """Return the trajectory made of what :meth:`Trajectory.__reduce__` has pickled."""
    return Trajectory(name, note, tuple(starmap(Waypoint, points)), modified, closing, taught_on)


def frames_in(points: Iterable[Waypoint]) -> tuple[str, ...]:
    """Return the user frames that points name, sorted."""
    return tuple(sorted({point.frame for point in points if point.frame}))


class SpeedsFrom(NamedTuple):
    """The speeds of the points from a row on, up to the next `SpeedsFrom`.

    Attributes:
        row: The first such row.
        low, high: The lowest and highest speed percentage of all points from any of these rows on.
    """

    row: int
    low: int
    high: int


def speeds_of(points: Sequence[Waypoint]) -> tuple[SpeedsFrom, ...]:
    """Return the lowest and highest speed from each row on, an entry for each change; rows rise."""
    found: list[SpeedsFrom] = []
    low, high = 100, 1
    for row in range(len(points) - 1, -1, -1):
        percent = points[row].speed_percent
        low, high = min(low, percent), max(high, percent)
        if found and found[-1][1:] == (low, high):
            found.pop()
        found.append(SpeedsFrom(row, low, high))
    return tuple(reversed(found))


def range_of(field: str, *, far: bool) -> Range:
    """Return the range of a figure; with `far` that of a point in a user frame."""
    return FAR_PLACE if far and RANGES[field] is PLACE else RANGES[field]


def check_figure(field: str, value: float, *, far: bool = False) -> Refusal | None:
    """Return why a figure of a point is not possible, or ``None`` if it is.

    Args:
        field: A key of :data:`RANGES`.
        value: The value entered.
        far: True for a point in a user frame; see :func:`range_of`.
    """
    allowed = range_of(field, far=far)
    if not math.isfinite(value) or (field in WHOLE and value != int(value)):
        code = POINT_NOT_WHOLE if field in WHOLE else POINT_NOT_A_NUMBER
        return Refusal(code, {"field": field, "value": value, "unit": allowed.unit})
    if not allowed.minimum <= value <= allowed.maximum:
        return POINT_OUT_OF_RANGE(**allowed._asdict(), field=field, value=value)
    return None


def check_point(point: Waypoint) -> Refusal | None:
    """Return why a point is incomplete or possible for no arm, or ``None`` if it is fine.

    `armui.trajectory.planning.check` checks whether a particular arm can reach it.
    """
    if point.move not in MOVES:
        return POINT_MOVE_UNKNOWN(value=str(point.move))
    arc = point.move is MoveMode.MOVE_C
    if len(point.target) != VALUE_COUNT:
        return POINT_INCOMPLETE(field="target", value=len(point.target))
    if arc != (point.middle is not None) or (arc and len(point.middle or ()) != VALUE_COUNT):
        return POINT_INCOMPLETE(field="middle", value=len(point.middle or ()))
    if point.frame and point.is_joint:
        return POINT_FRAME_OF_JOINTS(name=point.frame)
    refusals = chain(
        (check_figure(*figure, far=bool(point.frame)) for figure in point.figures()),
        map(check_cell_name, filter(None, (point.frame, point.holds))),
        (check_text("comment", comment, lines=1) for comment in point.comments),
        (check_text("note", point.note),),
    )
    return next((each for each in refusals if each is not None), None)


def check_name(name: str) -> Refusal | None:
    """Return why a trajectory cannot have a name, or ``None``; every script is allowed."""
    if not name.strip():
        return NAME_EMPTY()
    if len(name) > LONGEST_NAME:
        return NAME_TOO_LONG(value=len(name), maximum=LONGEST_NAME)
    if any(character in name for character in "\r\n\0"):
        return TEXT_BAD(field="name")
    return check_text("name", name)


def check_text(field: str, text: str, *, lines: int = 0) -> Refusal | None:
    """Return why a text cannot be kept in a file, or ``None``: too long, half of a character.

    Args:
        field: The field of the text.
        text: The text.
        lines: 1 if it must be a single line.
    """
    if len(text) > LONGEST_TEXT:
        return TEXT_TOO_LONG(field=field, value=len(text), maximum=LONGEST_TEXT)
    half = any("\ud800" <= character <= "\udfff" for character in text)
    if half or "\0" in text or (lines and ("\n" in text or "\r" in text)):
        return TEXT_BAD(field=field)
    return None


def check_trajectory(trajectory: Trajectory) -> tuple[int, Refusal] | None:
    """Return the first reason why a trajectory cannot be saved, or ``None``.

    Returns:
        The row of the point, from 1, or 0 for the trajectory itself, and the reason.
    """
    refusal = check_name(trajectory.name) or check_text("note", trajectory.note)
    refusal = refusal or check_text("taught_on", trajectory.taught_on, lines=1)
    for comment in trajectory.closing:
        refusal = refusal or check_text("comment", comment, lines=1)
    if refusal is not None:
        return 0, refusal
    tool = trajectory.poses_of.tool
    if tool is not None:
        refusal = check_tool(tool) or (check_cell_name(tool.name) if tool.name else None)
    for frame in trajectory.poses_of.frames:
        refusal = refusal or check_user_frame(frame) or check_cell_name(frame.name)
    if refusal is not None:
        return 0, refusal
    for row, point in enumerate(trajectory.points, start=1):
        refusal = check_point(point)
        if refusal is not None:
            return row, refusal
    return None
