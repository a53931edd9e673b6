"""S19 and the jogging table: a gamepad is a held button, and whatever takes it away stops the arm.

The devices stand where the program reads them from; everything behind that is the program's own.
"""

import errno

import can
import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QApplication

from armui.control.gamepad.pilot import GAMEPAD_LOST, GAMEPAD_UNATTENDED
from armui.control.motion.jogging import GAMEPAD_SILENT, JOG_HELD_UP, JOG_NO_FEEDBACK
from armui.gamepad.dead_man import HoldPhase
from tests.company import OtherHost
from tests.control.jogger import bend, rest_s
from tests.gamepad.pads import MOUSE, OTHER_PAD, PAD, switch_on
from tests.gamepad.piloting import drive, is_sent_nothing, pass_time, pick_up, pilot, reasons

# What a hold ends with ----------------------------------------------------------------------------


def dead_man_let_go(app_driver, pads):
    pads.release("left_shoulder")


def axis_let_go(app_driver, pads):
    pads.push(left_x=0.0)


def unplugged(app_driver, pads):
    pads.unplug()


def nothing_is_read_any_more(app_driver, pads):
    pads.hangs = True
    app_driver.time_s += 0.07  # and 10 ms in each look that follows


def another_window(app_driver, pads):
    QApplication.sendEvent(app_driver.window, QEvent(QEvent.Type.WindowDeactivate))


def another_program_or_a_locked_screen(app_driver, pads):
    QApplication.instance().applicationStateChanged.emit(Qt.ApplicationState.ApplicationInactive)


def minimised(app_driver, pads):
    app_driver.window.showMinimized()


def hidden(app_driver, pads):
    app_driver.window.hide()


def a_second_dead_man(app_driver, pads):
    pads.plug_in(OTHER_PAD)
    pass_time(app_driver, 0.01)
    pads.press("left_shoulder", info=OTHER_PAD)


def stop_button(app_driver, pads):
    pads.press("b")


def halt_button(app_driver, pads):
    pads.press("x")


def stop_on_the_screen(app_driver, pads):
    app_driver.controller.emergency_stop()


def switched_off(app_driver, pads):
    app_driver.window._preferences.change(gamepad=False)


def another_mode_chosen(app_driver, pads):
    app_driver.window._preferences.change(gamepad_mode="base")


def a_button_of_the_screen_let_go(app_driver, pads):
    app_driver.controller.jogging.stop()


ENDS = (
    *(dead_man_let_go, axis_let_go, unplugged, nothing_is_read_any_more),
    *(another_window, another_program_or_a_locked_screen, minimised, hidden, a_second_dead_man),
    *(stop_button, halt_button, stop_on_the_screen, switched_off, another_mode_chosen),
    a_button_of_the_screen_let_go,
)


@pytest.mark.parametrize("end", ENDS, ids=lambda end: end.__name__)
def test_whatever_takes_the_hold_away_stops_the_arm(ready, pads, end):
    drive(ready, pads)
    end(ready, pads)
    pass_time(ready, 0.01)
    assert not ready.controller.jogging.active
    if end not in {stop_button, stop_on_the_screen}:  # a stopped arm sinks
        assert rest_s(ready) <= 0.1
        assert is_sent_nothing(ready)


@pytest.mark.parametrize(
    "end",
    [end for end in ENDS if end not in {dead_man_let_go, axis_let_go, unplugged, switched_off}],
    ids=lambda end: end.__name__,
)
def test_it_takes_a_new_press_although_everything_is_still_held(ready, pads, end):
    drive(ready, pads)
    end(ready, pads)
    pass_time(ready, 0.02)
    pads.hangs = False
    ready.window.showNormal()
    ready.window.activateWindow()
    pads.push(left_x=0.0)
    pass_time(ready, 0.1)
    pads.push(left_x=-1.0)
    pass_time(ready, 0.05)
    assert not ready.controller.jogging.active
    assert ready.program.controller.gamepad.view.phase is not HoldPhase.MOVING


def test_a_held_button_moves_nothing_before_an_axis_is_pushed(ready):
    assert pilot(ready).view.phase is HoldPhase.READY
    assert is_sent_nothing(ready)


def test_without_the_dead_man_nothing_moves(ready, pads):
    pads.release("left_shoulder")
    for axes in ({"left_x": -1.0}, {"right_y": 1.0, "right_trigger": 1.0}):
        pads.push(**axes)
        assert is_sent_nothing(ready)
    pads.press("dpad_up", "a", "y")
    assert is_sent_nothing(ready)


def test_an_axis_that_was_pushed_before_must_come_back_first(ready, pads):
    pads.release("left_shoulder")
    pads.push(left_x=-1.0)
    pass_time(ready, 0.02)
    pads.press("left_shoulder")
    assert is_sent_nothing(ready)
    assert pilot(ready).view.phase is HoldPhase.OFF_CENTRE
    assert "back to its centre" in ready.read("gamepad_text")
    pads.push(left_x=0.0)
    pass_time(ready, 0.02)
    drive(ready, pads)


def test_a_device_that_comes_with_its_button_down_is_not_held(app_driver, pads):
    app_driver.window.activateWindow()
    bend(app_driver)
    switch_on(app_driver.program, pads)
    pads.plug_in(PAD, down=("left_shoulder",))
    pass_time(app_driver, 0.02)
    pads.push(left_x=-1.0)
    assert is_sent_nothing(app_driver)
    assert "let go of LB" in app_driver.read("gamepad_text")


def test_a_device_that_comes_back_must_be_pressed_anew(ready, pads):
    drive(ready, pads)
    pads.unplug()
    pass_time(ready, 0.3)
    assert reasons(ready) == [GAMEPAD_LOST]
    pads.plug_in(PAD, down=("left_shoulder",))
    pads.push(left_x=-1.0)
    assert is_sent_nothing(ready)


def test_a_space_mouse_that_falls_silent_is_gone(app_driver, pads):
    app_driver.window.activateWindow()
    bend(app_driver)
    switch_on(app_driver.program, pads, gamepad_mode="base")
    pick_up(app_driver, pads, MOUSE, dead_man="1")
    pads.push(MOUSE, x=-1.0)
    pass_time(app_driver, 0.2)
    assert app_driver.controller.jogging.active
    pads.push(MOUSE, silent=True)
    pass_time(app_driver, 0.01)
    assert not app_driver.controller.jogging.active
    assert reasons(app_driver) == [GAMEPAD_SILENT]


def test_ten_seconds_without_a_movement_of_the_device_end_it(ready, pads):
    drive(ready, pads, left_y=-0.3)  # slowly: far from any limit after ten seconds
    pass_time(ready, 9.5)
    assert ready.controller.jogging.active
    pass_time(ready, 0.4)
    assert not ready.controller.jogging.active
    assert reasons(ready) == [GAMEPAD_UNATTENDED]
    assert "held for 10 s" in ready.read("motion_message")


def test_a_hand_that_moves_may_go_on(ready, pads):
    drive(ready, pads, left_y=-0.3)
    for place in (-0.36, -0.3, -0.36):
        pass_time(ready, 4.0)
        pads.push(left_y=place)
    assert ready.controller.jogging.active


# The program, the link, other hosts ---------------------------------------------------------------


def test_a_window_that_was_stuck_does_not_go_on_by_itself(ready, pads):
    drive(ready, pads)
    ready.step(0.1)
    assert not ready.controller.jogging.active
    assert reasons(ready) == [JOG_HELD_UP]
    pass_time(ready, 0.3)
    assert is_sent_nothing(ready)
    assert pilot(ready).view.phase is HoldPhase.SPENT


def test_a_pilot_that_looks_no_more_lets_the_arm_rest(ready, pads):
    """The jog has a clock of its own: nobody steers, nothing goes on."""
    drive(ready, pads)
    pilot(ready)._timer.stop()
    for _ in range(10):
        ready.step(0.01)
    assert not ready.controller.jogging.active
    assert reasons(ready) == [GAMEPAD_SILENT]
    assert rest_s(ready) <= 0.1


def test_a_lost_adapter_ends_it_and_it_does_not_come_back_with_it(ready, pads):
    drive(ready, pads)
    ready.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    pass_time(ready, 0.05)
    assert not ready.controller.jogging.active
    assert pilot(ready).view.phase is HoldPhase.SPENT
    ready.plug_in()
    ready.wait(lambda: "reconnected" in ready.codes())
    pass_time(ready, 0.3)
    assert is_sent_nothing(ready)


def test_a_pulled_cable_ends_it(ready, pads):
    drive(ready, pads)
    ready.node.link.off = True
    pass_time(ready, 0.15)
    assert not ready.controller.jogging.active
    assert reasons(ready) == [JOG_NO_FEEDBACK]


def test_another_host_that_moves_the_arm_ends_it(ready, pads):
    other = OtherHost(ready)
    drive(ready, pads)
    other.say("155#0000271000002710", "151#0101320000000000")
    pass_time(ready, 0.1)
    assert not ready.controller.jogging.active
    pads.push(left_x=0.0)
    pass_time(ready, 0.05)
    pads.release("left_shoulder")
    pass_time(ready, 0.02)
    pads.press("left_shoulder")
    pass_time(ready, 0.02)
    pads.push(left_x=-1.0)
    ready.heard()
    pass_time(ready, 0.2)
    assert not ready.controller.jogging.active
    assert not {frame.arbitration_id for frame in ready.heard()} & {0x155, 0x156, 0x157}
    assert "let go of LB" in ready.read("gamepad_text")


def test_an_arm_that_may_not_move_refuses_and_says_why(app_driver, pads):
    app_driver.window.activateWindow()
    app_driver.connect()
    switch_on(app_driver.program, pads)
    pick_up(app_driver, pads)
    pads.push(left_x=-1.0)
    assert is_sent_nothing(app_driver)
    assert "not enabled" in app_driver.read("gamepad_text")
