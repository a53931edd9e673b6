"""The window 连接机械臂, by clicks and keys (M1)."""

from __future__ import annotations

from dataclasses import replace

import pytest
from PySide6.QtCore import QItemSelectionModel, Qt
from PySide6.QtWidgets import QApplication, QLabel, QLineEdit, QTableView
from pytestqt.qtbot import QtBot

from armui.arm.device import Device
from armui.bus.adapters import BUS_BUSY
from armui.control.link.link_state import OFFLINE, LinkState
from armui.control.operating_state import OperatingState
from armui.doctor.facts import CanFacts, Diagnosis, LinkFacts, SerialPortFacts
from armui.doctor.judge import judge_can
from armui.ui.background import Background
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.connect import AdapterTrouble, ConnectDialog
from armui.ui.dialogs.finding_row import FindingRow
from armui.ui.translation import Translator
from tests.app_driver import AtOnce
from tests.ui.arm_states import operating_state
from tests.ui.dialog_reading import message, shown, words_of
from tests.ui.fake_controller import FakeController

LEFT = Qt.MouseButton.LeftButton

SIM_2 = Device("virtual", "sim-2", None, simulated=True, generation=2)
SIM_1 = Device("virtual", "sim-1", None, simulated=True, generation=1)
CAN0 = Device("socketcan", "can0", None)
CANDLE = Device("gs_usb", "0", 1_000_000, serial="0031002F")
FOUND = [SIM_2, SIM_1, CAN0, CANDLE]


@pytest.fixture
def connect(qtbot: QtBot, controller: FakeController) -> ConnectDialog:
    dialog = ConnectDialog(controller.as_real)
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


def connected(controller: FakeController) -> Device:
    """What is to be connected; the model is the one that was offered."""
    call, device = controller.calls[-1]
    assert call == "connect_device"
    assert isinstance(device, Device)
    assert device.model_assumed
    return replace(device, model_assumed=False)


def test_opening_it_searches_each_time(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    assert controller.calls == [("search_devices",)]
    connect.close()
    connect.open()
    assert controller.calls == [("search_devices",)] * 2


def test_devices_are_listed_with_all_that_is_known_the_real_ones_first(
    connect: ConnectDialog,
) -> None:
    assert cells(connect) == [
        ["", "SocketCAN", "can0", "—", "—"],
        ["", "candleLight (gs_usb)", "0", "0031002F", "1 Mbit/s"],
        ["", "Simulated arm, gen. 2", "—", "—", "—"],
        ["", "Simulated arm, gen. 1", "—", "—", "—"],
    ]
    assert chosen_rows(connect) == [0]


def test_a_click_and_the_button_connect(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    click_row(qtbot, connect, 0)
    qtbot.mouseClick(connect.connect_button, LEFT)

    assert connected(controller) == CAN0


def test_a_double_click_connects(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    table = connect.findChild(QTableView)
    place = table.visualRect(table.model().index(3, 1)).center()
    qtbot.mouseClick(table.viewport(), LEFT, pos=place)
    qtbot.mouseDClick(table.viewport(), LEFT, pos=place)

    assert connected(controller) == SIM_1


def test_by_keyboard(qtbot: QtBot, controller: FakeController, connect: ConnectDialog) -> None:
    table = connect.findChild(QTableView)
    qtbot.keyClick(table, Qt.Key.Key_Down)
    qtbot.keyClick(table, Qt.Key.Key_Return)

    assert connected(controller) == CANDLE


def test_the_bit_rate_can_be_chosen_where_the_program_sets_it(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    click_row(qtbot, connect, 1)
    assert connect.bitrate_box.isEnabled()
    assert connect.bitrate_box.currentData() == 1_000_000
    qtbot.keyClick(connect.bitrate_box, Qt.Key.Key_Down)
    qtbot.mouseClick(connect.connect_button, LEFT)

    expected = Device("gs_usb", "0", 500_000, serial="0031002F")
    assert connected(controller) == expected


@pytest.mark.parametrize(("row", "reason"), [(2, "simulated"), (0, "operating system")])
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

    assert cells(connect)[2][1:3] == ["slcan", "/dev/ttyACM0"]
    assert chosen_rows(connect) == [2]
    qtbot.mouseClick(connect.connect_button, LEFT)
    assert connected(controller) == Device("slcan", "/dev/ttyACM0", 1_000_000)


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

    assert connected(controller) == expected


def test_a_named_device_survives_the_next_search_and_is_listed_once(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    for _time in range(2):
        connect._manual.interface_box.setCurrentText("slcan")
        qtbot.keyClicks(connect._manual.channel_edit, "COM5")
        qtbot.mouseClick(connect._manual.add_button, LEFT)
    controller.devices_found.emit([SIM_2])

    assert [row[2] for row in cells(connect)] == ["COM5", "—"]
    assert chosen_rows(connect) == [0]


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
    controller.be(operating_state(device=SIM_2))
    click_row(qtbot, connect, 2)

    assert [row[0] for row in cells(connect)] == ["", "", "Online", ""]
    assert not connect.connect_button.isEnabled()
    assert connect.connect_button.toolTip() == "This device is connected."
    qtbot.mouseClick(connect.disconnect_button, LEFT)
    assert controller.calls[-1] == ("disconnect_device",)


def test_once_the_arm_is_heard_it_is_out_of_the_way(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    click_row(qtbot, connect, 2)
    qtbot.mouseClick(connect.connect_button, LEFT)
    controller.be(operating_state(device=SIM_2, link=LinkState.OPENING))
    controller.be(operating_state(device=SIM_2, link=LinkState.OFFLINE))
    assert connect.isVisible()  # and says what to check
    controller.be(operating_state(device=SIM_2, link=LinkState.ONLINE))
    assert not connect.isVisible()

    connect.open()  # to look at it, or to disconnect
    controller.be(operating_state(device=SIM_2, link=LinkState.ONLINE, speed_percent=7))
    assert connect.isVisible()


def test_what_is_wrong_with_an_adapter_is_said_with_the_command_that_mends_it(
    qtbot: QtBot, controller: FakeController
) -> None:
    down = LinkFacts("can0", "can", False)
    closed = SerialPortFacts("/dev/ttyACM0", False, "dialout")
    found = judge_can(CanFacts(links=(down,), ports=(closed,)))
    trouble = AdapterTrouble(Background(AtOnce()), lambda: found)
    qtbot.addWidget(trouble)
    trouble.examine()
    assert not trouble.isHidden()
    rows = trouble.findChildren(FindingRow)
    texts = " ".join(label.text() for row in rows for label in row.findChildren(QLabel))
    assert "/dev/ttyACM0" in texts  # the gravest alone: the diagnosis tells the rest
    commands = [line.text() for row in rows for line in row.findChildren(QLineEdit)]
    assert commands == ['sudo usermod -aG dialout "$USER"']
    qtbot.mouseClick(rows[0].copy_buttons[0], LEFT)
    assert QApplication.clipboard().text() == commands[0]


def test_advice_on_an_adapter_is_not_cut_off(qtbot: QtBot, controller: FakeController) -> None:
    dialog = ConnectDialog(controller.as_real, background=Background(AtOnce()))
    trouble = dialog.findChild(AdapterTrouble)
    down = LinkFacts("can0", "can", False)
    trouble._find_faults = lambda: judge_can(CanFacts(links=(down,)))
    shown(qtbot, dialog)
    controller.devices_found.emit(FOUND)
    trouble.examine()
    rows = trouble.findChildren(FindingRow)
    assert rows
    for label in rows[0].findChildren(QLabel):
        assert label.height() >= label.heightForWidth(label.width())
    table = dialog.findChild(QTableView)
    assert table.verticalScrollBar().maximum() == 0  # each device is seen


def test_where_nothing_is_wrong_nothing_is_said(qtbot: QtBot) -> None:
    trouble = AdapterTrouble(Background(AtOnce()), list)
    qtbot.addWidget(trouble)
    trouble.examine()
    assert trouble.isHidden()


def test_a_look_that_fails_says_nothing(qtbot: QtBot) -> None:
    def fails() -> list[Diagnosis]:
        raise OSError("no /sys")

    trouble = AdapterTrouble(Background(AtOnce()), fails)
    qtbot.addWidget(trouble)
    trouble.examine()
    assert trouble.isHidden()


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
    controller.be(operating_state(device=CAN0, link=link))

    assert [row[0] for row in cells(connect)] == [word, "", "", ""]


def test_a_connected_device_that_no_search_found_is_listed(
    controller: FakeController, connect: ConnectDialog
) -> None:
    controller.be(operating_state(device=Device("pcan", "PCAN_USBBUS1", 500_000)))

    assert cells(connect)[2] == ["Online", "PCAN", "PCAN_USBBUS1", "—", "500 kbit/s"]


def test_the_chosen_bit_rate_makes_it_no_other_device(
    controller: FakeController, connect: ConnectDialog
) -> None:
    controller.be(operating_state(device=Device("gs_usb", "0", 500_000, serial="0031002F")))

    assert cells(connect)[1] == ["Online", "candleLight (gs_usb)", "0", "0031002F", "500 kbit/s"]
    assert len(cells(connect)) == 4


def test_a_device_that_does_not_open_says_why_and_what_to_do(
    controller: FakeController, connect: ConnectDialog
) -> None:
    controller.be(OperatingState(link_problem=BUS_BUSY(device="can0")))

    assert message(connect) == (
        "can0 is in use by another program. Close that program, then connect again."
    )
    assert connect.connect_button.isEnabled()


def test_offline_says_what_to_check(controller: FakeController, connect: ConnectDialog) -> None:
    offline = OFFLINE()
    controller.be(operating_state(device=CAN0, link=LinkState.OFFLINE, cannot_move=offline))

    assert "Check its power, the CAN cable and the bit rate, or whether" in message(connect)


def test_a_moving_arm_is_not_left_without_a_question(
    qtbot: QtBot, controller: FakeController, connect: ConnectDialog
) -> None:
    controller.be(operating_state(device=SIM_2, moving=True))
    qtbot.mouseClick(connect.disconnect_button, LEFT)
    assert controller.calls[-1] == ("search_devices",)

    (question,) = connect.findChildren(ConfirmDialog)
    assert "goes on to its target" in question.text()
    qtbot.mouseClick(question.action_button, LEFT)
    assert controller.calls[-1] == ("disconnect_device",)


def test_the_words_in_the_table_change_with_the_language(
    controller: FakeController, connect: ConnectDialog, translator: Translator
) -> None:
    controller.be(operating_state(device=SIM_2))
    translator.set_language("zh")
    QApplication.processEvents()

    assert cells(connect)[2][:2] == ["在线", "仿真机械臂（第 2 代）"]
    header = connect.findChild(QTableView).model().headerData
    assert [header(column, Qt.Orientation.Horizontal) for column in range(5)] == [
        *("状态", "类型", "通道", "序列号", "波特率")
    ]


def test_choosing_nothing_closes_the_button_with_a_reason(connect: ConnectDialog) -> None:
    selection = connect.findChild(QTableView).selectionModel()
    selection.select(selection.currentIndex(), QItemSelectionModel.SelectionFlag.Clear)

    assert not connect.connect_button.isEnabled()
    assert connect.connect_button.toolTip() == "Choose a device in the list first."
