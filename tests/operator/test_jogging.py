"""An operator who holds a button or keys down: what the arm does, and when it rests again."""

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QFocusEvent, QKeyEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox

from tests.accepted import accepted
from tests.control.jogger import TICK_S, bend, hold, rest_s
from tests.generations import ONE_IS_ENOUGH

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def arm_repeats():
    return True  # it is looked at between two steps


def angles(app_driver):
    return [round(angle, 3) for angle in app_driver.firmware.joints_deg]


def test_a_held_jog_says_its_speed_and_a_step_its_step(any_driver):
    """12.9 °/s at 100 % for a joint at the factory's acceleration; 60 mm/s, 12 °/s of the tool."""
    bend(any_driver)
    any_driver.click("menu_motion")
    assert any_driver.read("jog_step_label") == "Step"
    choose_continuous(any_driver)
    assert any_driver.read("jog_step_label") == "12.9°/s"
    accepted(any_driver.controller.motion.set_speed_percent(50))
    any_driver.run(0.2)
    assert any_driver.read("jog_step_label") == "6.4°/s"
    any_driver.click("menu_cartesian")
    choose_continuous(any_driver, "tool_step")
    assert any_driver.read("tool_step_label") == "30.0 mm/s, 6.0°/s"


def choose_continuous(app_driver, step_box="jog_step"):
    box = app_driver.find(step_box)
    assert isinstance(box, QComboBox)
    box.setCurrentIndex(box.findText("Continuous"))


@pytest.fixture
def ready(any_driver):
    """Bent, at 100 %, continuous jogging chosen, the window in front."""
    any_driver.window.activateWindow()
    bend(any_driver)
    choose_continuous(any_driver)
    any_driver.heard()
    return any_driver


def press(app_driver, name="jog_plus_1", seconds=0.3):
    """Press a button and keep it down for a while; the arm has moved then."""
    before = angles(app_driver)
    button = app_driver.find(name)
    button.setFocus()
    app_driver.press(button)
    hold(app_driver, seconds)
    assert app_driver.controller.jogging.active
    assert angles(app_driver) != before
    return button


# What a hold may end with -------------------------------------------------------------------------


def let_go(app_driver, button):
    QTest.mouseRelease(button, LEFT, pos=button.rect().center())


def leave(app_driver, button):
    outside = QPointF(button.width() + 40, 10)
    where = QPointF(button.mapToGlobal(QPoint(button.width() + 40, 10)))
    none = Qt.KeyboardModifier.NoModifier
    QApplication.sendEvent(
        button,
        QMouseEvent(QEvent.Type.MouseMove, outside, where, Qt.MouseButton.NoButton, LEFT, none),
    )


def focus_elsewhere(app_driver, button):
    app_driver.find("target_field_1").setFocus()


def focus_lost(app_driver, button):
    QApplication.sendEvent(button, QFocusEvent(QEvent.Type.FocusOut))


def other_window(app_driver, button):
    QApplication.sendEvent(app_driver.window, QEvent(QEvent.Type.WindowDeactivate))


def other_program(app_driver, button):
    app = QApplication.instance()
    app.applicationStateChanged.emit(Qt.ApplicationState.ApplicationInactive)


def minimise(app_driver, button):
    app_driver.window.showMinimized()


def hide(app_driver, button):
    app_driver.window.hide()


def close(app_driver, button):
    app_driver.window.close()


def other_panel(app_driver, button):
    app_driver.find("operation_area").setCurrentIndex(1)


def stop(app_driver, button):
    button.setEnabled(False)


ENDS = (
    let_go,
    leave,
    focus_elsewhere,
    focus_lost,
    other_window,
    other_program,
    minimise,
    hide,
    close,
    other_panel,
    stop,
)


@pytest.mark.parametrize("end", ENDS, ids=lambda end: end.__name__)
@ONE_IS_ENOUGH
def test_whatever_takes_the_button_away_stops_the_arm(ready, end):
    button = press(ready)
    end(ready, button)
    assert not ready.controller.jogging.active
    ready._settle()
    ready.heard()
    assert rest_s(ready) <= 0.1
    before = angles(ready)
    hold(ready, 0.2)
    assert not {f.arbitration_id for f in ready.heard()} & {0x155, 0x156, 0x157}
    assert angles(ready) == before


@ONE_IS_ENOUGH
def test_a_pointer_that_comes_back_does_not_begin_anew(ready):
    button = press(ready)
    leave(ready, button)
    inside = QPointF(button.rect().center())
    where = QPointF(button.mapToGlobal(button.rect().center()))
    none = Qt.KeyboardModifier.NoModifier
    QApplication.sendEvent(
        button,
        QMouseEvent(QEvent.Type.MouseMove, inside, where, Qt.MouseButton.NoButton, LEFT, none),
    )
    assert button.isDown()
    assert not ready.controller.jogging.active


@ONE_IS_ENOUGH
def test_the_field_goes_along_and_the_others_stay(ready):
    ready.type_into("target_field_2", "33")
    button = press(ready)
    assert "Jogging J1 +" in ready.read("notice_label")
    let_go(ready, button)
    rest_s(ready)
    hold(ready, 0.1)
    assert float(ready.read("target_field_1")) == pytest.approx(angles(ready)[0], abs=0.0005)
    assert ready.read("target_field_2") == "33.000"


def test_the_limit_is_said_where_the_operator_looks(ready):
    ready.controller.motion.send_joints((148.0, *angles(ready)[1:]))
    ready.run_until(
        lambda: not ready.controller.operating_state.moving and angles(ready)[0] == 148.0
    )
    ready.run(0.3)
    press(ready, seconds=0.1)
    hold(ready, 0.3)
    assert angles(ready)[0] == 150.0
    assert "at its limit of 150" in ready.read("motion_message")
    assert "Jogging ended" in ready.read("notice_label")


def test_a_step_is_still_a_step(ready):
    ready.find("jog_step").setCurrentIndex(1)
    ready.click("jog_plus_1")
    ready.run(0.6)
    assert angles(ready)[0] == 11.0
    assert not ready.controller.jogging.active


# Keys ---------------------------------------------------------------------------------------------


@pytest.fixture
def pad(ready):
    ready.click("jog_keys_button")
    pad = ready.find("jog_key_pad")
    assert pad.hasFocus()
    return pad


def key_down(pad, key):
    QTest.keyPress(pad, key)


def key_up(pad, key):
    QTest.keyRelease(pad, key)


@ONE_IS_ENOUGH
def test_no_key_moves_anything_before_it_is_switched_on(ready):
    ready.window.setFocus()
    assert not ready.find("jog_key_pad").isVisible()
    QTest.keyPress(ready.window, Qt.Key.Key_Space)
    QTest.keyPress(ready.window, Qt.Key.Key_Q)
    hold(ready, 0.1)
    assert ready.heard() == []


@ONE_IS_ENOUGH
def test_a_direction_alone_moves_nothing(ready, pad):
    key_down(pad, Qt.Key.Key_Q)
    hold(ready, 0.1)
    key_down(pad, Qt.Key.Key_Space)  # nor does the dead-man key that comes after it
    hold(ready, 0.1)
    assert ready.heard() == []


@pytest.mark.parametrize(
    "end",
    [
        lambda app_driver, pad: key_up(pad, Qt.Key.Key_Q),
        lambda app_driver, pad: key_up(pad, Qt.Key.Key_Space),
        lambda app_driver, pad: key_down(pad, Qt.Key.Key_W),
        lambda app_driver, pad: app_driver.find("target_field_1").setFocus(),
        other_window,
        minimise,
        other_panel,
    ],
    ids=["key", "dead man", "second key", "focus", "other window", "minimised", "other panel"],
)
@ONE_IS_ENOUGH
def test_whatever_ends_the_keys_stops_the_arm(ready, pad, end):
    before = angles(ready)
    key_down(pad, Qt.Key.Key_Space)
    key_down(pad, Qt.Key.Key_Q)
    hold(ready, 0.2)
    assert angles(ready)[0] > before[0]
    assert angles(ready)[1:] == before[1:]
    end(ready, pad)
    assert not ready.controller.jogging.active
    assert rest_s(ready) <= 0.1
    place = angles(ready)
    hold(ready, 10 * TICK_S)
    assert angles(ready) == place


@ONE_IS_ENOUGH
def test_the_keyboard_s_own_repetition_counts_for_nothing(ready, pad):
    key_down(pad, Qt.Key.Key_Space)
    key_down(pad, Qt.Key.Key_A)
    asked = ready.codes().count("jogging_joint")
    for key in (Qt.Key.Key_A, Qt.Key.Key_Space):
        for kind in (QEvent.Type.KeyRelease, QEvent.Type.KeyPress):
            QApplication.sendEvent(pad, _repeated(kind, key))
    hold(ready, 0.1)
    assert ready.controller.jogging.active
    assert ready.codes().count("jogging_joint") == asked
    key_up(pad, Qt.Key.Key_A)


def _repeated(kind, key):
    return QKeyEvent(kind, key, Qt.KeyboardModifier.NoModifier, "", True)


@ONE_IS_ENOUGH
def test_the_stop_key_stops_while_keys_are_held(ready, pad):
    key_down(pad, Qt.Key.Key_Space)
    key_down(pad, Qt.Key.Key_Q)
    hold(ready, 0.1)
    key_down(pad, Qt.Key.Key_F12)
    assert not ready.controller.jogging.active
    ready.run_until(lambda: "stop_confirmed" in ready.codes())


@ONE_IS_ENOUGH
def test_with_a_step_chosen_a_key_is_one_step(ready, pad):
    ready.find("jog_step").setCurrentIndex(1)
    pad.setFocus()
    key_down(pad, Qt.Key.Key_Space)
    key_down(pad, Qt.Key.Key_H)
    ready.run(0.6)
    assert angles(ready)[5] == 19.0


@ONE_IS_ENOUGH
def test_an_arm_that_cannot_move_says_so_on_the_pad(ready, pad):
    ready.controller.emergency_stop()
    ready.run_until(lambda: "stop_confirmed" in ready.codes())
    assert "not possible now" in ready.read("jog_key_pad_hint")
    assert "emergency stop" in pad.toolTip()
