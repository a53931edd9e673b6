"""A cell: the parts fixed to the arm and the objects around it, by name."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Final

from armui.arm.refusal import Reason, Refusal
from armui.cell.checks import check_name, check_names
from armui.cell.gripper_table import GripperTable, Pairs, check_gripper_table
from armui.cell.held_objects import HeldObject, check_held_object
from armui.cell.parts import part_named, put, without
from armui.cell.placement import WORLD, Placement, check_placement
from armui.cell.tools import Tool, check_tool
from armui.cell.user_frames import UserFrame, check_user_frame
from armui.cell.work_area import Area, check_area

CELL_CHOICE_BAD = Reason(
    "cell_choice_bad", "The cell has nothing named “{value}”. Choose one of those in its list."
)

Part = Tool | UserFrame | HeldObject
_LISTS: Final[dict[type[Any], tuple[str, str]]] = {
    Tool: ("tools", "tool"),
    UserFrame: ("frames", "frame"),
    HeldObject: ("held_objects", "held"),
}
"""The list of each kind of part, and the name of the one of it that is in force."""


@dataclass(frozen=True, slots=True)
class Cell:
    """The data of a cell.

    Attributes:
        name: Its name, which is also that of its file.
        tools: Its tools, in the order of the list.
        tool: The name of the chosen tool; "" for the bare flange.
        gripper_table: The gripper's openings, asked for and measured with callipers, mm.
        gripper_calibrated: True if that table is applied.
        area: Where the arm may go.
        held_objects: What the hand may hold, in the order of the list.
        held: The name of what it holds now; "" for nothing.
        frames: Its user frames, in the order of the list.
        frame: The name of the one that poses are shown and typed in; "" for the base.
        placement: Where the base stands in the room.
    """

    name: str
    tools: tuple[Tool, ...] = ()
    tool: str = ""
    gripper_table: Pairs = ()
    gripper_calibrated: bool = False
    area: Area = field(default_factory=Area)
    held_objects: tuple[HeldObject, ...] = ()
    held: str = ""
    frames: tuple[UserFrame, ...] = ()
    frame: str = ""
    placement: Placement = field(default_factory=Placement)

    @property
    def is_empty(self) -> bool:
        """True if nothing was added yet: the arm moves as without a cell."""
        return self == Cell(self.name)

    @property
    def chosen_tool(self) -> Tool | None:
        """The chosen tool, or ``None`` for the bare flange."""
        return part_named(self.tools, self.tool)

    @property
    def chosen_frame(self) -> UserFrame | None:
        """The chosen user frame, or ``None`` for the base."""
        return part_named(self.all_frames, self.frame)

    @property
    def all_frames(self) -> tuple[UserFrame, ...]:
        """The user frames, and behind them that of the room if the base is placed in it."""
        world = self.placement.world
        return self.frames if world is None else (*self.frames, world)

    @property
    def held_object(self) -> HeldObject | None:
        """The object that the gripper holds now, or ``None``."""
        return part_named(self.held_objects, self.held)

    @property
    def gripper(self) -> GripperTable | None:
        """The gripper's table while it is applied, or ``None``."""
        return GripperTable(self.gripper_table) if self.gripper_calibrated else None


def with_part(cell: Cell, part: Part, *, instead_of: str = "") -> Cell:
    """Return a cell with a further part, or with one in the place of another of its kind.

    Args:
        cell: The cell.
        part: The part. It is in force if the one it replaces was; a new tool or frame is, too.
        instead_of: The name of the one that it replaces; "" adds it.
    """
    parts, chosen = _LISTS[type(part)]
    now = getattr(cell, chosen)
    in_force = now == instead_of if instead_of else not isinstance(part, HeldObject)
    now = part.name if in_force else now
    changed: dict[str, Any] = {parts: put(getattr(cell, parts), part, instead_of), chosen: now}
    return replace(cell, **changed)


def without_part(cell: Cell, kind: type[Part], name: str) -> Cell:
    """Return a cell without a part of a kind; if it was in force, none of the kind is."""
    parts, chosen = _LISTS[kind]
    now = getattr(cell, chosen)
    changed: dict[str, Any] = {parts: without(getattr(cell, parts), name)}
    changed[chosen] = "" if now == name else now
    return replace(cell, **changed)


def placed(cell: Cell, placement: Placement) -> Cell:
    """Return a cell with the base elsewhere; a frame of the room that goes is not in force."""
    gone = cell.frame == WORLD and not placement.is_set
    return replace(cell, placement=placement, frame="" if gone else cell.frame)


def check_cell(cell: Cell) -> Refusal | None:
    """Return why a cell is not possible as a whole, or ``None``."""
    misplaced = check_placement(cell.placement)
    if misplaced is not None:
        return misplaced
    refusals: Sequence[Refusal | None] = (
        check_name(cell.name),
        check_names(tool.name for tool in cell.tools),
        *(check_tool(tool) for tool in cell.tools),
        _check_choice(cell.tool, cell.chosen_tool),
        check_gripper_table(cell.gripper_table, used=cell.gripper_calibrated),
        check_area(cell.area),
        check_names(held.name for held in cell.held_objects),
        *(check_held_object(held) for held in cell.held_objects),
        _check_choice(cell.held, cell.held_object),
        check_names(frame.name for frame in cell.all_frames),
        *(check_user_frame(frame) for frame in cell.frames),
        _check_choice(cell.frame, cell.chosen_frame),
    )
    return next((each for each in refusals if each is not None), None)


def _check_choice(name: str, chosen: object) -> Refusal | None:
    return CELL_CHOICE_BAD(value=name) if name and chosen is None else None
