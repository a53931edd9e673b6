"""Searches for devices outside the GUI thread, because some drivers take seconds."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QObject, QThread, Signal

from armui.arm.device import Device


class DeviceSearch(QThread):
    """Looks for devices once.

    Args:
        simulated: The simulated arms, always listed first.
        find: Searches for devices; :func:`armui.bus.adapters.find_devices` by default.

    Signals:
        found: A list of :class:`Device`.
    """

    found = Signal(object)

    def __init__(
        self, simulated: Sequence[Device], find: Callable[[], list[Device]] | None = None
    ) -> None:
        super().__init__()
        self.setObjectName("device search")
        self._simulated = list(simulated)
        self._find = find

    def run(self) -> None:
        """Search in this thread, and emit `found` with the simulated devices first."""
        # python-can and its back-ends are loaded in this thread, so that the window need not wait.
        from armui.bus.adapters import find_devices  # noqa: PLC0415

        self.found.emit(self._simulated + (self._find or find_devices)())


class DeviceFinder(QObject):
    """Runs one search at a time and reports the devices found.

    Args:
        simulated: The simulated arms, always listed first.
        find: Searches for devices; by default with python-can and its plug-ins.

    Signals:
        found: A list of :class:`Device`.
        searching_changed: True if a search is under way, else false.
    """

    found = Signal(object)
    searching_changed = Signal(bool)

    def __init__(
        self,
        simulated: Sequence[Device],
        find: Callable[[], list[Device]] | None,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._simulated = list(simulated)
        self._find = find
        self._search: DeviceSearch | None = None

    def start(self) -> None:
        """Start a search, unless one is under way already."""
        if self._search is not None:
            return
        # without a parent: a search that a driver keeps from ending must not be destroyed
        self._search = DeviceSearch(self._simulated, self._find)
        self._search.found.connect(self.found)
        self._search.finished.connect(self._on_finished)
        self.searching_changed.emit(True)
        self._search.start()

    def end(self, within_s: float) -> bool:
        """Wait for the search to end; return whether it has ended within the time."""
        return self._search is None or self._search.wait(round(1e3 * within_s))

    def _on_finished(self) -> None:
        if self._search is not None:
            self._search.deleteLater()
            self._search = None
        self.searching_changed.emit(False)
