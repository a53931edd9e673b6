"""The entries of the event log as sentences, and the texts of its columns and filters."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Final

from armui.arm.joint_status import Item, Word
from armui.arm.parameters import Parameter
from armui.arm.refusal import Refusal
from armui.arm.state import GripperFault
from armui.control.authority_watch import MOTION_CUT
from armui.control.event_log.collector import NOT_KEPT, PROBLEM
from armui.control.event_log.log_events import LOGGED_TARGETS
from armui.control.event_log.observed import Observed
from armui.control.event_log.observer import (
    ARM_STATUS,
    CONTROL_MODE,
    GRIPPER_FAULT,
    INVALID_FRAMES,
    JOINT_FAULT,
    MOTORS_OFF,
    MOTORS_ON,
    MOVE_MODE,
    TEACHING,
)
from armui.control.events import Notice
from armui.control.motion.motion_command import End
from armui.protocol.codec import InvalidFrameKind
from armui.telemetry.events import Asker, EventEntry, EventKind, EventOutcome, Level
from armui.ui.words import arm
from armui.ui.words.arm import GRIPPER_FAULTS, joint_item, joint_word
from armui.ui.words.events import notice_text
from armui.ui.words.parameters import full_name, value_text
from armui.ui.words.refusals import refusal
from armui.ui.words.text import NOT_KNOWN, Texts, listed, sentence, source_of

_ENDS: Final = Texts("MotionEnd") | {
    "short": "the arm stopped before its target",
    "refused": "the arm itself refused the target",
    End.REPLACED.name: "a newer command took its place",
    End.CANCELLED.name: "cancelled",
    End.STOPPED.name: "emergency stop",
    End.DISABLED.name: "motors without power",
    End.OTHER_HOST.name: "another host moved the arm",
    End.TAUGHT.name: "drag teaching began",
    End.OTHER_MODE.name: "the arm left CAN control",
    End.SILENT.name: "no more feedback from the arm",
    End.LIMITS_CHANGED.name: "the joint limits changed",
    End.ZERO_CHANGED.name: "a zero was set",
    End.TOOL_CHANGED.name: "the tool changed",
    End.MOVED_AWAY.name: "the arm stopped elsewhere",
    End.NOT_SENT.name: "its frames were not sent",
    End.FORGOTTEN.name: "disconnected",
}
_TARGETS: Final = Texts("Targets") | {
    "JointTarget12": "Joint targets",
    "CartesianTarget1": "Pose targets",
    "MitControl1": "MIT commands",
    "GripperCommand": "Gripper commands",
}
_FRAME_KINDS: Final = Texts("FrameKind") | {
    InvalidFrameKind.UNKNOWN_ID.name: "unknown identifier",
    InvalidFrameKind.WRONG_LENGTH.name: "wrong length",
    InvalidFrameKind.VALUE_OUTSIDE_TABLE.name: "value outside its table",
}
_ASKERS: Final = Texts("Asker") | {
    Asker.OPERATOR: "Operator",
    Asker.RUN: "Run",
    Asker.JOG: "Jogging",
    Asker.RECOVERY: "Recovery",
    Asker.ARM: "Arm",
    Asker.OTHER_HOST: "Other host",
    Asker.CLIENT: "Client",
    Asker.CLIENT: "Client",
    Asker.PROGRAM: "Program",
}
EVENT_KINDS: Final = Texts("EventKind") | {
    EventKind.COMMAND: "Command",
    EventKind.RESULT: "Result",
    EventKind.STATUS: "Status",
    EventKind.FAULT: "Fault",
    EventKind.LINK: "Connection",
    EventKind.OTHER_HOST: "Other host",
    EventKind.ODDITY: "Bus",
    EventKind.PROGRAM: "Program",
}
_LEVELS: Final = Texts("Level") | {
    Level.INFO: "Information",
    Level.DONE: "Done",
    Level.WARNING: "Warning",
    Level.FAULT: "Fault",
}


def asker(who: Asker) -> str:
    """Return the source of an event, for a column."""
    return _ASKERS.text(who)


def event_kind(kind: EventKind) -> str:
    """Return the kind of an event, for a column."""
    return EVENT_KINDS.text(kind)


def event_level(level: Level) -> str:
    """Return the severity of an event, for a filter."""
    return _LEVELS.text(level)


def entry_text(entry: EventEntry) -> str:
    """Return the sentence of an event."""
    return _text(entry.code, entry.params)


def outcome_text(outcome: EventOutcome) -> str:
    """Return the sentence on the outcome of a command."""
    return _text(outcome.code, outcome.params)


def _text(code: str, params: Mapping[str, object]) -> str:
    """Return the sentence of an event, or its bare code and figures if a file holds odd ones."""
    try:
        observed = Observed(code)
        if source := source_of(observed):
            return sentence(Observed.context, source, _figures(observed, params)).rstrip()
        return " ".join([notice_text(Notice(code), params), *_values(params)])
    except (KeyError, ValueError, TypeError):
        return f"{code} {dict(params)}"


def _figures(observed: Observed, params: Mapping[str, object]) -> dict[str, object]:
    figures = dict(params)
    for name, word in _FIGURES.get(observed, {}).items():
        value = params.get(name)
        figures[name] = NOT_KNOWN if value is None else word(value)
    return figures


def _values(params: Mapping[str, object]) -> list[str]:
    """Return the settings that were sent, with their values in brackets; [] if there are none."""
    values = params.get("values", ())
    if not isinstance(values, tuple) or not values:
        return []
    texts = (
        f"{full_name(Parameter(name, joint))} {value_text(name, value)}"
        for name, joint, value in values
    )
    return [f"({', '.join(texts)})"]


def _joints(joints: object) -> str:
    return listed(f"J{joint}" for joint in joints) if isinstance(joints, tuple) else str(joints)


def _reason(reason: object) -> str:
    return refusal(reason) if isinstance(reason, Refusal) else str(reason)


def _control_mode(code: Any) -> str:
    return arm.control_mode_short(int(code))


_FIGURES: Final[Mapping[Observed, Mapping[str, Callable[[Any], str]]]] = {
    CONTROL_MODE: {"mode": _control_mode, "before": _control_mode},
    MOVE_MODE: {"mode": arm.move_mode, "before": arm.move_mode},
    ARM_STATUS: {"status": arm.arm_status},
    TEACHING: {"state": arm.teaching, "before": arm.teaching},
    MOTORS_ON: {"joints": _joints},
    MOTORS_OFF: {"joints": _joints},
    JOINT_FAULT: {
        "item": lambda name: joint_item(Item[name]).rstrip(":"),
        "word": lambda name: joint_word(Word[name]),
    },
    GRIPPER_FAULT: {"fault": lambda name: GRIPPER_FAULTS.text(GripperFault(name))},
    INVALID_FRAMES: {"kind": _FRAME_KINDS.word},
    MOTION_CUT: {"end": _ENDS.word},
    PROBLEM: {"reason": _reason},
    NOT_KEPT: {"text": str},
    LOGGED_TARGETS: {"message": _TARGETS.word},
}
"""The functions that put the figures of a sentence into words."""
