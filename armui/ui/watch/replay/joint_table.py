"""The table 关节状态 of a recording: the same rows and words as live, and nothing to press."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QWidget

from armui.arm.joint_status import Item, Word
from armui.control.devices.joint_monitor import JointMonitor
from armui.ui import words
from armui.ui.dialogs.joint_status_cell import JointCellDelegate
from armui.ui.dialogs.joint_status_model import JointStatusModel
from armui.ui.theme import scaled_font
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from PySide6.QtGui import QShowEvent

    from armui.arm.joint_status import StatusCell
    from armui.control.arm_controller import ArmController

_HEADER_PAD_PX: Final = 16
_MARK_PX: Final = 40
"""The mark before a word, and the room around both."""


class RecordedJoints(JointMonitor):
    """The joints of a log.

    Since when a fault lasts is told by the time line: one that was jumped into began earlier.
    """

    def cell(self, item: Item, joint: int) -> StatusCell:
        """One cell of the table."""
        return super().cell(item, joint)._replace(since=None)


class JointTable(Translated, QWidget):
    """Looks at the joints only while it is shown.

    Args:
        controller: Watches the log.
    """

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self.monitor = RecordedJoints(controller, parent=self)
        self.model = JointStatusModel(self.monitor)
        self.table = named("replay_joint_table", QTableView())
        self.table.setModel(self.model)
        self.table.setItemDelegate(JointCellDelegate(self.table))
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.table.setCornerButtonEnabled(False)
        across, down = self.table.horizontalHeader(), self.table.verticalHeader()
        across.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        across.setSectionsClickable(False)
        across.setDefaultAlignment(Qt.AlignmentFlag.AlignCenter)
        down.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        down.setDefaultAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        in_column(self.table, on=self, margins=(8, 8, 8, 6))
        self.monitor.updated.connect(self._on_updated)
        self.retranslate_ui()

    def _on_updated(self) -> None:
        if self.isVisible():
            self.model.refresh()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.table.setAccessibleName(self.tr("Joint status in the recording"))
        self.model.retranslate()
        metrics = self.table.fontMetrics()
        names = max(metrics.horizontalAdvance(words.joint_item(item)) for item in Item)
        self.table.verticalHeader().setFixedWidth(names + _HEADER_PAD_PX)
        bold = scaled_font(self.table, 1.0, bold=True)
        widest = max(QFontMetrics(bold).horizontalAdvance(words.joint_word(word)) for word in Word)
        self.table.horizontalHeader().setMinimumSectionSize(widest + _MARK_PX)

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with what went by while the table was hidden."""
        self.model.refresh()
        super().showEvent(event)
