"""Reads the devices in a thread of its own, for which neither the window nor the bus waits."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable, Sequence
from operator import methodcaller
from typing import Final, Protocol

from armui.gamepad.device_state import DeviceInfo, DeviceSnapshot, DeviceState
from armui.system.clock import steady_s

_LOG: Final = logging.getLogger(__name__)

_PERIOD_S: Final = 0.004
"""The period of reading, twice as short as a USB device's reports: a press of the stop waits for
the next one.
"""
_IDLE_S: Final = 0.25
"""The period while there is no device."""
_SCAN_S: Final = 2.0
_END_S: Final = 2.0

OnButtons = Callable[[DeviceInfo, frozenset[str], frozenset[str]], None]
"""Called in the reader's thread with a device, the pressed buttons and the released ones."""


class DeviceBackend(Protocol):
    """Reads the devices of one kind; created and used in one thread only.

    Attributes:
        package: The package it needs.
        unusable: The names of devices found that cannot be used.
    """

    package: str
    unusable: tuple[str, ...]

    def open(self) -> None:
        """Load the library.

        Raises:
            ImportError: The library is not installed.
            OSError: The library does not work here.
        """
        ...

    def scan(self) -> None:
        """Search for new devices; may take some tenths of a second."""
        ...

    def read(self, now_s: float) -> tuple[DeviceState, ...]:
        """Return the present state of the devices, without those that are gone; never waits.

        Args:
            now_s: The time by the program's clock.
        """
        ...

    def close(self) -> None:
        """Release the devices and the library."""
        ...


class Reader(Protocol):
    """The interface of a device reader."""

    @property
    def latest(self) -> DeviceSnapshot:
        """The devices as last read."""
        ...

    @property
    def running(self) -> bool:
        """True until the reader has ended."""
        ...

    def stop(self) -> None:
        """Ask the reader to stop; does not wait for it."""
        ...

    def end(self) -> bool:
        """Stop reading, wait a moment, and return whether the reader has ended."""
        ...


class DeviceReader:
    """Reads until :meth:`end`; errors are reported in the snapshot, and end nothing.

    No press of a button is missed, however short: each one is reported.

    Args:
        backends: The back-ends, created in the caller's thread but used only in the reader's.
        on_buttons: Called at each press and release.
        clock: Monotonic time in seconds.
    """

    def __init__(
        self,
        backends: Sequence[DeviceBackend],
        on_buttons: OnButtons,
        clock: Callable[[], float] = steady_s,
    ) -> None:
        self._backends = tuple(backends)
        self._on_buttons = on_buttons
        self._clock = clock
        self._latest = DeviceSnapshot(clock())
        self._before: dict[str, DeviceState] = {}
        self._missing: tuple[str, ...] = ()
        self._problems: dict[tuple[str, str], str] = {}
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._run, name="gamepads", daemon=True)
        self._thread.start()

    @property
    def latest(self) -> DeviceSnapshot:
        """The devices as last read."""
        return self._latest

    @property
    def running(self) -> bool:
        """True if the thread runs."""
        return self._thread.is_alive()

    def stop(self) -> None:
        """Ask the thread to stop."""
        self._ending.set()

    def end(self) -> bool:
        """Stop, and return whether the thread ended within a moment; a hanging one is left."""
        self.stop()
        self._thread.join(_END_S)
        return not self._thread.is_alive()

    # In the reader's thread -----------------------------------------------------------------------

    def _run(self) -> None:
        backends = [each for each in self._backends if self._opened(each)]
        scanned_s: float | None = None
        try:
            while not self._ending.is_set():
                now_s = self._clock()
                due = scanned_s is None or now_s - scanned_s >= _SCAN_S
                if due and not any(each.buttons for each in self._latest.devices):
                    self._each(backends, "scan")
                    scanned_s = now_s
                self._read(backends)
                self._ending.wait(_PERIOD_S if self._latest.devices else _IDLE_S)
        finally:
            self._each(backends, "close")

    def _opened(self, backend: DeviceBackend) -> bool:
        try:
            backend.open()
        except ImportError:
            self._missing = (*self._missing, backend.package)
        except Exception as error:  # noqa: BLE001 - from another's library: its message is shown
            self._note(backend, "open", error)
        else:
            return True
        return False

    def _each(self, backends: Sequence[DeviceBackend], step: str) -> None:
        for backend in backends:
            try:
                methodcaller(step)(backend)
            except Exception as error:  # noqa: BLE001 - as above
                self._note(backend, step, error)
            else:
                self._problems.pop((backend.package, step), None)

    def _read(self, backends: Sequence[DeviceBackend]) -> None:
        now_s = self._clock()
        states: list[DeviceState] = []
        for backend in backends:
            try:
                states += backend.read(now_s)
            except Exception as error:  # noqa: BLE001 - as above: its devices count as gone
                self._note(backend, "read", error)
            else:
                self._problems.pop((backend.package, "read"), None)
        self._latest = DeviceSnapshot(
            now_s,
            tuple(states),
            tuple(name for each in backends for name in each.unusable),
            self._missing,
            tuple(self._problems.values()),
        )
        before, self._before = self._before, {each.info.key: each for each in states}
        for state in states:
            # buttons that are down when a device appears are not reported as pressed
            old = before.get(state.info.key, state)
            if old.buttons != state.buttons:
                down, up = state.buttons - old.buttons, old.buttons - state.buttons
                self._on_buttons(state.info, down, up)

    def _note(self, backend: DeviceBackend, step: str, error: Exception) -> None:
        text = f"{backend.package}: {error or type(error).__name__}"
        if self._problems.get((backend.package, step)) != text:
            _LOG.warning("Devices: %s of %s failed", step, text, exc_info=error)
        self._problems[backend.package, step] = text


def read_devices(on_buttons: OnButtons, clock: Callable[[], float]) -> Reader:
    """Start reading devices of every kind for which there is a library."""
    from armui.gamepad.sdl_gamepads import SdlGamepads  # noqa: PLC0415 - loaded when switched on
    from armui.gamepad.space_mice import SpaceMice  # noqa: PLC0415 - as above

    return DeviceReader((SdlGamepads(), SpaceMice()), on_buttons, clock)
