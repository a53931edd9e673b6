"""The local interface before a simulated arm, with clients at its socket."""

import json
import socket
import sys
import time

import pytest
from PySide6.QtCore import QCoreApplication

import armui_client
from armui.interface.interface import Interface, Shelf
from armui.trajectory.library.store import Library
from armui.ui.background import Background
from tests.app_driver import AtOnce
from tests.interface.script import Script

collect_ignore_glob = [] if sys.platform == "linux" else ["test_*.py"]
"""The interface is offered on Linux only."""

STEP_S = 0.02
WITHIN_S = 10.0


def until_settled(interface):
    """Wait until an interface that was switched on is served, or says why it is not."""
    until_s = time.monotonic() + WITHIN_S
    while not interface.view.on and interface.view.problem is None:
        assert time.monotonic() < until_s
        QCoreApplication.processEvents()
        time.sleep(0.001)


class Desk(Interface):
    """The interface, with the rig it is of."""

    def __init__(self, rig, path):
        self.shelf = Shelf(Background(AtOnce()), lambda: Library(path.parent / "library"))
        super().__init__(rig.controller, path, lambda: rig.time_s, shelf=self.shelf)
        self.rig = rig


class RawClient:
    """A client that speaks lines over the socket, while the rig's time goes on."""

    def __init__(self, rig, path, name="a script", *, greets=True):
        self.rig = rig
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(str(path))
        self.socket.setblocking(False)
        self.kept = b""
        self.notifications = []
        self.answers = {}
        self.ids = 0
        self.lease = None
        if greets:
            self.hello = self.ask("hello", client=name, protocol=1)

    def send(self, line):
        self.socket.sendall(line)

    def begin(self, method, **params):
        """Ask for something; returns the id of the answer."""
        self.ids += 1
        call = {"jsonrpc": "2.0", "id": self.ids, "method": method, "params": params}
        self.send(json.dumps(call).encode() + b"\n")
        return self.ids

    def read(self):
        """Take in what has come; false once the other side has closed."""
        try:
            while chunk := self.socket.recv(65536):
                self.kept += chunk
        except BlockingIOError:
            return True
        except ConnectionError:
            return False
        else:
            return False
        finally:
            *lines, self.kept = self.kept.split(b"\n")
            for line in map(json.loads, lines):
                if "method" in line:
                    self.notifications.append(line)
                else:
                    self.answers[line["id"]] = line

    def wait(self, condition, steps=500):
        """Let the rig's time go on until something has come."""
        until_s = time.monotonic() + WITHIN_S
        while not condition():
            assert time.monotonic() < until_s, "nothing came"
            QCoreApplication.processEvents()
            self.rig.step()
            time.sleep(0.001)
            self.read()

    def answer(self, number):
        self.wait(lambda: number in self.answers)
        return self.answers[number]

    def ask(self, method, **params):
        """Ask for something, and return the result."""
        answer = self.answer(self.begin(method, **params))
        assert "error" not in answer, answer
        return answer["result"]

    def refused(self, method, **params):
        """Ask for something that is refused, and return the error."""
        return self.answer(self.begin(method, **params))["error"]

    def told(self, method):
        return [each["params"] for each in self.notifications if each["method"] == method]

    def close(self):
        self.socket.close()


@pytest.fixture
def desk(rig, tmp_path):
    """The interface of a rig whose arm is ready to move."""
    rig.ready()
    interface = Desk(rig, tmp_path / "r" / "api.sock")
    interface.switch(on=True)
    until_settled(interface)
    assert interface.view.problem is None
    yield interface
    assert interface.end()


@pytest.fixture
def connect(desk):
    """Connects another client."""
    clients = []

    def one(name="a script", **more):
        clients.append(RawClient(desk.rig, desk.view.path, name, **more))
        return clients[-1]

    yield one
    for each in clients:
        each.close()


@pytest.fixture
def client(connect):
    return connect()


@pytest.fixture
def leased(client, desk):
    """A client that holds the lease."""
    return with_lease(client, desk)


def with_lease(client, desk, percent=100):
    asked = client.begin("lease.request", purpose="a test", moves=True, max_speed_percent=percent)
    client.wait(lambda: desk.view.asked is not None)
    desk.grant(percent)
    client.lease = client.answer(asked)["result"]["lease"]
    return client


# The client of others ----------------------------------------------------------------------------


@pytest.fixture
def script(desk, monkeypatch):
    return Script(desk, monkeypatch)


@pytest.fixture
def with_arm(script):
    """Runs a function with a connected arm, in a thread."""

    def run(act, **more):
        def connected():
            with armui_client.connect("a test", **more) as arm:
                return act(arm)

        return script.run(connected)

    return run


@pytest.fixture(name="with_lease")
def fixture_with_lease(with_arm):
    """The same, with the lease."""

    def run(act):
        def leased(arm):
            with arm.lease("a test", max_speed_percent=100):
                return act(arm)

        return with_arm(leased)

    return run
