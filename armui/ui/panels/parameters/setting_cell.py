"""One parameter of the arm in a panel: its value, and a line with its state."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFont, QFontMetrics, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from armui.arm.parameters import Parameter
from armui.control.parameters.setting_draft import CellStatus, shown_as
from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets import painting, state_mark
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.state_mark import Mark

_GAP_PX: Final = 1
_NARROWEST_PX: Final = 62
_FONT_SCALE: Final = 0.82
_RADIUS_PX: Final = 4.5
_NOTE_GAP_PX: Final = 4.0

_MARKS: Final = {
    CellStatus.NOT_READ: Mark.UNKNOWN,
    CellStatus.READING: Mark.WAITING,
    CellStatus.CORRUPT: Mark.ATTENTION,
    CellStatus.CHANGED: Mark.CHANGED,
    CellStatus.WRONG: Mark.ATTENTION,
    CellStatus.SAVING: Mark.WAITING,
    CellStatus.SAVED: Mark.GOOD,
    CellStatus.NOT_SAVED: Mark.FAULT,
}


class CellNote(QWidget):
    """The line with a cell's state; it keeps its room when empty."""

    def __init__(self) -> None:
        super().__init__()
        self._status = CellStatus.READ
        self._text = ""
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)

    def text(self) -> str:
        """Return the text."""
        return self._text

    @property
    def status(self) -> CellStatus:
        """The state shown by the mark."""
        return self._status

    def show_status(self, status: CellStatus, text: str) -> None:
        """Show another mark and text."""
        if (status, text) != (self._status, self._text):
            self._status, self._text = status, text
            self.setAccessibleName(text)
            self.update()

    def sizeHint(self) -> QSize:
        """Return the size of one line of small text."""
        return QSize(0, QFontMetrics(self._font()).height())

    def minimumSizeHint(self) -> QSize:
        """Return the same: the width is that of the value above."""
        return self.sizeHint()

    def _font(self) -> QFont:
        return scaled_font(self, _FONT_SCALE)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the mark and the text to its right, aligned to the right edge."""
        mark = _MARKS.get(self._status)
        if mark is None and not self._text:
            return
        painter = painting.begin(self)
        painter.setFont(self._font())
        metrics = painter.fontMetrics()
        mark_px = 0.0 if mark is None else 2 * _RADIUS_PX + _NOTE_GAP_PX
        room_px = self.width() - mark_px
        text = metrics.elidedText(self._text, Qt.TextElideMode.ElideRight, int(room_px))
        width_px = metrics.horizontalAdvance(text)
        colors = colors_of(self)
        if mark is not None:
            x = self.width() - width_px - _NOTE_GAP_PX - _RADIUS_PX
            center = QPointF(x, self.height() / 2)
            state_mark.draw(painter, colors, center, _RADIUS_PX, mark)
        painter.setPen(QColor(colors.muted))
        area = QRectF(self.width() - width_px, 0, width_px + 1, self.height())
        painter.drawText(area, Qt.AlignmentFlag.AlignVCenter, text)
        painter.end()


def cell_name(parameter: Parameter) -> str:
    """Return the name of a parameter's cell: ``max_angle_deg_2``."""
    return f"{parameter.name}_{parameter.joint}" if parameter.joint else parameter.name


class SettingCell(QWidget):
    """The interface of all cells to the panel.

    Args:
        parameter: The parameter shown.

    Signals:
        edited: The operator has changed the value.
    """

    edited = Signal()

    def __init__(self, parameter: Parameter) -> None:
        super().__init__()
        self.parameter = parameter
        self.note = named(f"{cell_name(parameter)}_note", CellNote())

    @property
    def text(self) -> str:
        """The entry as text."""
        raise NotImplementedError

    @property
    def value(self) -> float | None:
        """The entry as a figure, or ``None`` if it is none."""
        raise NotImplementedError

    @property
    def focus_widget(self) -> QWidget:
        """The widget that the Tab key leads to."""
        raise NotImplementedError

    def show_value(self, value: float | None) -> None:
        """Show the arm's value, or ``None`` if it is not known."""
        raise NotImplementedError

    def set_locked(self, *, locked: bool) -> None:
        """Lock or unlock the entry."""
        raise NotImplementedError

    def describe(self, name: str, tip: str) -> None:
        """Set the name, and the full state as tooltip."""
        raise NotImplementedError

    def show_status(
        self,
        status: CellStatus,
        text: str,
        *,
        beyond: bool = False,  # noqa: ARG002 - only cells with a field mark it
    ) -> None:
        """Show the state.

        Args:
            status: The state.
            text: The state in a word.
            beyond: True if it exceeds the factory's value: it may be saved, but is marked.
        """
        self.note.show_status(status, text)


class FigureCell(SettingCell):
    """A parameter as a field for its figure; named as the parameter, ``max_angle_deg_2``."""

    def __init__(self, parameter: Parameter, unit: str = "") -> None:
        super().__init__(parameter)
        self.field = named(cell_name(parameter), FigureField(parameter.kind.decimals, unit))
        self.field.setMinimumWidth(_NARROWEST_PX)
        in_column(self.field, self.note, on=self, spacing=_GAP_PX, margins=0)
        self.field.value_edited.connect(self.edited)

    @property
    def text(self) -> str:
        """The field's text."""
        return self.field.text()

    @property
    def value(self) -> float | None:
        """The figure in the field."""
        return self.field.value

    @property
    def focus_widget(self) -> QWidget:
        """The field."""
        return self.field

    def show_value(self, value: float | None) -> None:
        """Show the arm's value; an equal figure typed in another form stays."""
        shown = None if value is None else shown_as(self.parameter, value)
        if shown is None or self.field.value != shown:
            self.field.show_value(shown)

    def set_locked(self, *, locked: bool) -> None:
        """Make the field read-only or not; it can still be read and copied from."""
        self.field.setReadOnly(locked)

    def describe(self, name: str, tip: str) -> None:
        """Set the name, and the full state as tooltip."""
        describe(self.field, name, tip)
        self.note.setToolTip(tip)

    def show_status(self, status: CellStatus, text: str, *, beyond: bool = False) -> None:
        """Show the state; invalid or unusual values are marked in the field, too."""
        super().show_status(status, text, beyond=beyond)
        self.field.show_attention(wanted=status is CellStatus.WRONG or beyond)
