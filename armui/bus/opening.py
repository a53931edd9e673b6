"""Opening a device that another thread may still be closing."""

from __future__ import annotations

import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

import can

from armui.arm.device import Device
from armui.bus.worker import Opener


def opener_after(before: Sequence[threading.Event], opener: Opener) -> Opener:
    """Opens a device when other threads have closed theirs: it may be the same one.

    Args:
        before: Set by the threads that are ending, each when its device is closed. The threads
            themselves may be gone by then.
        opener: How to open it.
    """

    @contextmanager
    def open_device(device: Device) -> Iterator[can.BusABC]:
        for released in before:
            released.wait()
        with opener(device) as bus:
            yield bus

    return open_device if before else opener
