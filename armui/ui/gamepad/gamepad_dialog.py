"""The window 手柄: jogging by gamepad or SpaceMouse switched on, tried and assigned (B22)."""

from __future__ import annotations

from dataclasses import asdict
from typing import Final

from PySide6.QtGui import QGuiApplication, QShowEvent
from PySide6.QtWidgets import QButtonGroup, QCheckBox, QComboBox, QFrame, QLabel, QWidget

from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.control.gamepad.pilot import PilotView
from armui.gamepad.device_state import DeviceInfo, DeviceState
from armui.gamepad.layout import Assignment, JogMode
from armui.setting_checks import GamepadMode
from armui.settings import SettingsStore
from armui.ui import words
from armui.ui.dialogs.base import ArmDialog
from armui.ui.dialogs.close_button import CloseButton
from armui.ui.gamepad.axis_rows import AxisRows
from armui.ui.gamepad.button_rows import ButtonRows
from armui.ui.widgets.buttons import caption, choice_button, named, push_button
from armui.ui.widgets.layouts import STRETCH, fill, in_column, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.seen_timer import SeenTimer
from armui.ui.widgets.text_label import text_label
from armui.ui.words.gamepad import gamepad_mode

_SIZE_PX: Final = (820, 520)
_LIVE_MS: Final = 33
PIP_COMMAND: Final = 'pip install "armui[gamepad]"'
_MODES: Final[dict[JogMode, GamepadMode]] = {
    JogMode.JOINT: "joint",
    JogMode.BASE: "base",
    JogMode.TOOL: "tool",
}


class GamepadDialog(ArmDialog):
    """Shows what was found and how its axes stand; nothing moves while this window is in front.

    Args:
        store: The settings.
        controller: Whose gamepads they are.
        parent: The main window.
    """

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
        self.copy_button.clicked.connect(self._on_copy)
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
        self.copy_button = push_button("gamepad_copy_button", on_enter=False)
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
            in_row((self._axes_card, 1), (self._buttons_card, 1), spacing=12),
            STRETCH,
            self._hint,
        )
        fill(self.footer, self.copy_button, STRETCH, CloseButton(self))

    # What is shown ----------------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Show how everything stands now."""
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
        self._say(view)
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

    def _say(self, view: PilotView) -> None:
        texts = [self._problem] if self._problem else []
        if view.missing:
            text = self.tr("Not installed: {packages}. In a terminal: {command}")
            texts.append(text.format(packages=", ".join(view.missing), command=PIP_COMMAND))
        texts += view.problems
        if view.unusable:
            text = self.tr(
                "Found, but cannot be used (layout not known, or no permission): {names}"
            )
            texts.append(text.format(names=", ".join(view.unusable)))
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
        self._pilot.set_mode(mode)  # a button of the device may have chosen another meanwhile
        self._take(problem)

    def _on_device(self, place: int) -> None:
        info = self.device_box.itemData(place)
        if info != self._shown:
            self._show_device(info)
        self._refresh()

    def _on_assigned(self, wanted: Assignment) -> None:
        if self._shown is None:
            return
        kept = dict(self._store.settings.gamepad_buttons) | {self._shown.name: asdict(wanted)}
        self._take(words.why_not(self._store.change(gamepad_buttons=kept)))

    def _on_copy(self) -> None:
        QGuiApplication.clipboard().setText(PIP_COMMAND)

    def _take(self, problem: str) -> None:
        self._problem = problem
        self._refresh()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
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
        caption(self.copy_button, self.tr("Copy the command"))
        self._refresh()
