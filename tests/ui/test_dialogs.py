"""The dialogs, by clicks and keys, as an operator uses them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QItemSelectionModel, QPoint, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QApplication, QDialog, QLabel, QLineEdit, QTableView, QWidget
from pytestqt.qtbot import QtBot

from armui.arm.refusal import Refusal
from armui.bus.adapters import Device
from armui.control.situation import LinkState, Situation, StopState
from armui.settings import SettingsStore
from armui.ui.dialogs.base import ArmDialog
from armui.ui.dialogs.confirm import ConfirmDialog, confirm
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.dialogs.files import FileDialog, choose_file
from armui.ui.dialogs.help import HelpDialog
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.theme import Theme, apply_theme
from armui.ui.translation import Translator
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.stop_shortcut import StopShortcut
from tests.ui.conftest import FakeController, situation

LEFT = Qt.MouseButton.LeftButton

SIM_2 = Device("virtual", "sim-2", None, simulated=True, generation=2)
SIM_1 = Device("virtual", "sim-1", None, simulated=True, generation=1)
CAN0 = Device("socketcan", "can0", None)
CANDLE = Device("gs_usb", "0", 1_000_000, serial="0031002F")
FOUND = [SIM_2, SIM_1, CAN0, CANDLE]


@pytest.fixture
def store(tmp_path: Path) -> SettingsStore:
    return SettingsStore(tmp_path / "settings.json")


@pytest.fixture
def translator(qapp: QApplication) -> Iterator[Translator]:
    translator = Translator(qapp)
    yield translator
    translator.set_language("en")


def shown(qtbot: QtBot, dialog: QDialog) -> None:
    qtbot.addWidget(dialog)
    dialog.show()
    qtbot.waitExposed(dialog)


def message(dialog: QDialog) -> str:
    line = dialog.findChild(MessageLine)
    assert line is not None
    return line.text()


def words_of(dialog: QDialog) -> str:
    return "\n".join(label.text() for label in dialog.findChildren(QLabel))


# What every dialog shares -------------------------------------------------------------------------

MakeDialog = Callable[[FakeController, SettingsStore], QDialog]

DIALOGS: dict[str, MakeDialog] = {
    "connect": lambda controller, _store: ConnectDialog(controller),
    "settings": lambda controller, store: SettingsDialog(store, controller),
    "help": lambda controller, _store: HelpDialog(controller),
    "confirm": lambda controller, _store: ConfirmDialog(
        controller, title="Title", text="Text", action_label="Do it"
    ),
    "file": lambda controller, _store: FileDialog(
        controller, title="Title", name_filter="Robot description (*.urdf)"
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
    shortcut = StopShortcut(qapp, controller)
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


def test_it_blocks_no_other_window(dialog: QDialog) -> None:
    assert not dialog.isModal()
    assert QApplication.activeModalWidget() is None


def test_escape_closes_it(qtbot: QtBot, dialog: QDialog) -> None:
    qtbot.keyClick(dialog, Qt.Key.Key_Escape)

    assert not dialog.isVisible()


def test_enter_presses_no_stop(qtbot: QtBot, controller: FakeController, dialog: QDialog) -> None:
    qtbot.keyClick(dialog, Qt.Key.Key_Return)

    assert ("emergency_stop",) not in controller.calls


@pytest.mark.parametrize("name", ["connect", "settings", "help"])
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
    assert dialog.windowTitle() in {"连接机械臂", "设置", "使用帮助"}
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
    language: str,
) -> None:
    translator.set_language(language)
    for name in ("connect", "settings", "help", "confirm"):
        dialog = DIALOGS[name](controller, store)
        shown(qtbot, dialog)
        for label in dialog.findChildren(QLabel):
            if label.isVisible() and label.text() and type(label) is QLabel:
                needed = label.heightForWidth(label.width()) if label.wordWrap() else 0
                assert label.height() >= needed, label.text()
                if not label.wordWrap():
                    assert label.width() >= label.sizeHint().width(), label.text()


def test_opening_again_brings_it_to_the_front(qtbot: QtBot, controller: FakeController) -> None:
    dialog = ArmDialog(controller)
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
        controller,
        title="Disable the motors",
        text="The arm will drop.",
        action_label="Disable",
        on_confirmed=lambda: answers.append("yes"),
    )
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose, False)
    # the tests look at it after it has closed
    dialog.kept_parent = parent
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
            controller,
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
    controller.be(situation(stop=StopState.STOPPED))
    qtbot.mousePress(dialog.stop_button, LEFT)

    assert controller.calls == [("emergency_stop",)]
    assert dialog.findChildren(ConfirmDialog) == []


def test_its_sign_follows_the_theme(
    qapp: QApplication, asked: tuple[ConfirmDialog, list[str]]
) -> None:
    dialog, _answers = asked

    def ink() -> set[QColor]:
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


# Connect ------------------------------------------------------------------------------------------


@pytest.fixture
def connect(qtbot: QtBot, controller: FakeController) -> ConnectDialog:
    dialog = ConnectDialog(controller)
    shown(qtbot, dialog)
    controller.devices_found.emit(FOUND)
    return dialog


def cells(dialog: ConnectDialog) -> list[list[str]]:
    model = dialog.findChild(QTableView).model()
    columns = range(model.columnCount())
    return [
        [model.index(row, column).data() for column in columns] for row in range(model.rowCount())
    ]


def click_row(qtbot: QtBot, dialog: ConnectDialog, row: int) -> None:
    table = dialog.findChild(QTableView)
    place = table.visualRect(table.model().index(row, 1)).center()
    qtbot.mouseClick(table.viewport(), LEFT, pos=place)


def chosen_rows(dialog: ConnectDialog) -> list[int]:
    return [index.row() for index in dialog.findChild(QTableView).selectionModel().selectedRows()]


def test_opening_it_searches_each_time(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    assert controller.calls == [("search_devices",)]
    connect.close()
    connect.open()
    assert controller.calls == [("search_devices",)] * 2


def test_devices_are_listed_with_kind_channel_serial_and_bit_rate(connect: ConnectDialog) -> None:
    assert cells(connect) == [
        ["", "Simulated arm, gen. 2", "—", "—", "—"],
        ["", "Simulated arm, gen. 1", "—", "—", "—"],
        ["", "SocketCAN", "can0", "—", "—"],
        ["", "candleLight (gs_usb)", "0", "0031002F", "1 Mbit/s"],
    ]
    assert chosen_rows(connect) == [0]


def test_a_click_and_the_button_connect(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    click_row(qtbot, connect, 2)
    qtbot.mouseClick(connect.connect_button, LEFT)

    assert controller.calls[-1] == ("connect_device", CAN0)


def test_a_double_click_connects(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    table = connect.findChild(QTableView)
    place = table.visualRect(table.model().index(1, 1)).center()
    qtbot.mouseClick(table.viewport(), LEFT, pos=place)
    qtbot.mouseDClick(table.viewport(), LEFT, pos=place)

    assert controller.calls[-1] == ("connect_device", SIM_1)


def test_by_keyboard(qtbot: QtBot, controller: FakeController, connect: ConnectDialog) -> None:
    table = connect.findChild(QTableView)
    qtbot.keyClick(table, Qt.Key.Key_Down)
    qtbot.keyClick(table, Qt.Key.Key_Return)

    assert controller.calls[-1] == ("connect_device", SIM_1)


def test_the_bit_rate_can_be_chosen_where_the_program_sets_it(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    click_row(qtbot, connect, 3)
    assert connect.bitrate_box.isEnabled()
    assert connect.bitrate_box.currentData() == 1_000_000
    qtbot.keyClick(connect.bitrate_box, Qt.Key.Key_Down)
    qtbot.mouseClick(connect.connect_button, LEFT)

    expected = Device("gs_usb", "0", 500_000, serial="0031002F")
    assert controller.calls[-1] == ("connect_device", expected)


@pytest.mark.parametrize(("row", "reason"), [(0, "simulated"), (2, "operating system")])
def test_the_bit_rate_is_closed_elsewhere_and_says_why(
    qtbot: QtBot, connect: ConnectDialog, row: int, reason: str
) -> None:
    click_row(qtbot, connect, row)

    assert not connect.bitrate_box.isEnabled()
    assert reason in connect.bitrate_box.toolTip()
    assert reason in words_of(connect)


def test_a_device_that_no_search_finds_can_be_named(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    manual = connect._manual
    assert not manual.add_button.isEnabled()
    assert manual.add_button.toolTip()
    manual.interface_box.setCurrentText("slcan")
    qtbot.keyClicks(manual.channel_edit, "/dev/ttyACM0")
    qtbot.mouseClick(manual.add_button, LEFT)

    assert cells(connect)[-1][1:3] == ["slcan", "/dev/ttyACM0"]
    assert chosen_rows(connect) == [4]
    qtbot.mouseClick(connect.connect_button, LEFT)
    assert controller.calls[-1] == ("connect_device", Device("slcan", "/dev/ttyACM0", 1_000_000))


@pytest.mark.parametrize(
    ("interface", "channel", "expected"),
    [
        ("udp_multicast", "239.0.0.1", Device("udp_multicast", "239.0.0.1", None)),
        ("kvaser", "1", Device("kvaser", 1, 1_000_000)),
    ],
)
def test_named_devices_as_python_can_wants_them(
    qtbot: QtBot,
    controller: FakeController,
    connect: ConnectDialog,
    interface: str,
    channel: str,
    expected: Device,
) -> None:
    connect._manual.interface_box.setCurrentText(interface)
    qtbot.keyClicks(connect._manual.channel_edit, channel)
    qtbot.mouseClick(connect._manual.add_button, LEFT)
    qtbot.mouseClick(connect.connect_button, LEFT)

    assert controller.calls[-1] == ("connect_device", expected)


def test_a_named_device_survives_the_next_search_and_is_listed_once(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    for _time in range(2):
        connect._manual.interface_box.setCurrentText("slcan")
        qtbot.keyClicks(connect._manual.channel_edit, "COM5")
        qtbot.mouseClick(connect._manual.add_button, LEFT)
    controller.devices_found.emit([SIM_2])

    assert [row[2] for row in cells(connect)] == ["—", "COM5"]
    assert chosen_rows(connect) == [1]


def test_while_it_searches_it_says_so(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    controller.searching_changed.emit(True)
    assert connect._progress.isVisible()
    assert not connect.refresh_button.isEnabled()
    assert message(connect) == "Searching for devices…"

    controller.searching_changed.emit(False)
    assert not connect._progress.isVisible()
    qtbot.mouseClick(connect.refresh_button, LEFT)
    assert controller.calls == [("search_devices",)] * 2


def test_the_connected_device_is_marked_and_disconnected(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    assert not connect.disconnect_button.isEnabled()
    assert connect.disconnect_button.toolTip()
    controller.be(situation(device=SIM_2))

    assert [row[0] for row in cells(connect)] == ["Online", "", "", ""]
    assert not connect.connect_button.isEnabled()
    assert connect.connect_button.toolTip() == "This device is connected."
    qtbot.mouseClick(connect.disconnect_button, LEFT)
    assert controller.calls[-1] == ("disconnect_device",)


@pytest.mark.parametrize(
    ("link", "word"),
    [
        (LinkState.OPENING, "Connecting…"),
        (LinkState.OFFLINE, "Offline"),
        (LinkState.ONLINE, "Online"),
        (LinkState.LOST, "Connection lost"),
    ],
)
def test_the_mark_says_how_the_link_is(
    controller: FakeController, connect: ConnectDialog, link: LinkState, word: str
) -> None:
    controller.be(situation(device=CAN0, link=link))

    assert [row[0] for row in cells(connect)] == ["", "", word, ""]


def test_a_connected_device_that_no_search_found_is_listed(
    controller: FakeController, connect: ConnectDialog
) -> None:
    controller.be(situation(device=Device("pcan", "PCAN_USBBUS1", 500_000)))

    assert cells(connect)[-1] == ["Online", "PCAN", "PCAN_USBBUS1", "—", "500 kbit/s"]


def test_the_chosen_bit_rate_makes_it_no_other_device(
    controller: FakeController, connect: ConnectDialog
) -> None:
    controller.be(situation(device=Device("gs_usb", "0", 500_000, serial="0031002F")))

    assert cells(connect)[3] == ["Online", "candleLight (gs_usb)", "0", "0031002F", "500 kbit/s"]
    assert len(cells(connect)) == 4


def test_a_device_that_does_not_open_says_why_and_what_to_do(
    controller: FakeController, connect: ConnectDialog
) -> None:
    controller.be(Situation(link_problem=Refusal("bus_busy", {"device": "can0"})))

    assert message(connect) == (
        "can0 is in use by another program. Close that program, then connect again."
    )
    assert connect.connect_button.isEnabled()


def test_offline_says_what_to_check(controller: FakeController, connect: ConnectDialog) -> None:
    offline = Refusal("offline")
    controller.be(situation(device=CAN0, link=LinkState.OFFLINE, cannot_move=offline))

    assert "Check its power, the CAN cable and the bit rate." in message(connect)


def test_a_moving_arm_is_not_left_without_a_question(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    controller.be(situation(device=SIM_2, moving=True))
    qtbot.mouseClick(connect.disconnect_button, LEFT)
    assert controller.calls[-1] == ("search_devices",)

    (question,) = connect.findChildren(ConfirmDialog)
    assert "goes on to its target" in question.text()
    qtbot.mouseClick(question.action_button, LEFT)
    assert controller.calls[-1] == ("disconnect_device",)


def test_the_words_in_the_table_change_with_the_language(
    controller: FakeController, connect: ConnectDialog, translator: Translator
) -> None:
    controller.be(situation(device=SIM_2))
    translator.set_language("zh")
    QApplication.processEvents()

    assert cells(connect)[0][:2] == ["在线", "仿真机械臂（第 2 代）"]
    header = connect.findChild(QTableView).model().headerData
    assert [header(column, Qt.Orientation.Horizontal) for column in range(5)] == [
        *("状态", "类型", "通道", "序列号", "波特率")
    ]


def test_choosing_nothing_closes_the_button_with_a_reason(connect: ConnectDialog) -> None:
    selection = connect.findChild(QTableView).selectionModel()
    selection.select(selection.currentIndex(), QItemSelectionModel.SelectionFlag.Clear)

    assert not connect.connect_button.isEnabled()
    assert connect.connect_button.toolTip() == "Choose a device in the list first."


# Settings -----------------------------------------------------------------------------------------


@pytest.fixture
def preferences(qtbot: QtBot, controller: FakeController, store: SettingsStore) -> SettingsDialog:
    dialog = SettingsDialog(store, controller)
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
        ("31", "Jog step 31.000° is out of range. Enter a value from 0.001° to 30.000°."),
        ("0", "Jog step 0.000° is out of range. Enter a value from 0.001° to 30.000°."),
        ("x", "Jog step: “x” is not an angle. Enter degrees in figures, for example 0.5."),
        ("", "Jog step: “” is not an angle. Enter degrees in figures, for example 0.5."),
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

    assert store.settings.urdf_path == str(file)
    assert str(file) in words_of(preferences)
    qtbot.mouseClick(preferences.built_in_button, LEFT)
    assert store.settings.urdf_path is None
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
    store.subscribe(lambda _settings: preferences.show_robot_problem("no joints in other.urdf"))
    preferences._on_urdf_chosen(file)

    assert message(preferences) == "no joints in other.urdf"


def test_settings_that_cannot_be_saved_say_so(
    qtbot: QtBot, controller: FakeController, tmp_path: Path
) -> None:
    in_the_way = tmp_path / "file"
    in_the_way.touch()
    dialog = SettingsDialog(SettingsStore(in_the_way / "settings.json"), controller)
    shown(qtbot, dialog)
    qtbot.keyClick(dialog.theme_box, Qt.Key.Key_Down)

    assert "could not be saved" in message(dialog)


def test_a_broken_settings_file_is_told_at_the_first_opening(
    qtbot: QtBot, controller: FakeController, tmp_path: Path
) -> None:
    path = tmp_path / "settings.json"
    path.write_text("{")
    dialog = SettingsDialog(SettingsStore(path), controller)
    shown(qtbot, dialog)

    assert "settings.json.broken" in message(dialog)


# Help and files -----------------------------------------------------------------------------------


def test_the_help_names_what_the_3d_area_can_do(
    qtbot: QtBot, controller: FakeController, translator: Translator
) -> None:
    translator.set_language("zh")
    dialog = HelpDialog(controller)
    shown(qtbot, dialog)
    text = words_of(dialog)

    for word in ("左键拖动", "中键拖动", "滚轮", "双击连杆", "Home", "F12", "RX  RY  RZ", "—"):
        assert word in text
    qtbot.mouseClick(dialog.close_button, LEFT)
    assert not dialog.isVisible()


def test_the_help_needs_no_scrolling(
    qtbot: QtBot, controller: FakeController, translator: Translator
) -> None:
    for language in ("zh", "en"):
        translator.set_language(language)
        dialog = HelpDialog(controller)
        shown(qtbot, dialog)
        assert dialog.area.verticalScrollBar().maximum() == 0
        assert dialog.height() <= 720


def test_a_chosen_file_is_handed_over(
    qtbot: QtBot, controller: FakeController, tmp_path: Path
) -> None:
    parent, chosen = QWidget(), []
    qtbot.addWidget(parent)
    file = tmp_path / "arm.urdf"
    file.touch()
    chooser = choose_file(
        parent,
        controller,
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
