"""What it costs to keep every sample, beside what decoding costs, in the same run.

The frames of two seconds of a moving arm, as the bus thread takes them in: decoded and folded into
the picture of the arm, without and with telemetry. Then half an hour of them, and its memory.
"""

import time

from armui.arm.tracker import Tracker
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.telemetry.store import Telemetry
from tests.benchmarks import rig
from tests.telemetry.motions import EIGHT_BYTES, Clock, feed, telemetry_at

ROUNDS = 9
BATCH = 16
FRAMES_PER_S = 3040
MOST_SHARE = 1 / 3
MOST_MB = 140.0


def recorded():
    """What an arm says in two seconds."""
    arm = Firmware(Generation.TWO)
    return [frame for _ in range(400) for frame in arm.step(0.005)]


def take_in(codec, frames, telemetry, begin_s):
    """As the bus thread does; the processor time of one frame in µs."""
    tracker, batch, at_s = Tracker(codec), [], begin_s
    began_s = time.thread_time()
    for frame in frames:
        at_s += 1 / FRAMES_PER_S
        heard = codec.decode(frame)
        tracker.update(heard, at_s)
        if telemetry is not None:
            batch.append((heard, at_s, EIGHT_BYTES, 0))
            if len(batch) == BATCH:
                telemetry.on_heard(batch)
                batch = []
    return 1e6 * (time.thread_time() - began_s) / len(frames)


def test_telemetry_cost(capsys, benchmark):
    codec, frames = Codec(Generation.TWO), recorded()
    telemetry = Telemetry()
    telemetry.on_codec(codec)
    telemetry.know_generation(Generation.TWO)
    bare, watched = [], []
    for number in range(ROUNDS):
        bare.append(take_in(codec, frames, None, 10.0 * number))
        watched.append(take_in(codec, frames, telemetry, 10.0 * number))
    without, with_it = min(bare), min(watched)
    clock = Clock()
    before_mb = rig.memory_mb("self")
    filled = telemetry_at(clock)
    feed(filled, clock, 1800.0)
    grown_mb = rig.memory_mb("self") - before_mb
    benchmark.extra_info.update(decode_us=without, telemetry_us=with_it - without, mb=grown_mb)
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print("\nprocessor time a frame:")
        print(f"  decoded and taken into the picture  {without:5.2f} µs")
        print(f"  the same, and every sample kept     {with_it:5.2f} µs")
        reserved_mb, most_mb = filled.bytes_kept / 1e6, filled.most_bytes / 1e6
        print(f"half an hour of an arm: {grown_mb:.0f} MB of {reserved_mb:.0f} MB reserved;")
        print(f"  whatever is heard, no more than {most_mb:.0f} MB")
    assert grown_mb < MOST_MB
    assert with_it - without < MOST_SHARE * without + 1.0
