"""Every event the program tells the operator of: its level, its sort, and who asked for it.

The user interface has a sentence for each; a comment names the figures it shows.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from enum import StrEnum, unique
from typing import TYPE_CHECKING, Final

from armui.telemetry.events import Asker, EventKind, Level

if TYPE_CHECKING:
    from armui.control.operations.started import Started

__all__ = ["LINK_BREAKS", "Event", "EventCode", "Level"]


_WHO: Final = {
    EventKind.COMMAND: Asker.OPERATOR,
    EventKind.RESULT: Asker.ARM,
    EventKind.STATUS: Asker.ARM,
    EventKind.LINK: Asker.PROGRAM,
    EventKind.OTHER_HOST: Asker.OTHER_HOST,
    EventKind.ODDITY: Asker.PROGRAM,
    EventKind.PROGRAM: Asker.PROGRAM,
}
"""Who says an event of a kind; that something has failed the program says."""


@unique
class EventCode(StrEnum):
    """Something that happened; see :class:`Event`.

    Attributes:
        level: How much it matters.
        kind: What sort of event it is.
        who: Who asked for it, or says it.
    """

    level: Level
    kind: EventKind
    who: Asker

    def __new__(
        cls, value: str, level: Level, kind: EventKind, who: Asker | None = None
    ) -> EventCode:
        """A code is the text itself, with what belongs to it; its kind tells who, unless told."""
        code = str.__new__(cls, value)
        code._value_ = value
        code.level, code.kind = level, kind
        failed = kind is EventKind.RESULT and level is Level.FAULT
        code.who = who or (Asker.PROGRAM if failed else _WHO[kind])
        return code

    SENT_JOINTS = "sent_joints", Level.INFO, EventKind.COMMAND  # j1 … j6
    JOGGED = "jogged", Level.INFO, EventKind.COMMAND  # joint, target
    WENT_HOME = "went_home", Level.INFO, EventKind.COMMAND
    JOGGING_JOINT = "jogging_joint", Level.INFO, EventKind.COMMAND, Asker.JOG  # joint, sign
    JOGGING_TOOL = "jogging_tool", Level.INFO, EventKind.COMMAND, Asker.JOG  # axis, sign
    DEVICE_JOGS_JOINTS = "device_jogs_joints", Level.INFO, EventKind.COMMAND  # device, axes
    DEVICE_JOGS_BASE = "device_jogs_base", Level.INFO, EventKind.COMMAND  # device, axes
    DEVICE_JOGS_TOOL = "device_jogs_tool", Level.INFO, EventKind.COMMAND  # device, axes
    JOG_ENDED = "jog_ended", Level.WARNING, EventKind.RESULT, Asker.JOG  # reason
    SENT_POSE = "sent_pose", Level.INFO, EventKind.COMMAND  # x … rz
    SENT_LINE = "sent_line", Level.INFO, EventKind.COMMAND  # x … rz
    SENT_ARC = "sent_arc", Level.INFO, EventKind.COMMAND
    STEPPED_TOOL = "stepped_tool", Level.INFO, EventKind.COMMAND  # axis, step with its unit
    SENT_SPEED = "sent_speed", Level.INFO, EventKind.COMMAND  # percent
    MODEL_OTHER = "model_other", Level.WARNING, EventKind.STATUS  # chosen, fits
    MODEL_NONE = "model_none", Level.WARNING, EventKind.STATUS  # chosen
    MODEL_RECALLED = "model_recalled", Level.INFO, EventKind.STATUS  # chosen, before, node
    MODEL_WAS_OTHER = "model_was_other", Level.WARNING, EventKind.STATUS  # chosen, before, node
    OVERRIDE_SET = "override_set", Level.INFO, EventKind.COMMAND  # percent
    SPEED_WAITS = "speed_waits", Level.WARNING, EventKind.COMMAND  # percent
    OTHER_HOST_MOVES = "other_host_moves", Level.WARNING, EventKind.OTHER_HOST  # frames
    LEADER_ARM_MOVES = "leader_arm_moves", Level.WARNING, EventKind.OTHER_HOST  # frames
    OTHER_HOST_GONE = "other_host_gone", Level.INFO, EventKind.OTHER_HOST  # frames
    TAKEN_OVER = "taken_over", Level.DONE, EventKind.COMMAND
    MODE_LEFT = "mode_left", Level.DONE, EventKind.COMMAND
    CANCEL_UNHEEDED = "cancel_unheeded", Level.FAULT, EventKind.RESULT
    MOTION_UNHEEDED = "motion_unheeded", Level.FAULT, EventKind.RESULT
    MOTION_TOO_FAST = "motion_too_fast", Level.FAULT, EventKind.RESULT  # reason
    FRAMES_DROPPED = "frames_dropped", Level.WARNING, EventKind.ODDITY  # count, total
    FRAME_SENT_BY_HAND = "frame_sent_by_hand", Level.WARNING, EventKind.COMMAND  # frame
    SENT_LAMP = "sent_lamp", Level.INFO, EventKind.COMMAND  # joint, lamp, color
    SENT_LAMPS = "sent_lamps", Level.INFO, EventKind.COMMAND  # joint, color
    STOP_SENT = "stop_sent", Level.WARNING, EventKind.COMMAND
    STOP_NOT_SENT = "stop_not_sent", Level.FAULT, EventKind.COMMAND
    STOP_REACHES_OTHER = (
        "stop_reaches_other",
        Level.WARNING,
        EventKind.RESULT,
        Asker.PROGRAM,
    )  # feedback
    STOP_LAPSED = "stop_lapsed", Level.FAULT, EventKind.RESULT
    STOP_WITHDRAWN = "stop_withdrawn", Level.WARNING, EventKind.RESULT, Asker.OPERATOR
    STOP_ABANDONED = "stop_abandoned", Level.FAULT, EventKind.RESULT  # device
    STOP_UNDONE = "stop_undone", Level.FAULT, EventKind.RESULT
    HALT_SENT = "halt_sent", Level.INFO, EventKind.COMMAND
    HALT_NOT_OUT = "halt_not_out", Level.FAULT, EventKind.COMMAND
    HALT_AT_REST = "halt_at_rest", Level.DONE, EventKind.RESULT
    STOP_CONFIRMED = "stop_confirmed", Level.WARNING, EventKind.RESULT
    STOP_UNCONFIRMED = "stop_unconfirmed", Level.FAULT, EventKind.RESULT
    RESUME_SENT = "resume_sent", Level.INFO, EventKind.COMMAND
    RESUMED = "resumed", Level.DONE, EventKind.RESULT
    RESUME_FAILED = "resume_failed", Level.FAULT, EventKind.RESULT
    ENABLE_SENT = "enable_sent", Level.INFO, EventKind.COMMAND
    ENABLED = "enabled", Level.DONE, EventKind.RESULT
    ENABLE_FAILED = "enable_failed", Level.FAULT, EventKind.RESULT  # joints
    ENABLE_SENT_JOINT = "enable_sent_joint", Level.INFO, EventKind.COMMAND  # joint
    ENABLED_JOINT = "enabled_joint", Level.DONE, EventKind.RESULT  # joint
    DISABLE_SENT = "disable_sent", Level.INFO, EventKind.COMMAND
    DISABLE_SENT_JOINT = "disable_sent_joint", Level.INFO, EventKind.COMMAND  # joint
    DISABLED_JOINT = "disabled_joint", Level.DONE, EventKind.RESULT  # joint
    DISABLED = "disabled", Level.DONE, EventKind.RESULT
    DISABLE_FAILED = "disable_failed", Level.FAULT, EventKind.RESULT  # joints
    CLEAR_ERROR_SENT = "clear_error_sent", Level.INFO, EventKind.COMMAND  # joint
    CLEAR_ERROR_ANSWERED = "clear_error_answered", Level.DONE, EventKind.RESULT  # joint
    CLEAR_ERROR_UNANSWERED = "clear_error_unanswered", Level.FAULT, EventKind.RESULT  # joint
    MOUNTING_SENT = "mounting_sent", Level.INFO, EventKind.COMMAND  # mounting
    LOAD_SENT = "load_sent", Level.INFO, EventKind.COMMAND  # load
    LOAD_ANSWERED = "load_answered", Level.DONE, EventKind.RESULT  # load
    LOAD_FAILED = "load_failed", Level.FAULT, EventKind.RESULT  # reason
    END_FEEDBACK_SENT = "end_feedback_sent", Level.INFO, EventKind.COMMAND
    END_FEEDBACK_ON = "end_feedback_on", Level.DONE, EventKind.RESULT
    END_FEEDBACK_OFF = "end_feedback_off", Level.DONE, EventKind.RESULT
    END_FEEDBACK_FAILED = "end_feedback_failed", Level.FAULT, EventKind.RESULT  # reason
    LINKAGE_SENT = "linkage_sent", Level.INFO, EventKind.COMMAND
    LINKAGE_ANSWERED = "linkage_answered", Level.INFO, EventKind.RESULT
    LINKAGE_ANSWERED_INPUT = "linkage_answered_input", Level.INFO, EventKind.RESULT
    LINKAGE_FAILED = "linkage_failed", Level.FAULT, EventKind.RESULT  # reason
    LINKAGE_IN_USE = "linkage_in_use", Level.DONE, EventKind.LINK  # feedback, control
    LINKAGE_FOUND = "linkage_found", Level.WARNING, EventKind.LINK  # feedback
    GRIPPER_SENT = "gripper_sent", Level.INFO, EventKind.COMMAND  # value, unit
    GRIPPER_THERE = "gripper_there", Level.DONE, EventKind.RESULT  # value, unit
    GRIPPER_GRIPS = "gripper_grips", Level.DONE, EventKind.RESULT  # value, unit, torque
    GRIPPER_NOT_THERE = "gripper_not_there", Level.FAULT, EventKind.RESULT  # value, unit, target
    GRIPPER_ACT_SENT = "gripper_act_sent", Level.INFO, EventKind.COMMAND  # act
    GRIPPER_ACT_DONE = "gripper_act_done", Level.DONE, EventKind.RESULT  # act
    GRIPPER_ACT_FAILED = "gripper_act_failed", Level.FAULT, EventKind.RESULT  # act
    ZERO_SENT = "zero_sent", Level.INFO, EventKind.COMMAND
    ZERO_SENT_JOINT = "zero_sent_joint", Level.INFO, EventKind.COMMAND  # joint
    ZERO_SET = "zero_set", Level.DONE, EventKind.RESULT
    ZERO_SET_JOINT = "zero_set_joint", Level.DONE, EventKind.RESULT  # joint
    ZERO_FAILED = "zero_failed", Level.FAULT, EventKind.RESULT  # reason
    SETTINGS_SENT = "settings_sent", Level.INFO, EventKind.COMMAND  # count, values
    SETTINGS_SAVED = "settings_saved", Level.DONE, EventKind.RESULT  # count
    SETTINGS_REFUSED = "settings_refused", Level.FAULT, EventKind.RESULT  # count, total, reason
    SETTINGS_RESET_SENT = "settings_reset_sent", Level.INFO, EventKind.COMMAND
    SETTINGS_RESET = "settings_reset", Level.DONE, EventKind.RESULT
    SETTINGS_RESET_FAILED = "settings_reset_failed", Level.FAULT, EventKind.RESULT  # reason
    RUN_STARTED = "run_started", Level.INFO, EventKind.COMMAND  # name
    RUN_PAUSED = "run_paused", Level.INFO, EventKind.COMMAND  # row
    RUN_CONTINUED = "run_continued", Level.INFO, EventKind.COMMAND  # row
    RUN_DONE = "run_done", Level.DONE, EventKind.RESULT, Asker.RUN  # name
    RUN_ENDED = "run_ended", Level.INFO, EventKind.RESULT, Asker.RUN  # row
    RUN_FAILED = "run_failed", Level.FAULT, EventKind.RESULT, Asker.RUN  # row, reason
    TEACHING_SENT = "teaching_sent", Level.INFO, EventKind.COMMAND  # command
    TEACHING_DONE = "teaching_done", Level.DONE, EventKind.RESULT  # command
    TEACHING_UNANSWERED = "teaching_unanswered", Level.FAULT, EventKind.RESULT  # command
    PLAN_SENT = "plan_sent", Level.INFO, EventKind.COMMAND  # plan
    STANDBY_SENT = "standby_sent", Level.INFO, EventKind.COMMAND
    MOTION_OUTPUT_SENT = "motion_output_sent", Level.INFO, EventKind.COMMAND
    STEP_IN_VAIN = "step_in_vain", Level.FAULT, EventKind.RESULT
    REPLAY_PAUSED = "replay_paused", Level.INFO, EventKind.COMMAND
    REPLAY_CONTINUED = "replay_continued", Level.INFO, EventKind.COMMAND
    REPLAY_ENDED = "replay_ended", Level.INFO, EventKind.RESULT, Asker.RUN  # name
    REPLAY_FAILED = "replay_failed", Level.FAULT, EventKind.RESULT, Asker.RUN  # reason
    RECORDING_STARTED = "recording_started", Level.INFO, EventKind.COMMAND
    RECORDING_ENDED = (
        "recording_ended",
        Level.DONE,
        EventKind.RESULT,
        Asker.PROGRAM,
    )  # count, seconds
    SESSION_STARTED = "session_started", Level.INFO, EventKind.COMMAND  # name
    SESSION_ENDED = (
        "session_ended",
        Level.DONE,
        EventKind.RESULT,
        Asker.PROGRAM,
    )  # name, frames, size
    SESSION_FAILED = "session_failed", Level.WARNING, EventKind.RESULT, Asker.PROGRAM  # reason
    SESSION_FRAMES_LOST = "session_frames_lost", Level.WARNING, EventKind.PROGRAM  # count
    MF4_SAVED = "mf4_saved", Level.DONE, EventKind.PROGRAM  # name
    MF4_NOT_SAVED = "mf4_not_saved", Level.WARNING, EventKind.PROGRAM  # name, reason
    RING_SAVED = "ring_saved", Level.DONE, EventKind.PROGRAM  # name, frames
    RING_NOT_SAVED = "ring_not_saved", Level.WARNING, EventKind.PROGRAM  # reason
    CONNECTED = "connected", Level.INFO, EventKind.LINK, Asker.OPERATOR  # device
    CONNECT_FAILED = "connect_failed", Level.FAULT, EventKind.LINK  # device, reason
    DISCONNECTED = "disconnected", Level.INFO, EventKind.LINK, Asker.OPERATOR  # device
    LINK_LOST = "link_lost", Level.FAULT, EventKind.LINK  # device, reason
    RECONNECTED = "reconnected", Level.DONE, EventKind.LINK  # device
    BUS_BLOCKED = "bus_blocked", Level.FAULT, EventKind.LINK  # device, reason
    BUS_UNBLOCKED = "bus_unblocked", Level.DONE, EventKind.LINK  # device
    ONLINE = "online", Level.DONE, EventKind.LINK
    OFFLINE = "offline", Level.WARNING, EventKind.LINK
    GENERATION = "generation", Level.INFO, EventKind.STATUS  # generation, firmware
    LIMITS_READ = "limits_read", Level.INFO, EventKind.STATUS
    LIMITS_MISSING = "limits_missing", Level.WARNING, EventKind.STATUS  # joints
    LIMITS_CORRUPT = "limits_corrupt", Level.WARNING, EventKind.STATUS  # joint
    PART_FAILED = "part_failed", Level.FAULT, EventKind.PROGRAM  # part
    SETTINGS_SHARED = "settings_shared", Level.WARNING, EventKind.PROGRAM  # path, count
    CHANNEL_SHARED = "channel_shared", Level.WARNING, EventKind.PROGRAM  # device, count
    NOBODY_MET = "nobody_met", Level.WARNING, EventKind.PROGRAM  # path, text
    FILES_HANG = "files_hang", Level.WARNING, EventKind.PROGRAM  # count
    SETTINGS_UNSAVED = "settings_unsaved", Level.WARNING, EventKind.PROGRAM  # reason
    REFUSED = "refused", Level.WARNING, EventKind.COMMAND  # reason
    QUESTION_WITHDRAWN = "question_withdrawn", Level.WARNING, EventKind.COMMAND  # question, reason


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
        started: The command that it tells the beginning of.
    """

    at: datetime
    level: Level
    code: EventCode
    params: Mapping[str, object] = field(default_factory=dict)
    started: Started | None = None
