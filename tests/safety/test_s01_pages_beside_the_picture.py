"""S1: whatever page is in front, in the main window or taken out, the first press stops.

A page that opens while the arm is jogged ends the jog, or leaves the release to the button: none
goes on after the finger is up.
"""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from armui.ui.shell.pages import PAGES
from armui.ui.shell.workspace import PageWindow
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.page import Page
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.stop_shortcut import HALT_KEY
from tests.control.jogger import bend, hold
from tests.operator.test_jogging import angles, choose_continuous

pytestmark = pytest.mark.styled

LEFT = Qt.MouseButton.LeftButton
KEYS = (Qt.Key.Key_F12, Qt.Key.Key_Pause, HALT_KEY)
DRAWER = ("plots", "events", "bus", "sessions", "joint_status", "guide")
LARGE_PX = 40


def open_page(app_driver, key):
    """Open a page of the drawer by its tab."""
    app_driver.click("events_button")
    app_driver.click(f"drawer_{key}")
    return app_driver.find("drawer").current


def take_out(app_driver):
    app_driver.click("drawer_take_out")
    return app_driver.dialog(PageWindow)


@pytest.fixture
def presses(app_driver, monkeypatch):
    """How often the arm was stopped and halted, as (stops, halts)."""
    app_driver.connect_by_hand()
    counts = {"emergency_stop": 0, "halt_and_hold": 0}

    def counted(name):
        act = getattr(app_driver.controller, name)

        def count():
            counts[name] += 1
            return act()

        return count

    for name in counts:
        monkeypatch.setattr(app_driver.controller, name, counted(name))
    return lambda: tuple(counts.values())


@pytest.mark.parametrize("key", DRAWER)
def test_with_the_keys_in_a_page_of_the_drawer(app_driver, presses, key):
    app_driver.window.activateWindow()
    app_driver.wait(app_driver.window.isActiveWindow)
    page = open_page(app_driver, key)
    assert page.window() is app_driver.window
    focus = QApplication.focusWidget()
    assert focus is not None
    assert page.isAncestorOf(focus) or focus is page
    for each in KEYS:
        QTest.keyPress(focus, each)
    assert presses() == (2, 1)
    app_driver.press(app_driver.find("halt_button"))
    assert presses() == (2, 2)


@pytest.mark.parametrize("key", DRAWER)
def test_a_page_that_was_taken_out_has_its_own_stops(app_driver, presses, key):
    page = open_page(app_driver, key)
    window = take_out(app_driver)
    assert page.window() is window
    QTest.mousePress(window.findChild(StopButton), LEFT)
    assert presses() == (1, 0)
    QTest.mousePress(window.findChild(HaltButton), LEFT)
    assert presses() == (1, 1)
    for each in KEYS:
        QTest.keyPress(window.focusWidget() or window, each)
    assert presses() == (3, 2)


def test_the_only_large_stop_is_the_main_window_s(app_driver):
    """Whatever is open, each other window has a slim one, wholly in sight."""
    for key in DRAWER:
        open_page(app_driver, key)
        app_driver.click("drawer_take_out")
    app_driver.window.pages.show("settings")
    app_driver.window.pages.show("connect")
    app_driver.window.window_actions.open_shortcuts()
    windows = [each for each in QApplication.topLevelWidgets() if each.isVisible()]
    assert len(windows) == 1 + len(DRAWER) + 3
    for window in windows:
        stops = [each for each in window.findChildren(StopButton) if each.window() is window]
        assert len(stops) == 1
        place = stops[0].geometry().translated(stops[0].parentWidget().mapTo(window, window.pos()))
        assert stops[0].visibleRegion().boundingRect() == stops[0].rect(), place
        assert (stops[0].height() > LARGE_PX) is (window is app_driver.window)


def test_every_page_that_can_be_taken_out_is_tried_here():
    assert {*DRAWER, "library", "editor", "recording"} == {
        key for key, page in PAGES.items() if page.movable
    }


# A held jog ---------------------------------------------------------------------------------------


@pytest.fixture
def arm_repeats():
    return True  # it is looked at between two steps


@pytest.fixture
def ready(app_driver):
    """Bent, continuous jogging chosen, the window in front."""
    app_driver.window.activateWindow()
    bend(app_driver)
    choose_continuous(app_driver)
    app_driver.heard()
    return app_driver


def press_jog(app_driver):
    """Hold the button that jogs joint 1, by way of the window; return where the pointer is."""
    button = app_driver.find("jog_plus_1")
    button.setFocus()
    where = button.mapTo(button.window(), button.rect().center())
    QTest.mousePress(app_driver.window.windowHandle(), LEFT, pos=where)
    hold(app_driver, 0.3)
    assert app_driver.controller.jogging.active
    return where


def press_keys(app_driver):
    """Hold the keys that jog joint 1."""
    app_driver.click("jog_keys_button")
    pad = app_driver.find("jog_key_pad")
    pad.setFocus()
    QTest.keyPress(pad, Qt.Key.Key_Space)
    QTest.keyPress(pad, Qt.Key.Key_Q)
    hold(app_driver, 0.3)
    assert app_driver.controller.jogging.active
    return


def rests(app_driver):
    app_driver.run(0.3)
    before = angles(app_driver)
    app_driver.run(1.0)
    return not app_driver.controller.jogging.active and angles(app_driver) == before


def let_go(app_driver, where):
    """Lift the finger: the window gets the release where the pointer is, keys go to the focus."""
    if where is not None:
        QTest.mouseRelease(app_driver.window.windowHandle(), LEFT, pos=where)
    else:
        focus = QApplication.focusWidget() or app_driver.window
        QTest.keyRelease(focus, Qt.Key.Key_Q)
        QTest.keyRelease(focus, Qt.Key.Key_Space)


def by_f1(app_driver):
    QTest.keyClick(app_driver.window.focusWidget(), Qt.Key.Key_F1)


def joint_status(app_driver):
    app_driver.window.pages.show("joint_status")


def sessions(app_driver):
    app_driver.window.pages.show("sessions")


def in_a_window(app_driver):
    """A page in the drawer is taken out while the finger is down."""
    app_driver.window.page_actions._take_out("joint_status")


@pytest.mark.each_value(full="each page, held by mouse and keys")
@pytest.mark.parametrize("opens", [by_f1, joint_status, sessions, in_a_window])
@pytest.mark.parametrize("hold_it", [press_jog, press_keys])
def test_a_page_that_opens_during_a_held_jog_keeps_no_release(ready, hold_it, opens):
    where = hold_it(ready)
    opens(ready)
    hold(ready, 0.3)
    assert [each for each in ready.window.findChildren(Page) if each.isVisible()]
    let_go(ready, where)
    assert rests(ready)


def test_the_next_press_jogs_as_ever_with_the_page_in_sight(ready):
    where = press_jog(ready)
    by_f1(ready)
    let_go(ready, where)
    assert rests(ready)
    assert ready.find("drawer").current.key == "guide"
    assert ready.find("drawer").isVisible()
    before = angles(ready)
    where = press_jog(ready)
    let_go(ready, where)
    assert angles(ready) != before
    assert rests(ready)


@pytest.mark.parametrize("key", ["joint_status", "guide"])
def test_a_page_that_was_taken_out_comes_to_the_front_during_a_held_jog(ready, key):
    open_page(ready, key)
    window = take_out(ready)
    ready.window.activateWindow()
    ready.wait(ready.window.isActiveWindow)
    where = press_jog(ready)
    window.activateWindow()
    ready.wait(window.isActiveWindow)
    hold(ready, 0.2)
    assert not ready.controller.jogging.active
    let_go(ready, where)
    assert rests(ready)


def test_the_stop_of_a_page_that_was_taken_out_ends_a_held_jog(ready):
    open_page(ready, "joint_status")
    window = take_out(ready)
    ready.window.activateWindow()
    ready.wait(ready.window.isActiveWindow)
    press_jog(ready)
    QTest.mousePress(window.findChild(HaltButton), LEFT)
    assert not ready.controller.jogging.active
    assert rests(ready)
