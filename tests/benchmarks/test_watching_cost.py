"""What watching costs the whole program: 60 curves at 3,000 frames a second, beside none.

The program as the operator has it, the arm in a process of its own; processor time of the program's
process with the window of curves closed and open, in turns.

    python -m pytest tests/benchmarks/test_watching_cost.py -s                   (half a minute)
"""

import sys
import time

import can
import numpy as np
import pytest
from PySide6.QtWidgets import QApplication

from armui.ui.watch.plot_page import PlotPage
from tests.benchmarks import rig
from tests.benchmarks.other_arm import BUS
from tests.benchmarks.test_plots_speed import PLOTS

SECONDS = 4.0
TURNS = 3
FRAMES_PER_S = 3000
MOST_SHARE = 1 / 3


@pytest.mark.skipif(sys.platform != "linux", reason="loopback of udp_multicast")
@pytest.mark.timeout(600)
def test_watching_cost(qapp, tmp_path, capsys, benchmark):
    closed: list[float] = []
    opened: list[float] = []
    pictures: list[float] = []
    frames: list[float] = []
    with (
        rig.helper("-m", "tests.benchmarks.other_arm", str(FRAMES_PER_S)),
        rig.window(qapp, tmp_path, lambda _device: can.Bus(**BUS), rig.UDP) as program,
    ):
        program.window.show_as_curves(())
        window = program.window._workspace.kept("plots")
        assert isinstance(window, PlotPage)
        program.window._workspace.take_out(window)
        window.window().resize(1280, 1000)
        tick = window.board._on_tick
        window.board._timer.timeout.disconnect(tick)
        window.board._timer.timeout.connect(lambda: pictures.append(time.monotonic()))
        window.board._timer.timeout.connect(tick)
        window.board.show_plots(PLOTS)
        window.board.set_span(60.0)
        rig.run_for(4.0)
        for _ in range(TURNS):
            for spent, shown in ((closed, False), (opened, True)):
                window.setVisible(shown)
                QApplication.processEvents()
                rig.run_for(0.5)
                before_s, began_s = time.process_time(), time.monotonic()
                rig.run_for(SECONDS)
                spent.append((time.process_time() - before_s) / (time.monotonic() - began_s))
                latest = program.controller.telemetry.latest("bus.frames_per_s")
                frames.append(0.0 if latest is None else latest[1])
        curves = sum(len(pane.quantities) for pane in window.board.panes)
        seen = sum(1 for pane in window.board._seen())
        window.close()
    without, with_it = float(np.median(closed)), float(np.median(opened))
    benchmark.extra_info.update(closed=without, opened=with_it)
    benchmark.pedantic(lambda: None, rounds=1)
    pictures_per_s = len(pictures) / (TURNS * (SECONDS + 0.5) + 4.0)
    with capsys.disabled():
        print(f"\n{np.median(frames):.0f} frames/s, processor time of the program's process:")
        print(f"  no curves shown          {100 * without:5.1f} % of a core")
        print(f"  {curves} curves, {seen} plots seen {100 * with_it:5.1f} % of a core")
        print(f"  {100 * (with_it / without - 1):+.0f} %, {pictures_per_s:.1f} pictures/s")
    assert curves == 60
