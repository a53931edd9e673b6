"""A trajectory of ROS: whether it can be followed, and where it is at a time.

Nothing here knows ROS: a message is anything with its fields. Angles are in degrees from here on.
"""

from __future__ import annotations

import bisect
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum
from itertools import pairwise
from typing import Any, Final

LONGEST_S: Final = 600.0
MOST_POINTS: Final = 10_000
START_WITHIN_S: Final = 1.0
"""A trajectory is begun when it comes: its stamp may be zero, or differ by this from now."""

_STEP_S: Final = 0.01
_RESTS_RAD_S: Final = 0.01
_ROUNDING: Final = 1.001


class Code(IntEnum):
    """How a trajectory has ended, as ``control_msgs/action/FollowJointTrajectory`` counts it."""

    SUCCESSFUL = 0
    INVALID_GOAL = -1
    INVALID_JOINTS = -2
    OLD_HEADER_TIMESTAMP = -3
    PATH_TOLERANCE_VIOLATED = -4
    GOAL_TOLERANCE_VIOLATED = -5


class Unfit(Exception):  # noqa: N818 - as one says it
    """A trajectory that is not followed.

    Attributes:
        code: What is wrong with it.
    """

    def __init__(self, text: str, code: Code = Code.INVALID_GOAL) -> None:
        super().__init__(text)
        self.code = code


@dataclass(frozen=True)
class Limit:
    """What a joint may do."""

    min_deg: float
    max_deg: float
    max_deg_s: float


@dataclass(frozen=True)
class Point:
    """Six angles at a time; with speeds in each point of a trajectory, or in none."""

    time_s: float
    angles_deg: tuple[float, ...]
    speeds_deg_s: tuple[float, ...] | None = None


def limits_of(hello: Mapping[str, Any], percent: float = 100.0) -> list[Limit]:
    """Return what the six joints may do in a stream, as armui tells it.

    Args:
        hello: Its answer.
        percent: The speed that the operator has granted.
    """
    fastest = hello["rates"]["stream_max_deg_s"]
    return [
        Limit(
            each["min_deg"],
            each["max_deg"],
            min(percent / 100.0 * each["max_speed_deg_s"], fastest),
        )
        for each in hello["limits"]
    ]


def points_of(message: Any, joints: Sequence[str], now_s: float) -> list[Point]:
    """Return the points of a ``trajectory_msgs/JointTrajectory``, in the order of the joints.

    Args:
        message: The message.
        joints: The names of the arm's joints.
        now_s: The time of ROS.

    Raises:
        Unfit: It can't be followed, wherever the arm is.
    """
    order = _order(list(message.joint_names), joints)
    stamp_s = _seconds(message.header.stamp)
    if stamp_s and abs(stamp_s - now_s) > START_WITHIN_S:
        text = (
            f"The stamp is {stamp_s - now_s:+.1f} s from now; a trajectory is begun when it comes."
        )
        raise Unfit(f"{text} Leave the stamp zero.", Code.OLD_HEADER_TIMESTAMP)
    if not message.points:
        raise Unfit("The trajectory has no points.")
    if len(message.points) > MOST_POINTS:
        raise Unfit(f"The trajectory has {len(message.points)} points; at most {MOST_POINTS}.")
    with_speeds = all(len(each.velocities) for each in message.points)
    points: list[Point] = []
    for number, each in enumerate(message.points, start=1):
        time_s = _seconds(each.time_from_start)
        if time_s < 0.0 or (points and time_s <= points[-1].time_s):
            before = f" after {points[-1].time_s:g} s" if points else ""
            text = f"Point {number} is at {time_s:g} s{before}: time_from_start must increase."
            raise Unfit(text)
        angles = _in_order(each.positions, order, f"Point {number}: positions")
        speeds = _in_order(each.velocities, order, f"Point {number}: velocities") or None
        points.append(Point(time_s, angles, speeds if with_speeds else None))
    if points[-1].time_s > LONGEST_S:
        raise Unfit(f"The trajectory takes {points[-1].time_s:g} s; at most {LONGEST_S:g} s.")
    last = points[-1].speeds_deg_s or ()
    if any(abs(each) > math.degrees(_RESTS_RAD_S) for each in last):
        raise Unfit("The last point has a velocity: the arm must end at rest.")
    return points


def _order(named: Sequence[str], joints: Sequence[str]) -> list[int]:
    """Return where each joint's figure stands in a point."""
    unknown = [each for each in named if each not in joints]
    if unknown:
        text = f"No joint that follows a trajectory is called “{unknown[0]}”; they are"
        raise Unfit(f"{text} {', '.join(joints)}.", Code.INVALID_JOINTS)
    twice = [each for each in joints if named.count(each) > 1]
    if twice:
        raise Unfit(f"{twice[0]} is named twice.", Code.INVALID_JOINTS)
    missing = [each for each in joints if each not in named]
    if missing:
        text = f"The trajectory lacks {', '.join(missing)}: name all six joints."
        raise Unfit(text, Code.INVALID_JOINTS)
    return [named.index(each) for each in joints]


def _in_order(values: Sequence[float], order: Sequence[int], what: str) -> tuple[float, ...]:
    if not len(values) and what.endswith("velocities"):
        return ()
    if len(values) != len(order):
        raise Unfit(f"{what} has {len(values)} values for {len(order)} joints.")
    if not all(map(math.isfinite, values)):
        raise Unfit(f"{what} has a value that is no number.")
    return tuple(math.degrees(values[each]) for each in order)


def _seconds(time: Any) -> float:
    return float(time.sec) + float(time.nanosec) * 1e-9


class Path:
    """Where a trajectory is at a time.

    Between two points it is a cubic (Hermite) where the points have velocities, else a straight
    line. Before a first point that is later than 0 s it comes from where the arm stands.

    Args:
        points: From :func:`points_of`.
        from_deg: Where the arm stands, or the last target of the trajectory that is replaced.
        limits: Of the joints.
        start_within_deg: How far from there a first point at 0 s may be.

    Attributes:
        duration_s: When it ends.
        goal_deg: Where.

    Raises:
        Unfit: It can't be followed from there.
    """

    def __init__(
        self,
        points: Sequence[Point],
        from_deg: Sequence[float],
        limits: Sequence[Limit],
        start_within_deg: float,
    ) -> None:
        first = points[0]
        if first.time_s == 0.0:
            _check_start(first.angles_deg, from_deg, start_within_deg)
        else:
            first = _beginning(first, from_deg, limits, start_within_deg)
            points = [first, *points]
        self._points = list(points)
        self._times_s = [each.time_s for each in points]
        self.duration_s = self._times_s[-1]
        self.goal_deg = points[-1].angles_deg
        self._limits = limits
        self._check()

    def at(self, time_s: float) -> tuple[float, ...]:
        """Return the six angles at a time from the start."""
        points = self._points
        after = bisect.bisect_right(self._times_s, time_s)
        if after == 0 or after == len(points):
            return points[max(0, after - 1)].angles_deg
        one, other = points[after - 1], points[after]
        span_s = other.time_s - one.time_s
        share = (time_s - one.time_s) / span_s
        if one.speeds_deg_s is None or other.speeds_deg_s is None:
            return tuple(
                a + share * (b - a) for a, b in zip(one.angles_deg, other.angles_deg, strict=True)
            )
        return tuple(
            _hermite(a, b, va * span_s, vb * span_s, share)
            for a, b, va, vb in zip(
                *(one.angles_deg, other.angles_deg, one.speeds_deg_s, other.speeds_deg_s),
                strict=True,
            )
        )

    def beyond(self, angles_deg: Sequence[float]) -> bool:
        """Return whether a joint is beyond its limits."""
        pairs = zip(angles_deg, self._limits, strict=True)
        return any(not limit.min_deg <= each <= limit.max_deg for each, limit in pairs)

    def _check(self) -> None:
        """Look at each 10 ms of it, and at each point: between points a cubic may leave the limits.

        Raises:
            Unfit: A joint would go beyond its limits, or faster than it may.
        """
        limits = self._limits
        steps = (each * _STEP_S for each in range(math.ceil(self.duration_s / _STEP_S)))
        times_s = sorted({*steps, *self._times_s})
        places = [self.at(each) for each in times_s]
        for time_s, angles in zip(times_s, places, strict=True):
            for joint, (angle, limit) in enumerate(zip(angles, limits, strict=True), start=1):
                if not limit.min_deg - 1e-6 <= angle <= limit.max_deg + 1e-6:
                    text = (
                        f"Joint {joint} would be at {angle:.1f}° after {time_s:.2f} s; its limits"
                    )
                    raise Unfit(f"{text} are {limit.min_deg:g}° to {limit.max_deg:g}°.")
        for (begins_s, ends_s), (one, other) in zip(
            pairwise(times_s), pairwise(places), strict=True
        ):
            for joint, (a, b, limit) in enumerate(zip(one, other, limits, strict=True), start=1):
                if abs(b - a) > _ROUNDING * limit.max_deg_s * (ends_s - begins_s) + 1e-6:
                    speed = abs(b - a) / (ends_s - begins_s)
                    text = (
                        f"Joint {joint} would turn at {speed:.0f}°/s after {begins_s:.2f} s; now it"
                    )
                    raise Unfit(f"{text} may turn at {limit.max_deg_s:.0f}°/s. Allow more time.")


def _check_start(start_deg: Sequence[float], from_deg: Sequence[float], within_deg: float) -> None:
    for joint, (start, now) in enumerate(zip(start_deg, from_deg, strict=True), start=1):
        if abs(start - now) > within_deg:
            text = f"The trajectory begins with joint {joint} at {start:.1f}°, but it is at"
            raise Unfit(f"{text} {now:.1f}°: more than {within_deg:g}° away.")


def _beginning(
    first: Point, from_deg: Sequence[float], limits: Sequence[Limit], within_deg: float
) -> Point:
    """Return a point at 0 s: where the arm stands.

    An arm may rest a little beyond its limits, where nothing can be followed: then the limit.
    """
    within = [
        max(limit.min_deg, min(limit.max_deg, each))
        for each, limit in zip(from_deg, limits, strict=True)
    ]
    _check_start(within, from_deg, within_deg)
    rests = None if first.speeds_deg_s is None else (0.0,) * len(within)
    return Point(0.0, tuple(within), rests)


def _hermite(a: float, b: float, va: float, vb: float, share: float) -> float:
    """Return the cubic through two angles with two speeds, in angles for the whole span."""
    left = 1.0 - share
    return (
        (1.0 + 2.0 * share) * left * left * a
        + share * left * left * va
        + share * share * (3.0 - 2.0 * share) * b
        - share * share * left * vb
    )


@dataclass(frozen=True)
class Tolerances:
    """How far the measured angles may be from the trajectory.

    Attributes:
        path_deg: On the way, of each joint; infinite: not looked at.
        goal_deg: At the end.
        goal_time_s: How long the arm may take to come there after the end.
    """

    path_deg: tuple[float, ...]
    goal_deg: tuple[float, ...]
    goal_time_s: float

    def astray(self, angles_deg: Sequence[float], wanted_deg: Sequence[float]) -> str | None:
        """Return in words which joint is too far from the path, or ``None``."""
        return _too_far(angles_deg, wanted_deg, self.path_deg)

    def off_goal(self, angles_deg: Sequence[float], goal_deg: Sequence[float]) -> str | None:
        """Return in words which joint is too far from the goal, or ``None``."""
        return _too_far(angles_deg, goal_deg, self.goal_deg)


def _too_far(
    angles_deg: Sequence[float], wanted_deg: Sequence[float], within_deg: Sequence[float]
) -> str | None:
    for joint, (angle, wanted, within) in enumerate(
        zip(angles_deg, wanted_deg, within_deg, strict=True), start=1
    ):
        if abs(angle - wanted) > within:
            return f"joint {joint} is at {angle:.1f}° instead of {wanted:.1f}° (±{within:.1f}°)"
    return None


def tolerances_of(goal: Any, joints: Sequence[str], usual: Tolerances) -> Tolerances:
    """Return the tolerances of a ``FollowJointTrajectory`` goal: of positions; 0: the usual ones.

    Raises:
        Unfit: One is of an unknown joint, or no number.
    """
    time_s = _seconds(goal.goal_time_tolerance)
    return Tolerances(
        _tolerances(goal.path_tolerance, joints, usual.path_deg),
        _tolerances(goal.goal_tolerance, joints, usual.goal_deg),
        math.inf if time_s < 0.0 else time_s or usual.goal_time_s,
    )


def _tolerances(
    told: Sequence[Any], joints: Sequence[str], usual: Sequence[float]
) -> tuple[float, ...]:
    found = dict(zip(joints, usual, strict=True))
    for each in told:
        if each.name not in found or not math.isfinite(each.position):
            raise Unfit(f"A tolerance of “{each.name}” can't be kept.", Code.INVALID_JOINTS)
        if each.position < 0.0:
            found[each.name] = math.inf
        elif each.position > 0.0:
            found[each.name] = math.degrees(each.position)
    return tuple(found.values())
