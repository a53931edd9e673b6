"""The local interface: a program that asks for the arm, has it, and wants what is dangerous."""

from __future__ import annotations

from dataclasses import replace
from datetime import datetime

from PySide6.QtWidgets import QDialog

from armui.control.events import Event
from armui.interface.interface_view import Consented, InterfaceView
from armui.interface.lease import LEASE_TAKEN_BACK, Ask, Client, Lease
from armui.interface.reasons import LEASE_ENDED, LEASE_GRANTED
from armui.ui.interface.client_question import ConsentDialog, GrantDialog
from armui.ui.interface.interface_dialog import InterfaceDialog
from tests.app_driver import AppDriver
from tests.gallery_scenes.arm import moving

_CLIENT = Client(1, "bottle sorting", 4711, "python3 sort_bottles.py")
_OTHER = Client(2, "notebook", 4720, "python3 jupyter-lab")
_VIEW = InterfaceView(True, None, "/run/user/1000/armui/api.sock", (_CLIENT, _OTHER))


def _show(app_driver: AppDriver, view: InterfaceView) -> None:
    """Show what a client at the socket would bring about, without waiting for its thread."""
    interface = app_driver.program.interface
    interface.switch = lambda **_on: None  # it is on
    interface._view = view
    interface.changed.emit(view)


def _ask(app_driver: AppDriver, ago_s: float) -> Ask:
    purpose = "put twelve bottles from the tray into the crate"
    return Ask(_CLIENT, purpose, True, 60, app_driver.time_s - ago_s)


def connected(app_driver: AppDriver) -> None:
    """Two programs read the arm."""
    app_driver.ready()
    _show(app_driver, _VIEW)


def leased(app_driver: AppDriver) -> None:
    """One of them moves it."""
    moving(app_driver)
    lease = Lease(_ask(app_driver, 100.0), 30, app_driver.time_s - 83.0)
    _show(app_driver, replace(_VIEW, lease=lease, doing="motion.send"))


def asks(app_driver: AppDriver) -> QDialog:
    """One of them asks for the arm."""
    _show(app_driver, _VIEW)  # the question of another language or theme is over
    _show(app_driver, replace(_VIEW, asked=_ask(app_driver, 7.0)))
    return app_driver.dialog(GrantDialog)


def wants_to_disable(app_driver: AppDriver) -> QDialog:
    """It has the arm, and wants to disable the motors."""
    now = replace(app_driver.program.interface.view, consent=None)
    _show(app_driver, now)
    told = Consented(_CLIENT, "motors.disable", "Disable motors", {}, app_driver.time_s - 3.0)
    _show(app_driver, replace(now, consent=told))
    return app_driver.dialog(ConsentDialog)


def window(app_driver: AppDriver) -> InterfaceDialog:
    """Who is connected, and what was granted."""
    controller = app_driver.controller
    if not any(each.code == LEASE_ENDED.id for each in controller.event_collector.log.entries()):
        at = datetime(2026, 1, 15, 12, 0).astimezone()
        reason, client = LEASE_TAKEN_BACK(), str(_CLIENT)
        controller.noticed.emit(Event(at, LEASE_GRANTED, {"client": client, "percent": 60}))
        controller.noticed.emit(Event(at, LEASE_ENDED, {"client": client, "reason": reason}))
        controller.noticed.emit(Event(at, LEASE_GRANTED, {"client": client, "percent": 30}))
    app_driver.window.pages.show("interface")
    return app_driver.dialog(InterfaceDialog)
