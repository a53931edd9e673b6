"""Tools on the flange: the tool centre point of each, and the capsule that stands for it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from armui.arm.refusal import Refusal
from armui.cell.checks import check_figure, check_pose
from armui.setting_checks import TOOL_LONGEST_MM

_THICKEST_MM: Final = 200.0
NO_TOOL: Final = (0.0,) * 6


@dataclass(frozen=True, slots=True)
class Tool:
    """A tool that the flange may carry.

    Attributes:
        name: Its name in the cell.
        pose: The tool centre point in the flange: X, Y, Z in mm, RX, RY, RZ in degrees.
        radius_mm: The radius of the capsule from the flange's centre to the tip that stands for
            the tool in checks; 0 if only the tip counts.
    """

    name: str
    pose: tuple[float, ...] = NO_TOOL
    radius_mm: float = 0.0

    @property
    def length_mm(self) -> float:
        """The distance from the flange's centre to the tip: the length of the capsule's axis."""
        return math.hypot(*self.pose[:3])


def check_tool(tool: Tool) -> Refusal | None:
    """Return why the figures of a tool are not possible, or ``None``."""
    refusal = check_pose(tool.name, tool.pose, TOOL_LONGEST_MM)
    return refusal or check_figure(tool.name, "radius_mm", tool.radius_mm, 0.0, _THICKEST_MM)
