"""An exception in what Qt calls is told at once, and neither Qt nor PySide ever meets it."""

import os
import subprocess
import sys

WINDOWS = """
import os, sys
os.environ["QT_QPA_PLATFORM"] = "offscreen"
import armui.ui
from PySide6.QtCore import QAbstractTableModel, QEvent, QModelIndex
from PySide6.QtWidgets import QApplication, QTableView, QWidget
from armui.ui.widgets.translated import Translated

app = QApplication([])
told = []

def tell(kind, error, trace):
    told.append(f"{error} in {trace.tb_frame.f_code.co_name}")

sys.excepthook = tell

class Window(QWidget):
    resized = 0
    def moveEvent(self, event): raise ArithmeticError("moved")
    def resizeEvent(self, event): Window.resized += 1
"""


def told_by(script):
    """What a program says that does this; it must come to its end."""
    command = [sys.executable, "-c", WINDOWS + script]
    done = subprocess.run(
        command,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
        env={**os.environ, "LC_ALL": "C.UTF-8"},  # Qt complains of one that is not installed
    )
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout.splitlines()


def test_an_event_that_fails_is_told_once_and_the_next_one_is_heard():
    """Without the guard the program is gone after a few windows: the next event is freed memory."""
    script = """
for _ in range(30):
    window = Window()
    window.setGeometry(10, 10, 100, 100)
    window.show()
print(Window.resized, len(told), *set(told))
"""
    assert told_by(script) == ["30 30 moved in moveEvent"]


def test_what_is_mixed_in_is_guarded_too():
    script = """
class Label(Translated, QWidget):
    translated = 0
    def retranslate_ui(self):
        Label.translated += 1
        raise ArithmeticError("words")

labels = [Label() for _ in range(30)]
for label in labels:
    QApplication.sendEvent(label, QEvent(QEvent.Type.LanguageChange))
print(Label.translated, len(told), *set(told))
"""
    assert told_by(script) == ["30 30 words in changeEvent"]


def test_a_question_that_fails_is_answered_by_qt():
    script = """
class Table(QAbstractTableModel):
    def rowCount(self, parent=None): raise ArithmeticError("rows")
    def columnCount(self, parent=None): return 2
    def data(self, index, role=0): raise ArithmeticError("data")
    def flags(self, index): raise ArithmeticError("flags")

class Sized(QWidget):
    def sizeHint(self): raise ArithmeticError("size")

model, view = Table(), QTableView()
view.setModel(model)
view.show()
sized = Sized()
sized.adjustSize()
print(model.rowCount(), model.data(QModelIndex()), sized.sizeHint().isValid())
print(*sorted(set(told)), sep=", ")
"""
    assert told_by(script) == ["0 None False", "data in data, rows in rowCount, size in sizeHint"]


def test_ctrl_c_is_no_failure_and_goes_on_as_before():
    script = """
class Ended(QWidget):
    def moveEvent(self, event): raise KeyboardInterrupt

ended = Ended()
ended.move(10, 10)
try:
    ended.show()
except KeyboardInterrupt:
    print("ended")
print(told)
"""
    assert told_by(script)[-1] == "[]"


def test_whatever_qt_calls_in_any_class_of_the_program_is_guarded():
    script = """
import importlib, pkgutil
from types import FunctionType
from shiboken6 import Shiboken
from armui.ui.override_guard import is_guarded

import armui.app
for room in (armui.ui, armui.viewport):
    for each in pkgutil.walk_packages(room.__path__, room.__name__ + "."):
        if not each.name.startswith("armui.viewport.process"):
            importlib.import_module(each.name)

def below(kind):
    for each in kind.__subclasses__():
        yield each
        yield from below(each)

kinds = {kind for kind in below(Shiboken.Object) if kind.__module__.startswith("armui.")}
seen = 0
for kind in kinds:
    for base in kind.__mro__:
        for name, function in vars(base).items():
            if not (base.__module__.startswith("armui.") and is_guarded(kind, name)):
                continue
            seen += 1
            if isinstance(function, FunctionType) and not hasattr(function, "__wrapped__"):
                print(base.__module__, base.__name__, name)
print(len(kinds) > 250, seen > 200)
"""
    assert told_by(script) == ["True True"]
