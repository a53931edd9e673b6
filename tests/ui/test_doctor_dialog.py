"""The window 诊断 by clicks: what it examines, what the operator reads, what is copied."""

from __future__ import annotations

from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QLineEdit, QProgressBar, QPushButton
from pytestqt.qtbot import QtBot

from armui.arm.device import Device
from armui.bus.adapters import BUS_BUSY
from armui.control.link.link_state import LinkState
from armui.doctor.judge import LINK_DOWN, PACKAGES
from armui.doctor.judge_heard import NOTHING_HEARD
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.dialogs.doctor import DoctorDialog
from tests.ui.arm_states import NOW_S, arm_state, operating_state
from tests.ui.dialog_reading import message, shown, words_of
from tests.ui.fake_controller import FakeController

LEFT = Qt.MouseButton.LeftButton
DOWN = LINK_DOWN("sudo ip link set can0 up", channel="can0")
FINE = PACKAGES(count="12")
SILENT = NOTHING_HEARD(device="x", seconds="2", count="0")


class Examinations:
    """Examinations that a test answers."""

    def __init__(self) -> None:
        self.arguments: list[list[str]] = []
        self.ended = 0
        self.on_answer: Any = None

    def __call__(self, arguments, on_answer):
        self.arguments.append(list(arguments))
        self.on_answer = on_answer
        return self

    def end(self) -> None:
        self.ended += 1


@pytest.fixture
def examinations() -> Examinations:
    return Examinations()


@pytest.fixture
def dialog(qtbot: QtBot, controller: FakeController, examinations: Examinations) -> DoctorDialog:
    dialog = DoctorDialog(controller.as_real, None, examinations)
    qtbot.addWidget(dialog)
    dialog.open()
    qtbot.waitExposed(dialog)
    return dialog


def answer(qtbot: QtBot, dialog: DoctorDialog, examinations: Examinations, findings) -> None:
    examinations.on_answer(findings)
    qtbot.waitUntil(lambda: not dialog.findChild(QProgressBar).isVisible())


def test_it_examines_when_it_is_opened(dialog, examinations):
    assert examinations.arguments == [[]]
    assert dialog.findChild(QProgressBar).isVisible()
    assert not dialog.again_button.isEnabled()
    assert not dialog.copy_button.isEnabled()


def test_findings_with_their_remedies(qtbot, dialog, examinations):
    answer(qtbot, dialog, examinations, [FINE, DOWN])
    assert message(dialog) == "Faults: 1, warnings: 0"
    assert "can0 is switched off." in words_of(dialog)
    assert dialog.findChild(QLineEdit).text() == "sudo ip link set can0 up"
    qtbot.mouseClick(dialog.findChild(QPushButton, "copy_command"), LEFT)
    assert QGuiApplication.clipboard().text() == "sudo ip link set can0 up"


def test_another_language_while_it_is_shown(qtbot, dialog, examinations, translator):
    answer(qtbot, dialog, examinations, [DOWN])
    translator.set_language("zh")
    qtbot.waitUntil(lambda: "can0 未启用。" in words_of(dialog))
    assert "[故障] can0 未启用。" in dialog.report()


def test_the_report_is_copied_whole(qtbot, dialog, examinations):
    answer(qtbot, dialog, examinations, [FINE, DOWN])
    qtbot.mouseClick(dialog.copy_button, LEFT)
    text = QGuiApplication.clipboard().text()
    assert text.startswith("armui doctor ")
    assert "[FAIL] can0 is switched off." in text
    assert "$ sudo ip link set can0 up" in text


def test_many_findings_come_a_few_at_a_time(qtbot, dialog, examinations):
    answer(qtbot, dialog, examinations, [FINE, *[DOWN] * 40])
    qtbot.waitUntil(lambda: len(dialog.findChildren(QLineEdit)) == 40)
    assert message(dialog) == "Faults: 40, warnings: 0"


def test_nothing_wrong(qtbot, dialog, examinations):
    answer(qtbot, dialog, examinations, [FINE])
    assert message(dialog) == "No fault was found."


def test_an_examination_that_fails_says_why(qtbot, dialog, examinations):
    answer(qtbot, dialog, examinations, "no Python")
    assert message(dialog) == "The diagnosis failed: no Python"
    assert not dialog.copy_button.isEnabled()


def test_again(qtbot, dialog, examinations):
    answer(qtbot, dialog, examinations, [DOWN])
    qtbot.mouseClick(dialog.again_button, LEFT)
    assert len(examinations.arguments) == 2
    answer(qtbot, dialog, examinations, [FINE])
    assert "can0" not in words_of(dialog)


def test_closing_ends_the_examination_and_what_it_says_later(qtbot, dialog, examinations):
    late = examinations.on_answer
    dialog.close()
    assert examinations.ended == 1
    late([DOWN])
    dialog.open()
    answer(qtbot, dialog, examinations, [FINE])
    assert "can0" not in words_of(dialog)


def test_a_device_that_could_not_be_connected_is_examined_itself(dialog, examinations):
    dialog.examine_device(Device("slcan", "/dev/ttyACM0", 500_000))
    assert examinations.arguments[-1] == [
        "--interface", "slcan", "--channel", "/dev/ttyACM0", "--bitrate", "500000",
    ]  # fmt: skip
    dialog.examine_device(Device("virtual", "x", None, simulated=True))
    assert examinations.arguments[-1] == []


def test_an_open_device_is_left_alone_and_its_arm_judged_here(
    qtbot, controller, dialog, examinations
):
    controller.be(operating_state())
    controller.hear(arm_state(arm_status=1))
    qtbot.mouseClick(dialog.close_button, LEFT)
    dialog.open()
    assert examinations.arguments[-1] == ["--no-listen"]
    answer(qtbot, dialog, examinations, [FINE, SILENT])
    text = words_of(dialog)
    assert "an arm of generation 2" in text
    assert "The arm is in emergency stop." in text
    assert "not one frame" not in text


def test_a_device_without_an_arm(qtbot, controller, dialog, examinations):
    controller.be(operating_state(link=LinkState.OFFLINE))
    dialog.examine()
    answer(qtbot, dialog, examinations, [FINE])
    assert "not one frame" in words_of(dialog)


# --- offered when connecting fails ------------------------------------------------------------


def test_the_diagnosis_is_offered_when_connecting_fails(qtbot, controller):
    dialog = ConnectDialog(controller.as_real)
    shown(qtbot, dialog)
    assert not dialog.diagnosis_button.isVisible()
    adapter = Device("gs_usb", "0")
    controller.devices_found.emit([adapter])
    refusal = BUS_BUSY(device="gs_usb 0", interface="gs_usb")
    controller.be(operating_state(link=LinkState.NO_DEVICE, device=None, link_problem=refusal))
    assert dialog.diagnosis_button.isVisible()
    with qtbot.waitSignal(dialog.diagnosis_wanted) as wanted:
        qtbot.mouseClick(dialog.diagnosis_button, LEFT)
    assert wanted.args == [adapter]


def test_and_when_nothing_is_heard(qtbot, controller):
    dialog = ConnectDialog(controller.as_real)
    shown(qtbot, dialog)
    controller.be(operating_state(link=LinkState.OFFLINE))
    assert dialog.diagnosis_button.isVisible()
    controller.be(operating_state())
    controller.hear(arm_state(at_s=NOW_S + 1))
    assert not dialog.diagnosis_button.isVisible()
