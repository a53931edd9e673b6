"""The bar above the plots: sets of them, the time shown, pause, cursors, saving."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtWidgets import QWidget

from armui.ui.actions.act import Act, HasActs, toggle_button
from armui.ui.actions.command import Target
from armui.ui.watch.plot_layout import SETS
from armui.ui.watch.save_button import SaveButton, save_commands
from armui.ui.watch.time_frame import SPANS_S
from armui.ui.widgets.buttons import drop_down
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


class PlotBar(HasActs, Translated, QWidget):
    """Controls a board, and shows its state.

    Args:
        board: The board.

    Signals:
        save_wanted: One of `SAVES`.
    """

    save_wanted = Signal(str)
    commands = save_commands("plots", SAVES)
    pause = Act("Pause", named="plot_pause", key="plots.pause", kind=toggle_button)
    # beside the plots its key is for what is edited there, so it is no key of the button
    undo = Act("Undo zoom", named="plot_undo", key="plots.undo", shortcut="")
    cursors = Act(
        "Cursors",
        named="plot_cursors",
        tip="Two vertical lines to drag; the table below shows the values there",
        key="plots.cursors",
        kind=toggle_button,
    )

    def __init__(self, board: PlotBoard, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._board = board
        self.sets = drop_down("plot_sets")
        self.spans = drop_down("plot_span")
        self.save = SaveButton("plot", SAVES)
        self.save.wanted.connect(self.save_wanted)
        self.saves = self.save.saves
        left = (self.sets, self.spans, self.pause, self.undo, self.cursors)
        in_flow(*left, on=self, spacing_px=8).push(self.save)
        self.sets.activated.connect(self._on_set)
        self.spans.activated.connect(self._on_span)
        board.plots_changed.connect(self.refresh)
        board.frame_changed.connect(self.refresh)
        board.cursors_changed.connect(self.refresh)
        self.retranslate_ui()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {**super().command_targets(), **self.save.command_targets("plots")}

    @pause.pressed
    def _on_pause(self) -> None:
        self._board.pause(wanted=self.pause.isChecked())

    @pause.text
    def _pause_text(self) -> str:
        return self.tr("Pause") if self._board.frame.live else self.tr("Live")

    @undo.pressed
    def _on_undo(self) -> None:
        self._board.undo()

    @undo.why_not
    def _why_not_undo(self) -> str:
        return "" if self._board.frame.can_undo else self._what_undoes()

    @undo.tip
    def _what_undoes(self) -> str:
        return self.tr("Drag a box in a plot to zoom in. Back: Ctrl+Z")

    @cursors.pressed
    def _on_cursors(self) -> None:
        self._board.show_cursors(wanted=self.cursors.isChecked())

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
        self.cursors.setChecked(self._board.has_cursors)
        self.show_acts()

    def _show_span(self, span_s: float) -> None:
        """One of the choices, or what the mouse has made of it."""
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
        self.refresh()


def _span_text(span_s: float) -> str:
    if span_s >= 60.0:
        minutes = span_s / 60.0
        text = QCoreApplication.translate("PlotBar", "{count} min")
        return text.format(count=f"{minutes:.3g}")
    return QCoreApplication.translate("PlotBar", "{count} s").format(count=f"{span_s:.3g}")
