"""One figure of a pose: target, jog buttons, measured value."""

from __future__ import annotations

from functools import partial
from typing import Final

from PySide6.QtWidgets import QLabel

from armui.ui import format as fmt
from armui.ui.panels.jogging.jog_signals import JogSignals
from armui.ui.theme import scaled_font
from armui.ui.widgets import painting
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.curve_menu import tell_quantities
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.jog_button import JogButton
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.value_label import ValueLabel

_WIDEST: Final = "-0000.000 mm"
_NAME_PX: Final = 34
_SAME: Final = 0.0006
"""Two figures that are written alike are the same."""


class PoseRow(JogSignals):
    """The controls of one axis; its signals carry the axis' place.

    Args:
        place: 0–5 for X, Y, Z, RX, RY, RZ.
        name: One of them.
        unit: ``mm`` or ``°``.

    Attributes:
        own: Whether the target was given by the operator; else it follows the arm.
    """

    def __init__(self, place: int, name: str, unit: str) -> None:
        super().__init__()
        painting.fill_ground(self)
        self.name = name
        self.own = False
        self._unit = unit
        self._label = QLabel(name)
        self._label.setFont(scaled_font(self._label, 1.15, bold=True))
        self._label.setFixedWidth(_NAME_PX)
        self.minus = named(f"pose_minus_{name}", JogButton("−"))
        self.plus = named(f"pose_plus_{name}", JogButton("+"))
        self.field = named(f"pose_field_{name}", FigureField(fmt.DECIMALS, unit))
        self.field.setTextMargins(0, 0, 28 if unit == "mm" else 5, 0)
        self.measured = named(f"pose_measured_{name}", ValueLabel(_WIDEST))
        kind = f"pose_{name.lower()}"
        tell_quantities(self, *(f"{source}.{kind}" for source in ("arm", "own", "other")))
        parts = (self._label, self.minus, (self.field, 1), self.plus, self.measured)
        in_row(*parts, on=self, spacing=8, margins=0)
        self._tell_presses(place, self.minus, self.plus)
        self.field.value_edited.connect(partial(self._on_edited, place))
        self.retranslate_ui()

    def _on_edited(self, place: int) -> None:
        self.own = bool(self.field.text())
        self.field.show_attention(wanted=self.field.is_nonsense())
        self.edited.emit(place)

    def show_target(self, value: float | None) -> None:
        """Give a target; ``None`` empties the field."""
        self.own = value is not None
        self.field.show_value(value)
        self.field.show_attention(wanted=False)

    def follow(self, value: float) -> None:
        """Have a target that nobody gave be where the arm is."""
        if not self.own:
            self.field.follow(value)

    def differs_from(self, value: float) -> bool:
        """Whether the operator has given a target, and it is another figure than this."""
        target = self.field.value
        return self.own and (target is None or abs(target - value) > _SAME)

    def show_measured(self, value: float | None, *, stale: bool) -> None:
        """Show the measured value."""
        self.measured.show_text(fmt.with_unit(value, self._unit), stale=stale)

    def set_step(self, step: float, *, continuous: bool) -> None:
        """How far one press of − or + goes, or whether it goes on while they are held."""
        self.field.step = step
        for button in (self.minus, self.plus):
            button.continuous = continuous
        self.retranslate_ui()

    def allow_jog(self, why_not: str) -> None:
        """Enable − and +, or disable them and say why."""
        for button, sign in ((self.minus, "−"), (self.plus, "+")):
            button.setEnabled(not why_not)
            if button.continuous:
                tip = self.tr("Moves along {axis} while it is held; let go to stop.")
            else:
                tip = self.tr("Moves along {axis} by {step} at once.")
            step = f"{sign}{self.field.step:g} {self._unit}"
            button.setToolTip(why_not or tip.format(axis=self.name, step=step))

    def retranslate_ui(self) -> None:
        """Put names and tooltips into the operator's language."""
        self.minus.setAccessibleName(self.tr("{axis} minus").format(axis=self.name))
        self.plus.setAccessibleName(self.tr("{axis} plus").format(axis=self.name))
        target = self.tr("Target {axis}").format(axis=self.name)
        describe(self.field, target, self.tr("Not sent before you press MOVE P or MOVE L."))
        self.measured.setToolTip(self.tr("Measured by the arm"))
