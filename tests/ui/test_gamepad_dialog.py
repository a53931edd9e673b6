"""The window 手柄: switched on, tried, assigned; and what is said without the libraries."""

import json

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from armui.gamepad.layout import JogMode
from armui.settings import SettingsStore
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.gamepad.gamepad_dialog import PIP_COMMAND, AxisRows, GamepadDialog
from tests.gamepad.pads import MOUSE, PAD, Pads
from tests.gamepad.piloting import pass_time

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def pads():
    return Pads()


@pytest.fixture
def dialog(app_driver, pads):
    """Opened by clicks; the gamepads are still off."""
    app_driver.controller.gamepad.make_reader = pads.make
    app_driver.window.pages.show("settings")
    settings = app_driver.dialog(SettingsDialog)
    assert settings._gamepad_state.text() == "Off"
    QTest.mouseClick(settings.gamepad_button, LEFT)
    return app_driver.dialog(GamepadDialog)


def switch_on(app_driver, dialog, pads, *infos):
    for info in infos:
        pads.plug_in(info)
    dialog.on_box.click()
    pass_time(app_driver, 0.02)


def rows(dialog):
    assert isinstance(dialog._axes, AxisRows)
    return dialog._axes


def choose(dialog, action, button):
    box = dialog._buttons._boxes[action]
    place = box.findData(button)
    assert place >= 0
    box.setCurrentIndex(place)
    box.activated.emit(place)


def test_it_is_switched_on_and_off_here_and_kept(app_driver, dialog, pads):
    switch_on(app_driver, dialog, pads, PAD)
    assert app_driver.controller.gamepad.view.on
    assert dialog.device_box.currentText() == PAD.name
    assert SettingsStore(app_driver.store.path).settings.gamepad
    dialog.on_box.click()
    assert not app_driver.controller.gamepad.view.on
    assert pads.ended
    assert not SettingsStore(app_driver.store.path).settings.gamepad


def test_nothing_found_is_said(app_driver, dialog, pads):
    switch_on(app_driver, dialog, pads)
    assert "No device found" in dialog._message.text()
    assert not dialog._axes_card.isVisible()
    pads.plug_in()
    pass_time(app_driver, 0.02)
    assert dialog._axes_card.isVisible()
    assert not dialog._message.isVisible()


def test_without_the_library_the_command_is_said_and_copied(app_driver, dialog, pads):
    pads.missing = ("pysdl2", "hidapi")
    switch_on(app_driver, dialog, pads)
    assert "pysdl2, hidapi" in dialog._message.text()
    assert PIP_COMMAND in dialog._message.text()
    QTest.mouseClick(dialog.copy_button, LEFT)
    assert QApplication.clipboard().text() == 'pip install "armui[gamepad]"'
    assert "armui[gamepad]" in app_driver.read("gamepad_text")


def test_what_cannot_be_used_is_named(app_driver, dialog, pads):
    pads.unusable = ("Strange Pad",)
    pads.problems = ("hidapi: broken",)
    switch_on(app_driver, dialog, pads, PAD)
    assert "Strange Pad" in dialog._message.text()
    assert "hidapi: broken" in dialog._message.text()


def test_axes_and_buttons_are_shown_as_they_are_now(app_driver, dialog, pads):
    switch_on(app_driver, dialog, pads, PAD)
    pads.push(left_x=-0.75, right_trigger=0.5)
    pads.press("a")
    dialog._show_live()
    axes = rows(dialog)
    assert [bar.value for bar in axes._bars] == [0.75, 0, 0, 0, 0, 0]
    assert [label.text() for label in axes._targets] == ["J1", "J2", "J3", "J4", "J5", "J6"]
    assert axes._share.text() == "60 %"
    assert dialog._buttons._down.text() == "Pressed: A / ✕"
    dialog._modes.button(1).click()
    assert app_driver.controller.gamepad.view.mode is JogMode.BASE
    assert app_driver.store.settings.gamepad_mode == "base"
    assert [label.text() for label in rows(dialog)._targets] == ["X", "Y", "Z", "RX", "RY", "RZ"]
    assert [bar.value for bar in rows(dialog)._bars] == [0, 0.75, 0, 0, 0, 0]


def test_nothing_moves_while_it_is_in_front(app_driver, dialog, pads):
    switch_on(app_driver, dialog, pads, PAD)
    pads.press("left_shoulder")
    pads.push(left_x=-1.0)
    pass_time(app_driver, 0.05)
    assert not app_driver.controller.jogging.active
    assert "jogging_joint" not in app_driver.codes()
    assert "refused" not in app_driver.codes()


def test_a_button_is_assigned_for_this_device_and_kept(app_driver, dialog, pads):
    switch_on(app_driver, dialog, pads, PAD, MOUSE)
    choose(dialog, "dead_man", "right_shoulder")
    pilot = app_driver.controller.gamepad
    assert pilot.buttons_of(PAD).dead_man == "right_shoulder"
    assert pilot.buttons_of(MOUSE).dead_man == "1"
    choose(dialog, "halt", "b")  # was the stop's: they change places
    assert (pilot.buttons_of(PAD).stop, pilot.buttons_of(PAD).halt) == ("x", "b")
    kept = json.loads(app_driver.store.path.read_text(encoding="utf-8"))["gamepad_buttons"]
    assert kept == {
        PAD.name: {
            "dead_man": "right_shoulder",
            "stop": "x",
            "halt": "b",
            "mode": "y",
            "episode": "start",
            "discard": "",
        }
    }
    dialog.device_box.setCurrentIndex(1)
    dialog.device_box.activated.emit(1)
    choose(dialog, "mode", "3")
    assert pilot.buttons_of(MOUSE).mode == "3"
    assert pilot.buttons_of(PAD).dead_man == "right_shoulder"
    again = SettingsStore(app_driver.store.path).settings.gamepad_buttons
    assert again[MOUSE.name]["mode"] == "3"


def test_an_action_may_have_no_button_and_takes_none_from_the_stop(app_driver, dialog, pads):
    switch_on(app_driver, dialog, pads, PAD)
    pilot, box = app_driver.controller.gamepad, dialog._buttons._boxes["discard"]
    assert box.currentText() == "No button"
    choose(dialog, "discard", "a")
    assert pilot.buttons_of(PAD).discard == "a"
    choose(dialog, "discard", "")
    assert (pilot.buttons_of(PAD).discard, box.currentText()) == ("", "No button")
    choose(dialog, "discard", "b")  # the stop would have none
    assert (pilot.buttons_of(PAD).stop, pilot.buttons_of(PAD).discard) == ("b", "")
    assert box.currentText() == "No button"
    choose(dialog, "dead_man", "a")
    choose(dialog, "discard", "a")  # and what else was assigned is not lost by it
    assert (pilot.buttons_of(PAD).dead_man, pilot.buttons_of(PAD).discard) == ("a", "")


def test_the_first_buttons_come_back(app_driver, dialog, pads):
    switch_on(app_driver, dialog, pads, PAD)
    choose(dialog, "dead_man", "a")
    dialog._buttons.restore.click()
    assert app_driver.controller.gamepad.buttons_of(PAD).dead_man == "left_shoulder"


def test_a_device_that_goes_takes_its_rows_along(app_driver, dialog, pads):
    switch_on(app_driver, dialog, pads, PAD, MOUSE)
    pads.unplug(PAD)
    pass_time(app_driver, 0.02)
    assert dialog.device_box.currentText() == MOUSE.name
    assert len(rows(dialog)._bars) == 6
    assert not rows(dialog)._trigger.isVisible()


@pytest.mark.parametrize(
    "kept",
    [{"gamepad_buttons": {"Pad": {"dead_man": 3}}}, {"gamepad_buttons": [1]}, {"gamepad": "yes"}],
)
def test_settings_of_no_sense_are_put_right(tmp_path, kept):
    path = tmp_path / "settings.json"
    path.write_text(json.dumps(kept), encoding="utf-8")
    store = SettingsStore(path)
    assert not store.settings.gamepad
    assert store.settings.gamepad_buttons == {}
    assert len(store.problems) == 1
