"""How long the program takes to a usable window, against an empty PySide6 window in the same run.

Whole processes, from their start to the first idle moment of the event loop after the window was
painted. The 3D picture follows later: it is loaded beside a window that can already be used.
"""

import os
import statistics
import subprocess
import sys
import time

RUNS = 7

EMPTY = """
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QMainWindow
app = QApplication([])
window = QMainWindow()
window.resize(1280, 800)
window.show()
app.processEvents()
print("usable", flush=True)
"""

OURS = """
import sys
from pathlib import Path
from PySide6.QtWidgets import QApplication
from armui.app import Program, SIMULATED, open_device
from armui.control.arm_controller import ArmController
from armui.helper_process import HelperProcess
from armui.settings import SettingsStore
app = QApplication([])
controller = ArmController(open_device, SIMULATED)
program = Program(app, SettingsStore(Path(sys.argv[1])), controller, HelperProcess())
program.window.resize(1280, 800)
program.window.show()
app.processEvents()
print("usable", flush=True)
program.shutdown()
"""


def seconds_to_usable(script, cache, *arguments):
    environment = {
        **os.environ,
        "QT_QPA_PLATFORM": "offscreen",
        # an installed program is not compiled anew at each start, whatever the tests' shell says
        "PYTHONDONTWRITEBYTECODE": "",
        "PYTHONPYCACHEPREFIX": str(cache),
    }
    began = time.perf_counter()
    with subprocess.Popen(
        [sys.executable, "-c", script, *arguments], stdout=subprocess.PIPE, env=environment
    ) as process:
        assert process.stdout.readline().strip() == b"usable"
        took = time.perf_counter() - began
        process.stdout.read()
    assert process.returncode == 0
    return took


def test_start(tmp_path, capsys, benchmark):
    empty, ours = [], []
    settings = str(tmp_path / "settings.json")
    for number in range(RUNS + 1):
        pair = seconds_to_usable(EMPTY, tmp_path), seconds_to_usable(OURS, tmp_path, settings)
        if number:  # the first pair compiles, and warms the disk
            empty.append(pair[0])
            ours.append(pair[1])
    ratio = statistics.median(b / a for a, b in zip(empty, ours, strict=True))
    benchmark.extra_info["ratio"] = ratio
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\nempty window   {statistics.median(empty):.2f} s")
        print(f"armui          {statistics.median(ours):.2f} s   {ratio:.1f} times")
    assert len(ours) == RUNS
