"""One joint, or one axis of the tool, in the room of three buttons: −, what is measured, +."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QSizePolicy

from armui.ui import format as fmt
from armui.ui.panels.jogging.jog_signals import JogSignals
from armui.ui.theme import scaled_font
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.jog_button import JogButton
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.value_label import ValueLabel

_WIDEST: Final = "-0000.000 mm"
_NAME_PX: Final = 24


class JogCell(JogSignals):
    """Can stand for a joint now and for an axis then; its signals carry its place.

    Args:
        place: 0–5.
    """

    def __init__(self, place: int) -> None:
        super().__init__()
        self._unit = "°"
        self._name = QLabel()
        self._name.setFont(scaled_font(self._name, 1.0, bold=True))
        self._name.setFixedWidth(_NAME_PX)
        self.minus = named(f"box_minus_{place + 1}", JogButton("−"))
        self.plus = named(f"box_plus_{place + 1}", JogButton("+"))
        self.measured = named(
            f"box_measured_{place + 1}",
            ValueLabel(_WIDEST, alignment=Qt.AlignmentFlag.AlignHCenter),
        )
        in_row(
            *(self._name, self.minus, (self.measured, 1), self.plus), on=self, spacing=4, margins=0
        )
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._tell_presses(place, self.minus, self.plus)
        self.stand_for("", "°")

    def stand_for(self, name: str, unit: str) -> None:
        """Be the cell of a joint or an axis.

        Args:
            name: ``J1`` or ``RX``.
            unit: ``°`` or ``mm``.
        """
        self._name.setText(name)
        self._unit = unit
        self.measured.show_text(fmt.NOTHING)
        self.retranslate_ui()

    def show_measured(self, value: float | None, *, stale: bool) -> None:
        """Show what is measured."""
        self.measured.show_text(fmt.with_unit(value, self._unit), stale=stale)

    def set_continuous(self, wanted: bool) -> None:
        """Whether − and + go on while they are held, or go by a step."""
        for button in (self.minus, self.plus):
            button.continuous = wanted

    def allow_jog(self, why_not: str) -> None:
        """Enable − and +, or disable them and say why."""
        for button in (self.minus, self.plus):
            button.setEnabled(not why_not)
            button.setToolTip(why_not)

    def retranslate_ui(self) -> None:
        """Put the names into the operator's language."""
        name = self._name.text()
        self.minus.setAccessibleName(self.tr("{name} minus").format(name=name))
        self.plus.setAccessibleName(self.tr("{name} plus").format(name=name))
        describe(self.measured, self.tr("Measured {name}").format(name=name))
