"""What every test may use; and what none may leave behind.

``pytest --full`` runs all combinations of values of the tests that are thinned: tests/pairs.py.
"""

import gc
import os
import signal
import threading
from collections import defaultdict
from functools import partial
from itertools import count

# Before Qt is loaded: tests need no display, and open no window on a desk that has one.
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
# Commands answer in English, wherever the tests run.
os.environ["LC_ALL"] = "en_US.UTF-8"

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from armui.protocol.generation import Generation
from tests.app_driver import AppDriver, Slow
from tests.arm_rig import ArmRig
from tests.company import OtherHost
from tests.examples import load_profile
from tests.pairs import SIZES, few_of
from tests.translations import modules

_ENDING_S = 2.0
_MUCH_MADE = 20_000
_YOUNG_SEARCHES = 10
_SEARCHES = count(1)
_BUTTONS = (Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton, Qt.MouseButton.MiddleButton)

load_profile()


def pytest_addoption(parser):
    parser.addoption(
        "--full", action="store_true", help="all combinations of values, not few that show each"
    )


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config, items):
    """Of what was asked for, leave out the combinations that only `--full` runs."""
    if config.getoption("full"):
        return
    thinned = defaultdict(list)
    for item in items:
        for name, together in SIZES.items():
            if item.get_closest_marker(name) is not None:
                thinned[item.nodeid.partition("[")[0], together].append(item)
    left = set()
    for (_, together), each in thinned.items():
        few = few_of([_values(item) for item in each], together)
        left |= set(each) - {each[place] for place in few}
    config.hook.pytest_deselected(items=[item for item in items if item in left])
    items[:] = [item for item in items if item not in left]


def _values(item):
    """What the item is run with; a list, say, is told from another by being another."""
    return {name: _hashable(value) for name, value in item.callspec.params.items()}


def _hashable(value):
    try:
        hash(value)
    except TypeError:
        return id(value)
    return value


def pytest_configure():
    """Programs that tests start hear the signals that this one was told to ignore.

    A shell has what it starts in the background ignore SIGINT, and nohup SIGHUP; it is inherited.
    """
    for name in ("SIGINT", "SIGHUP"):
        number = getattr(signal, name, None)  # Windows has no SIGHUP
        if number is not None and signal.getsignal(number) is signal.SIG_IGN:
            signal.signal(number, signal.SIG_DFL)


@pytest.fixture(params=[Generation.ONE, Generation.TWO], ids=["gen1", "gen2"])
def generation(request):
    return request.param


@pytest.fixture
def arm_repeats():
    """Whether the arm tells everything as often as a real one, and not once a step of the rig.

    Tests that look between two steps, or at each frame, override this.
    """
    return False


@pytest.fixture
def rig(qapp, request, arm_repeats):
    """A simulated arm of generation 2 and the controller, not connected yet."""
    rig = _as_told(ArmRig(request.node.nodeid), arm_repeats)
    yield rig
    rig.close()


@pytest.fixture
def any_rig(qapp, request, generation, arm_repeats):
    """The same, in both generations."""
    rig = _as_told(ArmRig(request.node.nodeid, generation), arm_repeats)
    yield rig
    rig.close()


def _as_told(rig, arm_repeats):
    if not arm_repeats:
        rig.repeat_nothing()
    return rig


@pytest.fixture
def other_host(rig):
    """A second host on the bus of `rig`."""
    host = OtherHost(rig)
    yield host
    host.close()


@pytest.fixture
def make_driver(qapp, request, tmp_path):
    """Starts the program; with the style sheet, which costs, if what it says is looked at."""
    settings = tmp_path / "settings.json"
    styled = request.node.get_closest_marker("styled") is not None
    return partial(AppDriver, qapp, request.node.nodeid, settings, styled=styled)


@pytest.fixture
def app_driver(make_driver, arm_repeats):
    """The main window before a simulated arm of generation 2, not connected yet, in English."""
    app_driver = make_driver(Generation.TWO)
    yield _as_told(app_driver, arm_repeats)
    app_driver.close()


@pytest.fixture
def slow_driver(make_driver, arm_repeats):
    """The same; what takes long is only done when `app_driver.workers` is told to work."""
    app_driver = make_driver(Generation.TWO, Slow())
    yield _as_told(app_driver, arm_repeats)
    app_driver.close()


@pytest.fixture
def any_driver(make_driver, generation, arm_repeats):
    """The same, in both generations."""
    app_driver = make_driver(generation)
    yield _as_told(app_driver, arm_repeats)
    app_driver.close()


@pytest.fixture(scope="module")
def trees_end_with_the_module():
    """The program's syntax trees: every later search for garbage would walk through them."""
    yield
    modules.cache_clear()


def pytest_collection_finish():
    """The tests themselves are no garbage; what they leave is searched between two of them.

    A search that another thread makes, at any time, may end what is left of a window: Qt and
    Python then wait for one another for ever.
    """
    gc.collect()
    gc.freeze()
    gc.disable()


def pytest_runtest_setup():
    """Delete what the test before had closed: windows, and their timers, end with their test.

    So do its presses: beside another button that is down nothing that is held begins.
    """
    for button in _BUTTONS:
        if QGuiApplication.mouseButtons() & button:
            QTest.mouseRelease(QWidget(), button)
    if gc.get_count()[0] > _MUCH_MADE:
        gc.collect(2 if next(_SEARCHES) % _YOUNG_SEARCHES == 0 else 1)
    if QCoreApplication.instance() is not None:
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)


@pytest.fixture(autouse=True)
def no_thread_outlives_the_test():
    before = set(threading.enumerate())
    yield
    # a QThread that ran Python leaves a dummy behind; it is Qt that complains if one still runs
    left = [
        thread
        for thread in set(threading.enumerate()) - before
        if not isinstance(thread, threading._DummyThread)
    ]
    for thread in left:
        thread.join(_ENDING_S)  # python-can's search lets its threads end by themselves
    still = [thread for thread in left if thread.is_alive()]
    assert not still, f"left running: {still}"
