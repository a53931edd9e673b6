"""Draws the 3D picture beside the user interface.

The thread that draws owns everything of OpenGL from first to last. It sleeps until something has
changed, and starts no new picture before the last one was used. VTK releases Python's global lock
while it draws, so the user interface keeps running. On macOS windows belong to the main thread,
drawing too: there the same class draws between two events instead.
"""

from __future__ import annotations

import contextlib
import logging
import os
import sys
import threading

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtGui import QImage

from armui.arm.refusal import Refusal
from armui.viewport.errors import DRAWING_STOPPED, SceneError
from armui.viewport.frame_painter import FramePainter
from armui.viewport.mailbox import Mailbox
from armui.viewport.view_state import ViewState

_LOG = logging.getLogger(__name__)
_JOIN_LIMIT_S = 10.0
_NICENESS = 10
_REST_MS = 150
"""The picture has come to rest when nothing has changed for so long."""


class RenderThread(QObject):
    """Makes pictures of the states it is shown, the latest one first.

    Signals:
        frame_ready: a finished picture, with a copy of its own memory.
        joint_picked: the joint number (1–6) or None at a picked place.
        mark_picked: the row of a mark that was clicked.
        load_failed: why a robot can't be shown, a `Refusal`; the one before stays.
        failed: why nothing can be drawn at all, a `Refusal`; no pictures follow.

    Args:
        threaded: False draws in the calling thread, between two events; by default on macOS only.
    """

    frame_ready = Signal(QImage)
    joint_picked = Signal(object)
    mark_picked = Signal(int)
    load_failed = Signal(object)
    failed = Signal(object)

    def __init__(
        self, *, threaded: bool = sys.platform != "darwin", parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._mailbox: Mailbox[ViewState] = Mailbox()
        self._threaded = threaded
        self._thread: threading.Thread | None = None
        self._inline_painter: FramePainter | None = None
        self._inline_timer = QTimer(self)
        self._inline_timer.setSingleShot(True)
        self._inline_timer.timeout.connect(self._draw_inline)

    @property
    def is_running(self) -> bool:
        """Whether `start` was called and `stop` was not."""
        return self._thread is not None or self._inline_painter is not None

    def start(self) -> None:
        """Begin to draw; call once."""
        if self._threaded:
            # A daemon: a graphics driver that hangs must not keep the program from ending.
            self._thread = threading.Thread(target=self._run, name="armui-viewport", daemon=True)
            self._thread.start()
        else:
            self._inline_painter = self._new_painter()
            self._inline_timer.start(0)

    def show(self, state: ViewState) -> None:
        """Ask for a picture; replaces a state that was not drawn yet."""
        self._mailbox.put(state)
        if self._inline_painter is not None:
            self._inline_timer.start(0)

    def frame_taken(self) -> None:
        """The last picture is on the screen: the next one may be drawn."""
        self._mailbox.acknowledge()
        if self._inline_painter is not None and not self._inline_timer.isActive():
            self._inline_timer.start(0 if self._mailbox.has_item else _REST_MS)

    def stop(self) -> None:
        """End drawing and wait until everything is given back; may be called twice."""
        self._mailbox.close()
        self._inline_timer.stop()
        if self._inline_painter is not None:
            self._inline_painter.close()
            self._inline_painter = None
        if self._thread is not None:
            self._thread.join(_JOIN_LIMIT_S)
            if self._thread.is_alive():
                _LOG.error("The 3D view did not end in %.0f s: the driver hangs.", _JOIN_LIMIT_S)
            self._thread = None

    def _new_painter(self) -> FramePainter:
        return FramePainter(self.load_failed.emit, self.joint_picked.emit, self.mark_picked.emit)

    def _run(self) -> None:
        _give_way()
        painter = self._new_painter()
        try:
            while True:
                state = self._mailbox.take(_REST_MS / 1000.0 if painter.is_rough else None)
                if self._mailbox.is_closed or not self._draw(painter, state):
                    break
        finally:
            painter.close()

    def _draw_inline(self) -> None:
        if self._inline_painter is None or self._mailbox.is_result_pending:
            return
        if not self._draw(self._inline_painter, self._mailbox.take_at_once()):
            self.stop()

    def _draw(self, painter: FramePainter, state: ViewState | None) -> bool:
        """Draw a state, or without one refine the last picture; False when drawing can't go on."""
        try:
            pixels = painter.refine() if state is None else painter.paint(state)
        except SceneError as error:
            self.failed.emit(error.refusal)
            return False
        except Exception as error:  # noqa: BLE001 - a picture must not take the controls with it
            _LOG.exception("The 3D view stopped")
            text = f"{type(error).__name__}: {error}"
            self.failed.emit(Refusal(DRAWING_STOPPED, {"text": text}))
            return False
        if pixels is not None:
            height, width, depth = pixels.shape
            shared = QImage(
                pixels.data, width, height, width * depth, QImage.Format.Format_RGBX8888
            )
            # a copy of its own, in the format that windows are painted in
            image = shared.convertToFormat(QImage.Format.Format_RGB32)
            image.setDevicePixelRatio(painter.pixel_ratio)
            self._mailbox.result_sent()
            self.frame_ready.emit(image)
        return True


def _give_way() -> None:
    """Let the buttons and the bus go before the picture where the processor draws it.

    Linux gives the threads that a software OpenGL starts from here the same low priority. Elsewhere
    the system's own scheduling has to do.
    """
    if sys.platform == "linux":
        with contextlib.suppress(OSError):
            os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), _NICENESS)
