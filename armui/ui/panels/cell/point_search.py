"""The base of the guided searches by points: of a tool's tip, of a user frame."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_reasons import CAPTURED_OF_ANOTHER, CELL_NONE
from armui.ui import words
from armui.ui.panels.cell.cell_tab import NARROW_PX, Answered, hint_label
from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

Pose = tuple[float, ...]


class PointSearch(Translated, QWidget):
    """Takes poses of the arm at rest, and shows what they give; nothing is applied by itself.

    Args:
        controller: The controller; its `cell` takes measured poses.
        answered: Shows an answer in the panel.
        name: The prefix of the names of its widgets.

    Signals:
        applied: The operator applies the pose found, six figures; true for a new thing, false for
            the chosen one.
    """

    applied = Signal(object, bool)

    def __init__(self, controller: ArmController, answered: Answered, name: str) -> None:
        super().__init__()
        self._controller = controller
        self._answered = answered
        self._why_not = ""
        self._arms = controller.cell.arms
        self._next = hint_label(f"{name}_next", lines=3)
        self._live = text_label(f"{name}_live", rank="muted", wraps=True)
        self._result = text_label(f"{name}_result", wraps=True)
        self._apply = push_button(f"{name}_apply")
        self._restart = push_button(f"{name}_restart")
        for button in (self._apply, self._restart):
            button.setMinimumWidth(NARROW_PX)
        self._apply.clicked.connect(lambda: self._on_apply(anew=False))
        self._restart.clicked.connect(self.restart)

    def found(self) -> Pose | Refusal | None:
        """Return the pose given by the points, or why there is none; ``None``: too few points."""
        raise NotImplementedError

    def restart(self) -> None:
        """Forget the points taken so far."""
        raise NotImplementedError

    def drop_others(self) -> bool:
        """Drop the points if another arm may be connected now; return whether they were."""
        arms, self._arms = self._arms, self._controller.cell.arms
        if arms == self._arms or not self._restart.isEnabled():
            return False
        self.restart()
        self._answered(CAPTURED_OF_ANOTHER())
        return True

    def show_chosen(self, chosen: Any, why_not: str) -> None:
        """Show which tool or frame the result can replace.

        Args:
            chosen: The chosen one; ``None`` if there is none.
            why_not: Why the cell cannot be changed now; empty if it can.
        """
        raise NotImplementedError

    def show_live(self) -> None:
        """Show what the arm's present pose would result in; called while it moves."""
        raise NotImplementedError

    def _why_no_pose(self, refusal: Refusal) -> str:
        """Return why no pose can be taken; "" if the line of the next step says it already."""
        return "" if refusal.reason == CELL_NONE else words.refusal(refusal)

    def _show(self) -> None:
        raise NotImplementedError

    def _captured(self, then: Callable[[Pose], object]) -> None:
        """Take the measured pose of the flange, or say why it cannot be taken."""
        if self.drop_others():
            return
        pose = self._controller.cell.capture()
        if isinstance(pose, Refusal):
            self._answered(pose)
            return
        self._answered(None)
        then(pose)
        self._show()

    def _on_apply(self, *, anew: bool) -> None:
        found = None if self.drop_others() else self.found()
        if isinstance(found, tuple):
            self.applied.emit(found, anew)
