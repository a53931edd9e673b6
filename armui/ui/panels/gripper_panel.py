"""夹爪控制: the gripper's opening and torque, or its angle and speed, and its power (0x159)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QAbstractButton, QFrame, QLabel, QSizePolicy, QWidget

from armui.arm.figures import FIGURE_NOT_A_NUMBER
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, GripperState, Reading
from armui.control.arm_controller import ArmController
from armui.control.devices.gripper import GripperControl, why_not_move_gripper
from armui.control.devices.gripper_ranges import GripperFigure, check, gripper_figures
from armui.control.operating_state import BUSY, OperatingState
from armui.protocol.generation import Generation
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, ActFamily
from armui.ui.actions.command import Command, Target, also
from armui.ui.freshness import is_stale
from armui.ui.panels.motor_row import PowerMark
from armui.ui.panels.panel import Panel
from armui.ui.widgets.buttons import caption, choice_group, describe, enable_or_explain, named
from armui.ui.widgets.curve_menu import set_quantities
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.jog_button import JogButton
from armui.ui.widgets.layouts import STRETCH, empty_grid, in_column, in_row, scrolled
from armui.ui.widgets.state_mark import Mark
from armui.ui.widgets.text_label import ValueLabel, text_label
from armui.ui.widgets.track_slider import TrackSlider
from armui.ui.words.arm import GRIPPER_ACTS, GRIPPER_FAULTS
from armui.ui.words.text import Text, Texts

_Kind = tuple[Generation, bool]
"""The generation, and whether angles are commanded in the second one."""
_WIDEST: Final = "-000.000 rad/s"
_LABEL_PX: Final = 58
"""The width of the labels at the left of the rows."""
_POWER: Final[Mapping[str, Callable[..., object]]] = {
    "enable": GripperControl.enable,
    "disable": GripperControl.disable,
    "clear": GripperControl.clear_error,
    "zero": GripperControl.set_zero,
}
_ENDS: Final = Texts("GripperPanel") | {"close_fully": "Close fully", "open_fully": "Open fully"}
_TITLES: Final = Texts("GripperPanel") | {
    "close_fully": "Close the gripper",
    "open_fully": "Open the gripper",
}
_ENDS_ALSO: Final = {"close_fully": also("关闭夹爪 合上夹爪"), "open_fully": also("打开夹爪")}
_USES: Final = Texts("GripperPanel") | {
    "close_fully": "Closes the gripper to 0.",
    "open_fully": "Opens the gripper to its stroke limit.",
    "enable": "Gives the gripper power where it is.",
    "disable": "Takes its power: it drops what it holds. Asks first.",
    "clear": "Clears its error; it has no power until enabled again.",
    "zero": "Makes the present opening its zero. Asks first.",
}


class MeasureChoice(QWidget):
    """Two buttons to choose between an opening and an angle.

    Signals:
        chosen: True if angles shall be commanded.
    """

    chosen = Signal(bool)

    def __init__(self) -> None:
        super().__init__()
        self._label = QLabel()
        self._label.setMinimumWidth(_LABEL_PX)
        self._group = choice_group(self, ("gripper_by_opening", "gripper_by_angle"))
        self._opening, self._angle = self.buttons
        for button in self.buttons:
            button.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        in_row(self._label, *((each, 1) for each in self.buttons), on=self, spacing=6, margins=0)
        self._group.idClicked.connect(lambda place: self.chosen.emit(place == 1))

    @property
    def buttons(self) -> list[QAbstractButton]:
        """The buttons for an opening and an angle, in this order."""
        return self._group.buttons()

    def show_choice(self, *, by_angle: bool, why_not: str) -> None:
        """Show the present choice.

        Args:
            by_angle: True if angles are commanded.
            why_not: The reason against angles; empty if there is none.
        """
        (self._angle if by_angle else self._opening).setChecked(True)
        enable_or_explain(self._angle, why_not, self.tr("Tells the gripper an angle."))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._label.setText(self.tr("Set by"))
        caption(self._opening, self.tr("Opening (mm)"), whose=self._label.text())
        caption(self._angle, self.tr("Angle (°)"), whose=self._label.text())


class GripperRow(QWidget):
    """A field, a slider, the measured value, and optionally − and + that act at once.

    Attributes:
        own: True if the operator has set the figure and it was not sent yet.

    Args:
        figure: The quantity; its widgets are named ``gripper_<figure>_field``, ``…_slider``.
        steps: Whether it has − and +.

    Signals:
        edited: The operator changed the figure; nothing is sent.
        stepped: − or + was pressed, or is still held: −1 or +1.
    """

    edited = Signal()
    stepped = Signal(int)

    def __init__(self, figure: GripperFigure, *, steps: bool) -> None:
        super().__init__()
        name = f"gripper_{figure.name}"
        self._figure = figure
        self.own = self._own_before = False
        self._label = QLabel()
        self._label.setFixedWidth(_LABEL_PX)
        self.field = named(f"{name}_field", FigureField(fmt.DECIMALS, figure.unit))
        self.field.step = figure.step
        self.slider = named(
            f"{name}_slider", TrackSlider(figure.resolution, origin=0.0, marked=True)
        )
        self.measured = named(f"{name}_measured", ValueLabel(_WIDEST))
        set_quantities(self, *(f"{source}.{name}" for source in ("arm", "own", "other")))
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
        self.field.editingFinished.connect(self._on_field_left)
        self.field.restored.connect(self._on_field_restored)
        self.slider.valueChanged.connect(self._on_slider_moved)
        if not steps:
            self.field.show_value(figure.first)
        self._after_change()
        self.retranslate_ui()

    @property
    def figure(self) -> GripperFigure:
        """The quantity of the row."""
        return self._figure

    def refusal(self) -> Refusal | None:
        """Return the reason against the field's content, or ``None``; an empty field is invalid."""
        if self.field.value is None:
            return FIGURE_NOT_A_NUMBER(**self._params(), value=self.field.text())
        return check(self._figure, self.field.value)

    def _params(self) -> dict[str, float | int | str]:
        figure = self._figure
        return {
            "figure": figure.name,
            "minimum": figure.minimum,
            "maximum": figure.maximum,
            "unit": figure.unit,
        }

    def set_figure(self, figure: GripperFigure) -> None:
        """Set another range of the same quantity."""
        if figure != self._figure:
            self._figure = figure
            self.slider.set_limits(0.0, figure.usual)
            self._after_change()
            self.retranslate_ui()

    def follow(self, value: float | None) -> None:
        """Show the gripper's present place or last target, unless the operator has set a figure."""
        if not self.own and value != self.field.value:
            self.field.follow(value)
            self._own_before = False
            self._after_change()

    def take_back(self) -> None:
        """Let the figure follow the gripper again: it was sent, or the arm is another one."""
        self.own = self._own_before = False
        self._after_change()

    def show_measured(self, value: float | None, *, stale: bool) -> None:
        """Show the value reported by the gripper."""
        self.measured.show_text(fmt.with_unit(value, self._figure.unit), stale=stale)
        self.slider.show_measured(None if stale else value)

    def allow_steps(self, why_not: str) -> None:
        """Enable − and +, or disable them with the reason."""
        for button, tip in (
            (self.minus, self.tr("Closes the gripper by {step} at once. Hold to go on.")),
            (self.plus, self.tr("Opens the gripper by {step} at once. Hold to go on.")),
        ):
            step = f"{self._figure.step:g} {self._figure.unit}"
            enable_or_explain(button, why_not, tip.format(step=step))

    def _on_field_edited(self) -> None:
        self.own = True
        self._after_change()
        self.edited.emit()

    def _on_field_left(self) -> None:
        self.own = self._own_before = self.own and bool(self.field.text())

    def _on_field_restored(self) -> None:
        self.own = self._own_before
        self._after_change()
        self.edited.emit()

    def _on_slider_moved(self) -> None:
        self.field.show_value(self.slider.requested)
        self.own = self._own_before = True
        self._after_change()
        self.edited.emit()

    def _after_change(self) -> None:
        self.field.show_typed(wanted=self.own)
        wrong = self.own and self.refusal() is not None
        self.slider.show_requested(self.field.value, attention=wrong)
        self.field.show_attention(wanted=wrong)

    def retranslate_ui(self) -> None:
        """Set names and ranges in the operator's language."""
        figure = self._figure
        name = words.figure(figure.name)
        self._label.setText(name)
        span = f"{name}: {figure.minimum:g}–{figure.maximum:g} {figure.unit}"
        for widget in (self.field, self.slider):
            describe(widget, name, span)
        measured = self.tr("Measured: {figure}").format(figure=name)
        describe(self.measured, measured, self.tr("Measured by the gripper"))
        self.minus.setAccessibleName(self.tr("{figure} minus").format(figure=name))
        self.plus.setAccessibleName(self.tr("{figure} plus").format(figure=name))


class GripperPanel(Panel):
    """Target and measured values of the gripper, its power, and its errors in words."""

    commands = (
        Command("gripper.opening", Text("MeasureChoice", "Opening (mm)")),
        Command("gripper.angle", Text("MeasureChoice", "Angle (°)")),
    )

    send = Act(
        "Send",
        named="gripper_send_button",
        does=GripperControl.move,
        tip="Moves the gripper to the target, and gives it power.",
        whose=True,
        key="gripper.send",
        primary=True,
        least_height_px=38,
    )
    ends = ActFamily(
        {
            end: Act(
                _ENDS.entry(end),
                named=f"gripper_{end}_button",
                does=GripperControl.move,
                tip=_USES.entry(end),
                whose=True,
                key=f"gripper.{end}",
                title=_TITLES.entry(end),
                synonyms=_ENDS_ALSO[end],
            )
            for end in _ENDS
        }
    )
    power = ActFamily(
        {
            act: Act(
                GRIPPER_ACTS.entry(act),
                named=f"gripper_{act}_button",
                does=does,
                tip=_USES.entry(act),
                whose=True,
                key=f"gripper.{act}",
                title=GRIPPER_ACTS.entry(act),
                synonyms=also("calibrate 标定") if act == "zero" else (),
            )
            for act, does in _POWER.items()
        }
    )

    def __init__(self, controller: ArmController) -> None:
        super().__init__(controller, "gripper_message")
        self._generation = self._operating_state.generation or Generation.TWO
        self._shown_kind: _Kind | None = None
        self._mark = PowerMark()
        self._power = text_label("gripper_power")
        self._faults = text_label("gripper_faults", rank="fault", wraps=True)
        self._rows = in_column(spacing=10)
        self._calibrated = text_label("gripper_calibrated", wraps=True)
        self._calibrated.setVisible(False)
        self._stroke_note = text_label("gripper_stroke_note", rank="muted", wraps=True)
        self._measure = MeasureChoice()
        first, second = (self._make_rows(each) for each in Generation)
        self._rows_of: dict[_Kind, tuple[GripperRow, GripperRow]] = {
            (Generation.ONE, False): first,
            (Generation.TWO, False): second,
            (Generation.TWO, True): (first[0], second[1]),  # an angle, and a torque
        }
        self._lay_out()
        self._measure.chosen.connect(self._on_measure)
        self._listen("gripper_")
        self.retranslate_ui()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        opening, angle = self._measure.buttons
        mine = {"gripper.opening": opening, "gripper.angle": angle}
        return {**super().command_targets(), **mine}

    # -- layout -------------------------------------------------------------------------------

    def _make_rows(self, generation: Generation) -> tuple[GripperRow, GripperRow]:
        """Make the rows of a generation: each generation measures other quantities."""
        figures = gripper_figures(generation, self._controller.state)
        travel = GripperRow(figures.travel, steps=True)
        effort = GripperRow(figures.effort, steps=False)
        for row in (travel, effort):
            row.edited.connect(self._on_edited)
            row.hide()
            self._rows.addWidget(row)
        travel.stepped.connect(self._on_stepped)
        return travel, effort

    @property
    def _kind(self) -> _Kind:
        return self._generation, self._controller.gripper.reports_angle

    @property
    def _travel(self) -> GripperRow:
        return self._rows_of[self._kind][0]

    @property
    def _effort(self) -> GripperRow:
        return self._rows_of[self._kind][1]

    def _lay_out(self) -> None:
        state = in_row(self._mark, self._power, STRETCH)
        card = QFrame()
        # errors may appear at any time: at the bottom they do not move any button
        notes = (self._calibrated, self._stroke_note, self._faults, STRETCH)
        parts = (state, self._measure, self._rows, *notes)
        in_column(*parts, on=card, spacing=10, margins=(16, 12, 16, 12))
        acts = empty_grid(gaps=(8, 8))
        for place, button in enumerate(self.power.values()):
            acts.addWidget(button, 0, place)
        ends = in_row(*((button, 1) for button in self.ends.values()), spacing=8)
        self._stack(scrolled(card), ends, self.send, acts)

    # -- actions ------------------------------------------------------------------------------

    def _on_measure(self, by_angle: bool) -> None:
        """Enter the next target as an angle or as an opening; this choice sends nothing."""
        self._controller.gripper.by_angle = by_angle
        self._refusal = self._event = None
        self._describe()
        self._show_all()

    def _on_edited(self) -> None:
        self._refusal = self._event = None
        self.show_acts()
        self._show_message()

    @send.pressed
    def _on_send(self) -> None:
        travel, effort = self._travel.field.value, self._effort.field.value
        if travel is None or effort is None:
            self._accepted(self._travel.refusal() or self._effort.refusal())
            return
        if self._accepted(self._controller.gripper.move(travel, effort)):
            self._note_sent()

    def _note_sent(self) -> None:
        for row in (self._travel, self._effort):
            row.take_back()
        self._show_state(self._controller.state)
        self._show_message()

    @send.lit
    def _is_new(self) -> bool:
        """Return true while a figure was set that is not sent yet, and is within the ranges."""
        travel = self._travel
        here = self._controller.gripper.heading(travel.figure.unit)
        new = self._effort.own or (travel.own and travel.field.value != here)
        return new and self._first_wrong() is None

    def _first_wrong(self) -> Refusal | None:
        """Return the reason against the figures; a travel that follows the arm is not checked."""
        return (self._travel.refusal() if self._travel.own else None) or self._effort.refusal()

    def _on_stepped(self, sign: int) -> None:
        """Move by a step, from the target or else the present place, but not beyond the range."""
        figure = self._travel.figure
        start = self._travel.field.value
        if start is None or self._travel.refusal() is not None:
            start = self._controller.gripper.heading(figure.unit)
        effort = self._effort.field.value
        if start is None or effort is None:
            self._accepted(self._effort.refusal() or self._travel.refusal())
            return
        target = min(max(start + sign * figure.step, figure.minimum), figure.maximum)
        if self._accepted(self._controller.gripper.move(round(target, 3), effort)):
            self._note_sent()

    @ends.why_not
    def _why_no_end(self, end: str) -> Refusal | None:
        return self._controller.gripper.why_no_end(opened=end == "open_fully")

    @ends.pressed
    def _on_end(self, end: str) -> None:
        opened = end == "open_fully"
        effort = self._effort.field.value
        if effort is None:
            self._accepted(self._effort.refusal())
        elif self._accepted(self._controller.gripper.move_to_end(opened=opened, effort=effort)):
            self._note_sent()

    @power.pressed
    def _on_power(self, act: str) -> None:
        if act == "enable":
            self._enable()
        elif act == "disable":
            self._ask_to_disable()
        elif act == "clear":
            self._accepted(self._controller.gripper.clear_error())
        else:
            self._ask_for_zero()

    def _enable(self) -> None:
        effort = self._effort.field.value
        if effort is None:
            self._accepted(self._effort.refusal())
            return
        self._accepted(self._controller.gripper.enable(effort))

    def _ask_to_disable(self) -> None:
        self._ask_to_hold(
            self.tr("Disable the gripper"),
            self.tr("The gripper loses its power and drops what it holds. Hold the workpiece."),
            GRIPPER_ACTS.text("disable"),
            self._controller.gripper.disable,
        )

    def _ask_for_zero(self) -> None:
        self._ask_to_hold(
            self.tr("Set the zero of the gripper"),
            self.tr(
                "Where the gripper stands now becomes its 0 mm, and it loses its power: it drops "
                "what it holds.\nClose it by hand before. With a wrong zero it presses against its "
                "stop, or does not close."
            ),
            GRIPPER_ACTS.text("zero"),
            self._controller.gripper.set_zero,
            still=partial(self._controller.gripper.stands_as, self._controller.state),
        )

    # -- what the gripper says ----------------------------------------------------------------

    def _forget_outdated(self, old: OperatingState) -> None:
        if old.cannot_enable != self._operating_state.cannot_enable:
            self._refusal = None
        if old.device != self._operating_state.device:
            self._event = None
            for rows in self._rows_of.values():
                rows[0].take_back()

    def _show_state(self, state: ArmState) -> None:
        heard = state.gripper
        stale = is_stale(heard, state, self._operating_state)
        gripper = None if heard is None else heard.value
        # a gripper that is commanded by angle reports angles instead of openings
        same = gripper is not None and gripper.unit == self._travel.figure.unit
        shown = self._controller.gripper.shown(gripper) if gripper and same else None
        self._travel.show_measured(shown, stale=stale)
        self._travel.follow(self._controller.gripper.heading(self._travel.figure.unit))
        self._calibrated.setVisible(self._controller.gripper.is_calibrated)
        effort = None
        if gripper is not None:
            first = self._generation is Generation.ONE
            effort = gripper.speed_rad_s if first else gripper.torque_nm
        self._effort.show_measured(effort, stale=stale)
        self._show_power(heard, stale=stale)
        figures = self._controller.gripper.figures
        self._travel.set_figure(figures.travel)
        self._stroke_note.setVisible(not figures.stroke_read)
        self._show_possible()

    def _show_power(self, heard: Reading[GripperState] | None, *, stale: bool) -> None:
        if heard is None or stale:
            mark, word = Mark.UNKNOWN, self.tr("No gripper heard")
        elif heard.value.faults:
            mark, word = Mark.FAULT, self.tr("Fault")
        elif heard.value.enabled:
            mark, word = Mark.GOOD, self.tr("Enabled")
        else:
            mark, word = Mark.OFF, self.tr("Disabled")
        self._mark.show_mark(mark, muted=stale)
        self._power.setText(word)
        faults = sorted(heard.value.faults, key=lambda f: f.name) if heard and not stale else []
        self._faults.setText("; ".join(map(GRIPPER_FAULTS.text, faults)))
        self._faults.setVisible(bool(faults))

    # -- appearance ---------------------------------------------------------------------------

    def _show_all(self) -> None:
        generation = self._operating_state.generation or self._generation
        if generation is not self._generation:
            self._generation = generation
            self._describe()
        kind = self._kind
        if kind != self._shown_kind:
            self._shown_kind = kind
            self._describe()
        for rows in self._rows_of.values():
            for row in rows:
                row.setVisible(row in self._rows_of[kind])
        self._measure.setVisible(self._generation is not Generation.ONE)
        if self.isVisible():
            self._controller.gripper.learn_stroke()
        self.power["zero"].setVisible(self._generation is not Generation.ONE)
        self._show_state(self._controller.state)
        self._show_message()

    def _show_possible(self) -> None:
        gripper = self._controller.gripper
        why_no_angle = words.why_not(gripper.why_no_angle())
        self._measure.show_choice(by_angle=gripper.reports_angle, why_not=why_no_angle)
        no_move = why_not_move_gripper(self._controller.operating_state)
        self._travel.allow_steps(words.why_not(no_move))
        self.show_acts()

    def _show_message(self) -> None:
        refusal = self._refusal or self._unless_told(self._operating_state.cannot_enable)
        if refusal is None and self._event is None:
            refusal = self._first_wrong()
        if refusal is not None and refusal.reason == BUSY and self._refusal is None:
            refusal = None  # no message is needed: the end of the request is reported
        self._show_outcome(refusal, self._event)

    def _describe(self) -> None:
        for rows in self._rows_of.values():
            for row in rows:
                row.retranslate_ui()
        self._calibrated.setText(
            self.tr("Calibrated: openings are as measured with callipers, by the cell's table.")
        )
        self._stroke_note.setText(
            self.tr("How far this gripper turns is not published: watch where it ends.")
            if self._generation is Generation.ONE or self._kind[1]
            else self.tr("The stroke limit has not been read: up to 100 mm can be set.")
        )

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._title.setText(self.tr("Gripper control"))
        self._measure.retranslate_ui()
        self._describe()
        self._show_all()
