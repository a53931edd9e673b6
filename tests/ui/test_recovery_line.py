"""The line above the panels: what it says while nothing stands in the way."""

import pytest
from PySide6.QtWidgets import QLabel

from armui.control.events import Level
from armui.control.safety.recovery_steps import Step, StepKind
from armui.ui.shell.recovery_line import RecoveryLine
from tests.ui.arm_states import operating_state


@pytest.fixture
def line(qtbot, controller):
    line = RecoveryLine(controller, lambda: None)
    qtbot.addWidget(line)
    line.show()
    return line


def said(line):
    return line.findChild(QLabel, "recovery_text").text()


def test_a_run_is_not_called_ready(line, controller):
    controller.be(operating_state())
    controller.recovery.show(Step(StepKind.READY, Level.DONE))
    assert said(line) == "Ready"
    controller.be(operating_state(running=True))
    assert said(line) == "A trajectory is running"
    assert line.accessibleName() == "A trajectory is running"
    controller.be(operating_state())
    assert said(line) == "Ready"


def test_what_stands_in_the_way_of_a_run_is_said_first(line, controller):
    controller.be(operating_state(running=True))
    controller.recovery.show(Step(StepKind.PAUSED, Level.WARNING))
    assert said(line) != "A trajectory is running"
    controller.recovery.show(Step(StepKind.READY, Level.DONE))
    assert said(line) == "A trajectory is running"
