"""The controls of the bus page: view, pause, clear, filter."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QButtonGroup, QLineEdit, QToolButton, QWidget

from armui.telemetry.bus_senders import Sender
from armui.ui.actions.act import Act, HasActs, check_box, toggle_button
from armui.ui.watch.bus.frame_filter import FrameFilter, IdFilter, parse_ids
from armui.ui.widgets.buttons import drop_down, fold_into, named
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.painting import repolish
from armui.ui.widgets.translated import Translated
from armui.ui.words import frames

_IDS_PX: Final = 140
_TEXT_PX: Final = 140
_BOLDER: Final = 1.15
"""The width of a bold text relative to a normal one."""


class FilterBar(HasActs, Translated, QWidget):
    """Controls in a row; a menu button holds the filters that are rarely used.

    Args:
        now_s: Returns the present time by the frames' clock.

    Signals:
        changed: The filter has changed.
        trace_wanted: True for the view in order of time, false for the one by identifier.
        pause_wanted: True to pause the figures, false to continue.
        clear_wanted: Counting shall start again.
    """

    changed = Signal()
    trace_wanted = Signal(bool)
    pause_wanted = Signal(bool)
    clear_wanted = Signal()
    by_id = Act("By ID", named="bus_by_id", key="bus.by_id", kind=toggle_button)
    in_order = Act("By time", named="bus_in_order", key="bus.in_order", kind=toggle_button)
    pause = Act(
        "Pause",
        named="bus_pause",
        tip="Freezes the figures; frames that come meanwhile are still counted",
        key="bus.pause",
        kind=toggle_button,
    )
    clear = Act("Clear", named="bus_clear", tip="Starts counting from zero", key="bus.clear")
    only_changed = Act(
        "Only changed",
        named="bus_only_changed",
        tip="Frames of which a byte has changed since this was ticked",
        key="bus.only_changed",
        kind=check_box,
    )
    only_unknown = Act(
        "Only unknown",
        named="bus_only_unknown",
        tip="Frames that are not known, or not as they should be",
        key="bus.only_unknown",
        kind=check_box,
    )

    def __init__(self, now_s: Callable[[], float]) -> None:
        super().__init__()
        self._now_s = now_s
        self._ids = IdFilter()
        self._changed_since_s: float | None = None
        views = QButtonGroup(self)
        for button in (self.by_id, self.in_order):
            views.addButton(button)
        self.by_id.setChecked(True)
        self.text = named("bus_text", QLineEdit(clearButtonEnabled=True))
        self.text.setMinimumWidth(_TEXT_PX)
        self.ids = named("bus_ids", QLineEdit(clearButtonEnabled=True))
        self.ids.setFixedWidth(_IDS_PX)
        self.senders = drop_down("bus_senders")
        self.more = named("bus_filter", QToolButton())
        fold_into(self.more, self.ids, self.senders, self.only_changed, self.only_unknown)
        parts = (self.by_id, self.in_order, (self.text, 1), self.more, self.pause, self.clear)
        in_row(*parts, on=self, spacing=6, margins=0)
        self.changed.connect(self._show_narrowed)
        self.pause.toggled.connect(self.pause_wanted)
        self.text.textChanged.connect(self.changed)
        self.ids.textChanged.connect(self._on_ids)
        self.senders.currentIndexChanged.connect(self.changed)
        self.retranslate_ui()

    @property
    def wanted(self) -> FrameFilter:
        """The filter as set by the controls."""
        return FrameFilter(
            text=self.text.text().strip(),
            ids=self._ids,
            sender=self._sender,
            only_unknown=self.only_unknown.isChecked(),
            changed_since_s=self._changed_since_s,
        )

    @property
    def _sender(self) -> Sender | None:
        place = self.senders.currentIndex()
        return tuple(Sender)[place - 1] if place > 0 else None

    def _on_ids(self, text: str) -> None:
        found = parse_ids(text)
        bad = found if isinstance(found, str) else ""
        self.ids.setProperty("attention", bool(bad))
        repolish(self.ids)
        self._tip_ids(bad)
        if isinstance(found, IdFilter):
            self._ids = found
            self.changed.emit()

    def _tip_ids(self, bad: str) -> None:
        use = self.tr("Identifiers in hexadecimal: 2A1, 2A1-2A8, or value/mask as in 150/7F0")
        wrong = self.tr("“{value}” is not an identifier; the filter is unchanged.")
        self.ids.setToolTip(f"{wrong.format(value=bad)} {use}" if bad else use)

    @by_id.pressed
    @in_order.pressed
    def _on_view(self) -> None:
        self.trace_wanted.emit(self.in_order.isChecked())

    @only_changed.pressed
    def _on_only_changed(self) -> None:
        self._changed_since_s = self._now_s() if self.only_changed.isChecked() else None
        self.changed.emit()

    @only_unknown.pressed
    def _on_only_unknown(self) -> None:
        self.changed.emit()

    @clear.pressed
    def _on_clear(self) -> None:
        if self.only_changed.isChecked():
            self._changed_since_s = self._now_s()
        self.clear_wanted.emit()

    def _show_narrowed(self) -> None:
        """Say on the button how many of its filters leave something out."""
        boxes = (self.only_changed, self.only_unknown)
        chosen = (self.ids.text(), self._sender, *(each.isChecked() for each in boxes))
        count = sum(map(bool, chosen))
        text = self.tr("Filter")
        self.more.setText(f"{text} ({count})" if count else text)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.show_acts()
        # the chosen one is bold, and must not move the others
        for button in (self.by_id, self.in_order):
            button.setMinimumWidth(round(_BOLDER * button.sizeHint().width()))
        self.text.setPlaceholderText(self.tr("Name or identifier"))
        self.text.setAccessibleName(self.text.placeholderText())
        self.ids.setPlaceholderText("2A1-2A8, 150/7F0")
        self.ids.setAccessibleName(self.tr("Identifiers"))
        self._tip_ids("")
        chosen = max(0, self.senders.currentIndex())
        with QSignalBlocker(self.senders):  # filling the list again must not change the filter
            self.senders.clear()
            self.senders.addItem(self.tr("All senders"))
            self.senders.addItems([frames.frame_sender(sender) for sender in Sender])
            self.senders.setCurrentIndex(chosen)
        self.senders.setAccessibleName(self.tr("Sender"))
        self._show_narrowed()
