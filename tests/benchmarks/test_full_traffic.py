"""A bus as full as it gets, from another process, with the window and the picture beside it.

8,100 frames a second, all joints moving, drawn. Beside it in the same run: a process that only
reads. Stated: what each has lost, how long the GUI thread kept an event waiting, pictures a second,
processor time and memory.

    python -m pytest tests/benchmarks/test_full_traffic.py -s                    (15 s)
    TRAFFIC_SECONDS=60 python -m pytest tests/benchmarks/test_full_traffic.py -s
"""

import os
import sys
import time

import pytest

from tests.benchmarks import rig

SECONDS = float(os.environ.get("TRAFFIC_SECONDS", "15"))
FRAMES_PER_S = 8100


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc; loopback of udp_multicast")
@pytest.mark.timeout(600)
def test_full_traffic(qapp, tmp_path, capsys, benchmark):
    counted, pictures = [0], []
    with (
        rig.helper("-m", "tests.benchmarks.other_arm", str(FRAMES_PER_S)) as arm,
        rig.window(qapp, tmp_path, lambda _device: rig.counting_bus(counted), rig.UDP) as program,
    ):
        client = program.view._client
        client.frame_ready.connect(lambda _picture: pictures.append(time.perf_counter()))
        connection = program.controller._connection
        with rig.helper("-m", "tests.benchmarks.bare_reader") as reader:
            lost, read = connection.frames_dropped, counted[0]
            cpu_s, began_s = time.process_time(), time.monotonic()
            pictures.clear()
            with rig.Gaps() as gaps:
                rig.run_for(SECONDS)
            took_s = time.monotonic() - began_s
            cpu_s = time.process_time() - cpu_s
            read, lost = counted[0] - read, connection.frames_dropped - lost
            shown = len(pictures)
            bare_read, bare_lost, bare_cpu_s = rig.end(reader)
        window_mb, picture_mb = rig.memory_mb(os.getpid()), rig.memory_mb(client.pid)
        rig.end(arm)
    benchmark.extra_info.update(lost=lost, bare_lost=bare_lost, pictures_per_s=shown / took_s)
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\n{FRAMES_PER_S} frames/s from another process, {took_s:.0f} s, drawing:")
        print(f"  armui        {read / took_s:6.0f} frames/s, {lost} lost, {cpu_s:.1f} s processor")
        print(
            f"  bare reader  {bare_read / took_s:6.0f} frames/s, {bare_lost:.0f} lost, "
            f"{bare_cpu_s:.1f} s processor"
        )
        print(rig.spread("GUI thread keeps an event waiting", gaps.late_ms))
        print(f"  pictures {shown / took_s:.1f}/s of 30 states/s")
        print(f"  memory: window {window_mb:.0f} MB and the tests, picture {picture_mb:.0f} MB")
    assert read > 0
    assert bare_read > 0
