"""The guessed dialect of an unknown table, for the operator to correct."""

from __future__ import annotations

from typing import Any, Final

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QComboBox, QLabel, QSpinBox, QWidget

from armui.trajectory.columns import LABELS, Dialect, Encoding, TableFile
from armui.trajectory.columns.model import DECIMALS, DELIMITERS, SPACES
from armui.ui.widgets.buttons import drop_down, named
from armui.ui.widgets.flow import in_flow, pair
from armui.ui.widgets.translated import Translated

_FIELD_PX: Final = 34
_MOST_LINES: Final = 9_999_999


class DialectBar(Translated, QWidget):
    """Encoding, delimiter, decimal sign and the line of the first figures.

    Signals:
        changed: The operator has set one of them; the others may be guessed again.
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._encoding = _choice("dialect_encoding", tuple(Encoding))
        self._delimiter = _choice("dialect_delimiter", DELIMITERS)
        self._decimal = _choice("dialect_decimal", DECIMALS)
        self._line = named("dialect_line", _Line())
        self._line.setKeyboardTracking(False)
        self._line.setMinimumWidth(90)
        self._line.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._fields = (self._encoding, self._delimiter, self._decimal, self._line)
        self._labels = tuple(QLabel() for _ in self._fields)
        self._chosen_fields: set[QWidget] = set()
        for label, field in zip(self._labels, self._fields, strict=True):
            label.setBuddy(field)
            field.setFixedHeight(_FIELD_PX)
        in_flow(*map(pair, self._labels, self._fields), on=self, spacing_px=10)
        for box in (self._encoding, self._delimiter, self._decimal):
            box.activated.connect(lambda _place, box=box: self._on_chosen(box))
        self._line.valueChanged.connect(lambda _line: self._on_chosen(self._line))
        self.retranslate_ui()

    @property
    def encoding(self) -> Encoding | None:
        """The encoding set by the operator; ``None`` to guess it."""
        said: Encoding | None = self._value(self._encoding)
        return said

    @property
    def dialect(self) -> Dialect:
        """The other parts of the dialect as set by the operator; ``None`` to guess one."""
        line = self._line.value() if self._line in self._chosen_fields else None
        return Dialect(self._value(self._delimiter), self._value(self._decimal), line)

    def show_table(self, table: TableFile) -> None:
        """Show the dialect with which a file was read."""
        sheet = table.sheet
        shown = (table.encoding, sheet.delimiter, sheet.decimal)
        for box, value in zip((self._encoding, self._delimiter, self._decimal), shown, strict=True):
            box.setCurrentIndex(box.findData(value))
        with QSignalBlocker(self._line):
            self._line.setRange(1, min(_MOST_LINES, max(1, sheet.lines)))
            self._line.setValue(sheet.first_line)

    def _value(self, box: QComboBox) -> Any:
        return box.currentData() if box in self._chosen_fields else None

    def _on_chosen(self, field: QWidget) -> None:
        """Note a corrected field; with another encoding the first line is guessed again."""
        self._chosen_fields.add(field)
        if field is self._encoding:
            self._chosen_fields.discard(self._line)
        self.changed.emit()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        texts = (
            self.tr("Encoding"),
            self.tr("Delimiter"),
            self.tr("Decimal sign"),
            self.tr("Figures from line"),
        )
        for label, field, text in zip(self._labels, self._fields, texts, strict=True):
            label.setText(text)
            field.setAccessibleName(text)
        self._line.setToolTip(
            self.tr("The line above holds the column titles if it has as many cells")
        )
        names: dict[Any, str] = {
            ",": self.tr("comma ,"),
            ";": self.tr("semicolon ;"),
            "\t": self.tr("tab"),
            "|": self.tr("vertical bar |"),
            SPACES: self.tr("spaces"),
        }
        _name(self._delimiter, names)
        _name(self._decimal, {".": self.tr("point ."), ",": self.tr("comma ,")})
        _name(self._encoding, dict(LABELS))


class _Line(QSpinBox):
    """A field in which Enter takes over the figure, but does not start the import."""

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Keep Enter from pressing the default button."""
        super().keyPressEvent(event)
        if event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter}:
            event.accept()


def _choice(name: str, values: tuple[Any, ...]) -> QComboBox:
    box = drop_down(name)
    for value in values:
        box.addItem("", value)
    return box


def _name(box: QComboBox, names: dict[Any, str]) -> None:
    for place in range(box.count()):
        box.setItemText(place, names[box.itemData(place)])
