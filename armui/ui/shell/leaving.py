"""Asking before the arm is left while something is under way, and ending that in good order."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QObject, Qt, QTimer
from PySide6.QtWidgets import QWidget

from armui.control.motion.motion_command import Mover
from armui.control.operating_state import StopState
from armui.ui.dialogs.confirm_dialog import CloseQuestion, confirm

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState


_REST_WITHIN_MS: Final = 3000


def end_motion_then(
    parent: QWidget, controller: ArmController, proceed: Callable[[], object]
) -> None:
    """Go on at once, or after the operator has agreed to end what this program drives.

    A run that dwells, waits or is paused counts, and so does a motion paused from here: the arm
    stands still, and it would go on, or be left with a target nobody remembers. So does a stop the
    arm has not confirmed. A jog ends without a question: nobody holds a button and leaves.

    Args:
        parent: The window that asks.
        controller: Whom the emergency stop in the question tells, and who ends it.
        proceed: What would leave the arm. It is called when the arm has come to rest, or has not
            within the time a run is given for it.
    """
    question = _question(controller.operating_state)
    if question is None:
        controller.end_motion()
        proceed()
        return
    title, text, label = question
    stopping = controller.operating_state.stop is StopState.REQUESTED

    def end() -> None:
        _Ending(parent, controller, proceed).begin()

    confirm(
        parent,
        controller,
        title=title,
        text=text,
        action_label=label,
        on_confirmed=proceed if stopping else end,
    )


def _question(operating_state: OperatingState) -> tuple[str, str, str] | None:
    """Title, text and the word on the button; ``None``: nothing is under way."""
    if operating_state.stop is StopState.REQUESTED:
        return (
            QCoreApplication.translate("Leaving", "The stop is not confirmed"),
            QCoreApplication.translate(
                "Leaving",
                "The arm has not said that it has stopped. The emergency stop is repeated only as "
                "long as the program is connected. Watch the arm.",
            ),
            QCoreApplication.translate("Leaving", "Leave anyway"),
        )
    end_it = QCoreApplication.translate("Leaving", "End it and go on")
    if operating_state.running:
        return (
            QCoreApplication.translate("Leaving", "A run is under way"),
            QCoreApplication.translate(
                "Leaving",
                "A trajectory or recording is being run, or is paused. If you go on, the arm is "
                "told to end its motion where it is; its motors stay enabled. The rest of the run "
                "is not done.",
            ),
            end_it,
        )
    if operating_state.holds:
        return (
            QCoreApplication.translate("Leaving", "A motion is held back"),
            QCoreApplication.translate(
                "Leaving",
                "The arm holds back a motion. If you go on, the arm is told to "
                "drop it and stays where it is; its motors stay enabled.",
            ),
            end_it,
        )
    return None


def end_single_motion_then(
    parent: QWidget, controller: ArmController, proceed: Callable[[], object]
) -> None:
    """End whatever this program moves, single motions too; go on at rest, or after 3 s.

    Args:
        parent: What waits belongs to it.
        controller: Ends it.
        proceed: What would leave the arm; not called if the operator stops the arm meanwhile.
    """
    _Ending(parent, controller, proceed, single=True).begin()


class _Ending(QObject):
    """Waits until the arm has come to rest, and then goes on, unless the operator stops it."""

    def __init__(
        self,
        parent: QWidget,
        controller: ArmController,
        proceed: Callable[[], object],
        *,
        single: bool = False,
    ) -> None:
        super().__init__(parent)
        self._controller = controller
        self._proceed = proceed
        self._single = single
        self._late = False
        self._limit = QTimer(self, singleShot=True, interval=_REST_WITHIN_MS)
        self._limit.timeout.connect(self._on_late)

    def begin(self) -> None:
        """End what is under way; go on as soon as nothing is, but not from an emergency stop."""
        self._controller.end_motion(single=self._single)
        self._controller.operating_state_changed.connect(self._look)
        if self._single:
            self._limit.start()
        self._look(self._controller.operating_state)

    def _on_late(self) -> None:
        self._late = True
        self._look(self._controller.operating_state)

    def _look(self, operating_state: OperatingState) -> None:
        stopping = operating_state.stop is not StopState.RUNNING
        driven = operating_state.running or bool(operating_state.holds)
        under_way = driven or (self._single and operating_state.moving)
        if not stopping and under_way and not self._late:
            return
        self._controller.operating_state_changed.disconnect(self._look)
        self._limit.stop()
        self.deleteLater()
        if not stopping:
            self._proceed()


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
