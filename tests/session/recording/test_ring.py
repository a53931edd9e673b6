"""The last minutes in memory: bounded, in order, and nothing of them copied twice."""

from __future__ import annotations

import numpy as np
import pytest

from armui.protocol.frame import Frame, FrameFlag
from armui.session.recording.collector import KEPT_S, MOST_BYTES, Collector, FrameRing, Sorter
from armui.session.recording.lane import FrameLane
from armui.session.recording.rows import ROW, FrameRows, in_order, joined, rows_of
from tests.session.recording.made import taken

RATE = 3000


def ordinary(count: int, start_s: float) -> FrameRows:
    table = np.zeros(count, ROW)
    table["time_s"] = start_s + np.arange(count) / RATE
    table["id"] = np.arange(count) % 32
    table["length"] = 8
    return FrameRows(table)


def times_of(parts):
    return np.concatenate([part.times_s for part in parts]) if parts else np.zeros(0)


def test_five_minutes_of_a_busy_bus_fit_into_the_bound():
    ring = FrameRing()
    for second in range(400):
        ring.append(ordinary(RATE, float(second)))
        assert ring.bytes_kept <= MOST_BYTES
    frames, span_s = ring.span()
    assert span_s == pytest.approx(KEPT_S, abs=0.5)
    assert frames == pytest.approx(KEPT_S * RATE, abs=RATE)
    assert MOST_BYTES <= 22e6


def test_more_traffic_reaches_back_less_far_and_takes_no_more_memory():
    ring = FrameRing(most_bytes=2_000_000)
    for second in range(60):
        ring.append(ordinary(RATE, float(second)))
    assert ring.bytes_kept <= 2_000_000
    times_s = times_of(ring.snapshot())
    assert times_s[-1] == 59 + (RATE - 1) / RATE
    assert len(times_s) > 60_000
    assert (np.diff(times_s) > 0).all()


def test_frames_of_can_fd_count_for_what_they_take():
    ring = FrameRing(most_bytes=4_000_000)
    long_one = (None, 0.0, Frame(0x321, bytes(64)), int(FrameFlag.FD))
    for second in range(100):
        ring.append(rows_of([(None, float(second), *long_one[2:])] * 1000))
        assert ring.bytes_kept <= ring.most_bytes == 4_000_000
    newest = ring.snapshot()[-1]
    assert newest.data(len(newest) - 1) == bytes(64)


def test_a_snapshot_stays_as_it_is_while_the_ring_goes_on():
    ring = FrameRing(keep_s=3.0)
    ring.append(ordinary(RATE * 3, 0.0))
    before = ring.snapshot()
    kept = times_of(before).copy()
    ring.append(ordinary(RATE * 30, 3.0))
    assert (times_of(before) == kept).all()
    assert times_of(ring.snapshot())[0] >= 33 - 3.0 - 1.0
    ring.clear()
    assert (ring.span(), ring.bytes_kept) == ((0, 0.0), 0)
    assert (times_of(before) == kept).all()


def test_a_batch_beyond_the_bound_of_the_lane_is_dropped_and_counted():
    lane = FrameLane(most=10)
    frames = taken(12)
    lane.on_heard(frames[:6])
    lane.on_sent(frames[6:10])
    lane.on_heard(frames[10:])
    assert (lane.waiting, lane.dropped) == (10, 2)
    assert lane.take_frames() == frames[:10]
    lane.on_heard(frames[10:])
    assert lane.take_frames() == frames[10:]
    assert (lane.waiting, lane.dropped) == (0, 2)


def test_frames_sent_and_heard_are_put_into_the_order_of_time():
    lane, ring = FrameLane(), FrameRing()
    collector = Collector(lane, ring)
    got: list[FrameRows] = []
    collector.add(got.append)
    frames = taken(1000)
    sent = frames[::5]
    heard = [frame for frame in frames if frame not in sent]
    for begin in range(0, 800, 100):
        lane.on_heard(heard[begin : begin + 100])
        lane.on_sent(sent[begin // 4 : begin // 4 + 25])
        collector.collect()
    collector.remove(got.append)

    rows = joined(got)
    assert list(rows.times_s) == [at_s for _, at_s, _, _ in frames]
    assert [rows.data(row) for row in range(len(rows))] == [f.data for _, _, f, _ in frames]
    assert collector.late == 0


def test_what_comes_far_too_late_gets_the_time_of_what_went_before():
    sorter = Sorter()
    sorter.sort(rows_of(taken(3000, 10.0)), everything=True)
    late = sorter.sort(rows_of(taken(10, 10.5)), everything=True)
    assert (late.times_s == 10.0 + 2999 / 3000).all()
    assert sorter.late == 10


def test_long_data_goes_with_its_frame():
    frames = [
        (None, 3.0, Frame(1, bytes(12)), 8),
        (None, 1.0, Frame(2, b"\x01"), 0),
        (None, 2.0, Frame(3, bytes(range(20))), 8),
    ]
    rows = in_order(joined([rows_of(frames[:2]), rows_of(frames[2:])]))
    assert [rows.data(row) for row in range(3)] == [b"\x01", bytes(range(20)), bytes(12)]
    assert rows.part(1, 3).data(0) == bytes(range(20))


def test_a_sink_that_fails_does_not_end_the_thread(caplog):
    lane, ring = FrameLane(), FrameRing()
    collector = Collector(lane, ring)
    told = []

    def sink(rows):
        told.append(len(rows))
        raise RuntimeError("a broken sink")

    collector.add(sink)
    collector.start()
    lane.on_heard(taken(10))
    collector.remove(sink)
    collector.end()
    assert told
    assert ring.span()[0] == 10
    assert "were not kept" in caplog.text
