"""The file chooser, with an emergency stop in it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QGridLayout, QWidget

from armui.ui.widgets.stop_button import StopButton

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


class FileDialog(QFileDialog):
    """Qt's own file chooser: the system's could hold neither the stop button nor the stop key.

    Args:
        controller: Whom the emergency stop tells.
        parent: The window it belongs to.
        title: What the file is for.
        name_filter: As Qt writes it: ``Robot description (*.urdf)``.
        start: The folder to begin in, or a file in it.
    """

    def __init__(
        self,
        controller: ArmController,
        parent: QWidget | None = None,
        *,
        title: str,
        name_filter: str,
        start: Path | None = None,
    ) -> None:
        super().__init__(parent, title)
        self.setOption(QFileDialog.Option.DontUseNativeDialog)
        self.setFileMode(QFileDialog.FileMode.ExistingFile)
        self.setNameFilter(name_filter)
        self.setModal(False)
        if start is not None:
            self.setDirectory(str(start if start.is_dir() else start.parent))
        self.stop_button = StopButton(controller, self)
        layout = self.layout()
        if isinstance(layout, QGridLayout):
            align = Qt.AlignmentFlag.AlignRight
            layout.addWidget(self.stop_button, layout.rowCount(), 0, 1, -1, align)


def choose_file(
    parent: QWidget,
    controller: ArmController,
    *,
    title: str,
    name_filter: str,
    on_chosen: Callable[[Path], object],
    start: Path | None = None,
) -> FileDialog:
    """Let the operator choose an existing file, without holding up anything.

    Returns:
        The open chooser; it deletes itself when closed. See :class:`FileDialog`.
    """
    dialog = FileDialog(controller, parent, title=title, name_filter=name_filter, start=start)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.fileSelected.connect(lambda name: on_chosen(Path(name)))
    dialog.show()
    return dialog
