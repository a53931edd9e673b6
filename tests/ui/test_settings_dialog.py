"""The window 设置, by clicks and keys (M21)."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLineEdit
from pytestqt.qtbot import QtBot

from armui.arm.model_check import ModelFit
from armui.protocol.generation import PiperModel
from armui.settings import SettingsStore
from armui.ui.dialogs.files import FileDialog
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.widgets.text_label import ElidedLabel
from armui.viewport.process.urdf_file import URDF_JOINT_COUNT
from tests.moments import now
from tests.ui.arm_states import operating_state
from tests.ui.dialog_reading import message, shown, words_of
from tests.ui.fake_controller import FakeController

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def store(tmp_path: Path) -> SettingsStore:
    return SettingsStore(tmp_path / "settings.json")


@pytest.fixture
def preferences(qtbot: QtBot, controller: FakeController, store: SettingsStore) -> SettingsDialog:
    dialog = SettingsDialog(store, controller.as_real)
    shown(qtbot, dialog)
    return dialog


def retype(qtbot: QtBot, field: QLineEdit, text: str) -> None:
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, text)
    qtbot.keyClick(field, Qt.Key.Key_Return)


def test_language_and_theme_hold_at_once(
    qtbot: QtBot, preferences: SettingsDialog, store: SettingsStore
) -> None:
    assert preferences.language_box.currentText() == "中文"
    qtbot.keyClick(preferences.language_box, Qt.Key.Key_Down)
    qtbot.keyClick(preferences.theme_box, Qt.Key.Key_Down)

    assert store.settings.language == "en"
    assert store.settings.theme == "dark"
    assert SettingsStore(store._path).settings == store.settings


@pytest.mark.parametrize(
    ("typed", "step_deg", "shown_as"),
    [("0.25", 0.25, "0.25°"), ("5°", 5.0, "5°"), ("0,5", 0.5, "0.5°"), ("30", 30.0, "30°")],
)
def test_a_jog_step_holds_at_once(
    qtbot: QtBot,
    preferences: SettingsDialog,
    store: SettingsStore,
    typed: str,
    step_deg: float,
    shown_as: str,
) -> None:
    retype(qtbot, preferences.jog_step_edit, typed)

    assert store.settings.jog_step_deg == step_deg
    assert preferences.jog_step_edit.text() == shown_as
    assert preferences.isVisible()
    assert message(preferences) == ""


@pytest.mark.parametrize(
    ("typed", "reason"),
    [
        ("31", "Jog step 31° is out of range. Enter a value from 0.001° to 30°."),
        ("0", "Jog step 0° is out of range. Enter a value from 0.001° to 30°."),
        ("x", "Jog step: “x” is not an angle. Enter a number of degrees, for example 0.5."),
        ("", "Jog step: “” is not an angle. Enter a number of degrees, for example 0.5."),
    ],
)
def test_a_jog_step_that_is_not_possible_says_why_and_stays_to_be_mended(
    qtbot: QtBot, preferences: SettingsDialog, store: SettingsStore, typed: str, reason: str
) -> None:
    preferences.jog_step_edit.clear()
    retype(qtbot, preferences.jog_step_edit, typed)

    assert store.settings.jog_step_deg == 1.0
    assert preferences.jog_step_edit.text() == typed
    assert preferences.jog_step_edit.property("attention") is True
    assert message(preferences) == reason

    retype(qtbot, preferences.jog_step_edit, "2")
    assert store.settings.jog_step_deg == 2.0
    assert preferences.jog_step_edit.property("attention") is False
    assert message(preferences) == ""


def test_what_was_wrong_is_forgotten_when_it_opens_again(
    qtbot: QtBot, preferences: SettingsDialog
) -> None:
    retype(qtbot, preferences.jog_step_edit, "99")
    preferences.close()
    preferences.open()

    assert preferences.jog_step_edit.text() == "1°"
    assert message(preferences) == ""


def test_a_robot_description_is_chosen_and_taken_back(
    qtbot: QtBot, preferences: SettingsDialog, store: SettingsStore, tmp_path: Path
) -> None:
    file = tmp_path / "other.urdf"
    file.write_text("<robot/>")
    assert not preferences.built_in_button.isEnabled()
    qtbot.mouseClick(preferences.browse_button, LEFT)
    (chooser,) = preferences.findChildren(FileDialog)
    chooser.setDirectory(str(tmp_path))
    chooser.selectFile(str(file))
    qtbot.keyClick(chooser, Qt.Key.Key_Return)

    assert now(store.settings.urdf_path) == str(file)
    assert str(file) in words_of(preferences)
    qtbot.mouseClick(preferences.built_in_button, LEFT)
    assert now(store.settings.urdf_path) is None
    assert "Built-in model of the PiPER" in words_of(preferences)


def test_a_robot_description_that_is_not_there_is_refused(
    preferences: SettingsDialog, store: SettingsStore, tmp_path: Path
) -> None:
    preferences._on_urdf_chosen(tmp_path / "gone.urdf")

    assert store.settings.urdf_path is None
    assert "gone.urdf is not there" in message(preferences)


def test_what_the_3d_view_finds_wrong_with_it_is_shown(
    preferences: SettingsDialog, store: SettingsStore, tmp_path: Path
) -> None:
    file = tmp_path / "other.urdf"
    file.write_text("<robot/>")
    reason = URDF_JOINT_COUNT(path="other.urdf", found=0, wanted=6)
    store.subscribe(lambda _settings: preferences.show_robot_problem(reason))
    preferences._on_urdf_chosen(file)

    assert "other.urdf has 0 revolute joints" in message(preferences)


def test_settings_that_cannot_be_saved_say_so(
    qtbot: QtBot, controller: FakeController, tmp_path: Path
) -> None:
    in_the_way = tmp_path / "file"
    in_the_way.touch()
    dialog = SettingsDialog(SettingsStore(in_the_way / "settings.json"), controller.as_real)
    shown(qtbot, dialog)
    qtbot.keyClick(dialog.theme_box, Qt.Key.Key_Down)

    assert "could not be saved" in message(dialog)


def test_a_broken_settings_file_is_told_at_the_first_opening(
    qtbot: QtBot, controller: FakeController, tmp_path: Path
) -> None:
    path = tmp_path / "settings.json"
    path.write_text("{")
    dialog = SettingsDialog(SettingsStore(path), controller.as_real)
    shown(qtbot, dialog)

    assert "settings.json.broken" in message(dialog)


def test_the_built_in_model_is_that_of_the_arm(
    preferences: SettingsDialog, controller: FakeController
) -> None:
    name = preferences.findChild(ElidedLabel, "urdf_name")
    assert name is not None
    assert name.text() == "Built-in model of the PiPER"
    controller.be(operating_state(model_fit=ModelFit(PiperModel.PIPER_X)))
    assert name.text() == "Built-in model of the PiPER X"
