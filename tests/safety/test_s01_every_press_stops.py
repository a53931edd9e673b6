"""S1: the first press stops, on the press, whatever is open; without a display.

Presses are given to the window system's queue of the window that holds the mouse, as the system
does it, not to the widget: with a popup open, that is the popup's.
"""

import importlib.util
import sys

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QLineEdit, QMenu, QToolTip

from armui.ui.actions.palette import CommandPalette
from armui.ui.dialogs.confirm_dialog import confirm
from armui.ui.dialogs.files import choose_file
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.watch.bus.bus_page import BusPage
from armui.ui.watch.plots_area import PlotPage
from armui.ui.widgets import stop_shortcut
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.stop_shortcut import HALT_CHORD, HALT_KEY, STOP_CHORD

pytestmark = pytest.mark.styled

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def presses(app_driver):
    """How often the arm was stopped and halted, as (stops, halts)."""
    app_driver.connect_by_hand()
    counts = {"stop": 0, "halt": 0}
    stop, halt = app_driver.controller.emergency_stop, app_driver.controller.halt_and_hold

    def count(name, act):
        def counted():
            counts[name] += 1
            return act()

        return counted

    app_driver.controller.emergency_stop = count("stop", stop)
    app_driver.controller.halt_and_hold = count("halt", halt)
    return lambda: (counts["stop"], counts["halt"])


def with_the_mouse(button):
    """The window that holds the mouse: the caller keeps it, its handle does not."""
    return QApplication.activePopupWidget() or button.window()


def press(button):
    """Press over a button, by way of the window that holds the mouse; do not let go."""
    window = with_the_mouse(button)
    handle = window.windowHandle()
    where = button.mapToGlobal(button.rect().center())
    QTest.mousePress(handle, LEFT, pos=handle.mapFromGlobal(where))


def let_go(button):
    window = with_the_mouse(button)
    handle = window.windowHandle()
    where = button.mapToGlobal(button.rect().center())
    QTest.mouseRelease(handle, LEFT, pos=handle.mapFromGlobal(where))


def away_from(button) -> QPoint:
    """A place on the screen where a popup does not cover the button."""
    return button.window().mapToGlobal(QPoint(40, button.window().height() // 2))


def combo_box(app_driver, _button):
    app_driver.window.pages.show("settings")
    dialog = app_driver.dialog(SettingsDialog)
    dialog.move(app_driver.window.mapToGlobal(QPoint(100, 200)))
    box = dialog.findChild(QComboBox)
    box.showPopup()
    assert QApplication.activePopupWidget() is not None


def menu(app_driver, button):
    opened = QMenu(app_driver.window)
    opened.addAction("one")
    opened.popup(away_from(button))
    assert QApplication.activePopupWidget() is opened


def menu_with_a_submenu(app_driver, button):
    opened = QMenu(app_driver.window)
    inner = opened.addMenu("more")
    inner.addAction("two")
    opened.popup(away_from(button))
    inner.popup(away_from(button) + QPoint(80, 0))
    assert QApplication.activePopupWidget() is inner


def context_menu(app_driver, button):
    field = QLineEdit(app_driver.window)
    opened = field.createStandardContextMenu()
    opened.popup(away_from(button))
    assert QApplication.activePopupWidget() is opened


def tool_tip(app_driver, button):
    QToolTip.showText(away_from(button), "a tip", app_driver.window)


def file_dialog(app_driver, _button):
    dialog = choose_file(
        app_driver.window,
        app_driver.controller,
        title="t",
        name_filter="* (*)",
        on_chosen=lambda _path: None,
    )
    box = dialog.findChild(QComboBox, "fileTypeCombo") or dialog.findChild(QComboBox)
    box.showPopup()


def question_being_held(app_driver, _button):
    dialog = confirm(
        app_driver.window,
        app_driver.controller,
        title="t",
        text="t",
        action_label="a",
        on_confirmed=lambda: None,
        hold=True,
    )
    app_driver.press(dialog.action_button)


def field_being_edited(app_driver, _button):
    field = app_driver.window.findChild(QLineEdit)
    field.setFocus()
    QTest.keyClicks(field, "12")


def list_of_the_curves(app_driver, button):
    app_driver.window.show_as_curves(())
    window = app_driver.taken_out(PlotPage)
    window.window().move(button.mapToGlobal(QPoint(-900, 300)))
    app_driver.wait(lambda: window.board.built)
    window.bar.sets.showPopup()
    assert QApplication.activePopupWidget() is not None


def list_of_the_bus_monitor(app_driver, button):
    app_driver.click("bus_button")
    window = app_driver.taken_out(BusPage)
    window.window().move(button.mapToGlobal(QPoint(-900, 300)))
    app_driver.hold_button(window.send_box.unlock)
    window.filter_bar.senders.showPopup()
    assert QApplication.activePopupWidget() is not None


def menu_of_a_figure(app_driver, _button):
    figure = app_driver.find("measured_2")
    middle = figure.rect().center()
    event = QContextMenuEvent(
        QContextMenuEvent.Reason.Mouse, middle, figure.mapToGlobal(middle)
    )  # fmt: skip
    QApplication.sendEvent(figure, event)
    assert isinstance(QApplication.activePopupWidget(), QMenu)


def command_palette(app_driver, _button):
    app_driver.window.activateWindow()  # off the screen nobody does when a dialog closes
    app_driver.wait(app_driver.window.isActiveWindow)
    QTest.keyClick(app_driver.window, Qt.Key.Key_K, Qt.KeyboardModifier.ControlModifier)
    palette = app_driver.dialog(CommandPalette)
    QTest.keyClicks(palette.search, "home")


OPEN = [
    command_palette,
    list_of_the_bus_monitor,
    list_of_the_curves,
    menu_of_a_figure,
    combo_box,
    menu,
    menu_with_a_submenu,
    context_menu,
    tool_tip,
    file_dialog,
    question_being_held,
    field_being_edited,
]


@pytest.fixture(autouse=True)
def no_popup_is_left():
    yield
    while (popup := QApplication.activePopupWidget()) is not None:
        popup.close()
    QToolTip.hideText()


@pytest.mark.parametrize("open_it", OPEN, ids=lambda each: each.__name__)
def test_the_first_press_stops_on_the_press(app_driver, presses, open_it):
    button = app_driver.find("stop_button")
    open_it(app_driver, button)
    press(button)
    assert presses() == (1, 0)
    assert QApplication.activePopupWidget() is None
    let_go(button)
    assert presses() == (1, 0)


@pytest.mark.parametrize("open_it", [combo_box, menu, file_dialog], ids=lambda each: each.__name__)
def test_the_first_press_halts(app_driver, presses, open_it):
    button = app_driver.find("halt_button")
    open_it(app_driver, button)
    press(button)
    assert presses() == (0, 1)
    let_go(button)
    assert presses() == (0, 1)


@pytest.mark.parametrize("open_it", [combo_box, file_dialog], ids=lambda each: each.__name__)
def test_the_buttons_of_the_dialog_itself_work_with_its_list_open(app_driver, presses, open_it):
    open_it(app_driver, None)
    dialog = QApplication.activePopupWidget().parentWidget().window()
    press(dialog.findChild(StopButton))
    assert presses() == (1, 0)


def test_a_press_on_the_popup_is_the_popups(app_driver, presses):
    button = app_driver.find("stop_button")
    chosen = []
    opened = QMenu(app_driver.window)
    action = opened.addAction("x" * 60)
    action.triggered.connect(lambda: chosen.append(1))
    opened.popup(button.mapToGlobal(QPoint(0, 0)))  # it covers the button
    handle = opened.windowHandle()
    middle = opened.actionGeometry(action).center()
    QTest.mouseMove(handle, middle)
    QTest.mouseClick(handle, LEFT, pos=middle)
    assert presses() == (0, 0)
    assert chosen == [1]


def test_a_press_beside_the_button_only_closes_the_popup(app_driver, presses):
    button = app_driver.find("stop_button")
    menu(app_driver, button)
    window = with_the_mouse(button)
    handle = window.windowHandle()
    where = button.mapToGlobal(QPoint(-button.window().width() // 3, 120))
    QTest.mouseClick(handle, LEFT, pos=handle.mapFromGlobal(where))
    assert presses() == (0, 0)
    assert QApplication.activePopupWidget() is None


@pytest.mark.each_value(full="each key over each thing that is open")
@pytest.mark.parametrize("key", [Qt.Key.Key_F12, Qt.Key.Key_Pause, HALT_KEY])
@pytest.mark.parametrize("open_it", OPEN, ids=lambda each: each.__name__)
def test_the_keys_act_at_the_first_press(app_driver, presses, open_it, key):
    open_it(app_driver, app_driver.find("stop_button"))
    QTest.keyPress(app_driver.window.windowHandle(), key)
    assert presses() == ((0, 1) if key == HALT_KEY else (1, 0))


@pytest.mark.parametrize(
    ("chord", "expected"), [(STOP_CHORD, (1, 0)), (HALT_CHORD, (0, 1))], ids=["stop", "halt"]
)
@pytest.mark.parametrize("on_macos", [True, False])
def test_the_second_keys_of_macos_act_there_alone(
    app_driver, presses, monkeypatch, chord, expected, on_macos
):
    monkeypatch.setattr(stop_shortcut, "_HAS_CHORDS", on_macos)
    command_palette(app_driver, None)
    search = app_driver.dialog(CommandPalette).search
    QTest.keyPress(search, chord.key())
    assert presses() == (0, 0)
    QTest.keyPress(search, chord.key(), chord.keyboardModifiers())
    assert presses() == (expected if on_macos else (0, 0))


def test_the_second_keys_of_macos_stand_on_the_buttons(monkeypatch):
    with monkeypatch.context() as macos:
        macos.setattr(sys, "platform", "darwin")
        there = importlib.util.module_from_spec(stop_shortcut.__spec__)
        stop_shortcut.__loader__.exec_module(there)
    assert (there.STOP_KEY_NAME, there.HALT_KEY_NAME) == ("F12, ⌘.", "F9, ⌘⌫")


@pytest.mark.parametrize("key", [Qt.Key.Key_F12, Qt.Key.Key_Pause, HALT_KEY])
def test_the_palette_swallows_no_stop(app_driver, presses, key):
    """The keys reach the arm while its search is typed into, and both buttons stand on it."""
    command_palette(app_driver, None)
    palette = app_driver.dialog(CommandPalette)
    expected = (0, 1) if key == HALT_KEY else (1, 0)
    QTest.keyPress(palette.search, key)
    assert presses() == expected
    assert palette.isVisible()
    assert palette.search.text() == "home"
    press(palette.findChild(HaltButton if key == HALT_KEY else StopButton))
    assert presses() == tuple(2 * count for count in expected)


def test_a_press_on_the_main_stop_needs_no_press_to_close_the_palette(app_driver, presses):
    command_palette(app_driver, None)
    palette = app_driver.dialog(CommandPalette)
    button = app_driver.find("stop_button")
    assert not palette.geometry().intersects(
        button.rect().translated(button.mapToGlobal(QPoint(0, 0)))
    )
    press(button)
    assert presses() == (1, 0)


@pytest.mark.parametrize(("words", "expected"), [("急停", (1, 0)), ("tz", (0, 1))])
def test_the_palette_stops_and_halts_too(app_driver, presses, words, expected):
    app_driver.store.change(language="zh")
    command_palette(app_driver, None)
    palette = app_driver.dialog(CommandPalette)
    app_driver.wait(lambda: palette._names.known)
    palette.search.setText(words)
    QTest.keyClick(palette.search, Qt.Key.Key_Return)
    assert presses() == expected


def test_every_window_with_a_stop_has_its_halt_or_the_key(app_driver):
    app_driver.window.pages.show("settings")
    dialog = app_driver.dialog(SettingsDialog)
    assert dialog.findChild(HaltButton).isVisible()
    assert dialog.findChild(StopButton).isVisible()
