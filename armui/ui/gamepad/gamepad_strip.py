"""The gamepad's strip in the main window: what the gamepad does, or what it waits for."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QRectF, QSize, QTimer
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QApplication, QLabel, QSizePolicy, QWidget

from armui.arm.refusal import Refusal
from armui.control.gamepad.pilot import GAMEPAD_NOT_IN_FRONT
from armui.gamepad.dead_man import HoldPhase
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.shell.workspace import PageWindow
from armui.ui.theme import Colors, colors_of
from armui.ui.widgets import icons, painting
from armui.ui.widgets.buttons import named
from armui.ui.widgets.hold_guard import HoldGuard
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.painting import set_rank
from armui.ui.widgets.text_label import ElidedLabel
from armui.ui.widgets.translated import Translated
from armui.ui.words.gamepad import gamepad_button, gamepad_mode

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.gamepad.pilot import PilotView
    from armui.setting_fields import Settings
    from armui.settings import SettingsStore

_ICON_PX: Final = 20
_SIDE_PX: Final = 26
_GROUND_SIDE_PX: Final = 16
_PADDING_PX: Final = 6
_A_DAY_S: Final = 86_400.0
"""A limit that never applies: the device is watched elsewhere, and the mouse is not used."""

_WAITS, _HELD, _MOVES, _WRONG = "waits", "held", "moves", "wrong"


class GamepadStrip(Translated, QWidget):
    """One line, visible only while a gamepad is switched on.

    It also tells the controller when jogging is not possible: neither the main window nor a page
    taken out of it is in front, a menu is open, or the main window is minimised or hidden.

    Args:
        controller: Controls the gamepads.
        store: The setting that switches them on.
    """

    def __init__(self, controller: ArmController, store: SettingsStore) -> None:
        super().__init__()
        self.setObjectName("gamepad_strip")
        self._controller = controller
        self._view: PilotView | None = None
        self._state = _WAITS
        self._watching = False
        self._guard = HoldGuard(self, _A_DAY_S)
        self._guard.lost.connect(self._on_lost)
        self._icon = QLabel()
        self._icon.setFixedWidth(_ICON_PX)
        self._text = named("gamepad_text", ElidedLabel())
        margins = (_SIDE_PX, _PADDING_PX, _SIDE_PX, _PADDING_PX)
        in_row(self._icon, (self._text, 1), on=self, spacing=10, margins=margins)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.hide()
        unsubscribe = store.subscribe(self._choose)
        self.destroyed.connect(lambda: unsubscribe())  # noqa: PLW0108 - the signal has an argument
        if store.settings.gamepad:
            QTimer.singleShot(0, self, partial(self._choose, store.settings))

    @property
    def text(self) -> str:
        """The present text."""
        return self._text.text()

    def _choose(self, settings: Settings) -> None:
        """Switch the gamepads on or off; their code is loaded only once they are on."""
        if self._view is None:
            if not settings.gamepad:
                return
            pilot = self._controller.gamepad
            pilot.attended = self._why_not_attended
            pilot.changed.connect(self._on_changed)
        self._controller.gamepad.choose(settings)
        self._on_changed(self._controller.gamepad.view)

    # Whether the operator attends to this window --------------------------------------------------

    def _why_not_attended(self) -> Refusal | None:
        covered = QApplication.activePopupWidget() or QApplication.activeModalWidget()
        if self._front() is not None and covered is None:
            return None
        return GAMEPAD_NOT_IN_FRONT()

    def _front(self) -> QWidget | None:
        """Return the window in front, if it may jog: the main window or a page taken out."""
        window, front = self.window(), QApplication.activeWindow()
        if front is None or not window.isVisible() or window.isMinimized():
            return None
        is_ours = front is window or (
            isinstance(front, PageWindow) and front.parentWidget() is window
        )
        return front if is_ours and not front.isMinimized() else None

    def _on_lost(self) -> None:
        self._controller.gamepad.lose(GAMEPAD_NOT_IN_FRONT())

    # Appearance -------------------------------------------------------------------------------

    def _on_changed(self, view: PilotView) -> None:
        self._view = view
        self.setVisible(view.on)
        held = view.phase not in {HoldPhase.UP, HoldPhase.SPENT}
        if held != self._watching:
            self._watching = held
            if held:
                self._guard.watch(self._front())
            else:
                self._guard.release()
        self._state = {
            HoldPhase.UP: _WAITS,
            HoldPhase.READY: _HELD,
            HoldPhase.MOVING: _MOVES,
            HoldPhase.OFF_CENTRE: _WRONG,
            HoldPhase.SPENT: _WRONG,
        }[view.phase]
        if not view.devices and (view.missing or view.problems):
            self._state = _WRONG
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set the text in the operator's language."""
        if self._view is None:
            return
        text = self._sentence(self._view)
        self._text.show_text(text)
        self.setAccessibleName(text)
        self._recolor()

    def _sentence(self, view: PilotView) -> str:
        device = view.device or next(iter(view.devices), None)
        if device is None:
            return self._nothing_found(view)
        button = gamepad_button(device.kind, self._controller.gamepad.buttons_of(device).dead_man)
        figures = {
            "device": device.name,
            "mode": gamepad_mode(view.mode),
            "button": button,
            "axes": view.axes,
        }
        text = {
            HoldPhase.UP: self.tr("{device} · {mode} · hold {button} and push an axis to jog"),
            HoldPhase.READY: self.tr("{device} · {mode} · dead man held, ready"),
            HoldPhase.MOVING: self.tr("{device} · {mode} · jogging {axes}"),
            HoldPhase.OFF_CENTRE: self.tr("{device} · {mode} · let every axis back to its centre"),
            HoldPhase.SPENT: self.tr("{device} · let go of {button}, then press it again"),
        }[view.phase].format(**figures)
        return text if view.refusal is None else f"{text} · {words.refusal(view.refusal)}"

    def _nothing_found(self, view: PilotView) -> str:
        if view.missing:
            return self.tr(
                "Gamepad: {packages} not installed. Install with pip: armui[gamepad]"
            ).format(packages=fmt.listed(view.missing))
        if view.problems:
            return self.tr("Gamepad: {problem}").format(problem="; ".join(view.problems))
        return self.tr("Gamepad: none found. Plug one in or switch it on.")

    def _recolor(self) -> None:
        _fill, ink = self._paint_colors(colors_of(self))
        set_rank(self._text, {_WAITS: "muted", _MOVES: "on_accent"}.get(self._state, ""))
        name = "warning" if self._state == _WRONG else "gamepad"
        self._icon.setPixmap(icons.pixmap(name, ink, _ICON_PX, self.devicePixelRatioF()))
        self.update()

    def _paint_colors(self, colors: Colors) -> tuple[str, str]:
        """Return the colours of background and text in the present state."""
        return {
            _WAITS: (colors.window, colors.muted),
            _HELD: (colors.accent_pale, colors.text),
            _MOVES: (colors.accent, colors.on_accent),
            _WRONG: (colors.warn_pale, colors.text),
        }[self._state]

    def sizeHint(self) -> QSize:
        """Return the size of one line."""
        return QSize(300, max(self.fontMetrics().height(), _ICON_PX) + 2 * _PADDING_PX)

    def minimumSizeHint(self) -> QSize:
        """Return the height of one line without a minimal width."""
        return QSize(0, self.sizeHint().height())

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the background in the colour of the present severity."""
        if self._state == _WAITS:
            return
        fill, _ink = self._paint_colors(colors_of(self))
        painter = painting.begin(self)
        ground = QRectF(self.rect()).adjusted(_GROUND_SIDE_PX, 1, -_GROUND_SIDE_PX, -1)
        painting.panel(painter, ground, fill, fill)
        painter.end()
