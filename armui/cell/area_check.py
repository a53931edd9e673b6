"""Finds where the arm comes too near to planes and boxes of its work area.

The arm is the capsules of :mod:`armui.cell.enclosure`, which enclose every part that moves, with
the tool and what the hand holds. A gap is the distance of a capsule's surface from a plane or a
box; below 0 it is how far the capsule reaches in.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from armui.arm.models import STANDING, Rising, model_data
from armui.arm.refusal import Contact, Reason
from armui.cell.enclosure import Body, Capsule, body_of
from armui.cell.first_place import PlaceSearch, place_between
from armui.cell.held_shape import held_shape
from armui.cell.moved_capsules import MovedCapsules
from armui.cell.nearness import Obstacles
from armui.cell.work_area import Area, Zone

if TYPE_CHECKING:
    from armui.cell.cell import Cell
    from armui.kinematics.geometry import Geometry
    from armui.protocol.generation import PiperModel

Array = npt.NDArray[np.float64]

AREA_IN_THE_WAY = Reason(
    "area_in_the_way",
    "Not there: {part} would come to {value} mm from “{name}” of the work area; {minimum} mm are "
    "kept. Move another way, or change the area under Cell.",
)
AREA_ONLY_OUT = Reason(
    "area_only_out",
    "The arm is too near to “{name}” of the work area: {part}, by {value} mm; this would bring it "
    "nearer still. Move it away.",
)

SLACK_MM: Final = 1.0
"""Between two poses that are looked at no part comes nearer to anything by more than this."""
_LOOKED_MM: Final = 2.0 * SLACK_MM
_SAME_MM: Final = 1e-6
_FLANGE: Final = 6
_MOST_PAIRS: Final = 200_000
_DROP_MM: Final = 25.0
_BESIDE_MM: Final = 50.0
"""A plane or box within this distance of the line straight down counts as below."""


@dataclass(frozen=True, slots=True)
class AreaEntry:
    """A place at which the arm is too near to something.

    Attributes:
        zone: The plane or box.
        part: The part of the arm, a name of `PARTS`.
        gap_mm: Its distance; below 0 it is inside.
    """

    zone: Zone
    part: str
    gap_mm: float


@dataclass(frozen=True, slots=True)
class Breach:
    """The first place on a way at which the arm is nearer to something than it may be.

    Attributes:
        index: The pose of the way before the place, by its index.
        share: The share of the way from that pose to the next one.
        zone: The plane or box.
        part: The part of the arm, a name of `PARTS`.
        gap_mm: Its distance there; below 0 it is inside.
    """

    index: int
    share: float
    zone: Zone
    part: str
    gap_mm: float


class AreaCheck:
    """The checks of one arm in one work area.

    Args:
        area: The work area; what is switched off in it does not count.
        body: The arm with what it carries.
        rising: The rise of the base's axes in the room, and its height.
    """

    def __init__(self, area: Area, body: Body, rising: Rising = STANDING) -> None:
        self._rising = rising
        self._area = area.in_force
        self._reaches_mm = _reaches_mm(body)
        names = [zone.name for zone in self._area.zones]
        self._skipped = np.array(
            [[name in each.skips for name in names] for each in body.capsules], dtype=bool
        ).reshape(len(body.capsules), len(names))
        self._moved = MovedCapsules(body.geometry, body.capsules)
        self._obstacles = Obstacles(self._area.planes, self._area.boxes)
        coarse, enclosing = _by_part(body)
        self._search = PlaceSearch(
            self._moved,
            self._obstacles,
            (MovedCapsules(body.geometry, coarse), enclosing, self._obstacles),
        )

    @property
    def is_free(self) -> bool:
        """True if nothing is switched on: the arm may go anywhere."""
        return self._area.is_free

    @property
    def zones(self) -> tuple[Zone, ...]:
        """The planes, then the boxes, that are switched on."""
        return self._area.zones

    @property
    def reaches_mm(self) -> tuple[float, ...]:
        """For each joint the furthest any part of the arm goes when it turns by 1 rad, in mm."""
        return tuple(self._reaches_mm.tolist())

    @property
    def margin_mm(self) -> float:
        """The distance that is kept."""
        return self._area.margin_mm

    def is_too_near(self, entry: AreaEntry) -> bool:
        """Return whether a standing arm is too near; measurements may waver within the slack."""
        return entry.gap_mm < self.margin_mm - SLACK_MM

    def gaps(self, joints_deg: npt.ArrayLike) -> Array:
        """Return (n, zones) the least gap of the arm to each plane and box at (n, 6) angles.

        A zone that no part of the arm is checked against is infinitely far.
        """
        return self._nearest(joints_deg)[0]

    def breach(
        self,
        way_deg: npt.ArrayLike,
        least_mm: npt.ArrayLike,
        spread_deg: npt.ArrayLike | None = None,
    ) -> Breach | None:
        """Return the first place on a way at which the arm is too near to something, or ``None``.

        Args:
            way_deg: (n, 6) the way; between two of them the joints turn evenly.
            least_mm: (zones,) the gap that is kept to each; minus infinity for what is not asked.
            spread_deg: (6,) how far each joint may be off, either way, at the beginning; that
                shrinks evenly to 0 at the end. The answer holds for every such way.

        Returns:
            The place; where the way only just keeps the gap, by less than 0.5 mm, there may be one.
            ``None`` holds for all of the way.

        Raises:
            ValueError: A figure is none.
        """
        least = np.where(self._skipped, -np.inf, np.asarray(least_mm, dtype=float))
        found = self._search.first(way_deg, least, spread_deg)
        if found is None:
            return None
        index, share = found.between(len(np.asarray(way_deg)))
        zone, part = self._area.zones[found.obstacle], self._moved.parts[found.capsule]
        return Breach(index, share, zone, part, found.gap_mm)

    def nearest_entries(self, joints_deg: Sequence[float]) -> tuple[AreaEntry, ...]:
        """Return what of the arm is nearest to each plane and box at six angles, nearest first."""
        gaps, nearest = (each[0].tolist() for each in self._nearest([joints_deg]))
        parts = [self._moved.parts[capsule] for capsule in nearest]
        entries = map(AreaEntry, self._area.zones, parts, gaps)
        return tuple(sorted(entries, key=lambda entry: entry.gap_mm))

    def contact(self, joints_deg: Sequence[float], zone: int) -> Contact:
        """Return where an arm at six angles is nearest to a plane or box, by its index."""
        capsule = int(self._nearest([joints_deg])[1][0, zone])
        ends = self._moved.all_ends(self._moved.frames(np.array([joints_deg], dtype=float)))
        radius_mm = float(self._moved.radii_mm[capsule])
        x, y, z = place_between(self._obstacles, ends[0, capsule], radius_mm, zone)
        return Contact(tuple(joints_deg), (self._moved.links[capsule],), (x, y, z))

    def below(self, joints_deg: Sequence[float]) -> tuple[str, ...]:
        """Return the names of what an arm that sinks from six angles may come to.

        The way it falls is not known: whatever is below or close beside any part of it counts.
        """
        ends = self._moved.all_ends(self._moved.frames(np.array([joints_deg], dtype=float)))[0]
        up, base_mm = np.array(self._rising[:3]), self._rising[3]
        highest_mm = float((ends @ up).max()) + base_mm
        drops_mm = np.arange(0.0, max(highest_mm, 1.0), _DROP_MM)
        sunk = (ends - up * drops_mm[:, None, None, None]).reshape(-1, 2, 3)
        radii_mm = np.tile(self._moved.radii_mm, len(drops_mm))
        which = np.zeros(len(sunk), dtype=np.int64)
        return tuple(
            zone.name
            for index, zone in enumerate(self._area.zones)
            if (self._obstacles.supports(sunk, which + index)[:, 0] - radii_mm).min() < _BESIDE_MM
        )

    def _nearest(self, joints_deg: npt.ArrayLike) -> tuple[Array, npt.NDArray[np.int64]]:
        """Return (n, zones) the least gaps at (n, 6) angles, and the capsules that have them."""
        poses = np.asarray(joints_deg, dtype=float).reshape(-1, len(self._reaches_mm))
        shape = (len(poses), len(self._obstacles))
        gaps, nearest = np.full(shape, np.inf), np.zeros(shape, dtype=np.int64)
        size = max(1, _MOST_PAIRS // max(1, len(self._moved) * shape[1]))
        for begin in range(0, len(poses), size):
            block = slice(begin, begin + size)
            ends = self._moved.all_ends(self._moved.frames(poses[block]))
            middles = ends.mean(axis=2)
            known = self._obstacles.distances(middles.reshape(-1, 3)).T
            known = known.reshape(*middles.shape[:2], -1) - self._moved.radii_mm[:, None]
            known[:, self._skipped] = np.inf
            half = np.linalg.norm(ends[:, :, 1] - middles, axis=2)
            # Exact distances are computed only where a capsule may be the nearest one.
            pose, capsule, zone = np.nonzero(
                known - half[:, :, None] <= known.min(axis=1, keepdims=True) + _SAME_MM
            )
            exact = self._obstacles.supports(ends[pose, capsule], zone)[:, 0]
            known[:] = np.inf
            known[pose, capsule, zone] = exact - self._moved.radii_mm[capsule]
            known[:, self._skipped] = np.inf
            nearest[block] = known.argmin(axis=1)
            gaps[block] = known.min(axis=1)
        return gaps, nearest

    def finely(self, way_deg: Array) -> Array:
        """Return (n, 6) poses on a way, close together where the arm is near to something."""
        travels_mm = np.radians(np.abs(np.diff(way_deg, axis=0))) @ self._reaches_mm
        gaps = self.gaps(way_deg).min(axis=1, initial=np.inf)
        # With such gaps at both ends no part can come within the margin in between.
        clear = np.minimum(gaps[:-1], gaps[1:]) - travels_mm / 2.0 >= self.margin_mm
        steps = np.where(clear, 1, np.ceil(travels_mm / _LOOKED_MM)).astype(np.int64)
        steps = np.maximum(steps, 1)
        after = np.repeat(np.arange(1, len(way_deg)), steps)
        counts = np.arange(len(after)) - np.repeat(np.cumsum(steps) - steps, steps) + 1.0
        shares = (counts / np.repeat(steps, steps))[:, None]
        poses = way_deg[after - 1] + shares * (way_deg[after] - way_deg[after - 1])
        return np.vstack((way_deg[:1], poses))


def carried_body(
    model: PiperModel, geometry: Geometry, tool: Sequence[float], cell: Cell | None
) -> Body:
    """Return an arm with its gripper, the tool in force and what the hand holds.

    Args:
        model: The model of the arm.
        geometry: Its geometry with the zeros in force.
        tool: The tool centre point in the flange: X, Y, Z in mm, RX, RY, RZ in degrees.
        cell: The cell: it tells how thick the tool is, and what is held.
    """
    opening_mm = max(model_data(model).gripper.strokes_mm)
    body = body_of(model, geometry, opening_mm)
    chosen = None if cell is None else cell.chosen_tool
    if any(tool[:3]):
        radius_mm = 0.0 if chosen is None else chosen.radius_mm
        tip = tuple(tool[:3])
        body = body.with_more(Capsule("tool", _FLANGE, (0.0, 0.0, 0.0), tip, radius_mm))
    held = None if cell is None else cell.held_object
    if cell is not None and held is not None:
        shape, area = held_shape(held), cell.area
        touched = frozenset(held.may_touch)
        for rods, others in ((shape.hull, area.planes), (shape.edges, area.boxes)):
            # Planes are checked against the edges, which are exact, boxes against the hull.
            skips = touched | {zone.name for zone in others}
            body = body.with_more(
                *(
                    Capsule("held object", _FLANGE, rod.start_mm, rod.end_mm, rod.radius_mm, skips)
                    for rod in rods
                )
            )
    return body


def _by_part(body: Body) -> tuple[tuple[Capsule, ...], npt.NDArray[np.int64]]:
    """Return a capsule around what each part has on each link, and which one each is in."""
    names = [(each.link, each.part) for each in body.capsules]
    groups = sorted(set(names))
    around = tuple(
        _around([each for each, name in zip(body.capsules, names, strict=True) if name == group])
        for group in groups
    )
    return around, np.array([groups.index(name) for name in names], dtype=np.int64)


def _around(capsules: Sequence[Capsule]) -> Capsule:
    """Return a capsule that encloses others of one link."""
    ends = np.array([end for each in capsules for end in (each.start_mm, each.end_mm)])
    apart = np.linalg.norm(ends[:, None] - ends[None], axis=2)
    start, end = (ends[which] for which in np.unravel_index(apart.argmax(), apart.shape))
    along = end - start
    shares = np.clip((ends - start) @ along / max(float(along @ along), 1e-9), 0.0, 1.0)
    off = np.linalg.norm(ends - start - shares[:, None] * along, axis=1)
    radius_mm = float((off + np.repeat([each.radius_mm for each in capsules], 2)).max())
    return Capsule("base", capsules[0].link, tuple(start), tuple(end), radius_mm)


def _reaches_mm(body: Body) -> Array:
    """Return (6,) how far from its axis each joint moves anything at most."""
    to_next_mm = [math.hypot(row.a_mm, row.d_mm) for row in body.geometry.rows]
    reaches_mm = np.zeros(len(to_next_mm))
    for capsule in body.capsules:
        furthest_mm = max(math.hypot(*capsule.start_mm), math.hypot(*capsule.end_mm))
        for joint in range(capsule.link):
            between_mm = sum(to_next_mm[joint + 1 : capsule.link])
            reach_mm = between_mm + furthest_mm + capsule.radius_mm
            reaches_mm[joint] = max(reaches_mm[joint], reach_mm)
    return reaches_mm
