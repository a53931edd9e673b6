"""Above the events: what is searched for, how grave, of whom, of which sort."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Signal
from PySide6.QtGui import QFont, QFontMetrics
from PySide6.QtWidgets import (
    QComboBox,
    QLineEdit,
    QWidget,
)

from armui.telemetry.events import Asker, EventKind, Level
from armui.ui.watch.events.event_filter import EventFilter
from armui.ui.watch.save_button import SaveButton
from armui.ui.widgets.buttons import bar_button, named
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words import event_log as words
from armui.ui.words.text import Texts

_LEVELS: Final = (Level.INFO, Level.WARNING, Level.FAULT)
_TOGGLE_PAD_PX: Final = 32
SAVES: Final = Texts("EventBar") | {
    "csv": "Shown events as CSV…",
    "json": "Shown events as JSON…",
    "txt": "Shown events as text…",
    "copy": "Copy shown events",
}


class EventBar(Translated, QWidget):
    """Says what is wanted.

    Signals:
        filter_changed: An `EventFilter`.
        follow_changed: Whether the newest event is to stay in sight.
        save_wanted: One of `SAVES`.
    """

    filter_changed = Signal(object)
    follow_changed = Signal(bool)
    save_wanted = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.search = named("event_search", QLineEdit())
        self.search.setClearButtonEnabled(True)
        self.levels = named("event_levels", QComboBox())
        self.askers = named("event_askers", QComboBox())
        self.follow = bar_button("event_follow", toggles=True)
        self.follow.setChecked(True)
        self.kinds = {kind: bar_button(f"event_kind_{kind}", toggles=True) for kind in EventKind}
        self.count = text_label("event_count", rank="muted")
        self.save = SaveButton("event", SAVES)
        self.save.wanted.connect(self.save_wanted)
        self.saves = self.save.saves
        self._lay_out()
        for button in self.kinds.values():
            button.setChecked(True)
            button.toggled.connect(self._tell)
        self.search.textChanged.connect(self._tell)
        self.levels.activated.connect(self._tell)
        self.askers.activated.connect(self._tell)
        self.follow.toggled.connect(self.follow_changed)
        self._quiet = False
        self.retranslate_ui()

    def _lay_out(self) -> None:
        first = in_row((self.search, 1), spacing=8)
        for widget in (self.levels, self.askers, self.follow, self.save):
            first.addWidget(widget)
        second = in_row(spacing=6)
        for button in self.kinds.values():
            second.addWidget(button)
        second.addStretch(1)
        second.addWidget(self.count)
        in_column(first, second, on=self, spacing=8, margins=0)

    def _fit_toggles(self) -> None:
        """Wide enough for their names in bold, as they are when they are on."""
        for button in (self.follow, *self.kinds.values()):
            bold = QFont(button.font())
            bold.setBold(True)
            text_px = QFontMetrics(bold).horizontalAdvance(button.text())
            button.setMinimumWidth(text_px + _TOGGLE_PAD_PX)

    @property
    def wanted(self) -> EventFilter:
        """What is wanted now."""
        return EventFilter(
            kinds=frozenset(kind for kind, button in self.kinds.items() if button.isChecked()),
            who=self.askers.currentData(),
            least=self.levels.currentData() or Level.INFO,
            words=tuple(self.search.text().casefold().split()),
        )

    def show_all(self) -> None:
        """Want everything again."""
        self._quiet = True
        self.search.clear()
        self.levels.setCurrentIndex(0)
        self.askers.setCurrentIndex(0)
        for button in self.kinds.values():
            button.setChecked(True)
        self._quiet = False
        self._tell()

    def show_only(self, kind: EventKind | None = None, who: Asker | None = None) -> None:
        """Want one sort, or one asker, alone."""
        self._quiet = True
        for each, button in self.kinds.items():
            button.setChecked(kind in {None, each})
        self.askers.setCurrentIndex(max(0, self.askers.findData(who)))
        self._quiet = False
        self._tell()

    def show_count(self, shown: int, kept: int) -> None:
        """Say how many there are."""
        text = self.tr("{shown} of {kept}").format(shown=f"{shown:,}", kept=f"{kept:,}")
        if self.count.text() != text:
            self.count.setText(text)

    def _tell(self) -> None:
        if not self._quiet:
            self.filter_changed.emit(self.wanted)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        level, who = self.levels.currentIndex(), self.askers.currentIndex()
        self.search.setPlaceholderText(self.tr("Search"))
        self.search.setAccessibleName(self.tr("Search"))
        self.levels.clear()
        texts = (
            self.tr("Every level"),
            self.tr("Warnings and faults"),
            self.tr("Faults"),
        )
        for text, least in zip(texts, _LEVELS, strict=True):
            self.levels.addItem(text, least)
        self.levels.setCurrentIndex(max(0, level))
        self.levels.setAccessibleName(self.tr("Level"))
        self.askers.clear()
        self.askers.addItem(self.tr("Everybody"), None)
        for each in Asker:
            self.askers.addItem(words.asker(each), each)
        self.askers.setCurrentIndex(max(0, who))
        self.askers.setAccessibleName(self.tr("Who asked, or says it"))
        self.follow.setText(self.tr("Follow"))
        self.follow.setToolTip(self.tr("Keep the newest event in sight"))
        for kind, button in self.kinds.items():
            button.setText(words.event_kind(kind))
        self._fit_toggles()
