"""What every dialog has in common, and the small ones: confirm, help, file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QLabel,
    QLineEdit,
    QPushButton,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from armui.control.operating_state import StopState
from armui.settings import SettingsStore
from armui.ui.dialogs.base import ArmDialog
from armui.ui.dialogs.confirm_dialog import ConfirmDialog, confirm
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.dialogs.files import FileDialog, choose_file
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.theme import Theme, apply_theme
from armui.ui.translation import Language, Translator
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.stop_shortcut import StopShortcut
from tests.ui.arm_states import operating_state
from tests.ui.dialog_reading import shown, words_of
from tests.ui.fake_controller import FakeController

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def store(tmp_path: Path) -> SettingsStore:
    return SettingsStore(tmp_path / "settings.json")


MakeDialog = Callable[[FakeController, SettingsStore], QDialog]

DIALOGS: dict[str, MakeDialog] = {
    "connect": lambda controller, _store: ConnectDialog(controller.as_real),
    "settings": lambda controller, store: SettingsDialog(store, controller.as_real),
    "confirm": lambda controller, _store: ConfirmDialog(
        controller.as_real, title="Title", text="Text", action_label="Do it"
    ),
    "file": lambda controller, _store: FileDialog(
        controller.as_real, title="Title", name_filter="Robot description (*.urdf)"
    ),
}


@pytest.fixture(params=DIALOGS)
def dialog(
    request: pytest.FixtureRequest, qtbot: QtBot, controller: FakeController, store: SettingsStore
) -> QDialog:
    made = DIALOGS[request.param](controller, store)
    shown(qtbot, made)
    return made


def test_the_stop_acts_when_it_is_pressed_down(
    qtbot: QtBot, controller: FakeController, dialog: QDialog
) -> None:
    (button,) = dialog.findChildren(StopButton)
    qtbot.mousePress(button, LEFT)

    assert controller.calls[-1] == ("emergency_stop",)


def test_the_stop_key_works_in_it(
    qtbot: QtBot, qapp: QApplication, controller: FakeController, dialog: QDialog
) -> None:
    shortcut = StopShortcut(qapp, controller.as_real)
    qtbot.keyPress(dialog.focusWidget() or dialog, Qt.Key.Key_F12)
    qapp.removeEventFilter(shortcut)
    shortcut.deleteLater()

    assert controller.calls.count(("emergency_stop",)) == 1


def test_the_stop_is_whole_and_on_top(dialog: QDialog) -> None:
    (button,) = dialog.findChildren(StopButton)
    place = button.mapTo(dialog, QPoint())

    assert button.width() >= button.sizeHint().width()
    assert dialog.rect().contains(button.rect().translated(place))
    for corner in (button.rect().topLeft(), button.rect().center(), button.rect().bottomRight()):
        assert dialog.childAt(place + corner) is button
    assert button.isEnabled()


def test_the_stop_is_one_line_high_and_as_wide_as_its_words(
    controller: FakeController, dialog: QDialog
) -> None:
    """The large one is the main window's."""
    (button,) = dialog.findChildren(StopButton)
    large = StopButton(controller.as_real)
    assert 24 <= button.height() <= 32
    assert button.width() == button.sizeHint().width() < large.sizeHint().width()
    large.deleteLater()


def test_it_blocks_no_other_window(dialog: QDialog) -> None:
    assert not dialog.isModal()
    assert QApplication.activeModalWidget() is None


def test_escape_closes_it(qtbot: QtBot, dialog: QDialog) -> None:
    qtbot.keyClick(dialog, Qt.Key.Key_Escape)

    assert not dialog.isVisible()


def test_enter_presses_no_stop(qtbot: QtBot, controller: FakeController, dialog: QDialog) -> None:
    qtbot.keyClick(dialog, Qt.Key.Key_Return)

    assert ("emergency_stop",) not in controller.calls


@pytest.mark.parametrize("name", ["connect", "settings"])
def test_it_speaks_the_new_language_at_once(
    qtbot: QtBot,
    controller: FakeController,
    store: SettingsStore,
    translator: Translator,
    name: str,
) -> None:
    dialog = DIALOGS[name](controller, store)
    shown(qtbot, dialog)
    title, english = dialog.windowTitle(), words_of(dialog)

    translator.set_language("zh")
    QApplication.processEvents()
    assert dialog.windowTitle() in {"连接机械臂", "设置"}
    assert "急停" in dialog.findChild(StopButton).text()
    translator.set_language("en")
    QApplication.processEvents()
    assert dialog.windowTitle() == title
    assert words_of(dialog) == english


@pytest.mark.parametrize("language", ["zh", "en"])
def test_no_word_is_cut_off(
    qtbot: QtBot,
    controller: FakeController,
    store: SettingsStore,
    translator: Translator,
    language: Language,
) -> None:
    translator.set_language(language)
    for name in ("connect", "settings", "confirm"):
        dialog = DIALOGS[name](controller, store)
        shown(qtbot, dialog)
        for label in dialog.findChildren(QLabel):
            if label.isVisible() and label.text() and type(label) is QLabel:
                needed = label.heightForWidth(label.width()) if label.wordWrap() else 0
                assert label.height() >= needed, label.text()
                if not label.wordWrap():
                    assert label.width() >= label.sizeHint().width(), label.text()


def test_opening_again_brings_it_to_the_front(qtbot: QtBot, controller: FakeController) -> None:
    dialog = ArmDialog(controller.as_real)
    shown(qtbot, dialog)
    dialog.open()

    assert dialog.isVisible()
    assert not dialog.isModal()


# Confirm ------------------------------------------------------------------------------------------


@pytest.fixture
def asked(qtbot: QtBot, controller: FakeController) -> tuple[ConfirmDialog, list[str]]:
    parent, answers = QWidget(), []
    qtbot.addWidget(parent)
    parent.show()
    dialog = confirm(
        parent,
        controller.as_real,
        title="Disable the motors",
        text="The arm will drop.",
        action_label="Disable",
        on_confirmed=lambda: answers.append("yes"),
    )
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose, False)
    # the tests look at it after it has closed
    dialog.kept_parent = parent  # type: ignore[attr-defined]
    return dialog, answers


def test_the_action_needs_its_own_button(
    qtbot: QtBot, asked: tuple[ConfirmDialog, list[str]]
) -> None:
    dialog, answers = asked
    assert dialog.isVisible()
    assert dialog.text() == "The arm will drop."
    assert dialog.action_button.text() == "Disable"

    qtbot.mouseClick(dialog.action_button, LEFT)
    assert answers == ["yes"]
    assert not dialog.isVisible()


@pytest.mark.parametrize("key", [Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape])
def test_enter_and_escape_mean_no(
    qtbot: QtBot, asked: tuple[ConfirmDialog, list[str]], key: Qt.Key
) -> None:
    dialog, answers = asked
    qtbot.keyClick(dialog, key)

    assert answers == []
    assert not dialog.isVisible()


def test_cancel_means_no(qtbot: QtBot, asked: tuple[ConfirmDialog, list[str]]) -> None:
    dialog, answers = asked
    qtbot.mouseClick(dialog.cancel_button, LEFT)

    assert answers == []
    assert not dialog.isVisible()


def test_asked_again_the_older_question_is_withdrawn(
    qtbot: QtBot, controller: FakeController
) -> None:
    parent, answers = QWidget(), []
    qtbot.addWidget(parent)

    def ask(answer: str) -> ConfirmDialog:
        return confirm(
            parent,
            controller.as_real,
            title="Same",
            text="",
            action_label="Yes",
            on_confirmed=lambda: answers.append(answer),
        )

    ask("first")
    second = ask("second")
    qtbot.mouseClick(second.action_button, LEFT)

    assert answers == ["second"]
    visible = [box for box in parent.findChildren(ConfirmDialog) if box.isVisible()]
    assert visible == []


def test_the_stop_in_a_question_asks_no_question(
    qtbot: QtBot, controller: FakeController, asked: tuple[ConfirmDialog, list[str]]
) -> None:
    dialog, _answers = asked
    controller.be(operating_state(stop=StopState.STOPPED))
    qtbot.mousePress(dialog.stop_button, LEFT)

    assert controller.calls == [("emergency_stop",)]
    assert dialog.findChildren(ConfirmDialog) == []


def test_its_sign_follows_the_theme(
    qapp: QApplication, asked: tuple[ConfirmDialog, list[str]]
) -> None:
    dialog, _answers = asked

    def ink() -> set[str]:
        image = dialog.findChildren(QLabel)[1].pixmap().toImage()
        return {
            image.pixelColor(x, y).name()
            for x in range(image.width())
            for y in range(image.height())
            if image.pixelColor(x, y).alpha() == 255
        }

    light = ink()
    apply_theme(qapp, Theme.DARK)
    QApplication.processEvents()
    assert ink()
    assert ink() != light


# Files --------------------------------------------------------------------------------------------


@pytest.mark.styled
def test_the_file_chooser_looks_as_the_other_dialogs(
    qtbot: QtBot, controller: FakeController, tmp_path: Path
) -> None:
    chooser = FileDialog(controller.as_real, title="Choose", name_filter="All (*)", start=tmp_path)
    shown(qtbot, chooser)
    assert "Choose" in words_of(chooser)
    (confirm,) = (each for each in chooser.findChildren(QPushButton) if each.property("primary"))
    assert confirm.text() == "&Open"
    for name in ("backButton", "forwardButton", "toParentButton", "newFolderButton"):
        button = chooser.findChild(QToolButton, name)
        image = button.icon().pixmap(16, QIcon.Mode.Normal).toImage()
        inks = {
            image.pixelColor(x, y).name()
            for x in range(16)
            for y in range(16)
            if image.pixelColor(x, y).alpha() > 200
        }
        assert inks, name
        assert "#000000" not in inks, f"{name} is black, which the dark theme hides"


def test_a_chosen_file_is_handed_over(
    qtbot: QtBot, controller: FakeController, tmp_path: Path
) -> None:
    parent = QWidget()
    chosen: list[Path] = []
    qtbot.addWidget(parent)
    file = tmp_path / "arm.urdf"
    file.touch()
    chooser = choose_file(
        parent,
        controller.as_real,
        title="Choose",
        name_filter="Robot description (*.urdf)",
        on_chosen=chosen.append,
        start=file,
    )
    assert chooser.directory().absolutePath() == str(tmp_path)
    assert not chooser.isModal()
    chooser.selectFile(str(file))
    qtbot.keyClick(chooser, Qt.Key.Key_Return)

    assert chosen == [file]


def test_the_next_file_is_looked_for_where_one_was_whose_path_was_typed(
    qtbot: QtBot, controller: FakeController, tmp_path: Path
) -> None:
    file = tmp_path / "points.csv"
    file.touch()

    def chooser() -> FileDialog:
        dialog = FileDialog(controller.as_real, title="A file", name_filter="All (*)")
        qtbot.addWidget(dialog)
        return dialog

    first = chooser()
    first.setDirectory(str(tmp_path.parent))
    first.show()
    name = first.findChild(QLineEdit)
    assert name is not None
    name.setText(str(file))
    qtbot.keyClick(name, Qt.Key.Key_Return)
    assert chooser().directory().absolutePath() == str(tmp_path)


def test_the_next_file_is_looked_for_where_the_last_was(
    qtbot: QtBot, controller: FakeController, tmp_path: Path
) -> None:
    def chosen_in(folder: Path) -> str:
        chooser = FileDialog(controller.as_real, title="A file", name_filter="Text (*.txt)")
        qtbot.addWidget(chooser)
        before = chooser.directory().absolutePath()
        chooser.setDirectory(str(folder))
        return before

    gone = tmp_path / "gone"
    gone.mkdir()
    chosen_in(tmp_path)
    assert chosen_in(gone) == str(tmp_path)
    gone.rmdir()
    assert Path(
        chosen_in(tmp_path)
    ).is_dir()  # one that is gone, as a stick that was pulled, is none
