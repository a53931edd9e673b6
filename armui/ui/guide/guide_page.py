"""The page 使用帮助: contents and a search on the left, a section on the right (F1)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QApplication,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QSplitter,
    QWidget,
)

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.ui import words
from armui.ui.background import Background, Job
from armui.ui.guide.guide_browser import GuideBrowser
from armui.ui.guide.place import FIRST
from armui.ui.guide.text import GuideSection, read_guide, search
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import fill, in_column
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.page import Page

_CONTENTS_PX: Final = 250
_TEXT_PX: Final = 750
_INDENT: Final = "    "


class GuidePage(Page):
    """Shows the guide in the present language, read in another thread.

    Args:
        background: Reads files.
        read: Reads the sections of a language.
    """

    def __init__(
        self, background: Background, read: Callable[[str], list[GuideSection]] = read_guide
    ) -> None:
        super().__init__("guide")
        self.setObjectName("guide_page")
        self._background = background
        self._read = read
        self._sections: list[GuideSection] = []
        self._language = ""
        self._wanted = FIRST
        self._answered = ""
        self._job: Job[list[GuideSection]] | None = None
        self.search = named("guide_search", QLineEdit(clearButtonEnabled=True))
        self.contents = named("guide_contents", QListWidget())
        self.browser = named("guide_text", GuideBrowser(background))
        self._message = named("guide_message", MessageLine(keeps_room=False))
        left = QWidget()
        in_column(self.search, (self.contents, 1), on=left, spacing=8, margins=0)
        splitter = QSplitter(Qt.Orientation.Horizontal)
        splitter.addWidget(left)
        splitter.addWidget(self.browser)
        splitter.setStretchFactor(1, 1)
        splitter.setChildrenCollapsible(False)
        splitter.setSizes([_CONTENTS_PX, _TEXT_PX])
        fill(self.body, self._message, (splitter, 1))
        self.search.textChanged.connect(self._show_contents)
        self.contents.currentItemChanged.connect(self._on_chosen)
        self.browser.section_wanted.connect(self.show_section)
        self.first = self.search
        self.retranslate_ui()

    def show_section(self, anchor: str) -> None:
        """Open the guide at a section."""
        self._wanted = anchor
        self.search.clear()
        self._choose()

    def answer(self, anchor: str, *, reads: bool) -> None:
        """Open the guide at the section for the place where the operator is.

        Args:
            anchor: The section.
            reads: True if the operator reads the guide; the section then changes only if another
                panel or page is seen by now.
        """
        if not reads or anchor != self._answered:
            self.show_section(anchor)
        self._answered = anchor

    @property
    def has_focus_inside(self) -> bool:
        """True if the keys go to the guide."""
        focus = QApplication.focusWidget()
        return focus is not None and self.isAncestorOf(focus)

    @property
    def shown(self) -> str:
        """The name of the section shown; empty if none is."""
        section = self.browser.section
        return "" if section is None else section.anchor

    # -- reading ------------------------------------------------------------------------------

    def _load(self, language: str) -> None:
        if self._job is not None:
            self._job.wanted = False
        self._language = language
        self._job = Job(self._take)
        self._background.begin_here(self._job, self._read, language)

    def _take(self, read: list[GuideSection] | Refusal) -> None:
        if isinstance(read, Refusal):
            self._message.show_message(partial(words.refusal, read), Level.FAULT)
            return
        self._message.show_message("")
        self._sections = read
        self._show_contents()
        self._choose()

    # -- showing ------------------------------------------------------------------------------

    def _show_contents(self) -> None:
        found: Sequence[GuideSection] = search(self._sections, self.search.text())
        blocked = self.contents.blockSignals(True)  # filling the list chooses no section
        self.contents.clear()
        for section in found:
            item = QListWidgetItem(_INDENT * max(0, section.level - 2) + section.title)
            item.setData(Qt.ItemDataRole.UserRole, section)
            self.contents.addItem(item)
        self.contents.blockSignals(blocked)
        if self._sections:
            none = self.tr("No section has “{text}”.").format(text=self.search.text())
            self._message.show_message("" if found else none)
        if self.search.text().strip() and found:
            self.contents.setCurrentRow(0)

    def _choose(self) -> None:
        for row in range(self.contents.count()):
            section = self.contents.item(row).data(Qt.ItemDataRole.UserRole)
            if section.anchor == self._wanted:
                self.contents.setCurrentRow(row)
                return
        if self.contents.count():
            self.contents.setCurrentRow(0)

    def _on_chosen(self, item: QListWidgetItem | None) -> None:
        if item is not None:
            section: GuideSection = item.data(Qt.ItemDataRole.UserRole)
            if not self.search.text().strip():
                self._wanted = section.anchor
            self.browser.show_section(section, tuple(self.search.text().split()))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Help"))
        self.search.setPlaceholderText(self.tr("Search the help"))
        self.search.setAccessibleName(self.tr("Search the help"))
        self.contents.setAccessibleName(self.tr("Contents"))
        self.browser.setAccessibleName(self.tr("Text of the help"))
        # Translators: the code of the language that is shown, "zh" for Chinese
        language = "zh" if self.tr("en") == "zh" else "en"
        if language != self._language:
            self._load(language)
