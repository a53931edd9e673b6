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
"""Between two places of a part that were looked at it moves by no more than twice this."""
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
        """Return (parts, 7) how far a part moves at most, for a radian of each joint or a mm open.

        That is how far it reaches from the joint's axis; a finger goes half of what opens.
        """
        up = {joint.child: joint for joint in self._joints}
        reaches = np.zeros((len(parts), 7))
        for row, part in zip(reaches, parts, strict=True):
            link, length = part.link, part.furthest_mm
            while link in up:
                joint = up[link]
                if joint.number is not None:
                    row[joint.number] = length
                elif joint.slides:
                    row[6] = 0.5
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
        self.slides = joint.type == "prismatic"
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
        elif self.slides:
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
        self, *zones: Zone, model: PiperModel = PiperModel.PIPER, cell: Cell | None = None
    ) -> None:
        self._description = description(model)
        self.parts = (*self._description.parts, *_carried(cell))
        self._reaches_mm = self._description.reaches_mm(self.parts)
        of = [zone for zone in zones if zone.on]
        self.zones = [_Plane(z) if isinstance(z, AreaPlane) else _Box(z) for z in of]
        self._shapes = [fcl.CollisionObject(part.shape) for part in self.parts]
        self._middles = np.array([part.middle for part in self.parts])
        self._radii = np.array([part.radius for part in self.parts])
        skips = [[zone.name in part.skips for zone in self.zones] for part in self.parts]
        self._counts = ~np.array(skips, dtype=bool).reshape(len(self.parts), len(self.zones))

    @classmethod
    def of(cls, cell: Cell, model: PiperModel = PiperModel.PIPER) -> MeshOracle:
        """Return the one of a whole cell."""
        return cls(*cell.area.zones, model=model, cell=cell)

    def look(self, joints_deg: Sequence[float], opening_mm: float = 0.0) -> dict[str, Gap]:
        """Return the nearest part to each zone, by the zone's name."""
        placed = self.placed((*joints_deg, opening_mm))
        bounds = self.bounds_mm(placed)
        found = {}
        for column, zone in enumerate(self.zones):
            alone = np.full_like(bounds, math.inf)
            alone[:, column] = bounds[:, column]
            found[zone.name] = self._nearest(placed, alone)
        return found

    def nearest(self, joints_deg: Sequence[float], opening_mm: float = 0.0) -> Gap:
        """Return the nearest part to any zone.

        Args:
            joints_deg: Six angles.
            opening_mm: How far the gripper is open.
        """
        placed = self.placed((*joints_deg, opening_mm))
        return self._nearest(placed, self.bounds_mm(placed))

    def along(
        self, before_deg: Sequence[float], after_deg: Sequence[float], opening_mm: float = 0.0
    ) -> Gap:
        """Return the nearest part to any zone on the way from one pose to another.

        Args:
            before_deg, after_deg: The poses; the joints turn evenly from one to the other.
            opening_mm: How far the gripper is open.
        """
        judge = Judge(self)
        judge.see(before_deg, opening_mm)
        judge.see(after_deg, opening_mm)
        return judge.least

    def travels_mm(self, start: np.ndarray, end: np.ndarray) -> np.ndarray:
        """Return (parts,) how far each part moves at most between two poses.

        Args:
            start, end: Six angles, and how far the gripper is open; all change evenly.
        """
        moved = np.abs(end - start)
        moved[:6] = np.radians(moved[:6])
        travels: np.ndarray = self._reaches_mm @ moved
        return travels

    def placed(self, pose: Sequence[float]) -> Placed:
        """Return where all parts are with six angles, and an opening of the gripper."""
        links = self._description.links(pose[:6], pose[6])
        frames = np.array([links[part.link] for part in self.parts])
        middles = np.einsum("nij,nj->ni", frames[:, :3, :3], self._middles) + frames[:, :3, 3]
        return Placed(frames, middles, self._radii, {})

    def bounds_mm(self, placed: Placed) -> np.ndarray:
        """Return (parts, zones) what each part is no nearer than to a zone: quickly, by spheres.

        What may touch a zone is infinitely far from it.
        """
        bounds = np.full(self._counts.shape, math.inf)
        for column, zone in enumerate(self.zones):
            bounds[:, column] = zone.bounds_mm(placed.middles) - placed.radii
        return np.where(self._counts, bounds, math.inf)

    def gap_mm(self, number: int, column: int, placed: Placed, below_mm: float) -> float:
        """Return the gap between a part and a zone.

        Args:
            number, column: Which part, and which zone.
            placed: Where the parts are.
            below_mm: What is certainly not below this need not be exact: less may be returned than
                the gap is, but no less than this.
        """
        part, zone = self.parts[number], self.zones[column]
        bound_mm = zone.bound_mm(part, placed.frames[number])
        if bound_mm >= below_mm or isinstance(zone, _Plane):
            return bound_mm
        if number not in placed.shapes:
            frame = placed.frames[number] @ part.place
            self._shapes[number].setTransform(fcl.Transform(frame[:3, :3], frame[:3, 3]))
            placed.shapes[number] = self._shapes[number]
        return zone.gap_mm(placed.shapes[number], apart=bound_mm > 0.0)

    def gap(self, number: int, column: int, mm: float) -> Gap:
        """Return a distance with the names of the part and the zone."""
        return Gap(mm, self.zones[column].name, self.parts[number].name)

    def _nearest(self, placed: Placed, bounds: np.ndarray) -> Gap:
        found = NOTHING_NEAR
        for place in np.argsort(bounds, axis=None).tolist():
            number, column = divmod(place, bounds.shape[1])
            if bounds[number, column] >= found.mm:
                break
            mm = self.gap_mm(number, column, placed, found.mm)
            if mm < found.mm:
                found = self.gap(number, column, mm)
        return found


@dataclass(frozen=True)
class Placed:
    """Where the parts are.

    Attributes:
        frames: Of their links.
        middles, radii: Spheres around them.
        shapes: Those that python-fcl was told of.
    """

    frames: np.ndarray
    middles: np.ndarray
    radii: np.ndarray
    shapes: dict[int, Any]


class _Plane:
    def __init__(self, zone: AreaPlane) -> None:
        self.name = zone.name
        frame = frame_of(zone.pose)
        self._normal, self._place = frame[:3, 2], frame[:3, 3]

    def bounds_mm(self, places: np.ndarray) -> np.ndarray:
        away: np.ndarray = (places - self._place) @ self._normal
        return away

    def bound_mm(self, part: Part, frame: np.ndarray) -> float:
        """Return how near a part is: by its corners, which is exact."""
        away = (frame[:3, 3] - self._place) @ self._normal
        return float((part.corners @ (self._normal @ frame[:3, :3])).min() + away) - part.round_mm


class _Box:
    def __init__(self, zone: AreaBox) -> None:
        self.name = zone.name
        frame = frame_of(zone.pose)
        self._turn, self._place = frame[:3, :3], frame[:3, 3]
        self._transform = fcl.Transform(self._turn, self._place)
        self._half = np.array(zone.size_mm) / 2.0
        self._solid = fcl.CollisionObject(fcl.Box(*zone.size_mm), self._transform)

    def bounds_mm(self, places: np.ndarray) -> np.ndarray:
        return _from_a_box(np.abs((places - self._place) @ self._turn) - self._half)

    def bound_mm(self, part: Part, frame: np.ndarray) -> float:
        """Return what a part is no nearer than: by a box around it that lies as this one does."""
        corners = part.corners @ (self._turn.T @ frame[:3, :3]).T
        middle = (frame[:3, 3] - self._place) @ self._turn
        low = corners.min(axis=0) + middle - part.round_mm
        high = corners.max(axis=0) + middle + part.round_mm
        return float(_from_a_box(np.maximum(low - self._half, -self._half - high)))

    def gap_mm(self, shape: Any, *, apart: bool) -> float:
        """Return how near a shape is; it is known whether they are apart."""
        if apart or not self._touches(self._solid, shape):
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
            if self._touches(inner, shape):
                touched = depth
            else:
                free = depth
        return touched

    @staticmethod
    def _touches(solid: Any, shape: Any) -> bool:
        return bool(fcl.collide(shape, solid, fcl.CollisionRequest(), fcl.CollisionResult()))


def _from_a_box(beyond: np.ndarray) -> np.ndarray:
    """Return how far (..., 3) beyond a box on each axis is from it; below 0 inside."""
    outside = np.linalg.norm(np.maximum(beyond, 0.0), axis=-1)
    return outside + np.minimum(beyond.max(axis=-1), 0.0)


class Judge:
    """Follows an arm from look to look, and remembers how near it has been.

    Of each part and each zone it keeps what they are at least apart, less what the part has moved
    by since: only what may have come nearer than the nearest so far is measured.

    Args:
        oracle: What measures it.

    Attributes:
        least: The nearest that it has been.
    """

    def __init__(self, oracle: MeshOracle) -> None:
        self._oracle = oracle
        self._last: np.ndarray | None = None
        self._sure_mm = np.zeros(0)
        self.least = NOTHING_NEAR

    def see(self, joints_deg: Sequence[float], opening_mm: float = 0.0) -> None:
        """Take in where the arm is now; it has come here evenly from the last look."""
        now, last, oracle = np.array((*joints_deg, opening_mm), float), self._last, self._oracle
        self._last = now
        if last is None:
            self._sure_mm = oracle.bounds_mm(oracle.placed(now.tolist()))
            self.least = oracle.nearest(joints_deg, opening_mm)
            return
        if np.array_equal(last, now):
            return
        travels = oracle.travels_mm(last, now)[:, None]
        before_mm, self._sure_mm = self._sure_mm, self._sure_mm - travels
        if not (self._sure_mm < self.least.mm).any():
            return
        placed = oracle.placed(now.tolist())
        self._sure_mm = np.maximum(self._sure_mm, oracle.bounds_mm(placed))
        nearest_mm = _on_the_way(before_mm, self._sure_mm, travels)
        for number, column in np.argwhere(nearest_mm < self.least.mm).tolist():
            was_mm, travel = float(before_mm[number, column]), float(travels[number, 0])
            now_mm = self._measure(number, column, placed, travel)
            self._sure_mm[number, column] = now_mm
            self._look_between(number, column, (last, now), (was_mm, now_mm))

    def _look_between(
        self,
        number: int,
        column: int,
        poses: tuple[np.ndarray, np.ndarray],
        gaps_mm: tuple[float, float],
    ) -> None:
        """Look at a part between two poses where it may come nearer than all before."""
        travel = float(self._oracle.travels_mm(*poses)[number])
        if travel / 2.0 <= FINEST_MM or _on_the_way(*gaps_mm, travel) >= self.least.mm:
            return
        (start, end), (start_mm, end_mm) = poses, gaps_mm
        middle = (start + end) / 2.0
        mm = self._measure(number, column, self._oracle.placed(middle.tolist()), travel / 2.0)
        self._look_between(number, column, (start, middle), (start_mm, mm))
        self._look_between(number, column, (middle, end), (mm, end_mm))

    def _measure(self, number: int, column: int, placed: Placed, travel_mm: float) -> float:
        """Return a gap, exactly where the part may come nearer than all before within a travel."""
        mm = self._oracle.gap_mm(number, column, placed, self.least.mm + travel_mm)
        if mm < self.least.mm:
            self.least = self._oracle.gap(number, column, mm)
        return mm


def _on_the_way(start_mm: Any, end_mm: Any, travel_mm: Any) -> Any:
    """Return how near a part comes at most between two poses, whose gaps are no less than these."""
    return np.maximum(
        (start_mm + end_mm - travel_mm) / 2.0, np.maximum(start_mm, end_mm) - travel_mm
    )


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
