"""The devices of the connect dialog as a table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

from PySide6.QtCore import Qt

from armui.arm.device import Device
from armui.control.operating_state import LinkState
from armui.ui import words
from armui.ui.format import NOTHING
from armui.ui.widgets.table_model import Index, TableModel

STATE, KIND, CHANNEL, SERIAL, BITRATE = range(5)

_KINDS: Final = {
    "socketcan": "SocketCAN",
    "gs_usb": "candleLight (gs_usb)",
    "slcan": "slcan",
    "udp_multicast": "UDP multicast",
    "pcan": "PCAN",
}
"""How the world knows a back-end, where that is not python-can's own name for it."""


def same_device(one: Device, other: Device | None) -> bool:
    """Whether two entries are one device: the bit rate chosen does not make it another."""
    return other is not None and _key(one) == _key(other)


def _key(device: Device) -> tuple[object, ...]:
    return (device.interface, str(device.channel), device.simulated, device.generation)


class DeviceModel(TableModel):
    """Found, typed-in and connected devices, each once; a row a device."""

    _columns = BITRATE + 1

    def __init__(self) -> None:
        super().__init__()
        self._found: list[Device] = []
        self._typed: list[Device] = []
        self._rows: list[Device] = []
        self._connected: Device | None = None
        self._link = LinkState.NO_DEVICE

    def show_found(self, devices: Sequence[Device]) -> None:
        """Replace what the last search found."""
        self._found = list(devices)
        self._rebuild()

    def add(self, device: Device) -> int:
        """Add a device that was typed in; its row."""
        if all(not same_device(device, known) for known in self._rows):
            self._typed.append(device)
            self._rebuild()
        return self.row_of(device)

    def show_connected(self, device: Device | None, link: LinkState) -> None:
        """Mark the device that is connected."""
        if (device, link) == (self._connected, self._link):
            return
        is_other = device is not None and not same_device(device, self._connected)
        self._connected, self._link = device, link
        if is_other or device is None:
            self._rebuild()
        else:
            self.redraw()

    def device(self, row: int) -> Device | None:
        """The device of a row; ``None`` if there is no such row."""
        return self._rows[row] if 0 <= row < len(self._rows) else None

    def row_of(self, device: Device | None) -> int:
        """The row of a device; −1 if it has none."""
        rows = (row for row, known in enumerate(self._rows) if same_device(known, device))
        return next(rows, -1)

    def _rebuild(self) -> None:
        rows: list[Device] = []
        connected = [self._connected] if self._connected is not None else []
        every = [*self._found, *self._typed, *connected]
        for device in sorted(
            every, key=lambda device: device.simulated
        ):  # what is real comes first
            if all(not same_device(device, known) for known in rows):
                rows.append(device)
        if rows == self._rows:
            self.redraw()
            return
        self.beginResetModel()
        self._rows = rows
        self.endResetModel()

    # What Qt asks -----------------------------------------------------------------------------

    def titles(self) -> Sequence[str]:
        """State, kind, channel, serial number, bit rate."""
        return (
            self.tr("State"),
            self.tr("Kind"),
            self.tr("Channel"),
            self.tr("Serial number"),
            self.tr("Bit rate"),
        )

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """The words of a cell; under ``UserRole`` whether its device is connected."""
        device = self.device(index.row())
        if device is None:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return self._text(device, index.column())
        if role == Qt.ItemDataRole.ToolTipRole:
            return words.device_name(device)
        if role == Qt.ItemDataRole.UserRole:
            return same_device(device, self._connected)
        return None

    def _text(self, device: Device, column: int) -> str:
        if column == STATE:
            return self._state_text(device)
        if column == KIND:
            kind = _KINDS.get(device.interface, device.interface)
            return words.device_name(device) if device.simulated else kind
        if column == CHANNEL:
            return NOTHING if device.simulated else str(device.channel)
        if column == SERIAL:
            return device.serial or NOTHING
        return bitrate_text(self._bitrate(device))

    def _bitrate(self, device: Device) -> int | None:
        """What the device runs at if it is connected, else what it would be opened with."""
        if self._connected is not None and same_device(device, self._connected):
            return self._connected.bitrate
        return device.bitrate

    def _state_text(self, device: Device) -> str:
        if not same_device(device, self._connected):
            return ""
        return {
            LinkState.NO_DEVICE: "",
            LinkState.OPENING: self.tr("Connecting…"),
            LinkState.OFFLINE: self.tr("Offline"),
            LinkState.ONLINE: self.tr("Online"),
            LinkState.LOST: self.tr("Connection lost"),
        }[self._link]


def bitrate_text(bitrate: int | None) -> str:
    """A bit rate as CAN people write it."""
    if bitrate is None:
        return NOTHING
    if bitrate % 1_000_000 == 0:
        return f"{bitrate // 1_000_000} Mbit/s"
    return f"{bitrate / 1000:g} kbit/s"
