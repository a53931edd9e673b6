"""Region 8: the 3D picture with its strip and its note, and the bar below it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QWidget

from armui.ui.widgets.layouts import empty_grid, in_column

if TYPE_CHECKING:
    from armui.ui.picture.picture_work import PictureWork
    from armui.viewport.view import ArmView

_RIM_PX = 14


class ViewRegion(QWidget):
    """Lays the strip of buttons and the note over the widget that shows the arm (manual 1.0.8).

    Args:
        view: Shows the arm.
        bar: The bar below it, visible while it has something to offer.
        work: The object with the strip and the note over the picture.
    """

    def __init__(self, view: ArmView, bar: QWidget, work: PictureWork) -> None:
        super().__init__()
        self.setObjectName("view_region")
        self._view = view
        self._strip = work.bar
        # items in one cell of a grid overlap: so the strip lies over an edge of the picture
        align = Qt.AlignmentFlag
        layout = empty_grid(self, margins=0)
        layout.addWidget(view, 0, 0)
        strip = in_column(work.bar, margins=_RIM_PX)
        layout.addLayout(strip, 0, 0, align.AlignRight | align.AlignTop)
        work.note.stand_over(self, view)
        work.bar.raise_()
        work.note.raise_()
        layout.addWidget(bar, 1, 0)
        layout.setRowStretch(0, 1)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Report the edge covered by the strip, beside which the arm is shown."""
        super().resizeEvent(event)
        self._view.set_covered(self._strip.sizeHint().width() + _RIM_PX)
