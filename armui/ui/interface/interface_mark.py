"""The marks in the status bar that the interface or the live stream is on, or cannot be."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QToolButton

from armui.ui import words
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import MARK_ICON_PX, show_as_mark
from armui.ui.widgets.painting import set_rank
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.interface.interface import Interface
    from armui.interface.interface_view import InterfaceView
    from armui.live.live_stream import LiveStream
    from armui.live.messages import LiveView


class ServedMark(Translated, QToolButton):
    """Shown while something is served to other programs; a click opens its window.

    Args:
        name: Its object name.
        open_window: Opens the window.
    """

    def __init__(self, name: str, open_window: Callable[[], object]) -> None:
        super().__init__()
        self.setObjectName(name)
        show_as_mark(self)
        self.clicked.connect(lambda _checked: open_window())

    def _recolor(self) -> None:
        self.retranslate_ui()

    def _show_text(self, text: str, tip: str, *, warns: bool) -> None:
        self.setText(text)
        self.setToolTip(tip)
        self.setAccessibleName(text)
        colors = colors_of(self)
        name, ink = ("warning", colors.warn) if warns else ("linkage", colors.muted)
        self.setIcon(icons.icon(name, ink, MARK_ICON_PX))
        set_rank(self, "warning" if warns else "muted")


class InterfaceMark(ServedMark):
    """Shown while the interface is on, with the number of programs.

    Args:
        interface: The interface.
        open_window: Opens its window.
    """

    def __init__(self, interface: Interface, open_window: Callable[[], object]) -> None:
        super().__init__("interface_mark", open_window)
        self._interface = interface
        interface.changed.connect(self._show)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._show(self._interface.view)

    def _show(self, view: InterfaceView) -> None:
        problem = view.problem
        self.setVisible(view.on or problem is not None)
        if problem is None:
            text = self.tr("Interface: {count}").format(count=len(view.clients))
            tip = self.tr("The local interface is on; so many programs are connected.")
        else:
            text, tip = self.tr("Interface not served"), words.refusal(problem)
        self._show_text(text, tip, warns=problem is not None)


class LiveMark(ServedMark):
    """Shown while the live stream is on, with its address.

    Args:
        live: The stream.
        open_window: Opens the window with its switch.
    """

    def __init__(self, live: LiveStream, open_window: Callable[[], object]) -> None:
        super().__init__("live_mark", open_window)
        self._live = live
        live.changed.connect(self._show)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._show(self._live.view)

    def _show(self, view: LiveView) -> None:
        state = view.state
        self.setVisible(state.on or state.problem is not None)
        if state.problem is not None:
            text, tip = self.tr("Live stream not served"), words.refusal(state.problem)
        else:
            text = self.tr("Live, open to the network: {address}") if view.for_others else ""
            text = (text or self.tr("Live: {address}")).format(address=view.address)
            tip = self.tr("A program watches.") if state.watched else self.tr("Nobody watches.")
            if view.lost or state.behind:
                tip += "\n" + self.tr(
                    "Frames dropped, as they were not sent in time: {lost}. How often a program "
                    "was seen not to keep up, and missed messages: {behind}."
                ).format(lost=view.lost, behind=state.behind)
        self._show_text(text, tip, warns=state.problem is not None or view.for_others)
