"""The file chooser, with an emergency stop in it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Final, cast

from PySide6.QtCore import QT_TRANSLATE_NOOP, Qt
from PySide6.QtWidgets import (
    QFileDialog,
    QGridLayout,
    QHeaderView,
    QLayout,
    QLayoutItem,
    QTreeView,
    QWidget,
)

from armui.control.arm_controller import ArmController
from armui.ui.widgets.stop_button import StopButton

_SIZE_PX: Final = (780, 540)

_QTS_OWN: Final = (
    QT_TRANSLATE_NOOP("QFileSystemModel", "Size"),
    QT_TRANSLATE_NOOP("QAbstractFileIconProvider", "Folder"),
)
"""Texts of Qt for which its translation has another word than is usual, or none: ours counts."""


class FileDialog(QFileDialog):
    """Qt's own file chooser: the system's could hold neither the stop button nor the stop key.

    Args:
        controller: Whom the emergency stop tells.
        parent: The window it belongs to.
        title: What the file is for.
        name_filter: As Qt writes it: ``Robot description (*.urdf)``.
        start: The folder to begin in, or a file in it.
        new_file: The name to propose for a file that is to be written; its ending is added where
            the operator types none. ``None``: an existing file is chosen.
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
        if start is not None:
            self.setDirectory(str(start if start.is_dir() else start.parent))
        if new_file is not None:
            self.selectFile(new_file)
        # Qt's own translation has no words for these two
        self.setLabelText(QFileDialog.DialogLabel.LookIn, self.tr("Folder"))
        self.setLabelText(QFileDialog.DialogLabel.FileType, self.tr("Kind"))
        self.stop_button = StopButton(controller, self)
        _add_at_the_top(self.layout(), self.stop_button)
        self._widen_columns()
        self.resize(*_SIZE_PX)

    def _widen_columns(self) -> None:
        """Let the name of a file have the room that size, kind and date leave."""
        for table in self.findChildren(QTreeView):
            mode = QHeaderView.ResizeMode
            table.header().setSectionResizeMode(mode.ResizeToContents)
            table.header().setSectionResizeMode(0, mode.Stretch)
            table.header().setStretchLastSection(False)


def _add_at_the_top(layout: QLayout | None, widget: QWidget) -> None:
    """Put a widget above everything in Qt's grid, at the right, as in the other dialogs."""
    if not isinstance(layout, QGridLayout):
        raise TypeError(f"Qt's file chooser is laid out by {layout!r}, not by a grid")
    places = [layout.getItemPosition(index) for index in range(layout.count())]
    items = [layout.takeAt(0) for _place in places]
    for item, place in zip(items, places, strict=True):
        row, column, rows, columns = cast("tuple[int, int, int, int]", place)
        layout.addItem(cast("QLayoutItem", item), row + 1, column, rows, columns)
    layout.addWidget(widget, 0, 0, 1, layout.columnCount(), Qt.AlignmentFlag.AlignRight)


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
    """Let the operator choose a file, without holding up anything; see :class:`FileDialog`.

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
    """Let the operator choose a folder, in the same way.

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
    dialog.show()
    return dialog
