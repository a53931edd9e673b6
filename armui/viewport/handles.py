"""The handles of a view: which exist, which one is held, and the effect of the pointer on it."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import TYPE_CHECKING

from armui.viewport.grips import Grip, GripDrag, grip_at, joint_grips, tool_grips
from armui.viewport.robot_shape import Rows, composed
from armui.viewport.strokes import Stroke

if TYPE_CHECKING:
    from armui.viewport.palette import ScenePalette
    from armui.viewport.projection import Projection
    from armui.viewport.robot_shape import RobotShape

_PLAIN_PX, _HELD_PX = 3.0, 5.5


class HandleKind(enum.Enum):
    """The kinds of handles."""

    TOOL = "tool"
    """Handles of the tool, along and about the axes of the base, or of another frame."""
    TOOL_FRAME = "tool_frame"
    """Handles of the tool, along and about its own axes."""
    JOINTS = "joints"
    """Handles of each joint."""


@dataclass(frozen=True, slots=True)
class HandlePlace:
    """The pose and kind of the handles.

    Attributes:
        angles_deg: The joint angles of the arm or ghost that is to be dragged.
        kind: The kind of handles.
        frame: Where they are instead, in the base: of a plane or box of the work area.
        axes: The frame whose axes those of a tool have; ``None`` for the base's.
    """

    angles_deg: tuple[float, ...]
    kind: HandleKind
    frame: Rows | None = None
    axes: Rows | None = None


@dataclass(frozen=True, slots=True)
class Dragged:
    """A handle being dragged.

    Attributes:
        grip: The handle.
        amount: The distance or angle since the press: mm along an axis, degrees about one.
    """

    grip: Grip
    amount: float


class Handles:
    """The handles of one view."""

    def __init__(self) -> None:
        self._place: HandlePlace | None = None
        self._drag: GripDrag | None = None
        self._hovered: tuple[object, int] | None = None

    @property
    def place(self) -> HandlePlace | None:
        """Their pose and kind; None while there are none."""
        return self._place

    @property
    def is_held(self) -> bool:
        """True if one of them is held."""
        return self._drag is not None

    def set_place(self, place: HandlePlace | None) -> bool:
        """Set or remove the handles, and return whether that is a change."""
        is_new = place != self._place
        self._place = place
        if place is None:
            self._drag = self._hovered = None
        return is_new

    def grips(
        self, shape: RobotShape, tool: Rows, projection: Projection, palette: ScenePalette
    ) -> list[Grip]:
        """Return all handles that can be grabbed now."""
        place = self._place
        if place is None:
            return []
        if place.kind is HandleKind.JOINTS:
            return joint_grips(shape, place.angles_deg, projection, palette)
        at = place.frame or composed(shape.flange(shape.links(place.angles_deg)), tool)
        frame = at if place.kind is HandleKind.TOOL_FRAME else place.axes
        return tool_grips(at, frame, projection, palette)

    @property
    def key(self) -> object:
        """A key of everything that the lines depend on, beside picture, robot and tool."""
        return self._place, self._outstanding

    @property
    def _outstanding(self) -> tuple[object, int] | None:
        return self._hovered if self._drag is None else _name(self._drag.grip)

    def strokes(self, grips: list[Grip]) -> list[Stroke]:
        """Return the lines to draw; the held or hovered handle stands out."""
        held = self._outstanding
        return [
            Stroke(grip.places, grip.color, _HELD_PX if _name(grip) == held else _PLAIN_PX)
            for grip in grips
        ]

    def hover(
        self, grips: list[Grip], projection: Projection, x_px: float, y_px: float
    ) -> tuple[bool, bool]:
        """Return whether the pointer is over a handle, and whether that has changed."""
        grip = grip_at(grips, projection, x_px, y_px)
        before, self._hovered = self._hovered, None if grip is None else _name(grip)
        return grip is not None, self._hovered != before

    def take(
        self, grips: list[Grip], projection: Projection, x_px: float, y_px: float
    ) -> Grip | None:
        """Grab the handle under the pointer, if there is one, and return it."""
        grip = grip_at(grips, projection, x_px, y_px)
        self._drag = None if grip is None else GripDrag(grip, projection, x_px, y_px)
        return grip

    def carry(self, x_px: float, y_px: float) -> Dragged | None:
        """Return the drag after a move of the pointer, or ``None``."""
        if self._drag is None:
            return None
        amount = self._drag.amount(x_px, y_px)
        return None if amount is None else Dragged(self._drag.grip, amount)

    def release(self) -> bool:
        """Release the held handle, and return whether there was one."""
        was_held, self._drag = self._drag is not None, None
        return was_held


def _name(grip: Grip) -> tuple[object, int]:
    return grip.kind, grip.number
