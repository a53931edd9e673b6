"""S19: where a gamepad moves nothing, its stop that always works, and how it moves the arm."""

import pytest
from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QApplication, QMenu

from armui.cell.cell import Cell, with_part
from armui.cell.user_frames import UserFrame
from armui.control.gamepad.pilot import GAMEPAD_NOT_IN_FRONT
from armui.control.motion.cartesian import FRAME_NOT_IN_FORCE
from armui.control.motion.jog_path import JointJog
from armui.gamepad.dead_man import HoldPhase
from armui.gamepad.layout import JogMode
from armui.telemetry.events import Asker
from armui.ui.shell.workspace import PageWindow
from tests.accepted import accepted
from tests.control.jogger import bend
from tests.gamepad.pads import MOUSE, PAD, switch_on
from tests.gamepad.piloting import (
    angles,
    drive,
    is_sent_nothing,
    pass_time,
    pick_up,
    pilot,
    reasons,
)

# The window ---------------------------------------------------------------------------------------


def test_an_open_menu_takes_it_away(ready, pads):
    drive(ready, pads)
    menu = QMenu(ready.window)
    menu.addAction("one")
    menu.popup(ready.window.mapToGlobal(ready.window.rect().center()))
    pass_time(ready, 0.02)
    assert not ready.controller.jogging.active
    assert reasons(ready) == [GAMEPAD_NOT_IN_FRONT]
    menu.close()
    menu.deleteLater()


@pytest.mark.parametrize("key", ["settings", "backup"])
def test_with_another_window_in_front_nothing_begins(ready, pads, key):
    pads.release("left_shoulder")
    ready.window.pages.show(key)
    pass_time(ready, 0.02)
    assert not ready.window.isActiveWindow()
    pads.press("left_shoulder")
    pass_time(ready, 0.02)
    pads.push(left_x=-1.0)
    assert is_sent_nothing(ready)
    assert "not in front" in ready.read("gamepad_text")


@pytest.fixture
def taken_out(ready, pads):
    """A page in a window of its own, in front; the dead-man button is pressed there."""
    pads.release("left_shoulder")
    ready.click("library_button")
    ready.click("page_take_out")
    window = ready.window.findChild(PageWindow)
    window.activateWindow()
    pass_time(ready, 0.02)
    assert window.isActiveWindow()
    pads.press("left_shoulder")
    pass_time(ready, 0.02)
    return window


def test_a_page_that_was_taken_out_is_ours_too(ready, pads, taken_out):
    drive(ready, pads)


def main_window_in_front(app_driver, window):
    app_driver.window.activateWindow()


def page_closed(app_driver, window):
    window.reject()


def main_window_hidden(app_driver, window):
    app_driver.window.hide()


def main_window_minimised(app_driver, window):
    app_driver.window.showMinimized()


def another_window(app_driver, window):
    QApplication.sendEvent(window, QEvent(QEvent.Type.WindowDeactivate))


@pytest.mark.parametrize(
    "end",
    [
        main_window_in_front,
        page_closed,
        main_window_hidden,
        main_window_minimised,
        another_window,
    ],
)
def test_what_takes_the_page_s_window_away_takes_the_hold_away(ready, pads, taken_out, end):
    drive(ready, pads)
    end(ready, taken_out)
    pass_time(ready, 0.03)
    assert not ready.controller.jogging.active
    pads.push(left_x=0.0)
    pass_time(ready, 0.1)
    pads.push(left_x=-1.0)
    pass_time(ready, 0.05)
    assert not ready.controller.jogging.active  # it takes a new press


def test_a_button_on_the_screen_that_is_held_goes_before(ready, pads):
    accepted(ready.controller.jogging.start(JointJog(6, 1)))
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
    drive(ready, pads)
    accepted(ready.controller.jogging.start(JointJog(6, 1)))
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
    ready.window.pages.show("settings")
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
    pads.release("left_shoulder")
    pass_time(ready, 0.02)
    assert "Base frame" in ready.read("gamepad_text")
    pads.press("left_shoulder")
    pass_time(ready, 0.02)
    drive(ready, pads, left_y=1.0)
    assert "Base frame · jogging X−" in ready.read("gamepad_text")


def next_mode(driver, pads):
    pads.press("y")
    pads.release("y")
    pass_time(driver, 0.02)
    return pilot(driver).view.mode


def test_the_mode_of_the_user_frame_is_left_out_without_one(ready, pads):
    assert [next_mode(ready, pads) for _press in range(3)] == [
        JogMode.BASE,
        JogMode.TOOL,
        JogMode.JOINT,
    ]
    pilot(ready).set_mode(JogMode.USER)  # as the settings can
    pads.release("left_shoulder")
    pass_time(ready, 0.02)
    pads.press("left_shoulder")
    pass_time(ready, 0.02)
    pads.push(left_y=1.0)
    assert is_sent_nothing(ready)
    assert pilot(ready).view.refusal == FRAME_NOT_IN_FORCE()


def test_it_goes_along_the_user_frame_in_force(ready, pads):
    turned = UserFrame("turned", (0.0, 0.0, 0.0, 0.0, 0.0, 90.0))  # its −Y is the base's X
    accepted(ready.controller.cell.take(with_part(Cell("bench"), turned)))
    assert [next_mode(ready, pads) for _press in range(3)][-1] is JogMode.USER
    pads.release("left_shoulder")
    pass_time(ready, 0.02)
    pads.press("left_shoulder")
    pass_time(ready, 0.02)
    before = ready.controller.state.end_pose()
    drive(ready, pads, left_x=1.0)  # Y−
    pass_time(ready, 0.5)
    pads.push(left_x=0.0)
    pass_time(ready, 0.5)
    after = ready.controller.state.end_pose()
    assert after[0] - before[0] > 3.0
    assert after[1:3] == pytest.approx(before[1:3], abs=0.05)


def test_the_event_log_says_that_the_operator_asked_by_gamepad(ready, pads):
    drive(ready, pads)
    entries = ready.controller.events.entries()
    found = [each for each in entries if each.code == "device_jogs_joints"]
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
