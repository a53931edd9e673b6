"""The points of a trajectory as a table; fast with ten thousand of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QMimeData, QModelIndex, QObject, Qt, Signal
from PySide6.QtGui import QColor

from armui.arm.figures import Range
from armui.arm.limits import JointLimits
from armui.arm.refusal import Refusal
from armui.protocol.codes import ALL_LAMPS, MoveMode
from armui.trajectory.files.log_points import LETTERS
from armui.trajectory.files.text import number
from armui.trajectory.planning.tool_points import ToolPoints
from armui.trajectory.planning.user_frames import Frames, frames_of, why_unknown
from armui.trajectory.points import edits
from armui.trajectory.points.cells import IN_FRAME, VALUES, PointColumn, editable, edited, text_of
from armui.trajectory.points.edits import Change
from armui.trajectory.points.program import (
    POINT_MOVE_UNKNOWN,
    GripperAction,
    GripperOpening,
    LightAction,
    Values,
    Waypoint,
    check_point,
    range_of,
)
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.trajectory.editor.document import Document
from armui.ui.widgets.table_model import LEFT, RIGHT, Index, TableModel
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.cell.cell import Cell

ROWS_MIME: Final = "application/x-armui-rows"

ToMove = Callable[[int, MoveMode], Waypoint | Refusal]
"""Returns the point of a row with another kind of motion, or why not."""

POSES: Final = frozenset({*VALUES, PointColumn.MIDDLE})
"""The columns whose figures may be those of a tool."""
_COLUMNS: Final = tuple(PointColumn)


@dataclass(frozen=True, slots=True)
class ColumnLook:
    """How a column looks.

    Attributes:
        title: Its title; that of the figures says what they are for either kind of motion.
        width_px: As wide as title and usual figures, so that every column is in sight beside the
            picture.
        most_px: How wide it becomes by itself, for what stands in it; 0 for no wider.
        figures: True for figures, which are aligned to the right.
    """

    title: Text
    width_px: int
    most_px: int = 0
    figures: bool = False


_AXES: Final = ("J1 °\nX mm", "J2 °\nY mm", "J3 °\nZ mm", "J4 °\nRX °", "J5 °\nRY °", "J6 °\nRZ °")
LOOKS: Final[Mapping[PointColumn, ColumnLook]] = {
    PointColumn.MOVE: ColumnLook(Text("PointsModel", "Motion\n({point})"), 60, 170),
    **{
        PointColumn(place): ColumnLook(Text("", axis), 50, 84, figures=True)
        for place, axis in zip(VALUES, _AXES, strict=True)
    },
    PointColumn.MIDDLE: ColumnLook(Text("PointsModel", "Middle\npose"), 80, 170),
    PointColumn.SPEED: ColumnLook(Text("PointsModel", "Speed"), 50, 64, figures=True),
    PointColumn.DWELL: ColumnLook(Text("PointsModel", "Dwell"), 46, 84, figures=True),
    PointColumn.GRIPPER: ColumnLook(Text("PointsModel", "Gripper"), 58, 220),
    PointColumn.LIGHT: ColumnLook(Text("PointsModel", "Light"), 44, 110),
    PointColumn.NOTE: ColumnLook(Text("PointsModel", "Note"), 44),
}

_FIXED: Final = (
    Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsDragEnabled
)
_EDITABLE: Final = _FIXED | Qt.ItemFlag.ItemIsEditable

_SHOWN: Final = int(Qt.ItemDataRole.DisplayRole)
_EXACT: Final = int(Qt.ItemDataRole.EditRole)
_ALIGNED: Final = int(Qt.ItemDataRole.TextAlignmentRole)
_EXPLAINED: Final = int(Qt.ItemDataRole.ToolTipRole)
_READ_OUT: Final = int(Qt.ItemDataRole.AccessibleTextRole)
_DECORATED: Final = int(Qt.ItemDataRole.DecorationRole)
_ANSWERED: Final = frozenset({_SHOWN, _EXACT, _ALIGNED, _EXPLAINED, _READ_OUT, _DECORATED})
"""The roles with an answer: Qt asks for ten roles of each cell it paints."""


class PointsModel(TableModel):
    """A row for each point, a column for each of :class:`PointColumn`.

    Args:
        document: The document with the points.
        to_move: Converts a point when its kind of motion is changed.
        limits: Returns the limits of the six joints in force, for the angles that are entered.

    Attributes:
        limits: As given.
        tool: Shows poses for the tool in force; what a point keeps is the pose of the flange.
        held_names: The names of what the hand may hold.

    Signals:
        refused: An index and the :class:`Refusal` of the entry.
        moved: The first row, and how many, after rows were dragged elsewhere.
    """

    refused = Signal(object, object)
    moved = Signal(int, int)
    _columns = len(PointColumn)

    def __init__(
        self,
        document: Document,
        to_move: ToMove,
        limits: Callable[[], Sequence[JointLimits]],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._to_move = to_move
        self.limits = limits
        self._frames: Frames = {}
        self.held_names: Sequence[str] = ()
        self.tool = ToolPoints()
        self._tool_name = ""
        self._points = document.points
        self._current = -1
        self._faults: Mapping[int, bool] = {}
        document.changed.connect(self._on_changed)

    # The model's interface for Qt -------------------------------------------------------------

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008, N802 - Qt's signature
        """Return the number of points."""
        return 0 if parent.isValid() else len(self._points)

    def point(self, row: int) -> Waypoint:
        """Return the point of a row."""
        return self._points[row]

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return the text of a cell; exact under ``EditRole``."""
        if role not in _ANSWERED or not index.isValid():
            return None
        column = _COLUMNS[index.column()]
        if role == _ALIGNED:
            return RIGHT if LOOKS[column].figures else LEFT
        point = self._points[index.row()]
        if column in POSES:
            point = self.tool.shown(point)
        if role == _DECORATED:
            return _swatch(point.light) if column is PointColumn.LIGHT else None
        if role == _EXACT:
            return text_of(point, column)
        return self._tip(point, column) if role == _EXPLAINED else self._shown(point, column)

    def _shown(self, point: Waypoint, column: PointColumn) -> str:
        if (
            column is PointColumn.LIGHT
            and point.light is not None
            and point.light.lamp == ALL_LAMPS
        ):
            return self.tr("J{joint} all").format(joint=point.light.joint)
        if column is PointColumn.MOVE and why_unknown((point,), self._frames) is not None:
            return f"? {shown(point, column)}"  # in front: a narrow column cuts the end
        if column is PointColumn.GRIPPER and point.holds is not None:
            text = self.tr("holds {name}") if point.holds else self.tr("holds nothing")
            told = (_gripper(point.gripper), text.format(name=point.holds))
            return fmt.listed(filter(None, told))
        return shown(point, column)

    def _tip(self, point: Waypoint, column: PointColumn) -> str:
        if column in VALUES:
            name = point.names[column - PointColumn.VALUE_1]
            allowed = range_of(name, far=bool(point.frame))
            if point.is_joint:
                joint = self.limits()[column - PointColumn.VALUE_1]
                allowed = Range(joint.min_deg, joint.max_deg, allowed.unit)
            return f"{name}: {allowed.minimum:g} – {allowed.maximum:g} {allowed.unit}"
        if column is PointColumn.MOVE and point.frame:
            unknown = why_unknown((point,), self._frames)
            if unknown is not None:
                return words.refusal(unknown)
            text = self.tr("Its place counts from the user frame “{name}” of the cell.")
            return text.format(name=point.frame)
        return text_of(point, column)

    def headerData(  # noqa: N802 - Qt's name
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """Return the titles of the columns, or a row's number and state."""
        if role == Qt.ItemDataRole.ToolTipRole and orientation == Qt.Orientation.Horizontal:
            return self._explained()
        if role != Qt.ItemDataRole.DisplayRole:
            return None
        if orientation == Qt.Orientation.Horizontal:
            return self.titles()[section]
        if section == self._current:
            return f"▶ {section + 1}"
        sign = {None: "", False: "! ", True: "✕ "}[self._faults.get(section)]
        return f"{sign}{section + 1}"

    def _explained(self) -> str:
        if self.tool.is_flange:
            return self.tr("Poses in the table are those of the flange: no tool is in force.")
        text = self.tr(
            "Poses in the table are of the tool centre point of {tool}. A point keeps where "
            "the flange is: another tool changes these figures, not where the arm goes."
        )
        return text.format(tool=self.named_tool)

    @property
    def named_tool(self) -> str:
        """The tool whose poses are shown, as a sentence names it."""
        name = self._tool_name
        return self.tr("the tool “{name}”").format(name=name) if name else self.tr("the tool")

    def titles(self) -> Sequence[str]:
        """Return the titles of :class:`PointColumn`."""
        name = fmt.short(self._tool_name) or self.tr("tool")
        point = self.tr("flange") if self.tool.is_flange else name
        return [look.title.text().format(point=point) for look in LOOKS.values()]

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Return the flags of a cell: whether it is `editable`; between rows only dropping."""
        if not index.isValid():
            return Qt.ItemFlag.ItemIsDropEnabled
        can_edit = editable(self._points[index.row()], _COLUMNS[index.column()])
        return _EDITABLE if can_edit else _FIXED

    def setData(  # noqa: N802 - Qt's name
        self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole
    ) -> bool:
        """Set a cell's content; return whether it was accepted, and emit :attr:`refused` if not."""
        if role != Qt.ItemDataRole.EditRole or not index.isValid():
            return False
        row = index.row()
        point = self._entered(row, PointColumn(index.column()), str(value))
        if isinstance(point, Refusal):
            self.refused.emit(index, point)
            return False
        if point != self._points[row]:
            self._document.edit(edits.change(self._points, {row: point}), self.tr("Edit"))
        return True

    def why_not(self, index: Index, text: str) -> Refusal | None:
        """Return the reason against a text in a cell, or ``None``."""
        point = self._entered(index.row(), PointColumn(index.column()), text)
        return point if isinstance(point, Refusal) else None

    def _entered(self, row: int, column: PointColumn, text: str) -> Waypoint | Refusal:
        point = self._points[row]
        if column in POSES:
            if text == text_of(before := self.tool.shown(point), column):
                return point  # unchanged: accepted even beyond the limits of this arm
            typed = edited(before, column, text, self.limits())
            if isinstance(typed, Refusal):
                return typed
            kept = self.tool.kept(typed, point)
            return check_point(kept) or kept
        if column is not PointColumn.MOVE:
            return edited(point, column, text)
        move = LETTERS.get(text.partition(IN_FRAME)[0][-1:])
        if move is None:
            return POINT_MOVE_UNKNOWN(value=text)
        return self._to_move(row, move)

    # Dragging rows ----------------------------------------------------------------------------

    def supportedDropActions(self) -> Qt.DropAction:  # noqa: N802 - Qt's name
        """Return that rows are moved."""
        return Qt.DropAction.MoveAction

    def mimeTypes(self) -> list[str]:  # noqa: N802 - Qt's name
        """Return the type of rows of this table."""
        return [ROWS_MIME]

    def mimeData(self, indexes: Iterable[Index]) -> QMimeData:  # noqa: N802 - Qt's name
        """Return the numbers of the dragged rows."""
        rows = sorted({index.row() for index in indexes})
        data = QMimeData()
        data.setData(ROWS_MIME, ",".join(map(str, rows)).encode())
        return data

    def dropMimeData(  # noqa: N802 - Qt's name
        self, data: QMimeData, _action: Qt.DropAction, row: int, _column: int, parent: Index
    ) -> bool:
        """Move the dragged rows before the row above which they were dropped.

        Returns:
            ``False``: the view has no rows to take away.
        """
        text = bytes(data.data(ROWS_MIME).data()).decode()
        rows = [int(word) for word in text.split(",") if word]
        before = row if row >= 0 else parent.row() if parent.isValid() else len(self._points)
        if rows and rows[-1] < len(self._points):
            points, first = edits.move(self._points, rows, before)
            if self._document.edit(points, self.tr("Move")):
                self.moved.emit(first, len(rows))
        return False

    # What changes -----------------------------------------------------------------------------

    def _on_changed(self, change: Change) -> None:
        """Report only changed rows, so that the view keeps its scroll position and selection."""
        points = self._document.points
        same = min(len(change.removed), len(change.added))
        if same:
            self._points = points[: change.first + same] + self._points[change.first + same :]
            top, bottom = (
                self.index(change.first, 0),
                self.index(change.first + same - 1, PointColumn.NOTE),
            )
            self.dataChanged.emit(top, bottom)
        first = change.first + same
        if len(change.removed) > same:
            self.beginRemoveRows(QModelIndex(), first, change.first + len(change.removed) - 1)
            self._points = points
            self.endRemoveRows()
        elif len(change.added) > same:
            self.beginInsertRows(QModelIndex(), first, change.first + len(change.added) - 1)
            self._points = points
            self.endInsertRows()

    @property
    def current(self) -> int:
        """The row to which the arm moves; −1 if none."""
        return self._current

    def fault(self, row: int) -> bool | None:
        """Return true for a row with an error, false with a warning, ``None`` with neither."""
        return self._faults.get(row)

    def show_current(self, row: int) -> None:
        """Highlight the row to which the arm moves; −1 for none."""
        if row != self._current:
            rows, self._current = (self._current, row), row
            self._redraw(rows)

    def show_faults(self, faults: Mapping[int, bool]) -> None:
        """Mark the rows with findings: ``True`` for an error, ``False`` for a warning."""
        if faults != self._faults:
            rows, self._faults = {*self._faults, *faults}, faults
            self._redraw(rows)

    def _redraw(self, rows: Iterable[int]) -> None:
        """Have rows painted again, as one range: separate ones are slow for ten thousand rows."""
        there = [row for row in rows if 0 <= row < len(self._points)]
        if there:
            first, last = min(there), max(there)
            self.dataChanged.emit(self.index(first, 0), self.index(last, len(PointColumn) - 1))
            self.headerDataChanged.emit(Qt.Orientation.Vertical, first, last)

    def show_cell(self, cell: Cell | None) -> None:
        """Mark the points that name what the cell has not, and offer what it has."""
        self._frames = frames_of(cell)
        self.held_names = () if cell is None else [each.name for each in cell.held_objects]
        self._redraw((0, len(self._points) - 1))

    def show_tool(self, tool: Values, name: str) -> None:
        """Show poses for another tool; no point changes."""
        self.tool, self._tool_name = ToolPoints(tool), name
        self._redraw((0, len(self._points) - 1))
        self.retranslate()

    def retranslate(self) -> None:
        """Update the titles after a change of language."""
        self.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, len(PointColumn) - 1)


def shown(point: Waypoint, column: PointColumn) -> str:
    """Return the text of a cell: figures with fixed decimals; the title has their units."""
    if column in VALUES:
        return fmt.number(point.target[column - PointColumn.VALUE_1])
    if column is PointColumn.MIDDLE:
        figures = [fmt.number(value, 1).removesuffix(".0") for value in point.middle or ()]
        return "\n".join(filter(None, ("  ".join(figures[:3]), "  ".join(figures[3:]))))
    if column is PointColumn.SPEED:
        return f"{point.speed_percent} %"
    if column is PointColumn.DWELL:
        return f"{text_of(point, column)} s" if point.dwell_s else fmt.NOTHING
    if column is PointColumn.MOVE and point.frame:
        return f"MOVE {point.move.name[-1]} · {point.frame}"
    if column is PointColumn.GRIPPER:
        return _gripper(point.gripper)
    if column is PointColumn.LIGHT:
        return "" if point.light is None else f"J{point.light.joint} / {point.light.lamp}"
    return " ".join(text_of(point, column).split())


def _gripper(action: GripperAction | None) -> str:
    if action is None:
        return ""
    if isinstance(action, GripperOpening):
        return f"{number(action.opening_mm)} mm, {number(action.torque_nm)} N·m"
    return f"{number(action.angle_deg)}°, {number(action.speed_rad_s)} rad/s"


def _swatch(light: LightAction | None) -> QColor | None:
    """Return the colour of the lamps, which the view draws beside the text."""
    return None if light is None else QColor(light.red, light.green, light.blue)
