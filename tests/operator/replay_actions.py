"""The window 回放 in the hands of an operator."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from armui.ui.shell import pages
from armui.ui.watch.recordings.sessions_page import SessionsPage
from armui.ui.watch.replay import replay_window
from armui.ui.watch.replay.replay_window import ReplayWindow
from tests.app_driver import AtOnce
from tests.ui.fake_view import FakeView


class StillView(FakeView):
    """A 3D view that draws nothing, and can be ended."""

    def __init__(self, robot: Path | None = None) -> None:
        super().__init__()
        self.robot = robot
        self.is_shut_down = False

    def shutdown(self) -> None:
        self.is_shut_down = True


class Replay:
    """The window, opened from that of the recordings; whoever asks reads the logs, or a helper."""

    def __init__(self, driver: Any, monkeypatch: Any, helper: Any = AtOnce) -> None:
        self.driver = driver
        monkeypatch.setattr(replay_window, "HelperProcess", helper)
        monkeypatch.setattr(pages, "ArmView", StillView)
        driver.click("sessions_button")
        driver.click(driver.page(SessionsPage).other_button)
        self.window = driver.dialog(ReplayWindow)

    @property
    def view(self) -> Any:
        assert self.window.view is not None
        return self.window.view

    @property
    def replay(self) -> Any:
        return self.view.replay

    def open(self, path: Path) -> None:
        self.window.open_log(path)
        self.driver.wait(lambda: self.window.view is not None or self.message())
        if self.window.view is not None:
            self.arrive()

    def arrive(self) -> None:
        """Until the replay is where it was sent."""
        self.driver.wait(lambda: not self.replay.is_travelling)

    def message(self) -> str:
        line = self.window.message
        return line.text() if not line.isHidden() else ""

    def find(self, name: str) -> Any:
        found = self.window.findChild(QWidget, name)
        assert found is not None, name
        return found

    def click(self, name: str) -> None:
        self.driver.click(self.find(name))

    def key(self, key: Qt.Key, modifiers: Any = Qt.KeyboardModifier.NoModifier) -> None:
        QTest.keyClick(self.window, key, modifiers)

    def since_s(self) -> float:
        """How far the replay is from the beginning."""
        return float(self.replay.position_s - self.replay.session.start_s)
