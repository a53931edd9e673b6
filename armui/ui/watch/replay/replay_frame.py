"""The frame around everything that comes from a recording: nobody takes it for live."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen
from PySide6.QtWidgets import QLabel, QWidget

from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import named
from armui.ui.widgets.elided_label import ElidedLabel
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from PySide6.QtGui import QPaintEvent

_LINE_PX: Final = 4
_BANNER_PX: Final = 38
_ICON_PX: Final = 22
_WORD_SCALE: Final = 1.2


class ReplayFrame(Translated, QWidget):
    """A thick line in a colour of its own around the content, with a banner on top.

    The banner says 回放 whatever language is chosen, that it is not live, which file it is, and
    what the clock showed then.

    Args:
        content: What comes from the recording.
        name: The file.
    """

    def __init__(self, content: QWidget, name: str) -> None:
        super().__init__()
        self.setObjectName("replay_frame")
        self._icon = QLabel()
        self.word = text_label("replay_word", plain=True)
        self.name = ElidedLabel()
        self.name.show_text(name)
        self.clock = text_label("replay_clock", plain=True)
        banner = in_row(
            self._icon,
            self.word,
            16,
            (self.name, 1),
            self.clock,
            spacing=10,
            margins=(14, 0, 14, 0),
        )
        holder = named("replay_banner", QWidget())
        holder.setFixedHeight(_BANNER_PX)
        holder.setLayout(banner)
        in_column(holder, (content, 1), on=self, spacing=0, margins=_LINE_PX)
        self.retranslate_ui()
        self._recolor()

    def retranslate_ui(self) -> None:
        """Put the words into the operator's language."""
        words = self.tr("REPLAY · NOT LIVE")
        self.word.setText(words if words.startswith("回放") else f"回放  {words}")
        self.name.setToolTip(self.tr("Nothing can be sent from here: there is no bus behind it."))

    def _recolor(self) -> None:
        ink = colors_of(self).on_replay
        ratio = self.devicePixelRatioF()
        self._icon.setPixmap(icons.pixmap("replay", ink, _ICON_PX, ratio))
        for label in (self.word, self.name, self.clock):
            label.setFont(scaled_font(self, _WORD_SCALE, bold=label is not self.name))

    def paintEvent(self, _event: QPaintEvent) -> None:
        """The line and the ground of the banner."""
        color = QColor(colors_of(self).replay)
        painter = QPainter(self)
        painter.fillRect(QRectF(0, 0, self.width(), _BANNER_PX + _LINE_PX), color)
        painter.setPen(QPen(color, _LINE_PX, j=Qt.PenJoinStyle.MiterJoin))
        half = _LINE_PX / 2
        painter.drawRect(QRectF(self.rect()).adjusted(half, half, -half, -half))
        painter.end()
