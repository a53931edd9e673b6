"""The start's shortcuts change nothing of what is imported, and end when the program stands."""

import gc
import subprocess
import sys

CODE = """
import gc, linecache, sys
from armui.system.quick_start import begin_quickly, begun
begin_quickly()
assert not gc.isenabled()
from PySide6.QtCore import QObject, Signal
import colorsys, armui.arm.limits, armui.ui.format
read = [name for name in linecache.cache if "armui" in name or "colorsys" in name]
assert not read, read
class Told(QObject):
    said = Signal(int)
told, heard = Told(), []
told.said.connect(heard.append)
told.said.emit(3)
assert heard == [3]
begun()
assert gc.isenabled() and gc.get_freeze_count() > 0
"""


def test_nothing_is_read_and_everything_works():
    done = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_without_the_name_inside_pyside_nothing_happens(monkeypatch):
    from armui.system import quick_start  # noqa: PLC0415 - only here

    monkeypatch.setattr(quick_start, "_PYTHONS_OWN", "no such name")
    searches = gc.isenabled()
    try:
        quick_start.begin_quickly()
        assert not gc.isenabled()
    finally:
        (gc.enable if searches else gc.disable)()
