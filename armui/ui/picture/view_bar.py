"""The strip beside the picture: from where the arm is seen, and what is drawn around it."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Final, NamedTuple

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication, QSize, Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QFrame, QMenu, QToolButton

from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.translated import Translated
from armui.viewport.camera import ViewDirection

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.settings import SettingsStore
    from armui.viewport.view import ArmView

_BUTTON_PX: Final = 30
_MARGIN_PX: Final = 4
TRAILS_S: Final = (0, 5, 15, 60)
"""How much of the tool's way can be shown, in seconds of motion; 0: nothing."""


class _Entry(NamedTuple):
    """One action.

    Attributes:
        text: Its name.
        tip: What it does.
        key: Its shortcut in the window.
        icon: Its icon's name.
        stays: Whether it is switched on and off.
    """

    text: object
    tip: object
    key: str
    icon: str = ""
    stays: bool = False


_ENTRIES: Final = {
    "front": _Entry(
        QT_TRANSLATE_NOOP("ViewBar", "Front view"),
        QT_TRANSLATE_NOOP("ViewBar", "Looks at the arm from where it points to"),
        "Ctrl+1",
        "view_front",
    ),
    "side": _Entry(
        QT_TRANSLATE_NOOP("ViewBar", "Side view"),
        QT_TRANSLATE_NOOP("ViewBar", "Looks at the arm from its right side"),
        "Ctrl+2",
        "view_side",
    ),
    "top": _Entry(
        QT_TRANSLATE_NOOP("ViewBar", "Top view"),
        QT_TRANSLATE_NOOP("ViewBar", "Looks down on the arm"),
        "Ctrl+3",
        "view_top",
    ),
    "iso": _Entry(
        QT_TRANSLATE_NOOP("ViewBar", "Oblique view"),
        QT_TRANSLATE_NOOP("ViewBar", "Looks at the arm from the front right and above"),
        "Ctrl+4",
        "view_iso",
    ),
    "fit": _Entry(
        QT_TRANSLATE_NOOP("ViewBar", "Fit"),
        QT_TRANSLATE_NOOP("ViewBar", "Shows all of the arm as large as the room allows"),
        "Ctrl+9",
        "view_fit",
    ),
    "follow": _Entry(
        QT_TRANSLATE_NOOP("ViewBar", "Follow the tool"),
        QT_TRANSLATE_NOOP("ViewBar", "Keeps the tool centre point in the middle"),
        "Ctrl+5",
        "view_follow",
        stays=True,
    ),
    "orthographic": _Entry(
        QT_TRANSLATE_NOOP("ViewBar", "Without perspective"),
        QT_TRANSLATE_NOOP("ViewBar", "Parallel lines look parallel: lengths can be compared"),
        "Ctrl+6",
        stays=True,
    ),
    "tool_frame": _Entry(
        QT_TRANSLATE_NOOP("ViewBar", "Tool frame"),
        QT_TRANSLATE_NOOP("ViewBar", "Shows the axes of the tool centre point"),
        "Ctrl+7",
        stays=True,
    ),
    "reach": _Entry(
        QT_TRANSLATE_NOOP("ViewBar", "Workspace"),
        QT_TRANSLATE_NOOP("ViewBar", "Shows how far the tool centre point can reach"),
        "Ctrl+8",
        stays=True,
    ),
    "save": _Entry(
        QT_TRANSLATE_NOOP("ViewBar", "Save picture…"),
        QT_TRANSLATE_NOOP("ViewBar", "Writes the picture with its figures to a file"),
        "Ctrl+Alt+S",
    ),
    "copy": _Entry(
        QT_TRANSLATE_NOOP("ViewBar", "Copy picture"),
        QT_TRANSLATE_NOOP("ViewBar", "Puts the picture with its figures into the clipboard"),
        "Ctrl+Alt+C",
    ),
}
_STRIP: Final = ("front", "side", "top", "iso", "fit", "follow")
_MENU: Final = (
    ("front", "side", "top", "iso"),
    ("fit", "follow", "orthographic"),
    ("tool_frame", "reach", "trail"),
    ("save", "copy"),
)


class ViewBar(Translated, QFrame):
    """Buttons for the views, and a menu with everything that can be chosen of the picture.

    Args:
        view: Shows the arm.
        preferences: Keep the direction, the perspective, the tool's frame and the trail's length.

    Attributes:
        view_actions: By name, for menus and lists of shortcuts.
    """

    def __init__(self, view: ArmView, preferences: SettingsStore) -> None:
        super().__init__()
        self.setObjectName("view_bar")
        self._view = view
        self._preferences = preferences
        self._buttons: list[QToolButton] = []
        self.view_actions = {name: self._action(name, entry) for name, entry in _ENTRIES.items()}
        self._trail_menu = QMenu(self)
        self._trails = self._trail_actions()
        self._menu = QMenu(self)
        self._fill_menu()
        self._more = named("view_more_button", QToolButton())
        self._more.setMenu(self._menu)
        self._more.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self._lay_out()
        self._connect()
        self._take_settings()
        self.retranslate_ui()
        self._recolor()

    def _action(self, name: str, entry: _Entry) -> QAction:
        action = named(f"view_{name}", QAction(self))
        action.setCheckable(entry.stays)
        action.setShortcut(QKeySequence(entry.key))
        self.addAction(action)
        return action

    def _trail_actions(self) -> dict[int, QAction]:
        group = QActionGroup(self)
        result: dict[int, QAction] = {}
        for length_s in TRAILS_S:
            action = result[length_s] = named(f"trail_{length_s}", QAction(self))
            action.setCheckable(True)
            group.addAction(action)
            self._trail_menu.addAction(action)
            action.triggered.connect(
                lambda _on=False, s=length_s: self._preferences.change(picture_trail_s=s)
            )
        return result

    def _fill_menu(self) -> None:
        for names in _MENU:
            for name in names:
                if name == "trail":
                    self._menu.addMenu(self._trail_menu)
                else:
                    self._menu.addAction(self.view_actions[name])
            self._menu.addSeparator()

    def _lay_out(self) -> None:
        for name in _STRIP:
            button = named(f"view_{name}_button", QToolButton())
            button.setDefaultAction(self.view_actions[name])
            self._buttons.append(button)
        for button in (*self._buttons, self._more):
            button.setAutoRaise(True)
            button.setFixedSize(_BUTTON_PX, _BUTTON_PX)
            button.setIconSize(QSize(20, 20))
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        in_column(*self._buttons, self._more, on=self, spacing=2, margins=_MARGIN_PX)

    def _connect(self) -> None:
        actions = self.view_actions
        for direction in ViewDirection:
            actions[direction.value].triggered.connect(partial(self._look_from, direction))
        actions["fit"].triggered.connect(self._view.fit)
        actions["follow"].triggered.connect(lambda on: self._view.follow_tool(wanted=on))
        actions["orthographic"].triggered.connect(
            lambda on: self._preferences.change(picture_orthographic=on)
        )
        actions["tool_frame"].triggered.connect(
            lambda on: self._preferences.change(picture_tool_frame=on)
        )
        self._view.view_changed.connect(self._show_mode)
        unsubscribe = self._preferences.subscribe(lambda _settings: self._take_settings())
        self.destroyed.connect(unsubscribe)

    def add_to_strip(self, action: QAction, name: str) -> None:
        """Put one more button at the top of the strip, and into the menu."""
        button = named(name, QToolButton())
        button.setDefaultAction(action)
        button.setAutoRaise(True)
        button.setFixedSize(_BUTTON_PX, _BUTTON_PX)
        button.setIconSize(QSize(20, 20))
        self.layout().insertWidget(0, button)  # type: ignore[union-attr]
        self._menu.insertAction(self._menu.actions()[0], action)

    def on(self, name: str, do: Callable[..., object]) -> None:
        """Have an action do something more."""
        self.view_actions[name].triggered.connect(do)

    def _look_from(self, direction: ViewDirection) -> None:
        self._view.look_from(direction)
        self._preferences.change(picture_direction=direction.value)

    def _take_settings(self) -> None:
        settings = self._preferences.settings
        self._view.set_orthographic(wanted=settings.picture_orthographic)
        self._view.show_tool_frame(wanted=settings.picture_tool_frame)
        self.view_actions["orthographic"].setChecked(settings.picture_orthographic)
        self.view_actions["tool_frame"].setChecked(settings.picture_tool_frame)
        trail = self._trails.get(settings.picture_trail_s)
        if trail is not None:
            trail.setChecked(True)

    def _show_mode(self) -> None:
        from armui.viewport.viewpoint import ViewMode  # noqa: PLC0415 - loaded with the view

        self.view_actions["follow"].setChecked(self._view.mode is ViewMode.FOLLOW)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        for name, entry in _ENTRIES.items():
            text = QCoreApplication.translate("ViewBar", str(entry.text))
            tip = QCoreApplication.translate("ViewBar", str(entry.tip))
            action = self.view_actions[name]
            keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
            action.setText(text)
            action.setToolTip(f"{text}: {tip} ({keys})")
        for button in self._buttons:
            button.setAccessibleName(button.defaultAction().text())
        self._trail_menu.setTitle(self.tr("Way of the tool"))
        for length_s, action in self._trails.items():
            words = self.tr("Last {seconds} s of motion").format(seconds=length_s)
            action.setText(words if length_s else self.tr("Off"))
        describe(self._more, self.tr("View"), self.tr("Views, and what is drawn in the picture"))

    def _recolor(self) -> None:
        color = colors_of(self).muted
        for name in _STRIP:
            self.view_actions[name].setIcon(icons.icon(_ENTRIES[name].icon, color))
        self._more.setIcon(icons.icon("view_more", color))
