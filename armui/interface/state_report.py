"""The arm's measured values for clients, each with its age. Pure."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from enum import IntEnum
from typing import Any, Final

from armui.arm.state import FRESH_FOR_S, ArmState, GripperState, Reading
from armui.interface.messages import Json
from armui.protocol import codes

_DIGITS: Final = 4


def _six(readings: Sequence[Reading[Any] | None], now_s: float, of: Callable[[Any], Any]) -> Json:
    values = [None if each is None else _rounded(of(each.value)) for each in readings]
    ages = [None if each is None else now_s - each.at_s for each in readings]
    known = [age for age in ages if age is not None]
    oldest = max(known) if len(known) == len(ages) else None
    return _aged(values, oldest)


def _one(reading: Reading[Any] | None, now_s: float, value: object) -> Json:
    return _aged(value, None if reading is None else now_s - reading.at_s)


def _aged(value: object, age_s: float | None) -> Json:
    """Return a value with its age; ``fresh`` is false where it is older than half a second."""
    age = None if age_s is None else round(max(0.0, age_s), _DIGITS)
    return {"value": value, "age_s": age, "fresh": age is not None and age <= FRESH_FOR_S}


def _rounded(value: object) -> object:
    return round(value, _DIGITS) if isinstance(value, float) else value


def _same(value: object) -> object:
    return value


def _code(kind: type[IntEnum], code: int) -> str | int:
    try:
        return kind(code).name.lower()
    except ValueError:
        return code  # a code that is in no table is passed on as its number


def _status(state: ArmState, now_s: float) -> Json:
    reading = state.status
    if reading is None:
        return _one(None, now_s, None)
    heard = reading.value
    value = {
        "control_mode": _code(codes.ControlMode, heard.control_mode),
        "arm_status": _code(codes.ArmStatusCode, heard.arm_status),
        "move_mode": _code(codes.MoveMode, heard.move_mode),
        "reached": heard.reached,
        "joints_beyond_limits": _numbers(heard.limit_exceeded),
        "joints_without_communication": _numbers(heard.communication_fault),
    }
    return _one(reading, now_s, value)


def _numbers(flags: Sequence[bool]) -> list[int]:
    return [joint for joint, on in enumerate(flags, start=1) if on]


def _gripper(state: ArmState, now_s: float, of: Callable[[GripperState], Any]) -> Json:
    reading = state.gripper
    return _one(reading, now_s, None if reading is None else _rounded(of(reading.value)))


FIELDS: Final[Mapping[str, Callable[[ArmState, float], Json]]] = {
    "joints_deg": lambda state, now_s: _six(state.joints_deg, now_s, _same),
    "flange_pose_mm_deg": lambda state, now_s: _six(state.pose, now_s, _same),
    "joint_speeds_deg_s": lambda state, now_s: _six(
        state.drivers_fast, now_s, lambda fast: fast.speed_deg_s
    ),
    "joint_currents_a": lambda state, now_s: _six(
        state.drivers_fast, now_s, lambda fast: fast.current_a
    ),
    "motor_temperatures_c": lambda state, now_s: _six(
        state.drivers_slow, now_s, lambda slow: slow.motor_temperature_c
    ),
    "driver_temperatures_c": lambda state, now_s: _six(
        state.drivers_slow, now_s, lambda slow: slow.driver_temperature_c
    ),
    "supply_v": lambda state, now_s: _six(state.drivers_slow, now_s, lambda slow: slow.voltage_v),
    "enabled": lambda state, now_s: _six(state.drivers_slow, now_s, lambda slow: slow.enabled),
    "gripper_mm": lambda state, now_s: _gripper(state, now_s, lambda each: each.opening_mm),
    "gripper_deg": lambda state, now_s: _gripper(state, now_s, lambda each: each.angle_deg),
    "gripper_torque_nm": lambda state, now_s: _gripper(state, now_s, lambda each: each.torque_nm),
    "gripper_enabled": lambda state, now_s: _gripper(state, now_s, lambda each: each.enabled),
    "status": _status,
}
"""What can be asked for: each value with its age; the names carry the units."""


def fields_of(wanted: Sequence[str] | None) -> tuple[str, ...]:
    """Return the fields that a call names, each once; all if it names none."""
    return tuple(FIELDS) if wanted is None else tuple(dict.fromkeys(wanted))


def report(state: ArmState, now_s: float, fields: Sequence[str] = tuple(FIELDS)) -> Json:
    """Return the values with their ages.

    Args:
        state: The state of the arm.
        now_s: Monotonic time.
        fields: Keys of :data:`FIELDS`.
    """
    return {
        "sequence": state.sequence,
        "measured": {name: FIELDS[name](state, now_s) for name in fields},
    }
