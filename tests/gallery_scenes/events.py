"""The window 事件 in use: what a simulated arm went through in some minutes."""

from __future__ import annotations

import datetime as dt

from PySide6.QtWidgets import QApplication, QWidget

from armui.sim.faults.schedule import fault
from armui.ui.watch.events.event_page import EventPage
from tests.app_driver import AppDriver

SIZE_PX = (1120, 720)
_BEGIN = dt.datetime(2026, 1, 15, 9, 30, 12, 480_000, tzinfo=dt.timezone(dt.timedelta(hours=8)))


def live(app_driver: AppDriver) -> None:
    """Connect, move, a driver that cuts out, recovery, a stop that is undone by hand."""
    controller = app_driver.controller
    controller._wall = controller.event_collector._writer._wall = lambda at_s: (
        _BEGIN + dt.timedelta(seconds=at_s - 1000.0)
    )
    app_driver.ready()
    act(app_driver)


def act(app_driver: AppDriver) -> None:
    """What happens once the arm is ready."""
    controller = app_driver.controller
    controller.motion.set_speed_percent(60)
    controller.motion.send_joints((20.0, 30.0, -30.0, 10.0, 5.0, 15.0))
    app_driver.run(2.5)
    overcurrent = fault("overcurrent", 3)
    app_driver.node.faults.start(overcurrent)
    app_driver.run(0.8)
    app_driver.node.faults.end(overcurrent)
    app_driver.run(0.4)
    controller.recovery.act(controller.recovery.step)
    app_driver.run(1.5)
    controller.recovery.act(controller.recovery.step)
    app_driver.run(1.0)
    app_driver.node.faults.start(garbage := fault("garbage"))
    app_driver.run(1.0)
    app_driver.node.faults.end(garbage)
    controller.motion.go_home()
    app_driver.run(0.5)
    controller.emergency_stop()
    app_driver.run(0.6)


def _window(app_driver: AppDriver) -> EventPage:
    app_driver.click("events_button")
    window = app_driver.taken_out(EventPage)
    window.resize(*SIZE_PX)
    window.refresh()
    return window


def events(app_driver: AppDriver) -> QWidget:
    window = _window(app_driver)
    window.bar.show_all()
    window.refresh()
    shown = window.model.entries()
    number = next(each.number for each in shown if each.code == "joint_fault")
    window.show_entry(number)
    QApplication.processEvents()
    return window.window()


def searched(app_driver: AppDriver) -> QWidget:
    window = _window(app_driver)
    window.bar.show_all()
    window.bar.levels.setCurrentIndex(1)
    window.bar.search.setText("J3")
    window.bar._on_filter_changed()
    app_driver.wait(lambda: not window.model.searching)
    return window.window()
