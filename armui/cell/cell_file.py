"""Cells as files that people can read: JSON, a parameter a line with its unit in its name.

A file is taken whole or not at all: one that is broken, cut short, foreign, of a newer version or
with a figure that is not possible is refused, and the place of the error is named.
"""

from __future__ import annotations

import errno
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from armui.arm.json_fields import FieldError, FieldProblem, Fields
from armui.arm.refusal import Reason, Refusal
from armui.cell import gripper_table
from armui.cell.cell import Cell, check_cell
from armui.cell.held_objects import HeldObject
from armui.cell.parts import Part, from_entry, to_entry
from armui.cell.placement import Placement
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.cell.work_area import Area
from armui.system.atomic import write_whole
from armui.system.files import error_text, read_file

CELL_NO_JSON = Reason(
    "cell_no_json",
    "The cell's file is broken or cut short: line {line}, column {column} is not JSON. Nothing "
    "was changed; choose another file, or correct that line.",
)
CELL_FOREIGN = Reason(
    "cell_foreign", "This is no cell of this program. Nothing was changed; choose another file."
)
CELL_VERSION = Reason(
    "cell_version",
    "The cell's file has format version {version}; this program reads version {known}. Update "
    "this program, or use the one that wrote it.",
)
CELL_FIELD_BAD = Reason(
    "cell_field_bad",
    "The cell's file is not valid at “{field}” ({problem}). Nothing was changed; choose "
    "another file, or correct the field.",
)
CELL_UNREADABLE = Reason(
    "cell_unreadable", "The file {path} cannot be read: {text}. Choose another one."
)
CELL_NOT_WRITTEN = Reason(
    "cell_not_written",
    "The cell could not be written to {path}: {text}. It holds until the program ends; export it "
    "to another folder.",
)
SUFFIX: Final = ".armui-cell"
FORMAT: Final = "armui-cell"
VERSION: Final = 2
_UNPLACED: Final = 1
"""The version of a file without the place of the base, so that older programs read it."""
_LARGEST_BYTES: Final = 1_000_000


@dataclass(frozen=True, slots=True)
class Difference:
    """A place at which two cells differ.

    Attributes:
        place: The path of the parameter in the file, as ``tools.gripper.z_mm``.
        before: Its value in the first cell; ``None`` if it is not there.
        after: Its value in the second.
    """

    place: str
    before: object
    after: object


def to_text(cell: Cell) -> str:
    """Return a cell as the text of its file; its name is that of the file."""
    version = VERSION if cell.placement.is_set else _UNPLACED
    entries = {"format": FORMAT, "version": version, **_entries(cell)}
    return json.dumps(entries, indent=2, ensure_ascii=False) + "\n"


def from_text(text: str, name: str) -> Cell | Refusal:
    """Return the cell in the text of a file, or why it is none.

    Args:
        text: The text.
        name: The name of the cell: that of the file, without its suffix.
    """
    try:
        values = json.loads(text)
    except json.JSONDecodeError as error:
        return CELL_NO_JSON(line=error.lineno, column=error.colno)
    except (ValueError, RecursionError):  # a huge number; deeply nested lists
        return CELL_FOREIGN()
    if not isinstance(values, dict) or values.get("format") != FORMAT:
        return CELL_FOREIGN()
    try:
        return _cell(Fields(values), name)
    except FieldError as error:
        problem = error.problem.value if error.refusal is None else error.expected
        return error.refusal or CELL_FIELD_BAD(field=error.place, problem=problem)


def read_cell(path: Path) -> Cell | Refusal:
    """Return the cell in a file, or why the file is none."""
    try:
        text = read_file(path, _LARGEST_BYTES).decode("utf-8-sig")
    except UnicodeDecodeError:
        return CELL_FOREIGN()
    except OSError as error:
        if error.errno == errno.EFBIG:
            return CELL_FOREIGN()
        return CELL_UNREADABLE(path=str(path), text=error_text(error))
    return from_text(text, path.stem)


def write_cell(path: Path, cell: Cell) -> Refusal | None:
    """Write a cell to a file, whole or not at all; return ``None``, or why it was not written."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write_whole(path, to_text(cell).encode())
    except OSError as error:
        return CELL_NOT_WRITTEN(path=str(path), text=error_text(error))
    return None


def delete_cell(path: Path) -> Refusal | None:
    """Delete the file of a cell; return ``None``, or why it could not be deleted."""
    try:
        path.unlink(missing_ok=True)
    except OSError as error:
        return CELL_NOT_WRITTEN(path=str(path), text=error_text(error))
    return None


def differences(before: Cell, after: Cell) -> tuple[Difference, ...]:
    """Return where two cells differ, by parameter; things of one list are told apart by name."""
    old, new = (dict(_flat("", _entries(cell))) for cell in (before, after))
    places = [*old, *(place for place in new if place not in old)]
    pairs = ((place, old.get(place), new.get(place)) for place in places)
    return tuple(Difference(*pair) for pair in pairs if pair[1] != pair[2])


def _entries(cell: Cell) -> dict[str, object]:
    return {
        "tools": list(map(to_entry, cell.tools)),
        "tool": cell.tool,
        "gripper_table": gripper_table.to_entries(cell.gripper_table),
        "gripper_calibrated": int(cell.gripper_calibrated),
        "area": to_entry(cell.area),
        "held_objects": list(map(to_entry, cell.held_objects)),
        "held": cell.held,
        "frames": list(map(to_entry, cell.frames)),
        "frame": cell.frame,
        **({"placement": to_entry(cell.placement)} if cell.placement.is_set else {}),
    }


def _cell(fields: Fields, name: str) -> Cell:
    """Return the cell in the fields of a file.

    Raises:
        FieldError: The file is refused.
    """
    fields.text("format")
    version = fields.whole("version")
    if version not in {_UNPLACED, VERSION}:
        raise fields.wrong("version", CELL_VERSION(version=version, known=VERSION))
    placement = fields.maybe_object("placement")
    cell = Cell(
        name,
        tools=_parts(Tool, fields, "tools"),
        tool=fields.text("tool", ""),
        gripper_table=gripper_table.from_entries(_objects(fields, "gripper_table")),
        gripper_calibrated=bool(fields.whole("gripper_calibrated", 0, (0, 1))),
        area=from_entry(Area, fields.object("area")) if "area" in fields else Area(),
        held_objects=_parts(HeldObject, fields, "held_objects"),
        held=fields.text("held", ""),
        frames=_parts(UserFrame, fields, "frames"),
        frame=fields.text("frame", ""),
        placement=from_entry(Placement, placement) if placement else Placement(),
    )
    fields.nothing_else()
    refusal = check_cell(cell)
    if refusal is not None:
        raise FieldError(FieldProblem.BAD, (), refusal=refusal)
    return cell


def _parts(kind: type[Part], fields: Fields, name: str) -> tuple[Part, ...]:
    return tuple(from_entry(kind, each) for each in _objects(fields, name))


def _objects(fields: Fields, name: str) -> Sequence[Fields]:
    """Return the objects of a list; none of a part that older files do not have."""
    return tuple(fields.objects(name)) if name in fields else ()


def _flat(place: str, value: object) -> Iterator[tuple[str, object]]:
    """Yield each parameter with its place."""
    if isinstance(value, Mapping):
        for key, each in value.items():
            if not (key == "name" and place):
                yield from _flat(f"{place}.{key}".removeprefix("."), each)
    elif isinstance(value, list):
        for number, each in enumerate(value, start=1):
            named = isinstance(each, Mapping) and "name" in each
            yield from _flat(f"{place}.{each['name'] if named else number}", each)
    else:
        yield place, value
