"""Where the picture is taken from: a turntable camera, without any drawing library."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

VIEW_ANGLE_DEG = 30.0
"""Opening angle of the shorter side of the picture."""

_DEG_PER_PIXEL = 0.4
_ZOOM_PER_STEP = 0.88
_NEAREST_M, _FARTHEST_M = 0.15, 8.0
_STEEPEST_DEG = 89.0

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class OrbitCamera:
    """Looks at a point from a direction; Z stays up, so the arm never tips over on the screen.

    Attributes:
        focus_m: the point looked at, in the base frame.
        distance_m: from there to the eye.
        azimuth_deg: of the eye about Z, 0 at +X.
        elevation_deg: of the eye above the floor.
    """

    focus_m: tuple[float, float, float]
    distance_m: float
    azimuth_deg: float = -52.0
    elevation_deg: float = 20.0

    def orbit(self, dx_px: float, dy_px: float) -> OrbitCamera:
        """The camera after a drag that turns: the scene follows the pointer."""
        elevation_deg = self.elevation_deg + dy_px * _DEG_PER_PIXEL
        return replace(
            self,
            azimuth_deg=(self.azimuth_deg - dx_px * _DEG_PER_PIXEL) % 360.0,
            elevation_deg=min(_STEEPEST_DEG, max(-_STEEPEST_DEG, elevation_deg)),
        )

    def pan(self, dx_px: float, dy_px: float, shorter_side_px: float) -> OrbitCamera:
        """The camera after a drag that moves: what is under the pointer stays under it."""
        visible_m = 2.0 * self.distance_m * math.tan(math.radians(VIEW_ANGLE_DEG / 2.0))
        metres_per_px = visible_m / max(shorter_side_px, 1.0)
        _, right, up = self._axes()
        return replace(
            self,
            focus_m=_along(
                _along(self.focus_m, right, -dx_px * metres_per_px), up, dy_px * metres_per_px
            ),
        )

    def zoom(self, steps: float) -> OrbitCamera:
        """The camera nearer (steps above zero) or farther, within sensible distances."""
        distance_m = self.distance_m * _ZOOM_PER_STEP**steps
        return replace(self, distance_m=min(_FARTHEST_M, max(_NEAREST_M, distance_m)))

    @property
    def eye_m(self) -> Vector:
        """Position of the eye in the base frame."""
        outward, _, _ = self._axes()
        return _along(self.focus_m, outward, self.distance_m)

    def _axes(self) -> tuple[Vector, Vector, Vector]:
        """Unit vectors: from the focus to the eye, to the right and up on the screen."""
        azimuth, elevation = math.radians(self.azimuth_deg), math.radians(self.elevation_deg)
        ca, sa = math.cos(azimuth), math.sin(azimuth)
        ce, se = math.cos(elevation), math.sin(elevation)
        return (ce * ca, ce * sa, se), (-sa, ca, 0.0), (-se * ca, -se * sa, ce)


def _along(start: Vector, direction: Vector, distance: float) -> Vector:
    x, y, z = (a + b * distance for a, b in zip(start, direction, strict=True))
    return (x, y, z)


HOME_CAMERA = OrbitCamera(focus_m=(0.06, 0.0, 0.25), distance_m=1.7)
"""The first view: the arm at rest in the middle, room for it to rise."""
