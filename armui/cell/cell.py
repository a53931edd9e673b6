"""A cell: what is fixed to the arm and stands around it, by name."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from armui.arm.refusal import Reason, Refusal
from armui.cell.checks import check_name, check_names
from armui.cell.gripper_table import GripperTable, Pairs, check_gripper_table
from armui.cell.held_objects import HeldObject, check_held_object
from armui.cell.tools import Tool, check_tool
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
    """

    name: str
    tools: tuple[Tool, ...] = ()
    tool: str = ""
    gripper_table: Pairs = ()
    gripper_calibrated: bool = False
    area: Area = field(default_factory=Area)
    held_objects: tuple[HeldObject, ...] = ()
    held: str = ""

    @property
    def is_empty(self) -> bool:
        """True if nothing was added yet: the arm moves as without a cell."""
        return self == Cell(self.name)

    @property
    def chosen_tool(self) -> Tool | None:
        """The chosen tool, or ``None`` for the bare flange."""
        return next((tool for tool in self.tools if tool.name == self.tool), None)

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
    )
    return next((each for each in refusals if each is not None), None)


def _check_choice(name: str, chosen: object) -> Refusal | None:
    return CELL_CHOICE_BAD(value=name) if name and chosen is None else None
