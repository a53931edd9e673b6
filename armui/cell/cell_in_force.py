"""The parts of a cell that count at a moment, as a recording keeps and a replay shows them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

from armui.arm.json_fields import FieldError, Fields
from armui.arm.refusal import Refusal
from armui.cell import parts
from armui.cell.cell import Cell
from armui.cell.held_objects import HeldObject, check_held_object
from armui.cell.placement import Placement, check_placement
from armui.cell.tools import Tool, check_tool
from armui.cell.user_frames import UserFrame, check_user_frame
from armui.cell.work_area import Area, check_area

_Part = TypeVar("_Part")
_Otherwise = TypeVar("_Otherwise")


@dataclass(frozen=True, slots=True)
class CellInForce:
    """The parts of a cell that count at a moment.

    Attributes:
        name: Its name; "" without one.
        tool: The tool on the flange.
        held: What the hand holds, or ``None``.
        area: The planes and boxes of the work area that are switched on.
        frame: The user frame that poses are shown in, or ``None`` for the base.
        placement: Where the base stands in the room.
    """

    name: str = ""
    tool: Tool = field(default_factory=lambda: Tool(""))
    held: HeldObject | None = None
    area: Area = field(default_factory=Area)
    frame: UserFrame | None = None
    placement: Placement = field(default_factory=Placement)


def cell_in_force(cell: Cell) -> CellInForce:
    """Return the parts of a cell that are in force."""
    tool, area = cell.chosen_tool or Tool(""), cell.area.in_force
    return CellInForce(cell.name, tool, cell.held_object, area, cell.chosen_frame, cell.placement)


def to_entry(holding: CellInForce) -> dict[str, object]:
    """Return it as a line of a recording's sidecar, without absent parts."""
    entry: dict[str, object] = {"cell": holding.name, "tool": parts.to_entry(holding.tool)}
    if holding.held is not None:
        entry["held"] = parts.to_entry(holding.held)
    if not holding.area.is_free:
        entry["area"] = parts.to_entry(holding.area)
    if holding.frame is not None:
        entry["frame"] = parts.to_entry(holding.frame)
    if holding.placement.is_set:
        entry["placement"] = parts.to_entry(holding.placement)
    return entry


def from_entry(entry: Mapping[str, Any]) -> CellInForce:
    """Return the parts in a line of a sidecar; missing or invalid ones are left out."""
    name = entry.get("cell")
    return CellInForce(
        name if isinstance(name, str) else "",
        _part(entry.get("tool"), Tool, check_tool, Tool("")),
        _part(entry.get("held"), HeldObject, check_held_object, None),
        _part(entry.get("area"), Area, check_area, Area()),
        _part(entry.get("frame"), UserFrame, check_user_frame, None),
        _part(entry.get("placement"), Placement, check_placement, Placement()),
    )


def all_through(told: Sequence[CellInForce]) -> CellInForce:
    """Return the parts that were equal at all of some moments; those that changed are left out."""
    nothing = CellInForce()
    tools_told = {each.tool.pose: each.tool for each in told}
    same = {
        part: held.pop()
        for part in ("name", "held", "area", "frame", "placement")
        if len(held := {getattr(each, part) for each in told}) == 1
    }
    tool = nothing.tool if len(tools_told) != 1 else next(iter(tools_told.values()))
    return replace(nothing, tool=tool, **same)


def _part(
    entry: object,
    kind: type[_Part],
    check: Callable[[_Part], Refusal | None],
    otherwise: _Otherwise,
) -> _Part | _Otherwise:
    try:
        found = parts.from_entry(kind, Fields(entry))
    except FieldError:
        return otherwise
    return otherwise if check(found) is not None else found
