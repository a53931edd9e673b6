"""A button with a menu of the ways to save and copy."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QToolButton, QWidget

from armui.ui.widgets.buttons import give_menu
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Texts


class SaveButton(Translated, QToolButton):
    """Opens its menu at a press.

    Args:
        room: The first part of the names of button and actions: ``plot`` makes ``plot_save``.
        kinds: The kinds of saving by name.

    Attributes:
        saves: The actions by those names.

    Signals:
        wanted: One of the names.
    """

    wanted = Signal(str)

    def __init__(self, room: str, kinds: Texts[str]) -> None:
        super().__init__()
        self.setObjectName(f"{room}_save")
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self)
        self._kinds = kinds
        self.saves = {name: QAction(menu) for name in kinds}
        for name, action in self.saves.items():
            action.setObjectName(f"{room}_{name}")
            action.triggered.connect(lambda _on=False, name=name: self.wanted.emit(name))
            menu.addAction(action)
        give_menu(self, menu)
        self.retranslate_ui()

    def targets(self, place: str) -> dict[str, QWidget | QAction]:
        """Return the target of each command of a page that has this button, by its name.

        Args:
            place: The key of the page.
        """
        return {f"{place}.save": self, **{f"{place}.{name}": it for name, it in self.saves.items()}}

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.setText(self.tr("Save"))
        for name, action in self.saves.items():
            action.setText(self._kinds.text(name))
