"""Of every notice: what sort it is, who asked, and of commands, what answers and what ends them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from armui.control.events import EventCode as E
from armui.protocol.codes import SettingIndex
from armui.telemetry.events import Asker, EventKind


@dataclass(frozen=True, slots=True)
class CommandRule:
    """How a command is followed.

    Attributes:
        ends: The notices that say what became of it.
        answer: What the arm's answer names (0x476); ``None``: it gives none.
        same: The figure that a notice must share with the command to be about it.
        moves: It moves the arm: what ends it is known to the authority.
    """

    ends: frozenset[E] = frozenset()
    answer: SettingIndex | None = None
    same: str | None = None
    moves: bool = False


def _rule(
    *ends: E, answer: SettingIndex | None = None, same: str | None = None, moves: bool = False
) -> CommandRule:
    return CommandRule(frozenset(ends), answer, same, moves)


MOTION: Final = _rule(E.MOTION_UNHEEDED, moves=True)
"""A motion to a target."""
_RUN_ENDS: Final = (E.RUN_DONE, E.RUN_ENDED, E.RUN_FAILED, E.REPLAY_ENDED, E.REPLAY_FAILED)
_ENABLE: Final = SettingIndex.MOTOR_ENABLE
_JOINT: Final = SettingIndex.JOINT_SETTING
_LINKAGE: Final = SettingIndex.LINKAGE_SETTING
_PARAMETER: Final = SettingIndex.PARAMETER_COMMAND

COMMANDS: Final[Mapping[E, CommandRule]] = {
    E.SENT_JOINTS: MOTION,
    E.JOGGED: MOTION,
    E.WENT_HOME: MOTION,
    E.SENT_POSE: MOTION,
    E.SENT_LINE: MOTION,
    E.SENT_ARC: MOTION,
    E.STEPPED_TOOL: MOTION,
    E.JOGGING_JOINT: _rule(E.JOG_ENDED, E.MOTION_UNHEEDED, moves=True),
    E.JOGGING_TOOL: _rule(E.JOG_ENDED, E.MOTION_UNHEEDED, moves=True),
    E.DEVICE_JOGS_JOINTS: _rule(E.JOG_ENDED, E.MOTION_UNHEEDED, moves=True),
    E.DEVICE_JOGS_BASE: _rule(E.JOG_ENDED, E.MOTION_UNHEEDED, moves=True),
    E.DEVICE_JOGS_TOOL: _rule(E.JOG_ENDED, E.MOTION_UNHEEDED, moves=True),
    E.SENT_SPEED: _rule(),
    E.SPEED_WAITS: _rule(),
    E.SENT_LAMP: _rule(),
    E.SENT_LAMPS: _rule(),
    E.TAKEN_OVER: _rule(),
    E.MODE_LEFT: _rule(),
    E.STOP_SENT: _rule(
        *(E.STOP_CONFIRMED, E.STOP_UNCONFIRMED, E.STOP_LAPSED, E.STOP_WITHDRAWN, E.STOP_ABANDONED)
    ),
    E.STOP_NOT_SENT: _rule(E.STOP_CONFIRMED, E.STOP_UNCONFIRMED, E.STOP_LAPSED, E.STOP_WITHDRAWN),
    E.HALT_SENT: _rule(E.HALT_AT_REST),
    E.HALT_NOT_OUT: _rule(E.HALT_AT_REST),
    E.RESUME_SENT: _rule(E.RESUMED, E.RESUME_FAILED),
    E.ENABLE_SENT: _rule(E.ENABLED, E.ENABLE_FAILED, answer=_ENABLE),
    E.DISABLE_SENT: _rule(E.DISABLED, E.DISABLE_FAILED, answer=_ENABLE),
    E.ENABLE_SENT_JOINT: _rule(E.ENABLED_JOINT, E.ENABLE_FAILED, answer=_ENABLE),
    E.DISABLE_SENT_JOINT: _rule(E.DISABLED_JOINT, E.DISABLE_FAILED, answer=_ENABLE),
    E.CLEAR_ERROR_SENT: _rule(
        E.CLEAR_ERROR_ANSWERED, E.CLEAR_ERROR_UNANSWERED, answer=_JOINT, same="joint"
    ),
    E.MOUNTING_SENT: _rule(),
    E.LOAD_SENT: _rule(E.LOAD_ANSWERED, E.LOAD_FAILED, answer=_PARAMETER),
    E.END_FEEDBACK_SENT: _rule(
        E.END_FEEDBACK_ON, E.END_FEEDBACK_OFF, E.END_FEEDBACK_FAILED, answer=_PARAMETER
    ),
    E.LINKAGE_SENT: _rule(
        *(E.LINKAGE_ANSWERED, E.LINKAGE_ANSWERED_INPUT, E.LINKAGE_FAILED, E.LINKAGE_IN_USE),
        answer=_LINKAGE,
    ),
    E.GRIPPER_SENT: _rule(E.GRIPPER_THERE, E.GRIPPER_GRIPS, E.GRIPPER_NOT_THERE),
    E.GRIPPER_ACT_SENT: _rule(E.GRIPPER_ACT_DONE, E.GRIPPER_ACT_FAILED, same="act"),
    E.ZERO_SENT: _rule(E.ZERO_SET, E.ZERO_FAILED, answer=_JOINT),
    E.ZERO_SENT_JOINT: _rule(E.ZERO_SET_JOINT, E.ZERO_FAILED, answer=_JOINT),
    E.SETTINGS_SENT: _rule(E.SETTINGS_SAVED, E.SETTINGS_REFUSED),
    E.SETTINGS_RESET_SENT: _rule(E.SETTINGS_RESET, E.SETTINGS_RESET_FAILED, answer=_PARAMETER),
    E.RUN_STARTED: _rule(*_RUN_ENDS),
    E.RUN_PAUSED: _rule(),
    E.RUN_CONTINUED: _rule(),
    E.REPLAY_PAUSED: _rule(),
    E.REPLAY_CONTINUED: _rule(),
    E.TEACHING_SENT: _rule(E.TEACHING_DONE, E.TEACHING_UNANSWERED, same="command"),
    E.PLAN_SENT: _rule(),
    E.STANDBY_SENT: _rule(E.STEP_IN_VAIN),
    E.MOTION_OUTPUT_SENT: _rule(E.STEP_IN_VAIN, E.ONLINE, answer=_LINKAGE),
    E.RECORDING_STARTED: _rule(E.RECORDING_ENDED),
    E.FRAME_SENT_BY_HAND: _rule(),
    E.SESSION_STARTED: _rule(E.SESSION_ENDED, E.SESSION_FAILED),
    E.REFUSED: _rule(),
    E.QUESTION_WITHDRAWN: _rule(),
}
"""Every command, by the notice that tells it."""

SETTINGS: Final = frozenset(
    {
        *(SettingIndex.LIMIT_SETTING, SettingIndex.JOINT_SETTING, SettingIndex.END_LIMIT_SETTING),
        *(SettingIndex.COLLISION_SETTING, SettingIndex.TEACHING_SETTING),
        SettingIndex.DRAG_ASSISTANCE_SETTING,
    }
)
"""What answers saved settings, which go out one frame after the other."""

LASTING: Final[Mapping[E, frozenset[E]]] = {
    E.OFFLINE: frozenset({E.ONLINE, E.LINK_LOST, E.DISCONNECTED}),
    E.LINK_LOST: frozenset({E.RECONNECTED, E.DISCONNECTED}),
    E.BUS_BLOCKED: frozenset({E.BUS_UNBLOCKED, E.LINK_LOST, E.DISCONNECTED}),
    E.MODEL_OTHER: frozenset({E.LINK_LOST, E.DISCONNECTED}),
    E.MODEL_NONE: frozenset({E.LINK_LOST, E.DISCONNECTED}),
    E.OTHER_HOST_MOVES: frozenset({E.OTHER_HOST_GONE, E.LINK_LOST, E.DISCONNECTED}),
    E.LEADER_ARM_MOVES: frozenset({E.OTHER_HOST_GONE, E.LINK_LOST, E.DISCONNECTED}),
}
"""What goes on from one notice to another."""

_RESULTS: Final = frozenset(
    {code for rule in COMMANDS.values() for code in rule.ends}
    | {E.STOP_REACHES_OTHER, E.STOP_UNDONE, E.MOTION_TOO_FAST, E.CANCEL_UNHEEDED}
)
_LINK: Final = frozenset(
    {
        *(E.CONNECTED, E.CONNECT_FAILED, E.DISCONNECTED, E.LINK_LOST, E.RECONNECTED),
        *(E.BUS_BLOCKED, E.BUS_UNBLOCKED, E.ONLINE, E.OFFLINE, E.LINKAGE_FOUND, E.LINKAGE_IN_USE),
    }
)
_OTHER_HOST: Final = frozenset({E.OTHER_HOST_MOVES, E.LEADER_ARM_MOVES, E.OTHER_HOST_GONE})
_STATUS: Final = frozenset(
    {
        *(E.GENERATION, E.LIMITS_READ, E.LIMITS_MISSING, E.LIMITS_CORRUPT),
        *(E.MODEL_OTHER, E.MODEL_NONE, E.MODEL_RECALLED, E.MODEL_WAS_OTHER),
    }
)
_PROGRAM: Final = frozenset(
    {
        *(E.PART_FAILED, E.SETTINGS_SHARED, E.CHANNEL_SHARED, E.NOBODY_MET, E.FILES_HANG),
        E.SETTINGS_UNSAVED,
        *(E.RING_SAVED, E.RING_NOT_SAVED, E.SESSION_FRAMES_LOST, E.MF4_SAVED, E.MF4_NOT_SAVED),
    }
)
_BY_BUTTON: Final = frozenset({E.JOGGING_JOINT, E.JOGGING_TOOL})
_BY_DEVICE: Final = frozenset({E.DEVICE_JOGS_JOINTS, E.DEVICE_JOGS_BASE, E.DEVICE_JOGS_TOOL})
JOGS: Final = _BY_BUTTON | _BY_DEVICE
"""What a held button begins: its motion is sent a moment later."""
_JOG: Final = _BY_BUTTON | {E.JOG_ENDED}
_RUN: Final = frozenset(_RUN_ENDS)
_BY_PROGRAM: Final = frozenset(
    {
        *(E.CANCEL_UNHEEDED, E.MOTION_UNHEEDED, E.MOTION_TOO_FAST, E.CONNECT_FAILED),
        *(E.STOP_UNCONFIRMED, E.STOP_LAPSED, E.STOP_ABANDONED, E.STOP_UNDONE, E.STOP_REACHES_OTHER),
        *(E.RESUME_FAILED, E.ENABLE_FAILED, E.DISABLE_FAILED, E.CLEAR_ERROR_UNANSWERED),
        *(E.LOAD_FAILED, E.END_FEEDBACK_FAILED, E.LINKAGE_FAILED, E.GRIPPER_NOT_THERE),
        *(E.GRIPPER_ACT_FAILED, E.ZERO_FAILED, E.SETTINGS_REFUSED, E.SETTINGS_RESET_FAILED),
        *(E.TEACHING_UNANSWERED, E.STEP_IN_VAIN, E.RECORDING_ENDED),
        *(E.SESSION_ENDED, E.SESSION_FAILED),
    }
)
_BY_OPERATOR: Final = frozenset({E.CONNECTED, E.DISCONNECTED, E.STOP_WITHDRAWN})


def kind_of(code: E) -> EventKind:
    """What sort of event a notice is."""
    for kind, codes in (
        (EventKind.COMMAND, COMMANDS),
        (EventKind.LINK, _LINK),
        (EventKind.OTHER_HOST, _OTHER_HOST),
        (EventKind.STATUS, _STATUS),
        (EventKind.PROGRAM, _PROGRAM),
        (EventKind.ODDITY, {E.FRAMES_DROPPED}),
        (EventKind.RESULT, _RESULTS),
    ):
        if code in codes:
            return kind
    raise KeyError(code)


def who_of(code: E) -> Asker:
    """Who asked for it, or says it, unless the recovery line was pressed."""
    if code in _JOG:
        return Asker.JOG
    if code in _RUN:
        return Asker.RUN
    if code in _OTHER_HOST:
        return Asker.OTHER_HOST
    if code in COMMANDS or code in _BY_OPERATOR:
        return Asker.OPERATOR
    kind = kind_of(code)
    by_program = kind in {EventKind.PROGRAM, EventKind.LINK, EventKind.ODDITY}
    return Asker.PROGRAM if by_program or code in _BY_PROGRAM else Asker.ARM


STREAMS: Final = frozenset(
    {
        *(E.SENT_SPEED, E.SPEED_WAITS, E.JOGGED, E.STEPPED_TOOL, E.SENT_LAMP, E.SENT_LAMPS),
        E.FRAMES_DROPPED,
    }
)
"""What comes one after the other, while something is dragged or held: it is counted, and the
newest figures stand."""
