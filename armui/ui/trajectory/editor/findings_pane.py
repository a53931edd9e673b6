"""Lists the findings of a check: a line for each, and a click leads to its row and its place."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QRect, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QGuiApplication, QResizeEvent
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QWidget

from armui.arm.refusal import Refusal
from armui.control.cell.cell_reasons import CELL_NOT_READ
from armui.control.run.player import why_not_run
from armui.control.run.preflight import Preflight
from armui.control.run.runner import Runner
from armui.trajectory.planning.findings import Finding, Severity
from armui.ui.actions.act import Act, HasActs
from armui.ui.theme import colors_of
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.findings import finding_line
from armui.ui.words.text import joined

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState

_TALLEST_PX = 170
_PADDING_PX = 14
_SIDES_PX = 32
_UNBOUNDED_PX = 10_000
_COMES_S = 1.0
"""The time after a check in which its page scrolls to the pane whenever that is resized."""
_MOST = 100
"""The most lines: more than an operator reads or a window lays out fast; the rest is counted."""


class FindingsPane(HasActs, Translated, QWidget):
    """Shows a :class:`Preflight`; hidden while there is none.

    Findings on the way to the first point are left out once the arm stands elsewhere, unless the
    run of this check moves it.

    Args:
        controller: Knows where the arm stands.

    Signals:
        finding_wanted: The :class:`Finding` that was clicked.
        found_changed: The :class:`Preflight` with what holds of its findings where the arm stands
            now; also after the pane was closed.
        dismissed: It was closed without an answer.
        asks: Whether it asks for an answer.
        placed: It has its size, after a check was shown: its page scrolls to it again.
    """

    finding_wanted = Signal(object)
    found_changed = Signal(object)
    dismissed = Signal()
    asks = Signal(bool)
    placed = Signal()
    accept_button = Act("Run now", named="accept_warnings", primary=True)
    _close_button = Act("Close", named="findings_close")

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self._controller = controller
        self._runner = Runner(controller, self)
        self._moved = self._runs = False
        self._shown_s = float("-inf")
        self._checked: Preflight | None = None
        self._accept: Callable[[], object] | None = None
        self._title = text_label("findings_title", wraps=True)
        self._list = named("findings_list", QListWidget())
        self._list.setWordWrap(True)
        self._list.setTextElideMode(Qt.TextElideMode.ElideNone)
        self._list.setResizeMode(QListWidget.ResizeMode.Adjust)
        self._list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._list.currentItemChanged.connect(self._on_current)
        self._list.itemClicked.connect(self._on_current)
        bar = self._list.verticalScrollBar()
        for changed in (bar.valueChanged, bar.rangeChanged):
            changed.connect(self.show_acts)
        head = in_row((self._title, 1), self.accept_button, self._close_button)
        in_column(head, self._list, on=self, spacing=6, margins=0)
        self.clear()
        self.retranslate_ui()
        controller.operating_state_changed.connect(self._on_operating_state)

    def show_check(
        self, checked: Preflight, accept: Callable[[], object] | None = None
    ) -> Preflight:
        """Show the findings of a check.

        Args:
            checked: The check.
            accept: Called when the operator agrees; not possible with errors.

        Returns:
            The check with the findings that hold where the arm is now.
        """
        self._checked, self._runs, self._shown_s = checked, False, time.monotonic()
        self._accept = accept if not checked.errors else None
        self._fill()
        self.show()
        return self._found(checked)

    @property
    def is_asking(self) -> bool:
        """True while it waits for an answer."""
        return self._accept is not None

    @property
    def has_errors(self) -> bool:
        """True while the check forbids a run."""
        return self._checked is not None and bool(self._found(self._checked).errors)

    def note_run(self, *_: object) -> None:
        """Note that the run of this check has begun."""
        self._runs = True

    def withdraw_question(self) -> None:
        """Show the findings alone, without the question."""
        self._accept = None
        self._fill()

    def clear(self) -> None:
        """Close the pane, and forget the check."""
        self._checked = None
        self._list.clear()
        self._put_away()

    def _put_away(self) -> None:
        """Close the pane, and drop the question; the marks of the findings stay elsewhere."""
        self._accept = None
        self.hide()
        self.asks.emit(False)

    def _on_operating_state(self, _operating_state: OperatingState) -> None:
        self._runs = self._runs and self._runner.running
        self.show_acts()
        if self._checked is not None and self._moved != self._has_moved(self._checked):
            self._fill()
            self.found_changed.emit(self._found(self._checked))

    def _has_moved(self, checked: Preflight) -> bool:
        return not self._runs and checked.why_moved(self._controller) is not None

    def _found(self, checked: Preflight) -> Preflight:
        return checked.seen_from_elsewhere() if self._moved else checked

    def _fill(self) -> None:
        self.show_acts()
        checked = self._checked
        if checked is None:
            return
        self._list.clear()
        self._moved = self._has_moved(checked)
        findings = self._found(checked).findings
        errors = sum(one.severity is Severity.ERROR for one in findings)
        if findings:
            title = self.tr("The check found errors: {errors}, warnings: {warnings}").format(
                errors=errors, warnings=len(findings) - errors
            )
        elif checked.findings:
            title = self.tr("Check: the points were checked.")
        else:
            title = self.tr("Check: nothing found.")
        if self._moved:
            moved = self.tr("The arm has moved since: its way to the first point is not checked.")
            title = joined(title, moved)
        if (waits := checked.basis.unconfirmed) is not None:
            title = joined(title, self._why_less(waits))
        self._title.setText(title)
        for finding in findings[:_MOST]:
            self._list.addItem(self._item(finding))
        if len(findings) > _MOST:
            count = len(findings) - _MOST
            self._list.addItem(self.tr("{count} more").format(count=count))
        self._fit()
        self._list.setVisible(bool(findings))
        self.accept_button.setVisible(self._accept is not None)
        self.asks.emit(self.is_asking)

    @accept_button.text
    def _accept_text(self) -> str:
        found = self._checked is not None and self._checked.findings
        return self.tr("Accept the warnings and run") if found else self.tr("Run now")

    @accept_button.why_not
    def _why_no_run(self) -> Refusal | None:
        return why_not_run(self._controller.operating_state)

    @accept_button.lit
    def _is_read(self) -> bool:
        """Return whether the list, if there is one, is scrolled to its end."""
        bar = self._list.verticalScrollBar()
        return self._list.isHidden() or bar.value() == bar.maximum()

    def _why_less(self, waits: Refusal) -> str:
        """Return which parts of an unconfirmed cell the check took into account."""
        text = self.tr(
            "The cell “{name}” is not confirmed: its work area and what is held were counted, its "
            "tool was not. Confirm it, then check again."
        )
        if waits.reason == CELL_NOT_READ:
            text = self.tr("The cell “{name}” could not be read: nothing of it was counted.")
        return text.format(**waits.params)

    def _fit(self) -> None:
        """Set the list's height to that of its wrapped lines, up to a limit."""
        width = max(1, self._list.viewport().width() - _SIDES_PX)
        room = QRect(0, 0, width, _UNBOUNDED_PX)
        metrics, wrap = self._list.fontMetrics(), int(Qt.TextFlag.TextWordWrap)
        height = 2 * self._list.frameWidth() + 4
        for place in range(self._list.count()):
            item = self._list.item(place)
            lines_px = metrics.boundingRect(room, wrap, item.text()).height() + _PADDING_PX
            item.setSizeHint(QSize(1, lines_px))
            height += lines_px
        self._list.setFixedHeight(min(_TALLEST_PX, height))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the height, because lines wrap differently in another width."""
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            QTimer.singleShot(0, self, self._fit)  # the list gets its new width after this event
        # later it would disturb other work; with a button down the pressed widget would move away
        if time.monotonic() - self._shown_s < _COMES_S and not QGuiApplication.mouseButtons():
            self.placed.emit()

    def _item(self, finding: Finding) -> QListWidgetItem:
        error = finding.severity is Severity.ERROR
        item = QListWidgetItem(finding_line(finding))
        item.setData(Qt.ItemDataRole.UserRole, finding)
        colors = colors_of(self)
        item.setForeground(QColor(colors.stop_ink if error else colors.warn))
        return item

    def _on_current(self, item: QListWidgetItem | None, *_: object) -> None:
        finding = None if item is None else item.data(Qt.ItemDataRole.UserRole)
        if finding is not None:
            self.finding_wanted.emit(finding)

    @accept_button.pressed
    def _on_accepted(self) -> None:
        accept = self._accept
        self._put_away()
        if accept is not None:
            accept()

    @_close_button.pressed
    def dismiss(self) -> None:
        """Close the pane without an answer."""
        self._put_away()
        self.dismissed.emit()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._fill()

    def _recolor(self) -> None:
        self._fill()
