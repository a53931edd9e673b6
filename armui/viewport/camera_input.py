"""Camera control by mouse drag, wheel and keys."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPointF, Qt
from PySide6.QtWidgets import QApplication

if TYPE_CHECKING:
    from collections.abc import Callable

    from PySide6.QtGui import QMouseEvent, QWheelEvent

    from armui.viewport.camera import OrbitCamera

_KEY_TURN_PX: Final = 20.0
_WHEEL_STEP: Final = 120.0
_MOVES: Final[dict[int, Callable[[OrbitCamera], OrbitCamera]]] = {
    Qt.Key.Key_Left: lambda camera: camera.orbit(-_KEY_TURN_PX, 0.0),
    Qt.Key.Key_Right: lambda camera: camera.orbit(_KEY_TURN_PX, 0.0),
    Qt.Key.Key_Up: lambda camera: camera.orbit(0.0, -_KEY_TURN_PX),
    Qt.Key.Key_Down: lambda camera: camera.orbit(0.0, _KEY_TURN_PX),
    Qt.Key.Key_Plus: lambda camera: camera.zoom(1.0),
    Qt.Key.Key_Equal: lambda camera: camera.zoom(1.0),
    Qt.Key.Key_Minus: lambda camera: camera.zoom(-1.0),
}


class Drag:
    """The mouse from press to release; a release near the press was a click."""

    def __init__(self) -> None:
        self._pressed_at: QPointF | None = None
        self._last: QPointF | None = None

    @property
    def is_pressed(self) -> bool:
        """True while a button is pressed."""
        return self._last is not None

    def press(self, event: QMouseEvent) -> None:
        """Begin a drag with the left or the middle button."""
        if event.button() in {Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton}:
            self._pressed_at = self._last = event.position()

    def move(
        self, event: QMouseEvent, camera: OrbitCamera, shorter_side_px: float
    ) -> OrbitCamera | None:
        """Turn the camera, or with the middle button or shift move it.

        Args:
            event: The event with the pointer's place.
            camera: The camera before it.
            shorter_side_px: The shorter side of the picture.

        Returns:
            The camera after it; ``None`` if nothing is dragged.
        """
        if self._last is None:
            return None
        delta = event.position() - self._last
        self._last = event.position()
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if shift or event.buttons() & Qt.MouseButton.MiddleButton:
            return camera.pan(delta.x(), delta.y(), shorter_side_px)
        return camera.orbit(delta.x(), delta.y())

    def release(self, event: QMouseEvent) -> QPointF | None:
        """End the drag, and return the place of a click, or ``None`` after a drag."""
        pressed_at = self._pressed_at
        self.cancel()
        if pressed_at is None:
            return None
        way_px = (event.position() - pressed_at).manhattanLength()
        return event.position() if way_px < QApplication.startDragDistance() else None

    def cancel(self) -> None:
        """End the drag, because the view is hidden or the release went unnoticed."""
        self._pressed_at = self._last = None


def turn_wheel(event: QWheelEvent, camera: OrbitCamera) -> OrbitCamera:
    """Return the camera nearer or farther, by the notches of the wheel."""
    return camera.zoom(event.angleDelta().y() / _WHEEL_STEP)


def press_key(key: int, camera: OrbitCamera) -> OrbitCamera | None:
    """Return the camera after an arrow key (turn), + or − (zoom); ``None`` for another key."""
    move = _MOVES.get(key)
    return None if move is None else move(camera)
