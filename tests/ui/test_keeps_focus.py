"""Who loses the keyboard because it was switched off hands it to nobody: not to the stop."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QDialog,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.keeps_focus import KeepsFocus
from armui.ui.widgets.press_button import PressButton
from tests.ui.fake_controller import FakeController


class Window(KeepsFocus, QWidget):
    def __init__(self):
        super().__init__()
        halt = HaltButton(FakeController().as_real)
        self.buttons = [QPushButton("enable"), halt, QPushButton("jog")]


@pytest.fixture
def window(qtbot):
    window = Window()
    layout = QVBoxLayout(window)
    for button in window.buttons:
        layout.addWidget(button)
    qtbot.addWidget(window)
    window.show()
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    window.buttons[0].setFocus()
    assert window.buttons[0].hasFocus()
    return window


@pytest.mark.parametrize("leave", [lambda b: b.setEnabled(False), lambda b: b.hide()])
def test_the_next_button_does_not_get_the_keyboard(window, leave):
    pressed = []
    for button in window.buttons:
        button.pressed.connect(lambda button=button: pressed.append(button))
    leave(window.buttons[0])
    assert not any(button.hasFocus() for button in window.buttons)
    QTest.keyClick(window, Qt.Key.Key_Space)
    assert pressed == []


def test_nor_does_the_first_one_once_a_question_has_gone(window, qtbot):
    """It was switched off by what was agreed to; then its window is the active one again."""
    question = QDialog(window)
    qtbot.addWidget(question)
    question.show()
    question.activateWindow()
    qtbot.waitUntil(question.isActiveWindow)
    window.buttons[0].setEnabled(False)
    window.buttons[0].setEnabled(True)
    question.close()
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    assert not any(button.hasFocus() for button in window.buttons)


@pytest.mark.parametrize(
    ("key", "place"), [(Qt.Key.Key_Tab, 1), (Qt.Key.Key_Backtab, 2)], ids=["on", "back"]
)
def test_tab_goes_on_from_where_it_was(window, key, place):
    window.buttons[0].setEnabled(False)
    QTest.keyClick(window, key)
    assert window.buttons[place].hasFocus()


def test_tab_goes_on_as_ever(window):
    QTest.keyClick(window.buttons[0], Qt.Key.Key_Tab)
    assert window.buttons[1].hasFocus()
    QTest.keyClick(window.buttons[1], Qt.Key.Key_Tab)
    assert window.buttons[2].hasFocus()


def test_in_the_program_a_stop_gives_the_stop_no_keyboard(app_driver):
    app_driver.connect()
    enable = app_driver.find("enable_button")
    enable.setFocus()
    app_driver.controller.emergency_stop()
    app_driver.run_until(lambda: not enable.isEnabled())
    for name in ("stop_button", "halt_button", "jog_plus_1"):
        assert not app_driver.find(name).hasFocus()
    assert app_driver.window.focusWidget() in {None, app_driver.window}


def test_a_dialog_that_opens_gives_halt_and_stop_no_keyboard(app_driver):
    for key in ("connect", "settings", "backup"):
        app_driver.window.pages.show(key)
        dialog = app_driver.dialog(QDialog)
        dialog.activateWindow()
        app_driver.wait(dialog.isActiveWindow)
        assert not isinstance(dialog.focusWidget(), PressButton), key
        dialog.close()


def test_a_panel_that_comes_gives_its_first_control_no_keyboard(app_driver):
    """Qt's stack does, and the frame around 空载 looked like a choice beside the one made."""
    app_driver.connect()
    app_driver.find("target_field_1").setFocus()
    app_driver.click("menu_end_load")
    focused = QApplication.focusWidget()
    assert focused is not None
    assert not isinstance(focused, QAbstractButton), focused
    QTest.keyClick(focused, Qt.Key.Key_Tab)
    assert app_driver.find("load_empty").hasFocus()
