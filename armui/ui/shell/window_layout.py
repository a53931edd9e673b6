"""The main window as it was when the program ended, as far as the screens of today allow."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, QObject, QSize, Qt

from armui.ui.dialogs.placing import on_screen, place_of, screens
from armui.ui.shell.drawer import DRAWER_PX
from armui.ui.shell.work_area import PAGE_SHARE, PANEL_PX

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

    from armui.ui.shell.layout_keeper import LayoutKeeper
    from armui.ui.shell.work_column import WorkColumn
    from armui.ui.shell.workspace_layout import WorkspaceLayout

_MOVED: Final = frozenset({QEvent.Type.Move, QEvent.Type.Resize, QEvent.Type.WindowStateChange})


class WindowLayout(QObject):
    """Puts the window and its borders where they were, and has changes kept.

    Args:
        keeper: Knows how it was.
        window: The main window, before it is shown.
        column: The borders in it.
        first_size: Of the window the first time.
    """

    def __init__(
        self, keeper: LayoutKeeper, window: QWidget, column: WorkColumn, first_size: QSize
    ) -> None:
        super().__init__(window)
        self._keeper = keeper
        self._window = window
        self._column = column
        layout = keeper.layout
        if layout.window is None:
            room = screens()[0]  # its title and its frame need some of the screen, too
            window.resize(first_size.boundedTo(QSize(room.width, room.height)))
        else:
            window.setGeometry(on_screen(layout.window))
        if layout.maximized:
            window.setWindowState(Qt.WindowState.WindowMaximized)
        column.area.set_widths(layout.panel_px or PANEL_PX, layout.page_share or PAGE_SHARE)
        column.set_drawer(layout.drawer_px or DRAWER_PX)
        column.sized.connect(keeper.note)
        keeper.collect_by(self._collect)
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """The window was moved."""
        if event.type() in _MOVED and self._window.isVisible():
            self._keeper.note()
        return super().eventFilter(watched, event)

    def _collect(self, layout: WorkspaceLayout) -> WorkspaceLayout:
        window, area = self._window, self._column.area
        return layout._replace(
            window=place_of(window.normalGeometry()),
            maximized=window.isMaximized(),
            panel_px=area.panel_px,
            page_share=round(area.page_share, 4),
            drawer_px=self._column.drawer_px,
        )
