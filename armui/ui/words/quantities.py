"""The names of what can be drawn as a curve, and its values in words."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.arm.limits import JOINTS
from armui.telemetry.quantities import DRIVER_FAULTS, GRIPPER_FAULTS, Source
from armui.ui import format as fmt
from armui.ui.words import status

if TYPE_CHECKING:
    from armui.telemetry.quantities import Quantity

_KINDS: Final[Mapping[str, object]] = {
    "joint_angle": QT_TRANSLATE_NOOP("Quantity", "angle"),
    "pose_x": QT_TRANSLATE_NOOP("Quantity", "End X"),
    "pose_y": QT_TRANSLATE_NOOP("Quantity", "End Y"),
    "pose_z": QT_TRANSLATE_NOOP("Quantity", "End Z"),
    "pose_rx": QT_TRANSLATE_NOOP("Quantity", "End RX"),
    "pose_ry": QT_TRANSLATE_NOOP("Quantity", "End RY"),
    "pose_rz": QT_TRANSLATE_NOOP("Quantity", "End RZ"),
    "speed_percent": QT_TRANSLATE_NOOP("Quantity", "Speed percentage"),
    "trajectory_point": QT_TRANSLATE_NOOP("Quantity", "Trajectory point"),
    "beyond_limit": QT_TRANSLATE_NOOP("Quantity", "Joints beyond limit"),
    "no_communication": QT_TRANSLATE_NOOP("Quantity", "Joints without communication"),
    "control_mode": QT_TRANSLATE_NOOP("Quantity", "Control mode"),
    "arm_status": QT_TRANSLATE_NOOP("Quantity", "Arm status"),
    "move_mode": QT_TRANSLATE_NOOP("Quantity", "Move mode"),
    "teaching": QT_TRANSLATE_NOOP("Quantity", "Teaching state"),
    "not_reached": QT_TRANSLATE_NOOP("Quantity", "Target not reached"),
    "gripper_opening": QT_TRANSLATE_NOOP("Quantity", "Gripper opening"),
    "gripper_torque": QT_TRANSLATE_NOOP("Quantity", "Gripper torque"),
    "gripper_angle": QT_TRANSLATE_NOOP("Quantity", "Gripper angle"),
    "gripper_speed": QT_TRANSLATE_NOOP("Quantity", "Gripper speed"),
    "gripper_faults": QT_TRANSLATE_NOOP("Quantity", "Gripper faults"),
    "gripper_enabled": QT_TRANSLATE_NOOP("Quantity", "Gripper enabled"),
    "motor_speed": QT_TRANSLATE_NOOP("Quantity", "motor speed"),
    "motor_current": QT_TRANSLATE_NOOP("Quantity", "motor current"),
    "motor_position": QT_TRANSLATE_NOOP("Quantity", "motor position"),
    "voltage": QT_TRANSLATE_NOOP("Quantity", "supply voltage"),
    "driver_temperature": QT_TRANSLATE_NOOP("Quantity", "driver temperature"),
    "motor_temperature": QT_TRANSLATE_NOOP("Quantity", "motor temperature"),
    "bus_current": QT_TRANSLATE_NOOP("Quantity", "supply current"),
    "driver_faults": QT_TRANSLATE_NOOP("Quantity", "driver faults"),
    "enabled": QT_TRANSLATE_NOOP("Quantity", "enabled"),
    "end_linear_speed": QT_TRANSLATE_NOOP("Quantity", "part in linear speed"),
    "end_angular_speed": QT_TRANSLATE_NOOP("Quantity", "part in angular speed"),
    "end_linear_acceleration": QT_TRANSLATE_NOOP("Quantity", "part in linear acceleration"),
    "end_angular_acceleration": QT_TRANSLATE_NOOP("Quantity", "part in angular acceleration"),
    "mit_position": QT_TRANSLATE_NOOP("Quantity", "MIT position"),
    "mit_speed": QT_TRANSLATE_NOOP("Quantity", "MIT speed"),
    "mit_torque": QT_TRANSLATE_NOOP("Quantity", "MIT torque"),
    "mit_kp": QT_TRANSLATE_NOOP("Quantity", "MIT kp"),
    "mit_kd": QT_TRANSLATE_NOOP("Quantity", "MIT kd"),
    "frames_per_s": QT_TRANSLATE_NOOP("Quantity", "Frames on the bus"),
    "bus_load": QT_TRANSLATE_NOOP("Quantity", "Bus load, without stuff bits"),
    "error_frames_per_s": QT_TRANSLATE_NOOP("Quantity", "Error frames"),
}
_SOURCES: Final[Mapping[Source, object]] = {
    Source.OWN: QT_TRANSLATE_NOOP("Quantity", "{name}, our command"),
    Source.OTHER: QT_TRANSLATE_NOOP("Quantity", "{name}, other host's command"),
}
_SHORT_SOURCES: Final[Mapping[Source, object]] = {
    Source.ARM: QT_TRANSLATE_NOOP("Quantity", "measured"),
    Source.OWN: QT_TRANSLATE_NOOP("Quantity", "our command"),
    Source.OTHER: QT_TRANSLATE_NOOP("Quantity", "other host's command"),
    Source.BUS: QT_TRANSLATE_NOOP("Quantity", "bus"),
}
_GROUPS: Final[Mapping[Source, object]] = {
    Source.ARM: QT_TRANSLATE_NOOP("Quantity", "Measured"),
    Source.OWN: QT_TRANSLATE_NOOP("Quantity", "Commanded by this program"),
    Source.OTHER: QT_TRANSLATE_NOOP("Quantity", "Commanded by other hosts"),
    Source.BUS: QT_TRANSLATE_NOOP("Quantity", "Bus"),
}
_FAULTS: Final[Mapping[str, object]] = {
    "Undervoltage": QT_TRANSLATE_NOOP("Quantity", "voltage too low"),
    "MotorOvertemperature": QT_TRANSLATE_NOOP("Quantity", "motor too hot"),
    "Overcurrent": QT_TRANSLATE_NOOP("Quantity", "overcurrent"),
    "DriverOvertemperature": QT_TRANSLATE_NOOP("Quantity", "driver too hot"),
    "SensorFault": QT_TRANSLATE_NOOP("Quantity", "sensor fault"),
    "DriverFault": QT_TRANSLATE_NOOP("Quantity", "driver error"),
    "CollisionProtection": QT_TRANSLATE_NOOP("Quantity", "collision protection"),
    "StallProtection": QT_TRANSLATE_NOOP("Quantity", "stall protection"),
}
_DECIMALS: Final[Mapping[str, int]] = {"°C": 0, "%": 1, "V": 1, "1/s": 0}


def quantity(what: Quantity) -> str:
    """Its name: «J1 角度»; a command says whose."""
    name = _translated(_KINDS[what.kind])
    if what.number is not None:
        name = f"J{what.number} {name}"
    if what.source in _SOURCES:
        return _translated(_SOURCES[what.source]).format(name=name)
    return name


def in_common(quantities: Sequence[Quantity]) -> tuple[str, list[str]]:
    """What several have in common, and what tells them apart: «电机温度», «J1», «J2» ….

    The first is "", and the others are whole names, where they have nothing in common.
    """
    first = quantities[0]
    several = len(quantities) > 1
    same_kind = len({(each.kind, each.source) for each in quantities}) == 1
    if several and same_kind and first.number is not None:
        return quantity_kind(first), [f"J{each.number}" for each in quantities]
    if several and len({(each.kind, each.number) for each in quantities}) == 1:
        name = _translated(_KINDS[first.kind])
        name = name if first.number is None else f"J{first.number} {name}"
        return name, [_translated(_SHORT_SOURCES[each.source]) for each in quantities]
    return "", [quantity(each) for each in quantities]


def quantity_group(source: Source) -> str:
    """Under which heading a list shows it."""
    return _translated(_GROUPS[source])


def quantity_kind(what: Quantity) -> str:
    """What the same quantity of several joints is called: «电机温度»; a command says whose."""
    name = _translated(_KINDS[what.kind])
    name = name[:1].upper() + name[1:]
    if what.source in _SOURCES:
        return _translated(_SOURCES[what.source]).format(name=name)
    return name


def quantity_value(what: Quantity, value: float | None) -> str:
    """A value with its unit, a code in its word; «—» where there is none."""
    if value is None or not math.isfinite(value):
        return fmt.NOTHING
    word = _code_word(what, int(value))
    if word is not None:
        return word
    if not what.unit:
        return fmt.number(value, 3 if what.kind.startswith("mit") else 0)
    figure = fmt.number(value, _DECIMALS.get(what.unit, fmt.DECIMALS))
    return f"{figure}{'' if what.unit == '°' else ' '}{what.unit}"


def quantity_difference(what: Quantity, difference: float | None) -> str:
    """How far apart two values are; codes have no difference."""
    if difference is None or not what.unit or not math.isfinite(difference):
        return fmt.NOTHING
    text = quantity_value(what, difference)
    return f"+{text}" if difference > 0 and not text.startswith("0.000") else text


def _code_word(what: Quantity, code: int) -> str | None:
    say = _CODES.get(what.kind)
    return None if say is None else say(code)


def _bits(code: int, names: list[str]) -> str:
    said = [name for place, name in enumerate(names) if code >> place & 1]
    return ", ".join(said) or QCoreApplication.translate("Quantity", "none")


def _translated(source: object) -> str:
    return QCoreApplication.translate("Quantity", str(source))


def _yes_or_no(code: int) -> str:
    yes = QCoreApplication.translate("Quantity", "yes")
    return yes if code else QCoreApplication.translate("Quantity", "no")


def _joints(code: int) -> str:
    return _bits(code, [f"J{joint}" for joint in JOINTS])


def _faults_of(names: tuple[str, ...]) -> Callable[[int], str]:
    return lambda code: _bits(code, [_translated(_FAULTS[name]) for name in names])


_CODES: Final[Mapping[str, Callable[[int], str]]] = {
    "control_mode": status.control_mode_short,
    "arm_status": status.arm_status,
    "move_mode": status.move_mode,
    "teaching": status.teaching,
    "not_reached": lambda code: status.reached(code == 0),
    "enabled": _yes_or_no,
    "gripper_enabled": _yes_or_no,
    "beyond_limit": _joints,
    "no_communication": _joints,
    "driver_faults": _faults_of(DRIVER_FAULTS),
    "gripper_faults": _faults_of(GRIPPER_FAULTS),
}
