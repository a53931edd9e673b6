"""The names of quantities that can be drawn as curves, and their values in words."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication

from armui.arm.limits import JOINTS
from armui.telemetry.quantities import DRIVER_FAULTS, GRIPPER_FAULTS, Source
from armui.ui import format as fmt
from armui.ui.words import arm
from armui.ui.words.text import Texts

if TYPE_CHECKING:
    from armui.telemetry.quantities import Quantity

_KINDS: Final = Texts("Quantity") | {
    "joint_angle": "angle",
    "pose_x": "End X",
    "pose_y": "End Y",
    "pose_z": "End Z",
    "pose_rx": "End RX",
    "pose_ry": "End RY",
    "pose_rz": "End RZ",
    "tool_x": "Tool centre point X",
    "tool_y": "Tool centre point Y",
    "tool_z": "Tool centre point Z",
    "tool_rx": "Tool centre point RX",
    "tool_ry": "Tool centre point RY",
    "tool_rz": "Tool centre point RZ",
    "speed_percent": "Speed percentage",
    "trajectory_point": "Trajectory point",
    "beyond_limit": "Joints beyond limit",
    "no_communication": "Joints without communication",
    "control_mode": "Control mode",
    "arm_status": "Arm status",
    "move_mode": "Move mode",
    "teaching": "Teaching state",
    "not_reached": "Target not reached",
    "gripper_opening": "Gripper opening",
    "gripper_torque": "Gripper torque",
    "gripper_angle": "Gripper angle",
    "gripper_speed": "Gripper speed",
    "gripper_faults": "Gripper faults",
    "gripper_enabled": "Gripper enabled",
    "motor_speed": "motor speed",
    "motor_current": "motor current",
    "motor_position": "motor position",
    "voltage": "supply voltage",
    "driver_temperature": "driver temperature",
    "motor_temperature": "motor temperature",
    "bus_current": "supply current",
    "driver_faults": "driver faults",
    "enabled": "enabled",
    "end_linear_speed": "part in linear speed",
    "end_angular_speed": "part in angular speed",
    "end_linear_acceleration": "part in linear acceleration",
    "end_angular_acceleration": "part in angular acceleration",
    "mit_position": "MIT position",
    "mit_speed": "MIT speed",
    "mit_torque": "MIT torque",
    "mit_kp": "MIT kp",
    "mit_kd": "MIT kd",
    "frames_per_s": "Frames on the bus",
    "bus_load": "Bus load, without stuff bits",
    "error_frames_per_s": "Error frames",
}
_SOURCES: Final = Texts("Quantity") | {
    Source.OWN: "{name}, our command",
    Source.OTHER: "{name}, other host's command",
}
_SHORT_SOURCES: Final = Texts("Quantity") | {
    Source.ARM: "measured",
    Source.OWN: "our command",
    Source.OTHER: "other host's command",
    Source.BUS: "bus",
}
_GROUPS: Final = Texts("Quantity") | {
    Source.ARM: "Measured",
    Source.OWN: "Commanded by this program",
    Source.OTHER: "Commanded by other hosts",
    Source.BUS: "Bus",
}
_FAULTS: Final = Texts("Quantity") | {
    "Undervoltage": "voltage too low",
    "MotorOvertemperature": "motor too hot",
    "Overcurrent": "overcurrent",
    "DriverOvertemperature": "driver too hot",
    "SensorFault": "sensor fault",
    "DriverFault": "driver error",
    "CollisionProtection": "collision protection",
    "StallProtection": "stall protection",
}
_DECIMALS: Final[Mapping[str, int]] = {"°C": 0, "%": 1, "V": 1, "1/s": 0}


def quantity(what: Quantity) -> str:
    """Return the name of a quantity: «J1 角度»; for a command with its source."""
    name = _KINDS.text(what.kind)
    if what.number is not None:
        name = f"J{what.number} {name}"
    if what.source in _SOURCES:
        return _SOURCES.text(what.source, {"name": name})
    return name


def in_common(quantities: Sequence[Quantity]) -> tuple[str, list[str]]:
    """Return the common part of several names, and their differences: «电机温度», «J1», «J2» ….

    If they have no common part, it is "", and the differences are the whole names.
    """
    first = quantities[0]
    several = len(quantities) > 1
    same_kind = len({(each.kind, each.source) for each in quantities}) == 1
    if several and same_kind and first.number is not None:
        return quantity_kind(first), [f"J{each.number}" for each in quantities]
    if several and len({(each.kind, each.number) for each in quantities}) == 1:
        name = _KINDS.text(first.kind)
        name = name if first.number is None else f"J{first.number} {name}"
        return name, [_SHORT_SOURCES.text(each.source) for each in quantities]
    return "", [quantity(each) for each in quantities]


def quantity_group(source: Source) -> str:
    """Return the heading of a source in a list."""
    return _GROUPS.text(source)


def quantity_kind(what: Quantity) -> str:
    """Return the name of a quantity without its joint: «电机温度»; for commands with the source."""
    name = _KINDS.text(what.kind)
    name = name[:1].upper() + name[1:]
    if what.source in _SOURCES:
        return _SOURCES.text(what.source, {"name": name})
    return name


def quantity_value(what: Quantity, value: float | None) -> str:
    """Return a value with its unit, or a code as its word; «—» without a value."""
    if value is None or not math.isfinite(value):
        return fmt.NOTHING
    word = _code_word(what, int(value))
    if word is not None:
        return word
    if not what.unit:
        return fmt.number(value, 3 if what.kind.startswith("mit") else 0)
    return fmt.with_unit(value, what.unit, _DECIMALS.get(what.unit, fmt.DECIMALS))


def quantity_difference(what: Quantity, difference: float | None) -> str:
    """Return the difference of two values as text; codes have none."""
    if difference is None or not what.unit or not math.isfinite(difference):
        return fmt.NOTHING
    text = quantity_value(what, difference)
    return f"+{text}" if difference > 0 and not text.startswith("0.000") else text


def _code_word(what: Quantity, code: int) -> str | None:
    say = _CODES.get(what.kind)
    return None if say is None else say(code)


def _bits(code: int, names: list[str]) -> str:
    said = [name for place, name in enumerate(names) if code >> place & 1]
    return fmt.listed(said) or QCoreApplication.translate("Quantity", "none")


def _yes_or_no(code: int) -> str:
    yes = QCoreApplication.translate("Quantity", "yes")
    return yes if code else QCoreApplication.translate("Quantity", "no")


def _joints(code: int) -> str:
    return _bits(code, [f"J{joint}" for joint in JOINTS])


def _faults_of(names: tuple[str, ...]) -> Callable[[int], str]:
    return lambda code: _bits(code, [_FAULTS.text(name) for name in names])


_CODES: Final[Mapping[str, Callable[[int], str]]] = {
    "control_mode": arm.control_mode_short,
    "arm_status": arm.arm_status,
    "move_mode": arm.move_mode,
    "teaching": arm.teaching,
    "not_reached": _yes_or_no,
    "enabled": _yes_or_no,
    "gripper_enabled": _yes_or_no,
    "beyond_limit": _joints,
    "no_communication": _joints,
    "driver_faults": _faults_of(DRIVER_FAULTS),
    "gripper_faults": _faults_of(GRIPPER_FAULTS),
}
