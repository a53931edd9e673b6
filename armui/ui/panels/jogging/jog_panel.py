"""The common part of 运动控制 and 末端控制: targets, measured values, a step, two ways to jog."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from itertools import pairwise
from typing import Final

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QFocusEvent, QHideEvent, QKeyEvent
from PySide6.QtWidgets import QComboBox, QFrame, QLabel, QLayout, QPushButton, QWidget

from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.arm_controller import ArmController
from armui.control.context import REFUSED
from armui.control.devices.zeroing import ZEROING_ENDED
from armui.control.events import Event
from armui.control.motion.jog_path import TOOL_DEG_S, TOOL_MM_S
from armui.control.motion.jogging import JOG_ENDED
from armui.control.operating_state import OperatingState
from armui.control.operations.started import Ending, Started
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.dialogs.confirm_dialog import drive
from armui.ui.panels.panel import Panel
from armui.ui.widgets import painting
from armui.ui.widgets.buttons import choice_button, describe, enable_or_explain, named
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.hold_guard import HOLD_UNATTENDED, UNATTENDED_S, HoldGuard
from armui.ui.widgets.jog_button import JogButton
from armui.ui.widgets.layouts import STRETCH, empty_grid, in_column, in_row, scrolled
from armui.ui.widgets.text_label import ValueLabel, text_label
from armui.ui.widgets.translated import Translated

_BUTTON_PX: Final = 38
_SEND_PX: Final = 110
"""The width of the buttons that send targets."""
_FOLLOW_S: Final = 0.1
"""The least time between two updates of fields that follow a moving arm."""
DEAD_MAN_KEY: Final = Qt.Key.Key_Space
"""A key under the thumb of either hand, no letter, and none of the keys that stop the arm."""

Keys = Sequence[tuple[str, str, str]]
"""For each index: its name, the key for +, and the key for −, as printed on the keyboard."""

_KEYS: Final = {
    "↑": Qt.Key.Key_Up,
    "↓": Qt.Key.Key_Down,
    "←": Qt.Key.Key_Left,
    "→": Qt.Key.Key_Right,
    "PgUp": Qt.Key.Key_PageUp,
    "PgDn": Qt.Key.Key_PageDown,
}
_COLUMNS: Final = 3
STEPS: Final = (0.1, 1.0, 5.0, 10.0)
_CONTINUOUS: Final = 0.0
_SAME: Final = 0.0005
"""Half of the last decimal: a smaller difference is invisible in a field."""
_WRITTEN_ALIKE: Final = 0.0006
"""Figures that are displayed alike differ by less than this, whichever way they were rounded."""


class JogRow(Translated, QWidget):
    """− and + of one joint or axis, which emit its number.

    Args:
        kind: The first part of the buttons' names: ``<kind>_minus_<name>``.
        name: The joint or axis in these names.
        number: The number in the signals.
    """

    stepped = Signal(int, int)
    """Emitted to jog by one step: the number, −1 or +1."""
    repeated = Signal(int, int)
    """Emitted as :attr:`stepped`, by a button that is still held."""
    held = Signal(int, int)
    """Emitted to jog until :attr:`hold_ended`: the number, −1 or +1."""
    hold_ended = Signal()
    unattended = Signal()
    """Emitted when a held button was released automatically, because the operator gave no sign for
    too long.
    """

    def __init__(self, kind: str, name: object, number: int) -> None:
        super().__init__()
        self.minus = named(f"{kind}_minus_{name}", JogButton("−"))
        self.plus = named(f"{kind}_plus_{name}", JogButton("+"))
        for button, direction in ((self.minus, -1), (self.plus, 1)):
            button.stepped.connect(partial(self.stepped.emit, number, direction))
            button.repeated.connect(partial(self.repeated.emit, number, direction))
            button.held.connect(partial(self.held.emit, number, direction))
            button.hold_ended.connect(self.hold_ended)
            button.unattended.connect(self.unattended)

    def set_continuous(self, wanted: bool) -> None:
        """Set whether − and + move while they are held, or by a step."""
        for button in (self.minus, self.plus):
            button.continuous = wanted

    def allow_jog(self, why_not: str) -> None:
        """Enable − and +, or disable them with the reason."""
        for button, tip in zip((self.minus, self.plus), self._tips(), strict=True):
            enable_or_explain(button, why_not, tip)

    def _tips(self) -> tuple[str, str]:
        """Return the tooltips of − and +."""
        return "", ""


class TargetRow(JogRow):
    """A joint or axis with a field for its target, beside the measured value.

    The target follows the arm until the operator enters another one, so that sending the fields
    never moves anything back to a former position.

    Args:
        kind, name, number: As those of a `JogRow`.
        field: The field of the target.
        measured: Shows the measured value.
    """

    edited = Signal()
    """Emitted when the operator has changed the target; nothing is sent."""

    def __init__(
        self, kind: str, name: object, number: int, field: FigureField, measured: ValueLabel
    ) -> None:
        super().__init__(kind, name, number)
        painting.fill_ground(self)
        self.field = field
        self.own = False
        self._own_before = False
        self.measured = measured
        self.field.value_edited.connect(self._on_field_edited)
        self.field.editingFinished.connect(self._on_field_left)
        self.field.restored.connect(self._on_field_restored)

    @property
    def own(self) -> bool:
        """True if the operator has set the target, so that it no longer follows the arm."""
        return self._own

    @own.setter
    def own(self, own: bool) -> None:
        self._own = own
        self.field.show_typed(wanted=own)

    def show_target(self, value: float | None) -> None:
        """Set a target; ``None`` empties the field."""
        self.own = self._own_before = value is not None
        self.field.show_value(value)
        self._after_target()

    def take_target(self, value: float) -> None:
        """Set a target; if it equals the present one, the field still follows the arm."""
        before = self.field.value
        if before is None or abs(value - before) > _SAME:
            self.show_target(value)

    def follow(self, value: float) -> None:
        """Set a target that is not the operator's own to the arm's position or last target."""
        if self.own:
            return
        self._own_before = False
        if self.field.follow(value):
            self._after_target()

    def differs_from(self, value: float) -> bool:
        """Return whether the operator has set a target that differs from this one."""
        target = self.field.value
        return self.own and (target is None or abs(target - value) > _WRITTEN_ALIKE)

    def set_step(self, step: float, *, continuous: bool) -> None:
        """Set the step of − and +, or that they move while they are held."""
        self.field.step = step
        self.set_continuous(continuous)

    def _on_field_edited(self) -> None:
        self.own = bool(self.field.text())
        self._after_target()
        self.edited.emit()

    def _on_field_left(self) -> None:
        self._own_before = self.own

    def _on_field_restored(self) -> None:
        """After Escape: follow the arm again if the field did so before the entry."""
        self.own = self._own_before
        self._after_target()
        self.edited.emit()

    def _after_target(self) -> None:
        """Mark the field if its text is no figure."""
        self.field.show_attention(wanted=self.field.is_nonsense())


class StepBox(QComboBox):
    """The usual steps, one more if needed, and «Continuous».

    Args:
        write: Returns a step as text.
    """

    chosen = Signal()
    """Emitted when another entry was chosen."""

    def __init__(self, write: Callable[[float], str]) -> None:
        super().__init__()
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self._write = write
        self._step = 1.0
        self._fill(STEPS)
        self.set_step(self._step)
        self.currentIndexChanged.connect(self._on_index_changed)

    @property
    def step(self) -> float:
        """The step chosen last; it also applies to the arrow keys in the fields."""
        return self._step

    @property
    def continuous(self) -> bool:
        """True if − and + move for as long as they are held."""
        return bool(self.currentData() == _CONTINUOUS)

    def set_step(self, step: float) -> None:
        """Choose a step; an unusual one becomes a further entry."""
        blocked = self.blockSignals(True)
        self._step = step
        self._fill(sorted({*STEPS, step}))
        self.setCurrentIndex(self.findData(step))
        self.blockSignals(blocked)

    def _fill(self, steps: Sequence[float]) -> None:
        self.clear()
        for step in steps:
            self.addItem(self._write(step), step)
        self.addItem(self.tr("Continuous"), _CONTINUOUS)

    def _on_index_changed(self) -> None:
        if not self.continuous:
            self._step = float(self.currentData())
        self.chosen.emit()

    def changeEvent(self, event: QEvent) -> None:
        """Update the text after a change of language."""
        if event.type() == QEvent.Type.LanguageChange:
            self.setItemText(self.count() - 1, self.tr("Continuous"))
        super().changeEvent(event)


class KeyPad(Translated, QFrame):
    """Accepts keys only while it has the focus, and shows the function of each key.

    Motion ends when either key is released, a second direction key is pressed, the focus is lost,
    or :class:`HoldGuard` detects a reason. A new press is needed to begin again.

    Args:
        keys: The things that can be moved, with their keys.
        name: The name of the widget.
    """

    pressed = Signal(int, int)
    """Emitted when a direction key was pressed: the index in ``keys``, and +1 or −1."""
    hold_ended = Signal()
    """Emitted once after each :attr:`pressed`, when the hold is over."""
    unattended = Signal()
    """Emitted when the hold ended because the operator gave no sign for too long."""

    def __init__(self, keys: Keys, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setProperty("card", True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._moves: dict[int, tuple[int, int]] = {}
        self._down: set[int] = set()
        self._armed = False
        self._holding = False
        self._why_not = ""
        self._continuous = False
        self._guard = HoldGuard(self)
        self._guard.lost.connect(self._forget)
        self._guard.unattended.connect(self.unattended)
        self._hint = text_label(f"{name}_hint", wraps=True)
        grid = empty_grid(gaps=(18, 2))
        for place, (what, plus, minus) in enumerate(keys):
            for text, direction in ((plus, 1), (minus, -1)):
                self._moves[_key(text)] = (place, direction)
            label = text_label(text=f"{what}  + {plus}  − {minus}", rank="muted")
            grid.addWidget(label, place // _COLUMNS, place % _COLUMNS)
        in_column(self._hint, grid, on=self, spacing=1, margins=(14, 5, 14, 5))
        self.retranslate_ui()

    def set_continuous(self, wanted: bool) -> None:
        """Set whether a key moves until it is released, or by one step for each press."""
        self._continuous = wanted
        self.retranslate_ui()

    def allow(self, why_not: str) -> None:
        """Accept keys, or reject them with the reason."""
        self._why_not = why_not
        if why_not:
            self._forget()
        self.retranslate_ui()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Begin with the single direction key that is pressed while the dead-man key is held."""
        key = event.key()
        if key != DEAD_MAN_KEY and key not in self._moves:
            super().keyPressEvent(event)
            return
        if event.isAutoRepeat():
            return
        if key == DEAD_MAN_KEY:
            self._armed = True
            return
        self._end()
        self._down.add(key)
        if self._armed and len(self._down) == 1 and not self._why_not:
            self._holding = True
            self._guard.watch()
            self.pressed.emit(*self._moves[key])

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """End the hold when either key is released."""
        key = event.key()
        if key != DEAD_MAN_KEY and key not in self._moves:
            super().keyReleaseEvent(event)
            return
        if event.isAutoRepeat():
            return
        self._down.discard(key)
        if key == DEAD_MAN_KEY:
            self._armed = False
        self._end()

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Show that keys are accepted now."""
        super().focusInEvent(event)
        self.retranslate_ui()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Drop all keys: their release elsewhere would not be noticed."""
        self._forget()
        super().focusOutEvent(event)
        self.retranslate_ui()

    def hideEvent(self, event: QHideEvent) -> None:
        """End the hold, because the pad is hidden."""
        self._forget()
        super().hideEvent(event)

    def _forget(self) -> None:
        self._armed = False
        self._down.clear()
        self._end()

    def _end(self) -> None:
        """Emit `hold_ended` first: the motion must end even if something after it fails."""
        if self._holding:
            self._holding = False
            self.hold_ended.emit()
        self._guard.release()

    def retranslate_ui(self) -> None:
        """Show the function of the keys, or the reason why they are disabled."""
        self.setAccessibleName(self.tr("Keyboard jogging"))
        self.setToolTip(self._why_not)
        if self._why_not:
            text = self.tr("Jogging is not possible now.")
        elif self.hasFocus() and not self._continuous:
            text = self.tr("Hold the space bar: a letter key is one step; held, it goes on.")
        elif self.hasFocus():
            text = self.tr("Hold the space bar and a letter key; release either to stop.")
        else:
            text = self.tr("Click here to jog by keys.")
        self._hint.setText(text)


def _key(text: str) -> int:
    named = _KEYS.get(text)
    return int(named) if named is not None else ord(text)


def held_speed(controller: ArmController, *, of_joints: bool) -> str:
    """Return the speed of a held jog at the present percentage, as text."""
    pace = controller.jogging.present_pace()
    if of_joints:
        return f"{fmt.number(max(pace.speeds_deg_s), 1)}°/s"
    length, angle = (fmt.number(pace.share * most, 1) for most in (TOOL_MM_S, TOOL_DEG_S))
    return f"{length} mm/s, {angle}°/s"


class JogPanel(Panel):
    """A card of targets, and two ways to jog: − and + beside them, and keys.

    Targets are cleared when another arm is connected. Joints go by their numbers, axes by their
    index in a pose. A key of the pad has the same effect as the button of the same number.

    Args:
        controller: Sends the motions.
        name: The first part of its widgets' names: ``<name>_step``, ``<name>_keys_button``.
        message_name: The object name of the message.
        keys: The keys that jog each number, in order.
        numbers: The numbers of the rows, in the order of the keys.
        write_step: Returns a step as text.
    """

    _rows: Sequence[TargetRow]
    _of_joints = True
    """False if it moves the tool."""

    def __init__(
        self,
        controller: ArmController,
        name: str,
        *,
        message_name: str,
        keys: Keys,
        numbers: Sequence[int],
        write_step: Callable[[float], str],
    ) -> None:
        super().__init__(controller, message_name)
        self._followed_s = 0.0
        self._begun: Started | None = None
        self._tried: tuple[float, ...] | None = None
        self._untaken: tuple[tuple[float, ...], tuple[bool, ...]] | None = None
        self._numbers = tuple(numbers)
        self._step_label = named(f"{name}_step_label", QLabel())
        self._step_box = named(f"{name}_step", StepBox(write_step))
        self._step_label.setBuddy(self._step_box)
        self._keys = choice_button(f"{name}_keys_button")
        self._with_measured = True
        self._key_pad = KeyPad(keys, f"{name}_key_pad")
        self._key_pad.hide()

    def _follow_rows(self) -> None:
        for row in self._rows:
            row.stepped.connect(self._on_stepped)
            row.repeated.connect(self._on_repeated)
            row.held.connect(self._on_held)
            row.hold_ended.connect(self._on_hold_ended)
            row.unattended.connect(self._on_unattended)
            row.edited.connect(self._on_edited)
        # Tab goes from target to target, and then through the steps
        steps = [button for row in self._rows for button in (row.minus, row.plus)]
        for before, after in pairwise([*(row.field for row in self._rows), *steps]):
            self.setTabOrder(before, after)

    def _finish(
        self,
        card: QFrame,
        buttons: Sequence[QWidget],
        sends: Sequence[QWidget],
        *,
        above: Sequence[QWidget] = (),
    ) -> None:
        """Lay the panel out around its card, and connect it; `retranslate_ui` is called after this.

        Args:
            card: Holds the rows.
            buttons: Those below it, from left to right.
            sends: The buttons that send the targets, at the right.
            above: The widgets between the title and the card.
        """
        head = in_row(self._title, STRETCH, *(self._keys, self._step_label, self._step_box))
        for other in buttons:
            for button in (other, *other.findChildren(QPushButton)):
                button.setMinimumHeight(_BUTTON_PX)
                button.setProperty("compact", True)
        for button in sends:
            button.setMinimumSize(_SEND_PX, _BUTTON_PX)
        row = in_row(*buttons, STRETCH, *sends, spacing=8)
        parts: list[QWidget | QLayout] = [
            *above,
            scrolled(card),
            self._key_pad,
            row,
        ]
        self._stack(*parts, head=head)
        self._step_box.chosen.connect(self._on_step_chosen)
        self._keys.toggled.connect(self._on_keys_toggled)
        self._key_pad.pressed.connect(self._on_key_pressed)
        self._key_pad.hold_ended.connect(self._on_hold_ended)
        self._key_pad.unattended.connect(self._on_unattended)
        self._listen()

    def show_measured_figures(self, *, wanted: bool) -> None:
        """Show or hide the measured values beside the targets: the picture shows them, too."""
        if wanted != self._with_measured:
            self._with_measured = wanted
            for row in self._rows:
                row.measured.setVisible(wanted)

    # -- targets ------------------------------------------------------------------------------

    def targets(self) -> tuple[float, ...] | None:
        """Return the figures in the fields, or ``None`` if one of them is invalid."""
        values = tuple(row.field.value for row in self._rows)
        known = tuple(value for value in values if value is not None)
        return known if len(known) == len(values) else None

    def typed(self) -> tuple[float, ...] | None:
        """Return the figures in the fields, if one of them was entered and not sent yet."""
        return self.targets() if any(self.given()) else None

    def given(self) -> tuple[bool, ...]:
        """Return for each field whether its target was entered; else it follows the arm."""
        return tuple(row.own for row in self._rows)

    def take_targets(self, values: Sequence[float], given: Sequence[bool] | None = None) -> None:
        """Set the fields as if the differing figures were typed; nothing is sent.

        Args:
            values: One for each row.
            given: Those that no longer follow the arm; by default those entered before, and those
                that differ.
        """
        for row, value in zip(self._rows, values, strict=True):
            row.take_target(value)
        for row, stands in zip(self._rows, given or (), strict=False):
            row.own = stands
        self._follow_arm()
        self._on_edited()

    def _fill(self, values: Sequence[float] | None) -> None:
        """Give every row a target; ``None`` empties the fields."""
        for row, value in zip(self._rows, values or (None,) * len(self._rows), strict=True):
            row.show_target(value)

    def _may_work(self) -> bool:
        """Return whether no reason against the targets in the fields is known."""
        refused = self._refusal is not None and self.targets() == self._tried
        return not refused and self._first_wrong() is None

    def _differ_from(self, values: Sequence[float]) -> bool:
        """Return whether a target was entered that differs from its value here."""
        return any(row.differs_from(value) for row, value in zip(self._rows, values, strict=True))

    def _follow(self, values: Sequence[float]) -> None:
        """Show these figures in the fields in which no target was entered."""
        for row, value in zip(self._rows, values, strict=True):
            row.follow(value)

    # -- what a panel of its own adds ---------------------------------------------------------

    def _on_stepped(self, number: int, direction: int) -> None:
        """Jog by one step."""
        raise NotImplementedError

    def _on_repeated(self, number: int, direction: int) -> None:
        """Jog by another step: the button is still held."""
        raise NotImplementedError

    def _on_edited(self) -> None:
        """React to a target that the operator has changed."""
        raise NotImplementedError

    def _on_held(self, number: int, direction: int) -> None:
        """Jog until :meth:`_on_hold_ended`."""
        raise NotImplementedError

    def _first_wrong(self) -> Refusal | None:
        """Return the reason against the targets in the fields, or ``None``."""
        raise NotImplementedError

    def _follow_now_and_then(self, state: ArmState) -> None:
        """Follow a moving arm ten times a second at most: painting the fields is slow."""
        at_s = state.last_feedback_s or 0.0
        if not 0.0 < at_s - self._followed_s < _FOLLOW_S:
            self._followed_s = at_s
            self._follow_arm()

    def _follow_arm(self) -> None:
        """Show the arm's place in the fields in which no target was entered."""
        raise NotImplementedError

    def _forget_targets(self) -> None:
        """Clear all targets, because another arm is connected, or its zero points have changed."""
        raise NotImplementedError

    def _show_possible(self) -> None:
        """Enable what can be used now; the tooltips of the rest give the reasons."""
        raise NotImplementedError

    # -- jogging ------------------------------------------------------------------------------

    def _on_step_chosen(self) -> None:
        for row in self._rows:
            row.set_step(self._step_box.step, continuous=self._step_box.continuous)
        self._key_pad.set_continuous(self._step_box.continuous)
        self._show_possible()

    def _on_keys_toggled(self, wanted: bool) -> None:
        self._key_pad.setVisible(wanted)
        if wanted:
            self._key_pad.setFocus(Qt.FocusReason.OtherFocusReason)

    def _on_key_pressed(self, place: int, direction: int) -> None:
        jog = self._on_held if self._step_box.continuous else self._on_stepped
        jog(self._numbers[place], direction)

    def _on_hold_ended(self) -> None:
        self._controller.jogging.stop()

    def _on_unattended(self) -> None:
        self._accepted(HOLD_UNATTENDED(seconds=UNATTENDED_S))

    def _accepted(self, answer: Started | Refusal | None) -> bool:
        self._begun, self._untaken = (answer if isinstance(answer, Started) else None), None
        accepted = super()._accepted(answer)
        self.show_acts()
        return accepted

    def _drive(
        self,
        move: Callable[[float], Started | Refusal],
        then: Callable[[], object] = lambda: None,
    ) -> None:
        """Send a single motion by :func:`drive`; ``then`` is called once it is sent."""

        def answered(answer: Started | Refusal) -> None:
            if self._accepted(answer):
                then()

        drive(self, self._controller, move, answered, self._given_figures)

    def _given_figures(self) -> list[object]:
        """Return all entries for a motion: the targets, and further ones of a subclass."""
        return [row.field.value if row.own else None for row in self._rows]

    def _on_noticed(self, event: Event) -> None:
        """Show why a jog has ended or a motion was refused; clear all targets after a new zero."""
        reason = event.params.get("reason")
        late = event.notice == REFUSED and self._begun and self._begun.ending is Ending.REFUSED
        if (late or event.notice == JOG_ENDED) and isinstance(reason, Refusal) and self.isVisible():
            if late and self._untaken and not any(self.given()):
                self.take_targets(*self._untaken)
            self._accepted(reason)
        elif event.notice in ZEROING_ENDED:
            # with the new zero the same figures are another place
            self._forget_targets()
            self._show_message()

    # -- what the arm says --------------------------------------------------------------------

    def _forget_outdated(self, old: OperatingState) -> None:
        if old.device != self._operating_state.device:
            # another arm: targets that were entered for the last one must not be sent to it
            self._forget_targets()
        now = self._operating_state
        if (old.cannot_move, not old.outside) != (now.cannot_move, not now.outside):
            self._refusal = None

    def _allow_jog(self) -> str:
        """Enable all that jogs, or disable it; return why nothing can be moved."""
        why_not = words.why_not(self._operating_state.cannot_move)
        for row in self._rows:
            row.allow_jog(why_not)
        self._key_pad.allow(why_not)
        held = self._step_box.continuous
        speed = held_speed(self._controller, of_joints=self._of_joints) if held else ""
        self._step_label.setText(speed or self.tr("Step"))
        return why_not

    def _show_message(self) -> None:
        standing = self._unless_told(self._operating_state.cannot_move)
        self._show_outcome(self._refusal or standing or self._first_wrong(), self._event)

    def retranslate_ui(self) -> None:
        """Set the texts of the head in the operator's language."""
        self._step_box.setAccessibleName(self.tr("Step of − and +"))
        self._keys.setText(self.tr("Keyboard"))
        tip = self.tr("Jog by keys, with the space bar held as dead-man key")
        describe(self._keys, self.tr("Keyboard jogging"), tip)
        self._show_possible()
        self._show_message()
