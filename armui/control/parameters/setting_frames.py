"""Encodes questions and settings of parameters as frames, and rounds values to frames."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from armui.arm.parameters import Batch, Group, Parameter
from armui.protocol import commands
from armui.protocol.codes import DEGREES_PER, SettingIndex

if TYPE_CHECKING:
    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame

INDEX: Final[Mapping[Group, SettingIndex]] = {
    Group.JOINT_LIMITS: SettingIndex.LIMIT_SETTING,
    Group.JOINT_ACCELERATION: SettingIndex.JOINT_SETTING,
    Group.END_LIMITS: SettingIndex.END_LIMIT_SETTING,
    Group.COLLISION: SettingIndex.COLLISION_SETTING,
    Group.TEACHING: SettingIndex.TEACHING_SETTING,
    Group.DRAG_ASSISTANCE: SettingIndex.DRAG_ASSISTANCE_SETTING,
}
"""The setting that 0x476 names in its answer, for each group."""

Values = Mapping[Parameter, float | None]
"""Values by parameter; ``None`` leaves one unchanged."""


def query_frames(codec: Codec, batch: Batch) -> list[Frame]:
    """Return the question that reads a batch."""
    match batch.group:
        case Group.JOINT_LIMITS:
            return commands.query_limits(codec, batch.joint)
        case Group.JOINT_ACCELERATION:
            return commands.query_acceleration(codec, batch.joint)
        case Group.END_LIMITS:
            return commands.query_end_limits(codec)
        case Group.COLLISION:
            return commands.query_collision_levels(codec)
        case Group.TEACHING:
            return commands.query_teaching(codec)
        case Group.DRAG_ASSISTANCE:
            return commands.query_drag_assistance(codec)


def setting_frames(codec: Codec, batch: Batch, values: Values) -> list[Frame]:
    """Return the frame that sets a batch.

    Args:
        codec: The arm's codec.
        batch: The batch to set.
        values: Every parameter of the batch, in the operator's units.
    """
    signals = {
        parameter.kind.signal.format(joint=parameter.joint): to_wire(codec, parameter, value)
        for parameter, value in values.items()
    }
    message = batch.parameters()[0].kind.message
    return commands.set_parameters(codec, message, signals, batch.joint)


def can_leave_unchanged(codec: Codec, batch: Batch) -> bool:
    """Return whether a batch's frame can leave out single values (0x7FFF, generation 2)."""
    first = batch.parameters()[0]
    signal = first.kind.signal.format(joint=first.joint)
    return codec.can_leave(first.kind.message, signal)


def to_wire(codec: Codec, parameter: Parameter, value: float | None) -> float | None:
    """Return a value in the unit of the frame, rounded to the frame's resolution."""
    if value is None:
        return None
    kind = parameter.kind
    signal = kind.signal.format(joint=parameter.joint)
    step = codec.step(kind.message, signal)
    return round(value / _factor(codec, parameter) / step) * step


def as_carried(codec: Codec, parameter: Parameter, value: float) -> float:
    """Return the nearest value that a frame can carry, in the operator's unit."""
    wire = to_wire(codec, parameter, value)
    return value if wire is None else wire * _factor(codec, parameter)


def step_of(codec: Codec, parameter: Parameter) -> float:
    """Return the smallest difference a frame can carry, in the operator's unit."""
    kind = parameter.kind
    signal = kind.signal.format(joint=parameter.joint)
    return codec.step(kind.message, signal) * _factor(codec, parameter)


def _factor(codec: Codec, parameter: Parameter) -> float:
    """Return how many of the operator's units one of the frame's is."""
    kind = parameter.kind
    if not kind.unit.startswith("°"):
        return 1.0
    return DEGREES_PER[codec.unit(kind.message, kind.signal.format(joint=parameter.joint))]
