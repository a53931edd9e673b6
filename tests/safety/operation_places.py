"""Where an operation must not lead: zones, and places outside, from which only ways back lead."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from armui.cell.cell import Cell
from armui.cell.work_area import AreaBox, Zone
from tests.accepted import accepted
from tests.cell.areas import area_of, wall
from tests.safety.arm_oracle import Array, depth_beyond_mm, depth_in_box_mm, height_mm, tip_of
from tests.safety.operation_driver import Driver
from tests.safety.operations_table import BENT_DEG, Joints, Way

_LOW_DEG: Final = (-150.0, 0.0, -170.0, -100.0, -70.0, -120.0)
_HIGH_DEG: Final = (150.0, 180.0, 0.0, 100.0, 70.0, 120.0)

REST_DEG: Final[Joints] = (0.0, -1.999, 1.971, -1.412, 22.11, -2.608)
"""How a real arm lies when it is switched on."""


def keep_out(driver: Driver, *zones: Zone) -> None:
    """Put a work area in force, as the operator does."""
    accepted(driver.begin("cell.take", Cell("cell", area=area_of(*zones))))


def beyond_limits_deg(joints_deg: Sequence[float]) -> float:
    """By how much all joints together are beyond their limits."""
    return sum(
        max(0.0, low - angle, angle - high)
        for low, angle, high in zip(_LOW_DEG, joints_deg, _HIGH_DEG, strict=True)
    )


# Outside ------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Outside:
    """A place outside, a way further out, and one back.

    Attributes:
        out: The way further out, from where the arm stands.
        back: The way back in.
        excess: How far out the arm is, by its joint angles; 0 or less: it is inside.
        noise: What of it is no motion, in the same unit.
        prepare: Puts in force what the arm is outside of.
    """

    out: Way
    back: Way
    excess: Callable[[Sequence[float]], float]
    noise: float
    prepare: Callable[[Driver], object] = lambda _driver: None


_PUSHED_DEG: Final[Joints] = (152.0, *BENT_DEG[1:])
_LOW_PLACE_DEG: Final[Joints] = (10.0, 100.0, -60.0, 0.0, 40.0, 0.0)
_WALL_MM: Final = depth_beyond_mm(BENT_DEG, 0.0) - 30.0
_FLOOR_MM: Final = round(height_mm(_LOW_PLACE_DEG)) + 15

OUTSIDE: Final = {
    "limit": Outside(
        Way(_PUSHED_DEG, (157.0, *BENT_DEG[1:]), axis=1),
        Way(_PUSHED_DEG, (146.0, *BENT_DEG[1:]), axis=1),
        beyond_limits_deg,
        0.05,
    ),
    "rest": Outside(
        Way(REST_DEG, (0.0, -7.0, *REST_DEG[2:]), joint=2, axis=2),
        Way(REST_DEG, (0.0, 6.0, -6.0, *REST_DEG[3:]), joint=2, axis=2),
        beyond_limits_deg,
        0.05,
    ),
    "area": Outside(
        Way(BENT_DEG, (10.0, 80.0, *BENT_DEG[2:]), joint=2),
        Way(BENT_DEG, (10.0, 50.0, *BENT_DEG[2:]), joint=2),
        lambda joints_deg: depth_beyond_mm(joints_deg, _WALL_MM),
        1.0,
        lambda driver: keep_out(driver, wall(_WALL_MM)),
    ),
    "floor": Outside(
        Way(_LOW_PLACE_DEG, (10.0, 108.0, *_LOW_PLACE_DEG[2:]), joint=2, axis=2),
        Way(_LOW_PLACE_DEG, (10.0, 90.0, *_LOW_PLACE_DEG[2:]), joint=2, axis=2),
        lambda joints_deg: _FLOOR_MM - height_mm(joints_deg),
        1.0,
        lambda driver: driver.set_floor(_FLOOR_MM),
    ),
}

# Zones --------------------------------------------------------------------------------------------

INTO: Final = Way((30.0, *BENT_DEG[1:]), (70.0, *BENT_DEG[1:]), axis=1)
_CUBE_MM: Final = (60.0, 60.0, 60.0)


@dataclass(frozen=True, slots=True)
class Box:
    """A box that the arm stays out of, along the base's axes."""

    centre_mm: Array
    size_mm: tuple[float, float, float]

    @property
    def zone(self) -> AreaBox:
        """As a cell has it."""
        x, y, z = map(float, self.centre_mm)
        return AreaBox("crate", (x, y, z, 0.0, 0.0, 0.0), self.size_mm)

    def depth_mm(self, joints_deg: Sequence[float]) -> float:
        """How deep an arm is in it; below 0 it is clear."""
        return depth_in_box_mm(joints_deg, tuple(self.centre_mm), self.size_mm)


def box_at(tip_mm: Array) -> Box:
    """A box around where an operation leads the fingertips."""
    return Box(tip_mm, _CUBE_MM)


NEAR_WALL_MM: Final = depth_beyond_mm(BENT_DEG, 0.0) + 32.0
"""Small steps outwards from `BENT_DEG` come to it, the margin before."""


def small_step(joints_deg: Sequence[float]) -> Way:
    """Outwards by less than a millimetre."""
    end = list(joints_deg)
    end[1] += 0.15
    return Way(tuple(joints_deg), tuple(end), joint=2, arc_mm=0.4)


# A second motion: from the first place straight to the last leads through the crate, by way of the
# one between it does not.
FIRST_DEG: Final[Joints] = (0.0, 70.0, -60.0, 0.0, 40.0, 0.0)
BETWEEN_DEG: Final[Joints] = (70.0, 20.0, -110.0, 0.0, 40.0, 0.0)
LAST_DEG: Final[Joints] = (70.0, 70.0, -60.0, 0.0, 40.0, 0.0)
CRATE: Final = Box(tip_of((35.0, 70.0, -60.0, 0.0, 40.0, 0.0)), (40.0, 40.0, 120.0))

# A full cell --------------------------------------------------------------------------------------

TWENTY: Final = tuple(
    AreaBox(
        f"box {number}",
        (
            float(650.0 * np.cos(number * np.pi / 10)),
            float(650.0 * np.sin(number * np.pi / 10)),
            60.0 + 20.0 * (number % 5),
            0.0,
            0.0,
            17.0 * number - 170.0,
        ),
        (80.0, 60.0, 120.0),
    )
    for number in range(20)
)
"""Twenty boxes around the arm, out of its way."""
