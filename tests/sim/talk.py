"""How the tests of the simulated arm write frames: candump's ID#DATA."""

from __future__ import annotations

from collections.abc import Iterable

from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from tests.protocol.rows import GENERATION_2

BOTH = (Generation.ONE, Generation.TWO)

ENABLE = "471#0702000000000000"
DISABLE = "471#0701000000000000"
STOP = "150#0100000000000000"
RESUME = "150#0200000000000000"
STANDBY = "151#0000000000000000"

# eight frames of the controller and six of the drivers at 200 Hz, six at 40 Hz, and what says its
# own cycle time
FRAMES_A_SECOND = 3040 + sum(1000 // row.cycle_ms for row in GENERATION_2 if row.cycle_ms)
"""Of an arm of generation 2 at rest."""


def frame(text: str) -> Frame:
    """`471#0702000000000000` as a frame."""
    identifier, _, data = text.partition("#")
    return Frame(int(identifier, 16), bytes.fromhex(data))


def text(answer: Frame) -> str:
    """The inverse of `frame`."""
    return f"{answer.arbitration_id:03X}#{answer.data.hex().upper()}"


def tell(arm: Firmware, *lines: str) -> list[str]:
    """Sends frames to an arm; returns its answers."""
    return [text(answer) for line in lines for answer in arm.on_frame(frame(line))]


def mode(speed_percent: int, *, control: int = 1, move: int = 1) -> str:
    """0x151: by default CAN control, MOVE J."""
    return f"151#{control:02X}{move:02X}{speed_percent:02X}0000000000"


def target(*joints_deg: float) -> list[str]:
    """0x155, 0x156, 0x157 for six angles: int32 in 0.001°, Motorola order."""
    raw = [round(angle * 1000) for angle in joints_deg]
    words = [value.to_bytes(4, "big", signed=True).hex().upper() for value in raw]
    return [f"{0x155 + k:03X}#{words[2 * k]}{words[2 * k + 1]}" for k in range(3)]


def ready(
    generation: Generation = Generation.TWO,
    joints_deg: Iterable[float] = (0.0,) * 6,
    version: str | None = None,
) -> Firmware:
    """An arm with power on its motors, still in standby; its firmware today's or another."""
    arm = Firmware(generation, joints_deg=tuple(joints_deg), version=version)
    tell(arm, ENABLE)
    return arm


def heard(frames: Iterable[Frame], identifier: int) -> list[str]:
    """The payloads sent under one identifier, in order."""
    return [each.data.hex().upper() for each in frames if each.arbitration_id == identifier]


def status_bytes(arm: Firmware) -> str:
    """The next payload of 0x2A1."""
    return heard(arm.step(0.02), 0x2A1)[-1]


def pose_target(*pose: float) -> list[str]:
    """0x152, 0x153, 0x154 for X, Y, Z in mm and RX, RY, RZ in °: int32 in 0.001, Motorola order."""
    raw = [round(value * 1000) for value in pose]
    words = [value.to_bytes(4, "big", signed=True).hex().upper() for value in raw]
    return [f"{0x152 + k:03X}#{words[2 * k]}{words[2 * k + 1]}" for k in range(3)]


def arc_point(number: int) -> str:
    """0x158 as a host of generation 1 sends it, with one byte."""
    return f"158#{number:02X}"
