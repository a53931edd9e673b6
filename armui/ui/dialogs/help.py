"""The window 使用帮助: how to use the 3D area (manual 1.0.8 ①)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication, Qt
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QScrollArea, QWidget

from armui.control.arm_controller import ArmController
from armui.ui.dialogs.base import ArmDialog
from armui.ui.dialogs.keycap import KeyCap
from armui.ui.theme import scaled_font
from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.layouts import empty_grid, in_row
from armui.ui.widgets.text_label import text_label

_SIZE_PX: Final = (1000, 680)
_COLUMN_GAP_PX: Final = 36
_SECTION_GAP_PX: Final = 12
_LINE_GAP_PX: Final = 8


@dataclass(frozen=True, slots=True)
class _Section:
    """A heading and its lines: what to do or see, and what it does or means.

    Attributes:
        column: Where it stands, 0 or 1.
        keys: What is on the left of a line is a key or a gesture.
    """

    column: int
    keys: bool
    heading: object
    lines: tuple[tuple[object, object], ...]


_SECTIONS: Final = (
    _Section(
        0,
        True,
        QT_TRANSLATE_NOOP("Help", "Mouse"),
        (
            (
                QT_TRANSLATE_NOOP("Help", "Left drag"),
                QT_TRANSLATE_NOOP("Help", "Turn the view around the arm"),
            ),
            (
                QT_TRANSLATE_NOOP("Help", "Middle drag, Shift + left drag"),
                QT_TRANSLATE_NOOP("Help", "Move the view"),
            ),
            (QT_TRANSLATE_NOOP("Help", "Wheel"), QT_TRANSLATE_NOOP("Help", "Zoom in and out")),
            (
                QT_TRANSLATE_NOOP("Help", "Double click on a link"),
                QT_TRANSLATE_NOOP("Help", "Mark the joint that moves it and go to its field"),
            ),
        ),
    ),
    _Section(
        0,
        True,
        QT_TRANSLATE_NOOP("Help", "Keyboard"),
        (
            (QT_TRANSLATE_NOOP("Help", "← → ↑ ↓"), QT_TRANSLATE_NOOP("Help", "Turn the view")),
            (QT_TRANSLATE_NOOP("Help", "+  −"), QT_TRANSLATE_NOOP("Help", "Zoom in and out")),
            (QT_TRANSLATE_NOOP("Help", "Home"), QT_TRANSLATE_NOOP("Help", "The first view again")),
            (
                QT_TRANSLATE_NOOP("Help", "Ctrl+1 … Ctrl+4"),
                QT_TRANSLATE_NOOP("Help", "Front, side, top and oblique view"),
            ),
            (
                QT_TRANSLATE_NOOP("Help", "Ctrl+5, Ctrl+9"),
                QT_TRANSLATE_NOOP("Help", "Follow the tool; show all of the arm"),
            ),
            (
                QT_TRANSLATE_NOOP("Help", "Ctrl+Shift+D"),
                QT_TRANSLATE_NOOP(
                    "Help",
                    "Handles: drag the target, or the chosen point; Ctrl and Shift snap, Esc "
                    "gives up",
                ),
            ),
            (
                QT_TRANSLATE_NOOP("Help", "F12, Pause"),
                QT_TRANSLATE_NOOP("Help", "Emergency stop, from every window of the program"),
            ),
        ),
    ),
    _Section(
        1,
        False,
        QT_TRANSLATE_NOOP("Help", "Figures at the top left"),
        (
            (
                QT_TRANSLATE_NOOP("Help", "X  Y  Z"),
                QT_TRANSLATE_NOOP("Help", "Measured place of the flange, in mm"),
            ),
            (
                QT_TRANSLATE_NOOP("Help", "RX  RY  RZ"),
                QT_TRANSLATE_NOOP("Help", "Its measured rotation: roll, pitch, yaw, in degrees"),
            ),
            (
                QT_TRANSLATE_NOOP("Help", "J1 … J6"),
                QT_TRANSLATE_NOOP("Help", "Measured joint angles in degrees, J1 the lowest joint"),
            ),
        ),
    ),
    _Section(
        1,
        False,
        QT_TRANSLATE_NOOP("Help", "What the picture says"),
        (
            (
                QT_TRANSLATE_NOOP("Help", "—"),
                QT_TRANSLATE_NOOP("Help", "Not heard from the arm yet: no figure is made up"),
            ),
            (
                QT_TRANSLATE_NOOP("Help", "Muted figures, faded arm"),
                QT_TRANSLATE_NOOP(
                    "Help", "Older than half a second: where the arm was, not where it is"
                ),
            ),
            (
                QT_TRANSLATE_NOOP("Help", "Red, green, blue axis"),
                QT_TRANSLATE_NOOP("Help", "X, Y and Z of the base, from the middle of its foot"),
            ),
            (
                QT_TRANSLATE_NOOP("Help", "Band along the way"),
                QT_TRANSLATE_NOOP(
                    "Help",
                    "Where the tool has been; thin violet: the setpoints sent one after another",
                ),
            ),
            (
                QT_TRANSLATE_NOOP("Help", "Octagon, triangle"),
                QT_TRANSLATE_NOOP(
                    "Help",
                    "An error or a warning of the check, where it would happen: click for its row",
                ),
            ),
        ),
    ),
)


class HelpDialog(ArmDialog):
    """Explains mouse, keyboard and figures of the 3D picture."""

    def __init__(self, controller: ArmController, parent: QWidget | None = None) -> None:
        super().__init__(controller, parent)
        self._labels: list[tuple[QLabel, object]] = []
        self.body.addWidget(self._build_page(), 1)
        self.close_button = push_button(on_enter=True)
        self.close_button.clicked.connect(self.close)
        self.footer.addStretch(1)
        self.footer.addWidget(self.close_button)
        self.resize(*_SIZE_PX)
        self.retranslate_ui()

    def _build_page(self) -> QScrollArea:
        page = QWidget()
        columns = in_row(on=page, spacing=_COLUMN_GAP_PX, margins=(0, 0, 8, 0))
        for number in (0, 1):
            columns.addLayout(self._build_column(number), 1)
        self.area = area = QScrollArea()
        area.setWidget(page)
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        return area

    def _build_column(self, number: int) -> QGridLayout:
        grid = empty_grid(gaps=(18, _LINE_GAP_PX))
        grid.setColumnStretch(1, 1)
        for section in _SECTIONS:
            if section.column == number:
                self._add_section(grid, section)
        grid.setRowStretch(grid.rowCount(), 1)
        return grid

    def _add_section(self, grid: QGridLayout, section: _Section) -> None:
        row = grid.rowCount()
        grid.setRowMinimumHeight(row, _SECTION_GAP_PX if row > 1 else 0)
        row += 1
        heading = text_label(rank="muted")
        grid.addWidget(heading, row, 0, 1, 2)
        self._labels.append((heading, section.heading))
        align = Qt.AlignmentFlag.AlignVCenter if section.keys else Qt.AlignmentFlag.AlignTop
        for what, meaning in section.lines:
            row += 1
            left, right = KeyCap() if section.keys else QLabel(), QLabel()
            left.setFont(scaled_font(left, 1.0, bold=not section.keys))
            right.setWordWrap(True)
            grid.addWidget(left, row, 0, align | Qt.AlignmentFlag.AlignLeft)
            grid.addWidget(right, row, 1, align)
            self._labels += [(left, what), (right, meaning)]

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.set_title(self.tr("Help: 3D view"))
        self.close_button.setText(self.tr("Close"))
        for label, source in self._labels:
            label.setText(QCoreApplication.translate("Help", str(source)))
