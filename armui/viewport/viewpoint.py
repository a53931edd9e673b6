"""Camera modes: fitted to the arm, moved by the operator, or following the tool. Pure."""

from __future__ import annotations

import enum
import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

from armui.viewport.camera import HOME_CAMERA, OrbitCamera, ViewDirection, poses_equal
from armui.viewport.fitting import (
    Ball,
    Box,
    Room,
    ball_around,
    boxes,
    fitted,
    is_ball_clear,
    is_clear,
    outermost,
)
from armui.viewport.path_picture import Reach
from armui.viewport.projection import Projection
from armui.viewport.robot_shape import RobotShape, moved
from armui.viewport.vectors import Vector

_GROWN: Final = 1.12
"""An arm that leaves the picture gets this factor of the room it needs, because it is moving."""
_SHRUNK: Final = 0.86
"""An arm at rest that fills less of the picture than this is shown larger."""
_FOLLOWED_AT_M: Final = 0.75


_TRIED: Final = 8
"""The steps in the range of a joint in which its reach is computed."""
_LETTERS: Final = ((0.19, 0.0, 0.0), (0.0, 0.19, 0.0))
"""Places beyond the letters X and Y at the base, in metres; the Z axis is within the arm."""
_SLACK_PX: Final = 10.0
"""The arm may come this far into the margin before the camera moves back."""


class ViewMode(enum.Enum):
    """The camera modes."""

    FIT = enum.auto()
    """The arm fills the room it has; when it leaves it, the camera moves back."""
    FREE = enum.auto()
    """The operator has turned or moved the picture, or changed its scale."""
    FOLLOW = enum.auto()
    """The tool stays in the middle."""


class Viewpoint:
    """The camera and its mode.

    Attributes:
        camera: The camera.
        mode: The camera mode.
        is_carried: True while a handle is held: the camera does not move, even by the wheel.
    """

    def __init__(self) -> None:
        self.camera = HOME_CAMERA
        self.mode = ViewMode.FIT
        self._shape: RobotShape | None = None
        self._balls: list[Ball | None] = []
        self._room = Room(1.0, 1.0)
        self._poses: list[tuple[tuple[float, ...], float]] = [((0.0,) * 6, 0.0)]
        self._places: tuple[Vector, ...] = ()
        self._boxes: tuple[Vector, ...] = ()
        self._with_boxes = False
        self._tool_m: Vector = (0.0, 0.0, 0.0)
        self._reach: Reach | None = None
        self._reached: tuple[Vector, ...] = ()
        self._been: list[Sequence[Vector]] = []
        self._is_held = False
        self.is_carried = False

    # what is visible --------------------------------------------------------------------------

    def set_shape(self, shape: RobotShape) -> None:
        """Set the robot in the picture, once it is known."""
        if shape != self._shape:
            self._shape = shape
            self._balls = [ball_around(points) if points else None for points in shape.points]
            self._reached = self._reached_places()
            self._refit(exactly=True)

    def set_room(self, room: Room) -> None:
        """Set the size of the picture, and the areas covered in it."""
        if room != self._room:
            self._room = room
            self._refit(exactly=True)

    def set_arm(
        self,
        angles_deg: Sequence[float] | None,
        gripper_mm: float,
        ghost_deg: Sequence[float] | None,
    ) -> None:
        """Set the pose of the arm and of its ghost."""
        poses = [(tuple(angles_deg or (0.0,) * 6), gripper_mm)]
        if ghost_deg is not None:
            poses.append((tuple(ghost_deg), 0.0))
        if len(poses) == len(self._poses) and all(
            poses_equal(one[0], other[0]) and one[1] == other[1]
            for one, other in zip(poses, self._poses, strict=True)
        ):
            return
        self._poses = poses
        self._refit(exactly=False)

    def set_places(self, places: tuple[Vector, ...]) -> None:
        """Set the outermost places of a path, which shall be in the picture as well."""
        if places != self._places:
            self._places = places
            self._refit(exactly=False)

    def set_boxes(self, corners: tuple[Vector, ...]) -> None:
        """Set the corners of the boxes of the work area, which :meth:`fit` shows as well."""
        if corners != self._boxes:
            self._boxes = corners
            if self._with_boxes:
                self._refit(exactly=True)

    def bring_in(self, places: Sequence[Vector]) -> None:
        """Move the camera back to show newly added places, too; they stay in view like the arm."""
        if self.mode is ViewMode.FIT and self._shape is not None and not self._is_held:
            self._been = [*self._been, places]
            self.camera = self._fitted(_GROWN)

    def set_reach(self, reach: Reach | None) -> None:
        """Set the reach that shall be in the picture as well; None for none."""
        if reach != self._reach:
            self._reach = reach
            self._reached = self._reached_places()
            self._refit(exactly=True)

    def set_placement(self, placement: Sequence[float]) -> None:
        """Set where the base stands in the room: the rows of the transform, in metres."""
        if tuple(placement) != self.camera.placement:
            self.camera = replace(self.camera, placement=tuple(placement))
            self._refit(exactly=True)

    def set_tool(self, tool_m: Vector) -> None:
        """Set the tool centre point in the flange, metres."""
        self._tool_m = tool_m
        if self.mode is ViewMode.FOLLOW:
            self._refit(exactly=False)

    # what the operator wants ------------------------------------------------------------------

    def look_from(self, direction: ViewDirection) -> None:
        """Show all of the arm from a direction."""
        self.camera = self.camera.turned_to(direction)
        if self.mode is ViewMode.FREE:
            self.mode = ViewMode.FIT
        self._refit(exactly=True)

    def fit(self, *, with_boxes: bool = True) -> None:
        """Show all of the arm from the present direction, and the boxes of the work area."""
        self.mode, self._with_boxes = ViewMode.FIT, with_boxes
        self._refit(exactly=True)

    def reset(self) -> None:
        """Go back to the first view."""
        kept = self.camera
        self.camera = replace(HOME_CAMERA, orthographic=kept.orthographic, placement=kept.placement)
        self.fit(with_boxes=False)

    def follow(self, *, wanted: bool) -> None:
        """Keep the tool in the middle, or show all of the arm again."""
        if not wanted:
            if self.mode is ViewMode.FOLLOW:
                self.fit(with_boxes=False)
            return
        self.mode = ViewMode.FOLLOW
        nearer_m = min(self.camera.distance_m, _FOLLOWED_AT_M)
        self.camera = replace(self.camera, distance_m=nearer_m)
        self._refit(exactly=False)

    def set_orthographic(self, *, wanted: bool) -> None:
        """Switch perspective off or on."""
        self.camera = replace(self.camera, orthographic=wanted)
        self._refit(exactly=True)

    def move_by_hand(self, camera: OrbitCamera) -> None:
        """Use the operator's camera from now on; a following one is turned and keeps following."""
        if camera == self.camera:
            return
        if self.mode is not ViewMode.FOLLOW or camera.focus_m != self.camera.focus_m:
            self.mode = ViewMode.FREE
        self.camera = camera

    def hold(self, *, held: bool) -> None:
        """Keep the camera still during a drag, except for the operator's own moves."""
        self._is_held = held
        if not held:
            self._refit(exactly=False)

    def come_to_rest(self) -> None:
        """Move closer to an arm that has stood still for a moment and appears small."""
        if self.mode is not ViewMode.FIT or self._is_held:
            return
        best = fitted(self.camera, self._groups(), self._room)
        if best.distance_m < _SHRUNK * self.camera.distance_m:
            self._been.clear()
            self.camera = best
            self._been = outermost(best, self._groups())

    @property
    def room(self) -> Room:
        """The picture, and what lies over it."""
        return self._room

    def arm_boxes(self) -> list[Box]:
        """Return a rectangle around each link of the arm and its ghost, as they are seen."""
        shape = self._shape
        if shape is None:
            return []
        links = (shape.outline(shape.links(*pose)) for pose in self._poses)
        return boxes(self.camera, [group for pose in links for group in pose], self._room)

    def _refit(self, *, exactly: bool) -> None:
        shape = self._shape
        if shape is None or self._is_held:
            return
        if self.mode is ViewMode.FOLLOW:
            rows = shape.flange(shape.links(*self._poses[0]))
            self.camera = replace(self.camera, focus_m=moved(rows, self._tool_m))
        elif self.mode is ViewMode.FIT and (exactly or not self._is_all_clear(shape)):
            if exactly:
                self._been.clear()
            # keep places where the arm was in view: else the camera would move to and fro with it
            self.camera = self._fitted(1.0 if exactly else _GROWN)
            self._been = outermost(self.camera, [*self._groups(), *self._been])

    def _is_all_clear(self, shape: RobotShape) -> bool:
        """Return whether everything is in the picture; asked 12 times a second in a motion."""
        projection = Projection(self.camera, self._room.width_px, self._room.height_px)
        doubtful: list[Sequence[Vector]] = []
        for pose in self._poses:
            links = shape.links(*pose)
            for rows, points, ball in zip(links, shape.points, self._balls, strict=True):
                if ball is None:
                    continue
                there = replace(ball, centre=moved(rows, ball.centre))
                if not is_ball_clear(projection, there, self._room, _SLACK_PX):
                    doubtful.append([moved(rows, point) for point in points])
        doubtful += self._standing()
        return is_clear(self.camera, doubtful, self._room, _SLACK_PX)

    def _fitted(self, grown: float) -> OrbitCamera:
        return fitted(self.camera, [*self._groups(), *self._been], self._room, grown)

    def _groups(self) -> list[Sequence[Vector]]:
        shape = self._shape
        if shape is None:
            return []
        groups: list[Sequence[Vector]] = []
        for pose in self._poses:
            groups += shape.outline(shape.links(*pose))
        return groups + self._standing()

    def _standing(self) -> list[Sequence[Vector]]:
        """Return the places that must be visible besides the arm and its ghost."""
        boxes = self._boxes if self._with_boxes else ()
        return [(place,) for place in (*self._places, *boxes, *self._reached, *_LETTERS)]

    def _reached_places(self) -> tuple[Vector, ...]:
        if self._shape is None or self._reach is None:
            return ()
        return tuple(_reached(self._shape, self._reach))


def _reached(shape: RobotShape, reach: Reach) -> Iterator[Vector]:
    """Yield places all around the shoulder, at the largest distance of the tool from it."""
    middles = [(low + high) / 2.0 for low, high in reach.limits_deg]
    tried = [
        [low + (high - low) * share / _TRIED for share in range(_TRIED + 1)]
        for low, high in reach.limits_deg
    ]
    shoulder, _ = shape.joint_frame(2, shape.links((0.0,) * len(middles)))
    furthest_m = 0.0
    for lift, bend in itertools.product(tried[1], tried[2]):
        flange = shape.flange(shape.links((0.0, lift, bend, *middles[3:])))
        furthest_m = max(furthest_m, math.dist(moved(flange, reach.tool_m), shoulder))
    for turn, height in itertools.product(tried[0], range(-90, 91, 30)):
        out_m = furthest_m * math.cos(math.radians(height))
        yield (
            shoulder[0] + out_m * math.cos(math.radians(turn)),
            shoulder[1] + out_m * math.sin(math.radians(turn)),
            shoulder[2] + furthest_m * math.sin(math.radians(height)),
        )
