"""Collects the frames of one arm into its state, and makes frozen snapshots of it.

One tracker follows one arm. One thread feeds it; the snapshots may be read by any thread.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, Final

from armui.arm.arrivals import Arrivals
from armui.arm.limits import JOINTS, JointLimits
from armui.arm.state import (
    EACH_JOINT,
    FRESH_FOR_S,
    PAUSE_S,
    RECORDS,
    ArmState,
    DriverFast,
    DriverSlow,
    EndMotion,
    GripperState,
    JointNumber,
    PerJoint,
    Reading,
    Six,
    Status,
    gripper_of,
)
from armui.protocol.addressing import OFFSETS
from armui.protocol.codec import Codec, InvalidFrame, InvalidFrameKind, Message
from armui.protocol.codes import DEGREES_PER
from armui.protocol.firmware_version import AnswerCollector, is_question
from armui.protocol.message_fields import record_reader

_Signals = Mapping[str, float]

_TARGET_MESSAGES: Final = ("JointTarget12", "JointTarget34", "JointTarget56")
_TARGET_PLACES: Final = {
    target_id + offset: place
    for offset in OFFSETS
    for place, target_id in enumerate(range(0x155, 0x158))
}
"""The index in the list of joint targets, by identifier, for every identifier offset (0x470)."""

_ANGLE_MESSAGES: Final = frozenset({"JointFeedback12", "JointFeedback34", "JointFeedback56"})
_FASTEST_DEG_S: Final = 300.0
"""A speed that no joint of the family reaches."""
_JUMP_DEG: Final = 5.0
_NEW_ZERO_DEG: Final = 0.5
"""An angle that jumps to within this of zero is the same arm's: a zero was set."""

_STATUS_ID: Final = 0x2A1
_VERSION_MESSAGE: Final = "FirmwareVersion"


class Tracker:
    """Collects decoded frames and makes an :class:`ArmState` of them on demand.

    Args:
        codec: The arm's codec.
        epoch: The epoch of its states; see :class:`ArmState`.
    """

    def __init__(self, codec: Codec, epoch: int = 0) -> None:
        self._codec = codec
        self._epoch = epoch
        self._sequence = 0
        self._published = 0
        self._picture = ArmState(epoch=epoch)
        self._frames = 0
        self._invalid_frames: Counter[str] = Counter()
        self._last_feedback_s: float | None = None
        self._status: Reading[Status] | None = None
        self._gripper: Reading[GripperState] | None = None
        self._joints: list[Reading[float] | None] = [None] * 6
        self._arrivals = [Arrivals() for _ in _ANGLE_MESSAGES]
        self._pose: list[Reading[float] | None] = [None] * 6
        self._drivers_fast = PerJoint[Reading[DriverFast] | None](None)
        self._drivers_slow = PerJoint[Reading[DriverSlow] | None](None)
        self._limits = PerJoint[Reading[JointLimits] | None](None)
        self._accelerations = PerJoint[Reading[float] | None](None)
        self._levels: dict[str, Reading[Six[int]]] = {}
        self._records: dict[str, Reading[Any]] = {}
        self._end_motion = PerJoint[Reading[EndMotion] | None](None)
        self._answer = AnswerCollector()
        self._version_heard_s: float | None = None
        self._silences = self._pauses = 0
        self._before_pause: list[Reading[float] | None] = []
        self._foreign_targets_s: list[float | None] = [None] * len(_TARGET_MESSAGES)
        self._status_heard_s: list[float | None] = [None] * len(OFFSETS)
        self._handlers = self._make_handlers()

    def update(self, heard: Message | InvalidFrame, at_s: float) -> None:
        """Add one decoded frame, received at monotonic time ``at_s``."""
        self._frames += 1
        self._sequence += 1
        if isinstance(heard, InvalidFrame):
            self._invalid_frames[heard.kind.name] += 1
            if heard.message is None:
                self._note_status(heard.arbitration_id - _STATUS_ID, at_s)
                self._note_foreign_target(_TARGET_PLACES.get(heard.arbitration_id), at_s)
                return
            heard = heard.message
        handler = self._handlers.get(heard.name)
        if handler is not None and not _is_asked_by_a_host(heard):
            if self._last_feedback_s is not None and at_s - self._last_feedback_s > PAUSE_S:
                self._pauses += 1
                self._silences += at_s - self._last_feedback_s > FRESH_FOR_S
                self._before_pause = list(self._joints)
            handler(heard.signals, at_s)
            self._last_feedback_s = at_s
            if self._before_pause and heard.name in _ANGLE_MESSAGES:
                self._look_for_another_arm()
        elif heard.name in _TARGET_MESSAGES:
            self._note_foreign_target(_TARGET_MESSAGES.index(heard.name), at_s)

    def count_invalid(self, kind: InvalidFrameKind) -> None:
        """Count a received frame as not understood."""
        self._invalid_frames[kind.name] += 1
        self._sequence += 1

    def reset_timeouts(self) -> None:
        """Reset the counts of silences, after frames were read from a log out of their time."""
        self._silences = self._pauses = 0
        self._before_pause = []
        for each in self._arrivals:
            each.forget()
        self._sequence += 1

    def _look_for_another_arm(self) -> None:
        """Count a pause as a silence if no joint of one arm could have come as far in it."""
        pairs = [
            (before, now)
            for before, now in zip(self._before_pause, self._joints, strict=True)
            if before is not None and now is not None and now.at_s > before.at_s
        ]
        if any(
            abs(now.value) > _NEW_ZERO_DEG
            and abs(now.value - before.value)
            > _JUMP_DEG + _FASTEST_DEG_S * (now.at_s - before.at_s)
            for before, now in pairs
        ):
            self._silences += 1
            self._before_pause = []
        elif len(pairs) == len(JOINTS):
            self._before_pause = []

    def snapshot(self) -> ArmState:
        """Return the arm's state up to now; the same object as before if nothing new was heard."""
        if self._published != self._sequence:
            self._published = self._sequence
            self._picture = self._compose()
        return self._picture

    def _compose(self) -> ArmState:
        return ArmState(
            epoch=self._epoch,
            sequence=self._sequence,
            silences=self._silences,
            pauses=self._pauses,
            last_feedback_s=self._last_feedback_s,
            status=self._status,
            joints_deg=_six(self._joints),
            in_time_since_s=max(each.since_s for each in self._arrivals),
            gap=self._last_gap(),
            pose=_six(self._pose),
            gripper=self._gripper,
            drivers_fast=self._drivers_fast.six(),
            drivers_slow=self._drivers_slow.six(),
            limits=self._limits.six(),
            accelerations_deg_s2=self._accelerations.six(),
            collision_levels=self._levels.get("CollisionFeedback"),
            drag_assistance=self._levels.get("DragAssistanceFeedback"),
            end_motion=self._end_motion.six(),
            firmware=None if self._answer.identity is None else self._answer.identity.software,
            identity=self._answer.identity,
            versions_named=self._answer.named,
            version_heard_s=self._version_heard_s,
            status_heard_s=tuple(self._status_heard_s),
            foreign_targets_s=self._all_targets_s(),
            frames=self._frames,
            invalid_frames=MappingProxyType(dict(self._invalid_frames)),
            **self._records,
        )

    # The effect of each message ---------------------------------------------------------------

    def _make_handlers(self) -> dict[str, Callable[[_Signals, float], None]]:
        handlers: dict[str, Callable[[_Signals, float], None]] = {
            "ArmStatus": self._on_status,
            "GripperFeedback": self._on_gripper,
            "LimitFeedback": self._on_limits,
            "AccelerationFeedback": self._on_acceleration,
            "CollisionFeedback": self._levels_handler("CollisionFeedback"),
            "DragAssistanceFeedback": self._levels_handler("DragAssistanceFeedback"),
            "FirmwareVersion": self._on_firmware,
            "JointFeedback12": self._angles_handler(0, "J1", "J2"),
            "JointFeedback34": self._angles_handler(2, "J3", "J4"),
            "JointFeedback56": self._angles_handler(4, "J5", "J6"),
            "EndPose1": _pair(self._pose, 0, "X", "Y"),
            "EndPose2": _pair(self._pose, 2, "Z", "RX"),
            "EndPose3": _pair(self._pose, 4, "RY", "RZ"),
        }
        for message, (field, record) in RECORDS.items():
            handlers[message] = self._record_handler(field, record)
        for joint in EACH_JOINT:
            handlers[f"DriverFast{joint}"] = self._driver_fast_handler(joint)
            handlers[f"DriverSlow{joint}"] = self._driver_slow_handler(joint)
            handlers[f"EndMotion{joint}"] = self._end_motion_handler(joint)
        return handlers

    def _angles_handler(
        self, index: int, first: str, second: str
    ) -> Callable[[_Signals, float], None]:
        on_pair = _pair(self._joints, index, first, second)
        arrivals = self._arrivals[index // 2]

        def on_angles(signals: _Signals, at_s: float) -> None:
            arrivals.note(at_s)
            on_pair(signals, at_s)

        return on_angles

    def _last_gap(self) -> Reading[float] | None:
        """Return the length of the last gap in the angles, and when it ended."""
        last = max(self._arrivals, key=lambda each: each.gap_ended_s)
        return Reading(last.gap_s, last.gap_ended_s) if last.gap_s else None

    def _note_status(self, offset: int, at_s: float) -> None:
        if offset in OFFSETS:
            self._status_heard_s[OFFSETS.index(offset)] = at_s

    def _note_foreign_target(self, place: int | None, at_s: float) -> None:
        if place is not None:
            self._foreign_targets_s[place] = at_s

    def _all_targets_s(self) -> float | None:
        """Return when the oldest of the three targets was heard; one alone may be a stray frame."""
        times = [at_s for at_s in self._foreign_targets_s if at_s is not None]
        return min(times) if len(times) == len(_TARGET_MESSAGES) else None

    def _on_status(self, signals: _Signals, at_s: float) -> None:
        status = Status(
            control_mode=int(signals["ControlMode"]),
            arm_status=int(signals["Status"]),
            move_mode=int(signals["MoveMode"]),
            teaching=int(signals["TeachingState"]),
            reached=signals["MotionState"] == 0,
            speed_percent=_whole(signals.get("SpeedPercent")),
            trajectory_point=_whole(signals.get("TrajectoryPoint")),
            limit_exceeded=_joint_flags(signals, "LimitExceeded"),
            communication_fault=_joint_flags(signals, "CommunicationFault"),
        )
        self._status = Reading(status, at_s)
        self._note_status(self._codec.addressing.feedback_offset, at_s)

    def _on_gripper(self, signals: _Signals, at_s: float) -> None:
        self._gripper = Reading(gripper_of(signals), at_s)

    def _on_limits(self, signals: _Signals, at_s: float) -> None:
        limits = JointLimits(
            min_deg=signals["MinAngle"],
            max_deg=signals["MaxAngle"],
            max_speed_deg_s=signals["MaxSpeed"] * self._degrees_per("LimitFeedback", "MaxSpeed"),
        )
        self._limits[JointNumber(signals["Joint"])] = Reading(limits, at_s)

    def _on_acceleration(self, signals: _Signals, at_s: float) -> None:
        factor = self._degrees_per("AccelerationFeedback", "MaxAcceleration")
        acceleration_deg_s2 = signals["MaxAcceleration"] * factor
        self._accelerations[JointNumber(signals["Joint"])] = Reading(acceleration_deg_s2, at_s)

    def _levels_handler(self, message: str) -> Callable[[_Signals, float], None]:
        def on_levels(signals: _Signals, at_s: float) -> None:
            levels: Six[int] = _six([int(signals[f"J{joint}"]) for joint in JOINTS])
            self._levels[message] = Reading(levels, at_s)

        return on_levels

    def _record_handler(self, field: str, record: type) -> Callable[[_Signals, float], None]:
        read: Callable[[_Signals], object] = record_reader(record)

        def on_record(signals: _Signals, at_s: float) -> None:
            self._records[field] = Reading(read(signals), at_s)

        return on_record

    def _end_motion_handler(self, joint: JointNumber) -> Callable[[_Signals, float], None]:
        read = record_reader(EndMotion)

        def on_end_motion(signals: _Signals, at_s: float) -> None:
            self._end_motion[joint] = Reading(read(signals), at_s)

        return on_end_motion

    def _on_firmware(self, signals: _Signals, at_s: float) -> None:
        self._version_heard_s = at_s
        self._answer.take(_version_payload(signals), at_s)

    def _driver_fast_handler(self, joint: JointNumber) -> Callable[[_Signals, float], None]:
        name = f"DriverFast{joint}"
        speed_factor = self._degrees_per(name, "Speed")
        position_factor = DEGREES_PER.get(self._codec.unit(name, "Position"))

        def on_driver(signals: _Signals, at_s: float) -> None:
            driver = DriverFast(
                speed_deg_s=signals["Speed"] * speed_factor,
                current_a=signals["Current"],
                position_deg=position_factor and signals["Position"] * position_factor,
            )
            self._drivers_fast[joint] = Reading(driver, at_s)

        return on_driver

    def _driver_slow_handler(self, joint: JointNumber) -> Callable[[_Signals, float], None]:
        def on_driver(signals: _Signals, at_s: float) -> None:
            driver = DriverSlow(
                voltage_v=signals["Voltage"],
                driver_temperature_c=signals["DriverTemperature"],
                motor_temperature_c=signals["MotorTemperature"],
                bus_current_a=signals["BusCurrent"],
                undervoltage=signals["Undervoltage"] == 1,
                motor_overtemperature=signals["MotorOvertemperature"] == 1,
                overcurrent=signals["Overcurrent"] == 1,
                driver_overtemperature=signals["DriverOvertemperature"] == 1,
                driver_fault=signals["DriverFault"] == 1,
                enabled=signals["Enabled"] == 1,
                sensor_fault=_flag(signals.get("SensorFault")),
                homed=_flag(signals.get("Homed")),
                collision_protection=_flag(signals.get("CollisionProtection")),
                stall_protection=_flag(signals.get("StallProtection")),
            )
            self._drivers_slow[joint] = Reading(driver, at_s)

        return on_driver

    def _degrees_per(self, message: str, signal: str) -> float:
        return DEGREES_PER[self._codec.unit(message, signal)]


def _version_payload(signals: _Signals) -> bytes:
    return bytes(int(signals[f"Byte{n}"]) for n in range(8))


def _is_asked_by_a_host(heard: Message) -> bool:
    """Return whether a message that an arm and a host may both send is the host's."""
    return heard.name == _VERSION_MESSAGE and is_question(_version_payload(heard.signals))


def _pair(
    where: list[Reading[float] | None], index: int, first: str, second: str
) -> Callable[[_Signals, float], None]:
    def on_pair(signals: _Signals, at_s: float) -> None:
        where[index] = Reading(signals[first], at_s)
        where[index + 1] = Reading(signals[second], at_s)

    return on_pair


def _six(values: list[Any]) -> Six[Any]:
    a, b, c, d, e, f = values
    return (a, b, c, d, e, f)


def _joint_flags(signals: _Signals, what: str) -> Six[bool]:
    return _six([signals.get(f"J{joint}{what}", 0) == 1 for joint in JOINTS])


def _whole(value: float | None) -> int | None:
    return None if value is None else int(value)


def _flag(value: float | None) -> bool | None:
    return None if value is None else value == 1
