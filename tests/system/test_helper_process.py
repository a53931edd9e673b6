"""Work in a process of its own: it comes back, whatever becomes of that process."""

import os
import signal
import subprocess
import sys
import time
from concurrent.futures import BrokenExecutor, CancelledError
from pathlib import Path

import pytest

from armui.system.helper_process import HelperProcess
from armui.trajectory.planning.check import CheckRequest, check, warm_up
from tests.posix import of_system
from tests.trajectory.arms import ARM, joint, run

MOST_S = 60.0


@pytest.fixture
def helper():
    helper = HelperProcess()
    yield helper
    helper.shutdown()


def test_it_is_another_process_and_always_the_same(helper):
    pids = {helper.submit(os.getpid).result(MOST_S) for _ in range(3)}
    assert len(pids) == 1
    assert os.getpid() not in pids


def test_a_check_comes_back_as_it_would_here(helper):
    order = CheckRequest(
        run(joint(0, 0, 0, 0, 0, 0), joint(10, 200, -60, 0, 25, 0)), ARM, (0.0,) * 6
    )
    there, here = helper.submit(check, order).result(MOST_S), check(order)
    assert there.findings == here.findings
    assert {finding.code for finding in there.findings} >= {"target_beyond_limit"}
    assert there.expected_s == here.expected_s
    assert (there.path.joints_deg == here.path.joints_deg).all()


def test_an_error_comes_back(helper):
    with pytest.raises(ZeroDivisionError):
        helper.submit(divmod, 1, 0).result(MOST_S)
    assert helper.submit(divmod, 7, 2).result(MOST_S) == (3, 1)


def test_a_process_that_dies_is_replaced(helper):
    with pytest.raises(BrokenExecutor):
        helper.submit(os._exit, 3).result(MOST_S)
    assert helper.submit(warm_up).result(MOST_S) is None


def test_a_process_that_dies_is_noted_and_one_that_is_ended_is_not(helper, caplog):
    with pytest.raises(BrokenExecutor):
        helper.submit(os._exit, 3).result(MOST_S)
    assert "Work in the helper process has failed" in caplog.text

    caplog.clear()
    helper.submit(os.getpid).result(MOST_S)
    endless = helper.submit(time.sleep, 1e6)
    while not endless.running() and not helper._pool._pending_work_items:
        time.sleep(0.01)
    helper.shutdown()
    assert not caplog.text
    assert helper.submit(divmod, 7, 2).result(MOST_S) == (3, 1)


def test_the_end_waits_for_no_work(helper):
    pid = helper.submit(os.getpid).result(MOST_S)
    endless, next_in_line = helper.submit(time.sleep, 1e6), helper.submit(warm_up)
    helper.shutdown()
    with pytest.raises((BrokenExecutor, CancelledError)):
        endless.result(MOST_S)
    with pytest.raises((BrokenExecutor, CancelledError)):
        next_in_line.result(MOST_S)
    assert not _lives(pid)


@pytest.mark.skipif(sys.platform == "win32", reason="asks the system in the manner of POSIX")
def test_it_does_not_outlive_a_killed_program(tmp_path):
    script = tmp_path / "program.py"
    script.write_text(
        "import os, time\n"
        "from armui.system.helper_process import HelperProcess\n"
        "if __name__ == '__main__':\n"
        "    print(HelperProcess().submit(os.getpid).result(), flush=True)\n"
        "    time.sleep(1e6)\n"
    )
    with subprocess.Popen([sys.executable, script], stdout=subprocess.PIPE, text=True) as program:
        pid = int(program.stdout.readline())
        assert _lives(pid)
        program.kill()
    deadline = time.monotonic() + MOST_S
    while _lives(pid) and time.monotonic() < deadline:
        of_system("sched_yield")()
    assert not _lives(pid)


@pytest.mark.skipif(not hasattr(os, "nice"), reason="the system knows no such thing")
def test_it_stands_back_and_leaves_ctrl_c_to_the_program(helper):
    nice = of_system("nice")
    assert helper.submit(nice, 0).result(MOST_S) == min(nice(0) + 5, 19)
    assert helper.submit(signal.getsignal, signal.SIGINT).result(MOST_S) == signal.SIG_IGN


def _lives(pid):
    """Whether a process is there and no mere entry its parent has not read yet."""
    try:
        os.kill(pid, 0)
        return Path(f"/proc/{pid}/stat").read_text("ascii").rpartition(")")[2].split()[0] != "Z"
    except (ProcessLookupError, FileNotFoundError):
        return False
