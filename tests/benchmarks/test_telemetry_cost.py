"""What it costs to keep every sample, beside what decoding costs, in the same run.

The frames of two seconds of a moving arm, as the bus thread takes them in: decoded and folded into
the picture of the arm, without and with telemetry. Then half an hour of them, and its memory.
"""

from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.telemetry.store import Telemetry
from tests.benchmarks import rig
from tests.benchmarks.bus_thread import without_and_with
from tests.telemetry.motions import Clock, feed, telemetry_at

MOST_SHARE = 1 / 3
MOST_MB = 140.0


def test_telemetry_cost(capsys, benchmark):
    codec = Codec(Generation.TWO)
    telemetry = Telemetry()
    telemetry.on_codec(codec)
    telemetry.know_generation(Generation.TWO)
    without, with_it = without_and_with(codec, telemetry)
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
