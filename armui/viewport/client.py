"""The Qt side of the render process: it sends view states and receives finished images."""

from __future__ import annotations

import contextlib
import math
import time
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtGui import QImage

from armui.viewport import messages
from armui.viewport.messages import BYTES_PER_PIXEL
from armui.viewport.process_link import ENTRY, Lost, PictureFrame, ProcessLink, RenderRequest
from armui.viewport.watch import LONGEST_S, PictureAge

if TYPE_CHECKING:
    from armui.viewport.robot_shape import RobotShape
    from armui.viewport.view_state import ViewState


_LOOK_AGAIN_MS: Final = 20


class Picture:
    """A finished image in shared memory.

    Attributes:
        frame: The process's data on it.
        image: Its pixels, in the format in which windows are painted. The memory is drawn into
            again: copy it to keep it beyond the next picture.
    """

    def __init__(self, frame: PictureFrame) -> None:

        self.frame = frame
        width, height = frame.size_px
        stride = width * BYTES_PER_PIXEL
        pixels = frame.memory.slot(frame.slot, stride * height)
        self.image = QImage(pixels, width, height, stride, QImage.Format.Format_RGB32)
        self.image.setDevicePixelRatio(frame.drawn.pixel_ratio)
        # the image points into the memory, which `frame` keeps alive: this view is no longer needed
        pixels.release()


class PictureClient(QObject):
    """Has pictures drawn of the states it is given, the latest one first.

    Signals:
        frame_ready: a :class:`Picture`.
        joint_picked: the joint number (1–6) or None at a picked place.
        mark_picked: the row of a mark that was clicked.
        robot_shown: the `RobotShape` that is in the picture from now on.
        load_failed: the `Refusal` of a robot that can't be shown; the one before stays.
        lost: the process is gone, a :class:`Lost`.
        aged: the picture has begun or ceased to look old.

    Args:
        entry: The function that the process runs; by default
            :data:`armui.viewport.process_link.ENTRY`.

    Attributes:
        shape: The robot in the picture, as far as it is known.
    """

    frame_ready = Signal(object)
    joint_picked = Signal(object)
    mark_picked = Signal(int)
    robot_shown = Signal(object)
    load_failed = Signal(object)
    lost = Signal(object)
    aged = Signal()
    _received = Signal(object)

    def __init__(self, entry: str = ENTRY, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._entry = entry
        self._link: ProcessLink | None = None
        self._sequence = 0
        self._state: ViewState | None = None
        self._age = PictureAge()
        self._is_stale = False
        self.shape: RobotShape | None = None
        self._is_rough = True
        self._clock = QTimer(self, singleShot=True)
        self._clock.timeout.connect(self._check_clock)
        # queued: `_receive` emits in the link's thread, and everything here runs in the GUI thread
        self._received.connect(self._on_received, Qt.ConnectionType.QueuedConnection)

    @property
    def is_running(self) -> bool:
        """True after `start`, until `stop`."""
        return self._link is not None

    @property
    def pid(self) -> int | None:
        """The number of the process, while there is one."""
        return None if self._link is None else self._link.pid

    @property
    def sequence(self) -> int:
        """The number of the newest state for which a picture was requested."""
        return self._sequence

    @property
    def is_stale(self) -> bool:
        """True if the picture is older than it may be without a notice (S24)."""
        return self._is_stale

    @property
    def is_settled(self) -> bool:
        """True if the last picture shows the newest state, with smooth edges."""
        return self._age.is_newest_shown and not self._is_rough

    def start(self) -> None:
        """Start drawing, also after the process was given up."""
        self.stop()
        self._link = ProcessLink(self._receive, self._entry)
        self._show_latest()
        self._link.start()

    def show(self, state: ViewState) -> None:
        """Request a picture; it replaces a state that was not drawn yet."""
        if state == self._state:
            return
        self._state = state
        self._sequence += 1
        self._age.wanted(self._sequence, time.monotonic())
        if not self._clock.isActive():
            self._clock.start(math.ceil(LONGEST_S * 1000.0))
        self._show_latest()

    def _show_latest(self) -> None:
        if self._link is not None and self._state is not None:
            self._link.show(RenderRequest(self._sequence, self._state))

    def frame_used(self, picture: Picture) -> None:
        """Report that this picture is on the screen, so that another may be drawn."""
        if self._link is not None:
            self._link.frame_used(picture.frame.number)

    def stop(self) -> None:
        """End the process, waiting up to a limit; may be called twice."""
        self._clock.stop()
        if self._link is not None:
            self._link.stop()
            self._link = None

    def _receive(self, message: object) -> None:
        """Bring a message into the GUI thread; called in the link's."""
        # the link's thread may still tell something after the Qt object was deleted
        with contextlib.suppress(RuntimeError):
            self._received.emit((self._link, message))

    def _on_received(self, received: tuple[ProcessLink | None, object]) -> None:

        link, message = received
        if link is not self._link or link is None:
            return  # from a process that was already given up
        if isinstance(message, PictureFrame):
            self._note_drawn(message.drawn)
            self.frame_ready.emit(Picture(message))
        elif isinstance(message, messages.Drawn):
            self._note_drawn(message)
        elif isinstance(message, messages.JointPicked):
            self.joint_picked.emit(message.number)
        elif isinstance(message, messages.MarkPicked):
            self.mark_picked.emit(message.row)
        elif isinstance(message, messages.RobotShown):
            self.shape = message.shape
            self.robot_shown.emit(message.shape)
        elif isinstance(message, messages.LoadFailed):
            self.load_failed.emit(message.refusal)
        elif isinstance(message, Lost):
            self.lost.emit(message)

    def _note_drawn(self, drawn: messages.Drawn) -> None:
        self._is_rough = drawn.is_rough
        self._age.shown(drawn.sequence, time.monotonic())
        self._check_age()

    def _check_clock(self) -> None:
        now_s = time.monotonic()
        self._check_age()
        if not self._age.is_newest_shown and not self._is_stale:
            left_s = LONGEST_S - self._age.age_s(now_s)
            self._clock.start(max(_LOOK_AGAIN_MS, math.ceil(left_s * 1000.0)))

    def _check_age(self) -> None:
        is_stale = self._age.is_stale(time.monotonic())
        if is_stale is not self._is_stale:
            self._is_stale = is_stale
            self.aged.emit()
