"""The live stream for Foxglove beside the stop: rate, age, memory, press to frame.

The whole program in real time, an arm of another process that sends 3,000 frames a second. By
turns in the same run the stop is pressed while the stream is off, and while it is on with four
viewers that read nothing and a fifth that reads everything.

    python -m pytest tests/benchmarks/test_live_stream.py -s
    STOP_PRESSES=500 python -m pytest tests/benchmarks/test_live_stream.py -s
"""

import subprocess
import sys
from contextlib import ExitStack

import numpy as np
import pytest

from tests.benchmarks import rig
from tests.benchmarks.test_stop_latency import PRESSES, other_process, press_again_and_again, timed
from tests.live.viewer import Viewer
from tests.waiting import wait_until

SILENT = 4
TURNS = 2
PORT = 8767
pytest.importorskip("foxglove")


@pytest.mark.timeout(900)
@pytest.mark.skipif(sys.platform != "linux", reason="loopback of udp_multicast")
def test_live_stream_and_stop(qapp, tmp_path, capsys, benchmark):
    sent_s: list[float] = []
    took_ms: dict[str, list[float]] = {"off": [], "on": []}
    memory_mb, seen, behind, lost = [], "", 0, 0
    with ExitStack() as stack:
        open_bus, device = stack.enter_context(other_process())
        program = stack.enter_context(
            rig.window(
                qapp, tmp_path, lambda device: timed(open_bus(device), sent_s.append), device
            )
        )
        wait_until(lambda: program.controller.operating_state.moving)
        live = program.live
        for _turn in range(TURNS):
            live.switch(on=False, port=PORT, for_others=False)
            took_ms["off"] += list(press_again_and_again(qapp, program, sent_s)[0])
            live.switch(on=True, port=PORT, for_others=False)
            wait_until(lambda: live.view.state.on)
            with ExitStack() as turn:
                for _ in range(SILENT):
                    viewer = Viewer(PORT, buffer=4096)
                    turn.callback(viewer.close)
                    viewer.watch()
                wait_until(lambda: live.view.state.watched)
                words = [sys.executable, "-m", "tests.live.viewer", str(PORT), "60"]
                reader = subprocess.Popen(words, stdout=subprocess.PIPE, text=True)
                process = live._sender._process
                rig.run_for(3.0)
                memory_mb.append(rig.memory_mb(process.pid))
                wait_until(lambda: live.view.state.behind)  # what they don't read fills all queues
                took_ms["on"] += list(press_again_and_again(qapp, program, sent_s)[0])
                while reader.poll() is None:
                    rig.run_for(0.2)
                memory_mb.append(rig.memory_mb(process.pid))
                seen = reader.communicate()[0]
                behind, lost = live.view.state.behind, live._frames.dropped
    benchmark.extra_info.update({f"{name}_ms": max(each) for name, each in took_ms.items()})
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\n{TURNS} × {PRESSES} presses each, mouse press to the stop's frame on the bus")
        print(rig.spread("without the live stream", took_ms["off"]))
        print(rig.spread(f"with it, {SILENT} viewers that don't read", took_ms["on"]))
        print(seen, end="")
        print(f"  process {np.round(memory_mb, 1)} MB; seen behind {behind}, frames lost {lost}")
    assert len(took_ms["on"]) == TURNS * PRESSES
