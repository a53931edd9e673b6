"""From a place of the arm to a pixel, and from a pixel back to a line in space. Pure."""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from armui.viewport.camera import VIEW_ANGLE_DEG, OrbitCamera, Vector

_PER_DISTANCE: Final = 0.5 / math.tan(math.radians(VIEW_ANGLE_DEG / 2.0))
"""How large a metre looks a metre away, in shorter sides of the picture."""
_NEAREST_SHARE: Final = 0.05
"""As in the picture: what is nearer to the eye than this share of the distance is not seen."""


class Ray(NamedTuple):
    """A line of sight: `start_m` in the base frame and a unit vector away from the eye."""

    start_m: Vector
    direction: Vector

    def at(self, distance_m: float) -> Vector:
        """The place so far along it."""
        x, y, z = (a + b * distance_m for a, b in zip(*self, strict=True))
        return (x, y, z)


class Projection:
    """Where a picture shows places. Pixels are counted from its top left corner.

    Args:
        camera: Takes the picture.
        width_px: Of the picture, in the pixels that are asked for.
        height_px: Likewise.
    """

    def __init__(self, camera: OrbitCamera, width_px: float, height_px: float) -> None:
        self.camera = camera
        self.width_px, self.height_px = width_px, height_px
        self._outward, self._right, self._up = camera.axes()
        self._size_px = _PER_DISTANCE * max(1.0, min(width_px, height_px))

    @property
    def key(self) -> tuple[OrbitCamera, float, float]:
        """Equal for two projections that show everything at the same places."""
        return self.camera, self.width_px, self.height_px

    def pixel(self, place_m: Vector) -> tuple[float, float] | None:
        """Where a place is seen, inside the picture or not; ``None`` behind the eye."""
        across, up, towards = self.relative(place_m)
        scale_px = self.scale_px(towards)
        if scale_px is None:
            return None
        return self.width_px / 2.0 + across * scale_px, self.height_px / 2.0 - up * scale_px

    def pixels_a_metre(self, place_m: Vector) -> float:
        """How many pixels a metre across the line of sight is there; 0 behind the eye."""
        return self.scale_px(self.relative(place_m)[2]) or 0.0

    def ray(self, x_px: float, y_px: float) -> Ray:
        """The line of everything that is seen at a pixel."""
        across = (x_px - self.width_px / 2.0) / self._size_px
        up = (self.height_px / 2.0 - y_px) / self._size_px
        camera = self.camera
        if camera.orthographic:
            start = _sum(
                camera.eye_m,
                _scaled(self._right, across * camera.distance_m),
                _scaled(self._up, up * camera.distance_m),
            )
            return Ray(start, _scaled(self._outward, -1.0))
        ahead = _sum(
            _scaled(self._outward, -1.0), _scaled(self._right, across), _scaled(self._up, up)
        )
        return Ray(camera.eye_m, _scaled(ahead, 1.0 / math.sqrt(dot(ahead, ahead))))

    def relative(self, place_m: Vector) -> Vector:
        """How far a place is to the right of the focus, above it, and nearer to the eye."""
        focus = self.camera.focus_m
        x, y, z = place_m[0] - focus[0], place_m[1] - focus[1], place_m[2] - focus[2]
        return (
            x * self._right[0] + y * self._right[1] + z * self._right[2],
            x * self._up[0] + y * self._up[1] + z * self._up[2],
            x * self._outward[0] + y * self._outward[1] + z * self._outward[2],
        )

    def scale_px(self, towards_m: float) -> float | None:
        """How many pixels a metre is, so much nearer to the eye than the focus."""
        distance_m = self.camera.distance_m
        if self.camera.orthographic:
            return self._size_px / distance_m
        away_m = distance_m - towards_m
        return self._size_px / away_m if away_m > _NEAREST_SHARE * distance_m else None


def dot(one: Vector, other: Vector) -> float:
    """The scalar product."""
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2]


def _scaled(vector: Vector, factor: float) -> Vector:
    return (vector[0] * factor, vector[1] * factor, vector[2] * factor)


def _sum(*vectors: Vector) -> Vector:
    x, y, z = (sum(parts) for parts in zip(*vectors, strict=True))
    return (x, y, z)
