"""The rig with the program's bus thread taken into the test's own: for thousands of motions.

`tests.arm_rig` waits for two threads at each step, which costs most of its time, and on a busy
computer all of it. Here the same worker receives and sends when time passes. What the threads
promise is no matter of this rig.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager

import can
from can.interfaces.virtual import VirtualBus
from PySide6.QtCore import QCoreApplication

from armui.arm.device import Device
from armui.bus.link import BusHealth, BusState
from armui.bus.worker import BusWorker
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.telemetry.listener import Listener
from tests.arm_rig import ArmRig

_ROUNDS = 50


class _PromptBus(VirtualBus):
    """A virtual bus that is never waited at."""

    def recv(self, timeout: float | None = None) -> can.Message | None:
        return super().recv(0)


class InlineWorker(BusWorker):
    """The bus thread's work, done when it is told to."""

    _bus: can.BusABC | None = None

    def start(self, *_priority: object) -> None:
        """Open the device at the next :meth:`pump`."""
        self._stack = ExitStack()
        self._report(BusState.OPENING)

    def pump(self) -> None:
        """Send what waits, and take in what there is."""
        if self._closing.is_set():
            return
        if self._bus is None:
            self._begin()
        bus = self._bus
        assert bus is not None
        self._outbox.send_waiting()
        self._processor.apply_codec(self._clock())
        self._receive_burst(bus)
        self._outbox.send_waiting()
        self._look_after_bus()

    @property
    def at_rest(self) -> bool:
        """Whether nothing is to be sent or taken in."""
        return self._closing.is_set() or (self._bus is not None and self.idle and self._empty)

    @property
    def _empty(self) -> bool:
        return self._bus.queue.empty() and not self._processor._next_codecs

    def _begin(self) -> None:
        self._bus = self._stack.enter_context(self._opener(self._device))
        self._queue.attach(self._bus)
        self._outbox.attach(self._bus)
        self._health, self._problem = BusHealth(self._device), None
        self._notifier.open(self._processor.codec, self._device.bitrate)
        self._received.emptied()
        self._report(BusState.OPEN)

    def close(self, within_ms: int) -> bool:
        """Close the device."""
        self._closing.set()
        if self._bus is not None:
            self._notifier.flush(self._processor.codec, self._clock())
            self._outbox.detach()
            self._queue.detach()
            self._stack.close()
        self.released.set()
        return True

    def isFinished(self) -> bool:  # noqa: N802 - Qt's name
        """Whether the device is closed."""
        return self.released.is_set()

    def wait(self, *_deadline: object) -> bool:
        """Wait for no thread."""
        return True


class InlineRig(ArmRig):
    """See :class:`tests.arm_rig.ArmRig`."""

    def __init__(self, channel: str, generation: Generation = Generation.TWO) -> None:
        super().__init__(channel, generation)
        self._inline: InlineWorker | None = None
        self.controller._connection._make_worker = self._make_worker

    def _make_worker(
        self, device: Device, codec: Codec, number: int, listeners: Sequence[Listener]
    ) -> InlineWorker:
        self._inline = InlineWorker(
            *(device, self._open, codec, lambda: self.time_s),
            listen_only=device.listen_only,
            number=number,
            listeners=listeners,
        )
        return self._inline

    @contextmanager
    def _open(self, device: Device) -> Iterator[can.BusABC]:
        with _PromptBus(str(device.channel)) as bus:
            yield bus

    def _settle_what_was_said(self) -> None:
        """As below; no time has passed: nothing is to be taken in if nobody spoke since."""
        QCoreApplication.processEvents()
        if self._inline is None or not self._inline.at_rest:
            self._settle()

    def _settle(self) -> None:
        for _ in range(_ROUNDS):
            if self._inline is not None:
                self._inline.pump()
            self._put_off_tick()
            QCoreApplication.processEvents()
            if self._inline is None or self._inline.at_rest:
                return
        raise AssertionError("there is always something more to say")


@contextmanager
def inline_rig(channel: str, *, repeats: bool = False) -> Iterator[InlineRig]:
    """Make such a rig, and close it at the end.

    Args:
        channel: Of the virtual bus.
        repeats: True for an arm that tells everything as often as a real one.
    """
    rig = InlineRig(channel)
    if not repeats:
        rig.repeat_nothing()
    try:
        yield rig
    finally:
        rig.close()
