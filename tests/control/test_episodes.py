"""Episodes marked in a log: what is kept, what is read back, what is said."""

from __future__ import annotations

import json

import pytest

from armui.control.sessions.choices import SessionChoices
from armui.control.sessions.episodes import (
    EPISODE_NO_LAST,
    EPISODE_NO_LOG,
    EPISODE_NONE,
    EPISODE_TASK_BAD,
    EPISODE_UNDER_WAY,
    LONGEST_TASK,
)
from armui.control.sessions.progress import EpisodePhase
from armui.session.recording.episodes import Episode, episode_line, episodes_of
from armui.session.recording.folder import list_recordings
from armui.session.recording.recorded_session import RecordedSession
from armui.session.recording.sidecar import as_bytes, read_lines
from tests.accepted import accepted


@pytest.fixture
def log(rig, qtbot, tmp_path):
    """Begins and ends logs of an arm that is ready; what was written is opened."""
    rig.ready()
    sessions = rig.controller.sessions
    sessions.choose(SessionChoices(tmp_path / "sessions"))
    return Log(rig, qtbot, sessions)


class Log:
    def __init__(self, rig, qtbot, sessions):
        self.rig, self.qtbot, self.sessions = rig, qtbot, sessions
        self.begin = sessions.start

    def end(self) -> RecordedSession:
        before = self.rig.codes().count("session_ended")
        assert self.sessions.stop() is None

        def ended():
            self.sessions.poll()
            return self.rig.codes().count("session_ended") > before

        self.qtbot.waitUntil(ended, timeout=10_000)
        newest = list_recordings(self.sessions.choices.folder)[0]
        assert newest.path is not None
        return RecordedSession(newest.path)


def test_what_is_marked_is_read_back(rig, log):
    episodes = rig.controller.episodes
    assert log.begin() is None
    rig.run(0.3)
    first = accepted(episodes.begin("stack the cubes"))
    assert rig.controller.operating_state.episode is EpisodePhase.UNDER_WAY
    assert episodes.under_way.number == 1
    rig.run(0.5)
    assert episodes.elapsed_s == pytest.approx(0.5, abs=0.02)
    accepted(episodes.end())
    assert first.result.code == "episode_ended"
    assert first.result.params == {"number": 1, "seconds": 0.5}
    rig.run(0.2)
    accepted(episodes.mark())  # the task is kept
    rig.run(0.2)
    accepted(episodes.discard())
    assert (episodes.kept, episodes.under_way) == (1, None)
    accepted(episodes.mark())
    rig.run(0.3)
    session = log.end()

    found = episodes_of(session.lines)
    assert [(each.number, each.task, each.discarded) for each in found] == [
        (1, "stack the cubes", False),
        (2, "stack the cubes", True),
        (3, "stack the cubes", False),
    ]
    assert [(each.end_s or 0.0) - each.begin_s for each in found] == pytest.approx(
        [0.5, 0.2, 0.3], abs=0.02
    )
    assert found[0].begin_s == pytest.approx(session.start_s + 0.3, abs=0.05)
    assert "episode_closed" in rig.codes(), "what was not ended is ended with the log, and said"
    marks = [each for each in session.marks if each.entry.get("code") == "episode"]
    assert [(each.at_s, each.entry["ended_s"]) for each in marks] == [
        (each.begin_s, each.end_s) for each in found
    ]


def test_a_log_begins_without_episodes_and_with_the_task_of_before(rig, log):
    episodes = rig.controller.episodes
    assert log.begin() is None
    accepted(episodes.begin("pour"))
    rig.run(0.3)
    assert len(episodes_of(log.end().lines)) == 1
    assert rig.controller.operating_state.episode is EpisodePhase.NO_LOG
    assert log.begin("another") is None
    assert (episodes.kept, episodes.under_way) == (0, None)
    accepted(episodes.begin())
    rig.run(0.3)
    accepted(episodes.end())
    (only,) = [each for each in episodes_of(log.end().lines) if each.end_s is not None]
    assert (only.number, only.task) == (1, "pour")


def test_what_cannot_be_marked_is_refused_with_its_reason(rig):
    episodes = rig.controller.episodes
    for act in (episodes.begin, episodes.end, episodes.discard, episodes.mark):
        assert act().reason == EPISODE_NO_LOG
    lines: list[object] = []
    episodes.begin_log(lines.append, 0.0)
    assert episodes.end().reason == EPISODE_NONE
    assert episodes.discard().reason == EPISODE_NO_LAST
    for task in ("two\nlines", "x" * (LONGEST_TASK + 1)):
        assert episodes.begin(task).reason == EPISODE_TASK_BAD
    assert lines == []
    accepted(episodes.begin(""))
    assert episodes.begin().reason == EPISODE_UNDER_WAY
    accepted(episodes.discard())
    assert episodes.discard().reason == EPISODE_NO_LAST, "only the last one can be discarded"


def test_what_a_killed_program_left_has_no_end():
    whole = as_bytes([{"kind": "session"}, episode_line(Episode(1, 10.0, 12.0, "a"))])
    begun = as_bytes([episode_line(Episode(2, 13.0, None, "b"))])
    cut = as_bytes([episode_line(Episode(2, 13.0, 15.0, "b"))])[:-20]
    strange = as_bytes(
        [
            {"kind": "episode", "episode": 3, "begin_s": "soon"},
            {"kind": "episode", "episode": 4, "begin_s": 9.0, "end_s": 8.0},
            json.loads('{"kind": "episode"}'),
        ]
    )
    found = episodes_of(read_lines(whole + strange + begun + cut))
    assert found == [Episode(1, 10.0, 12.0, "a"), Episode(2, 13.0, None, "b")]
    assert episodes_of(read_lines(as_bytes([{"kind": "session"}]))) == []
