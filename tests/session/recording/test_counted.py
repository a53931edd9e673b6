"""How many faults and stops a recording without events tells of."""

from __future__ import annotations

import json
import os
import time
from pathlib import Path

import pytest

from armui.arm.device import RecordedArm
from armui.control.event_log.log_events import log_events
from armui.session.recording import sidecar
from armui.session.recording.counted import Counts, counted, counts_in, keep
from armui.session.recording.folder import list_recordings
from armui.session.recording.recorded_session import RecordedSession
from armui.session.session import KeepsCounts
from armui.ui.watch.replay.log_time import wall_time
from tests.bus.playback.logs import log_with
from tests.session.recording.made import BASE, recorded, taken

ALONE = {"reason": "command"}


@pytest.fixture
def path(tmp_path) -> Path:
    """As `armui record` leaves it, with a fault of a joint from 1.1 s to 1.4 s."""
    session = log_with(tmp_path, "overcurrent")
    frames = [
        (None, each.time_s - BASE.shift_s, each.frame, int(each.flags))
        for batch in session.frames_between(0.0, 1e12)
        for each in batch
    ]
    session.close()
    return recorded(tmp_path / "own", frames, block=700, facts=ALONE)


def entry(path):
    (found,) = list_recordings(path.parent)
    return found


def lines(path):
    return (path.parent / f"made{sidecar.SUFFIX}").read_bytes()


def test_what_nobody_has_counted_is_not_known(path):
    assert (entry(path).faults, entry(path).stops) == (None, None)
    assert RecordedSession(path).lacks_counts


def test_the_frames_are_counted_once_and_the_list_tells_it(path):
    session = RecordedSession(path)
    counts = counted(session)
    assert counts.faults >= 1
    keep(path.parent, session.name, counts)
    assert (entry(path).faults, entry(path).stops) == counts
    assert not RecordedSession(path).lacks_counts
    assert RecordedSession(path).marks == []  # they are found in the frames, as before


def test_opened_in_the_window_it_is_counted_alike(path):
    session = RecordedSession(path)
    assert isinstance(session, KeepsCounts)
    found = log_events(session, session.channels[0], RecordedArm(2), wall_time)
    session.keep_counts(found.marks)
    assert not session.lacks_counts
    assert (entry(path).faults, entry(path).stops) == counted(session)


def test_what_another_program_is_still_writing_is_left_alone(tmp_path):
    path = recorded(tmp_path, taken(2000), facts=ALONE)
    side = tmp_path / f"made{sidecar.SUFFIX}"
    whole = side.read_bytes()
    killed = whole[: whole.rindex(b'{"kind": "end"')]
    side.write_bytes(killed)
    session = RecordedSession(path)
    session.keep_counts([])
    assert side.read_bytes() == killed

    old_s = time.time() - 3600.0
    os.utime(tmp_path / "made.armui.idx", (old_s, old_s))
    session = RecordedSession(path)
    session.keep_counts([])
    assert entry(path).faults == 0
    assert not entry(path).ended


def test_half_a_line_of_a_killed_program_stays_half_a_line(path):
    side = path.parent / f"made{sidecar.SUFFIX}"
    side.write_bytes(side.read_bytes() + b'{"kind": "ev')
    keep(path.parent, "made", Counts(3, 1))
    assert json.loads(lines(path).splitlines()[-1]) == {"kind": "counted", "faults": 3, "stops": 1}
    assert (entry(path).faults, entry(path).stops) == (3, 1)


def test_a_folder_that_cannot_be_written_is_no_trouble(path):
    keep(path.parent / "gone", "made", Counts(3, 1))
    assert entry(path).faults is None


def test_events_beside_it_count_and_a_recording_of_the_window_without_any_had_none():
    session = {"kind": "session"}
    events = [
        event(1, "fault", "joint_fault"),
        event(1, "fault", "joint_fault"),  # its end
        event(2, "stop", "stop_sent"),
    ]
    assert counts_in([session, *events]) == Counts(1, 1)
    assert counts_in([session]) == Counts(0, 0)
    assert counts_in([{**session, **ALONE}]) is None
    assert counts_in([{**session, **ALONE}, {"kind": "counted", "faults": "many"}]) is None


def event(number, mark, code, **params):
    """A line of the sidecar."""
    entry = {"number": number, "code": code, "params": params}
    return {"kind": "event", "time_s": float(number), "mark": mark, "entry": entry}


STOPPED = ("fault", "arm_status", {"status": 1})
SENT: tuple[str, str, dict[str, object]] = ("stop", "stop_sent", {})
CONFIRMED: tuple[str, str, dict[str, object]] = ("stop", "stop_confirmed", {})


@pytest.mark.parametrize(
    ("told", "counts"),
    [
        ([SENT, STOPPED, CONFIRMED], Counts(0, 1)),
        ([SENT, STOPPED, CONFIRMED] * 2, Counts(0, 2)),
        ([SENT, ("stop", "stop_unconfirmed", {})], Counts(0, 1)),
        ([STOPPED], Counts(0, 1)),  # another program's
        ([SENT, STOPPED, ("stop", "stop_undone", {})], Counts(0, 1)),
        ([("stop", "halt_sent", {})], Counts(0, 0)),
        ([SENT, STOPPED, ("fault", "arm_status", {"status": 7})], Counts(1, 1)),
        ([("fault", "arm_status", {"status": [1]}), ("fault", None, {})], Counts(2, 0)),
    ],
)
def test_what_is_told_twice_of_one_stop_is_one_stop(told, counts):
    lines = [event(place, mark, code, **params) for place, (mark, code, params) in enumerate(told)]
    assert counts_in([{"kind": "session"}, *lines]) == counts
