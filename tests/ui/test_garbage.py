"""Garbage ends in the thread of the windows, whoever makes it."""

import gc
import os
import subprocess
import sys
import threading

import pytest
from PySide6.QtCore import QObject

from armui.ui import garbage
from armui.ui.garbage import GarbageSearch


class Remains:
    """What lets go of itself only when somebody searches."""

    def __init__(self, ended):
        self.itself = self
        self.ended = ended

    def __del__(self):
        self.ended.append(threading.current_thread())


@pytest.fixture
def search(qapp):
    """The search, in a process that has searched by itself so far."""
    before = gc.isenabled()
    gc.enable()
    parent = QObject()
    yield GarbageSearch(parent)
    parent.deleteLater()
    (gc.enable if before else gc.disable)()


def make_many(ended):
    """More than Python, left to itself, would let pass without a search."""
    for _ in range(1000):
        Remains(ended)


def test_no_other_thread_searches(search):
    ended: list[threading.Thread] = []
    other = threading.Thread(target=make_many, args=(ended,))
    other.start()
    other.join()
    assert not ended
    search.collect()
    assert ended == [threading.main_thread()] * 1000


STARTED = """
import gc, threading
from functools import wraps
from PySide6.QtCore import QTimer
from armui import app
from armui.start import StartOptions

begun = {}

def noting(start):
    @wraps(start)
    def noted(thread, *arguments):
        if app.QApplication.instance() is not None:  # the log's writer begins before it
            begun[thread.name] = gc.isenabled()
        return start(thread, *arguments)
    return noted

threading.Thread.start = noting(threading.Thread.start)

class Brief(app.Program):
    def __init__(self, *arguments, **more):
        super().__init__(*arguments, **more)
        QTimer.singleShot(1500, app.QApplication.quit)

def opened(*arguments, **more):
    begun["bus"] = gc.isenabled()
    return open_device(*arguments, **more)

open_device, app.open_device, app.Program = app.open_device, opened, Brief
app.run(StartOptions(sim_generation=2))
assert "bus" in begun and len(begun) > 1, begun
assert not any(begun.values()), begun
"""


def test_from_the_first_thread_on_no_other_searches(tmp_path):
    own = {name: str(tmp_path) for name in ("HOME", "XDG_DATA_HOME", "XDG_STATE_HOME")}
    own |= {name: str(tmp_path) for name in ("XDG_CONFIG_HOME", "XDG_RUNTIME_DIR")}
    environment = {**os.environ, **own, "QT_QPA_PLATFORM": "offscreen"}
    done = subprocess.run(
        [sys.executable, "-c", STARTED],
        env=environment,
        capture_output=True,
        text=True,
        timeout=50.0,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def test_what_has_become_old_is_found_within_a_minute(search, monkeypatch):
    ended: list[threading.Thread] = []
    remains = Remains(ended)
    for _ in range(2):
        gc.collect(1)  # they survive, and are old
    del remains
    search.collect()
    assert not ended
    monkeypatch.setattr(garbage, "_LOOKS", 2)
    search.collect()
    assert len(ended) == 1


def test_it_looks_by_itself(search, qtbot):
    ended: list[threading.Thread] = []
    Remains(ended)
    search._timer.setInterval(1)
    qtbot.waitUntil(lambda: len(ended) == 1, timeout=5000)
