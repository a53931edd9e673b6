"""Opening a device that another thread may still be closing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

import can
from PySide6.QtCore import QThread

from armui.arm.device import Device
from armui.bus.worker import Opener


def opener_after(before: Sequence[QThread], opener: Opener) -> Opener:
    """Opens a device when other threads have closed theirs: it may be the same one.

    Args:
        before: The threads that are ending.
        opener: How to open it.
    """

    @contextmanager
    def open_device(device: Device) -> Iterator[can.BusABC]:
        for worker in before:
            worker.wait()
        with opener(device) as bus:
            yield bus

    return open_device if before else opener
