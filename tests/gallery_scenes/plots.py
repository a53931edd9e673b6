"""The window 曲线 in use."""

from __future__ import annotations

import tempfile
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QLabel, QWidget

from armui.ui.watch.plot_layout import SETS
from armui.ui.watch.plots_area import PlotPage
from tests.app_driver import AppDriver

SIZE_PX = (1180, 760)


def _window(app_driver: AppDriver, name: str, span_s: float) -> PlotPage:
    """The window with one of its sets, running."""
    app_driver.window.show_as_curves(())
    window = app_driver.taken_out(PlotPage)
    window.resize(*SIZE_PX)
    board = window.board
    app_driver.wait(lambda: window._known)
    board.pause(wanted=False)
    board.show_cursors(wanted=False)
    board.show_plots(SETS[name])
    board.set_span(span_s)
    board.frame.forget_plots()
    app_driver.wait(lambda: board.built)
    return window


def _drawn(app_driver: AppDriver, window: PlotPage) -> QWidget:
    window.bar.refresh()
    app_driver.wait(lambda: window.board.panes[0].graphs[0].width_px > 100)
    window.board.draw(window.board.now_s())
    for pane in window.board.panes:
        pane.show_values(window.board.now_s())
    return window.window()


def follow(app_driver: AppDriver) -> QWidget:
    return _drawn(app_driver, _window(app_driver, "follow", 5.0))


def why_stopped(app_driver: AppDriver) -> QWidget:
    if app_driver.controller.telemetry.series["ArmStatus"].count < 800:  # once, in four pictures
        app_driver.run(4.0)
    return _drawn(app_driver, _window(app_driver, "stop", 10.0))


def cursors(app_driver: AppDriver) -> QWidget:
    window = _window(app_driver, "follow", 10.0)
    board = window.board
    board.show_plots((*SETS["follow"][:3], ("arm.motor_current.1", "arm.motor_current.2")))
    board.frame.zoom(board.now_s(), -3.2, -0.4)
    board.show_cursors(wanted=True)
    app_driver.wait(lambda: board.built)
    return _drawn(app_driver, window)


def units(app_driver: AppDriver) -> QWidget:
    window = _window(app_driver, "tool", 5.0)
    angle_and_more = ("arm.joint_angle.2", "arm.motor_current.2", "arm.motor_temperature.2")
    window.board.show_plots((angle_and_more, *SETS["tool"][:1], SETS["tool"][4], ("bus.bus_load",)))
    app_driver.wait(lambda: window.board.built)
    return _drawn(app_driver, window)


def exported(app_driver: AppDriver) -> QWidget:
    """The picture that is written: with what is scrolled out of sight, each unit on its axis."""
    units(app_driver)
    page = app_driver.taken_out(PlotPage)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "curves.png"
        page.export.write("png", path)
        app_driver.wait(path.exists)
        label = QLabel()
        picture = QPixmap(str(path))
    label.setPixmap(picture.scaledToWidth(SIZE_PX[0], Qt.TransformationMode.SmoothTransformation))
    label.resize(label.sizeHint())
    return label


def hot(app_driver: AppDriver) -> QWidget:
    return _drawn(app_driver, _window(app_driver, "hot", 5.0))
