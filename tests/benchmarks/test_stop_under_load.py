"""How late a stop is while the program does what takes long, beside a bare button in the same run.

The whole program in real time, as in `test_stop_latency`. It states figures and fails on none: how
fast they are says more of the computer than of the code.
"""

import gc
import sys
import threading
import time
from typing import Any

import can
import numpy as np
import pytest
from can.interfaces.virtual import VirtualBus
from PySide6.QtCore import QEvent, QEventLoop, QPointF, Qt, QTimer
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QPushButton

from armui.app import _SWITCH_INTERVAL_S, Program, load_pages
from armui.arm.device import Device
from armui.control.arm_controller import ArmController
from armui.control.run.replay import Replay
from armui.control.run.sample_store import SampleStore
from armui.protocol import commands
from armui.protocol.codes import MoveMode
from armui.protocol.generation import Generation
from armui.settings import SettingsStore
from armui.sim.node import Node
from armui.system.helper_process import FileThread, HelperProcess
from armui.trajectory import files
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.planning.check import warm_up
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording, replay_profile
from tests.accepted import accepted
from tests.benchmarks.rig import spread
from tests.benchmarks.test_stop_latency import CHANNEL, STOP_ID, DeafToStops

RATE_HZ = 200
LOADS = (
    *("nothing", "a .log of 10,000 points", "a .log of 30,000 points", "a .log of 100,000 points"),
    *("ending a recording of 30 min", "ending a recording of 120 min"),
    *("replaying 30 min", "replaying 120 min", "checking 10,000 points"),
)
PRESSES = 100
"""At least so many for each load and button."""
LONGEST_S = 30.0


class TimedBus(VirtualBus):
    """Notes when each emergency stop is on the bus; 0x150 says other things, too."""

    def __init__(self, on_stop):
        super().__init__(CHANNEL)
        self._on_stop = on_stop

    def send(self, msg, timeout=None):
        super().send(msg, timeout)
        if msg.arbitration_id == STOP_ID and msg.data[0] == 1:
            self._on_stop(time.time())


class Presses(threading.Thread):
    """Presses two buttons in turn until it is told to end; notes when."""

    def __init__(self, stop, bare):
        super().__init__(name="mouse")
        self._buttons = (stop, bare)
        # asked here: the widgets belong to this thread
        self._places = {
            button: (center := QPointF(button.rect().center()), button.mapToGlobal(center))
            for button in self._buttons
        }
        self.pressed_s: dict[Any, Any] = {stop: [], bare: []}
        self.seen = threading.Event()
        self.enough = threading.Event()

    def run(self):
        number = 0
        pause = threading.Event()
        while not self.enough.is_set():
            button = self._buttons[number % 2]
            number += 1
            pause.wait(0.011)
            self.seen.clear()
            self.pressed_s[button].append(time.time())
            QApplication.postEvent(button, self._event(button, QEvent.Type.MouseButtonPress))
            self.seen.wait(20)
            QApplication.postEvent(button, self._event(button, QEvent.Type.MouseButtonRelease))

    def _event(self, button, kind):
        left = Qt.MouseButton.LeftButton
        return QMouseEvent(kind, *self._places[button], left, left, Qt.KeyboardModifier.NoModifier)


class GuiWatch:
    """The longest time between two looks of the GUI thread at its events.

    What the thread itself has worked in the meantime stands beside it: the rest of the time others
    had the processor, or Python's lock.
    """

    def __init__(self):
        self.longest_s = self.longest_work_s = 0.0
        self._last_s, self._last_work_s = time.perf_counter(), time.thread_time()
        self.timer = QTimer(interval=1)
        self.timer.timeout.connect(self._look)
        self.timer.start()

    def _look(self):
        now_s, work_s = time.perf_counter(), time.thread_time()
        self.longest_s = max(self.longest_s, now_s - self._last_s)
        self.longest_work_s = max(self.longest_work_s, work_s - self._last_work_s)
        self._last_s, self._last_work_s = now_s, work_s


def minutes(count):
    """A recording of so many minutes; the arm sways slowly."""
    times_s = np.arange(0.0, 60.0 * count, 1.0 / RATE_HZ)
    samples = np.full((len(times_s), 8), np.nan)
    samples[:, 0] = times_s
    samples[:, 1:7] = (0.0, 30.0, -30.0, 0.0, 0.0, 0.0)
    samples[:, 1] = 20.0 * np.sin(times_s / 10.0)
    return Recording(f"{count} min", samples=samples)


def points(count):
    """A trajectory of so many points near each other."""
    row = [
        Waypoint(MoveMode.MOVE_J, (round(20.0 * np.sin(0.01 * n), 3), 30.0, -30.0, 0.0, 0.0, 0.0))
        for n in range(count)
    ]
    return Trajectory(f"{count} points", points=tuple(row))


class Loads:
    """Begins each load, and knows when it is over."""

    def __init__(self, program, folder):
        self.controller = program.controller
        self.window = program.window.pages.trajectories._library
        self.folder = folder
        self.texts = {
            count: files.to_bytes(points(count), ".log") for count in (10_000, 30_000, 100_000)
        }
        self.recordings = {count: minutes(count) for count in (30, 120)}
        self.profiles = {count: replay_profile(one) for count, one in self.recordings.items()}
        self.checked = points(10_000)

    def prepare(self, name):
        """Returns what begins the load, and then tells whether it is over."""
        figures = [int(word.replace(",", "")) for word in name.split() if word[0].isdigit()]
        for word, prepare in (
            ("a .log", self._file),
            ("ending", self._end_recording),
            ("replaying", self._replay),
            ("checking", self._check),
        ):
            if name.startswith(word):
                return prepare(figures[0])
        return lambda: lambda: True

    def _file(self, count):
        def begin():
            (self.folder / f"{count}.log").write_bytes(self.texts[count])
            self.window.refresh()
            return lambda: f"{count} points" in self.window._table.names()

        return begin

    def _end_recording(self, count):
        self.window.open_recorder()
        window = self.window.editors._recorder
        window._on_record()
        store, samples = SampleStore(), self.recordings[count].samples
        chunk = len(store._chunk)
        store._full = [samples[at : at + chunk].copy() for at in range(0, len(samples), chunk)]
        self.controller.recorder._samples = store

        def begin():
            window._on_record()
            return lambda: window._result is not None

        return begin

    def _replay(self, count):
        def begin():
            replay = Replay(self.recordings[count], profile=self.profiles[count])
            accepted(self.controller.replayer.start(replay))
            return lambda: self.controller.replayer.progress.done > 0.0

        return begin

    def _check(self, _count):
        def begin():
            over: list[Any] = []
            self.window._checks.begin(self.checked, RunOptions(), over.append)
            return lambda: bool(over)

        return begin


def measure(begin, stop, bare):
    """The presses while a load goes on, how long it lasted, and the GUI thread's longest holds."""
    mouse, watch, loop = Presses(stop, bare), GuiWatch(), QEventLoop()
    for button in (stop, bare):
        button.pressed.connect(mouse.seen.set)
    began_s = time.perf_counter()
    over = begin()
    took_s: list[float] = []

    def look():
        if not took_s and over():
            took_s.append(time.perf_counter() - began_s)
        pressed = len(mouse.pressed_s[bare])
        if (took_s and pressed >= PRESSES) or time.perf_counter() - began_s > LONGEST_S:
            loop.quit()

    timer = QTimer(interval=5)
    timer.timeout.connect(look)
    timer.start()
    mouse.start()
    loop.exec()
    mouse.enough.set()
    while mouse.is_alive():
        QApplication.processEvents()
    timer.stop()
    watch.timer.stop()
    for button in (stop, bare):
        button.pressed.disconnect(mouse.seen.set)
    return mouse.pressed_s, took_s[0] if took_s else LONGEST_S, watch


def delays_s(pressed_s, done_s):
    """From each press to the next effect: one stop may serve two presses."""
    nexts = np.searchsorted(done_s, pressed_s)
    known = nexts < len(done_s)
    return np.array(done_s)[nexts[known]] - np.array(pressed_s)[known]


@pytest.mark.timeout(900)
def test_stop_under_load(qapp, tmp_path, capsys, benchmark):
    before = sys.getswitchinterval()
    sys.setswitchinterval(_SWITCH_INTERVAL_S)
    list(load_pages())
    folder = tmp_path / "trajectories"
    folder.mkdir()
    arm_side = can.Bus(interface="virtual", channel=CHANNEL)
    firmware = DeafToStops(Generation.TWO)
    sent_s: list[float] = []
    handled_s: list[float] = []
    controller = ArmController(lambda _device: TimedBus(sent_s.append))
    workers, filer = HelperProcess(), FileThread()
    store = SettingsStore(tmp_path / "settings.json")
    program = Program(qapp, store, controller, workers, folder, files=filer)
    program.view.hide()
    program.window.show()
    bare = QPushButton("bare")
    bare.show()
    bare.pressed.connect(lambda: handled_s.append(time.time()))
    with Node(firmware, arm_side):
        controller.connect_device(Device("virtual", CHANNEL, None, simulated=True, generation=2))
        _wait(lambda: controller.operating_state.generation is not None)
        _wait(lambda: None not in controller.operating_state.enabled)
        controller.motors.enable()
        _wait(lambda: controller.operating_state.cannot_move is None)
        program.window.open_library_window()
        workers.submit(warm_up).result(120)
        filer.submit(filer.call, warm_up).result(120)
        bare_stop = QPushButton("stop")
        bare_stop.show()
        # the stop's own frames, without what it ends: the load is to go on
        bare_stop.pressed.connect(
            lambda: controller._connection.send_urgent(
                commands.emergency_stop(controller._connection.codec)
            )
        )
        loads = Loads(program, folder)
        gc.collect()
        gc.freeze()
        for name in LOADS:
            begin = loads.prepare(name)
            _wait(lambda: controller.operating_state.cannot_run is None)
            sent_s.clear()
            handled_s.clear()
            pressed_s, took_s, watch = measure(begin, bare_stop, bare)
            to_bus_ms = 1e3 * delays_s(pressed_s[bare_stop], sent_s)
            to_handler_ms = 1e3 * delays_s(pressed_s[bare], handled_s)
            held_ms, worked_ms = 1e3 * watch.longest_s, 1e3 * watch.longest_work_s
            lines = [
                f"{name}: {took_s:.1f} s, GUI thread held {held_ms:.0f}, worked {worked_ms:.0f} ms",
                spread("  stop: press to frame on the bus", to_bus_ms),
                spread("  bare button: press to handler", to_handler_ms),
            ]
            with capsys.disabled():
                print("\n" + "\n".join(lines))
            controller.replayer.stop()
            _wait(lambda: not controller.operating_state.running)
        program.shutdown()
    for widget in (bare, bare_stop, program.window):
        widget.deleteLater()
    arm_side.shutdown()
    sys.setswitchinterval(before)
    benchmark.pedantic(lambda: None, rounds=1)


def _wait(condition):
    for _ in range(60_000):
        QTest.qWait(1)
        if condition():
            return
    raise AssertionError("it never came")
