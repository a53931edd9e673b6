"""Plots one below the other, beside a list of everything that can be drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QMenu, QWidget

from armui.control.events import Level
from armui.ui.actions.keys import listen_for
from armui.ui.watch.cursor_table import CursorTable
from armui.ui.watch.plot_bar import PlotBar
from armui.ui.watch.plot_board import PlotBoard
from armui.ui.watch.plot_export import PlotExport
from armui.ui.watch.plot_layout import MOST_CURVES, MOST_PLOTS
from armui.ui.watch.quantity_list import QuantityList
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.message_line import MessageLine

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.telemetry.store import Telemetry
    from armui.ui.background import Background


class PlotsArea(QWidget):
    """What the page 曲线 and a replay share.

    Args:
        telemetry: Where the curves are kept.
        controller: Whom the stop button of a file chooser tells.
        background: Where files are written.

    Attributes:
        board: The plots.
        bar: Commands them.
        quantities: Everything that can be drawn.
        cursor_table: The values at the cursors.
        export: Saves and copies what is drawn.
        message: What became of something.
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
        self.message = named("plot_message", MessageLine(self))
        self.message.hide()
        self.export = PlotExport(controller, self.board, background, self)
        self._lay_out()
        self.quantities.wanted.connect(lambda keys: self.board.take(keys, None, self.board.chosen))
        self.board.refused.connect(self._on_refused)
        self.board.menu_wanted.connect(self._open_menu)
        self.bar.save_wanted.connect(self._on_save)
        self.export.said.connect(self.say)
        # beside the plots the same key is for what is edited there
        listen_for("plots.undo", self, self.bar.undo.click)

    def _lay_out(self) -> None:
        # a widget that changes its parent is styled anew, with all that is in it
        row = in_row(self.quantities, on=self, spacing=12, margins=0)
        right = in_column(spacing=6)
        row.addLayout(right, 1)
        right.addWidget(self.bar)
        right.addWidget(self.board, 1)
        right.addWidget(self.cursor_table)
        right.addWidget(self.message)

    # Menus ------------------------------------------------------------------------------------

    def _open_menu(self, place: int, key: str | None, at: QPoint) -> None:
        menu = named("plot_menu", QMenu(self))
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        if key is not None:
            menu.addAction(self.tr("Remove curve"), lambda: self.board.remove(place, key))
            menu.addAction(
                self.tr("Into a plot of its own"), lambda: self.board.take([key], place, None)
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
            text = self.tr("A plot takes {count} curves, so that they can be told apart.")
            count = MOST_CURVES
        self.say(text.format(count=count), Level.WARNING)

    def say(self, text: str, level: Level) -> None:
        """Tell the operator something."""
        self.message.show_message(text, level)
        self.message.show()

    def _on_save(self, what: str) -> None:
        if what == "copy_picture":
            self.export.copy_picture()
        elif what == "copy_values":
            if not self.board.has_cursors:
                self.board.show_cursors(wanted=True)
            self.export.copy_text(self.cursor_table.text())
        else:
            self.export.save(what)
