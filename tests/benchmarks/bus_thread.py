"""What the bus thread does with each frame, without a bus: for benchmarks of what is told of it."""

from __future__ import annotations

import time
from typing import Any

from armui.arm.tracker import Tracker
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware

ROUNDS = 9
BATCH = 16
FRAMES_PER_S = 3040


def recorded() -> list[Frame]:
    """What a moving arm says in two seconds."""
    arm = Firmware(Generation.TWO)
    return [frame for _ in range(400) for frame in arm.step(0.005)]


def take_in(codec: Codec, frames: list[Frame], listener: Any, begin_s: float) -> float:
    """As the bus thread does; the processor time of one frame in µs."""
    tracker, batch, at_s = Tracker(codec), [], begin_s
    began_s = time.thread_time()
    for frame in frames:
        at_s += 1 / FRAMES_PER_S
        heard = codec.decode(frame)
        tracker.update(heard, at_s)
        if listener is not None:
            batch.append((heard, at_s, frame, 0))
            if len(batch) == BATCH:
                listener.on_heard(batch)
                listener.on_look(at_s)
                batch = []
    return 1e6 * (time.thread_time() - began_s) / len(frames)


def without_and_with(codec: Codec, listener: Any, after: Any = lambda: None) -> tuple[float, float]:
    """The least processor time of a frame in µs in some rounds, without a listener and with it."""
    frames = recorded()
    bare, watched = [], []
    for number in range(ROUNDS):
        bare.append(take_in(codec, frames, None, 10.0 * number))
        watched.append(take_in(codec, frames, listener, 10.0 * number))
        after()
    return min(bare), min(watched)
