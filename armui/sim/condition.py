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

    Not every generation has every bit. A sensor fault is told as a driver fault where its own bit
    means something else; collision and stall then show in 0x2A1 alone.
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
"""Stay after their cause has gone, until they are cleared; the others end with their cause."""

CUTS_POWER: Final = frozenset({Alarm.OVERCURRENT, Alarm.DRIVER})
"""The driver switches its own motor off; with the others it goes on holding the joint."""


class Alarms:
    """The alarms of six drivers.

    Attributes:
        any: Whether there is one.
        collision: Whether one of them is a collision.
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
        """Says whether the cause of an alarm is there; tells whether the alarm is new."""
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
        """Clears what is kept; an alarm whose cause is still there stays."""
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
        control_mode: Who commands the arm.
        move_mode: Which kind of motion targets ask for.
        speed_percent: Share of the joints' highest speeds, 0–100.
        teaching_state: What drag teaching does.
        motion_state: Whether the last target is reached; a motion cut short leaves it unreached.
        stopped: Whether an emergency stop is in force.
        no_solution: Whether no way to the last target was found.
        singular: Whether the way to the last target leads through a singular pose.
        activity: What drag teaching does, for the status.
        beyond_limit: The joints whose last target was refused.
        communication_fault: The joints the controller cannot talk to.
        alarms: What the drivers complain of.
        direct: Whether 0xAD in the mode word has handed the joints to their drivers' own loop.
        needs_reset: Whether the arm was taken out of that loop by a mode word that its firmware
            does not understand so: it takes up no target until it is reset.
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
        """Forgets what was wrong with the target before."""
        self.no_solution = self.singular = False
        self.beyond_limit = _no_joint()

    @property
    def hindered(self) -> bool:
        """True if a fault keeps a joint from moving."""
        return self.alarms.any or any(self.communication_fault)

    def clear_errors(self) -> None:
        """Clears errors as a resume does; an error whose cause is still there stays."""
        self.stopped = False
        self.alarms.clear(range(JOINT_COUNT))
        self.accept_target()
        self.motion_state = MotionState.REACHED
        self.direct = self.needs_reset = False

    def start_anew(self) -> None:
        """Goes back to the state after a power cycle; an error whose cause is still there stays."""
        self.clear_errors()
        self.control_mode = ControlMode.STANDBY
        self.move_mode = MoveMode.MOVE_P
        self.speed_percent = 0
        self.teaching_state = TeachingState.OFF
