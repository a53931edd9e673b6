"""Reasons against actions in the operator's language, with formatted figures.

The sentences are declared where they are raised (`armui.arm.refusal`).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.parameters import KINDS, Parameter
from armui.arm.refusal import Refusal
from armui.control.safety.interlocks import ARM_FAULT
from armui.setting_fields import DECLARED
from armui.ui.words import arm
from armui.ui.words.arm import ARM_PARTS, OTHER_MODES
from armui.ui.words.parameters import full_name, value_text
from armui.ui.words.settings import setting_label
from armui.ui.words.text import NOT_KNOWN, Text, Texts, sentence, source_of

if TYPE_CHECKING:
    from armui.trajectory.files import TrajectoryFileError


_REPORTED: Final = Text("Refusal", "The arm reported: {status}.")
_UNDER_WAY: Final = Texts("UnderWay") | {
    "enabling": "enabling the motors",
    "disabling": "disabling the motors",
    "resuming": "releasing the emergency stop",
    "recording": "recording",
    "settings": "reading or saving the arm's settings",
    "end_reports": "the setting before",
    "linkage": "setting the linkage",
    "zeroing": "setting a zero",
    "clearing_error": "clearing a joint's error",
    "teaching": "a teaching command",
    "recovery": "the step before",
}

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
"""The prefixes of codes whose field is a figure of a point, and not a word of a file."""
_CLOSE_UNITS: Final = ("", "°", "%")


_PLACE = QT_TRANSLATE_NOOP("FilePlace", "{file}, line {line}, column {column}: {reason}")
_LINE = QT_TRANSLATE_NOOP("FilePlace", "{file}, line {line}: {reason}")
_FILE = QT_TRANSLATE_NOOP("FilePlace", "{file}: {reason}")
_PLACE_ONLY = QT_TRANSLATE_NOOP("FilePlace", "Line {line}, column {column}: {reason}")
_LINE_ONLY = QT_TRANSLATE_NOOP("FilePlace", "Line {line}: {reason}")


_IN_WORDS: Final[Mapping[str, tuple[type, Callable[[Any], str]]]] = {
    "mode": (int, arm.control_mode),
    "other_mode": (str, OTHER_MODES.text),
    "status": (int, arm.arm_status),
    "what": (str, _UNDER_WAY.word),
    "figure": (str, arm.figure),
    "operation": (str, arm.operation_title),
    **dict.fromkeys(("part", "one", "other"), (str, ARM_PARTS.word)),
}
"""The figures of sentences that are codes or names: their type, and what puts them in words."""


def in_words(params: dict[str, object]) -> dict[str, object]:
    """Return the figures of a sentence with codes and names in the operator's language."""
    said = dict(params)
    for name, (kind, say) in _IN_WORDS.items():
        if isinstance(value := params.get(name), kind):
            said[name] = say(value)
    return said


def refusal(reason: Refusal) -> str:
    """Return a reason against an action in the operator's language."""
    params = in_words(_with_figures(reason.code, _with_units(dict(reason.params))))
    if (field := params.get("field")) in DECLARED:
        params["field"] = setting_label(str(field)).text()
    source = source_of(reason.reason)
    return sentence("Refusal", source, params) if source else _unexpected(reason)


def why_not(reason: Refusal | None) -> str:
    """Return the same, or "" for ``None``."""
    return "" if reason is None else refusal(reason)


def why_ended(reason: Refusal | None) -> str:
    """Return why a run ended, or ""; in the past tense for a fault, which may be over by now."""
    if reason is not None and reason.reason == ARM_FAULT:
        return _REPORTED.text().format(status=arm.arm_status(int(reason.params["status"])))
    return why_not(reason)


def _unexpected(reason: Refusal) -> str:
    """Return a general sentence for a code that another package's adapter may have added."""
    source = QT_TRANSLATE_NOOP("Refusal", "Not possible now: {reason}.")
    return sentence("Refusal", source, {"reason": str(reason) or NOT_KNOWN})


def file_error(error: TrajectoryFileError) -> str:
    """Return the fault of a file in the operator's language.

    Args:
        error: The error; for a text without a file, as of the clipboard, no file is named.
    """
    reason = refusal(error.refusal)
    if error.line:
        named, bare = (_PLACE, _PLACE_ONLY) if error.column else (_LINE, _LINE_ONLY)
        source = named if error.file else bare
    elif error.file:
        source = _FILE
    else:
        return reason
    figures = {"file": error.file, "line": error.line, "column": error.column, "reason": reason}
    return sentence("FilePlace", source, figures)


def point_figure(name: str) -> str:
    """Return the name of a figure of a point: a key of ``program.RANGES``, or one of its texts."""
    return _FIGURES.word(name)


def _with_figures(code: str, params: dict[str, object]) -> dict[str, object]:
    """Return the parameters of a sentence about a point, with figures in the operator's words."""
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


def _with_units(params: dict[str, object]) -> dict[str, object]:
    """Return the parameters of a sentence about a setting, with its name and values in words."""
    name = params.get("parameter")
    if name is None:
        return params
    if not isinstance(name, str) or name not in KINDS:
        return params
    joint = params.get("joint")
    words = dict(params)
    words["parameter"] = full_name(Parameter(name, joint if isinstance(joint, int) else 0))
    for key in ("value", "held", "minimum", "maximum"):
        value = params.get(key)
        if isinstance(value, int | float):
            words[key] = value_text(name, value)
    return words
