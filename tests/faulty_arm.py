"""Faults put into the frames of the simulated arm: what its drivers say, byte by byte."""

import weakref
from typing import Any

from armui.protocol.frame import Frame
from armui.sim.firmware import Firmware

_DRIVER_SLOW = 0x260
_STATUS_BYTE = 5


class FaultyDrivers:
    """Sets bits of 0x261–0x266 byte 5 on their way out of a firmware, or keeps frames back.

    Attributes:
        bits: The bits to set, by joint.
        silent: Joints whose drivers say nothing.
        missing: Arbitration IDs that never leave the arm.
    """

    def __init__(self, firmware: Firmware) -> None:
        self.bits: dict[int, int] = {}
        self.silent: set[int] = set()
        self.missing: set[int] = set()
        # the firmware holds this; a reference back would keep both beyond the test
        self._step = weakref.WeakMethod(firmware.step)
        self._firmware = weakref.ref(firmware)
        firmware.step = self.step

    def mend(self) -> None:
        """From now on the drivers say what is so."""
        del self._firmware().step

    def step(self, dt_s: float) -> list[Frame]:
        """The firmware's frames with the faults in them."""
        step = self._step()
        assert step is not None
        return [
            self._spoil(frame)
            for frame in step(dt_s)
            if frame.arbitration_id - _DRIVER_SLOW not in self.silent
            and frame.arbitration_id not in self.missing
        ]

    def _spoil(self, frame: Frame) -> Frame:
        bits = self.bits.get(frame.arbitration_id - _DRIVER_SLOW, 0)
        if not bits:
            return frame
        data = bytearray(frame.data)
        data[_STATUS_BYTE] |= bits
        return Frame(frame.arbitration_id, bytes(data))


class HardOfHearing:
    """Keeps frames from a firmware, or its answers from the bus.

    Attributes:
        deaf_to: Arbitration IDs the arm never hears.
        mute_on: Arbitration IDs it never sends.
        heard: What it did hear.
    """

    def __init__(self, firmware: Firmware) -> None:
        self.deaf_to: set[int] = set()
        self.mute_on: set[int] = set()
        self.heard: list[Frame] = []
        self._on_frame = weakref.WeakMethod(firmware.on_frame)
        firmware.on_frame = self.on_frame

    def on_frame(self, frame: Frame) -> list[Frame]:
        """The firmware's answers, those that get through."""
        on_frame = self._on_frame()
        assert on_frame is not None
        if frame.arbitration_id in self.deaf_to:
            return []
        self.heard.append(frame)
        return [each for each in on_frame(frame) if each.arbitration_id not in self.mute_on]


LYING_DEG = (5.0, 10.0, -20.0, 0.0, 30.0, -40.0)


def laid_down(rig: Any) -> Any:
    """A connected arm whose joints read `LYING_DEG`, and whose ear the test can stop."""
    rig.connect()
    rig.firmware.mechanics.count_anew(LYING_DEG)
    rig.run(0.1)
    rig.ear = HardOfHearing(rig.firmware)
    return rig
