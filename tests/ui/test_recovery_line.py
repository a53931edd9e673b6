"""The line above the panels: what it says while nothing stands in the way."""

import pytest
from PySide6.QtCore import QRect, Qt
from PySide6.QtWidgets import QLabel

from armui.control.events import Level
from armui.control.safety.recovery_steps import Action, Step, StepKind
from armui.control.safety.uncommanded_motion import MotionKind, UncommandedMotion, Unheld
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


@pytest.mark.parametrize("width", [1000, 700])
def test_what_is_outside_is_whole_beside_a_run_that_has_ended(line, controller, width):
    outside = ", ".join(f"J{joint} -170.0° < -150°" for joint in range(1, 5))
    step = Step(StepKind.OUTSIDE, Level.WARNING, {"outside": outside}, Action.COME_INSIDE)
    controller.recovery.show(step)
    line.resize(width, line.sizeHint().height())
    text = line.findChild(QLabel, "recovery_text")
    room = text.contentsRect()
    wide = QRect(0, 0, room.width(), 9999)
    needed = text.fontMetrics().boundingRect(wide, Qt.TextFlag.TextWordWrap, text.text())
    assert needed.height() <= room.height()
    assert outside in text.text()
    assert "these move slowly" in line.accessibleName()


def test_what_is_below_a_sinking_arm_is_said_once(line, controller):
    controller.area_guard.below = lambda: "post"
    motion = UncommandedMotion(MotionKind.SINKS, Unheld.STOPPED, 3, 20, 2, 7.7, 5, "post")
    step = Step(StepKind.STOPPED, Level.WARNING, action=Action.RESUME, motion=motion)
    line.resize(3000, 54)
    controller.recovery.show(step)
    assert line.accessibleName().count("post") == 1
    line.resize(700, 54)  # the shorter one does not have it otherwise
    assert line.findChild(QLabel, "recovery_text").text().count("post") == 1
