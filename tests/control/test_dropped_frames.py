"""Frames lost before the program could read them are told, and not too often."""

from armui.control.dropped_frames import DroppedFrames


def told(bench):
    return [notice.params for notice in bench.notices if notice.code == "frames_dropped"]


def test_they_are_told_at_once_and_then_every_ten_seconds(bench):
    bench.connect()
    queue = bench.controller._connection._worker._queue
    queue._by_adapter = 3
    bench.step()
    assert told(bench) == [{"count": 3, "total": 3}]
    queue._by_adapter = 5
    bench.run(9.0)
    assert len(told(bench)) == 1
    bench.run(1.1)
    assert told(bench)[1:] == [{"count": 2, "total": 5}]
    bench.run(11.0)
    assert len(told(bench)) == 2


def test_the_next_device_counts_anew(bench):
    bench.connect()
    bench.controller._connection._worker._queue._by_adapter = 3
    bench.step()
    bench.controller.disconnect_device()
    bench.connect()
    bench.controller._connection._worker._queue._by_adapter = 1
    bench.step()
    assert told(bench)[-1] == {"count": 1, "total": 1}


def test_it_is_a_part_of_the_controller(bench):
    assert any(isinstance(part, DroppedFrames) for part in bench.controller._parts._parts)
