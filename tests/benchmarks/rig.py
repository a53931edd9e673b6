"""What benchmarks of the whole window share: the program, company on the bus, measuring."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

import can
import numpy as np
from PySide6.QtCore import QEvent, QEventLoop, QObject, QTimer
from PySide6.QtWidgets import QApplication

from armui.app import _SWITCH_INTERVAL_S, Program, keep_from_collector
from armui.arm.device import Device
from armui.bus.worker import Opener
from armui.control.arm_controller import ArmController
from armui.control.link.link_state import LinkState
from armui.settings import SettingsStore
from armui.system.clock import steady_s
from armui.system.helper_process import HelperProcess
from armui.system.thread_priority import raise_threads
from armui.ui.garbage import GarbageSearch
from tests.benchmarks.other_arm import BUS
from tests.waiting import wait_until

BUSY = "while True: pass"


@contextmanager
def helper(*arguments: str) -> Iterator[subprocess.Popen[str]]:
    """A process of a benchmark; ready when it has printed its first line."""
    with subprocess.Popen(
        [sys.executable, *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        try:
            process.stdout.readline()
            yield process
        finally:
            process.kill()


def end(process: subprocess.Popen[str]) -> list[float]:
    """End a process of a benchmark; the figures it prints."""
    process.stdin.write("\n")
    process.stdin.flush()
    return [float(word) for word in process.stdout.readline().split()]


@contextmanager
def all_cores_busy() -> Iterator[None]:
    """As many processes as there are cores, each taking all it gets."""
    with ExitStack() as stack:
        for _ in range(os.cpu_count() or 1):
            code = f"print('busy', flush=True)\n{BUSY}"
            stack.enter_context(helper("-c", code))
        yield


@contextmanager
def window(
    app: QApplication,
    folder: Path,
    open_bus: Opener,
    device: Device,
    clock: Callable[[], float] = steady_s,
) -> Iterator[Program]:
    """The program as the operator has it, connected, with the picture on the screen."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(_SWITCH_INTERVAL_S)
    GarbageSearch(app)
    controller = ArmController(open_bus, clock=clock)
    store = SettingsStore(folder / "settings.json")
    program = Program(app, store, controller, HelperProcess(), folder / "trajectories")
    program.window.resize(1520, 800)  # leaves 900×700 and a little more to the picture
    program.window.show()
    controller.connect_device(device)
    wait_until(lambda: controller.operating_state.link is LinkState.ONLINE)
    wait_until(lambda: program.view._picture is not None)
    keep_from_collector()
    raise_threads()
    try:
        yield program
    finally:
        lower_threads()
        program.shutdown()
        program.window.deleteLater()
        sys.setswitchinterval(before)


def lower_threads() -> None:
    """What comes after in this process has the priority of any program."""
    if sys.platform == "linux":
        for task in Path("/proc/self/task").iterdir():
            with suppress(ProcessLookupError):
                os.setpriority(os.PRIO_PROCESS, int(task.name), 0)


UDP = Device(BUS["interface"], BUS["channel"], None, options=(("port", BUS["port"]),))


@contextmanager
def counting_bus(counted: list[int]) -> Iterator[can.BusABC]:
    """The bus of `other_arm`, which counts what it hands on."""
    with can.Bus(**BUS) as bus:
        receive = bus.recv

        def recv(timeout: float | None = None) -> can.Message | None:
            message = receive(timeout)
            counted[0] += message is not None
            return message

        bus.recv = recv
        yield bus


class Gaps(QObject):
    """How long the GUI thread keeps an event waiting that another thread posts every few ms."""

    PERIOD_S = 0.004

    def __init__(self) -> None:
        super().__init__()
        self.late_ms: list[float] = []
        self._posted_s = 0.0
        self._done = threading.Event()
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._post, name="gaps")

    def __enter__(self) -> Gaps:
        self._thread.start()
        return self

    def __exit__(self, *_reason: object) -> None:
        self._ending.set()
        self._done.set()
        self._thread.join()

    def _post(self) -> None:
        while not self._ending.wait(self.PERIOD_S):
            self._done.clear()
            self._posted_s = time.perf_counter()
            QApplication.postEvent(self, QEvent(QEvent.Type.User))
            while not self._done.wait(self.PERIOD_S) and not self._ending.is_set():
                pass  # nobody takes the event any more once it is ended

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.User:
            self.late_ms.append(1e3 * (time.perf_counter() - self._posted_s))
            self._done.set()
            return True
        return super().event(event)


def run_for(seconds: float) -> None:
    """Let the program run."""
    loop = QEventLoop()
    QTimer.singleShot(round(1e3 * seconds), loop.quit)
    loop.exec()


def spread(name: str, values_ms: list[float]) -> str:
    """A line of the table."""
    p50, p95, p99 = np.percentile(values_ms, (50, 95, 99))
    return (
        f"  {name:44} p50 {p50:6.2f}  p95 {p95:6.2f}  p99 {p99:6.2f}  "
        f"worst {max(values_ms):6.2f} ms"
    )


def memory_mb(pid: int | str | None) -> float:
    """What a process takes, shared memory in equal shares (Linux)."""
    for line in Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines():
        if line.startswith("Pss:"):
            return int(line.split()[1]) / 1024.0
    raise ValueError(f"no figure of process {pid}")
