"""The window 导出: a recorded log as MCAP, CSV or Parquet."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Protocol

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QWidget

from armui.control.events import Level
from armui.export.process import ExportDone, ExportProcess
from armui.session.exports.request import ExportProblem, ExportProgress, ExportRequest
from armui.ui.dialogs.base import ArmDialog
from armui.ui.dialogs.confirm import confirm
from armui.ui.watch import export_text
from armui.ui.watch.export_form import ExportForm
from armui.ui.widgets.buttons import named, push_button
from armui.ui.widgets.enable_or_explain import enable_or_explain
from armui.ui.widgets.layouts import STRETCH, fill
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.progress import quiet_progress
from armui.ui.widgets.text_label import text_label

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

_SIZE_PX: Final = (780, 560)
_STEPS: Final = 1000


class RunningExport(Protocol):
    """An export under way."""

    def end(self) -> None:
        """End it; nothing remains of it."""


BeginExport = Callable[
    [ExportRequest, Callable[[ExportProgress | ExportDone], object]], RunningExport
]
"""Begins an export; see :class:`armui.export.process.ExportProcess`."""


class ExportDialog(ArmDialog):
    """Takes a log, a format, a stretch of time and a target.

    The export runs in a process of its own; the window goes on. Closing the dialog cancels it.

    Args:
        controller: Whom the emergency stop tells.
        parent: The main window.
        begin: Begins an export.
    """

    _told = Signal(int, object)

    def __init__(
        self,
        controller: ArmController,
        parent: QWidget | None = None,
        begin: BeginExport = ExportProcess,
    ) -> None:
        super().__init__(controller, parent)
        self._controller = controller
        self._begin = begin
        self._under_way: RunningExport | None = None
        self._request: ExportRequest | None = None
        self._number = 0
        self._progress = ExportProgress(None, 0)
        self._done: ExportDone | None = None
        self._cancelled = False
        self._build()
        self.form.changed.connect(self._on_changed)
        self.export_button.clicked.connect(self._on_export)
        self.close_button.clicked.connect(self._on_close)
        # queued, for an answer comes in another thread
        self._told.connect(self._on_told, Qt.ConnectionType.QueuedConnection)
        self.resize(*_SIZE_PX)
        self.retranslate_ui()

    # Layout -----------------------------------------------------------------------------------

    def _build(self) -> None:
        self.form = ExportForm(self._controller)
        self._message = named("export_message", MessageLine())
        self._remarks = text_label("export_remarks", rank="muted", wraps=True, plain=True)
        self.progress = quiet_progress()
        fill(self.body, self.form, STRETCH, self._message, self._remarks, self.progress)
        self.export_button = push_button("export_button", primary=True, on_enter=False)
        self.close_button = push_button(on_enter=False)
        fill(self.footer, STRETCH, self.export_button, self.close_button)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.set_title(self.tr("Export a recording"))
        self.export_button.setText(self.tr("Export"))
        self._refresh()

    # What the operator does -------------------------------------------------------------------

    def open(self) -> None:
        """Show the dialog; what is chosen first is the recording."""
        super().open()
        self.form.log_button.setFocus()

    def show_log(self, path: Path) -> None:
        """Offer a recording to be exported; what is under way goes on."""
        if self._under_way is None:
            self.form.show_log(path)

    def _on_changed(self) -> None:
        if self._under_way is None:
            self._done, self._cancelled = None, False
            self._refresh()

    def _on_export(self) -> None:
        request = self.form.request()
        if request is not None and self._under_way is None:
            self._run(request)

    def _run(self, request: ExportRequest) -> None:
        self._end()
        number = self._number
        self._request = request
        self._done, self._cancelled = None, False
        self._progress = ExportProgress(None, 0)
        self._under_way = self._begin(request, lambda said: self._told.emit(number, said))
        self._refresh()

    def _on_close(self) -> None:
        if self._under_way is None:
            self.close()
        else:
            self._cancel()

    def _cancel(self) -> None:
        self._end()
        self._cancelled = True
        self._refresh()

    def _ask_to_replace(self, request: ExportRequest) -> None:
        text = self.tr("{target} is there already. It will be replaced when the export is whole.")
        confirm(
            self,
            self._controller,
            title=self.tr("Replace the file?"),
            text=text.format(target=request.target),
            action_label=self.tr("Replace"),
            on_confirmed=partial(self._run, replace(request, replace=True)),
            concerns_arm=False,
        )

    # What comes back --------------------------------------------------------------------------

    def _on_told(self, number: int, said: Any) -> None:
        if number != self._number:
            return
        if isinstance(said, ExportProgress):
            self._progress = said
            self._refresh_progress()
            return
        self._under_way = None
        self._done = said
        self._refresh()
        if said.problem is ExportProblem.EXISTS and self._request is not None:
            self._ask_to_replace(self._request)

    def _refresh(self) -> None:
        running = self._under_way is not None
        reason = self.tr("An export is under way.") if running else self.form.reason()
        enable_or_explain(self.export_button, reason)
        self.form.setEnabled(not running)
        self.close_button.setText(self.tr("Cancel the export") if running else self.tr("Close"))
        self.progress.setVisible(running)
        self._refresh_message()
        self._refresh_progress()

    def _refresh_message(self) -> None:
        done, request = self._done, self._request
        remarks: list[str] = []
        if self._cancelled:
            text = self.tr("The export was cancelled; nothing was written.")
            self._message.show_message(text, Level.WARNING)
        elif done is None or request is None:
            reason = self.form.reason() if self.form.has_log() else ""
            self._message.show_message(reason, Level.WARNING if reason else Level.INFO)
        elif done.report is None:
            self._message.show_message(export_text.problem(done, request.target), Level.FAULT)
        else:
            text = export_text.finished(done.report, request.format, request.target)
            level = Level.WARNING if done.report["damage_count"] else Level.DONE
            self._message.show_message(text, level)
            remarks = export_text.remarks(done.report)
        self._remarks.setText("\n".join(remarks))

    def _refresh_progress(self) -> None:
        if self._under_way is None:
            return
        done = self._progress.done
        self.progress.setRange(0, 0 if done is None else _STEPS)
        if done is not None:
            self.progress.setValue(round(done * _STEPS))
        text = self.tr("Exporting… {frames:,} frames read")
        self._message.show_message(text.format(frames=self._progress.frames))

    # The end ----------------------------------------------------------------------------------

    def closeEvent(self, event: QCloseEvent) -> None:
        """What is under way is cancelled."""
        if self._under_way is not None:
            self._cancel()
        super().closeEvent(event)

    def reject(self) -> None:
        """Escape does the same."""
        if self._under_way is not None:
            self._cancel()
        super().reject()

    def _end(self) -> None:
        """Nobody waits any more for what is under way."""
        self._number += 1
        if self._under_way is not None:
            self._under_way.end()
            self._under_way = None
