"""Closing the program while the arm moves: what this program moves is ended, or may finish."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QWidget

from armui.control.motion.motion_command import Mover
from armui.ui.dialogs.confirm import confirm
from armui.ui.shell.leaving import end_single_motion_then

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


def close_unless_moving(
    window: QWidget, controller: ArmController, close_now: Callable[[], object]
) -> None:
    """Close at once, or after the operator has said what becomes of the motion.

    Args:
        window: The main window, which asks.
        controller: Whom the emergency stop in the question tells.
        close_now: Closes the window without asking again.
    """
    operating_state = controller.operating_state
    if not operating_state.moving:
        close_now()
        return
    if operating_state.mover is Mover.OURS:
        _ask_how_to_close(window, controller, close_now)
        return
    confirm(
        window,
        controller,
        title=QCoreApplication.translate("MainWindow", "The arm is moving"),
        text=QCoreApplication.translate(
            "MainWindow",
            "Closing the program does not stop the arm: it goes on to its target. "
            "Press the emergency stop if it must not.",
        ),
        action_label=QCoreApplication.translate("MainWindow", "Close anyway"),
        on_confirmed=close_now,
    )


def _ask_how_to_close(
    window: QWidget, controller: ArmController, close_now: Callable[[], object]
) -> None:
    """This program moves the arm: its motion is ended unless the operator lets it finish."""
    from armui.ui.dialogs.close_question import CloseQuestion  # noqa: PLC0415 - faster start

    def let_finish() -> None:
        controller.let_motion_finish()
        close_now()

    for older in window.findChildren(CloseQuestion):
        older.reject()
    question = CloseQuestion(controller, window)
    question.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    question.accepted.connect(lambda: end_single_motion_then(window, controller, close_now))
    question.let_finish.connect(let_finish)
    question.open()
