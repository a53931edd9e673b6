"""The window's process, as the operator starts it: what it loads, and what it leaves behind."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QDeadlineTimer

from armui.doctor.probes.program import try_priority
from armui.system.thread_priority import NICE, RaisedBy
from tests.posix import kill, of_system, stand_still

linux = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc and /dev/shm")
LIMIT_MS = 120_000

PROGRAM = """
import json, multiprocessing, sys

def arm():
    # the number of the simulated arm's process
    from armui.sim.arm_process import PROCESS_NAME
    children = multiprocessing.active_children()
    return next((each.pid for each in children if each.name == PROCESS_NAME), None)

def main():
    # not above: the picture's process imports this file, too
    from PySide6.QtCore import QTimer
    from armui import app
    from armui.control.operating_state import LinkState
    from armui.start import StartOptions

    class Watched(app.Program):
        def __init__(self, *arguments, **more):
            super().__init__(*arguments, **more)
            self.online_before = False
            self.link = None
            self.controller.operating_state_changed.connect(self.tell_link)
            self.watch = QTimer(interval=20)
            self.watch.timeout.connect(self.look)
            self.watch.start()

        def tell_link(self, state):
            if state.link is not self.link:
                self.link = state.link
                if not self.watch.isActive():
                    problem = self.controller._connection.problem
                    told = {"link": self.link.name, "arm": arm()}
                    print(json.dumps({**told, "problem": problem and problem.code}), flush=True)

        def look(self):
            online = self.controller.operating_state.link is LinkState.ONLINE
            if self.view._picture is None and online:
                self.online_before = True
            if self.view.is_settled and online:
                self.watch.stop()
                heavy = {name.partition(".")[0] for name in sys.modules}
                heavy &= {"vtkmodules", "vtk", "pyvista", "trimesh", "yourdfpy", "ruckig"}
                told = {
                    "heavy": sorted(heavy),
                    "picture": self.view._client.pid,
                    "arm": arm(),
                    "online_before_the_picture": self.online_before,
                }
                print(json.dumps(told), flush=True)

    app.Program = Watched
    app.run(StartOptions(sim_generation=2))

if __name__ == "__main__":
    main()
"""


def is_running(pid):
    """Whether a process is there and no zombie."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except (FileNotFoundError, ProcessLookupError):
        return False
    return state != "Z"


def shared_memory_of(pid):
    return [path.name for path in Path("/dev/shm").glob(f"armui-{pid}-*")]


def wait_for_the_end_of(pid):
    """No clock but the limit: the end of a process of another's is seen by looking."""
    limit = QDeadlineTimer(LIMIT_MS)
    while is_running(pid):
        assert not limit.hasExpired(), "it goes on without its program"
        subprocess.run([sys.executable, "-c", ""], check=True)


def nice_of(pid, *beginnings):
    """The nice values of a process's first thread, and of those whose names begin so."""
    found = {}
    for task in Path(f"/proc/{pid}/task").iterdir():
        name = "first" if task.name == str(pid) else (task / "comm").read_text().strip()
        if name == "first" or name.startswith(beginnings):
            priority = of_system("getpriority")(of_system("PRIO_PROCESS"), int(task.name))
            found[f"{name} {task.name}"] = priority
    return found


def wait_until_it_goes_first(pid):
    """Window and bus; where the system does not let them, nothing changes."""
    nice = NICE if try_priority().by is not RaisedBy.NOBODY else 0
    limit = QDeadlineTimer(LIMIT_MS)
    while set((found := nice_of(pid, "bus ")).values()) != {nice} or len(found) < 2:
        assert not limit.hasExpired(), found
        subprocess.run([sys.executable, "-c", ""], check=True)


@linux
@pytest.mark.timeout(300)
def test_it_never_loads_vtk_and_a_killed_one_leaves_nothing(tmp_path):
    """Nor what the simulated arm is made of: that is a process, too, which may be killed itself."""
    script = tmp_path / "program.py"
    script.write_text(PROGRAM)
    root = str(Path(__file__).resolve().parent.parent)
    own = {name: str(tmp_path) for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME")}
    own |= {"XDG_STATE_HOME": str(tmp_path), "XDG_RUNTIME_DIR": str(tmp_path)}
    environment = {**os.environ, **own, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": root}
    with subprocess.Popen(
        [sys.executable, str(script)],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env=environment,
        text=True,
    ) as process:
        try:
            told = json.loads(process.stdout.readline())
            assert told["heavy"] == []
            assert told["online_before_the_picture"]
            assert is_running(told["picture"])
            wait_until_it_goes_first(process.pid)
            assert min(nice_of(told["picture"], "").values()) >= 0
            arm = told["arm"]
            assert is_running(arm)
            kill(arm)
            lost = json.loads(process.stdout.readline())
            assert (lost["link"], lost["problem"]) == ("LOST", "simulated_arm_ended")
            while (told_then := json.loads(process.stdout.readline()))["link"] != "ONLINE":
                pass
            assert told_then["arm"] not in {arm, None}  # another one, as after a power cut
            stand_still(told["picture"])  # the worst case: it can do nothing for itself
        finally:  # also when it has hung: leaving the block waits for its end
            process.kill()
        process.wait()
        wait_for_the_end_of(told["picture"])
        wait_for_the_end_of(told_then["arm"])
        assert shared_memory_of(process.pid) == []
