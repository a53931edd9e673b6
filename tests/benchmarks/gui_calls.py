"""The ten longest calls of the GUI thread, and what it works in all.

    python -m tests.benchmarks.gui_calls SECONDS [FRAMES_PER_S]

The whole program with the simulated arm in a process of its own, moving and drawn. Each event that
Qt delivers is timed, with the processor time of the GUI thread beside it: on a busy computer a call
takes long because others had the processor.
"""

from __future__ import annotations

import collections
import os
import sys
import tempfile
import time
from pathlib import Path

from tests.benchmarks.other_arm import BUS

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import can
from PySide6.QtCore import QCoreApplication, QEvent, QObject
from PySide6.QtWidgets import QApplication

from tests.benchmarks import rig

SHOWN = 10
FRAMES_PER_S = "3000"


class TimedApplication(QApplication):
    """Notes how long each event takes that is delivered from the event loop."""

    def __init__(self) -> None:
        super().__init__([])
        self.calls: dict[str, list[tuple[float, float]]] = collections.defaultdict(list)
        self._depth = 0
        self.is_noting = False

    def notify(self, receiver: QObject, event: QEvent) -> bool:
        if self._depth or not self.is_noting:
            return super().notify(receiver, event)
        name = f"{_name(receiver)}: {event.type().name}"
        self._depth = 1
        began_s, cpu_s = time.perf_counter(), time.thread_time()
        try:
            return super().notify(receiver, event)
        finally:
            self._depth = 0
            spent = time.perf_counter() - began_s, time.thread_time() - cpu_s
            self.calls[name].append(spent)


def _name(receiver: QObject) -> str:
    name = receiver.objectName() or type(receiver).__name__
    parent = receiver.parent()
    return name if parent is None else f"{type(parent).__name__}/{name}"


def main() -> None:
    """Run, then print the table."""
    frames_per_s = sys.argv[2] if len(sys.argv) > 2 else FRAMES_PER_S
    app = TimedApplication()
    with (
        tempfile.TemporaryDirectory() as folder,
        rig.helper("-m", "tests.benchmarks.other_arm", frames_per_s),
        rig.window(app, Path(folder), lambda _device: can.Bus(**BUS), rig.UDP),
    ):
        rig.run_for(1.0)
        app.is_noting = True
        worked_s = time.thread_time()
        rig.run_for(float(sys.argv[1]))
        worked_s = time.thread_time() - worked_s
        app.is_noting = False
    slowest = sorted(app.calls.items(), key=lambda item: max(c for _, c in item[1]), reverse=True)
    print(f"{'worst ms':>9} {'cpu ms':>7} {'median':>7} {'times':>6}  call")
    for name, spent in slowest[:SHOWN]:
        wall_s, cpu_s = max(spent, key=lambda each: each[1])
        median_s = sorted(c for _, c in spent)[len(spent) // 2]
        print(
            f"{1e3 * wall_s:9.2f} {1e3 * cpu_s:7.2f} {1e3 * median_s:7.2f} {len(spent):6}  {name}"
        )
    share = 100.0 * worked_s / float(sys.argv[1])
    print(f"{frames_per_s} frames/s: the GUI thread works {share:.1f} % of the time")
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)


if __name__ == "__main__":
    main()
