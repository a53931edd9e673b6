"""The page 曲线: curves of everything heard and commanded in the last half hour."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt, QTimer, Signal

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.ui.background import Job
from armui.ui.watch import layout_file
from armui.ui.watch.plot_layout import from_text, to_text
from armui.ui.watch.plots_area import PlotsArea
from armui.ui.widgets.page import Page

if TYPE_CHECKING:
    from PySide6.QtGui import QHideEvent

    from armui.control.arm_controller import ArmController
    from armui.ui.background import Background

_KEEP_AFTER_MS: Final = 1000


class PlotPage(Page):
    """Plots one below the other, beside a list of everything that can be drawn.

    Args:
        controller: Knows what was heard.
        background: Where files are read and written.
        settings: The file of the operator's settings: the plots are kept beside it.

    Attributes:
        board: The plots.
    """

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

    # What others ask for ----------------------------------------------------------------------

    def add_curves(self, keys: Sequence[str]) -> None:
        """Have quantities drawn: where they are drawn already, or in a plot of their own."""
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
        """Bring a monotonic time into sight, and put the first cursor there."""
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
            text = self.tr("The arrangement of the plots could not be kept: {text}")
            self._say(text.format_map(result.params), Level.WARNING)

    def hideEvent(self, event: QHideEvent) -> None:
        """Keep the layout now."""
        super().hideEvent(event)
        if self._keep_timer.isActive():
            self._keep_timer.stop()
            self._keep()

    def _say(self, text: str, level: Level) -> None:
        self.area.say(text, level)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.set_title(self.tr("Curves"))
