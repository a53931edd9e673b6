"""What watching costs the whole program: 60 curves, events, ring at 3,000 frames a second.

The program as the operator has it, the arm in a process of its own; processor time of the program's
process, in turns: with nobody told of any frame but the picture of the arm (neither events nor ring
nor series, no curves), with all of that kept and no curves shown, and with ten plots of 60 curves
besides. Processor time is the program's own, so that others on the computer count little; they do
count through caches and waiting, so that turns are many and their medians are compared.

    python -m pytest tests/benchmarks/test_watching_cost.py -s                   (a minute)
    WATCHING_TURNS=12 python -m pytest tests/benchmarks/test_watching_cost.py -s
"""

import contextlib
import os
import sys
import time

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication

from armui.ui.watch.plots_area import PlotPage
from tests.benchmarks import rig
from tests.benchmarks.test_plots_speed import PLOTS
from tests.posix import of_system

SECONDS = float(os.environ.get("WATCHING_SECONDS", "4"))
TURNS = int(os.environ.get("WATCHING_TURNS", "5"))
FRAMES_PER_S = 3000
MOST_SHARE = 1 / 3


@contextlib.contextmanager
def nobody_told(controller):
    """Frames go into the picture of the arm, and nowhere else; nothing is an event."""
    connection, event_collector = controller._connection, controller.event_collector
    worker, listeners = connection._worker, connection._listeners
    worker.set_listeners(())
    advance = event_collector.follow_arm
    event_collector.follow_arm = lambda: None
    sessions = controller.sessions
    sessions._timer.stop()
    collector = sessions._collector
    collector.end()
    try:
        yield
    finally:
        collector.start()
        sessions._timer.start()
        event_collector.follow_arm = advance
        worker.set_listeners((connection.telemetry, *listeners))


def spent_in(seconds, counted):
    """Share of a core, and frames a second."""
    frames = counted[0]
    before_s, began_s = time.process_time(), time.monotonic()
    rig.run_for(seconds)
    passed_s = time.monotonic() - began_s
    return (time.process_time() - before_s) / passed_s, (counted[0] - frames) / passed_s


@pytest.mark.skipif(sys.platform != "linux", reason="loopback of udp_multicast")
@pytest.mark.timeout(900)
def test_watching_cost(qapp, tmp_path, capsys, benchmark):
    bare: list[float] = []
    kept: list[float] = []
    shown: list[float] = []
    rates: list[float] = []
    pictures: list[float] = []
    counted = [0]
    with (
        rig.helper("-m", "tests.benchmarks.other_arm", str(FRAMES_PER_S)),
        rig.window(qapp, tmp_path, lambda _device: rig.counting_bus(counted), rig.UDP) as program,
    ):
        controller = program.controller
        program.window.show_as_curves(())
        page = program.window._workspace.kept("plots")
        assert isinstance(page, PlotPage)
        program.window._workspace.take_out(page)
        page.window().resize(1280, 1000)
        begin = page.board._book.begin_picture

        def begin_picture():
            pictures.append(time.monotonic())
            begin()

        page.board._book.begin_picture = begin_picture
        page.board.show_plots(PLOTS)
        page.board.set_span(60.0)
        rig.run_for(4.0)
        pictures.clear()
        for _ in range(TURNS):
            for spent, is_told, is_shown in (
                (bare, False, False),
                (kept, True, False),
                (shown, True, True),
            ):
                with contextlib.nullcontext() if is_told else nobody_told(controller):
                    page.window().setVisible(is_shown)
                    QApplication.processEvents()
                    rig.run_for(0.5)
                    share, rate = spent_in(SECONDS, counted)
                spent.append(share)
                rates.append(rate)
        page.window().show()
        QApplication.processEvents()
        curves = sum(len(pane.quantities) for pane in page.board.panes)
        seen = len(page.board._seen())
        page.window().close()
    # in turns: what the computer does meanwhile is the same for all three
    cost = float(np.median(np.array(shown) / np.array(bare))) - 1.0
    benchmark.extra_info.update(bare=min(bare), kept=min(kept), shown=min(shown), cost=cost)
    benchmark.pedantic(lambda: None, rounds=1)
    pictures_per_s = len(pictures) / (TURNS * (SECONDS + 0.5))
    with capsys.disabled():
        print(
            f"\n{np.median(rates):.0f} frames/s, {TURNS} turns of {SECONDS:.0f} s, load "
            f"{of_system('getloadavg')()[0]:.1f}; processor time of the program's process, "
            "of a core:"
        )
        for name, spent in (
            ("no events, ring, series, curves", bare),
            ("all kept, no curves shown", kept),
            (f"{curves} curves in {seen} plots seen", shown),
        ):
            print(
                f"  {name:34} median {100 * np.median(spent):5.1f}  least {100 * min(spent):5.1f} %"
            )
        print(
            f"  together {100 * cost:+.0f} % (median of the turns), {pictures_per_s:.1f} pictures/s"
        )
    assert curves == 60
    assert cost < MOST_SHARE
