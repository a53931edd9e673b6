"""Runs the package's adapter helper by pkexec, for the changes that only root may make.

`resources/packaging/linux/adapter_helper.py` is that helper. It prints its plan, and carries it out
after «go»; so the files can be shown before, and the arm can be checked after the password.
"""

from __future__ import annotations

import contextlib
import json
import os
import stat
import subprocess
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import IO, Any, Final

from armui.arm.refusal import Reason, Refusal

HELPER: Final = Path("/usr/libexec/armui-adapter")
POLICY: Final = Path("/usr/share/polkit-1/actions/org.armui.adapter.policy")
PKEXEC: Final = Path("/usr/bin/pkexec")
BY_ROOT: Final = (str(PKEXEC), "--disable-internal-agent", str(HELPER))
BY_ANYBODY: Final = (str(HELPER),)
_GO_S: Final = 60.0
"""The longest time from «go» to the last line; the helper gives each of its tools 5 s."""
_DISMISSED: Final = 126
_NOT_AUTHORISED: Final = 127
_PASSED_ON: Final = ("DBUS_", "DISPLAY", "HOME", "LANG", "LC_", "WAYLAND_", "XAUTH", "XDG_")
_LAST_WORDS: Final = 300

ADAPTER_DISMISSED = Reason(
    "adapter_dismissed", "The question for the password was closed: nothing was changed."
)
ADAPTER_NOT_AUTHORISED = Reason(
    "adapter_not_authorised",
    "The system did not allow it: {text}. Nothing was changed; the commands below do the same in a "
    "terminal.",
)
ADAPTER_NO_ANSWER = Reason(
    "adapter_no_answer",
    "The helper ended without reporting what it did: {text}. Look at the diagnosis again.",
)


ADAPTER_NO_INTERFACE = Reason(
    "adapter_no_interface", "{text} is not there any more. Plug the adapter in again."
)
ADAPTER_NOT_CAN = Reason("adapter_not_can", "{text} is not a CAN interface: nothing was changed.")
ADAPTER_BAD_BITRATE = Reason(
    "adapter_bad_bitrate", "{text} is not a bit rate of an arm: nothing was changed."
)
ADAPTER_BAD_NAME = Reason(
    "adapter_bad_name",
    "This name is not possible. Use small letters, digits and _, 15 at most, beginning with a "
    "letter, as in arm_left, and no name that the system itself gives (can0, eth0).",
)
ADAPTER_NAME_TAKEN = Reason("adapter_name_taken", "{text} is the name of another adapter already.")
ADAPTER_NO_SERIAL = Reason(
    "adapter_no_serial",
    "The adapter of {text} has no serial number: it cannot be told from another one, so "
    "nothing was saved.",
)
ADAPTER_BAD_SERIAL = Reason(
    "adapter_bad_serial", "The adapter's serial number cannot be used: {text}."
)
ADAPTER_NO_CHANNEL = Reason(
    "adapter_no_channel", "Which channel of its adapter {text} is, is not known."
)
ADAPTER_NOT_USB = Reason(
    "adapter_not_usb", "{text} is not a USB serial adapter: nothing was changed."
)
ADAPTER_NOT_OURS = Reason(
    "adapter_not_ours", "{text} belongs to another program: nothing was written."
)
ADAPTER_NOT_KEPT = Reason("adapter_not_kept", "Nothing is kept under the name {text}.")
ADAPTER_NO_BITRATE = Reason(
    "adapter_no_bitrate", "{text} has no bit rate yet. Switch it on with one first."
)
ADAPTER_NOT_UP = Reason(
    "adapter_not_up",
    "The system said that it is done, and it is not: {text}. Unplug the adapter, plug it "
    "in again, and try once more.",
)
ADAPTER_NOT_DOWN = Reason(
    "adapter_not_down", "{text} is still switched on, though the system said that it is off."
)
ADAPTER_TOOL_MISSING = Reason(
    "adapter_tool_missing", "The system's program {text} is missing. Install it."
)
ADAPTER_TOOL_HANGS = Reason(
    "adapter_tool_hangs",
    "The system's program {text} did not answer within 5 s. Unplug the adapter and plug it "
    "in again.",
)
ADAPTER_TOOL_FAILED = Reason("adapter_tool_failed", "The system refused it: {text}.")
ADAPTER_SYSTEM = Reason("adapter_system", "The system refused it: {text}.")
_SENTENCES: Final = {
    each.id: each
    for each in (
        ADAPTER_NO_INTERFACE,
        ADAPTER_NOT_CAN,
        ADAPTER_BAD_BITRATE,
        ADAPTER_BAD_NAME,
        ADAPTER_NAME_TAKEN,
        ADAPTER_NO_SERIAL,
        ADAPTER_BAD_SERIAL,
        ADAPTER_NO_CHANNEL,
        ADAPTER_NOT_USB,
        ADAPTER_NOT_OURS,
        ADAPTER_NOT_KEPT,
        ADAPTER_NO_BITRATE,
        ADAPTER_NOT_UP,
        ADAPTER_NOT_DOWN,
        ADAPTER_TOOL_MISSING,
        ADAPTER_TOOL_HANGS,
        ADAPTER_TOOL_FAILED,
        ADAPTER_SYSTEM,
    )
}
"""The helper's reasons for a refusal, by code."""


@dataclass(frozen=True, slots=True)
class Planned:
    """The helper's plan.

    Attributes:
        files: The files it writes, by path.
        removed: The files it removes.
    """

    files: Mapping[str, str] = field(default_factory=dict)
    removed: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Done:
    """The change is done.

    Attributes:
        result: The helper's result of checking it.
    """

    result: Mapping[str, Any]


Answer = Planned | Done | Refusal


@cache
def helper_is_there() -> bool:
    """Return whether the package has installed the helper, and only root can change it.

    The result is cached; the first call waits for the disk.
    """
    return are_owned((HELPER, POLICY, PKEXEC))


def are_owned(files: Sequence[Path], owner: int = 0) -> bool:
    """Return whether files exist, and only their owner can change or replace them."""
    try:
        found = [each.lstat() for each in (*files, *(each.parent for each in files))]
    except OSError:
        return False
    others = stat.S_IWGRP | stat.S_IWOTH
    return all(each.st_uid == owner and not each.st_mode & others for each in found)


class AdapterChange:
    """One change by the helper, which starts at once, with a thread that reads its output.

    Args:
        words: The verb and its arguments.
        on_answer: Called with the plan and, after `go`, with the result; or with a refusal. It
            is called in that thread, until it is ended.
        command: The command that starts the helper: as root, or as the present user, to plan only.
    """

    def __init__(
        self,
        words: Sequence[str],
        on_answer: Callable[[Answer], object],
        command: Sequence[str] = BY_ROOT,
    ) -> None:
        self._command = [*command, *words]
        self._on_answer = on_answer
        self._lock = threading.Lock()
        self._process: subprocess.Popen[str] | None = None
        self._late: threading.Timer | None = None
        self.is_ended = False
        self._thread = threading.Thread(target=self._run, name="armui-adapter", daemon=True)
        self._thread.start()

    def go(self) -> None:
        """Carry out the plan."""
        process = self._process
        if self.is_ended or process is None or process.stdin is None:
            return
        self._late = threading.Timer(_GO_S, self._on_late)
        self._late.daemon = True
        self._late.start()
        with contextlib.suppress(OSError, ValueError):  # it has ended; its output says why
            process.stdin.write("go\n")
            process.stdin.flush()

    def end(self) -> None:
        """Cancel: without «go» the helper does nothing; a change that has begun is completed."""
        with self._lock:
            self.is_ended = True
            process = self._process
        if self._late is not None:
            self._late.cancel()
        if process is not None:
            with contextlib.suppress(OSError):  # after the password it is root's: not ours to kill
                process.kill()
            if process.stdin is not None:
                with contextlib.suppress(OSError, ValueError):
                    process.stdin.close()  # without «go» the helper gives up

    def wait(self, within_s: float) -> bool:
        """Wait up to a time, and return whether it has ended."""
        self._thread.join(within_s)
        return not self._thread.is_alive()

    def _on_late(self) -> None:
        self._answer(ADAPTER_TOOL_HANGS(text=self._command[-1]))
        self.end()

    def _answer(self, answer: Answer) -> None:
        with self._lock:
            if self.is_ended:
                return
            self.is_ended = not isinstance(answer, Planned)
        if self._late is not None and self.is_ended:
            self._late.cancel()
        self._on_answer(answer)

    def _run(self) -> None:
        try:
            with self._lock:
                if self.is_ended:
                    return
                self._process = process = subprocess.Popen(  # noqa: S603 - the package's own
                    self._command,
                    stdin=subprocess.PIPE,
                    stdout=subprocess.PIPE,
                    stderr=subprocess.PIPE,
                    encoding="utf-8",
                    errors="replace",
                    env=_environment(),
                )
        except OSError as error:
            self._answer(ADAPTER_NOT_AUTHORISED(text=error.strerror or str(error)))
            return
        self._listen(process)

    def _listen(self, process: subprocess.Popen[str]) -> None:
        for line in _lines(process.stdout):
            answer = _understood(line)
            if answer is not None:
                self._answer(answer)
        said = "".join(_lines(process.stderr)).strip()[-_LAST_WORDS:]
        code = process.wait()
        if code == _DISMISSED:
            self._answer(ADAPTER_DISMISSED())
        elif code == _NOT_AUTHORISED:
            self._answer(ADAPTER_NOT_AUTHORISED(text=said.splitlines()[0] if said else "pkexec"))
        self._answer(ADAPTER_NO_ANSWER(text=said or str(code)))
        for pipe in (process.stdin, process.stdout, process.stderr):
            with contextlib.suppress(OSError, ValueError):
                if pipe is not None:
                    pipe.close()


def _lines(pipe: IO[str] | None) -> Sequence[str] | IO[str]:
    return () if pipe is None else pipe


def _understood(line: str) -> Answer | None:
    try:
        ((word, content),) = json.loads(line).items()
        if word == "plan":
            return Planned(content.get("files", {}), tuple(content.get("removed", ())))
        if word == "done":
            return Done(content)
        reason = _SENTENCES.get(f"adapter_{content['code']}", ADAPTER_SYSTEM)
        return reason(text=str(content["text"]))
    except (ValueError, AttributeError, KeyError, TypeError):
        return None


def _environment() -> dict[str, str]:
    """Return the variables for a program of the system, without our libraries and Python."""
    kept = {name: value for name, value in os.environ.items() if name.startswith(_PASSED_ON)}
    return {**kept, "PATH": "/usr/sbin:/usr/bin:/sbin:/bin"}
