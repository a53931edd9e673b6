"""Asking before something that was entered and not saved is lost."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Protocol, runtime_checkable

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QWidget

from armui.ui.dialogs.confirm import confirm

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


@runtime_checkable
class KeepsDraft(Protocol):
    """A panel in which something can be entered that is saved by a deliberate act."""

    def has_unsaved_changes(self) -> bool:
        """Whether leaving the panel would lose something."""

    def discard_changes(self) -> None:
        """Forget what was entered."""


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
    """Go on at once, or after the operator has agreed to lose what is not saved.

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

    confirm(
        parent,
        controller,
        title=QCoreApplication.translate("Unsaved", "Changes are not saved"),
        text=QCoreApplication.translate(
            "Unsaved",
            "What you entered has not been saved to the arm. If you go on it is lost; the arm "
            "keeps what it holds now.",
        ),
        action_label=QCoreApplication.translate("Unsaved", "Discard changes"),
        on_confirmed=discard,
    )
