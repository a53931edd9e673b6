"""Jogging by gamepad and SpaceMouse: the sign in the window, and the settings."""

from __future__ import annotations

from PySide6.QtWidgets import QDialog

from armui.control.gamepad.pilot import GAMEPAD_NOT_IN_FRONT
from armui.gamepad.device_state import DeviceInfo
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.gamepad.gamepad_dialog import GamepadDialog
from tests.app_driver import AppDriver
from tests.control.jogger import bend
from tests.gamepad.pads import MOUSE, PAD, Pads, switch_on
from tests.gamepad.piloting import pass_time, pick_up


def _switched_on(app_driver: AppDriver, **choices: object) -> Pads:
    pads = Pads()
    app_driver.window.activateWindow()
    switch_on(app_driver.program, pads, **choices)
    return pads


def waiting(app_driver: AppDriver) -> None:
    """Found, and nothing is held."""
    bend(app_driver)
    _switched_on(app_driver).plug_in()
    pass_time(app_driver, 0.05)


def jogging(app_driver: AppDriver) -> None:
    """Two axes of the base at once."""
    bend(app_driver)
    pads = _switched_on(app_driver, gamepad_mode="base", gamepad_one_axis=False)
    pick_up(app_driver, pads)
    pads.push(left_y=-0.9, right_y=-0.7, right_trigger=0.6)
    pass_time(app_driver, 0.3)


def taken_away(app_driver: AppDriver) -> None:
    """Another window came in front."""
    bend(app_driver)
    pads = _switched_on(app_driver)
    pick_up(app_driver, pads)
    pads.push(left_x=-1.0)
    pass_time(app_driver, 0.2)
    app_driver.controller.gamepad.lose(GAMEPAD_NOT_IN_FRONT())


def _settings(app_driver: AppDriver, pads: Pads, *found: DeviceInfo) -> QDialog:
    switch_on(app_driver.program, pads)
    for info in found:
        pads.plug_in(info)
    app_driver.controller.gamepad.tick()
    app_driver.window.pages.show("settings")
    settings = app_driver.dialog(SettingsDialog)
    settings.gamepad_button.click()
    settings.close()
    return app_driver.dialog(GamepadDialog)


def settings(app_driver: AppDriver) -> QDialog:
    """Two devices, a stick and a button of the first pushed."""
    pads = Pads()
    dialog = _settings(app_driver, pads, PAD, MOUSE)
    pads.push(left_y=-0.8, left_x=0.12, right_trigger=0.5)
    pads.press("left_shoulder")
    app_driver.controller.gamepad.tick()
    dialog._show_live()  # type: ignore[attr-defined]  # now, and not at the next tick of its timer
    return dialog


def space_mouse(app_driver: AppDriver) -> QDialog:
    """A SpaceMouse alone."""
    pads = Pads()
    dialog = _settings(app_driver, pads, MOUSE)
    pads.push(MOUSE, x=0.5, rz=-0.7)
    app_driver.controller.gamepad.tick()
    dialog._show_live()  # type: ignore[attr-defined]  # as above
    return dialog


def not_installed(app_driver: AppDriver) -> QDialog:
    """Without the libraries."""
    pads = Pads()
    pads.missing = ("pysdl2", "hidapi")
    return _settings(app_driver, pads)
