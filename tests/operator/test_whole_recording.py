"""An operator looks at the whole of a recording: its curves, its frames, its export."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.protocol.generation import Generation
from armui.ui.watch.bus.trace_model import TraceColumn
from armui.ui.watch.export_dialog import ExportDialog
from tests.operator.replay_actions import Replay
from tests.session.recordings import START_S, frames, moving, write

WHOLE, FRAMES = 3, 4


@pytest.fixture(scope="module")
def log(tmp_path_factory):
    """Six seconds of an arm that is enabled and moves."""
    path = tmp_path_factory.mktemp("log") / "cell 3.blf"
    write(path, frames(6.0, asked=moving(Generation.TWO)))
    return path


@pytest.fixture
def replay(app_driver, monkeypatch, log):
    replay = Replay(app_driver, monkeypatch)
    replay.open(log)
    yield replay
    replay.window.close()
    app_driver.wait(lambda: replay.window.view is None)


def seen(replay, tab):
    replay.view.tabs.setCurrentIndex(tab)
    return replay.view.tabs.widget(tab)


def whole(replay):
    curves = seen(replay, WHOLE)
    replay.driver.wait(lambda: not curves.is_loading and curves.area.board.built)
    return curves


def test_the_curves_reach_from_the_beginning_to_the_end_wherever_the_replay_is(replay):
    assert replay.view.whole.area is None  # nothing is read before it is wanted
    curves = whole(replay)
    session = replay.replay.session
    board = curves.area.board
    assert replay.since_s() < 0.2
    assert board.edge_s() == session.end_s
    assert board.frame.shown.span_s == pytest.approx(session.end_s - session.start_s)
    series = board.telemetry.series["JointFeedback12"]
    assert series.count == pytest.approx(1200, abs=10)
    assert series.latest("joint_angle.1")[0] == pytest.approx(session.end_s, rel=0, abs=0.1)


def test_the_cursor_follows_the_replay_and_leads_it(replay):
    curves = whole(replay)
    board = curves.area.board
    replay.replay.go_to(START_S + 2.0)
    replay.arrive()
    replay.driver.wait(lambda: abs(board.cursors_s[0] - START_S - 2.0) < 0.01)
    pane = board.panes[0]
    pane.show_values(board.now_s(), board.cursors_s[0])
    angle = board.telemetry.series["JointFeedback12"].value_at("joint_angle.1", START_S + 2.0)[1]
    assert angle > 1.0  # it moves then, and stands at 0° in the end
    assert pane.legend._entries[0].value == f"{angle:.3f}°"

    board.panes[0].graphs[0].box.cursor_dragged.emit(0, START_S + 4.5 - board.edge_s())
    replay.arrive()
    assert replay.since_s() == pytest.approx(4.5, abs=0.01)
    board.panes[0].graphs[0].box.clicked.emit(START_S + 1.0 - board.edge_s())
    replay.arrive()
    assert replay.since_s() == pytest.approx(1.0, abs=0.01)
    assert board.frame.shown.span_s > 5.9  # what is shown stays


def test_the_frames_around_the_moment_are_listed_and_lead_to_theirs(replay):
    frames = seen(replay, FRAMES)
    replay.replay.go_to(START_S + 3.0)
    replay.arrive()
    table, model = frames.table, frames.model

    def here():
        row = table.currentIndex().row()
        return row >= 0 and abs(frames._trace.times_s[row] - START_S - 3.0) < 0.01

    replay.driver.wait(here)
    assert model.rowCount() > 500
    texts = [
        [model.index(row, column).data() for column in range(model.columnCount())]
        for row in range(model.rowCount())
    ]
    angles = next(row for row in texts if row[TraceColumn.ID] == "0x2A5")
    assert angles[TraceColumn.NAME] == "Angles of J1, J2"
    assert angles[TraceColumn.SENDER] == "arm"
    assert angles[TraceColumn.SAYS].startswith("J1 ")
    row = table.currentIndex().row() - 40
    index = model.index(row, TraceColumn.NAME)
    table.scrollTo(index)
    place = table.visualRect(index).center()
    QTest.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    replay.arrive()
    assert replay.replay.position_s == pytest.approx(frames._trace.times_s[row], rel=0, abs=1e-4)


def test_the_frames_go_along(replay):
    frames = seen(replay, FRAMES)
    for at_s in (0.5, 5.0, 2.0):
        replay.replay.go_to(START_S + at_s)
        replay.arrive()
        replay.driver.wait(
            lambda at=at_s: frames._between_s[0] <= START_S + at <= frames._between_s[1]
        )
        replay.driver.wait(
            lambda at=at_s: (
                abs(frames._trace.times_s[frames.table.currentIndex().row()] - START_S - at) < 0.01
            )
        )


def test_it_is_exported_straight_from_there(replay, log):
    replay.click("replay_export")
    dialog = replay.driver.dialog(ExportDialog)
    assert dialog.form._log == log


def test_it_is_closed_while_the_curves_are_read(replay):
    seen(replay, WHOLE)
    history = replay.replay.whole
    replay.window.close()
    replay.driver.wait(lambda: replay.window.view is None)
    assert not history._thread.is_alive()
