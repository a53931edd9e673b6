"""S23: what nobody expected is told once, kept in the log, ends its own motion and nothing else."""

import logging
import os
import subprocess
import sys
import threading
from typing import Any

import pytest
from PySide6.QtCore import QObject, QThread, Signal
from PySide6.QtGui import QGuiApplication

from armui import app
from armui.control.motion.jog_path import JointJog
from armui.start import StartOptions
from armui.system import failures
from armui.system.helper_process import HelperProcess
from armui.system.log_file import UnhurriedHandler, log_to
from tests.accepted import accepted


class Breaks(QObject):
    said = Signal()

    def __init__(self):
        super().__init__()
        self.said.connect(self.fail)

    def fail(self):
        raise ZeroDivisionError("in a slot")


@pytest.fixture
def told(monkeypatch):
    """Hooks in place, as in the program, and what they told; pytest-qt's own come back after."""
    heard: list[Any] = []
    handler = failures.FailureHandler(heard.append)
    logger = logging.getLogger("armui")
    logger.addHandler(handler)
    monkeypatch.setattr(logger, "propagate", False)
    with failures.hooks():
        yield heard
    logger.removeHandler(handler)


def test_an_exception_in_a_slot_is_told(qapp, told):
    breaks = Breaks()
    breaks.said.emit()
    (failure,) = told
    assert failure.error == "ZeroDivisionError: in a slot"
    assert 'raise ZeroDivisionError("in a slot")' in failure.text
    assert failure.text.startswith("armui ")


def test_an_exception_in_a_thread_is_told(told):
    thread = threading.Thread(target=lambda: 1 / 0, name="worker 7")
    thread.start()
    thread.join()
    assert [failure.error for failure in told] == ["ZeroDivisionError: division by zero"]
    assert "worker 7" in told[0].text


def test_an_exception_in_a_thread_of_qt_is_told(qapp, told):
    class Thread(QThread):
        def run(self):
            raise KeyError("gone")

    thread = Thread()
    thread.start()
    assert thread.wait(5000)
    assert [failure.error for failure in told] == ["KeyError: 'gone'"]


def test_a_failure_that_repeats_is_one_failure(qapp, told):
    breaks = Breaks()
    for _ in range(250):
        breaks.said.emit()
    assert [failure.count for failure in told] == list(range(1, 251))


def test_the_hooks_of_before_come_back():
    before = sys.excepthook, threading.excepthook
    with failures.hooks():
        assert sys.excepthook is not before[0]
    assert (sys.excepthook, threading.excepthook) == before


def test_the_log_keeps_it_and_collapses_repetitions(tmp_path, qapp, told):
    with log_to(tmp_path / "logs") as path:
        breaks = Breaks()
        for _ in range(250):
            breaks.said.emit()
    text = path.read_text(encoding="utf-8")
    assert text.count("ZeroDivisionError: in a slot") == 3
    assert "(time 10)" in text
    assert "(time 100)" in text


def test_the_log_rotates(tmp_path):
    with log_to(tmp_path):
        for number in range(300):
            logging.getLogger("armui.test").warning("%d %s", number, "x" * 20_000)
            if number % 100 == 99:
                handler = logging.getLogger("armui").handlers[-1]
                assert isinstance(handler, UnhurriedHandler)
                handler.lines.join()
    names = sorted(path.name for path in tmp_path.iterdir())
    assert names == ["armui.log", *(f"armui.log.{n}" for n in (1, 2, 3, 4))]
    assert sum(path.stat().st_size for path in tmp_path.iterdir()) < 5_100_000


@pytest.mark.parametrize("in_the_way", [True, False])
def test_a_log_that_cannot_be_written_keeps_nothing_from_starting(tmp_path, in_the_way):
    folder = tmp_path / "file"
    if in_the_way:
        folder.touch()
    else:
        (folder / "armui.log").mkdir(parents=True)
    with log_to(folder) as path:
        assert path is None


def test_the_window_says_it_in_one_line_with_a_text_to_copy(app_driver, told):
    breaks = Breaks()
    breaks.said.emit()
    line = app_driver.find("failure_line")
    assert line.isVisible()
    assert "ZeroDivisionError: in a slot" in line.text()
    assert "\n" not in line.text()
    app_driver.click("failure_copy_button")
    assert 'raise ZeroDivisionError("in a slot")' in QGuiApplication.clipboard().text()
    breaks.said.emit()
    assert "2 times" in line.text()
    app_driver.click("failure_close_button")
    assert not line.isVisible()
    for ends in (False, True):  # put away, it comes again where it has ended a motion
        app_driver.window.show_failure(told[-1], motion_ended=ends)
        assert line.isVisible() == ends


def test_a_jog_whose_part_fails_ends_and_the_stop_still_stops(any_driver, told, monkeypatch):
    arm = any_driver
    arm.ready()
    jogging = arm.controller.jogging
    accepted(jogging.start(JointJog(1, 1)))
    arm.run_until(lambda: arm.controller.operating_state.jogging)
    arm.run(0.5)

    def breaks():
        raise ArithmeticError("of a jog")

    monkeypatch.setattr(jogging, "follow_arm", breaks)
    arm.step()
    assert not jogging.active
    assert "ArithmeticError: of a jog" in arm.find("failure_line").text()
    arm.run(0.5)
    before = arm.controller.state.angles_deg()[0]
    arm.run(0.5)
    assert arm.controller.state.angles_deg()[0] == pytest.approx(before, abs=0.01)
    arm.controller.emergency_stop()
    arm.run_until(lambda: "stop_confirmed" in arm.codes(), 1.0)


def test_an_error_of_our_own_in_the_bus_thread_is_told_and_a_lost_device_is_not(
    rig, told, monkeypatch, qtbot
):
    rig.connect()
    rig.unplug(OSError(19, "gone"))
    qtbot.waitUntil(lambda: "link_lost" in rig.codes())
    assert told == []
    rig.plug_in()
    qtbot.waitUntil(lambda: "reconnected" in rig.codes())

    monkeypatch.setattr(
        rig.controller._connection._worker, "_take_in", None
    )  # calling it raises in the worker
    rig.node.poll(0.02)
    qtbot.waitUntil(lambda: bool(told))
    assert told[0].error.startswith("TypeError")


def test_the_program_runs_with_hooks_and_a_log(tmp_path, monkeypatch):
    seen = []
    before = sys.excepthook
    monkeypatch.setattr("armui.system.paths.logs", lambda: tmp_path / "logs")

    def run(_options):
        seen.append(sys.excepthook)
        return 7

    monkeypatch.setattr("armui.app._run", run)
    assert app.run(StartOptions()) == 7
    assert seen[0] is not before
    assert sys.excepthook is before
    assert (tmp_path / "logs" / "armui.log").is_file()


def test_work_that_fails_in_the_helper_process_is_logged(caplog):
    helper = HelperProcess()
    with pytest.raises(ZeroDivisionError), caplog.at_level(logging.WARNING, "armui"):
        helper.submit(divmod, 1, 0).result(60)
    helper.shutdown()
    assert "ZeroDivisionError" in caplog.text


@pytest.mark.parametrize("when", ["before", "after"])
def test_a_window_that_cannot_be_built_ends_with_a_word_and_a_code(tmp_path, when):
    """In the real start: what is half built is taken apart without a crash, and it is kept."""
    code = (
        "import sys\n"
        "from armui import app\n"
        "from armui.start import StartOptions\n"
        "from armui.ui.shell.status_bar import StatusBar\n"
        "make = StatusBar.__init__\n"
        "def planted(*arguments):\n"
        f"    if {when!r} == 'after': make(*arguments)\n"
        "    raise RuntimeError('planted')\n"
        "StatusBar.__init__ = planted\n"
        "if __name__ == '__main__': sys.exit(app.run(StartOptions(sim_generation=2)))\n"
    )
    own = ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR")
    environment = {**os.environ, **dict.fromkeys(own, str(tmp_path))}
    environment["QT_QPA_PLATFORM"] = "offscreen"
    ended = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=False
    )
    assert ended.returncode == 1, ended.stderr
    assert ended.stderr.endswith("RuntimeError: planted\n")
    (log,) = tmp_path.rglob("armui.log")
    assert "RuntimeError: planted" in log.read_text()
