"""A page that was taken out: a window of its own, with halt and emergency stop."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QRect, QSize, Qt, Signal
from PySide6.QtWidgets import QToolButton, QWidget

from armui.ui.dialogs.base import ArmDialog
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.keeps_focus import restore_parent

if TYPE_CHECKING:
    from PySide6.QtGui import QHideEvent, QMoveEvent, QResizeEvent

    from armui.control.arm_controller import ArmController
    from armui.ui.widgets.page import Page

_SIZE: Final = QSize(1180, 760)
_ICON_PX: Final = 18


class PageWindow(ArmDialog):
    """Closing it leaves the page, which may ask; a button puts the page back.

    Args:
        controller: Whom halt and emergency stop tell.
        page: What it holds.
        parent: The main window.

    Signals:
        put_back_wanted: The page shall stand in the main window again.
        placed: It was moved, or is of another size.
    """

    put_back_wanted = Signal()
    placed = Signal()

    def __init__(self, controller: ArmController, page: Page, parent: QWidget) -> None:
        super().__init__(controller, parent)
        self.setObjectName(f"{page.key}_window")
        self.setWindowFlags(Qt.WindowType.Window)
        self._moved = True  # it opens where it stood
        self._page: Page | None = page
        self._put_back = named("page_put_back", QToolButton())
        self._put_back.setIconSize(QSize(_ICON_PX, _ICON_PX))
        self._put_back.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._put_back.clicked.connect(self.put_back_wanted)
        self.add_to_header(self._put_back)
        self.body.addWidget(page, 1)
        page.titled.connect(self._name)
        page.show()
        self.resize(_SIZE.boundedTo(self.screen().availableSize()))
        self.retranslate_ui()
        self._recolor()

    def release(self) -> Page | None:
        """Let go of the page, which is hidden then, and be no more."""
        page, self._page = self._page, None
        if page is not None:
            page.titled.disconnect(self._name)
            page.hide()
            page.setParent(self.parentWidget())
            for each in page.findChildren(QWidget):
                restore_parent(each)
        self.hide()
        self.deleteLater()
        return page

    def open(self) -> None:
        """Show it in front, the keys with what is worked with."""
        super().open()
        if self._page is not None:
            self._page.take_focus()

    def reject(self) -> None:
        """To close it is to leave the page."""
        if self._page is None:
            super().reject()
        else:
            self._page.leave()

    def room_for_questions(self) -> QRect:
        """All of it below its stops."""
        top = self.stop_button.mapToGlobal(self.stop_button.rect().bottomLeft()).y()
        left = self.mapToGlobal(self.rect().topLeft())
        return QRect(left.x(), top, self.width(), left.y() + self.height() - top)

    def _name(self) -> None:
        if self._page is not None:
            self.set_title(self._page.title)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._name()
        self._put_back.setText(self.tr("Put back"))
        tip = self.tr("Puts this page back beside the 3D picture.")
        describe(self._put_back, self.tr("Put back"), tip)

    def _recolor(self) -> None:
        self._put_back.setIcon(icons.icon("put_back", colors_of(self).muted))

    def moveEvent(self, event: QMoveEvent) -> None:
        """Where it stands is remembered."""
        super().moveEvent(event)
        self.placed.emit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """So is its size."""
        super().resizeEvent(event)
        self.placed.emit()

    def hideEvent(self, event: QHideEvent) -> None:
        """A held control in it is let go of by the guards that watch for this."""
        super().hideEvent(event)
        self.placed.emit()
