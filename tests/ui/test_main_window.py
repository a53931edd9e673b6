"""The window as a whole: wiring, settings, language, closing."""

import time
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QLabel,
    QLineEdit,
    QPushButton,
    QSlider,
    QSpinBox,
    QToolButton,
    QWidget,
)

from armui.arm.models import robot_description
from armui.arm.state import ArmState
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState
from armui.interface.interface import Interface
from armui.live.live_stream import LiveStream
from armui.protocol.generation import PiperModel
from armui.settings import SettingsStore
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.main_window import MainWindow
from armui.ui.panels.jogging.motion_panel import MotionPanel
from armui.ui.panels.light_panel import LightPanel
from armui.ui.shell.operation_area import OperationArea
from armui.ui.theme import LIGHT, Theme, apply_theme
from armui.ui.translation import Translator
from armui.viewport import palette
from armui.viewport.camera import ViewDirection
from armui.viewport.process.urdf_file import MESH_EMPTY
from tests.app_driver import AtOnce
from tests.ui.arm_states import arm_state, operating_state
from tests.ui.dialog_reading import message
from tests.ui.fake_view import FakeView

LEFT = Qt.MouseButton.LeftButton
NAMED = [
    "stop_button",
    "enable_button",
    "communication_button",
    "speed_slider",
    "speed_field",
    "send_button",
    "load_button",
    "home_button",
    "motion_message",
    "status_control",
    "status_arm",
    "status_mode",
    "status_reached",
    "notice_label",
    "menu_motion",
    "joint_status_button",
    "menu_light",
    "lamp_field",
    "all_lamps",
    "pick_color_button",
    "effect_strip",
    "light_confirm_button",
    "light_message",
    "recovery_text",
    "recovery_button",
    "menu_teaching",
    "teaching_state",
    "teaching_phase",
    "teaching_message",
    "teaching_start_recording",
    "plan_pause",
    "teaching_exit_steps",
    *(f"light_joint_{joint}" for joint in range(1, 7)),
    *(
        f"{panel}_{name}"
        for panel in ("joint_settings", "end_limits", "collision")
        for name in ("read_button", "edit_button", "cancel_button", "save_button", "message")
    ),
    "menu_joint_settings",
    "menu_end_limits",
    "menu_collision",
    "max_angle_deg_1",
    "max_acceleration_deg_s2_6_note",
    "max_linear_speed_m_s",
    "collision_level_1_level_8",
    "collision_all_level_0",
    *(f"{color}_{kind}" for color in ("red", "green", "blue") for kind in ("field", "slider")),
    "help_button",
    "reset_view_button",
    "settings_button",
    *(
        f"{name}_{joint}"
        for name in ("jog_minus", "jog_plus", "target_field", "target_slider", "measured")
        for joint in range(1, 7)
    ),
]


@pytest.fixture
def store(tmp_path):
    return SettingsStore(tmp_path / "settings.json")


@pytest.fixture
def view():
    return FakeView()


@pytest.fixture
def interface(controller, tmp_path):
    return Interface(controller, tmp_path / "api.sock", time.monotonic)


@pytest.fixture
def live(controller):
    return LiveStream(controller, time.monotonic)


@pytest.fixture
def window(qtbot, controller, view, store, interface, live):
    window = MainWindow(controller, view, store, AtOnce(), interface=interface, live=live)
    qtbot.addWidget(window, before_close_func=lambda window: setattr(window, "_may_close", True))
    window.resize(1280, 800)
    window.show()
    return window


@pytest.fixture
def whole_window(window):
    """With every panel in it."""
    area = window.findChild(OperationArea, "operation_area")
    for place in [*range(area.count()), 0]:
        area.show_panel(place)
    return window


def test_what_a_test_clicks_has_one_name(whole_window):
    counts = {name: len(whole_window.findChildren(QWidget, name)) for name in NAMED}
    assert {name: count for name, count in counts.items() if count != 1} == {}


def test_a_panel_is_made_when_it_is_first_shown(window, qtbot):
    area = window.findChild(OperationArea, "operation_area")
    assert len(area.panels) == 1
    qtbot.mouseClick(window.findChild(QWidget, "menu_light"), LEFT)
    assert [type(panel) for panel in area.panels] == [MotionPanel, LightPanel]
    first = area.currentWidget()
    qtbot.mouseClick(window.findChild(QWidget, "menu_motion"), LEFT)
    qtbot.mouseClick(window.findChild(QWidget, "menu_light"), LEFT)
    assert area.currentWidget() is first


def test_every_control_has_an_accessible_name(whole_window):
    window = whole_window
    controls = [
        control
        for kind in (QAbstractButton, QLineEdit, QSlider, QSpinBox)
        for control in window.findChildren(kind)
        if control.objectName() and not control.objectName().startswith("qt_")
    ]
    assert len(controls) > 30
    assert [control.objectName() for control in controls if not control.accessibleName()] == []


def test_the_stop_is_the_largest_control_of_its_bar(window):
    def area(name):
        size = window.findChild(QWidget, name).size()
        return size.width() * size.height()

    others = ("communication_button", "enable_button", "speed_field", "speed_slider")
    assert all(area("stop_button") > area(name) for name in others)


def test_the_arm_reaches_the_3d_view(controller, view, window):
    assert not view.joints
    controller.be_ready((1.0, 2.0, -3.0, 4.0, 5.0, 6.0))
    assert view.joints == ((1.0, 2.0, -3.0, 4.0, 5.0, 6.0), None, False)
    assert view.pose == ((56.128, 0.0, 213.266, 0.0, 85.0, 0.0), False)
    controller.be(operating_state(link=LinkState.OFFLINE))
    assert view.joints[2]
    assert view.pose[1]


def test_a_hidden_window_does_no_work_and_catches_up(controller, view, window):
    window.hide()
    controller.be_ready((9.0,) * 6)
    assert not view.joints
    window.show()
    assert view.joints[0] == (9.0,) * 6


def test_the_view_chosen_last_is_the_first_one(qtbot, controller, store, interface, live):
    store.change(picture_direction="side", picture_orthographic=True, picture_tool_frame=False)
    view: Any = FakeView()
    window = MainWindow(controller, view, store, AtOnce(), interface=interface, live=live)
    qtbot.addWidget(window, before_close_func=lambda window: setattr(window, "_may_close", True))
    assert view.looked_from == [ViewDirection.SIDE]
    assert (view.orthographic, view.tool_frame) == (True, False)


def test_the_range_of_a_joint_is_shown_while_its_row_has_the_keyboard(window, view, qtbot):
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    window.findChild(QLineEdit, "target_field_3").setFocus()
    assert view.joint_range == (3, (-170.0, 0.0))
    window.setFocus()
    assert view.joint_range is None


def test_reset_view(window, view, qtbot):
    qtbot.mouseClick(window.findChild(QAbstractButton, "reset_view_button"), LEFT)
    assert view.resets == 1


def test_a_link_picked_in_3d_leads_to_its_joint(window, view, qtbot):
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    view.joint_picked.emit(4)
    assert window.focusWidget().objectName() == "target_field_4"


def test_the_icon_of_the_chosen_panel_has_the_accent_colour(window, qtbot):
    def accented(key):
        picture = window.findChild(QToolButton, f"menu_{key}").icon().pixmap(20, 20).toImage()
        seen = {
            picture.pixelColor(x, y).name()
            for x in range(picture.width())
            for y in range(picture.height())
            if picture.pixelColor(x, y).alpha() == 255
        }
        return LIGHT.accent in seen

    assert (accented("motion"), accented("light")) == (True, False)
    qtbot.mouseClick(window.findChild(QToolButton, "menu_light"), LEFT)
    assert (accented("motion"), accented("light")) == (False, True)


def test_a_robot_that_cannot_be_loaded_is_said(window, view):
    view.load_failed.emit(MESH_EMPTY(mesh="hand.stl"))
    said = window.findChild(QLabel, "notice_label").text()
    assert said.endswith("the mesh hand.stl holds no surface. Export it again.")


def test_a_robot_chosen_in_the_settings_that_cannot_be_loaded_is_said_there(window, view):
    window.pages.show("settings")
    dialog = window.findChild(SettingsDialog)
    view.load_failed.emit(MESH_EMPTY(mesh="hand.stl"))
    assert "hand.stl" in message(dialog)
    dialog.close()


@pytest.mark.parametrize(
    ("button", "dialog"),
    [
        ("communication_button", "ConnectDialog"),
        ("help_button", "GuidePage"),
        ("settings_button", "SettingsDialog"),
    ],
)
def test_dialogs_and_pages_open_once(window, qtbot, button, dialog):
    for _ in range(2):
        qtbot.mouseClick(window.findChild(QAbstractButton, button), LEFT)
    shown = [
        child
        for child in window.findChildren(QWidget)
        if type(child).__name__ == dialog and child.isVisible()
    ]
    assert len(shown) == 1
    shown[0].close()


def test_settings_reach_the_window(window, store, view, controller, qtbot):
    controller.be_ready()
    store.change(jog_step_deg=2.5)
    qtbot.mouseClick(window.findChild(QPushButton, "jog_plus_3"), LEFT)
    assert controller.calls == [("jog", 3, 2.5)]
    store.change(urdf_path="/robots/other.urdf")
    assert view.robot == Path("/robots/other.urdf")
    store.change(urdf_path=None)
    assert view.robot == robot_description(PiperModel.PIPER)


def test_the_view_takes_the_theme(qapp, window, view):
    assert view.palette_shown is palette.LIGHT
    apply_theme(qapp, Theme.DARK)
    assert view.palette_shown is palette.DARK
    apply_theme(qapp, Theme.LIGHT)
    assert view.palette_shown is palette.LIGHT


def test_language_changes_while_running(qapp, window):
    send = window.findChild(QPushButton, "send_button")
    translator = Translator(qapp)
    assert send.text() == "Send"
    translator.set_language("zh")
    qapp.processEvents()
    try:
        shown = {
            name: window.findChild(QAbstractButton, name).text().strip()
            for name in (
                "home_button",
                "load_button",
                "send_button",
                "stop_button",
                "menu_motion",
                "help_button",
                "reset_view_button",
                "settings_button",
                "communication_button",
            )
        }
        assert list(shown.values()) == [
            "回零",
            "装载",
            "发送",
            "急停",
            "运动控制",
            "使用帮助",
            "视角还原",
            "设置",
            "未连接",
        ]
        assert send.shortcut().toString() == "Ctrl+Return"
    finally:
        translator.set_language("en")
    qapp.processEvents()
    assert send.text() == "Send"


@pytest.mark.parametrize("panel", ["motion", "light"])
@pytest.mark.parametrize("language", ["zh", "en"])
def test_nothing_is_cut_off_at_1280_by_800(qapp, window, controller, qtbot, language, panel):
    translator = Translator(qapp)
    translator.set_language(language)
    controller.be_ready()
    qtbot.mouseClick(window.findChild(QAbstractButton, f"menu_{panel}"), LEFT)
    for _ in range(2):  # the layouts within others follow a round later
        qapp.processEvents()
    try:
        cut = [
            button.objectName()
            for button in window.findChildren(QAbstractButton)
            if button.isVisible()
            and button.objectName() in NAMED
            and button.width() < button.fontMetrics().horizontalAdvance(button.text())
        ]
        assert cut == []
        assert window.size().toTuple() == (1280, 800)
        message = window.findChild(QWidget, f"{panel}_message")
        bottom = message.mapTo(window, message.rect().bottomLeft()).y()
        assert bottom < window.findChild(QWidget, "status_bar").geometry().top() + 1
    finally:
        translator.set_language("en")
        qapp.processEvents()


def questions(window):
    return [child for child in window.findChildren(ConfirmDialog) if child.isVisible()]


def test_closing_while_the_arm_moves_asks(window, controller, qtbot):
    controller.be(operating_state(moving=True))
    assert not window.close()
    (question,) = questions(window)
    assert "does not stop" in question.text()
    qtbot.mouseClick(question.cancel_button, LEFT)
    assert window.isVisible()
    window.close()
    qtbot.mouseClick(questions(window)[0].action_button, LEFT)
    assert not window.isVisible()


def test_closing_at_rest_just_closes(window, controller):
    controller.be(operating_state())
    controller.hear(arm_state())
    assert window.close()
    assert not questions(window)


@pytest.mark.parametrize(
    "state", [operating_state(link=LinkState.LOST), operating_state(), OperatingState()]
)
def test_an_arm_whose_angles_are_not_known_stays_where_it_was_seen_last(
    controller, view, window, state
):
    """The cable is out, it has come back and is being asked who it is, the device is closed."""
    controller.be_ready((1.0, 2.0, -3.0, 4.0, 5.0, 6.0))
    controller.be(state)
    controller.hear(ArmState())
    assert view.joints is None  # not sent to its zeros
