"""Shows one section of the guide, with its pictures as wide as the text leaves room for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

from PySide6.QtCore import QSizeF, Qt, QTimer, QUrl, Signal
from PySide6.QtGui import QColor, QImage, QResizeEvent, QTextCursor
from PySide6.QtWidgets import QTextBrowser, QTextEdit

from armui.arm.refusal import Refusal
from armui.system.files import read_file
from armui.ui.background import Background, Job
from armui.ui.guide.text import FOLDER, GuideSection
from armui.ui.theme import colors_of

_SIDE_PX: Final = 48
_SETTLED_MS: Final = 150
_NOTHING: Final = QImage()


class GuideBrowser(QTextBrowser):
    """Shows a section; pictures are read in another thread, and appear when they have come.

    Args:
        background: Reads pictures.

    Signals:
        section_wanted: A link to another section was clicked, with the section's name.
    """

    section_wanted = Signal(str)

    def __init__(self, background: Background) -> None:
        super().__init__()
        self._background = background
        self._section: GuideSection | None = None
        self._words: tuple[str, ...] = ()
        self._pictures: dict[str, QImage] = {}
        self._fitted: dict[str, QImage] = {}
        self._job: Job[dict[str, bytes]] | None = None
        self.setOpenLinks(False)
        # Tab leaves the text and skips its links: the list of contents leads to the same sections
        flags = self.textInteractionFlags()
        self.setTextInteractionFlags(flags & ~Qt.TextInteractionFlag.LinksAccessibleByKeyboard)
        self.anchorClicked.connect(self._on_link)
        self._resized = QTimer(self, interval=_SETTLED_MS, singleShot=True)
        self._resized.timeout.connect(lambda: self._show(keep_place=True))

    @property
    def section(self) -> GuideSection | None:
        """The section shown."""
        return self._section

    def picture_width(self, name: str) -> float:
        """Return the width at which a picture is shown, in pixels; 0 if it is not shown."""
        picture = self._fitted.get(name)
        return 0.0 if picture is None else picture.deviceIndependentSize().width()

    def show_section(self, section: GuideSection, words: tuple[str, ...] = ()) -> None:
        """Show a section, with these words marked."""
        self._section, self._words = section, words
        self._show(keep_place=False)
        missing = [name for name in section.pictures if name not in self._pictures]
        if missing:
            if self._job is not None:
                self._job.wanted = False
            self._job = Job(self._take_pictures)
            self._background.begin_here(self._job, read_pictures, FOLDER, missing)

    def _take_pictures(self, read: Mapping[str, bytes] | Refusal) -> None:
        if isinstance(read, Refusal):
            return
        for name, data in read.items():
            picture = QImage.fromData(data)
            if not picture.isNull():
                self._pictures[name] = picture
        self._show(keep_place=True)

    def _show(self, *, keep_place: bool) -> None:
        if self._section is None:
            return
        at = self.verticalScrollBar().value() if keep_place else 0
        self._fitted = {
            name: self._fit(picture)
            for name, picture in self._pictures.items()
            if name in self._section.pictures
        }
        self.setMarkdown(self._section.text)
        self._mark_words()
        self.verticalScrollBar().setValue(at)

    def _fit(self, picture: QImage) -> QImage:
        """Return a picture no wider nor higher than the page, sharp on its screen."""
        ratio = self.devicePixelRatioF()
        page = self.viewport().size()
        room = QSizeF(page.width() - _SIDE_PX, page.height())
        size = QSizeF(picture.size()).scaled(room * ratio, Qt.AspectRatioMode.KeepAspectRatio)
        if 0 < size.width() < picture.width():
            smooth = Qt.TransformationMode.SmoothTransformation
            picture = picture.scaledToWidth(round(size.width()), smooth)
        else:
            picture = picture.copy()
        picture.setDevicePixelRatio(ratio)
        return picture

    def _mark_words(self) -> None:
        marks = []
        for word in self._words:
            cursor = QTextCursor(self.document())
            while not (cursor := self.document().find(word, cursor)).isNull():
                mark = QTextEdit.ExtraSelection()
                mark.cursor = cursor
                mark.format.setBackground(QColor(colors_of(self).warn_pale))
                marks.append(mark)
        self.setExtraSelections(marks)

    def _on_link(self, url: QUrl) -> None:
        if url.hasFragment():
            self.section_wanted.emit(url.fragment())

    def loadResource(self, _kind: int, name: QUrl | str) -> Any:  # noqa: N802 - the name Qt calls
        """Return a picture that has been read; no file is opened here."""
        return self._fitted.get(QUrl(name).toString(), _NOTHING)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the pictures to the new size once it has settled."""
        super().resizeEvent(event)
        if event.size() != event.oldSize():
            self._resized.start()


def read_pictures(folder: Path, names: Sequence[str]) -> dict[str, bytes]:
    """Return the files of those pictures that exist; not for the GUI thread."""
    found = {}
    for name in names:
        file = folder / name
        if file.is_file():
            found[name] = read_file(file)
    return found
