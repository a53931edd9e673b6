"""The connection to armui: JSON-RPC 2.0, one message a line, and the thread that reads it."""

from __future__ import annotations

import contextlib
import itertools
import json
import os
import platform
import selectors
import socket
import stat
import threading
import time
from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from armui_client.errors import ArmuiError, Disconnected, Invalid, LeaseLost, Refused, Timeout

PROTOCOL: Final = 1
"""The version of the protocol that is spoken."""
ANSWER_S: Final = 10.0
"""An answer that needs no operator comes within this time."""

_SEND_S: Final = 5.0
_BEAT_S: Final = 0.3
"""armui ends the lease of a client that says nothing for a second."""
_MOST_BYTES: Final = 65536
"""armui ends the connection of who sends a longer line."""
_KEPT: Final = 1000
_LEASE_GOES_ON: Final = frozenset({"lease_declined", "lease_moves_nothing", "lease_too_fast"})
"""Reasons about a lease that leave it held."""


def socket_path() -> Path:
    """Return armui's socket: ``ARMUI_SOCKET``, or the one in this user's folder for programs."""
    named = os.environ.get("ARMUI_SOCKET")
    if named:
        return Path(named)
    for folder in (os.environ.get("XDG_RUNTIME_DIR") or "", f"/run/user/{os.getuid()}"):
        if Path(folder).is_absolute() and _is_private(Path(folder)):
            return Path(folder) / "armui" / "api.sock"
    state = os.environ.get("XDG_STATE_HOME", "").strip() or Path.home() / ".local" / "state"
    return Path(state) / "armui" / f"running-{platform.node() or 'here'}" / "api.sock"


def _is_private(folder: Path) -> bool:
    try:
        found = folder.lstat()
    except OSError:
        return False
    others_write = found.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
    return stat.S_ISDIR(found.st_mode) and found.st_uid == os.getuid() and not others_write


@dataclass
class Heard:
    """What the reading thread has heard; guarded by :attr:`Connection.news`.

    Attributes:
        calls: The calls that wait for their answers: the method, and the lease that each names.
        answers: Those that have come.
        operations: The newest state of each operation, by its number.
        events: Those that nobody has taken yet.
        state: The newest measured state, until somebody takes it.
        lease: The number of the lease that is held.
        ended: Why leases have ended, by their numbers.
        gone: Why the connection is over.
    """

    calls: dict[int, tuple[str, int | None]] = field(default_factory=dict)
    answers: dict[int, dict[str, Any]] = field(default_factory=dict)
    operations: dict[int, dict[str, Any]] = field(default_factory=dict)
    events: deque[dict[str, Any]] = field(default_factory=lambda: deque(maxlen=_KEPT))
    state: dict[str, Any] | None = None
    lease: int | None = None
    ended: dict[int, dict[str, Any]] = field(default_factory=dict)
    gone: str | None = None


class Connection:
    """Sends calls and waits for their answers, from any thread.

    Attributes:
        heard: What has come.
        news: Is notified when something has come; held to look at ``heard``.

    Raises:
        Disconnected: Nobody answers at the socket.
    """

    def __init__(self, path: Path) -> None:
        self.heard = Heard()
        self.news = threading.Condition()
        self._ids = itertools.count(1)
        self._writing = threading.Lock()
        self._torn = False
        self._complaint = ""
        if not hasattr(socket, "AF_UNIX"):
            raise Disconnected("armui's local interface is offered on Linux only.")
        self._socket = socket.socket(socket.AF_UNIX)
        self._socket.settimeout(_SEND_S)
        try:
            self._socket.connect(str(path))
        except OSError as error:
            self._socket.close()
            text = f"No armui answers at {path} ({error}). Start it with --api-on."
            raise Disconnected(text) from None
        self._thread = threading.Thread(target=self._read, name="armui-client", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Close it. A call that waits for its answer raises :class:`Disconnected`."""
        with self.news:
            self._complaint = "The connection is closed."
        with contextlib.suppress(OSError):
            self._socket.shutdown(socket.SHUT_RDWR)
        self._thread.join()
        self._socket.close()

    def ask(
        self,
        method: str,
        params: Mapping[str, Any],
        timeout_s: float,
        *,
        lease: int | None = None,
    ) -> Any:
        """Call a method, and return its result; see :meth:`answer`."""
        return self.answer(self.begin(method, params, lease=lease), timeout_s)

    def begin(self, method: str, params: Mapping[str, Any], *, lease: int | None = None) -> int:
        """Send a call, and return its number.

        Args:
            method: The method.
            params: Its arguments.
            lease: The lease that it names, if it needs one.
        """
        with self.news:
            number = next(self._ids)
            self.heard.calls[number] = (method, lease)
        try:
            self._write(method, params if lease is None else {**params, "lease": lease}, number)
        except BaseException:
            self.forget(number)
            raise
        return number

    def answer(self, number: int, timeout_s: float, *, again: bool = False) -> Any:
        """Wait for the answer to a call, and return its result.

        Args:
            number: The call's.
            timeout_s: For the answer.
            again: True if the answer will be waited for again after a :class:`Timeout`.

        Raises:
            Refused, LeaseLost, Invalid: It is an error.
            Timeout: None came.
            Disconnected: armui is gone.
        """
        waits = False
        try:
            with self.news:
                method, lease = self.heard.calls[number]
                text = f"armui has not answered {method}"
                self.wait_for(lambda: number in self.heard.answers, timeout_s, text)
                answer = self.heard.answers[number]
                if "error" in answer:
                    raise self._error(answer["error"], lease)
                return answer["result"]
        except Timeout:
            waits = again
            raise
        finally:
            if not waits:
                self.forget(number)

    def forget(self, number: int) -> None:
        """Wait for the answer to a call no longer; a lease that it brings is given back."""
        with self.news:
            self.heard.calls.pop(number, None)
            self.heard.answers.pop(number, None)

    def wait_for(self, ready: Callable[[], bool], timeout_s: float | None, text: str) -> None:
        """Wait, with ``news`` held, until something has been heard.

        Raises:
            Timeout: It has not; the text says what.
            Disconnected: armui is gone.
        """
        heard = self.heard
        if not self.news.wait_for(lambda: ready() or heard.gone is not None, timeout_s):
            raise Timeout(f"{text} within {timeout_s:g} s.")
        if heard.gone is not None and not ready():
            raise Disconnected(heard.gone)

    def lease(self) -> int | None:
        """Return the number of the lease that is held, or ``None``.

        Raises:
            LeaseLost: It was held, and not given back.
        """
        with self.news:
            held = self.heard.lease
            last = next(reversed(self.heard.ended), None)
        lost = self.why_lost(last) if held is None else None
        if lost is not None and lost.reason != "lease_released":
            raise lost
        return held

    def give_back(self) -> None:
        """Give the lease back that is held, if any, without waiting for the answer."""
        with self.news:
            held = self.heard.lease
        if held is not None:
            with contextlib.suppress(Disconnected):
                self._write("lease.release", {"lease": held})

    def why_lost(self, lease: int | None) -> LeaseLost | None:
        """Return why a lease has ended, or ``None``."""
        with self.news:
            told = None if lease is None else self.heard.ended.get(lease)
        if told is None:
            return None
        return LeaseLost(told["text"], reason=told["reason"], figures=told["figures"])

    def _error(self, told: Mapping[str, Any], lease: int | None) -> ArmuiError:
        text, data = told["message"], told.get("data") or {}
        reason, figures = data.get("reason", ""), data.get("figures", {})
        if not reason:
            return Invalid(text)
        lost = self.why_lost(lease)  # whatever has ended it: another host's reason, too
        if lost is not None:
            return lost
        if lease is not None and reason.startswith("lease_") and reason not in _LEASE_GOES_ON:
            return LeaseLost(text, reason=reason, figures=figures)
        return Refused(text, reason=reason, figures=figures)

    def _write(self, method: str, params: Mapping[str, Any], number: int | None = None) -> None:
        message: dict[str, Any] = {"jsonrpc": "2.0", "method": method, "params": params}
        if number is not None:
            message["id"] = number
        line = json.dumps(message, allow_nan=False).encode() + b"\n"
        if len(line) > _MOST_BYTES:
            raise Invalid(f"{method} has {len(line)} bytes of arguments; at most {_MOST_BYTES}.")
        with self._writing:
            # an interrupt may have torn the line before: this one begins on its own
            line, self._torn = (b"\n" if self._torn else b"") + line, True
            try:
                self._socket.sendall(line)
            except OSError as error:
                raise Disconnected(self.heard.gone or f"armui has gone ({error}).") from None
            self._torn = False

    # The reading thread -----------------------------------------------------------------------

    def _read(self) -> None:
        """Take in what comes, and say that we are there while the lease is held."""
        try:
            with contextlib.suppress(OSError, ValueError), selectors.DefaultSelector() as ready:
                ready.register(self._socket, selectors.EVENT_READ)
                self._read_with(ready)
        finally:
            with self.news:
                self.heard.gone, self.heard.lease = self._complaint or "armui has gone.", None
                self.news.notify_all()

    def _read_with(self, ready: selectors.BaseSelector) -> None:
        rest, beat_s = b"", time.monotonic()
        while True:
            if ready.select(_BEAT_S / 2):
                chunk = self._socket.recv(65536)
                if not chunk:
                    return
                *lines, rest = (rest + chunk).split(b"\n")
                for line in lines:
                    self._take(json.loads(line))
            if self.heard.lease is not None and time.monotonic() - beat_s >= _BEAT_S:
                beat_s = time.monotonic()
                self._write("ping", {})

    def _take(self, line: Mapping[str, Any]) -> None:
        heard, params = self.heard, line.get("params", {})
        method, number, result = line.get("method"), line.get("id"), line.get("result")
        with self.news:
            if method == "state":
                heard.state = params
            elif method == "event":
                heard.events.append(params)
            elif method == "operation":
                _keep(heard.operations, params["number"], params)
            elif method == "lease":
                _keep(heard.ended, params["lease"], params["reason"])
                if heard.lease == params["lease"]:
                    heard.lease = None
            elif number in heard.calls:
                heard.answers[number] = dict(line)
                if heard.calls[number][0] == "lease.request" and result is not None:
                    heard.lease = result["lease"]
            elif isinstance(result, dict) and "lease" in result:
                # granted when nobody waited for it any more
                self._write("lease.release", {"lease": result["lease"]})
            elif number is None and "error" in line:
                self._complaint = line["error"]["message"]
            self.news.notify_all()


def _keep(kept: dict[int, dict[str, Any]], number: int, told: dict[str, Any]) -> None:
    """Note the newest, and forget the oldest of many."""
    kept.pop(number, None)
    kept[number] = told
    if len(kept) > _KEPT:
        del kept[next(iter(kept))]
