"""Every reason against a trajectory, its file, or a change of the library."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.ui.words.text import sentence

_FILES: Final[Mapping[str, object]] = {
    "file_gone": QT_TRANSLATE_NOOP("Refusal", "It is not in the library any more."),
    "file_unreadable": QT_TRANSLATE_NOOP("Refusal", "The file cannot be read: {text}."),
    "file_too_large": QT_TRANSLATE_NOOP(
        "Refusal", "The file has {value} MB; files up to {maximum} MB are read."
    ),
    "file_not_text": QT_TRANSLATE_NOOP(
        "Refusal", "This is no text in UTF-8 or GBK. Save it as a text file in UTF-8."
    ),
    "file_not_encoding": QT_TRANSLATE_NOOP(
        "Refusal", "This is no text in {value}. Choose another encoding."
    ),
    "file_kind_unknown": QT_TRANSLATE_NOOP(
        "Refusal", "This is no trajectory file the program knows. Import it by columns."
    ),
    "file_no_table": QT_TRANSLATE_NOOP(
        "Refusal", "No rows of numbers are found here. Choose a file with one point a row."
    ),
    "file_version": QT_TRANSLATE_NOOP(
        "Refusal",
        "The file is of version {value}; this program reads up to version {maximum}. Update the "
        "program.",
    ),
    "file_empty": QT_TRANSLATE_NOOP("Refusal", "The file holds nothing."),
    "file_cut_off": QT_TRANSLATE_NOOP("Refusal", "The file ends too early."),
    "file_damaged": QT_TRANSLATE_NOOP("Refusal", "The file is damaged: {text}."),
    "line_unknown": QT_TRANSLATE_NOOP(
        "Refusal", "“{value}” is no kind of line. A line begins with J, P, L, C or #."
    ),
    "header_unknown": QT_TRANSLATE_NOOP(
        "Refusal", "“{value}” is no entry of the header; name, note and modified are."
    ),
    "option_unknown": QT_TRANSLATE_NOOP(
        "Refusal",
        "“{value}” is no option of a point; speed, dwell, gripper, light and note are.",
    ),
    "option_twice": QT_TRANSLATE_NOOP("Refusal", "“{value}” is given twice. Leave one."),
    "option_bad": QT_TRANSLATE_NOOP("Refusal", "“{value}” is no {field}. Write it as {example}."),
    "number_bad": QT_TRANSLATE_NOOP("Refusal", "“{value}” is not a number."),
    "values_count": QT_TRANSLATE_NOOP("Refusal", "{value} numbers where {expected} belong."),
    "text_unclosed": QT_TRANSLATE_NOOP("Refusal", "The closing quotation mark is missing."),
    "column_missing": QT_TRANSLATE_NOOP("Refusal", "The column “{field}” is missing."),
    "column_unknown": QT_TRANSLATE_NOOP("Refusal", "The column “{value}” is unknown."),
    "column_twice": QT_TRANSLATE_NOOP("Refusal", "The column “{field}” is there twice."),
    "cells_count": QT_TRANSLATE_NOOP(
        "Refusal", "{value} cells where there are {expected} columns."
    ),
    "time_bad": QT_TRANSLATE_NOOP(
        "Refusal", "“{value}” is no date and time. Write it as 2026-01-31T12:00:00."
    ),
    "json_bad": QT_TRANSLATE_NOOP("Refusal", "This is not valid JSON: {text}."),
    "json_field_missing": QT_TRANSLATE_NOOP("Refusal", "“{field}” is missing."),
    "json_field_unknown": QT_TRANSLATE_NOOP("Refusal", "“{value}” is unknown."),
    "json_field_bad": QT_TRANSLATE_NOOP(
        "Refusal", "“{field}” is not what it should be: {expected}."
    ),
}

_POINTS: Final[Mapping[str, object]] = {
    "point_out_of_range": QT_TRANSLATE_NOOP(
        "Refusal",
        "{field}: {value}{unit} is out of range. Enter a value from {minimum}{unit} to "
        "{maximum}{unit}.",
    ),
    "point_not_a_number": QT_TRANSLATE_NOOP("Refusal", "{field}: “{value}” is not a number."),
    "point_not_whole": QT_TRANSLATE_NOOP("Refusal", "{field}: {value} is not a whole number."),
    "point_incomplete": QT_TRANSLATE_NOOP(
        "Refusal", "{field}: {value} values; six belong there, and a middle only to MOVE C."
    ),
    "point_move_unknown": QT_TRANSLATE_NOOP(
        "Refusal", "“{value}” is no kind of motion. MOVE J, MOVE P, MOVE L and MOVE C are."
    ),
    "sample_back_in_time": QT_TRANSLATE_NOOP(
        "Refusal", "The time {value} s is before the one above, {minimum} s."
    ),
    "text_too_long": QT_TRANSLATE_NOOP(
        "Refusal", "{field}: {value} characters; up to {maximum} are kept. Shorten it."
    ),
    "text_bad": QT_TRANSLATE_NOOP(
        "Refusal", "{field}: holds a character that cannot be kept. Remove it."
    ),
    "convert_needs_middle": QT_TRANSLATE_NOOP(
        "Refusal", "An arc needs a middle pose, which no conversion can know. Enter it by hand."
    ),
    "convert_out_of_reach": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm cannot bring its flange to X {x}  Y {y}  Z {z} mm with this orientation: no joint "
        "angles belong to it. Change the pose.",
    ),
}

_LIBRARY: Final[Mapping[str, object]] = {
    "name_empty": QT_TRANSLATE_NOOP("Refusal", "A trajectory needs a name. Enter one."),
    "name_too_long": QT_TRANSLATE_NOOP(
        "Refusal", "The name has {value} characters; up to {maximum} are kept. Shorten it."
    ),
    "name_taken": QT_TRANSLATE_NOOP("Refusal", "There is a “{name}” already. Choose another name."),
    "changed_since": QT_TRANSLATE_NOOP(
        "Refusal",
        "“{name}” has been changed since it was made, and is kept. Delete it if you do not want "
        "it.",
    ),
    "deleted_gone": QT_TRANSLATE_NOOP(
        "Refusal",
        "“{name}” is no longer among what was deleted. It has been brought back already, or its "
        "time was up.",
    ),
    "library_damaged": QT_TRANSLATE_NOOP(
        "Refusal",
        "The file of “{name}” is damaged and is not written over. Save under another name.",
    ),
    "library_not_saved": QT_TRANSLATE_NOOP(
        "Refusal",
        "“{name}” was not saved: {text}. What was kept before is unchanged. Check the disk, then "
        "save again.",
    ),
    "library_not_deleted": QT_TRANSLATE_NOOP(
        "Refusal", "Not deleted: {name}: {text}. Check the rights to the library's folder."
    ),
    "library_not_restored": QT_TRANSLATE_NOOP(
        "Refusal", "Not brought back: {name}: {text}. Check the rights to the library's folder."
    ),
    "library_unreadable": QT_TRANSLATE_NOOP(
        "Refusal", "The library cannot be read: {name}: {text}. Check the rights to this folder."
    ),
}

_COLUMNS: Final[Mapping[str, object]] = {
    "columns_twice": QT_TRANSLATE_NOOP(
        "Refusal", "Columns {first} and {second} are both {field}. Leave one of them out."
    ),
    "columns_missing": QT_TRANSLATE_NOOP(
        "Refusal", "Still missing: {missing}. Say which columns hold them."
    ),
    "columns_unit": QT_TRANSLATE_NOOP(
        "Refusal", "Column {column}: {field} is not given in “{value}”. Choose one of {choices}."
    ),
}

TRAJECTORY_REFUSALS: Final[Mapping[str, object]] = {**_FILES, **_POINTS, **_LIBRARY, **_COLUMNS}

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
