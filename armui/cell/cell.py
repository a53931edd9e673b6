"""A cell: what is fixed to the arm and stands around it, by name."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from armui.arm.refusal import Reason, Refusal
from armui.cell.checks import check_name, check_names
from armui.cell.gripper_table import GripperTable, Pairs, check_gripper_table
from armui.cell.held_objects import HeldObject, check_held_object
from armui.cell.tools import Tool, check_tool
from armui.cell.user_frames import UserFrame, check_user_frame
from armui.cell.work_area import Area, check_area

CELL_CHOICE_BAD = Reason(
    "cell_choice_bad", "The cell has nothing named “{value}”. Choose one of those in its list."
)


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

    @property
    def is_empty(self) -> bool:
        """True if nothing was added yet: the arm moves as without a cell."""
        return self == Cell(self.name)

    @property
    def chosen_tool(self) -> Tool | None:
        """The chosen tool, or ``None`` for the bare flange."""
        return self.tool_named(self.tool)

    @property
    def chosen_frame(self) -> UserFrame | None:
        """The chosen user frame, or ``None`` for the base."""
        return self.frame_named(self.frame)

    @property
    def held_object(self) -> HeldObject | None:
        """What the hand holds now, or ``None``."""
        return self.object_named(self.held)

    @property
    def gripper(self) -> GripperTable | None:
        """The gripper's table while it is applied, or ``None``."""
        return GripperTable(self.gripper_table) if self.gripper_calibrated else None

    def tool_named(self, name: str) -> Tool | None:
        """Return a tool by its name, or ``None``."""
        return next((tool for tool in self.tools if tool.name == name), None)

    def object_named(self, name: str) -> HeldObject | None:
        """Return something that the hand may hold by its name, or ``None``."""
        return next((each for each in self.held_objects if each.name == name), None)

    def frame_named(self, name: str) -> UserFrame | None:
        """Return a user frame by its name, or ``None``."""
        return next((frame for frame in self.frames if frame.name == name), None)


def with_tool(cell: Cell, tool: Tool, *, instead_of: str = "") -> Cell:
    """Return a cell with a further tool, or with a tool in the place of another.

    Args:
        cell: The cell.
        tool: The tool; it is chosen if it is new, or if the one it replaces was.
        instead_of: The name of the tool that it replaces; "" adds it.
    """
    if not instead_of:
        return replace(cell, tools=(*cell.tools, tool), tool=tool.name)
    tools = tuple(tool if each.name == instead_of else each for each in cell.tools)
    return replace(cell, tools=tools, tool=tool.name if cell.tool == instead_of else cell.tool)


def without_tool(cell: Cell, name: str) -> Cell:
    """Return a cell without a tool; if it was the chosen one, the bare flange is chosen."""
    tools = tuple(each for each in cell.tools if each.name != name)
    return replace(cell, tools=tools, tool="" if cell.tool == name else cell.tool)


def with_held_object(cell: Cell, held: HeldObject, *, instead_of: str = "") -> Cell:
    """Return a cell with a further object to hold, or with one in the place of another."""
    if not instead_of:
        return replace(cell, held_objects=(*cell.held_objects, held))
    objects = tuple(held if each.name == instead_of else each for each in cell.held_objects)
    now = held.name if cell.held == instead_of else cell.held
    return replace(cell, held_objects=objects, held=now)


def with_frame(cell: Cell, frame: UserFrame, *, instead_of: str = "") -> Cell:
    """Return a cell with a further user frame, or with one in the place of another.

    Args:
        cell: The cell.
        frame: The frame; it is chosen if it is new, or if the one it replaces was.
        instead_of: The name of the frame that it replaces; "" adds it.
    """
    if not instead_of:
        return replace(cell, frames=(*cell.frames, frame), frame=frame.name)
    frames = tuple(frame if each.name == instead_of else each for each in cell.frames)
    chosen = frame.name if cell.frame == instead_of else cell.frame
    return replace(cell, frames=frames, frame=chosen)


def without_frame(cell: Cell, name: str) -> Cell:
    """Return a cell without a user frame; if it was the chosen one, the base is chosen."""
    frames = tuple(each for each in cell.frames if each.name != name)
    return replace(cell, frames=frames, frame="" if cell.frame == name else cell.frame)


def check_cell(cell: Cell) -> Refusal | None:
    """Return why a cell is not possible as a whole, or ``None``."""
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
        check_names(frame.name for frame in cell.frames),
        *(check_user_frame(frame) for frame in cell.frames),
        _check_choice(cell.frame, cell.chosen_frame),
    )
    return next((each for each in refusals if each is not None), None)


def _check_choice(name: str, chosen: object) -> Refusal | None:
    return CELL_CHOICE_BAD(value=name) if name and chosen is None else None
