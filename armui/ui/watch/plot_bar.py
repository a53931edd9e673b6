"""The bar above the plots: sets of them, the time shown, pause, cursors, saving."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QWidget

from armui.ui.watch.plot_layout import SETS
from armui.ui.watch.save_button import SaveButton
from armui.ui.watch.time_frame import SPANS_S
from armui.ui.widgets.buttons import bar_button, drop_down
from armui.ui.widgets.flow import in_flow
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Texts

if TYPE_CHECKING:
    from armui.ui.watch.plot_board import PlotBoard

_SETS: Final = Texts("PlotBar") | {
    "follow": "Target vs measured",
    "hot": "Temperatures and currents",
    "stop": "Why it stopped",
    "tool": "Tool pose",
    "bus": "Bus health",
}
SAVES: Final = Texts("PlotBar") | {
    "csv": "Values as CSV…",
    "png": "Picture as PNG…",
    "svg": "Picture as SVG…",
    "copy_picture": "Copy picture",
    "copy_values": "Copy values at the cursors",
}


class PlotBar(Translated, QWidget):
    """Controls a board, and shows its state.

    Args:
        board: The board.

    Attributes:
        save: The button that saves as one of `SAVES`.
    """

    def __init__(self, board: PlotBoard, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._board = board
        self.sets = drop_down("plot_sets")
        self.spans = drop_down("plot_span")
        self.pause = bar_button("plot_pause", toggles=True)
        self.undo = bar_button("plot_undo")
        self.cursors = bar_button("plot_cursors", toggles=True)
        self.save = SaveButton("plot", SAVES)
        left = (self.sets, self.spans, self.pause, self.undo, self.cursors)
        in_flow(*left, on=self, spacing_px=8).push(self.save)
        self.sets.activated.connect(self._on_set)
        self.spans.activated.connect(self._on_span)
        self.pause.clicked.connect(lambda on: board.pause(wanted=on))
        self.undo.clicked.connect(board.undo)
        self.cursors.clicked.connect(lambda on: board.show_cursors(wanted=on))
        board.plots_changed.connect(self.refresh)
        board.frame_changed.connect(self.refresh)
        board.cursors_changed.connect(self.refresh)
        self.retranslate_ui()

    def _on_set(self, _place: int) -> None:
        name = self.sets.currentData()
        if name in SETS:
            self._board.show_plots(SETS[name])

    def _on_span(self, _place: int) -> None:
        span_s = self.spans.currentData()
        if span_s is not None:
            self._board.set_span(span_s)

    def refresh(self) -> None:
        """Show the state of the board."""
        frame, name = self._board.frame, self._board.plot_layout.name
        own = self.sets.findData("")
        if name is None and own < 0:
            self.sets.addItem(self.tr("Custom layout"), "")
        elif name is not None and own >= 0:
            self.sets.removeItem(own)
        self.sets.setCurrentIndex(self.sets.findData(name or ""))
        self._show_span(frame.shown.span_s)
        self.pause.setChecked(not frame.live)
        self.undo.setEnabled(frame.can_undo)
        self.cursors.setChecked(self._board.has_cursors)

    def _show_span(self, span_s: float) -> None:
        """Select the length of time; one made by zooming becomes an entry of its own."""
        place = next(
            (at for at, each in enumerate(SPANS_S) if abs(each - span_s) < each * 1e-6), None
        )
        if self.spans.count() > len(SPANS_S):
            self.spans.removeItem(len(SPANS_S))
        if place is None:
            self.spans.addItem(_span_text(span_s), None)
            place = len(SPANS_S)
        self.spans.setCurrentIndex(place)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.sets.clear()
        for name in SETS:
            self.sets.addItem(_SETS.text(name), name)
        self.sets.setToolTip(self.tr("Sets of plots, ready made"))
        self.sets.setAccessibleName(self.sets.toolTip())
        self.spans.clear()
        for span_s in SPANS_S:
            self.spans.addItem(_span_text(span_s), span_s)
        self.spans.setToolTip(self.tr("The time span shown; the mouse wheel changes it, too"))
        self.spans.setAccessibleName(self.tr("Time shown"))
        self.pause.setText(self.tr("Pause"))
        self.undo.setText(self.tr("Undo zoom"))
        self.undo.setToolTip(self.tr("Drag a box in a plot to zoom in. Back: Ctrl+Z"))
        self.cursors.setText(self.tr("Cursors"))
        self.cursors.setToolTip(
            self.tr("Two vertical lines to drag; the table below shows the values there")
        )
        self.refresh()


def _span_text(span_s: float) -> str:
    if span_s >= 60.0:
        minutes = span_s / 60.0
        text = QCoreApplication.translate("PlotBar", "{count} min")
        return text.format(count=f"{minutes:.3g}")
    return QCoreApplication.translate("PlotBar", "{count} s").format(count=f"{span_s:.3g}")
