"""The line above the panels: what it says while nothing stands in the way."""

import pytest
from PySide6.QtWidgets import QLabel

from armui.control.events import Level
from armui.control.safety.recovery_steps import Step, StepKind
from armui.ui.shell.recovery_line import RecoveryLine


@pytest.fixture
def line(qtbot, controller):
    line = RecoveryLine(controller, lambda: None, lambda: None)
    qtbot.addWidget(line)
    line.show()
    return line


@pytest.mark.parametrize(
    ("kind", "level", "said", "sign"),
    [
        (StepKind.READY, Level.DONE, "Ready", True),
        (StepKind.MOVING, Level.INFO, "The arm is moving", False),
        (StepKind.RUNNING, Level.INFO, "A trajectory is running", False),
        (StepKind.RUN_WAITS, Level.INFO, "Waiting: press “Next step”", True),
        (
            StepKind.RUN_PAUSED,
            Level.WARNING,
            "Paused: with the speed above 0 %, hold “Continue” for 1 s",
            True,
        ),
    ],
)
def test_it_says_what_the_arm_is_at(line, controller, kind, level, said, sign):
    controller.recovery.show(Step(kind, level))
    text = line.findChild(QLabel, "recovery_text")
    assert (text.text(), line.accessibleName()) == (said, said)
    icon = text.parentWidget().findChildren(QLabel)[0]
    assert icon.pixmap().isNull() is not sign
