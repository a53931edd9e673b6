"""Computes the distances between the arm's own parts, as capsules along its links.

The capsules are as large as the meshes in ``urdf/``, a little within the covers: a reported
collision is a real contact. Neighbouring parts are left out, because their joints' limits keep them
apart.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.held_shape import HeldShape
from armui.arm.refusal import Contact
from armui.arm.tool_capsule import ToolCapsule
from armui.cell.enclosure import Capsule
from armui.cell.first_place import PlaceSearch, place_between
from armui.cell.moved_capsules import MovedCapsules
from armui.kinematics.forward import Links, link_frames, links
from armui.kinematics.geometry import JOINT_COUNT, Geometry, Wrist

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]

PARTS: Final = ("base", "upper arm", "forearm", "hand", "gripper", "tool", "held object")
"""The names of the arm's parts in findings."""

_COLUMN_RADIUS_MM: Final = 38.0
_SOCKET_MM: Final = (-33.0, 60.0)
_SOCKET_RADIUS_MM: Final = 25.0
"""The box with the sockets behind the foot: its radius, then its place along X and its height."""
_UPPER_ARM_RADIUS_MM: Final = 26.0
_FOREARM_RADIUS_MM: Final = 28.0
_HAND_RADIUS_MM: Final = 31.0
_RAISED_MM: Final = (40.0, 54.0)
"""The beginning and the end of the raised motor of a parallel wrist, without the capsule's ends."""
_RAISED_RADIUS_MM: Final = 27.0
_KNEE_MM: Final = (125.0, 29.0)
"""The bend of the upper arm: its place along the arm, and its distance outwards."""
_FOREARM_FROM_MM: Final = 60.0
"""The distance from the elbow at which the forearm begins; before it is the elbow's motor, a
neighbour of the upper arm.
"""
_PALM_AT_MM: Final = 54.0
_PALM_HALF_MM: Final = 56.0
_PALM_RADIUS_MM: Final = 14.0
_FINGER_RADIUS_MM: Final = 18.0
_SMALL_MM: Final = 1e-9


@dataclass(frozen=True, slots=True)
class _Capsule:
    part: str
    link: int
    start: Array
    end: Array
    radius_mm: float


@dataclass(frozen=True, slots=True)
class OwnBreach:
    """The first place on a way at which two parts of the arm are nearer than they may be.

    Attributes:
        index: The pose of the way before the place, by its index.
        share: The share of the way from that pose to the next one.
        one, other: The parts, names of `PARTS`.
        gap_mm: Their distance there; below 0 they reach into each other.
    """

    index: int
    share: float
    one: str
    other: str
    gap_mm: float


class OwnBody:
    """The distances between the parts of an arm.

    Args:
        geometry: The arm's geometry with its zeros.
        tool_mm: The distance from the flange to the gripper's tip; 0 without a gripper.
        gripper_turned_deg: The gripper's turn about the flange's Z axis.
        tool: The tool on the flange, which counts beside the gripper if it has a radius.
        held: What the hand holds.

    Attributes:
        pairs: The parts that could meet, two and two, as ``upper arm/gripper``.
    """

    def __init__(
        self,
        geometry: Geometry,
        tool_mm: float,
        gripper_turned_deg: float = 0.0,
        tool: ToolCapsule | None = None,
        held: HeldShape | None = None,
    ) -> None:
        pose = np.zeros((1, JOINT_COUNT))
        arm, frames = links(geometry, pose), link_frames(geometry, pose)[0]
        tool = None if tool is None or not tool.radius_mm else tool
        carried = _carried(arm, tool, held)
        met = (*_pairs(geometry, arm, tool_mm, gripper_turned_deg), *_with(geometry, arm, carried))
        pairs = [tuple(_fixed_to(each, frames) for each in pair) for pair in met]
        names = [f"{fixed.part}/{moving.part}" for fixed, moving in pairs]
        self.pairs = tuple(dict.fromkeys(names))
        rods = list(dict.fromkeys(fixed for fixed, _ in pairs))
        # a capsule seen from two links occurs once for each
        seen = list(dict.fromkeys((moving, fixed.link) for fixed, moving in pairs))
        self._geometry, self._rods = geometry, _Rods(rods)
        self._moved = MovedCapsules(
            geometry, [each for each, _ in seen], [link for _, link in seen]
        )
        self._search = PlaceSearch(self._moved, self._rods)
        order = np.argsort([self.pairs.index(name) for name in names], kind="stable")
        self._capsules = np.array([seen.index((each[1], each[0].link)) for each in pairs])[order]
        self._obstacles = np.array([rods.index(each[0]) for each in pairs])[order]
        self._pair_of = np.array([self.pairs.index(name) for name in names])[order]

    @property
    def reaches_mm(self) -> tuple[float, ...]:
        """For each joint the furthest any part of the arm goes when it turns by 1 rad, in mm."""
        return tuple(self._moved.reaches_mm.max(axis=(0, 1)).tolist())

    def gaps(self, joints_deg: npt.ArrayLike) -> Array:
        """Return (n, pairs) the distance of each two parts at (n, 6) angles.

        It is below 0 where they reach into each other.
        """
        poses = np.asarray(joints_deg, dtype=float).reshape(-1, JOINT_COUNT)
        frames = self._moved.frames(poses)
        count = len(self._capsules)
        which = np.repeat(np.arange(len(poses)), count)
        capsules = np.tile(self._capsules, len(poses))
        ends = self._moved.ends(frames, which, capsules)
        gaps = self._rods.supports(ends, np.tile(self._obstacles, len(poses)))[:, 0]
        gaps = (gaps - self._moved.radii_mm[capsules]).reshape(len(poses), count)
        begins = np.flatnonzero(np.diff(self._pair_of, prepend=-1))
        nearest: Array = np.minimum.reduceat(gaps, begins, axis=1)
        return nearest

    def contact(self, joints_deg: Sequence[float], pair: int) -> Contact:
        """Return where two parts, by the index of their pair, are nearest at six angles."""
        pose, those = np.array([joints_deg], dtype=float), np.flatnonzero(self._pair_of == pair)
        capsules, rods = self._capsules[those], self._obstacles[those]
        ends = self._moved.ends(self._moved.frames(pose), np.zeros_like(those), capsules)
        gaps = self._rods.supports(ends, rods)[:, 0] - self._moved.radii_mm[capsules]
        nearest = int(gaps.argmin())
        capsule, rod = int(capsules[nearest]), int(rods[nearest])
        frame = link_frames(self._geometry, pose)[0, self._rods.links[rod]]
        radius_mm = float(self._moved.radii_mm[capsule])
        place = place_between(self._rods, ends[nearest], radius_mm, rod)
        x, y, z = (frame[:3, :3] @ place + frame[:3, 3]).tolist()
        # The fingers lie in the axis of joint 6, so that their capsule is link 5's: report link 6.
        is_hand = self._moved.parts[capsule] == "gripper"
        both = self._rods.links[rod], JOINT_COUNT if is_hand else self._moved.links[capsule]
        return Contact(tuple(joints_deg), both, (x, y, z))

    def breach(
        self,
        way_deg: npt.ArrayLike,
        least_mm: npt.ArrayLike,
        spread_deg: npt.ArrayLike | None = None,
    ) -> OwnBreach | None:
        """Return the first place on a way at which two parts are too near, or ``None``.

        Args:
            way_deg: (n, 6) the way; between two of them the joints turn evenly.
            least_mm: (pairs,) the distance that is kept between each two; minus infinity for what
                is not asked.
            spread_deg: (6,) how far each joint may be off, either way, at the beginning; that
                shrinks evenly to 0 at the end. The answer holds for every such way.

        Returns:
            The place; where the way only just keeps the distance, by less than 0.5 mm, there may be
            one. ``None`` holds for all of the way.

        Raises:
            ValueError: A figure is none.
        """
        least = np.full((len(self._moved), len(self._rods)), -np.inf)
        least[self._capsules, self._obstacles] = np.asarray(least_mm, dtype=float)[self._pair_of]
        found = self._search.first(way_deg, least, spread_deg)
        if found is None:
            return None
        index, share = found.between(len(np.asarray(way_deg)))
        one, other = self._rods.parts[found.obstacle], self._moved.parts[found.capsule]
        return OwnBreach(index, share, one, other, found.gap_mm)


class _Rods:
    """Capsules that stand still, where others move about them.

    Args:
        capsules: The capsules, each in the frame of its link.
    """

    def __init__(self, capsules: Sequence[Capsule]) -> None:
        self.parts = tuple(each.part for each in capsules)
        self.links = [each.link for each in capsules]
        self._starts = np.array([each.start_mm for each in capsules])
        self._ends = np.array([each.end_mm for each in capsules])
        self._radii_mm = np.array([each.radius_mm for each in capsules])

    def __len__(self) -> int:
        return len(self.parts)

    def supports(self, ends: Array, which: Whole) -> Array:
        """Return (m, 5) the distances of m lines from one capsule each, and a support.

        Args:
            ends: (m, 2, 3) the ends of the lines, in mm.
            which: (m,) the capsule of each.
        """
        start, end = self._starts[which], self._ends[which]
        apart = _apart(ends[:, 0], ends[:, 1], start, end)
        distances = np.sqrt(_dot(apart, apart))
        # Crossing lines have no direction between them; zero is a valid support, too.
        apart /= np.where(distances > _SMALL_MM, distances, np.inf)[:, None]
        heights = np.maximum(_dot(apart, start), _dot(apart, end))
        radii_mm = self._radii_mm[which]
        return np.column_stack((distances - radii_mm, apart, heights + radii_mm))


def _apart(a: Array, b: Array, c: Array, d: Array) -> Array:
    """Return (n, 3) the shortest ways to the segments a–b from the segments c–d."""
    one, other, between = b - a, d - c, a - c
    one_2, other_2 = _dot(one, one), np.maximum(_dot(other, other), 1e-12)
    along, across = _dot(one, other), _dot(other, between)
    lean = _dot(one, between)
    slant = one_2 * other_2 - along**2
    parallel = slant <= 1e-9 * one_2 * other_2
    share = np.where(
        parallel, 0.0, (along * across - lean * other_2) / np.where(parallel, 1.0, slant)
    )
    share = np.clip(share, 0.0, 1.0)
    back = np.clip((along * share + across) / other_2, 0.0, 1.0)
    share = np.clip((along * back - lean) / np.maximum(one_2, 1e-12), 0.0, 1.0)
    apart: Array = between + share[:, None] * one - back[:, None] * other
    return apart


def _pairs(
    geometry: Geometry, arm: Links, tool_mm: float, gripper_turned_deg: float
) -> Iterator[tuple[_Capsule, _Capsule]]:
    """Return the parts that could meet."""
    fixed_parts = _fixed(geometry, arm)
    yield fixed_parts[0], _forearm(geometry, arm)
    for moving in _hand(geometry, arm, tool_mm, gripper_turned_deg):
        for fixed in fixed_parts:
            yield fixed, moving


def _carried(arm: Links, tool: ToolCapsule | None, held: HeldShape | None) -> Iterator[_Capsule]:
    """Return the capsules fixed to the flange beside the gripper."""
    if tool is not None:
        begin, end = (
            _in_flange(arm, [share * part for part in tool.tip_mm]) for share in tool.ends
        )
        yield _Capsule("tool", JOINT_COUNT, begin, end, tool.radius_mm)
    for rod in () if held is None else held.hull:
        begin, end = _in_flange(arm, rod.start_mm), _in_flange(arm, rod.end_mm)
        yield _Capsule("held object", JOINT_COUNT, begin, end, rod.radius_mm)


def _in_flange(arm: Links, place: Sequence[float]) -> Array:
    along, palm, hand = place
    return arm.flange + along * arm.along + palm * arm.palm + hand * arm.hand


def _with(
    geometry: Geometry, arm: Links, carried: Iterator[_Capsule]
) -> Iterator[tuple[_Capsule, _Capsule]]:
    """Return the parts that a carried object could meet; behind a bent tool also the forearm."""
    fixed_parts = (*_fixed(geometry, arm), _forearm(geometry, arm))
    for moving in carried:
        for fixed in fixed_parts:
            yield fixed, moving


def _forearm(geometry: Geometry, arm: Links) -> _Capsule:
    bar = arm.elbow + geometry.elbow_mm * arm.across + _FOREARM_FROM_MM * arm.forearm
    return _Capsule("forearm", 3, bar, arm.wrist, _FOREARM_RADIUS_MM)


def _fixed(geometry: Geometry, arm: Links) -> tuple[_Capsule, ...]:
    """Return base and upper arm, the column first."""
    foot = np.zeros_like(arm.elbow)
    shoulder = foot + np.array((0.0, 0.0, geometry.base_mm))
    knee = shoulder + _KNEE_MM[0] * arm.upper_arm - _KNEE_MM[1] * np.cross(arm.side, arm.upper_arm)
    column = _Capsule("base", 0, foot, shoulder, _COLUMN_RADIUS_MM)
    low = foot + np.array((_SOCKET_MM[0], 0.0, 0.0))
    socket = _Capsule("base", 0, low, low + np.array((0.0, 0.0, _SOCKET_MM[1])), _SOCKET_RADIUS_MM)
    upper = (
        _Capsule("upper arm", 2, shoulder, knee, _UPPER_ARM_RADIUS_MM),
        _Capsule("upper arm", 2, knee, arm.elbow, _UPPER_ARM_RADIUS_MM),
    )
    return (column, socket, *upper)


def _hand(
    geometry: Geometry, arm: Links, tool_mm: float, gripper_turned_deg: float
) -> Iterator[_Capsule]:
    if geometry.wrist is Wrist.PARALLEL:
        yield _Capsule("hand", 4, arm.wrist, arm.centre, _HAND_RADIUS_MM)
        # the motor of joint 5 stands on its axis, above the wrist
        along = (arm.centre - arm.wrist) / geometry.wrist_mm
        above = np.cross(along, arm.side)
        low, high = (arm.centre + place * above for place in _RAISED_MM)
        yield _Capsule("hand", 4, low, high, _RAISED_RADIUS_MM)
    yield _Capsule("hand", 5, arm.centre, arm.flange, _HAND_RADIUS_MM)
    if tool_mm > _PALM_AT_MM:
        palm = arm.flange + _PALM_AT_MM * arm.hand
        turn = math.radians(gripper_turned_deg)
        apart = math.cos(turn) * arm.palm - math.sin(turn) * arm.along
        aside = _PALM_HALF_MM * apart
        yield _Capsule("gripper", JOINT_COUNT, palm - aside, palm + aside, _PALM_RADIUS_MM)
        tip = arm.flange + (tool_mm - _FINGER_RADIUS_MM) * arm.hand
        yield _Capsule("gripper", 5, palm, tip, _FINGER_RADIUS_MM)


def _fixed_to(capsule: _Capsule, frames: Array) -> Capsule:
    """Return a capsule at a pose as one that is fixed to its link.

    Args:
        capsule: The capsule.
        frames: The frames of all links at that pose.
    """
    frame = frames[capsule.link]
    start, end = (
        tuple(map(float, frame[:3, :3].T @ (place[0] - frame[:3, 3])))
        for place in (capsule.start, capsule.end)
    )
    return Capsule(capsule.part, capsule.link, start, end, capsule.radius_mm)


def _dot(one: Array, other: Array) -> Array:
    products: Array = np.einsum("ij,ij->i", one, other)
    return products
