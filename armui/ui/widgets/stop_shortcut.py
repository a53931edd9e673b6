"""The keys that stop, halt and slow the arm from every window, and stop buttons behind popups."""

from __future__ import annotations

import sys
from typing import Final

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QPoint, Qt, QTimer, Signal
from PySide6.QtGui import QDragEnterEvent, QHelpEvent, QKeyEvent, QMouseEvent, QPaintEvent
from PySide6.QtWidgets import QApplication, QWidget

from armui.control.arm_controller import ArmController
from armui.control.run.speed_override import STEP_PERCENT
from armui.ui.widgets.press_button import PressButton
from armui.ui.widgets.tips import uncover

STOP_KEYS: Final = frozenset({Qt.Key.Key_F12, Qt.Key.Key_Pause})
HALT_KEY: Final = Qt.Key.Key_F9
"""A key in the same group as F12, but not beside it, so that neither is hit for the other."""
STOP_CHORD: Final = Qt.KeyboardModifier.ControlModifier | Qt.Key.Key_Period
"""The stop on macOS, where F9 and F12 control music and no key is Pause: ⌘, which Qt calls Control,
and a dot, the usual combination to cancel.
"""
HALT_CHORD: Final = Qt.KeyboardModifier.ControlModifier | Qt.Key.Key_Backspace
_HAS_CHORDS: Final = sys.platform == "darwin"
STOP_KEY_NAME: Final = "F12, ⌘." if _HAS_CHORDS else "F12, Pause"
HALT_KEY_NAME: Final = "F9, ⌘⌫" if _HAS_CHORDS else "F9"
SLOWER_KEY: Final = Qt.Key.Key_F8
"""The key beside the halt, so that hitting it by mistake slows the arm."""

_LISTENED_TO: Final = (QKeyEvent, QMouseEvent, QDragEnterEvent, QHelpEvent)
_PAINTED_WITHIN_MS: Final = 250
_PRESSES: Final = frozenset({QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonDblClick})


class StopShortcut(QObject):
    """Filters events of the whole application, even while a dialog takes the other keys.

    A key only ever stops, halts or slows; it never releases. A press that would only close a popup
    (of a combo box, a menu) reaches the stop button under it.

    Args:
        app: The application, which is the filter's parent.
        controller: The controller of the arm.
        first_window: The filter starts when this window was painted; by default at once. Showing
            and painting it takes two thousand events, each of which costs Python some time.
    """

    def __init__(
        self, app: QCoreApplication, controller: ArmController, first_window: QWidget | None = None
    ) -> None:
        super().__init__(app)
        self._app = app
        self._controller = controller
        if first_window is None:
            app.installEventFilter(self)
        else:
            # installed after the first painting, whose events then do not pass through Python
            _FirstPicture(self, first_window).seen.connect(self._go_first)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Handle the keys in every window, and presses behind a popup."""
        # most events are of no interest: asking each for its type would take ten times as long
        if not isinstance(event, _LISTENED_TO):
            return False
        # a key press goes to the window first and then to its widgets: take the first one
        kind = event.type()
        if kind == QEvent.Type.KeyPress and isinstance(event, QKeyEvent):
            return self._on_key(event)
        if kind in _PRESSES and isinstance(event, QMouseEvent):
            return _press_behind_popup(event)
        if kind == QEvent.Type.ToolTip:
            QTimer.singleShot(0, self, uncover)  # from the event loop, when the tooltip is visible
        elif kind == QEvent.Type.DragEnter:
            # during a drag, Qt's own filter takes every key: install this one in front of it
            QTimer.singleShot(0, self, self._go_first)
        return False

    def _on_key(self, event: QKeyEvent) -> bool:
        # repetitions of a held key do nothing, but are taken, so that no widget acts on them
        chord = event.keyCombination() if _HAS_CHORDS else None
        if event.key() in STOP_KEYS or chord == STOP_CHORD:
            if not event.isAutoRepeat():
                self._controller.emergency_stop()
            return True
        if event.key() == HALT_KEY or chord == HALT_CHORD:
            if not event.isAutoRepeat():
                self._controller.halt_and_hold()
            return True
        if event.key() == SLOWER_KEY:
            if not event.isAutoRepeat():
                self._controller.speed_override.step(-STEP_PERCENT)
            return True
        return False

    def _go_first(self) -> None:
        # Qt asks the filter first that was installed last
        self._app.removeEventFilter(self)
        self._app.installEventFilter(self)


class _FirstPicture(QObject):
    """Emits a signal when a window was painted for the first time, or after a time limit."""

    seen = Signal()

    def __init__(self, parent: QObject, window: QWidget) -> None:
        super().__init__(parent)
        window.installEventFilter(self)
        # a covered window may never be painted, and the stop keys have to work all the same
        QTimer.singleShot(_PAINTED_WITHIN_MS, self, self._emit_seen)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Detect the first paint event of the window."""
        if isinstance(event, QPaintEvent):
            watched.removeEventFilter(self)
            QTimer.singleShot(0, self, self._emit_seen)
        return False

    def _emit_seen(self) -> None:
        self.seen.emit()


def _press_behind_popup(event: QMouseEvent) -> bool:
    """Have the stop button under the pointer act, and close the popups."""
    if QApplication.activePopupWidget() is None or event.button() != Qt.MouseButton.LeftButton:
        return False
    button = _button_at(event.globalPosition().toPoint())
    if button is None:
        return False
    button.act()
    # each submenu is a popup of its own; stop at one that does not close
    while (popup := QApplication.activePopupWidget()) is not None:
        if not popup.close():
            break
    return True


def _button_at(place: QPoint) -> PressButton | None:
    """Return the button under a place of the desktop that no other window covers."""
    widget = QApplication.widgetAt(place)
    if widget is None:  # Qt finds no widget outside of all screens
        popup = QApplication.activePopupWidget()
        if popup is not None and popup.geometry().contains(place):
            return None
        windows = [each for each in QApplication.topLevelWidgets() if each.isVisible()]
        under = [each.childAt(each.mapFromGlobal(place)) for each in windows]
        widget = next((each for each in under if isinstance(each, PressButton)), None)
    return widget if isinstance(widget, PressButton) else None
