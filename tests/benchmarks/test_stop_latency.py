"""How long a stop takes from the mouse press to the frame on the bus, while everything else runs.

The whole program in real time: an arm sends 3,000 frames a second, moves, and is drawn. Another
thread presses the mouse at moments the program cannot foresee. In the same run, the same presses on
a bare button tell how much of it is Qt's and Python's own: one in the same process, one in another
program that has no window but the button.

Four ways: the arm in a process of its own; the same with every core kept busy by other processes;
the same with a picture's process that stands still and is replaced again and again; and the
simulated arm within the program.

    python -m pytest tests/benchmarks/test_stop_latency.py -s
    STOP_PRESSES=1000 python -m pytest tests/benchmarks/test_stop_latency.py -s
"""

import os
import sys
import threading
import time
from contextlib import ExitStack, contextmanager
from typing import Any

import can
import numpy as np
import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QPushButton

from armui.arm.device import Device
from armui.protocol import commands
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from armui.system.thread_priority import raise_threads
from tests.benchmarks import rig
from tests.benchmarks.bare_button import Mouse
from tests.benchmarks.other_arm import BUS
from tests.posix import stand_still
from tests.waiting import wait_until

PRESSES = int(os.environ.get("STOP_PRESSES", "200"))
FRAMES_PER_S = 3000
CHANNEL = "benchmark-stop"
STOP_ID = 0x150
ENDS_DEG = ((60, 90, -60, 40, 30, 60), (-60, 40, -90, -40, -30, -60))


class DeafToStops(Firmware):
    """Goes on moving, so that the picture goes on being drawn."""

    def on_frame(self, frame):
        return [] if frame.arbitration_id == STOP_ID else super().on_frame(frame)


@contextmanager
def timed(opened, on_stop):
    """A bus that notes when each stop frame is on it."""
    with opened as bus:
        send = bus.send

        def timed_send(message, timeout=None):
            send(message, timeout)
            if message.arbitration_id == STOP_ID:
                on_stop(time.time())

        bus.send = timed_send
        yield bus


def keep_moving(firmware, codec, stopping):
    """Send the simulated arm to and fro behind the program's back."""
    ends = list(ENDS_DEG)
    frames = commands.enable_motors(codec)
    while not stopping.wait(1.5):
        frames += commands.move_joints(codec, ends[0], speed_percent=60)
        ends.reverse()
        for frame in frames:
            firmware.on_frame(frame)
        frames = []


def udp_bus(_device):
    return can.Bus(**BUS)


@contextmanager
def other_process():
    """The arm in a process of its own."""
    with rig.helper("-m", "tests.benchmarks.other_arm", str(FRAMES_PER_S)):
        yield udp_bus, rig.UDP


@contextmanager
def same_process():
    """The simulated arm within the program."""
    codec, firmware = Codec(Generation.TWO), DeafToStops(Generation.TWO)
    stopping = threading.Event()
    mover = threading.Thread(target=keep_moving, args=(firmware, codec, stopping))
    with can.Bus(interface="virtual", channel=CHANNEL) as arm_side, Node(firmware, arm_side):
        mover.start()
        device = Device("virtual", CHANNEL, None, simulated=True, generation=2)
        try:
            yield lambda _device: can.Bus(interface="virtual", channel=CHANNEL), device
        finally:
            stopping.set()
            mover.join()


@contextmanager
def nothing(_program):
    yield


@contextmanager
def busy_cores(_program):
    with rig.all_cores_busy():
        yield


@contextmanager
def standing_picture(program):
    """The picture's process is made to stand still whenever there is one."""
    client = program.view._client

    def stop():
        if client._link is None:
            return  # it is being replaced
        client._link._restarts._lost_s.clear()
        if client.pid is not None and program.view._lost is None:
            stand_still(client.pid)

    timer = QTimer(interval=1000)
    timer.timeout.connect(stop)
    timer.start()
    yield
    timer.stop()


def press_again_and_again(qapp, program, sent_s):
    """The latencies in ms, of the stop and of a bare button in the same process."""
    handled_s = []
    bare = QPushButton("bare")
    bare.show()
    bare.pressed.connect(lambda: handled_s.append(time.time()))
    controller = program.controller
    stop_button = program.window.findChild(QPushButton, "stop_button")
    mouse = Mouse((stop_button, bare), PRESSES)
    for button in (stop_button, bare):
        button.pressed.connect(mouse.seen.set)
    # no repeats: each stop frame is a press's own
    stop_button.pressed.connect(controller._stop.emergency_stop.reset)
    sent_s.clear()
    mouse.start()
    raise_threads()  # a mouse of the window system's waits for no turn of this process
    qapp.exec()
    mouse.join()
    bare.deleteLater()
    pressed_s = mouse.pressed_s
    first_s = [min(at for at in sent_s if at >= press) for press in pressed_s[stop_button]]
    return (
        1e3 * (np.array(first_s) - pressed_s[stop_button]),
        1e3 * (np.array(handled_s) - pressed_s[bare]),
    )


def press_elsewhere(qapp):
    """The same of a bare button in another program, while this one goes on; ms."""
    with rig.helper("-m", "tests.benchmarks.bare_button", str(PRESSES)) as process:
        taken_ms: list[float] = []

        def wait():
            taken_ms.extend(rig.end(process))
            QApplication.exit(0)

        waiting = threading.Thread(target=wait)
        waiting.start()
        qapp.exec()
        waiting.join()
    return np.array(taken_ms)


@pytest.mark.timeout(900)
@pytest.mark.skipif(sys.platform != "linux", reason="loopback of udp_multicast, signals")
@pytest.mark.parametrize(
    ("arm", "load"),
    [
        (other_process, nothing),
        (other_process, busy_cores),
        (other_process, standing_picture),
        (same_process, nothing),
    ],
    ids=lambda way: way.__name__,
)
def test_stop_latency(qapp, tmp_path, capsys, benchmark, arm, load):
    sent_s: list[float] = []
    pictures: list[Any] = []
    with ExitStack() as stack:
        open_bus, device = stack.enter_context(arm())
        program = stack.enter_context(
            rig.window(
                qapp, tmp_path, lambda device: timed(open_bus(device), sent_s.append), device
            )
        )
        wait_until(lambda: program.controller.operating_state.moving)
        stack.enter_context(load(program))
        program.view._client.frame_ready.connect(lambda _p: pictures.append(time.monotonic()))
        began_s = time.monotonic()
        stop_ms, bare_ms = press_again_and_again(qapp, program, sent_s)
        took_s = time.monotonic() - began_s
        other_ms = press_elsewhere(qapp)
    benchmark.extra_info["p99_ms"] = float(np.percentile(stop_ms, 99))
    benchmark.extra_info["bare_p99_ms"] = float(np.percentile(bare_ms, 99))
    benchmark.extra_info["other_p99_ms"] = float(np.percentile(other_ms, 99))
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\narm: {arm.__name__}, load: {load.__name__}, {PRESSES} presses each")
        print(rig.spread("stop: mouse press to frame on bus", stop_ms))
        print(rig.spread("bare button: press to handler", bare_ms))
        print(rig.spread("bare button in another program", other_ms))
        print(f"  3D picture meanwhile: {len(pictures) / took_s:.0f}/s")
    assert len(stop_ms) == PRESSES
