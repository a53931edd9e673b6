"""The search for devices, off the GUI thread: some drivers take seconds to answer."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QThread, Signal

from armui.arm.device import Device


class DeviceSearch(QThread):
    """Looks for devices once.

    Args:
        simulated: Arms made of software, listed first and always.
        find: The search itself; :func:`armui.bus.adapters.find_devices` by default.

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
        """Search and report."""
        # python-can and its back-ends are loaded here, where nobody waits for them
        from armui.bus.adapters import find_devices  # noqa: PLC0415

        self.found.emit(self._simulated + (self._find or find_devices)())
