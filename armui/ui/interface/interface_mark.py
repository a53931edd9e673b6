"""The mark in the status bar that the local interface is on, or cannot be."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QToolButton

from armui.ui import words
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.painting import set_rank
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.interface.interface import Interface
    from armui.interface.interface_view import InterfaceView

_ICON_PX: Final = 14


class InterfaceMark(Translated, QToolButton):
    """Shown while the interface is on, with the number of programs; a click opens its window.

    Args:
        interface: The interface.
        open_window: Opens its window.
    """

    def __init__(self, interface: Interface, open_window: Callable[[], object]) -> None:
        super().__init__()
        self._interface = interface
        self.setObjectName("interface_mark")
        self.setIconSize(QSize(_ICON_PX, _ICON_PX))
        self.setAutoRaise(True)
        self.setProperty("narrow", True)
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setFixedHeight(self.fontMetrics().height())  # the bar keeps its height
        interface.changed.connect(self._show)
        self.clicked.connect(lambda _checked: open_window())
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._show(self._interface.view)

    def _recolor(self) -> None:
        self.retranslate_ui()

    def _show(self, view: InterfaceView) -> None:
        problem = view.problem
        self.setVisible(view.on or problem is not None)
        if problem is None:
            text = self.tr("Interface: {count}").format(count=len(view.clients))
            tip = self.tr("The local interface is on; so many programs are connected.")
        else:
            text, tip = self.tr("Interface not served"), words.refusal(problem)
        self.setText(text)
        self.setToolTip(tip)
        self.setAccessibleName(text)
        colors = colors_of(self)
        name, ink = ("linkage", colors.muted) if problem is None else ("warning", colors.warn)
        self.setIcon(icons.icon(name, ink, _ICON_PX))
        set_rank(self, "muted" if problem is None else "warning")
