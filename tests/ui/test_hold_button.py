"""A button that wants to be held: what fills its line, and what begins anew."""

from time import monotonic
from typing import Any

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QToolTip, QVBoxLayout, QWidget

from armui.ui.dialogs.confirm_dialog import ConfirmDialog, confirm
from armui.ui.widgets import hold_button
from armui.ui.widgets.hold_button import HOLD_MS, HoldButton

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def button(qtbot, controller):
    window = QWidget()
    qtbot.addWidget(window)
    layout = QVBoxLayout(window)
    button: Any = HoldButton(controller, "Disable")
    button.count = 0
    layout.addWidget(button)
    window.show()
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    button.setFocus()
    button.owner = window  # Python would delete it

    def on_held():
        button.count += 1

    button.held.connect(on_held)
    return button


def wait(button, ms=HOLD_MS):
    button.progress.setCurrentTime(ms)


def test_held_to_the_end_it_acts_once(button):
    QTest.mousePress(button, LEFT)
    wait(button, HOLD_MS - 1)
    assert button.count == 0
    assert button.share == pytest.approx(0.999)
    wait(button)
    assert button.count == 1
    QTest.mouseRelease(button, LEFT)
    assert button.count == 1
    assert button.share == 0


def test_a_release_that_waits_behind_the_time_is_heard_first(button, monkeypatch):
    """As after the window's thread was held up: the time is over before the mouse is asked."""
    QTest.mousePress(button, LEFT)
    late_s = monotonic() + 0.5
    monkeypatch.setattr(hold_button, "monotonic", lambda: late_s)
    here = QPointF(button.rect().center())
    let_go = QMouseEvent(
        *(QEvent.Type.MouseButtonRelease, here, button.mapToGlobal(here)),
        *(LEFT, Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier),
    )
    QCoreApplication.postEvent(button, let_go)
    wait(button)
    QApplication.processEvents()
    assert button.count == 0


def test_time_passes_by_itself(button, qtbot):
    button.progress.setDuration(20)
    QTest.mousePress(button, LEFT)
    qtbot.waitUntil(lambda: button.count == 1)
    QTest.mouseRelease(button, LEFT)


def test_clicks_do_nothing(button):
    QTest.mouseClick(button, LEFT)
    QTest.mouseDClick(button, LEFT)
    button.click()
    QTest.keyClick(button, Qt.Key.Key_Return)
    wait(button)
    assert button.count == 0


def test_it_says_that_it_wants_to_be_held(button):
    hint = "Hold it for 1 s, with the mouse or the space bar."
    assert button.toolTip() == hint
    assert button.accessibleDescription() == hint
    button.setToolTip("It drops.")
    assert button.toolTip() == f"It drops.\n{hint}"
    button.setEnabled(False)
    assert button.toolTip() == "It drops."
    button.setEnabled(True)
    assert button.toolTip() == f"It drops.\n{hint}"


@pytest.mark.parametrize("click", ["mouse", "key", "program"])
def test_a_short_click_says_in_a_line_what_is_wanted(button, click):
    if click == "mouse":
        QTest.mouseClick(button, LEFT)
    elif click == "key":
        QTest.keyClick(button, Qt.Key.Key_Space)
    else:
        button.click()
    assert QToolTip.text() == "Hold it for 1 s, with the mouse or the space bar."


def test_held_to_the_end_it_says_nothing(button):
    QToolTip.hideText()
    QTest.mousePress(button, LEFT)
    wait(button)
    QTest.mouseRelease(button, LEFT)
    assert button.count == 1
    assert not QToolTip.isVisible()


def test_the_space_bar_holds_too(button):
    QTest.keyPress(button, Qt.Key.Key_Space)
    wait(button, HOLD_MS // 2)
    again = QKeyEvent(
        QEvent.Type.KeyPress, Qt.Key.Key_Space, Qt.KeyboardModifier.NoModifier, " ", autorep=True
    )
    button.keyPressEvent(again)
    assert button.share == 0.5
    wait(button)
    assert button.count == 1
    QTest.keyRelease(button, Qt.Key.Key_Space)


@pytest.mark.parametrize(
    "leave",
    [
        lambda button: QTest.mouseRelease(button, LEFT),
        lambda button: QTest.mouseMove(button, QPoint(-40, -40)),
        lambda button: button.setEnabled(False),
        lambda button: button.clearFocus(),
    ],
    ids=["let go", "left", "disabled", "focus lost"],
)
def test_whatever_interrupts_begins_anew(button, leave):
    QTest.mousePress(button, LEFT)
    wait(button, HOLD_MS - 1)
    leave(button)
    assert button.share == 0
    wait(button)
    assert button.count == 0


def test_hidden_it_does_not_act(button):
    QTest.mousePress(button, LEFT)
    button.window().hide()
    wait(button)
    assert button.count == 0


def test_the_line_shows_how_far(button):
    empty = button.grab().toImage()
    QTest.mousePress(button, LEFT)
    wait(button, HOLD_MS // 2)
    half = button.grab().toImage()
    wait(button, HOLD_MS - 1)
    assert button.grab().toImage() != half
    assert half != empty
    QTest.mouseRelease(button, LEFT)


# In a question ------------------------------------------------------------------------------------


@pytest.fixture
def question(qtbot, controller):
    window = QWidget()
    qtbot.addWidget(window)
    window.show()
    said = []
    dialog: Any = confirm(
        window,
        controller,
        title="Sure?",
        text="It drops.",
        action_label="Drop",
        on_confirmed=lambda: said.append("yes"),
        hold=True,
    )
    dialog.said = said
    dialog.owner = window  # Python would delete it
    return dialog


def test_a_question_to_be_held(question, qtbot):
    texts = [label.text() for label in question.findChildren(QWidget) if hasattr(label, "text")]
    assert "Hold the button, or the space bar on it, for one second." in texts
    QTest.mouseDClick(question.action_button, LEFT)
    QTest.keyClick(question, Qt.Key.Key_Return)
    assert question.said == []


def test_held_the_answer_is_yes(question):
    QTest.mousePress(question.action_button, LEFT)
    wait(question.action_button)
    assert question.said == ["yes"]
    assert not question.isVisible()


def test_an_ordinary_question_says_nothing_of_holding(qtbot, controller):
    dialog = ConfirmDialog(controller, title="Sure?", text="Go.", action_label="Go")
    qtbot.addWidget(dialog)
    dialog.show()
    hints = [
        each for each in dialog.findChildren(QWidget) if "Hold" in getattr(each, "text", str)()
    ]
    assert all(not hint.isVisible() for hint in hints)
