"""Between the next step and the status bar: panels, pages and picture; a run; the drawer."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSplitter, QWidget

from armui.ui.shell.drawer import DRAWER_PX, Drawer
from armui.ui.shell.work_area import WorkArea
from armui.ui.widgets.layouts import in_column

_LEAST_WORK_PX: Final = 260


class WorkColumn(QSplitter):
    """The drawer takes its height from panels and picture while it is open, and gives it back.

    Args:
        area: Panels or pages, and the picture.
        run: Tells the run under way, below them.
        drawer: Below that.

    Attributes:
        area: As given.
        drawer_px: How high the drawer is when it is open.

    Signals:
        sized: The operator has moved a border.
    """

    sized = Signal()

    def __init__(self, area: WorkArea, run: QWidget, drawer: Drawer) -> None:
        super().__init__(Qt.Orientation.Vertical)
        self.setObjectName("work_column")
        self.setHandleWidth(1)
        self.setChildrenCollapsible(False)
        self.area = area
        self.drawer_px = DRAWER_PX
        self._drawer = drawer
        self._work = work = QWidget()
        in_column((area, 1), run, on=work, spacing=0, margins=0)
        self.addWidget(work)
        self.addWidget(drawer)
        self.setStretchFactor(0, 1)
        self.setStretchFactor(1, 0)
        drawer.turned.connect(self.fit)
        self.splitterMoved.connect(self._on_moved)
        area.sized.connect(self.sized)

    def set_drawer(self, height_px: int) -> None:
        """Take another height of the drawer."""
        self.drawer_px = height_px
        self.fit()

    def fit(self, *_: object) -> None:
        """Give the drawer its height, as far as there is room."""
        if self._drawer.isHidden():
            return
        room = self.height() - self.handleWidth()
        least = max(_LEAST_WORK_PX, self._work.minimumSizeHint().height())
        height = max(self._drawer.minimumHeight(), min(self.drawer_px, room - least))
        self.setSizes([max(0, room - height), height])

    def _on_moved(self, *_: int) -> None:
        self.drawer_px = self._drawer.height()
        self.sized.emit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The drawer keeps its height."""
        super().resizeEvent(event)
        self.fit()
