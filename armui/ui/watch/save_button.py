"""A button with a menu of everything that can be saved or copied."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QToolButton


class SaveButton(QToolButton):
    """Opens its menu at a press; whoever has it puts the words in.

    Args:
        room: How the names of button and actions begin: ``plot`` makes ``plot_save``.
        kinds: What can be saved, by names that tell it.

    Attributes:
        saves: The actions by those names.

    Signals:
        wanted: One of the names.
    """

    wanted = Signal(str)

    def __init__(self, room: str, kinds: Iterable[str]) -> None:
        super().__init__()
        self.setObjectName(f"{room}_save")
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self)
        self.saves = {name: QAction(menu) for name in kinds}
        for name, action in self.saves.items():
            action.setObjectName(f"{room}_{name}")
            action.triggered.connect(lambda _on=False, name=name: self.wanted.emit(name))
            menu.addAction(action)
        self.setMenu(menu)
