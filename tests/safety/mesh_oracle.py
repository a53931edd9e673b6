"""How near an arm truly is to planes and boxes: by its meshes, and by nothing of the program's own.

The program encloses the arm in capsules and asks those. This oracle places the meshes of the robot
description by its own chain of joints and measures each of them: the corners against planes, which
is exact, and python-fcl against boxes. A distance below 0 is how deep a part lies inside.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import fcl
import numpy as np
import yourdfpy
from scipy.spatial.transform import Rotation

from armui.arm.models import model_folder, robot_description
from armui.cell.cell import Cell
from armui.cell.held_objects import HeldObject
from armui.cell.work_area import Area, AreaBox, AreaPlane, Zone
from armui.protocol.generation import PiperModel

DEEPEST_STEPS = 14
"""A depth is found by halving this often: to 0.01 mm of a box of 200 mm."""
FINEST_MM = 1.0
"""Between two places of the arm that were looked at nothing moves by more than twice this."""
_THINNEST_MM = 0.05


@dataclass(frozen=True)
class Gap:
    """How near a part is to a zone.

    Attributes:
        mm: The distance; below 0 the depth inside.
        zone: The name of the plane or box.
        part: The name of the mesh, or of what the flange carries.
    """

    mm: float
    zone: str = ""
    part: str = ""


NOTHING_NEAR = Gap(math.inf)


@dataclass(frozen=True)
class Part:
    """Something rigid that a link carries.

    Attributes:
        name: What it is called.
        link: The link of the description that it is fixed to.
        corners: Places whose hull it lies in, (n, 3) in the link; a sphere around each of them.
        round_mm: The radius of these spheres.
        shape: The same for python-fcl.
        place: Where that shape lies in the link.
        middle, radius: A sphere around all of it.
        skips: The names of the zones that it may touch.
    """

    name: str
    link: str
    corners: np.ndarray
    shape: Any
    place: np.ndarray
    round_mm: float = 0.0
    skips: frozenset[str] = frozenset()
    middle: np.ndarray = field(init=False)
    radius: float = field(init=False)

    def __post_init__(self) -> None:
        middle = (self.corners.min(axis=0) + self.corners.max(axis=0)) / 2.0
        radius = float(np.linalg.norm(self.corners - middle, axis=1).max()) + self.round_mm
        object.__setattr__(self, "middle", middle)
        object.__setattr__(self, "radius", radius)

    @property
    def furthest_mm(self) -> float:
        """How far from the link's origin it reaches."""
        return float(np.linalg.norm(self.corners, axis=1).max()) + self.round_mm


class Description:
    """The links of an arm by its robot description, and the meshes on them.

    Args:
        model: The model of the family.
        older_zeros: True for an arm with firmware before S-V1.6-3.
    """

    def __init__(self, model: PiperModel, *, older_zeros: bool = False) -> None:
        meshes = model_folder(model) / "meshes"

        def found(fname: str) -> str:
            return str(meshes / Path(fname).name)

        urdf = yourdfpy.URDF.load(
            str(robot_description(model, older_zeros=older_zeros)),
            filename_handler=found,
            build_collision_scene_graph=False,
        )
        self._joints = [_Joint(each) for each in _from_the_base(urdf.robot.joints)]
        self.parts = tuple(self._parts(urdf))

    @staticmethod
    def _parts(urdf: yourdfpy.URDF) -> Iterable[Part]:
        graph = urdf.scene.graph
        for node in graph.nodes_geometry:
            link = graph.transforms.parents[node]
            placed, name = graph[node]
            mesh = urdf.scene.geometry[name]
            if link == "base_link":
                continue  # no motion moves it
            offset = np.linalg.inv(graph[link][0]) @ placed
            corners = 1e3 * (np.asarray(mesh.vertices) @ offset[:3, :3].T + offset[:3, 3])
            shape = fcl.BVHModel()
            shape.beginModel(len(corners), len(mesh.faces))
            shape.addSubModel(corners, np.asarray(mesh.faces))
            shape.endModel()
            hull = 1e3 * (np.asarray(mesh.convex_hull.vertices) @ offset[:3, :3].T + offset[:3, 3])
            yield Part(Path(name).stem, link, hull, shape, np.eye(4))

    def links(self, joints_deg: Sequence[float], opening_mm: float) -> dict[str, np.ndarray]:
        """Return where each link is in the base, mm.

        Args:
            joints_deg: Six angles.
            opening_mm: How far the gripper is open: each finger stands half of it aside.
        """
        placed = {"base_link": np.eye(4)}
        for joint in self._joints:
            placed[joint.child] = placed[joint.parent] @ joint.turned(joints_deg, opening_mm)
        return placed

    def reaches_mm(self, parts: Sequence[Part]) -> np.ndarray:
        """Return (6,) how far from its axis each joint moves any of some parts at most."""
        up = {joint.child: joint for joint in self._joints}
        reaches = np.zeros(6)
        for part in parts:
            link, length = part.link, part.furthest_mm
            while link in up:
                joint = up[link]
                if joint.number is not None:
                    reaches[joint.number] = max(reaches[joint.number], length)
                length += joint.length_mm
                link = joint.parent
        return reaches


class _Joint:
    def __init__(self, joint: yourdfpy.Joint) -> None:
        self.parent, self.child = joint.parent, joint.child
        self._origin = np.eye(4) if joint.origin is None else np.array(joint.origin)
        self._origin[:3, 3] *= 1e3
        turns = joint.type == "revolute"
        self.number = int(joint.name.removeprefix("joint")) - 1 if turns else None
        self._slides = joint.type == "prismatic"
        self._axis = np.asarray(joint.axis, dtype=float)
        assert not turns or self._axis.tolist() == [0.0, 0.0, 1.0]

    @property
    def length_mm(self) -> float:
        return float(np.linalg.norm(self._origin[:3, 3]))

    def turned(self, joints_deg: Sequence[float], opening_mm: float) -> np.ndarray:
        placed = self._origin.copy()
        if self.number is not None:
            angle = math.radians(joints_deg[self.number])
            x, y = self._origin[:3, 0], self._origin[:3, 1]
            placed[:3, 0] = math.cos(angle) * x + math.sin(angle) * y
            placed[:3, 1] = math.cos(angle) * y - math.sin(angle) * x
        elif self._slides:
            placed[:3, 3] += self._origin[:3, :3] @ self._axis * opening_mm / 2.0
        return placed


def _from_the_base(joints: Sequence[yourdfpy.Joint]) -> Iterable[yourdfpy.Joint]:
    known, left = {"base_link"}, list(joints)
    while left:
        ready = [joint for joint in left if joint.parent in known]
        assert ready, "a link that hangs on nothing"
        yield from ready
        known |= {joint.child for joint in ready}
        left = [joint for joint in left if joint.child not in known]


@cache
def description(model: PiperModel) -> Description:
    """Return the description of a model; its meshes are read once."""
    return Description(model)


class MeshOracle:
    """Measures an arm with what it carries against zones.

    Args:
        zones: Planes and boxes, in the base; what is switched off does not count.
        model: The arm.
        cell: Tells which tool is on the flange, and what the hand holds.
    """

    def __init__(
        self,
        *zones: Zone,
        model: PiperModel = PiperModel.PIPER,
        cell: Cell | None = None,
    ) -> None:
        self._description = description(model)
        self.parts = (*self._description.parts, *_carried(cell))
        self.reaches_mm = self._description.reaches_mm(self.parts)
        self._planes = [_Plane(zone) for zone in zones if zone.on and isinstance(zone, AreaPlane)]
        self._boxes = [_Box(zone) for zone in zones if zone.on and isinstance(zone, AreaBox)]
        self._shapes = [fcl.CollisionObject(part.shape) for part in self.parts]
        self._middles = np.array([part.middle for part in self.parts])
        self._radii = np.array([part.radius for part in self.parts])

    @classmethod
    def of(cls, cell: Cell, model: PiperModel = PiperModel.PIPER) -> MeshOracle:
        """Return the one of a whole cell."""
        return cls(*cell.area.zones, model=model, cell=cell)

    def look(self, joints_deg: Sequence[float], opening_mm: float = 0.0) -> dict[str, Gap]:
        """Return the nearest part to each zone, by the zone's name."""
        placed = self._places(joints_deg, opening_mm)
        return {
            zone.name: zone.nearest(self, placed, math.inf) for zone in self._planes + self._boxes
        }

    def nearest(
        self, joints_deg: Sequence[float], opening_mm: float = 0.0, below_mm: float = math.inf
    ) -> Gap:
        """Return the nearest part to any zone.

        Args:
            joints_deg: Six angles.
            opening_mm: How far the gripper is open.
            below_mm: What is not nearer than this is of no interest: then `NOTHING_NEAR`.
        """
        placed = self._places(joints_deg, opening_mm)
        found = Gap(below_mm)
        for zone in self._planes + self._boxes:
            found = min(found, zone.nearest(self, placed, found.mm), key=lambda gap: gap.mm)
        return found if found.zone else NOTHING_NEAR

    def travel_mm(self, before_deg: Sequence[float], after_deg: Sequence[float]) -> float:
        """Return how far anything moves at most between two poses, each joint evenly."""
        return float(np.radians(np.abs(np.subtract(after_deg, before_deg))) @ self.reaches_mm)

    def along(
        self,
        before_deg: Sequence[float],
        after_deg: Sequence[float],
        opening_mm: float = 0.0,
        below_mm: float = math.inf,
    ) -> Gap:
        """Return the nearest part to any zone on the way from one pose to another.

        Args:
            before_deg, after_deg: The poses; the joints turn evenly from one to the other.
            opening_mm: How far the gripper is open.
            below_mm: See :meth:`nearest`.
        """
        found = min(
            (self.nearest(each, opening_mm, below_mm) for each in (before_deg, after_deg)),
            key=lambda gap: gap.mm,
        )
        parts = [(np.asarray(before_deg, float), np.asarray(after_deg, float))]
        while parts:
            start, end = parts.pop()
            half_mm = self.travel_mm(start.tolist(), end.tolist()) / 2.0
            if half_mm <= FINEST_MM:
                continue
            middle, sought = (start + end) / 2.0, min(found.mm, below_mm)
            gap = self.nearest(middle, opening_mm, sought + half_mm)
            if gap is NOTHING_NEAR:
                continue  # and so nothing between start and end is nearer than what was found
            found = min(found, gap, key=lambda each: each.mm)
            parts += [(start, middle), (middle, end)]
        return found if found.mm < below_mm else NOTHING_NEAR

    def _places(self, joints_deg: Sequence[float], opening_mm: float) -> _Placed:
        links = self._description.links(joints_deg, opening_mm)
        frames = np.array([links[part.link] for part in self.parts])
        middles = np.einsum("nij,nj->ni", frames[:, :3, :3], self._middles) + frames[:, :3, 3]
        return _Placed(frames, middles, self._radii, [False] * len(self.parts))

    def shape(self, number: int, placed: _Placed) -> Any:
        """Return a part for python-fcl, where it is."""
        if not placed.set[number]:
            frame = placed.frames[number] @ self.parts[number].place
            self._shapes[number].setTransform(fcl.Transform(frame[:3, :3], frame[:3, 3]))
            placed.set[number] = True
        return self._shapes[number]


@dataclass(frozen=True)
class _Placed:
    """Where the parts are: their links' frames, spheres around them, and which python-fcl knows."""

    frames: np.ndarray
    middles: np.ndarray
    radii: np.ndarray
    set: list[bool]


class _Plane:
    def __init__(self, zone: AreaPlane) -> None:
        self.name = zone.name
        frame = frame_of(zone.pose)
        self._normal, self._place = frame[:3, 2], frame[:3, 3]

    def nearest(self, oracle: MeshOracle, placed: _Placed, below_mm: float) -> Gap:
        bounds = (placed.middles - self._place) @ self._normal - placed.radii
        found = Gap(below_mm)
        for number in np.argsort(bounds):
            if bounds[number] >= found.mm:
                break
            part = oracle.parts[number]
            if self.name in part.skips:
                continue
            frame = placed.frames[number]
            normal = self._normal @ frame[:3, :3]
            away = (frame[:3, 3] - self._place) @ self._normal
            mm = float((part.corners @ normal).min() + away) - part.round_mm
            if mm < found.mm:
                found = Gap(mm, self.name, part.name)
        return found if found.zone else NOTHING_NEAR


class _Box:
    def __init__(self, zone: AreaBox) -> None:
        self.name = zone.name
        frame = frame_of(zone.pose)
        self._turn, self._place = frame[:3, :3], frame[:3, 3]
        self._transform = fcl.Transform(self._turn, self._place)
        self._half = np.array(zone.size_mm) / 2.0
        self._solid = fcl.CollisionObject(fcl.Box(*zone.size_mm), self._transform)

    def nearest(self, oracle: MeshOracle, placed: _Placed, below_mm: float) -> Gap:
        aside = np.abs((placed.middles - self._place) @ self._turn) - self._half
        bounds = np.linalg.norm(np.maximum(aside, 0.0), axis=1) - placed.radii
        found = Gap(below_mm)
        for number in np.argsort(bounds):
            if bounds[number] >= found.mm and bounds[number] > 0.0:
                break
            part = oracle.parts[number]
            if self.name in part.skips:
                continue
            mm = self._gap_mm(oracle.shape(int(number), placed))
            if mm < found.mm:
                found = Gap(mm, self.name, part.name)
        return found if found.zone else NOTHING_NEAR

    def _gap_mm(self, shape: Any) -> float:
        if not fcl.collide(shape, self._solid, fcl.CollisionRequest(), fcl.CollisionResult()):
            gap = fcl.distance(shape, self._solid, fcl.DistanceRequest(), fcl.DistanceResult())
            return max(float(gap), 0.0)
        return -self._depth_mm(shape)

    def _depth_mm(self, shape: Any) -> float:
        """Return how deep a shape reaches in: a box smaller by that on all sides is not touched."""
        free, touched = float(self._half.min()), 0.0
        for _ in range(DEEPEST_STEPS):
            depth = (free + touched) / 2.0
            inner = fcl.CollisionObject(
                fcl.Box(*np.maximum(2.0 * (self._half - depth), _THINNEST_MM)), self._transform
            )
            if fcl.collide(shape, inner, fcl.CollisionRequest(), fcl.CollisionResult()):
                touched = depth
            else:
                free = depth
        return touched


class Judge:
    """Follows an arm from look to look, and remembers how near it has been.

    Args:
        oracle: What measures it.

    Attributes:
        least: The nearest that it has been.
        first: Where it was at the first look.
    """

    def __init__(self, oracle: MeshOracle) -> None:
        self._oracle = oracle
        self._last_deg: tuple[float, ...] | None = None
        self._sure_mm = -math.inf
        self.least = NOTHING_NEAR
        self.first = NOTHING_NEAR

    def see(self, joints_deg: Sequence[float], opening_mm: float = 0.0) -> None:
        """Take in where the arm is now; it has come here evenly from the last look."""
        now_deg, last_deg = tuple(joints_deg), self._last_deg
        if last_deg is None:
            self.first = self.least = self._oracle.nearest(now_deg, opening_mm)
            self._sure_mm = self.least.mm
        elif now_deg != last_deg:
            # nothing is nearer than it was, less the way that it can have gone since
            self._sure_mm -= self._oracle.travel_mm(last_deg, now_deg)
            if self._sure_mm < self.least.mm:
                here = self._oracle.nearest(now_deg, opening_mm)
                on_the_way = self._oracle.along(last_deg, now_deg, opening_mm, self.least.mm)
                self.least = min(self.least, here, on_the_way, key=lambda gap: gap.mm)
                self._sure_mm = here.mm
        self._last_deg = now_deg


def frame_of(pose: Sequence[float]) -> np.ndarray:
    """Return X, Y, Z in mm and RX, RY, RZ in degrees as a matrix."""
    frame = np.eye(4)
    frame[:3, :3] = Rotation.from_euler("xyz", pose[3:], degrees=True).as_matrix()
    frame[:3, 3] = pose[:3]
    return frame


def _carried(cell: Cell | None) -> Iterable[Part]:
    """Yield the tool as a cylinder from the flange to its tip, and what the hand holds."""
    if cell is None:
        return
    tool = cell.chosen_tool
    if tool is not None and any(tool.pose[:3]):
        yield _cylinder(np.array(tool.pose[:3]), max(tool.radius_mm, _THINNEST_MM))
    if cell.held_object is not None:
        yield _held(cell.held_object, cell.area)


def _cylinder(tip: np.ndarray, radius_mm: float) -> Part:
    length = float(np.linalg.norm(tip))
    place = np.eye(4)
    place[:3, :3] = Rotation.align_vectors([tip / length], [[0.0, 0.0, 1.0]])[0].as_matrix()
    place[:3, 3] = tip / 2.0
    around = np.linspace(0.0, 2.0 * np.pi, 72, endpoint=False)
    rim = radius_mm * np.column_stack((np.cos(around), np.sin(around), np.zeros(72)))
    ends = np.array(((0.0, 0.0, -length / 2.0), (0.0, 0.0, length / 2.0)))
    corners = (rim[None] + ends[:, None]).reshape(-1, 3) @ place[:3, :3].T + place[:3, 3]
    return Part("tool", "flange", corners, fcl.Cylinder(radius_mm, length), place)


def _held(held: HeldObject, area: Area) -> Part:
    place = frame_of(held.pose)
    size = np.array(held.size_mm)
    skips = frozenset(held.may_touch) & {zone.name for zone in area.zones}
    if not held.is_rod:
        signs = np.array(np.meshgrid(*[(-0.5, 0.5)] * 3)).reshape(3, -1).T
        corners = (signs * size) @ place[:3, :3].T + place[:3, 3]
        return Part("held object", "flange", corners, fcl.Box(*size), place, skips=skips)
    radius = float(max(size[:2])) / 2.0
    half = max(float(size[2]) / 2.0 - radius, _THINNEST_MM / 2.0)
    ends = np.array(((0.0, 0.0, -half), (0.0, 0.0, half))) @ place[:3, :3].T + place[:3, 3]
    shape = fcl.Capsule(radius, 2.0 * half)
    return Part("held object", "flange", ends, shape, place, radius, skips)
