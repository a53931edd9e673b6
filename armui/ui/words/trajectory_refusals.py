"""Every reason against a trajectory, its file, or a change of the library."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.refusal_codes import RefusalCode
from armui.ui.words.text import sentence

_FILES: Final[Mapping[RefusalCode, object]] = {
    RefusalCode.FILE_GONE: QT_TRANSLATE_NOOP("Refusal", "It is not in the library any more."),
    RefusalCode.FILE_UNREADABLE: QT_TRANSLATE_NOOP("Refusal", "The file cannot be read: {text}."),
    RefusalCode.FILE_TOO_LARGE: QT_TRANSLATE_NOOP(
        "Refusal", "The file has {value} MB; files up to {maximum} MB are read."
    ),
    RefusalCode.FILE_NOT_TEXT: QT_TRANSLATE_NOOP(
        "Refusal", "This is no text in UTF-8 or GBK. Save it as a text file in UTF-8."
    ),
    RefusalCode.FILE_NOT_ENCODING: QT_TRANSLATE_NOOP(
        "Refusal", "This is no text in {value}. Choose another encoding."
    ),
    RefusalCode.FILE_KIND_UNKNOWN: QT_TRANSLATE_NOOP(
        "Refusal", "This is no trajectory file the program knows. Import it by columns."
    ),
    RefusalCode.FILE_NO_TABLE: QT_TRANSLATE_NOOP(
        "Refusal", "No rows of numbers are found here. Choose a file with one point a row."
    ),
    RefusalCode.FILE_VERSION: QT_TRANSLATE_NOOP(
        "Refusal",
        "The file is of version {value}; this program reads up to version {maximum}. Update the "
        "program.",
    ),
    RefusalCode.FILE_EMPTY: QT_TRANSLATE_NOOP("Refusal", "The file holds nothing."),
    RefusalCode.FILE_CUT_OFF: QT_TRANSLATE_NOOP("Refusal", "The file ends too early."),
    RefusalCode.FILE_DAMAGED: QT_TRANSLATE_NOOP("Refusal", "The file is damaged: {text}."),
    RefusalCode.LINE_UNKNOWN: QT_TRANSLATE_NOOP(
        "Refusal", "“{value}” is no kind of line. A line begins with J, P, L, C or #."
    ),
    RefusalCode.HEADER_UNKNOWN: QT_TRANSLATE_NOOP(
        "Refusal", "“{value}” is no entry of the header; name, note and modified are."
    ),
    RefusalCode.OPTION_UNKNOWN: QT_TRANSLATE_NOOP(
        "Refusal", "“{value}” is no option of a point; speed, dwell, gripper, light and note are."
    ),
    RefusalCode.OPTION_TWICE: QT_TRANSLATE_NOOP("Refusal", "“{value}” is given twice. Leave one."),
    RefusalCode.OPTION_BAD: QT_TRANSLATE_NOOP(
        "Refusal", "“{value}” is no {field}. Write it as {example}."
    ),
    RefusalCode.NUMBER_BAD: QT_TRANSLATE_NOOP("Refusal", "“{value}” is not a number."),
    RefusalCode.VALUES_COUNT: QT_TRANSLATE_NOOP(
        "Refusal", "{value} numbers where {expected} belong."
    ),
    RefusalCode.TEXT_UNCLOSED: QT_TRANSLATE_NOOP(
        "Refusal", "The closing quotation mark is missing."
    ),
    RefusalCode.COLUMN_MISSING: QT_TRANSLATE_NOOP("Refusal", "The column “{field}” is missing."),
    RefusalCode.COLUMN_UNKNOWN: QT_TRANSLATE_NOOP("Refusal", "The column “{value}” is unknown."),
    RefusalCode.COLUMN_TWICE: QT_TRANSLATE_NOOP("Refusal", "The column “{field}” is there twice."),
    RefusalCode.CELLS_COUNT: QT_TRANSLATE_NOOP(
        "Refusal", "{value} cells where there are {expected} columns."
    ),
    RefusalCode.TIME_BAD: QT_TRANSLATE_NOOP(
        "Refusal", "“{value}” is no date and time. Write it as 2026-01-31T12:00:00."
    ),
    RefusalCode.JSON_BAD: QT_TRANSLATE_NOOP("Refusal", "This is not valid JSON: {text}."),
    RefusalCode.JSON_FIELD_MISSING: QT_TRANSLATE_NOOP("Refusal", "“{field}” is missing."),
    RefusalCode.JSON_FIELD_UNKNOWN: QT_TRANSLATE_NOOP("Refusal", "“{value}” is unknown."),
    RefusalCode.JSON_FIELD_BAD: QT_TRANSLATE_NOOP(
        "Refusal", "“{field}” is not what it should be: {expected}."
    ),
}

_POINTS: Final[Mapping[RefusalCode, object]] = {
    RefusalCode.POINT_OUT_OF_RANGE: QT_TRANSLATE_NOOP(
        "Refusal",
        "{field}: {value}{unit} is out of range. Enter a value from {minimum}{unit} to "
        "{maximum}{unit}.",
    ),
    RefusalCode.POINT_NOT_A_NUMBER: QT_TRANSLATE_NOOP(
        "Refusal", "{field}: “{value}” is not a number."
    ),
    RefusalCode.POINT_NOT_WHOLE: QT_TRANSLATE_NOOP(
        "Refusal", "{field}: {value} is not a whole number."
    ),
    RefusalCode.POINT_INCOMPLETE: QT_TRANSLATE_NOOP(
        "Refusal", "{field}: {value} values; six belong there, and a middle only to MOVE C."
    ),
    RefusalCode.POINT_MOVE_UNKNOWN: QT_TRANSLATE_NOOP(
        "Refusal", "“{value}” is no kind of motion. MOVE J, MOVE P, MOVE L and MOVE C are."
    ),
    RefusalCode.SAMPLE_BACK_IN_TIME: QT_TRANSLATE_NOOP(
        "Refusal", "The time {value} s is before the one above, {minimum} s."
    ),
    RefusalCode.TEXT_TOO_LONG: QT_TRANSLATE_NOOP(
        "Refusal", "{field}: {value} characters; up to {maximum} are kept. Shorten it."
    ),
    RefusalCode.TEXT_BAD: QT_TRANSLATE_NOOP(
        "Refusal", "{field}: holds a character that cannot be kept. Remove it."
    ),
    RefusalCode.CONVERT_NEEDS_MIDDLE: QT_TRANSLATE_NOOP(
        "Refusal", "An arc needs a middle pose, which no conversion can know. Enter it by hand."
    ),
    RefusalCode.CONVERT_OUT_OF_REACH: QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm cannot bring its flange to X {x}  Y {y}  Z {z} mm with this orientation: no joint "
        "angles belong to it. Change the pose.",
    ),
}

_LIBRARY: Final[Mapping[RefusalCode, object]] = {
    RefusalCode.NAME_EMPTY: QT_TRANSLATE_NOOP("Refusal", "A trajectory needs a name. Enter one."),
    RefusalCode.NAME_TOO_LONG: QT_TRANSLATE_NOOP(
        "Refusal", "The name has {value} characters; up to {maximum} are kept. Shorten it."
    ),
    RefusalCode.NAME_TAKEN: QT_TRANSLATE_NOOP(
        "Refusal", "There is a “{name}” already. Choose another name."
    ),
    RefusalCode.CHANGED_SINCE: QT_TRANSLATE_NOOP(
        "Refusal",
        "“{name}” has been changed since it was made, and is kept. Delete it if you do not want "
        "it.",
    ),
    RefusalCode.DELETED_GONE: QT_TRANSLATE_NOOP(
        "Refusal",
        "“{name}” is no longer among what was deleted. It has been brought back already, or its "
        "time was up.",
    ),
    RefusalCode.LIBRARY_DAMAGED: QT_TRANSLATE_NOOP(
        "Refusal",
        "The file of “{name}” is damaged and is not written over. Save under another name.",
    ),
    RefusalCode.LIBRARY_NOT_SAVED: QT_TRANSLATE_NOOP(
        "Refusal",
        "“{name}” was not saved: {text}. What was kept before is unchanged. Check the disk, then "
        "save again.",
    ),
    RefusalCode.LIBRARY_NOT_DELETED: QT_TRANSLATE_NOOP(
        "Refusal", "Not deleted: {name}: {text}. Check the rights to the library's folder."
    ),
    RefusalCode.LIBRARY_NOT_RESTORED: QT_TRANSLATE_NOOP(
        "Refusal", "Not brought back: {name}: {text}. Check the rights to the library's folder."
    ),
    RefusalCode.LIBRARY_UNREADABLE: QT_TRANSLATE_NOOP(
        "Refusal", "The library cannot be read: {name}: {text}. Check the rights to this folder."
    ),
}

_COLUMNS: Final[Mapping[RefusalCode, object]] = {
    RefusalCode.COLUMNS_TWICE: QT_TRANSLATE_NOOP(
        "Refusal", "Columns {first} and {second} are both {field}. Leave one of them out."
    ),
    RefusalCode.COLUMNS_MISSING: QT_TRANSLATE_NOOP(
        "Refusal", "Still missing: {missing}. Say which columns hold them."
    ),
    RefusalCode.COLUMNS_UNIT: QT_TRANSLATE_NOOP(
        "Refusal", "Column {column}: {field} is not given in “{value}”. Choose one of {choices}."
    ),
}

TRAJECTORY_REFUSALS: Final[Mapping[RefusalCode, object]] = {
    **_FILES,
    **_POINTS,
    **_LIBRARY,
    **_COLUMNS,
}

_FIGURES: Final[Mapping[str, object]] = {
    "speed": QT_TRANSLATE_NOOP("PointFigure", "Speed"),
    "dwell": QT_TRANSLATE_NOOP("PointFigure", "Dwell"),
    "opening": QT_TRANSLATE_NOOP("PointFigure", "Gripper opening"),
    "torque": QT_TRANSLATE_NOOP("PointFigure", "Gripper torque"),
    "gripper": QT_TRANSLATE_NOOP("PointFigure", "Gripper opening"),
    "gripper angle": QT_TRANSLATE_NOOP("PointFigure", "Gripper angle"),
    "gripper speed": QT_TRANSLATE_NOOP("PointFigure", "Gripper speed"),
    "light joint": QT_TRANSLATE_NOOP("PointFigure", "Light, joint"),
    "lamp": QT_TRANSLATE_NOOP("PointFigure", "Light, lamp"),
    "red": QT_TRANSLATE_NOOP("PointFigure", "Light, R"),
    "green": QT_TRANSLATE_NOOP("PointFigure", "Light, G"),
    "blue": QT_TRANSLATE_NOOP("PointFigure", "Light, B"),
    "target": QT_TRANSLATE_NOOP("PointFigure", "Target"),
    "middle": QT_TRANSLATE_NOOP("PointFigure", "Middle pose"),
    "t": QT_TRANSLATE_NOOP("PointFigure", "Time"),
    "time": QT_TRANSLATE_NOOP("PointFigure", "Time"),
    "wait": QT_TRANSLATE_NOOP("PointFigure", "Time since the row before"),
    "note": QT_TRANSLATE_NOOP("PointFigure", "Note"),
    "name": QT_TRANSLATE_NOOP("PointFigure", "Name"),
    "comment": QT_TRANSLATE_NOOP("PointFigure", "Comment"),
}
_OF_FIGURES: Final = ("point_", "text_", "columns_")
"""How the codes begin whose field is a figure of a point, and not a word of a file."""
_CLOSE_UNITS: Final = ("", "°", "%")


def point_figure(name: str) -> str:
    """What a figure of a point is called: a key of ``program.RANGES``, or a text of it."""
    return sentence("PointFigure", _FIGURES.get(name, name), {})


def with_figures(code: str, params: dict[str, object]) -> dict[str, object]:
    """The figures of a sentence about a point, as the operator reads them."""
    if not code.startswith(_OF_FIGURES):
        return params
    words = dict(params)
    if isinstance(field := params.get("field"), str):
        words["field"] = point_figure(field)
    if isinstance(unit := params.get("unit"), str):
        words["unit"] = unit if unit in _CLOSE_UNITS else f" {unit}"
    if isinstance(missing := params.get("missing"), str):
        words["missing"] = ", ".join(map(point_figure, missing.split(", ")))
    return words
