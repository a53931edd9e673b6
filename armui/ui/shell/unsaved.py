"""Asking before something that was entered and not saved is lost: save it, discard it, or stay."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Protocol, runtime_checkable

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QWidget

from armui.ui.dialogs.confirm_dialog import SaveQuestion

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


@runtime_checkable
class KeepsDraft(Protocol):
    """A panel in which something can be entered that is saved by a deliberate act."""

    def has_unsaved_changes(self) -> bool:
        """Whether leaving the panel would lose something."""

    def discard_changes(self) -> None:
        """Forget what was entered."""

    def why_no_saving(self) -> str:
        """Why what was entered cannot be saved now; empty: it can."""

    def save_changes(self, then: Callable[[], object]) -> None:
        """Save what was entered; go on once it has proved to be saved, and never otherwise."""


@runtime_checkable
class KeepsWork(Protocol):
    """A window whose unsaved work is kept on the disk and offered the next time."""

    def keep_work(self) -> None:
        """The program ends: bring what is kept up to date."""


def unsaved(panels: Iterable[object]) -> list[KeepsDraft]:
    """Those of the panels in which something is not saved; the others need not know of this."""
    return [
        panel for panel in panels if isinstance(panel, KeepsDraft) and panel.has_unsaved_changes()
    ]


def leave_then(
    parent: QWidget,
    controller: ArmController,
    panels: Iterable[object],
    proceed: Callable[[], object],
) -> None:
    """Go on at once, or after what was entered has been saved, or the operator has given it up.

    Args:
        parent: The window that asks.
        controller: Whom the emergency stop in the question tells.
        panels: Those that would be left.
        proceed: What would lose the changes.
    """
    left = unsaved(panels)
    if not left:
        proceed()
        return

    def discard() -> None:
        for panel in left:
            panel.discard_changes()
        proceed()

    for older in parent.findChildren(UnsavedQuestion):
        older.reject()
    question = UnsavedQuestion(controller, parent, left)
    question.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    question.accepted.connect(discard)
    question.save_wanted.connect(lambda: save_then(left, proceed))
    question.open()


def save_then(panels: Sequence[KeepsDraft], proceed: Callable[[], object]) -> None:
    """Save one panel after the other, and go on when the last has proved to be saved."""
    if not panels:
        proceed()
        return
    first, *rest = panels
    first.save_changes(lambda: save_then(rest, proceed))


class UnsavedQuestion(SaveQuestion):
    """Save to the arm, discard, or stay; withdrawn once there is nothing left to lose.

    Args:
        controller: Whom the emergency stop tells.
        parent: The window that asks.
        panels: Those in which something is not saved.
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
        """Stay while no arm is heard: nothing can be saved then, and the button says why."""
        return not self._controller.mark.heard or super().holds()

    def _follow(self) -> None:
        left = unsaved(self._panels)
        reasons = (panel.why_no_saving() for panel in left)
        self.allow_saving(next((each for each in reasons if each), ""))
        if not left and self.isVisible():
            self.reject()
