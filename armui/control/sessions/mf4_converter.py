"""Makes .mf4 files of ended recordings, in a process of its own."""

from __future__ import annotations

import contextlib
import threading
from concurrent.futures import CancelledError, ThreadPoolExecutor
from concurrent.futures import wait as wait_for
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.session.recording.kinds import MF4_SUFFIX, no_mf4, why_not_written
from armui.system.atomic import unfinished_name
from armui.system.files import read_file
from armui.system.helper_process import HelperProcess

if TYPE_CHECKING:
    from collections.abc import Callable
    from concurrent.futures import Executor, Future

SESSION_MF4_CALLED_OFF = Reason(
    "session_mf4_called_off", "Cancelled. The recording itself is complete, as .blf."
)
SESSION_NAME_TAKEN = Reason(
    "session_name_taken",
    "There is a file called “{name}” in the folder already. Choose another name.",
)


_LOOK_S: Final = 0.1
_END_S: Final = 1.0


@dataclass(frozen=True, slots=True)
class Mf4Made:
    """The outcome of one conversion.

    Attributes:
        name: The name of the recording.
        refusal: The reason why there is no .mf4 file of it, or ``None``.
    """

    name: str
    refusal: Refusal | None


@dataclass(slots=True, eq=False)
class _Conversion:
    """One recording that is to be converted.

    Attributes:
        share: How much of it is done, 0 to 1; ``None`` before it is begun.
    """

    folder: Path
    name: str
    called_off: threading.Event = field(default_factory=threading.Event)
    share: float | None = None


def _make(folder: Path, name: str, told: Path, unfinished: Path) -> None:
    """In the process; see `armui.session.recording.mf4.make_mf4`."""
    from armui.session.recording import mf4  # noqa: PLC0415 - python-can, asammdf

    with mf4.told_in(told) as tell:
        mf4.make_mf4(folder, name, tell, unfinished=unfinished)


def _helper() -> Executor:
    return HelperProcess()


class Mf4Converter:
    """Converts recordings to MF4 one after another, in a thread that waits for disk and process.

    Args:
        make_helper: Makes the process for one conversion.
    """

    def __init__(self, make_helper: Callable[[], Executor] = _helper) -> None:
        self._make_helper = make_helper
        self._thread: ThreadPoolExecutor | None = None
        self._conversions: dict[str, tuple[_Conversion, Future[None]]] = {}

    @property
    def names(self) -> frozenset[str]:
        """The recordings under conversion or waiting for it: their files must not be moved."""
        return frozenset(self._conversions)

    @property
    def share(self) -> float | None:
        """The share of the present conversion that is done, 0–1, or ``None`` if unknown."""
        return next((conversion.share for conversion, _done in self._conversions.values()), None)

    def begin(self, folder: Path, name: str) -> None:
        """Queue the conversion of a recording that was written as .blf."""
        if self._thread is None:
            self._thread = ThreadPoolExecutor(1, "armui-mf4")
        conversion = _Conversion(folder, name)
        self._conversions[name] = conversion, self._thread.submit(self._work, conversion)

    def call_off(self) -> None:
        """Cancel all conversions; nothing remains of the one under way. `take_done` reports it."""
        for conversion, _done in self._conversions.values():
            conversion.called_off.set()

    def take_done(self) -> list[Mf4Made]:
        """Return the conversions that have ended since the last call."""
        done = [each for each in self._conversions.values() if each[1].done()]
        for conversion, _future in done:
            del self._conversions[conversion.name]
        return [
            Mf4Made(conversion.name, _reason(conversion, future)) for conversion, future in done
        ]

    def end(self) -> None:
        """End the process at once; the recordings stay, as .blf."""
        self.call_off()
        if self._thread is not None:
            wait_for([future for _order, future in self._conversions.values()], _END_S)
            self._thread.shutdown(wait=False, cancel_futures=True)
            self._thread = None
        self._conversions.clear()

    def _work(self, conversion: _Conversion) -> None:
        """Make one, in the thread.

        Raises:
            CancelledError: It was called off; nothing remains of it.
            Exception: Whatever was wrong.
        """
        if conversion.called_off.is_set():
            raise CancelledError
        helper = self._make_helper()
        unfinished = unfinished_name(conversion.folder / f"{conversion.name}{MF4_SUFFIX}")
        try:
            with TemporaryDirectory(prefix="armui-mf4-") as room:
                told = Path(room) / "share"
                future = helper.submit(_make, conversion.folder, conversion.name, told, unfinished)
                while not (wait_for([future], _LOOK_S).done or conversion.called_off.is_set()):
                    with contextlib.suppress(OSError, ValueError):
                        conversion.share = float(read_file(told))
                if not future.done():
                    helper.shutdown()
                    raise CancelledError
                future.result()
        finally:
            helper.shutdown()
            with contextlib.suppress(OSError):
                unfinished.unlink(missing_ok=True)


def _reason(conversion: _Conversion, future: Future[None]) -> Refusal | None:
    name = f"{conversion.name}{MF4_SUFFIX}"
    try:
        error = future.exception()
    except CancelledError as cancelled:
        error = cancelled
    if isinstance(error, CancelledError):
        return SESSION_MF4_CALLED_OFF()
    if isinstance(error, ModuleNotFoundError):
        return no_mf4()
    if isinstance(error, FileExistsError):
        return SESSION_NAME_TAKEN(name=name)
    return None if error is None else why_not_written(error, conversion.folder)
