"""What takes long at the start waits until the window has been painted."""

from __future__ import annotations

from unittest.mock import Mock

from PySide6.QtWidgets import QWidget

from armui import app
from armui.app import AfterFirstPaint
from armui.simulated_arms import SIMULATED


class Painted(QWidget):
    """Notes that it is painted."""

    def __init__(self, done):
        super().__init__()
        self.done = done

    def paintEvent(self, event):
        self.done.append("painted")


def test_it_begins_once_the_window_is_painted(qtbot):
    done: list[str] = []
    window = Painted(done)
    qtbot.addWidget(window)
    window.show()
    AfterFirstPaint(window, lambda: done.append("begun"))
    assert done == []
    qtbot.waitUntil(lambda: "begun" in done)
    window.repaint()
    qtbot.waitUntil(lambda: done.count("painted") > 1)
    assert done[:2] == ["painted", "begun"]
    assert done.count("begun") == 1


def test_a_window_that_nobody_sees_is_not_waited_for_long(qtbot, monkeypatch):
    monkeypatch.setattr(app, "_PAINTED_MS", 20)
    done: list[str] = []
    window = Painted(done)
    qtbot.addWidget(window)
    AfterFirstPaint(window, lambda: done.append("begun"))
    qtbot.waitUntil(lambda: done == ["begun"])


def test_the_window_is_shown_with_its_device_expected(qtbot, monkeypatch):
    happened = []
    program = Mock()
    program.controller.expect_device.side_effect = lambda: happened.append("expected")
    program.window.show.side_effect = lambda: happened.append("shown")
    for part in ("AfterFirstPaint", "_GoingFirst", "QTimer"):
        monkeypatch.setattr(app, part, Mock())
    app._run_window(Mock(), program, Mock(), SIMULATED[0], Mock())
    assert happened == ["expected", "shown"]
    app._run_window(Mock(), program, Mock(), None, Mock())
    assert happened == ["expected", "shown", "shown"]
