"""The bus worker without its threads: it sends and receives when it is told to.

The fuzz is about what is said and when. That threads do not get in each other's way is shown
elsewhere; here they would cost most of the time, and the order of things.
"""

from __future__ import annotations

import logging
from contextlib import AbstractContextManager
from typing import Final

import can

from armui.bus.link import BusHealth, BusState
from armui.bus.worker import BusWorker

_LOG: Final = logging.getLogger("armui.bus.worker")
_REOPEN_S: Final = 0.5


class LockstepWorker(BusWorker):
    """Opens its device when it is started, and lives by `pump`."""

    _context: AbstractContextManager[can.BusABC] | None = None
    _bus: can.BusABC | None = None
    _was_open = False
    _ended = False
    _reopen_s = 0.0

    def start(self, *_: object) -> None:
        """Open the device."""
        self._report(BusState.OPENING)
        self._open()

    def close(self, within_ms: int = 0) -> bool:
        """Close the device."""
        if not self._ended:
            self._ended = True
            self._leave()
            self._report(BusState.CLOSED)
        return True

    def isFinished(self) -> bool:  # noqa: N802 - Qt's name
        """There is no thread that could go on."""
        return self._ended

    def wait(self, *_: object) -> bool:
        """Nothing to wait for."""
        return True

    def pump(self) -> bool:
        """Send and take in what there is; whether anything has moved."""
        if self._ended:
            return False
        if self._bus is None:
            if not self._was_open or self._clock() < self._reopen_s:
                return False
            return self._open()
        frames = self._processor._tracker._frames
        waited = not self._outbox.empty
        try:
            self._processor.apply_codec(self._clock())
            self._outbox.send_waiting()
            self._receive_burst(self._bus)
            self._look_after_bus()
        except Exception as error:  # noqa: BLE001 - as the worker itself does
            self._lose(error)
            return True
        return waited or self._processor._tracker._frames != frames

    def _open(self) -> bool:
        try:
            self._context = self._opener(self._device)
            self._bus = self._context.__enter__()
        except Exception as error:  # noqa: BLE001 - as the worker itself does
            self._lose(error)
            return False
        self._was_open = True
        self._outbox.attach(self._bus)
        self._health, self._problem = BusHealth(self._device), None
        self._report(BusState.OPEN)
        return True

    def _lose(self, error: Exception) -> None:
        if self._was_open and not isinstance(error, (can.CanError, OSError)):
            _LOG.error("%s is lost", self._device.name, exc_info=error)  # no adapter raises it
        self._leave()
        self._reopen_s = self._clock() + _REOPEN_S
        if not self._was_open:
            self._ended = True
        self._report(BusState.LOST if self._was_open else BusState.FAILED, error)

    def _leave(self) -> None:
        self._outbox.detach()
        context, self._context, self._bus = self._context, None, None
        if context is not None:
            context.__exit__(None, None, None)
