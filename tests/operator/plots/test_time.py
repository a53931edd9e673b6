"""Zoom, pause, undo and cursors, with the mouse."""

from datetime import datetime, time

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from tests.operator.plots.actions import trigger


def ranges(plots):
    return [tuple(pane.graphs[0].box.viewRange()[0]) for pane in plots.board.panes]


def turn(viewport, place, notches, modifier=Qt.KeyboardModifier.NoModifier):
    """Turn the wheel over a place."""
    event = QWheelEvent(
        QPointF(place), QPointF(viewport.mapToGlobal(place)), QPoint(), QPoint(0, 120 * notches),
        Qt.MouseButton.NoButton, modifier, Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    QApplication.sendEvent(viewport, event)
    QApplication.processEvents()


def test_all_plots_show_the_same_time(plots):
    assert set(ranges(plots)) == {(-30.0, 0.0)}
    plots.choose("plot_span", "10 s")
    plots.draw()
    assert set(ranges(plots)) == {(-10.0, 0.0)}


def test_a_frame_zooms_every_plot_and_undo_leads_back(plots):
    plots.drag_in(0, (-20.0, 0.5), (-10.0, 0.5))
    plots.draw()
    for begin_s, end_s in ranges(plots):
        assert begin_s == pytest.approx(-20.0, abs=0.2)
        assert end_s == pytest.approx(-10.0, abs=0.2)
    left_s = plots.board.edge_s() + ranges(plots)[0][0]
    at_left = plots.board.telemetry.wall_time(left_s)
    told = datetime.combine(at_left, time.fromisoformat(plots.board.times.begin), at_left.tzinfo)
    assert told.timestamp() == pytest.approx(at_left.timestamp(), abs=1.0), "it is the left end's"
    assert plots.window.bar.pause.isChecked()
    assert plots.window.bar.spans.currentText() != "30 s"
    plots.click("plot_undo")
    plots.draw()
    assert set(ranges(plots)) == {(-30.0, 0.0)}
    assert not plots.window.bar.pause.isChecked()
    assert not plots.window.bar.undo.isEnabled()


def test_a_high_frame_zooms_the_figures_of_its_plot_alone(plots):
    before = plots.board.panes[1].graphs[0].heights
    low, high = plots.board.panes[0].graphs[0].heights
    plots.drag_in(0, (-20.0, 0.2), (-2.0, 0.9))
    plots.draw()
    shown = plots.board.panes[0].graphs[0].heights
    assert shown[0] == pytest.approx(low + 0.1 * (high - low), abs=0.05 * (high - low))
    assert shown[1] == pytest.approx(low + 0.8 * (high - low), abs=0.05 * (high - low))
    assert plots.board.panes[1].graphs[0].heights == before
    pane = plots.board.panes[0]
    trigger(plots.menu_at(pane, QPoint(300, 70)), "Fit the height")
    plots.draw()
    assert plots.board.panes[0].graphs[0].heights == (low, high)
    assert not plots.board.frame.live


def test_paused_it_stands_still_and_runs_on(plots, app_driver):
    plots.click("plot_pause")
    edge_s = plots.board.edge_s()
    app_driver.run(1.0)
    assert plots.board.edge_s() == edge_s
    assert plots.window.bar.pause.text() == "Pause"
    assert plots.window.bar.pause.isChecked()
    plots.click("plot_pause")
    assert not plots.window.bar.pause.isChecked()
    assert plots.board.edge_s() == plots.board.now_s()


def test_the_wheel_shows_a_longer_time(plots):
    viewport, place = plots.place(0, -10.0)
    turn(viewport, place, -1)
    assert plots.board.frame.shown.span_s == pytest.approx(37.5)
    assert plots.board.frame.live
    turn(viewport, place, 2)
    assert plots.board.frame.shown.span_s == pytest.approx(24.0)


def test_the_wheel_with_control_shows_more_of_the_figures(plots):
    low, high = plots.board.panes[0].graphs[0].heights
    viewport, place = plots.place(0, -10.0, 0.5)
    turn(viewport, place, -1, Qt.KeyboardModifier.ControlModifier)
    plots.draw()
    shown = plots.board.panes[0].graphs[0].heights
    assert shown[1] - shown[0] == pytest.approx(1.25 * (high - low))


@pytest.mark.parametrize(
    ("button", "modifier"),
    [
        (Qt.MouseButton.MiddleButton, Qt.KeyboardModifier.NoModifier),
        (Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ShiftModifier),
    ],
)
def test_the_time_is_moved_along(plots, button, modifier):
    plots.drag_in(0, (-20.0, 0.5), (-10.0, 0.5), button, modifier)
    shown = plots.board.frame.shown
    assert shown.end_s == pytest.approx(-10.0, abs=0.6)
    assert shown.span_s == pytest.approx(30.0)
    assert not plots.board.frame.live


def test_two_cursors_tell_values_and_differences(plots):
    plots.click("plot_pause")
    plots.click("plot_cursors")
    plots.draw()
    assert plots.window.cursor_table.isVisible()
    # before the motion, which began four seconds ago, and after it
    plots.drag_in(0, (-20.0, 0.5), (-4.5, 0.5))
    plots.drag_in(0, (-10.0, 0.5), (-0.5, 0.5))
    first_s, second_s = (each - plots.board.edge_s() for each in plots.board.cursors_s)
    assert first_s == pytest.approx(-4.5, abs=0.2)
    assert second_s == pytest.approx(-0.5, abs=0.2)
    before, after, difference = plots.table()["J1 angle"]
    assert before == "0.000°"
    assert after == "20.000°"
    assert difference == "+20.000°"
    assert plots.table()["J1 angle, our command"] == ["—", "20.000°", "—"]
    times = plots.window.cursor_table._times.text()
    assert f"B − A {second_s - first_s:.3f} s" in times
    assert plots.board.frame.shown.span_s == 30.0  # nothing was zoomed
    plots.click("plot_cursors")
    assert not plots.window.cursor_table.isVisible()


def test_a_click_brings_the_nearer_cursor(plots):
    plots.click("plot_pause")
    plots.click("plot_cursors")
    viewport, place = plots.place(2, -12.0)
    QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, pos=place)
    first_s, second_s = (each - plots.board.edge_s() for each in plots.board.cursors_s)
    assert first_s == pytest.approx(-20.0, abs=0.2)
    assert second_s == pytest.approx(-12.0, abs=0.2)


def test_a_moment_is_shown(plots):
    at_s = plots.board.now_s() - 100.0
    plots.window.show_moment(at_s)
    shown, edge_s = plots.board.frame.shown, plots.board.edge_s()
    assert edge_s + shown.begin_s < at_s < edge_s + shown.end_s
    assert plots.board.cursors_s[0] == at_s
    assert plots.window.bar.cursors.isChecked()
