"""A recording of this program is replayed: its events are those of the live event log."""

from __future__ import annotations

from datetime import datetime, timedelta
from functools import partial

import pytest

from armui.arm.device import RecordedArm
from armui.arm.refusal import Refusal
from armui.control.event_log.log_events import log_events
from armui.control.sessions.choices import SessionChoices
from armui.session.recording.folder import list_recordings
from armui.session.recording.recorded_session import RecordedSession
from armui.sim.faults.schedule import fault
from armui.ui.translation import Translator
from armui.ui.watch.events.event_table import EventColumn
from armui.ui.watch.replay.log_time import wall_time

MILLISECOND = timedelta(milliseconds=1.001)
"""A recording keeps the time of day in whole milliseconds, and ends as seconds after it."""
_SAME = [each for each in EventColumn if each is not EventColumn.END]


@pytest.fixture
def language(qapp):
    translator = Translator(qapp)
    yield translator.set_language
    translator.set_language("en")


def eventful(rig):
    """A motion that arrives, a fault that begins and ends, a refusal, a stop."""
    rig.controller.motion.send_joints((5.0, 10.0, -10.0, 0.0, 0.0, 0.0))
    rig.run(2.0)
    broken = fault("joint-communication", 2)
    rig.node.faults.start(broken)
    rig.run(0.5)
    rig.node.faults.end(broken)
    rig.run(0.5)
    assert isinstance(rig.controller.motors.resume(), Refusal)
    rig.controller.emergency_stop()
    rig.run(1.0)


@pytest.fixture
def recorded(rig, qtbot, tmp_path):
    """What was recorded, and the events that were live from its beginning on."""
    sessions = rig.controller.sessions
    sessions.choose(SessionChoices(tmp_path / "sessions"))
    rig.ready()
    sessions.poll()
    before = rig.controller.events.newest
    assert sessions.start() is None
    eventful(rig)
    assert sessions.stop() is None
    revision, live = rig.controller.events.snapshot()
    qtbot.waitUntil(partial(_ended, sessions, rig), timeout=10_000)
    (entry,) = list_recordings(sessions.choices.folder)
    assert entry.path is not None
    session = RecordedSession(entry.path)
    yield session, [each for each in live if each.number > before], revision
    session.close()


def _ended(sessions, rig):
    sessions.poll()
    return "session_ended" in rig.codes()


def texts(entry):
    return [column.read(entry) for column in _SAME]


def end_of(entry) -> datetime | None:
    return None if entry.ended_s is None else entry.wall_at(entry.ended_s)


@pytest.mark.parametrize("spoken", ["en", "zh"])
def test_the_same_events_in_the_same_words_and_times(recorded, language, spoken):
    session, live, _revision = recorded
    language(spoken)
    replayed = log_events(session, "can0", RecordedArm(2), wall_time).log.entries()
    replayed = replayed[-len(live) :]

    assert {"stop_sent", "refused", "joint_fault", "arm_status", "sent_joints"} <= {
        each.code for each in live
    }
    assert list(map(texts, replayed)) == list(map(texts, live))
    for found, told in zip(replayed, live, strict=True):
        assert (found.lasts, found.unheard, found.goes_on) == (
            told.lasts, told.unheard, told.goes_on,
        )  # fmt: skip
        found_end, told_end = end_of(found), end_of(told)
        assert (found_end is None) == (told_end is None)
        if found_end is not None and told_end is not None:
            assert abs(found_end - told_end) <= MILLISECOND
    begun = [each for each in live if each.code == "joint_fault"]
    assert [each.ended_s is not None for each in begun] == [True]


def test_events_stand_where_their_frames_do(recorded):
    session, live, _revision = recorded
    replayed = log_events(session, "can0", RecordedArm(2), wall_time).log.entries()[-len(live) :]
    shift_s = session.facts["unix_s"] - session.facts["steady_s"]

    for found, told in zip(replayed, live, strict=True):
        assert found.at_s == pytest.approx(told.at_s + shift_s, abs=1e-4)
        assert session.start_s - 1.0 <= found.at_s <= session.end_s + 1.0
        for outcome, was in ((found.answer, told.answer), (found.result, told.result)):
            assert (outcome is None) == (was is None)
            if outcome is not None:
                assert outcome.at_s == pytest.approx(was.at_s + shift_s, abs=1e-4)
