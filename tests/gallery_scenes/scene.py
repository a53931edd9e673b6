"""One state of the window or of a dialog, and what the scenes of several subjects need."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QApplication, QDialog, QWidget

from tests.app_driver import AppDriver


@dataclass(frozen=True)
class Scene:
    """One state of the main window.

    Attributes:
        name: For the file.
        play: Brings a window that has just opened, with no device, to this state.
        panels: Whether each panel of the operation area is a picture, too.
        sizes: Of the window, in pixels, where others than the usual ones tell more.
        fine: Whether it is taken once more on a screen of 3840×2160 at 200 %.
    """

    name: str
    play: Callable[[AppDriver], object]
    panels: bool = False
    sizes: tuple[tuple[int, int], ...] = ()
    fine: bool = False


@dataclass(frozen=True)
class DialogScene:
    """One dialog in one state.

    Attributes:
        name: For the file.
        during: The name of the scene of the window in which it is opened.
        open: Opens it; called once for each language and theme.
    """

    name: str
    during: str
    open: Callable[[AppDriver], QWidget]


def settled(app_driver: AppDriver) -> None:
    """Until the settings of the arm are read or written."""
    app_driver.run_until(lambda: not app_driver.controller.settings.busy)


def close_dialogs() -> None:
    """Leave no dialog open for the next picture."""
    for widget in QApplication.topLevelWidgets():
        if isinstance(widget, QDialog) and widget.isVisible():
            widget.reject()
    QCoreApplication.processEvents()
