"""A random walk over the windows: ``python -m tests.window_walk --steps 3000 --seed 1``.

An operator who clicks everywhere: panels, pages, windows, taken out and put back, restarts, sizes,
languages and themes, and now and then a stop, which the arm must hear whatever is shown. After each
step the program is looked at, see `faults`.
"""

from __future__ import annotations

import argparse
import itertools
import os
import random
import sys
import tempfile
import time
from collections import Counter
from functools import partial
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import QCoreApplication, QEvent, QPoint, QRect, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractScrollArea,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDialog,
    QLabel,
    QLineEdit,
    QMenu,
    QPushButton,
    QScrollArea,
    QToolButton,
    QWidget,
)

from armui.protocol.generation import Generation
from armui.system import failures
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.actions.window_actions import WindowActions
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.shell.workspace import PageWindow
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.text_label import ElidedLabel
from tests.app_driver import PANELS, AppDriver
from tests.operator.library.actions import POINT

SIZES = ((1024, 720), (1280, 800), (1440, 900), (1920, 1080), (2560, 1440), (3840, 2160))
"""Of the main window, in pixels."""
CONTROLS = (QAbstractButton, QAbstractSpinBox, QComboBox, QLineEdit)
_SLACK_PX = 2
_KINDS = {
    "panel": 4, "page": 4, "take_out": 3, "put_back": 3, "size": 3, "dialog": 3, "close": 3,
    "language": 0.5, "theme": 0.3, "restart": 0.4, "back": 1, "editor": 1, "lists": 3, "stop": 1,
}  # fmt: skip
"""Of steps, and how often each is taken."""


class Walk:
    """Takes one step after another.

    Args:
        app: Qt's application.
        folder: For settings and trajectories.
        seed: The same seed takes the same steps.
    """

    def __init__(self, app: QApplication, folder: Path, seed: int) -> None:
        self._app = app
        self._folder = folder
        self._random = random.Random(seed)
        self._numbers = itertools.count()
        self._failures: list[failures.Failure] = []
        self.driver = self._start()
        self.names: list[str] = []

    def _start(self) -> AppDriver:
        name = f"walk {os.getpid()} {id(self)} {next(self._numbers)}"
        driver = AppDriver(self._app, name, self._folder / "settings.json", Generation.TWO)
        setattr(driver.program.window, "show_failure", self._failures.append)  # noqa: B010 - a stand-in
        driver.repeat_nothing()
        library = Library(driver.library_folder)
        if not library.entries():
            for each, points in (("one", (POINT, POINT)), ("empty", ())):
                library.save(Trajectory(each, points=points))
        driver.connect()
        driver.window.page_actions.reopen()
        self._settle(driver)
        return driver

    def _settle(self, driver: AppDriver) -> None:
        driver.run(0.04)
        for _ in range(3):
            QCoreApplication.processEvents()
            QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)

    def close(self) -> None:
        """End the program."""
        self.driver.window.close()
        self.driver.close()
        self._settle_only()

    def _settle_only(self) -> None:
        QCoreApplication.processEvents()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)

    # Steps ------------------------------------------------------------------------------------

    def step(self, kind: str = "") -> list[str]:
        """Take one of a kind, by default any; returns what is wrong after it."""
        kind = kind or self._random.choices(list(_KINDS), list(_KINDS.values()))[0]
        self.names.append(kind)
        before = set(shown_windows())
        found: list[str] = getattr(self, f"_{kind}")() or []
        self._settle(self.driver)
        found += [f"exception: {each}" for each in self._failures]
        self._failures.clear()
        for window in shown_windows():
            if window not in before and isinstance(window, QDialog) and not window.focusWidget():
                found.append(f"{_path(window)}: opened without focus")
        return found + faults(self.driver)

    def _lists(self) -> list[str]:
        return [each for window in shown_windows() for each in short_lists(window)]

    def _stop(self) -> list[str]:
        """Stop from any window, by its button or by the key; a stopped arm is recovered."""
        stops = [
            (window, button)
            for window in shown_windows()
            for button in window.findChildren(StopButton)
            if button.window() is window and button.isVisible()
        ]
        window, button = self._random.choice(stops)
        by_key = self._random.random() < 0.5
        self.names[-1] += f" {window.objectName() or type(window).__name__} {by_key=}"
        self.driver.heard()
        if by_key:
            QTest.keyClick(window.focusWidget() or window, Qt.Key.Key_F12)
        else:
            self.driver.click(button)
        self.driver.run(0.04)
        heard = [(each.arbitration_id, each.data[0]) for each in self.driver.heard()]
        questions = [each for each in shown_windows() if isinstance(each, ConfirmDialog)]
        if not by_key and questions:  # the arm has stopped: it is asked first
            self.names[-1] += " recovers"
            self.driver.confirm()
            return []
        return [] if (0x150, 1) in heard else [f"{_path(window)}: {by_key=}, no stop at the arm"]

    def _click(self, name: str) -> None:
        found = [
            each
            for each in self.driver.window.findChildren(QAbstractButton, name)
            if each.isVisible() and each.isEnabled() and each.window() is self.driver.window
        ]
        if found:
            self.names[-1] += f" {name}"
            found[0].click()

    def _panel(self) -> None:
        self._click(f"menu_{self._random.choice(PANELS)}")

    def _page(self) -> None:
        names = ("library", "plots", "events", "bus", "sessions", "joint_status")
        self._click(f"{self._random.choice(names)}_button")

    def _editor(self) -> None:
        self.driver.window.pages.trajectories.open_editor(self._random.choice(("one", "empty")))

    def _back(self) -> None:
        self._click(self._random.choice(("page_back", "drawer_fold", "page_crumb")))

    def _take_out(self) -> None:
        self._click(self._random.choice(("page_take_out", "drawer_take_out")))

    def _put_back(self) -> None:
        windows = [each for each in shown_windows() if isinstance(each, PageWindow)]
        if windows:
            window = self._random.choice(windows)
            self.names[-1] += f" {window.objectName()}"
            button = window.findChild(QToolButton, "page_put_back")
            assert button is not None
            button.click()

    def _size(self) -> None:
        width, height = self._random.choice(SIZES)
        self.names[-1] += f" {width}x{height}"
        self.driver.window.resize(width, height)

    def _dialog(self) -> None:
        window = self.driver.window
        actions = window.findChild(WindowActions)
        openers = {
            **{
                key: partial(window.pages.show, key)
                for key in ("connect", "settings", "backup", "replay", "export")
            },
            "shortcuts": actions.open_shortcuts,
            "guide": actions.open_guide,
        }
        name = self._random.choice(sorted(openers))
        self.names[-1] += f" {name}"
        openers[name]()

    def _close(self) -> None:
        windows = [each for each in shown_windows() if isinstance(each, QDialog)]
        if windows:
            window = self._random.choice(windows)
            self.names[-1] += f" {window.objectName() or type(window).__name__}"
            window.close()

    def _language(self) -> None:
        now = self.driver.store.settings.language
        self.driver.store.change(language="en" if now == "zh" else "zh")

    def _theme(self) -> None:
        now = self.driver.store.settings.theme
        self.driver.store.change(theme="light" if now == "dark" else "dark")

    def _restart(self) -> None:
        language, size = self.driver.store.settings.language, self.driver.window.size()
        self.close()
        self.driver = self._start()
        self.driver.store.change(language=language)
        self.driver.window.resize(size)


# What is looked at ----------------------------------------------------------------------------


def shown_windows() -> list[QWidget]:
    """The windows of the program that are seen, without menus and other popups."""
    return [
        each
        for each in QApplication.topLevelWidgets()
        if each.isVisible() and not isinstance(each, QMenu) and each.windowType() in _WINDOWS
    ]


_WINDOWS = {Qt.WindowType.Window, Qt.WindowType.Dialog}


def faults(driver: AppDriver) -> list[str]:
    """Return what is wrong in the windows that are seen, in words; nothing a scroll bar reaches.

    The keyboard may be with nobody: `KeepsFocus` takes it from a control that goes away and gives
    it to no other, lest the space bar presses what the operator never chose. It must not be lost:
    Tab goes on from there. A window that opens has it, see `Walk.step`; the stop's key needs none.
    """
    found = []
    for window in shown_windows():
        for widget in window.findChildren(QWidget):
            if widget.isVisible() and widget.window() is window:
                found += [f"{_path(widget)}: {each}" for each in _faults_of(widget, window)]
        stops = [each for each in window.findChildren(StopButton) if each.window() is window]
        pressable = [each for each in stops if each.isVisible() and each.isEnabled()]
        inside = [each for each in pressable if not _beyond(each, window)]
        if isinstance(window, QDialog) and not stops:
            found.append(f"{_path(window)}: no stop")
        elif not inside and stops:
            found.append(f"{_path(window)}: stop out of reach")
    active = QApplication.activeWindow()
    if active is not None and QApplication.focusWidget() is None:
        QTest.keyClick(active, Qt.Key.Key_Tab)
        if QApplication.focusWidget() is None:
            found.append(f"{_path(active)}: no focus, and Tab leads nowhere")
    return found


def _faults_of(widget: QWidget, window: QWidget) -> list[str]:
    found = []
    if isinstance(widget, CONTROLS) and widget.objectName() != "qt_toolbar_ext_button":
        beyond = _beyond(widget, window)
        if beyond:
            found.append(f"outside by {beyond} px")
    text = _cut(widget)
    if text:
        found.append(text)
    return found


def _beyond(widget: QWidget, window: QWidget) -> int:
    """By how much a widget lies outside what can be seen; a scroll area can be scrolled."""
    rect = QRect(widget.mapTo(window, QPoint(0, 0)), widget.size())
    parent = widget.parentWidget()
    within = window.rect()
    while parent is not None and parent is not window:
        area = parent.parentWidget()
        if isinstance(area, QAbstractScrollArea) and area.viewport() is parent:
            if not isinstance(area, QScrollArea):
                return 0
            place = QRect(parent.mapTo(window, QPoint(0, 0)), parent.size())
            policy = Qt.ScrollBarPolicy.ScrollBarAlwaysOff
            across = area.horizontalScrollBarPolicy() != policy
            down = area.verticalScrollBarPolicy() != policy
            over = 0 if across else max(place.left() - rect.left(), rect.right() - place.right())
            below = 0 if down else max(place.top() - rect.top(), rect.bottom() - place.bottom())
            worst = max(over, below)
            if worst > _SLACK_PX:
                return worst
            rect, widget = place, area
        parent = parent.parentWidget()
    over = max(
        within.left() - rect.left(), rect.right() - within.right(),
        within.top() - rect.top(), rect.bottom() - within.bottom(),
    )  # fmt: skip
    return over if over > _SLACK_PX else 0


def _cut(widget: QWidget) -> str:
    """What of a widget's text is not seen, and no tooltip tells."""
    if isinstance(widget, ElidedLabel) or (
        widget.toolTip() and not isinstance(widget, QPushButton)
    ):
        return ""
    if isinstance(widget, QLabel):
        if not widget.text() or widget.wordWrap() or "<" in widget.text():
            wraps = bool(widget.text()) and widget.wordWrap()
            needed = widget.heightForWidth(widget.width()) if wraps else 0
            low = needed - widget.height()
            return f"{low} px of {widget.text()[:30]!r} cut below" if low > _SLACK_PX else ""
        short = widget.sizeHint().width() - widget.width()
        return f"{short} px of {widget.text()[:30]!r} cut" if short > _SLACK_PX else ""
    if isinstance(widget, QPushButton | QToolButton) and widget.text():
        needed = widget.fontMetrics().horizontalAdvance(widget.text().replace("&", ""))
        only_icon = isinstance(widget, QToolButton) and (
            widget.toolButtonStyle() is Qt.ToolButtonStyle.ToolButtonIconOnly
            and not widget.icon().isNull()
        )
        short = needed - widget.width()
        short = max(short, widget.fontMetrics().height() - widget.height())
        return f"{short} px of {widget.text()!r} cut" if short > 0 and not only_icon else ""
    if isinstance(widget, QComboBox) and widget.currentText():
        needed = widget.fontMetrics().horizontalAdvance(widget.currentText())
        short = needed - widget.width()
        return f"{short} px of {widget.currentText()!r} cut" if short > 0 else ""
    return ""


def _path(widget: QWidget | None) -> str:
    names = []
    while widget is not None:
        names.append(widget.objectName() or type(widget).__name__)
        widget = None if widget.isWindow() else widget.parentWidget()
    return " < ".join(names[:4])


def short_lists(widget: QWidget) -> list[str]:
    """The drop-down lists of a window that show less than their rows although there is room."""
    found = []
    for box in widget.findChildren(QComboBox):
        if not box.isVisible() or box.window() is not widget or not box.isEnabled():
            continue
        box.showPopup()
        QCoreApplication.processEvents()
        view: QAbstractItemView = box.view()
        rows = min(box.count(), box.maxVisibleItems())
        last = view.visualRect(box.model().index(rows - 1, box.modelColumn(), box.rootModelIndex()))
        if view.isVisible() and last.bottom() > view.viewport().rect().bottom():
            found.append(f"{_path(box)}: list of {box.count()} is cut")
        box.hidePopup()
    return found


def main() -> int:
    """Walk, and tell what was found; returns 1 if anything was."""
    parser = argparse.ArgumentParser(prog="python -m tests.window_walk", description=__doc__)
    parser.add_argument("--steps", type=int, default=3000)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    app = QApplication(sys.argv[:1])
    counted: Counter[str] = Counter()
    first: dict[str, str] = {}
    began_s = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        walk = Walk(app, Path(folder), asked.seed)
        for number in range(asked.steps):
            for each in walk.step():
                counted[each] += 1
                where = f"step {number}: {', '.join(walk.names[-6:])}"
                if first.setdefault(each, where) is where:
                    size = walk.driver.window.size().toTuple()
                    language = walk.driver.store.settings.language
                    print(f"{each} [{size} {language}]\n    {where}", flush=True)
            if number % 100 == 99:
                print(f"{number + 1} steps, {time.monotonic() - began_s:.0f} s", flush=True)
        walk.close()
    print(f"{asked.steps} steps, {len(counted)} findings, {time.monotonic() - began_s:.0f} s")
    return 1 if counted else 0


if __name__ == "__main__":
    raise SystemExit(main())
