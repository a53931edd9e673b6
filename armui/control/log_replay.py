"""A replayed log with a controller of its own, which watches it like an arm."""

from __future__ import annotations

import atexit
import weakref
from datetime import datetime
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, QTimer, Signal

from armui.arm.device import Device, RecordedArm
from armui.bus.playback.curve_history import CurveHistory, is_own_command
from armui.bus.playback.log_cursor import LogClock, LogCursor
from armui.bus.playback.log_player import FILLED_S
from armui.bus.playback.log_worker import FASTEST, SLOWEST, LogWorker
from armui.control.arm_controller import ArmController
from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec
from armui.protocol.firmware_version import FirmwareVersion
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation, PiperModel
from armui.system.clock import local_time
from armui.telemetry.bus_statistics import BusStatistics
from armui.telemetry.series import KEPT_S

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from contextlib import AbstractContextManager
    from typing import NoReturn

    from armui.bus.playback.log_cursor import ReplayedFrame
    from armui.session.frames import Channel
    from armui.session.session import Session
    from armui.telemetry.listener import Listener

_AROUND_S: Final = (0.3, 3.0, 60.0)
"""The times before a moment to read, and half as much after it; the next one if too few."""
_ENOUGH_FRAMES: Final = 200
_FILL_AFTER_MS: Final = 120
"""Curves are filled once the operator has stayed at one time for this long."""


class LogReplay(QObject):
    """Plays a log without any bus: every command is refused.

    Args:
        session: The log; its opener closes it after :meth:`close`.
        channel: The channel that is shown.
        arm: The facts on the arm in the log.
        name: The name shown to the operator.
        parent: The parent object.

    Attributes:
        session, channel: As given.
        clock: Returns the log time, which moves only with the replay.
        controller: Watches the log.
        whole: Reads the curves of the whole log, once they are wanted.

    Signals:
        moved: The replay is at another time, or was started or paused.
        failed: The log cannot be read any more; with the error.
    """

    moved = Signal()
    failed = Signal(str)

    def __init__(
        self,
        session: Session,
        channel: Channel,
        arm: RecordedArm,
        name: str,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self.session = session
        self._arm = arm
        self.clock = LogClock(session.start_s)
        self.channel = channel
        self._device = Device(
            "replay",
            name,
            None,
            name,
            listen_only=True,
            recorded=arm,
            model=arm.model or PiperModel.PIPER,
        )
        self._worker: LogWorker | None = None
        self._forgotten: weakref.finalize[..., LogReplay] | None = None
        self._going_to: float | None = None
        self._number = 0
        self._curves_are_seen = True
        self.whole: CurveHistory | None = None
        self.controller = ArmController(
            _no_device,
            clock=self.clock,
            parent=self,
            wall=_wall,
            make_worker=self._make_worker,
        )
        if arm.tool:
            self.controller.cell.use_own_tool(arm.tool)
        self._fill_timer = QTimer(self, singleShot=True, interval=_FILL_AFTER_MS)
        self._fill_timer.timeout.connect(self._fill)

    def _make_worker(
        self, device: Device, codec: Codec, number: int, listeners: Sequence[Listener]
    ) -> LogWorker:
        worker = LogWorker(
            device,
            codec,
            self.session,
            self.channel,
            self.clock,
            number=number,
            listeners=listeners,
        )
        worker.found.connect(self._on_found)
        worker.moved.connect(self._on_moved)
        worker.failed.connect(self.failed)
        self._worker = worker
        # The thread ends even if nobody closes the replay, when its window is destroyed or the
        # program ends.
        self._forgotten = weakref.finalize(self, _end, worker)
        # At exit this may run after Qt's own clean-up, which aborts a program whose thread still
        # runs.
        self._forgotten.atexit = False
        atexit.register(worker.end_in_time)
        return worker

    def open(self) -> None:
        """Open the log at its beginning, paused."""
        self.controller.connect_device(self._device)
        self.go_to(self.session.start_s)

    def close(self) -> bool:
        """End the thread that plays and return whether it has ended within two seconds."""
        self._fill_timer.stop()
        if self.whole is not None:
            self.whole.end(wait=True)
        self._worker = None
        ended = self.controller.shutdown()
        if ended and self._forgotten is not None:
            forgotten = self._forgotten.detach()
            if forgotten is not None:
                atexit.unregister(forgotten[2][0].end_in_time)
        return ended

    # Position and state -----------------------------------------------------------------------

    @property
    def position_s(self) -> float:
        """The log time that is shown, or that the replay is going to."""
        return self.clock() if self._going_to is None else self._going_to

    @property
    def is_playing(self) -> bool:
        """True if the log runs."""
        return self._worker is not None and self._worker.is_playing

    @property
    def is_travelling(self) -> bool:
        """True if another time is being gone to."""
        return self._going_to is not None

    @property
    def is_at_end(self) -> bool:
        """True if the replay is at the end of the log."""
        return self.position_s >= self.session.end_s

    @property
    def last_frame(self) -> ReplayedFrame | None:
        """The frame that was processed last."""
        return None if self._worker is None else self._worker.last

    @property
    def speed(self) -> float:
        """The speed: log seconds per second."""
        return 1.0 if self._worker is None else self._worker.speed

    @property
    def loading(self) -> tuple[float, float, float] | None:
        """The log times of the curves being read, from and to, with the share done, or ``None``."""
        worker = self._worker
        history = None if worker is None else worker.history
        if worker is None or history is None:
            return None
        share = (history.reached_s - history.begin_s) / max(history.end_s - history.begin_s, 1e-9)
        return history.begin_s, min(worker.curves_from_s, history.end_s), share

    # Reading beside the replay ----------------------------------------------------------------

    def read_whole(self, longest_s: float, then: Callable[[], object]) -> CurveHistory:
        """Return the curves of the whole log, which a thread of their own reads meanwhile.

        Args:
            longest_s: The longest time to read; of a longer log the end is read.
            then: Called in another thread once they are read.
        """
        session = self.session
        begin_s = max(session.start_s, session.end_s - longest_s)
        telemetry = self.controller.telemetry.alike(
            lambda: session.end_s, max(session.end_s - begin_s, KEPT_S)
        )
        times_s = begin_s, session.end_s
        self.whole = CurveHistory(session, self.channel, telemetry, times_s, then)
        return self.whole

    def read_around(self, at_s: float) -> tuple[BusStatistics, float, float]:
        """Read the frames around a time; for a thread that may wait for the disk.

        Args:
            at_s: Log time.

        Returns:
            The statistics with the frames, and the log times from and to which they are complete.
        """
        arm, cursor = self._arm, LogCursor(self.session, self.channel)
        firmware = FirmwareVersion.parse(arm.firmware)
        codec = Codec(Generation(arm.generation), Addressing(arm.feedback_offset), firmware)
        for before_s in _AROUND_S:
            begin_s, end_s = at_s - before_s, at_s + before_s / 2.0
            pieces = list(cursor.columns_between(begin_s, end_s))
            if sum(map(len, pieces)) >= _ENOUGH_FRAMES:
                break
        statistics = BusStatistics(lambda: at_s)
        statistics.on_codec(codec)
        for piece in pieces:
            for row in range(len(piece)):
                frame = Frame(
                    int(piece.ids[row]), piece.payloads[row, : piece.lengths[row]].tobytes()
                )
                flags = int(piece.flags[row])
                heard = (codec.decode(frame), float(piece.times_s[row]), frame, flags)
                own = is_own_command(frame.arbitration_id, flags)
                (statistics.on_sent if own else statistics.on_heard)([heard])
        while not statistics.count_waiting():
            pass
        return statistics, begin_s, end_s

    # The operator's wishes --------------------------------------------------------------------

    def want_curves(self, back_s: float) -> None:
        """Have the curves reach this far back from any time; above some minutes it takes seconds.

        With 0 nothing is read for them until the log is played.
        """
        if self._worker is None:
            return
        self._curves_are_seen = back_s > 0.0
        if self._curves_are_seen and not self._fill_timer.isActive():
            self._fill_if_lacking()
        self._worker.want_history(on=back_s > FILLED_S)

    def set_speed(self, speed: float) -> None:
        """Set the speed of the replay, from 0.1 to 20 times as fast as it was."""
        if self._worker is not None:
            self._worker.speed = min(max(speed, SLOWEST), FASTEST)
            self.moved.emit()

    def play(self, *, on: bool) -> None:
        """Play or pause; at the end of the log play from its beginning."""
        if self._worker is None:
            return
        if on and self.is_at_end:
            self.go_to(self.session.start_s)
        if on:
            self._fill_if_lacking()
        self._worker.play(on=on)
        self.moved.emit()

    def step(self) -> None:
        """Pause and advance by one frame."""
        if self._worker is not None:
            self._fill_if_lacking()
            self._worker.step()

    def step_back(self) -> None:
        """Pause and go back to the frame before."""
        if self._worker is not None:
            self._worker.play(on=False)
            self._going_to = self.position_s
            self._number = self._worker.ask_for(None)

    def go_to(self, at_s: float) -> None:
        """Go to another time of the log."""
        if self._worker is not None:
            self._fill_timer.stop()
            self._going_to = min(max(at_s, self.session.start_s), self.session.end_s)
            self._number = self._worker.ask_for(self._going_to)
            self.moved.emit()

    # Reports of the thread --------------------------------------------------------------------

    def _on_found(self, number: int) -> None:
        worker = self._worker
        if worker is None or number != self._number or not worker.enter(number):
            return
        self._going_to = None
        # A log holds the handshake's answers already: two ticks take all of them in.
        self.controller.tick()
        self.controller.tick()
        if worker.is_playing:
            self._fill()
        elif self._curves_are_seen:
            self._fill_timer.start()
        self.moved.emit()

    def _fill_if_lacking(self) -> None:
        if self._worker is not None and self._worker.lacks_curves:
            self._fill()

    def _fill(self) -> None:
        self._fill_timer.stop()
        if self._worker is not None and self._going_to is None:
            self._worker.fill_curves()

    def _on_moved(self) -> None:
        if self._worker is not None and self._going_to is None:
            self.controller.tick()
            self.moved.emit()


def _end(worker: LogWorker) -> None:
    atexit.unregister(worker.end_in_time)
    worker.end_in_time()


def _wall(at_s: float) -> datetime:
    """Return the local time of a log time, which counts from 1970 or from the log's beginning."""
    return local_time(at_s) or datetime.fromtimestamp(0).astimezone()


def _no_device(_device: Device) -> AbstractContextManager[NoReturn]:
    raise RuntimeError("a log is replayed: there is no device to open")
