"""A replay that nobody closes ends its thread all the same: Qt aborts a program otherwise."""

from __future__ import annotations

import gc
import subprocess
import sys

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QObject

from armui.arm.device import RecordedArm
from armui.control.log_replay import LogReplay
from tests.bus.playback.logs import log_with, settled

OPEN_AT_THE_END = """
import sys, weakref

class Early:
    pass

if len(sys.argv) > 2:  # as in a process of a pool: Qt's turn at the end is before this one's
    early = Early()
    weakref.finalize(early, int)

from pathlib import Path
from PySide6.QtCore import QCoreApplication
from tests.bus.playback.logs import log_with
from armui.arm.device import RecordedArm
from armui.control.log_replay import LogReplay

app = QCoreApplication([])
log = log_with(Path(sys.argv[1]), "")
replay = LogReplay(log, log.channels[0], RecordedArm(2), "log")
replay.open()
replay.play(on=True)
"""


@pytest.fixture
def log(tmp_path):
    session = log_with(tmp_path, "")
    yield session
    session.close()


def test_its_thread_ends_with_its_owner(qtbot, log):
    owner = QObject()
    replay = LogReplay(log, log.channels[0], RecordedArm(2), "log", owner)
    replay.open()
    settled(qtbot, replay)
    worker = replay._worker
    assert worker.isRunning()

    owner.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
    del replay, owner
    gc.collect()

    assert worker.isFinished()


@pytest.mark.parametrize("more", [[], ["early"]])
def test_a_program_that_ends_takes_it_along(tmp_path, more):
    ended = subprocess.run(
        [sys.executable, "-c", OPEN_AT_THE_END, str(tmp_path), *more],
        capture_output=True, text=True, timeout=50, check=False,
    )  # fmt: skip
    assert "QThread" not in ended.stderr
    assert ended.returncode == 0, ended.stderr
