"""The controls of the bus page: view, pause, clear, filter."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QButtonGroup,
    QCheckBox,
    QLineEdit,
    QWidget,
)

from armui.telemetry.bus_senders import Sender
from armui.ui.actions.act import Act, HasActs
from armui.ui.actions.keys import keys_of
from armui.ui.watch.bus.frame_filter import FrameFilter, IdFilter, parse_ids
from armui.ui.widgets.buttons import bar_button, drop_down, named
from armui.ui.widgets.flow import in_flow
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.painting import repolish
from armui.ui.widgets.translated import Translated
from armui.ui.words import frames

_IDS_PX: Final = 140
_TEXT_PX: Final = 130
_BOLDER: Final = 1.15


class FilterBar(HasActs, Translated, QWidget):
    """Controls in a row, which goes on below where the window is narrow.

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
    clear = Act("Clear", named="bus_clear", tip="Starts counting from zero")

    def __init__(self, now_s: Callable[[], float]) -> None:
        super().__init__()
        self._now_s = now_s
        self._ids = IdFilter()
        self._changed_since_s: float | None = None
        self.by_id = bar_button("bus_by_id", toggles=True)
        self.in_order = bar_button("bus_in_order", toggles=True)
        self._views = QButtonGroup(self)
        self._views.addButton(self.by_id, 0)
        self._views.addButton(self.in_order, 1)
        self.by_id.setChecked(True)
        self.pause = bar_button("bus_pause", toggles=True)
        self.text = named("bus_text", QLineEdit())
        self.text.setClearButtonEnabled(True)
        self.text.setMinimumWidth(_TEXT_PX)
        self.ids = named("bus_ids", QLineEdit())
        self.ids.setClearButtonEnabled(True)
        self.ids.setFixedWidth(_IDS_PX)
        self.senders = drop_down("bus_senders")
        self.only_changed = named("bus_only_changed", QCheckBox())
        self.only_unknown = named("bus_only_unknown", QCheckBox())
        self._lay_out()
        self._views.idClicked.connect(lambda place: self.trace_wanted.emit(place == 1))
        self.pause.toggled.connect(self._on_pause)
        self.text.textChanged.connect(self.changed)
        self.ids.textChanged.connect(self._on_ids)
        self.senders.currentIndexChanged.connect(self.changed)
        self.only_changed.toggled.connect(self._on_only_changed)
        self.only_unknown.toggled.connect(self.changed)
        self.retranslate_ui()

    def _lay_out(self) -> None:
        wanted = (self.text, self.ids, self.senders, self.only_changed, self.only_unknown)
        parts = (self.by_id, self.in_order, *wanted, self.pause, self.clear)
        in_column(in_flow(*parts, spacing_px=6), on=self, margins=0)

    @property
    def wanted(self) -> FrameFilter:
        """The present filter."""
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

    def _on_only_changed(self, wanted: bool) -> None:
        self._changed_since_s = self._now_s() if wanted else None
        self.changed.emit()

    @clear.pressed
    def _on_clear(self) -> None:
        if self.only_changed.isChecked():
            self._changed_since_s = self._now_s()
        self.clear_wanted.emit()

    def _on_pause(self, wanted: bool) -> None:
        self.pause_wanted.emit(wanted)
        self._name_pause()

    def _name_pause(self) -> None:
        going = not self.pause.isChecked()
        self.pause.setText(self.tr("Pause") if going else self.tr("Live"))
        self.pause.setShortcut(QKeySequence(keys_of("bus.pause")))  # other text takes it away

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.by_id.setText(self.tr("By ID"))
        self.in_order.setText(self.tr("By time"))
        for button in (self.by_id, self.in_order):  # the chosen one is written bolder
            button.setMinimumWidth(round(_BOLDER * button.sizeHint().width()))
        self.pause.setToolTip(
            self.tr("Freezes the figures; frames that come meanwhile are still counted (Ctrl+P)")
        )
        self._name_pause()
        self.show_acts()
        self.text.setPlaceholderText(self.tr("Name or identifier"))
        self.text.setAccessibleName(self.text.placeholderText())
        self.ids.setPlaceholderText("2A1-2A8, 150/7F0")
        self.ids.setAccessibleName(self.tr("Identifiers"))
        self._tip_ids("")
        self.only_changed.setText(self.tr("Only changed"))
        self.only_changed.setToolTip(
            self.tr("Frames of which a byte has changed since this was ticked")
        )
        self.only_unknown.setText(self.tr("Only unknown"))
        self.only_unknown.setToolTip(self.tr("Frames that are not known, or not as they should be"))
        chosen = max(0, self.senders.currentIndex())
        with QSignalBlocker(self.senders):
            self.senders.clear()
            self.senders.addItem(self.tr("All senders"))
            self.senders.addItems([frames.frame_sender(sender) for sender in Sender])
            self.senders.setCurrentIndex(chosen)
        self.senders.setAccessibleName(self.tr("Sender"))
