"""The two views: a tree of frames and signals, and the frames in order of time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QRect, Qt, Signal
from PySide6.QtWidgets import QHeaderView

from armui.ui.theme import colors_of
from armui.ui.watch.bus import frame_model, trace_model
from armui.ui.watch.bus.cells import KEY_ROLE, RowView, bytes_width
from armui.ui.widgets import icons
from armui.ui.widgets.table_model import Index

if TYPE_CHECKING:
    from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QResizeEvent
    from PySide6.QtWidgets import QStyleOptionViewItem

    from armui.ui.watch.bus.frame_model import FrameModel
    from armui.ui.watch.bus.trace_model import TraceModel
    from armui.ui.widgets.table_model import Index

_ICON_PX: Final = 16
_PAD_PX: Final = 24
_INDENT_PX: Final = 22
_NAME_PX: Final = 190


class FrameTree(RowView):
    """Frames by identifier; a sign before a signal shows it as a curve.

    Signals:
        curves_wanted: Keys of quantities.
    """

    curves_wanted = Signal(object)

    def __init__(self, model: FrameModel) -> None:
        super().__init__(model)
        self.setObjectName("bus_tree")
        self.setModel(model)
        self.setIndentation(_INDENT_PX)
        self.setExpandsOnDoubleClick(True)
        self._fit_columns()

    def _fit_columns(self) -> None:
        text = self.fontMetrics().horizontalAdvance
        header = self.header()
        widths = {
            frame_model.ID: text("0x00000000") + _INDENT_PX + _PAD_PX,
            frame_model.SENDER: text("another host") + _PAD_PX,
            frame_model.DATA: max(bytes_width(self), text("0000000000000000000000")) + _PAD_PX,
            frame_model.RATE: text("Rate, Hz 0") + _PAD_PX,
            frame_model.JITTER: text("±00.00 / 00.00") + _PAD_PX,
            frame_model.COUNT: text("00000000") + _PAD_PX,
            frame_model.LAST: text("00:00:00.000") + _PAD_PX,
        }
        for column, width in widths.items():
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.Interactive)
            header.resizeSection(column, width)
        header.setSectionResizeMode(frame_model.NAME, QHeaderView.ResizeMode.Stretch)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Where not all fits, the name is no wider than it must be: Qt would leave it as it was."""
        super().resizeEvent(event)
        header = self.header()
        others = header.length() - header.sectionSize(frame_model.NAME)
        if self.viewport().width() - others < _NAME_PX:
            header.resizeSection(frame_model.NAME, _NAME_PX)

    def drawRow(  # noqa: N802 - the name Qt calls
        self, painter: QPainter, option: QStyleOptionViewItem, index: Index
    ) -> None:
        """A sign before each signal that can be drawn."""
        super().drawRow(painter, option, index)
        place = self._sign(index)
        if place is not None:
            ratio = self.devicePixelRatioF()
            painter.drawPixmap(
                place, icons.pixmap("plots", colors_of(self).accent, _ICON_PX, ratio)
            )

    def _sign(self, index: Index) -> QRect | None:
        first = index.sibling(index.row(), frame_model.ID)
        if not first.data(KEY_ROLE):
            return None
        cell = self.visualRect(first)
        top = cell.center().y() - _ICON_PX // 2
        return QRect(cell.right() - _ICON_PX - 4, top, _ICON_PX, _ICON_PX)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """A click on the sign shows the curve."""
        super().mouseReleaseEvent(event)
        place = event.position().toPoint()
        index = self.indexAt(place)
        sign = self._sign(index) if index.isValid() else None
        left = event.button() is Qt.MouseButton.LeftButton
        if left and sign is not None and sign.adjusted(-4, -4, 4, 4).contains(place):
            self._show_curve(index)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter shows the signal's curve."""
        if event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter}:
            self._show_curve(self.currentIndex())
            event.accept()  # a dialog would take it for its button
            return
        super().keyPressEvent(event)

    def _show_curve(self, index: Index) -> None:
        key = index.sibling(index.row(), frame_model.ID).data(KEY_ROLE) if index.isValid() else None
        if key:
            self.curves_wanted.emit([key])


class TraceList(RowView):
    """Frames in order of time."""

    def __init__(self, model: TraceModel) -> None:
        super().__init__(model)
        self.setObjectName("bus_trace")
        self.setRootIsDecorated(False)
        self.setItemsExpandable(False)
        self.setModel(model)
        text = self.fontMetrics().horizontalAdvance
        header = self.header()
        widths = {
            trace_model.TIME: text("00:00:00.000") + _PAD_PX,
            trace_model.ID: text("0x00000000") + _PAD_PX,
            trace_model.NAME: text("Control mode, kind of motion, speed") + _PAD_PX,
            trace_model.SENDER: text("another host") + _PAD_PX,
            trace_model.DATA: bytes_width(self) + _PAD_PX,
        }
        for column, width in widths.items():
            header.resizeSection(column, width)
        header.setSectionResizeMode(trace_model.SAYS, QHeaderView.ResizeMode.Stretch)
