"""Opens the right editor in each cell of the table of points.

It paints nothing: a delegate's painting in Python is called for every cell, time and again.
"""

from __future__ import annotations

from typing import Final, cast

from PySide6.QtCore import (
    QAbstractItemModel,
    QEvent,
    QObject,
    QPersistentModelIndex,
    QRect,
    Qt,
    Signal,
)
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QLineEdit, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from armui.trajectory.points.cells import VALUES, PointColumn
from armui.ui.trajectory.editor.cell_editors import (
    CellEditor,
    GripperEditor,
    LightEditor,
    MoveEditor,
    TextEditor,
)
from armui.ui.trajectory.editor.points_model import PointsModel
from armui.ui.widgets.painting import repolish
from armui.ui.widgets.table_model import Index

_LEAVING: Final = frozenset(
    {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Tab, Qt.Key.Key_Backtab}
)


class PointDelegate(QStyledItemDelegate):
    """An editor stays open as long as what is in it cannot be: it says why.

    Signals:
        refused: An index and the :class:`Refusal` of what is being entered there.
        accepted: What was said of an entry holds no more.
    """

    refused = Signal(object, object)
    accepted = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._index = QPersistentModelIndex()

    # Editors ----------------------------------------------------------------------------------

    def createEditor(  # noqa: N802 - Qt's name
        self, parent: QWidget, _option: QStyleOptionViewItem, index: Index
    ) -> QWidget:
        """The editor of the cell's column."""
        self._index = QPersistentModelIndex(index)
        self.accepted.emit()
        column = PointColumn(index.column())
        if column is PointColumn.MOVE:
            editor = MoveEditor(parent)
            editor.decided.connect(self._on_decided)
            return editor
        if column is PointColumn.GRIPPER:
            return GripperEditor(parent)
        if column is PointColumn.LIGHT:
            return LightEditor(parent)
        return TextEditor(parent, figure=column in {*VALUES, PointColumn.SPEED, PointColumn.DWELL})

    def _on_decided(self) -> None:
        editor = cast("MoveEditor", self.sender())
        self.commitData.emit(editor)
        self.closeEditor.emit(editor)

    def setEditorData(self, editor: QWidget, index: Index) -> None:  # noqa: N802 - Qt's name
        """Show what stands in the cell."""
        if isinstance(editor, CellEditor):
            editor.set_text(str(index.data(Qt.ItemDataRole.EditRole)))

    def setModelData(  # noqa: N802 - Qt's name
        self, editor: QWidget, model: QAbstractItemModel, index: Index
    ) -> None:
        """Hand over what was entered; the model tells if it cannot be."""
        if isinstance(editor, CellEditor):
            model.setData(index, editor.text(), Qt.ItemDataRole.EditRole)

    def updateEditorGeometry(  # noqa: N802 - Qt's name
        self, editor: QWidget, option: QStyleOptionViewItem, _index: Index
    ) -> None:
        """Over the cell; wider where the editor needs it, within what is seen of the table."""
        cell: QRect = option.rect
        width = max(cell.width(), editor.sizeHint().width(), editor.minimumSizeHint().width())
        if isinstance(editor, TextEditor):
            width = max(cell.width(), 80)
        parent = editor.parentWidget()
        room = cell.right() if parent is None else parent.width()
        editor.setGeometry(max(0, min(cell.x(), room - width)), cell.y(), width, cell.height())

    def eventFilter(self, editor: QObject, event: QEvent) -> bool:
        """Keep the editor open while what is in it cannot be."""
        if (
            event.type() == QEvent.Type.KeyPress
            and isinstance(event, QKeyEvent)
            and Qt.Key(event.key()) in _LEAVING
            and isinstance(editor, CellEditor)
            and self._refuses(editor)
        ):
            return True
        return super().eventFilter(editor, event)

    def _refuses(self, editor: CellEditor) -> bool:
        model = self._index.model()
        if not isinstance(model, PointsModel):
            return False
        reason = model.why_not(self._index, editor.text())
        if reason is None:
            self.accepted.emit()
            return False
        self.refused.emit(model.index(self._index.row(), self._index.column()), reason)
        if isinstance(editor, QLineEdit):
            editor.setProperty("attention", True)
            repolish(editor)
        return True
