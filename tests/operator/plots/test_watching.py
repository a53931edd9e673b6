"""What the curves show, and how they are put together by hand."""

import math
from itertools import pairwise

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit, QTreeView

from armui.arm.limits import JOINTS
from armui.ui.watch.plot_layout import MOST_PLOTS, SETS
from tests.company import OtherHost
from tests.operator.plots.actions import LEFT, trigger
from tests.sim.talk import mode, target

pytestmark = pytest.mark.styled

FOLLOW = [[f"{source}.joint_angle.{joint}" for source in ("arm", "own", "other")]
          for joint in JOINTS]  # fmt: skip


def test_it_opens_with_what_was_asked_and_what_was_done(plots):
    assert plots.keys() == FOLLOW
    assert plots.values(1) == {
        "arm.joint_angle.2": "30.000°",
        "own.joint_angle.2": "30.000°",
        "other.joint_angle.2": "—",
    }
    pane = plots.board.panes[0]
    measured, commanded, other = (
        pane.graphs[0].curves._curves[place][1] for place in range(3)
    )  # fmt: skip
    assert len(measured) >= 1
    assert len(commanded) == 1
    assert other == []
    # the command stood before the joint had got there, and stands to the right end
    begin, end = commanded[0].first().x(), commanded[0].last().x()
    assert end == pytest.approx(plots.board.now_s())
    assert plots.board.now_s() - begin == pytest.approx(4.0, abs=0.1)
    low, high = pane.graphs[0].heights
    assert low < 0.0
    assert high > 20.0


def test_a_stop_ends_the_command_that_stood(plots):
    plots.driver.controller.emergency_stop()
    plots.driver.run(1.0)
    plots.draw()
    assert plots.values(0)["own.joint_angle.1"] == "—"
    (piece,) = plots.board.panes[0].graphs[0].curves._curves[1][1]
    assert plots.board.now_s() - piece.last().x() == pytest.approx(1.0, abs=0.1)


def test_targets_of_another_host_are_told_apart(plots, app_driver):
    host = OtherHost(app_driver)
    host.say(*target(1.0, 2.0, -3.0, 4.0, 5.0, 6.0), mode(10))
    app_driver.run(0.5)
    host.close()
    plots.draw()
    assert plots.values(2)["other.joint_angle.3"] == "-3.000°"
    assert plots.values(2)["own.joint_angle.3"] == "—"


def test_what_is_not_heard_any_more_looks_so(plots, app_driver):
    app_driver.powered = False
    app_driver.run(2.0)
    plots.draw()
    entry = plots.board.panes[0].legend.entries[0]
    assert entry.stale
    pieces = plots.board.panes[0].graphs[0].curves._curves[0][1]
    assert plots.board.now_s() - pieces[-1].last().x() == pytest.approx(2.0, abs=0.1)
    app_driver.powered = True
    app_driver.run(1.0)
    plots.draw()
    # a gap, not a line across it
    pieces = plots.board.panes[0].graphs[0].curves._curves[0][1]
    ends = sorted((piece.first().x(), piece.last().x()) for piece in pieces)
    assert any(second[0] - first[1] > 1.5 for first, second in pairwise(ends))


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("Temperatures and currents", "hot"),
        ("Why it stopped", "stop"),
        ("Tool pose", "tool"),
        ("Bus health", "bus"),
    ],
)
def test_sets_answer_a_question(plots, text, name):
    plots.choose("plot_sets", text)
    plots.draw()
    assert plots.keys() == [list(plot) for plot in SETS[name]]
    assert any(value != "—" for value in plots.values(0).values())
    assert all(
        math.isfinite(end)
        for pane in plots.board.panes
        for graph in pane.graphs
        for end in graph.heights
    )


def test_a_quantity_is_dragged_from_the_list_into_a_plot(plots):
    tree = plots.find(QTreeView, "quantity_tree")
    index = plots.window.quantities.index_of("arm.motor_current.2")
    QApplication.processEvents()
    pane = plots.board.panes[1]
    plots.carry(tree.viewport(), tree.visualRect(index).center(), pane, QPoint(200, 60))
    assert plots.keys()[1] == [*FOLLOW[1], "arm.motor_current.2"]
    assert len(plots.keys()) == 6
    plots.draw()
    assert plots.values(1)["arm.motor_current.2"] != "—"


def test_a_quantity_dropped_below_gets_a_plot_of_its_own(plots):
    tree = plots.find(QTreeView, "quantity_tree")
    index = plots.window.quantities.index_of("bus.bus_load")
    QApplication.processEvents()
    strip = plots.board._strip
    plots.carry(tree.viewport(), tree.visualRect(index).center(), strip, strip.rect().center())
    assert plots.keys()[6:] == [["bus.bus_load"]]


def test_a_curve_is_dragged_from_plot_to_plot(plots):
    legend = plots.board.panes[0].legend
    start = legend.place_of("own.joint_angle.1")
    plots.carry(legend, start, plots.board.panes[1], QPoint(200, 60))
    assert plots.keys()[0] == ["arm.joint_angle.1", "other.joint_angle.1"]
    assert plots.keys()[1] == [*FOLLOW[1], "own.joint_angle.1"]


def test_the_list_is_searched_and_a_double_click_adds_to_the_chosen_plot(plots):
    QTest.keyClicks(plots.find(QLineEdit, "quantity_search"), "bus load")
    tree = plots.find(QTreeView, "quantity_tree")
    top = tree.model().index(0, 0)
    assert tree.model().rowCount() == 1
    assert tree.model().rowCount(top) == 1
    plots.driver.click(plots.board.panes[2].legend)
    assert plots.board.panes[2].chosen
    place = tree.visualRect(tree.model().index(0, 0, top)).center()
    QTest.mouseClick(tree.viewport(), LEFT, pos=place)
    QTest.mouseDClick(tree.viewport(), LEFT, pos=place)
    plots.wait_built()
    assert plots.keys()[2] == [*FOLLOW[2], "bus.bus_load"]


def test_what_was_never_heard_is_muted_in_the_list(plots):
    items = plots.window.quantities._items
    heard = items["arm.joint_angle.1"].foreground().color()
    assert items["own.joint_angle.1"].foreground().color() == heard
    assert items["other.mit_torque.1"].foreground().color() != heard


def test_curves_and_plots_are_removed_by_their_menu(plots):
    pane = plots.board.panes[0]
    menu = plots.menu_at(pane, pane.legend.mapTo(pane, pane.legend.place_of("arm.joint_angle.1")))
    trigger(menu, "Remove curve")
    plots.wait_built()
    assert plots.keys()[0] == ["own.joint_angle.1", "other.joint_angle.1"]
    pane = plots.board.panes[3]
    trigger(plots.menu_at(pane, QPoint(300, 70)), "Remove plot")
    plots.wait_built()
    assert len(plots.keys()) == 5
    assert plots.window.bar.sets.currentText() == "Custom layout"


def test_no_more_plots_than_can_be_read(plots):
    for joint in JOINTS:
        plots.board.take([f"arm.voltage.{joint}"], None, None)
    plots.wait_built()
    assert len(plots.keys()) == MOST_PLOTS
    plots.board.take(["bus.bus_load"], None, None)
    plots.wait_built()
    assert len(plots.keys()) == MOST_PLOTS
    assert "remove one first" in plots.window.area.message.text()


def test_hidden_plots_do_nothing(plots, monkeypatch):
    drawn = []
    for pane in plots.board.panes:
        monkeypatch.setattr(pane, "advance", lambda *_args, pane=pane: drawn.append(pane))
    plots.driver.wait(lambda: drawn)
    plots.window.close()
    QTest.qWait(50)  # a page that was moved out of its window is drawn in its colours once more
    drawn.clear()
    QTest.qWait(200)
    assert drawn == []


def test_minimised_or_scrolled_away_plots_are_not_drawn(plots, monkeypatch):
    plots.choose("plot_sets", "Why it stopped")
    for joint in JOINTS:
        plots.board.take([f"arm.voltage.{joint}"], None, None)
    plots.wait_built()
    drawn = set()
    for place, pane in enumerate(plots.board.panes):
        monkeypatch.setattr(pane, "advance", lambda *_args, place=place: drawn.add(place))
    plots.board.draw(plots.board.now_s())
    assert 0 in drawn
    assert 11 not in drawn
    plots.window.window().showMinimized()
    QApplication.processEvents()
    drawn.clear()
    plots.board._on_tick()
    assert drawn == set()


def test_everything_follows_language_and_colours(plots):
    plots.driver.store.change(language="zh", theme="dark")
    QApplication.processEvents()
    plots.draw()
    assert plots.window.title == "曲线"
    assert plots.board.panes[0].legend.title == "J1 角度"
    assert plots.window.bar.sets.currentText() == "目标与测量"
    dark = plots.board.panes[0].curve_colors["arm.joint_angle.1"]
    plots.driver.store.change(theme="light")
    QApplication.processEvents()
    assert plots.board.panes[0].curve_colors["arm.joint_angle.1"] != dark


@pytest.mark.parametrize("key", [Qt.Key.Key_F12, Qt.Key.Key_Pause])
def test_the_stop_key_works_here(plots, key):
    stops = []
    plots.driver.controller.emergency_stop = lambda: stops.append(1)
    QTest.keyPress(plots.window.quantities.tree, key)
    assert stops == [1]
    box = plots.window.bar.sets
    box.showPopup()
    popup = QApplication.activePopupWidget()
    assert popup is not None
    QTest.keyPress(popup, key)
    assert stops == [1, 1]


def axis_texts(graph):
    """What stands on an axis, from below."""
    low, high = graph.heights
    axis, length_px = graph._figures, graph.box.rect().height()
    spacing, values = axis.tickValues(low, high, length_px)[0]
    return axis.tickStrings(values, 1.0, spacing)


def test_every_unit_has_an_axis_that_names_it(plots):
    """0.005 A under 40° in one plot is a curve and no flat line."""
    mixed = ["arm.joint_angle.1", "arm.motor_current.2", "arm.motor_temperature.1"]
    plots.board.show_plots([[*mixed, "arm.joint_angle.2"], ["arm.arm_status"], ["bus.bus_load"]])
    plots.wait_built()
    plots.draw()
    pane, status, load = plots.board.panes
    assert [graph.unit for graph in pane.graphs] == ["°", "A", "°C"]
    assert [len(graph.curves._curves) for graph in pane.graphs] == [2, 1, 1]
    for graph in (*pane.graphs, *load.graphs):
        texts = axis_texts(graph)
        assert texts
        assert all(text.endswith(graph.unit) for text in texts)
        figures = [y for _pen, lines in graph.curves._curves for line in lines for y in ys(line)]
        low, high = graph.heights
        assert low < min(figures) <= max(figures) < high
    currents = pane.graphs[1].heights
    assert currents[1] - currents[0] < 5.0
    assert all(text == text.strip() for text in axis_texts(status.graphs[0]))
    # each is looked at by itself, and all are fitted at once
    before = [graph.heights for graph in pane.graphs]
    pane.graphs[1].box.turned_height.emit(0.5, 0.0)
    plots.draw()
    after = [graph.heights for graph in pane.graphs]
    assert (after[0], after[2]) == (before[0], before[2])
    assert after[1][1] - after[1][0] == pytest.approx(0.5 * (before[1][1] - before[1][0]))
    plots.board.show_all_heights(0)
    plots.draw()
    assert [graph.heights for graph in pane.graphs] == before


def ys(line):
    """The figures of a line."""
    return [line[place].y() for place in range(line.size())]
