"""The window's process, as the operator starts it: what it loads, and what it leaves behind."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QDeadlineTimer

linux = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc and /dev/shm")
LIMIT_MS = 120_000

PROGRAM = """
import json, sys
from pathlib import Path

def main():
    # not above: the picture's process imports this file, too
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QApplication
    from armui.app import SIMULATED, Program, open_device
    from armui.control.arm_controller import ArmController
    from armui.control.situation import LinkState
    from armui.helper_process import HelperProcess
    from armui.settings import SettingsStore

    app = QApplication([])
    controller = ArmController(open_device, SIMULATED)
    folder = Path(sys.argv[1])
    store = SettingsStore(folder / "settings.json")
    program = Program(app, store, controller, HelperProcess(), folder / "trajectories")
    program.window.show()
    program.controller.connect_device(SIMULATED[0])
    view = program.view
    online_before = []

    def look():
        if view._picture is None and controller.situation.link is LinkState.ONLINE:
            online_before.append(True)
        if view.is_settled and controller.situation.link is LinkState.ONLINE:
            timer.stop()
            heavy = {name.partition(".")[0] for name in sys.modules}
            heavy &= {"vtkmodules", "vtk", "pyvista", "trimesh", "yourdfpy"}
            print(json.dumps({
                "heavy": sorted(heavy),
                "picture": view._client.pid,
                "online_before_the_picture": bool(online_before),
            }), flush=True)

    timer = QTimer(interval=20)
    timer.timeout.connect(look)
    timer.start()
    app.exec()

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


@linux
@pytest.mark.timeout(300)
def test_it_never_loads_vtk_and_a_killed_one_leaves_nothing(tmp_path):
    script = tmp_path / "program.py"
    script.write_text(PROGRAM)
    root = str(Path(__file__).resolve().parent.parent)
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": root}
    with subprocess.Popen(
        [sys.executable, str(script), str(tmp_path)],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env=environment,
        text=True,
    ) as process:
        told = json.loads(process.stdout.readline())
        assert told["heavy"] == []
        assert told["online_before_the_picture"]
        assert is_running(told["picture"])
        os.kill(told["picture"], signal.SIGSTOP)  # the worst case: it can do nothing for itself
        process.kill()
        process.wait()
        wait_for_the_end_of(told["picture"])
        assert shared_memory_of(process.pid) == []
