"""The menu at the left: panels, library, monitors, joint status (regions 2, 9 and 10)."""

from __future__ import annotations

import enum
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Final, TypeVar

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QAction, QColor, QFontMetrics, QPaintEvent, QPalette, QResizeEvent
from PySide6.QtWidgets import QAbstractButton, QSizePolicy, QToolButton, QWidget

from armui.arm.joint_status import StatusVerdict
from armui.arm.limits import JOINTS
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.actions.command import Command, Target, also
from armui.ui.actions.operator_view import operator_view
from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets import icons, painting, state_mark
from armui.ui.widgets.buttons import caption, named
from armui.ui.widgets.hold_button import HoldButton
from armui.ui.widgets.layouts import STRETCH, CardArea, in_column, in_row
from armui.ui.widgets.state_mark import Mark
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.tips import keep_in_sight
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text, Texts

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.devices.joint_monitor import JointMonitor
    from armui.ui.shell.page_entry import PageEntry
    from armui.ui.shell.page_opener import PageOpener


_WIDTH_PX: Final = 176
_GAP_PX: Final = 1
_ICON_PX: Final = 18
_HEIGHT_PX: Final = 44
_BUTTON_WIDTH_PX: Final = 150
_MARK_PX: Final = 9.0
_TEXT_LEFT_PX: Final = 12 + 2 * _MARK_PX + 10
_TEXT_RIGHT_PX: Final = 8

_FOLD_PX: Final = 10
_SMALL: Final = 0.8
"""The size of texts at the foot, by the normal size: all three fit into the width."""
_SIGN_ROOM_PX: Final = 26.0
"""The distance from the right edge of a heading to its sign, with a gap."""
_HEADING_TOP_PX: Final = 3.0
"""The offset of a heading's text from its middle, as in the style sheet."""
_AROUND_PX: Final = 14
"""The sum of the margins above and below the menu, and between its two parts."""
_HEADINGS: Final = Texts("SideMenu") | {
    "operate": "Operate",
    "settings": "Arm settings",
    "work": "Work",
    "watch": "Watch",
}
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
        keep_in_sight(self)
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
        line = colors.accent if self.hasFocus() else colors.stop if fault else fill
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
    """A button for each page to watch.

    Args:
        pages: The pages by their keys, from top to bottom; the button of one is named
            ``<key>_button``, its icon as the page.

    Signals:
        page_wanted: A page shall be shown, by its key.
    """

    page_wanted = Signal(str)

    def __init__(self, pages: Mapping[str, PageEntry[PageOpener]]) -> None:
        super().__init__()
        self.setObjectName("watch_menu")
        self._pages = pages
        self._buttons = {key: _as_entry(named(f"{key}_button", QToolButton())) for key in pages}
        in_column(*self._buttons.values(), on=self, spacing=_GAP_PX, margins=0)
        for key, button in self._buttons.items():
            button.clicked.connect(lambda _on=False, key=key: self.page_wanted.emit(key))
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
            title = self._pages[key].title.text()
            button.setText(f" {title}")
            button.setAccessibleName(title)
            button.setToolTip(self._pages[key].tip_text)

    def _recolor(self) -> None:
        for key, button in self._buttons.items():
            button.setIcon(icons.icon(key, colors_of(self).muted))


class LibraryButton(Translated, QToolButton):
    """An icon and the name of the page it opens; a red dot while a recording is under way there."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("library_button")
        self._recording = False
        self.setCheckable(True)
        _as_entry(self)
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
        icon = ("record", colors.stop) if self._recording else ("library", colors.muted)
        self.setIcon(icons.icon(*icon))


def _foot_button(name: str) -> QToolButton:
    button = named(name, QToolButton())
    button.setProperty("foot", True)
    button.setFont(scaled_font(button, _SMALL))
    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
    button.setIconSize(QSize(_ICON_PX, _ICON_PX))
    return button


class MenuFoot(HasActs, Translated, QWidget):
    """使用帮助, 视角还原 and 设置 (manual 1.0.8) at the foot of the menu: nothing moves them."""

    help = Act(
        "Help",
        named="help_button",
        key="view.help",
        title=Text("MenuFoot", "Help: 3D view"),
        tip="How to use the 3D view",
        kind=_foot_button,
    )
    reset_view = Act(
        "Reset view",
        named="reset_view_button",
        key="window.reset_view",
        tip="Restores the initial view",
        kind=_foot_button,
    )
    settings = Act(
        "Settings",
        named="settings_button",
        key="window.settings",
        tip="Language, theme, jog step, 3D model",
        synonyms=also("preferences options configuration 选项 首选项 配置"),
        kind=_foot_button,
    )

    def __init__(self) -> None:
        super().__init__()
        in_row(self.help, self.reset_view, self.settings, on=self, spacing=0, margins=0)
        self.retranslate_ui()
        self._recolor()

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        self.show_acts()

    def _recolor(self) -> None:
        for act in self.acts:
            icon = act.named.removesuffix("_button")
            act.button(self).setIcon(icons.icon(icon, colors_of(self).muted))


class UnlockButton(HoldButton):
    """Leaves the operator's view when it is held for a second."""

    def __init__(self, controller: ArmController) -> None:
        super().__init__(controller)
        self.setObjectName("unlock_button")

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        super().retranslate_ui()
        caption(self, self.tr("Unlock"), tip=self.tr("Leaves the operator's view."))


class MenuGroup(enum.Enum):
    """The headings over the panels, in their order."""

    OPERATE = "operate"
    SETTINGS = "settings"
    """The arm's own settings, which are rarely needed: the group can be folded."""


@dataclass(frozen=True, slots=True)
class MenuEntry:
    """An entry of the menu: a panel of the operation area.

    Attributes:
        key: Its name and that of its icon; the button is named ``menu_<key>``.
        title: The text in the menu.
        make_panel: Creates the panel.
        commands: The panel's commands for the command palette.
        synonyms: Other names of the panel, for the command palette.
        group: The heading under which it stands.
    """

    key: str
    title: Text
    make_panel: Callable[[], QWidget]
    commands: Sequence[Command] = ()
    synonyms: tuple[str, ...] = ()
    group: MenuGroup = MenuGroup.OPERATE


class GroupHeading(Translated, QToolButton):
    """The heading of a group that can be folded; folded, it shows the number of its entries."""

    def __init__(self, entries: int) -> None:
        super().__init__()
        self.setObjectName("menu_fold")
        self.setProperty("heading", True)
        self.setCheckable(True)
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setLayoutDirection(Qt.LayoutDirection.RightToLeft)  # puts the sign behind the text
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setIconSize(QSize(_FOLD_PX, _FOLD_PX))
        self._entries = entries
        self.toggled.connect(self.retranslate_ui)
        self.toggled.connect(self._recolor)
        self.retranslate_ui()
        self._recolor()

    def retranslate_ui(self, *_: object) -> None:
        """Set the text in the operator's language."""
        name = _HEADINGS.text(MenuGroup.SETTINGS.value)
        self.setText(name)
        self.setAccessibleName(name if self.isChecked() else f"{name} {self._entries}")
        self.setToolTip(self.tr("Folds this group away, or shows it."))

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the number of folded entries in front of the sign."""
        super().paintEvent(event)
        if self.isChecked():
            return
        painter = painting.begin(self)
        painter.setFont(scaled_font(self, _SMALL))
        painter.setPen(QColor(colors_of(self).muted))
        room = QRectF(self.rect()).adjusted(0, _HEADING_TOP_PX, -_SIGN_ROOM_PX, 0)
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        painter.drawText(room, right, str(self._entries))
        painter.end()

    def _recolor(self, *_: object) -> None:
        sign = "fold" if self.isChecked() else "unfold"
        self.setIcon(icons.icon(sign, colors_of(self).muted))


class SideMenu(Translated, QWidget):
    """The panels under two headings, then the library, what is watched, and the joint status.

    The chosen entry is on pale blue. The group of the arm's settings is folded where all would not
    fit, until the operator folds or unfolds it. The panels scroll on a low screen.

    Args:
        entries: The panels, each group in its order.
        library: Opens the library.
        watch: Opens what is watched.
        joint_status: Shows the state of the joints, always visible (manual 1.0.10).
        foot: The buttons at the foot, whose place is fixed.
        folded: True or False as the operator left the group of the settings; None to fit.
        unlock: Leaves the operator's view; it replaces the group of the settings.

    Signals:
        chosen: The index of the entry.
        folded_by_hand: The operator has folded the group of the settings (``True``), or unfolded
            it.
    """

    chosen = Signal(int)
    folded_by_hand = Signal(bool)

    def __init__(
        self,
        entries: Sequence[MenuEntry],
        *,
        library: QWidget,
        watch: QWidget,
        joint_status: QWidget,
        foot: QWidget,
        unlock: QWidget,
        folded: bool | None = None,
    ) -> None:
        super().__init__()
        self.setObjectName("side_menu")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)  # else no background is drawn
        self._entries = tuple(entries)
        self._folded = folded
        self.commands = [
            Command(f"{entry.key}.open", entry.title, synonyms=entry.synonyms)
            for entry in self._entries
        ]
        # no QButtonGroup: Tab would reach only the checked one of its buttons
        self._buttons = [self._button(place) for place in range(len(self._entries))]
        self._actions = [QAction(self) for _ in self._entries]
        for place, action in enumerate(self._actions):
            action.triggered.connect(partial(self._on_clicked, place))
        self._chosen: int | None = 0
        self.setFixedWidth(_WIDTH_PX)
        self._headings = {name: text_label(rank="group") for name in ("operate", "work", "watch")}
        self._settings = QWidget()
        settings = self._of(MenuGroup.SETTINGS)
        in_column(*settings, on=self._settings, spacing=_GAP_PX, margins=0)
        self._fold = GroupHeading(len(settings))
        self._column = QWidget()
        operate = (self._headings["operate"], *self._of(MenuGroup.OPERATE))
        self._unlock = unlock
        panels = (*operate, self._fold, self._settings, unlock, STRETCH)
        in_column(*panels, on=self._column, spacing=_GAP_PX, margins=0)
        self._area = area = self._scrolled(self._column)
        self._below = QWidget()
        work = (self._headings["work"], library, self._headings["watch"], watch, joint_status)
        in_column(*work, on=self._below, spacing=_GAP_PX, margins=0)
        margins = (8, 6, 8, 6)
        layout = in_column((area, 1), self._below, on=self, spacing=_GAP_PX, margins=margins)
        layout.addStretch(0)  # takes the spare height if nothing scrolls
        layout.addWidget(foot)
        self._foot = foot
        self._fold.clicked.connect(self._on_folded)
        self.retranslate_ui()
        self.choose(0)
        self._show_group(shown=not folded)

    def _button(self, place: int) -> QToolButton:
        button = _as_entry(named(f"menu_{self._entries[place].key}", QToolButton()))
        button.setCheckable(True)
        button.clicked.connect(partial(self._on_clicked, place))
        return button

    def _of(self, group: MenuGroup) -> list[QToolButton]:
        pairs = zip(self._entries, self._buttons, strict=True)
        return [button for entry, button in pairs if entry.group is group]

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name: of a folded one an action."""
        targets: dict[str, Target] = {}
        parts = zip(self.commands, self._buttons, self._actions, strict=True)
        for command, button, action in parts:
            targets[command.name] = button if button.isVisibleTo(self) else action
        return targets

    def _on_clicked(self, place: int, _on: bool = False) -> None:
        self.choose(place)
        self.chosen.emit(place)

    def open_entry(self, key: str) -> None:
        """Open an entry as if it was pressed, unless it is open already."""
        keys = [entry.key for entry in self._entries]
        place = keys.index(key)
        if place != self._chosen and self.isVisible():
            self._on_clicked(place)

    def choose(self, place: int | None) -> None:
        """Show an entry, or none, as the chosen one, without emitting a signal."""
        self._chosen = place
        for number, button in enumerate(self._buttons):
            button.setChecked(number == place)
        if self.shows_setting:
            self._show_group(shown=True)
        if place is not None:
            self._area.ensureWidgetVisible(self._buttons[place], 0, 0)
        self._recolor()

    @property
    def shows_setting(self) -> bool:
        """True if the chosen entry is one of the arm's settings."""
        chosen = self._chosen
        return chosen is not None and self._entries[chosen].group is MenuGroup.SETTINGS

    # -- folding ------------------------------------------------------------------------------

    def _on_folded(self) -> None:
        self._folded = not self._fold.isChecked()
        self._show_group(shown=not self._folded)
        self.folded_by_hand.emit(self._folded)

    def _show_group(self, *, shown: bool) -> None:
        self._fold.setChecked(shown)
        self._settings.setVisible(shown and not operator_view())
        self._fold.setVisible(not operator_view())
        self._unlock.setVisible(operator_view())
        self._column.updateGeometry()
        self._area.fit()  # Qt does not update it during a resize

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit into the new room."""
        super().resizeEvent(event)
        self._fold_to_fit()

    def event(self, event: QEvent) -> bool:
        """Fit again after a change of font, style or language."""
        done = super().event(event)
        if event.type() == QEvent.Type.LayoutRequest:
            self._fold_to_fit()
        return done

    def _fold_to_fit(self) -> None:
        """Fold or unfold the group by the room, unless the operator has chosen."""
        if self._folded is None and not self.shows_setting:
            whole_px = self._column.sizeHint().height()
            if not self._fold.isChecked():
                whole_px += self._settings.sizeHint().height() + _GAP_PX
            below_px = self._below.sizeHint().height() + self._foot.sizeHint().height()
            room_px = self.height() - below_px - _AROUND_PX
            self._show_group(shown=whole_px <= room_px)

    def _scrolled(self, column: QWidget) -> CardArea:
        area = CardArea(column)
        area.setViewport(QWidget())
        area.setObjectName("side_menu_entries")
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.viewport().setAutoFillBackground(False)
        column.setBackgroundRole(QPalette.ColorRole.Base)  # a scroll area fills its widget
        self._bar = area.verticalScrollBar()
        # queued: the area must not be resized while it lays out its contents
        queued = Qt.ConnectionType.QueuedConnection
        self._bar.rangeChanged.connect(self._make_room, queued)
        return area

    def _make_room(self, _least: int, most: int) -> None:
        """Widen the menu by the scroll bar while its entries scroll."""
        self.setFixedWidth(_WIDTH_PX + (self._bar.sizeHint().width() if most else 0))

    # -- appearance ---------------------------------------------------------------------------

    def retranslate_ui(self) -> None:
        """Set the entries in the operator's language."""
        self._show_group(shown=self._fold.isChecked())  # the operator's view may have changed
        for name, heading in self._headings.items():
            heading.setText(_HEADINGS.text(name))
        for place, entry in enumerate(self._entries):
            title = entry.title.text()
            self._buttons[place].setText(f" {title}")
            self._buttons[place].setAccessibleName(title)

    def _recolor(self) -> None:
        colors = colors_of(self)
        for place, entry in enumerate(self._entries):
            color = colors.accent if place == self._chosen else colors.muted
            self._buttons[place].setIcon(icons.icon(entry.key, color))


_Entry = TypeVar("_Entry", bound=QToolButton)


def _as_entry(button: _Entry) -> _Entry:
    """Give a button the look of an entry of the menu."""
    button.setProperty("entry", True)
    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
    button.setIconSize(QSize(_ICON_PX, _ICON_PX))
    button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
    return button
