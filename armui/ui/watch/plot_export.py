"""Saves and copies the plots, drawn and written in another thread."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtGui import QGuiApplication, QImage

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.telemetry.quantities import QUANTITIES
from armui.ui import words
from armui.ui.background import Job
from armui.ui.dialogs.files import FileExport
from armui.ui.watch import figure, value_table
from armui.ui.watch.curves_item import CURSOR_NAMES
from armui.ui.words import quantities as names

if TYPE_CHECKING:
    from pathlib import Path

    from PySide6.QtWidgets import QWidget

    from armui.control.arm_controller import ArmController
    from armui.telemetry.store import Telemetry
    from armui.ui.background import Background
    from armui.ui.watch.plot_board import PlotBoard


class PlotExport(FileExport):
    """Saves plots to files, and copies them.

    Args:
        controller: For the emergency stop in the file chooser.
        board: The plots.
        background: Draws and writes.
        window: The parent of the file chooser.
    """

    def __init__(
        self, controller: ArmController, board: PlotBoard, background: Background, window: QWidget
    ) -> None:
        super().__init__(controller, background, window)
        self._telemetry: Telemetry = board.telemetry
        self._board = board

    def save(self, kind: str) -> None:
        """Let the operator choose a file; ``kind`` is csv, png or svg."""
        self._choose(self.tr("Save the plots"), "armui", kind, partial(self.write, kind))

    def write(self, kind: str, path: Path) -> None:
        """Write the plots to a file."""
        job = self._job(path)
        if kind == "csv":
            self._background.begin_here(job, self._write_csv(path))
        else:
            self._background.begin_here(job, figure.write, path, self.figure(), kind)

    def copy_picture(self) -> None:
        """Copy a picture of the plots."""
        self._background.begin_here(Job(self._on_drawn), figure.to_image, self.figure())

    def copy_text(self, text: str) -> None:
        """Copy a table."""
        QGuiApplication.clipboard().setText(text)
        self.message_changed.emit(self.tr("Copied"), Level.DONE)

    def figure(self) -> figure.CurveFigure:
        """Return a copy of the plots that may be drawn in any thread."""
        board = self._board
        now_s, shown = board.now_s(), board.frame.shown
        edge_s = board.frame.edge_s(now_s)
        plots = [plot for pane in board.panes for plot in pane.as_figure(shown, edge_s, now_s)]
        cursors = [
            (name, at_s - edge_s)
            for name, at_s in zip(CURSOR_NAMES, board.cursors_s, strict=True)
            if at_s is not None
        ]
        heading = f"{self._telemetry.wall_time(edge_s):%Y-%m-%d %H:%M:%S}"
        ends = (shown.begin_s, shown.end_s)
        return figure.CurveFigure(heading, plots, edge_s, *ends, cursors, self._window.font())

    def _write_csv(self, path: Path) -> Callable[[], int]:
        now_s, shown = self._board.now_s(), self._board.frame.shown
        edge_s = self._board.frame.edge_s(now_s)
        edge = self._telemetry.wall_time(edge_s)
        keys = dict.fromkeys(key for plot in self._board.plot_layout.plots for key in plot)
        titles = [(key, _title(key)) for key in keys]
        telemetry, call = self._telemetry, self._background.call
        span = (edge_s + shown.begin_s, edge_s + shown.end_s)

        def work() -> int:
            table = value_table.columns(telemetry, titles, *span)
            return call(value_table.write_csv, path, table, edge_s, edge)

        return work

    def _on_drawn(self, result: QImage | Refusal) -> None:
        if isinstance(result, Refusal):
            self.message_changed.emit(words.refusal(result), Level.FAULT)
            return
        QGuiApplication.clipboard().setImage(result)
        self.message_changed.emit(self.tr("Copied"), Level.DONE)


def _title(key: str) -> str:
    what = QUANTITIES[key]
    name = names.quantity(what)
    return f"{name} [{what.unit}]" if what.unit else name
