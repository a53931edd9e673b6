"""The rules that restrict the ways of the arm, one class each, and the list of them.

Whatever moves the arm asks all of them by the one law (:mod:`armui.ways.law`). A new restriction is
a class here and a line in :func:`rules_of`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.arm.limits import (
    ANGLE_STEP_DEG,
    JOINT_OUT_OF_LIMITS,
    JOINTS,
    JOINTS_OUTSIDE,
    SAG_DEG,
    JointLimits,
    check_joint,
    outside_list,
)
from armui.arm.models import ArmModel
from armui.arm.refusal import Contact, Reason, Refusal
from armui.cell.area_check import AREA_IN_THE_WAY, AREA_ONLY_OUT, AreaCheck
from armui.cell.enclosure import Body, Capsule
from armui.cell.work_area import Area, AreaPlane
from armui.kinematics.poses import matrix_to_pose
from armui.ways.law import Excess, Rule
from armui.ways.own_body import OwnBody
from armui.ways.way import Array, Way, with_ramps

if TYPE_CHECKING:
    from armui.arm.models import Rising

TOO_LOW = Reason(
    "too_low",
    "The tool or what is held would come to {value} mm; motions end at {minimum} mm, as chosen "
    "under Settings. Move upwards.",
)
HITS_ITSELF = Reason(
    "hits_itself", "The arm would hit itself: {other} against {one}. Move another way."
)
TOUCHES_ITSELF = Reason(
    "touches_itself",
    "The arm touches itself: {other} against {one}; this would press them together. Move them "
    "apart.",
)

LIMITS: Final = "limits"
FLOOR: Final = "floor"
AREA: Final = "area"
OWN_BODY: Final = "own_body"
"""The names of the rules."""

_NOISE_MM: Final = 1.0
_EXACT_MM: Final = 0.01
_SOME: Final = 129
"""The number of poses by which the lowest height of a way is found."""
_FINE_DEG: Final = 0.1
_WITH_RAMPS: Final = 1.5
"""The factor by which a check takes longer with the joints' ramps."""
_FLANGE: Final = 6
_OWN_BODY_ZONES: Final = 10
"""The check of the arm's own body takes about as long as that of this many planes and boxes."""


class LimitsRule:
    """The limits of the joints; of each joint two bounds, its least and its greatest angle.

    Args:
        limits: Of the six joints.
    """

    name = LIMITS
    noise = SAG_DEG
    exact = ANGLE_STEP_DEG / 2
    may_stay = False
    reaches_mm: tuple[float, ...] = ()

    def __init__(self, limits: Sequence[JointLimits]) -> None:
        self._limits = tuple(limits)
        self._low = np.array([each.min_deg for each in limits])
        self._high = np.array([each.max_deg for each in limits])
        self.bounds = tuple(f"J{joint}{end}" for joint in JOINTS for end in "-+")

    def outside(self, joints_deg: Array) -> Array:
        """Return (n, 12) by how much each joint is below and above its limits."""
        ends = np.stack((self._low - joints_deg, joints_deg - self._high), axis=2)
        # NaN counts as outside, so that an unknown angle never passes (S35).
        known: Array = np.nan_to_num(ends.reshape(len(joints_deg), -1), nan=np.inf)
        return known

    def breach(self, way: Way, allowed: Array) -> Excess | None:
        """Return the first pose beyond a limit: between two poses the joints turn evenly."""
        found = self.outside(way.joints_deg)
        return _first(found - allowed, found, way.joints_deg)

    def finely(self, way: Way) -> Array:
        """Return the poses of the way."""
        return way.joints_deg

    def contact(self, breach: Excess) -> None:
        """Return ``None``: a joint at its limit touches nothing."""

    def refuse(self, breach: Excess, *, found_outside: bool) -> Refusal:
        """Return the joint, its angle and its limits as a reason; of joints outside, all."""
        place = breach.bound // 2
        if found_outside:
            return JOINTS_OUTSIDE(joints=outside_list(breach.joints_deg, self._limits))
        limits, angle = self._limits[place], breach.joints_deg[place]
        return check_joint(place + 1, angle, limits) or JOINT_OUT_OF_LIMITS(
            joint=place + 1, value=angle, minimum=limits.min_deg, maximum=limits.max_deg
        )


class AreaRule:
    """The planes and boxes of the cell's work area, with the margin that is kept from them.

    Args:
        check: The area, and the arm with all that it carries.
    """

    name = AREA
    noise = _NOISE_MM
    exact = _EXACT_MM
    may_stay = True

    def __init__(self, check: AreaCheck) -> None:
        self._check = check
        self.bounds = tuple(zone.name for zone in check.zones)
        self.reaches_mm = check.reaches_mm

    def outside(self, joints_deg: Array) -> Array:
        """Return (n, zones) by how much of the margin the arm is too near to each."""
        near: Array = self._check.margin_mm - self._check.gaps(joints_deg)
        return near

    def breach(self, way: Way, allowed: Array) -> Excess | None:
        """Return the first place that is too near to a plane or box."""
        return _in_zones(self._check, way, self._check.margin_mm - allowed)

    def finely(self, way: Way) -> Array:
        """Return poses between which no part moves by more than the noise."""
        return self._check.finely(way.joints_deg)

    def contact(self, breach: Excess) -> Contact:
        """Return where the arm is too near to the plane or box."""
        return self._check.contact(breach.joints_deg, breach.bound)

    def refuse(self, breach: Excess, *, found_outside: bool) -> Refusal:
        """Return the part and the plane or box as a reason."""
        part, name = breach.part, self.bounds[breach.bound]
        if not part:
            seen = self._check.nearest_entries(breach.joints_deg)
            part = next(entry.part for entry in seen if entry.zone.name == name)
        if found_outside:
            return AREA_ONLY_OUT(name=name, part=part, value=round(breach.outside, 1))
        gap_mm = self._check.margin_mm - breach.outside
        return AREA_IN_THE_WAY(
            name=name, part=part, value=round(gap_mm, 1), minimum=self._check.margin_mm
        )


class FloorRule:
    """The least height of flange, fingertip and held object that the operator has chosen.

    Args:
        arm: The arm, its tool, what it holds and how its base stands in the room.
        lowest_mm: The height.
    """

    name = FLOOR
    noise = _NOISE_MM
    exact = _EXACT_MM
    may_stay = True
    bounds: tuple[str, ...] = (FLOOR,)

    def __init__(self, arm: ArmModel, lowest_mm: float) -> None:
        self._lowest_mm = lowest_mm
        area = Area(planes=(AreaPlane(FLOOR, _level(arm.rising, lowest_mm)),), margin_mm=0.0)
        self._check = AreaCheck(area, Body(arm.kinematics.geometry, _low_parts(arm)))
        self.reaches_mm = self._check.reaches_mm

    def outside(self, joints_deg: Array) -> Array:
        """Return (n, 1) by how much the lowest place is too low."""
        low: Array = -self._check.gaps(joints_deg)
        return low

    def breach(self, way: Way, allowed: Array) -> Excess | None:
        """Return the first place that is too low."""
        return _in_zones(self._check, way, -allowed)

    def finely(self, way: Way) -> Array:
        """Return poses between which nothing moves by more than the noise."""
        return self._check.finely(way.joints_deg)

    def contact(self, breach: Excess) -> Contact:
        """Return where the lowest part reaches the height."""
        return self._check.contact(breach.joints_deg, breach.bound)

    def refuse(self, breach: Excess, *, found_outside: bool) -> Refusal:  # noqa: ARG002 - one sentence
        """Return the height as a reason."""
        value = round(self._lowest_mm - breach.outside, 1)
        return TOO_LOW(value=value, minimum=self._lowest_mm)


class OwnBodyRule:
    """The parts of the arm, its tool and what it holds, which may not touch each other.

    Args:
        body: The parts.
    """

    name = OWN_BODY
    noise = _NOISE_MM
    exact = _EXACT_MM
    may_stay = True

    def __init__(self, body: OwnBody) -> None:
        self._body = body
        self.bounds = body.pairs
        self.reaches_mm = body.reaches_mm

    def outside(self, joints_deg: Array) -> Array:
        """Return (n, pairs) by how much two parts are in each other."""
        deep: Array = -self._body.gaps(joints_deg)
        return deep

    def breach(self, way: Way, allowed: Array) -> Excess | None:
        """Return the first place where two parts touch."""
        found = self._body.breach(way.joints_deg, -allowed, way.spreads_deg)
        if found is None:
            return None
        bound = self.bounds.index(f"{found.one}/{found.other}")
        place = place_on(way.joints_deg, found.index, found.share)
        return Excess(bound, -found.gap_mm, place, index=found.index)

    def finely(self, way: Way) -> Array:
        """Return poses between which no joint turns by more than a tenth of a degree."""
        turns = np.abs(np.diff(way.joints_deg, axis=0)).max(axis=1, initial=0.0)
        steps = np.maximum(np.ceil(turns / _FINE_DEG), 1).astype(np.int64)
        parts = [
            before + np.linspace(0.0, 1.0, count + 1)[1:, None] * (after - before)
            for before, after, count in zip(
                way.joints_deg[:-1], way.joints_deg[1:], steps.tolist(), strict=True
            )
        ]
        return np.vstack((way.joints_deg[:1], *parts))

    def contact(self, breach: Excess) -> Contact:
        """Return where the two parts touch."""
        return self._body.contact(breach.joints_deg, breach.bound)

    def refuse(self, breach: Excess, *, found_outside: bool) -> Refusal:
        """Return the two parts as a reason."""
        one, other = self.bounds[breach.bound].split("/")
        return (TOUCHES_ITSELF if found_outside else HITS_ITSELF)(one=one, other=other)


@dataclass(frozen=True, eq=False)
class Rules:
    """The rules in force for one arm.

    Attributes:
        every: All of them, in the order in which they are asked.
        arm: The arm they are of.
    """

    every: tuple[Rule, ...]
    arm: ArmModel

    @cached_property
    def _reaches_mm(self) -> tuple[float, ...]:
        """Return how far each joint moves any part at most for a radian."""
        of_rules = [rule.reaches_mm for rule in self.every if rule.reaches_mm]
        return tuple(max(each) for each in zip(*of_rules, strict=True))

    def effort(self, way: Way) -> float:
        """Return the effort of checking a way: its turn in degrees times the obstacles."""
        turn_deg = way.turn_deg * (_WITH_RAMPS if way.is_joint_move else 1.0)
        zones = sum(len(rule.bounds) for rule in self.every if rule.name == AREA)
        # A motion that continues without braking cannot wait for the thread of long checks.
        return turn_deg * (zones if any(way.spread_deg) else _OWN_BODY_ZONES + zones)

    def ramped(self, way: Way) -> Way:
        """Return a way with the deviations that the joints' ramps may cause."""
        speeds = [each.max_speed_deg_s for each in self.arm.limits]
        return with_ramps(way, speeds, self.arm.accelerations_deg_s2)

    def travel_mm(self, ahead_deg: Sequence[float], now_deg: Sequence[float]) -> float:
        """Return how far any part of the arm moves at most between two poses."""
        return sum(
            math.radians(abs(a - b)) * reach
            for a, b, reach in zip(ahead_deg, now_deg, self._reaches_mm, strict=True)
        )

    def room_mm(self, joints_deg: Sequence[float]) -> float:
        """Return how far every part of an arm may move at six angles without a breach, in mm."""
        pose = np.array([joints_deg], dtype=float)
        rooms = [-rule.outside(pose).max(initial=-np.inf) for rule in self.every if rule.reaches_mm]
        return float(max(0.0, min(rooms, default=0.0)))

    def within_limits(self, joints_deg: Sequence[float]) -> bool:
        """Return whether six angles are within the joints' limits."""
        return all(
            each.min_deg <= angle <= each.max_deg
            for angle, each in zip(joints_deg, self.arm.limits, strict=True)
        )

    def lowest_mm(self, way: Way, agreed_mm: float) -> float | None:
        """Return how low over the floor a way leads, if that is below a height, else ``None``.

        Args:
            way: The way; an arm that begins below the height may stay, or come back.
            agreed_mm: The height; where a lowest one is chosen, that alone is asked.
        """
        if any(rule.name == FLOOR for rule in self.every):
            return None
        depths_mm = self._floor.outside(_some_poses(way))[:, 0]
        deepest_mm, begin_mm = float(depths_mm.max()), float(depths_mm[0])
        # without a tolerance, which would add up over many motions
        return -deepest_mm if deepest_mm > max(-agreed_mm, begin_mm) + _EXACT_MM else None

    @cached_property
    def _floor(self) -> FloorRule:
        return FloorRule(self.arm, 0.0)

    @property
    def are_bounded(self) -> bool:
        """True if a work area or a least height is in force, which an unknown way might break."""
        return any(rule.name in {AREA, FLOOR} for rule in self.every)


def rules_of(arm: ArmModel, area: AreaCheck | None = None, lowest_mm: float | None = None) -> Rules:
    """Return the rules of an arm.

    Args:
        arm: The arm, its tool, what it holds and how its base stands.
        area: Its work area; ``None`` if it may go anywhere.
        lowest_mm: The least height that the operator has chosen, or ``None``.
    """
    body = OwnBody(
        arm.kinematics.geometry, arm.tool_mm, arm.gripper_turned_deg, tool=arm.tool, held=arm.held
    )
    every: list[Rule] = [LimitsRule(arm.limits)]
    if lowest_mm is not None:
        every.append(FloorRule(arm, lowest_mm))
    if area is not None and not area.is_free:
        every.append(AreaRule(area))
    every.append(OwnBodyRule(body))
    return Rules(tuple(every), arm)


def _some_poses(way: Way) -> Array:
    """Return (n, 6) poses on a way, few enough for the window's thread: a mm may lie between two.

    They only serve to find the lowest height before the operator is asked, not for the check.
    """
    turns_deg = np.abs(np.diff(way.joints_deg, axis=0)).max(axis=1)
    at = np.concatenate(([0.0], np.cumsum(turns_deg)))
    places = np.linspace(0.0, at[-1], _SOME)
    return np.column_stack([np.interp(places, at, column) for column in way.joints_deg.T])


def place_on(joints_deg: Array, index: int, share: float) -> tuple[float, ...]:
    """Return the six angles between a pose of a way and the next one."""
    before = joints_deg[index]
    after = joints_deg[min(index + 1, len(joints_deg) - 1)]
    return tuple((before + share * (after - before)).tolist())


def _in_zones(check: AreaCheck, way: Way, least_mm: Array) -> Excess | None:
    found = check.breach(way.joints_deg, least_mm, way.spreads_deg)
    if found is None:
        return None
    bound = check.zones.index(found.zone)
    place = place_on(way.joints_deg, found.index, found.share)
    return Excess(bound, check.margin_mm - found.gap_mm, place, found.part, found.index)


def _first(over: Array, found: Array, joints_deg: Array) -> Excess | None:
    places = np.flatnonzero((over > 0.0).any(axis=1))
    if not len(places):
        return None
    place = int(places[0])
    bound = int(np.argmax(over[place]))
    pose = tuple(joints_deg[place].tolist())
    return Excess(bound, float(found[place, bound]), pose, index=place)


def _level(rising: Rising, height_mm: float) -> tuple[float, ...]:
    """Return a frame in the base on the level plane of a height in the room."""
    up, base_mm = np.array(rising[:3]), rising[3]
    aside = np.cross(up, (1.0, 0.0, 0.0) if abs(up[0]) < 0.9 else (0.0, 1.0, 0.0))
    aside /= np.linalg.norm(aside)
    frame = np.eye(4)
    frame[:3, :3] = np.stack((aside, np.cross(up, aside), up), axis=1)
    frame[:3, 3] = (height_mm - base_mm) * up
    return tuple(matrix_to_pose(frame))


def _low_parts(arm: ArmModel) -> tuple[Capsule, ...]:
    """Return the parts that count for the height: flange, fingertip or tool, and held object."""
    nothing = (0.0, 0.0, 0.0)
    parts = [Capsule("hand", _FLANGE, nothing, nothing, 0.0)]
    if arm.tool is None:
        tip = (0.0, 0.0, max(arm.tool_mm, 0.0))
        parts.append(Capsule("gripper", _FLANGE, tip, tip, 0.0))
    else:
        tip = arm.tool.tip_mm
        begin, end = (tuple(share * each for each in tip) for share in arm.tool.ends)
        parts += [
            Capsule("tool", _FLANGE, tip, tip, 0.0),
            Capsule("tool", _FLANGE, begin, end, arm.tool.radius_mm),
        ]
    for rod in () if arm.held is None else arm.held.edges:
        parts.append(Capsule("held object", _FLANGE, rod.start_mm, rod.end_mm, rod.radius_mm))
    return tuple(parts)
