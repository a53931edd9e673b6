"""The table of the window 关节状态: ten items by six joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

from PySide6.QtCore import Qt

from armui.arm.joint_status import UNITS, Item, StatusCell, Word, rows
from armui.arm.limits import JOINTS
from armui.control.devices.joint_monitor import JointMonitor
from armui.protocol.generation import Generation
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.widgets.state_mark import Mark
from armui.ui.widgets.table_model import Index, TableModel

CELL_ROLE: Final = Qt.ItemDataRole.UserRole
"""A :class:`CellView`: what the delegate draws."""

_DECIMALS: Final = {
    Item.SUPPLY_VOLTAGE: 1,
    Item.MOTOR_TEMPERATURE: 0,
    Item.DRIVER_CURRENT: 2,
    Item.DRIVER_TEMPERATURE: 0,
    Item.DRIVER_ENABLED: 1,
}
"""Of the figures, so that columns of them stand still."""

_KINDS: Final = {
    Item.SUPPLY_VOLTAGE: ("voltage",),
    Item.MOTOR_TEMPERATURE: ("motor_temperature",),
    Item.DRIVER_CURRENT: ("motor_current",),
    Item.DRIVER_TEMPERATURE: ("driver_temperature",),
    Item.DRIVER_ENABLED: ("motor_speed", "enabled"),
}
"""Which curves belong to a row; the others are faults of the driver."""


@dataclass(frozen=True, slots=True)
class CellView:
    """A cell ready to be drawn.

    Attributes:
        text: The word, or the status code.
        small: The figure behind it, and of a fault since when.
        mark: What stands before the word; the status code has none.
        stale: It was heard a while ago.
    """

    text: str
    small: str
    mark: Mark | None
    stale: bool


class JointStatusModel(TableModel):
    """Shows what a monitor knows; told by :meth:`refresh` to look.

    Args:
        monitor: Knows the joints.
    """

    _columns = len(JOINTS)

    def __init__(self, monitor: JointMonitor) -> None:
        super().__init__()
        self._monitor = monitor
        self._generation: Generation | None = None
        self._rows: Sequence[Item] = rows(None)
        self._cells = {(row, column): StatusCell() for row in range(10) for column in range(6)}

    def refresh(self) -> None:
        """Look at the joints and tell the view which cells have changed."""
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
        """Every word anew: the language has changed."""
        self.redraw()
        self.headerDataChanged.emit(Qt.Orientation.Vertical, 0, len(self._rows) - 1)

    def describe(self, index: Index) -> str:
        """A cell in full: joint, item, word, figure, and since when."""
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
        """The keys of what a cell shows, as far as it can be drawn as a curve."""
        joint = JOINTS[index.column()]
        kinds = _KINDS.get(self._rows[index.row()], ("driver_faults",))
        keys = [f"arm.{kind}.{joint}" for kind in kinds]
        if self._rows[index.row()] is Item.COMMUNICATION:
            keys = ["arm.no_communication"]
        return keys

    # What Qt asks -----------------------------------------------------------------------------

    def headerData(  # noqa: N802 - the name Qt calls
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """The joint's number above, the item's name on the left."""
        if role != Qt.ItemDataRole.DisplayRole:
            return None
        if orientation is Qt.Orientation.Horizontal:
            return str(JOINTS[section])
        return words.joint_item(self._rows[section])

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """The word of a cell; more of it under the other roles."""
        if not index.isValid():
            return None
        item, cell = self._rows[index.row()], self._cells[index.row(), index.column()]
        if role == Qt.ItemDataRole.DisplayRole:
            return _text(item, cell)
        if role in {Qt.ItemDataRole.ToolTipRole, Qt.ItemDataRole.AccessibleTextRole}:
            return self.describe(index)
        if role == CELL_ROLE:
            return CellView(_text(item, cell), _small(item, cell), _mark(item, cell), cell.stale)
        return None


def _text(item: Item, cell: StatusCell) -> str:
    if item is Item.STATUS_CODE:
        return fmt.NOTHING if cell.value is None else f"0x{int(cell.value):X}"
    return fmt.NOTHING if cell.word is None else words.joint_word(cell.word)


def _figure(item: Item, cell: StatusCell) -> str:
    if cell.value is None:
        return fmt.NOTHING
    return f"{fmt.number(cell.value, _DECIMALS[item])} {UNITS[item]}"


def _small(item: Item, cell: StatusCell) -> str:
    figure = [_figure(item, cell)] if item in UNITS and cell.value is not None else []
    since = [f"{cell.since:%H:%M:%S}"] if cell.fault and cell.since is not None else []
    return " · ".join(figure + since)


def _mark(item: Item, cell: StatusCell) -> Mark | None:
    if item is Item.STATUS_CODE:
        return None
    if cell.word is None:
        return Mark.UNKNOWN
    if cell.fault:
        return Mark.FAULT
    return Mark.OFF if cell.word in {Word.DISABLED, Word.NOT_HOMED} else Mark.GOOD
