"""Every quantity of the protocol, reported or commanded: its message, its unit, its rate."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JOINTS
from armui.telemetry.bus_senders import Sender
from armui.telemetry.series import Shape

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

FULL_HZ: Final = 200.0
"""The rate of the controller's and the motors' feedback; targets are streamed as fast."""
_SLOW_HZ: Final = 40.0
_BUS_HZ: Final = 10.0

BUS_SERIES: Final = "bus"

DRIVER_FAULTS: Final = (
    *("Undervoltage", "MotorOvertemperature", "Overcurrent", "DriverOvertemperature"),
    *("SensorFault", "DriverFault", "CollisionProtection", "StallProtection"),
)
"""The bits of ``driver_faults``, the first one worth 1; the same in both generations."""
GRIPPER_FAULTS: Final = DRIVER_FAULTS[:6]
"""The bits of ``gripper_faults``."""

_POSE_AXES: Final = ("x", "y", "z", "rx", "ry", "rz")

_POSES: Final = (("X", "Y"), ("Z", "RX"), ("RY", "RZ"))
_PAIRS: Final = ((1, 2), (3, 4), (5, 6))


class Source(enum.StrEnum):
    """The source of a quantity."""

    ARM = "arm"
    OWN = "own"
    OTHER = "other"
    BUS = "bus"


class Space(enum.Enum):
    """A kind of command of which only the newest one holds."""

    MOTION = enum.auto()
    GRIPPER = enum.auto()
    MODE = enum.auto()


@dataclass(frozen=True, slots=True)
class Field:
    """One signal of a message, or several bits of it as one code.

    Attributes:
        name: The name in the series.
        unit: The operator's unit.
        signals: Its signals in the DBC files; if several, they are bits, the first one worth 1.
        is_code: True for a whole number of 0–255 that every generation reports.
        is_angle: True for an angle, converted to degrees from the generation's unit.
    """

    name: str
    unit: str
    signals: tuple[str, ...]
    is_code: bool = False
    is_angle: bool = False


@dataclass(frozen=True, slots=True)
class Record:
    """A message whose signals are kept over time.

    Attributes:
        message: Its name in the DBC files.
        source: The source of the message.
        number: The joint it is about, if any.
        fields: The fields that are kept.
        common: True if it means the same in both generations.
        space: For a command, its kind.
    """

    message: str
    source: Source
    fields: tuple[Field, ...]
    rate_hz: float = FULL_HZ
    number: int | None = None
    common: bool = False
    space: Space | None = None

    @property
    def name(self) -> str:
        """The name of its series: the message's, with the source in front unless it is the arm."""
        return self.message if self.source is Source.ARM else f"{self.source}.{self.message}"

    @property
    def shape(self) -> Shape:
        """The figures, codes and rate that its series is made for."""
        figures = tuple(field.name for field in self.fields if not field.is_code)
        codes = tuple(field.name for field in self.fields if field.is_code)
        return Shape(self.name, self.rate_hz, figures, codes, held=self.space is not None)


@dataclass(frozen=True, slots=True)
class Quantity:
    """A quantity that can be drawn as a curve.

    Attributes:
        key: Its permanent name in layouts: ``arm.joint_angle.1``.
        kind: The kind of quantity, as ``joint_angle``.
        source: Its source.
        number: The joint's number, if it belongs to one.
        unit: The operator's unit; "" for codes.
        series, field: The series and the field that hold it.
        held: True for a command, which holds until the next one.
    """

    key: str
    kind: str
    source: Source
    number: int | None
    unit: str
    series: str
    field: str
    held: bool = False


def _figure(name: str, unit: str, signal: str, *, is_angle: bool = False) -> Field:
    return Field(name, unit, (signal,), is_angle=is_angle)


def _code(name: str, *signals: str) -> Field:
    return Field(name, "", signals, is_code=True)


TOOL_POSE: Final = Record(
    "ToolPose",
    Source.ARM,
    tuple(
        _figure(f"tool_{axis}", "°" if axis.startswith("r") else "mm", "") for axis in _POSE_AXES
    ),
)
"""The pose of the tool. No message has it: it is computed from the flange's pose while a tool is
set.
"""
_STATUS: Final = Record(
    "ArmStatus",
    Source.ARM,
    (
        _figure("speed_percent", "%", "SpeedPercent"),
        _figure("trajectory_point", "", "TrajectoryPoint"),
        Field("beyond_limit", "", tuple(f"J{n}LimitExceeded" for n in JOINTS)),
        Field("no_communication", "", tuple(f"J{n}CommunicationFault" for n in JOINTS)),
        _code("control_mode", "ControlMode"),
        _code("arm_status", "Status"),
        _code("move_mode", "MoveMode"),
        _code("teaching", "TeachingState"),
        _code("not_reached", "MotionState"),
    ),
    common=True,
)
_GRIPPER_FIGURES: Final = (
    _figure("gripper_opening", "mm", "Opening"),
    _figure("gripper_torque", "N·m", "Torque"),
    _figure("gripper_angle", "°", "Angle"),
    _figure("gripper_speed", "rad/s", "Speed"),
)
_GRIPPER: Final = Record(
    "GripperFeedback",
    Source.ARM,
    (
        *_GRIPPER_FIGURES,
        _code("gripper_faults", *GRIPPER_FAULTS),
        _code("gripper_enabled", "Enabled"),
    ),
)


def _pose_fields(pair: tuple[str, str]) -> tuple[Field, ...]:
    return tuple(
        _figure(f"pose_{axis.lower()}", "°" if axis.startswith("R") else "mm", axis)
        for axis in pair
    )


def _joint_fields(pair: tuple[int, int]) -> tuple[Field, ...]:
    return tuple(_figure(f"joint_angle.{joint}", "°", f"J{joint}") for joint in pair)


def _feedback() -> Iterator[Record]:
    for pair in _PAIRS:
        message = f"JointFeedback{pair[0]}{pair[1]}"
        yield Record(message, Source.ARM, _joint_fields(pair), common=True)
    for place, axes in enumerate(_POSES, 1):
        yield Record(f"EndPose{place}", Source.ARM, _pose_fields(axes), common=True)
    yield TOOL_POSE
    yield _STATUS
    yield _GRIPPER
    for joint in JOINTS:
        fast = (
            _figure("motor_speed", "°/s", "Speed", is_angle=True),
            _figure("motor_current", "A", "Current"),
            _figure("motor_position", "°", "Position", is_angle=True),
        )
        yield Record(f"DriverFast{joint}", Source.ARM, fast, number=joint)
    for joint in JOINTS:
        slow = (
            _figure("voltage", "V", "Voltage"),
            _figure("driver_temperature", "°C", "DriverTemperature"),
            _figure("motor_temperature", "°C", "MotorTemperature"),
            _figure("bus_current", "A", "BusCurrent"),
            _code("driver_faults", *DRIVER_FAULTS),
            _code("enabled", "Enabled"),
        )
        yield Record(f"DriverSlow{joint}", Source.ARM, slow, _SLOW_HZ, joint)
    for joint in JOINTS:
        end = (
            _figure("end_linear_speed", "m/s", "LinearSpeed"),
            _figure("end_angular_speed", "rad/s", "AngularSpeed"),
            _figure("end_linear_acceleration", "m/s²", "LinearAcceleration"),
            _figure("end_angular_acceleration", "rad/s²", "AngularAcceleration"),
        )
        yield Record(f"EndMotion{joint}", Source.ARM, end, number=joint)


def _commands(source: Source) -> Iterator[Record]:
    motion, full = Space.MOTION, FULL_HZ
    for pair in _PAIRS:
        message = f"JointTarget{pair[0]}{pair[1]}"
        yield Record(message, source, _joint_fields(pair), full, None, True, motion)
    for place, axes in enumerate(_POSES, 1):
        message = f"CartesianTarget{place}"
        yield Record(message, source, _pose_fields(axes), full, None, True, motion)
    yield Record("GripperCommand", source, _GRIPPER_FIGURES, space=Space.GRIPPER)
    mode = (_figure("speed_percent", "%", "SpeedPercent"), _figure("move_mode", "", "MoveMode"))
    yield Record("ModeControl", source, mode, common=True, space=Space.MODE)
    if source is Source.OTHER:  # this program commands no motor by itself
        for joint in JOINTS:
            mit = (
                _figure("mit_position", "°", "Position", is_angle=True),
                _figure("mit_speed", "°/s", "Velocity", is_angle=True),
                _figure("mit_torque", "N·m", "Torque"),
                _figure("mit_kp", "", "Kp"),
                _figure("mit_kd", "", "Kd"),
            )
            yield Record(f"MitControl{joint}", source, mit, full, joint, False, motion)


BUS: Final = Record(
    BUS_SERIES,
    Source.BUS,
    (
        _figure("frames_per_s", "1/s", ""),
        _figure("bus_load", "%", ""),
        _figure("error_frames_per_s", "1/s", ""),
    ),
    _BUS_HZ,
)
RECORDS: Final = (*_feedback(), *_commands(Source.OWN), *_commands(Source.OTHER), BUS)


def _quantities() -> Iterator[Quantity]:
    for record in RECORDS:
        for field in record.fields:
            kind, _, joint = field.name.partition(".")
            number = int(joint) if joint else record.number
            key = f"{record.source}.{kind}" + ("" if number is None else f".{number}")
            series = record.shape.name
            held = record.space is not None
            yield Quantity(key, kind, record.source, number, field.unit, series, field.name, held)


QUANTITIES: Final[Mapping[str, Quantity]] = {each.key: each for each in _quantities()}
"""All quantities by key, in the order of the list."""


_SOURCES: Final = {
    Sender.ARM: Source.ARM,
    Sender.OWN: Source.OWN,
    Sender.OTHER: Source.OTHER,
}


def quantity_key(sender: Sender, message: str, signal: str) -> str | None:
    """Return the key of a signal's quantity, or ``None`` if it is not kept."""
    source = _SOURCES.get(sender)
    return None if source is None else _keys().get((source, message, signal))


@cache
def _keys() -> Mapping[tuple[Source, str, str], str]:
    places = {(each.series, each.field): each.key for each in QUANTITIES.values()}
    return {
        (record.source, record.message, signal): places[record.name, field.name]
        for record in RECORDS
        for field in record.fields
        for signal in field.signals
        if signal
    }
