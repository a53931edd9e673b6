"""The choice of a device and of its arm's model, before connecting."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QLabel, QWidget

from armui.arm.device import Device
from armui.arm.models import all_models, model_data
from armui.control.link.link_state import LinkState
from armui.protocol.generation import PiperModel
from armui.ui import words
from armui.ui.format import NOTHING
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import fill, in_row
from armui.ui.widgets.table_model import Index, TableModel
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.control.operating_state import OperatingState
    from armui.ui.dialogs.kept_models import KeptModels


_ICON_PX: Final = 16
LINE_GAP_PX: Final = 8
"""The gap between label, field and note, and between the lines below."""
STATE, KIND, CHANNEL, SERIAL, BITRATE = range(5)

_KINDS: Final = {
    "socketcan": "SocketCAN",
    "gs_usb": "candleLight (gs_usb)",
    "slcan": "slcan",
    "udp_multicast": "UDP multicast",
    "pcan": "PCAN",
}
"""The common name of a back-end, if it differs from python-can's."""


def same_device(one: Device, other: Device | None) -> bool:
    """Return whether two entries are one device; the bit rate does not matter."""
    return other is not None and _key(one) == _key(other)


def _key(device: Device) -> tuple[object, ...]:
    return (device.interface, str(device.channel), device.simulated, device.generation)


class DeviceModel(TableModel):
    """The devices found, entered and connected, each once, a row for each."""

    _columns = BITRATE + 1

    def __init__(self) -> None:
        super().__init__()
        self._found: list[Device] = []
        self._typed: list[Device] = []
        self._rows: list[Device] = []
        self._connected: Device | None = None
        self._link = LinkState.NO_DEVICE

    def show_found(self, devices: Sequence[Device]) -> None:
        """Replace the devices of the last search."""
        self._found = list(devices)
        self._rebuild()

    def add(self, device: Device) -> int:
        """Add a device that was entered, and return its row."""
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
        """Return the device of a row, or ``None`` if there is no such row."""
        return self._rows[row] if 0 <= row < len(self._rows) else None

    def row_of(self, device: Device | None) -> int:
        """Return the row of a device, or −1 if it has none."""
        rows = (row for row, known in enumerate(self._rows) if same_device(known, device))
        return next(rows, -1)

    def _rebuild(self) -> None:
        rows: list[Device] = []
        connected = [self._connected] if self._connected is not None else []
        every = [*self._found, *self._typed, *connected]
        for device in sorted(
            every, key=lambda device: device.simulated
        ):  # real devices come before the simulated arm
            if all(not same_device(device, known) for known in rows):
                rows.append(device)
        if rows == self._rows:
            self.redraw()
            return
        self.beginResetModel()
        self._rows = rows
        self.endResetModel()

    # The model's interface for Qt -------------------------------------------------------------

    def titles(self) -> Sequence[str]:
        """Return the titles: state, kind, channel, serial number, bit rate."""
        return (
            self.tr("State"),
            self.tr("Kind"),
            self.tr("Channel"),
            self.tr("Serial number"),
            self.tr("Bit rate"),
        )

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return the text of a cell; under ``UserRole`` whether its device is connected."""
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
        """Return the present bitrate of a connected device, or the one to open another with."""
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
    """Return a bit rate in the usual notation."""
    if bitrate is None:
        return NOTHING
    if bitrate % 1_000_000 == 0:
        return f"{bitrate // 1_000_000} Mbit/s"
    return f"{bitrate / 1000:g} kbit/s"


class ModelChoice(Translated, QWidget):
    """A list of the models, with a note on the choice.

    Args:
        kept: The models chosen for arms.

    Signals:
        chosen: Another model was chosen.
    """

    chosen = Signal()

    def __init__(self, kept: KeptModels) -> None:
        super().__init__()
        self._kept = kept
        self._by_hand = False
        self._device: Device | None = None
        self._now: OperatingState | None = None
        self._label = QLabel()
        self.box = named("model_box", QComboBox())
        for model, data in all_models().items():
            self.box.addItem(data.name, model)
        self._label.setBuddy(self.box)
        self.hint = text_label("model_hint", rank="muted", wraps=True)
        self._icon = QLabel()
        row = in_row(on=self, spacing=LINE_GAP_PX, margins=0)
        fill(row, self._label, self.box, 8, self._icon, (self.hint, 1))
        self.box.currentIndexChanged.connect(self._on_chosen)
        self.box.activated.connect(self._on_activated)
        self.retranslate_ui()

    @property
    def model(self) -> PiperModel:
        """The chosen model."""
        return PiperModel(self.box.currentData())

    @property
    def is_assumed(self) -> bool:
        """True if it was only offered, and the operator has not changed the list."""
        return not self._by_hand

    def show_device(self, device: Device | None, now: OperatingState) -> None:
        """Offer the model chosen for a device, in this connection or the last time.

        Args:
            device: The selected device.
            now: The present operating state.
        """
        self._device, self._now = device, now
        if device is None:
            return
        kept = self._kept.of(device) or PiperModel.PIPER
        shown = now.model if same_device(device, now.device) else kept
        self._by_hand = False
        self.box.setCurrentIndex(self.box.findData(shown))
        self._explain()

    def show_fit(self, device: Device | None, now: OperatingState) -> None:
        """Show the result of comparing the model with the arm's feedback."""
        self._device, self._now = device, now
        self._explain()

    def keep(self, device: Device) -> None:
        """Store the chosen model, because the device is about to be connected."""
        self._kept.keep(device)

    def _on_activated(self, _index: int) -> None:
        self._by_hand = True

    def _on_chosen(self) -> None:
        self._explain()
        self.chosen.emit()

    def _explain(self) -> None:
        now, device = self._now, self._device
        text, wrong = "", False
        if now is not None and device is not None and same_device(device, now.device):
            fit = now.model_fit
            text, wrong = self._of_connected(now), (fit.wrong or fit.before) is not None
        elif device is not None and device.simulated:
            text = self.tr("The simulated arm is this model.")
        self._icon.setVisible(wrong)
        if wrong:
            color, ratio = colors_of(self).warn, self.devicePixelRatioF()
            self._icon.setPixmap(icons.pixmap("warning", color, _ICON_PX, ratio))
        self.hint.setText(
            text or self.tr("No frame names the model: it is checked after connecting.")
        )

    def _of_connected(self, now: OperatingState) -> str:
        fit = now.model_fit
        if fit.wrong is not None and fit.other is not None:
            return self.tr(
                "The pose this arm reports is that of a {fits}: choose it and press Connect."
            ).format(fits=model_data(fit.other).name)
        if fit.wrong is not None:
            return self.tr("The pose this arm reports fits none of the models.")
        if fit.confirmed:
            return self.tr("Confirmed by the pose the arm reports.")
        if fit.fitting is not None:
            return self.tr("Fits the pose the arm reports; so do others. Move a joint to decide.")
        if fit.before is not None:
            return self.tr(
                "Last time this arm was a {before}: choose that and press Connect, or wait "
                "until the arm stands still and is checked."
            ).format(before=model_data(fit.before).name)
        return self.tr("Not checked yet: the arm must stand still.")

    def line_up(self, *labels: QLabel) -> None:
        """Give the labels of the rows below the same width as the one here."""
        column = (self._label, *labels)
        width = max(label.sizeHint().width() for label in column)
        for label in column:
            label.setFixedWidth(width)

    def _recolor(self) -> None:
        self._explain()

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        self._label.setText(self.tr("Model of the arm"))
        self.box.setAccessibleName(self.tr("Model of the arm"))
        self.box.setToolTip(
            self.tr(
                "Its lengths decide where the tool is. The limits of the joints are always read "
                "from the arm."
            )
        )
        self._explain()
