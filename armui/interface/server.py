"""The socket of the local interface, served by a thread of its own (S31).

It reads lines, keeps each client within its limits, answers calls that need only the arm's newest
state, and passes all others to the window's thread. The memory for unread answers is bounded: a
client that does not read gets no states.
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import logging
import os
import socket
import struct
import sys
import threading
from collections.abc import Awaitable, Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Final

from armui.interface import messages
from armui.interface.lease import Client
from armui.interface.messages import MAX_BYTES, Call, CallError, Code, Id, Json
from armui.interface.methods import METHODS, NAME_LENGTH, read
from armui.interface.state_report import fields_of, report
from armui.system.clock import steady_s
from armui.system.files import read_file
from armui.system.paths import make_private

if TYPE_CHECKING:
    from armui.arm.state import ArmState

MOST_CLIENTS: Final = 8
MOST_CALLS_PER_S: Final = 2000
MOST_WAITING: Final = 64
"""The most calls of one client that may wait for their answers."""
MOST_UNREAD: Final = 512 * 1024
"""A client with more bytes unread gets no states and events; with twice as many it is cut off."""
_END_S: Final = 2.0
_HELLO: Final = "hello"
_HERE: Final = frozenset(
    name
    for name in METHODS
    if name.startswith(("ping", "state.", "events.")) or name == "stream.target"
)
"""The methods that are answered in the server's thread."""
_HELLO_WITHIN_S: Final = 1.0
_LOG: Final = logging.getLogger(__name__)


class SocketTakenError(OSError):
    """Another program of this user serves the socket already."""


@dataclass(eq=False)
class ClientSession:
    """One client's connection, from the server's side.

    Attributes:
        client: The client; its name is empty before its hello.
        events: True if it has subscribed to the events.
        heard_s: The time of the last line from it.
        waiting: The number of calls that the window's thread has not answered yet.
    """

    client: Client
    writer: asyncio.StreamWriter
    events: bool = False
    heard_s: float = 0.0
    waiting: int = 0
    greeted: bool = False
    subscription: asyncio.Task[None] | None = None
    room: asyncio.Event = field(default_factory=asyncio.Event)


@dataclass(frozen=True, slots=True)
class Target:
    """The newest target of a stream.

    Attributes:
        session: The session that it came from.
        lease: The number of the lease that it names.
        joints_deg: Six angles; ``None``: it is a pose.
        flange_pose_mm_deg: A pose of the flange in the base, or ``None``.
        id: The id of the answer, if one is wanted.
        answered: False for a notification.
    """

    session: ClientSession
    lease: object
    joints_deg: tuple[float, ...] | None
    flange_pose_mm_deg: tuple[float, ...] | None
    id: Id
    answered: bool


class Server:
    """Serves the socket from :meth:`start` to :meth:`stop`.

    Args:
        path: The socket.
        state: Returns the newest state of the arm, for any thread.
        on_opened: Takes why the socket could not be opened, or ``None`` once it is served.
        on_call: Takes a call that the window's thread must answer by :meth:`answer`.
        on_target: Called when there is a new target: see :meth:`take_target`.
        on_gone: Takes a session that is over.
        clock: Monotonic time in seconds.
    """

    def __init__(
        self,
        path: Path,
        state: Callable[[], ArmState],
        *,
        on_opened: Callable[[OSError | None], object],
        on_call: Callable[[ClientSession, Call], object],
        on_target: Callable[[], object],
        on_gone: Callable[[ClientSession], object],
        clock: Callable[[], float] = steady_s,
    ) -> None:
        self.path = path
        self._state = state
        self._on_opened = on_opened
        self._on_call, self._on_target = on_call, on_target
        self._on_gone = on_gone
        self._clock = clock
        self._loop: asyncio.AbstractEventLoop | None = None
        self._thread: threading.Thread | None = None
        self._sessions: dict[int, ClientSession] = {}
        self._tasks: set[asyncio.Task[None]] = set()
        self._numbers = 0
        self._targets: dict[int, Target] = {}
        self._target_lock = threading.Lock()
        self._last: asyncio.Event | None = None
        self._ending = False

    @property
    def clients(self) -> list[Client]:
        """The connected clients that have said hello."""
        return [each.client for each in list(self._sessions.values()) if each.greeted]

    # From the window's thread -----------------------------------------------------------------

    def start(self) -> None:
        """Open the socket, for this user alone, and serve it, all in a thread of its own."""
        loop = self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(
            target=self._serve, args=(loop,), name="armui-interface", daemon=True
        )
        self._thread.start()

    def stop(self) -> bool:
        """Close everything; return whether the thread has ended."""
        loop, thread = self._loop, self._thread
        if loop is None or thread is None:
            return True
        self._ending = True
        with contextlib.suppress(RuntimeError):  # the loop is closed: the thread has ended already
            loop.call_soon_threadsafe(self._end)
        thread.join(_END_S)
        return not thread.is_alive()

    def answer(self, session: ClientSession, call: Call, value: object | CallError) -> None:
        """Answer a call, from any thread."""
        self._soon(lambda: self._answer(session, call.id, call.answered, value, waited=True))

    def answer_target(self, target: Target, value: object | CallError) -> None:
        """Answer a target of a stream, from any thread."""
        if target.answered:
            self._soon(lambda: self._answer(target.session, target.id, True, value))

    def take_target(self) -> Target | None:
        """Return a client's newest target, once; an older one that was not taken is replaced."""
        with self._target_lock:
            return self._targets.popitem()[1] if self._targets else None

    def send_notification(self, method: str, params: Json, to: ClientSession | None = None) -> None:
        """Send a notification to one session, or to all that want the events."""
        line = messages.notification(method, params)
        self._soon(lambda: self._send_line(line, to))

    def cut_off(self, session: ClientSession) -> None:
        """Close the connection of a client."""
        self._soon(session.writer.close)

    def _soon(self, act: Callable[[], object]) -> None:
        loop = self._loop
        if loop is not None:
            with contextlib.suppress(RuntimeError):  # the server has ended meanwhile
                loop.call_soon_threadsafe(act)

    # In the server's thread -------------------------------------------------------------------

    def _serve(self, loop: asyncio.AbstractEventLoop) -> None:
        asyncio.set_event_loop(loop)
        try:
            messages.sentences()  # read the file now, so that no message waits for the disk later
            listening = _listen(self.path)
        except OSError as error:
            self._on_opened(error)
            loop.close()
            return
        try:
            loop.run_until_complete(self._until_ended(listening))
        finally:
            loop.close()

    async def _until_ended(self, listening: socket.socket) -> None:
        self._last = asyncio.Event()
        if self._ending:
            self._last.set()
        server = await _start(self._begin, listening)
        self._on_opened(None)
        try:
            await self._last.wait()
        finally:
            server.close()
            for task in list(self._tasks):
                task.cancel()
            await asyncio.gather(*self._tasks, return_exceptions=True)
            with contextlib.suppress(OSError):
                self.path.unlink()

    def _end(self) -> None:
        if self._last is not None:
            self._last.set()

    async def _begin(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        task = asyncio.current_task()
        if task is not None:
            self._tasks.add(task)
            task.add_done_callback(self._tasks.discard)
        process, user = _peer(writer.get_extra_info("socket"))
        if not _is_mine(user) or len(self._sessions) >= MOST_CLIENTS:
            text = f"At most {MOST_CLIENTS} clients, of the user of the program."
            writer.write(messages.error(CallError(Code.INVALID, text)))
            if _is_mine(user):
                with contextlib.suppress(OSError, EOFError, ValueError, asyncio.TimeoutError):
                    # wait for its hello: if the socket closed before, it would not get the error
                    await asyncio.wait_for(reader.readuntil(b"\n"), _HELLO_WITHIN_S)
            writer.close()
            return
        self._numbers += 1
        number = self._numbers
        session = ClientSession(Client(number, "", process, _program(process)), writer)
        self._sessions[number] = session
        try:
            await self._read(session, reader)
        except (ConnectionError, asyncio.IncompleteReadError, asyncio.CancelledError):
            pass  # the session has ended; asyncio would report a cancelled task as a failure
        except Exception:  # noqa: BLE001 - an error in one session must not end the others
            _LOG.exception("A session of the local interface failed")
        finally:
            self._sessions.pop(number, None)
            if session.subscription is not None:
                session.subscription.cancel()
            writer.close()
            self._on_gone(session)

    async def _read(self, session: ClientSession, reader: asyncio.StreamReader) -> None:
        began_s, count = self._clock(), 0
        while True:
            try:
                line = await reader.readuntil(b"\n")
            except asyncio.LimitOverrunError:
                text = f"A line has at most {MAX_BYTES} bytes."
                self._send(session, messages.error(CallError(Code.INVALID, text)))
                return
            session.heard_s = now_s = self._clock()
            if now_s - began_s >= 1.0:
                began_s, count = now_s, 0
            count += 1
            if count > MOST_CALLS_PER_S:
                await asyncio.sleep(began_s + 1.0 - now_s)
            self._take(session, line)
            # until there is room nothing more is read, which slows the client down
            while session.waiting >= MOST_WAITING:
                session.room.clear()
                await session.room.wait()

    def _take(self, session: ClientSession, line: bytes) -> None:
        """Answer one line from a client, or hand the call to the window's thread."""
        call: Call | None = None
        try:
            call = messages.read_call(line)
            if not session.greeted and call.method != _HELLO:
                raise CallError(Code.INVALID, "Say hello first: who you are.")  # noqa: TRY301
            if call.method == _HELLO:
                self._greet(session, call)
            if not self._answers(session, call):
                session.waiting += 1
                self._on_call(session, call)
        except CallError as wrong:
            if call is None or call.answered:
                self._send(session, messages.error(wrong, None if call is None else call.id))

    def _greet(self, session: ClientSession, call: Call) -> None:
        params = read(_HELLO, call.params)
        name, protocol = params["client"], params["protocol"]
        if not name.strip():
            raise CallError(Code.PARAMS, "“client” must be your name.")
        if protocol != messages.PROTOCOL:
            text = f"This program speaks protocol {messages.PROTOCOL}, not {protocol!r}."
            raise CallError(Code.PARAMS, text, data={"protocol": messages.PROTOCOL})
        known = session.client
        printable = "".join(each for each in name.strip() if each.isprintable())
        session.client = Client(known.number, printable, known.process, known.program)
        session.greeted = True

    def _answers(self, session: ClientSession, call: Call) -> bool:
        """Answer what needs only the newest state; return whether it did."""
        if call.method not in _HERE:
            return False
        params = read(call.method, call.params)
        if call.method == "stream.target":
            self._take_target(session, call, params)
            return True
        answer: Json = {}
        if call.method == "state.get":
            answer = report(self._state(), self._clock(), fields_of(params["fields"]))
        elif call.method == "state.subscribe":
            self._subscribe(session, float(params["rate_hz"]), fields_of(params["fields"]))
        elif call.method == "state.unsubscribe":
            self._unsubscribe(session)
        elif call.method != "ping":
            session.events = call.method == "events.subscribe"
        self._answer(session, call.id, call.answered, answer)
        return True

    def _take_target(self, session: ClientSession, call: Call, params: Json) -> None:
        """Keep the newest target for the window's thread."""
        joints_deg, pose = params["joints_deg"], params["flange_pose_mm_deg"]
        if (joints_deg is None) == (pose is None):
            raise CallError(Code.PARAMS, "Wanted: “joints_deg” or “flange_pose_mm_deg”.")
        lease = call.params.get("lease")
        target = Target(session, lease, joints_deg, pose, call.id, call.answered)
        with self._target_lock:
            before = self._targets.get(session.client.number)
            self._targets[session.client.number] = target
        if before is not None:
            self.answer_target(before, {"superseded": True})
        else:
            self._on_target()

    def _subscribe(self, session: ClientSession, rate_hz: float, fields: Iterable[str]) -> None:
        self._unsubscribe(session)
        session.subscription = asyncio.ensure_future(
            self._send_states(session, 1.0 / rate_hz, tuple(fields))
        )

    @staticmethod
    def _unsubscribe(session: ClientSession) -> None:
        if session.subscription is not None:
            session.subscription.cancel()
            session.subscription = None

    async def _send_states(
        self, session: ClientSession, period_s: float, fields: tuple[str, ...]
    ) -> None:
        due_s = self._clock()
        while True:
            told = report(self._state(), self._clock(), fields)
            self._send_line(messages.notification("state", told), session)
            due_s = max(due_s + period_s, self._clock())
            await asyncio.sleep(due_s - self._clock())

    def _answer(
        self,
        session: ClientSession,
        id_: Id,
        answered: bool,
        value: object | CallError,
        *,
        waited: bool = False,
    ) -> None:
        if waited:
            session.waiting -= 1
            session.room.set()
        if answered:
            wrong = isinstance(value, CallError)
            line = messages.error(value, id_) if wrong else messages.result(id_, value)  # type: ignore[arg-type]
            self._send(session, line)

    def _send_line(self, line: bytes, to: ClientSession | None) -> None:
        wanting = [each for each in self._sessions.values() if each.events]
        for session in wanting if to is None else [to]:
            if _unread(session) <= MOST_UNREAD:
                self._send(session, line)

    def _send(self, session: ClientSession, line: bytes) -> None:
        if session.writer.is_closing():
            return
        if _unread(session) > 2 * MOST_UNREAD:
            session.writer.transport.abort()  # its unread answers would fill up the memory
            return
        session.writer.write(line)


def _unread(session: ClientSession) -> int:
    return session.writer.transport.get_write_buffer_size()


if sys.platform == "linux":

    def _listen(path: Path) -> socket.socket:
        """Return the listening socket, closed to other users.

        Raises:
            SocketTakenError: Somebody answers there.
            OSError: It cannot be made.
        """
        make_private(path.parent)
        with socket.socket(socket.AF_UNIX) as probe:
            try:
                probe.connect(str(path))
            except OSError:
                with contextlib.suppress(FileNotFoundError):
                    path.unlink()  # the socket of a program that was killed: nobody listens at it
            else:
                raise SocketTakenError(errno.EADDRINUSE, "another program serves it", str(path))
        listening = socket.socket(socket.AF_UNIX)
        try:
            before = os.umask(0o177)
            try:
                listening.bind(str(path))
            finally:
                os.umask(before)
            listening.listen(MOST_CLIENTS)
        except OSError:
            listening.close()
            raise
        return listening

    def _peer(connection: socket.socket) -> tuple[int, int]:
        """Return the process and the user at the other end, as the system knows them."""
        told = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, struct.calcsize("3i"))
        process, user, _group = struct.unpack("3i", told)
        return process, user

    async def _start(
        begin: Callable[[asyncio.StreamReader, asyncio.StreamWriter], Awaitable[None]],
        listening: socket.socket,
    ) -> asyncio.Server:
        return await asyncio.start_unix_server(begin, sock=listening, limit=MAX_BYTES)

    def _is_mine(user: int) -> bool:
        return user == os.getuid()

else:

    def _listen(path: Path) -> socket.socket:
        raise OSError(errno.ENOSYS, "offered on Linux only", str(path))

    def _peer(connection: socket.socket) -> tuple[int, int]:
        raise OSError(errno.ENOSYS, "offered on Linux only", str(connection))

    async def _start(
        begin: Callable[[asyncio.StreamReader, asyncio.StreamWriter], Awaitable[None]],
        listening: socket.socket,
    ) -> asyncio.Server:
        return await asyncio.start_server(begin, sock=listening, limit=MAX_BYTES)

    def _is_mine(user: int) -> bool:
        return user < 0


def _program(process: int) -> str:
    try:
        words = read_file(Path(f"/proc/{process}/cmdline")).split(b"\0")
    except OSError:
        return ""
    names = [Path(os.fsdecode(each)).name for each in words[:2] if each]
    return " ".join(names)[:NAME_LENGTH]
