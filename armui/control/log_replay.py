"""A log that is replayed, with a controller of its own that watches it as it watches an arm."""

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
"""So long before a moment its frames are read, and half as long after it: longer where few are."""
_ENOUGH_FRAMES: Final = 200
_FILL_AFTER_MS: Final = 120
"""Curves are filled when the operator has come to rest somewhere."""


class LogReplay(QObject):
    """Plays a log. There is no bus in it, and no way to one: what is to be sent is refused.

    Args:
        session: The log; closed by whoever opened it, after :meth:`close`.
        channel: What is seen of it.
        arm: What it tells of its arm.
        name: What the operator knows it by.
        parent: Qt's.

    Attributes:
        session, channel: As given.
        clock: Log time; it moves only with the replay.
        controller: Watches the log.
        whole: Reads the curves of the whole log, once they are wanted.

    Signals:
        moved: The replay is elsewhere, or runs or stands still now.
        failed: The log cannot be read any more; what is wrong.
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
        # a window that is destroyed, a program that ends: whoever forgets to close it
        self._forgotten = weakref.finalize(self, _end, worker)
        # its own turn at the end may come after Qt's, which ends the program over such a thread
        self._forgotten.atexit = False
        atexit.register(worker.end_in_time)
        return worker

    def open(self) -> None:
        """Begin, standing still, at the beginning."""
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

    # Where it stands --------------------------------------------------------------------------

    @property
    def position_s(self) -> float:
        """Log time of what is seen, or of the place that is about to be."""
        return self.clock() if self._going_to is None else self._going_to

    @property
    def is_playing(self) -> bool:
        """True if the log runs."""
        return self._worker is not None and self._worker.is_playing

    @property
    def is_travelling(self) -> bool:
        """True if another place is being looked up."""
        return self._going_to is not None

    @property
    def is_at_end(self) -> bool:
        """True if nothing comes after what is seen."""
        return self.position_s >= self.session.end_s

    @property
    def last_frame(self) -> ReplayedFrame | None:
        """The frame that was taken in last."""
        return None if self._worker is None else self._worker.last

    @property
    def speed(self) -> float:
        """How much log time passes in a second."""
        return 1.0 if self._worker is None else self._worker.speed

    @property
    def loading(self) -> tuple[float, float, float] | None:
        """What of the curves is being read: log times from and to, and which share is done."""
        worker = self._worker
        history = None if worker is None else worker.history
        if worker is None or history is None:
            return None
        share = (history.reached_s - history.begin_s) / max(history.end_s - history.begin_s, 1e-9)
        return history.begin_s, min(worker.curves_from_s, history.end_s), share

    # Beside what is played --------------------------------------------------------------------

    def read_whole(self, longest_s: float, then: Callable[[], object]) -> CurveHistory:
        """Have the curves of the whole log read, whatever is played meanwhile.

        Args:
            longest_s: Of a longer log it is the end.
            then: Called, in another thread, when they are read.
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
            What has counted and kept them; and the log times from and to which it holds all.
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
        """Have the curves show so much before any place; more than some minutes take seconds.

        With nothing wanted, nothing is read for them until the log is played.
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
        """Let it run, or stand still; at the end it begins anew."""
        if self._worker is None:
            return
        if on and self.is_at_end:
            self.go_to(self.session.start_s)
        if on:
            self._fill_if_lacking()
        self._worker.play(on=on)
        self.moved.emit()

    def step(self) -> None:
        """Stand still, one frame further."""
        if self._worker is not None:
            self._fill_if_lacking()
            self._worker.step()

    def step_back(self) -> None:
        """Stand still, at the moment of the frame before."""
        if self._worker is not None:
            self._worker.play(on=False)
            self._going_to = self.position_s
            self._number = self._worker.ask_for(None)

    def go_to(self, at_s: float) -> None:
        """Be at another time of the log."""
        if self._worker is not None:
            self._fill_timer.stop()
            self._going_to = min(max(at_s, self.session.start_s), self.session.end_s)
            self._number = self._worker.ask_for(self._going_to)
            self.moved.emit()

    # What the thread tells --------------------------------------------------------------------

    def _on_found(self, number: int) -> None:
        worker = self._worker
        if worker is None or number != self._number or not worker.enter(number):
            return
        self._going_to = None
        # what an arm is asked when it comes is known here: two looks take all of it in
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
    """Log time counts from 1970, or from the beginning of the log where nobody noted more."""
    return local_time(at_s) or datetime.fromtimestamp(0).astimezone()


def _no_device(_device: Device) -> AbstractContextManager[NoReturn]:
    raise RuntimeError("a log is replayed: there is no device to open")
