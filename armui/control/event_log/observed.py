"""What the event log says beside the notices, as codes; a comment names the figures."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass, field
from enum import Enum, StrEnum, auto, unique

from armui.telemetry.events import Asker, EventKind, Level


@unique
class ObservedCode(StrEnum):
    """Something that was seen to happen; none of :class:`armui.control.events.EventCode`."""

    CONTROL_MODE = "control_mode"  # mode, before
    MOVE_MODE = "move_mode"  # mode, before
    ARM_STATUS = "arm_status"  # status
    TEACHING = "teaching"  # state, before
    MOTION = "motion"
    MOTORS_ON = "motors_on"  # joints
    MOTORS_OFF = "motors_off"  # joints
    JOINT_FAULT = "joint_fault"  # joint, item, word
    BEYOND_LIMIT = "beyond_limit"  # joint
    GRIPPER_FAULT = "gripper_fault"  # fault
    LIMITS_UNUSABLE = "limits_unusable"  # joint
    OTHER_FRAMES = "other_frames"  # id
    INVALID_FRAMES = "invalid_frames"  # kind, id
    FEWER_FRAMES = "fewer_frames"  # share
    RUN_POINT = "run_point"  # row
    ARRIVED = "arrived"
    MOTION_CUT = "motion_cut"  # end
    ANSWERED = "answered"  # index
    PROBLEM = "problem"  # reason
    NOT_KEPT = "not_kept"  # text
    LOGGED_STOP = "logged_stop"  # this and those below: what a host says in a foreign log
    LOGGED_RESUME = "logged_resume"
    LOGGED_ENABLE = "logged_enable"
    LOGGED_DISABLE = "logged_disable"
    LOGGED_MOTION_COMMAND = "logged_motion_command"
    LOGGED_TARGETS = "logged_targets"  # message
    UNKNOWN_MARK = "unknown_mark"  # code


class EventPhase(Enum):
    """What of an event is told."""

    BEGAN = auto()
    """It goes on until it has ended."""
    ENDED = auto()
    GREW = auto()
    """It happened more often, or has other figures by now."""
    HAPPENED = auto()


@dataclass(frozen=True, slots=True)
class EventChange:
    """What was observed.

    Attributes:
        phase: Which part of it this is.
        key: What is the same in its beginning and its end.
        at_s: Monotonic time.
        code: What it is; this and the rest are told with its beginning.
        kind: What sort it is.
        who: Whose word it is.
        level: How grave it is.
        params: The figures of its sentence.
        count: How often; of what grew, all of it.
        unheard: Of an end: it was not heard.
    """

    phase: EventPhase
    key: Hashable
    at_s: float
    code: ObservedCode | None = None
    kind: EventKind = EventKind.STATUS
    who: Asker = Asker.ARM
    level: Level = Level.INFO
    params: Mapping[str, object] = field(default_factory=dict)
    count: int = 1
    unheard: bool = False
