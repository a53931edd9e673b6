"""Logs of the simulated arm, made by stepping it: no bus, no waiting."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

import can

from armui.protocol import commands
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.faults.faulty_link import FaultyLink
from armui.sim.faults.schedule import Fault, Faults
from armui.sim.firmware import Firmware

STEP_S = 0.005
START_S = 1_790_000_000.0
"""Of every log, in seconds since 1970: September 2026."""


def frames(
    seconds: float,
    generation: Generation = Generation.TWO,
    *,
    faults: tuple[Fault, ...] = (),
    asked: dict[int, list[Frame]] | None = None,
    start_s: float = START_S,
) -> Iterator[tuple[float, Frame]]:
    """What an arm says, and what it is told, in the order of time.

    Args:
        seconds: How long.
        generation: Of its protocol.
        faults: What breaks when.
        asked: Commands of a host, by the number of the step before which they come.
        start_s: Of the first frame.
    """
    firmware, link = Firmware(generation), FaultyLink(0)
    schedule = Faults(firmware, link, faults)
    for step in range(round(seconds / STEP_S)):
        at_s = start_s + step * STEP_S
        schedule.at(firmware.time_s)
        told = (asked or {}).get(step, [])
        said = list(told)
        for frame in link.to_arm(told, firmware.time_s):
            said += firmware.on_frame(frame)
        spoken, _lost = link.to_bus(firmware.step(STEP_S), firmware.time_s, STEP_S)
        for place, frame in enumerate(said + spoken):
            yield at_s + place * 1e-5, frame


def greeting(generation: Generation) -> dict[int, list[Frame]]:
    """A host that asks for the version and the limits, and switches the motors on."""
    codec = Codec(generation)
    ask = Codec(Generation.TWO)
    asked = {40: commands.query_firmware(ask), 200: commands.enable_motors(codec)}
    for joint in range(1, 7):
        asked[80 + joint] = [
            *commands.query_limits(codec, joint),
            *commands.query_acceleration(codec, joint),
        ]
    return asked


def moving(generation: Generation) -> dict[int, list[Frame]]:
    """A host that greets, moves to and fro, stops the arm at 17 s and ends the stop at 18.5 s."""
    codec = Codec(generation)
    asked = greeting(generation)
    away, back = (35.0, 60.0, -50.0, 20.0, 30.0, -40.0), (0.0, 20.0, -20.0, 0.0, 0.0, 0.0)
    for place, step in enumerate(range(300, 3400, 500)):
        target = away if place % 2 == 0 else back
        asked[step] = commands.move_joints(codec, target, speed_percent=40)
    asked[3400] = commands.emergency_stop(codec)
    asked[3700] = commands.resume(codec)
    return asked


def write(path: Path, recorded: Iterable[tuple[float, Frame]], channel: int = 1) -> int:
    """Write a log with python-can's own writer; how many frames it holds."""
    count = 0
    with can.Logger(path) as logger:
        for at_s, frame in recorded:
            logger(
                can.Message(
                    timestamp=at_s, arbitration_id=frame.arbitration_id, data=frame.data,
                    is_extended_id=False, channel=channel,
                )
            )  # fmt: skip
            count += 1
    return count
