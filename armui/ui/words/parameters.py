"""The parameters an arm keeps, in the words of the manual (sections 1.0.7.4–1.0.7.6)."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.backup import ComparisonVerdict
from armui.arm.parameters import KINDS, Parameter
from armui.control.parameters.setting_draft import CellStatus
from armui.ui import format as fmt
from armui.ui.words.text import Texts, listed, sentence

_NAMES: Final = Texts("Parameter") | {
    "max_angle_deg": "Max. angle",
    "min_angle_deg": "Min. angle",
    "max_speed_deg_s": "Max. speed",
    "max_acceleration_deg_s2": "Max. acceleration",
    "max_linear_speed_m_s": "Max. linear speed of the end",
    "max_angular_speed_rad_s": "Max. angular speed of the end",
    "max_linear_acceleration_m_s2": "Max. linear acceleration of the end",
    "max_angular_acceleration_rad_s2": "Max. angular acceleration of the end",
    "collision_level": "Collision level",
    "drag_assistance": "Drag assistance",
    "teaching_range_percent": "Teaching range",
    "stroke_limit_mm": "Gripper stroke limit",
    "teaching_friction": "Teaching friction",
}

_MOST_NAMED: Final = 4
"""The most settings that a sentence names."""

_STATUS: Final = Texts("Parameter") | {
    CellStatus.NOT_READ: "not read",
    CellStatus.READING: "reading…",
    CellStatus.CORRUPT: "corrupt",
    CellStatus.SAVING: "saving…",
    CellStatus.SAVED: "saved",
    CellStatus.NOT_SAVED: "not saved",
    CellStatus.WRONG: "invalid",
}

_EXPLAINED: Final = Texts("Parameter") | {
    CellStatus.NOT_READ: "Not read from the arm.",
    CellStatus.READING: "Being read from the arm.",
    CellStatus.CORRUPT: (
        "The value stored in the arm cannot be right: its memory is corrupt (0xFFFF). Enter a "
        "value and save it."
    ),
    CellStatus.CHANGED: "Changed and not saved; the arm holds {held}.",
    CellStatus.SAVING: "Sent to the arm; its answer is awaited.",
    CellStatus.SAVED: "Saved: the arm holds this value.",
}

_VERDICTS: Final = Texts("Parameter") | {
    ComparisonVerdict.SAME: "= the same",
    ComparisonVerdict.DIFFERS: "≠ differs",
    ComparisonVerdict.ONLY_IN_FILE: "only in the file",
    ComparisonVerdict.ONLY_IN_ARM: "only in the arm",
    ComparisonVerdict.NOT_READ: "not read from the arm",
}


def parameter_name(name: str) -> str:
    """Return the name of a parameter: a key of ``parameters.KINDS``."""
    return _NAMES.text(name)


def full_name(parameter: Parameter) -> str:
    """Return a parameter's name with its joint, if it belongs to one («J3 max. speed»)."""
    name = parameter_name(parameter.name)
    return f"J{parameter.joint} {name}" if parameter.joint else name


def setting_names(settings: str) -> str:
    """Return the names of settings as a list; further ones than a few are only counted.

    Args:
        settings: ``max_speed.3 load.0``: each with its joint, 0 for none.
    """
    each = [name.rpartition(".") for name in settings.split()]
    names = [full_name(Parameter(name, int(joint))) for name, _, joint in each[:_MOST_NAMED]]
    more = [f"+{len(each) - _MOST_NAMED}"] if len(each) > _MOST_NAMED else []
    return listed([*names, *more])


def value_text(name: str, value: float) -> str:
    """Return a value with its decimals and its unit."""
    kind = KINDS[name]
    return fmt.with_unit(value, kind.unit, kind.decimals)


def status_word(status: CellStatus) -> str:
    """Return the state of a parameter in a word or two; empty if it is as in the arm."""
    return _STATUS.text(status) if status in _STATUS else ""


def status_explained(status: CellStatus, held: str) -> str:
    """Return the state as a sentence; ``held`` is the arm's value."""
    return _EXPLAINED.text(status, {"held": held}) if status in _EXPLAINED else ""


def verdict_word(verdict: ComparisonVerdict) -> str:
    """Return the result of comparing a parameter of a backup with the arm's."""
    return _VERDICTS.text(verdict)


def span_text(name: str) -> str:
    """Return the range of a parameter as text."""
    kind = KINDS[name]
    source = QT_TRANSLATE_NOOP("Parameter", "Range: {minimum} to {maximum}")
    words = {"minimum": value_text(name, kind.minimum), "maximum": value_text(name, kind.maximum)}
    return sentence("Parameter", source, words)


def beyond_word(name: str, bound: float) -> str:
    """Return in a word or two that a value exceeds the factory's."""
    source = QT_TRANSLATE_NOOP("Parameter", "factory {bound}")
    return sentence("Parameter", source, {"bound": f"{bound:.{KINDS[name].decimals}f}"})


def beyond_factory(parameter: Parameter, value: float, bound: float) -> str:
    """Return as a sentence that a value exceeds the factory's."""
    source = QT_TRANSLATE_NOOP("Parameter", "{name}: {value} goes beyond the factory's {bound}.")
    figures = {"value": value_text(parameter.name, value), "name": full_name(parameter)}
    figures["bound"] = value_text(parameter.name, bound)
    return sentence("Parameter", source, figures)


def beyond_danger() -> str:
    """Return the danger of such a value, shown before it is saved."""
    source = QT_TRANSLATE_NOOP(
        "Parameter",
        "The arm may then be driven against its mechanical stops or beyond what its motors are "
        "made for, and no check here prevents it. Save this only if you know that this arm can "
        "do it.",
    )
    return sentence("Parameter", source, {})
