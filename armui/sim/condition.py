"""The modes, flags and faults that the controller reports in 0x2A1."""

from __future__ import annotations

import enum
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Final

from armui.protocol.codes import ArmStatusCode, ControlMode, MotionState, MoveMode, TeachingState
from armui.sim.mechanics.powered_joints import JOINT_COUNT


class Alarm(enum.StrEnum):
    """An alarm of a driver; the value is the name of its bit in 0x261–0x266.

    Not every generation has every bit. Where the sensor's own bit means something else, a sensor
    fault is reported as a driver fault; collision and stall then show in 0x2A1 alone.
    """

    UNDERVOLTAGE = "Undervoltage"
    MOTOR_OVERTEMPERATURE = "MotorOvertemperature"
    OVERCURRENT = "Overcurrent"
    DRIVER_OVERTEMPERATURE = "DriverOvertemperature"
    SENSOR = "SensorFault"
    DRIVER = "DriverFault"
    COLLISION = "CollisionProtection"
    STALL = "StallProtection"


KEPT: Final = frozenset({Alarm.OVERCURRENT, Alarm.DRIVER, Alarm.COLLISION, Alarm.STALL})
"""Alarms that stay after their cause has gone, until they are cleared; the others end with their
cause.
"""

CUTS_POWER: Final = frozenset({Alarm.OVERCURRENT, Alarm.DRIVER})
"""Alarms at which the driver switches its own motor off; with the others it still holds the joint.
"""


class Alarms:
    """The alarms of six drivers.

    Attributes:
        any: True if there is an alarm.
        collision: True if one of them is a collision.
    """

    def __init__(self) -> None:
        self._causes: list[set[Alarm]] = [set() for _ in range(JOINT_COUNT)]
        self._kept: list[set[Alarm]] = [set() for _ in range(JOINT_COUNT)]
        self.any = False
        self.collision = False

    def of(self, index: int) -> set[Alarm]:
        """Return the alarms that the driver of a joint (0–5) reports."""
        return self._causes[index] | self._kept[index]

    def set(self, index: int, alarm: Alarm, *, present: bool) -> bool:
        """Sets whether an alarm's cause is present; returns whether the alarm is new."""
        if present == (alarm in self._causes[index]):
            return False
        is_new = present and alarm not in self._kept[index]
        if present:
            self._causes[index].add(alarm)
            if alarm in KEPT:
                self._kept[index].add(alarm)
        else:
            self._causes[index].discard(alarm)
        self._sum_up()
        return is_new

    def clear(self, indices: Iterable[int]) -> None:
        """Clears kept alarms; an alarm whose cause is still present stays."""
        for index in indices:
            self._kept[index] = self._causes[index] & KEPT
        self._sum_up()

    def _sum_up(self) -> None:
        alarms = [self.of(index) for index in range(JOINT_COUNT)]
        self.any = any(alarms)
        self.collision = any(Alarm.COLLISION in each for each in alarms)


def _no_joint() -> list[bool]:
    return [False] * JOINT_COUNT


@dataclass(slots=True)
class Condition:
    """Modes, flags and faults of the arm.

    Attributes:
        control_mode: The source of the arm's commands.
        move_mode: The kind of motion to targets.
        speed_percent: Share of the joints' highest speeds, 0–100.
        teaching_state: The state of drag teaching.
        motion_state: The arrival at the last target; an aborted motion leaves it unreached.
        stopped: True if an emergency stop is in force.
        no_solution: True if no way to the last target was found.
        singular: True if the way to the last target leads through a singular pose.
        activity: The activity of drag teaching, for the status.
        beyond_limit: The joints whose last target was refused.
        communication_fault: The joints the controller cannot talk to.
        alarms: The drivers' alarms.
        direct: True if 0xAD in the mode word has put the joints under their drivers' own loop.
        needs_reset: True if a mode word that its firmware does not support was to end that loop:
            the arm accepts no target until it is reset.
    """

    control_mode: ControlMode = ControlMode.STANDBY
    move_mode: MoveMode = MoveMode.MOVE_P
    speed_percent: int = 0
    teaching_state: TeachingState = TeachingState.OFF
    motion_state: MotionState = MotionState.REACHED
    stopped: bool = False
    no_solution: bool = False
    singular: bool = False
    activity: ArmStatusCode = ArmStatusCode.NORMAL
    beyond_limit: list[bool] = field(default_factory=_no_joint)
    communication_fault: list[bool] = field(default_factory=_no_joint)
    alarms: Alarms = field(default_factory=Alarms)
    direct: bool = False
    needs_reset: bool = False

    @property
    def status(self) -> ArmStatusCode:
        """The status code of 0x2A1 byte 1: the gravest of those that apply."""
        if self.stopped:
            return ArmStatusCode.EMERGENCY_STOP
        if any(self.communication_fault):
            return ArmStatusCode.JOINT_COMMUNICATION_FAULT
        if self.alarms.collision:
            return ArmStatusCode.COLLISION
        if self.alarms.any:
            return ArmStatusCode.JOINT_STATUS_ABNORMAL
        if any(self.beyond_limit):
            return ArmStatusCode.TARGET_BEYOND_LIMIT
        if self.no_solution:
            return ArmStatusCode.NO_SOLUTION
        if self.singular:
            return ArmStatusCode.SINGULARITY
        return self.activity

    def obeys(self, *move_modes: MoveMode) -> bool:
        """Return whether a target of one of these kinds of motion starts it as it arrives."""
        return self.control_mode is ControlMode.CAN_CONTROL and self.move_mode in move_modes

    def accept_target(self) -> None:
        """Clears the faults of the former target."""
        self.no_solution = self.singular = False
        self.beyond_limit = _no_joint()

    @property
    def hindered(self) -> bool:
        """True if a fault keeps a joint from moving."""
        return self.alarms.any or any(self.communication_fault)

    @property
    def may_move(self) -> bool:
        """True if neither a fault nor a stop is in the way of a motion."""
        return not (self.stopped or self.hindered or self.needs_reset)

    def clear_errors(self) -> None:
        """Clears errors as a resume does; an error whose cause is still present stays."""
        self.stopped = False
        self.alarms.clear(range(JOINT_COUNT))
        self.accept_target()
        self.motion_state = MotionState.REACHED
        self.direct = self.needs_reset = False

    def start_anew(self) -> None:
        """Returns to the state after a power cycle; an error whose cause is still present stays."""
        self.clear_errors()
        self.control_mode = ControlMode.STANDBY
        self.move_mode = MoveMode.MOVE_P
        self.speed_percent = 0
        self.teaching_state = TeachingState.OFF
