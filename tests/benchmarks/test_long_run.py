"""What the window's process takes over hours, with curves, events and a recording going on.

The arm's clock is stepped as fast as the computer goes: it moves, jogs, is stopped, made ready
again, and its settings are saved, three times a minute. What fills by design is stated apart: the
curves' samples (by rows: half an hour of the fullest traffic) and the recorder's ring. The event
log fills, too, up to 10,000 events.

    python -m pytest tests/benchmarks/test_long_run.py -s       (3 minutes of the arm's time)
    LONG_RUN_HOURS=10 python -m pytest tests/benchmarks/test_long_run.py -s
"""

import gc
import os
import sys
import time

import pytest
from PySide6.QtCore import QCoreApplication

import armui.bus.worker
from armui.arm.parameters import Parameter
from armui.control.motion.jog_path import JointJog
from armui.control.operations.started import Started
from armui.protocol.generation import Generation
from armui.system.helper_process import FileThread
from tests.app_driver import AppDriver
from tests.benchmarks import rig
from tests.benchmarks.test_memory import shared_arrays_mb
from tests.safety.fuzz.lockstep import LockstepWorker

HOURS = float(os.environ.get("LONG_RUN_HOURS", "0.05"))
LOOKS = 12
PLACES = ((20.0, 40.0, -40.0, 10.0, 20.0, 15.0), (-30.0, 60.0, -60.0, 0.0, 0.0, 0.0))
NEVER_MS = 3_600_000


class Worker(LockstepWorker):
    """The bus thread's work without its thread, telling the listeners as the thread does."""

    def _open(self):
        opened = super()._open()
        if opened:
            self._notifier.open(self._processor.codec, self._device.bitrate)
        return opened


class Driver(AppDriver):
    """A driver on whose bus nobody waits."""

    def _listen_closely(self, bus):
        receive = bus.recv
        bus.recv = lambda timeout=None: receive(0)
        self._host_bus = bus

    def _settle(self):
        worker = self.controller._connection._worker
        while worker is not None and worker.pump():
            pass
        QCoreApplication.processEvents()

    _settle_what_was_said = _settle


def round_of(driver, number):
    """Twenty seconds of work."""
    controller = driver.controller
    controller.motion.set_speed_percent(50)
    controller.motion.send_joints(PLACES[number % 2])
    driver.run(5.0)
    if isinstance(controller.jogging.start(JointJog(1, 1)), Started):
        driver.run(0.6)
        controller.jogging.stop()
    driver.run(2.0)
    if number % 7 == 0:
        controller.emergency_stop()
    if number % 11 == 0:
        controller.settings.save({Parameter("collision_level", 1): float(number % 3)})
    for _ in range(20):
        if controller.operating_state.cannot_move is None:
            break
        if controller.recovery.step.action is not None:
            controller.recovery.act(controller.recovery.step)
        driver.run(0.3)
    driver.run(10.0)
    driver.events.clear()


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.timeout(0)
def test_long_run(qapp, tmp_path, capsys, benchmark, monkeypatch):
    monkeypatch.setattr(armui.bus.worker, "BusWorker", Worker)
    files = FileThread()
    driver = Driver(qapp, "long run", tmp_path / "settings.json", Generation.TWO, files=files)
    driver.repeat_nothing()
    driver._ear.shutdown()  # a queue that nobody reads would grow
    driver.store.change(session_folder=str(tmp_path / "sessions"))
    driver.program._keep_events(tmp_path / "events", files)
    driver.ready()
    for part in (driver.controller, driver.controller.jogging):
        part._timer.setInterval(NEVER_MS)
    driver.click("plots_button")
    driver.click("events_button")
    assert driver.controller.sessions.start() is None
    began_s, began, number = time.perf_counter(), driver.time_s, 0
    looks: list[tuple[float, float, float, float, int]] = []
    while (passed_h := (driver.time_s - began) / 3600.0) < HOURS:
        if passed_h >= len(looks) * HOURS / LOOKS:
            gc.collect()
            whole, shared = rig.memory_mb("self"), shared_arrays_mb()
            looks.append((passed_h, whole, shared, whole - shared, sys.getallocatedblocks()))
        number += 1
        round_of(driver, number)
    lost = driver.controller.sessions.progress().lost
    benchmark.extra_info["rest_grown_mb"] = looks[-1][3] - looks[1][3]
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        took_s = time.perf_counter() - began_s
        print(f"\n{HOURS:g} hours of the arm's time in {took_s:.0f} s; {lost} frames lost; MB:")
        print("  hours   whole  samples and ring    rest  Python's blocks")
        for passed_h, whole, shared, rest, blocks in looks:
            print(f"  {passed_h:5.2f}  {whole:6.1f}  {shared:16.1f}  {rest:6.1f}  {blocks:15,}")
    driver.close()
    assert lost == 0
