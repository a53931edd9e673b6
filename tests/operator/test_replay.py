"""An operator looks at a recording: goes to its faults, plays it, reads what the arm said."""

from __future__ import annotations

from concurrent.futures import Future
from pathlib import Path

import can
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox

from armui.cell.cell import Cell
from armui.cell.cell_in_force import CellInForce, to_entry
from armui.cell.held_objects import HeldObject
from armui.cell.placement import Placement
from armui.cell.user_frames import UserFrame
from armui.cell.work_area import Area, AreaBox
from armui.protocol.generation import Generation
from armui.session.foreign.indexed import IndexedLog
from armui.session.frames import NotALogError
from armui.sim.faults.schedule import Fault
from armui.ui.watch.events.event_table import EventColumn
from armui.ui.watch.replay import log_opening
from armui.ui.watch.replay.replay_window import ReplayWindow
from tests.accepted import accepted
from tests.operator.replay_actions import Replay
from tests.session.indexed import open_indexed
from tests.session.recordings import START_S, frames, greeting, write


@pytest.fixture(scope="module")
def log(tmp_path_factory) -> Path:
    """Four seconds: motors on at 1 s, joint 3 too hot from 2 to 2.5 s, joint 2 hit at 3 s."""
    path = tmp_path_factory.mktemp("log") / "yesterday.blf"
    faults = (Fault("motor-overtemperature", 3, 2.0, 2.5), Fault("collision", 2, 3.0, 3.1))
    write(path, frames(4.0, faults=faults, asked=greeting(Generation.TWO)))
    return path


@pytest.fixture
def replay(app_driver, monkeypatch):
    replay = Replay(app_driver, monkeypatch)
    yield replay
    replay.window.close()
    app_driver.wait(lambda: replay.window.view is None)


def test_a_log_is_shown_and_unmistakably_not_live(replay, log):
    replay.open(log)

    view = replay.view
    assert "NOT LIVE" in view.frame.word.text()
    assert view.frame.name.text() == "yesterday.blf"
    assert replay.window.windowTitle() == "Replay – yesterday.blf"
    assert view.frame.clock.text().startswith("2026-09-21 ")
    assert view.transport.place.text() == "0:00.100 / 0:03.995"


def test_it_shows_the_cell_that_held_and_not_the_present_one(replay, log, monkeypatch):
    tray = UserFrame("tray", (0.0, 0.0, 200.0, 0.0, 0.0, 90.0))
    crate = AreaBox("crate", (300.0, 0.0, 50.0, 0.0, 0.0, 20.0))
    base = Placement((0.0, 0.0, 900.0, 180.0, 0.0, 0.0))
    area = Area((), (crate,))
    then = CellInForce("then", held=HeldObject("cube"), area=area, frame=tray, placement=base)
    now = Cell("now", frames=(UserFrame("table"),), frame="table")
    accepted(replay.driver.controller.cell.take(now))
    lines = [{"kind": "cell", **to_entry(then)}]
    monkeypatch.setattr(IndexedLog, "lines", lines, raising=False)
    replay.open(log)
    view = replay.view.view
    box, held = view.area
    assert (box.size_mm, box.held, held.held) == (crate.size_mm, False, True)
    assert view.base == base.pose
    assert [(each.name, each.lit) for each in view.frames] == [("tray", True)]
    x, y, z, *_turn = replay.replay.controller.state.end_pose()
    assert view.pose[0][:3] == pytest.approx((y, -x, z - 200.0), abs=1e-6)


def test_next_fault_goes_from_one_to_the_next(replay, log):
    replay.open(log)

    reached = []
    for _ in range(4):
        replay.click("replay_next_fault")
        replay.arrive()
        reached.append(round(replay.since_s(), 1))
    assert reached[0] == 2.0
    assert reached[-1] == 3.0
    assert reached == sorted(reached)

    replay.driver.wait(lambda: "Collision" in replay.view.status._labels["arm"].text())
    replay.key(Qt.Key.Key_N, Qt.KeyboardModifier.ShiftModifier)
    replay.arrive()
    assert replay.since_s() < 3.01


def test_the_joints_say_what_they_said_then(replay, log):
    replay.open(log)
    replay.replay.go_to(START_S + 2.3)
    replay.arrive()

    model = replay.view.joints.model
    texts = {
        (row, column): model.data(model.index(row, column))
        for row in range(model.rowCount())
        for column in range(6)
    }
    assert list(texts.values()).count("Too hot") == 1
    assert replay.view.view.joints[0] == pytest.approx((0.0,) * 6)
    assert replay.view.view.joints[2] is False  # not stale: the log stands still, and so does time


def test_the_time_line_is_pressed_and_scrubbed(replay, log):
    replay.open(log)
    line = replay.view.time_line
    place = QPoint(round(line.place_px(START_S + 2.2)), 20)

    QTest.mousePress(line, Qt.MouseButton.LeftButton, pos=place)
    replay.arrive()
    assert replay.since_s() == pytest.approx(2.2, abs=0.02)
    assert any(
        "J3 Motor temperature: Too hot" in each
        for each in line.told_at(line.place_px(START_S + 2.2))
    )

    QTest.mouseMove(line, QPoint(round(line.place_px(START_S + 3.5)), 20))
    QTest.mouseRelease(line, Qt.MouseButton.LeftButton, pos=place)
    replay.key(Qt.Key.Key_Space)
    assert replay.replay.is_playing


def test_play_pause_speed_and_frame_by_frame(replay, log):
    replay.open(log)
    box = replay.find("replay_speed")
    assert isinstance(box, QComboBox)
    box.activated.emit(box.findText("0.5×"))
    replay.click("replay_play")
    replay.driver.wait(lambda: replay.since_s() > 0.2)
    assert replay.replay.speed == 0.5
    assert replay.view.transport.buttons["play"].text() == "Pause"
    replay.click("replay_play")
    replay.driver.wait(lambda: not replay.replay.is_playing)

    replay.click("replay_step")
    replay.driver.wait(lambda: replay.view.transport.frame.text().startswith("Frame "))
    stepped_to = replay.since_s()
    replay.click("replay_step_back")
    replay.arrive()
    assert replay.since_s() < stepped_to


def rows_of(replay):
    """What stands in the tab 事件: time, who, what."""
    model = replay.view.events.model
    columns = (EventColumn.BEGIN, EventColumn.WHO, EventColumn.TEXT)
    return [
        tuple(model.data(model.index(row, column)) for column in columns)
        for row in range(model.rowCount())
    ]


def show_events(replay):
    replay.view.tabs.setCurrentIndex(2)
    replay.driver.wait(lambda: replay.view.events.model.rowCount() > 0)
    return [(who, text) for _time, who, text in rows_of(replay)]


def test_a_click_on_an_event_leads_there(replay, log):
    replay.open(log)
    told = show_events(replay)
    events = replay.view.events

    assert ("Other host", "Motors: enable sent") in told
    row = told.index(("Arm", "J3 Motor temperature: Too hot"))
    events.table.clicked.emit(events.model.index(row, 0))
    replay.arrive()
    assert replay.since_s() == pytest.approx(2.0, abs=0.1)
    assert events.table.currentIndex().row() == row
    assert events.detail.text().startswith("J3 Motor temperature: Too hot\nsince 2026-09-21 ")


def test_the_event_of_the_moment_is_lit_and_follows(replay, log):
    replay.open(log)
    told = show_events(replay)
    events = replay.view.events
    replay.replay.go_to(START_S + 3.9)
    replay.arrive()
    replay.driver.wait(lambda: events.table.currentIndex().row() == len(told) - 1)

    replay.replay.go_to(START_S + 2.5)
    replay.arrive()
    lit = events.table.currentIndex().row()
    assert events.model.entry(lit).at_s <= START_S + 2.5 < events.model.entry(lit + 1).at_s

    events.bar.follow.setChecked(False)
    replay.replay.go_to(START_S + 3.9)
    replay.arrive()
    assert events.table.currentIndex().row() == lit
    events.bar.follow.setChecked(True)
    assert events.table.currentIndex().row() == len(told) - 1

    # before the first event nothing is lit
    replay.replay.go_to(replay.replay.session.start_s)
    replay.arrive()
    first_s = events.model.entry(0).at_s
    assert (events.table.currentIndex().row() == -1) == (first_s > replay.replay.position_s + 1e-4)


def test_events_are_filtered_as_live(replay, log):
    replay.open(log)
    told = show_events(replay)
    events = replay.view.events
    levels = events.bar.levels
    levels.setCurrentIndex(levels.findText("Faults"))
    levels.activated.emit(levels.currentIndex())

    assert 0 < events.model.rowCount() < len(told)
    assert {who for _time, who, _text in rows_of(replay)} == {"Arm"}
    assert events.bar.count.text() == f"{events.model.rowCount()} of {len(told)}"
    replay.replay.go_to(START_S + 3.9)
    replay.arrive()
    assert events.table.currentIndex().row() == events.model.rowCount() - 1


def test_jumps_are_no_lost_connection(replay, log):
    replay.open(log)
    for since_s in (1.0, 3.0, 2.0):
        replay.replay.go_to(START_S + since_s)
        replay.arrive()

    codes = {each.code for each in replay.replay.controller.events.entries()}
    assert not codes & {"link_lost", "reconnected"}
    assert "connected" in codes


def test_the_curves_have_the_times_of_the_log(replay, log):
    replay.open(log)
    replay.view.tabs.setCurrentIndex(1)
    replay.replay.go_to(START_S + 3.0)
    replay.arrive()

    telemetry = replay.view.curves.board.telemetry
    replay.driver.wait(lambda: telemetry.series["JointFeedback12"].count > 500)
    assert telemetry is not replay.driver.controller.telemetry
    assert telemetry.wall_time(START_S).timestamp() == START_S


def test_a_jump_while_it_stands_still_draws_the_curves(replay, log):
    replay.open(log)
    replay.view.tabs.setCurrentIndex(1)
    board = replay.view.curves.board
    replay.driver.wait(lambda: board.built)

    def drawn_up_to(at_s):
        caches = board._book._caches.values()
        return any(abs(each._end_s - at_s) < 0.1 and any(each.drawn) for each in caches)

    for since_s in (3.0, 3.5, 1.5):
        replay.replay.go_to(START_S + since_s)
        replay.arrive()
        assert not replay.replay.is_playing
        replay.driver.wait(lambda: drawn_up_to(replay.replay.position_s))


def test_the_channel_with_the_arm_is_shown_and_the_other_can_be_chosen(replay, tmp_path):
    with can.Logger(tmp_path / "two.blf") as logger:
        for at_s, frame in frames(1.0):
            for channel, shift in ((1, 0x400), (2, 0)):
                logger(
                    can.Message(
                        timestamp=at_s, arbitration_id=min(frame.arbitration_id + shift, 0x7FF),
                        data=frame.data, is_extended_id=False, channel=channel,
                    )
                )  # fmt: skip
    replay.open(tmp_path / "two.blf")
    box = replay.find("replay_channel")
    assert [box.itemText(place) for place in range(2)] == ["2 (arm)", "1 (no arm)"]
    replay.replay.go_to(START_S + 0.5)
    replay.arrive()
    assert replay.replay.controller.state.angles_deg() is not None

    box.setCurrentIndex(1)
    box.activated.emit(1)
    replay.arrive()

    assert replay.replay.channel == 1
    assert replay.since_s() == pytest.approx(0.5)
    assert replay.replay.controller.state.angles_deg() is None


def test_the_operator_may_say_which_protocol_it_is(replay, log):
    replay.open(log)
    box = replay.find("replay_generation")
    assert box.currentText() == "generation 2 (as the log tells)"

    box.setCurrentIndex(0)
    box.activated.emit(0)
    replay.replay.go_to(START_S + 2.0)
    replay.arrive()

    assert replay.replay.controller.operating_state.generation is Generation.ONE


@pytest.mark.parametrize(
    ("name", "content", "told"),
    [
        ("empty.log", b"", "empty.log is a log without a single frame"),
        ("zip.log", b"PK\x03\x04" + bytes(99), "zip.log is a packed archive"),
        ("photo.png", b"\x89PNG", "By its name photo.png is no CAN log"),
        ("noise.blf", bytes(range(256)) * 99, "Nothing in noise.blf reads as a frame"),
    ],
)
def test_what_cannot_be_replayed_is_said_and_another_can_be_chosen(
    replay, log, tmp_path, name, content, told
):
    (tmp_path / name).write_bytes(content)
    replay.open(tmp_path / name)
    assert told in replay.message()
    assert replay.find("replay_choose").isVisible()

    replay.open(log)

    assert replay.window.view is not None
    assert replay.message() == ""


def test_a_truncated_log_shows_what_there_is_and_says_so(replay, log, tmp_path):
    whole = log.read_bytes()
    (tmp_path / "half.blf").write_bytes(whole[: len(whole) // 2])

    replay.open(tmp_path / "half.blf")

    assert "could not be read; the rest is shown" in replay.message()
    assert replay.replay.session.frames > 1000


def test_reading_can_be_called_off(app_driver, monkeypatch, log):
    asked: list[Future[None]] = []

    class Endless(type(app_driver.workers)):  # type: ignore[misc]
        ended = False

        def submit(self, *_work, **_how):
            asked.append(Future())
            return asked[-1]

        def shutdown(self, *_how, **_more):
            Endless.ended = True

    replay = Replay(app_driver, monkeypatch, Endless)
    replay.window.open_log(log)
    app_driver.wait(lambda: asked)
    assert replay.find("replay_progress").isVisible()
    assert not replay.find("replay_progress").isTextVisible()  # its height would cut it in half

    replay.click("replay_cancel")

    assert Endless.ended
    assert replay.find("replay_choose").isVisible()
    asked[0].set_result(None)  # whatever comes of it later is not shown
    app_driver.wait(lambda: replay.window.view is None)
    assert replay.message() == ""
    replay.window.close()


def test_closing_the_window_lets_go_of_the_log(replay, log):
    replay.open(log)
    shown, session = replay.view, replay.replay.session

    replay.key(Qt.Key.Key_Escape)
    assert replay.window.isVisible()
    replay.window.close()

    assert not replay.window.isVisible()
    assert shown.view.is_shut_down
    assert replay.window.view is None
    replay.driver.wait(lambda: not session._columns)


def test_the_end_of_the_program_lets_go_of_the_log(replay, log):
    replay.open(log)
    replay.replay.play(on=True)
    worker, session = replay.replay.controller._connection._worker, replay.replay.session

    replay.window.end()

    assert worker.isFinished()
    assert not session._columns
    assert not session._folder.exists()


def test_a_log_named_on_the_command_line_is_opened(app_driver, monkeypatch, log):
    Replay(app_driver, monkeypatch).window.close()

    app_driver.window.pages.open_replay(log)

    window = app_driver.dialog(ReplayWindow)
    app_driver.wait(lambda: window.view is not None)
    app_driver.wait(lambda: not window.view.replay.is_travelling)
    window.close()


def test_a_recording_of_this_program_is_opened_by_its_index(app_driver, monkeypatch, log):
    asked = []

    def open_own(path):
        asked.append(path)
        if path.name != "ours.blf":
            raise NotALogError("it has no index")
        return open_indexed(log)

    def no_reading():
        raise AssertionError("it was to be read")

    replay = Replay(app_driver, monkeypatch)
    replay.window._open_own = open_own
    replay.open(log)  # another program's: it is read
    assert replay.window.view is not None
    monkeypatch.setattr(log_opening, "index_or_reason", no_reading)

    replay.open(log.with_name("ours.blf"))

    assert [each.name for each in asked] == ["yesterday.blf", "ours.blf"]
    assert replay.replay.session.frames > 1000
    replay.window.close()
