"""Where the numbers of points and the signs of findings stand in the picture.

Loads numpy when there is a path to be shown: whoever makes a path has loaded it.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from armui.viewport.camera import Vector
    from armui.viewport.path_picture import FindingMark, PathPicture
    from armui.viewport.projection import Projection

_CELL_PX: Final = (34.0, 20.0)
"""One number at most stands in a cell of this size: what lies closer is not readable."""
_MOST: Final = 120
_NEAR_PX: Final = 13.0


class _Rim(NamedTuple):
    """How far from each edge of the picture a sign stands at least."""

    left: float
    top: float
    right: float
    bottom: float


_RIM_PX: Final = _Rim(18.0, 18.0, 66.0, 18.0)
"""At the right edge are buttons."""


class Tag(NamedTuple):
    """A number beside a point.

    Attributes:
        x_px, y_px: Of the point, from the top left.
        row: Its row, from 0.
    """

    x_px: float
    y_px: float
    row: int


class Sign(NamedTuple):
    """A finding where it happens.

    Attributes:
        x_px, y_px: Of its sign, from the top left.
        finding: What was found.
        beyond: Where it happens from there, a direction on the screen, when it is not in sight.
    """

    x_px: float
    y_px: float
    finding: FindingMark
    beyond: tuple[float, float] | None = None


def tags(
    path: PathPicture, projection: Projection, first: frozenset[int] = frozenset()
) -> list[Tag]:
    """The numbers that can be read.

    Args:
        path: Its points.
        projection: Of the picture.
        first: Rows whose numbers stand there whatever is near.
    """
    import numpy as np  # noqa: PLC0415 - see above

    if not path.is_numbered or not len(path.rows):
        return []
    pixels = _pixels(path.marks_mm / 1000.0, projection)
    inside = np.isfinite(pixels[:, 0])
    inside &= (pixels >= 0.0).all(axis=1)
    inside &= pixels[:, 0] < projection.width_px
    inside &= pixels[:, 1] < projection.height_px
    rows = np.asarray(path.rows)
    forced = np.isin(rows, list(first | path.bad_rows))
    order = np.lexsort((rows, ~forced))
    order = order[inside[order]]
    cells = np.floor(pixels[order] / _CELL_PX).astype(int)
    _, chosen = np.unique(cells, axis=0, return_index=True)
    kept = order[np.sort(chosen)][:_MOST]
    return [Tag(float(pixels[at, 0]), float(pixels[at, 1]), int(rows[at])) for at in kept.tolist()]


def signs(path: PathPicture, projection: Projection) -> list[Sign]:
    """The findings, errors last, so that they lie on top.

    One that happens outside of the picture stands at its rim, where one would have to look for it.
    """
    found = []
    for finding in sorted(path.findings, key=lambda each: each.is_error)[-_MOST:]:
        x, y, z = finding.place_mm
        seen_px = _seen_px(projection, (x / 1000.0, y / 1000.0, z / 1000.0))
        x_px = _within(seen_px[0], _RIM_PX.left, projection.width_px - _RIM_PX.right)
        y_px = _within(seen_px[1], _RIM_PX.top, projection.height_px - _RIM_PX.bottom)
        across, down = seen_px[0] - x_px, seen_px[1] - y_px
        away_px = math.hypot(across, down)
        beyond = (across / away_px, down / away_px) if away_px > _NEAR_PX else None
        found.append(Sign(x_px, y_px, finding, beyond))
    return found


def finding_at(
    path: PathPicture, projection: Projection, x_px: float, y_px: float
) -> FindingMark | None:
    """The finding whose sign is at a pixel; of several the one that matters most."""
    near = [
        sign
        for sign in signs(path, projection)
        if max(abs(sign.x_px - x_px), abs(sign.y_px - y_px)) <= _NEAR_PX
    ]
    return near[-1].finding if near else None


def _seen_px(projection: Projection, place_m: Vector) -> tuple[float, float]:
    """Where a place is seen; one behind the eye is far off, on the side that it is on."""
    pixel = projection.pixel(place_m)
    if pixel is not None:
        return pixel
    across, up, _ = projection.relative(place_m)
    away = math.hypot(across, up) or 1.0
    size_px = projection.width_px + projection.height_px
    return (
        projection.width_px / 2.0 + across / away * size_px,
        projection.height_px / 2.0 - up / away * size_px,
    )


def _within(value: float, low: float, high: float) -> float:
    return max(low, min(value, high))


def _pixels(places_m: NDArray[np.float64], projection: Projection) -> NDArray[np.float64]:
    """(n, 2) where places are seen; infinite behind the eye."""
    import numpy as np  # noqa: PLC0415 - see above

    camera = projection.camera
    outward, right, up = (np.array(axis) for axis in camera.axes())
    relative = places_m - np.array(camera.focus_m)
    scales = np.full(len(places_m), projection.scale_px(0.0) or 0.0)
    if not camera.orthographic:
        away = (camera.distance_m - relative @ outward) / camera.distance_m
        scales = np.where(away > 0.0, scales / np.where(away > 0.0, away, 1.0), np.inf)
    with np.errstate(invalid="ignore"):
        across = projection.width_px / 2.0 + relative @ right * scales
        down = projection.height_px / 2.0 - relative @ up * scales
    return np.column_stack((across, down))
