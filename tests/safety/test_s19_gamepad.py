"""S19 and the jogging table: a gamepad is a held button, and whatever takes it away stops the arm.

The devices stand where the program reads them from; everything behind that is the program's own.
"""

import errno

import can
import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QApplication, QMenu

from armui.arm.refusal_codes import RefusalCode
from armui.control.events import EventCode
from armui.gamepad.dead_man import HoldPhase
from armui.gamepad.layout import JogMode
from armui.telemetry.events import Asker
from tests.company import OtherHost
from tests.control.jogger import bend, rest_s
from tests.gamepad.pads import MOUSE, OTHER_PAD, PAD, Pads, switch_on
from tests.gamepad.piloting import (
    angles,
    drive,
    is_sent_nothing,
    pass_time,
    pick_up,
)


@pytest.fixture
def pads():
    return Pads()


@pytest.fixture
def ready(app_driver, pads):
    """Bent, at 100 %, the window in front, gamepads switched on, the dead-man button held."""
    app_driver.window.activateWindow()
    bend(app_driver)
    switch_on(app_driver.program, pads)
    pick_up(app_driver, pads)
    app_driver.heard()
    return app_driver


def pilot(app_driver):
    return app_driver.controller.gamepad


def reasons(app_driver):
    """Why jogs have ended."""
    ends = [each for each in app_driver.events if each.code == EventCode.JOG_ENDED]
    return [each.params["reason"].code for each in ends]


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
    assert reasons(ready) == [RefusalCode.GAMEPAD_LOST]
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
    assert reasons(app_driver) == [RefusalCode.GAMEPAD_SILENT]


def test_ten_seconds_without_a_movement_of_the_device_end_it(ready, pads):
    drive(ready, pads, left_y=-0.3)  # slowly: far from any limit after ten seconds
    pass_time(ready, 9.5)
    assert ready.controller.jogging.active
    pass_time(ready, 0.4)
    assert not ready.controller.jogging.active
    assert reasons(ready) == [RefusalCode.GAMEPAD_UNATTENDED]
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
    assert reasons(ready) == [RefusalCode.JOG_HELD_UP]
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
    assert reasons(ready) == [RefusalCode.GAMEPAD_SILENT]
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
    assert reasons(ready) == [RefusalCode.JOG_NO_FEEDBACK]


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


# The window ---------------------------------------------------------------------------------------


def test_an_open_menu_takes_it_away(ready, pads):
    drive(ready, pads)
    menu = QMenu(ready.window)
    menu.addAction("one")
    menu.popup(ready.window.mapToGlobal(ready.window.rect().center()))
    pass_time(ready, 0.02)
    assert not ready.controller.jogging.active
    assert reasons(ready) == [RefusalCode.GAMEPAD_NOT_IN_FRONT]
    menu.close()
    menu.deleteLater()


@pytest.mark.parametrize("open_it", ["open_settings_dialog", "open_help_dialog"])
def test_with_another_window_in_front_nothing_begins(ready, pads, open_it):
    pads.release("left_shoulder")
    getattr(ready.window, open_it)()
    pass_time(ready, 0.02)
    assert not ready.window.isActiveWindow()
    pads.press("left_shoulder")
    pass_time(ready, 0.02)
    pads.push(left_x=-1.0)
    assert is_sent_nothing(ready)
    assert "not in front" in ready.read("gamepad_text")


def test_a_button_on_the_screen_that_is_held_goes_before(ready, pads):
    from armui.control.motion.jog_path import JointJog

    assert ready.controller.jogging.start(JointJog(6, 1)) is None
    pads.push(left_x=-1.0)
    pass_time(ready, 0.05)
    assert ready.controller.jogging.active
    assert ready.controller.jogging.steered is None
    before = angles(ready)
    pass_time(ready, 0.2)
    after = angles(ready)
    assert after[0] == before[0]
    assert after[5] > before[5]


def test_a_button_on_the_screen_takes_over_and_keeps_what_it_took(ready, pads):
    from armui.control.motion.jog_path import JointJog

    drive(ready, pads)
    assert ready.controller.jogging.start(JointJog(6, 1)) is None
    pass_time(ready, 0.5)
    assert ready.controller.jogging.active
    assert ready.controller.jogging.steered is None
    assert pilot(ready).view.phase is HoldPhase.SPENT
    ready.controller.jogging.stop()


# The stop -----------------------------------------------------------------------------------------


def stops_heard(app_driver):
    return [frame for frame in app_driver.heard() if frame.arbitration_id == 0x150]


def test_the_stop_needs_no_dead_man(ready, pads):
    pads.release("left_shoulder")
    pass_time(ready, 0.02)
    ready.heard()
    pads.press("b")
    pass_time(ready, 0.01)
    assert stops_heard(ready)[0].data[0] == 1
    assert "stop_sent" in ready.codes()


def test_the_stop_works_from_any_window_and_however_short_the_press(ready, pads):
    pads.release("left_shoulder")
    ready.window.open_settings_dialog()
    pass_time(ready, 0.02)
    ready.heard()
    pads.press("b")
    pads.release("b")
    pass_time(ready, 0.01)
    assert stops_heard(ready)[0].data[0] == 1


def test_the_stop_works_on_a_device_that_does_not_drive(ready, pads):
    pads.plug_in(MOUSE)
    drive(ready, pads)
    ready.heard()
    pads.press("2", info=MOUSE)
    pass_time(ready, 0.01)
    assert stops_heard(ready)[0].data[0] == 1
    assert not ready.controller.jogging.active


def test_the_halt_needs_no_dead_man(ready, pads):
    pads.release("left_shoulder")
    pass_time(ready, 0.02)
    pads.press("x")
    pass_time(ready, 0.01)
    assert "halt_sent" in ready.codes()


def test_a_button_that_was_down_before_is_no_press(app_driver, pads):
    bend(app_driver)
    switch_on(app_driver.program, pads)
    pads.plug_in(PAD, down=("b",))
    pass_time(app_driver, 0.1)
    assert "stop_sent" not in app_driver.codes()


def test_switched_off_means_nothing_is_taken(ready, pads):
    ready.window._preferences.change(gamepad=False)
    assert pads.ended
    pads.press("b")
    pass_time(ready, 0.05)
    assert "stop_sent" not in ready.codes()


def test_it_is_off_and_nothing_is_read_unless_the_operator_wants_it(app_driver):
    app_driver.window.activateWindow()
    assert not app_driver.window._preferences.settings.gamepad
    assert "gamepad" not in vars(app_driver.controller)
    assert not app_driver.find("gamepad_strip").isVisible()


# What moves, how fast, and who is said to have asked ----------------------------------------------


@pytest.mark.parametrize(
    ("axes", "joint", "sign"),
    [({"left_x": -1.0}, 1, 1), ({"left_y": 1.0}, 2, -1), ({"right_x": 1.0}, 4, -1)],
)
def test_one_joint_turns_and_the_others_stay(ready, pads, axes, joint, sign):
    before = angles(ready)
    drive(ready, pads, seconds=0.5, right_trigger=1.0, **axes)
    turned = [now - then for now, then in zip(angles(ready), before, strict=True)]
    assert sign * turned[joint - 1] > 2.0
    assert [each for place, each in enumerate(turned, 1) if place != joint] == [0.0] * 5


def test_the_trigger_makes_it_faster_and_never_faster_than_the_window_shows(ready, pads):
    def way(**axes):
        drive(ready, pads, seconds=0.4, **axes)
        before = angles(ready)[0]
        pass_time(ready, 0.4)
        gone = angles(ready)[0] - before
        pads.push(left_x=0.0, right_trigger=0.0)
        pass_time(ready, 0.5)
        return gone

    slow, fast = way(left_x=-1.0), way(left_x=-1.0, right_trigger=1.0)
    ready.controller.motion.set_speed_percent(50)
    half = way(left_x=-1.0, right_trigger=1.0)
    assert slow == pytest.approx(0.2 * fast, rel=0.1)
    assert half == pytest.approx(0.5 * fast, rel=0.1)
    # 12.9 °/s is what a button on the screen jogs a joint with
    assert fast == pytest.approx(0.4 * 12.9, rel=0.05)


def test_the_mode_button_and_the_sign_in_the_window(ready, pads):
    assert "Joints" in ready.read("gamepad_text")
    pads.press("y")
    pads.release("y")
    pass_time(ready, 0.02)
    assert pilot(ready).view.mode is JogMode.BASE
    assert "Base frame" in ready.read("gamepad_text")
    pads.release("left_shoulder")
    pass_time(ready, 0.02)
    pads.press("left_shoulder")
    pass_time(ready, 0.02)
    drive(ready, pads, left_y=1.0)
    assert "Base frame · jogging X−" in ready.read("gamepad_text")


def test_the_event_log_says_that_the_operator_asked_by_gamepad(ready, pads):
    drive(ready, pads)
    entries = ready.controller.events.entries()
    found = [each for each in entries if each.code == EventCode.DEVICE_JOGS_JOINTS]
    assert found[-1].who is Asker.OPERATOR
    assert found[-1].params == {"axes": "J1+", "device": PAD.name}
    assert f"{PAD.name} jogs J1+ (joints)" in ready.read("notice_label")


def test_the_fields_of_the_joints_go_along(ready, pads):
    ready.type_into("target_field_2", "33")
    ready.window.activateWindow()
    drive(ready, pads)
    pads.release("left_shoulder")
    pass_time(ready, 0.3)
    assert float(ready.read("target_field_1")) == pytest.approx(angles(ready)[0], abs=0.0005)
    assert ready.read("target_field_2") == "33.000"


def test_all_axes_at_once_and_another_assignment(app_driver, pads):
    app_driver.window.activateWindow()
    bend(app_driver)
    buttons = {PAD.name: {"dead_man": "right_shoulder"}}
    switch_on(app_driver.program, pads, gamepad_one_axis=False, gamepad_buttons=buttons)
    pick_up(app_driver, pads)  # by the button that no longer counts
    pads.push(left_x=-1.0)
    assert is_sent_nothing(app_driver)
    pads.push(left_x=0.0)
    pads.press("right_shoulder")
    pass_time(app_driver, 0.02)
    before = angles(app_driver)
    drive(app_driver, pads, seconds=0.4, left_x=-1.0, left_y=-1.0, right_trigger=1.0)
    turned = [now - then for now, then in zip(angles(app_driver), before, strict=True)]
    assert turned[0] > 2.0
    assert turned[1] > 2.0
    assert turned[2:] == [0.0] * 4
