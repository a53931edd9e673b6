"""The reach of the tool: a translucent border, and an inner one around unreachable places."""

from __future__ import annotations

import logging
import math
import threading
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

import numpy as np
import pyvista as pv
from numpy.typing import NDArray

from armui.viewport.palette import ScenePalette, rgb
from armui.viewport.process.geometry import actor_of
from armui.viewport.process.robot import ARM_JOINT_COUNT, rotation_about

if TYPE_CHECKING:
    from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

    from armui.viewport.path_picture import Reach
    from armui.viewport.process.robot import Robot


Array = NDArray[np.float64]
Shares = NDArray[np.float32]

_LOG = logging.getLogger(__name__)
_OUTER_OPACITY: Final = 0.10
_INNER_OPACITY: Final = 0.30
_FLOOR_OPACITY: Final = 0.6
VOXEL_M: Final = 0.02
_STEP_M: Final = 0.016
"""The distance between the places tried for joints 3 to 6."""
_CELL_M: Final = 0.014
_ROUND_SHOULDER: Final = 240
_ROUND_BASE: Final = 120
"""The number of cells around the axes of joints 2 and 1."""
_SHARES: Final = (0.2, 0.5, 0.8)
_LONGEST_M: Final = 4.0
"""The longest arm from base to tool: the voxels grow with the third power."""
_POINT_M: Final = 0.001
"""A turn that moves a point by less than this is neglected."""
_HALF: Final = 0.5
_LEFT_OUT: Final = 0.88
"""The share of the triangles removed: the border is smooth, and drawn in every picture."""
_DIRECTIONS: Final = 400
_DEEP_M: Final = 0.09
"""A border this far within the reach belongs to an inner region."""
_SMOOTHINGS: Final = 20


class ReachActor:
    """The border in a renderer.

    A thread computes it while pictures without it are drawn.
    """

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        self._actors: list[vtkActor] = []
        self._job: _Job | None = None
        self._palette: ScenePalette | None = None

    @property
    def is_unfinished(self) -> bool:
        """True if the requested border is not in the picture yet, and may come."""
        return self._job is not None and not self._actors and not self._job.has_failed

    def show(self, reach: Reach | None, robot: Robot, palette: ScenePalette) -> None:
        """Show the reach of a robot as soon as it is computed, or nothing."""
        job = self._job
        if reach is None:
            self._job = None
            self._clear()
        elif job is None or job.reach != reach or job.robot is not robot:
            self._job = _Job(robot, reach)
            self._clear()
        elif palette != self._palette:
            self._clear()
        self._palette = palette
        self.catch_up()

    def catch_up(self) -> bool:
        """Add results that are ready to the picture, and return whether there were any."""
        job, palette = self._job, self._palette
        if job is None or palette is None or self._actors or not job.is_done:
            return False
        shell = job.shell
        if shell is None:
            return False
        self._add(shell.outer, palette.accent, _OUTER_OPACITY)
        self._add(shell.inner, palette.speeds[1], _INNER_OPACITY)
        self._add(shell.floor, palette.accent, _FLOOR_OPACITY)
        return True

    def _add(self, surface: pv.PolyData, color: str, opacity: float) -> None:
        actor = actor_of(surface)
        appearance = actor.GetProperty()
        appearance.SetColor(*rgb(color))
        appearance.SetOpacity(opacity)
        appearance.LightingOff()
        actor.PickableOff()
        self._renderer.AddActor(actor)
        self._actors.append(actor)

    def _clear(self) -> None:
        for actor in self._actors:
            self._renderer.RemoveActor(actor)
        self._actors.clear()


class _Job:
    """One border, worked out in a thread."""

    def __init__(self, robot: Robot, reach: Reach) -> None:
        self.robot, self.reach = robot, reach
        self.shell: ReachShell | None = None
        self._thread = threading.Thread(target=self._work, name="armui-reach", daemon=True)
        self._thread.start()

    @property
    def is_done(self) -> bool:
        return not self._thread.is_alive()

    @property
    def has_failed(self) -> bool:
        return self.is_done and self.shell is None

    def _work(self) -> None:
        try:
            self.shell = shell_of(self.robot, self.reach)
        except Exception:  # noqa: BLE001 - without the reach the picture is still useful
            # for one, all axes of a foreign arm may lie in one plane
            _LOG.exception("The reach of the robot cannot be worked out")


@dataclass(frozen=True, eq=False)
class ReachVolume:
    """A box of voxels along the axes of the base frame.

    Attributes:
        shares: (nx, ny, nz) the reachable share of each voxel, 0 to 1.
        origin: Centre of the first voxel, metres.
        shoulder: The place of joint 2 at zero, metres.
    """

    shares: Shares
    origin: Array
    shoulder: Array

    def share_at(self, places: Array) -> Array:
        """Return (n,) the share of the voxels at (n, 3) places; 0 outside of the box."""
        at = np.rint((places - self.origin) / VOXEL_M).astype(int)
        inside = ((at >= 0) & (at < self.shares.shape)).all(axis=1)
        found = np.zeros(len(places))
        found[inside] = self.shares[tuple(at[inside].T)]
        return found


@dataclass(frozen=True, slots=True)
class _Axis:
    """A joint's axis while all joints are at zero, and two directions square to it.

    Attributes:
        place: On it, metres.
        rows: (3, 3) where angles are counted from, a quarter turn further, along the axis.
    """

    place: Array
    rows: Array

    def cylindrical(self, places: Array) -> tuple[Array, Array, Array]:
        """Return angle (degrees, 0 to 360), distance and height of (n, 3) places."""
        out, aside, height = ((places - self.place) @ self.rows.T).T
        return np.degrees(np.arctan2(aside, out)) % 360.0, np.hypot(out, aside), height

    def turned(self, places: Array, angles_deg: Array) -> Array:
        """Return (m × n, 3) the places after each turn about the axis."""
        turns = [rotation_about(self.rows[2], math.radians(each))[:3, :3] for each in angles_deg]
        spokes = places - self.place
        return np.concatenate([spokes @ turn.T for turn in turns]) + self.place


@dataclass(frozen=True, slots=True)
class _Grid:
    """Cells around an axis.

    Attributes:
        axis: The axis.
        low: The lowest height.
        cells: (angles, distances, heights) how much of each is reached.
    """

    axis: _Axis
    low: float
    cells: Shares

    def share_at(self, places: Array) -> Shares:
        """Return (n,) the share of the cells at (n, 3) places."""
        angles, far, heights = self.axis.cylindrical(places)
        count_angle, count_far, count_height = self.cells.shape
        at_angle = (angles * (count_angle / 360.0)).astype(int) % count_angle
        at_far = (far / _CELL_M).astype(int)
        at_height = np.floor((heights - self.low) / _CELL_M).astype(int)
        inside = (at_far < count_far) & (at_height >= 0) & (at_height < count_height)
        found = np.zeros(len(places), np.float32)
        found[inside] = self.cells[at_angle[inside], at_far[inside], at_height[inside]]
        return found

    def swept(self, limits_deg: tuple[float, float]) -> _Grid:
        """Return the volume covered by all turns within limits."""
        count = len(self.cells)
        first, last = (round(limit * count / 360.0) for limit in limits_deg)
        wide = min(last - first + 1, count)
        # a cell is reached from every cell that lies one of these turns before it
        begin = (np.arange(count) - (first + wide - 1)) % count
        cells = np.zeros_like(self.cells)
        for share in _SHARES:
            around = np.concatenate((self.cells, self.cells)) > share
            sums = np.cumsum(around, axis=0, dtype=np.int16)
            sums = np.concatenate((np.zeros_like(sums[:1]), sums))
            cells += sums[begin + wide] > sums[begin]
        cells /= np.float32(len(_SHARES))
        return replace(self, cells=cells)

    def soft(self) -> _Grid:
        """Return the same volume with a smoothed border."""
        return replace(self, cells=_softened(self.cells, round_axis=0))


def reached(robot: Robot, reach: Reach) -> ReachVolume:
    """Return the volume that the tool can reach.

    Args:
        robot: The arm.
        reach: Limits of its joints, and the tool.

    Raises:
        ValueError: the arm is so long that its voxels would fill the memory.
    """
    axes, cloud = _at_zero(robot, reach)
    places = np.concatenate([*(axis.place[np.newaxis] for axis in axes), cloud])
    length_m = float(np.linalg.norm(np.diff(places, axis=0), axis=1).sum())
    if length_m > _LONGEST_M:
        raise ValueError(f"{length_m:.0f} m of {_LONGEST_M:.0f} m at most")
    for axis, limits_deg in zip(axes[:1:-1], reach.limits_deg[:1:-1], strict=True):
        cloud = _turned(cloud, axis, limits_deg)
    upper = _around(axes[1], cloud).swept(reach.limits_deg[1]).soft()
    lower = _gathered(axes[0], upper).swept(reach.limits_deg[0]).soft()
    return _voxels(lower, axes[1].place)


def _at_zero(robot: Robot, reach: Reach) -> tuple[list[_Axis], Array]:
    """Return the joints' axes and the tool, (1, 3), in the base frame at zero."""
    poses = robot.link_poses((0.0,) * ARM_JOINT_COUNT, 0.0)
    by_name = {joint.name: joint for joint in robot.joints}
    axes = []
    for name in robot.arm_joints:
        joint = by_name[name]
        pose = poses[joint.parent] @ joint.origin
        along = pose[:3, :3] @ joint.axis
        plain = np.eye(3)[int(np.abs(along).argmin())]
        first = np.cross(along, plain) / np.linalg.norm(np.cross(along, plain))
        rows = np.array([first, np.cross(along, first), along])
        axes.append(_Axis(pose[:3, 3], rows))
    flange = poses[by_name[robot.arm_joints[-1]].child]
    return axes, (flange[:3, :3] @ np.array(reach.tool_m) + flange[:3, 3])[np.newaxis]


def _turned(cloud: Array, axis: _Axis, limits_deg: tuple[float, float]) -> Array:
    """Return the cloud at every angle of a joint, thinned: no two places in one cell."""
    low_deg, high_deg = limits_deg
    _, far, _ = axis.cylindrical(cloud)
    way_m = math.radians(high_deg - low_deg) * float(far.max())
    if way_m < _POINT_M:
        return axis.turned(cloud, np.array([low_deg]))
    steps = math.ceil(way_m / _STEP_M) + 1
    cloud = axis.turned(cloud, np.linspace(low_deg, high_deg, steps))
    cells = np.floor(cloud / (0.5 * _STEP_M)).astype(np.int64)
    cells -= cells.min(axis=0)
    wide = cells.max(axis=0) + 1
    keys = (cells[:, 0] * wide[1] + cells[:, 1]) * wide[2] + cells[:, 2]
    _, chosen = np.unique(keys, return_index=True)
    return cloud[chosen]


def _around(axis: _Axis, cloud: Array) -> _Grid:
    """Return a grid around an axis with the cells that a cloud is in."""
    angles, far, heights = axis.cylindrical(cloud)
    low = float(heights.min()) - _CELL_M
    count_far = int(far.max() / _CELL_M) + 2
    count_height = int((heights.max() - low) / _CELL_M) + 2
    cells = np.zeros((_ROUND_SHOULDER, count_far, count_height), np.float32)
    at_angle = (angles * (_ROUND_SHOULDER / 360.0)).astype(int) % _ROUND_SHOULDER
    at_height = ((heights - low) / _CELL_M).astype(int)
    cells[at_angle, (far / _CELL_M).astype(int), at_height] = 1.0
    return _Grid(axis, low, cells)


def _gathered(axis: _Axis, upper: _Grid) -> _Grid:
    """Return a grid around another axis that covers the same reached places."""
    _, at_far, at_height = np.nonzero(upper.cells)
    heights = np.abs(upper.low + _CELL_M * (at_height + 0.5))
    reach_m = float(np.hypot(_CELL_M * (at_far + 1), heights + _CELL_M).max())
    _, away, middle = axis.cylindrical(upper.axis.place[np.newaxis])
    low = float(middle[0]) - reach_m
    angles = np.radians((np.arange(_ROUND_BASE) + 0.5) * (360.0 / _ROUND_BASE))
    far = np.arange(0.5 * _CELL_M, float(away[0]) + reach_m + _CELL_M, _CELL_M)
    heights = np.arange(low + 0.5 * _CELL_M, low + 2.0 * reach_m + _CELL_M, _CELL_M)
    around = np.cos(angles)[:, np.newaxis] * axis.rows[0] + (
        np.sin(angles)[:, np.newaxis] * axis.rows[1]
    )
    spokes = axis.place + far[:, np.newaxis] * around[:, np.newaxis]
    places = spokes[:, :, np.newaxis] + heights[:, np.newaxis] * axis.rows[2]
    shares = upper.share_at(places.reshape(-1, 3))
    return _Grid(axis, low, shares.reshape(places.shape[:3]))


def _voxels(lower: _Grid, shoulder: Array) -> ReachVolume:
    """Return the reached volume, in a box along the axes of the base frame."""
    heights = np.flatnonzero(lower.cells.any(axis=(0, 1)))
    far = np.flatnonzero(lower.cells.any(axis=(0, 2)))
    out, along = lower.axis.rows[:2], lower.axis.rows[2]
    ends = lower.low + _CELL_M * np.array([heights[0], heights[-1] + 1])
    radius = _CELL_M * (far[-1] + 1)
    spread = radius * np.linalg.norm(out, axis=0)
    corners = lower.axis.place + ends[:, np.newaxis] * along
    low, high = corners.min(axis=0) - spread, corners.max(axis=0) + spread
    origin = low - 2.0 * VOXEL_M
    counts = np.ceil((high - low) / VOXEL_M).astype(int) + 5
    ticks = [
        start + VOXEL_M * np.arange(count) for start, count in zip(origin, counts, strict=True)
    ]
    places = np.stack(np.meshgrid(*ticks, indexing="ij"), axis=-1).reshape(-1, 3)
    shares = lower.share_at(places).reshape(counts)
    return ReachVolume(_softened(_softened(shares)), origin, shoulder)


def _softened(shares: Shares, round_axis: int | None = None) -> Shares:
    """Return the shares smoothed with their neighbours; one axis may be cyclic, the others end."""
    for axis in range(shares.ndim):
        if axis == round_axis:
            before, after = np.roll(shares, 1, axis), np.roll(shares, -1, axis)
        else:
            count = shares.shape[axis]
            before = shares.take(np.maximum(np.arange(count) - 1, 0), axis)
            after = shares.take(np.minimum(np.arange(count) + 1, count - 1), axis)
        shares = 0.25 * before + 0.5 * shares + 0.25 * after
    return shares.astype(np.float32)


@dataclass(frozen=True, slots=True)
class ReachShell:
    """The border's surfaces in the base frame, metres.

    Attributes:
        outer: The outer border of the reach.
        inner: The border of unreachable regions within.
        floor: The lines where both meet the floor.
    """

    outer: pv.PolyData
    inner: pv.PolyData
    floor: pv.PolyData


def shell_of(robot: Robot, reach: Reach) -> ReachShell:
    """Return the border of the reach; takes some tenths of a second."""
    volume = reached(robot, reach)
    border = _border(volume)
    border.point_data["depth"] = _depths(border.points)
    inner = border.clip_scalar(scalars="depth", value=_DEEP_M, invert=False)
    outer = border.clip_scalar(scalars="depth", value=_DEEP_M)
    floor = border.slice(normal="z", origin=(0.0, 0.0, 0.0))
    for shape in (inner, outer, floor):
        shape.clear_data()
    return ReachShell(outer, inner, floor)


def _border(volume: ReachVolume) -> pv.PolyData:
    """Return the surface where half of a voxel is reached, without the voxels' steps."""
    box = pv.ImageData(dimensions=volume.shares.shape, spacing=(VOXEL_M,) * 3, origin=volume.origin)
    box.point_data["share"] = volume.shares.ravel(order="F")
    border: pv.PolyData = box.contour([_HALF], scalars="share", method="flying_edges")
    smooth: pv.PolyData = border.smooth_taubin(n_iter=_SMOOTHINGS, pass_band=0.08)
    smooth.clear_data()
    few: pv.PolyData = smooth.decimate_pro(_LEFT_OUT, preserve_topology=True)
    return few


def _depths(places: NDArray[np.floating]) -> NDArray[np.float64]:
    """Return how deep each place lies within the convex hull of all."""
    # directions spread evenly over a sphere: a spiral from pole to pole
    numbers = np.arange(_DIRECTIONS) + 0.5
    heights = 1.0 - 2.0 * numbers / _DIRECTIONS
    turns = numbers * math.pi * (3.0 - math.sqrt(5.0))
    out = np.sqrt(1.0 - heights * heights)
    ways = np.array([out * np.cos(turns), out * np.sin(turns), heights])
    along = places @ ways
    depths: NDArray[np.float64] = (along.max(axis=0) - along).min(axis=1)
    return depths
