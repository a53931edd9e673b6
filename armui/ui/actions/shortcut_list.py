"""The list of all shortcuts, by the places where they count (?)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QSizePolicy, QWidget

from armui.ui.actions.keys import SHORTCUTS
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets import painting
from armui.ui.widgets.layouts import STRETCH, bare_area, empty_grid, fill
from armui.ui.widgets.text_label import text_label

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.ui.words.text import Text

_SIZE_PX: Final = (600, 640)
_GAPS_PX: Final = (16, 6)
_SECTION_GAP_PX: Final = 12


class KeyCap(QLabel):
    """Keys in a box that looks like a key."""

    def __init__(self) -> None:
        super().__init__()
        self.setContentsMargins(9, 4, 9, 5)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the key, then the word on it."""
        colors = colors_of(self)
        painter = painting.begin(self)
        box = QRectF(self.rect())
        painting.panel(painter, box, colors.border, colors.border)
        painting.panel(painter, box.adjusted(0, 0, 0, -2), colors.surface, colors.border)
        painter.end()
        super().paintEvent(event)


class ShortcutList(ArmDialog):
    """The list with keys on the left and their effects on the right.

    Args:
        controller: Receives the emergency stop.
        places: The titles of all places by their keys.
        parent: The main window.
    """

    def __init__(
        self, controller: ArmController, places: Mapping[str, Text], parent: QWidget | None = None
    ) -> None:
        super().__init__(controller, parent)
        self._texts: list[tuple[QLabel, Text]] = []
        content = QWidget()
        grid = empty_grid(gaps=_GAPS_PX)
        content.setLayout(grid)
        grid.setColumnStretch(1, 1)
        for place, title in places.items():
            self._add(grid, place, title)
        grid.setRowStretch(grid.rowCount(), 1)
        self.body.addWidget(bare_area(content), 1)
        fill(self.footer, STRETCH, CloseButton(self, on_enter=True))
        self.setObjectName("shortcut_list")
        self.resize(*_SIZE_PX)
        self.retranslate_ui()

    def _add(self, grid: QGridLayout, place: str, title: Text) -> None:
        """Add the shortcuts of a place below a heading; nothing if it has none."""
        shortcuts = [each for each in SHORTCUTS.values() if each.place == place]
        if not shortcuts:
            return
        row = grid.rowCount()
        grid.setRowMinimumHeight(row, _SECTION_GAP_PX if self._texts else 0)
        heading = text_label(rank="muted")
        grid.addWidget(heading, row + 1, 0, 1, 2)
        self._texts.append((heading, title))
        for line, shortcut in enumerate(shortcuts, row + 2):
            keys, effect = KeyCap(), text_label(wraps=True)
            keys.setFont(scaled_font(keys, 1.0))
            keys.setText(shortcut.text())
            grid.addWidget(keys, line, 0, Qt.AlignmentFlag.AlignLeft)
            grid.addWidget(effect, line, 1)
            self._texts.append((effect, shortcut.title))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Keyboard shortcuts"))
        for label, text in self._texts:
            label.setText(text.text())
