"""One search for devices at a time."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QObject, Signal

from armui.arm.device import Device
from armui.bus.search import DeviceSearch


class DeviceFinder(QObject):
    """Starts searches and tells what they found.

    Args:
        simulated: Arms made of software, listed first and always.
        find: The search itself; by default python-can's and its plug-ins'.

    Signals:
        found: A list of :class:`Device`.
        searching_changed: Whether a search is under way.
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
        """Search, unless a search is under way already."""
        if self._search is not None:
            return
        # without a parent: a search that a driver keeps from ending must not be destroyed
        self._search = DeviceSearch(self._simulated, self._find)
        self._search.found.connect(self.found)
        self._search.finished.connect(self._on_finished)
        self.searching_changed.emit(True)
        self._search.start()

    def end(self, within_s: float) -> bool:
        """Wait for a search to end; returns whether it has within a time."""
        return self._search is None or self._search.wait(round(1e3 * within_s))

    def _on_finished(self) -> None:
        if self._search is not None:
            self._search.deleteLater()
            self._search = None
        self.searching_changed.emit(False)
