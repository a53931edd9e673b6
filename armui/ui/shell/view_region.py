"""Region 8: the 3D picture with its three buttons at the lower right."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QPushButton, QVBoxLayout, QWidget

from armui.ui.actions.command import Command, Target, also
from armui.ui.actions.keys import keys_of
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.layouts import empty_grid, in_column, in_row
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.ui.picture.picture_work import PictureWork
    from armui.viewport.view import ArmView

_RIM_PX = 14


class ViewRegion(Translated, QWidget):
    """Lays 使用帮助, 视角还原 and 设置 over the widget that shows the arm (manual 1.0.8).

    Args:
        view: Shows the arm.
        bar: The bar below it, visible while it has something to offer.
        work: The object with the strip and the note over the picture.
    """

    commands = (
        Command(
            "window.settings", synonyms=also("preferences options configuration 选项 首选项 配置")
        ),
        Command("window.reset_view"),
        Command("view.help", Text("HelpPage", "Help: 3D view")),
    )
    help_wanted = Signal()
    reset_wanted = Signal()
    settings_wanted = Signal()

    def __init__(self, view: ArmView, bar: QWidget, work: PictureWork) -> None:
        super().__init__()
        self._view = view
        self._below = bar
        self._strip = work.bar
        self._help = QPushButton()
        self._reset = QPushButton()
        self._settings = QPushButton()
        self._buttons = {
            "help": self._help,
            "reset_view": self._reset,
            "settings": self._settings,
        }
        self._row = row = in_row(spacing=8, margins=_RIM_PX)
        for name, button in self._buttons.items():
            button.setObjectName(f"{name}_button")
            button.setAutoDefault(False)
            row.addWidget(button)
        # items in one cell of a grid overlap: so the buttons lie over a corner of the picture
        align = Qt.AlignmentFlag
        layout = empty_grid(self, margins=0)
        layout.addWidget(view, 0, 0)
        layout.addLayout(row, 0, 0, align.AlignRight | align.AlignBottom)
        layout.addLayout(_with_rim(work.bar), 0, 0, align.AlignRight | align.AlignTop)
        work.note.stand_over(self, view)
        work.bar.raise_()
        work.note.raise_()
        layout.addWidget(bar, 1, 0)
        layout.setRowStretch(0, 1)
        for button in self._buttons.values():
            button.raise_()
        self._settings.setShortcut(keys_of("window.settings"))
        self._reset.setShortcut(keys_of("window.reset_view"))
        self._help.clicked.connect(self.help_wanted)
        self._reset.clicked.connect(self.reset_wanted)
        self._settings.clicked.connect(self.settings_wanted)
        self.retranslate_ui()
        self._recolor()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            "window.settings": self._settings,
            "window.reset_view": self._reset,
            "view.help": self._help,
        }

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Report the areas covered by buttons, beside which the arm is shown."""
        super().resizeEvent(event)
        strip = self._strip.sizeHint()
        self._row.setContentsMargins(_RIM_PX, _RIM_PX, _RIM_PX, _RIM_PX)
        below_px = 0 if self._below.isHidden() else self._below.sizeHint().height()
        room_px = event.size().height() - below_px - strip.height() - _RIM_PX
        if self._row.sizeHint().height() > room_px:
            # in a low picture the buttons would cover the end of the strip
            beside_px = strip.width() + 2 * _RIM_PX
            self._row.setContentsMargins(_RIM_PX, _RIM_PX, beside_px, _RIM_PX)
        self._tell_covered()

    def _tell_covered(self) -> None:
        corner = self._row.sizeHint()
        strip_px = self._strip.sizeHint().width() + _RIM_PX
        self._view.set_covered((corner.width(), corner.height()), strip_px)

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        for button, text, tip in (
            (self._help, self.tr("Help"), self.tr("How to use the 3D view")),
            (self._reset, self.tr("Reset view"), self.tr("Restores the initial view")),
            (self._settings, self.tr("Settings"), self.tr("Language, theme, jog step, 3D model")),
        ):
            shortcut = button.shortcut()
            button.setText(text)
            button.setShortcut(shortcut)
            button.setAccessibleName(text)
            keys = shortcut.toString(shortcut.SequenceFormat.NativeText)
            button.setToolTip(f"{tip} ({keys})" if keys else tip)
        # before that, sizes are not final
        if self.testAttribute(Qt.WidgetAttribute.WA_WState_Polished):
            self._tell_covered()

    def _recolor(self) -> None:
        for name, button in self._buttons.items():
            button.setIcon(icons.icon(name, colors_of(self).muted))


def _with_rim(widget: QWidget) -> QVBoxLayout:
    """Return a layout that keeps a widget away from the picture's edge."""
    return in_column(widget, margins=_RIM_PX)
