"""Offers an unsaved recording of an earlier program: to save it, or to discard it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from armui.control.events import Level
from armui.ui import format as fmt
from armui.ui.actions.act import Act, HasActs
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.trajectory.library.recording_drafts import UnsavedRecording
    from armui.trajectory.library.store import Deleted
    from armui.ui.trajectory.library.library_work import LibraryWork


class UnsavedRecordingLine(HasActs, Translated, QWidget):
    """A line shown while there is such a recording; the oldest comes first.

    Args:
        work: Runs actions on the library.

    Signals:
        kept: The name under which one was saved.
        discarded: The name of one that was moved to the bin.
        refused: The library's reason for a refusal, as a text.
    """

    kept = Signal(str)
    discarded = Signal(str)
    refused = Signal(str)
    _keep = Act("Keep", named="keep_recording", tip="Saves it in the library.")
    _discard = Act(
        "Discard", named="discard_recording", tip="It stays under “Recently deleted…” for 30 days."
    )

    def __init__(self, work: LibraryWork) -> None:
        super().__init__()
        self._work = work
        self._found: Sequence[UnsavedRecording] = ()
        self._message = named("unsaved_recording", MessageLine(keeps_room=False))
        in_row((self._message, 1), self._keep, self._discard, on=self, spacing=8, margins=0)
        self.retranslate_ui()

    def refresh(self) -> None:
        """Search for unsaved recordings of earlier programs."""
        self._work.do(self._work.library.unsaved_recordings, self._show_found, self.refused.emit)

    def _show_found(self, found: Sequence[UnsavedRecording]) -> None:
        self._found = found
        self.setEnabled(True)
        self.retranslate_ui()

    @_keep.pressed
    def _on_keep(self) -> None:
        self.setEnabled(False)  # a second press has no effect
        keep = partial(self._work.library.keep_recording, self._found[0])
        self._work.do(keep, self._on_kept, self._on_refused)

    def _on_kept(self, name: str) -> None:
        self.kept.emit(name)
        self.refresh()

    @_discard.pressed
    def _on_discard(self) -> None:
        self.setEnabled(False)
        discard = partial(self._work.library.discard_recording, self._found[0])
        self._work.do(discard, self._on_discarded, self._on_refused)

    def _on_discarded(self, deleted: Deleted) -> None:
        self.discarded.emit(deleted.names[0])
        self.refresh()

    def _on_refused(self, text: str) -> None:
        self.refused.emit(text)
        self.refresh()  # another program may have decided meanwhile

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.setVisible(bool(self._found))
        self.show_acts()
        if not self._found:
            self._message.show_message("")
            return
        first = self._found[0]
        text = self.tr("Unsaved recording of {time}: “{name}”, {count} samples.").format(
            time=f"{first.begun.astimezone():%Y-%m-%d %H:%M}",
            name=first.name,
            count=fmt.count(first.count),
        )
        self._message.show_message(text, Level.WARNING)
