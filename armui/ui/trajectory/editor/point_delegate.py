"""Opens the right editor in each cell of the table of points.

It paints nothing: a delegate's painting in Python is called for every cell, time and again.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, Protocol, cast, runtime_checkable

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
from PySide6.QtWidgets import (
    QComboBox,
    QLabel,
    QLineEdit,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from armui.trajectory.files.log_points import LETTERS
from armui.trajectory.points.cells import HOLDS, IN_FRAME, VALUES, PointColumn
from armui.ui.trajectory.editor.points_model import PointsModel
from armui.ui.widgets.buttons import drop_down, named
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.painting import repolish
from armui.ui.widgets.table_model import Index
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

_FIELD_PX: Final = 62
_COLOR_PX: Final = 130
_ALL: Final = "all"
_HOLDS_NOTHING: Final = 1
"""The index of the entry for an empty hand; 0 is that for no change."""
_JOINTS: Final = 6


@runtime_checkable
class CellEditor(Protocol):
    """What the delegate asks of an editor."""

    def text(self) -> str:
        """Return the entry, in the notation of the model."""

    def set_text(self, text: str) -> None:
        """Show what stood in the cell."""


class TextEditor(QLineEdit):
    """An editor for a figure, the six figures of a pose, or a note."""

    def __init__(self, parent: QWidget, *, figure: bool) -> None:
        super().__init__(parent)
        if figure:
            self.setAlignment(Qt.AlignmentFlag.AlignRight)

    def set_text(self, text: str) -> None:
        """Show what stood in the cell, ready to be typed over."""
        self.setText(text)
        self.selectAll()


class MoveEditor(QComboBox):
    """An editor of the kind of motion; choosing one closes it.

    Signals:
        decided: The operator has chosen a kind.
    """

    decided = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        for letter in LETTERS:
            self.addItem(f"MOVE {letter}")
        self.activated.connect(self.decided)

    def text(self) -> str:
        """Return the chosen kind of motion."""
        return self.currentText()

    def set_text(self, text: str) -> None:
        """Choose what stood in the cell."""
        self.setCurrentText(text.partition(IN_FRAME)[0])


class _Row(Translated, QWidget):
    """Fields side by side, over the cell and what is at its right."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAutoFillBackground(True)
        self._layout = in_row(on=self, spacing=4, margins=(2, 0, 4, 0))
        self.kind = QComboBox()
        self._layout.addWidget(self.kind)
        self.setFocusProxy(self.kind)

    def add_field(self, name: str, width_px: int = _FIELD_PX) -> QLineEdit:
        """Add a field at the right end."""
        field = named(name, QLineEdit())
        field.setFixedWidth(width_px)
        self._layout.addWidget(field)
        return field

    def add_label(self) -> QLabel:
        """Add a label for a unit at the right end."""
        label = text_label(rank="muted")
        self._layout.addWidget(label)
        return label

    def focusNextPrevChild(self, forward: bool) -> bool:  # noqa: N802 - Qt's name
        """Lead Tab from field to field before it leaves the cell."""
        parts = self.findChildren(QWidget, options=Qt.FindChildOption.FindDirectChildrenOnly)
        none = Qt.FocusPolicy.NoFocus
        stops = [each for each in parts if each.focusPolicy() != none and each.isEnabled()]
        here = stops.index(self.focusWidget())
        there = here + (1 if forward else -1)
        if not 0 <= there < len(stops):
            return super().focusNextPrevChild(forward)
        stops[there].setFocus(Qt.FocusReason.TabFocusReason)
        return True

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""


class GripperEditor(_Row):
    """An editor of the gripper's action on arrival, and of what the hand holds from then on.

    Args:
        held: The names of what it may hold.
    """

    _UNITS: Final = (("", ""), ("mm", "N·m"), ("°", "rad/s"))
    _FIRST: Final = (("", ""), ("0", "1"), ("0", "1"))

    def __init__(self, parent: QWidget, held: Sequence[str]) -> None:
        super().__init__(parent)
        self.kind.setObjectName("gripper_kind")
        self.kind.addItems(["", "", ""])
        self.place = self.add_field("gripper_place")
        self._place_unit = self.add_label()
        self.force = self.add_field("gripper_force")
        self._force_unit = self.add_label()
        self.holds = drop_down("gripper_holds")
        self.holds.addItems(["", "", *held])
        self._layout.addWidget(self.holds)
        self.kind.currentIndexChanged.connect(self._on_kind)
        self.kind.installEventFilter(self)
        self.retranslate_ui()
        self._on_kind(0)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Put a digit typed on the kind into the field for the opening, or the angle if chosen."""
        typed = isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress
        if not (typed and event.text().isdigit()):  # type: ignore[attr-defined]  # a key's
            return super().eventFilter(watched, event)
        self.kind.setCurrentIndex(self.kind.currentIndex() or 1)
        self.place.setFocus()
        self.place.setText(event.text())  # type: ignore[attr-defined]  # as above
        return True

    def retranslate_ui(self) -> None:
        """Set the kinds in the operator's language."""
        texts = (self.tr("Nothing"), self.tr("Opening"), self.tr("Angle"))
        for place, text in enumerate(texts):
            self.kind.setItemText(place, text)
        for place, text in enumerate((self.tr("Holds as before"), self.tr("Holds nothing"))):
            self.holds.setItemText(place, text)
        self.holds.setToolTip(self.tr("What the gripper holds from this point on"))

    def _on_kind(self, kind: int) -> None:
        place, force = self._FIRST[kind]
        for field, text in ((self.place, place), (self.force, force)):
            field.setEnabled(kind > 0)
            field.setText(text)
        self._place_unit.setText(self._UNITS[kind][0])
        self._force_unit.setText(self._UNITS[kind][1])

    def text(self) -> str:
        """Return the action as in ``35mm@1Nm holds=Cube``; empty for none."""
        kind, holds = self.kind.currentIndex(), self.holds.currentIndex()
        units = ("mm", "Nm") if kind == 1 else ("°", "rad/s")
        action = f"{_plain(self.place)}{units[0]}@{_plain(self.force)}{units[1]}" if kind else ""
        held = self.holds.currentText() if holds > _HOLDS_NOTHING else ""
        return action if holds == 0 else f"{action} {HOLDS}{held}".lstrip()

    def set_text(self, text: str) -> None:
        """Show the action in a text."""
        text, sign, held = (part.strip() for part in text.partition(HOLDS))
        if held and self.holds.findText(held) < 0:
            self.holds.addItem(held)
        self.holds.setCurrentIndex(
            self.holds.findText(held) if held else _HOLDS_NOTHING if sign else 0
        )
        place, _, force = text.partition("@")
        self.kind.setCurrentIndex(0 if not text else 1 if place.endswith("mm") else 2)
        if text:
            self.place.setText(place.removesuffix("mm").removesuffix("°"))
            self.force.setText(force.removesuffix("Nm").removesuffix("rad/s"))


class LightEditor(_Row):
    """An editor of the lamps' action on arrival: joint, lamp and colour."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.kind.setObjectName("light_joint")
        self.kind.addItem("")
        self.kind.addItems([f"J{joint}" for joint in range(1, _JOINTS + 1)])
        self.lamp = self.add_field("light_lamp")
        self.color = self.add_field("light_color", _COLOR_PX)
        self.kind.currentIndexChanged.connect(self._on_joint)
        self.retranslate_ui()
        self._on_joint(0)

    def retranslate_ui(self) -> None:
        """Set the names of the fields in the operator's language."""
        self.kind.setItemText(0, self.tr("Nothing"))
        self.lamp.setToolTip(self.tr("Lamp: 0 to 254, or all"))
        self.color.setToolTip(self.tr("Grey values of red, green and blue, 0 to 255: 255,128,0"))
        self.color.setPlaceholderText("R,G,B")

    def _on_joint(self, joint: int) -> None:
        self.lamp.setEnabled(joint > 0)
        self.color.setEnabled(joint > 0)
        if joint > 0 and not self.lamp.text():
            self.lamp.setText(_ALL)
            self.color.setText("255,255,255")

    def text(self) -> str:
        """Return the action as in ``1/all:255,128,0``; empty for none."""
        joint = self.kind.currentIndex()
        if joint == 0:
            return ""
        return f"{joint}/{_plain(self.lamp).lower()}:{self.color.text().replace(' ', '')}"

    def set_text(self, text: str) -> None:
        """Show the action in a text."""
        joint, _, rest = text.partition("/")
        lamp, _, color = rest.partition(":")
        self.lamp.setText(lamp)
        self.color.setText(color)
        self.kind.setCurrentIndex(int(joint) if joint else 0)


def _plain(field: QLineEdit) -> str:
    return field.text().strip().replace(",", ".").replace("−", "-")


_LEAVING: Final = frozenset(
    {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Tab, Qt.Key.Key_Backtab}
)


class PointDelegate(QStyledItemDelegate):
    """Keeps an editor open while its content is invalid, and shows the reason.

    Signals:
        refused: An index and the :class:`Refusal` of the present entry.
        accepted: The former refusal of an entry no longer holds.
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
        """Return the editor for the cell's column."""
        self._index = QPersistentModelIndex(index)
        self.accepted.emit()
        column = PointColumn(index.column())
        if column is PointColumn.MOVE:
            editor = MoveEditor(parent)
            editor.decided.connect(self._on_decided)
            return editor
        if column is PointColumn.GRIPPER:
            model = index.model()
            held = model.held_names if isinstance(model, PointsModel) else ()
            return GripperEditor(parent, held)
        if column is PointColumn.LIGHT:
            return LightEditor(parent)
        return TextEditor(parent, figure=column in {*VALUES, PointColumn.SPEED, PointColumn.DWELL})

    def _on_decided(self) -> None:
        editor = cast("MoveEditor", self.sender())
        self.commitData.emit(editor)
        self.closeEditor.emit(editor)

    def setEditorData(self, editor: QWidget, index: Index) -> None:  # noqa: N802 - Qt's name
        """Show the cell's content, unless another one is being typed: rows are also repainted."""
        typed = isinstance(editor, QLineEdit) and editor.isModified()
        if isinstance(editor, CellEditor) and not typed:
            editor.set_text(str(index.data(Qt.ItemDataRole.EditRole)))

    def setModelData(  # noqa: N802 - Qt's name
        self, editor: QWidget, model: QAbstractItemModel, index: Index
    ) -> None:
        """Pass the entry to the model, which reports a refusal."""
        if isinstance(editor, CellEditor):
            model.setData(index, editor.text(), Qt.ItemDataRole.EditRole)

    def updateEditorGeometry(  # noqa: N802 - Qt's name
        self, editor: QWidget, option: QStyleOptionViewItem, _index: Index
    ) -> None:
        """Place the editor over the cell, wider if needed, within the visible table."""
        cell: QRect = option.rect
        width = max(cell.width(), editor.sizeHint().width(), editor.minimumSizeHint().width())
        if isinstance(editor, TextEditor):
            width = max(cell.width(), 80)
        parent = editor.parentWidget()
        room = cell.right() if parent is None else parent.width()
        editor.setGeometry(max(0, min(cell.x(), room - width)), cell.y(), width, cell.height())

    def eventFilter(self, editor: QObject, event: QEvent) -> bool:
        """Keep the editor open while its content is invalid."""
        if (
            event.type() == QEvent.Type.KeyPress
            and isinstance(event, QKeyEvent)
            and Qt.Key(event.key()) in _LEAVING
            and isinstance(editor, CellEditor)
            and not self.can_take(editor)
        ):
            return True
        return super().eventFilter(editor, event)

    def can_take(self, editor: CellEditor) -> bool:
        """Return whether the model takes the present entry; show at the cell why not."""
        model = self._index.model()
        if not isinstance(model, PointsModel):
            return True
        reason = model.why_not(self._index, editor.text())
        if reason is None:
            self.accepted.emit()
            return True
        self.refused.emit(model.index(self._index.row(), self._index.column()), reason)
        if isinstance(editor, QLineEdit):
            editor.setProperty("attention", True)
            repolish(editor)
        return False
