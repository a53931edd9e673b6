"""The entries of the event log as sentences, and the words of its columns and filters."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.arm.gripper import GripperFault
from armui.arm.joint_status import Item, Word
from armui.arm.parameters import Parameter
from armui.arm.refusal import Refusal
from armui.control.event_log.observed import ObservedCode
from armui.control.motion.motion_command import End
from armui.protocol.codec import InvalidFrameKind
from armui.telemetry.events import Asker, EventEntry, EventKind, EventOutcome, Level
from armui.ui.words import status
from armui.ui.words.events import event_text
from armui.ui.words.gripper import gripper_fault
from armui.ui.words.joints import joint_item, joint_word
from armui.ui.words.parameters import full_name, value_text
from armui.ui.words.refusals import refusal
from armui.ui.words.text import NOT_KNOWN, listed, sentence

_OBSERVED: Final[Mapping[str, object]] = {
    ObservedCode.CONTROL_MODE: QT_TRANSLATE_NOOP("Observed", "Control mode: {before} → {mode}"),
    ObservedCode.MOVE_MODE: QT_TRANSLATE_NOOP("Observed", "Motion mode: {before} → {mode}"),
    ObservedCode.ARM_STATUS: QT_TRANSLATE_NOOP("Observed", "Arm status: {status}"),
    ObservedCode.TEACHING: QT_TRANSLATE_NOOP("Observed", "Drag teaching: {before} → {state}"),
    ObservedCode.MOTION: QT_TRANSLATE_NOOP("Observed", "Target not reached"),
    ObservedCode.MOTORS_ON: QT_TRANSLATE_NOOP("Observed", "Motors enabled: {joints}"),
    ObservedCode.MOTORS_OFF: QT_TRANSLATE_NOOP("Observed", "Motors disabled: {joints}"),
    ObservedCode.JOINT_FAULT: QT_TRANSLATE_NOOP("Observed", "J{joint} {item} {word}"),
    ObservedCode.BEYOND_LIMIT: QT_TRANSLATE_NOOP("Observed", "J{joint} beyond its angle limit"),
    ObservedCode.GRIPPER_FAULT: QT_TRANSLATE_NOOP("Observed", "Gripper: {fault}"),
    ObservedCode.LIMITS_UNUSABLE: QT_TRANSLATE_NOOP(
        "Observed", "J{joint}: the limits stored in the arm cannot be true"
    ),
    ObservedCode.OTHER_FRAMES: QT_TRANSLATE_NOOP("Observed", "Another host sends {id}"),
    ObservedCode.INVALID_FRAMES: QT_TRANSLATE_NOOP(
        "Observed", "Frames not understood: {kind} (last {id})"
    ),
    ObservedCode.FEWER_FRAMES: QT_TRANSLATE_NOOP(
        "Observed", "The arm's status frames come more rarely: {share} % fewer than before"
    ),
    ObservedCode.RUN_POINT: QT_TRANSLATE_NOOP("Observed", "Sent the point of row {row}"),
    ObservedCode.ARRIVED: QT_TRANSLATE_NOOP("Observed", "Target reached, says the arm"),
    ObservedCode.MOTION_CUT: QT_TRANSLATE_NOOP("Observed", "Not driven to its end: {end}"),
    ObservedCode.ANSWERED: QT_TRANSLATE_NOOP("Observed", "Answered with 0x476 (setting {index})"),
    ObservedCode.PROBLEM: QT_TRANSLATE_NOOP("Observed", "{reason}"),
    ObservedCode.NOT_KEPT: QT_TRANSLATE_NOOP(
        "Observed",
        "The events cannot be written to the disk; the newest are kept in memory. {text}",
    ),
    ObservedCode.LOGGED_STOP: QT_TRANSLATE_NOOP("Observed", "Emergency stop sent"),
    ObservedCode.LOGGED_RESUME: QT_TRANSLATE_NOOP("Observed", "Resume sent"),
    ObservedCode.LOGGED_ENABLE: QT_TRANSLATE_NOOP("Observed", "Motors: enable sent"),
    ObservedCode.LOGGED_DISABLE: QT_TRANSLATE_NOOP("Observed", "Motors: disable sent"),
    ObservedCode.LOGGED_MOTION_COMMAND: QT_TRANSLATE_NOOP(
        "Observed", "Trajectory or drag teaching command sent"
    ),
    ObservedCode.LOGGED_TARGETS: QT_TRANSLATE_NOOP("Observed", "{message} begin"),
    ObservedCode.UNKNOWN_MARK: QT_TRANSLATE_NOOP("Observed", "Unknown event: {code}"),
}
OBSERVED_CODES: Final = frozenset(_OBSERVED)
"""What there is a sentence for."""

_ENDS: Final[Mapping[str, object]] = {
    "short": QT_TRANSLATE_NOOP("MotionEnd", "the arm stands before its target"),
    End.REPLACED.name: QT_TRANSLATE_NOOP("MotionEnd", "a newer command took its place"),
    End.CANCELLED.name: QT_TRANSLATE_NOOP("MotionEnd", "cancelled"),
    End.STOPPED.name: QT_TRANSLATE_NOOP("MotionEnd", "emergency stop"),
    End.DISABLED.name: QT_TRANSLATE_NOOP("MotionEnd", "motors without power"),
    End.OTHER_HOST.name: QT_TRANSLATE_NOOP("MotionEnd", "another host moved the arm"),
    End.TAUGHT.name: QT_TRANSLATE_NOOP("MotionEnd", "drag teaching began"),
    End.OTHER_MODE.name: QT_TRANSLATE_NOOP("MotionEnd", "the arm left CAN control"),
    End.SILENT.name: QT_TRANSLATE_NOOP("MotionEnd", "the arm fell silent"),
    End.LIMITS_CHANGED.name: QT_TRANSLATE_NOOP("MotionEnd", "the joint limits changed"),
    End.ZERO_CHANGED.name: QT_TRANSLATE_NOOP("MotionEnd", "a zero was set"),
    End.MOVED_AWAY.name: QT_TRANSLATE_NOOP("MotionEnd", "the arm stands elsewhere"),
    End.NOT_SENT.name: QT_TRANSLATE_NOOP("MotionEnd", "its frames did not get out"),
    End.FORGOTTEN.name: QT_TRANSLATE_NOOP("MotionEnd", "disconnected"),
}
_TARGETS: Final[Mapping[str, object]] = {
    "JointTarget12": QT_TRANSLATE_NOOP("Targets", "Joint targets"),
    "CartesianTarget1": QT_TRANSLATE_NOOP("Targets", "Pose targets"),
    "MitControl1": QT_TRANSLATE_NOOP("Targets", "MIT commands"),
    "GripperCommand": QT_TRANSLATE_NOOP("Targets", "Gripper commands"),
}
_FRAME_KINDS: Final[Mapping[str, object]] = {
    InvalidFrameKind.UNKNOWN_ID.name: QT_TRANSLATE_NOOP("FrameKind", "unknown identifier"),
    InvalidFrameKind.WRONG_LENGTH.name: QT_TRANSLATE_NOOP("FrameKind", "wrong length"),
    InvalidFrameKind.VALUE_OUTSIDE_TABLE.name: QT_TRANSLATE_NOOP(
        "FrameKind", "value outside its table"
    ),
}
_ASKERS: Final[Mapping[Asker, object]] = {
    Asker.OPERATOR: QT_TRANSLATE_NOOP("Asker", "Operator"),
    Asker.RUN: QT_TRANSLATE_NOOP("Asker", "Run"),
    Asker.JOG: QT_TRANSLATE_NOOP("Asker", "Jogging"),
    Asker.RECOVERY: QT_TRANSLATE_NOOP("Asker", "Recovery"),
    Asker.ARM: QT_TRANSLATE_NOOP("Asker", "Arm"),
    Asker.OTHER_HOST: QT_TRANSLATE_NOOP("Asker", "Other host"),
    Asker.PROGRAM: QT_TRANSLATE_NOOP("Asker", "Program"),
}
_KINDS: Final[Mapping[EventKind, object]] = {
    EventKind.COMMAND: QT_TRANSLATE_NOOP("EventKind", "Command"),
    EventKind.RESULT: QT_TRANSLATE_NOOP("EventKind", "Result"),
    EventKind.STATUS: QT_TRANSLATE_NOOP("EventKind", "Status"),
    EventKind.FAULT: QT_TRANSLATE_NOOP("EventKind", "Fault"),
    EventKind.LINK: QT_TRANSLATE_NOOP("EventKind", "Connection"),
    EventKind.OTHER_HOST: QT_TRANSLATE_NOOP("EventKind", "Other host"),
    EventKind.ODDITY: QT_TRANSLATE_NOOP("EventKind", "Bus"),
    EventKind.PROGRAM: QT_TRANSLATE_NOOP("EventKind", "Program"),
}
_LEVELS: Final[Mapping[Level, object]] = {
    Level.INFO: QT_TRANSLATE_NOOP("Level", "Information"),
    Level.DONE: QT_TRANSLATE_NOOP("Level", "Done"),
    Level.WARNING: QT_TRANSLATE_NOOP("Level", "Warning"),
    Level.FAULT: QT_TRANSLATE_NOOP("Level", "Fault"),
}


def asker(who: Asker) -> str:
    """Who asked, for a column."""
    return QCoreApplication.translate("Asker", str(_ASKERS[who]))


def event_kind(kind: EventKind) -> str:
    """What sort of event, for a column."""
    return QCoreApplication.translate("EventKind", str(_KINDS[kind]))


def event_level(level: Level) -> str:
    """How grave, for a filter."""
    return QCoreApplication.translate("Level", str(_LEVELS[level]))


def entry_text(entry: EventEntry) -> str:
    """What happened, as a sentence."""
    return _text(entry.code, entry.params)


def outcome_text(outcome: EventOutcome) -> str:
    """What became of a command, as a sentence."""
    return _text(outcome.code, outcome.params)


def _text(code: str, params: Mapping[str, object]) -> str:
    """A sentence, whatever the figures are: they may come from a file."""
    source = _OBSERVED.get(code)
    try:
        if source is None:
            return " ".join([event_text(code, params), *_values(params)])
        return sentence("Observed", source, _figures(code, params)).rstrip()
    except (KeyError, ValueError, TypeError):
        return f"{code} {dict(params)}"


def _figures(code: str, params: Mapping[str, object]) -> dict[str, object]:
    figures = dict(params)
    for name, word in _FIGURES.get(code, {}).items():
        value = params.get(name)
        figures[name] = NOT_KNOWN if value is None else word(value)
    return figures


def _values(params: Mapping[str, object]) -> list[str]:
    """Of settings that were sent, each with its value."""
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


def _translated(context: str, words: Mapping[str, object], name: object) -> str:
    source = words.get(str(name))
    return str(name) if source is None else QCoreApplication.translate(context, str(source))


def _control_mode(code: Any) -> str:
    return status.control_mode_short(int(code))


_FIGURES: Final[Mapping[str, Mapping[str, Callable[[Any], str]]]] = {
    ObservedCode.CONTROL_MODE: {"mode": _control_mode, "before": _control_mode},
    ObservedCode.MOVE_MODE: {"mode": status.move_mode, "before": status.move_mode},
    ObservedCode.ARM_STATUS: {"status": status.arm_status},
    ObservedCode.TEACHING: {"state": status.teaching, "before": status.teaching},
    ObservedCode.MOTORS_ON: {"joints": _joints},
    ObservedCode.MOTORS_OFF: {"joints": _joints},
    ObservedCode.JOINT_FAULT: {
        "item": lambda name: joint_item(Item[name]),
        "word": lambda name: joint_word(Word[name]),
    },
    ObservedCode.GRIPPER_FAULT: {"fault": lambda name: gripper_fault(GripperFault(name))},
    ObservedCode.INVALID_FRAMES: {
        "kind": lambda name: _translated("FrameKind", _FRAME_KINDS, name)
    },
    ObservedCode.MOTION_CUT: {"end": lambda name: _translated("MotionEnd", _ENDS, name)},
    ObservedCode.PROBLEM: {"reason": _reason},
    ObservedCode.NOT_KEPT: {"text": str},
    ObservedCode.LOGGED_TARGETS: {"message": lambda name: _translated("Targets", _TARGETS, name)},
}
"""How the figures of a sentence are put into words."""
