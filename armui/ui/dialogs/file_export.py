"""Putting something into a file that the operator chooses, in another thread."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.ui import words
from armui.ui.background import Job

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

    from armui.control.arm_controller import ArmController
    from armui.ui.background import Background


class FileExport(QObject):
    """What the exports of plots, events and the picture share.

    Args:
        controller: For the emergency stop in the file chooser.
        background: Where files are written.
        window: Whom the file chooser belongs to.

    Signals:
        said: What has become of it, and its :class:`Level`.
    """

    said = Signal(str, object)

    def __init__(self, controller: ArmController, background: Background, window: QWidget) -> None:
        super().__init__(window)
        self._controller = controller
        self._background = background
        self._window = window

    def _choose(
        self, title: str, name: str, kind: str, on_chosen: Callable[[Path], object]
    ) -> None:
        """Let the operator say where to.

        Args:
            title: Of the file chooser.
            name: How the proposed name begins; date and time follow.
            kind: The ending of the file, ``csv``.
            on_chosen: Gets the file.
        """
        from armui.ui.dialogs.files import choose_file  # noqa: PLC0415 - faster start

        now = datetime.now().astimezone()
        choose_file(
            self._window,
            self._controller,
            title=title,
            name_filter=f"{kind.upper()} (*.{kind})",
            on_chosen=on_chosen,
            new_file=str(Path.home() / f"{name}-{now:%Y%m%d-%H%M%S}.{kind}"),
        )

    def _job(self, path: Path) -> Job[Any]:
        """Of writing a file: says what came of it."""
        return Job(partial(self._on_written, path))

    def _on_written(self, path: Path, result: int | Refusal | None) -> None:
        if isinstance(result, Refusal):
            text = self.tr("Not saved: {path}. {reason}")
            text = text.format(path=path, reason=words.refusal(result))
            self.said.emit(text, Level.FAULT)
        else:
            self.said.emit(self.tr("Saved: {path}").format(path=path), Level.DONE)
