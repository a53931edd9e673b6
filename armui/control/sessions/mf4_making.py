"""Has .mf4 files made of recordings that have ended, in a process that holds nobody up."""

from __future__ import annotations

from concurrent.futures import CancelledError
from typing import TYPE_CHECKING, NamedTuple

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.session.recording.kinds import MF4_SUFFIX
from armui.session.recording.problems import why_not_written

if TYPE_CHECKING:
    from collections.abc import Callable
    from concurrent.futures import Executor, Future
    from pathlib import Path


class Mf4Made(NamedTuple):
    """What became of one.

    Attributes:
        name: Of the recording.
        reason: Why there is no .mf4 file of it; ``None``: there is.
    """

    name: str
    reason: Refusal | None


def _make(folder: Path, name: str) -> Path:
    """In the process; see `armui.session.recording.mf4.make_mf4`."""
    from armui.session.recording.mf4 import make_mf4  # noqa: PLC0415 - python-can, asammdf

    return make_mf4(folder, name)


def _helper() -> Executor:
    from armui.system.helper_process import HelperProcess  # noqa: PLC0415 - for those who want it

    return HelperProcess()


class Mf4Making:
    """Makes one after another.

    Args:
        make_helper: Makes what does the work, with the first.
    """

    def __init__(self, make_helper: Callable[[], Executor] = _helper) -> None:
        self._make_helper = make_helper
        self._helper: Executor | None = None
        self._making: dict[str, tuple[Path, Future[Path]]] = {}

    @property
    def names(self) -> frozenset[str]:
        """The recordings of which one is being made: their files must not be moved."""
        return frozenset(self._making)

    def begin(self, folder: Path, name: str) -> None:
        """Have one made of a recording that was written as .blf."""
        if self._helper is None:
            self._helper = self._make_helper()
        self._making[name] = folder, self._helper.submit(_make, folder, name)

    def take(self) -> list[Mf4Made]:
        """Those that are done since the last call."""
        done = [(name, *each) for name, each in self._making.items() if each[1].done()]
        for name, _folder, _future in done:
            del self._making[name]
        return [Mf4Made(name, _reason(name, future, folder)) for name, folder, future in done]

    def end(self) -> None:
        """End the process at once; the recordings stay, as .blf."""
        if self._helper is not None:
            self._helper.shutdown(wait=False)
            self._helper = None
        self._making.clear()


def _reason(name: str, future: Future[Path], folder: Path) -> Refusal | None:
    try:
        error = future.exception()
    except CancelledError as cancelled:
        error = cancelled
    if isinstance(error, ModuleNotFoundError):
        return Refusal(RefusalCode.SESSION_NO_MF4)
    if isinstance(error, FileExistsError):
        return Refusal(RefusalCode.SESSION_NAME_TAKEN, {"name": f"{name}{MF4_SUFFIX}"})
    return None if error is None else why_not_written(error, folder)
