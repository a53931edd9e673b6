"""The turntable camera of the 3D picture, without any drawing library. Pure."""

from __future__ import annotations

import enum
import math
from dataclasses import dataclass, replace
from typing import Final

from armui.viewport.vectors import Vector, dot, plus

VIEW_ANGLE_DEG: Final = 30.0
"""The opening angle for the shorter side of the picture."""

_DEG_PER_PIXEL = 0.4
_ZOOM_PER_STEP = 0.88
_NEAREST_M, _FARTHEST_M = 0.15, 8.0
_STEEPEST_DEG = 89.0


ON_THE_FLOOR: Final[tuple[float, ...]] = (
    *(1.0, 0.0, 0.0, 0.0),
    *(0.0, 1.0, 0.0, 0.0),
    *(0.0, 0.0, 1.0, 0.0),
)
"""The placement of a base that is upright on the floor."""
_SAME_ANGLE_DEG: Final = 0.005
"""A smaller difference moves nothing by a pixel: an arm at rest whose last digit changes is not
drawn again.
"""


class ViewDirection(enum.Enum):
    """A direction from which to look at the arm; the values are kept in the settings."""

    FRONT = "front"
    SIDE = "side"
    TOP = "top"
    ISO = "iso"
    BELOW = "below"


@dataclass(frozen=True, slots=True)
class OrbitCamera:
    """Looks at a point from a direction; the Z axis of the room stays up.

    Dragging does not move the eye below the floor: only `turned_to` does; from there dragging turns
    it below the floor, too, until it is above again.

    Attributes:
        focus_m: the point looked at, in the base frame.
        distance_m: the distance from there to the eye; without perspective, objects at the focus
            keep the size they have with it.
        azimuth_deg: the eye's azimuth about Z, 0 at +X.
        elevation_deg: the eye's elevation above the floor.
        orthographic: true for a picture without perspective.
        placement: where the base stands in the room: the upper three rows of the transform, row by
            row, in metres. Up, the floor and the angles are those of the room.
    """

    focus_m: tuple[float, float, float]
    distance_m: float
    azimuth_deg: float = -52.0
    elevation_deg: float = 20.0
    orthographic: bool = False
    placement: tuple[float, ...] = ON_THE_FLOOR

    def orbit(self, dx_px: float, dy_px: float) -> OrbitCamera:
        """Return the camera after a turning drag: the scene follows the pointer."""
        lowest_deg = 0.0 if self.elevation_deg >= 0.0 else -_STEEPEST_DEG
        elevation_deg = self.elevation_deg + dy_px * _DEG_PER_PIXEL
        turned = replace(
            self,
            azimuth_deg=(self.azimuth_deg - dx_px * _DEG_PER_PIXEL) % 360.0,
            elevation_deg=min(_STEEPEST_DEG, max(lowest_deg, elevation_deg)),
        )
        return self._kept_above_floor(turned)

    def pan(self, dx_px: float, dy_px: float, shorter_side_px: float) -> OrbitCamera:
        """Return the camera after a moving drag: the point under the pointer stays under it."""
        visible_m = 2.0 * self.distance_m * math.tan(math.radians(VIEW_ANGLE_DEG / 2.0))
        metres_per_px = visible_m / max(shorter_side_px, 1.0)
        _, right, up = self.axes()
        focus_m = plus(self.focus_m, right, -dx_px * metres_per_px)
        focus_m = plus(focus_m, up, dy_px * metres_per_px)
        return self._kept_above_floor(replace(self, focus_m=focus_m))

    def zoom(self, steps: float) -> OrbitCamera:
        """Return the camera nearer (steps above zero) or farther, within sensible distances."""
        distance_m = self.distance_m * _ZOOM_PER_STEP**steps
        distance_m = min(_FARTHEST_M, max(_NEAREST_M, distance_m))
        return self._kept_above_floor(replace(self, distance_m=distance_m))

    def _kept_above_floor(self, moved: OrbitCamera) -> OrbitCamera:
        """Return a camera moved by hand, raised where it would sink below the floor."""
        below_m = -moved.height_m
        if below_m <= 0.0 or self.height_m < 0.0:
            return moved
        return replace(moved, focus_m=plus(moved.focus_m, self._in_base((0.0, 0.0, 1.0)), below_m))

    def turned_to(self, direction: ViewDirection) -> OrbitCamera:
        """Return the camera with its eye in another direction from the same point."""
        azimuth_deg, elevation_deg = _DIRECTIONS_DEG[direction]
        return replace(self, azimuth_deg=azimuth_deg, elevation_deg=elevation_deg)

    @property
    def eye_m(self) -> Vector:
        """The position of the eye in the base frame."""
        outward, _, _ = self.axes()
        return plus(self.focus_m, outward, self.distance_m)

    @property
    def height_m(self) -> float:
        """The height of the eye above the floor."""
        return dot(self._in_base((0.0, 0.0, 1.0)), self.eye_m) + self.placement[11]

    def _in_base(self, direction: Vector) -> Vector:
        """Return a direction of the room as one of the base."""
        x, y, z = direction
        a, b, c, _, d, e, f, _, g, h, i, _ = self.placement
        return (a * x + d * y + g * z, b * x + e * y + h * z, c * x + f * y + i * z)

    def axes(self) -> tuple[Vector, Vector, Vector]:
        """Return unit vectors: from the focus to the eye, to the right and up on the screen."""
        azimuth, elevation = math.radians(self.azimuth_deg), math.radians(self.elevation_deg)
        ca, sa = math.cos(azimuth), math.sin(azimuth)
        ce, se = math.cos(elevation), math.sin(elevation)
        outward, right, up = (ce * ca, ce * sa, se), (-sa, ca, 0.0), (-se * ca, -se * sa, ce)
        if self.placement == ON_THE_FLOOR:
            return outward, right, up
        return self._in_base(outward), self._in_base(right), self._in_base(up)


HOME_CAMERA: Final = OrbitCamera(focus_m=(0.06, 0.0, 0.25), distance_m=1.7)
"""The camera until the robot is known, for one of the arm's size."""

_DIRECTIONS_DEG: Final = {
    ViewDirection.FRONT: (0.0, 0.0),
    ViewDirection.SIDE: (-90.0, 0.0),
    ViewDirection.TOP: (-90.0, 90.0),
    ViewDirection.BELOW: (-90.0, -90.0),
    ViewDirection.ISO: (HOME_CAMERA.azimuth_deg, HOME_CAMERA.elevation_deg),
}
"""Azimuth and elevation of each direction: from +X towards the arm, from its right, from above and
from below with X to the right.
"""


def poses_equal(one: tuple[float, ...] | None, other: tuple[float, ...] | None) -> bool:
    """Return whether two poses, six angles in degrees each, look the same on a screen."""
    if one is None or other is None:
        return False
    return all(abs(a - b) < _SAME_ANGLE_DEG for a, b in zip(one, other, strict=True))
