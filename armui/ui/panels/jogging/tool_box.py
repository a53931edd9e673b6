"""The tool centre point: where the tool's tip is in the flange; kept on this computer."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLabel, QWidget

from armui.kinematics.poses import AXES, LINEAR_AXES
from armui.ui import format as fmt
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import empty_grid
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated


class ToolBox(Translated, QWidget):
    """Six small fields; what they hold counts as soon as a field is left."""

    changed = Signal(object)
    """Six figures as they were typed; one that is none stands as its text."""

    def __init__(self) -> None:
        super().__init__()
        self._title = text_label(rank="muted", wraps=True)
        self._fields = [FigureField(fmt.DECIMALS) for _ in AXES]
        grid = empty_grid(self, gaps=(8, 2), margins=0)
        grid.addWidget(self._title, 0, 0, 1, 6)
        for place, (name, field) in enumerate(zip(AXES, self._fields, strict=True)):
            row, column = 1 + place // LINEAR_AXES, 2 * (place % LINEAR_AXES)
            field.setObjectName(f"tool_field_{name}")
            grid.addWidget(QLabel(name), row, column)
            grid.addWidget(field, row, column + 1)
            grid.setColumnStretch(column + 1, 1)
            field.editingFinished.connect(self._on_finished)
        grid.setRowStretch(grid.rowCount(), 1)
        self.retranslate_ui()

    def show_tool(self, tool: Sequence[float]) -> None:
        """Put the figures in force into the fields."""
        for field, value in zip(self._fields, tool, strict=True):
            field.show_value(value)
            field.show_attention(wanted=False)

    def mark(self, *, wrong: bool) -> None:
        """Mark the fields that hold something else than a figure, or all that was refused."""
        for field in self._fields:
            field.show_attention(wanted=wrong and (field.value is None or abs(field.value) > 180))

    def _on_finished(self) -> None:
        self.changed.emit(
            tuple(
                field.text() or fmt.NOTHING if field.value is None else field.value
                for field in self._fields
            )
        )

    def retranslate_ui(self) -> None:
        """Put names into the operator's language."""
        self._title.setText(self.tr("Tool centre point on the flange (mm, °), kept on this PC"))
        for name, field in zip(AXES, self._fields, strict=True):
            field.setAccessibleName(self.tr("Tool {axis}").format(axis=name))
