"""The thread that reads the devices: what it tells, and what it survives."""

import threading

import pytest

from armui.gamepad.device_reader import DeviceReader
from armui.gamepad.device_state import DeviceState
from tests.gamepad.pads import MOUSE, PAD
from tests.waiting import wait_until

pytestmark = pytest.mark.usefixtures("qapp")


class Backend:
    """Does what the test says, whenever the reader asks."""

    def __init__(self, package="pysdl2"):
        self.package = package
        self.unusable: tuple[str, ...] = ()
        self.states: tuple[DeviceState, ...] = ()
        self.fails: dict[str, Exception] = {}
        self.calls = []
        self.threads = set()

    def _called(self, name):
        self.calls.append(name)
        self.threads.add(threading.current_thread().name)
        if name in self.fails:
            raise self.fails[name]

    def open(self):
        self._called("open")

    def scan(self):
        self._called("scan")

    def read(self, now_s):
        self._called("read")
        return self.states

    def close(self):
        self._called("close")


@pytest.fixture
def backend():
    return Backend()


@pytest.fixture
def told():
    return []


@pytest.fixture
def read(told):
    """Make a reader; whatever was made is ended."""
    readers = []

    def make(*backends):
        reader = DeviceReader(backends, lambda *each: told.append(each))
        readers.append(reader)
        return reader

    yield make
    assert all(reader.end() for reader in readers)


def pad(*buttons, info=PAD, **axes):
    return DeviceState(info, axes, frozenset(buttons))


def test_it_reads_in_a_thread_of_its_own_and_lets_go_at_the_end(backend, read):
    reader = read(backend)
    backend.states = (pad("a", left_x=0.5),)
    wait_until(lambda: reader.latest.devices == backend.states)
    assert reader.running
    reader.stop()
    assert reader.end()
    assert not reader.running
    assert backend.calls[0] == "open"
    assert backend.calls[-1] == "close"
    assert backend.threads == {"gamepads"}


def test_a_press_is_told_with_its_release(backend, read, told):
    backend.states = (pad(),)
    reader = read(backend)
    wait_until(lambda: reader.latest.devices)
    backend.states = (pad("b"),)
    wait_until(lambda: told)
    backend.states = (pad("a"),)
    wait_until(lambda: len(told) == 2)
    none: frozenset[str] = frozenset()
    assert told == [(PAD, frozenset("b"), none), (PAD, frozenset("a"), frozenset("b"))]


def test_what_is_down_when_a_device_comes_is_no_press(backend, read, told):
    reader = read(backend)
    backend.states = (pad("b"),)
    wait_until(lambda: reader.latest.devices)
    backend.states = ()
    wait_until(lambda: not reader.latest.devices)
    backend.states = (pad("b", "a"),)
    wait_until(lambda: reader.latest.devices)
    assert told == []


def test_a_package_that_is_not_installed_is_named_and_the_other_is_read(backend, read):
    backend.fails["open"] = ImportError("No module named 'sdl2'")
    other = Backend("hidapi")
    other.states = (pad(info=MOUSE),)
    reader = read(backend, other)
    wait_until(lambda: reader.latest.devices)
    assert reader.latest.missing == ("pysdl2",)
    assert [state.info for state in reader.latest.devices] == [MOUSE]
    assert reader.end()
    assert "close" not in backend.calls


@pytest.mark.parametrize("where", ["open", "scan", "read"])
def test_a_library_that_fails_is_said_and_the_other_is_read(backend, read, where):
    backend.fails[where] = OSError("no such thing")
    other = Backend("hidapi")
    other.states = (pad(info=MOUSE),)
    reader = read(backend, other)
    wait_until(lambda: reader.latest.devices and reader.latest.problems)
    assert reader.latest.problems == ("pysdl2: no such thing",)
    assert reader.latest.missing == ()


def test_what_failed_and_works_again_is_read_again(backend, read):
    backend.states = (pad(),)
    reader = read(backend)
    wait_until(lambda: reader.latest.devices)
    backend.fails["read"] = OSError("gone for now")
    wait_until(lambda: not reader.latest.devices and reader.latest.problems)
    backend.fails.clear()
    wait_until(lambda: reader.latest.devices and not reader.latest.problems)


def test_nobody_looks_for_devices_while_a_button_is_held(backend, read):
    """Looking may take some tenths of a second: who holds on would count as silent."""
    now = [0.0]
    backend.states = (pad("left_shoulder"),)
    reader = DeviceReader((backend,), lambda *_each: None, lambda: now[0])
    try:
        wait_until(lambda: reader.latest.devices)
        looks = backend.calls.count("scan")
        now[0] = 10.0
        wait_until(lambda: reader.latest.at_s == 10.0)
        assert backend.calls.count("scan") == looks
        backend.states = (pad(),)
        wait_until(lambda: backend.calls.count("scan") > looks)
    finally:
        assert reader.end()
