"""From the library to a run of three points made by jogging, and the presses counted.

``python -m tests.operator.test_three_points`` says how many there are.
"""

import os
import sys
import tempfile
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget

from armui.control.run.progress import RunPhase
from armui.protocol.generation import Generation
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from tests.app_driver import AppDriver

PRESSES = 9
"""Create; Enter for the name that stands there; three times a jog button and Insert; Send.

Enter moves no hand to the mouse and back, and names the trajectory for good. Before there were
pages the same eight buttons were pressed, but the windows of library and editor lay over the jog
buttons on a screen of 1440×900: both had to be dragged aside, and the editor's, 1224 pixels wide,
made narrower, before the first point. Eleven."""


class CountedHand:
    """Presses what is seen and can be pressed, as an operator does, and keeps count.

    Attributes:
        pressed: The names of what was pressed.
    """

    def __init__(self, app_driver):
        self.driver = app_driver
        self.pressed = []

    def enter(self):
        """Press Enter where the keys go: nothing is typed, and no field is clicked."""
        QTest.keyClick(self.driver.window.focusWidget(), Qt.Key.Key_Return)
        self.pressed.append("Enter")

    def press(self, name):
        shown = [
            each for each in self.driver.window.findChildren(QWidget, name) if each.isVisible()
        ]
        assert len(shown) == 1, f"{name}: {shown}"
        (button,) = shown
        assert button.isEnabled(), f"{name}: {button.toolTip()}"
        middle = button.mapTo(button.window(), button.rect().center())
        assert button.window().rect().contains(middle), f"{name} is cut off"
        assert button.window().childAt(middle) is button, f"{name} is covered"
        self.pressed.append(name)
        self.driver.click(button)
        self.driver.run(0.7)


def make_and_run(app_driver):
    """Make three points with the arm, and run them; the hand that did it."""
    app_driver.ready()
    app_driver.click("library_button")
    app_driver.page(LibraryPage)
    hand = CountedHand(app_driver)
    hand.press("library_create")
    hand.enter()
    for joint in (1, 2, 3):
        hand.press(f"box_minus_{joint}" if joint == 3 else f"box_plus_{joint}")
        hand.press("box_insert")
    hand.press("run_send")
    return hand


def test_nine_presses_make_and_run_three_points(app_driver):
    hand = make_and_run(app_driver)
    assert len(hand.pressed) == PRESSES
    targets = [point.target for point in app_driver.page(EditorPage).document.points]
    goals = [(1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (1.0, 1.0, -1.0)]
    for target, goal in zip(targets, goals, strict=True):
        assert target[:3] == pytest.approx(goal, abs=0.02)
    progress = app_driver.controller.player.progress
    app_driver.run_until(lambda: app_driver.controller.player.progress.phase is RunPhase.DONE)
    assert progress.count == len(goals)
    assert app_driver.firmware.joints_deg[:3] == pytest.approx(goals[-1], abs=0.05)


def test_the_key_of_send_counts_wherever_in_the_page(app_driver):
    make_and_run(app_driver)
    player = app_driver.controller.player
    app_driver.run_until(lambda: player.progress.phase is RunPhase.DONE)
    app_driver.window.activateWindow()
    app_driver.wait(app_driver.window.isActiveWindow)
    jog = app_driver.find("box_plus_1")
    jog.setFocus()
    QTest.keyClick(jog, Qt.Key.Key_F5)
    assert player.progress.phase is not RunPhase.DONE
    app_driver.run_until(lambda: player.progress.phase is RunPhase.DONE)
    app_driver.click("menu_motion")
    QTest.keyClick(app_driver.find("jog_plus_1"), Qt.Key.Key_F5)
    assert player.progress.phase is RunPhase.DONE, "no page is seen"


def main():
    app = QApplication(sys.argv[:1])
    with tempfile.TemporaryDirectory() as folder:
        app_driver = AppDriver(app, "count", Path(folder) / "settings.json", Generation.TWO)
        pressed = make_and_run(app_driver).pressed
        app_driver.close()
    print(f"{len(pressed)} presses from the library to a run of three points: {', '.join(pressed)}")


if __name__ == "__main__":
    main()
