"""S19: a hold that nobody attends ends by itself.

When the connection of a remote desktop drops, some servers leave the button and the keys of the
far side pressed: the program hears of no release, and would jog on to the joint's limit.
"""

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from armui.ui.widgets.hold_guard import UNATTENDED_S, HoldGuard
from tests.control.jogger import bend, hold
from tests.operator.test_jogging import angles, choose_continuous

LEFT = Qt.MouseButton.LeftButton
QUICK_MS = 60


@pytest.fixture
def ready(app_driver):
    app_driver.window.activateWindow()
    bend(app_driver)
    choose_continuous(app_driver)
    app_driver.heard()
    return app_driver


def guard_of(widget) -> HoldGuard:
    guard = widget.findChild(HoldGuard)
    assert isinstance(guard, HoldGuard)
    assert guard._patience.interval() == 1000 * UNATTENDED_S
    return guard


def over(app_driver, guard):
    """As if nothing had moved all the time."""
    assert guard._patience.isActive()
    guard._patience.start(QUICK_MS)
    app_driver.wait(lambda: not guard._patience.isActive())


def is_said(app_driver) -> bool:
    return "without a movement of the mouse" in app_driver.read("motion_message")


def test_a_button_that_stays_down_and_nothing_else(ready):
    button = ready.find("jog_plus_1")
    guard = guard_of(button)
    button.setFocus()
    ready.press(button)
    hold(ready, 0.3)
    assert ready.controller.jogging.active
    over(ready, guard)
    assert not ready.controller.jogging.active
    assert is_said(ready)
    ready.run(0.3)
    before = angles(ready)
    ready.run(1.0)
    assert angles(ready) == before


def test_keys_that_stay_down(ready):
    ready.click("jog_keys_button")
    pad = ready.find("jog_key_pad")
    guard = guard_of(pad)
    pad.setFocus()
    QTest.keyPress(pad, Qt.Key.Key_Space)
    QTest.keyPress(pad, Qt.Key.Key_Q)
    hold(ready, 0.2)
    assert ready.controller.jogging.active
    # the server repeats keys by itself: that is no sign of an operator
    again = QKeyEvent(
        QEvent.Type.KeyPress, Qt.Key.Key_Q, Qt.KeyboardModifier.NoModifier, "q", autorep=True
    )
    left_ms = guard._patience.remainingTime()
    QApplication.sendEvent(pad, again)
    assert guard._patience.remainingTime() <= left_ms
    over(ready, guard)
    assert not ready.controller.jogging.active
    assert is_said(ready)


def test_steps_that_repeat_end_as_well(ready):
    box = ready.find("jog_step")
    box.setCurrentIndex(0)
    button = ready.find("jog_plus_1")
    guard = guard_of(button)
    ready.press(button)
    assert button._timer.isActive()
    over(ready, guard)
    assert not button._timer.isActive()


def test_a_movement_of_the_pointer_is_a_sign_of_the_operator(ready):
    button = ready.find("jog_plus_1")
    guard = guard_of(button)
    button.setFocus()
    ready.press(button)
    guard._patience.setInterval(60_000)  # as if most of it were over
    place = QPointF(button.rect().center())
    where = QPointF(button.mapToGlobal(place))
    kind, none = QEvent.Type.MouseMove, Qt.KeyboardModifier.NoModifier
    before_ms = guard._patience.remainingTime()
    guard._patience.setInterval(90_000)
    QApplication.sendEvent(button, QMouseEvent(kind, place, where, LEFT, LEFT, none))
    assert guard._patience.remainingTime() > before_ms
    hold(ready, 0.1)
    assert ready.controller.jogging.active
    QTest.mouseRelease(button, LEFT, pos=button.rect().center())
    assert not guard._patience.isActive()
