"""What is found in a recording while it is shown: its events, and half an hour of curves."""

from __future__ import annotations

import threading
from pathlib import Path

import pytest

from armui.bus.playback import curve_history, log_player
from armui.protocol.generation import Generation
from armui.sim.faults.schedule import Fault
from armui.ui.watch.curves_item import Missing
from tests.bus.playback.logs import as_own
from tests.operator.replay_actions import Replay
from tests.session.indexed import open_indexed
from tests.session.recordings import START_S, frames, greeting, write


@pytest.fixture(scope="module")
def log(tmp_path_factory) -> Path:
    """Four seconds: motors on at 1 s, joint 3 too hot from 2 to 2.5 s."""
    path = tmp_path_factory.mktemp("log") / "yesterday.blf"
    faults = (Fault("motor-overtemperature", 3, 2.0, 2.5),)
    write(path, frames(4.0, faults=faults, asked=greeting(Generation.TWO)))
    return path


@pytest.fixture
def replay(app_driver, monkeypatch):
    replay = Replay(app_driver, monkeypatch)
    yield replay
    replay.window.close()
    app_driver.wait(lambda: replay.window.view is None)


def test_a_recording_by_the_command_has_its_events_and_marks(app_driver, monkeypatch, log):
    session = open_indexed(log)
    own = as_own(log.parent, session)
    expected = len(session.marks)
    session.close()
    replay = Replay(app_driver, monkeypatch)
    replay.open(log.parent / "own" / f"{own.name}.blf")

    app_driver.wait(lambda: replay.view.events.model.rowCount() > 3)
    assert replay.replay.session.marks == []
    assert len(replay.view.time_line._marks) == expected
    assert replay.view.transport.buttons["next_fault"].isEnabled()
    replay.window.close()


def test_zoomed_out_curves_are_loaded_and_say_so_meanwhile(replay, log, monkeypatch):
    monkeypatch.setattr(log_player, "FILLED_S", 0.5)
    go_on = threading.Event()
    reading = curve_history.CurveHistory._goes_on
    monkeypatch.setattr(
        curve_history.CurveHistory,
        "_goes_on",
        lambda history, at_s: go_on.wait(10) and reading(history, at_s),
    )
    replay.open(log)
    view = replay.view
    board, angles = view.curves.board, replay.replay.controller.telemetry.series["JointFeedback12"]
    view.tabs.setCurrentWidget(view.curves)
    replay.replay.go_to(START_S + 3.0)
    replay.arrive()
    replay.driver.wait(lambda: angles.count > 0)
    assert angles.samples(0, START_S + 2.4).size == 0
    assert board._missing is None

    board.set_span(1800.0)
    replay.driver.wait(lambda: board._missing is not None)
    missing: Missing = replay.view.curves.board._missing
    assert missing.text == "Loading: 0 %"
    assert missing.begin_s == pytest.approx(START_S, abs=0.1)
    assert missing.end_s == pytest.approx(START_S + 2.5, abs=0.1)
    replay.driver.wait(lambda: board.panes[0].graphs[0].curves._missing == missing)

    go_on.set()
    replay.driver.wait(lambda: board._missing is None)
    assert angles.samples(0, START_S + 0.2).size > 10
    view.tabs.setCurrentWidget(view.joints)  # what is not seen is not read
    replay.driver.wait(lambda: not replay.replay._worker._wants_history)
