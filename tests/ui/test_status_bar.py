"""Region 11, M26: the last event, and every code of 0x2A1 in words."""

from datetime import datetime

import pytest
from PySide6.QtWidgets import QLabel

from armui.control.events import Event
from armui.control.link.link_state import LinkState
from armui.control.link.link_watch import FEEDBACK_LATE
from armui.control.motion.joint_motion import JOGGED
from armui.control.safety.interlocks import SPEED_ZERO
from armui.control.safety.stopping import STOP_UNCONFIRMED
from armui.control.safety.uncommanded_motion import MotionKind, UncommandedMotion, Unheld
from armui.ui.shell.status_bar import StatusBar
from armui.ui.theme import DARK, LIGHT, Theme, apply_theme
from tests.ui.arm_states import NOW_S, arm_state, operating_state

NOON = datetime(2026, 11, 21, 12, 3, 4)


@pytest.fixture
def bar(qtbot, controller):
    bar = StatusBar(controller)
    qtbot.addWidget(bar)
    bar.resize(1280, 32)
    bar.show()
    return bar


def text(bar, name):
    return bar.findChild(QLabel, name).text()


def ink(bar, name):
    label = bar.findChild(QLabel, name)
    return label.palette().color(label.foregroundRole()).name()


def joints(*numbers):
    return tuple(joint in numbers for joint in range(1, 7))


def test_nothing_heard(bar):
    assert text(bar, "status_control") == "Control: —"
    assert text(bar, "status_arm") == "Status: —"
    assert text(bar, "status_mode") == "—"
    assert text(bar, "status_reached") == "—"


def test_codes_in_words(bar, controller):
    controller.be_ready()
    assert text(bar, "status_control") == "Control: CAN commands"
    assert text(bar, "status_arm") == "Status: Normal"
    assert text(bar, "status_mode") == "Joint mode"
    assert text(bar, "status_reached") == "Target reached"
    assert bar.findChild(QLabel, "status_teaching").isHidden()
    assert bar.findChild(QLabel, "status_joints").isHidden()
    assert ink(bar, "status_arm") == LIGHT.text
    sinks = UncommandedMotion(MotionKind.SINKS, Unheld.STOPPED)
    controller.be(operating_state(uncommanded=sinks))
    assert text(bar, "status_reached") == "Target left again"
    controller.be(operating_state())  # it rests elsewhere, and still reports its target as reached
    assert text(bar, "status_reached") == "Target left again"
    controller.be(operating_state(moving=True))
    assert text(bar, "status_reached") == "Target reached"


def test_unknown_codes_keep_their_number(bar, controller):
    controller.be(operating_state())
    controller.hear(arm_state(arm_status=0x2F))
    assert "0x2F" in text(bar, "status_arm")
    assert ink(bar, "status_arm") == LIGHT.stop_ink


@pytest.mark.parametrize(
    ("code", "color"),
    [(0x01, "stop_ink"), (0x07, "stop_ink"), (0x03, "warn"), (0x04, "warn"), (0x0B, "text")],
)
def test_alarms_have_colour_and_sign(bar, controller, code, color):
    controller.be(operating_state())
    controller.hear(arm_state(arm_status=code))
    assert ink(bar, "status_arm") == getattr(LIGHT, color)
    assert bar._status_icon.isVisible() == (color != "text")


def test_teaching_is_shown_while_there_is_any(bar, controller):
    controller.be(operating_state())
    controller.hear(arm_state(teaching=4))
    assert text(bar, "status_teaching") == "Replay paused"
    assert bar.findChild(QLabel, "status_teaching").isVisible()


def test_joints_out_of_order_are_named(bar, controller):
    controller.be(operating_state())
    controller.hear(arm_state(communication_fault=joints(1, 3), limit_exceeded=joints(6)))
    assert text(bar, "status_joints") == "No communication: J1, J3  Beyond limit: J6"
    assert ink(bar, "status_joints") == LIGHT.stop_ink


def test_stale_status_turns_muted(bar, controller):
    controller.be_ready()
    controller.be(operating_state(link=LinkState.OFFLINE))
    assert text(bar, "status_arm") == "Status: Normal"
    assert ink(bar, "status_arm") == LIGHT.muted


def test_status_frame_lost_while_others_arrive(bar, controller):
    controller.be(operating_state())
    old = arm_state(at_s=NOW_S)
    new = arm_state(at_s=NOW_S + 0.6, sequence=2)
    controller.hear(new._replace(status=old.status))
    assert ink(bar, "status_control") == LIGHT.muted


def test_last_notice_with_its_time(bar, controller):
    controller.noticed.emit(Event(NOON, JOGGED, {"joint": 2, "target": 12.0}))
    assert text(bar, "notice_label") == "12:03:04  Sent J2 12°"
    assert not bar._notice_icon.isVisible()
    controller.noticed.emit(Event(NOON, STOP_UNCONFIRMED, {}))
    assert "NOT confirmed" in text(bar, "notice_label")
    assert bar._notice_icon.isVisible()


def test_a_remark_on_the_bus_does_not_wipe_what_matters_more(bar, controller):
    late = Event(NOON, FEEDBACK_LATE, {"value": 300})
    controller.noticed.emit(Event(NOON, JOGGED, {"joint": 2, "target": 12.0}))
    controller.noticed.emit(late)
    assert "arrived late" in text(bar, "notice_label")
    controller.noticed.emit(Event(NOON, STOP_UNCONFIRMED, {}))
    controller.noticed.emit(late)
    assert "NOT confirmed" in text(bar, "notice_label")
    bar.show_problem(SPEED_ZERO())
    controller.noticed.emit(late)
    assert "arrived late" not in text(bar, "notice_label")


def test_the_notice_gives_way_and_the_status_never(bar, controller):
    controller.be(operating_state())
    controller.hear(
        arm_state(
            control_mode=6,
            arm_status=8,
            teaching=7,
            communication_fault=joints(1, 2, 3, 4, 5, 6),
        )
    )
    controller.noticed.emit(Event(NOON, STOP_UNCONFIRMED, {}))
    event = bar.findChild(QLabel, "notice_label")
    assert "NOT confirmed" in event.toolTip()
    for name in ("control", "arm", "mode", "teaching", "reached", "joints"):
        label = bar.findChild(QLabel, f"status_{name}")
        assert label.width() >= label.sizeHint().width(), name
        assert label.geometry().right() <= bar.width(), name


@pytest.mark.parametrize(("theme", "colors"), [(Theme.DARK, DARK), (Theme.LIGHT, LIGHT)])
def test_another_theme_leaves_a_stop_red(bar, controller, qapp, theme, colors):
    controller.be_ready()
    controller.hear(arm_state(arm_status=1))
    for each in (Theme.DARK, Theme.LIGHT, theme):
        apply_theme(qapp, each)
    assert ink(bar, "status_arm") == colors.stop_ink
    apply_theme(qapp, Theme.LIGHT)
