"""Lets the operator choose files and folders, and writes files."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, cast

from PySide6.QtCore import QT_TRANSLATE_NOOP, QDir, QObject, Qt, Signal
from PySide6.QtWidgets import (
    QDialogButtonBox,
    QFileDialog,
    QGridLayout,
    QHeaderView,
    QLayout,
    QLayoutItem,
    QTreeView,
    QWidget,
)

from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.ui import words
from armui.ui.background import Job
from armui.ui.dialogs.base import MARGIN_PX, place
from armui.ui.widgets.buttons import show_primary
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.text_label import text_label

if TYPE_CHECKING:
    from armui.ui.background import Background


_SIZE_PX: Final = (780, 540)

_QTS_OWN: Final = (
    QT_TRANSLATE_NOOP("QFileSystemModel", "Size"),
    QT_TRANSLATE_NOOP("QAbstractFileIconProvider", "Folder"),
)
"""Texts for which Qt's translation is unusual or missing; our translation is used."""


class FileExport(QObject):
    """The common part of the exports of plots, events and the picture.

    Args:
        controller: For the emergency stop in the file chooser.
        background: Writes files.
        window: The parent of the file chooser.

    Signals:
        message_changed: The text on the result, and its :class:`Level`.
    """

    message_changed = Signal(str, object)

    def __init__(self, controller: ArmController, background: Background, window: QWidget) -> None:
        super().__init__(window)
        self._controller = controller
        self._background = background
        self._window = window

    def _choose(
        self, title: str, name: str, kind: str, on_chosen: Callable[[Path], object]
    ) -> None:
        """Let the operator choose the file to be written.

        Args:
            title: The title of the file chooser.
            name: How the proposed name begins; date and time follow.
            kind: The ending of the file, ``csv``.
            on_chosen: Called with the file.
        """
        now = datetime.now().astimezone()
        choose_file(
            self._window,
            self._controller,
            title=title,
            name_filter=f"{kind.upper()} (*.{kind})",
            on_chosen=on_chosen,
            new_file=f"{name}-{now:%Y%m%d-%H%M%S}.{kind}",
        )

    def _job(self, path: Path) -> Job[Any]:
        """Return a job of writing a file that passes its result to `_on_written`."""
        return Job(partial(self._on_written, path))

    def _on_written(self, path: Path, result: int | Refusal | None) -> None:
        if isinstance(result, Refusal):
            text = self.tr("Not saved: {path}. {reason}")
            text = text.format(path=path, reason=words.refusal(result))
            self.message_changed.emit(text, Level.FAULT)
        else:
            self.message_changed.emit(self.tr("Saved: {path}").format(path=path), Level.DONE)


class FileDialog(QFileDialog):
    """Qt's own file chooser: the system's could have neither the stop button nor the stop key.

    Args:
        controller: Receives the emergency stop.
        parent: The window it belongs to.
        title: The purpose of the file.
        name_filter: The filter in Qt's notation: ``Robot description (*.urdf)``.
        start: The folder to begin in, or a file in it; by default that of the last file.
        new_file: The proposed name of a file to be written; its suffix is added if the operator
            types none. ``None`` to choose an existing file.
    """

    def __init__(
        self,
        controller: ArmController,
        parent: QWidget | None = None,
        *,
        title: str,
        name_filter: str,
        start: Path | None = None,
        new_file: str | None = None,
    ) -> None:
        super().__init__(parent, title)
        self.setOption(QFileDialog.Option.DontUseNativeDialog)
        self.setFileMode(QFileDialog.FileMode.ExistingFile)
        if new_file is not None:
            self.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
            self.setFileMode(QFileDialog.FileMode.AnyFile)
            self.setDefaultSuffix(Path(new_file).suffix)
        self.setNameFilter(name_filter)
        self.setModal(False)
        # Qt begins in the folder shown last, but at first in the process's working directory
        if start is None and self.directory() == QDir.current():
            start = Path.home()
        if start is not None:
            self.setDirectory(str(start if start.is_dir() else start.parent))
        if new_file is not None:
            self.selectFile(new_file)
        # Qt's own translation has no words for these two
        self.setLabelText(QFileDialog.DialogLabel.LookIn, self.tr("Folder"))
        self.setLabelText(QFileDialog.DialogLabel.FileType, self.tr("Kind"))
        self.stop_button = StopButton(controller, self, slim=True)
        halt_button = HaltButton(controller, self, slim=True)
        heading = text_label(text=title, rank="title", plain=True)
        top = in_row((heading, 1), halt_button, self.stop_button, spacing=14)
        _add_at_the_top(self.layout(), top)
        for buttons in self.findChildren(QDialogButtonBox):
            for button in buttons.buttons():
                if buttons.buttonRole(button) is QDialogButtonBox.ButtonRole.AcceptRole:
                    show_primary(button, wanted=True)
        self._widen_columns()
        self.resize(*_SIZE_PX)
        self.filesSelected.connect(self._note_folder)

    def _note_folder(self, names: list[str]) -> None:
        """Have the next chooser begin where these files are, also where their path was typed."""
        if self.fileMode() is not QFileDialog.FileMode.Directory:
            self.setDirectory(str(Path(names[0]).parent))

    def _widen_columns(self) -> None:
        """Give the names of files the width that size, kind and date leave."""
        for table in self.findChildren(QTreeView):
            mode = QHeaderView.ResizeMode
            table.header().setSectionResizeMode(mode.ResizeToContents)
            table.header().setSectionResizeMode(0, mode.Stretch)
            table.header().setStretchLastSection(False)


def _add_at_the_top(layout: QLayout | None, buttons: QLayout) -> None:
    """Put buttons above everything in Qt's grid, as in the other dialogs."""
    if not isinstance(layout, QGridLayout):
        raise TypeError(f"Qt's file chooser is laid out by {layout!r}, not by a grid")
    places = [layout.getItemPosition(index) for index in range(layout.count())]
    items = [layout.takeAt(0) for _place in places]
    for item, cell in zip(items, places, strict=True):
        row, column, rows, columns = cast("tuple[int, int, int, int]", cell)
        layout.addItem(cast("QLayoutItem", item), row + 1, column, rows, columns)
    layout.addLayout(buttons, 0, 0, 1, layout.columnCount())
    layout.setContentsMargins(*(4 * (MARGIN_PX,)))


def choose_file(
    parent: QWidget,
    controller: ArmController,
    *,
    title: str,
    name_filter: str,
    on_chosen: Callable[[Path], object],
    start: Path | None = None,
    new_file: str | None = None,
) -> FileDialog:
    """Let the operator choose a file without blocking; see :class:`FileDialog`.

    Returns:
        The open chooser; it deletes itself when closed.
    """
    dialog = FileDialog(
        controller, parent, title=title, name_filter=name_filter, start=start, new_file=new_file
    )
    return _asking(dialog, on_chosen)


def choose_folder(
    controller: ArmController,
    parent: QWidget,
    *,
    title: str,
    on_chosen: Callable[[Path], object],
    start: Path | None = None,
) -> FileDialog:
    """Let the operator choose a folder without blocking.

    Returns:
        The open chooser; it deletes itself when closed.
    """
    dialog = FileDialog(controller, parent, title=title, name_filter="", start=start)
    dialog.setFileMode(QFileDialog.FileMode.Directory)
    dialog.setOption(QFileDialog.Option.ShowDirsOnly)
    return _asking(dialog, on_chosen)


def _asking(dialog: FileDialog, on_chosen: Callable[[Path], object]) -> FileDialog:
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.fileSelected.connect(lambda name: on_chosen(Path(name)))
    place(dialog)
    dialog.show()
    return dialog
