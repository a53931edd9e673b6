"""Every event the program tells the operator of, with its level.

The user interface has a sentence for each; a comment names the figures it shows.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from enum import StrEnum, unique
from typing import Final

from armui.telemetry.events import Level

__all__ = ["LINK_BREAKS", "Event", "EventCode", "Level"]


@unique
class EventCode(StrEnum):
    """Something that happened; see :class:`Event`.

    Attributes:
        level: How much it matters.
    """

    level: Level

    def __new__(cls, value: str, level: Level) -> EventCode:
        """A code is the text itself, and has its level beside it."""
        code = str.__new__(cls, value)
        code._value_ = value
        code.level = level
        return code

    SENT_JOINTS = "sent_joints", Level.INFO  # j1 … j6
    JOGGED = "jogged", Level.INFO  # joint, target
    WENT_HOME = "went_home", Level.INFO
    JOGGING_JOINT = "jogging_joint", Level.INFO  # joint, sign
    JOGGING_TOOL = "jogging_tool", Level.INFO  # axis, sign
    DEVICE_JOGS_JOINTS = "device_jogs_joints", Level.INFO  # device, axes
    DEVICE_JOGS_BASE = "device_jogs_base", Level.INFO  # device, axes
    DEVICE_JOGS_TOOL = "device_jogs_tool", Level.INFO  # device, axes
    JOG_ENDED = "jog_ended", Level.WARNING  # reason
    SENT_POSE = "sent_pose", Level.INFO  # x … rz
    SENT_LINE = "sent_line", Level.INFO  # x … rz
    SENT_ARC = "sent_arc", Level.INFO
    STEPPED_TOOL = "stepped_tool", Level.INFO  # axis, step with its unit
    SENT_SPEED = "sent_speed", Level.INFO  # percent
    MODEL_OTHER = "model_other", Level.WARNING  # chosen, fits
    MODEL_NONE = "model_none", Level.WARNING  # chosen
    MODEL_RECALLED = "model_recalled", Level.INFO  # chosen, before, node
    MODEL_WAS_OTHER = "model_was_other", Level.WARNING  # chosen, before, node
    SPEED_WAITS = "speed_waits", Level.WARNING  # percent
    OTHER_HOST_MOVES = "other_host_moves", Level.WARNING  # frames
    LEADER_ARM_MOVES = "leader_arm_moves", Level.WARNING  # frames
    OTHER_HOST_GONE = "other_host_gone", Level.INFO  # frames
    TAKEN_OVER = "taken_over", Level.DONE
    MODE_LEFT = "mode_left", Level.DONE
    CANCEL_UNHEEDED = "cancel_unheeded", Level.FAULT
    MOTION_UNHEEDED = "motion_unheeded", Level.FAULT
    MOTION_TOO_FAST = "motion_too_fast", Level.FAULT  # reason
    FRAMES_DROPPED = "frames_dropped", Level.WARNING  # count, total
    FRAME_SENT_BY_HAND = "frame_sent_by_hand", Level.WARNING  # frame
    SENT_LAMP = "sent_lamp", Level.INFO  # joint, lamp, color
    SENT_LAMPS = "sent_lamps", Level.INFO  # joint, color
    STOP_SENT = "stop_sent", Level.WARNING
    STOP_NOT_SENT = "stop_not_sent", Level.FAULT
    STOP_REACHES_OTHER = "stop_reaches_other", Level.WARNING  # feedback
    STOP_LAPSED = "stop_lapsed", Level.FAULT
    STOP_WITHDRAWN = "stop_withdrawn", Level.WARNING
    STOP_ABANDONED = "stop_abandoned", Level.FAULT  # device
    STOP_UNDONE = "stop_undone", Level.FAULT
    HALT_SENT = "halt_sent", Level.INFO
    HALT_NOT_OUT = "halt_not_out", Level.FAULT
    HALT_AT_REST = "halt_at_rest", Level.DONE
    STOP_CONFIRMED = "stop_confirmed", Level.WARNING
    STOP_UNCONFIRMED = "stop_unconfirmed", Level.FAULT
    RESUME_SENT = "resume_sent", Level.INFO
    RESUMED = "resumed", Level.DONE
    RESUME_FAILED = "resume_failed", Level.FAULT
    ENABLE_SENT = "enable_sent", Level.INFO
    ENABLED = "enabled", Level.DONE
    ENABLE_FAILED = "enable_failed", Level.FAULT  # joints
    ENABLE_SENT_JOINT = "enable_sent_joint", Level.INFO  # joint
    ENABLED_JOINT = "enabled_joint", Level.DONE  # joint
    DISABLE_SENT = "disable_sent", Level.INFO
    DISABLE_SENT_JOINT = "disable_sent_joint", Level.INFO  # joint
    DISABLED_JOINT = "disabled_joint", Level.DONE  # joint
    DISABLED = "disabled", Level.DONE
    DISABLE_FAILED = "disable_failed", Level.FAULT  # joints
    CLEAR_ERROR_SENT = "clear_error_sent", Level.INFO  # joint
    CLEAR_ERROR_ANSWERED = "clear_error_answered", Level.DONE  # joint
    CLEAR_ERROR_UNANSWERED = "clear_error_unanswered", Level.FAULT  # joint
    MOUNTING_SENT = "mounting_sent", Level.INFO  # mounting
    LOAD_SENT = "load_sent", Level.INFO  # load
    LOAD_ANSWERED = "load_answered", Level.DONE  # load
    LOAD_FAILED = "load_failed", Level.FAULT  # reason
    END_FEEDBACK_SENT = "end_feedback_sent", Level.INFO
    END_FEEDBACK_ON = "end_feedback_on", Level.DONE
    END_FEEDBACK_OFF = "end_feedback_off", Level.DONE
    END_FEEDBACK_FAILED = "end_feedback_failed", Level.FAULT  # reason
    LINKAGE_SENT = "linkage_sent", Level.INFO
    LINKAGE_ANSWERED = "linkage_answered", Level.INFO
    LINKAGE_ANSWERED_INPUT = "linkage_answered_input", Level.INFO
    LINKAGE_FAILED = "linkage_failed", Level.FAULT  # reason
    LINKAGE_IN_USE = "linkage_in_use", Level.DONE  # feedback, control
    LINKAGE_FOUND = "linkage_found", Level.WARNING  # feedback
    GRIPPER_SENT = "gripper_sent", Level.INFO  # value, unit
    GRIPPER_THERE = "gripper_there", Level.DONE  # value, unit
    GRIPPER_GRIPS = "gripper_grips", Level.DONE  # value, unit, torque
    GRIPPER_NOT_THERE = "gripper_not_there", Level.FAULT  # value, unit, target
    GRIPPER_ACT_SENT = "gripper_act_sent", Level.INFO  # act
    GRIPPER_ACT_DONE = "gripper_act_done", Level.DONE  # act
    GRIPPER_ACT_FAILED = "gripper_act_failed", Level.FAULT  # act
    ZERO_SENT = "zero_sent", Level.INFO
    ZERO_SENT_JOINT = "zero_sent_joint", Level.INFO  # joint
    ZERO_SET = "zero_set", Level.DONE
    ZERO_SET_JOINT = "zero_set_joint", Level.DONE  # joint
    ZERO_FAILED = "zero_failed", Level.FAULT  # reason
    SETTINGS_SENT = "settings_sent", Level.INFO  # count, values
    SETTINGS_SAVED = "settings_saved", Level.DONE  # count
    SETTINGS_REFUSED = "settings_refused", Level.FAULT  # count, total, reason
    SETTINGS_RESET_SENT = "settings_reset_sent", Level.INFO
    SETTINGS_RESET = "settings_reset", Level.DONE
    SETTINGS_RESET_FAILED = "settings_reset_failed", Level.FAULT  # reason
    RUN_STARTED = "run_started", Level.INFO  # name
    RUN_PAUSED = "run_paused", Level.INFO  # row
    RUN_CONTINUED = "run_continued", Level.INFO  # row
    RUN_DONE = "run_done", Level.DONE  # name
    RUN_ENDED = "run_ended", Level.INFO  # row
    RUN_FAILED = "run_failed", Level.FAULT  # row, reason
    TEACHING_SENT = "teaching_sent", Level.INFO  # command
    TEACHING_DONE = "teaching_done", Level.DONE  # command
    TEACHING_UNANSWERED = "teaching_unanswered", Level.FAULT  # command
    PLAN_SENT = "plan_sent", Level.INFO  # plan
    STANDBY_SENT = "standby_sent", Level.INFO
    MOTION_OUTPUT_SENT = "motion_output_sent", Level.INFO
    STEP_IN_VAIN = "step_in_vain", Level.FAULT
    REPLAY_PAUSED = "replay_paused", Level.INFO
    REPLAY_CONTINUED = "replay_continued", Level.INFO
    REPLAY_ENDED = "replay_ended", Level.INFO  # name
    REPLAY_FAILED = "replay_failed", Level.FAULT  # reason
    RECORDING_STARTED = "recording_started", Level.INFO
    RECORDING_ENDED = "recording_ended", Level.DONE  # count, seconds
    SESSION_STARTED = "session_started", Level.INFO  # name
    SESSION_ENDED = "session_ended", Level.DONE  # name, frames, size
    SESSION_FAILED = "session_failed", Level.WARNING  # reason
    SESSION_FRAMES_LOST = "session_frames_lost", Level.WARNING  # count
    MF4_SAVED = "mf4_saved", Level.DONE  # name
    MF4_NOT_SAVED = "mf4_not_saved", Level.WARNING  # name, reason
    RING_SAVED = "ring_saved", Level.DONE  # name, frames
    RING_NOT_SAVED = "ring_not_saved", Level.WARNING  # reason
    CONNECTED = "connected", Level.INFO  # device
    CONNECT_FAILED = "connect_failed", Level.FAULT  # device, reason
    DISCONNECTED = "disconnected", Level.INFO  # device
    LINK_LOST = "link_lost", Level.FAULT  # device, reason
    RECONNECTED = "reconnected", Level.DONE  # device
    BUS_BLOCKED = "bus_blocked", Level.FAULT  # device, reason
    BUS_UNBLOCKED = "bus_unblocked", Level.DONE  # device
    ONLINE = "online", Level.DONE
    OFFLINE = "offline", Level.WARNING
    GENERATION = "generation", Level.INFO  # generation, firmware
    LIMITS_READ = "limits_read", Level.INFO
    LIMITS_MISSING = "limits_missing", Level.WARNING  # joints
    LIMITS_CORRUPT = "limits_corrupt", Level.WARNING  # joint
    PART_FAILED = "part_failed", Level.FAULT  # part
    SETTINGS_SHARED = "settings_shared", Level.WARNING  # path, count
    CHANNEL_SHARED = "channel_shared", Level.WARNING  # device, count
    NOBODY_MET = "nobody_met", Level.WARNING  # path, text
    FILES_HANG = "files_hang", Level.WARNING  # count
    SETTINGS_UNSAVED = "settings_unsaved", Level.WARNING  # reason
    REFUSED = "refused", Level.WARNING  # reason
    QUESTION_WITHDRAWN = "question_withdrawn", Level.WARNING  # question, reason


LINK_BREAKS: Final = frozenset({EventCode.LINK_LOST, EventCode.RECONNECTED})
"""A device that went, and came back."""

ZEROING_ENDED: Final = frozenset(
    {EventCode.ZERO_SET, EventCode.ZERO_SET_JOINT, EventCode.ZERO_FAILED}
)
"""After these the angles may be counted anew: places entered before are other places."""


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happened, as data; the user interface has the sentence for it.

    Attributes:
        at: Local time.
        code: What happened.
        params: The figures of the sentence.
    """

    at: datetime
    level: Level
    code: EventCode
    params: Mapping[str, object] = field(default_factory=dict)
