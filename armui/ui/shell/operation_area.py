"""Region 7: the panel chosen in the menu; each is made when it is first shown."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol, runtime_checkable

from PySide6.QtWidgets import QStackedWidget, QWidget

from armui.ui.shell.side_menu import MenuEntry


@runtime_checkable
class ShowsJoints(Protocol):
    """A panel with something for each joint."""

    def focus_joint(self, joint: int) -> None:
        """Bring the operator to a joint's controls."""


class OperationArea(QStackedWidget):
    """Holds the panels that have been shown, and empty pages for the others.

    Args:
        entries: What can be shown, in the order of the menu.
    """

    def __init__(self, entries: Sequence[MenuEntry]) -> None:
        super().__init__()
        self.setObjectName("operation_area")
        self._entries = tuple(entries)
        self._made: dict[int, QWidget] = {}
        self._empty = {place: QWidget() for place in range(len(self._entries))}
        for page in self._empty.values():
            self.addWidget(page)
        self.show_panel(0)

    @property
    def panels(self) -> list[QWidget]:
        """The panels that have been shown, in the order of the menu."""
        return [self._made[place] for place in sorted(self._made)]

    def show_panel(self, place: int) -> None:
        """Show a panel, made at the first time."""
        if place not in self._made:
            empty = self._empty.pop(place)
            panel = self._made[place] = self._entries[place].make_panel()
            self.insertWidget(place, panel)
            self.removeWidget(empty)
            empty.deleteLater()
        self.setCurrentIndex(place)

    def focus_joint(self, joint: int) -> None:
        """Bring the operator to a joint in the panel that is shown, if it has one for it."""
        panel: object = self.currentWidget()
        if isinstance(panel, ShowsJoints):
            panel.focus_joint(joint)
