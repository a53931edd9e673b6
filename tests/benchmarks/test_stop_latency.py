"""How long a stop takes from the mouse press to the frame on the bus, while everything else runs.

The whole program in real time: the simulated arm sends 3,000 frames a second, moves, and is drawn.
Another thread presses the mouse at moments the program cannot foresee. In the same run, the same
presses on a bare button tell how much of it is Qt's and Python's own.
"""

import gc
import random
import sys
import threading
import time

import can
import numpy as np
import pytest
from can.interfaces.virtual import VirtualBus
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QPushButton

from armui.app import _SWITCH_INTERVAL_S, Program
from armui.arm.device import Device
from armui.control.arm_controller import ArmController
from armui.helper_process import HelperProcess
from armui.protocol import commands
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.settings import SettingsStore
from armui.sim.firmware import Firmware
from armui.sim.node import Node

PRESSES = 300
CHANNEL = "benchmark-stop"
STOP_ID = 0x150
ENDS_DEG = ((60, 90, -60, 40, 30, 60), (-60, 40, -90, -40, -30, -60))


class DeafToStops(Firmware):
    """Goes on moving, so that the picture goes on being drawn."""

    def on_frame(self, frame):
        return [] if frame.arbitration_id == STOP_ID else super().on_frame(frame)


def press_event(widget, kind):
    center = QPointF(widget.rect().center())
    buttons = Qt.MouseButton.LeftButton
    return QMouseEvent(
        kind, center, widget.mapToGlobal(center), buttons, buttons, Qt.KeyboardModifier.NoModifier
    )


class TimedBus(VirtualBus):
    """Notes when each stop frame is on the bus."""

    def __init__(self, on_stop):
        super().__init__(CHANNEL)
        self._on_stop = on_stop

    def send(self, msg, timeout=None):
        super().send(msg, timeout)
        if msg.arbitration_id == STOP_ID:
            self._on_stop(time.time())


class Mouse(threading.Thread):
    """Presses a button at random moments; waits after each until it has had its effect."""

    def __init__(self, buttons):
        super().__init__(name="mouse")
        self._buttons = buttons
        self._random = random.Random(4)
        self.pressed_s = {button: [] for button in buttons}
        self.seen = threading.Event()

    def run(self):
        for number in range(PRESSES * len(self._buttons)):
            button = self._buttons[number % len(self._buttons)]
            pause = threading.Event()
            pause.wait(self._random.uniform(0.02, 0.05))
            self.seen.clear()
            press = press_event(button, QEvent.Type.MouseButtonPress)
            self.pressed_s[button].append(time.time())
            QApplication.postEvent(button, press)
            self.seen.wait(5)
            QApplication.postEvent(button, press_event(button, QEvent.Type.MouseButtonRelease))
        QApplication.exit(0)  # quit() would ask: the arm is moving


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


def describe(name, latencies_ms):
    p50, p99 = np.percentile(latencies_ms, (50, 99))
    worst = max(latencies_ms)
    return f"{name:34} p50 {p50:6.2f} ms   p99 {p99:6.2f} ms   worst {worst:6.2f} ms"


@pytest.mark.timeout(300)
def test_stop_latency(qapp, tmp_path, capsys, benchmark):
    before = sys.getswitchinterval()
    sys.setswitchinterval(_SWITCH_INTERVAL_S)
    codec = Codec(Generation.TWO)
    arm_side = can.Bus(interface="virtual", channel=CHANNEL)
    firmware = DeafToStops(Generation.TWO)
    sent_s, handled_s = [], []
    controller = ArmController(lambda _device: TimedBus(sent_s.append))
    program = Program(qapp, SettingsStore(tmp_path / "settings.json"), controller, HelperProcess())
    program.view.first_frame_shown.connect(gc.freeze)  # as the program itself does
    program.window.resize(1520, 800)  # leaves 900×700 and a little more to the picture
    program.window.show()
    bare = QPushButton("bare")
    bare.show()
    bare.pressed.connect(lambda: handled_s.append(time.time()))
    stopping = threading.Event()
    mover = threading.Thread(target=keep_moving, args=(firmware, codec, stopping))
    with Node(firmware, arm_side):
        assert _wait(lambda: program.view._image is not None)
        controller.connect_device(Device("virtual", CHANNEL, None, simulated=True, generation=2))
        mover.start()
        assert _wait(lambda: controller.situation.moving)
        stop_button = program.window.findChild(QPushButton, "stop_button")
        mouse = Mouse([stop_button, bare])
        for button in (stop_button, bare):
            button.pressed.connect(mouse.seen.set)
        # no repeats: each stop frame is a press's own
        stop_button.pressed.connect(controller._stop.keeper.forget)
        frames = []
        program.view._renderer.frame_ready.connect(lambda _image: frames.append(time.monotonic()))
        mouse.start()
        qapp.exec()
        mouse.join()
        size = program.view.size().toTuple()
        stopping.set()
        mover.join()
        program.shutdown()
    bare.deleteLater()
    program.window.deleteLater()
    arm_side.shutdown()
    sys.setswitchinterval(before)

    to_bus_ms = 1e3 * (np.array(sent_s) - mouse.pressed_s[stop_button])
    to_handler_ms = 1e3 * (np.array(handled_s) - mouse.pressed_s[bare])
    benchmark.extra_info["p99_ms"] = float(np.percentile(to_bus_ms, 99))
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print("\n" + describe("stop: mouse press to frame on bus", to_bus_ms))
        print(describe("bare button: press to handler", to_handler_ms))
        rate = (len(frames) - 1) / (frames[-1] - frames[0])
        print(f"3D picture meanwhile: {rate:.0f} frames/s at {size[0]}×{size[1]}, one a state")
    assert len(to_bus_ms) == PRESSES


def _wait(condition):
    for _ in range(20_000):
        QTest.qWait(1)
        if condition():
            return True
    return False
