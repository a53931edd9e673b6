"""A recording by `armui record` has no events beside it: its frames tell them, as of any log."""

from __future__ import annotations

from datetime import UTC, datetime

import numpy as np
import pytest

from armui.arm.device import RecordedArm
from armui.control.event_log.log_events import log_events
from armui.protocol.generation import Generation
from armui.session.log_marks import IdRows
from armui.session.recording.recorded_session import RecordedSession
from armui.session.recording.rows import rows_of
from armui.session.recording.sidecar import event_line
from armui.session.session import MarkKind
from tests.bus.playback.logs import EACH_FAULT, as_own, log_with
from tests.bus.playback.test_log_events import silent_log, told
from tests.session.recording.made import BASE, writer

DRIVER_FAST = (0x251, 0x252, 0x253, 0x254, 0x255, 0x256)


def wall(at_s):
    return datetime.fromtimestamp(at_s, UTC)


def both(tmp_path, foreign, generation=Generation.TWO):
    """What is told of a log of another program, and of the same frames in one of ours."""
    own = as_own(tmp_path, foreign)
    arm = RecordedArm(int(generation))
    found = log_events(own, own.channels[0], arm, wall)
    expected = log_events(foreign, foreign.channels[0], arm, wall)
    foreign.close()
    own.close()
    return found, expected


def nearly(entries):
    """As told, times to 10 µs: both formats round theirs."""
    return [
        tuple(round(each, 5) if isinstance(each, float) else each for each in line)
        for line in told(entries)
    ]


@pytest.mark.parametrize("fault", ["", *EACH_FAULT])
def test_the_same_frames_tell_the_same(tmp_path, fault):
    found, expected = both(tmp_path, log_with(tmp_path, fault, seconds=2.0))

    assert nearly(found.log.entries()) == nearly(expected.log.entries())
    assert [(each.kind, each.entry["code"]) for each in found.marks] == [
        (each.kind, each.entry["code"]) for each in expected.marks
    ]
    assert any(each.kind is MarkKind.COMMAND for each in found.marks)


def test_generation_one_too(tmp_path):
    one = Generation.ONE
    found, expected = both(tmp_path, log_with(tmp_path, "overcurrent", one, seconds=2.0), one)
    assert nearly(found.log.entries()) == nearly(expected.log.entries())


def test_a_silence_is_found(tmp_path):
    found, expected = both(tmp_path, silent_log(tmp_path))
    assert [each.code for each in found.log.entries()].count("offline") == 1
    assert nearly(found.log.entries()) == nearly(expected.log.entries())


def test_what_stands_beside_a_recording_counts_and_nothing_else(tmp_path):
    session = log_with(tmp_path, "overcurrent")
    own = as_own(tmp_path, session)
    made = writer(tmp_path / "told", name="told")
    noted = {"number": 1, "at_s": BASE.steady_s, "wall": "2026-01-15T08:00:00+00:00",
             "level": "info", "kind": "program", "who": "program", "code": "session_started",
             "params": {}}  # fmt: skip
    for batch in own.frames_between(-np.inf, np.inf):
        made.write(rows_of([(None, each.time_s - BASE.shift_s, each.frame, 0) for each in batch]))
    made.write(rows_of([]), [event_line(BASE.unix_s, MarkKind.NOTE, noted)])
    made.finish({})
    told_session = RecordedSession(made.path)

    found = log_events(told_session, told_session.channels[0], RecordedArm(2), wall)

    assert [each.code for each in found.log.entries()] == ["session_started"]
    assert found.marks is told_session.marks


def test_it_ends_when_nobody_waits_any_more(tmp_path):
    own = as_own(tmp_path, log_with(tmp_path, "overcurrent"))
    asked = []

    def is_wanted():
        asked.append(True)
        return len(asked) < 2

    log_events(own, own.channels[0], RecordedArm(2), wall, is_wanted)
    assert len(asked) == 2
    assert own.frames > 2 * 700


def test_of_what_is_only_heard_every_silence_remains_and_little_else(tmp_path):
    session = silent_log(tmp_path)
    own = as_own(tmp_path, session)
    rows = IdRows(own, own.channels[0], (0x2A1,), DRIVER_FAST)
    thin, every = (
        np.sort(np.concatenate([log.data_rows(channel, each).times_s for each in DRIVER_FAST]))
        for log, channel in ((rows, own.channels[0]), (session, session.channels[0]))
    )
    assert thin.size < every.size / 10
    gaps = [np.diff(each) for each in (thin, every)]
    assert (gaps[0] > 0.1).sum() == 1
    assert gaps[0][gaps[0] > 0.1] == pytest.approx(gaps[1][gaps[1] > 0.1], abs=1e-5)

    whole = rows.data_rows(own.channels[0], 0x2A1)
    status = session.data_rows(session.channels[0], 0x2A1)
    assert whole.numbers.tolist() == status.numbers.tolist()
    assert whole.payloads.tolist() == status.payloads.tolist()
    assert rows.data_rows("another", 0x2A1) is None
    assert rows.data_rows(own.channels[0], 0x2A2) is None
    session.close()
