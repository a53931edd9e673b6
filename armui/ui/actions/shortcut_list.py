"""The list of all shortcuts, by the places where they count (?)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QScrollArea, QWidget

from armui.ui.actions.keys import SHORTCUTS
from armui.ui.actions.places import PLACES
from armui.ui.dialogs.base import ArmDialog
from armui.ui.dialogs.keycap import KeyCap
from armui.ui.widgets.buttons import named, push_button
from armui.ui.widgets.layouts import STRETCH, empty_grid, fill, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

_SIZE_PX: Final = (980, 640)
_COLUMN_GAP_PX: Final = 36
_SECTION_GAP_PX: Final = 12
_LINE_GAP_PX: Final = 6
_LEFT: Final = (
    *("everywhere", "window", "view", "motion", "light", "gripper", "parameters", "jogging"),
    "library",
)
"""The places of the left column; the others stand in the right one."""


class ShortcutList(ArmDialog):
    """Keys on the left, what they do on the right.

    Args:
        controller: Whom the emergency stop tells.
        parent: The main window.
    """

    def __init__(self, controller: ArmController, parent: QWidget | None = None) -> None:
        super().__init__(controller, parent)
        self.setObjectName("shortcut_list")
        self._titles: list[tuple[QLabel, Text]] = []
        page = QWidget()
        columns = in_row(on=page, spacing=_COLUMN_GAP_PX, margins=(0, 0, 8, 0))
        right = [place for place in PLACES if place not in _LEFT]
        for places in (list(_LEFT), right):
            columns.addLayout(self._column(places), 1)
        self.area = named("shortcuts_area", QScrollArea())
        self.area.setWidget(page)
        self.area.setWidgetResizable(True)
        self.area.setFrameShape(QFrame.Shape.NoFrame)
        self.area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.body.addWidget(self.area, 1)
        self.close_button = push_button(on_enter=True)
        self.close_button.clicked.connect(self.close)
        fill(self.footer, STRETCH, self.close_button)
        self.resize(*_SIZE_PX)
        self.retranslate_ui()

    def _column(self, places: list[str]) -> QGridLayout:
        grid = empty_grid(gaps=(16, _LINE_GAP_PX))
        grid.setColumnStretch(1, 1)
        for place in places:
            shortcuts = [each for each in SHORTCUTS.values() if each.place == place]
            if not shortcuts:
                continue
            row = grid.rowCount()
            grid.setRowMinimumHeight(row, _SECTION_GAP_PX if row > 1 else 0)
            row += 1
            heading = text_label(rank="muted")
            grid.addWidget(heading, row, 0, 1, 2)
            self._titles.append((heading, PLACES[place]))
            for each in shortcuts:
                row += 1
                cap, what = KeyCap(), QLabel()
                cap.setText(each.text())
                what.setWordWrap(True)
                middle = Qt.AlignmentFlag.AlignVCenter
                grid.addWidget(cap, row, 0, middle | Qt.AlignmentFlag.AlignLeft)
                grid.addWidget(what, row, 1, middle)
                self._titles.append((what, each.title))
        grid.setRowStretch(grid.rowCount(), 1)
        return grid

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.set_title(self.tr("Keyboard shortcuts"))
        self.close_button.setText(self.tr("Close"))
        for label, title in self._titles:
            label.setText(title.text())
