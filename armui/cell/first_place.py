"""Finds the first place on a way of the joints at which something that moves is too near.

A part of the way is clear if a support of the obstacle (`armui.cell.nearness`) stays below
everything that moves over all of it. From one end of the part to the other a place goes along a
straight line, less a bulge: with turns h of the joints, in radians, and R_j its distance from the
axis of joint j, its second derivative is at most Σ R_max(i,j)·h_i·h_j; over the part that is a
bulge of an eighth of it. What is not clear is cut into shorter parts, until it moves by no more
than :data:`RESOLUTION_MM`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Protocol

import numpy as np
import numpy.typing as npt

from armui.cell.moved_capsules import MovedCapsules
from armui.kinematics.geometry import JOINT_COUNT

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]
Flags = npt.NDArray[np.bool_]

RESOLUTION_MM: Final = 0.5
"""A part too near by less than this may be reported or not; anything nearer is always found."""
_ROUNDING_MM: Final = 1e-6
_CUT: Final = 4
"""The number of pieces into which a part that is not clear is cut."""
_BULGE_MM: Final = 25.0
"""The first parts are as long as bulges of about this allow."""
_MOST_AT_ONCE: Final = 200_000
_TINY: Final = 1e-300
_PLACES: Final = 101
_PLAIN: Final = 11
"""The number of figures of a row without a spread."""


class Supports(Protocol):
    """The interface of obstacles: those of a work area, or any other convex shapes."""

    def __len__(self) -> int:
        """Return the number of obstacles."""

    def supports(self, ends: Array, which: Whole) -> Array:
        """Return what `Obstacles.supports` returns."""


class Facing(Supports, Protocol):
    """The interface of obstacles that can also be checked coarsely."""

    def facing(self, places: Array) -> tuple[Array, Array]:
        """Return what `Obstacles.facing` returns."""


@dataclass(frozen=True, slots=True)
class FirstPlace:
    """The first place at which something is too near.

    Attributes:
        at: The place on the way: 0 is its first pose, 1 the next one, 1.5 midway to the third.
        capsule: The index of what moves.
        obstacle: The index of what it is too near to.
        gap_mm: The distance there; with a spread the least possible one.
    """

    at: float
    capsule: int
    obstacle: int
    gap_mm: float

    def between(self, poses: int) -> tuple[int, float]:
        """Return the pose before the place on a way of `poses` poses, and the share to the next."""
        index = max(min(int(self.at), poses - 2), 0)
        return index, self.at - index


@dataclass(frozen=True, slots=True)
class _Parts:
    """Parts of the way.

    Attributes:
        begins, ends: (c,) the places between which each lies.
        turns: (c, 6) how far each joint turns, in radians.
        strays: (c, 6) how far each may be off the straight way, in radians: poses between the ends.
        spreads: (c, 6) how far each may be off at the begin by what is not known of the arm.
        widest: (c, 6) the same at most, all over the part.
    """

    begins: Array
    ends: Array
    turns: Array
    strays: Array
    spreads: Array
    widest: Array


@dataclass(frozen=True, slots=True)
class _Rows:
    """The pairs of a part of a way and an obstacle that are not known to be clear.

    Attributes:
        part, capsule, obstacle: (m,) which.
        begin, end: (m, 11) at the part's ends: the capsule's ends, six figures; what `supports`
            returns, five. With a spread there are twelve more, what `rises` returns for these.
    """

    part: Whole
    capsule: Whole
    obstacle: Whole
    begin: Array
    end: Array

    def chosen(self, which: Flags | Whole) -> _Rows:
        return _Rows(
            self.part[which],
            self.capsule[which],
            self.obstacle[which],
            self.begin[which],
            self.end[which],
        )


class _Way:
    """A way of the joints.

    Args:
        way_deg: (n, 6) its poses, two at least; between them the joints turn evenly.
        spread_deg: (n, 6) how far each joint may be off.
    """

    def __init__(self, way_deg: Array, spread_deg: Array) -> None:
        self._way_deg = way_deg
        self._spread = np.radians(spread_deg)
        self.is_spread = bool(self._spread.any())
        self.last = len(way_deg) - 1.0

    def poses(self, at: Array) -> Array:
        """Return (c, 6) the angles at places."""
        return _between(self._way_deg, at)

    def first_parts(self, bulges_mm: Array) -> Array:
        """Return places between which the way bulges by about `_BULGE_MM` at most.

        Args:
            bulges_mm: (n - 1,) how far it does between two poses.
        """
        lengths = np.sqrt(bulges_mm / _BULGE_MM)
        counts = np.maximum(np.ceil(lengths), 1.0).astype(np.int64)
        # Neighbouring parts that are short are joined into one.
        strides = np.floor(np.cumsum(lengths))
        alone = lengths > 0.5
        kept = np.ones(len(lengths), dtype=bool)
        kept[1:] = alone[1:] | alone[:-1] | (np.diff(strides) > 0.0)
        begins = np.flatnonzero(kept)
        counts = counts[begins]
        steps = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
        places = np.repeat(begins, counts) + steps / np.repeat(counts, counts)
        return np.append(places, self.last)

    def parts(self, begins: Array, ends: Array) -> _Parts:
        """Return the parts of the way between pairs of places."""
        first, last = self.poses(begins), self.poses(ends)
        strays = np.zeros((len(begins), JOINT_COUNT))
        long = np.flatnonzero(ends - begins > 1.0)
        if len(long):
            low = begins[long].astype(np.int64)
            counts = ends[long].astype(np.int64) - low - 1
            starts = np.cumsum(counts) - counts
            steps = np.arange(counts.sum()) - np.repeat(starts, counts) + 1
            rows = np.repeat(long, counts)
            shares = (steps / np.repeat(counts + 1, counts))[:, None]
            straight = first[rows] + shares * (last[rows] - first[rows])
            off = np.abs(self._way_deg[np.repeat(low, counts) + steps] - straight)
            strays[long] = np.radians(np.maximum.reduceat(off, starts, axis=0))
            widest = np.maximum.reduceat(self._spread[np.repeat(low, counts) + steps], starts)
        spreads = _between(self._spread, begins)
        widest_all = np.maximum(spreads, _between(self._spread, ends))
        if len(long):
            widest_all[long] = np.maximum(widest_all[long], widest)
        turns = np.radians(np.abs(last - first))
        return _Parts(begins, ends, turns, strays, spreads, widest_all)


def place_between(obstacles: Supports, line: Array, radius_mm: float, obstacle: int) -> list[float]:
    """Return the place midway between a capsule and an obstacle, or within both.

    Args:
        obstacles: The obstacles.
        line: (2, 3) the ends of the capsule's line, in mm.
        radius_mm: Its radius.
        obstacle: The index of the obstacle.
    """
    places = np.linspace(line[0], line[1], _PLACES)
    which = np.full(_PLACES, obstacle)
    supports = obstacles.supports(np.repeat(places[:, None], 2, axis=1), which)
    # the middle, if the line is parallel to a plane or an edge
    nearest = np.flatnonzero(supports[:, 0] <= supports[:, 0].min() + _ROUNDING_MM)
    at = nearest[len(nearest) // 2]
    place: list[float] = (
        places[at] - (supports[at, 0] + radius_mm) / 2.0 * supports[at, 1:4]
    ).tolist()
    return place


@dataclass(eq=False, repr=False)
class PlaceSearch:
    """Searches ways for the first place at which something that moves is too near to an obstacle.

    Args:
        moving: The moved capsules.
        obstacles: The obstacles from which a distance is kept.
        coarse: Fewer capsules that enclose all of it, and which of them each is in; needs
            obstacles that are `Facing`.
    """

    _moving: MovedCapsules
    _obstacles: Supports
    _coarse: tuple[MovedCapsules, Whole, Facing] | None = None

    def __post_init__(self) -> None:
        self._furthest_mm = self._moving.reaches_mm.max(axis=(0, 1), initial=0.0)

    def first(
        self, way_deg: npt.ArrayLike, least_mm: Array, spread_deg: npt.ArrayLike | None = None
    ) -> FirstPlace | None:
        """Return the first place on a way at which something is nearer than it may be, or ``None``.

        ``None`` holds for all of the way. A place returned may miss being too near by up to
        `RESOLUTION_MM`; it never lies behind the first that is too near.

        Args:
            way_deg: (n, 6) the way; between two poses the joints turn evenly.
            least_mm: (k, z) how near each capsule may come to each obstacle; minus infinity where
                nothing is asked.
            spread_deg: (6,) how far each joint may be off at the way's beginning; that shrinks
                evenly to 0 at its end. Or (n, 6) at each of its poses. The answer holds for every
                such way; how far it is told too early grows with the spread.

        Raises:
            ValueError: Something is no number, or no way of six joints.
        """
        way, spread, least = _checked(way_deg, least_mm, spread_deg)
        if not len(way) or not (least > -np.inf).any():
            return None
        if len(way) == 1:
            way, spread = np.repeat(way, 2, axis=0), np.repeat(spread, 2, axis=0)
        path = _Way(way, spread)
        turns = np.radians(np.abs(np.diff(way, axis=0, append=way[-1:])))[: int(path.last)]
        places = path.first_parts(_weights(turns) @ self._furthest_mm / 8.0)
        size = max(8, _MOST_AT_ONCE // (len(self._moving) * len(self._obstacles)))
        for begin in range(0, len(places) - 1, size):
            found = self._first(path, places[begin : begin + size + 1], least)
            if found is not None:
                return found
        return None

    def _first(self, way: _Way, places: Array, least_mm: Array) -> FirstPlace | None:
        """Return the first place between some that follow each other."""
        parts = way.parts(places[:-1], places[1:])
        frames = self._moving.frames(way.poses(places))
        part, capsule, obstacle = self._not_clear(parts, frames, least_mm)
        both = np.concatenate((part, part + 1))
        ends = self._states(way, frames, both, np.tile(capsule, 2), np.tile(obstacle, 2))
        rows = _Rows(part, capsule, obstacle, *np.split(ends, 2))
        found: FirstPlace | None = None
        while len(rows.part):
            rows, told = self._judged(parts, rows, least_mm)
            if told is not None and (found is None or told.at <= found.at):
                found = told
            if found is not None:
                rows = rows.chosen(parts.begins[rows.part] < found.at)
            if len(rows.part):
                parts, rows = self._cut(way, parts, rows)
        return found

    def _states(
        self, way: _Way, frames: Array, poses: Whole, capsules: Whole, obstacles: Whole
    ) -> Array:
        ends = self._moving.ends(frames, poses, capsules)
        supports = self._obstacles.supports(ends, obstacles)
        states = [ends.reshape(-1, 6), supports]
        if way.is_spread:
            rises = self._moving.rises(frames, poses, capsules, ends, supports[:, 1:4])
            states.append(rises.reshape(-1, 2 * JOINT_COUNT))
        return np.concatenate(states, axis=1)

    def _cut(self, way: _Way, parts: _Parts, rows: _Rows) -> tuple[_Parts, _Rows]:
        """Return shorter parts, and the rows of them."""
        used, which = np.unique(rows.part, return_inverse=True)
        begins, ends = parts.begins[used, None], parts.ends[used, None]
        places = begins + (ends - begins) * (np.arange(_CUT + 1) / _CUT)
        # a part with poses in it is cut at the poses
        np.rint(places, out=places, where=ends - begins > 1.0)
        frames = self._moving.frames(way.poses(places[:, 1:-1].ravel()))
        inner = (which[:, None] * (_CUT - 1) + np.arange(_CUT - 1)).ravel()
        capsule, obstacle = (np.repeat(each, _CUT - 1) for each in (rows.capsule, rows.obstacle))
        between = self._states(way, frames, inner, capsule, obstacle)
        states = np.concatenate(
            (rows.begin[:, None], between.reshape(len(which), _CUT - 1, -1), rows.end[:, None]),
            axis=1,
        )
        width = states.shape[2]
        shorter = _Rows(
            (which[:, None] * _CUT + np.arange(_CUT)).ravel(),
            np.repeat(rows.capsule, _CUT),
            np.repeat(rows.obstacle, _CUT),
            states[:, :-1].reshape(-1, width),
            states[:, 1:].reshape(-1, width),
        )
        return way.parts(places[:, :-1].ravel(), places[:, 1:].ravel()), shorter

    def _judged(
        self, parts: _Parts, rows: _Rows, least_mm: Array
    ) -> tuple[_Rows, FirstPlace | None]:
        """Return the rows that are undecided, and the first place that is too near."""
        moving, capsule = self._moving, rows.capsule
        least = least_mm[capsule, rows.obstacle] - _ROUNDING_MM
        reaches, radii = moving.reaches_mm[capsule], moving.radii_mm[capsule]
        moves, first = moving.moves[capsule], moving.first_joints[capsule]
        ends = np.concatenate((rows.begin[:, :6], rows.end[:, :6]), axis=1).reshape(-1, 4, 3)
        supports = np.stack((rows.begin[:, 6:11], rows.end[:, 6:11]), axis=1)
        gaps = (supports[:, :, 0] - radii[:, None]).T
        axes = moving.first_axes[capsule, None]
        along = 1.0 - _across(supports[:, :, 1:4], axes).max(axis=1)[:, None]

        def bulges_mm(turns: Array) -> Array:
            return _bulges_mm(_weights(turns) - along * _lead(turns, first), reaches)

        turns = parts.turns[rows.part] * moves
        bulges = bulges_mm(turns)
        heights = supports[:, :, 1:4] @ ends.swapaxes(1, 2) - supports[:, :, 4:]
        lowest = _lowest(heights, bulges)
        off = parts.strays[rows.part] + parts.widest[rows.part]
        strays = _moved_mm(parts.strays[rows.part], reaches)
        beyond = strays + _moved_mm(parts.widest[rows.part], reaches)
        near = gaps[0] - _moved_mm(parts.spreads[rows.part], reaches)
        if rows.begin.shape[1] > _PLAIN:
            # the part of the spread that leads towards the obstacle
            spread = parts.spreads[rows.part] * moves
            rises = np.abs(np.stack((rows.begin[:, _PLAIN:], rows.end[:, _PLAIN:])))
            rises = rises.reshape(2, -1, 2, JOINT_COUNT)
            here = np.einsum("mej,mj->me", rises[0], spread) + bulges_mm(spread) / 2.0
            near = np.maximum(near, (heights[:, 0, :2] - here).min(axis=1) - radii)
            off *= moves
            sunk = np.einsum("mej,mj->me", rises.max(axis=0), off)
            sunk += (bulges_mm(turns + off) - bulges) / 2.0
            lowest -= np.minimum(sunk, beyond[:, None])[:, None]
        else:
            lowest -= beyond[:, None, None]
        moved = np.linalg.norm(ends[:, 2:] - ends[:, :2], axis=2)
        moved = (moved + _bulges_mm(_weights(turns), reaches) / 4.0).max(axis=1)
        bounds = np.maximum(
            lowest.min(axis=2).max(axis=1) - radii, (gaps[0] + gaps[1] - moved) / 2.0 - beyond
        )
        left = np.flatnonzero(~(bounds >= least))
        gaps, near, least = gaps[:, left], near[left], least[left]
        ahead = gaps[1] < least
        told = near < least
        told |= ahead & (near < least + RESOLUTION_MM)
        told |= moved[left] + strays[left] <= RESOLUTION_MM
        part = rows.part[left]
        at = np.where(told, parts.begins[part], np.where(ahead, parts.ends[part], np.inf))
        rows_left = rows.chosen(left[~told])
        if not len(at) or at.min() == np.inf:
            return rows_left, None
        nearest = np.flatnonzero(at == at.min())
        value = np.where(told, near, gaps[1])
        chosen = int(nearest[(value - least)[nearest].argmin()])
        place = FirstPlace(
            float(at[chosen]),
            int(capsule[left[chosen]]),
            int(rows.obstacle[left[chosen]]),
            float(value[chosen]),
        )
        return rows_left, place

    def _not_clear(
        self, parts: _Parts, frames: Array, least_mm: Array
    ) -> tuple[Whole, Whole, Whole]:
        """Return part, capsule and obstacle of the pairs that the coarse capsules do not clear."""
        asked = least_mm > -np.inf
        if self._coarse is None:
            capsule, obstacle = np.nonzero(asked)
            count = len(parts.begins)
            part = np.repeat(np.arange(count), len(capsule))
            return part, np.tile(capsule, count), np.tile(obstacle, count)
        coarse, enclosing, obstacles = self._coarse
        ends = coarse.all_ends(frames)
        ends = np.concatenate((ends[:-1], ends[1:]), axis=2).reshape(-1, 4, 3)
        directions, heights = obstacles.facing(ends.mean(axis=1))
        directions = directions.swapaxes(0, 1)
        along = directions @ ends.swapaxes(1, 2) - heights.T[..., None]
        count = len(coarse)
        turns = np.repeat(parts.turns, count, axis=0)
        reaches = np.tile(coarse.reaches_mm, (len(parts.begins), 1, 1))
        bulges = _bulges_mm(_weights(turns), reaches)[:, None]
        lead = _bulges_mm(_lead(turns, np.zeros(len(turns), dtype=np.int64)), reaches)[:, None]
        across = _across(directions, coarse.first_axes[0])[..., None]
        bounds = _risen(along[..., :2], along[..., 2:], bulges - (1.0 - across) * lead).min(axis=2)
        off = _moved_mm(np.repeat(parts.strays + parts.widest, count, axis=0), reaches)
        off += np.tile(coarse.radii_mm, len(parts.begins))
        least = np.full((count, len(obstacles)), -np.inf)
        np.maximum.at(least, enclosing, least_mm)
        bounds = (bounds - off[:, None]).reshape(-1, count, len(obstacles))
        near = ~(bounds >= least - _ROUNDING_MM)
        part, capsule, obstacle = np.nonzero(near[:, enclosing] & asked)
        return part, capsule, obstacle


def _checked(
    way_deg: npt.ArrayLike, least_mm: Array, spread_deg: npt.ArrayLike | None
) -> tuple[Array, Array, Array]:
    way = np.asarray(way_deg, dtype=float)
    spread = np.zeros(JOINT_COUNT) if spread_deg is None else np.asarray(spread_deg, dtype=float)
    if way.shape[1:] != (JOINT_COUNT,) or spread.shape not in {(JOINT_COUNT,), way.shape}:
        raise ValueError(f"way_deg, spread_deg: {way.shape}, {spread.shape}: six joints are needed")
    if not (np.isfinite(way).all() and np.isfinite(spread).all() and (spread >= 0.0).all()):
        raise ValueError(f"way_deg, spread_deg: {way}, {spread}: finite angles are needed")
    if np.isnan(least_mm).any():
        raise ValueError(f"least_mm: {least_mm}: distances, or -inf for what is not asked")
    if spread.ndim == 1:
        spread = np.linspace(1.0, 0.0, len(way))[:, None] * spread
    return way, spread, least_mm


def _between(values: Array, at: Array) -> Array:
    """Return (c, 6) values at places, interpolated linearly between (n, 6) values."""
    index = np.minimum(at.astype(np.int64), len(values) - 2)
    begin, end = values[index], values[index + 1]
    found: Array = begin + (at - index)[:, None] * (end - begin)
    return found


def _weights(turns: Array) -> Array:
    """Return (…, 6) the weights of a place's distances from the joints' axes in its bulge.

    Args:
        turns: (…, 6) the turns of the joints, in radians.
    """
    weights: Array = turns * (2.0 * np.cumsum(turns, axis=-1) - turns)
    return weights


def _lead(turns: Array, first: Whole) -> Array:
    """Return (m, 6) the contribution to `_weights` of the first joint that turns.

    That part of the bulge is square to the axis of this joint.
    """
    rows = np.arange(len(turns))
    turn = turns[rows, first]
    lead = 2.0 * turn[:, None] * turns
    lead[rows, first] = turn**2
    return lead


def _bulges_mm(weights: Array, reaches_mm: Array) -> Array:
    """Return (m, e) how much the velocity of ends changes over a part, in mm, at most."""
    bulges: Array = np.einsum("mj,mej->me", weights, reaches_mm)
    return bulges


def _moved_mm(turns: Array, reaches_mm: Array) -> Array:
    """Return (m,) how far turns of the joints move anything of capsules at most."""
    moved: Array = np.einsum("mj,mej->me", turns, reaches_mm).max(axis=1)
    return moved


def _across(directions: Array, axes: Array) -> Array:
    """Return (…) how much of directions of length 1 at most is square to axes."""
    along = np.einsum("...i,...i->...", directions, axes)
    across: Array = np.sqrt(np.maximum(1.0 - along**2, 0.0))
    return across


def _lowest(heights: Array, bulges_mm: Array) -> Array:
    """Return (m, 3, 2) how high capsules' ends stay at least on their way, above three supports.

    Args:
        heights: (m, 2, 4) how high they are above the support at the way's begin, and above that at
            its end: first both ends at the begin, then both at the end.
        bulges_mm: (m, 2) what `_bulges_mm` returned.

    Returns:
        The heights above these two, and above one that leads from the first to the other.
    """
    begins, ends = heights[..., :2], heights[..., 2:]
    single = _risen(begins, ends, bulges_mm[:, None])
    # Any mean of two supports is a support, too.
    begin, end = begins[:, 0], ends[:, 1]
    middle = (ends[:, 0] + begins[:, 1]) / 2.0 - bulges_mm / 4.0
    dips = np.maximum(np.minimum(begin, end) - middle, 0.0)
    falls = begin - middle
    turned = np.where(
        dips > 0.0, begin - falls**2 / (falls + end - middle + _TINY), np.minimum(begin, end)
    )
    return np.concatenate((single, turned[:, None]), axis=1)


def _risen(begins: Array, ends: Array, bulges_mm: Array) -> Array:
    """Return (m, s, e) the least height on ways from some heights to others."""
    half = bulges_mm / 2.0
    dips = np.maximum(half - np.abs(ends - begins), 0.0)
    risen: Array = np.minimum(begins, ends) - dips**2 / (4.0 * half + _TINY)
    return risen
