"""The window 关节状态: what each driver says of itself, beside the work (manual 1.0.10)."""

from __future__ import annotations

from functools import partial
from typing import Final

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QHeaderView,
    QSizePolicy,
    QTableView,
    QWidget,
)

from armui.arm.joint_status import Item, Word
from armui.arm.limits import JOINTS
from armui.control.arm_controller import ArmController
from armui.control.devices.joint_errors import why_not_clear
from armui.control.devices.joint_monitor import JointMonitor
from armui.control.events import Event, EventCode, Level
from armui.control.operating_state import OperatingState
from armui.ui import words
from armui.ui.dialogs.base import ArmDialog
from armui.ui.dialogs.close_button import CloseButton
from armui.ui.dialogs.joint_status_cell import JointCellDelegate, cell_width
from armui.ui.dialogs.joint_status_model import JointStatusModel
from armui.ui.widgets.buttons import named, push_button
from armui.ui.widgets.enable_or_explain import enable_or_explain
from armui.ui.widgets.layouts import fill, in_column, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import text_label

_HEADER_PAD_PX: Final = 20
_FRAME_PX: Final = 1
_OURS: Final = frozenset(
    {EventCode.CLEAR_ERROR_SENT, EventCode.CLEAR_ERROR_ANSWERED, EventCode.CLEAR_ERROR_UNANSWERED}
)


class JointStatusDialog(ArmDialog):
    """Stays open beside the work; looks at the joints only while it is shown.

    Args:
        controller: Clears errors.
        monitor: Knows the joints.
        parent: The main window.
    """

    def __init__(
        self, controller: ArmController, monitor: JointMonitor, parent: QWidget | None = None
    ) -> None:
        super().__init__(controller, parent)
        self._controller = controller
        self._monitor = monitor
        self._event: Event | None = None
        self._model = JointStatusModel(monitor)
        self._build_table()
        self._build_clear_buttons()
        self._message = named("joint_status_message", MessageLine())
        self.body.addWidget(self._message)
        self.body.addStretch(1)
        self._build_footer()
        monitor.updated.connect(self._on_updated)
        controller.operating_state_changed.connect(self._on_operating_state_changed)
        controller.noticed.connect(self._on_noticed)
        self._table.selectionModel().currentChanged.connect(self._show_detail)
        self._model.dataChanged.connect(self._show_detail)
        self.retranslate_ui()
        self.ensurePolished()
        self.resize(self.sizeHint())

    # Layout -----------------------------------------------------------------------------------

    def _build_table(self) -> None:
        self._table = named("joint_status_table", QTableView())
        self._table.setModel(self._model)
        self._table.setItemDelegate(JointCellDelegate(self._table))
        self._table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self._table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self._table.setTabKeyNavigation(False)
        # as high as its rows, lower on a small screen
        self._table.setSizeAdjustPolicy(QTableView.SizeAdjustPolicy.AdjustToContents)
        self._table.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Maximum)
        self._table.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        across, down = self._table.horizontalHeader(), self._table.verticalHeader()
        across.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        across.setHighlightSections(False)
        across.setSectionsClickable(False)
        across.setDefaultAlignment(Qt.AlignmentFlag.AlignCenter)
        down.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        down.setHighlightSections(False)
        down.setSectionsClickable(False)
        down.setDefaultAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._corner_label = text_label(rank="muted")
        self._corner_label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._table.setCornerButtonEnabled(False)
        corner = self._table.findChild(QAbstractButton)
        if corner is not None:  # Qt's own, and nowhere promised
            in_column(self._corner_label, on=corner, margins=(0, 0, 6, 0))

    def quantities_at(self, place: QPoint) -> list[str]:
        """What the cell at a place of the dialog shows."""
        viewport = self._table.viewport()
        if not viewport.rect().contains(viewport.mapFrom(self, place)):
            return []
        index = self._table.indexAt(viewport.mapFrom(self, place))
        return self._model.quantities(index) if index.isValid() else []

    def _build_clear_buttons(self) -> None:
        self._below_header = QWidget()
        names = (f"clear_error_{joint}" for joint in JOINTS)
        self.clear_buttons = [push_button(name, on_enter=False) for name in names]
        row = in_row(self._below_header, spacing=0, margins=(_FRAME_PX, 0, _FRAME_PX, 0))
        for joint, button in zip(JOINTS, self.clear_buttons, strict=True):
            button.clicked.connect(partial(self._clear_error, joint))
            row.addLayout(in_row(button, margins=(4, 0, 4, 0)), 1)
        self.body.addLayout(in_column(self._table, row, spacing=6))

    def _build_footer(self) -> None:
        self._detail = text_label("joint_status_detail", rank="muted", wraps=True, plain=True)
        fill(self.footer, (self._detail, 1), CloseButton(self, on_enter=True))

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.set_title(self.tr("Joint status"))
        self._corner_label.setText(self.tr("Joint"))
        self._table.setAccessibleName(self.tr("Joint status"))
        for joint, button in zip(JOINTS, self.clear_buttons, strict=True):
            button.setText(self.tr("Clear error"))
            button.setAccessibleName(f"{button.text()} J{joint}")
        self._model.retranslate()
        self._fit_columns()
        self._show_usable(self._controller.operating_state)
        self._show_detail()
        self._show_notice()

    def _fit_columns(self) -> None:
        """Wide enough for every word there is, so that nothing moves when one changes."""
        metrics = self._table.fontMetrics()
        names = max(metrics.horizontalAdvance(words.joint_item(item)) for item in Item)
        header_px = names + _HEADER_PAD_PX
        self._table.verticalHeader().setFixedWidth(header_px)
        self._below_header.setFixedWidth(header_px)
        buttons = max(button.sizeHint().width() for button in self.clear_buttons) + 2 * 4
        column_px = max(buttons, cell_width(self._table, [words.joint_word(w) for w in Word]))
        self._table.setMinimumWidth(header_px + len(JOINTS) * column_px + 2 * _FRAME_PX)

    # What the arm says ------------------------------------------------------------------------

    def _on_updated(self) -> None:
        if self.isVisible():
            self._model.refresh()

    def _on_operating_state_changed(self, operating_state: OperatingState) -> None:
        if self.isVisible():
            self._show_usable(operating_state)

    def _show_usable(self, operating_state: OperatingState) -> None:
        reason = why_not_clear(operating_state)
        use = self.tr("Ask the driver of joint {joint} to clear its error")
        for joint, button in zip(JOINTS, self.clear_buttons, strict=True):
            enable_or_explain(button, words.why_not(reason), use.format(joint=joint))

    def _show_detail(self, *_cells: object) -> None:
        """The cell the operator went to, in full: tooltips are out of the keyboard's reach."""
        index = self._table.currentIndex()
        if index.isValid():
            self._detail.setText(self._model.describe(index))
        else:
            self._detail.setText(
                self.tr("A time beside a fault says since when. Choose a cell to read it in full.")
            )

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with what went by while the window was hidden."""
        self._model.refresh()
        self._show_usable(self._controller.operating_state)
        super().showEvent(event)

    # Clearing errors --------------------------------------------------------------------------

    def _clear_error(self, joint: int) -> None:
        self._event = None
        refusal = self._controller.joint_errors.clear(joint)
        if refusal is not None:
            self._message.show_message(words.refusal(refusal), Level.WARNING)

    def _on_noticed(self, event: Event) -> None:
        if event.code in _OURS:
            self._event = event
            self._show_notice()

    def _show_notice(self) -> None:
        if self._event is None:
            self._message.show_message("")
        else:
            self._message.show_message(words.event(self._event), self._event.level)
