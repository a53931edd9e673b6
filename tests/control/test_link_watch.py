"""Frames lost before the program could read them are told, and not too often."""

from armui.control.link.link_watch import DroppedFrames


def told(rig):
    return [event.params for event in rig.events if event.code == "frames_dropped"]


def test_they_are_told_at_once_and_then_every_ten_seconds(rig):
    rig.connect()
    queue = rig.controller._connection._worker._queue
    queue._by_adapter = 3
    rig.step()
    assert told(rig) == [{"count": 3, "total": 3}]
    queue._by_adapter = 5
    rig.run(9.0)
    assert len(told(rig)) == 1
    rig.run(1.1)
    assert told(rig)[1:] == [{"count": 2, "total": 5}]
    rig.run(11.0)
    assert len(told(rig)) == 2


def test_the_next_device_counts_anew(rig):
    rig.connect()
    rig.controller._connection._worker._queue._by_adapter = 3
    rig.step()
    rig.controller.disconnect_device()
    rig.connect()
    rig.controller._connection._worker._queue._by_adapter = 1
    rig.step()
    assert told(rig)[-1] == {"count": 1, "total": 1}


def test_it_is_a_part_of_the_controller(rig):
    assert any(isinstance(part, DroppedFrames) for part in rig.controller._all_parts())


def test_a_computer_that_stood_still_is_told_with_the_arms_silence(rig):
    rig.ready()
    rig.powered = False
    rig.step(0.7)
    (told_busy,) = [event for event in rig.events if event.code == "offline_busy"]
    assert told_busy.params == {"value": 700}
    assert "offline" not in rig.codes()
    rig.powered = True
    rig.run_until(lambda: rig.codes()[-1] != "offline_busy")
    rig.run(1.0)
    rig.powered = False
    rig.run(1.0)
    assert rig.codes()[-1] == "offline", "an old stall was told with another silence"
