"""The page 关节状态 and its button: figures, times, words, marks."""

from __future__ import annotations

from datetime import datetime, timedelta

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QFontMetrics, QImage, QPainter
from PySide6.QtWidgets import QApplication, QLabel
from pytestqt.qtbot import QtBot

from armui.arm.joint_status import Item, StatusVerdict, Word
from armui.arm.state import ArmState, DriverFast, DriverSlow, Reading
from armui.control.devices.joint_monitor import JointMonitor
from armui.control.link.link_state import LINK_LOST, LinkState
from armui.protocol.generation import Generation
from armui.ui import words
from armui.ui.shell.side_menu import JointStatusButton
from armui.ui.theme import DARK, LIGHT, Colors, Theme, apply_theme, scaled_font
from armui.ui.translation import LANGUAGES, Language, Translator
from armui.ui.watch.joint_status_page import (
    CELL_ROLE,
    CellView,
    JointStatusModel,
    JointStatusPage,
    word_width,
)
from armui.ui.widgets import state_mark
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.state_mark import Mark
from tests.ui.arm_states import NOW_S, arm_state, heard_six, operating_state
from tests.ui.dialog_reading import shown
from tests.ui.fake_controller import FakeController

VOLTAGE, MOTOR_TEMPERATURE, CURRENT, ENABLED, HOMED = 1, 2, 3, 7, 8
DRAWER_PX = (1072, 245)
"""Of a page in the drawer of a window of 1280×800 that has just opened."""
NOON = datetime(2026, 1, 2, 12, 0, 0).astimezone()

WELL = DriverSlow(
    voltage_v=24.04,
    driver_temperature_c=31.0,
    motor_temperature_c=-3.0,
    bus_current_a=0.1,
    undervoltage=False,
    motor_overtemperature=False,
    overcurrent=False,
    driver_overtemperature=False,
    driver_fault=False,
    enabled=True,
    sensor_fault=False,
    homed=False,
    collision_protection=None,
    stall_protection=None,
)


def arm(at_s: float = NOW_S, slow: dict[int, DriverSlow] | None = None) -> ArmState:
    """An arm of generation 1 whose drivers have been heard."""
    given = slow or {}
    fast = Reading(DriverFast(speed_deg_s=-0.04, current_a=1.236, position_deg=None), at_s)
    return arm_state(at_s=at_s)._replace(
        drivers_slow=heard_six((given.get(joint, WELL) for joint in range(1, 7)), at_s),
        drivers_fast=(fast,) * 6,
    )


class Clock:
    """The computer's clock, in the test's hand."""

    def __init__(self) -> None:
        self.now = NOON

    def __call__(self) -> datetime:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def monitor(controller: FakeController, clock: Clock) -> JointMonitor:
    monitor = JointMonitor(controller.as_real, clock, controller.as_real)
    controller.be(operating_state(generation=Generation.ONE))
    return monitor


@pytest.fixture
def model(monitor: JointMonitor) -> JointStatusModel:
    model = JointStatusModel(monitor)
    monitor.updated.connect(model.refresh)
    return model


@pytest.fixture
def button(qtbot: QtBot, monitor: JointMonitor) -> JointStatusButton:
    button = JointStatusButton(monitor)
    qtbot.addWidget(button)
    return button


@pytest.fixture
def page(qtbot: QtBot, controller: FakeController, monitor: JointMonitor) -> JointStatusPage:
    page = JointStatusPage(controller.as_real, monitor)
    page.resize(*DRAWER_PX)
    shown(qtbot, page)
    return page


def view(model: JointStatusModel, row: int, joint: int) -> CellView:
    found = model.index(row, joint - 1).data(CELL_ROLE)
    assert isinstance(found, CellView)
    return found


# Cells --------------------------------------------------------------------------------------------


def test_figures_have_a_fixed_number_of_decimals_and_their_unit(
    controller: FakeController, model: JointStatusModel
) -> None:
    controller.hear(arm())
    assert [view(model, row, 1).small for row in range(10)] == [
        "",
        "24.0 V",
        "-3 °C",
        "1.24 A",
        "31 °C",
        "",
        "",
        "0.0°/s",  # never a negative zero
        "",
        "",
    ]


@pytest.mark.parametrize("code", [0x00, 0x01, 0x40, 0xC0])
def test_the_status_code_is_written_as_the_manual_does(
    controller: FakeController, model: JointStatusModel, code: int
) -> None:
    driver = WELL._replace(
        undervoltage=bool(code & 1), enabled=bool(code & 0x40), homed=bool(code & 0x80)
    )
    controller.hear(arm(slow={4: driver}))
    assert view(model, 0, 4).text == {0: "0x0", 1: "0x1", 0x40: "0x40", 0xC0: "0xC0"}[code]
    assert view(model, 0, 4).mark is None


def test_a_fault_shows_its_figure_and_since_when_until_it_ends(
    controller: FakeController, model: JointStatusModel, clock: Clock
) -> None:
    controller.hear(arm())
    clock.now = NOON + timedelta(seconds=65)
    controller.hear(arm(slow={2: WELL._replace(undervoltage=True, voltage_v=18.3)}))
    clock.now = NOON + timedelta(seconds=70)
    controller.hear(arm(slow={2: WELL._replace(undervoltage=True, voltage_v=18.1)}))
    assert view(model, VOLTAGE, 2) == CellView("Too low", "18.1 V", "12:01:05", Mark.FAULT, False)
    assert view(model, VOLTAGE, 2).small == "18.1 V · 12:01:05"
    tip = model.index(VOLTAGE, 1).data(Qt.ItemDataRole.ToolTipRole)
    assert tip == "J2  Supply voltage: Too low · 18.1 V · since 2026-01-02 12:01:05"

    controller.hear(arm())
    assert view(model, VOLTAGE, 2) == CellView("Normal", "24.0 V", "", Mark.GOOD, False)
    assert view(model, VOLTAGE, 1).mark is Mark.GOOD


def test_off_is_no_fault(controller: FakeController, model: JointStatusModel) -> None:
    controller.hear(arm(slow={1: WELL._replace(enabled=False)}))
    assert view(model, ENABLED, 1).mark is Mark.OFF
    assert view(model, HOMED, 1) == CellView("Not homed", "", "", Mark.OFF, False)


def test_what_was_never_heard_is_a_dash_with_a_mark_of_its_own(
    controller: FakeController, model: JointStatusModel
) -> None:
    controller.hear(arm_state())  # no driver yet
    assert view(model, CURRENT, 3) == CellView("—", "", "", Mark.UNKNOWN, False)
    assert view(model, 0, 3) == CellView("—", "", "", None, False)
    assert view(model, 9, 3).text == "Normal"


def test_without_a_link_everything_heard_is_stale(
    controller: FakeController, model: JointStatusModel
) -> None:
    controller.hear(arm())
    controller.be(operating_state(generation=Generation.ONE, link=LinkState.LOST))
    assert all(view(model, row, joint).stale for row in range(10) for joint in range(1, 7))


def test_only_cells_that_changed_are_drawn_again(
    qtbot: QtBot, controller: FakeController, model: JointStatusModel
) -> None:
    controller.hear(arm())
    changed: list[tuple[int, int]] = []
    model.dataChanged.connect(lambda first, _last: changed.append((first.row(), first.column())))
    controller.hear(arm())
    assert changed == []
    controller.hear(arm(slow={5: WELL._replace(motor_temperature_c=80.0)}))
    assert changed == [(MOTOR_TEMPERATURE, 4)]


# The page -----------------------------------------------------------------------------------------


def test_a_refusal_to_clear_is_said_in_the_page(
    qtbot: QtBot, controller: FakeController, page: JointStatusPage
) -> None:
    controller.answer = LINK_LOST()
    qtbot.mouseClick(page.clear_buttons[4], Qt.MouseButton.LeftButton)
    assert controller.calls[-1] == ("clear_joint_error", 4)
    said = page.findChild(MessageLine, "joint_status_message")
    assert said.text() == words.refusal(LINK_LOST())
    assert not page.findChild(QLabel, "joint_status_detail").isVisible()
    page.table.setCurrentIndex(page.table.model().index(1, 1))
    assert said.text() == ""
    assert page.findChild(QLabel, "joint_status_detail").text().startswith("J2")


def test_the_buttons_stand_above_their_columns(page: JointStatusPage) -> None:
    table = page.table
    for column, button in enumerate(page.clear_buttons.values()):
        left = table.viewport().mapTo(page, table.viewport().rect().topLeft()).x()
        left += table.columnViewportPosition(column)
        place = button.mapTo(page, button.rect().topLeft())
        assert left <= place.x()
        assert place.x() + button.width() <= left + table.columnWidth(column) + 2
        assert place.y() + button.height() <= table.y()


@pytest.mark.parametrize("said", [False, True])
@pytest.mark.parametrize("language", LANGUAGES)
def test_in_the_drawer_of_a_small_window_all_rows_are_seen(
    qapp: QApplication,
    controller: FakeController,
    page: JointStatusPage,
    translator: Translator,
    language: Language,
    said: bool,
) -> None:
    apply_theme(qapp, Theme.LIGHT)
    controller.hear(arm())
    translator.set_language(language)
    if said:
        controller.answer = LINK_LOST()
        page.clear_buttons[4].click()
    QApplication.processEvents()
    assert page.minimumSizeHint().width() <= DRAWER_PX[0]
    assert page.minimumSizeHint().height() <= DRAWER_PX[1]
    table = page.table
    below = table.rowViewportPosition(9) + table.rowHeight(9)
    assert below <= table.viewport().height()
    assert min(table.rowHeight(row) for row in range(10)) >= 17


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_fault_has_its_figure_beside_its_word(
    qapp: QApplication, page: JointStatusPage, translator: Translator, language: Language
) -> None:
    """Each column of the drawer has room for the longest word and the widest figure."""
    apply_theme(qapp, Theme.LIGHT)
    translator.set_language(language)
    QApplication.processEvents()
    figure = QFontMetrics(scaled_font(page.table, 0.84)).horizontalAdvance(" -00.00 A ")
    columns = [page.table.columnWidth(column) for column in range(6)]
    assert min(columns) >= word_width(page.table) + figure


@pytest.mark.parametrize("language", LANGUAGES)
def test_in_the_smallest_window_every_word_is_seen(
    qapp: QApplication, page: JointStatusPage, translator: Translator, language: Language
) -> None:
    apply_theme(qapp, Theme.LIGHT)
    translator.set_language(language)
    QApplication.processEvents()
    assert page.minimumSizeHint().width() <= 816


# The button ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("slow", "text", "mark"),
    [
        ({}, "Normal", Mark.GOOD),
        ({3: WELL._replace(enabled=False)}, "Disabled J3", Mark.OFF),
        (dict.fromkeys(range(1, 7), WELL._replace(enabled=False)), "Disabled", Mark.OFF),
        ({2: WELL._replace(overcurrent=True)}, "Fault J2", Mark.FAULT),
        (dict.fromkeys(range(1, 7), WELL._replace(overcurrent=True)), "Fault J1–J6", Mark.FAULT),
    ],
)
def test_the_button_says_the_worst_in_words_and_shape(
    controller: FakeController,
    button: JointStatusButton,
    slow: dict[int, DriverSlow],
    text: str,
    mark: Mark,
) -> None:
    controller.hear(arm(slow=slow))
    assert (button.state_text, button.mark) == (text, mark)
    assert button.accessibleName() == f"Joint status {text}"


@pytest.mark.parametrize(
    ("link", "text"),
    [
        (LinkState.NO_DEVICE, "Unknown —"),
        (LinkState.OPENING, "Unknown —"),
        (LinkState.OFFLINE, "Offline"),
        (LinkState.LOST, "Offline"),
    ],
)
def test_the_button_follows_the_link(
    controller: FakeController, button: JointStatusButton, link: LinkState, text: str
) -> None:
    controller.be(operating_state(generation=None, link=link))
    assert button.state_text == text


def test_the_button_is_drawn_again_only_when_the_worst_changes(
    controller: FakeController, monitor: JointMonitor
) -> None:
    told: list[StatusVerdict] = []
    monitor.worst_changed.connect(lambda: told.append(monitor.worst.verdict))
    controller.hear(arm())
    controller.hear(arm(at_s=NOW_S + 0.1))
    controller.hear(arm(slow={1: WELL._replace(voltage_v=20.0)}))
    assert told == [StatusVerdict.NORMAL]


# Words and marks ----------------------------------------------------------------------------------

MANUAL = {
    Item.STATUS_CODE: "状态码:",
    Item.SUPPLY_VOLTAGE: "电源电压:",
    Item.MOTOR_TEMPERATURE: "电机温度:",
    Item.DRIVER_CURRENT: "驱动器电流:",
    Item.DRIVER_TEMPERATURE: "驱动器温度:",
    Item.SENSOR: "传感器状态:",
    Item.COLLISION_PROTECTION: "碰撞保护:",
    Item.DRIVER_FAULT: "驱动器错误状态:",
    Item.DRIVER_ENABLED: "驱动器使能状态:",
    Item.HOMED: "回零状态:",
    Item.STALL_PROTECTION: "堵转保护:",
    Item.COMMUNICATION: "关节通讯:",
    Word.NORMAL: "正常",
    Word.TOO_LOW: "过低",
    Word.TOO_HOT: "过温",
    Word.OVERCURRENT: "过流",
    Word.ABNORMAL: "异常",
    Word.ERROR: "错误",
    Word.TRIGGERED: "触发保护",
    Word.ENABLED: "使能",
    Word.DISABLED: "失能",
    Word.NOT_HOMED: "没有回零",
    Word.HOMED: "已经回零",
    StatusVerdict.NORMAL: "正常",
    StatusVerdict.DISABLED: "失能",
    StatusVerdict.UNKNOWN: "未知",
    StatusVerdict.FAULT: "有故障",
    StatusVerdict.OFFLINE: "离线",
}


@pytest.mark.parametrize("code", [*Item, *Word, *StatusVerdict])
def test_every_word_is_the_manuals(
    translator: Translator, code: Item | Word | StatusVerdict
) -> None:
    look_up = {Item: words.joint_item, Word: words.joint_word, StatusVerdict: words.joint_verdict}
    english = look_up[type(code)](code)  # type: ignore[operator]
    assert english.isascii()
    translator.set_language("zh")
    assert look_up[type(code)](code) == MANUAL[code]  # type: ignore[operator]


@pytest.mark.parametrize("colors", [LIGHT, DARK], ids=["light", "dark"])
def test_marks_differ_without_their_colours(qapp: QApplication, colors: Colors) -> None:
    pictures = []
    for mark in Mark:
        picture = QImage(24, 24, QImage.Format.Format_RGB32)
        picture.fill(QColor(colors.surface))
        painter = QPainter(picture)
        state_mark.draw(painter, colors, QPointF(12, 12), 9, mark, muted=True)
        painter.end()
        pictures.append(picture)
    assert all(
        one != other for place, one in enumerate(pictures) for other in pictures[place + 1 :]
    )
