"""The right button on any figure of the program shows it as a curve."""

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QApplication, QMenu, QTableView, QWidget

from armui.telemetry.quantities import QUANTITIES
from armui.ui.panels.gripper_panel import GripperPanel
from armui.ui.panels.jogging.cartesian_panel import CartesianPanel
from armui.ui.panels.motor_panel import MotorPanel
from armui.ui.panels.parameters.end_load_panel import EndLoadPanel
from armui.ui.watch.joint_status_page import JointStatusPage
from armui.ui.widgets.curve_menu import quantities_under
from armui.viewport.hud import Hud
from tests.operator.plots.actions import Plots, ask_for_menu, trigger

pytestmark = pytest.mark.styled


@pytest.fixture(autouse=True)
def no_menu_is_left():
    yield
    while (popup := QApplication.activePopupWidget()) is not None:
        popup.close()


def window_of(driver):
    """The window 曲线, once it shows what was asked for."""
    plots = Plots.__new__(Plots)
    plots.driver = driver
    plots.window = driver.window._workspace.kept("plots")
    plots.board = plots.window.board
    plots.wait_built()
    return plots


def ask(widget):
    ask_for_menu(widget, widget.rect().center())
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    return menu


def panel(driver, kind):
    panels = driver.window._panels
    for place in range(panels.count()):
        driver.window._show_panel(place)
        driver.run(0.1)
        if isinstance(panels.currentWidget(), kind):
            return panels.currentWidget()
    raise AssertionError(kind)


def test_a_joint_of_the_motion_panel(app_driver):
    app_driver.ready()
    trigger(ask(app_driver.find("measured_3")), "Show as curve")
    plots = window_of(app_driver)
    assert plots.window.isVisible()
    # it is in the set that is shown already: no plot is added, its own is chosen
    assert len(plots.keys()) == 6
    assert plots.board.panes[2].chosen


def test_a_figure_of_the_status_bar_gets_a_plot_of_its_own(app_driver):
    app_driver.ready()
    trigger(ask(app_driver.find("status_arm")), "Show as curve")
    plots = window_of(app_driver)
    assert plots.keys()[6:] == [["arm.arm_status"]]
    plots.draw()
    assert plots.values(6) == {"arm.arm_status": "Normal"}
    # asked for again it is there already
    trigger(ask(app_driver.find("status_arm")), "Show as curve")
    assert len(window_of(app_driver).keys()) == 7


def test_a_cell_of_the_joint_status(app_driver):
    app_driver.ready()
    app_driver.click("joint_status_button")
    page = app_driver.page(JointStatusPage)
    app_driver.run(0.2)
    table = page.findChild(QTableView)
    cell = table.visualRect(table.model().index(2, 3)).center()
    ask_for_menu(table.viewport(), cell)
    trigger(QApplication.activePopupWidget(), "Show as curve")
    assert window_of(app_driver).keys()[6:] == [["arm.motor_temperature.4"]]


def under(window, widget):
    return quantities_under(window, widget.mapTo(window, widget.rect().center()))


def test_figures_of_the_panels(app_driver):
    app_driver.ready()
    window = app_driver.window
    motors = panel(app_driver, MotorPanel)
    for name, key in (
        ("current_2", "arm.motor_current.2"),
        ("voltage_1", "arm.voltage.1"),
        ("driver_temperature_1", "arm.driver_temperature.1"),
    ):
        assert under(window, motors.findChild(QWidget, name)) == [key]
    tool = panel(app_driver, CartesianPanel).findChild(QWidget, "pose_measured_RX")
    assert under(window, tool) == ["arm.pose_rx", "own.pose_rx", "other.pose_rx"]
    gripper = panel(app_driver, GripperPanel).findChild(QWidget, "gripper_opening_measured")
    assert under(window, gripper)[0] == "arm.gripper_opening"
    assert under(window, app_driver.find("speed_field"))[0] == "arm.speed_percent"
    cells = panel(app_driver, EndLoadPanel)._cells
    keys = {key for cell in cells.values() for key in cell.property("quantities")}
    assert keys <= set(QUANTITIES)
    assert len(keys) == 24


def test_every_figure_that_says_what_it_is_can_be_drawn(app_driver):
    app_driver.ready()
    for place in range(app_driver.window._panels.count()):
        app_driver.window._show_panel(place)
    told = [
        key
        for widget in app_driver.window.findChildren(QWidget)
        for key in widget.property("quantities") or ()
    ]
    assert len(told) > 100
    assert set(told) <= set(QUANTITIES)


def test_what_is_no_figure_has_no_menu(app_driver):
    app_driver.ready()
    label = app_driver.find("notice_label")
    ask_for_menu(label, label.rect().center())
    assert QApplication.activePopupWidget() is None


def test_each_figure_over_the_picture(qapp):
    hud, font = Hud(), qapp.font()
    frame = hud.frame(font)

    def keys(of_tool):
        places = [
            frame.topLeft() + QPoint(x, 18 + round(line * frame.height() / 7.9))
            for x in (20, round(frame.width()) - 20)
            for line in range(7)
        ]
        return [hud.quantity_at(place, font, of_tool=of_tool) for place in places]

    for of_tool, point in ((False, "pose"), (True, "tool")):
        assert keys(of_tool) == [
            None,  # the name of the point, with no figure beside it
            *(f"arm.{point}_{axis}" for axis in ("x", "y", "z", "rx", "ry", "rz")),
            None,
            *(f"arm.joint_angle.{joint}" for joint in range(1, 7)),
        ]
    assert hud.quantity_at(frame.bottomRight() + QPoint(3, 3), font, of_tool=False) is None


def test_with_a_tool_the_curve_is_that_of_its_point(app_driver):
    app_driver.ready()
    row = panel(app_driver, CartesianPanel).findChild(QWidget, "pose_measured_Z")
    view = app_driver.program.view
    place = view._hud_painter.frame(view.font()).topLeft().toPoint() + QPoint(20, 60)
    assert view.quantities_at(place)[0].startswith("arm.pose_")
    assert app_driver.controller.telemetry.latest("arm.tool_z") is None
    app_driver.type_into("tool_field_Z", "120")
    app_driver.run(0.3)

    (key,) = view.quantities_at(place)
    assert key.startswith("arm.tool_")
    assert under(app_driver.window, row) == ["arm.tool_z"]
    shown = app_driver.controller.cartesian.tool_pose(app_driver.controller.state)
    kept = [app_driver.controller.telemetry.latest(f"arm.tool_{axis}") for axis in ("x", "y", "z")]
    assert [value for _at_s, value in kept] == pytest.approx(shown[:3], abs=0.01)
    flange = app_driver.controller.state.end_pose()
    assert sum((a - b) ** 2 for a, b in zip(shown, flange[:3], strict=False)) ** 0.5 > 100
