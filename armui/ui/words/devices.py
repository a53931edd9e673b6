"""What a device is called."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.device import Device
from armui.ui.words.text import sentence


def device_name(device: Device) -> str:
    """A device as the operator knows it: an adapter by its channel, a simulated arm as such."""
    if not device.simulated:
        return device.name
    source = QT_TRANSLATE_NOOP("Device", "Simulated arm, gen. {generation}")
    return sentence("Device", source, {"generation": device.generation})
