"""The work area: planes that the arm keeps to one side of, boxes that it keeps out of."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final, TypeVar

from armui.arm.refusal import Reason, Refusal
from armui.cell.checks import check_figure, check_names, check_pose, check_sizes
from armui.cell.parts import part_named, put, without

AREA_TOO_MANY = Reason(
    "area_too_many", "A work area has at most {planes} planes and {boxes} boxes. Delete one first."
)

MOST_PLANES: Final = 8
MOST_BOXES: Final = 100
MARGIN_MM: Final = 10.0
"""The distance that the arm keeps from planes and boxes unless another one is chosen."""
_FURTHEST_MM: Final = 5000.0
_SMALLEST_MM: Final = 1.0
_LEAST_MARGIN_MM: Final = 2.0
"""Ways are looked at in steps that are too short to hide 1 mm: with this margin nothing touches."""
_LARGEST_MARGIN_MM: Final = 200.0
_NOWHERE: Final = (0.0,) * 6


@dataclass(frozen=True, slots=True)
class AreaPlane:
    """A plane whose one side the arm may not enter.

    Attributes:
        name: Its name in the cell.
        pose: A frame on it, in the base: X, Y, Z in mm, RX, RY, RZ in degrees. Its Z axis points to
            the side on which the arm stays.
        on: False if it is switched off.
    """

    name: str
    pose: tuple[float, ...] = _NOWHERE
    on: bool = True


@dataclass(frozen=True, slots=True)
class AreaBox:
    """A box that the arm stays out of.

    Attributes:
        name: Its name in the cell.
        pose: The frame of its centre in the base: X, Y, Z in mm, RX, RY, RZ in degrees.
        size_mm: Its edges along the axes of that frame.
        on: False if it is switched off.
    """

    name: str
    pose: tuple[float, ...] = _NOWHERE
    size_mm: tuple[float, ...] = (100.0, 100.0, 100.0)
    on: bool = True


Zone = AreaPlane | AreaBox
_AnyZone = TypeVar("_AnyZone", AreaPlane, AreaBox)


@dataclass(frozen=True, slots=True)
class Area:
    """All planes and boxes of a cell.

    Attributes:
        planes: The planes, in the order of the list.
        boxes: The boxes, in the order of the list.
        margin_mm: The distance that the arm keeps from them.
        stops_others: True if a hand or another host that enters is stopped.
    """

    planes: tuple[AreaPlane, ...] = ()
    boxes: tuple[AreaBox, ...] = ()
    margin_mm: float = MARGIN_MM
    stops_others: bool = False

    @property
    def zones(self) -> tuple[Zone, ...]:
        """All planes, then all boxes."""
        return (*self.planes, *self.boxes)

    @property
    def in_force(self) -> Area:
        """The area with only those planes and boxes that are switched on."""
        return replace(self, planes=_on(self.planes), boxes=_on(self.boxes))

    @property
    def is_free(self) -> bool:
        """True if nothing is switched on: the arm may go anywhere."""
        return not any(zone.on for zone in self.zones)

    def named(self, name: str) -> Zone | None:
        """Return a plane or box by its name, or ``None``."""
        return part_named(self.zones, name)


def with_zone(area: Area, zone: Zone, *, instead_of: str = "") -> Area:
    """Return an area with a further plane or box, or with one in the place of another.

    Args:
        area: The area.
        zone: The plane or box.
        instead_of: The name of the one it replaces; "" adds it.
    """
    zones = put(area.zones, zone, instead_of)
    planes = tuple(each for each in zones if isinstance(each, AreaPlane))
    boxes = tuple(each for each in zones if isinstance(each, AreaBox))
    return replace(area, planes=planes, boxes=boxes)


def without_zone(area: Area, name: str) -> Area:
    """Return an area without the plane or box of a name."""
    return replace(area, planes=without(area.planes, name), boxes=without(area.boxes, name))


def check_area(area: Area) -> Refusal | None:
    """Return why a work area is not possible, or ``None``."""
    if len(area.planes) > MOST_PLANES or len(area.boxes) > MOST_BOXES:
        return AREA_TOO_MANY(planes=MOST_PLANES, boxes=MOST_BOXES)
    refusal = check_names(zone.name for zone in area.zones)
    if refusal is None:
        refusal = check_figure(
            "", "margin_mm", area.margin_mm, _LEAST_MARGIN_MM, _LARGEST_MARGIN_MM
        )
    return refusal or next(filter(None, map(_check_zone, area.zones)), None)


def _check_zone(zone: Zone) -> Refusal | None:
    refusal = check_pose(zone.name, zone.pose, _FURTHEST_MM)
    if refusal is None and isinstance(zone, AreaBox):
        return check_sizes(zone.name, zone.size_mm, _SMALLEST_MM, _FURTHEST_MM)
    return refusal


def _on(zones: tuple[_AnyZone, ...]) -> tuple[_AnyZone, ...]:
    return tuple(zone for zone in zones if zone.on)
