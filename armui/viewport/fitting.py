"""Fits the camera so that the arm just fills the room it has. Pure."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Final

from armui.viewport.camera import OrbitCamera
from armui.viewport.projection import Projection
from armui.viewport.vectors import Vector, dot

Groups = Sequence[Sequence[Vector]]
"""Points that belong together, in metres: those of one link."""

MARGIN_PX: Final = 16.0
_AIR_PX: Final = 10.0
_NEAREST_M: Final = 0.2
_NARROWEST_PX: Final = 60.0


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle in pixels from the top left corner."""

    left: float
    top: float
    right: float
    bottom: float

    def overlaps(self, other: Box) -> bool:
        """Return whether two boxes overlap."""
        beside = self.right <= other.left or other.right <= self.left
        return not (beside or self.bottom <= other.top or other.bottom <= self.top)


@dataclass(frozen=True, slots=True)
class Room:
    """The part of a picture that is free for the arm.

    Attributes:
        width_px, height_px: The size of the whole picture.
        figures: The box covered by the figures at the top left.
        strip_px: The width of the buttons along the right edge.
    """

    width_px: float
    height_px: float
    figures: Box = Box(0.0, 0.0, 0.0, 0.0)
    strip_px: float = 0.0

    def with_air(self) -> Room:
        """Return the room with a margin around the figures for small moves."""
        figures = self.figures
        if figures.right > 0.0:
            figures = Box(0.0, 0.0, figures.right + _AIR_PX, figures.bottom + _AIR_PX)
        return replace(self, figures=figures)

    @property
    def inside(self) -> Box:
        """The picture without its margins."""
        return Box(
            MARGIN_PX,
            MARGIN_PX,
            self.width_px - self.strip_px - MARGIN_PX,
            self.height_px - MARGIN_PX,
        )


def is_clear(camera: OrbitCamera, groups: Groups, room: Room, slack_px: float = 0.0) -> bool:
    """Return whether all points are in the picture, and none behind figures.

    Args:
        camera: The camera.
        groups: The points to be seen.
        room: The room in the picture.
        slack_px: The pixels by which they may reach into the margin.
    """
    projection = Projection(camera, room.width_px, room.height_px)
    return all(_is_free(_box(projection, group), room, slack_px) for group in groups)


@dataclass(frozen=True, slots=True)
class Ball:
    """A ball around points that belong together; one test of it replaces a test of each of them."""

    centre: Vector
    radius_m: float


def ball_around(places: Sequence[Vector]) -> Ball:
    """Return a ball that contains all points."""
    sides = [(min(axis) + max(axis)) / 2.0 for axis in zip(*places, strict=True)]
    centre = (sides[0], sides[1], sides[2])
    return Ball(centre, max(math.dist(centre, place) for place in places))


def is_ball_clear(projection: Projection, ball: Ball, room: Room, slack_px: float) -> bool:
    """Return whether a ball is in the picture, not behind figures; if unsure, false."""
    across, up, towards = projection.relative(ball.centre)
    scale_px = projection.scale_px(towards)
    nearest_px = projection.scale_px(towards + ball.radius_m)
    if scale_px is None or nearest_px is None:
        return False
    x, y = room.width_px / 2.0 + across * scale_px, room.height_px / 2.0 - up * scale_px
    # in perspective the nearest part sets the size, and off the middle of the picture a ball looks
    # elongated
    aside_px = max(abs(across), abs(up)) * (nearest_px - scale_px)
    half_px = ball.radius_m * nearest_px + aside_px
    return _is_free(Box(x - half_px, y - half_px, x + half_px, y + half_px), room, slack_px)


def _is_free(box: Box | None, room: Room, slack_px: float) -> bool:
    if box is None:
        return False
    inside = room.inside
    return not (
        box.left < inside.left - slack_px
        or box.top < inside.top - slack_px
        or box.right > inside.right + slack_px
        or box.bottom > inside.bottom + slack_px
        or box.overlaps(room.figures)
    )


def fitted(camera: OrbitCamera, groups: Groups, room: Room, grown: float = 1.0) -> OrbitCamera:
    """Return the camera as near as possible, in its present direction.

    Args:
        camera: The camera with the direction.
        groups: The points to be seen.
        room: The room in the picture.
        grown: The factor on the room that is needed.

    Returns:
        The camera; the same one if there are no points.
    """
    if not any(groups):
        return camera
    # the camera turns about its focus: in the arm's middle, so that the operator turns it about the
    # arm
    camera = replace(camera, focus_m=_middle(groups))
    seen = _deciding(_seen(camera, groups, room), camera, room)
    roomy = room.with_air()
    cameras = [_within(camera, seen, box, room) for box in _free_boxes(roomy)]
    cameras.sort(key=lambda each: each.distance_m)
    best = next((each for each in cameras if is_clear(each, groups, roomy, 1.0)), cameras[-1])
    return replace(best, distance_m=best.distance_m * grown)


def outermost(camera: OrbitCamera, groups: Groups) -> list[Sequence[Vector]]:
    """Return those of many points that decide the place of the camera, each as a group."""
    _, right, up = camera.axes()
    places = [place for group in groups for place in group]
    seen = [(dot(place, right), dot(place, up), place) for place in places]
    ways = [
        (across, upwards)
        for across, upwards in itertools.product((-1.0, 0.0, 1.0), repeat=2)
        if across or upwards
    ]
    chosen = {
        max(seen, key=lambda each: across * each[0] + upwards * each[1])[2]
        for across, upwards in ways
        if places
    }
    return [(place,) for place in sorted(chosen)]


def _free_boxes(room: Room) -> Iterable[Box]:
    """Yield the rectangles that the arm may be fitted into, the whole picture last."""
    inside = room.inside
    shares = (0.0, 0.5, 1.0)
    lefts = [max(inside.left, room.figures.right * share) for share in shares]
    tops = [max(inside.top, room.figures.bottom * share) for share in shares]
    for left, top in itertools.product(lefts, tops):
        if inside.right - left >= _NARROWEST_PX and inside.bottom - top >= _NARROWEST_PX:
            yield Box(left, top, inside.right, inside.bottom)
    yield Box(inside.left, inside.top, max(inside.right, inside.left + 1.0), inside.bottom + 1.0)


def _middle(groups: Groups) -> Vector:
    """Return the middle of the box around everything."""
    axes = zip(*(place for group in groups for place in group), strict=True)
    x, y, z = ((min(axis) + max(axis)) / 2.0 for axis in axes)
    return x, y, z


def _seen(camera: OrbitCamera, groups: Groups, room: Room) -> list[Vector]:
    """Return how far each place is to the right of the focus, above it, and nearer to the eye."""
    projection = Projection(camera, room.width_px, room.height_px)
    seen = [projection.relative(place) for group in groups for place in group]
    return [(across, up, 0.0) for across, up, _ in seen] if camera.orthographic else seen


def _deciding(seen: Sequence[Vector], camera: OrbitCamera, room: Room) -> list[Vector]:
    """Return those of many places that can be the outermost in some rectangle of the picture.

    At an edge the place with the greatest sum of its distance aside and a share of its nearness is
    the outermost. The share lies between those of the picture's own edges, and the sum is linear in
    it: a place exceeded by the same one at both ends of the range never is.
    """
    unit = Projection(replace(camera, distance_m=1.0), room.width_px, room.height_px)
    most = max(room.width_px, room.height_px) / unit.pixels_a_metre(camera.focus_m)
    chosen = {max(seen, key=lambda each: each[2])}
    for axis, way in itertools.product((0, 1), (-1.0, 1.0)):
        best = -math.inf
        ends = ((way * each[axis] - most * each[2], each) for each in seen)
        for end, each in sorted(ends, reverse=True):
            other_end = end + 2.0 * most * each[2]
            if other_end > best:
                best = other_end
                chosen.add(each)
    return list(chosen)


def _within(camera: OrbitCamera, seen: Sequence[Vector], box: Box, room: Room) -> OrbitCamera:
    """Return the nearest camera that shows everything in a rectangle.

    Each edge of the rectangle is a plane through the eye. That all places lie inside of it is a
    condition linear in the place and the distance of the camera.
    """
    unit = Projection(replace(camera, distance_m=1.0), room.width_px, room.height_px)
    size_px = unit.pixels_a_metre(camera.focus_m)
    middle_x, middle_y = room.width_px / 2.0, room.height_px / 2.0
    left, right = (box.left - middle_x) / size_px, (box.right - middle_x) / size_px
    low, high = (middle_y - box.bottom) / size_px, (middle_y - box.top) / size_px
    rightmost = max(across + right * towards for across, _, towards in seen)
    leftmost = min(across + left * towards for across, _, towards in seen)
    highest = max(up + high * towards for _, up, towards in seen)
    lowest = min(up + low * towards for _, up, towards in seen)
    wide = max(right - left, 1e-6)
    tall = max(high - low, 1e-6)
    nearest = max(towards for _, _, towards in seen) + _NEAREST_M
    distance = max((rightmost - leftmost) / wide, (highest - lowest) / tall, _NEAREST_M)
    if not camera.orthographic:
        distance = max(distance, nearest)
    across = ((rightmost - right * distance) + (leftmost - left * distance)) / 2.0
    up = ((highest - high * distance) + (lowest - low * distance)) / 2.0
    _, right_axis, up_axis = camera.axes()
    x, y, z = (
        focus + across * r + up * u
        for focus, r, u in zip(camera.focus_m, right_axis, up_axis, strict=True)
    )
    return replace(camera, focus_m=(x, y, z), distance_m=distance)


def boxes(camera: OrbitCamera, groups: Groups, room: Room) -> list[Box]:
    """Return the rectangle around each group in the picture; what is behind the eye is left out."""
    projection = Projection(camera, room.width_px, room.height_px)
    found = [_box(projection, group) for group in groups if group]
    return [box for box in found if box is not None]


def _box(projection: Projection, group: Sequence[Vector]) -> Box | None:
    """Return the rectangle around a group; ``None`` if some of it is behind the eye."""
    left = top = math.inf
    right = bottom = -math.inf
    for place in group:
        pixel = projection.pixel(place)
        if pixel is None:
            return None
        x, y = pixel
        left, right = min(left, x), max(right, x)
        top, bottom = min(top, y), max(bottom, y)
    return Box(left, top, right, bottom)
