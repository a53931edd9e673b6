"""The events of a replayed log, from its sidecar or from its frames: pure."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields
from datetime import datetime
from typing import TYPE_CHECKING, Final

from armui.arm.joint_status import Item, Word
from armui.arm.other_hosts import OtherTraffic
from armui.arm.state import ArmState
from armui.control.event_log.observed import Observed
from armui.control.event_log.observer import (
    ARM_STATUS,
    BEYOND_LIMIT,
    DRIVER_FAULTS,
    JOINT_FAULT,
    STATUS_LEVELS,
    EventObserver,
)
from armui.control.event_log.writer import EventWriter
from armui.control.events import Notice
from armui.control.requests.reports import OFFLINE_NOTICE
from armui.control.sessions.progress import SESSION_FRAMES_LOST
from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec
from armui.protocol.codes import ArmStatusCode
from armui.protocol.generation import Generation
from armui.session.session import HasDataRows, MarkKind
from armui.telemetry.event_json import LATEST_S, from_record
from armui.telemetry.events import MOST_ENTRIES, Asker, EventEntry, EventKind, EventLog, Level

if TYPE_CHECKING:
    from armui.arm.device import RecordedArm
    from armui.session.frames import Channel
    from armui.session.log_marks import IdRows
    from armui.session.session import Session, SessionMark

LOGGED_STOP = Observed("logged_stop", "Emergency stop sent")
LOGGED_RESUME = Observed("logged_resume", "Release sent")
LOGGED_ENABLE = Observed("logged_enable", "Motors: enable sent")
LOGGED_DISABLE = Observed("logged_disable", "Motors: disable sent")
LOGGED_MOTION_COMMAND = Observed(
    "logged_motion_command", "Trajectory or drag teaching command sent"
)
LOGGED_TARGETS = Observed("logged_targets", "{message} begin")
LOGGED_GRIPPER_JUMP = Observed(
    "logged_gripper_jump",
    "The gripper's reading jumps from {before} to {after} {unit} within {within_ms} ms, faster "
    "than any gripper: its angle has wrapped, its zero was set, or a second arm answers",
)
LOGGED_EPISODE = Observed("logged_episode", "Episode {number}: “{task}”")
LOGGED_DISCARDED = Observed("logged_discarded", "Episode {number}, discarded: “{task}”")
UNKNOWN_MARK = Observed("unknown_mark", "Unknown event: {code}")

Wall = Callable[[float], datetime]
_COMMANDS: Final[Mapping[str, tuple[Observed, Level]]] = {
    "stop_sent": (LOGGED_STOP, Level.WARNING),
    "resume_sent": (LOGGED_RESUME, Level.INFO),
    "enable_sent": (LOGGED_ENABLE, Level.INFO),
    "disable_sent": (LOGGED_DISABLE, Level.INFO),
    "motion_command": (LOGGED_MOTION_COMMAND, Level.INFO),
    "target": (LOGGED_TARGETS, Level.INFO),
}
_STATUS: Final = frozenset({"status", "stopped", "beyond_limit", "no_communication", "joint"})
"""The marks that stand for the arm's own reports."""
_OF_ARM: Final = EventKind.FAULT, Asker.ARM
_COMMAND: Final = EventKind.COMMAND, Asker.OTHER_HOST
_LINK: Final = EventKind.LINK, Asker.PROGRAM
_BY_PROGRAM: Final = EventKind.PROGRAM, Asker.PROGRAM

_FIELDS: Final = tuple(each.name for each in fields(EventEntry) if each.name != "number")


@dataclass(frozen=True, slots=True)
class LoggedEvents:
    """The events of a log.

    Attributes:
        log: The events in the order of time.
        marks: The moments that the replay offers to go to.
    """

    log: EventLog
    marks: Sequence[SessionMark]


def log_events(
    session: Session,
    channel: Channel,
    arm: RecordedArm,
    wall: Wall,
    is_wanted: Callable[[], bool] = lambda: True,
) -> LoggedEvents:
    """Return the events of a log in the order of time; this may take some seconds.

    A recording made in the window has its events, as told live, in a file beside it. The events of
    any other log come from the arm's frames, as they would live, and from its marks of commands and
    silences.

    Args:
        session: The log.
        channel: The channel that is shown.
        arm: The facts on the arm in the log.
        wall: Returns the local time of a log time.
        is_wanted: Called now and then; once it returns false, the rest is left out.
    """
    found: Sequence[SessionMark] = session.marks
    rows: HasDataRows | None = session if isinstance(session, HasDataRows) else None
    if rows is None and not any("number" in each.entry for each in found):
        from armui.session.log_marks import LogFrames, marks_of  # noqa: PLC0415 - numpy

        rows = gathered = _gathered(session, channel, arm, is_wanted)
        frames = LogFrames((channel,), gathered.times_and_payloads)
        told = marks_of(frames, Generation(arm.generation))
        found = sorted([*told, *found], key=lambda each: each.at_s)
    marks = [each for each in found if each.entry.get("channel", channel) == channel]
    entries: list[EventEntry] = []
    if rows is not None:
        marks = [each for each in marks if each.entry.get("code") not in _STATUS]
        entries = _events_heard(rows, channel, arm, wall)
    # an episode needs no entry of its own: its beginning and its end have theirs
    told_of = [each for each in marks if each.entry.get("code") != "episode"]
    entries += [entry_of(each, wall) for each in told_of]
    return LoggedEvents(_log_of(entries), found)


def _gathered(
    session: Session, channel: Channel, arm: RecordedArm, is_wanted: Callable[[], bool]
) -> IdRows:
    """Return the frames in which events, faults and silences are searched."""
    from armui.control.event_log.status_listener import WATCHED  # noqa: PLC0415 - with such a log
    from armui.session.log_marks import IdRows, marked_ids  # noqa: PLC0415 - numpy

    generation = Generation(arm.generation)
    codec = Codec(generation, Addressing(arm.feedback_offset))
    watched = {wire_id for wire_id, layout in codec.layouts.items() if layout.name in WATCHED}
    every, heard = marked_ids(generation)
    return IdRows(session, channel, every | watched, heard, is_wanted)


def entry_of(mark: SessionMark, wall: Wall) -> EventEntry:
    """Return a mark as an event: as it was written down, or in the live sentence for it."""
    try:
        return from_record(mark.entry) if "number" in mark.entry else _worded(mark, wall)
    except (ValueError, TypeError):
        return _unknown(mark, wall)


def _worded(mark: SessionMark, wall: Wall) -> EventEntry:
    """Return a mark as an event, in the sentence it has while connected.

    Raises:
        ValueError, TypeError: The mark does not have the form that this program writes.
    """
    code = str(mark.entry.get("code", ""))
    if mark.entry.get("kind") == "lost":
        params = {"count": mark.entry.get("count", 0)}
        level = SESSION_FRAMES_LOST.level
        return _entry(mark, wall, SESSION_FRAMES_LOST, _BY_PROGRAM, params=params, level=level)
    if code in _COMMANDS:
        logged, level = _COMMANDS[code]
        params = {"message": mark.entry["message"]} if "message" in mark.entry else {}
        return _entry(mark, wall, logged, _COMMAND, params=params, level=level)
    if code == "episode":
        params = {"number": mark.entry["episode"], "task": mark.entry["task"]}
        logged = LOGGED_DISCARDED if mark.entry["discarded"] else LOGGED_EPISODE
        by = EventKind.PROGRAM, Asker.OPERATOR
        return _entry(mark, wall, logged, by, params=params, level=Level.INFO)
    if code == "gripper_jump":
        params = {name: mark.entry[name] for name in ("before", "after", "unit", "within_ms")}
        return _entry(mark, wall, LOGGED_GRIPPER_JUMP, _OF_ARM, params=params, level=Level.WARNING)
    if code == "silent":
        level = OFFLINE_NOTICE.level
        return _entry(mark, wall, OFFLINE_NOTICE, _LINK, params={}, level=level)
    return _fault(mark, wall, code) or _unknown(mark, wall)


def _fault(mark: SessionMark, wall: Wall, code: str) -> EventEntry | None:
    """Return the event of a fault that the arm reports, in the words used while connected."""
    told, joint = mark.entry, mark.entry.get("joint")
    level = Level.FAULT
    if code in {"status", "stopped"}:
        status = told.get("status", int(ArmStatusCode.EMERGENCY_STOP))
        level = STATUS_LEVELS.get(int(str(status)), Level.FAULT)
        observed, params = ARM_STATUS, {"status": status}
    elif code == "beyond_limit":
        observed, params, level = BEYOND_LIMIT, {"joint": joint}, Level.WARNING
    elif code == "no_communication":
        observed, params = _row(joint, Item.COMMUNICATION, Word.ABNORMAL)
    elif code == "joint" and told.get("what") in DRIVER_FAULTS:
        observed, params = _row(joint, *DRIVER_FAULTS[str(told["what"])])
    else:
        return None
    return _entry(mark, wall, observed, _OF_ARM, params=params, level=level)


def _row(joint: object, item: Item, word: Word) -> tuple[Observed, dict[str, object]]:
    return JOINT_FAULT, {"joint": joint, "item": item.name, "word": word.name}


def _unknown(mark: SessionMark, wall: Wall) -> EventEntry:
    """Return an event for a mark of a newer program or a damaged line, with its code unchanged."""
    params = {"code": str(mark.entry.get("code", mark.entry.get("kind", "?")))}
    faults = {MarkKind.FAULT, MarkKind.STOP}
    level = Level.FAULT if mark.kind in faults else Level.INFO
    return _entry(mark, wall, UNKNOWN_MARK, _BY_PROGRAM, params=params, level=level)


def _entry(
    mark: SessionMark,
    wall: Wall,
    what: Notice | Observed,
    by: tuple[EventKind, Asker],
    *,
    params: Mapping[str, object],
    level: Level,
) -> EventEntry:
    ended_s = mark.entry.get("ended_s")
    if not isinstance(ended_s, int | float) or not abs(ended_s) <= LATEST_S:
        ended_s = None
    return EventEntry(
        number=0,
        at_s=mark.at_s,
        wall=wall(mark.at_s),
        level=level,
        kind=by[0],
        who=by[1],
        code=what.id,
        params=params,
        lasts="ended_s" in mark.entry,
        ended_s=ended_s,
    )


def _events_heard(
    session: HasDataRows, channel: Channel, arm: RecordedArm, wall: Wall
) -> list[EventEntry]:
    """Return the events of the arm that a program connected at the time would have noted."""
    from armui.control.event_log.log_status import MOST, status_changes  # noqa: PLC0415 - numpy

    offset = arm.feedback_offset
    codec = Codec(Generation(arm.generation), Addressing(offset))
    noted = status_changes(session, channel, codec)
    log = EventLog(MOST)
    writer = EventWriter(log, wall)
    end_s = noted[-1].at_s if noted else 0.0
    for change in EventObserver().observe(noted, ArmState(), OtherTraffic(), end_s):
        writer.write(change)
    return log.entries()


def _log_of(entries: Iterable[EventEntry]) -> EventLog:
    """Return an event log of entries, numbered in the order of time."""
    ordered = sorted(entries, key=lambda each: each.at_s)
    log = EventLog(max(len(ordered), MOST_ENTRIES))
    for entry in ordered:
        log.add(**{name: getattr(entry, name) for name in _FIELDS})
    return log
