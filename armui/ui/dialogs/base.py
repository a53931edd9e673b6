"""The parts shared by all dialogs: the emergency stop, and a change of language."""

from __future__ import annotations

from typing import Final, Protocol, runtime_checkable

from PySide6.QtCore import QEvent, QMargins, QRect, QSize, Qt
from PySide6.QtGui import QContextMenuEvent, QGuiApplication, QMoveEvent, QShowEvent
from PySide6.QtWidgets import QDialog, QPushButton, QWidget

from armui.control.arm_controller import ArmController
from armui.ui.actions.act import HasActs
from armui.ui.shell.workspace_layout import Place, fitted
from armui.ui.widgets.curve_menu import offer_curves
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.keeps_focus import KeepsFocus
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

MARGIN_PX: Final = 20
_GAP_PX: Final = 14
_EDGE_PX: Final = 16
FRAME: Final = QMargins(8, 36, 8, 8)
"""The frame that window systems draw around a window; its title must stay reachable."""
_LEAST_FRAME: Final = QMargins(0, 20, 0, 0)
"""The room below which a title could no longer be reached with the narrowest of these frames."""


@runtime_checkable
class HasRoomForQuestions(Protocol):
    """A window with an area for small windows, which never cover its stop button."""

    def room_for_questions(self) -> QRect:
        """Return the area in pixels of the desktop."""


def place(dialog: QDialog) -> None:
    """Move a dialog to the top right of that area, and fit it into its width and on the screen.

    One that cannot be so narrow begins at its left edge; a higher one extends below.

    Args:
        dialog: The dialog before it is shown; Qt places it if no window has such an area.
    """
    parent = dialog.parentWidget()
    window = dialog if parent is None else parent.window()
    # a window that was moved partly off the screen may have its dialogs there, too
    screen = window.screen().availableGeometry().marginsRemoved(FRAME)
    reach = screen if window is dialog else screen.united(window.geometry())
    dialog.ensurePolished()  # the size hint depends on the theme's fonts
    wanted = dialog.size().expandedTo(dialog.sizeHint())
    if not isinstance(window, HasRoomForQuestions):
        dialog.resize(dialog.size().boundedTo(QSize(window.width(), reach.height())))
        return
    room = window.room_for_questions()
    width = min(wanted.width(), max(dialog.minimumSizeHint().width(), room.width() - _EDGE_PX))
    left = max(room.x(), room.x() + room.width() - _EDGE_PX - width)
    wish = Place(left, room.y() + _EDGE_PX, width, wanted.height())
    there = _rect_of(fitted(wish, [place_of(reach)]))
    if there.size() == wanted:
        dialog.move(there.topLeft())  # Qt gives it its wanted size when it is shown
    else:
        dialog.setGeometry(there)


def screens() -> list[Place]:
    """Return the usable area of each screen, the main one first."""
    main = QGuiApplication.primaryScreen()
    ordered = [main, *(each for each in QGuiApplication.screens() if each is not main)]
    return [place_of(each.availableGeometry().marginsRemoved(FRAME)) for each in ordered]


def place_of(rect: QRect) -> Place:
    """Return a rectangle of Qt as a plain place."""
    return Place(rect.x(), rect.y(), rect.width(), rect.height())


def _rect_of(place: Place) -> QRect:
    """Return a stored place as a rectangle."""
    return QRect(place.x, place.y, place.width, place.height)


def on_screen(place: Place) -> QRect:
    """Return the rectangle for a window at a stored place, completely on an existing screen.

    Where it already is, it stays to the pixel: most frames are narrower than `FRAME`, and a window
    beside the edge would open lower than it was closed.
    """
    rect = _rect_of(place)
    for screen in QGuiApplication.screens():
        if screen.availableGeometry().marginsRemoved(_LEAST_FRAME).contains(rect):
            return rect
    return _rect_of(fitted(place, screens()))


class CloseButton(Translated, QPushButton):
    """A button that closes a dialog.

    Args:
        dialog: The dialog it closes.
        on_enter: True if Enter presses it anywhere in the dialog.
    """

    def __init__(self, dialog: QDialog, *, on_enter: bool = False) -> None:
        super().__init__()
        self.setAutoDefault(on_enter)
        self.setDefault(on_enter)
        self.clicked.connect(dialog.close)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set the text in the operator's language."""
        self.setText(self.tr("Close"))


class ArmDialog(HasActs, Translated, KeepsFocus, QDialog):
    """A dialog with its title, halt and emergency stop in one line at the top.

    It never blocks the main window, so the stop there stays within reach, too. Escape closes it.

    Args:
        controller: Receives the emergency stop.
        parent: The window it belongs to and stays in front of.

    Attributes:
        body: The layout for its own content.
        footer: The layout for its buttons, from left to right.
    """

    def __init__(self, controller: ArmController, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._controller = controller
        self.setModal(False)
        self._moved = False
        self._heading = text_label(rank="title", wraps=True, plain=True)
        self.halt_button = HaltButton(controller, self, slim=True)
        self.stop_button = StopButton(controller, self, slim=True)

        self._header = header = in_row((self._heading, 1), spacing=_GAP_PX)
        header.addWidget(self.halt_button, 0, Qt.AlignmentFlag.AlignTop)
        header.addWidget(self.stop_button, 0, Qt.AlignmentFlag.AlignTop)
        self.body = in_column(spacing=_GAP_PX)
        self.footer = in_row(spacing=_GAP_PX // 2)
        in_column(header, (self.body, 1), self.footer, on=self, spacing=_GAP_PX, margins=MARGIN_PX)

    def add_to_header(self, widget: QWidget) -> None:
        """Add a widget between the title and the stops."""
        self._header.insertWidget(1, widget, 0, Qt.AlignmentFlag.AlignTop)

    def set_title(self, title: str) -> None:
        """Set the title in the frame and at the top of the dialog."""
        self.setWindowTitle(title)
        self._heading.setText(title)

    def open(self) -> None:
        """Show the dialog in front; unlike Qt's own, without blocking the window behind it."""
        if not self.isVisible() and not self._moved:
            place(self)
        self.show()
        self.raise_()
        self.activateWindow()

    def showEvent(self, event: QShowEvent) -> None:
        """Focus the first control of the content, never halt or stop."""
        super().showEvent(event)
        if not event.spontaneous() and self.focusWidget() in {None, self.halt_button}:
            self.go_on_from(self.stop_button, forward=True)

    def event(self, event: QEvent) -> bool:
        """Grow if wrapped text would be cut; Qt's size hint counts only one line of it."""
        done = super().event(event)
        if event.type() == QEvent.Type.LayoutRequest and self.isVisible():
            room = self.screen().availableGeometry().marginsRemoved(FRAME)
            layout = self.layout()
            least = 0 if layout is None else layout.minimumHeightForWidth(self.width())
            needed = min(least, room.height())
            if needed > self.height():
                self.resize(self.width(), needed)
                self.move(self.x(), max(room.top(), min(self.y(), room.bottom() - needed)))
        return done

    def moveEvent(self, event: QMoveEvent) -> None:
        """Remember that the operator has moved the dialog: it reopens at the same place."""
        super().moveEvent(event)
        # moves by the program itself are not spontaneous
        if event.spontaneous() and self.isVisible():
            self._moved = True

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language; called again when that changes."""

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer to show the figure under the pointer as a curve."""
        offer_curves(self, event)
