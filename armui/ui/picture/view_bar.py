"""The strip beside the picture: the directions of the view, and the overlays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QFrame, QMenu, QToolButton

from armui.ui.actions.command import Command, Target, also
from armui.ui.actions.keys import SHORTCUTS, keys_of
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import describe, give_menu, named
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text, Texts
from armui.viewport.camera import ViewDirection
from armui.viewport.handles import HandleKind
from armui.viewport.viewpoint import ViewMode

if TYPE_CHECKING:
    from armui.settings import SettingsStore
    from armui.viewport.view import ArmView

_BUTTON_PX: Final = 30
_MARGIN_PX: Final = 4


_TIPS: Final = Texts("ViewBar") | {
    "front": "Looks at the arm from the front",
    "side": "Looks at the arm from its right side",
    "top": "Looks down on the arm",
    "iso": "Looks at the arm from the front right and above",
    "below": "Looks at the arm from below the floor; turning the picture never goes there",
    "fit": "Shows all of the arm, and the boxes of the work area, as large as the room allows",
    "follow": "Keeps the tool centre point in the middle",
    "orthographic": "Parallel lines look parallel: lengths can be compared",
    "tool_frame": "Shows the axes of the tool centre point",
    "reach": (
        "Shows where the tool centre point can reach; orange outlines what it cannot reach within"
    ),
    "area": "Shows the planes and boxes of the cell's work area; those near the arm are lit",
    "frames": "Shows the user frames of the cell; the one in force has coloured axes",
    "save": "Writes the picture with its figures to a file",
    "copy": "Puts the picture with its figures into the clipboard",
}
"""The tooltip of each action; name and key are those of ``view.<action>`` in `SHORTCUTS`."""
_ALSO: Final = {
    **dict.fromkeys(("save", "copy"), also("screenshot image capture 截图 截屏")),
    **dict.fromkeys(("iso", "fit", "follow"), also("camera 相机")),
}
_SWITCHES: Final = ("follow", "orthographic", "tool_frame", "reach", "area", "frames")
_HANDLES: Final = Texts("ViewBar") | {
    None: "No handles",
    HandleKind.TOOL: "Tool, along the axes of its figures: base or user frame",
    HandleKind.TOOL_FRAME: "Tool, along its own axes",
    HandleKind.JOINTS: "Joints",
}
_ICONS: Final = ("front", "side", "top", "iso", "fit", "follow")
"""The actions with an icon."""
_VIEWS: Final = ("front", "side", "top", "iso", "below")
_MENU: Final = (
    ("follow", "orthographic", "tool_frame", "reach", "area", "frames", "trail"),
    ("save", "copy"),
)
"""Actions without a button; with all actions the menu would open over the stop button."""


_TRAILS: Final = {
    0: Text("Action", "Tool trail: off"),
    5: Text("Action", "Tool trail: last 5 s of motion"),
    15: Text("Action", "Tool trail: last 15 s of motion"),
    60: Text("Action", "Tool trail: last 60 s of motion"),
}
_HANDLE_TITLES: Final = {
    None: Text("ViewBar", "No handles"),
    HandleKind.TOOL: Text("Action", "Handles at the tool, along the axes of base or user frame"),
    HandleKind.TOOL_FRAME: Text("Action", "Handles at the tool, along its own axes"),
    HandleKind.JOINTS: Text("Action", "Handles at the joints"),
}
"""The titles of the handles in the command palette."""


class ViewBar(Translated, QFrame):
    """Buttons for the views, and a menu with all choices for the picture.

    Signals:
        handles_wanted: The handles to show in the picture, a `HandleKind` or None.

    Args:
        view: Shows the arm.
        preferences: Keep the direction, the perspective, the tool's frame and the trail's length.

    Attributes:
        view_actions: The actions by name, for menus and lists of shortcuts.
    """

    commands = (
        *(Command(f"view.{name}", synonyms=_ALSO.get(name, ())) for name in (*_TIPS, "handles")),
        *(Command(f"view.trail_{length_s}", title) for length_s, title in _TRAILS.items()),
        *(Command(f"view.handles_{kind}", title) for kind, title in _HANDLE_TITLES.items()),
    )
    handles_wanted = Signal(object)

    def __init__(self, view: ArmView, preferences: SettingsStore) -> None:
        super().__init__()
        self.setObjectName("view_bar")
        self._view = view
        self._of_tool = any(preferences.settings.tool)
        self._preferences = preferences
        self.view_actions = {name: self._action(name) for name in _TIPS}
        self._trail_menu = QMenu(self)
        self._trails = self._trail_actions()
        self._handles_menu = QMenu(self)
        self._handles = self._handle_actions()
        self._handles_button = _menu_button("view_handles_button", self._handles_menu)
        self._handles_button.setCheckable(True)
        self._last_handles = HandleKind.TOOL
        self._views_menu = QMenu(self)
        self._views = _menu_button("view_from_button", self._views_menu)
        self._fit = named("view_fit_button", QToolButton())
        self._fit.setDefaultAction(self.view_actions["fit"])
        self._menu = QMenu(self)
        self._fill_menu()
        self._more = _menu_button("view_more_button", self._menu)
        self._lay_out()
        self._connect()
        self._take_settings()
        self.retranslate_ui()
        self._recolor()

    def _action(self, name: str) -> QAction:
        action = named(f"view_{name}", QAction(self))
        action.setCheckable(name in _SWITCHES)
        action.setShortcut(QKeySequence(keys_of(f"view.{name}")))
        self.addAction(action)
        return action

    def _trail_actions(self) -> dict[int, QAction]:
        group = QActionGroup(self)
        result: dict[int, QAction] = {}
        for length_s in _TRAILS:
            action = result[length_s] = named(f"trail_{length_s}", QAction(self))
            action.setCheckable(True)
            group.addAction(action)
            self._trail_menu.addAction(action)
            action.triggered.connect(
                lambda _on=False, s=length_s: self._preferences.change(picture_trail_s=s)
            )
        return result

    def _handle_actions(self) -> dict[HandleKind | None, QAction]:
        group = QActionGroup(self)
        result: dict[HandleKind | None, QAction] = {}
        for kind in _HANDLES:
            name = "none" if kind is None else kind.value
            action = result[kind] = named(f"handles_{name}", QAction(self))
            action.setCheckable(True)
            action.setChecked(kind is None)
            group.addAction(action)
            self._handles_menu.addAction(action)
            action.triggered.connect(lambda _on=False, kind=kind: self.choose_handles(kind))
        self._toggle_handles = named("handles_toggle", QAction(self))
        self._toggle_handles.setShortcut(QKeySequence(keys_of("view.handles")))
        self._toggle_handles.triggered.connect(self._on_toggle_handles)
        self.addAction(self._toggle_handles)
        return result

    def choose_handles(self, kind: HandleKind | None) -> None:
        """Show handles of another kind in the picture, or none with None."""
        self._handles[kind].setChecked(True)
        self._handles_button.setChecked(kind is not None)
        if kind is not None:
            self._last_handles = kind
        self.handles_wanted.emit(kind)

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            **{f"view.{name}": action for name, action in self.view_actions.items()},
            "view.handles": self._toggle_handles,
            **{f"view.trail_{length_s}": action for length_s, action in self._trails.items()},
            **{f"view.handles_{kind}": action for kind, action in self._handles.items()},
        }

    def _on_toggle_handles(self) -> None:
        off = self._handles[None].isChecked()
        self.choose_handles(self._last_handles if off else None)

    def _fill_menu(self) -> None:
        for name in _VIEWS:
            self._views_menu.addAction(self.view_actions[name])
        for names in _MENU:
            for name in names:
                if name == "trail":
                    self._menu.addMenu(self._trail_menu)
                else:
                    self._menu.addAction(self.view_actions[name])
            self._menu.addSeparator()

    def _lay_out(self) -> None:
        buttons = (self._handles_button, self._views, self._fit, self._more)
        for button in buttons:
            button.setAutoRaise(True)
            button.setFixedSize(_BUTTON_PX, _BUTTON_PX)
            button.setIconSize(QSize(20, 20))
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        in_column(*buttons, on=self, spacing=2, margins=_MARGIN_PX)

    def _connect(self) -> None:
        actions = self.view_actions
        for direction in ViewDirection:
            actions[direction.value].triggered.connect(partial(self._look_from, direction))
        actions["fit"].triggered.connect(self._view.fit)
        actions["area"].setChecked(True)
        actions["frames"].setChecked(True)
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

    def _look_from(self, direction: ViewDirection) -> None:
        self._view.look_from(direction)
        self._preferences.change(picture_direction=direction.value)

    def _take_settings(self) -> None:
        settings = self._preferences.settings
        self._view.set_orthographic(wanted=settings.picture_orthographic)
        self._view.show_tool_frame(wanted=settings.picture_tool_frame)
        self.view_actions["orthographic"].setChecked(settings.picture_orthographic)
        self.view_actions["tool_frame"].setChecked(settings.picture_tool_frame)
        self._name_trail()
        trail = self._trails.get(settings.picture_trail_s)
        if trail is not None:
            trail.setChecked(True)

    def _show_mode(self) -> None:

        self.view_actions["follow"].setChecked(self._view.mode is ViewMode.FOLLOW)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        for name, action in self.view_actions.items():
            shortcut = SHORTCUTS[f"view.{name}"]
            action.setText(shortcut.title.text())
            action.setToolTip(f"{action.text()}: {_TIPS.text(name)} ({shortcut.text()})")
        self._fit.setAccessibleName(self._fit.defaultAction().text())
        for kind, action in self._handles.items():
            action.setText(_HANDLES.text(kind))
        name, keys = self.tr("Drag the target in the picture"), SHORTCUTS["view.handles"].text()
        self._toggle_handles.setText(name)
        self._handles_menu.setTitle(name)
        describe(self._views, self.tr("Look from"))
        tip = self.tr(
            "Drags the target, or the chosen point, in the picture; the arm does not move. "
            "Ctrl: coarse steps, Shift: fine steps, Esc: give up"
        )
        describe(self._handles_button, name, f"{tip} ({keys})")
        self._name_trail()
        for length_s, action in self._trails.items():
            words = self.tr("Last {seconds} s of motion").format(seconds=length_s)
            action.setText(words if length_s else self.tr("Off"))
        describe(self._more, self.tr("View"), self.tr("Views, and what is drawn in the picture"))

    def show_tool(self, tool: Sequence[float]) -> None:
        """Name the trail after the tool in force, or after the flange."""
        self._of_tool = any(tool)
        self._name_trail()

    def _name_trail(self) -> None:
        """Name in the menu whose trail it is: that of the tool centre point or the flange."""
        way = (
            self.tr("Trail of the tool centre point")
            if self._of_tool
            else self.tr("Trail of the flange")
        )
        self._trail_menu.setTitle(way)

    def _recolor(self) -> None:
        color = colors_of(self).muted
        for name in _ICONS:
            self.view_actions[name].setIcon(icons.icon(f"view_{name}", color))
        self._views.setIcon(icons.icon("view_iso", color))
        self._handles_button.setIcon(icons.icon("drag_target", color))
        self._more.setIcon(icons.icon("view_more", color))


def _menu_button(name: str, menu: QMenu) -> QToolButton:
    """Return a button that opens a menu at once."""
    button = named(name, QToolButton())
    give_menu(button, menu)
    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    return button
