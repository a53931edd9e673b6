"""An operator marks episodes in a log, by whatever is at hand, and sees them in the replay."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.session.recording.episodes import episodes_of
from armui.session.recording.recorded_session import RecordedSession
from armui.ui import words
from armui.ui.theme import colors_of
from armui.ui.watch.recordings.sessions_page import SessionsPage
from armui.ui.watch.replay.time_line import TimeLine, mark_text
from tests.gamepad.pads import PAD, Pads, switch_on


@pytest.fixture
def card(app_driver, tmp_path):
    app_driver.store.change(session_folder=str(tmp_path / "sessions"))
    app_driver.ready()
    app_driver.click("sessions_button")
    return app_driver.page(SessionsPage).recording


def test_by_button_key_and_gamepad(app_driver, card, tmp_path):
    pads = Pads()
    episodes = app_driver.controller.episodes
    assert "No log is being written" in card.begin_button.toolTip()
    QTest.keyClick(app_driver.window, Qt.Key.Key_F6)
    told = words.event(app_driver.events[-1])
    assert told.startswith("Not done. No log is being written"), "nothing of it was to be sent"
    app_driver.click("session_record")
    app_driver.run(0.3)
    card.task_field.setText("stack the cubes")
    app_driver.click("episode_begin")
    app_driver.run(1.2)
    card.refresh()
    mark = app_driver.find("recording_mark")
    mark._show_time()
    assert mark.text().strip() == "1 s · episode 1 under way, 1 s"
    assert card.state_label.text().endswith(" · episode 1 under way, 1 s")
    assert not card.begin_button.isEnabled()
    app_driver.click("episode_end")
    assert card.state_label.text().endswith(" · 1 episodes")

    app_driver.run(0.2)
    QTest.keyClick(app_driver.window, Qt.Key.Key_F6)
    app_driver.run(0.2)
    QTest.keyClick(app_driver.window, Qt.Key.Key_F6, Qt.KeyboardModifier.ShiftModifier)
    assert episodes.kept == 1

    switch_on(app_driver.program, pads)
    pads.plug_in(PAD)
    pads.press("start")
    app_driver.run(0.2)
    assert episodes.under_way.number == 3
    app_driver.click("session_record")
    assert episodes.under_way is None
    assert "episode_closed" in app_driver.codes()
    app_driver.wait(
        lambda: app_driver.controller.sessions.poll() or not card._sessions.busy_names()
    )

    (path,) = (tmp_path / "sessions").glob("*.blf")
    session = RecordedSession(path)
    found = episodes_of(session.lines)
    assert [(each.task, each.discarded) for each in found] == [
        ("stack the cubes", False),
        ("stack the cubes", True),
        ("stack the cubes", False),
    ]
    marks = [each for each in session.marks if each.entry.get("code") == "episode"]
    assert mark_text(marks[0]) == "Operator: Episode 1: “stack the cubes”"
    assert mark_text(marks[1]) == "Operator: Episode 2, discarded: “stack the cubes”"
    line = TimeLine()
    line.resize(600, 62)
    line.show_log(session.start_s, session.end_s, session.marks)
    (told,) = [
        each for each in line.told_at(line.place_px(found[0].begin_s + 0.6)) if "Episode 1:" in each
    ]
    assert "1.2" in told, "it is told all through it, with its length"
    seen = line.grab().toImage()
    top_px = 17  # of the band of an episode; one that was discarded is a thin line below
    times_s = [(each.begin_s + (each.end_s or each.begin_s)) / 2.0 for each in found]
    inks = [seen.pixelColor(round(line.place_px(at_s)), top_px).name() for at_s in times_s]
    assert [each == colors_of(line).ok for each in inks] == [True, False, True]
    line.close()
