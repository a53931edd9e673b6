"""The parameters an arm keeps: name, unit, range, and the frames that set and read them.

The panels, the backup file and the frames share this catalogue. Values are in the operator's units,
whatever the generation puts on the wire (manual sections 1.0.7.4–1.0.7.6; 0x473, 0x47C, 0x478,
0x47B, 0x47E, 0x488).
"""

from __future__ import annotations

import enum
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final, NamedTuple

from armui.arm.limits import JOINTS, plausible
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState, Reading, Six

if TYPE_CHECKING:
    from armui.arm.models import ModelData

SETTING_OUT_OF_RANGE = Reason(
    "setting_out_of_range",
    "{parameter}: {value} is out of range. Enter a value from {minimum} to {maximum}.",
)
SETTING_NO_CHOICE = Reason(
    "setting_no_choice", "{parameter}: {value} is not possible. Choose one of {choices}."
)
SETTING_NOT_A_NUMBER = Reason(
    "setting_not_a_number",
    "{parameter}: “{value}” is not a number. Enter a value from {minimum} to {maximum}.",
)

_MOST_ANGLE_DEG: Final = 360.0
_MOST_SPEED_DEG_S: Final = 360.0
_MOST_ACCELERATION_DEG_S2: Final = 1800.0
_MOST_END_LIMIT: Final = 32.766
"""One step below 0x7FFF, which means «leave it» in generation 2."""
_ANGLE_SLACK_DEG: Final = 0.05
"""Half the step of 0.1° in which frames carry angle limits (0x473, 0x474)."""
_RATE_SLACK: Final = 1.02
"""The rounding of a factory value to the coarse steps of generation 1 (rpm)."""
_CORRUPT_SPEED_DEG_S: Final = 3600.0
"""A speed far above any joint of this arm, below 0xFFFF in either generation's unit."""
_CORRUPT_ACCELERATION_DEG_S2: Final = 36_000.0
_CORRUPT_END_LIMIT: Final = 65.535


class Group(enum.Enum):
    """Parameters that one frame sets and one question reads."""

    JOINT_LIMITS = "joint_limits"
    """Limits of one joint: set by 0x474, asked for by 0x472, answered by 0x473."""
    JOINT_ACCELERATION = "joint_acceleration"
    """Acceleration of one joint: set by 0x475, asked for by 0x472, answered by 0x47C."""
    END_LIMITS = "end_limits"
    """Set by 0x479, asked for by 0x477, answered by 0x478."""
    COLLISION = "collision"
    """Set by 0x47A, asked for by 0x477, answered by 0x47B."""
    TEACHING = "teaching"
    """Set by 0x47D, asked for by 0x477, answered by 0x47E; generation 2."""
    DRAG_ASSISTANCE = "drag_assistance"
    """Set by 0x487, asked for by 0x477, answered by 0x488; generation 2, from S-V1.8-1."""


OF_ONE_JOINT: Final = frozenset({Group.JOINT_LIMITS, Group.JOINT_ACCELERATION})
"""Groups that exist once for each joint."""
_SIX_IN_ONE: Final = frozenset({Group.COLLISION, Group.DRAG_ASSISTANCE})
"""Groups whose single frame has a value for each joint."""


class Parameter(NamedTuple):
    """One value an arm keeps.

    Attributes:
        name: A key of :data:`KINDS`.
        joint: 1–6, or 0 for what belongs to the whole arm.
    """

    name: str
    joint: int = 0

    @property
    def kind(self) -> ParameterKind:
        """The properties that are the same for every joint."""
        return KINDS[self.name]

    @property
    def batch(self) -> Batch:
        """The parameters that one frame sets together with this one."""
        group = self.kind.group
        return Batch(group, self.joint if group in OF_ONE_JOINT else 0)


class Batch(NamedTuple):
    """The parameters that one frame sets: a group, and the joint if each joint has its own."""

    group: Group
    joint: int = 0

    def parameters(self) -> tuple[Parameter, ...]:
        """Return its parameters, in the order of the frame."""
        names = [name for name, kind in KINDS.items() if kind.group is self.group]
        if self.group in _SIX_IN_ONE:
            return tuple(Parameter(names[0], joint) for joint in JOINTS)
        return tuple(Parameter(name, self.joint) for name in names)


@dataclass(frozen=True, slots=True)
class ParameterKind:
    """The properties of a parameter.

    Attributes:
        group: The parameters it is set and read with.
        message, signal: The message and signal that set it; the signal that reads it has the same
            name. ``{joint}`` in it stands for the joint.
        unit: The operator's unit.
        minimum, maximum: The range that may be requested. The arm may keep less: it is read back.
        decimals: The decimals shown to the operator.
        choices: All legal values, if they are few.
        corrupt_from: A value from here on can only come from a corrupted memory, read as 0xFFFF.
        read: Returns the value from the arm's state.
    """

    group: Group
    message: str
    signal: str
    unit: str
    minimum: float
    maximum: float
    decimals: int
    read: Callable[[ArmState, int], Reading[float] | None]
    choices: tuple[float, ...] = ()
    corrupt_from: float = math.inf


def _joint_limit(field: str) -> Callable[[ArmState, int], Reading[float] | None]:
    return lambda state, joint: _field(state.limits[joint - 1], field)


def _end_limit(signal: str, field: str, unit: str) -> ParameterKind:
    return ParameterKind(
        Group.END_LIMITS,
        "EndLimitSetting",
        signal,
        unit,
        0.001,
        _MOST_END_LIMIT,
        3,
        lambda state, _joint: _field(state.end_limits, field),
        corrupt_from=_CORRUPT_END_LIMIT,
    )


def _teaching(
    field: str, signal: str, unit: str, span: tuple[float, float], *choices: float
) -> ParameterKind:
    return ParameterKind(
        Group.TEACHING,
        "TeachingSetting",
        signal,
        unit,
        *span,
        0,
        lambda state, _joint: _field(state.teaching_handle, field),
        choices,
        corrupt_from=span[1] + 1,
    )


def _field(heard: Reading[Any] | None, field: str) -> Reading[float] | None:
    return None if heard is None else Reading(float(getattr(heard.value, field)), heard.at_s)


def _of_joint(heard: Reading[Six[int]] | None, joint: int) -> Reading[float] | None:
    return None if heard is None else Reading(float(heard.value[joint - 1]), heard.at_s)


KINDS: Final[Mapping[str, ParameterKind]] = {
    "max_angle_deg": ParameterKind(
        Group.JOINT_LIMITS,
        "LimitSetting",
        "MaxAngle",
        "°",
        -_MOST_ANGLE_DEG,
        _MOST_ANGLE_DEG,
        1,
        _joint_limit("max_deg"),
    ),
    "min_angle_deg": ParameterKind(
        Group.JOINT_LIMITS,
        "LimitSetting",
        "MinAngle",
        "°",
        -_MOST_ANGLE_DEG,
        _MOST_ANGLE_DEG,
        1,
        _joint_limit("min_deg"),
    ),
    "max_speed_deg_s": ParameterKind(
        Group.JOINT_LIMITS,
        "LimitSetting",
        "MaxSpeed",
        "°/s",
        0.1,
        _MOST_SPEED_DEG_S,
        1,
        _joint_limit("max_speed_deg_s"),
        corrupt_from=_CORRUPT_SPEED_DEG_S,
    ),
    "max_acceleration_deg_s2": ParameterKind(
        Group.JOINT_ACCELERATION,
        "JointSetting",
        "MaxAcceleration",
        "°/s²",
        0.1,
        _MOST_ACCELERATION_DEG_S2,
        1,
        lambda state, joint: state.accelerations_deg_s2[joint - 1],
        corrupt_from=_CORRUPT_ACCELERATION_DEG_S2,
    ),
    "max_linear_speed_m_s": _end_limit("MaxLinearSpeed", "max_linear_speed_m_s", "m/s"),
    "max_angular_speed_rad_s": _end_limit("MaxAngularSpeed", "max_angular_speed_rad_s", "rad/s"),
    "max_linear_acceleration_m_s2": _end_limit(
        "MaxLinearAcceleration", "max_linear_acceleration_m_s2", "m/s²"
    ),
    "max_angular_acceleration_rad_s2": _end_limit(
        "MaxAngularAcceleration", "max_angular_acceleration_rad_s2", "rad/s²"
    ),
    "collision_level": ParameterKind(
        Group.COLLISION,
        "CollisionSetting",
        "J{joint}",
        "",
        0,
        8,
        0,
        lambda state, joint: _of_joint(state.collision_levels, joint),
        corrupt_from=9,
    ),
    "drag_assistance": ParameterKind(
        Group.DRAG_ASSISTANCE,
        "DragAssistanceSetting",
        "J{joint}",
        "",
        0,
        10,
        0,
        lambda state, joint: _of_joint(state.drag_assistance, joint),
        corrupt_from=11,
    ),
    "teaching_range_percent": _teaching("range_percent", "TeachingRange", "%", (100, 200)),
    "stroke_limit_mm": _teaching("stroke_limit_mm", "StrokeLimit", "mm", (0, 100), 0, 70, 100),
    "teaching_friction": _teaching("friction", "Friction", "", (1, 10)),
}
"""Every parameter by name; those of one group in the order of its frame."""


def all_batches(*, teaching: bool, drag_assistance: bool) -> Iterator[Batch]:
    """Yield every batch of parameters that a backup holds.

    Args:
        teaching: Include the teaching handle's (generation 2).
        drag_assistance: Include the drag assistance (from S-V1.8-1).
    """
    for group in (Group.JOINT_LIMITS, Group.JOINT_ACCELERATION):
        yield from (Batch(group, joint) for joint in JOINTS)
    yield Batch(Group.END_LIMITS)
    yield Batch(Group.COLLISION)
    if drag_assistance:
        yield Batch(Group.DRAG_ASSISTANCE)
    if teaching:
        yield Batch(Group.TEACHING)


def reading_of(state: ArmState, parameter: Parameter) -> Reading[float] | None:
    """Return a parameter's value as last read from the arm, or ``None`` if it has not been read."""
    return parameter.kind.read(state, parameter.joint)


def is_corrupt(state: ArmState, parameter: Parameter) -> bool:
    """Return whether the value read can only come from a corrupted memory (0xFFFF)."""
    known = reading_of(state, parameter)
    if known is None:
        return False
    if parameter.kind.group is Group.JOINT_LIMITS and parameter.kind.unit == "°":
        limits = state.limits[parameter.joint - 1]
        return limits is not None and not plausible(limits.value)
    return known.value >= parameter.kind.corrupt_from


def check_value(parameter: Parameter, value: float) -> Refusal | None:
    """Return why a value may not be requested, or ``None`` if it may."""
    kind = parameter.kind
    if not math.isfinite(value):
        return not_a_number(parameter, str(value))
    figures = _figures(parameter, value)
    if not kind.minimum <= value <= kind.maximum:
        return SETTING_OUT_OF_RANGE(**figures)
    if kind.choices and value not in kind.choices:
        choices = ", ".join(f"{choice:g}" for choice in kind.choices)
        return SETTING_NO_CHOICE(**(figures | {"choices": choices}))
    return None


def factory_bound(parameter: Parameter, value: float, data: ModelData) -> float | None:
    """Return the factory limit that a value exceeds on this model, or ``None``.

    The factory's angle range is also the range that the mechanics are known to allow.

    Args:
        parameter: The parameter.
        value: In the operator's unit.
        data: The model's data.
    """
    if parameter.joint not in JOINTS:
        return None
    limits = data.limits[parameter.joint - 1]
    if parameter.kind.group is Group.JOINT_LIMITS and parameter.kind.unit == "°":
        if value > limits.max_deg + _ANGLE_SLACK_DEG:
            return limits.max_deg
        return limits.min_deg if value < limits.min_deg - _ANGLE_SLACK_DEG else None
    bounds = {
        "max_speed_deg_s": limits.max_speed_deg_s,
        "max_acceleration_deg_s2": data.accelerations_deg_s2[parameter.joint - 1],
    }
    bound = bounds.get(parameter.name)
    return bound if bound is not None and value > bound * _RATE_SLACK else None


def not_a_number(parameter: Parameter, text: str) -> Refusal:
    """Return the refusal of a text that was typed for a parameter and is no number."""
    return SETTING_NOT_A_NUMBER(**_figures(parameter, text))


def _figures(parameter: Parameter, value: float | str) -> dict[str, float | int | str]:
    kind = parameter.kind
    return {
        "parameter": parameter.name,
        "joint": parameter.joint,
        "value": value,
        "minimum": kind.minimum,
        "maximum": kind.maximum,
    }
