"""The adapter set up by a click: its buttons, the files shown before, and what came of it."""

import pytest
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QLineEdit, QPushButton

from armui.arm.device import Device
from armui.doctor import adapter_change
from armui.doctor.adapter_change import (
    ADAPTER_DISMISSED,
    ADAPTER_NOT_AUTHORISED,
    BY_ANYBODY,
    BY_ROOT,
    Done,
    Planned,
)
from armui.doctor.facts import CanFacts, LinkFacts, SerialPortFacts
from armui.doctor.judge import judge_can
from armui.doctor.judge_heard import ARM, NOTHING_HEARD
from armui.ui.background import Background
from armui.ui.dialogs.adapter_line import AdapterLine, KeepDialog
from armui.ui.dialogs.connect import AdapterTrouble
from armui.ui.dialogs.doctor import DoctorDialog
from armui.ui.dialogs.finding_row import FindingRow
from tests.app_driver import AtOnce
from tests.ui.arm_states import operating_state
from tests.ui.dialog_reading import words_of
from tests.ui.fake_controller import FakeController

LEFT = Qt.MouseButton.LeftButton
DOWN = CanFacts(links=(LinkFacts("can0", "can", False),))
FILES = Planned({"/etc/systemd/network/70-armui-arm_left.link": "[Link]\nName=arm_left\n"})
HEARD = ARM(device="can0", generation="2", rate="3000")
NOTHING = NOTHING_HEARD(device="can0", seconds="2.0")


class Changes:
    """Changes that a test answers."""

    def __init__(self):
        self.begun = []
        self.went = self.ended = 0
        self.on_answer = None

    def __call__(self, words, on_answer, command):
        self.begun.append((tuple(words), command))
        self.on_answer = on_answer
        return self

    def go(self):
        self.went += 1

    def end(self):
        self.ended += 1


class Examinations:
    """Listening that a test answers."""

    def __init__(self):
        self.arguments = []
        self.on_answer = None
        self.ended = 0

    def __call__(self, arguments, on_answer):
        self.arguments.append(list(arguments))
        self.on_answer = on_answer
        return self

    def end(self):
        self.ended += 1


@pytest.fixture
def controller(qapp):
    return FakeController()


@pytest.fixture
def changes():
    return Changes()


@pytest.fixture
def examinations():
    return Examinations()


@pytest.fixture
def line(qtbot, controller, changes, examinations):
    line = AdapterLine(controller.as_real, changes, examinations, lambda: True)
    qtbot.addWidget(line)
    return line


def told(changes, answer):
    changes.on_answer(answer)
    QCoreApplication.processEvents()


def trouble_with(qtbot, line, facts):
    trouble = AdapterTrouble(Background(AtOnce()), lambda: judge_can(facts), line)
    qtbot.addWidget(trouble)
    trouble.examine()
    return trouble


def test_a_button_takes_the_place_of_the_command(qtbot, line, changes):
    trouble = trouble_with(qtbot, line, DOWN)
    (row,) = trouble.findChildren(FindingRow)
    texts = [button.text() for button in row.remedy_buttons]
    assert texts == ["Switch on: 1 Mbit/s", "Switch on: 500 kbit/s"]
    assert "sudo ip link set can0 up" in row.remedy_buttons[0].toolTip()
    assert row.findChildren(QLineEdit) == []
    qtbot.mouseClick(row.remedy_buttons[0], LEFT)
    assert changes.begun == [(("up", "can0", "1000000"), BY_ROOT)]
    assert "password" in line.text()


def test_without_the_packages_helper_there_is_the_command(qtbot, controller):
    line = AdapterLine(controller.as_real, is_there=lambda: False)
    qtbot.addWidget(line)
    trouble = trouble_with(qtbot, line, DOWN)
    (row,) = trouble.findChildren(FindingRow)
    assert row.remedy_buttons == []
    assert row.findChild(QLineEdit).text().startswith("sudo ip link set can0 up")


def test_success_is_what_is_heard(qtbot, line, changes, examinations):
    line.choose(("up", "can0", "1000000"))
    told(changes, Planned())
    assert changes.went == 1
    told(changes, Done({"up": True, "bitrate": 1_000_000}))
    assert examinations.arguments == [["--interface", "socketcan", "--channel", "can0"]]
    examinations.on_answer([NOTHING])
    QCoreApplication.processEvents()
    assert "not one frame" in line.text()
    line.choose(("reset", "can0"))
    told(changes, Planned())
    told(changes, Done({"up": True}))
    examinations.on_answer([HEARD])
    QCoreApplication.processEvents()
    assert "3000 frames/s" in line.text()


def test_on_the_adapter_that_is_connected_the_frames_are_counted(
    qtbot, controller, line, changes, examinations
):
    controller.be(operating_state(device=Device("socketcan", "can0", None)))
    for frames, said in ((0, "nothing is heard"), (7, "7 frames were heard")):
        line.choose(("reset", "can0"))
        told(changes, Planned())
        told(changes, Done({"up": True}))
        assert "listening" in line.text()
        controller.state = controller.state._replace(frames=controller.state.frames + frames)
        line._count(line._number, "can0")  # the time it listens has passed
        assert said in line.text()
    assert examinations.arguments == []


@pytest.mark.parametrize("reason", [ADAPTER_DISMISSED, ADAPTER_NOT_AUTHORISED], ids=str)
def test_polkit_says_no(qtbot, line, changes, reason):
    trouble = trouble_with(qtbot, line, DOWN)
    qtbot.mouseClick(trouble.findChildren(FindingRow)[0].remedy_buttons[0], LEFT)
    told(changes, reason(text="Not authorized"))
    assert "othing was changed" in line.text()
    row = trouble._rows[0]
    if reason is ADAPTER_NOT_AUTHORISED:  # the way by the terminal is left
        assert row.findChild(QLineEdit).text().startswith("sudo ip link")
    else:
        assert len(row.remedy_buttons) == 2


def test_it_can_be_given_up_and_what_comes_later_is_not_heeded(qtbot, line, changes):
    line.choose(("up", "can0", "1000000"))
    qtbot.mouseClick(line.cancel_button, LEFT)
    assert changes.ended == 1
    told(changes, Planned())
    told(changes, Done({}))
    assert changes.went == 0
    assert line.text().startswith("Cancelled")


def test_one_after_another(line, changes):
    line.choose(("up", "can0", "1000000"))
    line.choose(("up", "can1", "1000000"))
    assert len(changes.begun) == 1


def keep_dialog(line):
    return line.window().findChild(KeepDialog)


def test_the_files_are_seen_before_they_are_written(qtbot, line, changes):
    line.choose(("remember", "can0", "1000000"))
    dialog = keep_dialog(line)
    assert changes.begun[-1] == (("remember", "can0", "arm_can0", "1000000"), BY_ANYBODY)
    assert not dialog.agree_button.isEnabled()
    told(changes, FILES)
    assert "Name=arm_left" in dialog.files.toPlainText()
    assert "/etc/systemd/network/70-armui-arm_left.link" in dialog.files.toPlainText()
    assert changes.went == 0

    dialog.name_edit.setText("arm_left")
    assert not dialog.agree_button.isEnabled()  # these files were another name's
    qtbot.waitUntil(lambda: len(changes.begun) == 2)
    told(changes, FILES)
    qtbot.mouseClick(dialog.agree_button, LEFT)
    assert changes.begun[-1] == (("remember", "can0", "arm_left", "1000000"), BY_ROOT)
    told(changes, FILES)
    assert changes.went == 1
    told(changes, Done({"not_told": []}))
    assert "plugged in again" in line.text()


def test_another_adapter_than_was_shown_is_not_written(qtbot, line, changes):
    line.start(("remember", "can0", "arm_left", "1000000"), FILES)
    told(changes, Planned({"/etc/x": "of the other one"}))
    assert (changes.went, changes.ended) == (0, 1)
    assert "not the one that was shown" in line.text()


def test_an_impossible_name_is_said_as_it_is_typed(qtbot, line, changes):
    line.choose(("remember", "can0", "1000000"))
    told(changes, adapter_change.ADAPTER_BAD_NAME(text="can0"))
    dialog = keep_dialog(line)
    assert "This name is not possible" in words_of(dialog)
    assert not dialog.agree_button.isEnabled()
    dialog.close()


def test_what_is_kept_is_taken_away_by_a_button(qtbot, line, changes):
    facts = CanFacts(kept=("arm_left", "port-20_8A"))
    found = judge_can(facts)
    assert [each.remedies for each in found if each.remedies] == [
        (("forget", "arm_left"),),
        (("forget", "port-20_8A"),),
    ]
    line.choose(("forget", "arm_left"))
    told(changes, Planned({}, ("/etc/systemd/network/70-armui-arm_left.link",)))
    dialog = keep_dialog(line)
    assert "Taken away: /etc/systemd/network/70-armui-arm_left.link" in dialog.files.toPlainText()
    qtbot.mouseClick(dialog.agree_button, LEFT)
    assert changes.begun[-1] == (("forget", "arm_left"), BY_ROOT)


def test_a_serial_adapter_is_opened_the_same_way(qtbot, line, changes):
    closed = SerialPortFacts("/dev/ttyACM0", False, "dialout")
    trouble = trouble_with(qtbot, line, CanFacts(ports=(closed,)))
    (row,) = trouble.findChildren(FindingRow)
    qtbot.mouseClick(row.remedy_buttons[0], LEFT)
    assert changes.begun == [(("remember", "ttyACM0"), BY_ANYBODY)]


def test_in_the_diagnosis_all_is_looked_at_again(qtbot, controller, line, changes, examinations):
    dialog = DoctorDialog(controller.as_real, None, examinations, line)
    qtbot.addWidget(dialog)
    dialog.open()
    examinations.on_answer(judge_can(DOWN))
    qtbot.waitUntil(lambda: dialog.findChild(QPushButton, "adapter_remedy") is not None)
    qtbot.mouseClick(dialog.findChild(QPushButton, "adapter_remedy"), LEFT)
    told(changes, Planned())
    told(changes, Done({"up": True}))
    # opened, and all again: nobody else listens meanwhile to the adapter that came up
    assert examinations.arguments == [[], []]
    assert "listening" in line.text()
    elsewhere = NOTHING_HEARD(device="socketcan can1", seconds="2.0")
    examinations.on_answer([elsewhere, ARM(device="socketcan can0", generation="2", rate="3000")])
    qtbot.waitUntil(lambda: "3000 frames/s" in line.text())
    dialog.close()


def test_the_line_listens_where_the_diagnosis_does_not(
    qtbot, controller, line, changes, examinations
):
    dialog = DoctorDialog(controller.as_real, None, examinations, line)
    qtbot.addWidget(dialog)
    dialog.open()
    examinations.on_answer(judge_can(DOWN))
    controller.be(operating_state(device=Device("socketcan", "can1", None)))
    line.choose(("up", "can0", "1000000"))
    told(changes, Planned())
    told(changes, Done({"up": True}))
    only_can0 = ["--interface", "socketcan", "--channel", "can0"]
    assert examinations.arguments[1:] == [only_can0, ["--no-listen"]]
    dialog.close()


def test_an_interface_that_is_up_is_switched_off_by_the_button_beside(qtbot, line, changes):
    passive = LinkFacts("can0", "can", up=True, state="ERROR-PASSIVE", bitrate=1_000_000)
    trouble = trouble_with(qtbot, line, CanFacts(links=(passive,)))
    row = trouble.findChildren(FindingRow)[0]
    assert [each.text() for each in row.remedy_buttons] == ["Switch on: 1 Mbit/s", "Switch off"]
    qtbot.mouseClick(row.remedy_buttons[1], LEFT)
    assert changes.begun == [(("down", "can0"), BY_ROOT)]
    told(changes, Planned())
    told(changes, Done({"up": False}))
    assert line.text() == "can0 is switched off."


def test_it_is_not_switched_off_while_the_arm_moves_on_it(controller, line, changes):
    can0 = Device("socketcan", "can0", None)
    controller.be(operating_state(device=can0, moving=True))
    line.choose(("down", "can0"))
    assert changes.begun == []
    assert "only way" in line.text()
    # nor where it began to move while the password was asked for
    controller.be(operating_state(device=can0))
    line.choose(("down", "can0"))
    controller.be(operating_state(device=can0, moving=True))
    told(changes, Planned())
    assert (changes.went, changes.ended) == (0, 1)


def test_wsl_is_told_in_words():
    (finding,) = [each for each in judge_can(CanFacts(wsl=True)) if each.code == "wsl"]
    assert finding.commands[-1] == "usbipd attach --wsl --busid BUSID"
    assert finding.remedies == ()
