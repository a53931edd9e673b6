"""灯光控制, M12: picking a colour, what the operator reads, what the controller is asked."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QAbstractButton, QColorDialog, QLineEdit, QSlider, QSpinBox, QWidget

from armui.arm.refusal import Refusal
from armui.control.link.link_state import LINK_LOST, LinkState
from armui.protocol.codes import ALL_LAMPS
from armui.ui.panels.light_panel import ColorStrip, LightPanel
from armui.ui.translation import Translator
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.stop_button import StopButton
from tests.ui.arm_states import operating_state

LEFT = Qt.MouseButton.LeftButton
CHANNELS = ("red", "green", "blue")


@pytest.fixture
def panel(qtbot, controller):
    panel = LightPanel(controller)
    qtbot.addWidget(panel)
    panel.resize(420, 690)
    panel.show()
    controller.be(operating_state())
    return panel


def button(panel, name) -> QAbstractButton:
    return panel.findChild(QAbstractButton, name)


def field(panel, name) -> QLineEdit:
    return panel.findChild(QLineEdit, f"{name}_field")


def slider(panel, name) -> QSlider:
    return panel.findChild(QSlider, f"{name}_slider")


def texts(panel):
    return [field(panel, name).text() for name in CHANNELS]


def message(panel) -> str:
    return panel.findChild(MessageLine, "light_message").text()


def strip(panel) -> ColorStrip:
    return panel.findChild(ColorStrip, "effect_strip")


def pixel(widget: QWidget, place: QPoint) -> str:
    return widget.grab().toImage().pixelColor(place).name()


def type_into(qtbot, line, text):
    line.setFocus()
    line.selectAll()
    qtbot.keyClicks(line, text)


def open_picker(qtbot, panel) -> QColorDialog:
    qtbot.mouseClick(button(panel, "pick_color_button"), LEFT)
    return panel.window().findChild(QColorDialog)


def shown_buttons(widget) -> list[QAbstractButton]:
    return [each for each in widget.findChildren(QAbstractButton) if each.isVisible()]


def confirm(qtbot, panel):
    qtbot.mouseClick(button(panel, "light_confirm_button"), LEFT)


# What is sent -------------------------------------------------------------------------------------


def test_all_lamps_of_the_first_joint_are_chosen_at_first(panel, controller, qtbot):
    confirm(qtbot, panel)
    assert controller.calls == [("set_light", 1, ALL_LAMPS, 255, 255, 255)]


def test_joint_lamp_and_channels_as_chosen(panel, controller, qtbot):
    qtbot.mouseClick(button(panel, "light_joint_4"), LEFT)
    qtbot.mouseClick(button(panel, "all_lamps"), LEFT, pos=QPoint(8, 10))
    type_into(qtbot, field(panel, "lamp"), "254")
    for name, text in zip(CHANNELS, ("12", "0", "200"), strict=True):
        type_into(qtbot, field(panel, name), text)
    assert controller.calls == []
    confirm(qtbot, panel)
    assert controller.calls == [("set_light", 4, 254, 12, 0, 200)]


def test_the_key_confirms_while_a_field_is_edited(panel, controller, qtbot):
    panel.activateWindow()
    qtbot.waitUntil(panel.isActiveWindow)
    type_into(qtbot, field(panel, "green"), "7")
    qtbot.keySequence(field(panel, "green"), "Ctrl+Return")
    qtbot.waitUntil(lambda: controller.calls == [("set_light", 1, ALL_LAMPS, 255, 7, 255)])


# Three ways to one colour -------------------------------------------------------------------------


def test_a_typed_colour_is_on_the_strip_the_sliders_and_the_picker(panel, qtbot):
    for name, text in zip(CHANNELS, ("255", "128", "0"), strict=True):
        type_into(qtbot, field(panel, name), text)
    assert [slider(panel, name).value() for name in CHANNELS] == [255, 128, 0]
    assert strip(panel).text() == "#FF8000"
    assert pixel(strip(panel), QPoint(20, 10)) == "#ff8000"
    picker = open_picker(qtbot, panel)
    assert picker.currentColor().name() == "#ff8000"
    type_into(qtbot, field(panel, "blue"), "255")
    assert picker.currentColor().name() == "#ff80ff"
    type_into(qtbot, field(panel, "blue"), "pink")
    assert picker.currentColor().name() == "#ff80ff"


@pytest.mark.parametrize("name", CHANNELS)
def test_a_slider_moves_its_own_field(panel, qtbot, name):
    slider(panel, name).setFocus()
    qtbot.keyClick(slider(panel, name), Qt.Key.Key_Left)
    assert field(panel, name).text() == "254"
    assert sorted(texts(panel)) == ["254", "255", "255"]
    assert strip(panel).text().count("FE") == 1


def test_picking_fills_the_fields_and_the_strip(panel, controller, qtbot):
    picker = open_picker(qtbot, panel)
    hue, saturation, value = picker.findChildren(QSpinBox)[:3]
    hue.setValue(180)
    saturation.setValue(255)
    value.setValue(255)
    assert texts(panel) == ["0", "255", "255"]
    assert strip(panel).text() == "#00FFFF"
    assert pixel(strip(panel), QPoint(20, 10)) == "#00ffff"
    assert slider(panel, "red").value() == 0
    assert controller.calls == []


def test_a_colour_turned_dark_in_the_picker_comes_back_bright(panel, qtbot):
    for name, text in zip(CHANNELS, ("0", "255", "255"), strict=True):
        type_into(qtbot, field(panel, name), text)
    value = open_picker(qtbot, panel).findChildren(QSpinBox)[2]
    value.setValue(0)
    assert texts(panel) == ["0", "0", "0"]
    assert strip(panel).text() == "#000000"
    value.setValue(255)
    assert texts(panel) == ["0", "255", "255"]


def test_the_picker_stands_beside_the_stop_and_grabs_nothing(panel, qtbot):
    picker = open_picker(qtbot, panel)
    dialog = picker.window()
    assert dialog is not panel.window()
    assert not dialog.isModal()
    assert dialog.findChild(StopButton).isVisible()
    assert dialog.findChild(HaltButton).isVisible()
    assert picker.testOption(QColorDialog.ColorDialogOption.NoEyeDropperButton)
    assert picker.testOption(QColorDialog.ColorDialogOption.DontUseNativeDialog)
    assert not any("Pick Screen" in each.text() for each in shown_buttons(picker))


def test_escape_in_the_picker_closes_its_window_and_it_opens_again(panel, qtbot):
    picker = open_picker(qtbot, panel)
    dialog = picker.window()
    qtbot.keyClick(picker, Qt.Key.Key_Escape)
    assert not dialog.isVisible()
    assert open_picker(qtbot, panel) is picker
    assert picker.isVisible()
    qtbot.keyClick(picker, Qt.Key.Key_Return)
    assert picker.isVisible()


# What is wrong is said ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("red", "256", "R channel: 256 is out of range. Enter a whole number from 0 to 255."),
        ("green", "-1", "G channel: -1 is out of range"),
        ("blue", "12.5", "B channel: “12.5” is not a whole number. Enter one from 0 to 255."),
        ("blue", "pink", "B channel: “pink” is not a whole number"),
        ("red", " ", "R channel: “—” is not a whole number"),
    ],
)
def test_a_wrong_grey_value_is_kept_marked_and_said(panel, qtbot, name, text, said):
    type_into(qtbot, field(panel, name), text)
    assert field(panel, name).text() == text
    assert field(panel, name).property("attention")
    assert said in message(panel)
    assert strip(panel).text() == "—"
    type_into(qtbot, field(panel, name), "9")
    assert not field(panel, name).property("attention")
    assert message(panel) == ""


def test_what_is_no_number_is_not_sent(panel, controller, qtbot):
    type_into(qtbot, field(panel, "red"), "pink")
    confirm(qtbot, panel)
    assert controller.calls == []
    assert "pink" in message(panel)


def test_a_wrong_lamp_is_said_unless_all_are_chosen(panel, qtbot):
    tick = button(panel, "all_lamps")
    assert not field(panel, "lamp").isEnabled()
    assert "Every lamp" in field(panel, "lamp").toolTip()
    qtbot.mouseClick(tick, LEFT, pos=QPoint(8, 10))
    assert field(panel, "lamp").toolTip() == "Lamp number: 0–254"
    type_into(qtbot, field(panel, "lamp"), "300")
    assert message(panel) == (
        "Lamp number: 300 is out of range. Enter a whole number from 0 to 254."
    )
    assert field(panel, "lamp").property("attention")
    qtbot.mouseClick(tick, LEFT, pos=QPoint(8, 10))
    assert message(panel) == ""
    assert not field(panel, "lamp").property("attention")


@pytest.mark.parametrize(
    ("link", "said"),
    [
        (LinkState.NO_DEVICE, "No arm is connected"),
        (LinkState.OPENING, "No arm is connected"),
        (LinkState.OFFLINE, "nothing is heard"),
        (LinkState.LOST, "device is gone"),
    ],
)
def test_without_an_arm_the_button_says_why(panel, controller, qtbot, link, said):
    controller.be(operating_state(link=link))
    assert not button(panel, "light_confirm_button").isEnabled()
    assert said in button(panel, "light_confirm_button").toolTip()
    assert message(panel) == ""  # the line above the panels says it
    confirm(qtbot, panel)
    assert controller.calls == []
    controller.be(operating_state())
    assert button(panel, "light_confirm_button").isEnabled()
    assert "Ctrl+Return" in button(panel, "light_confirm_button").toolTip()
    assert message(panel) == ""


@pytest.mark.parametrize("reason", ["stopped", "busy", "not_enabled"])
def test_what_hinders_motion_does_not_hinder_light(panel, controller, qtbot, reason):
    refusal = Refusal(reason, {"joints": "1"})
    controller.be(operating_state(cannot_move=refusal, cannot_enable=refusal))
    confirm(qtbot, panel)
    assert len(controller.calls) == 1


def test_the_controllers_no_is_shown_until_something_is_changed(panel, controller, qtbot):
    controller.answer = LINK_LOST()
    confirm(qtbot, panel)
    assert "device is gone" in message(panel)
    qtbot.mouseClick(button(panel, "light_joint_2"), LEFT)
    assert message(panel) == ""


def test_nothing_here_is_passed_off_as_measured(panel):
    note = panel.findChild(QWidget, "light_note").text()
    assert "no feedback" in note
    assert "lamp board" in note


# Language -----------------------------------------------------------------------------------------


def test_the_manuals_labels_to_the_letter_and_the_values_kept(qapp, panel, qtbot):
    type_into(qtbot, field(panel, "red"), "300")
    translator = Translator(qapp)
    translator.set_language("zh")
    qapp.processEvents()
    try:
        shown = [label.text() for label in panel.findChildren(QWidget) if hasattr(label, "text")]
        for label in ("灯光控制", "关节序号", "灯珠序号", "R 通道", "G 通道", "B 通道"):
            assert label in shown
        for label in ("效果", "确认", "全部"):
            assert label in shown
        assert message(panel) == "R 通道：300 超出范围。请输入 0 至 255 的整数。"
        assert texts(panel) == ["300", "255", "255"]
        assert button(panel, "light_confirm_button").shortcut().toString() == "Ctrl+Return"
    finally:
        translator.set_language("en")
    qapp.processEvents()
    assert "R channel: 300" in message(panel)
