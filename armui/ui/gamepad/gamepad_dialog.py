"""The window 手柄: switches jogging by gamepad or SpaceMouse on, and assigns buttons (B22)."""

from __future__ import annotations

from dataclasses import asdict
from functools import partial
from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QGuiApplication, QPaintEvent, QPen, QShowEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QCheckBox,
    QComboBox,
    QFrame,
    QLabel,
    QSizePolicy,
    QWidget,
)

from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.control.gamepad.pilot import PilotView
from armui.gamepad.device_state import DeviceInfo, DeviceKind, DeviceState
from armui.gamepad.layout import (
    ACTIONS,
    BUTTONS,
    DEAD_ZONES,
    DEFAULTS,
    OPTIONAL,
    SOURCES,
    SPEED_AXIS,
    Assignment,
    JogMode,
    deflections,
    speed_share,
    swapped,
)
from armui.setting_checks import GamepadMode
from armui.settings import SettingsStore
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.theme import colors_of
from armui.ui.widgets import painting
from armui.ui.widgets.buttons import caption, choice_button, named
from armui.ui.widgets.layouts import STRETCH, empty_grid, fill, in_column, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.seen_timer import SeenTimer
from armui.ui.widgets.text_label import ValueLabel, text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.gamepad import (
    GAMEPAD_ACTIONS,
    GAMEPAD_AXES,
    gamepad_button,
    gamepad_mode,
    moved_axis,
)

_SIZE_PX: Final = (820, 520)
_LIVE_MS: Final = 33
PIP_COMMAND: Final = 'pip install "armui[gamepad]"'
_MODES: Final[dict[JogMode, GamepadMode]] = {
    JogMode.JOINT: "joint",
    JogMode.BASE: "base",
    JogMode.TOOL: "tool",
    JogMode.USER: "user",
}
_AXES: Final = range(6)
_HEIGHT_PX: Final = 18
_GROOVE_PX: Final = 8.0
_CORNER_PX: Final = 4.0
_MOST_SEEN: Final = 12


class ButtonRows(HasActs, Translated, QWidget):
    """A row for each action of a button.

    Args:
        kind: The kind of device.
    """

    chosen = Signal(object)
    """Emitted with the :class:`Assignment` that the operator has chosen."""
    restore = Act("Restore", named="gamepad_defaults_button", tip="The buttons as delivered")

    def __init__(self, kind: DeviceKind) -> None:
        super().__init__()
        self._kind = kind
        self._now = DEFAULTS[kind]
        self._labels = {action: QLabel() for action in ACTIONS}
        self._boxes = {action: named(f"gamepad_{action}_box", QComboBox()) for action in ACTIONS}
        self._down = text_label("gamepad_down", rank="muted", wraps=True)
        grid = empty_grid(self, gaps=(12, 8), margins=0)
        grid.setColumnStretch(1, 1)
        for row, action in enumerate(ACTIONS):
            label, box = self._labels[action], self._boxes[action]
            label.setBuddy(box)
            box.setMaxVisibleItems(_MOST_SEEN)
            for button in self._choices(action):
                box.addItem("", button)
            box.activated.connect(partial(self._on_chosen, action))
            grid.addWidget(label, row, 0)
            grid.addWidget(box, row, 1)
        grid.addLayout(in_row(STRETCH, self.restore), len(ACTIONS), 0, 1, 2)
        grid.addWidget(self._down, len(ACTIONS) + 1, 0, 1, 2)
        grid.setRowStretch(len(ACTIONS) + 2, 1)
        self.retranslate_ui()

    def show_assignment(self, now: Assignment) -> None:
        """Show the present assignment."""
        self._now = now
        for action, box in self._boxes.items():
            box.setCurrentIndex(box.findData(getattr(now, action)))

    def show_down(self, down: frozenset[str]) -> None:
        """Name the pressed buttons, and mark their actions."""
        names = " · ".join(gamepad_button(self._kind, name) for name in sorted(down))
        self._down.setText(self.tr("Pressed: {buttons}").format(buttons=names or "—"))
        for action, label in self._labels.items():
            lit = getattr(self._now, action) in down
            font = label.font()
            if font.bold() != lit:
                font.setBold(lit)
                label.setFont(font)

    @restore.pressed
    def _on_restore(self) -> None:
        self.chosen.emit(DEFAULTS[self._kind])

    def _choices(self, action: str) -> tuple[str, ...]:
        return (*(("",) if action in OPTIONAL else ()), *BUTTONS[self._kind])

    def _on_chosen(self, action: str, place: int) -> None:
        button = self._boxes[action].itemData(place)
        self.chosen.emit(swapped(self._now, action, button))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        for action, box in self._boxes.items():
            self._labels[action].setText(GAMEPAD_ACTIONS.text(action))
            for place, button in enumerate(self._choices(action)):
                text = gamepad_button(self._kind, button) if button else self.tr("No button")
                box.setItemText(place, text)
        self.show_acts()
        self.show_down(frozenset())


class AxisBar(QWidget):
    """A bar for −1 to 1, or 0 to 1.

    Args:
        dead_zone: The axis counts as at rest within it.
        from_left: True if it begins at the left, as for a trigger.
    """

    def __init__(self, dead_zone: float, *, from_left: bool = False) -> None:
        super().__init__()
        self._dead_zone = dead_zone
        self._from_left = from_left
        self._value = 0.0
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    @property
    def value(self) -> float:
        """The value shown."""
        return self._value

    def show_value(self, value: float) -> None:
        """Show a deflection, −1 to 1."""
        value = max(-1.0, min(1.0, value))
        if value != self._value:
            self._value = value
            self.update()

    def sizeHint(self) -> QSize:
        """Return a size that uses the available width."""
        return QSize(120, _HEIGHT_PX)

    def minimumSizeHint(self) -> QSize:
        """Return the smallest readable size."""
        return QSize(70, _HEIGHT_PX)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw groove, dead zone and bar."""
        colors = colors_of(self)
        painter = painting.begin(self)
        painter.setPen(QPen(QColor(colors.border), 1.0))
        painter.setBrush(QColor(colors.sunken))
        top = (self.height() - _GROOVE_PX) / 2
        groove = QRectF(0.5, top, self.width() - 1.0, _GROOVE_PX)
        painter.drawRoundedRect(groove, _CORNER_PX, _CORNER_PX)
        centre = groove.left() if self._from_left else groove.center().x()
        reach = groove.width() if self._from_left else groove.width() / 2
        moves = abs(self._value) > self._dead_zone
        end = centre + reach * self._value
        painter.setPen(QPen(QColor("transparent")))
        painter.setBrush(QColor(colors.accent if moves else colors.muted))
        bar = QRectF(QPointF(min(centre, end), top), QPointF(max(centre, end), top + _GROOVE_PX))
        painter.drawRoundedRect(bar, _CORNER_PX, _CORNER_PX)
        painter.setPen(QPen(QColor(colors.muted), 1.0))
        for side in (-1, 1):
            if not self._from_left:
                at = centre + side * reach * self._dead_zone
                painter.drawLine(QPointF(at, top - 3), QPointF(at, top + _GROOVE_PX + 3))
        painter.end()


class AxisRows(Translated, QWidget):
    """A row for each axis of the arm, and one for the trigger.

    Args:
        kind: The kind of device.
    """

    def __init__(self, kind: DeviceKind) -> None:
        super().__init__()
        self._kind = kind
        self._mode = JogMode.JOINT
        self._sources = [text_label() for _ in _AXES]
        self._bars = [AxisBar(DEAD_ZONES[kind]) for _ in _AXES]
        self._targets = [QLabel() for _ in _AXES]
        grid = empty_grid(self, gaps=(12, 6), margins=0)
        grid.setColumnStretch(1, 1)
        for row, cells in enumerate(zip(self._sources, self._bars, self._targets, strict=True)):
            for column, cell in enumerate(cells):
                grid.addWidget(cell, row, column)
        self._trigger_label = text_label()
        self._trigger = AxisBar(0.0, from_left=True)
        self._share = ValueLabel("100 %", alignment=Qt.AlignmentFlag.AlignLeft)
        if kind is DeviceKind.GAMEPAD:
            row = grid.rowCount()
            for column, cell in enumerate((self._trigger_label, self._trigger, self._share)):
                grid.addWidget(cell, row, column)
        grid.setRowStretch(grid.rowCount(), 1)
        self.retranslate_ui()

    def show_mode(self, mode: JogMode) -> None:
        """Show the axes of a mode."""
        if mode is not self._mode:
            self._mode = mode
            self.retranslate_ui()

    def show_state(self, state: DeviceState | None) -> None:
        """Show the deflection of each axis, or nothing with None."""
        pushed = (0.0,) * 6 if state is None else deflections(state, self._mode)
        for bar, value in zip(self._bars, pushed, strict=True):
            bar.show_value(value)
        if self._kind is DeviceKind.GAMEPAD:
            self._trigger.show_value(0.0 if state is None else state.axes.get(SPEED_AXIS, 0.0))
            self._share.show_text("—" if state is None else f"{100 * speed_share(state):.0f} %")

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        sources = SOURCES[self._kind][self._mode]
        for place, source in enumerate(sources):
            self._sources[place].setText(GAMEPAD_AXES.text(source.axis or source.plus))
            self._targets[place].setText(moved_axis(self._mode, place))
            self._bars[place].setAccessibleName(GAMEPAD_AXES.text(source.axis or source.plus))
        self._trigger_label.setText(GAMEPAD_AXES.text(SPEED_AXIS))
        self._trigger.setAccessibleName(GAMEPAD_AXES.text(SPEED_AXIS))
        self._share.setToolTip(
            self.tr("Share of the speed in the top bar; a fifth of it without the trigger")
        )


class GamepadDialog(ArmDialog):
    """Shows the devices found and their axes; nothing moves while this window is in front.

    Args:
        store: The settings.
        controller: Controls the gamepads.
        parent: The main window.
    """

    copy_button = Act("Copy the command", named="gamepad_copy_button")

    def __init__(
        self, store: SettingsStore, controller: ArmController, parent: QWidget | None = None
    ) -> None:
        super().__init__(controller, parent)
        self._store = store
        self._pilot = controller.gamepad
        self._shown: DeviceInfo | None = None
        self._problem = ""
        self._axes: AxisRows | None = None
        self._buttons: ButtonRows | None = None
        self._build()
        self.resize(*_SIZE_PX)
        self._timer = SeenTimer(self, _LIVE_MS, self._show_live)
        self._pilot.changed.connect(self._on_changed)
        self.on_box.clicked.connect(self._on_switched)
        self.one_axis_box.clicked.connect(self._on_one_axis)
        self.device_box.activated.connect(self._on_device)
        self._modes.idClicked.connect(self._on_mode)
        self.on_box.setFocus()
        self.retranslate_ui()

    # Layout -----------------------------------------------------------------------------------

    def _build(self) -> None:
        self.on_box = named("gamepad_on_box", QCheckBox())
        self.one_axis_box = named("gamepad_one_axis_box", QCheckBox())
        self._device_label = QLabel()
        self.device_box = named("gamepad_device_box", QComboBox())
        self._device_label.setBuddy(self.device_box)
        self._mode_label = QLabel()
        self._modes = QButtonGroup(self)
        modes = in_row(spacing=6)
        for number, mode in enumerate(JogMode):
            button = choice_button(f"gamepad_mode_{mode.value}")
            self._modes.addButton(button, number)
            modes.addWidget(button)
        self._hint = text_label("gamepad_hint", rank="muted", wraps=True)
        self._message = named("gamepad_message", MessageLine())
        self._axes_card, self._buttons_card = QFrame(), QFrame()
        self._axes_title, self._buttons_title = QLabel(), QLabel()
        self._axes_place = in_column(self._axes_title, spacing=10)
        self._buttons_place = in_column(self._buttons_title, spacing=10)
        for card, place in (
            (self._axes_card, self._axes_place),
            (self._buttons_card, self._buttons_place),
        ):
            card.setProperty("card", True)
            place.setContentsMargins(16, 12, 16, 12)
            card.setLayout(place)
        fill(
            self.body,
            in_row((self.on_box, 1), self.one_axis_box),
            in_row(
                *(self._device_label, (self.device_box, 1), 12, self._mode_label, modes), spacing=8
            ),
            self._message,
            in_row((in_column(self._axes_card, STRETCH), 1), (self._buttons_card, 1), spacing=12),
            STRETCH,
            self._hint,
        )
        fill(self.footer, self.copy_button, STRETCH, CloseButton(self))

    # What is shown ----------------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Update everything that is shown."""
        super().showEvent(event)
        if not event.spontaneous():
            self._refresh()

    def _on_changed(self, _view: PilotView) -> None:
        if self.isVisible():
            self._refresh()

    def _refresh(self) -> None:
        view, settings = self._pilot.view, self._store.settings
        self.on_box.setChecked(settings.gamepad)
        self.one_axis_box.setChecked(settings.gamepad_one_axis)
        self._modes.button(tuple(JogMode).index(view.mode)).setChecked(True)
        self._list_devices(view)
        if self._axes is not None:
            self._axes.show_mode(view.mode)
        if self._buttons is not None and self._shown is not None:
            self._buttons.show_assignment(self._pilot.buttons_of(self._shown))
        self.copy_button.setVisible(bool(view.missing))
        self._show_problems(view)
        self._show_live()

    def _list_devices(self, view: PilotView) -> None:
        listed = [self.device_box.itemData(n) for n in range(self.device_box.count())]
        if listed != list(view.devices):
            self.device_box.clear()
            for info in view.devices:
                self.device_box.addItem(info.name, info)
        if self._shown not in view.devices:
            self._show_device(next(iter(view.devices), None))
        self.device_box.setEnabled(bool(view.devices))
        if self._shown is not None:
            self.device_box.setCurrentIndex(view.devices.index(self._shown))

    def _show_device(self, info: DeviceInfo | None) -> None:
        """Make the rows for the device; another kind of device has others."""
        self._shown = info
        for old in (self._axes, self._buttons):
            if old is not None:
                old.hide()
                old.deleteLater()
        self._axes = self._buttons = None
        there = info is not None
        self._axes_card.setVisible(there)
        self._buttons_card.setVisible(there)
        if info is None:
            return
        self._axes = AxisRows(info.kind)
        self._axes.show_mode(self._pilot.view.mode)
        self._buttons = ButtonRows(info.kind)
        self._buttons.show_assignment(self._pilot.buttons_of(info))
        self._buttons.chosen.connect(self._on_assigned)
        self._axes_place.addWidget(self._axes, 1)
        self._buttons_place.addWidget(self._buttons, 1)

    def _show_live(self) -> None:
        state = self._state()
        if self._axes is not None:
            self._axes.show_state(state)
        if self._buttons is not None:
            self._buttons.show_down(frozenset() if state is None else state.buttons)

    def _state(self) -> DeviceState | None:
        snapshot = self._pilot.snapshot
        if snapshot is None or self._shown is None:
            return None
        return next((each for each in snapshot.devices if each.info == self._shown), None)

    def _show_problems(self, view: PilotView) -> None:
        texts = [self._problem] if self._problem else []
        if view.missing:
            text = self.tr("Not installed: {packages}. In a terminal: {command}")
            texts.append(text.format(packages=fmt.listed(view.missing), command=PIP_COMMAND))
        texts += view.problems
        if view.unusable:
            text = self.tr(
                "Found, but cannot be used (layout not known, or no permission): {names}"
            )
            texts.append(text.format(names=fmt.listed(view.unusable)))
        level = Level.WARNING if texts else Level.INFO
        if not texts and view.on and not view.devices:
            texts.append(self.tr("No device found. Plug one in, or switch it on and pair it."))
        self._message.show_message("\n".join(texts), level)
        self._message.setVisible(bool(texts))

    # What the operator does -------------------------------------------------------------------

    def _on_switched(self) -> None:
        self._take(words.why_not(self._store.change(gamepad=self.on_box.isChecked())))

    def _on_one_axis(self) -> None:
        one_axis = self.one_axis_box.isChecked()
        self._take(words.why_not(self._store.change(gamepad_one_axis=one_axis)))

    def _on_mode(self, number: int) -> None:
        mode = tuple(JogMode)[number]
        problem = words.why_not(self._store.change(gamepad_mode=_MODES[mode]))
        self._pilot.set_mode(mode)  # a button of the device may have changed it
        self._take(problem)

    def _on_device(self, place: int) -> None:
        info = self.device_box.itemData(place)
        if info != self._shown:
            self._show_device(info)
        self._refresh()

    def _on_assigned(self, wanted: Assignment) -> None:
        if self._shown is None:
            return
        new = {self._shown.name: asdict(wanted)}
        self._take(words.why_not(self._store.keep("gamepad_buttons", new)))

    @copy_button.pressed
    def _on_copy(self) -> None:
        QGuiApplication.clipboard().setText(PIP_COMMAND)

    def _take(self, problem: str) -> None:
        self._problem = problem
        self._refresh()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Gamepad and SpaceMouse"))
        caption(self.on_box, self.tr("Jog by gamepad or SpaceMouse"))
        tip = self.tr("Only the axis that was pushed first moves, until all are at rest again")
        caption(self.one_axis_box, self.tr("One axis at a time"), tip=tip)
        self._device_label.setText(self.tr("Device"))
        self.device_box.setPlaceholderText(self.tr("None found"))
        self._mode_label.setText(self.tr("Moves"))
        for number, mode in enumerate(JogMode):
            caption(self._modes.button(number), gamepad_mode(mode))
        self._axes_title.setText(self.tr("Axes"))
        self._buttons_title.setText(self.tr("Buttons"))
        self._hint.setText(
            self.tr(
                "Nothing moves while this window is in front: try everything here. In the main "
                "window hold the dead-man button, then push an axis; letting go of either stops. "
                "The buttons for emergency stop and halt work at any time, in every window."
            )
        )
        self.show_acts()
        self._refresh()
