"""How long the first show of each panel and window holds the GUI thread (S2: 50 ms).

A simulated arm is connected, and the program has loaded what it loads while nothing is asked of it.
Processor time of the GUI thread beside real time: on a busy computer only the first compares.
"""

import time

import pytest
from PySide6.QtWidgets import QApplication, QDialog

from armui.app import load_pages, open_device
from armui.simulated_arms import SIMULATED
from armui.ui.shell.operation_area import menu_entries
from armui.ui.shell.pages import PAGES
from tests.benchmarks import rig

MOST_MS = 50.0


def held(show):
    """How long showing something holds this thread: processor time and real time, in ms."""
    began_s, worked_s = time.perf_counter(), time.thread_time()
    show()
    QApplication.processEvents()
    return 1e3 * (time.thread_time() - worked_s), 1e3 * (time.perf_counter() - began_s)


def shown(program):
    """What is shown, by name, with what shows it; and hides it again."""
    window = program.window
    entries = menu_entries(program.controller, window._preferences, lambda: None)
    for place, entry in enumerate(entries):
        if place:  # the first one stands at the start
            yield f"panel {entry.key}", lambda place=place: window._show_panel(place)
    for key in PAGES:
        yield f"page {key}", lambda key=key: window.pages.show(key)
        for dialog in window.findChildren(QDialog):
            if dialog.isVisible():
                dialog.close()


@pytest.mark.timeout(300)
def test_first_show(qapp, tmp_path, capsys, benchmark):
    figures = {}
    with rig.window(qapp, tmp_path, open_device, SIMULATED[0]) as program:
        list(load_pages())
        rig.run_for(3.0)
        for name, show in shown(program):
            figures[name] = held(show)
            rig.run_for(0.3)
    benchmark.extra_info.update({name: worked for name, (worked, _) in figures.items()})
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print("\nfirst show: processor time, real time")
        for name, (worked_ms, took_ms) in figures.items():
            more = "  above 50 ms" if worked_ms > MOST_MS else ""
            print(f"  {name:26} {worked_ms:6.1f} ms {took_ms:6.1f} ms{more}")
    assert len(figures) > 20
