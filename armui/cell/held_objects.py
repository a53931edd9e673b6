"""The objects a gripper may hold: boxes and capsules, fixed to the flange while they are held."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from armui.arm.refusal import Refusal
from armui.cell.checks import check_figure, check_names, check_pose, check_sizes
from armui.cell.tools import NO_TOOL
from armui.protocol.codes import EndLoad
from armui.setting_checks import TOOL_LONGEST_MM

PAYLOAD_KG: Final = 1.5
"""What the arm carries at most, by its maker."""
HEAVIEST_KG: Final = 5.0
_SMALLEST_MM: Final = 1.0
_LARGEST_MM: Final = 1000.0


@dataclass(frozen=True, slots=True)
class HeldObject:
    """Something that the hand may hold.

    Attributes:
        name: Its name in the cell.
        pose: The frame of its middle in the flange: X, Y, Z in mm, RX, RY, RZ in degrees.
        size_mm: Its edges along the axes of that frame. Of a rod Z is its whole length, and the
            larger of X and Y its diameter.
        is_rod: True for a rod with round ends, a capsule; False for a box.
        mass_kg: Its mass.
        may_touch: The names of the planes and boxes of the work area that it may touch.
    """

    name: str
    pose: tuple[float, ...] = NO_TOOL
    size_mm: tuple[float, ...] = (40.0, 40.0, 40.0)
    is_rod: bool = False
    mass_kg: float = 0.0
    may_touch: tuple[str, ...] = ()

    @property
    def load(self) -> EndLoad:
        """The class of payload that the arm is best told of."""
        if not self.mass_kg:
            return EndLoad.EMPTY
        return EndLoad.HALF if self.mass_kg <= PAYLOAD_KG / 2.0 else EndLoad.FULL


def check_held_object(held: HeldObject) -> Refusal | None:
    """Return why the figures of an object are not possible, or ``None``."""
    refusals = (
        check_pose(held.name, held.pose, TOOL_LONGEST_MM),
        check_sizes(held.name, held.size_mm, _SMALLEST_MM, _LARGEST_MM),
        check_figure(held.name, "mass_kg", held.mass_kg, 0.0, HEAVIEST_KG),
        check_names(held.may_touch),
    )
    return next((each for each in refusals if each is not None), None)
