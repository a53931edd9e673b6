"""运动控制, M8–M11: what a click asks the controller for, and what the operator reads."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QLineEdit, QPushButton

from armui.arm.device import Device
from armui.arm.limits import JOINT_OUT_OF_LIMITS, JointLimits
from armui.arm.state import ArmState
from armui.control.link.link_state import LinkState
from armui.control.safety.interlocks import NOT_ENABLED, STOPPED
from armui.settings import SettingsStore
from armui.ui.panels.jogging.motion_panel import MotionPanel
from armui.ui.widgets.jog_button import JogButton
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import ValueLabel
from armui.ui.widgets.track_slider import TrackSlider
from tests.family import FACTORY_LIMITS
from tests.ui.arm_states import NOW_S, arm_state, operating_state

LEFT = Qt.MouseButton.LeftButton
ANGLES = (10.0, 20.0, -30.0, 40.0, 50.0, -60.0)


@pytest.fixture
def panel(qtbot, controller, tmp_path):
    panel = MotionPanel(controller, SettingsStore(tmp_path / "settings.json"))
    qtbot.addWidget(panel)
    panel.resize(420, 700)
    panel.show()
    return panel


def field(panel, joint) -> QLineEdit:
    return panel.findChild(QLineEdit, f"target_field_{joint}")


def texts(panel):
    return [field(panel, joint).text() for joint in range(1, 7)]


def measured(panel, joint) -> ValueLabel:
    return panel.findChild(ValueLabel, f"measured_{joint}")


def slider(panel, joint) -> TrackSlider:
    return panel.findChild(TrackSlider, f"target_slider_{joint}")


def push(panel, name) -> QPushButton:
    return panel.findChild(QPushButton, name)


def message(panel) -> str:
    return panel.findChild(MessageLine, "motion_message").text()


def type_into(qtbot, line, text):
    line.setFocus()
    line.selectAll()
    qtbot.keyClicks(line, text)


def test_nothing_is_made_up_before_the_arm_is_heard(panel):
    assert texts(panel) == [""] * 6
    assert field(panel, 1).placeholderText() == "—"
    assert [measured(panel, joint).text() for joint in range(1, 7)] == ["—"] * 6
    assert not push(panel, "send_button").isEnabled()
    assert "No arm is connected" in push(panel, "send_button").toolTip()
    assert message(panel) == ""  # the line above the panels says it


def test_fields_follow_the_arm_until_a_target_is_given(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    assert texts(panel) == ["10.000", "20.000", "-30.000", "40.000", "50.000", "-60.000"]
    type_into(qtbot, field(panel, 2), "90")
    controller.hear(arm_state((11.0,) * 6, sequence=2))
    assert texts(panel) == ["11.000", "90", *["11.000"] * 4]
    assert measured(panel, 2).text() == "11.000°"
    qtbot.mouseClick(push(panel, "send_button"), LEFT)
    assert controller.calls == [("send_joints", (11.0, 90.0, 11.0, 11.0, 11.0, 11.0))]


def test_a_field_about_to_be_typed_over_stays_so_while_it_follows(panel, controller):
    controller.be_ready(ANGLES)
    field(panel, 1).setFocus()
    field(panel, 1).selectAll()
    controller.hear(arm_state((11.0,) * 6, sequence=2))
    assert field(panel, 1).selectedText() == "11.000"


def test_send_is_lit_while_there_is_something_to_send(panel, controller, qtbot):
    def lit():
        return bool(push(panel, "send_button").property("primary"))

    controller.be_ready(ANGLES)
    assert not lit()
    type_into(qtbot, field(panel, 2), "90")
    assert lit()
    type_into(qtbot, field(panel, 2), "20")
    assert not lit()
    type_into(qtbot, field(panel, 2), "90")
    qtbot.mouseClick(push(panel, "send_button"), LEFT)
    controller.hear(arm_state((10.0, 90.0, -30.0, 40.0, 50.0, -60.0), sequence=2))
    assert not lit()
    controller.hear(arm_state((0.0,) * 6, sequence=3))  # somebody else moved it
    assert not lit()
    assert texts(panel) == ["0.000"] * 6


def test_angles_taken_are_no_targets(panel, controller, qtbot):
    """An arm that somebody else moves then is not sent back by Send."""
    controller.be_ready(ANGLES)
    type_into(qtbot, field(panel, 1), "12")
    qtbot.mouseClick(push(panel, "load_button"), LEFT)
    assert texts(panel)[0] == "10.000"
    controller.hear(arm_state((11.0,) * 6, sequence=2))
    assert texts(panel)[0] == "11.000"
    assert not any(panel.given())
    assert not push(panel, "send_button").property("primary")


def test_fields_with_no_figure_are_not_sent(panel, controller, qtbot):
    controller.be(operating_state())
    qtbot.mouseClick(push(panel, "send_button"), LEFT)
    assert controller.calls == []
    assert "not been heard" in message(panel) or "angles" in message(panel)


def test_send_sends_the_six_fields(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    type_into(qtbot, field(panel, 2), "25,5")
    qtbot.mouseClick(push(panel, "send_button"), LEFT)
    assert controller.calls == [("send_joints", (10.0, 25.5, -30.0, 40.0, 50.0, -60.0))]


def test_enter_commits_and_does_not_send(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    type_into(qtbot, field(panel, 1), "12.3456")
    qtbot.keyClick(field(panel, 1), Qt.Key.Key_Return)
    assert field(panel, 1).text() == "12.346"
    assert controller.calls == []


def test_escape_brings_the_figure_back(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    type_into(qtbot, field(panel, 1), "99")
    qtbot.keyClick(field(panel, 1), Qt.Key.Key_Escape)
    assert field(panel, 1).text() == "10.000"
    assert slider(panel, 1).requested == pytest.approx(10.0)


def test_arrow_keys_turn_the_figure_by_the_step(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    qtbot.keyClick(field(panel, 1), Qt.Key.Key_Up)
    qtbot.keyClick(field(panel, 2), Qt.Key.Key_Down)
    assert texts(panel)[:2] == ["11.000", "19.000"]
    assert controller.calls == []


def test_slider_changes_the_field_only(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    slider(panel, 1).setFocus()
    qtbot.keyClick(slider(panel, 1), Qt.Key.Key_Right)
    assert field(panel, 1).text() == "11.000"
    assert controller.calls == []


def test_load_takes_the_measured_angles(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    controller.hear(arm_state((1.0, 2.0, -3.0, 4.0, 5.0, 6.0), sequence=2))
    qtbot.mouseClick(push(panel, "load_button"), LEFT)
    assert texts(panel) == ["1.000", "2.000", "-3.000", "4.000", "5.000", "6.000"]
    assert controller.calls == []


def test_home_asks_for_zero(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    qtbot.mouseClick(push(panel, "home_button"), LEFT)
    assert controller.calls == [("go_home",)]


@pytest.mark.parametrize(
    ("key", "call"),
    [
        ("Ctrl+Return", ("send_joints", ANGLES)),
        ("Ctrl+Shift+H", ("go_home",)),
    ],
)
def test_shortcuts_work_while_a_field_is_edited(panel, controller, qtbot, key, call):
    controller.be_ready(ANGLES)
    panel.activateWindow()
    qtbot.waitUntil(panel.isActiveWindow)
    qtbot.keySequence(field(panel, 1), key)
    qtbot.waitUntil(lambda: controller.calls == [call])


@pytest.mark.parametrize(("sign", "delta"), [("minus", -1.0), ("plus", 1.0)])
@pytest.mark.parametrize("joint", range(1, 7))
def test_jog_moves_at_once_and_takes_the_target_along(panel, controller, qtbot, joint, sign, delta):
    controller.be_ready(ANGLES)
    qtbot.mousePress(push(panel, f"jog_{sign}_{joint}"), LEFT)
    qtbot.mouseRelease(push(panel, f"jog_{sign}_{joint}"), LEFT)
    assert controller.calls == [("jog", joint, delta)]
    expected = list(ANGLES)
    expected[joint - 1] += delta
    assert texts(panel) == [f"{angle:.3f}" for angle in expected]


def test_refused_jog_leaves_the_field_and_says_why(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    controller.answer = NOT_ENABLED(joints="1, 3")
    qtbot.mouseClick(push(panel, "jog_plus_1"), LEFT)
    assert texts(panel)[0] == "10.000"
    assert "1, 3" in message(panel)


def test_jog_step_can_be_chosen(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    box = panel.findChild(QComboBox, "jog_step")
    assert [box.itemText(i) for i in range(box.count())] == [
        "0.1°",
        "1°",
        "5°",
        "10°",
        "Continuous",
    ]
    box.setCurrentIndex(3)
    qtbot.mouseClick(push(panel, "jog_minus_6"), LEFT)
    assert controller.calls == [("jog", 6, -10.0)]
    panel.set_jog_step(2.5)
    assert box.currentText() == "2.5°"
    assert box.count() == 6


def test_held_button_repeats_until_let_go(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    button = panel.findChild(JogButton, "jog_plus_1")
    qtbot.mousePress(button, LEFT)
    qtbot.waitUntil(lambda: len(controller.calls) >= 3)
    qtbot.mouseRelease(button, LEFT)
    assert set(controller.calls) == {("jog", 1, 1.0)}
    assert not button._timer.isActive()


def test_held_button_waits_for_a_lagging_arm(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    controller.motion.lagging = True
    button = panel.findChild(JogButton, "jog_plus_1")
    qtbot.mousePress(button, LEFT)
    with qtbot.waitSignal(button.repeated):
        pass
    assert controller.calls == [("jog", 1, 1.0)]
    controller.motion.lagging = False
    qtbot.waitUntil(lambda: len(controller.calls) == 2)
    qtbot.mouseRelease(button, LEFT)


def test_a_button_disabled_while_held_goes_no_further(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    button = panel.findChild(JogButton, "jog_plus_1")
    qtbot.mousePress(button, LEFT)
    controller.be(operating_state(cannot_move=STOPPED()))
    button._on_timeout()
    assert controller.calls == [("jog", 1, 1.0)]
    assert not button._timer.isActive()
    qtbot.mouseRelease(button, LEFT)


def test_out_of_limits_is_marked_said_and_left_to_the_controller(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    type_into(qtbot, field(panel, 2), "200")
    assert field(panel, 2).text() == "200"
    assert field(panel, 2).property("attention")
    assert "200" in message(panel)
    assert "180" in message(panel)
    controller.answer = JOINT_OUT_OF_LIMITS(joint=2, value=200.0, minimum=0.0, maximum=180.0)
    qtbot.mouseClick(push(panel, "send_button"), LEFT)
    assert controller.calls[-1][1][1] == 200.0
    assert "180" in message(panel)
    type_into(qtbot, field(panel, 2), "90")
    assert not field(panel, 2).property("attention")
    assert message(panel) == ""


def test_nonsense_is_marked_and_not_sent(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    type_into(qtbot, field(panel, 4), "fast")
    assert field(panel, 4).property("attention")
    qtbot.mouseClick(push(panel, "send_button"), LEFT)
    assert controller.calls == []
    assert "fast" in message(panel)


def test_limits_of_the_arm_replace_the_factory_s(panel, controller, qtbot):
    controller.be_ready(ANGLES)
    narrow = (JointLimits(-5.0, 5.0, 100.0), *FACTORY_LIMITS[1:])
    controller.be(operating_state(limits=narrow))
    assert field(panel, 1).property("attention")
    assert slider(panel, 1).maximum() == 5000


def test_factory_limits_say_that_they_are(panel, controller):
    controller.be(operating_state(limits_read=(False,) * 6))
    assert "Factory limits" in slider(panel, 1).toolTip()
    controller.be(operating_state())
    assert "Limits read from the arm" in slider(panel, 1).toolTip()


def test_the_measured_angles_stand_beside_the_targets_only_where_the_picture_has_none(panel):
    assert not measured(panel, 1).isHidden()
    panel.show_measured_figures(wanted=False)
    assert measured(panel, 1).isHidden()
    panel.show_measured_figures(wanted=True)
    assert not measured(panel, 1).isHidden()


def test_what_cannot_be_used_says_why(panel, controller):
    controller.be_ready(ANGLES)
    assert push(panel, "send_button").isEnabled()
    controller.be(operating_state(cannot_move=STOPPED()))
    for name in ("send_button", "home_button", "jog_plus_1", "jog_minus_6"):
        assert not push(panel, name).isEnabled()
        assert "emergency stop" in push(panel, name).toolTip()
    assert message(panel) == ""  # the line above the panels says it
    assert push(panel, "load_button").isEnabled()
    controller.be(operating_state())
    assert message(panel) == ""
    assert "Ctrl+Return" in push(panel, "send_button").toolTip()


def test_stale_angles_turn_muted(panel, controller):
    controller.be_ready(ANGLES)
    assert not measured(panel, 1).is_stale()
    controller.be(operating_state(link=LinkState.OFFLINE))
    assert measured(panel, 1).is_stale()
    assert measured(panel, 1).text() == "10.000°"
    assert slider(panel, 1).measured is None


def test_one_joint_not_heard_any_more_is_stale_alone(panel, controller):
    controller.be_ready(ANGLES)
    old, new = arm_state(ANGLES), arm_state(ANGLES, at_s=NOW_S + 1.0, sequence=2)
    mixed = (*new.joints_deg[:5], old.joints_deg[5])
    controller.hear(new._replace(joints_deg=mixed))
    assert [measured(panel, joint).is_stale() for joint in range(1, 7)] == [False] * 5 + [True]


def test_another_arm_gets_fields_of_its_own(panel, controller):
    controller.be_ready(ANGLES)
    other = Device("virtual", "other", simulated=True, generation=2)
    controller.hear(ArmState())
    controller.be(operating_state(device=other))
    assert texts(panel) == [""] * 6
    controller.hear(arm_state((1.0,) * 6, sequence=2))
    assert texts(panel)[0] == "1.000"


def test_typed_figures_are_not_overwritten_by_the_first_angles(panel, controller, qtbot):
    controller.be(operating_state())
    type_into(qtbot, field(panel, 1), "5")
    controller.hear(arm_state(ANGLES))
    assert texts(panel) == ["5", "20.000", "-30.000", "40.000", "50.000", "-60.000"]


def test_a_hidden_panel_does_no_work_and_catches_up(panel, controller):
    panel.hide()
    controller.be_ready(ANGLES)
    assert measured(panel, 1).text() == "—"
    panel.show()
    assert measured(panel, 1).text() == "10.000°"
    assert texts(panel)[0] == "10.000"
