"""Every reason against a trajectory, its file, or a change of the library."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal_codes import RefusalCode
from armui.ui.words.text import Texts

_FILES: Final = Texts("Refusal") | {
    RefusalCode.FILE_GONE: "It is not in the library any more.",
    RefusalCode.FILE_UNREADABLE: "The file cannot be read: {text}.",
    RefusalCode.FILE_TOO_LARGE: "The file has {value} MB; files up to {maximum} MB are read.",
    RefusalCode.FILE_NOT_TEXT: "This is no text in UTF-8 or GBK. Save it as a text file in UTF-8.",
    RefusalCode.FILE_NOT_ENCODING: "This is no text in {value}. Choose another encoding.",
    RefusalCode.FILE_KIND_UNKNOWN: (
        "This is no trajectory file the program knows. Import it by columns."
    ),
    RefusalCode.FILE_NO_TABLE: (
        "No rows of numbers are found here. Choose a file with one point a row."
    ),
    RefusalCode.FILE_VERSION: (
        "The file is of version {value}; this program reads up to version {maximum}. Update the "
        "program."
    ),
    RefusalCode.FILE_EMPTY: "The file holds nothing.",
    RefusalCode.FILE_CUT_OFF: "The file ends too early.",
    RefusalCode.FILE_DAMAGED: "The file is damaged: {text}.",
    RefusalCode.LINE_UNKNOWN: "“{value}” is no kind of line. A line begins with J, P, L, C or #.",
    RefusalCode.HEADER_UNKNOWN: "“{value}” is no entry of the header; name, note and modified are.",
    RefusalCode.OPTION_UNKNOWN: (
        "“{value}” is no option of a point; speed, dwell, gripper, light and note are."
    ),
    RefusalCode.OPTION_TWICE: "“{value}” is given twice. Leave one.",
    RefusalCode.OPTION_BAD: "“{value}” is no {field}. Write it as {example}.",
    RefusalCode.NUMBER_BAD: "“{value}” is not a number.",
    RefusalCode.VALUES_COUNT: "{value} numbers where {expected} belong.",
    RefusalCode.TEXT_UNCLOSED: "The closing quotation mark is missing.",
    RefusalCode.COLUMN_MISSING: "The column “{field}” is missing.",
    RefusalCode.COLUMN_UNKNOWN: "The column “{value}” is unknown.",
    RefusalCode.COLUMN_TWICE: "The column “{field}” is there twice.",
    RefusalCode.CELLS_COUNT: "{value} cells where there are {expected} columns.",
    RefusalCode.TIME_BAD: "“{value}” is no date and time. Write it as 2026-01-31T12:00:00.",
    RefusalCode.JSON_BAD: "This is not valid JSON: {text}.",
    RefusalCode.JSON_FIELD_MISSING: "“{field}” is missing.",
    RefusalCode.JSON_FIELD_UNKNOWN: "“{value}” is unknown.",
    RefusalCode.JSON_FIELD_BAD: "“{field}” is not what it should be: {expected}.",
}

_POINTS: Final = Texts("Refusal") | {
    RefusalCode.POINT_OUT_OF_RANGE: (
        "{field}: {value}{unit} is out of range. Enter a value from {minimum}{unit} to "
        "{maximum}{unit}."
    ),
    RefusalCode.POINT_NOT_A_NUMBER: "{field}: “{value}” is not a number.",
    RefusalCode.POINT_NOT_WHOLE: "{field}: {value} is not a whole number.",
    RefusalCode.POINT_INCOMPLETE: (
        "{field}: {value} values; six belong there, and a middle only to MOVE C."
    ),
    RefusalCode.POINT_MOVE_UNKNOWN: (
        "“{value}” is no kind of motion. MOVE J, MOVE P, MOVE L and MOVE C are."
    ),
    RefusalCode.SAMPLE_BACK_IN_TIME: "The time {value} s is before the one above, {minimum} s.",
    RefusalCode.TEXT_TOO_LONG: "{field}: {value} characters; up to {maximum} are kept. Shorten it.",
    RefusalCode.TEXT_BAD: "{field}: holds a character that cannot be kept. Remove it.",
    RefusalCode.CONVERT_NEEDS_MIDDLE: (
        "An arc needs a middle pose, which no conversion can know. Enter it by hand."
    ),
    RefusalCode.CONVERT_OUT_OF_REACH: (
        "The arm cannot bring its flange to X {x}  Y {y}  Z {z} mm with this orientation: no joint "
        "angles belong to it. Change the pose."
    ),
}

_LIBRARY: Final = Texts("Refusal") | {
    RefusalCode.NAME_EMPTY: "A trajectory needs a name. Enter one.",
    RefusalCode.NAME_TOO_LONG: (
        "The name has {value} characters; up to {maximum} are kept. Shorten it."
    ),
    RefusalCode.NAME_TAKEN: "There is a “{name}” already. Choose another name.",
    RefusalCode.CHANGED_SINCE: (
        "“{name}” has been changed since it was made, and is kept. Delete it if you do not want it."
    ),
    RefusalCode.DELETED_GONE: (
        "“{name}” is no longer among what was deleted. It has been brought back already, or its "
        "time was up."
    ),
    RefusalCode.LIBRARY_DAMAGED: (
        "The file of “{name}” is damaged and is not written over. Save under another name."
    ),
    RefusalCode.LIBRARY_NOT_SAVED: (
        "“{name}” was not saved: {text}. What was kept before is unchanged. Check the disk, then "
        "save again."
    ),
    RefusalCode.LIBRARY_NOT_DELETED: (
        "Not deleted: {name}: {text}. Check the rights to the library's folder."
    ),
    RefusalCode.LIBRARY_NOT_RESTORED: (
        "Not brought back: {name}: {text}. Check the rights to the library's folder."
    ),
    RefusalCode.LIBRARY_UNREADABLE: (
        "The library cannot be read: {name}: {text}. Check the rights to this folder."
    ),
}

_COLUMNS: Final = Texts("Refusal") | {
    RefusalCode.COLUMNS_TWICE: (
        "Columns {first} and {second} are both {field}. Leave one of them out."
    ),
    RefusalCode.COLUMNS_MISSING: "Still missing: {missing}. Say which columns hold them.",
    RefusalCode.COLUMNS_UNIT: (
        "Column {column}: {field} is not given in “{value}”. Choose one of {choices}."
    ),
}

TRAJECTORY_REFUSALS: Final = _FILES | _POINTS | _LIBRARY | _COLUMNS

_FIGURES: Final = Texts("PointFigure") | {
    "speed": "Speed",
    "dwell": "Dwell",
    "opening": "Gripper opening",
    "torque": "Gripper torque",
    "gripper": "Gripper opening",
    "gripper angle": "Gripper angle",
    "gripper speed": "Gripper speed",
    "light joint": "Light, joint",
    "lamp": "Light, lamp",
    "red": "Light, R",
    "green": "Light, G",
    "blue": "Light, B",
    "target": "Target",
    "middle": "Middle pose",
    "t": "Time",
    "time": "Time",
    "wait": "Time since the row before",
    "note": "Note",
    "name": "Name",
    "comment": "Comment",
    "taught_on": "Arm it was taught on",
}
_OF_FIGURES: Final = ("point_", "text_", "columns_")
"""How the codes begin whose field is a figure of a point, and not a word of a file."""
_CLOSE_UNITS: Final = ("", "°", "%")


def point_figure(name: str) -> str:
    """What a figure of a point is called: a key of ``program.RANGES``, or a text of it."""
    return _FIGURES.word(name)


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
