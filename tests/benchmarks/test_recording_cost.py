"""What it costs to keep and to record every frame, beside what taking it in costs, in one run.

The frames of two seconds of an arm, in batches as the bus thread tells them: what the bus thread
does anyway, then with the lane of the recorder as one more listener. Beside it, in their own
threads, the ring and a recording of each format. The stop waits for the bus thread only.
"""

from __future__ import annotations

import time

from armui.arm.tracker import Tracker
from armui.bus.notifier import Notifier
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.session.recording.collector import MOST_BYTES, Collector, FrameRing
from armui.session.recording.kinds import RecordingFormat
from armui.session.recording.lane import FrameLane
from armui.session.recording.recorded_session import RecordedSession
from armui.session.recording.rows import rows_of
from armui.session.recording.writer import RecordingPlan, RecordingWriter, TimeBase
from tests.benchmarks import rig
from tests.benchmarks.bus_thread import recorded

ROUNDS = 9
BATCH = 16
FRAMES_PER_S = 3040
MOST_US = 0.3
MINUTES = 30
FIRST_PICTURE_S = 0.3


def take_in(codec, frames, line, lane, begin_s):
    """As the bus thread does; the processor time of one frame in µs."""
    tracker, at_s = Tracker(codec), begin_s
    line.open(codec, 1_000_000)
    began_s = time.thread_time()
    for number, frame in enumerate(frames):
        at_s += 1 / FRAMES_PER_S
        heard = codec.decode(frame)
        tracker.update(heard, at_s)
        line.received.append((heard, at_s, frame, 0))
        if number % BATCH == BATCH - 1:
            line.flush(codec, at_s)
    taken_s = time.thread_time() - began_s
    if lane is not None:
        assert lane.waiting >= len(frames) // BATCH * BATCH
        lane.take_frames()
    return 1e6 * taken_s / len(frames)


def collected(frames):
    """Processor time of a frame in the collector's thread, in µs, ten looks a second."""
    lane, ring = FrameLane(), FrameRing()
    collector = Collector(lane, ring)
    began_s, longest_s = time.thread_time(), 0.0
    for begin in range(0, len(frames), FRAMES_PER_S // 10):
        lane.on_heard(frames[begin : begin + FRAMES_PER_S // 10])
        before_s = time.perf_counter()
        collector.collect()
        longest_s = max(longest_s, time.perf_counter() - before_s)
    return 1e6 * (time.thread_time() - began_s) / len(frames), 1e3 * longest_s


def written(folder, kind, frames):
    """Processor time of a frame in the writing thread, in µs; and bytes of a frame."""
    base = TimeBase(0.0, time.time())
    writer = RecordingWriter(RecordingPlan(folder, kind.name, kind, base, 10**9))
    rows = rows_of(frames)
    began_s = time.thread_time()
    for begin in range(0, len(rows), 1200):
        writer.write(rows.part(begin, begin + 1200))
    cost_us = 1e6 * (time.thread_time() - began_s) / len(rows)
    writer.finish({})
    return cost_us, writer.total_bytes / len(rows)


def jumps(folder, frames):
    """The longest jump into half an hour: opening, the bus as it stood, one second of frames."""
    base = TimeBase(0.0, time.time())
    writer = RecordingWriter(RecordingPlan(folder, "long", RecordingFormat.BLF, base, 10**9))
    rows = rows_of(frames)
    length_s = len(rows) / FRAMES_PER_S
    for number in range(round(60 * MINUTES / length_s)):
        for begin in range(0, len(rows), 1200):
            writer.write(rows.part(begin, begin + 1200).shifted(number * length_s))
    writer.finish({})
    began_s = time.perf_counter()
    session = RecordedSession(writer.path)
    opened_s = time.perf_counter() - began_s
    longest_s = 0.0
    for place in range(20):
        at_s = session.start_s + (place + 0.37) / 20 * (session.end_s - session.start_s)
        began_s = time.perf_counter()
        assert len(session.snapshot_at(at_s)) >= 20
        assert sum(map(len, session.frames_between(at_s, at_s + 1.0))) > 2500
        longest_s = max(longest_s, time.perf_counter() - began_s)
    return session.frames, opened_s, longest_s


def test_recording_cost(capsys, benchmark, tmp_path):
    codec, frames = Codec(Generation.TWO), recorded()
    bare, tapped = [], []
    for number in range(ROUNDS):
        bare.append(take_in(codec, frames, Notifier(), None, 10.0 * number))
        lane = FrameLane()
        tapped.append(take_in(codec, frames, Notifier([lane]), lane, 10.0 * number))
    without, with_it = min(bare), min(tapped)
    taken = [(None, number / FRAMES_PER_S, frame, 0) for number, frame in enumerate(frames)]
    kept, longest_ms = min(collected(taken) for _ in range(ROUNDS))
    costs = {kind: written(tmp_path, kind, taken) for kind in RecordingFormat}
    before_mb = rig.memory_mb("self")
    ring, rows = FrameRing(), rows_of(taken)
    for number in range(200):
        ring.append(rows.shifted(number * len(rows) / FRAMES_PER_S))
    grown_mb = rig.memory_mb("self") - before_mb
    count, opened_s, jump_s = jumps(tmp_path, taken)
    benchmark.extra_info.update(tap_us=with_it - without, ring_us=kept, jump_s=jump_s)
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print("\nprocessor time a frame, in the bus thread:")
        print(f"  taken in, nobody listening         {without:5.2f} µs")
        print(f"  the same, handed to the recorder   {with_it:5.2f} µs")
        print("in threads of their own:")
        print(f"  into the ring                      {kept:5.2f} µs (a look {longest_ms:.2f} ms)")
        for kind, (cost_us, size) in costs.items():
            print(f"  written as {kind.value}   {cost_us:5.2f} µs, {size:.0f} bytes")
        print(f"the ring: {grown_mb:.0f} MB of {MOST_BYTES / 1e6:.0f} MB at most")
        print(f"{count} frames: opened in {opened_s:.3f} s, the longest jump {jump_s:.3f} s")
    assert with_it - without < MOST_US
    assert grown_mb < MOST_BYTES / 1e6 + 5
    assert opened_s + jump_s < FIRST_PICTURE_S
