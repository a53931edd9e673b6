"""The thread that owns the bus: it receives, decodes, and publishes snapshots for the GUI.

Sending has a thread of its own (:mod:`armui.bus.outbox`): a driver that blocks in ``send`` holds
up neither the receiving nor the window.
"""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from typing import Final

import can
from PySide6.QtCore import QObject, QThread, Signal

from armui.arm.device import Device
from armui.arm.other_hosts import OtherTraffic
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.bus.adapters import explain
from armui.bus.frame_processor import FrameProcessor
from armui.bus.link import BUS_DEAF, BusHealth, BusReport, BusState
from armui.bus.outbox import KEEP_S, Outbox, SendingThread
from armui.bus.press import Press
from armui.bus.receive_clock import STAMPED, ReceiveClock
from armui.bus.receive_queue import ReceiveQueue
from armui.protocol.codec import Codec
from armui.protocol.commands import query_limits
from armui.protocol.frame import Frame, FrameFlag
from armui.system.clock import steady_s
from armui.system.failures import is_our_own
from armui.telemetry.listener import Listener
from armui.ways.passes import Pass

_MARKS_NEIGHBOURS: Final = frozenset({"socketcan"})
"""Back-ends that mark frames of other programs on the same PC as not received.

Linux sets MSG_DONTROUTE on every frame that was sent from this computer, by whichever program, and
python-can makes ``is_rx`` false of it. Our own frames do not come back at all: python-can opens the
socket without CAN_RAW_RECV_OWN_MSGS.
"""

_LOG: Final = logging.getLogger(__name__)

Opener = Callable[[Device], AbstractContextManager[can.BusABC]]
"""Opens a device; the bus is closed when the context ends."""

_RECEIVE_S: Final = 0.005
"""The longest wait for a frame before the thread does its other work."""

_BURST: Final = 256
"""The most frames processed before the thread does its other work."""

_PICTURE_S: Final = 0.005
"""The least time between two snapshots of the arm: the screen shows one every 16 ms."""

_LAST_S: Final = 0.5
"""A device that is closed may take this long for a stop, or for the end of a motion."""

_REOPEN_S: Final = 0.5
"""A lost device is tried again after this time."""


def is_own_echo(message: can.Message, interface: str) -> bool:
    """Return whether a frame is one of ours that the adapter hands back."""
    return not message.is_rx and interface not in _MARKS_NEIGHBOURS


class BusWorker(QThread):
    """Owns one device from connecting to disconnecting.

    Args:
        device: The device to open.
        opener: The function that opens it.
        codec: The protocol to begin with; see :meth:`use_codec`.
        clock: Monotonic time in seconds.
        listen_only: Only urgent frames are sent: the operator's stop.
        number: The number of this thread in its reports, by which a late report is recognised.
        listeners: Objects that are told of every frame.

    Attributes:
        samples: Every joint feedback, while they are wanted.
        released: Set once the device is closed for good.

    Signals:
        reported: A :class:`BusReport`, whenever the state of the device changes.
        answered: A :class:`Message` of :data:`armui.bus.frame_processor.ANSWERS`.
    """

    reported = Signal(object)
    answered = Signal(object)

    def __init__(
        self,
        device: Device,
        opener: Opener,
        codec: Codec,
        clock: Callable[[], float] = steady_s,
        parent: QObject | None = None,
        *,
        listen_only: bool = False,
        number: int = 0,
        listeners: Sequence[Listener] = (),
    ) -> None:
        super().__init__(parent)
        self.setObjectName(f"bus {device.name}")
        self._number = number
        self._device = device
        self._opener = opener
        self._clock = clock
        self._pictured_s = 0.0
        self._processor = FrameProcessor(codec, listeners, self.answered.emit)
        self._notifier = self._processor.notifier
        self._outbox = Outbox(clock, listen_only=listen_only, sent=self._notifier.sent)
        self._health = BusHealth(device)
        self._problem: Refusal | None = None
        self._queue = ReceiveQueue()
        self._received = ReceiveClock(clock, stamped=device.interface in STAMPED)
        self.samples = self._processor.samples
        self._closing = threading.Event()
        self.released = threading.Event()

    @property
    def idle(self) -> bool:
        """True if nothing waits to be sent."""
        return self._outbox.empty

    @property
    def state(self) -> ArmState:
        """The arm's state from frames heard since the last :meth:`use_codec`, for any thread."""
        return self._processor.state

    @property
    def traffic(self) -> OtherTraffic:
        """Frames heard from other hosts; may be read from any thread."""
        return self._processor.traffic

    @property
    def frames_dropped(self) -> int:
        """The number of frames lost before the program could read them, as far as is known."""
        return self._queue.dropped

    def send(
        self,
        frames: Sequence[Frame],
        keep_s: float | None = None,
        command: int | None = None,
        passed: Pass | None = None,
        press: Press | None = None,
    ) -> bool:
        """Queue frames in order; false if the device is not open; see :meth:`Outbox.put`."""
        keep_s = KEEP_S if keep_s is None else keep_s
        return self._outbox.put(frames, keep_s, command, passed, press)

    def holds(self, command: int) -> bool:
        """Return whether a frame of a command is not out yet; see :meth:`Outbox.holds`."""
        return self._outbox.holds(command)

    def void(self, newest: int) -> None:
        """Drop waiting batches of commands older than this one; see :meth:`Outbox.void`."""
        self._outbox.void(newest)

    def send_urgent(self, frames: Sequence[Frame]) -> bool:
        """Send at once, ahead of all that waits; return as :meth:`Outbox.put_urgent` does."""
        return self._outbox.put_urgent(frames)

    def set_listeners(self, listeners: Sequence[Listener]) -> None:
        """Replace the listeners that are told of every frame."""
        self._notifier.set_listeners(listeners)

    def use_codec(self, codec: Codec, *, forget: bool = True) -> None:
        """Use this codec from the next frame on; forget what was heard unless told otherwise.

        See :meth:`armui.bus.frame_processor.FrameProcessor.use_codec`.
        """
        self._processor.use_codec(codec, forget=forget)

    def close(self, within_ms: int) -> bool:
        """Close the device and end the thread.

        Args:
            within_ms: The time to wait for it.

        Returns:
            True if both are done. Otherwise a driver is busy: the device is closed as soon as its
            call returns, and nothing more is sent to it.
        """
        self._closing.set()
        return self.wait(within_ms)

    def run(self) -> None:
        """Open the device, use it, and reopen it after a loss, until :meth:`close`."""
        try:
            self._run()
        finally:
            self.released.set()

    def _run(self) -> None:
        self._report(BusState.OPENING)
        was_open = False
        while not self._closing.is_set():
            try:
                with self._opener(self._device) as bus:
                    was_open = True
                    self._use(bus)
            except Exception as error:  # noqa: BLE001 - third-party drivers raise anything; go on
                # A device that is unplugged is no failure of the program; an error in its own code
                # is one, and is told (S23).
                level = logging.ERROR if was_open and is_our_own(error) else logging.WARNING
                _LOG.log(level, "%s is lost", self._device.name, exc_info=error)
                state = BusState.LOST if was_open else BusState.FAILED
                self._report(state, error)
                if not was_open:
                    return
                self._closing.wait(_REOPEN_S)
        self._report(BusState.CLOSED)

    def _use(self, bus: can.BusABC) -> None:
        self._queue.attach(bus)
        self._outbox.attach(bus, threaded=True)
        self._health, self._problem = BusHealth(self._device), None
        sender = SendingThread(self._outbox, bus)
        sender.start()
        self._notifier.open(self._processor.codec, self._device.bitrate)
        self._received.emptied()  # a device that was just opened holds no old frames
        self._report(BusState.OPEN)
        try:
            while not self._closing.is_set():
                self._processor.apply_codec(self._clock())
                self._receive_burst(bus)
                if sender.failure is not None:
                    raise sender.failure
                self._look_after_bus()
            self._outbox.let_urgent_out(_LAST_S)
        finally:
            self._notifier.flush(self._processor.codec, self._clock())
            self._outbox.detach()
            sender.end()
            self._queue.detach()

    def _look_after_bus(self) -> None:
        """Report when no frame can be sent or received any more, and when it works again."""
        now_s, blocked = self._clock(), self._outbox.blocked
        if self._health.follow_silence(now_s, self._outbox.frames_out) and not blocked:
            self._outbox.put(query_limits(self._processor.codec, 1))
        problem = self._health.problem(now_s, blocked=blocked)
        if problem != self._problem:
            self._problem = problem
            deaf = problem is not None and problem.reason == BUS_DEAF
            state = BusState.DEAF if deaf else BusState.BLOCKED
            state = BusState.OPEN if problem is None else state
            self.reported.emit(BusReport(state, self._device, problem, self._number))

    def _receive_burst(self, bus: can.BusABC) -> None:
        message = bus.recv(_RECEIVE_S)
        self._received.begin()  # after the wait, which is short unless the thread was delayed
        now_s = self._clock()
        taken = 0
        while message is not None:
            self._processor.apply_codec(now_s)
            self._take_in(message, self._received.at_s(message.timestamp, now_s))
            taken += 1
            if taken == _BURST:
                break
            message = bus.recv(0)
        else:
            self._received.emptied()
        if now_s - self._pictured_s >= _PICTURE_S or taken == 0:
            # Frames of a real bus come one by one; telling listeners of several together saves
            # time.
            self._pictured_s = now_s
            self._notifier.flush(self._processor.codec, now_s)
            self._processor.publish()
            self._queue.poll(now_s)

    def _take_in(self, message: can.Message, now_s: float) -> None:
        if is_own_echo(message, self._device.interface):
            return
        if message.is_error_frame:
            self._health.on_error_frame(message.arbitration_id)
            self._queue.note_error(message)
        elif message.is_rx:  # frames of this computer do not prove reception
            self._health.on_frame(now_s)
        odd = message.is_error_frame or message.is_extended_id or message.is_remote_frame
        frame = Frame(message.arbitration_id, bytes(message.data))
        self._processor.process(frame, now_s, _flags(message) if odd else 0)

    def _report(self, state: BusState, error: Exception | None = None) -> None:
        problem = None if error is None else explain(self._device, error)
        self.reported.emit(BusReport(state, self._device, problem, self._number))


def _flags(message: can.Message) -> int:
    flags = FrameFlag.EXTENDED if message.is_extended_id else FrameFlag(0)
    if message.is_remote_frame:
        flags |= FrameFlag.REMOTE
    if message.is_error_frame:
        flags |= FrameFlag.ERROR
    return flags | FrameFlag.FD if message.is_fd else flags


def opener_after(before: Sequence[threading.Event], opener: Opener) -> Opener:
    """Return an opener that first waits until other threads have closed the same device.

    Args:
        before: Set by the threads that are ending, each when its device is closed. The threads
            themselves may be gone by then.
        opener: The function that opens it.
    """

    def open_device(device: Device) -> AbstractContextManager[can.BusABC]:
        for released in before:
            released.wait()
        return opener(device)

    return open_device if before else opener
