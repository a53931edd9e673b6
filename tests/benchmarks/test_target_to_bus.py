"""How long a client's target takes to its frame on the bus, while the whole program runs.

The window with its picture, the simulated arm in another process, and a client of the local
interface in a third. The arm rests when a target comes, so that the first frame after it is its
own. Beside it in the same run: a ping of the client's, a bare Unix socket's echo, and a bare relay
that puts a frame on udp_multicast by python-can for each line it reads. Once as the computer is,
and once with every core kept busy by other processes.

    python -m pytest tests/benchmarks/test_target_to_bus.py -s
    TARGETS=500 python -m pytest --timeout=600 tests/benchmarks/test_target_to_bus.py -s
"""

import json
import os
import subprocess
import sys
import threading
import time
from contextlib import contextmanager, nullcontext

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication

from armui.interface.interface import Interface
from armui.simulated_arms import SIMULATED, SimulatedArms
from armui.system.clock import steady_s
from armui.system.thread_priority import raise_threads
from tests.accepted import accepted
from tests.benchmarks import rig
from tests.waiting import wait_until

TARGETS = int(os.environ.get("TARGETS", "150"))
TARGET_ID = 0x155


@contextmanager
def timed(arms, device, sent_s):
    """The simulated arm's bus, which notes when each target is on it."""
    with arms.connected(device) as bus:
        send = bus.send

        def timed_send(message, timeout=None):
            send(message, timeout)
            if message.arbitration_id == TARGET_ID:
                sent_s.append(time.time())

        bus.send = timed_send
        yield bus


def measured(process, sent_s):
    """Have the client measure while the program runs; what it has found."""
    found: list[str] = []

    def wait():
        process.stdin.write("\n")
        process.stdin.flush()
        found.append(process.stdout.readline())
        QApplication.exit(0)

    waiting = threading.Thread(target=wait)
    sent_s.clear()
    waiting.start()
    QApplication.instance().exec()
    waiting.join()
    assert found[0], "the client has failed"
    return {name: np.array(values) for name, values in json.loads(found[0]).items()}


@pytest.mark.timeout(900)
@pytest.mark.skipif(sys.platform != "linux", reason="the interface is not offered there")
@pytest.mark.parametrize("load", [nullcontext, rig.all_cores_busy], ids=["as it is", "busy"])
def test_target_to_bus(qapp, tmp_path, capsys, benchmark, load):
    sent_s: list[float] = []
    arms = SimulatedArms()
    relay_path = tmp_path / "relay.sock"
    with (
        rig.window(
            qapp, tmp_path, lambda device: timed(arms, device, sent_s), SIMULATED[0]
        ) as program,
        rig.helper("-m", "tests.benchmarks.bare_relay", str(relay_path)),
    ):
        controller = program.controller
        accepted(controller.motors.enable())
        wait_until(lambda: controller.operating_state.cannot_move is None)
        path = tmp_path / "r" / "api.sock"
        # the arm is simulated: nobody need hold a button
        interface = Interface(controller, path, steady_s, grants_itself=True)
        interface.switch(on=True)
        wait_until(lambda: interface.view.on)
        raise_threads()
        arguments = ("tests.benchmarks.stream_client", str(path), str(relay_path), str(TARGETS))
        process = subprocess.Popen(
            [sys.executable, "-m", *arguments],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        began: list[str] = []
        waiting = threading.Thread(target=lambda: began.append(process.stdout.readline()))
        waiting.start()
        try:
            wait_until(lambda: began)
            assert began == ["ready\n"]
            with load():
                found = measured(process, sent_s)
        finally:
            process.kill()
            process.communicate()  # closes its pipes, too
            interface.end()
    on_bus_s = np.sort(sent_s)
    firsts_s = on_bus_s[np.searchsorted(on_bus_s, found["said_s"])]
    target_ms = 1e3 * (firsts_s - found["said_s"])
    benchmark.extra_info["p99_ms"] = float(np.percentile(target_ms, 99))
    benchmark.extra_info["relay_p99_ms"] = float(np.percentile(1e3 * found["relayed_s"], 99))
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\n{load.__name__}, {TARGETS} targets; leases lost: {len(found['losses'])}")
        print(rig.spread("target of a client to frame on bus", target_ms))
        print(rig.spread("bare relay: line to frame on bus", 1e3 * found["relayed_s"]))
        print(rig.spread("ping of the client, there and back", 1e3 * found["ping_s"]))
        print(rig.spread("bare Unix socket, there and back", 1e3 * found["echo_s"]))
    assert len(target_ms) == TARGETS
