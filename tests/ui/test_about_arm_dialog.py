"""The window «About this arm»: every value was heard or read, or is said to be unknown."""

from __future__ import annotations

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from armui.arm.device import Device
from armui.arm.model_check import ModelFit
from armui.arm.state import Reading
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState
from armui.doctor.facts import LinkFacts
from armui.protocol.addressing import Addressing
from armui.protocol.generation import Generation, PiperModel
from armui.ui.background import Background
from armui.ui.dialogs import about_arm
from armui.ui.dialogs.about_arm import AboutArmDialog
from armui.ui.dialogs.online_since import OnlineSince
from tests.app_driver import AtOnce
from tests.family import FACTORY_LIMITS
from tests.ui.arm_states import NOW_S, arm_state, operating_state
from tests.ui.dialog_reading import shown
from tests.ui.fake_controller import FakeController

CAN0 = Device("socketcan", "can0", None)


@pytest.fixture
def links(monkeypatch) -> list[LinkFacts]:
    known = [LinkFacts("can0", "can", True, "ERROR-ACTIVE", 1_000_000, serial="0031002F")]
    monkeypatch.setattr(about_arm, "probe_links", lambda: tuple(known))
    return known


@pytest.fixture
def dialog(qtbot: QtBot, controller: FakeController, links) -> AboutArmDialog:
    online = OnlineSince(controller.as_real, controller)
    return AboutArmDialog(controller.as_real, online, Background(AtOnce(), parent=controller))


def value(dialog: AboutArmDialog, key: str) -> str:
    label = dialog.findChild(QLabel, f"about_{key}")
    assert label is not None
    return label.text()


def connect(controller: FakeController, at_s: float = NOW_S, **changes) -> None:
    one, two, three, four, five, six = (Reading(each, at_s) for each in FACTORY_LIMITS)
    state = arm_state(at_s=at_s)._replace(
        firmware="S-V1.8-9",
        frames=0,
        limits=(one, two, three, four, five, six),
        accelerations_deg_s2=(Reading(286.5, at_s), None, None, None, None, None),
    )
    controller.hear(state)
    controller.be(operating_state(device=CAN0, generation=Generation.TWO, **changes))


def test_without_an_arm_everything_is_unknown(qtbot, controller, dialog):
    controller.be(OperatingState())
    shown(qtbot, dialog)
    assert value(dialog, "firmware") == "unknown"
    assert value(dialog, "device") == "none connected"
    assert value(dialog, "bitrate") == "unknown"
    assert value(dialog, "feedback") == "unknown"
    assert value(dialog, "online") == "not heard"
    assert value(dialog, "joint_1") == "unknown: not read from the arm"
    assert value(dialog, "model") == "none connected"


@pytest.mark.parametrize(
    ("fitting", "says"),
    [
        (None, "PiPER L, as chosen; not checked yet"),
        ({PiperModel.PIPER_L}, "PiPER L, confirmed by the pose it reports"),
        (
            {PiperModel.PIPER_L, PiperModel.PIPER},
            "PiPER L, as chosen; other models fit its pose as well",
        ),
        ({PiperModel.PIPER_X}, "PiPER L, as chosen; its pose is that of a PiPER X"),
        (set(), "PiPER L, as chosen; its pose fits none of the models"),
    ],
)
def test_the_model_is_the_operator_s_and_what_the_arm_tells_of_it(
    qtbot, controller, dialog, fitting, says
):
    connect(controller)
    fit = ModelFit(PiperModel.PIPER_L, None if fitting is None else frozenset(fitting))
    controller.be(replace(controller.operating_state, model_fit=fit))
    shown(qtbot, dialog)
    assert value(dialog, "model") == says


def test_an_arm_on_an_adapter(qtbot, controller, dialog):
    connect(controller)
    shown(qtbot, dialog)
    qtbot.waitUntil(lambda: value(dialog, "serial") == "0031002F")
    assert value(dialog, "firmware") == "S-V1.8-9"
    assert value(dialog, "generation") == "Generation 2"
    assert value(dialog, "device") == "socketcan, socketcan can0"
    assert value(dialog, "bitrate") == "1000000 bit/s, set by the operating system"
    assert value(dialog, "feedback") == "0x2A1 to 0x2A8 (offset 0x00)"
    assert value(dialog, "commands") == "0x150 to 0x15F (offset 0x00)"
    # 3 rad/s = 171.9 °/s
    assert value(dialog, "joint_1") == "-150.0° to 150.0°, at most 171.9°/s and 286.5°/s²"
    assert value(dialog, "joint_2") == "0.0° to 180.0°, at most 171.9°/s"


def test_shifted_identifiers_that_nothing_proves(qtbot, controller, dialog):
    connect(controller, addressing=Addressing(0x10, 0x20), control_certain=False)
    shown(qtbot, dialog)
    assert value(dialog, "feedback") == "0x2B1 to 0x2B8 (offset 0x10)"
    assert value(dialog, "commands").startswith("0x170 to 0x17F (offset 0x20), not proven")


def test_the_bit_rate_that_the_program_set(qtbot, controller, dialog):
    connect(controller)
    device = Device("slcan", "COM5", 500_000, serial="206E3599")
    controller.be(operating_state(device=device, generation=Generation.ONE))
    controller.hear(controller.state._replace(firmware=None))
    shown(qtbot, dialog)
    assert value(dialog, "bitrate") == "500000 bit/s, set by this program"
    assert value(dialog, "serial") == "206E3599"
    assert value(dialog, "firmware") == "unknown: generation 1 does not report it"


def test_how_long_and_how_often_the_arm_is_heard(qtbot, controller, dialog):
    connect(controller)
    shown(qtbot, dialog)
    controller.hear(controller.state._replace(last_feedback_s=NOW_S + 3_725, frames=7_450_000))
    dialog._timer.timeout.emit()
    assert value(dialog, "online") == "1:02:05"
    assert value(dialog, "rate") == "2000 per second"
    controller.be(operating_state(device=CAN0, link=LinkState.OFFLINE))
    assert value(dialog, "online") == "not heard"
    connect(controller, at_s=NOW_S + 4_000)
    assert value(dialog, "online") == "0 s"


def test_copied_as_text(qtbot, controller, dialog):
    connect(controller)
    shown(qtbot, dialog)
    qtbot.mouseClick(dialog.copy_button, Qt.MouseButton.LeftButton)
    lines = QGuiApplication.clipboard().text().splitlines()
    assert "Firmware: S-V1.8-9" in lines
    assert lines[-1].startswith("Program: armui ")
    assert dialog.findChild(QLabel, "about_arm_said").text()
