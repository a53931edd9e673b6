"""A client of the local interface that carries out operations, for the tests of every operation."""

from __future__ import annotations

import enum
import inspect
import json
import socket
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

from PySide6.QtCore import QCoreApplication

from armui.arm.refusal import Reason, Refusal
from armui.control.operations.started import Started
from armui.control.run.progress import Run
from armui.interface import lease as leases
from armui.interface.interface import Interface, Shelf
from armui.interface.messages import Code
from armui.interface.plain_forms import WITHOUT
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.background import Background
from tests.app_driver import AtOnce
from tests.safety.operation_driver import Answer, ControllerDriver, Midway

BY_OTHER_MEANS: Final = frozenset({"run.start"})
"""Operations that a client has done by a method of another name."""
_WITHIN_S: Final = 20.0
_PING_S: Final = 0.4
_OF_LEASES: Final = {each.id: each for each in vars(leases).values() if isinstance(each, Reason)}


class _KeptInterface(Interface):
    """Keeps the record of each operation that a client has begun."""

    begun: Started | None = None
    fault: Midway | None = None
    """What fails in the operation itself: its calls are the same in each run, unlike its ticks."""

    def _by_client(self, act: Callable[[], Any], *, moves: bool = True) -> Any:
        if self.fault is not None:
            sys.setprofile(self.fault.profile)
        try:
            return super()._by_client(act, moves=moves)
        finally:
            sys.setprofile(None)

    def _follow_outcome(self, session: Any, started: Started) -> None:
        self.begun = started
        super()._follow_outcome(session, started)


class ClientDriver(ControllerDriver):
    """A client behind the socket; what no client can ask for is done by the controller.

    The operator grants whatever it asks for.
    """

    def __init__(self, channel: str) -> None:
        super().__init__(channel)
        self._folder = tempfile.TemporaryDirectory()
        path = Path(self._folder.name) / "private" / "api.sock"
        self._library = Library(Path(self._folder.name) / "library")
        shelf = Shelf(Background(AtOnce()), lambda: self._library)
        self.interface = _KeptInterface(
            *(self.controller, path, lambda: self.time_s), grants_itself=True, shelf=shelf
        )
        self.interface.switch(on=True)
        while not self.interface.view.on:
            QCoreApplication.processEvents()
        self._socket = socket.socket(socket.AF_UNIX)
        self._socket.connect(str(path))
        self._socket.settimeout(_WITHIN_S)
        self._socket.setblocking(False)
        self._kept, self._ids, self._pinged_s = b"", 0, 0.0
        self._ask("hello", client="a client", protocol=1)

    def begin(self, name: str, *arguments: Any, **named: Any) -> Answer:
        """Carry out an operation over the socket, with the lease; nobody's time goes on."""
        if name in WITHOUT and name not in BY_OTHER_MEANS:
            return super().begin(name, *arguments, **named)
        held = self.interface.view.lease
        if held is None:
            answer = self._ask("lease.request", purpose="a test", moves=True)
            if "error" in answer:
                return self._refusal(answer["error"])
            held = self.interface.view.lease
            assert held is not None
        self.interface.begun = None
        if name == "run.start":
            name, params = "trajectory.run", self._stored(arguments[0])
        else:
            params = self._params(name, arguments, named)
        self.interface.fault = self._fault
        answer = self._ask(name, lease=held.number, **params)
        self._settle_what_was_said()
        return self._refusal(answer["error"]) if "error" in answer else self.interface.begun

    def _stored(self, run: Run) -> dict[str, object]:
        """Keep in the library what is to be run, as one that has run before."""
        self._library.save(Trajectory(run.name, points=tuple(run.points)), replacing=run.name)
        self._library.note_run(run.name, RunOptions())
        return {"name": run.name, "cycles": run.cycles, "first_row": run.first + 1}

    def _params(
        self, name: str, arguments: tuple[Any, ...], named: dict[str, Any]
    ) -> dict[str, object]:
        signature = inspect.signature(self.controller.operations[name].carry_out)
        before = (None,) if "started" in signature.parameters else ()
        bound = signature.bind(*before, *arguments, **named)
        bound.arguments.pop("started", None)
        return {key: _plain(value) for key, value in bound.arguments.items()}

    def _refusal(self, error: dict[str, Any]) -> Refusal | None:
        if error["code"] == Code.INTERNAL:
            return None  # as of a slot of the window that fails
        code = error.get("data", {}).get("reason")
        assert code is not None, error
        if code in _OF_LEASES:
            return _OF_LEASES[code](**error["data"]["figures"])
        told = [each for each in self.refusals if each.code == code]
        if not told:
            other = self.now.other_host
            told = [] if other is None or other.refusal.code != code else [other.refusal]
        return told[-1] if told else Reason(code, error["message"])()

    def _ask(self, method: str, **params: object) -> dict[str, Any]:
        self._ids += 1
        call = {"jsonrpc": "2.0", "id": self._ids, "method": method, "params": params}
        self._socket.sendall(json.dumps(call).encode() + b"\n")
        until_s = time.monotonic() + _WITHIN_S
        while True:
            QCoreApplication.processEvents()
            try:
                self._kept += self._socket.recv(65536)
            except BlockingIOError:
                time.sleep(0.0002)
            *lines, self._kept = self._kept.split(b"\n")
            for line in map(json.loads, lines):
                if line.get("id") == self._ids:
                    answer: dict[str, Any] = line
                    return answer
            assert time.monotonic() < until_s, f"{method} was not answered"

    def step(self, dt_s: float = 0.04) -> None:
        """Let a step's time pass; the client says that it is there."""
        if self.time_s - self._pinged_s >= _PING_S and not self._closed:
            self._pinged_s = self.time_s
            self._ask("ping")
        super().step(dt_s)

    def close(self) -> None:
        """End everything."""
        if not self._closed:
            self._socket.close()
            assert self.interface.end()
            self._folder.cleanup()
        super().close()


def _plain(value: Any) -> object:
    if isinstance(value, enum.Enum):
        return value.name.lower()
    if isinstance(value, tuple | list):
        return [_plain(each) for each in value]
    return value.item() if hasattr(value, "item") else value
