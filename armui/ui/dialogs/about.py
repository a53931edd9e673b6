"""The window «About armui»: version, files taken over from another version, and licences."""

from __future__ import annotations

import platform
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import Final

from PySide6.QtCore import qVersion
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QListWidget, QPlainTextEdit, QWidget

from armui import __version__
from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.system.command_process import is_packaged
from armui.system.files import read_file
from armui.system.licences import Licence, licences
from armui.system.version_record import TakenOver, taken_over
from armui.ui import words
from armui.ui.actions.act import Act
from armui.ui.background import Background, Job
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import fill, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import text_label

_SIZE_PX: Final = (820, 600)
_LIST_WIDTH_PX: Final = 240
_MOST_BYTES: Final = 1_000_000


def read_licence(path: Path) -> str:
    """Return the text of a licence, whatever its encoding.

    Raises:
        OSError: It cannot be read.
    """
    return read_file(path, _MOST_BYTES).decode("utf-8", "replace")


class AboutDialog(ArmDialog):
    """Shows version, facts and licences, which are read in the background at each opening.

    Args:
        controller: Receives the emergency stop.
        background: Reads the note of the versions, and the licences.
        settings: The program's file of settings.
        parent: The main window.
    """

    copy_button = Act("Copy as text", named="about_copy", key="about.copy")

    def __init__(
        self,
        controller: ArmController,
        background: Background,
        settings: Path,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(controller, parent)
        self._background = background
        self._settings = settings
        self._taken_over: TakenOver | None = None
        self._licences: tuple[Licence, ...] = ()
        self._reading: Job[str] | None = None
        self._facts = text_label("about_facts", wraps=True, plain=True)
        self._licence_note = text_label(rank="muted", wraps=True, plain=True)
        self.list = named("about_licences", QListWidget())
        self.list.setFixedWidth(_LIST_WIDTH_PX)
        self.text = named("about_licence", QPlainTextEdit(readOnly=True))
        self._message = named("about_message", MessageLine())
        shown = in_row(self.list, (self.text, 1), spacing=12)
        fill(self.body, self._facts, self._licence_note, (shown, 1))
        fill(self.footer, self.copy_button, (self._message, 1), CloseButton(self, on_enter=True))
        self.resize(*_SIZE_PX)
        self.list.currentRowChanged.connect(self._read)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("About armui"))
        self.show_acts()
        self.list.setAccessibleName(self.tr("Licences"))
        self.text.setAccessibleName(self.tr("Text of the licence"))
        self._licence_note.setText(
            self.tr(
                "Licences of armui and of the libraries it comes with. Qt and PySide are under the "
                "LGPL 3: they are files of their own, and may be replaced."
            )
        )
        self._facts.setText(self.facts())

    def open(self) -> None:
        """Show the dialog, and read what was taken over and the licences again."""
        super().open()
        self._message.show_message("")
        self._background.begin_here(Job(self._on_taken_over), taken_over, self._settings)
        self._background.begin_here(Job(self._on_licences), licences)

    def facts(self) -> str:
        """Return version, kind of installation, system and taken-over files, a line each."""
        way = (
            self.tr("installed package")
            if is_packaged()
            else self.tr("from the source or Python's packages")
        )
        system = f"{platform.system()} {platform.release()} {platform.machine()}"
        runs_on = f"Qt {qVersion()}, Python {platform.python_version()}, {system}"
        return "\n".join((f"armui {__version__} – {way}", runs_on, self._files_text()))

    def _files_text(self) -> str:
        found = self._taken_over
        if found is None:
            return self.tr("No files of another version were taken over.")
        at = datetime.fromisoformat(found.at).astimezone()
        before = found.before or self.tr("an older version")
        said = self.tr(
            "Files of {before} were taken over by {version} on {day}: settings {settings}, "
            "trajectories {trajectories}, logs {sessions}."
        )
        yes, no = self.tr("yes"), self.tr("no")
        return said.format(
            before=before,
            version=found.version,
            day=f"{at:%Y-%m-%d %H:%M}",
            settings=yes if found.files.get("settings") else no,
            trajectories=found.files.get("trajectories", 0),
            sessions=found.files.get("sessions", 0),
        )

    # Results of background work ---------------------------------------------------------------

    def _on_taken_over(self, found: TakenOver | Refusal | None) -> None:
        self._taken_over = None if isinstance(found, Refusal) else found
        self._facts.setText(self.facts())

    def _on_licences(self, found: tuple[Licence, ...] | Refusal) -> None:
        if isinstance(found, Refusal):
            self._message.show_message(partial(words.refusal, found), Level.FAULT)
            return
        if not found:
            said = self.tr("The texts were not installed; they are in the release's zip file.")
            self._message.show_message(said, Level.WARNING)
        if found != self._licences:
            self._licences = found
            self.list.clear()
            self.list.addItems([f"{each.of}: {each.path.name}" for each in found])
            self.list.setCurrentRow(0)

    def _read(self, row: int) -> None:
        if self._reading is not None:
            self._reading.wanted = False
        self.text.setPlainText("")
        if 0 <= row < len(self._licences):
            self._reading = Job(self._on_text)
            self._background.begin_here(self._reading, read_licence, self._licences[row].path)

    def _on_text(self, text: str | Refusal) -> None:
        self.text.setPlainText(words.refusal(text) if isinstance(text, Refusal) else text)

    @copy_button.pressed
    def _on_copy(self) -> None:
        QGuiApplication.clipboard().setText(self.facts())
        self._message.show_message(self.tr("Copied: paste it into a mail."), Level.DONE)
