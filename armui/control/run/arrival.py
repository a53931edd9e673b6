"""Decides whether the arm has arrived at a point, by its own flag and its measured pose."""

from __future__ import annotations

import enum
import math
from collections.abc import Sequence
from typing import Final

from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.control.safety.interlocks import ARM_FAULT
from armui.protocol.codes import TARGET_REFUSALS
from armui.trajectory.points.program import Waypoint

RUN_ELSEWHERE = Reason(
    "run_elsewhere",
    "The arm says that it is there, but measures itself away from the point: {away}. See what "
    "keeps it.",
)


JOINT_TOLERANCE_DEG: Final = 0.1
PLACE_TOLERANCE_MM: Final = 0.5
TURN_TOLERANCE_DEG: Final = 0.3
"""A point is reached when every joint is this near to it, or the flange in place and turn."""

_TAKEN_IN_S: Final = 0.1
"""Feedback sooner than this after a point was sent may still be about the last point."""
_AT_REST_S: Final = 1.0
"""An arm that reports «reached» may measure elsewhere this long: angles have own frames."""


class Arrival(enum.Enum):
    """The states of a motion towards its point."""

    UNDER_WAY = enum.auto()
    REACHED = enum.auto()


class ArrivalWatch:
    """Watches one motion from its sending on."""

    def __init__(self, point: Waypoint, sent_s: float) -> None:
        self._point = point
        self._sent_s = sent_s
        self._elsewhere_since_s: float | None = None

    def check(self, state: ArmState, now_s: float) -> Arrival | Refusal:
        """Return the state of the motion, or why it will not be carried out."""
        status = state.status
        if status is None or status.at_s < self._sent_s + _TAKEN_IN_S:
            return Arrival.UNDER_WAY
        if status.value.arm_status in TARGET_REFUSALS:
            return ARM_FAULT(status=status.value.arm_status)
        if not status.value.reached:
            self._elsewhere_since_s = None
            return Arrival.UNDER_WAY
        away = distance(self._point, state)
        if away is None or not _fresh(state, self._sent_s + _TAKEN_IN_S, self._point.is_joint):
            return Arrival.UNDER_WAY
        if away <= 1.0:
            return Arrival.REACHED
        if self._elsewhere_since_s is None:
            self._elsewhere_since_s = now_s
        if state.in_time_for_s(now_s, self._elsewhere_since_s) < _AT_REST_S:
            return Arrival.UNDER_WAY
        return RUN_ELSEWHERE(away=_away_text(self._point, state))


def distance(point: Waypoint, state: ArmState) -> float | None:
    """Return the distance to a point, in units of the tolerance; ``None``: unknown."""
    if point.is_joint:
        angles_deg = state.angles_deg()
        if angles_deg is None:
            return None
        return _joints_away_deg(point.target, angles_deg) / JOINT_TOLERANCE_DEG
    pose = state.end_pose()
    if pose is None:
        return None
    place_mm, turn_deg = _pose_away(point.target, pose)
    return max(place_mm / PLACE_TOLERANCE_MM, turn_deg / TURN_TOLERANCE_DEG)


def _away_text(point: Waypoint, state: ArmState) -> str:
    angles_deg, pose = state.angles_deg(), state.end_pose()
    if point.is_joint and angles_deg is not None:
        return f"{_joints_away_deg(point.target, angles_deg):.2f}°"
    if pose is None:
        return "?"
    place_mm, turn_deg = _pose_away(point.target, pose)
    return f"{place_mm:.2f} mm, {turn_deg:.2f}°"


def _joints_away_deg(target: Sequence[float], angles_deg: Sequence[float]) -> float:
    return max(abs(a - b) for a, b in zip(target, angles_deg, strict=True))


def _pose_away(target: Sequence[float], pose: Sequence[float]) -> tuple[float, float]:
    """Return the distance of two poses in mm, and the angle between them in degrees."""
    from scipy.spatial.transform import Rotation  # noqa: PLC0415 - loaded with the first run

    first, second = (Rotation.from_euler("xyz", six[3:], degrees=True) for six in (target, pose))
    return math.dist(target[:3], pose[:3]), math.degrees((first.inv() * second).magnitude())


def _fresh(state: ArmState, since_s: float, joints: bool) -> bool:
    values = state.joints_deg if joints else state.pose
    return all(heard is not None and heard.at_s >= since_s for heard in values)
