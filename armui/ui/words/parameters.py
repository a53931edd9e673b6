"""The parameters an arm keeps, in the words of the manual (sections 1.0.7.4–1.0.7.6)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.comparison import ComparisonVerdict
from armui.arm.parameters import KINDS, Parameter
from armui.control.parameters.setting_draft import CellStatus
from armui.ui.words.text import sentence

_NAMES: Final[Mapping[str, object]] = {
    "max_angle_deg": QT_TRANSLATE_NOOP("Parameter", "Max. angle"),
    "min_angle_deg": QT_TRANSLATE_NOOP("Parameter", "Min. angle"),
    "max_speed_deg_s": QT_TRANSLATE_NOOP("Parameter", "Max. speed"),
    "max_acceleration_deg_s2": QT_TRANSLATE_NOOP("Parameter", "Max. acceleration"),
    "max_linear_speed_m_s": QT_TRANSLATE_NOOP("Parameter", "Max. linear speed of the end"),
    "max_angular_speed_rad_s": QT_TRANSLATE_NOOP("Parameter", "Max. angular speed of the end"),
    "max_linear_acceleration_m_s2": QT_TRANSLATE_NOOP(
        "Parameter", "Max. linear acceleration of the end"
    ),
    "max_angular_acceleration_rad_s2": QT_TRANSLATE_NOOP(
        "Parameter", "Max. angular acceleration of the end"
    ),
    "collision_level": QT_TRANSLATE_NOOP("Parameter", "Collision level"),
    "drag_assistance": QT_TRANSLATE_NOOP("Parameter", "Drag assistance"),
    "teaching_range_percent": QT_TRANSLATE_NOOP("Parameter", "Teaching range"),
    "stroke_limit_mm": QT_TRANSLATE_NOOP("Parameter", "Gripper stroke limit"),
    "teaching_friction": QT_TRANSLATE_NOOP("Parameter", "Teaching friction"),
}

_STATUS: Final[Mapping[CellStatus, object]] = {
    CellStatus.NOT_READ: QT_TRANSLATE_NOOP("Parameter", "not read"),
    CellStatus.READING: QT_TRANSLATE_NOOP("Parameter", "reading…"),
    CellStatus.CORRUPT: QT_TRANSLATE_NOOP("Parameter", "corrupt"),
    CellStatus.SAVING: QT_TRANSLATE_NOOP("Parameter", "saving…"),
    CellStatus.SAVED: QT_TRANSLATE_NOOP("Parameter", "saved"),
    CellStatus.NOT_SAVED: QT_TRANSLATE_NOOP("Parameter", "not saved"),
    CellStatus.WRONG: QT_TRANSLATE_NOOP("Parameter", "not possible"),
}

_EXPLAINED: Final[Mapping[CellStatus, object]] = {
    CellStatus.NOT_READ: QT_TRANSLATE_NOOP("Parameter", "Not read from the arm."),
    CellStatus.READING: QT_TRANSLATE_NOOP("Parameter", "Being read from the arm."),
    CellStatus.CORRUPT: QT_TRANSLATE_NOOP(
        "Parameter",
        "What the arm holds here cannot be true: its memory is corrupt (0xFFFF). Enter a value and "
        "save it.",
    ),
    CellStatus.CHANGED: QT_TRANSLATE_NOOP(
        "Parameter", "Changed and not saved; the arm holds {held}."
    ),
    CellStatus.SAVING: QT_TRANSLATE_NOOP("Parameter", "Sent to the arm; its answer is awaited."),
    CellStatus.SAVED: QT_TRANSLATE_NOOP("Parameter", "Saved: the arm holds this value."),
}

_VERDICTS: Final[Mapping[ComparisonVerdict, object]] = {
    ComparisonVerdict.SAME: QT_TRANSLATE_NOOP("Parameter", "= the same"),
    ComparisonVerdict.DIFFERS: QT_TRANSLATE_NOOP("Parameter", "≠ differs"),
    ComparisonVerdict.ONLY_IN_FILE: QT_TRANSLATE_NOOP("Parameter", "only in the file"),
    ComparisonVerdict.ONLY_IN_ARM: QT_TRANSLATE_NOOP("Parameter", "only in the arm"),
    ComparisonVerdict.NOT_READ: QT_TRANSLATE_NOOP("Parameter", "not read from the arm"),
}


def parameter_name(name: str) -> str:
    """What a parameter is called: a key of ``parameters.KINDS``."""
    return sentence("Parameter", _NAMES[name], {})


def full_name(parameter: Parameter) -> str:
    """A parameter's name with its joint, if it belongs to one («J3 max. speed»)."""
    name = parameter_name(parameter.name)
    return f"J{parameter.joint} {name}" if parameter.joint else name


def value_text(name: str, value: float) -> str:
    """A value with as many decimals as it has a meaning, and its unit."""
    kind = KINDS[name]
    gap = "" if kind.unit.startswith("°") or not kind.unit else " "
    return f"{value:.{kind.decimals}f}{gap}{kind.unit}"


def status_word(status: CellStatus) -> str:
    """How a parameter stands, in a word or two; nothing where it is as the arm holds it."""
    source = _STATUS.get(status)
    return "" if source is None else sentence("Parameter", source, {})


def status_explained(status: CellStatus, held: str) -> str:
    """The same as a sentence; ``held`` is what the arm holds."""
    source = _EXPLAINED.get(status)
    return "" if source is None else sentence("Parameter", source, {"held": held})


def verdict_word(verdict: ComparisonVerdict) -> str:
    """How a parameter of a backup compares with the arm's."""
    return sentence("Parameter", _VERDICTS[verdict], {})


def span_text(name: str) -> str:
    """From which to which value a parameter can be set."""
    kind = KINDS[name]
    source = QT_TRANSLATE_NOOP("Parameter", "Possible: {minimum} to {maximum}")
    words = {"minimum": value_text(name, kind.minimum), "maximum": value_text(name, kind.maximum)}
    return sentence("Parameter", source, words)
