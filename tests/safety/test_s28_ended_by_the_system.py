"""S28: what the system ends, ends like what the operator closes: motion, bus, processes, in 1 s."""

import json
import os
import queue
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import can
import pytest
from jeepney import DBusAddress, HeaderFields, new_method_return, new_signal
from PySide6.QtCore import QDeadlineTimer

from armui.control.arm_controller import ArmController
from armui.control.run.progress import Run
from armui.ending import SleepWatch, SystemEnd
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from armui.trajectory.points.cells import PointColumn
from armui.trajectory.points.program import GripperOpening
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from tests.accepted import accepted
from tests.arm_rig import thin_out
from tests.examples import sample
from tests.operator.editor.actions import OUT, Editor, to
from tests.posix import HANG_UP
from tests.test_window_process import LIMIT_MS, shared_memory_of, wait_for_the_end_of

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="sends signals, reads /proc"),
    pytest.mark.timeout(150),
]

PORT = 46212
ABORT = (0x150, bytes([0, 6, 0, 0, 0, 0, 0, 0]))  # byte 1: the trajectory command 6, end it
LONGEST_S = 1.0
BUSY_COMPUTER_S = 4.0
"""What a computer that runs other tests beside may add to the end of a process."""
SIGNALS = (signal.SIGTERM, HANG_UP, signal.SIGINT)
ROOT = Path(__file__).resolve().parents[2]


class Outside:
    """An arm, and somebody who listens, on a bus that is no part of the program's process."""

    def __init__(self, tmp_path):
        self.group = f"239.74.163.{os.getpid() % 200 + 20}"
        options: dict[str, Any] = {
            "interface": "udp_multicast",
            "channel": self.group,
            "port": PORT,
        }
        self.arm_bus, self.ear = can.Bus(**options), can.Bus(**options)
        self.firmware = Firmware(Generation.TWO)
        thin_out(self.firmware)  # datagrams are lost where a busy computer does not read them
        self.node = Node(self.firmware, self.arm_bus)
        own = {name: str(tmp_path) for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME")}
        own |= {"XDG_STATE_HOME": str(tmp_path), "XDG_RUNTIME_DIR": str(tmp_path)}
        self.environment = {
            **os.environ,
            **own,
            "QT_QPA_PLATFORM": "offscreen",
            "PYTHONPATH": str(ROOT),
        }
        self.process = None
        self.picture = None

    def begin(self, state):
        """Start the program; it drives the arm, and does what `state` says."""
        script = str(ROOT / "tests" / "safety" / "ended_program.py")
        self.process = subprocess.Popen(
            [sys.executable, script, str(PORT), self.group, state],
            stdout=subprocess.PIPE,
            env=self.environment,
            text=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # noqa: PLW1509 - no lock in it
        )
        self.picture = json.loads(self.process.stdout.readline())["picture"]

    def hear_the_end(self, *, by):
        """Whether the end of the motion is heard within a second of a signal."""
        while self.ear.recv(0) is not None:
            pass
        began_s = time.monotonic()
        self.process.send_signal(by)
        while (left_s := began_s + LONGEST_S - time.monotonic()) > 0:
            message = self.ear.recv(left_s)
            if message is not None and (message.arbitration_id, bytes(message.data)) == ABORT:
                return time.monotonic() - began_s
        return None

    def close(self):
        if self.process is not None:
            self.process.kill()
            self.process.wait()
            self.process.stdout.close()
        self.arm_bus.shutdown()
        self.ear.shutdown()


@pytest.fixture
def outside(tmp_path):
    outside = Outside(tmp_path)
    with outside.node:
        yield outside
    outside.close()


AT_NIGHT = [
    ("run", HANG_UP),
    ("run", signal.SIGINT),
    ("menu", signal.SIGTERM),
    ("dialog", signal.SIGTERM),
    ("busy", signal.SIGTERM),
]
"""Each starts a program: `HYPOTHESIS_PROFILE=nightly` has them, too."""


@pytest.mark.parametrize(
    ("state", "by"),
    [("run", signal.SIGTERM), ("stuck", signal.SIGTERM), *sample(AT_NIGHT, 0)],
    ids=lambda value: value if isinstance(value, str) else value.name,
)
def test_a_signal_in_mid_motion_ends_it(outside, state, by):
    outside.begin(state)
    began_s = time.monotonic()
    heard_s = outside.hear_the_end(by=by)
    outside.process.send_signal(by)  # once more: nothing of the first one's ending is undone
    code = outside.process.wait(10.0)
    gone_s = time.monotonic() - began_s
    assert heard_s is not None
    assert code == 128 + by
    print(f"{state} {by.name}: motion ended after {heard_s:.3f} s, program after {gone_s:.3f} s")
    wait_for_the_end_of(outside.picture)
    limit = QDeadlineTimer(LIMIT_MS)
    while shared_memory_of(outside.process.pid):  # Python's tracker lets go a moment later
        assert not limit.hasExpired()
        subprocess.run([sys.executable, "-c", ""], check=True)
    assert outside.firmware.joints_deg[0] < 55.0
    assert max(map(abs, outside.firmware.mechanics.speeds_deg_s)) < 0.1


@pytest.mark.parametrize(
    ("state", "by"),
    sample([(s, by) for s in ("opening", "closing", "disk") for by in SIGNALS], 3, seed=1),
)
def test_nothing_that_hangs_keeps_the_program_open(outside, tmp_path, state, by):
    """A device that is being opened, or closed already, and a disk when the device is closed."""
    outside.begin(state)
    time.sleep(0.3)
    began_s = time.monotonic()
    outside.process.send_signal(by)
    time.sleep(0.1)
    outside.process.send_signal(by)
    code = outside.process.wait(15.0)
    gone_s = time.monotonic() - began_s
    assert code == 128 + by
    assert gone_s < LONGEST_S + BUSY_COMPUTER_S
    print(f"{state} {by.name}: program ended after {gone_s:.3f} s")
    if outside.picture is not None:
        wait_for_the_end_of(outside.picture)
    (log,) = tmp_path.rglob("armui.log")
    assert ("Not written, the disk was too slow: sleep" in log.read_text()) is (state == "disk")
    assert "Traceback" not in log.read_text()


# Without a process of its own --------------------------------------------------------------------

FAR = (60.0, 60.0, -60.0, 0.0, 0.0, 0.0)


@pytest.fixture
def system_end(qapp, app_driver):
    """In mid-motion; its signals are not followed, for they would end the tests."""
    app_driver.ready()
    accepted(app_driver.controller.motion.send_joints(FAR))
    app_driver.run(0.5)
    app_driver.heard()
    ends: list[int] = []
    system_end = SystemEnd(qapp, app_driver.program, ends.append)
    setattr(system_end, "ends", ends)  # noqa: B010 - for the tests alone
    yield system_end
    system_end._listening.close()
    system_end._wakes.close()


def aborts(rig):
    return [frame for frame in rig.heard() if (frame.arbitration_id, bytes(frame.data)) == ABORT]


def at_rest(rig):
    return max(map(abs, rig.firmware.mechanics.speeds_deg_s)) < 0.1


def test_a_log_out_ends_the_motion(app_driver, system_end):
    """The slot of `commitDataRequest` is called directly: no session manager is there to ask."""
    system_end._on_session_ends()
    assert len(aborts(app_driver)) == 1
    app_driver.run(1.0)
    assert at_rest(app_driver)
    assert app_driver.window.isVisible()  # another program may call the log-out off
    accepted(app_driver.controller.motion.send_joints(FAR))


def test_a_window_that_is_held_up_does_not_keep_the_arm_moving(app_driver, system_end):
    """Nothing of Qt works meanwhile; the arm hears of the end from another thread."""
    thread = threading.Thread(target=system_end.end_motion_in_time)
    thread.start()
    thread.join(5.0)
    assert not thread.is_alive()
    assert 2 <= len(aborts(app_driver)) <= 6  # nobody sees whether the arm heard the first
    app_driver.run(1.0)
    assert at_rest(app_driver)


@pytest.mark.parametrize("held_up", [False, True])
def test_a_gripper_that_a_run_has_sent_is_ended_with_it(qapp, app_driver, held_up):
    """It comes to its end in the next row's motion, of which nobody is there to see anything."""
    rig = app_driver
    rig.ready()
    near = to((5.0, 0.0, 0.0, 0.0, 0.0, 0.0), gripper=GripperOpening(70.0))
    accepted(rig.controller.player.start(Run("Test", (near, to(FAR)), (5.0, 5.0))))
    gripper = rig.firmware.gripper
    rig.run_until(lambda: 10.0 < gripper.travel < 40.0, seconds=10.0)
    ending = SystemEnd(qapp, rig.program, lambda code: pytest.fail(str(code)))
    if held_up:
        thread = threading.Thread(target=ending.end_motion_in_time)
        thread.start()
        thread.join(5.0)
    else:
        ending._end_motion()
    at_end = gripper.travel
    rig.run(2.0)
    assert gripper.travel == pytest.approx(at_end, abs=5.0)
    assert gripper.enabled
    assert at_rest(rig)
    ending._listening.close()
    ending._wakes.close()


def test_what_is_not_saved_is_kept_and_nobody_is_asked(app_driver, qapp):
    editor = Editor(app_driver, to(OUT))
    editor.type_into(0, PointColumn.DWELL, "2")
    codes: list[int] = []
    ending = SystemEnd(qapp, app_driver.program, codes.append)
    ending._on_asked(signal.SIGTERM)  # at once: the draft's own second has not passed
    assert editor.library.draft("Test").points[0].dwell_s == 2.0
    assert not [w for w in qapp.topLevelWidgets() if isinstance(w, ConfirmDialog) and w.isVisible()]
    assert app_driver.program.closed.is_set()
    assert not app_driver.program.unwritten
    assert codes == [128 + signal.SIGTERM]
    ending._listening.close()
    ending._wakes.close()


class Lock:
    def __init__(self, happened):
        self.happened = happened
        happened.append("lock")

    def close(self):
        self.happened.append("go on")


class Logind:
    """The system's bus, and logind behind it."""

    def __init__(self):
        self.happened = []
        self.messages: queue.Queue[Any] = queue.Queue()
        self.sock = self

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.happened.append("closed")

    def send_and_get_reply(self, call, timeout):
        member = call.header.fields[HeaderFields.member]
        if member != "Inhibit":
            return new_method_return(call)
        assert call.body == (
            "sleep:shutdown",
            "armui",
            "The arm's motion is ended first",
            "delay",
        )
        return new_method_return(call, "h", (Lock(self.happened),))

    def say(self, member, *, begins):
        manager = DBusAddress("/org/freedesktop/login1", None, "org.freedesktop.login1.Manager")
        self.messages.put(new_signal(manager, member, "b", (begins,)))

    def receive(self):
        message = self.messages.get(timeout=30.0)
        if message is None:
            raise ConnectionResetError
        return message

    def shutdown(self, _how):
        self.messages.put(None)


@pytest.mark.parametrize("member", ["PrepareForSleep", "PrepareForShutdown"])
def test_sleep_is_held_up_until_the_motion_has_ended(member):
    logind = Logind()
    watch = SleepWatch(lambda: logind.happened.append("motion ended"), lambda: logind)
    watch.start()
    logind.say("SessionNew", begins=True)
    logind.say(member, begins=True)
    logind.say(member, begins=True)
    logind.say(member, begins=False)
    watch._thread.join(0.0)
    logind.shutdown(socket.SHUT_RDWR)
    watch._thread.join(5.0)
    watch.end()
    assert logind.happened == [
        *("lock", "motion ended", "go on", "motion ended", "lock", "go on", "closed"),
    ]


@pytest.mark.parametrize("error", [FileNotFoundError("no bus"), KeyError("no address")])
def test_without_a_bus_of_the_system_nothing_is_heard_and_nothing_said(error, capsys):
    def connect():
        raise error

    watch = SleepWatch(pytest.fail, connect)
    watch.start()
    watch._thread.join(5.0)
    assert not watch._thread.is_alive()
    watch.end()
    assert capsys.readouterr() == ("", "")


def test_the_thread_of_the_signals_makes_no_part_of_the_controller(qapp, qtlog):
    """Without a device there is nothing to end; a part made in that thread would be its child."""

    def no_bus(_device):
        raise OSError("there is none")

    controller = ArmController(no_bus)
    thread = threading.Thread(target=controller.abort_from_any_thread)
    thread.start()
    thread.join()
    assert "gripper" not in vars(controller)
    controller.shutdown()
    assert [each.message for each in qtlog.records] == []
