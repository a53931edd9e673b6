"""Runs actions on the library's files in the background; results arrive in the GUI thread."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QObject
from shiboken6 import isValid

from armui.arm.refusal import Refusal
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.store import Library, LibraryError
from armui.trajectory.library.turns import take_turn
from armui.ui import words
from armui.ui.background import Background, Job

Result = TypeVar("Result")


@dataclass(frozen=True, slots=True)
class _Done(Generic[Result]):
    value: Result | None = None
    error: LibraryError | TrajectoryFileError | None = None


class LibraryWork(QObject):
    """Runs one action on the library after another, in the order of their requests.

    No window waits for a slow disk or an unreachable network folder.

    Args:
        library: The library; only actions may use it.
        background: Runs the actions.
        owner: The window that receives the results, unless it is gone.
    """

    def __init__(self, library: Library, background: Background, owner: QObject) -> None:
        super().__init__(owner)
        self.library = library
        self._background = background

    def do(
        self,
        action: Callable[[], Result],
        then: Callable[[Result], object] = lambda _result: None,
        refused: Callable[[str], object] = lambda _text: None,
    ) -> None:
        """Run an action on the library.

        Args:
            action: The function; it runs in another thread and must not touch a window.
            then: Receives the result.
            refused: Receives the reason for a refusal, in the operator's language.
        """
        self._background.begin_here(
            Job(partial(self._on_done, then, refused)), _run_alone, self.library, action
        )

    def _on_done(
        self,
        then: Callable[[Any], object],
        refused: Callable[[str], object],
        done: _Done[Any] | Refusal,
    ) -> None:
        if not isValid(self):
            return
        if isinstance(done, Refusal):
            refused(words.refusal(done))
        elif isinstance(done.error, LibraryError):
            refused(words.refusal(done.error.refusal))
        elif done.error is not None:
            refused(words.file_error(done.error))
        else:
            then(done.value)


def _run_alone(library: Library, action: Callable[[], Result]) -> _Done[Result]:
    try:
        return _Done(take_turn(library, action))
    except (LibraryError, TrajectoryFileError) as error:
        return _Done(error=error)
