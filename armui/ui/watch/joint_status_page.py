"""The page 关节状态: the reports of each driver, open beside the work (manual 1.0.10)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, Final

from PySide6.QtCore import QPoint, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPainter, QPen, QShowEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QWidget,
)

from armui.arm.joint_status import UNITS, Item, StatusCell, Word, rows
from armui.arm.limits import JOINTS
from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.devices.joint_errors import (
    CLEAR_ERROR_ANSWERED,
    CLEAR_ERROR_SENT,
    CLEAR_ERROR_UNANSWERED,
    JointErrors,
)
from armui.control.devices.joint_monitor import JointMonitor
from armui.control.events import Event, Level
from armui.control.operating_state import OperatingState
from armui.protocol.generation import Generation
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, ActFamily
from armui.ui.theme import Colors, colors_of, scaled_font
from armui.ui.widgets import state_mark
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import STRETCH, fill, in_row
from armui.ui.widgets.message_line import MessageLine, Words
from armui.ui.widgets.page import Page
from armui.ui.widgets.state_mark import Mark
from armui.ui.widgets.table_model import Index, TableModel
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text

_HEADER_PAD_PX: Final = 12
_FRAME_PX: Final = 2
_BETWEEN_PX: Final = 3
_MOST: Final = 100
"""The stretch factor by which the table takes all height until its rows are highest."""
_OURS: Final = frozenset({CLEAR_ERROR_SENT, CLEAR_ERROR_ANSWERED, CLEAR_ERROR_UNANSWERED})
_MARK_PX: Final = 6.0
_LEFT_PX: Final = 6.0
_GAP_PX: Final = 6.0
_TEXT_LEFT_PX: Final = _LEFT_PX + 2 * _MARK_PX + _GAP_PX
_HIGHEST_ROW_PX: Final = 40
_LOWEST_ROW_PX: Final = 17
"""The least height: all rows and a message fit the drawer of a window of 1280×800."""
_ROWS: Final = 10
_WORD: Final = 0.92
"""The relative font size of words beside figures."""
_SMALL: Final = 0.84
CELL_ROLE: Final = Qt.ItemDataRole.UserRole
"""The role of a :class:`CellView`, which the delegate draws."""

_DECIMALS: Final = {
    Item.SUPPLY_VOLTAGE: 1,
    Item.MOTOR_TEMPERATURE: 0,
    Item.DRIVER_CURRENT: 2,
    Item.DRIVER_TEMPERATURE: 0,
    Item.DRIVER_ENABLED: 1,
}
"""The decimals of the figures, fixed so that columns do not jitter."""

_KINDS: Final = {
    Item.SUPPLY_VOLTAGE: ("voltage",),
    Item.MOTOR_TEMPERATURE: ("motor_temperature",),
    Item.DRIVER_CURRENT: ("motor_current",),
    Item.DRIVER_TEMPERATURE: ("driver_temperature",),
    Item.DRIVER_ENABLED: ("motor_speed", "enabled"),
}
"""The curves of a row; those of other rows are faults of the driver."""


@dataclass(frozen=True, slots=True)
class CellView:
    """The content of a cell.

    Attributes:
        text: The word, or the status code.
        figure: The figure behind it, if it has one.
        since: Of a fault, the time of day when it began.
        mark: The sign before the word; the status code has none.
        stale: True if it is too old to count as present.
    """

    text: str
    figure: str
    since: str
    mark: Mark | None
    stale: bool

    @property
    def small(self) -> str:
        """The figure, and for a fault the time when it began."""
        return " · ".join(filter(None, (self.figure, self.since)))


class JointStatusModel(TableModel):
    """Shows the content of a monitor; updated by :meth:`refresh`.

    Args:
        monitor: Gives the state of the joints.
    """

    _columns = len(JOINTS)

    def __init__(self, monitor: JointMonitor) -> None:
        super().__init__()
        self._monitor = monitor
        self._generation: Generation | None = None
        self._rows: Sequence[Item] = rows(None)
        self._cells = {(row, column): StatusCell() for row in range(_ROWS) for column in range(6)}

    def refresh(self) -> None:
        """Read the joints and report the changed cells to the view."""
        if self._monitor.generation is not self._generation:
            self._generation = self._monitor.generation
            self._rows = rows(self._generation)
            self.headerDataChanged.emit(Qt.Orientation.Vertical, 0, len(self._rows) - 1)
        for row, item in enumerate(self._rows):
            for column, joint in enumerate(JOINTS):
                cell = self._monitor.cell(item, joint)
                if cell != self._cells[row, column]:
                    self._cells[row, column] = cell
                    index = self.index(row, column)
                    self.dataChanged.emit(index, index)

    def retranslate(self) -> None:
        """Update every text after a change of language."""
        self.redraw()
        self.headerDataChanged.emit(Qt.Orientation.Vertical, 0, len(self._rows) - 1)

    def describe(self, index: Index) -> str:
        """Return the full text of a cell: joint, item, word, figure, and since when."""
        cell, item = self._cells[index.row(), index.column()], self._rows[index.row()]
        parts = [f"J{index.column() + 1}  {words.joint_item(item)} {_text(item, cell)}"]
        if item in UNITS:
            parts.append(_figure(item, cell))
        if cell.since is not None:
            parts.append(self.tr("since {time}").format(time=f"{cell.since:%Y-%m-%d %H:%M:%S}"))
        if cell.stale:
            parts.append(self.tr("not heard of late"))
        return " · ".join(parts)

    def quantities(self, index: Index) -> list[str]:
        """Return the keys of a cell's quantities that can be drawn as curves."""
        joint = JOINTS[index.column()]
        kinds = _KINDS.get(self._rows[index.row()], ("driver_faults",))
        keys = [f"arm.{kind}.{joint}" for kind in kinds]
        if self._rows[index.row()] is Item.COMMUNICATION:
            keys = ["arm.no_communication"]
        return keys

    # The model's interface for Qt -------------------------------------------------------------

    def headerData(  # noqa: N802 - the name Qt calls
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """Return the joint's number for a column, the item's name for a row."""
        if role != Qt.ItemDataRole.DisplayRole:
            return None
        if orientation is Qt.Orientation.Horizontal:
            return str(JOINTS[section])
        return words.joint_item(self._rows[section])

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return the word of a cell, or more of it under the other roles."""
        if not index.isValid():
            return None
        item, cell = self._rows[index.row()], self._cells[index.row(), index.column()]
        if role == Qt.ItemDataRole.DisplayRole:
            return _text(item, cell)
        if role in {Qt.ItemDataRole.ToolTipRole, Qt.ItemDataRole.AccessibleTextRole}:
            return self.describe(index)
        if role == CELL_ROLE:
            figure = _figure(item, cell) if item in UNITS and cell.value is not None else ""
            since = f"{cell.since:%H:%M:%S}" if cell.fault and cell.since is not None else ""
            return CellView(_text(item, cell), figure, since, _mark(item, cell), cell.stale)
        return None


def _text(item: Item, cell: StatusCell) -> str:
    if item is Item.STATUS_CODE:
        return fmt.NOTHING if cell.value is None else f"0x{int(cell.value):X}"
    return fmt.NOTHING if cell.word is None else words.joint_word(cell.word)


def _figure(item: Item, cell: StatusCell) -> str:
    if cell.value is None:
        return fmt.NOTHING
    return fmt.with_unit(cell.value, UNITS[item], _DECIMALS[item])


def _mark(item: Item, cell: StatusCell) -> Mark | None:
    if item is Item.STATUS_CODE:
        return None
    if cell.word is None:
        return Mark.UNKNOWN
    if cell.fault:
        return Mark.FAULT
    return Mark.OFF if cell.word in {Word.DISABLED, Word.NOT_HOMED} else Mark.GOOD


class JointCellDelegate(QStyledItemDelegate):
    """Draws a :class:`CellView`; a fault has a background of its own."""

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        """Draw one cell."""
        view = index.data(CELL_ROLE)
        table = self.parent()
        if not isinstance(view, CellView) or not isinstance(table, QWidget):
            return
        colors = colors_of(table)
        state, box = option.state, QRectF(option.rect)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        is_fault = view.mark is Mark.FAULT
        if is_fault and not view.stale:
            painter.fillRect(box, QColor(colors.stop_pale))
        if state & QStyle.StateFlag.State_HasFocus:
            painter.setPen(QPen(QColor(colors.accent), 2))
            painter.drawRect(box.adjusted(1, 1, -1, -1))
        self._draw_text(painter, colors, box, view, table)
        painter.restore()

    @staticmethod
    def _draw_text(
        painter: QPainter, colors: Colors, box: QRectF, view: CellView, table: QWidget
    ) -> None:
        """Draw the figure below the word, or beside it where the row is too low for both."""
        is_fault = view.mark is Mark.FAULT
        small_font = scaled_font(table, _SMALL)
        small = QFontMetrics(small_font)
        line_px = QFontMetrics(scaled_font(table, 1.0, bold=is_fault)).height()
        two_lines = line_px + small.height() <= box.height()
        word_font = scaled_font(table, 1.0 if two_lines else _WORD, bold=is_fault)
        word = QFontMetrics(word_font)
        below_px = small.height() if view.small and two_lines else 0
        top = box.center().y() - (word.height() + below_px) / 2
        left, width = box.left() + _TEXT_LEFT_PX, box.width() - _TEXT_LEFT_PX
        if view.mark is not None:
            center = QPointF(box.left() + _LEFT_PX + _MARK_PX, top + word.height() / 2)
            state_mark.draw(painter, colors, center, _MARK_PX, view.mark, muted=view.stale)
        painter.setFont(word_font)
        dim = view.stale or view.text == fmt.NOTHING
        painter.setPen(QColor(colors.muted if dim else colors.text))
        align = Qt.AlignmentFlag
        # Chinese characters are higher than the line height of the font
        upon = align.AlignLeft | align.AlignVCenter | Qt.TextFlag.TextDontClip
        painter.drawText(QRectF(left, top, width, word.height()), upon, view.text)
        painter.setFont(small_font)
        painter.setPen(QColor(colors.text if is_fault and not view.stale else colors.muted))
        if two_lines:
            below = QRectF(left, top + word.height(), width, small.height())
            painter.drawText(below, upon, view.small)
            return
        room = width - word.horizontalAdvance(view.text) - 2 * _GAP_PX
        # what has no room is in the tooltip, and below the table
        fits = (text for text in (view.small, view.figure) if small.horizontalAdvance(text) <= room)
        beside = box.adjusted(0, 0, -_GAP_PX, 0)
        painter.drawText(beside, align.AlignRight | align.AlignVCenter, next(fits, ""))

    def sizeHint(self, _option: QStyleOptionViewItem, _index: Index) -> QSize:
        """Return the height of a row with two lines; the columns share the table's width."""
        return QSize(0, _HIGHEST_ROW_PX)


def word_width(table: QWidget) -> int:
    """Return how wide a column must be for every word, bold, in pixels."""
    metrics = QFontMetrics(scaled_font(table, _WORD, bold=True))
    widest = max(metrics.horizontalAdvance(words.joint_word(each)) for each in Word)
    return int(_TEXT_LEFT_PX + widest + _GAP_PX)


_CLEAR: Final = Text("JointStatusPage", "Clear error")


class JointStatusPage(Page):
    """Shows the joints' reports below the work; updated only while visible.

    Args:
        controller: Clears errors.
        monitor: Gives the state of the joints.

    Attributes:
        table: The table with a row for each item and a column for each joint.
        clear_buttons: The buttons that clear each joint's error, above its column, by its number.
    """

    clear_buttons = ActFamily(
        {
            joint: Act(
                _CLEAR,
                named=f"clear_error_{joint}",
                does=JointErrors.clear,
                key=f"joint_status.clear_{joint}",
                title=replace(_CLEAR, suffix=f"J{joint}"),
            )
            for joint in JOINTS
        }
    )

    def __init__(self, controller: ArmController, monitor: JointMonitor) -> None:
        super().__init__("joint_status")
        self.setObjectName("joint_status_page")
        self._controller = controller
        self._event: Event | None = None
        self._model = JointStatusModel(monitor)
        self._build_table()
        self._build_head()
        self._detail = text_label("joint_status_detail", rank="muted", wraps=True, plain=True)
        self._message = named("joint_status_message", MessageLine(keeps_room=False, lines=1))
        self._reference = named("joint_status_reference", MessageLine(keeps_room=False, lines=1))
        self.body.setSpacing(_BETWEEN_PX)
        table = (self.table, _MOST)
        fill(*(self.body, self._head, table, self._detail, self._reference, self._message, STRETCH))
        monitor.updated.connect(self._on_updated)
        controller.operating_state_changed.connect(self._on_operating_state_changed)
        controller.noticed.connect(self._on_noticed)
        self.table.selectionModel().currentChanged.connect(self._on_chosen)
        self._model.dataChanged.connect(self._show_detail)
        self.first = self.table
        self.retranslate_ui()

    # Layout -----------------------------------------------------------------------------------

    def _build_table(self) -> None:
        self.table = named("joint_status_table", QTableView())
        self.table.setModel(self._model)
        self.table.setItemDelegate(JointCellDelegate(self.table))
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setTabKeyNavigation(False)
        self.table.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.table.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        # between these two heights the rows share the height of the table
        self.table.setMinimumHeight(_ROWS * _LOWEST_ROW_PX + 2 * _FRAME_PX)
        self.table.setMaximumHeight(_ROWS * _HIGHEST_ROW_PX + 2 * _FRAME_PX)
        across, down = self.table.horizontalHeader(), self.table.verticalHeader()
        across.hide()
        down.setMinimumSectionSize(_LOWEST_ROW_PX)
        for header in (across, down):
            header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
            header.setHighlightSections(False)
            header.setSectionsClickable(False)
        down.setDefaultAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)

    def _build_head(self) -> None:
        """Make the line above the columns: numbers of the joints, buttons that clear errors."""
        self._joint_label = text_label(rank="muted")
        self._joint_label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._head = QWidget()
        row = in_row(
            self._joint_label, on=self._head, spacing=0, margins=(_FRAME_PX, 0, _FRAME_PX, 0)
        )
        for joint, button in self.clear_buttons.items():
            button.setProperty("compact", True)
            number = text_label(text=f"J{joint}")
            number.setFont(scaled_font(number, 1.0, bold=True))
            cell = (int(_LEFT_PX), 0, _BETWEEN_PX, 0)
            row.addLayout(in_row(number, button, STRETCH, spacing=_BETWEEN_PX, margins=cell), 1)

    def quantities_at(self, place: QPoint) -> list[str]:
        """Return the quantities of the cell at a place of the page."""
        viewport = self.table.viewport()
        if not viewport.rect().contains(viewport.mapFrom(self, place)):
            return []
        index = self.table.indexAt(viewport.mapFrom(self, place))
        return self._model.quantities(index) if index.isValid() else []

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Joint status"))
        self._joint_label.setText(self.tr("Joint"))
        self.table.setAccessibleName(self.tr("Joint status"))
        self._model.retranslate()
        self._show_usable(self._controller.operating_state)
        self._fit_columns()
        self._show_detail()
        self._show_notice()

    def _fit_columns(self) -> None:
        """Make the columns wide enough for every word, whatever room that leaves for figures."""
        metrics = self.table.fontMetrics()
        names = max(metrics.horizontalAdvance(words.joint_item(item)) for item in Item)
        header_px = names + _HEADER_PAD_PX
        self.table.verticalHeader().setFixedWidth(header_px)
        self._joint_label.setFixedWidth(header_px)
        column_px = max(button.sizeHint().width() for button in self.clear_buttons.values())
        column_px = max(column_px + 4 * _BETWEEN_PX, word_width(self.table))
        self.table.setMinimumWidth(header_px + len(JOINTS) * column_px + 2 * _FRAME_PX)

    # Feedback of the arm ----------------------------------------------------------------------

    def _on_updated(self) -> None:
        if self.isVisible():
            self._model.refresh()

    def _on_operating_state_changed(self, operating_state: OperatingState) -> None:
        if self.isVisible():
            self._show_usable(operating_state)

    def _show_usable(self, operating_state: OperatingState) -> None:
        self.show_acts()
        doubt = words.why_not(operating_state.reference.why_doubtful())
        self._reference.show_message(doubt, Level.WARNING if doubt else Level.INFO)

    def _on_chosen(self, *_cells: object) -> None:
        """Replace the message on clearing an error by the description of the chosen cell."""
        self._event = None
        self._show_notice()
        self._show_detail()

    def _show_detail(self, *_cells: object) -> None:
        """Show the chosen cell in full: the keyboard does not reach tooltips."""
        index = self.table.currentIndex()
        if index.isValid():
            self._detail.setText(self._model.describe(index))
        else:
            self._detail.setText(
                self.tr("A time beside a fault says since when. Choose a cell to read it in full.")
            )

    def showEvent(self, event: QShowEvent) -> None:
        """Update the joints, which were not updated while the page was hidden."""
        self._model.refresh()
        self._show_usable(self._controller.operating_state)
        super().showEvent(event)

    # Clearing errors --------------------------------------------------------------------------

    @clear_buttons.tip
    def _what_clears(self, joint: int) -> str:
        return self.tr("Ask the driver of joint {joint} to clear its error").format(joint=joint)

    @clear_buttons.whose
    def _of_joint(self, joint: int) -> str:
        return f"J{joint}"

    @clear_buttons.pressed
    def _clear_error(self, joint: int) -> None:
        self._event = None
        answer = self._controller.joint_errors.clear(joint)
        if isinstance(answer, Refusal):
            self._show_message(partial(words.refusal, answer), Level.WARNING)

    def _on_noticed(self, event: Event) -> None:
        if event.notice in _OURS:
            self._event = event
            self._show_notice()

    def _show_notice(self) -> None:
        if self._event is None:
            self._show_message("", Level.INFO)
        else:
            self._show_message(partial(words.event, self._event), self._event.level)

    def _show_message(self, text: Words, level: Level) -> None:
        """Say something in the place of the chosen cell's line."""
        self._message.show_message(text, level)
        self._detail.setHidden(bool(text))
