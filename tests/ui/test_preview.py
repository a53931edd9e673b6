"""The ghost arm and the bar that moves it; no arm is anywhere near."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton

from armui.trajectory.planning.planned_path import PlannedPath
from armui.ui.trajectory.preview.path_preview import PathPreview
from armui.ui.trajectory.preview.preview_bar import PreviewBar
from armui.ui.widgets.text_label import ValueLabel
from armui.ui.widgets.track_slider import TrackSlider
from armui.viewport.path_picture import NOTHING


def plan():
    """Joint 1 turns by 10° in each of two seconds; a point after each."""
    return PlannedPath(
        times_s=np.linspace(0.0, 2.0, 21),
        joints_deg=np.outer(np.linspace(0.0, 20.0, 21), (1.0, 0.0, 0.0, 0.0, 0.0, 0.0)),
        places_mm=np.outer(np.linspace(0.0, 200.0, 21), (1.0, 0.0, 0.0)),
        speeds_mm_s=np.full(21, 100.0),
        rows=np.repeat([0, 1], [11, 10]),
        cycles=np.ones(21, dtype=np.int64),
    )


class View:
    def __init__(self):
        self.shown = NOTHING

    def set_preview(self, preview):
        self.shown = preview

    def show_joint_range(self, number, limits_deg=(0.0, 0.0)):
        self.range = (number, limits_deg)


@pytest.fixture
def view():
    return View()


@pytest.fixture
def bar(qtbot):
    bar = PreviewBar()
    qtbot.addWidget(bar)
    return bar


@pytest.fixture
def preview(view, bar):
    return PathPreview(view, bar)


def test_a_path_is_shown_with_its_points_and_a_ghost_at_the_beginning(preview, view, bar):
    assert not bar.isVisible()
    preview.show(plan(), frozenset({1}))
    assert bar.isVisible()
    assert view.shown.ghost_deg == (0.0,) * 6
    path = view.shown.path
    assert (path.rows, path.bad_rows) == ((0, 1), frozenset({1}))
    assert path.marks_mm[:, 0].tolist() == [100.0, 200.0]


def test_the_slider_moves_the_ghost(preview, view, bar, qtbot):
    preview.show(plan())
    slider = bar.findChild(TrackSlider, "preview_slider")
    for _ in range(5):
        qtbot.keyClick(slider, Qt.Key.Key_Right)
    assert view.shown.ghost_deg[0] == pytest.approx(5.0)
    assert "0:00.5 / 0:02.0" in bar.findChild(object, "preview_time").text()


def test_a_selected_row_brings_the_ghost_to_its_point(preview, view, bar):
    preview.show(plan())
    preview.select_row(0)
    assert view.shown.selected_row == 0
    assert bar.time_s == pytest.approx(1.0)
    assert view.shown.ghost_deg[0] == pytest.approx(10.0)


def test_play_runs_to_the_end_and_stops_there(preview, view, bar, qtbot):
    preview.show(plan())
    bar.go_to(1.9)
    play = bar.findChild(QPushButton, "preview_play")
    qtbot.mouseClick(play, Qt.MouseButton.LeftButton)
    assert play.text() == "Pause"
    qtbot.waitUntil(lambda: not play.isChecked())
    assert view.shown.ghost_deg[0] == pytest.approx(20.0)
    assert play.text() == "Play"


@pytest.mark.parametrize(
    ("duration_s", "shown"),
    [(59.96, "0:00.0 / 1:00.0"), (8055.5, "0:00.0 / 2:14:15.5")],
)
def test_every_length_of_time_has_room(bar, duration_s, shown):
    bar.open(duration_s)
    label = bar.findChild(ValueLabel, "preview_time")
    assert label.text() == shown
    assert label.sizeHint().width() >= label.fontMetrics().horizontalAdvance(shown)


def test_closing_takes_all_of_it_away(preview, view, bar, qtbot):
    preview.show(plan())
    with qtbot.waitSignal(preview.closed):
        qtbot.mouseClick(bar.findChild(QPushButton, "preview_close"), Qt.MouseButton.LeftButton)
    assert view.shown == NOTHING
    assert not bar.isVisible()
    preview.show(plan())
    preview.show(None)
    assert view.shown == NOTHING
