"""Half an hour of an arm in the window 回放: how soon any place of it is seen, by whole presses.

5.4 million frames of an arm that moves and is stopped, recorded as the program records. A press on
the time line; then the state of the arm at that place in the window, its 3D picture on the screen,
and the curves that led there. With each tab in front, and with the curves over half an hour. Beside
it, what the GUI thread keeps an event waiting, and the same pictures of a replay without a window.

    python -m pytest tests/benchmarks/test_scrubbing.py -s                       (two minutes)
    SCRUB_MINUTES=5 SCRUB_JUMPS=5 python -m pytest tests/benchmarks/test_scrubbing.py -s

With `SCRUB_BUSY=1` as many processes as there are cores take all they get meanwhile.
"""

import contextlib
import os
import random
import time

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from armui.arm.device import RecordedArm
from armui.control.arm_controller import ArmController
from armui.control.log_replay import LogReplay
from armui.protocol.generation import Generation
from armui.session.recording.kinds import RecordingFormat
from armui.session.recording.recorded_session import RecordedSession
from armui.session.recording.rows import rows_of
from armui.session.recording.writer import RecordingPlan, RecordingWriter, TimeBase
from armui.system.helper_process import FileThread, HelperProcess
from armui.ui.background import Background
from armui.ui.theme import Theme, apply_theme
from armui.ui.watch.replay.replay_window import ReplayWindow
from armui.viewport.view import ArmView
from tests.benchmarks import rig
from tests.bus.playback.logs import settled
from tests.posix import of_system
from tests.session.recordings import START_S, frames, moving
from tests.waiting import wait_until

MINUTES = float(os.environ.get("SCRUB_MINUTES", "30"))
JUMPS = int(os.environ.get("SCRUB_JUMPS", "20"))
BUSY = bool(os.environ.get("SCRUB_BUSY"))
PIECE_S = 20.0
BLOCK = 1200
FIRST_PICTURE_S = 0.3
SIZE_PX = (1440, 920)
LOOK_S = 0.002


@pytest.fixture(scope="module")
def log(tmp_path_factory):
    """The same twenty seconds again and again, in a recording of the program."""
    taken = [
        (None, at_s - START_S, frame, 0)
        for at_s, frame in frames(PIECE_S, asked=moving(Generation.TWO))
    ]
    rows = rows_of(taken)
    folder = tmp_path_factory.mktemp("long")
    plan = RecordingPlan(folder, "long", RecordingFormat.BLF, TimeBase(0.0, START_S), 10**9)
    writer = RecordingWriter(plan)
    for number in range(round(60.0 * MINUTES / PIECE_S)):
        for begin in range(0, len(rows), BLOCK):
            writer.write(rows.part(begin, begin + BLOCK).shifted(number * PIECE_S))
    writer.finish({})
    return writer.path


class Scrubber:
    """Presses the time line, and notes when what is seen."""

    def __init__(self, window):
        self.view = window.view
        self.replay = window.view.replay
        self.board = window.view.curves.board
        self._client = window.view.view._client
        self._shown = 0, 0.0
        self._note_drawn, self._frame_used = self._client._note_drawn, self._client.frame_used
        self._client._note_drawn = self._on_known
        self._client.frame_used = self._on_painted
        self._moved_s = 0.0
        self.replay.moved.connect(self._on_moved)

    def _on_moved(self):
        self._moved_s = time.perf_counter()

    def _on_known(self, drawn):
        """A picture has come, or the one that is painted shows this state, too."""
        self._note_drawn(drawn)
        if not self.view.view._is_frame_new:
            self._shown = drawn.sequence, time.perf_counter()

    def _on_painted(self, picture):
        self._frame_used(picture)
        self._shown = picture.frame.drawn.sequence, time.perf_counter()

    def jump(self, at_s, *, curves):
        """Seconds from a press until state, picture and curves of a place are seen."""
        line, replay = self.view.time_line, self.replay
        place = QPoint(round(line.place_px(at_s)), line.height() // 2)
        began_s = time.perf_counter()
        QTest.mousePress(line, Qt.MouseButton.LeftButton, pos=place)
        until(lambda: not replay.is_travelling)
        state_s = time.perf_counter() - began_s
        assert replay.controller.state.angles_deg() is not None
        wanted = self._client.sequence
        until(lambda: self._shown[0] >= wanted)
        picture_s, curves_s = self._shown[1] - began_s, 0.0
        if curves:
            until(lambda: replay._worker.curves_from_s < replay.clock())
            filled_s = time.perf_counter()
            until(lambda: self._moved_s > filled_s)
            until(lambda: not (self.board._dirty or self.board._waiting))
            curves_s = time.perf_counter() - began_s
        QTest.mouseRelease(line, Qt.MouseButton.LeftButton, pos=place)
        return state_s, picture_s, curves_s


def until(condition):
    """As `wait_until`, but for looking more often."""
    ends_s = time.perf_counter() + 60.0
    while not condition():
        assert time.perf_counter() < ends_s
        QApplication.processEvents()
        time.sleep(LOOK_S)


def without_window(qtbot, path, chance):
    """Seconds until the state of each place is known to a replay that nobody shows."""
    session = RecordedSession(path)
    replay = LogReplay(session, session.channels[0], RecordedArm(2), path.name)
    replay.open()
    settled(qtbot, replay)
    taken_s = []
    for _ in range(JUMPS):
        began_s = time.perf_counter()
        replay.go_to(chance.uniform(session.start_s, session.end_s))
        until(lambda: not replay.is_travelling)
        taken_s.append(time.perf_counter() - began_s)
    assert replay.close()
    session.close()
    return taken_s


def _no_bus(_device):
    raise RuntimeError("no arm is connected")


@contextlib.contextmanager
def opened(background, path):
    """The window with a log open, its picture drawn, its events found."""
    window = ReplayWindow(ArmController(_no_bus), background, ArmView, open_own=RecordedSession)
    window.resize(*SIZE_PX)
    window.show()
    try:
        window.open_log(path)
        wait_until(lambda: window.view is not None)
        view = window.view
        wait_until(lambda: window._events is None and view.view._client.is_settled)
        yield window
    finally:
        window.close()
        window.end()
        window.deleteLater()


def show_tab(view, name):
    """Have one of the tabs in front."""
    if name.startswith("curves"):
        view.tabs.setCurrentWidget(view.curves)
        wait_until(lambda: view.curves.board.built)
        view.curves.board.set_span(1800.0 if "30" in name else 60.0)
    else:
        view.tabs.setCurrentWidget(view.joints if name == "joints" else view.events)
    rig.run_for(1.0)


@pytest.mark.timeout(900)
def test_scrubbing(qtbot, qapp, capsys, benchmark, log):
    apply_theme(qapp, Theme.LIGHT)
    chance = random.Random(13)
    bare_s = without_window(qtbot, log, chance)
    background = Background(HelperProcess(), FileThread())
    lines, medians_s = [], {}
    busy = rig.all_cores_busy() if BUSY else contextlib.nullcontext()
    with opened(background, log) as window, busy:
        scrubber = Scrubber(window)
        session = window.view.replay.session
        for tab in ("joints", "curves, 60 s", "curves, 30 min", "events"):
            show_tab(window.view, tab)
            seen = []
            with rig.Gaps() as gaps:
                for _ in range(JUMPS):
                    at_s = chance.uniform(session.start_s, session.end_s)
                    seen.append(scrubber.jump(at_s, curves=tab.startswith("curves")))
                    rig.run_for(chance.uniform(0.05, 0.4))
            state, picture, curves = (1e3 * np.array(column) for column in zip(*seen, strict=True))
            medians_s[tab] = float(np.median(picture)) / 1e3
            lines.append(
                f"  {tab:16} state {told(state)}  picture {told(picture)}  "
                f"curves {told(curves) if curves.any() else '–':>12}  "
                f"GUI thread held {max(gaps.late_ms):4.0f} ms"
            )
    background._workers.shutdown()
    background._files.shutdown()
    benchmark.extra_info.update({f"{tab}_s": each for tab, each in medians_s.items()})
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\n{session.frames:,} frames, {JUMPS} presses each, median / worst in ms, ", end="")
        print(f"load {of_system('getloadavg')()[0]:.1f}:")
        print("\n".join(lines))
        print(f"  no window        state {told(1e3 * np.array(bare_s))}")
    assert max(medians_s.values()) < FIRST_PICTURE_S


def told(values_ms):
    """Median and worst."""
    return f"{np.median(values_ms):4.0f} / {max(values_ms):4.0f}"
