"""Reads a bus and passes its frames to a recording; it sends nothing."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final

import can

from armui.arm.device import Device
from armui.bus.adapters import open_bus
from armui.bus.receive_clock import STAMPED, ReceiveClock
from armui.protocol.frame import Frame, FrameFlag
from armui.protocol.generation import Generation
from armui.session.batch_builder import MESSAGE_FLAGS
from armui.sim.firmware import Firmware
from armui.sim.node import Node

if TYPE_CHECKING:
    from armui.session.recording.lane import FrameLane
    from armui.session.recording.rows import RecordedFrame

SIMULATED: Final = "armui-simulated"
_WAIT_S: Final = 0.05
_AT_ONCE: Final = 256


@contextmanager
def opened(device: Device) -> Iterator[can.BusABC]:
    """Open a device; for a simulated one also start its arm.

    Raises:
        can.CanError, OSError, ValueError, ImportError: see `armui.bus.adapters.explain`.
    """
    if not device.simulated:
        with open_bus(device) as bus:
            yield bus
        return
    with (
        open_bus(device) as arm_side,
        open_bus(device) as bus,
        Node(Firmware(Generation(device.generation or 2), model=device.model), arm_side),
    ):
        yield bus


class BusListener:
    """Passes frames from a bus to a recording.

    Args:
        bus: The open bus.
        device: The device of the bus.
        lane: The queue for the frames.
        clock: The program's, in seconds.

    Attributes:
        frames: The number of frames so far.
    """

    def __init__(
        self, bus: can.BusABC, device: Device, lane: FrameLane, clock: Callable[[], float]
    ) -> None:
        self._bus = bus
        self._lane = lane
        self._clock = clock
        self._received = ReceiveClock(clock, stamped=device.interface in STAMPED)
        self.frames = 0

    def listen(self) -> None:
        """Wait a moment for frames, and pass on those that came.

        Raises:
            can.CanError, OSError: The device is gone.
        """
        self._received.begin()
        message = self._bus.recv(_WAIT_S)
        now_s = self._clock()
        batch: list[RecordedFrame] = []
        while message is not None:
            batch.append(_taken(message, self._received.at_s(message.timestamp, now_s)))
            if len(batch) == _AT_ONCE:
                break
            message = self._bus.recv(0)
        else:
            self._received.emptied()
        if batch:
            self.frames += len(batch)
            self._lane.on_heard(batch)


def _taken(message: can.Message, at_s: float) -> RecordedFrame:
    flags = FrameFlag(0)
    if message.is_extended_id or message.is_remote_frame or message.is_error_frame or message.is_fd:
        for name, flag in MESSAGE_FLAGS:
            if getattr(message, name):
                flags |= flag
    data = bytes(message.dlc) if message.is_remote_frame else bytes(message.data)
    return None, at_s, Frame(message.arbitration_id, data), int(flags)
