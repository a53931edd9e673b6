"""灯光控制: the colour of the lamps on the joints (manual section 1.0.7.2)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Final

from PySide6.QtCore import QRectF, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QPaintEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QColorDialog,
    QFrame,
    QLabel,
    QSizePolicy,
    QWidget,
)

from armui.arm.limits import JOINTS
from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.devices.lights import Lights, why_no_lamps
from armui.control.operating_state import OperatingState
from armui.protocol.codes import ALL_LAMPS
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act
from armui.ui.actions.command import Command, Target
from armui.ui.actions.figure import CommandField, Figure
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.panels.panel import Panel
from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets import painting
from armui.ui.widgets.buttons import choice_group, describe, named
from armui.ui.widgets.layouts import STRETCH, empty_grid, fill, in_row, scrolled
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.track_slider import TrackSlider
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

FULL: Final = 255
"""The highest value of a colour channel."""

_PAGE: Final = 16
_HEIGHT_PX: Final = 44
_BRIGHT: Final = 0.45
"""From this luminance on black text is more readable than white."""
_FIELD_PX: Final = 74
_PICKER: Final = (
    QColorDialog.ColorDialogOption.DontUseNativeDialog,
    QColorDialog.ColorDialogOption.NoButtons,
    QColorDialog.ColorDialogOption.NoEyeDropperButton,
)
_LAMPS: Final = Text("Action", "Lamps of")


class ColorStrip(QWidget):
    """Shows one colour with its hexadecimal value; hatched without a colour."""

    def __init__(self) -> None:
        super().__init__()
        self._color: QColor | None = None
        self.setFont(scaled_font(self, 1.1, bold=True))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def text(self) -> str:
        """Return the value it shows: ``#RRGGBB``, or «—»."""
        return fmt.NOTHING if self._color is None else self._color.name().upper()

    def show_color(self, color: QColor | None) -> None:
        """Show a colour, or none with ``None``."""
        self._color = color
        self.update()

    def sizeHint(self) -> QSize:
        """Return the preferred size."""
        return QSize(200, _HEIGHT_PX)

    def minimumSizeHint(self) -> QSize:
        """Return the smallest size."""
        return QSize(100, _HEIGHT_PX)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the strip."""
        colors = colors_of(self)
        painter = painting.begin(self)
        fill = colors.sunken if self._color is None else self._color.name()
        painting.panel(painter, QRectF(self.rect()), fill, colors.faint)
        if self._color is None:
            hatching = QBrush(QColor(colors.border), Qt.BrushStyle.BDiagPattern)
            painter.fillRect(self.rect().adjusted(4, 4, -4, -4), hatching)
            ink = colors.text
        else:
            ink = "#000000" if _luminance(self._color) > _BRIGHT else "#ffffff"
        painter.setPen(QColor(ink))
        painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, self.text())
        painter.end()


def _luminance(color: QColor) -> float:
    """Return how bright a colour looks, 0–1 (the weights of Rec. 709, without its gamma)."""
    return 0.2126 * color.redF() + 0.7152 * color.greenF() + 0.0722 * color.blueF()


class ChannelRow(Translated, QWidget):
    """A channel value of 0–255; the field accepts other figures, too, and is marked then.

    Args:
        field: The field of the channel.

    Signals:
        edited: The operator changed the value.
    """

    edited = Signal()

    def __init__(self, field: CommandField) -> None:
        super().__init__()
        self.field = field
        self.field.setFixedWidth(_FIELD_PX)
        self.slider = named(f"{field.figure.name}_slider", TrackSlider(1.0, origin=0.0))
        self.slider.setRange(0, FULL)
        self.slider.setPageStep(_PAGE)
        in_row((self.slider, 1), self.field, on=self, spacing=10, margins=0)
        self.slider.valueChanged.connect(self._on_slider_moved)
        self.field.value_edited.connect(self._on_field_edited)
        self.retranslate_ui()

    @property
    def value(self) -> int | None:
        """The channel value, or ``None`` if the field holds none."""
        value = self.field.value
        return None if value is None or self.field.why_wrong() is not None else int(value)

    def show_value(self, value: int) -> None:
        """Set the value without emitting a signal."""
        self.field.show_value(value)
        self._after_change()

    def _on_slider_moved(self) -> None:
        self.field.show_value(self.slider.requested)
        self._after_change()
        self.edited.emit()

    def _on_field_edited(self) -> None:
        self._after_change()
        self.edited.emit()

    def _after_change(self) -> None:
        """Set the slider by the field, as far as its track reaches."""
        wrong = self.value is None
        self.slider.show_requested(self.field.value, attention=wrong)
        self.field.show_attention(wanted=wrong)

    def retranslate_ui(self) -> None:
        """Set the channel's name in the operator's language."""
        describe(self.slider, self.field.name, self.field.span)


class ColorDialog(ArmDialog):
    """Qt's own colour picker beside the stop; a picked colour takes effect at once.

    The eye-dropper is removed: it would grab the mouse, so that the stop could not be pressed.

    Signals:
        picked: The operator has picked a colour.
    """

    picked = Signal(QColor)

    def __init__(self, controller: ArmController, parent: QWidget | None = None) -> None:
        super().__init__(controller, parent)
        self.setObjectName("color_dialog")
        self._picker = QColorDialog()
        self._picker.setWindowFlags(Qt.WindowType.Widget)
        for option in _PICKER:
            self._picker.setOption(option)
        self._picker.currentColorChanged.connect(self.picked)
        self._picker.finished.connect(self.close)  # Escape in the picker closes the dialog, too
        self.body.addWidget(self._picker)
        fill(self.footer, STRETCH, CloseButton(self))
        self.retranslate_ui()

    def show_color(self, color: QColor) -> None:
        """Show a colour without emitting a signal."""
        with QSignalBlocker(self._picker):
            self._picker.setCurrentColor(color)

    def open(self) -> None:
        """Show the dialog, with the picker, which Escape may have hidden."""
        self._picker.show()
        super().open()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Colour of the lamps"))


class LightPanel(Panel):
    """The colour to be sent to the lamps; their actual colour is not known.

    Fields, sliders and a picker are three ways to the same colour. The choices are kept while
    another panel is used.
    """

    commands = (
        Command("light.all", Text("LightPanel", "All lamps of the joint")),
        *(Command(f"light.joint_{j}", replace(_LAMPS, suffix=f"J{j}")) for j in JOINTS),
    )

    pick = Act(
        "Pick a colour…",
        named="pick_color_button",
        tip="Opens a window to pick a colour in; nothing is sent.",
        key="light.pick",
        title=Text("LightPanel", "Colour of the lamps"),
    )
    confirm = Act(
        "Send colour",
        named="light_confirm_button",
        does=Lights.set_light,
        tip="Sends the colour to the lamps; nothing moves.",
        key="light.confirm",
        primary=True,
        least_height_px=38,
    )

    lamp = Figure(Lights.set_light, "lamp", named="lamp_field")
    red = Figure(Lights.set_light, "red", named="red_field")
    green = Figure(Lights.set_light, "green", named="green_field")
    blue = Figure(Lights.set_light, "blue", named="blue_field")

    def __init__(self, controller: ArmController) -> None:
        super().__init__(controller, "light_message")
        self._joint_label = QLabel()
        self._joints = choice_group(self, (f"light_joint_{j}" for j in JOINTS), JOINTS[0])
        self.lamp.setFixedWidth(_FIELD_PX)
        self.lamp.show_value(0)
        self._all_lamps = named("all_lamps", QCheckBox())
        self._all_lamps.setChecked(True)
        self._rows = [ChannelRow(field) for field in (self.red, self.green, self.blue)]
        self._picker: ColorDialog | None = None
        self._effect_label = QLabel()
        self._effect = named("effect_strip", ColorStrip())
        self._sent: tuple[object, ...] | None = None
        self._note = text_label("light_note", rank="muted", wraps=True)
        self._lay_out()
        self._connect()
        self._show_color(QColor(FULL, FULL, FULL))
        self.retranslate_ui()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            **super().command_targets(),
            "light.all": self._all_lamps,
            **{f"light.joint_{joint}": self._joints.button(joint) for joint in JOINTS},
        }

    # -- layout -------------------------------------------------------------------------------

    def _lay_out(self) -> None:
        card = QFrame()
        grid = empty_grid(card, gaps=(10, 8), margins=(16, 12, 16, 12))
        grid.addWidget(self._joint_label, 0, 0)
        grid.addLayout(in_row(*self._joints.buttons(), spacing=6), 0, 1)
        lamp = in_row(self._all_lamps, STRETCH, self.lamp)
        grid.addWidget(self.lamp.label, 1, 0)
        grid.addLayout(lamp, 1, 1)
        for place, row in enumerate(self._rows, start=2):
            grid.addWidget(row.field.label, place, 0)
            grid.addWidget(row, place, 1)
        grid.addWidget(self.pick, 5, 1)
        grid.setRowStretch(6, 1)
        grid.setColumnStretch(1, 1)

        effect = in_row(self._effect_label, (self._effect, 1), spacing=12)
        self._stack(scrolled(card), effect, self.confirm, self._note)

    def _connect(self) -> None:
        self._joints.idClicked.connect(self._on_edited)
        self._all_lamps.toggled.connect(self._on_edited)
        self.lamp.value_edited.connect(self._on_edited)
        for row in self._rows:
            row.edited.connect(self._on_channel_edited)
        self._controller.operating_state_changed.connect(self._on_operating_state_changed)

    # -- the colour ---------------------------------------------------------------------------

    def color(self) -> QColor | None:
        """Return the colour in the fields, or ``None`` if one of them is invalid."""
        red, green, blue = (row.value for row in self._rows)
        if red is None or green is None or blue is None:
            return None
        return QColor(red, green, blue)

    def _on_channel_edited(self) -> None:
        color = self.color()
        self._effect.show_color(color)
        if color is not None and self._picker is not None:
            self._picker.show_color(color)
        self._on_edited()

    @pick.pressed
    def _on_pick(self) -> None:
        if self._picker is None:
            self._picker = ColorDialog(self._controller, self.window())
            self._picker.picked.connect(self._on_picked)
        color = self.color()
        if color is not None:
            self._picker.show_color(color)
        self._picker.open()

    def _on_picked(self, color: QColor) -> None:
        self._show_color(color)
        self._on_edited()

    def _show_color(self, color: QColor) -> None:
        channels = color.red(), color.green(), color.blue()
        for row, value in zip(self._rows, channels, strict=True):
            row.show_value(value)
        self._effect.show_color(color)

    # -- actions ------------------------------------------------------------------------------

    def focus_joint(self, joint: int) -> None:
        """Choose the joint whose lamp is set, and focus its button."""
        button = self._joints.button(joint)
        button.setChecked(True)
        button.setFocus(Qt.FocusReason.OtherFocusReason)
        self._on_edited()

    def _figures(self) -> list[CommandField]:
        """Return the fields whose figures would be sent."""
        lamp = () if self._all_lamps.isChecked() else (self.lamp,)
        return [*lamp, *(row.field for row in self._rows)]

    @confirm.pressed
    def _on_confirm(self) -> None:
        fields = self._figures()
        values = {
            field.figure.name: int(field.value) for field in fields if field.value is not None
        }
        if len(values) < len(fields):
            self._accepted(self._first_wrong())
        else:
            values.setdefault("lamp", ALL_LAMPS)
            joint = self._joints.checkedId()
            if self._accepted(self._controller.lights.set_light(joint, **values)):
                self._sent = self._entered()
                self.show_acts()

    def _entered(self) -> tuple[object, ...]:
        """Return everything that would be sent, as entered."""
        texts = ((field.figure.name, field.text()) for field in self._figures())
        return self._joints.checkedId(), *texts

    def _first_wrong(self) -> Refusal | None:
        wrong = (field.why_wrong() for field in self._figures())
        return next((refusal for refusal in wrong if refusal is not None), None)

    def _on_edited(self) -> None:
        self._refusal = None
        self._show_all()

    # -- appearance ---------------------------------------------------------------------------

    def _on_operating_state_changed(self, operating_state: OperatingState) -> None:
        old, self._operating_state = self._operating_state, operating_state
        if why_no_lamps(old) != why_no_lamps(operating_state):
            self._refusal = None
            self.show_acts()
            self._show_message()

    def _show_all(self) -> None:
        self._show_lamp()
        self.show_acts()
        self._show_message()

    def _show_lamp(self) -> None:
        every = self._all_lamps.isChecked()
        self.lamp.setEnabled(not every)
        self.lamp.show_attention(wanted=not every and self.lamp.why_wrong() is not None)
        self.lamp.setToolTip(
            self.tr("Every lamp is chosen. Take the tick away to choose one.")
            if every
            else self.lamp.span
        )

    @confirm.lit
    def _is_new(self) -> bool:
        """Return true while the entries are not sent yet, and are within the ranges."""
        return self._entered() != self._sent and self._first_wrong() is None

    def _show_message(self) -> None:
        standing = self._unless_told(why_no_lamps(self._operating_state))
        self._show_outcome(self._refusal or standing or self._first_wrong())

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._title.setText(self.tr("Light control"))
        self._joint_label.setText(words.figure("joint"))
        for joint in JOINTS:
            name = self.tr("Lamps of joint {joint}").format(joint=joint)
            self._joints.button(joint).setText(str(joint))
            describe(self._joints.button(joint), name)
        self._all_lamps.setText(self.tr("All"))
        self._all_lamps.setAccessibleName(self.tr("All lamps of the joint"))
        self._effect_label.setText(self.tr("Effect"))
        describe(self._effect, self.tr("Effect"), self.tr("The colour that Send colour sends"))
        self._note.setText(
            self.tr(
                "Works on joints that have a lamp board.\n"
                "Lamps give no feedback: this is only what will be sent."
            )
        )
        self._show_all()
