"""Logs of a simulated arm, as a recorder would have written them; and of single frames."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import can

from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware

START_S = 1_718_900_000.0
STEP_S = 0.005


def line(time_s: float, frame: Frame, channel: str = "can0") -> str:
    """As candump -L writes it."""
    return f"({time_s:.6f}) {channel} {frame.arbitration_id:03X}#{frame.data.hex().upper()}\n"


def candump(path: Path, frames: Iterable[tuple[float, Frame]], channel: str = "can0") -> Path:
    """A log of frames with their times."""
    path.write_text("".join(line(at_s, frame, channel) for at_s, frame in frames))
    return path


def session(
    seconds: float, generation: Generation = Generation.TWO, *, start_s: float = START_S
) -> list[tuple[float, Frame]]:
    """Enabled, then sent to J1 = 30°, with everything the arm says meanwhile."""
    arm = Firmware(generation, joints_deg=(12.0, 20.0, -30.0, 5.0, 10.0, -40.0))
    codec = Codec(generation)
    heard: list[tuple[float, Frame]] = []
    asked = {
        0.0: [codec.encode("MotorEnable", Joint=7, Action=2)],
        0.2: [codec.encode("ModeControl", ControlMode=1, MoveMode=1, SpeedPercent=50)],
        0.3: [
            codec.encode("JointTarget12", J1=30.0, J2=20.0),
            codec.encode("JointTarget34", J3=-30.0, J4=5.0),
            codec.encode("JointTarget56", J5=10.0, J6=-40.0),
        ],
    }
    waiting = dict(asked)
    for step in range(round(seconds / STEP_S)):
        now_s = step * STEP_S
        for at_s in [each for each in waiting if each <= now_s]:
            for frame in waiting.pop(at_s):
                heard.append((start_s + now_s, frame))
                heard += [(start_s + now_s, each) for each in arm.on_frame(frame)]
        heard += [(start_s + now_s, each) for each in arm.step(STEP_S)]
    return heard


def blf(path: Path, frames: Iterable[tuple[float, Frame]]) -> Path:
    """The same as Vector's binary log."""
    with can.BLFWriter(path) as writer:
        for at_s, frame in frames:
            writer.on_message_received(
                can.Message(
                    timestamp=at_s,
                    arbitration_id=frame.arbitration_id,
                    data=frame.data,
                    is_extended_id=False,
                    channel=0,
                )
            )
    return path
