"""The arms of the family: each in the window, and a choice that the arm contradicts."""

from __future__ import annotations

from typing import Final

from PySide6.QtWidgets import QDialog

from armui.protocol.generation import PiperModel
from tests.app_driver import AppDriver
from tests.gallery_scenes import dialogs

_RAISED_DEG: Final = (25.0, 70.0, -60.0, 20.0, 40.0, 10.0)
_LEANING_DEG: Final = (10.0, 60.0, -60.0, 5.0, 30.0, 0.0)


def _show(app_driver: AppDriver, true: PiperModel, chosen: PiperModel) -> None:
    app_driver.lie(_RAISED_DEG if true is chosen else _LEANING_DEG, true)
    app_driver.connect(chosen)
    app_driver.run(3.0)


def piper_h(app_driver: AppDriver) -> None:
    _show(app_driver, PiperModel.PIPER_H, PiperModel.PIPER_H)


def piper_l(app_driver: AppDriver) -> None:
    _show(app_driver, PiperModel.PIPER_L, PiperModel.PIPER_L)


def piper_x(app_driver: AppDriver) -> None:
    _show(app_driver, PiperModel.PIPER_X, PiperModel.PIPER_X)


def wrong(app_driver: AppDriver) -> None:
    _show(app_driver, PiperModel.PIPER_L, PiperModel.PIPER)


def connect_wrong(app_driver: AppDriver) -> QDialog:
    return dialogs.connect(app_driver)
