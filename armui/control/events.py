"""Every event the program tells the operator of, with its level.

The user interface has a sentence for each; a comment names the figures it shows.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from enum import StrEnum, unique
from typing import Final

from armui.telemetry.event_level import Level

__all__ = ["LEVELS", "LINK_BREAKS", "Event", "EventCode", "Level"]


@unique
class EventCode(StrEnum):
    """Something that happened; see :class:`Event`."""

    SENT_JOINTS = "sent_joints"  # j1 … j6
    JOGGED = "jogged"  # joint, target
    WENT_HOME = "went_home"
    JOGGING_JOINT = "jogging_joint"  # joint, sign
    JOGGING_TOOL = "jogging_tool"  # axis, sign
    DEVICE_JOGS_JOINTS = "device_jogs_joints"  # device, axes
    DEVICE_JOGS_BASE = "device_jogs_base"  # device, axes
    DEVICE_JOGS_TOOL = "device_jogs_tool"  # device, axes
    JOG_ENDED = "jog_ended"  # reason
    SENT_POSE = "sent_pose"  # x … rz
    SENT_LINE = "sent_line"  # x … rz
    SENT_ARC = "sent_arc"
    STEPPED_TOOL = "stepped_tool"  # axis, step with its unit
    SENT_SPEED = "sent_speed"  # percent
    MODEL_OTHER = "model_other"  # chosen, fits
    MODEL_NONE = "model_none"  # chosen
    MODEL_RECALLED = "model_recalled"  # chosen, before, node
    MODEL_WAS_OTHER = "model_was_other"  # chosen, before, node
    SPEED_WAITS = "speed_waits"  # percent
    OTHER_HOST_MOVES = "other_host_moves"  # frames
    LEADER_ARM_MOVES = "leader_arm_moves"  # frames
    OTHER_HOST_GONE = "other_host_gone"  # frames
    TAKEN_OVER = "taken_over"
    MODE_LEFT = "mode_left"
    CANCEL_UNHEEDED = "cancel_unheeded"
    MOTION_UNHEEDED = "motion_unheeded"
    MOTION_TOO_FAST = "motion_too_fast"  # reason
    FRAMES_DROPPED = "frames_dropped"  # count, total
    FRAME_SENT_BY_HAND = "frame_sent_by_hand"  # frame
    SENT_LAMP = "sent_lamp"  # joint, lamp, color
    SENT_LAMPS = "sent_lamps"  # joint, color
    STOP_SENT = "stop_sent"
    STOP_NOT_SENT = "stop_not_sent"
    STOP_REACHES_OTHER = "stop_reaches_other"  # feedback
    STOP_LAPSED = "stop_lapsed"
    STOP_WITHDRAWN = "stop_withdrawn"
    STOP_ABANDONED = "stop_abandoned"  # device
    STOP_UNDONE = "stop_undone"
    HALT_SENT = "halt_sent"
    HALT_NOT_OUT = "halt_not_out"
    HALT_AT_REST = "halt_at_rest"
    STOP_CONFIRMED = "stop_confirmed"
    STOP_UNCONFIRMED = "stop_unconfirmed"
    RESUME_SENT = "resume_sent"
    RESUMED = "resumed"
    RESUME_FAILED = "resume_failed"
    ENABLE_SENT = "enable_sent"
    ENABLED = "enabled"
    ENABLE_FAILED = "enable_failed"  # joints
    ENABLE_SENT_JOINT = "enable_sent_joint"  # joint
    ENABLED_JOINT = "enabled_joint"  # joint
    DISABLE_SENT = "disable_sent"
    DISABLE_SENT_JOINT = "disable_sent_joint"  # joint
    DISABLED_JOINT = "disabled_joint"  # joint
    DISABLED = "disabled"
    DISABLE_FAILED = "disable_failed"  # joints
    CLEAR_ERROR_SENT = "clear_error_sent"  # joint
    CLEAR_ERROR_ANSWERED = "clear_error_answered"  # joint
    CLEAR_ERROR_UNANSWERED = "clear_error_unanswered"  # joint
    MOUNTING_SENT = "mounting_sent"  # mounting
    LOAD_SENT = "load_sent"  # load
    LOAD_ANSWERED = "load_answered"  # load
    LOAD_FAILED = "load_failed"  # reason
    END_FEEDBACK_SENT = "end_feedback_sent"
    END_FEEDBACK_ON = "end_feedback_on"
    END_FEEDBACK_OFF = "end_feedback_off"
    END_FEEDBACK_FAILED = "end_feedback_failed"  # reason
    LINKAGE_SENT = "linkage_sent"
    LINKAGE_ANSWERED = "linkage_answered"
    LINKAGE_ANSWERED_INPUT = "linkage_answered_input"
    LINKAGE_FAILED = "linkage_failed"  # reason
    LINKAGE_IN_USE = "linkage_in_use"  # feedback, control
    LINKAGE_FOUND = "linkage_found"  # feedback
    GRIPPER_SENT = "gripper_sent"  # value, unit
    GRIPPER_THERE = "gripper_there"  # value, unit
    GRIPPER_GRIPS = "gripper_grips"  # value, unit, torque
    GRIPPER_NOT_THERE = "gripper_not_there"  # value, unit, target
    GRIPPER_ACT_SENT = "gripper_act_sent"  # act
    GRIPPER_ACT_DONE = "gripper_act_done"  # act
    GRIPPER_ACT_FAILED = "gripper_act_failed"  # act
    ZERO_SENT = "zero_sent"
    ZERO_SENT_JOINT = "zero_sent_joint"  # joint
    ZERO_SET = "zero_set"
    ZERO_SET_JOINT = "zero_set_joint"  # joint
    ZERO_FAILED = "zero_failed"  # reason
    SETTINGS_SENT = "settings_sent"  # count, values
    SETTINGS_SAVED = "settings_saved"  # count
    SETTINGS_REFUSED = "settings_refused"  # count, total, reason
    SETTINGS_RESET_SENT = "settings_reset_sent"
    SETTINGS_RESET = "settings_reset"
    SETTINGS_RESET_FAILED = "settings_reset_failed"  # reason
    RUN_STARTED = "run_started"  # name
    RUN_PAUSED = "run_paused"  # row
    RUN_CONTINUED = "run_continued"  # row
    RUN_DONE = "run_done"  # name
    RUN_ENDED = "run_ended"  # row
    RUN_FAILED = "run_failed"  # row, reason
    TEACHING_SENT = "teaching_sent"  # command
    TEACHING_DONE = "teaching_done"  # command
    TEACHING_UNANSWERED = "teaching_unanswered"  # command
    PLAN_SENT = "plan_sent"  # plan
    STANDBY_SENT = "standby_sent"
    MOTION_OUTPUT_SENT = "motion_output_sent"
    STEP_IN_VAIN = "step_in_vain"
    REPLAY_PAUSED = "replay_paused"
    REPLAY_CONTINUED = "replay_continued"
    REPLAY_ENDED = "replay_ended"  # name
    REPLAY_FAILED = "replay_failed"  # reason
    RECORDING_STARTED = "recording_started"
    RECORDING_ENDED = "recording_ended"  # count, seconds
    SESSION_STARTED = "session_started"  # name
    SESSION_ENDED = "session_ended"  # name, frames, size
    SESSION_FAILED = "session_failed"  # reason
    SESSION_FRAMES_LOST = "session_frames_lost"  # count
    MF4_SAVED = "mf4_saved"  # name
    MF4_NOT_SAVED = "mf4_not_saved"  # name, reason
    RING_SAVED = "ring_saved"  # name, frames
    RING_NOT_SAVED = "ring_not_saved"  # reason
    CONNECTED = "connected"  # device
    CONNECT_FAILED = "connect_failed"  # device, reason
    DISCONNECTED = "disconnected"  # device
    LINK_LOST = "link_lost"  # device, reason
    RECONNECTED = "reconnected"  # device
    BUS_BLOCKED = "bus_blocked"  # device, reason
    BUS_UNBLOCKED = "bus_unblocked"  # device
    ONLINE = "online"
    OFFLINE = "offline"
    GENERATION = "generation"  # generation, firmware
    LIMITS_READ = "limits_read"
    LIMITS_MISSING = "limits_missing"  # joints
    LIMITS_CORRUPT = "limits_corrupt"  # joint
    PART_FAILED = "part_failed"  # part
    SETTINGS_SHARED = "settings_shared"  # path, count
    CHANNEL_SHARED = "channel_shared"  # device, count
    REFUSED = "refused"  # reason


LINK_BREAKS: Final = frozenset({EventCode.LINK_LOST, EventCode.RECONNECTED})
"""A device that went, and came back."""

LEVELS: Final[Mapping[EventCode, Level]] = {
    EventCode.SENT_JOINTS: Level.INFO,
    EventCode.JOGGED: Level.INFO,
    EventCode.WENT_HOME: Level.INFO,
    EventCode.JOGGING_JOINT: Level.INFO,
    EventCode.JOGGING_TOOL: Level.INFO,
    EventCode.DEVICE_JOGS_JOINTS: Level.INFO,
    EventCode.DEVICE_JOGS_BASE: Level.INFO,
    EventCode.DEVICE_JOGS_TOOL: Level.INFO,
    EventCode.JOG_ENDED: Level.WARNING,
    EventCode.SENT_POSE: Level.INFO,
    EventCode.SENT_LINE: Level.INFO,
    EventCode.SENT_ARC: Level.INFO,
    EventCode.STEPPED_TOOL: Level.INFO,
    EventCode.SENT_SPEED: Level.INFO,
    EventCode.MODEL_OTHER: Level.WARNING,
    EventCode.MODEL_NONE: Level.WARNING,
    EventCode.MODEL_RECALLED: Level.INFO,
    EventCode.MODEL_WAS_OTHER: Level.WARNING,
    EventCode.SPEED_WAITS: Level.WARNING,
    EventCode.OTHER_HOST_MOVES: Level.WARNING,
    EventCode.LEADER_ARM_MOVES: Level.WARNING,
    EventCode.OTHER_HOST_GONE: Level.INFO,
    EventCode.TAKEN_OVER: Level.DONE,
    EventCode.MODE_LEFT: Level.DONE,
    EventCode.CANCEL_UNHEEDED: Level.FAULT,
    EventCode.MOTION_UNHEEDED: Level.FAULT,
    EventCode.MOTION_TOO_FAST: Level.FAULT,
    EventCode.FRAMES_DROPPED: Level.WARNING,
    EventCode.FRAME_SENT_BY_HAND: Level.WARNING,
    EventCode.SENT_LAMP: Level.INFO,
    EventCode.SENT_LAMPS: Level.INFO,
    EventCode.STOP_SENT: Level.WARNING,
    EventCode.STOP_NOT_SENT: Level.FAULT,
    EventCode.STOP_REACHES_OTHER: Level.WARNING,
    EventCode.STOP_LAPSED: Level.FAULT,
    EventCode.STOP_WITHDRAWN: Level.WARNING,
    EventCode.STOP_ABANDONED: Level.FAULT,
    EventCode.STOP_UNDONE: Level.FAULT,
    EventCode.HALT_SENT: Level.INFO,
    EventCode.HALT_NOT_OUT: Level.FAULT,
    EventCode.HALT_AT_REST: Level.DONE,
    EventCode.STOP_CONFIRMED: Level.WARNING,
    EventCode.STOP_UNCONFIRMED: Level.FAULT,
    EventCode.RESUME_SENT: Level.INFO,
    EventCode.RESUMED: Level.DONE,
    EventCode.RESUME_FAILED: Level.FAULT,
    EventCode.ENABLE_SENT: Level.INFO,
    EventCode.ENABLED: Level.DONE,
    EventCode.ENABLE_FAILED: Level.FAULT,
    EventCode.ENABLE_SENT_JOINT: Level.INFO,
    EventCode.ENABLED_JOINT: Level.DONE,
    EventCode.DISABLE_SENT: Level.INFO,
    EventCode.DISABLE_SENT_JOINT: Level.INFO,
    EventCode.DISABLED_JOINT: Level.DONE,
    EventCode.DISABLED: Level.DONE,
    EventCode.DISABLE_FAILED: Level.FAULT,
    EventCode.CLEAR_ERROR_SENT: Level.INFO,
    EventCode.CLEAR_ERROR_ANSWERED: Level.DONE,
    EventCode.CLEAR_ERROR_UNANSWERED: Level.FAULT,
    EventCode.MOUNTING_SENT: Level.INFO,
    EventCode.LOAD_SENT: Level.INFO,
    EventCode.LOAD_ANSWERED: Level.DONE,
    EventCode.LOAD_FAILED: Level.FAULT,
    EventCode.END_FEEDBACK_SENT: Level.INFO,
    EventCode.END_FEEDBACK_ON: Level.DONE,
    EventCode.END_FEEDBACK_OFF: Level.DONE,
    EventCode.END_FEEDBACK_FAILED: Level.FAULT,
    EventCode.LINKAGE_SENT: Level.INFO,
    EventCode.LINKAGE_ANSWERED: Level.INFO,
    EventCode.LINKAGE_ANSWERED_INPUT: Level.INFO,
    EventCode.LINKAGE_FAILED: Level.FAULT,
    EventCode.LINKAGE_IN_USE: Level.DONE,
    EventCode.LINKAGE_FOUND: Level.WARNING,
    EventCode.GRIPPER_SENT: Level.INFO,
    EventCode.GRIPPER_THERE: Level.DONE,
    EventCode.GRIPPER_GRIPS: Level.DONE,
    EventCode.GRIPPER_NOT_THERE: Level.FAULT,
    EventCode.GRIPPER_ACT_SENT: Level.INFO,
    EventCode.GRIPPER_ACT_DONE: Level.DONE,
    EventCode.GRIPPER_ACT_FAILED: Level.FAULT,
    EventCode.ZERO_SENT: Level.INFO,
    EventCode.ZERO_SENT_JOINT: Level.INFO,
    EventCode.ZERO_SET: Level.DONE,
    EventCode.ZERO_SET_JOINT: Level.DONE,
    EventCode.ZERO_FAILED: Level.FAULT,
    EventCode.SETTINGS_SENT: Level.INFO,
    EventCode.SETTINGS_SAVED: Level.DONE,
    EventCode.SETTINGS_REFUSED: Level.FAULT,
    EventCode.SETTINGS_RESET_SENT: Level.INFO,
    EventCode.SETTINGS_RESET: Level.DONE,
    EventCode.SETTINGS_RESET_FAILED: Level.FAULT,
    EventCode.RUN_STARTED: Level.INFO,
    EventCode.RUN_PAUSED: Level.INFO,
    EventCode.RUN_CONTINUED: Level.INFO,
    EventCode.RUN_DONE: Level.DONE,
    EventCode.RUN_ENDED: Level.INFO,
    EventCode.RUN_FAILED: Level.FAULT,
    EventCode.TEACHING_SENT: Level.INFO,
    EventCode.TEACHING_DONE: Level.DONE,
    EventCode.TEACHING_UNANSWERED: Level.FAULT,
    EventCode.PLAN_SENT: Level.INFO,
    EventCode.STANDBY_SENT: Level.INFO,
    EventCode.MOTION_OUTPUT_SENT: Level.INFO,
    EventCode.STEP_IN_VAIN: Level.FAULT,
    EventCode.REPLAY_PAUSED: Level.INFO,
    EventCode.REPLAY_CONTINUED: Level.INFO,
    EventCode.REPLAY_ENDED: Level.INFO,
    EventCode.REPLAY_FAILED: Level.FAULT,
    EventCode.RECORDING_STARTED: Level.INFO,
    EventCode.RECORDING_ENDED: Level.DONE,
    EventCode.SESSION_STARTED: Level.INFO,
    EventCode.SESSION_ENDED: Level.DONE,
    EventCode.SESSION_FAILED: Level.WARNING,
    EventCode.SESSION_FRAMES_LOST: Level.WARNING,
    EventCode.MF4_SAVED: Level.DONE,
    EventCode.MF4_NOT_SAVED: Level.WARNING,
    EventCode.RING_SAVED: Level.DONE,
    EventCode.RING_NOT_SAVED: Level.WARNING,
    EventCode.CONNECTED: Level.INFO,
    EventCode.CONNECT_FAILED: Level.FAULT,
    EventCode.DISCONNECTED: Level.INFO,
    EventCode.LINK_LOST: Level.FAULT,
    EventCode.RECONNECTED: Level.DONE,
    EventCode.BUS_BLOCKED: Level.FAULT,
    EventCode.BUS_UNBLOCKED: Level.DONE,
    EventCode.ONLINE: Level.DONE,
    EventCode.OFFLINE: Level.WARNING,
    EventCode.GENERATION: Level.INFO,
    EventCode.LIMITS_READ: Level.INFO,
    EventCode.LIMITS_MISSING: Level.WARNING,
    EventCode.LIMITS_CORRUPT: Level.WARNING,
    EventCode.PART_FAILED: Level.FAULT,
    EventCode.SETTINGS_SHARED: Level.WARNING,
    EventCode.CHANNEL_SHARED: Level.WARNING,
    EventCode.REFUSED: Level.WARNING,
}
"""How much each matters."""


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
