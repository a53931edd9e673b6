"""How long the program takes to a usable window, against an empty PySide6 window in the same run.

Whole processes, from their start to the first idle moment of the event loop after the window was
painted; then to an arm that answers, and to the first 3D picture, which is loaded in a process of
its own beside a window that can already be used. And what each process takes of the memory then.
"""

import os
import statistics
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

RUNS = int(os.environ.get("START_RUNS", "7"))

EMPTY = """
import time
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QMainWindow
app = QApplication([])
window = QMainWindow()
window.resize(1280, 800)
window.show()
app.processEvents()
print("usable", flush=True)
print(time.process_time())
"""

OURS = """
import gc, multiprocessing, os, sys, time
from functools import partial
from pathlib import Path

def pss_mb(pid):
    lines = Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines()
    return next(int(line.split()[1]) / 1024 for line in lines if line.startswith("Pss:"))

def main():
    # not above: the picture's process imports this file, too
    from PySide6.QtCore import QTimer
    from armui.app import Program, open_device
    from armui.simulated_arms import SIMULATED, SimulatedArms
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import LinkState
    from armui.system.helper_process import FileThread, HelperProcess
    from armui.settings import SettingsStore
    from armui.ui.theme import make_application

    app = make_application([])
    arms = SimulatedArms()
    arms.begin(SIMULATED[0])  # as the command does
    controller = ArmController(partial(open_device, arms=arms), SIMULATED)
    store, files = SettingsStore(Path(sys.argv[1])), FileThread()
    program = Program(app, store, controller, HelperProcess(), files=files)
    program.window.resize(1280, 800)
    program.window.show()
    app.processEvents()
    worked_s = time.process_time()
    print("usable", flush=True)
    gc.freeze()  # as the command does
    controller.connect_device(SIMULATED[0])
    told = set()

    def tell(word, is_so):
        if is_so and word not in told:
            told.add(word)
            print(word, flush=True)

    def look():
        tell("connected", controller.operating_state.link is LinkState.ONLINE)
        tell("picture", program.view._picture is not None and not program.view._is_frame_new)
        if len(told) == 2:
            timer.stop()
            children = {each.name: each.pid for each in multiprocessing.active_children()}
            arm = children["armui-simulated-arm"]
            memory = [pss_mb(pid) for pid in (os.getpid(), program.view._client.pid, arm)]
            print(*memory, worked_s, flush=True)
            app.quit()

    timer = QTimer(interval=2)
    timer.timeout.connect(look)
    timer.start()
    app.exec()
    program.shutdown()

if __name__ == "__main__":
    main()
"""


def seconds_to(words, script, cache, *arguments):
    """Seconds from the start until the process prints each of some words; what it prints last."""
    environment = {
        **os.environ,
        "QT_QPA_PLATFORM": "offscreen",
        # an installed program is not compiled anew at each start, whatever the tests' shell says
        "PYTHONDONTWRITEBYTECODE": "",
        "PYTHONPYCACHEPREFIX": str(cache),
    }
    path = cache / "script.py"
    path.write_text(script)
    took_s: dict[Any, Any] = {}
    began_s = time.perf_counter()
    with subprocess.Popen(
        [sys.executable, str(path), *arguments],
        stdout=subprocess.PIPE,
        env=environment | {"PYTHONPATH": str(Path.cwd())},
        text=True,
    ) as process:
        while len(took_s) < len(words):
            word = process.stdout.readline().strip()
            assert word in words, word
            took_s[word] = time.perf_counter() - began_s
        rest = process.stdout.read().split()
    assert process.returncode == 0
    return took_s, [float(figure) for figure in rest]


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.timeout(900)
def test_start(tmp_path, capsys, benchmark):
    empty_s, ours_s, memory_mb, work = [], [], [], []
    settings = str(tmp_path / "settings.json")
    for number in range(RUNS + 1):
        empty, [empty_work_s] = seconds_to(["usable"], EMPTY, tmp_path)
        ours, [*memory, ours_work_s] = seconds_to(
            ["usable", "connected", "picture"], OURS, tmp_path, settings
        )
        if number:  # the first pair compiles, and warms the disk
            empty_s.append(empty["usable"])
            ours_s.append(ours)
            memory_mb.append(memory)
            work.append((empty_work_s, ours_work_s))
    pairs = zip(empty_s, ours_s, strict=True)
    ratio = statistics.median(ours["usable"] / empty for empty, ours in pairs)
    benchmark.extra_info["ratio"] = ratio
    benchmark.pedantic(lambda: None, rounds=1)
    window_mb, picture_mb, arm_mb = map(statistics.median, zip(*memory_mb, strict=True))
    with capsys.disabled():
        print(f"\nempty window         {statistics.median(empty_s):.2f} s")
        for word in ("usable", "connected", "picture"):
            print(f"armui, {word:13} {statistics.median(ours[word] for ours in ours_s):.2f} s")
        print(f"usable in {ratio:.1f} times the empty window's time")
        ratio = statistics.median(ours / empty for empty, ours in work)
        empty_ms, ours_ms = (1e3 * statistics.median(each) for each in zip(*work, strict=True))
        print(f"processor time till then {ours_ms:.0f} ms of {empty_ms:.0f} ms, {ratio:.1f} times")
        each_mb = f"window {window_mb:.0f} MB, picture {picture_mb:.0f} MB"
        print(f"memory: {each_mb}, simulated arm {arm_mb:.0f} MB")
    assert len(ours_s) == RUNS
