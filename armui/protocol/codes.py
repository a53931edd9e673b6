"""The codes of the protocol's tables that the program itself uses.

The value tables of the DBC files hold the same codes with words for people; a test compares the
two. Codes that only generation 2 knows say so; the codec refuses them in generation 1.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Mapping
from typing import Final

VALID = 0xAE
"""The value that makes a field of 0x159, 0x475 or 0x477 take effect."""

MOVE_UNCHANGED = 0xFF
"""The value of 0x151 byte 1 that keeps the kind of motion; generation 2."""

ALL_JOINTS = 7
"""The joint number that means every joint in 0x471 and 0x475."""

ALL_LAMPS = 0xFF
"""The lamp number that means every lamp in 0x121."""

DEGREES_PER: Final[Mapping[str, float]] = {
    "deg": 1.0,
    "rad": math.degrees(1.0),
    "rpm": 6.0,
    "rad/s": math.degrees(1.0),
    "rpm/s": 6.0,
    "rad/s^2": math.degrees(1.0),
}
"""Degrees (per second, per second squared) in one unit of the DBC files."""


class ControlMode(enum.IntEnum):
    """The source of commands: 0x2A1 byte 0; a host may request 0–4 and 7 with 0x151 byte 0."""

    STANDBY = 0x00
    CAN_CONTROL = 0x01
    TEACHING = 0x02
    ETHERNET_CONTROL = 0x03
    WIFI_CONTROL = 0x04
    REMOTE_CONTROL = 0x05
    LINKED_TEACHING_INPUT = 0x06
    OFFLINE_TRAJECTORY = 0x07  # generation 2


class ArmStatusCode(enum.IntEnum):
    """The arm's state or fault: 0x2A1 byte 1."""

    NORMAL = 0x00
    EMERGENCY_STOP = 0x01
    NO_SOLUTION = 0x02
    SINGULARITY = 0x03
    TARGET_BEYOND_LIMIT = 0x04
    JOINT_COMMUNICATION_FAULT = 0x05
    JOINT_BRAKE_CLOSED = 0x06
    COLLISION = 0x07
    OVERSPEED_WHILE_TEACHING = 0x08
    JOINT_STATUS_ABNORMAL = 0x09
    OTHER_FAULT = 0x0A
    TEACHING_RECORDING = 0x0B
    TEACHING_RUNNING = 0x0C
    TEACHING_PAUSED = 0x0D
    MAIN_CONTROLLER_TOO_HOT = 0x0E  # generation 2
    BRAKE_RESISTOR_TOO_HOT = 0x0F  # generation 2


AT_WORK: Final = frozenset(
    {
        ArmStatusCode.NORMAL,
        ArmStatusCode.TEACHING_RECORDING,
        ArmStatusCode.TEACHING_RUNNING,
        ArmStatusCode.TEACHING_PAUSED,
    }
)
"""The statuses that are no fault."""

TARGET_REFUSALS: Final = frozenset(
    {ArmStatusCode.NO_SOLUTION, ArmStatusCode.SINGULARITY, ArmStatusCode.TARGET_BEYOND_LIMIT}
)
"""The statuses with which the arm refuses a target, and stands: it takes the next one."""


class MoveMode(enum.IntEnum):
    """The kind of motion: 0x151 byte 1 and 0x2A1 byte 2."""

    MOVE_P = 0x00
    MOVE_J = 0x01
    MOVE_L = 0x02
    MOVE_C = 0x03
    MOVE_M = 0x04  # generation 2, up to S-V1.8-7
    MOVE_CPV = 0x05  # generation 2
    MOVE_M_FROM_1_8_8 = 0x06  # generation 2, from S-V1.8-8


class TeachingState(enum.IntEnum):
    """Drag teaching: commanded with 0x150 byte 2, reported in 0x2A1 byte 3."""

    OFF = 0x00
    START_RECORDING = 0x01
    STOP_RECORDING = 0x02
    RUN_RECORDING = 0x03
    PAUSE = 0x04
    CONTINUE = 0x05
    ABORT = 0x06
    MOVE_TO_START = 0x07


class MotionState(enum.IntEnum):
    """The arrival at the target: 0x2A1 byte 4."""

    REACHED = 0x00
    NOT_REACHED = 0x01


class StopCommand(enum.IntEnum):
    """Emergency stop and resume: 0x150 byte 0."""

    NO_ACTION = 0x00
    EMERGENCY_STOP = 0x01
    RESUME = 0x02


class TrajectoryCommand(enum.IntEnum):
    """The commands to trajectories: 0x150 byte 1."""

    OFF = 0x00
    PAUSE = 0x01
    CONTINUE = 0x02
    CLEAR_CURRENT = 0x03
    CLEAR_ALL = 0x04
    GET_CURRENT = 0x05
    ABORT = 0x06
    TRANSFER = 0x07  # generation 2
    TRANSFER_ENDS = 0x08  # generation 2


class MitMode(enum.IntEnum):
    """The control loop, position-velocity or MIT: 0x151 byte 3, generation 2."""

    POSITION_VELOCITY = 0x00
    MIT = 0xAD


class Mounting(enum.IntEnum):
    """The mounting of the arm: 0x151 byte 5, generation 2."""

    UNCHANGED = 0x00
    LEVEL = 0x01
    ON_THE_LEFT_SIDE = 0x02
    ON_THE_RIGHT_SIDE = 0x03
    UPSIDE_DOWN = 0x04  # level, from S-V1.8-8


class ArcPointNumber(enum.IntEnum):
    """The role of a pose in an arc: 0x158."""

    NONE = 0x00
    START = 0x01
    MIDDLE = 0x02
    END = 0x03


class SilenceMode(enum.IntEnum):
    """Silence on the bus for a firmware upgrade: 0x422."""

    LEAVE_SILENCE = 0x00
    SILENCE_FOR_CONTROLLER_UPGRADE = 0x01
    SILENCE_FOR_DRIVER_UPGRADE = 0x02


class LinkageRole(enum.IntEnum):
    """The arm as teaching input or motion output: 0x470 byte 0."""

    UNCHANGED = 0x00
    TEACHING_INPUT = 0xFA
    MOTION_OUTPUT = 0xFC


class MotorAction(enum.IntEnum):
    """Enabling and disabling motors: 0x471 byte 1."""

    DISABLE = 0x01
    ENABLE = 0x02


class LimitQuery(enum.IntEnum):
    """The limits asked for: 0x472 byte 1."""

    ANGLE_AND_SPEED_LIMITS = 0x01
    ACCELERATION_LIMIT = 0x02


class ParameterQuery(enum.IntEnum):
    """The parameters asked for: 0x477 byte 0."""

    NONE = 0x00
    END_LIMITS = 0x01
    COLLISION_LEVELS = 0x02
    TRAJECTORY_INDEX = 0x03  # generation 2
    TEACHING_SETTING = 0x04  # generation 2
    DRAG_ASSISTANCE = 0x05  # generation 2, from S-V1.8-1


class FactoryReset(enum.IntEnum):
    """The parameters to be reset: 0x477 byte 1."""

    NONE = 0x00
    END_LIMITS_TO_FACTORY = 0x01
    JOINT_LIMITS_TO_FACTORY = 0x02  # generation 2


class EndLoad(enum.IntEnum):
    """The load at the end of the arm: 0x477 byte 4."""

    EMPTY = 0x00
    HALF = 0x01
    FULL = 0x02
    NOT_GIVEN = 0x03  # generation 2


class SettingIndex(enum.IntEnum):
    """The setting that 0x476 answers: the low byte of its identifier."""

    MOTION_COMMAND = 0x50
    LINKAGE_SETTING = 0x70
    MOTOR_ENABLE = 0x71
    LIMIT_QUERY = 0x72
    LIMIT_SETTING = 0x74
    JOINT_SETTING = 0x75
    PARAMETER_COMMAND = 0x77
    END_LIMIT_SETTING = 0x79
    COLLISION_SETTING = 0x7A
    TEACHING_SETTING = 0x7D  # generation 2
    DRAG_ASSISTANCE_SETTING = 0x87  # generation 2, from S-V1.8-1


class GripperMeasure(enum.IntEnum):
    """The meaning of bytes 0–3 of 0x159 and 0x2A8: an opening or an angle; from S-V1.8-8.

    It is told by bit 2 of 0x159 byte 6, and by 0x2A8 byte 7.
    """

    OPENING = 0x00
    ANGLE = 0x01


class CpvAction(enum.IntEnum):
    """Reading or writing a value in CPV: 0x181–0x187 byte 0, generation 2."""

    ANSWER = 0x61
    READ = 0x72
    WRITE = 0x77


class CpvKind(enum.IntEnum):
    """The value in a CPV frame: 0x181–0x187 bytes 1–2, two letters; generation 2."""

    ACCELERATION = 0x6163
    DECELERATION = 0x6463
    ZERO_LEARNING = 0x6565
    SPEED_KI = 0x6B69
    SPEED_KP = 0x6B70
    POSITION_TARGET = 0x706F
    POSITION_KP = 0x7070
    SPEED_TARGET = 0x7370
    PROFILE_SPEED = 0x7676


class LeaderZero(enum.IntEnum):
    """The commands to a leader arm: 0x191 bytes 0–2, generation 2, from S-V1.7-4."""

    LEADER_AND_FOLLOWER = 0x010000
    BOTH_TO_ZERO = 0x010001
    LEADER_TO_ZERO = 0x010101
