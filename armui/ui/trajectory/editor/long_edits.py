"""Works out edits of many rows in another process, so that the stop button responds at once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from PySide6.QtCore import QObject

from armui.arm.refusal import Reason, Refusal
from armui.ui.background import Job

if TYPE_CHECKING:
    from armui.control.run.preflight import Works
    from armui.ui.trajectory.editor.document import Document

EDIT_UNDER_WAY = Reason(
    "edit_under_way", "The program is still working on many rows. Wait until it is done."
)
POINTS_CHANGED = Reason(
    "points_changed", "The points were changed while the program worked on them. Try again."
)

Outcome = TypeVar("Outcome")


@dataclass(frozen=True, slots=True)
class LongEdit(Generic[Outcome]):
    """An edit that takes long for many rows.

    Attributes:
        rows: The number of rows.
        at_once: The most rows to be worked out in the window's thread.
        work: A function of a module that works the edit out.
        arguments: Its arguments.
        finish: Carries the edit out with the result, in the window's thread; the result may be a
            :class:`Refusal` where the work has failed.
    """

    rows: int
    at_once: int
    work: Callable[..., object]
    arguments: tuple[Any, ...]
    finish: Callable[[Any], Outcome]


class LongEdits(QObject):
    """Carries out one long edit at a time.

    Args:
        document: The document.
        background: Runs the work.
        parent: The owner.
    """

    def __init__(self, document: Document, background: Works, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._background = background
        self._job: Job[object] | None = None

    @property
    def busy(self) -> bool:
        """True while an edit is worked out."""
        return self._job is not None

    def begin(self, edit: LongEdit[Outcome], then: Callable[[Outcome | Refusal], object]) -> None:
        """Work an edit out, and carry it out if the points are still the same.

        Args:
            edit: The edit.
            then: Receives its outcome, or why it was not carried out.
        """
        if self.busy:
            then(EDIT_UNDER_WAY())
            return
        if edit.rows <= edit.at_once:
            then(edit.finish(edit.work(*edit.arguments)))
            return
        before = self._document.points

        def done(result: object) -> None:
            self._job = None
            same = self._document.points is before
            then(edit.finish(result) if same else POINTS_CHANGED())

        self._job = Job(done)
        self._background.begin(self._job, edit.work, *edit.arguments)

    def drop(self) -> None:
        """Drop the edit that is worked out: its page is left."""
        if self._job is not None:
            self._job.wanted = False
            self._job = None
