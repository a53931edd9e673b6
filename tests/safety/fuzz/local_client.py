"""A client of the local interface as the fuzz drives it: its lines come when the rig's time says.

Socket and thread are shown elsewhere (`tests.interface`); here they would cost the order of things.
"""

from __future__ import annotations

import json
import logging
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, Final

from armui.interface import messages
from armui.interface.lease import Client
from armui.interface.messages import MAX_BYTES
from armui.interface.server import MOST_CLIENTS, ClientSession, Server
from armui.interface.state_report import report

if TYPE_CHECKING:
    from tests.safety.fuzz.world import World

_LOG: Final = logging.getLogger("armui.interface.server")
_PING_S: Final = 0.4

Told = Callable[[dict[str, Any], bool], object]
"""Takes an answer: the result, or the error; and whether it is a result."""


class LockstepServer(Server):
    """Takes a client's lines when it is told to, and answers at once."""

    def start(self) -> None:
        """There is nothing to open."""
        messages.sentences()
        self._on_opened(None)

    def stop(self) -> bool:
        """Close all connections."""
        for each in list(self._sessions.values()):
            self.hang_up(each)
        return True

    def join(self, line: _Line) -> ClientSession | None:
        """Connect another client, or not: there are too many."""
        if len(self._sessions) >= MOST_CLIENTS:
            return None
        self._numbers += 1
        client = Client(self._numbers, "", 4711, "python fuzz.py")
        session = ClientSession(client, line)  # type: ignore[arg-type]
        self._sessions[self._numbers] = session
        return session

    def hear(self, session: ClientSession, line: bytes) -> None:
        """Take in one line, as the thread does that reads."""
        if session.client.number not in self._sessions:
            return
        if len(line) > MAX_BYTES:
            self.hang_up(session)
            return
        session.heard_s = self._clock()
        try:
            self._take(session, line)
        except Exception:  # noqa: BLE001 - as the server itself does
            _LOG.exception("A session of the local interface failed")
            self.hang_up(session)

    def hang_up(self, session: ClientSession) -> None:
        """The connection is over."""
        if self._sessions.pop(session.client.number, None) is not None:
            self._on_gone(session)

    def is_connected(self, session: ClientSession | None) -> bool:
        """Whether a client is connected."""
        return session is not None and session in self._sessions.values()

    def _soon(self, act: Callable[[], object]) -> None:
        act()

    def _subscribe(self, session: ClientSession, _rate_hz: float, fields: Iterable[str]) -> None:
        told = report(self._state(), self._clock(), tuple(fields))
        self._send_line(messages.notification("state", told), session)


class _Line:
    """Where a session writes what it says to its client."""

    def __init__(self, take: Callable[[bytes], object]) -> None:
        self.write = take
        self.transport = self

    def get_write_buffer_size(self) -> int:
        """It reads everything at once."""
        return 0

    def is_closing(self) -> bool:
        """It is written to until it is over."""
        return False

    def abort(self) -> None:
        """It reads everything, and is never cut off."""


class LocalClient:
    """A script of somebody's, which may say anything at any time.

    Attributes:
        lease: The last lease's number; it goes on using it after its end.
        heard_s: When it last said anything while it was connected.
        over: Called when it hears that its lease is over, with the reason.
        follow: The path of its targets by the time in seconds, while it streams.
        silent: Whether it says nothing.
    """

    def __init__(self, world: World) -> None:
        self._world = world
        self._session: ClientSession | None = None
        self._ids = 0
        self._waiting: dict[int, Told] = {}
        self.lease: int | None = None
        self.heard_s = -1e9
        self.over: Callable[[str], object] = _ignore
        self.follow: Callable[[float], Iterable[float]] | None = None
        self.on_target: Told = _ignore
        self._every_s, self._since_s, self._sent = 0.02, 0.0, 0
        self.silent = False

    @property
    def _server(self) -> LockstepServer | None:
        server = self._world.interface._server
        assert server is None or isinstance(server, LockstepServer)
        return server

    @property
    def connected(self) -> bool:
        """Whether its connection stands."""
        server = self._server
        return server is not None and server.is_connected(self._session)

    def connect(self) -> None:
        """Connect, unless it is."""
        self.silent = False
        server = self._server
        if not self.connected and server is not None:
            self._waiting.clear()
            self._session = server.join(_Line(self._on_line))
            self.call("hello", client="fuzz.py", protocol=1)

    def hang_up(self) -> None:
        """The connection is over, as of a process that was killed."""
        server, session = self._server, self._session
        if server is not None and session is not None:
            server.hang_up(session)

    def say(self, line: bytes) -> None:
        """Say a line, whatever it is."""
        server, session = self._server, self._session
        if server is not None and session is not None and self.connected:
            self.heard_s = self._world.time_s
            server.hear(session, line)

    def call(self, method: str, then: Told | None = None, **params: object) -> None:
        """Ask for something; what follows the answer is done as soon as it is there."""
        self._ids += 1
        if then is not None:
            self._waiting[self._ids] = then
        call = {"jsonrpc": "2.0", "id": self._ids, "method": method, "params": params}
        self.say(json.dumps(call).encode() + b"\n")

    def stream(
        self, path: Callable[[float], Iterable[float]], rate_hz: float, on_target: Told
    ) -> None:
        """Send targets from now on, with each answer taken."""
        self.follow, self._every_s, self.on_target = path, 1.0 / rate_hz, on_target
        self._since_s, self._sent = self._world.time_s, 0

    def step(self, _dt_s: float) -> None:
        """Let time pass: it says that it is there, and sends its targets."""
        now_s = self._world.time_s
        if self.silent or not self.connected:
            return
        if now_s - self.heard_s >= _PING_S:
            self.call("ping")
        since_s = now_s - self._since_s
        if self.follow is not None and since_s >= self._sent * self._every_s - 1e-9:
            self._sent = int(since_s / self._every_s + 1e-9) + 1
            target = list(self.follow(since_s))
            self.call("stream.target", self.on_target, lease=self.lease, joints_deg=target)

    def _on_line(self, line: bytes) -> None:
        said = json.loads(line)
        if said.get("method") == "lease":
            self.over(said["params"]["reason"]["reason"])
        then = self._waiting.pop(said["id"], None) if isinstance(said.get("id"), int) else None
        if then is not None:
            then(said.get("result", said.get("error")), "error" not in said)


def _ignore(*_: object) -> None:
    """Nobody asks."""
