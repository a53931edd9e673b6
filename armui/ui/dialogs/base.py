"""What every dialog of the program shares: the emergency stop, and a change of language."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final, Protocol, runtime_checkable

from PySide6.QtCore import QEvent, QMargins, QRect, Qt
from PySide6.QtGui import QContextMenuEvent, QGuiApplication, QMoveEvent, QShowEvent
from PySide6.QtWidgets import QDialog, QPushButton, QWidget

from armui.control.arm_controller import ArmController
from armui.ui.actions.command import Command, Target
from armui.ui.shell.workspace_layout import Place, fitted
from armui.ui.widgets.curve_menu import offer_curves
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.keeps_focus import KeepsFocus
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

_MARGIN_PX: Final = 20
_GAP_PX: Final = 14
_EDGE_PX: Final = 16
FRAME: Final = QMargins(8, 36, 8, 8)
"""What window systems draw around a window, its title above all; it must be in reach."""


@runtime_checkable
class HasRoomForQuestions(Protocol):
    """A window that says where small windows may lie over it; no stop button lies there."""

    def room_for_questions(self) -> QRect:
        """In pixels of the desktop."""


def place(dialog: QDialog) -> None:
    """Move a dialog to the right edge of that room, and to its top, and fit it on the screen.

    One that is wider than the room begins at its left edge; one that is higher goes on below.

    Args:
        dialog: Before it is shown; without a window that has such a room Qt finds its place.
    """
    parent = dialog.parentWidget()
    window = dialog if parent is None else parent.window()
    # where the operator has moved the window beyond the screen, its dialogs may go, too
    screen = window.screen().availableGeometry().marginsRemoved(FRAME)
    reach = screen if window is dialog else screen.united(window.geometry())
    dialog.ensurePolished()
    wanted = dialog.size().expandedTo(dialog.sizeHint())
    if not isinstance(window, HasRoomForQuestions):
        dialog.resize(dialog.size().boundedTo(reach.size()))
        return
    room = window.room_for_questions()
    left = max(room.x(), room.x() + room.width() - _EDGE_PX - wanted.width())
    wish = Place(left, room.y() + _EDGE_PX, wanted.width(), wanted.height())
    there = _rect_of(fitted(wish, [place_of(reach)]))
    if there.size() == wanted:
        dialog.move(there.topLeft())  # Qt sizes it as it is shown
    else:
        dialog.setGeometry(there)


def screens() -> list[Place]:
    """What a window can fill of each screen, the main one first."""
    main = QGuiApplication.primaryScreen()
    ordered = [main, *(each for each in QGuiApplication.screens() if each is not main)]
    return [place_of(each.availableGeometry().marginsRemoved(FRAME)) for each in ordered]


def place_of(rect: QRect) -> Place:
    """A rectangle of Qt as plain figures."""
    return Place(rect.x(), rect.y(), rect.width(), rect.height())


def _rect_of(place: Place) -> QRect:
    """The other way round."""
    return QRect(place.x, place.y, place.width, place.height)


def on_screen(place: Place) -> QRect:
    """Where a window opens that stood at a place: wholly on a screen there is."""
    return _rect_of(fitted(place, screens()))


class CloseButton(Translated, QPushButton):
    """Names itself.

    Args:
        dialog: What it closes.
        on_enter: Whether Enter presses it wherever in the dialog.
    """

    def __init__(self, dialog: QDialog, *, on_enter: bool = False) -> None:
        super().__init__()
        self.setAutoDefault(on_enter)
        self.setDefault(on_enter)
        self.clicked.connect(dialog.close)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Its word in the operator's language."""
        self.setText(self.tr("Close"))


class ArmDialog(Translated, KeepsFocus, QDialog):
    """A dialog with its title, halt and emergency stop in one line at the top.

    It never blocks the main window: the stop there stays within reach too. Escape closes it.

    Args:
        controller: Whom the emergency stop tells.
        parent: The window it belongs to and stays in front of.

    Attributes:
        body: Where its own content goes.
        footer: Where its buttons go, from left to right.
        commands: What the command palette offers of it.
    """

    commands: Sequence[Command] = ()

    def __init__(self, controller: ArmController, parent: QWidget | None = None) -> None:
        super().__init__(parent)
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
        in_column(header, (self.body, 1), self.footer, on=self, spacing=_GAP_PX, margins=_MARGIN_PX)

    def command_targets(self) -> Mapping[str, Target]:
        """Return what carries out each of its commands, by the command's name."""
        return {}

    def add_to_header(self, widget: QWidget) -> None:
        """Put something between the title and the stops."""
        self._header.insertWidget(1, widget, 0, Qt.AlignmentFlag.AlignTop)

    def set_title(self, title: str) -> None:
        """Name the dialog, in its frame and at its top."""
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
        """The keyboard goes to the first control of the content, never to halt or stop."""
        super().showEvent(event)
        if not event.spontaneous() and self.focusWidget() in {None, self.halt_button}:
            self.go_on_from(self.stop_button, forward=True)

    def event(self, event: QEvent) -> bool:
        """Grow where text goes on below and would be cut; Qt counts the height of one line only."""
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
        """Where the operator has put it, it opens again."""
        super().moveEvent(event)
        if event.spontaneous() and self.isVisible():
            self._moved = True

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language; called anew when that changes."""

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """A figure can be shown as a curve."""
        offer_curves(self, event)
