"""The state of the connection to a device, apart from whether an arm answers on it."""

from __future__ import annotations

import enum
from typing import NamedTuple

from armui.arm.device import Device
from armui.arm.refusal import Refusal


class BusState(enum.Enum):
    """What the bus thread is doing with its device."""

    OPENING = enum.auto()
    OPEN = enum.auto()
    BLOCKED = enum.auto()
    """It is open, and no frame gets out; it goes on trying."""
    LOST = enum.auto()
    """It was open and is gone; the thread keeps trying to open it again."""
    FAILED = enum.auto()
    """It could not be opened; the thread has ended."""
    CLOSED = enum.auto()


class BusReport(NamedTuple):
    """What the bus thread says of its device.

    Attributes:
        state: What it is doing.
        device: The device.
        problem: Why it is ``BLOCKED``, ``LOST`` or ``FAILED``.
        worker: The number of the thread that says so.
    """

    state: BusState
    device: Device
    problem: Refusal | None = None
    worker: int = 0
