"""Asks before the arm, the program or a panel is left: motion is ended, entries are saved."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Final, Protocol, runtime_checkable

from PySide6.QtCore import QCoreApplication, QObject, Qt, QTimer
from PySide6.QtWidgets import QWidget

from armui.control.devices.teaching_phase import phase_of, why_under_way
from armui.control.motion.motion_command import Mover
from armui.control.operating_state import StopState
from armui.control.safety.uncommanded_motion import MotionKind
from armui.ui.dialogs.confirm_dialog import CloseQuestion, SaveQuestion, confirm

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState


_REST_WITHIN_MS: Final = 3000


@runtime_checkable
class KeepsDraft(Protocol):
    """A panel with entries that are saved only on purpose."""

    def has_unsaved_changes(self) -> bool:
        """Return whether leaving the panel would lose entries."""

    def discard_changes(self) -> None:
        """Discard the entries."""

    def why_no_saving(self) -> str:
        """Return why the entries cannot be saved now; empty if they can."""

    def save_changes(self, then: Callable[[], object]) -> None:
        """Save the entries; go on only when they are known to be saved."""


def unsaved(panels: Iterable[object]) -> list[KeepsDraft]:
    """Return the panels with unsaved entries; other objects are ignored."""
    return [
        panel for panel in panels if isinstance(panel, KeepsDraft) and panel.has_unsaved_changes()
    ]


def leave_then(
    parent: QWidget,
    controller: ArmController,
    panels: Iterable[object],
    proceed: Callable[[], object],
) -> None:
    """Go on at once, or after the entries have been saved or discarded.

    Args:
        parent: The window that asks.
        controller: Receives the emergency stop.
        panels: The panels that would be left.
        proceed: The function that would lose the changes.
    """
    left = unsaved(panels)
    if not left:
        proceed()
        return

    def discard() -> None:
        for panel in left:
            panel.discard_changes()
        proceed()

    # a new question replaces one that is still open for another way out
    for older in parent.findChildren(UnsavedQuestion):
        older.reject()
    question = UnsavedQuestion(controller, parent, left)
    question.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    question.accepted.connect(discard)
    question.save_wanted.connect(lambda: save_then(left, proceed))
    question.open()


def save_then(panels: Sequence[KeepsDraft], proceed: Callable[[], object]) -> None:
    """Save one panel after the other, and go on when all are known to be saved."""
    if not panels:
        proceed()
        return
    first, *rest = panels
    first.save_changes(lambda: save_then(rest, proceed))


class UnsavedQuestion(SaveQuestion):
    """A question to save to the arm, discard, or stay; withdrawn when nothing is unsaved any more.

    Args:
        controller: Receives the emergency stop.
        parent: The window that asks.
        panels: The panels with unsaved entries.
    """

    def __init__(
        self, controller: ArmController, parent: QWidget, panels: Sequence[KeepsDraft]
    ) -> None:
        super().__init__(
            controller,
            parent,
            QCoreApplication.translate(
                "UnsavedQuestion",
                "What you entered has not been saved to the arm. If you discard it, the arm keeps "
                "what it holds now.",
            ),
            concerns_arm=True,
        )
        self._panels = panels
        controller.operating_state_changed.connect(self._follow)
        controller.settings.changed.connect(self._follow)
        self._follow()

    def holds(self) -> bool:
        """Return true also while the arm is silent: saving is then disabled, with the reason."""
        return not self._controller.mark.heard or super().holds()

    def _follow(self) -> None:
        left = unsaved(self._panels)
        reasons = (panel.why_no_saving() for panel in left)
        self.allow_saving(next((each for each in reasons if each), ""))
        if not left and self.isVisible():
            self.reject()


def end_motion_then(
    parent: QWidget, controller: ArmController, proceed: Callable[[], object]
) -> None:
    """Go on at once, or after the operator has agreed to end the program's motion.

    A run that dwells, waits or is paused counts, and so does a motion paused from here: the arm
    would go on later, or be left with a forgotten target. A stop that the arm has not confirmed
    counts as well. A jog ends without a question.

    Args:
        parent: The window that asks.
        controller: Receives the emergency stop, and ends the motion.
        proceed: The function that would leave the arm. It is called when the arm is at rest, or
            when the time limit of a run's end is over.
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
        still=lambda: _question(controller.operating_state) == question,
    )


def _question(operating_state: OperatingState) -> tuple[str, str, str] | None:
    """Return title, text and button text of the question; ``None`` if nothing is under way."""
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
    """End all motion by this program, single motions too; go on at rest, or after 3 s.

    Args:
        parent: The parent of the waiting object.
        controller: Ends it.
        proceed: The function that would leave the arm; not called if the operator stops the arm
            meanwhile.
    """
    _Ending(parent, controller, proceed, single=True).begin()


class _Ending(QObject):
    """Waits for the arm's rest and then calls `proceed`, unless the operator stops the arm."""

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
        """End the motion, and call `proceed` once it has ended, unless by an emergency stop."""
        self._controller.end_motion(single=self._single)
        self._controller.operating_state_changed.connect(self._on_operating_state)
        if self._single:
            self._limit.start()
        self._on_operating_state(self._controller.operating_state)

    def _on_late(self) -> None:
        self._late = True
        self._on_operating_state(self._controller.operating_state)

    def _on_operating_state(self, operating_state: OperatingState) -> None:
        stopping = operating_state.stop is not StopState.RUNNING
        driven = operating_state.running or bool(operating_state.holds)
        under_way = driven or (self._single and operating_state.moving)
        if not stopping and under_way and not self._late:
            return
        self._controller.operating_state_changed.disconnect(self._on_operating_state)
        self._limit.stop()
        self.deleteLater()
        if not stopping:
            self._proceed()


def close_unless_moving(
    window: QWidget, controller: ArmController, close_now: Callable[[], object]
) -> None:
    """Close at once, or after the operator has decided about the motion.

    Args:
        window: The main window, which asks.
        controller: Receives the emergency stop.
        close_now: Closes the window without asking again.
    """
    operating_state = controller.operating_state
    teaches, falls = is_taught(controller), gives_way(operating_state)
    if not (operating_state.moving or teaches or falls):
        close_now()
        return
    if operating_state.mover is Mover.OURS:
        _ask_how_to_close(window, controller, close_now)
        return
    title = QCoreApplication.translate("MainWindow", "The arm is moving")
    text = QCoreApplication.translate(
        "MainWindow",
        "Closing the program does not stop the arm: it goes on to its target. "
        "Press the emergency stop if it must not.",
    )
    if falls:
        text = QCoreApplication.translate(
            "MainWindow",
            "No motor holds it, or nothing told it to move. Closing the program does not hold it, "
            "and nobody tells any more how far it goes.",
        )
    if teaches:
        title = QCoreApplication.translate("MainWindow", "Drag teaching is under way")
        text = QCoreApplication.translate(
            "MainWindow",
            "Closing the program ends a replay that was begun here, and nothing else: the arm "
            "goes on giving way to the hand and recording, or replaying. End it under Drag "
            "teaching first.",
        )
    confirm(
        window,
        controller,
        title=title,
        text=text,
        action_label=QCoreApplication.translate("MainWindow", "Close anyway"),
        on_confirmed=close_now,
        still=lambda: is_taught(controller) if teaches else _moves(controller.operating_state),
    )


def _moves(operating_state: OperatingState) -> bool:
    return operating_state.moving or gives_way(operating_state)


def gives_way(operating_state: OperatingState) -> bool:
    """Return whether the arm is measured to move without a command, or without power to hold it."""
    uncommanded = operating_state.uncommanded
    return uncommanded is not None and uncommanded.kind in {MotionKind.SINKS, MotionKind.MOVES}


def is_taught(controller: ArmController) -> bool:
    """Return whether the arm records a motion by hand, or replays its recording."""
    now = controller.operating_state
    if now.status is None or now.unreachable is not None or now.stop is not StopState.RUNNING:
        return False
    return why_under_way(phase_of(now.status)) is not None


def _ask_how_to_close(
    window: QWidget, controller: ArmController, close_now: Callable[[], object]
) -> None:
    """Ask before closing during a motion: it is ended unless the operator lets it finish."""

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
