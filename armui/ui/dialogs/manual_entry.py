"""Naming a device that no search can find: a network bus, or an adapter on a given serial port."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QLabel, QLineEdit, QWidget

from armui.arm.device import DEFAULT_BITRATE, Device, bitrate_is_ours
from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.translated import Translated


class ManualEntry(Translated, QWidget):
    """Interface and channel as python-can names them.

    Args:
        interfaces: The back-ends to offer; others can be typed.

    Signals:
        entered: The :class:`Device` that was named.
    """

    entered = Signal(object)

    def __init__(self, interfaces: Sequence[str]) -> None:
        super().__init__()
        self.interface_label = QLabel()
        self.interface_box = QComboBox()
        self.interface_box.setEditable(True)
        self.interface_box.addItems(list(interfaces))
        self.interface_box.setCurrentText("slcan")
        self.interface_label.setBuddy(self.interface_box)
        self._channel_label = QLabel()
        self.channel_edit = QLineEdit()
        self._channel_label.setBuddy(self.channel_edit)
        self.add_button = push_button(on_enter=False)
        of_interface = (self.interface_label, (self.interface_box, 2), 6)
        of_channel = (self._channel_label, (self.channel_edit, 3))
        in_row(*of_interface, *of_channel, self.add_button, on=self, spacing=8, margins=0)
        self.add_button.clicked.connect(self._on_add)
        self.channel_edit.textChanged.connect(self._on_changed)
        self.interface_box.editTextChanged.connect(self._on_changed)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.interface_label.setText(self.tr("Interface"))
        self._channel_label.setText(self.tr("Channel"))
        self.channel_edit.setPlaceholderText(self.tr("e.g. COM5, /dev/ttyACM0, 239.0.0.1"))
        self.add_button.setText(self.tr("Add to the list"))
        self._on_changed()

    def _on_changed(self) -> None:
        complete = bool(self._interface() and self._channel())
        self.add_button.setEnabled(complete)
        tip = "" if complete else self.tr("Enter the interface and its channel first.")
        self.add_button.setToolTip(tip)

    def _on_add(self) -> None:
        interface, channel = self._interface(), self._channel()
        self.entered.emit(
            Device(
                interface=interface,
                # some back-ends count their channels
                channel=int(channel) if channel.isdecimal() else channel,
                bitrate=DEFAULT_BITRATE if bitrate_is_ours(interface) else None,
            )
        )
        self.channel_edit.clear()

    def _interface(self) -> str:
        return self.interface_box.currentText().strip()

    def _channel(self) -> str:
        return self.channel_edit.text().strip()
