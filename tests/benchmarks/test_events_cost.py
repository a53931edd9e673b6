"""What the events cost: a frame in the bus thread, a tick in the window's, a piece of a search.

Processor time, so that others on the computer do not count. Beside each in the same run: decoding
the frame and taking it into the picture of the arm; the same tick without the events.

    python -m pytest tests/benchmarks/test_events_cost.py -s
"""

import statistics
import time
from datetime import UTC, datetime

from armui.control.event_log.status_listener import StatusListener
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.telemetry.events import Asker, EventKind, EventLog, Level
from armui.ui.theme import LIGHT
from armui.ui.watch.events.event_filter import EventFilter
from armui.ui.watch.events.event_table import EventModel
from tests.arm_rig import ArmRig
from tests.benchmarks.bus_thread import without_and_with

TICKS = 400
ENDS_DEG = ((30, 60, -40, 20, 15, 30), (-30, 30, -60, -20, -15, -30))
MOST_SHARE = 1 / 3
MOST_OF_SEARCH = 0.1
"""The longest piece of a search may take so much of the whole of it."""


def test_a_frame(capsys, benchmark):
    codec, listener = Codec(Generation.TWO), StatusListener()
    listener.on_codec(codec)
    listener.know_generation(Generation.TWO)
    without, with_it = without_and_with(codec, listener, listener.take_changes)
    benchmark.extra_info.update(without_us=without, with_us=with_it)
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print("\nprocessor time a frame:")
        print(f"  decoded and taken into the picture     {without:5.2f} µs")
        print(f"  the same, its changes noted as events  {with_it:5.2f} µs")
    assert with_it - without < MOST_SHARE * without + 1.0


def timed_ticks(rig, moving):
    """The processor time of a tick in µs, without and with the events, turn by turn."""
    event_collector = rig.controller.event_collector
    spent: tuple[list[float], list[float]] = ([], [])
    act, tick = event_collector.follow_arm, rig.controller.tick
    for number in range(TICKS):
        event_collector.follow_arm = act if number % 2 else lambda: None

        def timed(into=spent[number % 2]):
            began_ns = time.thread_time_ns()
            tick()
            into.append((time.thread_time_ns() - began_ns) / 1e3)

        rig.controller.tick = timed
        if moving and number % 100 == 0:
            rig.controller.motion.send_joints(ENDS_DEG[number // 100 % 2])
        rig.step()
    rig.controller.tick, event_collector.follow_arm = tick, act
    return [statistics.median(each) for each in spent]


def test_a_tick(qapp, capsys, benchmark):
    rig = ArmRig("events-cost")
    try:
        rig.ready()
        rig.controller.motion.set_speed_percent(20)
        still, moving = timed_ticks(rig, moving=False), timed_ticks(rig, moving=True)
    finally:
        rig.close()
    benchmark.extra_info.update(still_us=still, moving_us=moving)
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print("\nprocessor time of the controller's tick, without and with the events:")
        print(f"  at rest  {still[0]:6.1f} {still[1]:6.1f} µs")
        print(f"  moving   {moving[0]:6.1f} {moving[1]:6.1f} µs")
    assert still[1] < (1 + MOST_SHARE) * still[0] + 20
    assert moving[1] < (1 + MOST_SHARE) * moving[0] + 20


def test_a_search(qapp, capsys, benchmark):
    log = EventLog()
    for number in range(10_000):
        log.add(
            at_s=float(number),
            wall=datetime(2026, 1, 15, tzinfo=UTC),
            level=Level.FAULT,
            kind=EventKind.FAULT,
            who=Asker.ARM,
            code="joint_fault",
            params={"joint": number % 6 + 1, "item": "DRIVER_CURRENT", "word": "OVERCURRENT"},
        )
    began_ms = 1e3 * time.thread_time()
    model = EventModel(log, LIGHT)
    opened_ms = 1e3 * time.thread_time() - began_ms
    pieces = []
    model._filter = EventFilter(words=("j4",))
    model._search = model._found()
    while model.searching:
        began_ms = 1e3 * time.thread_time()
        model._search_on()
        pieces.append(1e3 * time.thread_time() - began_ms)
    benchmark.extra_info.update(opened_ms=opened_ms, piece_ms=max(pieces))
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\n10,000 events: shown {opened_ms:.1f} ms; searched in {len(pieces)} pieces,")
        print(f"  each {statistics.median(pieces):.1f} ms, the longest {max(pieces):.1f} ms")
    assert model.rowCount() == 1667
    assert max(pieces) < MOST_OF_SEARCH * sum(pieces)
