"""The arm's state as last heard: a frozen snapshot, each value with its time of reception.

Nothing here is assumed: a value that has not been heard is ``None``. Times are those of
:data:`armui.system.clock.steady_s`; joints stand in tuples of six, joint 1 first.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Annotated, Final, Generic, NamedTuple, Self, TypeVar, cast

from armui.arm.arrivals import LATE_S
from armui.arm.limits import JOINTS, JointLimits
from armui.protocol.firmware_version import ArmIdentity, NamedVersion

T = TypeVar("T")
Six = tuple[T, T, T, T, T, T]

PAUSE_S: Final = 0.1
"""In either generation an arm sends about a hundred frames within this time."""
FRESH_FOR_S: Final = 0.5
"""A value older than this is stale; an arm silent for longer is offline."""

_ALIKE: Final = frozenset(
    {
        "epoch",
        "sequence",
        "last_feedback_s",
        "silences",
        "pauses",
        "status",
        "joints_deg",
        "in_time_since_s",
        "gap",
        "pose",
        "firmware",
        "identity",
        "version_heard_s",
        "versions_named",
        "status_heard_s",
        "foreign_targets_s",
        "frames",
        "oddities",
    }
)
"""Fields with the same meaning in both generations; all others differ in units or bits, or come
from frames that only one of them has.
"""


class GripperFault(enum.StrEnum):
    """A fault that the gripper's driver reports, named by its signal (generation 2)."""

    UNDERVOLTAGE = "Undervoltage"
    MOTOR_OVERTEMPERATURE = "MotorOvertemperature"
    OVERCURRENT = "Overcurrent"
    DRIVER_OVERTEMPERATURE = "DriverOvertemperature"
    SENSOR = "SensorFault"
    DRIVER = "DriverFault"


class GripperState(NamedTuple):
    """The content of 0x2A8.

    Attributes:
        opening_mm: The opening in generation 2; ``None`` in generation 1, and while an angle is
            reported.
        angle_deg: The angle in generation 1, and in generation 2 after an angle was commanded (from
            S-V1.8-8).
        enabled: True if its motor is enabled.
        torque_nm: The torque in generation 2; ``None`` in generation 1.
        speed_rad_s: The speed in generation 1; ``None`` in generation 2.
        homed: True if it knows its zero; ``None`` in generation 1, which does not say.
        faults: The faults; always empty in generation 1, which has no bits for them.
    """

    opening_mm: float | None
    angle_deg: float | None
    enabled: bool
    torque_nm: float | None = None
    speed_rad_s: float | None = None
    homed: bool | None = None
    faults: frozenset[GripperFault] = frozenset()

    @property
    def travel(self) -> float:
        """The opening or angle, in the unit of `unit`."""
        return (self.angle_deg if self.opening_mm is None else self.opening_mm) or 0.0

    @property
    def unit(self) -> str:
        """The unit of `travel`: mm or degrees."""
        return "°" if self.opening_mm is None else "mm"


def gripper_of(signals: Mapping[str, float]) -> GripperState:
    """Return the gripper's state from the signals of 0x2A8 of either generation."""
    homed = signals.get("Homed")
    return GripperState(
        opening_mm=signals.get("Opening"),
        angle_deg=signals.get("Angle"),
        enabled=signals["Enabled"] == 1,
        torque_nm=signals.get("Torque"),
        speed_rad_s=signals.get("Speed"),
        homed=None if homed is None else homed == 1,
        faults=frozenset(fault for fault in GripperFault if signals.get(fault) == 1),
    )


def is_fresh(at_s: float | None, now_s: float) -> bool:
    """Return whether a value heard at ``at_s`` is recent enough to count as present."""
    return at_s is not None and now_s - at_s <= FRESH_FOR_S


@dataclass(frozen=True, slots=True)
class Reading(Generic[T]):
    """A value and its time of reception.

    Attributes:
        value: The value in the operator's units.
        at_s: Monotonic time of its reception.
    """

    value: T
    at_s: float

    def fresh(self, now_s: float) -> bool:
        """Return whether the value is recent enough to count as present."""
        return is_fresh(self.at_s, now_s)


class Status(NamedTuple):
    """The content of 0x2A1; codes are those of the protocol table.

    Attributes:
        control_mode, arm_status, move_mode, teaching: The codes of bytes 0–3.
        reached: Byte 4: the target has been reached.
        speed_percent: Byte 5 in generation 1, ``None`` in generation 2.
        trajectory_point: Byte 5 in generation 2, ``None`` in generation 1.
        limit_exceeded: Joints beyond their angle limit (generation 2; else all false).
        communication_fault: Joints the controller cannot talk to.
    """

    control_mode: int
    arm_status: int
    move_mode: int
    teaching: int
    reached: bool
    speed_percent: int | None
    trajectory_point: int | None
    limit_exceeded: Six[bool]
    communication_fault: Six[bool]


class DriverFast(NamedTuple):
    """The content of 0x251–0x256 for one motor.

    Attributes:
        speed_deg_s: Motor speed.
        current_a: Motor current.
        position_deg: Motor position; ``None`` in generation 1, which counts encoder pulses.
    """

    speed_deg_s: float
    current_a: float
    position_deg: float | None


class DriverSlow(NamedTuple):
    """The content of 0x261–0x266 for one driver.

    A fault that the generation has no bit for is ``None``.
    """

    voltage_v: float
    driver_temperature_c: float
    motor_temperature_c: float
    bus_current_a: float
    undervoltage: bool
    motor_overtemperature: bool
    overcurrent: bool
    driver_overtemperature: bool
    driver_fault: bool
    enabled: bool
    sensor_fault: bool | None
    homed: bool | None
    collision_protection: bool | None
    stall_protection: bool | None

    @property
    def status_code(self) -> int:
        """Byte 5 as on the bus: the flags are its eight bits in both generations."""
        flags = (
            self.undervoltage,
            self.motor_overtemperature,
            self.overcurrent,
            self.driver_overtemperature,
            self.sensor_fault or self.collision_protection,
            self.driver_fault,
            self.enabled,
            self.homed or self.stall_protection,
        )
        return sum(1 << bit for bit, flag in enumerate(flags) if flag)


class EndLimits(NamedTuple):
    """The limits of the arm's end, 0x478."""

    max_linear_speed_m_s: Annotated[float, "MaxLinearSpeed"]
    max_angular_speed_rad_s: Annotated[float, "MaxAngularSpeed"]
    max_linear_acceleration_m_s2: Annotated[float, "MaxLinearAcceleration"]
    max_angular_acceleration_rad_s2: Annotated[float, "MaxAngularAcceleration"]


class TeachingHandleSettings(NamedTuple):
    """The settings of the teaching handle and the gripper in generation 2, 0x47E.

    Attributes:
        range_percent: The scale from the handle's travel to the gripper's, 100–200.
        stroke_limit_mm: 70 small gripper, 100 large gripper, 0 not set.
        friction: 1–10.
    """

    range_percent: Annotated[float, "TeachingRange"]
    stroke_limit_mm: Annotated[float, "StrokeLimit"]
    friction: Annotated[float, "Friction"]


class EndMotion(NamedTuple):
    """A joint's part in the motion of the end, 0x481–0x486; sent only while it is switched on."""

    linear_speed_m_s: Annotated[float, "LinearSpeed"]
    angular_speed_rad_s: Annotated[float, "AngularSpeed"]
    linear_acceleration_m_s2: Annotated[float, "LinearAcceleration"]
    angular_acceleration_rad_s2: Annotated[float, "AngularAcceleration"]


RECORDS: Final[Mapping[str, tuple[str, type]]] = {
    "EndLimitFeedback": ("end_limits", EndLimits),
    "TeachingFeedback": ("teaching_handle", TeachingHandleSettings),
}
"""Messages kept as whole records: the field of :class:`ArmState`, and the record's class."""


_NOTHING: Final = (None, None, None, None, None, None)
_NO_INVALID_FRAMES: Final[Mapping[str, int]] = MappingProxyType({})


class ArmState(NamedTuple):
    """Everything last heard from one arm.

    Attributes:
        epoch: The number of the last fresh start: everything in one state was heard and decoded
            since the bus thread was last told to start anew.
        sequence: Rises with everything new that is heard.
        last_feedback_s: The time of the last frame of the arm that was understood.
        silences: The number of times in this epoch that the arm was silent for longer than
            :data:`FRESH_FOR_S` and then heard again: it may be another arm, or one that was
            switched off and on.
        pauses: The number of times in this epoch that it was silent for longer than
            :data:`PAUSE_S`, silences among them: long enough to take another arm in its place, so
            it is asked who it is.
        joints_deg: Joint angles, 0x2A5–0x2A7.
        in_time_since_s: Since when all six have arrived in time (:mod:`armui.arm.arrivals`): no
            speed, and no standing still, is concluded from what was measured before.
        gap: For how long angles did not arrive the last time that this was a gap, and when it
            ended; ``None`` if there was none.
        pose: X, Y, Z in mm and RX, RY, RZ in degrees of the flange, 0x2A2–0x2A4.
        limits: Angle range and highest speed of each joint, 0x473.
        accelerations_deg_s2: Highest acceleration of each joint, 0x47C.
        end_limits: Highest speeds and accelerations of the end, 0x478.
        collision_levels: 0 (none) to 8 of each joint, 0x47B.
        drag_assistance: 0 (none) to 10 of each joint, 0x488; firmware from S-V1.8-1.
        teaching_handle: 0x47E, generation 2.
        end_motion: Each joint's part in the motion of the end, 0x481–0x486.
        firmware: Version text of 0x4AF; generation 1 has none.
        identity: The other data of the arm's answer.
        versions_named: The versions in its last answers, each with the time its text began.
        version_heard_s: When a part of an arm's answer to 0x4AF was last heard, readable or not.
        foreign_targets_s: When the joint targets of another sender, a teaching input or another
            host, were last heard in full (0x155–0x157, with any identifier offset).
        status_heard_s: When a status was heard under each identifier offset (0x470), whichever
            arm sent it.
        frames: The number of frames received since the bus was opened.
        invalid_frames: The number of frames not understood, by kind.
    """

    epoch: int = 0
    sequence: int = 0
    last_feedback_s: float | None = None
    silences: int = 0
    pauses: int = 0
    status: Reading[Status] | None = None
    joints_deg: Six[Reading[float] | None] = _NOTHING
    in_time_since_s: float = -math.inf
    gap: Reading[float] | None = None
    pose: Six[Reading[float] | None] = _NOTHING
    gripper: Reading[GripperState] | None = None
    drivers_fast: Six[Reading[DriverFast] | None] = _NOTHING
    drivers_slow: Six[Reading[DriverSlow] | None] = _NOTHING
    limits: Six[Reading[JointLimits] | None] = _NOTHING
    accelerations_deg_s2: Six[Reading[float] | None] = _NOTHING
    end_limits: Reading[EndLimits] | None = None
    collision_levels: Reading[Six[int]] | None = None
    drag_assistance: Reading[Six[int]] | None = None
    teaching_handle: Reading[TeachingHandleSettings] | None = None
    end_motion: Six[Reading[EndMotion] | None] = _NOTHING
    firmware: str | None = None
    identity: ArmIdentity | None = None
    versions_named: tuple[NamedVersion, ...] = ()
    version_heard_s: float | None = None
    status_heard_s: tuple[float | None, ...] = (None, None, None)
    foreign_targets_s: float | None = None
    frames: int = 0
    invalid_frames: Mapping[str, int] = _NO_INVALID_FRAMES

    def angles_deg(self) -> Six[float] | None:
        """Return six joint angles, or ``None`` while one of them has never been heard."""
        return _six_values(self.joints_deg)

    def in_time_for_s(self, now_s: float, since_s: float = -math.inf) -> float:
        """Return for how long the six angles have arrived in time, up to the last that did.

        Use this as the elapsed time where the arm is judged by something not happening in time: it
        is 0 while no angles arrive, and restarts after a gap.

        Args:
            now_s: Monotonic time.
            since_s: Only what arrived after this moment counts.
        """
        newest_s = math.inf
        for each in self.joints_deg:
            if each is None:
                return 0.0
            newest_s = min(newest_s, each.at_s)
        if now_s - newest_s > LATE_S:
            return 0.0
        return max(0.0, newest_s - max(since_s, self.in_time_since_s))

    def in_time(self, now_s: float) -> bool:
        """Return whether the last two reports of each angle arrived in time, and no gap is open."""
        return self.in_time_for_s(now_s) > 0.0

    def end_pose(self) -> Six[float] | None:
        """Return X, Y, Z in mm and RX, RY, RZ in degrees, or ``None`` while one is unknown.

        A pose whose frames have stopped while the joint angles still arrive does not count.
        """
        angle_s = max((each.at_s for each in self.joints_deg if each is not None), default=0.0)
        heard = all(each is None or is_fresh(each.at_s, angle_s) for each in self.pose)
        return _six_values(self.pose) if heard else None

    def enabled(self) -> Six[bool | None]:
        """Return whether each motor is enabled; ``None`` for a motor not heard yet."""
        a, b, c, d, e, f = (
            None if driver is None else driver.value.enabled for driver in self.drivers_slow
        )
        return (a, b, c, d, e, f)

    def joints_without_limits(self) -> list[int]:
        """Return the joints whose limits have not been read completely."""
        return [
            joint
            for joint in JOINTS
            if self.limits[joint - 1] is None or self.accelerations_deg_s2[joint - 1] is None
        ]


def _six_values(heard: Six[Reading[float] | None]) -> Six[float] | None:
    a, b, c, d, e, f = heard
    if a is None or b is None or c is None or d is None or e is None or f is None:
        return None
    return (a.value, b.value, c.value, d.value, e.value, f.value)


# The part of a state that means the same in both generations of the protocol.
#
# The frames of both share identifiers and lengths. Before it is known which one an arm speaks, what
# the other would read differently is not known at all.


_NOTHING_HEARD: Final = ArmState()
_UNKNOWN: Final = {
    name: value for name, value in _NOTHING_HEARD._asdict().items() if name not in _ALIKE
}


def common_to_generations(state: ArmState) -> ArmState:
    """Return a state reduced to the values that both generations encode alike.

    Angles, the pose, the modes of 0x2A1 and the signs that the arm is present are kept.
    """
    status = state.status
    if status is not None:
        neutral = status.value._replace(
            speed_percent=None, trajectory_point=None, limit_exceeded=(False,) * 6
        )
        status = replace(status, value=neutral)
    return state._replace(status=status, **_UNKNOWN)


class JointNumber(int):
    """The number of a joint, 1 to 6.

    A frame can hold any number; only a checked one can index a :class:`PerJoint`.

    Raises:
        ValueError: No joint has this number.
    """

    def __new__(cls, number: float) -> Self:
        """Return a number of a joint; other numbers than 1 to 6 raise a `ValueError`."""
        if number not in JOINTS:
            raise ValueError(f"no joint has the number {number:g}; they are 1 to 6")
        return super().__new__(cls, number)


EACH_JOINT: Final = tuple(map(JointNumber, JOINTS))


class PerJoint(Generic[T]):
    """One value for each joint, indexed by a checked number, so that no index counts from the end.

    Args:
        value: The initial value of each joint.
    """

    def __init__(self, value: T) -> None:
        self._values = [value] * len(JOINTS)

    def __setitem__(self, joint: JointNumber, value: T) -> None:
        self._values[joint - 1] = value

    def __iter__(self) -> Iterator[T]:
        return iter(self._values)

    def six(self) -> Six[T]:
        """Return the present values, joint 1 first."""
        return cast("Six[T]", tuple(self._values))
