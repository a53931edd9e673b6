"""What the bus monitor costs: a frame on the bus thread and when it is counted, and a look.

The frames of two seconds of a moving arm as the bus thread takes them in, decoded and folded into
the picture of the arm, without and with the listener; beside it what counting them costs the
window's thread. Then the window itself, shown: what it does ten times a second. It states, and
fails nobody.

    python -m pytest tests/benchmarks/test_bus_monitor_cost.py -s
"""

import time

from armui.arm.tracker import Tracker
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.telemetry.bus_statistics import BusStatistics
from armui.ui.watch.bus.bus_page import BusPage
from tests.app_driver import AppDriver
from tests.benchmarks.bus_thread import BATCH, FRAMES_PER_S, ROUNDS, recorded

LOOKS = 60
SIGNALS_OF = ("0x2A1", "0x2A5", "0x251", "0x261")


def take_in(codec, frames, statistics, begin_s):
    """As the bus thread does; the processor time of one frame in µs."""
    tracker, batch, at_s = Tracker(codec), [], begin_s
    began_s = time.thread_time()
    for frame in frames:
        at_s += 1 / FRAMES_PER_S
        heard = codec.decode(frame)
        tracker.update(heard, at_s)
        batch.append((heard, at_s, frame, 0))
        if len(batch) == BATCH:
            if statistics is not None:
                statistics.on_heard(batch)
            batch = []
    return 1e6 * (time.thread_time() - began_s) / len(frames)


def count(statistics, frames):
    """As the window does; the processor time of one frame in µs."""
    began_s = time.thread_time()
    while not statistics.count_waiting():
        pass
    return 1e6 * (time.thread_time() - began_s) / len(frames)


def test_cost_of_a_frame(capsys, benchmark):
    codec, frames = Codec(Generation.TWO), recorded()
    statistics = BusStatistics()
    statistics.on_codec(codec)
    bare, tapped, counted = [], [], []
    for number in range(ROUNDS):
        bare.append(take_in(codec, frames, None, 10.0 * number))
        tapped.append(take_in(codec, frames, statistics, 10.0 * number))
        counted.append(count(statistics, frames))
    benchmark.extra_info.update(
        decode_us=min(bare), tap_us=min(tapped) - min(bare), count_us=min(counted)
    )
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print("\nprocessor time a frame:")
        print(f"  decoded and taken into the picture        {min(bare):5.2f} µs")
        print(f"  the same, handed over to the bus monitor  {min(tapped):5.2f} µs")
        print(f"  counted, in the window's thread           {min(counted):5.2f} µs")


def test_cost_of_a_look(qapp, tmp_path, capsys, benchmark):
    driver = AppDriver(qapp, "bus monitor cost", tmp_path / "settings.json", Generation.TWO)
    try:
        driver.ready()
        driver.click("bus_button")
        window = driver.taken_out(BusPage)
        driver.run(0.5)
        window.refresh()
        for place in range(window.model.rowCount()):
            index = window.model.index(place, 0)
            window.tree.setExpanded(index, index.data() in SIGNALS_OF)
        for view in (window.filter_bar.by_id, window.filter_bar.in_order):
            view.click()
            rows = window.tree if view is window.filter_bar.by_id else window.trace
            looks, pictures = [], []
            for _ in range(LOOKS):
                driver.run(0.1)
                began_s = time.thread_time()
                window.refresh()
                looked_s = time.thread_time()
                rows.viewport().repaint()
                looks.append(1e3 * (looked_s - began_s))
                pictures.append(1e3 * (time.thread_time() - looked_s))
            looks.sort()
            pictures.sort()
            with capsys.disabled():
                print(f"\n{view.objectName()}, {LOOKS} looks at 0.1 s of an arm each, processor:")
                print(f"  counting and showing  {looks[LOOKS // 2]:5.2f} ms, most {looks[-1]:5.2f}")
                print(f"  painting all rows     {pictures[LOOKS // 2]:5.2f} ms")
        benchmark.pedantic(lambda: None, rounds=1)
    finally:
        driver.close()
