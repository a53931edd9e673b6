"""The picture as a file and in the clipboard."""

from __future__ import annotations

from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QGuiApplication, QImage

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.ui import words
from armui.ui.background import Job

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

    from armui.control.arm_controller import ArmController
    from armui.ui.background import Background
    from armui.viewport.view import ArmView

_FILTER: Final = "PNG (*.png)"


class PictureExport(QObject):
    """Writes what is on the screen; where the picture is old, or not there, it says so instead.

    Args:
        controller: Whom the stop button of the file chooser tells.
        view: Shows the picture.
        background: Writes files.
        window: Whose the file chooser is.

    Signals:
        said: What became of it, and how much it matters.
    """

    said = Signal(str, object)

    def __init__(
        self, controller: ArmController, view: ArmView, background: Background, window: QWidget
    ) -> None:
        super().__init__(window)
        self._controller = controller
        self._view = view
        self._background = background
        self._window = window

    def copy(self) -> None:
        """Put the picture into the clipboard."""
        image = self._taken()
        if image is not None:
            QGuiApplication.clipboard().setImage(image)
            self.said.emit(self.tr("Picture copied"), Level.DONE)

    def save(self) -> None:
        """Let the operator say where to, and write it there: as it was when it was asked for."""
        image = self._taken()
        if image is None:
            return
        from armui.ui.dialogs.files import choose_file  # noqa: PLC0415 - faster start

        now = datetime.now().astimezone()
        choose_file(
            self._window,
            self._controller,
            title=self.tr("Save picture"),
            name_filter=_FILTER,
            on_chosen=partial(self.write, image),
            new_file=str(Path.home() / f"armui-{now:%Y%m%d-%H%M%S}.png"),
        )

    def write(self, image: QImage, path: Path) -> None:
        """Write a picture to a file, out of the window's way."""
        self._background.begin_here(Job(partial(self._on_written, path)), _write, image, path)

    def _taken(self) -> QImage | None:
        if not self._view.is_current:
            text = self.tr("There is no picture of now to be taken: wait until it is drawn.")
            self.said.emit(text, Level.WARNING)
            return None
        return self._view.taken_picture()

    def _on_written(self, path: Path, result: Refusal | None) -> None:
        if isinstance(result, Refusal):
            text = self.tr("Not saved: {path}. {reason}")
            text = text.format(path=path, reason=words.refusal(result))
            self.said.emit(text, Level.FAULT)
        else:
            self.said.emit(self.tr("Saved: {path}").format(path=path), Level.DONE)


def _write(image: QImage, path: Path) -> None:
    """Write a PNG.

    Raises:
        OSError: It cannot be written.
    """
    if not image.save(str(path), "PNG"):  # type: ignore[call-overload]
        with path.open("ab"):
            pass  # says why
        raise OSError(str(path))
