"""One figure of the gripper: what is wanted in a field and on a slider, what is measured beside."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QLabel, QWidget

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.control.devices.gripper_ranges import Figure, check
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.curve_menu import tell_quantities
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.jog_button import JogButton
from armui.ui.widgets.layouts import empty_grid
from armui.ui.widgets.track_slider import TrackSlider
from armui.ui.widgets.value_label import ValueLabel

_WIDEST: Final = "-000.000 rad/s"
_LABEL_PX: Final = 58


class GripperRow(QWidget):
    """A field, a slider, the measured value; with − and + where a step acts at once.

    Args:
        figure: What it is; its widgets are called ``gripper_<figure>_field``, ``…_slider``.
        steps: Whether it has − and +.

    Signals:
        edited: The operator changed the figure; nothing is sent.
        stepped: − or + was pressed, or is still held: −1 or +1.
    """

    edited = Signal()
    stepped = Signal(int)

    def __init__(self, figure: Figure, *, steps: bool) -> None:
        super().__init__()
        name = f"gripper_{figure.name}"
        self._figure = figure
        self._label = QLabel()
        self._label.setFixedWidth(_LABEL_PX)
        self.field = named(f"{name}_field", FigureField(fmt.DECIMALS, figure.unit))
        self.field.step = figure.step
        self.slider = named(
            f"{name}_slider", TrackSlider(figure.resolution, origin=0.0, marked=True)
        )
        self.measured = named(f"{name}_measured", ValueLabel(_WIDEST))
        tell_quantities(self, *(f"{source}.{name}" for source in ("arm", "own", "other")))
        self.minus, self.plus = JogButton("−"), JogButton("+")
        self._label.setBuddy(self.field)
        grid = empty_grid(self, gaps=(6, 4), margins=0)
        grid.addWidget(self._label, 0, 0)
        # without − and + the field takes their places
        grid.addWidget(self.field, 0, 2 if steps else 1, 1, 1 if steps else 3)
        grid.addWidget(self.measured, 0, 4, Qt.AlignmentFlag.AlignRight)
        grid.addWidget(self.slider, 1, 1, 1, 4)
        grid.setColumnStretch(2, 1)
        for button, word, sign, column in ((self.minus, "minus", -1, 1), (self.plus, "plus", 1, 3)):
            button.setObjectName(f"{name}_{word}")
            button.setVisible(steps)
            button.stepped.connect(lambda sign=sign: self.stepped.emit(sign))
            button.repeated.connect(lambda sign=sign: self.stepped.emit(sign))
            if steps:
                grid.addWidget(button, 0, column)
            else:
                button.setParent(self)
        self.slider.set_limits(0.0, figure.usual)
        self.field.value_edited.connect(self._on_field_edited)
        self.slider.valueChanged.connect(self._on_slider_moved)
        self.show_value(figure.first)
        self.retranslate_ui()

    @property
    def figure(self) -> Figure:
        """What it is."""
        return self._figure

    def refusal(self) -> Refusal | None:
        """What is to be said against what stands in the field; an empty one is no figure."""
        if self.field.value is None:
            return Refusal(
                RefusalCode.GRIPPER_NOT_A_NUMBER, {**self._params(), "value": self.field.text()}
            )
        return check(self._figure, self.field.value)

    def _params(self) -> dict[str, float | int | str]:
        figure = self._figure
        return {
            "gripper": figure.name,
            "minimum": figure.minimum,
            "maximum": figure.maximum,
            "unit": figure.unit,
        }

    def set_figure(self, figure: Figure) -> None:
        """Take another range of the same quantity."""
        if figure != self._figure:
            self._figure = figure
            self.slider.set_limits(0.0, figure.usual)
            self._after_change()
            self.retranslate_ui()

    def show_value(self, value: float | None) -> None:
        """Put a figure into field and slider without telling anyone."""
        self.field.show_value(value)
        self._after_change()

    def show_measured(self, value: float | None, *, stale: bool) -> None:
        """Show what the gripper says."""
        self.measured.show_text(fmt.with_unit(value, self._figure.unit), stale=stale)
        self.slider.show_measured(None if stale else value)

    def allow_steps(self, why_not: str) -> None:
        """Enable − and +, or disable them and say why."""
        for button, tip in (
            (self.minus, self.tr("Closes the gripper by {step} at once. Hold to go on.")),
            (self.plus, self.tr("Opens the gripper by {step} at once. Hold to go on.")),
        ):
            button.setEnabled(not why_not)
            step = f"{self._figure.step:g} {self._figure.unit}"
            button.setToolTip(why_not or tip.format(step=step))

    def _on_field_edited(self) -> None:
        self._after_change()
        self.edited.emit()

    def _on_slider_moved(self) -> None:
        self.field.show_value(self.slider.requested)
        self._after_change()
        self.edited.emit()

    def _after_change(self) -> None:
        wrong = self.refusal() is not None
        self.slider.show_requested(self.field.value, attention=wrong)
        self.field.show_attention(wanted=wrong)

    def retranslate_ui(self) -> None:
        """Put names and ranges into the operator's language."""
        figure = self._figure
        name = words.gripper_figure(figure.name)
        self._label.setText(name)
        span = f"{name}: {figure.minimum:g}–{figure.maximum:g} {figure.unit}"
        for widget in (self.field, self.slider):
            describe(widget, name, span)
        measured = self.tr("Measured: {figure}").format(figure=name)
        describe(self.measured, measured, self.tr("Measured by the gripper"))
        self.minus.setAccessibleName(self.tr("{figure} minus").format(figure=name))
        self.plus.setAccessibleName(self.tr("{figure} plus").format(figure=name))
