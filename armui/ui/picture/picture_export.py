"""The picture as a file and in the clipboard."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QBuffer, QByteArray, QIODevice
from PySide6.QtGui import QGuiApplication, QImage

from armui.control.events import Level
from armui.system.atomic import write_whole
from armui.ui.dialogs.files import FileExport

if TYPE_CHECKING:
    from pathlib import Path

    from PySide6.QtWidgets import QWidget

    from armui.control.arm_controller import ArmController
    from armui.ui.background import Background
    from armui.viewport.view import ArmView


class PictureExport(FileExport):
    """Writes what is on the screen; where the picture is old, or not there, it says so instead.

    Args:
        controller: Whom the stop button of the file chooser tells.
        view: Shows the picture.
        background: Writes files.
        window: Whose the file chooser is.
    """

    def __init__(
        self, controller: ArmController, view: ArmView, background: Background, window: QWidget
    ) -> None:
        super().__init__(controller, background, window)
        self._view = view

    def copy(self) -> None:
        """Put the picture into the clipboard."""
        image = self._taken()
        if image is not None:
            QGuiApplication.clipboard().setImage(image)
            self.said.emit(self.tr("Picture copied"), Level.DONE)

    def save(self) -> None:
        """Let the operator say where to, and write it there: as it was when it was asked for."""
        image = self._taken()
        if image is not None:
            self._choose(self.tr("Save picture"), "armui", "png", partial(self.write, image))

    def write(self, image: QImage, path: Path) -> None:
        """Write a picture to a file, out of the window's way."""
        self._background.begin_here(self._job(path), _write, image, path)

    def _taken(self) -> QImage | None:
        if not self._view.is_current:
            text = self.tr("There is no picture of now to be taken: wait until it is drawn.")
            self.said.emit(text, Level.WARNING)
            return None
        return self._view.taken_picture()


def _write(image: QImage, path: Path) -> None:
    """Write a PNG; a file that was there is replaced when the new one is whole.

    Raises:
        OSError: It cannot be written.
    """
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    if not image.save(buffer, "PNG"):  # type: ignore[call-overload]
        raise OSError(str(path))
    write_whole(path, bytes(data.data()))
