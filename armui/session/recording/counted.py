"""The numbers of faults and stops in a recording, kept in its sidecar.

A recording of the window has its events in its sidecar. One that was recorded without a window has
none: its frames are examined once, when it has ended or when it is opened, and the result is added
to the sidecar as a line of the kind ``counted``.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final, NamedTuple

from armui.protocol.codes import ArmStatusCode
from armui.session.log_marks import IdRows, LogFrames, marked_ids, marks_of
from armui.session.recording import index_file, sidecar
from armui.session.session import MarkKind
from armui.session.survey import survey
from armui.system.files import open_file

if TYPE_CHECKING:
    from pathlib import Path

    from armui.session.session import Session, SessionMark

KIND: Final = "counted"
_SENT: Final = "stop_sent"
_OVER_S: Final = 60.0
"""A recording that has not grown for this long was left by a killed program."""


class Counts(NamedTuple):
    """The numbers of faults and stops in a recording.

    Attributes:
        faults: The faults that began: of the arm, of a joint, or silence; emergency stops do not
            count.
        stops: The emergency stops, sent or reported by the arm; the same one is usually both.
    """

    faults: int
    stops: int


def counts_of(marks: Sequence[SessionMark]) -> Counts:
    """Return the counts in marks made of frames or of the program's events."""
    told = [_is_stopped(each.entry) for each in marks]
    sent = sum(each.entry.get("code") == _SENT for each in marks)
    faults = sum(
        each.kind is MarkKind.FAULT and not stopped
        for each, stopped in zip(marks, told, strict=True)
    )
    return Counts(faults, max(sent, sum(told)))


def _is_stopped(entry: Mapping[str, object]) -> bool:
    """Return whether a mark is the arm's report of a stop, from its frames or from an event."""
    params = entry.get("params")
    status = params.get("status") if isinstance(params, Mapping) else None
    as_event = entry.get("code") == "arm_status" and status == ArmStatusCode.EMERGENCY_STOP
    return entry.get("code") == "stopped" or as_event


def counted(session: Session) -> Counts:
    """Return the counts of all frames of a recording; half an hour of an arm takes some seconds."""
    own = survey(session)[0]
    rows = IdRows(session, own.channel, *marked_ids(own.generation))
    frames = LogFrames((own.channel,), rows.times_and_payloads)
    return counts_of(marks_of(frames, own.generation))


def counts_in(lines: Sequence[Mapping[str, Any]]) -> Counts | None:
    """Return the counts in a sidecar, or ``None`` if it has none."""
    told = next((line for line in reversed(lines) if line["kind"] == KIND), None)
    if told is not None:
        figures = told.get("faults"), told.get("stops")
        if all(isinstance(each, int) for each in figures):
            return Counts(*figures)
    if any(line["kind"] == "event" for line in lines):
        return counts_of(sidecar.marks_of(lines))
    recorded_alone = bool(lines) and lines[0].get("reason") == "command"
    return None if recorded_alone else Counts(0, 0)


def is_over(folder: Path, name: str, lines: Sequence[Mapping[str, Any]]) -> bool:
    """Return whether a recording is no longer being written, by this or another program."""
    if any(line["kind"] == "end" for line in lines):
        return True
    try:
        written_s = (folder / f"{name}{index_file.SUFFIX}").stat().st_mtime
    except OSError:
        return False
    return time.time() - written_s > _OVER_S


def keep(folder: Path, name: str, counts: Counts) -> None:
    """Add the counts to a sidecar; one that cannot be written is left as it is."""
    line = sidecar.as_bytes([{"kind": KIND, **counts._asdict()}])
    with contextlib.suppress(OSError), open_file(sidecar.path_of(folder, name), "r+b") as file:
        # a killed program may have left half a line
        file.seek(0, 2)
        if file.tell():
            file.seek(-1, 2)
            line = line if file.read(1) == b"\n" else b"\n" + line
        file.seek(0, 2)
        file.write(line)
