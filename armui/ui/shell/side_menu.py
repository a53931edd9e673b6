"""The menu at the left: panels, library, monitors, joint status (regions 2, 9 and 10)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFontMetrics, QPaintEvent
from PySide6.QtWidgets import QAbstractButton, QScrollArea, QSizePolicy, QToolButton, QWidget

from armui.arm.joint_status import StatusVerdict
from armui.arm.limits import JOINTS
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.command import Command, Target
from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets import icons, painting, state_mark
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import empty_grid, in_column
from armui.ui.widgets.state_mark import Mark
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.control.devices.joint_monitor import JointMonitor
    from armui.ui.shell.page_entry import PageEntry
    from armui.ui.shell.page_opener import PageOpener


_WIDTH_PX: Final = 176
_COLUMNS: Final = 2
_HEIGHT_PX: Final = 52
_BUTTON_WIDTH_PX: Final = 150
_MARK_PX: Final = 9.0
_TEXT_LEFT_PX: Final = 12 + 2 * _MARK_PX + 10
_TEXT_RIGHT_PX: Final = 8

_MARKS: Final = {
    StatusVerdict.NORMAL: Mark.GOOD,
    StatusVerdict.DISABLED: Mark.OFF,
    StatusVerdict.UNKNOWN: Mark.UNKNOWN,
    StatusVerdict.FAULT: Mark.FAULT,
    StatusVerdict.OFFLINE: Mark.OFFLINE,
}


class JointStatusButton(Translated, QAbstractButton):
    """A button with a mark, the name of the page, and the state of the joints in words.

    Args:
        monitor: Gives the state of the joints.
    """

    def __init__(self, monitor: JointMonitor) -> None:
        super().__init__()
        self.setObjectName("joint_status_button")
        self._monitor = monitor
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        monitor.worst_changed.connect(self.retranslate_ui)
        self.retranslate_ui()

    @property
    def mark(self) -> Mark:
        """The mark shown."""
        return _MARKS[self._monitor.worst.verdict]

    @property
    def state_text(self) -> str:
        """The state in words, with the joints it concerns."""
        worst = self._monitor.worst
        text = words.joint_verdict(worst.verdict)
        if worst.joints and len(worst.joints) < len(JOINTS):
            return f"{text} {fmt.joint_spans(list(worst.joints))}"
        if worst.joints and worst.verdict is StatusVerdict.FAULT:
            return f"{text} J1–J6"
        return f"{text} {fmt.NOTHING}" if worst.verdict is StatusVerdict.UNKNOWN else text

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        self.setText(self.tr("Joint status"))
        self.setAccessibleName(f"{self.text()} {self.state_text}")
        faults = [
            f"J{joint}  {words.joint_item(item)} {words.joint_word(word)}"
            for joint, item, word in self._monitor.faults
        ]
        tip = self.tr("The worst of the six joints. Press to see all of them.")
        self.setToolTip("\n".join([self.state_text, *faults, tip]))
        self.update()

    def sizeHint(self) -> QSize:
        """Return the preferred size."""
        return QSize(_BUTTON_WIDTH_PX, _HEIGHT_PX)

    def minimumSizeHint(self) -> QSize:
        """Return the same size: it is never smaller."""
        return self.sizeHint()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the button."""
        colors = colors_of(self)
        fault = self._monitor.worst.verdict is StatusVerdict.FAULT
        painter = painting.begin(self)
        active = self.underMouse() or self.isDown()
        ground = colors.stop_pale if fault else colors.surface
        fill = colors.accent_pale if active else ground
        edge = colors.stop if fault else colors.border
        line = colors.accent if active or self.hasFocus() else edge
        painting.panel(painter, QRectF(self.rect()), fill, line, 2 if self.hasFocus() else 1)
        center = QPointF(12 + _MARK_PX, self.height() / 2)
        state_mark.draw(painter, colors, center, _MARK_PX, self.mark)
        half, width = self.height() / 2, self.width() - _TEXT_LEFT_PX - _TEXT_RIGHT_PX
        painter.setFont(scaled_font(self, 1.0, bold=True))
        painter.setPen(QColor(colors.text))
        above = QRectF(_TEXT_LEFT_PX, 0, width, half)
        painter.drawText(above, Qt.AlignmentFlag.AlignBottom, self.text())
        font = scaled_font(self, 0.92, bold=fault)
        state = QFontMetrics(font).elidedText(
            self.state_text, Qt.TextElideMode.ElideRight, int(width)
        )
        painter.setFont(font)
        painter.setPen(QColor(colors.text if fault else colors.muted))
        below = QRectF(_TEXT_LEFT_PX, half + 1, width, half)
        painter.drawText(below, Qt.AlignmentFlag.AlignTop, state)
        painter.end()


class WatchMenu(Translated, QWidget):
    """A button for each page, two in a row; a single one is as wide as the menu.

    Args:
        pages: The pages by their keys, row by row; the button of one is named ``<key>_button``, its
            icon as the page.

    Signals:
        page_wanted: A page shall be shown, by its key.
    """

    page_wanted = Signal(str)

    def __init__(self, pages: Mapping[str, PageEntry[PageOpener]]) -> None:
        super().__init__()
        self.setObjectName("watch_menu")
        self._pages = pages
        self._buttons = {key: named(f"{key}_button", QToolButton()) for key in pages}
        layout = empty_grid(self, gaps=(4, 4), margins=0)
        for place, (key, button) in enumerate(self._buttons.items()):
            button.setProperty("half", True)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
            button.setIconSize(QSize(18, 18))
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            button.clicked.connect(lambda _on=False, key=key: self.page_wanted.emit(key))
            row, column = divmod(place, _COLUMNS)
            alone = column == 0 and place == len(pages) - 1
            layout.addWidget(button, row, column, 1, _COLUMNS if alone else 1)
        self.commands = [page.command for page in pages.values() if page.command is not None]
        self._recolor()
        self.retranslate_ui()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        buttons = zip(self._pages.values(), self._buttons.values(), strict=True)
        return {page.command.name: button for page, button in buttons if page.command is not None}

    def retranslate_ui(self) -> None:
        """Set the names in the operator's language."""
        for key, button in self._buttons.items():
            title = self._pages[key].tab_title.text()
            button.setText(f" {title}")
            button.setAccessibleName(title)
            button.setToolTip(self._pages[key].tip_text)

    def _recolor(self) -> None:
        for key, button in self._buttons.items():
            button.setIcon(icons.icon(key, colors_of(self).accent))


class LibraryButton(Translated, QToolButton):
    """An icon and the name of the page it opens; a red dot while a recording is under way there."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("library_button")
        self._recording = False
        self.setCheckable(True)
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setIconSize(QSize(20, 20))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._recolor()
        self.retranslate_ui()

    def show_recording(self, *, recording: bool) -> None:
        """Show whether the motion of the arm is being recorded."""
        if recording != self._recording:
            self._recording = recording
            self.retranslate_ui()
            self._recolor()

    def retranslate_ui(self) -> None:
        """Set its name in the operator's language."""
        name = self.tr("Recording…") if self._recording else self.tr("Trajectory library")
        self.setText(f" {name}")
        self.setAccessibleName(name)
        self.setToolTip(self.tr("Make, check, run and record trajectories"))

    def _recolor(self) -> None:
        colors = colors_of(self)
        icon = ("record", colors.stop) if self._recording else ("library", colors.accent)
        self.setIcon(icons.icon(*icon))


@dataclass(frozen=True, slots=True)
class MenuEntry:
    """An entry of the menu: a panel of the operation area.

    Attributes:
        key: Its name and that of its icon; the button is named ``menu_<key>``.
        title: The text in the menu.
        make_panel: Creates the panel.
        commands: The panel's commands for the command palette.
        synonyms: Other names of the panel, for the command palette.
    """

    key: str
    title: Text
    make_panel: Callable[[], QWidget]
    commands: Sequence[Command] = ()
    synonyms: tuple[str, ...] = ()


class SideMenu(Translated, QWidget):
    """One entry for each panel; the chosen one is on pale blue.

    It scrolls on a low screen.

    Args:
        entries: The entries from top to bottom.
        at_bottom: A widget apart from them at the lower end.

    Signals:
        chosen: The index of the entry.
    """

    chosen = Signal(int)

    def __init__(self, entries: Sequence[MenuEntry], at_bottom: Sequence[QWidget]) -> None:
        super().__init__()
        self.setObjectName("side_menu")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._entries = tuple(entries)
        self.commands = [
            Command(f"{entry.key}.open", entry.title, synonyms=entry.synonyms)
            for entry in self._entries
        ]
        # no QButtonGroup: Tab would reach only the checked one of its buttons
        self._buttons: list[QToolButton] = []
        self._chosen: int | None = 0
        self.setFixedWidth(_WIDTH_PX)
        column = QWidget()
        layout = in_column(on=column, spacing=2, margins=0)
        for place, entry in enumerate(self._entries):
            button = named(f"menu_{entry.key}", QToolButton())
            button.setProperty("entry", True)
            button.setCheckable(True)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
            button.setIconSize(QSize(20, 20))
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            button.clicked.connect(partial(self._on_clicked, place))
            self._buttons.append(button)
            layout.addWidget(button)
        layout.addStretch(1)
        entries_area = (self._scrolled(column), 1)
        in_column(entries_area, *at_bottom, on=self, spacing=6, margins=(8, 10, 8, 10))
        self.retranslate_ui()
        self.choose(0)

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        names = (command.name for command in self.commands)
        return dict(zip(names, self._buttons, strict=True))

    def _on_clicked(self, place: int, _on: bool = False) -> None:
        self.choose(place)
        self.chosen.emit(place)

    def open_entry(self, key: str) -> None:
        """Open an entry as by a press on it, unless it is open already."""
        keys = [entry.key for entry in self._entries]
        place = keys.index(key)
        if place != self._chosen and self.isVisible():
            self._on_clicked(place)

    def choose(self, place: int | None) -> None:
        """Show an entry, or none, as the chosen one, without emitting a signal."""
        self._chosen = place
        for number, button in enumerate(self._buttons):
            button.setChecked(number == place)
        self._recolor()

    def _scrolled(self, column: QWidget) -> QScrollArea:
        area = QScrollArea()
        area.setViewport(QWidget())
        area.setObjectName("side_menu_entries")
        area.setWidgetResizable(True)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setWidget(column)
        area.viewport().setAutoFillBackground(False)
        column.setAutoFillBackground(False)
        self._bar = area.verticalScrollBar()
        # queued: the area must not be resized while it lays out its contents
        queued = Qt.ConnectionType.QueuedConnection
        self._bar.rangeChanged.connect(self._make_room, queued)
        return area

    def _make_room(self, _least: int, most: int) -> None:
        """Make room for the scroll bar beside the entries, where they scroll."""
        self.setFixedWidth(_WIDTH_PX + (self._bar.sizeHint().width() if most else 0))

    def retranslate_ui(self) -> None:
        """Set the entries in the operator's language."""
        for place, entry in enumerate(self._entries):
            title = entry.title.text()
            self._buttons[place].setText(f" {title}")
            self._buttons[place].setAccessibleName(title)

    def _recolor(self) -> None:
        colors = colors_of(self)
        for place, entry in enumerate(self._entries):
            color = colors.accent if place == self._chosen else colors.muted
            self._buttons[place].setIcon(icons.icon(entry.key, color))
