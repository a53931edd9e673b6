"""Projects places of the arm to pixels, and pixels back to lines in space. Pure."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from armui.viewport.camera import VIEW_ANGLE_DEG, OrbitCamera
from armui.viewport.vectors import Vector, minus, plus, unit

_PER_DISTANCE: Final = 0.5 / math.tan(math.radians(VIEW_ANGLE_DEG / 2.0))
"""The apparent size of a metre a metre away, in shorter sides of the picture."""
_NEAREST_SHARE: Final = 0.05
"""As in the picture, places nearer to the eye than this share of the distance are not seen."""


@dataclass(frozen=True, slots=True)
class Ray:
    """A line of sight: `start_m` in the base frame and a unit vector away from the eye."""

    start_m: Vector
    direction: Vector

    def at(self, distance_m: float) -> Vector:
        """Return the place at a distance along it."""
        return plus(self.start_m, self.direction, distance_m)


class Projection:
    """The projection of places to pixels, counted from the top left corner.

    Args:
        camera: The camera.
        width_px: The width of the picture, in the pixels of the results.
        height_px: Likewise.
    """

    def __init__(self, camera: OrbitCamera, width_px: float, height_px: float) -> None:
        self.camera = camera
        self.width_px, self.height_px = width_px, height_px
        self._outward, self._right, self._up = camera.axes()
        self._size_px = _PER_DISTANCE * max(1.0, min(width_px, height_px))

    @property
    def key(self) -> tuple[OrbitCamera, float, float]:
        """A key that is equal for two projections with equal results."""
        return self.camera, self.width_px, self.height_px

    def pixel(self, place_m: Vector) -> tuple[float, float] | None:
        """Return the pixel of a place, even outside the picture; ``None`` behind the eye."""
        across, up, towards = self.relative(place_m)
        scale_px = self.scale_px(towards)
        if scale_px is None:
            return None
        return self.width_px / 2.0 + across * scale_px, self.height_px / 2.0 - up * scale_px

    def pixels_a_metre(self, place_m: Vector) -> float:
        """Return the pixels for a metre across the line of sight at a place; 0 behind the eye."""
        return self.scale_px(self.relative(place_m)[2]) or 0.0

    def ray(self, x_px: float, y_px: float) -> Ray:
        """Return the line of sight through a pixel."""
        across = (x_px - self.width_px / 2.0) / self._size_px
        up = (self.height_px / 2.0 - y_px) / self._size_px
        camera = self.camera
        if camera.orthographic:
            start = plus(camera.eye_m, self._right, across * camera.distance_m)
            start = plus(start, self._up, up * camera.distance_m)
            return Ray(start, minus((0.0, 0.0, 0.0), self._outward))
        aside = plus(plus((0.0, 0.0, 0.0), self._right, across), self._up, up)
        return Ray(camera.eye_m, unit(minus(aside, self._outward)))

    def relative(self, place_m: Vector) -> Vector:
        """Return a place relative to the focus: to the right, upwards, and towards the eye."""
        focus = self.camera.focus_m
        x, y, z = place_m[0] - focus[0], place_m[1] - focus[1], place_m[2] - focus[2]
        return (
            x * self._right[0] + y * self._right[1] + z * self._right[2],
            x * self._up[0] + y * self._up[1] + z * self._up[2],
            x * self._outward[0] + y * self._outward[1] + z * self._outward[2],
        )

    def scale_px(self, towards_m: float) -> float | None:
        """Return the pixels for a metre, this much nearer to the eye than the focus, or None."""
        distance_m = self.camera.distance_m
        if self.camera.orthographic:
            return self._size_px / distance_m
        away_m = distance_m - towards_m
        return self._size_px / away_m if away_m > _NEAREST_SHARE * distance_m else None
