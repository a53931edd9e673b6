"""Regions 1, 3 and 4: communication, speed, enable (M1–M5)."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QSpinBox

from armui.arm.limits import JointLimits
from armui.arm.state import EndLimits, Reading
from armui.control.devices.joint_monitor import JointMonitor
from armui.control.link.link_state import LinkState
from armui.control.operating_state import RUN_UNDER_WAY, Busy, OperatingState, StopState
from armui.control.safety.interlocks import STOPPED
from armui.protocol.codes import ALL_JOINTS, MoveMode
from armui.protocol.generation import Generation
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.shell.top_bar import CommunicationButton, EnableButton, TopBar
from armui.ui.widgets.text_label import ValueLabel
from armui.ui.widgets.track_slider import TrackSlider
from tests.ui.arm_states import arm_state, heard_six, operating_state
from tests.ui.dialog_reading import hold
from tests.ui.test_joint_status import WELL

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def opened():
    return []


@pytest.fixture
def bar(qtbot, controller, opened):
    bar = TopBar(
        controller, lambda: opened.append("connect"), JointMonitor(controller, parent=controller)
    )
    qtbot.addWidget(bar)
    bar.resize(1280, 64)
    bar.show()
    return bar


@pytest.fixture
def communication(bar):
    return bar.findChild(CommunicationButton, "communication_button")


@pytest.fixture
def enable(bar):
    return bar.findChild(EnableButton, "enable_button")


@pytest.fixture
def slider(bar):
    return bar.findChild(TrackSlider, "speed_slider")


@pytest.fixture
def field(bar):
    return bar.findChild(QSpinBox, "speed_field")


def test_communication_button_opens_the_connect_window(communication, opened, qtbot):
    qtbot.mouseClick(communication, LEFT)
    assert opened == ["connect"]


def test_every_link_state_has_its_own_word_and_look(communication, controller):
    words, looks = [], []
    for link in LinkState:
        controller.be(operating_state(link=link))
        words.append(communication.text())
        sign = communication.grab(communication.rect().adjusted(0, 0, -150, 0)).toImage()
        # in greys: the shape alone has to tell the states apart
        looks.append(sign.convertToFormat(sign.Format.Format_Grayscale8))
    assert words == ["Not connected", "Connecting…", "Offline", "Online", "Connection lost"]
    for place, look in enumerate(looks):
        assert all(look != other for other in looks[:place])


def test_the_device_is_named(communication, controller):
    assert communication.device_name == ""
    controller.be(operating_state())
    assert "1" in communication.device_name
    assert communication.device_name in communication.toolTip()


def test_speed_by_field(field, controller, qtbot):
    controller.be(operating_state())
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "55")
    assert controller.calls == []
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert controller.calls == [("set_speed_percent", 55)]


def test_speed_by_keys_on_the_slider(slider, field, controller, qtbot):
    controller.be(operating_state())
    qtbot.keyClick(slider, Qt.Key.Key_Right)
    qtbot.keyClick(slider, Qt.Key.Key_PageUp)
    assert controller.calls == [("set_speed_percent", 31), ("set_speed_percent", 41)]
    assert field.value() == 41
    assert slider.requested == 41


def test_a_click_beside_the_handle_goes_a_page_only(slider, controller, qtbot):
    controller.be(operating_state())
    right_end = slider.rect().center()
    right_end.setX(slider.width() - 12)
    qtbot.mouseClick(slider, LEFT, pos=right_end)
    assert controller.calls == [("set_speed_percent", 40)]


def test_a_drag_sends_once_when_the_handle_is_let_go(slider, field, controller, qtbot):
    controller.be(operating_state())

    def at(percent):
        middle = slider.rect().center()
        middle.setX(round(9 + percent / 100 * (slider.width() - 18)))
        return middle

    qtbot.mousePress(slider, LEFT, pos=at(30))
    for percent in (40, 50, 60):
        qtbot.mouseMove(slider, at(percent))
    assert controller.calls == []
    shown = field.value()
    assert shown == pytest.approx(60, abs=1)
    qtbot.mouseRelease(slider, LEFT, pos=at(60))
    assert controller.calls == [("set_speed_percent", shown)]


def test_a_refused_speed_is_not_shown_as_a_fact(field, slider, controller, qtbot):
    controller.be(operating_state())
    controller.answer = RUN_UNDER_WAY()
    field.setValue(60)
    assert field.value() == 30
    assert slider.requested == 30


def test_the_arm_s_own_speed_stands_beside(bar, slider, controller):
    own = bar.findChild(ValueLabel, "arm_speed")
    assert own.text() == "—"
    controller.be_ready()
    controller.hear(arm_state(speed_percent=12, sequence=2))
    assert own.text() == "12 %"
    assert slider.measured == 12


def test_nothing_is_shown_of_what_generation_2_does_not_tell(bar, controller):
    own = bar.findChild(ValueLabel, "arm_speed")
    controller.be(operating_state(generation=Generation.TWO))
    assert own.isHidden()
    controller.be(operating_state(generation=Generation.ONE))
    assert not own.isHidden()


@pytest.mark.parametrize(
    ("marks", "busy", "word"),
    [
        ((True,) * 6, None, "Enabled"),
        ((False,) * 6, None, "Disabled"),
        ((True, False, True, True, True, True), None, "Partly enabled"),
        ((True, None, True, True, True, True), None, "Partly enabled"),
        ((None,) * 6, None, "Unknown"),
        ((False, None, False, False, False, False), None, "Unknown"),
        ((False,) * 6, Busy.ENABLING, "Enabling…"),
        ((True,) * 6, Busy.DISABLING, "Disabling…"),
    ],
)
def test_enable_button_shows_the_six_joints(enable, controller, marks, busy, word):
    controller.be(operating_state(enabled=marks, busy=busy))
    assert enable.marks == marks
    assert enable.text() == word


def test_a_joint_with_a_fault_has_another_mark_though_it_is_enabled(enable, controller):
    controller.be(operating_state(generation=Generation.TWO))
    well = enable.grab().toImage()
    hot = WELL._replace(motor_overtemperature=True)
    drivers = heard_six((WELL, hot, WELL, WELL, WELL, WELL))
    controller.hear(arm_state(sequence=2)._replace(drivers_slow=drivers))
    assert enable.faulty == (2,)
    assert "Fault: J2" in enable.accessibleName()
    assert "J2" in enable.toolTip()
    grey = well.Format.Format_Grayscale8  # the shape alone has to tell
    assert enable.grab().toImage().convertToFormat(grey) != well.convertToFormat(grey)
    controller.hear(arm_state(sequence=3)._replace(drivers_slow=heard_six((WELL,) * 6)))
    assert enable.faulty == ()
    assert enable.grab().toImage() == well


def test_in_an_emergency_stop_the_motors_are_not_called_disabled(enable, controller):
    """The motors brake until the release, though they report disabled."""
    off = operating_state(enabled=(False,) * 6, stop=StopState.STOPPED)
    controller.be(off)
    assert enable.text() == "Stopped"
    assert enable.accessibleName() == "Stopped"
    controller.be(replace(off, stop=StopState.RUNNING))
    assert enable.text() == "Disabled"


@pytest.mark.parametrize("marks", [(False,) * 6, (True,) * 5 + (False,), (None,) * 6])
def test_a_click_enables_unless_all_are_enabled(enable, controller, qtbot, marks):
    controller.be(operating_state(enabled=marks))
    qtbot.mouseClick(enable, LEFT)
    assert controller.calls == [("enable", ALL_JOINTS)]


def test_disabling_says_first_that_the_arm_drops(bar, enable, controller, qtbot):
    controller.be(operating_state(enabled=(False,) * 6))
    assert enable.offer == ""
    controller.be(operating_state())
    assert enable.offer == "Disable…"
    qtbot.mouseClick(enable, LEFT)
    assert controller.calls == []
    (question,) = bar.findChildren(ConfirmDialog)
    assert "drop" in question.text()
    qtbot.mouseClick(question.action_button, LEFT)
    assert controller.calls == []
    hold(question.action_button)
    assert controller.calls == [("disable", ALL_JOINTS)]


def test_what_cannot_be_enabled_says_why(enable, controller):
    controller.be(OperatingState())
    assert not enable.isEnabled()
    assert "connected" in enable.toolTip()
    controller.be(operating_state(cannot_enable=STOPPED()))
    assert "emergency stop" in enable.toolTip()
    controller.be(operating_state())
    assert enable.isEnabled()
    assert "drop" in enable.toolTip()


def test_what_the_speed_means_stands_beside_it_for_the_motion_at_hand(bar, controller):
    means = bar.findChild(ValueLabel, "speed_means")
    assert means.text() == ""
    limits = tuple(JointLimits(-90.0, 90.0, speed) for speed in (100.0, 172.0, *[100.0] * 4))
    end = Reading(EndLimits(0.5, 1.0, 1.0, 1.0), 0.0)
    controller.be(operating_state(limits=limits))

    def hear(mode, sequence):
        state = arm_state(move_mode=mode, sequence=sequence)
        controller.hear(state._replace(end_limits=end))

    hear(MoveMode.MOVE_J, 2)
    assert means.text() == "≤ 51.6°/s"
    hear(MoveMode.MOVE_L, 3)
    assert means.text() == "≤ 150 mm/s"
    hear(MoveMode.MOVE_P, 4)
    assert means.text() == "≤ 51.6°/s"
    controller.be(operating_state(limits=limits, jogging=True))
    assert means.text() == ""  # a jog has a pace of its own


def test_without_room_what_the_speed_means_is_in_its_tooltip(bar, slider, controller):
    controller.be_ready()
    controller.hear(arm_state(sequence=2))
    means = bar.findChild(ValueLabel, "speed_means")
    assert means.text()
    bar.resize(1280, bar.height())
    assert means.isVisible()
    assert means.text() not in slider.toolTip()
    bar.resize(900, bar.height())
    assert not means.isVisible()
    assert slider.toolTip().startswith(means.text())
