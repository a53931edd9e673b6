"""Plots one below the other, beside a list of everything that can be drawn."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPoint, Qt, QTimer, Signal
from PySide6.QtWidgets import QMenu, QWidget

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.ui.actions.command import Command, Target
from armui.ui.actions.keys import listen_for
from armui.ui.background import Job
from armui.ui.watch import layout_file
from armui.ui.watch.cursor_table import CursorTable
from armui.ui.watch.plot_bar import SAVES, PlotBar
from armui.ui.watch.plot_board import PlotBoard
from armui.ui.watch.plot_export import PlotExport
from armui.ui.watch.plot_layout import MOST_CURVES, MOST_PLOTS, from_text, to_text
from armui.ui.watch.quantity_list import QuantityList
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import fill, in_column, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.page import Page
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from PySide6.QtGui import QHideEvent

    from armui.control.arm_controller import ArmController
    from armui.telemetry.store import Telemetry
    from armui.ui.background import Background


_KEEP_AFTER_MS: Final = 1000
"""The delay after the last change, before the layout is written to the disk."""


class PlotsArea(QWidget):
    """The common part of the page 曲线 and a replay.

    Args:
        telemetry: The series of the curves.
        controller: Receives the stop of the file chooser.
        background: Writes files.

    Attributes:
        board: The plots.
        bar: The bar that controls them.
        quantities: The list of everything that can be drawn.
        cursor_table: The values at the cursors.
        export: Saves and copies the plots.
        message: The line for results.
    """

    def __init__(
        self,
        telemetry: Telemetry,
        controller: ArmController,
        background: Background,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.board = PlotBoard(telemetry, self)
        self.bar = PlotBar(self.board, self)
        self.quantities = QuantityList(telemetry, self)
        self.cursor_table = CursorTable(self.board, telemetry, self)
        self.message = named("plot_message", MessageLine(self, keeps_room=False))
        self.export = PlotExport(controller, self.board, background, self)
        self._lay_out()
        self.quantities.wanted.connect(lambda keys: self.board.take(keys, None, self.board.chosen))
        self.board.refused.connect(self._on_refused)
        self.board.menu_wanted.connect(self._open_menu)
        self.bar.save.wanted.connect(self._on_save)
        self.export.message_changed.connect(self.show_message)
        # only within this area: elsewhere in the window the same key undoes edits
        listen_for("plots.undo", self, self.bar.undo.click)

    def _lay_out(self) -> None:
        # nested at once: Qt styles a widget and its children again when its parent changes
        right = in_column(spacing=6)
        in_row(self.quantities, (right, 1), on=self, spacing=12, margins=0)
        fill(right, self.bar, (self.board, 1), self.cursor_table, self.message)

    # Menus ------------------------------------------------------------------------------------

    def _open_menu(self, place: int, key: str | None, at: QPoint) -> None:
        menu = named("plot_menu", QMenu(self))
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        if key is not None:
            menu.addAction(self.tr("Remove curve"), lambda: self.board.remove(place, key))
            menu.addAction(
                self.tr("Move to its own plot"), lambda: self.board.take([key], place, None)
            )
            menu.addSeparator()
        menu.addAction(self.tr("Fit the height"), lambda: self.board.show_all_heights(place))
        if self.board.frame.can_undo:
            menu.addAction(self.tr("Undo zoom"), self.board.undo)
        menu.addAction(self.tr("Remove plot"), lambda: self.board.remove(place, None))
        menu.popup(at)

    def _on_refused(self, what: str) -> None:
        if what == "plots":
            text = self.tr("There are {count} plots already: remove one first.")
            count = MOST_PLOTS
        else:
            text = self.tr("A plot takes {count} curves at most, so that they can be told apart.")
            count = MOST_CURVES
        self.show_message(text.format(count=count), Level.WARNING)

    def show_message(self, text: str, level: Level) -> None:
        """Show a message to the operator."""
        self.message.show_message(text, level)

    def _on_save(self, what: str) -> None:
        if what == "copy_picture":
            self.export.copy_picture()
        elif what == "copy_values":
            if not self.board.has_cursors:
                self.board.show_cursors(wanted=True)
            self.export.copy_text(self.cursor_table.text())
        else:
            self.export.save(what)


class PlotPage(Page):
    """Plots one below the other, beside a list of everything that can be drawn.

    Args:
        controller: Gives the series.
        background: Reads and writes files.
        settings: The file of the operator's settings, beside which the plots are stored.

    Attributes:
        board: The plots.
    """

    commands = (
        Command("plots.pause", Text("PlotBar", "Pause")),
        Command("plots.undo"),
        Command("plots.cursors", Text("PlotBar", "Cursors")),
        Command("plots.save", Text("SaveButton", "Save")),
        *(Command(f"plots.{kind}", Text("PlotBar", source)) for kind, source in SAVES.items()),
    )
    layout_read = Signal()

    def __init__(self, controller: ArmController, background: Background, settings: Path) -> None:
        super().__init__("plots")
        self.setObjectName("plot_page")
        self._background = background
        self._file = layout_file.path_beside(settings)
        self._known = False
        telemetry = controller.telemetry
        self.area = PlotsArea(telemetry, controller, background, self)
        self.board, self.bar = self.area.board, self.area.bar
        self.quantities, self.cursor_table = self.area.quantities, self.area.cursor_table
        self.export = self.area.export
        self.body.addWidget(self.area, 1)
        self._keep_timer = QTimer(self, singleShot=True, interval=_KEEP_AFTER_MS)
        self._keep_timer.timeout.connect(self._keep)
        self.board.plots_changed.connect(self._on_changed)
        self.board.frame_changed.connect(self._on_changed)
        self.retranslate_ui()
        self._read()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            "plots.pause": self.bar.pause,
            "plots.undo": self.bar.undo,
            "plots.cursors": self.bar.cursors,
            **self.bar.save.targets("plots"),
        }

    # Requests from other parts ----------------------------------------------------------------

    def add_curves(self, keys: Sequence[str]) -> None:
        """Show quantities in their present plot, or in a new one."""
        if not self._known:
            self.layout_read.connect(
                lambda: self.add_curves(keys), Qt.ConnectionType.SingleShotConnection
            )
            return
        layout = self.board.plot_layout
        missing = [key for key in keys if layout.find(key) is None]
        if missing:
            self.board.take(missing, None, None)
        place = layout.find(keys[0]) if keys else None
        if place is not None:
            self.board.reveal(place)

    def show_moment(self, at_s: float) -> None:
        """Show a monotonic time, and move the first cursor there."""
        if self._known:
            self.board.show_moment(at_s)
            return
        self.layout_read.connect(
            lambda: self.board.show_moment(at_s), Qt.ConnectionType.SingleShotConnection
        )

    # The layout -------------------------------------------------------------------------------

    def _read(self) -> None:
        self._background.begin_here(Job(self._on_read), layout_file.read_text, self._file)

    def _on_read(self, text: str | Refusal) -> None:
        kept = from_text(text) if isinstance(text, str) else None
        if kept is not None:
            plots, span_s = kept
            self.board.show_plots(plots)
            self.board.set_span(span_s)
            self.board.frame.forget_plots()
            self.bar.refresh()
        self._known = True
        self._keep_timer.stop()
        self.layout_read.emit()

    def _on_changed(self) -> None:
        if self._known:
            self._keep_timer.start()

    def _keep(self) -> None:
        frame = self.board.frame
        text = to_text(self.board.plot_layout.plots, frame.shown.span_s)
        job = Job(self._on_kept)
        self._background.begin_here(job, layout_file.write_text, self._file, text)

    def _on_kept(self, result: Refusal | None) -> None:
        if isinstance(result, Refusal):
            text = self.tr("The layout of the plots could not be saved: {text}")
            self.area.show_message(text.format_map(result.params), Level.WARNING)

    def hideEvent(self, event: QHideEvent) -> None:
        """Store the layout now."""
        super().hideEvent(event)
        if self._keep_timer.isActive():
            self._keep_timer.stop()
            self._keep()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Curves"))
