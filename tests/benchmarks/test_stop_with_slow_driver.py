"""How long a press on the stop holds the window while the driver is slow.

The whole way from a mouse press to the end of its handler, beside a bare button's press in the same
run. A driver that is free, one that blocks 3 s in each ``send``, and one that times out after 1 s
on each frame; between the presses other commands are given. It states, and fails on no slow
machine.
"""

import sys
import threading
import time
from contextlib import contextmanager

import can
import numpy as np
import pytest
from can.interfaces.virtual import VirtualBus
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton

from armui.app import _SWITCH_INTERVAL_S
from armui.arm.device import Device
from armui.control.arm_controller import ArmController
from armui.control.link.link_state import LinkState
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from armui.ui.widgets.stop_button import StopButton

PRESSES = 40
BLOCKS_S = 3.0
TIMES_OUT_S = 1.0


class FreeBus(VirtualBus):
    """As python-can's own, and not known to be: the sending thread writes the stop."""

    ending = threading.Event()

    def send(self, msg, timeout=None):
        super().send(msg, timeout)


class BlockingBus(FreeBus):
    """Each frame takes three seconds."""

    def send(self, msg, timeout=None):
        self.ending.wait(BLOCKS_S)
        super().send(msg, timeout)


class TimingOutBus(FreeBus):
    """Nobody acknowledges; the driver ignores the time it is given."""

    def send(self, msg, timeout=None):
        self.ending.wait(TIMES_OUT_S)
        raise can.CanTimeoutError("nobody acknowledges")


KINDS = {
    "free, written by the caller": VirtualBus,
    "free, through the sending thread": FreeBus,
    "blocks 3 s a frame": BlockingBus,
    "times out after 1 s a frame": TimingOutBus,
}


@pytest.fixture(autouse=True)
def the_programs_own_switch_interval():
    before = sys.getswitchinterval()
    sys.setswitchinterval(_SWITCH_INTERVAL_S)
    yield
    sys.setswitchinterval(before)


def held_ms(act):
    began_s = time.perf_counter()
    act()
    return 1e3 * (time.perf_counter() - began_s)


def describe(name, times_ms):
    return (
        f"{name:44} median {np.median(times_ms):6.2f} ms   "
        f"p99 {np.percentile(times_ms, 99):6.2f} ms   worst {max(times_ms):6.2f} ms"
    )


@pytest.mark.timeout(300)
@pytest.mark.parametrize("name", KINDS)
def test_what_a_press_costs(qtbot, capsys, benchmark, name):
    channel = f"benchmark {name}"

    @contextmanager
    def opened(_device):
        with KINDS[name](channel) as bus:
            yield bus

    FreeBus.ending.clear()
    controller = ArmController(opened)
    stop, bare = StopButton(controller), QPushButton("bare")
    bare.pressed.connect(lambda: None)
    qtbot.addWidget(stop)
    qtbot.addWidget(bare)
    presses_ms, bare_ms, commands_ms = [], [], []
    arm_side = can.Bus(interface="virtual", channel=channel)
    with Node(Firmware(Generation.TWO), arm_side):
        controller.connect_device(Device("virtual", channel, None))
        qtbot.waitUntil(lambda: controller.operating_state.link is LinkState.ONLINE, timeout=20_000)
        for _ in range(PRESSES):
            presses_ms.append(held_ms(lambda: QTest.mousePress(stop, Qt.MouseButton.LeftButton)))
            QTest.mouseRelease(stop, Qt.MouseButton.LeftButton)
            bare_ms.append(held_ms(lambda: QTest.mousePress(bare, Qt.MouseButton.LeftButton)))
            QTest.mouseRelease(bare, Qt.MouseButton.LeftButton)
            commands_ms.append(held_ms(lambda: controller.lights.set_light(1, 1, 1, 2, 3)))
            qtbot.wait(5)
        FreeBus.ending.set()
        controller.shutdown()
    arm_side.shutdown()
    benchmark.extra_info["worst_ms"] = max(presses_ms)
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\ndriver: {name}")
        print(describe("  press on the stop, until the window goes on", presses_ms))
        print(describe("  another command", commands_ms))
        print(describe("  press on a bare button", bare_ms))
    assert len(presses_ms) == PRESSES
