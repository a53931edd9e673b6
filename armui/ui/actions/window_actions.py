"""The commands of the main window without a button: palette, guide, theme, language, stops."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, QSize, Qt
from PySide6.QtWidgets import QAbstractButton, QDialog, QToolButton, QWidget

from armui.control.devices.motors import Motors
from armui.control.motion.joint_motion import Motion
from armui.control.operations.operation import operation_of
from armui.control.run.speed_override import STEP_PERCENT
from armui.control.safety.recovery_steps import Action, StepKind
from armui.ui.actions.command import Command, CommandSource, Target, also, new_action
from armui.ui.actions.keys import key_text, listen_for
from armui.ui.actions.palette import CommandPalette
from armui.ui.actions.palette_items import Callback, PaletteItems, lead_to, use
from armui.ui.actions.shortcut_list import ShortcutList
from armui.ui.guide.place import section_of
from armui.ui.shell.pages import PAGES
from armui.ui.theme import colors_of
from armui.ui.translation import shown_language
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import caption, enable_or_explain, reason_against
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.settings import SettingsStore
    from armui.ui.background import Background
    from armui.ui.shell.page_opener import PageOpener
    from armui.ui.shell.recovery_line import RecoveryLine
    from armui.ui.shell.step_row import StepRow


_ICON_PX: Final = 14
_HIGHEST_PX: Final = 20
"""The largest height of the button: that of the text beside it."""
_IN_THE_RUN_STRIP: Final = frozenset({StepKind.RUN_PAUSED, StepKind.RUN_WAITS})
"""The steps whose button is in the strip of the run, not in the line above the panels."""
_OPERATOR_VIEW: Final = "window.operator_view"
_NEXT_STEP: Final = "window.next_step"
_HELD_IN_THE_LINE: Final = {
    "window.resume": Action.RESUME,
    "window.come_inside": Action.COME_INSIDE,
}
"""The commands that are carried out by the button of the next step, while it is this step."""


# fmt: off
_COMMANDS: Final = (
    Command("everywhere.stop",
            synonyms=also("stop estop e-stop emo kill panic 停止 紧急停止 停机")),
    Command("everywhere.halt", Text("HaltButton", "Halt"),
            synonyms=also("stopping hold freeze brake 停下 停止运动 保持 刹车")),
    Command("everywhere.slower", synonyms=also("override speed reduce 倍率 降速 慢")),
    Command("everywhere.faster", synonyms=also("override speed increase 倍率 提速 快")),
    Command("window.resume", operation=operation_of(Motors.resume), risky=True,
            synonyms=also("recover restart resume reset 恢复 复位")),
    Command(_NEXT_STEP, Text("RecoveryLine", "Next step"),
            synonyms=also("fix help recover 怎么办")),
    Command("window.come_inside", operation=operation_of(Motion.come_inside),
            synonyms=also("rest pose limits outside 静置 限位外")),
    *(page.command for page in PAGES.values() if page.command and not page.beside_menu),
    Command("window.language", Text("Action", "Language: Chinese or English")),
    Command("window.theme", Text("Action", "Theme: light or dark"),
            synonyms=also("dark light night 深色 浅色 夜间")),
    Command(_OPERATOR_VIEW, Text("Action", "Operator's view: only jog, run and stop"),
            synonyms=also("lock unlock kiosk protect 锁定 解锁 操作员")),
    Command("everywhere.guide", Text("Action", "Help"),
            synonyms=also("manual help documentation font text size 帮助 手册 说明书 字体 字号")),
    Command("everywhere.shortcuts", Text("Action", "Keyboard shortcuts"),
            synonyms=also("keys hotkeys 热键")),
    Command("everywhere.full_screen", Text("Action", "Full screen"),
            synonyms=also("fullscreen maximize kiosk 最大化")),
    Command("window.close", Text("Action", "Close the program"),
            synonyms=also("quit exit shutdown 退出 关机")),
)
# fmt: on


class CommandsButton(Translated, QToolButton):
    """A button in the status bar that opens the command palette, and shows its key."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("commands_button")
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setMaximumHeight(_HIGHEST_PX)
        self.setIconSize(QSize(_ICON_PX, _ICON_PX))
        self.setProperty("quiet", True)
        self.retranslate_ui()
        self._recolor()

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        key = key_text("everywhere.palette")
        self.setText(key)
        self.setAccessibleName(self.tr("Commands"))
        text = self.tr("Find every function by its name")
        self.setToolTip(f"{text} ({key})")

    def _recolor(self) -> None:
        self.setIcon(icons.icon("search", colors_of(self).muted))


class LanguageButton(Translated, QToolButton):
    """A button in the status bar with the name of the other language, in that language.

    It is never hidden, so that somebody who cannot read the present language finds it.
    """

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("language_button")
        self.setMaximumHeight(_HIGHEST_PX)
        self.setProperty("quiet", True)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Show the name of the other language, in that language."""
        tip = self.tr("The other language; its font follows at the next start.")
        caption(self, "English" if shown_language() == "zh" else "中文", tip=tip)


class WindowActions(QObject):
    """Opens the command palette, the list of shortcuts and the guide, from every window.

    Args:
        window: The main window.
        controller: Stops the arm, and gives the reasons why something cannot be done.
        store: The operator's settings.
        background: Reads files.

    Attributes:
        button: Opens the command palette.
        language_button: Switches the language.
    """

    commands = _COMMANDS

    def __init__(
        self,
        window: QWidget,
        controller: ArmController,
        store: SettingsStore,
        background: Background,
    ) -> None:
        super().__init__(window)
        self._window = window
        self._controller = controller
        self._store = store
        self._background = background
        self._opened: dict[str, QDialog] = {}
        self.button = CommandsButton()
        self.button.clicked.connect(self.open_palette)
        self.language_button = LanguageButton()
        self.language_button.clicked.connect(self._switch_language)
        openers: dict[str, Callback] = {
            "palette": self.open_palette,
            "guide": self.open_guide,
            "shortcuts": self.open_shortcuts,
            "full_screen": self._switch_full_screen,
            "faster": lambda: controller.speed_override.step(STEP_PERCENT),
            "episode": controller.episodes.mark,
            "discard_episode": controller.episodes.discard,
        }
        everywhere = Qt.ShortcutContext.ApplicationShortcut
        for name, act in openers.items():
            listen_for(f"everywhere.{name}", window, act, everywhere).setAutoRepeat(False)

    def link(
        self,
        recovery: RecoveryLine,
        run: StepRow,
        pages: PageOpener,
        *,
        buttons: Mapping[str, QAbstractButton],
        lock: Callback,
    ) -> None:
        """Connect the actions to the parts of the window.

        Args:
            recovery: Takes the next step.
            run: Goes on with a run that pauses or waits.
            pages: Opens pages and windows.
            buttons: The buttons below the menu, by the names of their commands.
            lock: Enters the operator's view.
        """
        self._recovery, self._run, self._pages = recovery, run, pages
        opening = {
            page.command.name: partial(pages.show, key)
            for key, page in PAGES.items()
            if page.command is not None and not page.beside_menu
        }
        does: dict[str, Callback] = {
            "everywhere.stop": self._stop,
            "everywhere.halt": self._halt,
            "everywhere.slower": lambda: self._controller.speed_override.step(-STEP_PERCENT),
            "everywhere.faster": lambda: self._controller.speed_override.step(STEP_PERCENT),
            _NEXT_STEP: self._take_step,
            **opening,
            "window.language": self._switch_language,
            "window.theme": self._switch_theme,
            _OPERATOR_VIEW: lock,
            "everywhere.guide": self.open_guide,
            "everywhere.shortcuts": self.open_shortcuts,
            "everywhere.full_screen": self._switch_full_screen,
            "window.close": self._window.close,
        }
        actions = {name: new_action(self, do) for name, do in does.items()}
        self._targets: dict[str, Target] = {**actions, **buttons}
        self._next_step, self._lock = actions[_NEXT_STEP], actions[_OPERATOR_VIEW]

    def offer(
        self,
        sources: Callable[[], Sequence[CommandSource]],
        places: Mapping[str, Text],
        where: Callable[[], tuple[Iterable[QWidget | None], str]],
    ) -> None:
        """Set the contents of the palette, the list of shortcuts and the guide.

        Args:
            sources: Returns the commands of each part of the window.
            places: The titles of all places by their keys.
            where: Returns the pages in the window, and the key of its panel.
        """
        self._sources, self._places, self._where = sources, places, where

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each of its commands, by the command's name."""
        enable_or_explain(self._next_step, self._why_no_step())
        enable_or_explain(self._lock, self._why_no_lock())
        button, now = self._recovery.step_button, self._controller.recovery.step.action
        held = {name for name, action in _HELD_IN_THE_LINE.items() if action is now}
        return self._targets if button is None else {**self._targets, **dict.fromkeys(held, button)}

    def palette_items(self) -> PaletteItems:
        """Return the items of the palette."""
        return PaletteItems(self._controller, self._sources(), self._places)

    # -- windows ------------------------------------------------------------------------------

    def open_palette(self) -> None:
        """Show the command palette."""
        self._open(
            "palette",
            lambda: CommandPalette(
                self._controller, self.palette_items(), self._background, self._window
            ),
        )

    def open_shortcuts(self) -> None:
        """Show the list of all shortcuts."""
        self._open("shortcuts", lambda: ShortcutList(self._controller, self._places, self._window))

    def open_guide(self) -> None:
        """Show the section of the user guide on the place where the operator is."""
        self._pages.open_guide(section_of(*self._where()))

    def _open(self, name: str, make: Callable[[], QDialog]) -> None:
        if name not in self._opened:
            self._opened[name] = make()
        self._opened[name].open()

    # -- what has no button -------------------------------------------------------------------

    def _stop(self) -> None:
        self._controller.emergency_stop()

    def _halt(self) -> None:
        self._controller.halt_and_hold()

    def _step_button(self) -> QWidget | None:
        in_strip = self._controller.recovery.step.kind in _IN_THE_RUN_STRIP
        return self._run.go_on_button if in_strip else self._recovery.step_button

    def _take_step(self) -> None:
        button = self._step_button()
        if button is not None and button is self._run.go_on_button:
            # this button sets the arm moving: the key only focuses it, and a second press is needed
            lead_to(button)
        elif button is not None:
            use(button)

    def _why_no_step(self) -> str:
        button = self._step_button()
        if button is None:
            return self.tr("There is no next step now.")
        return reason_against(button)

    def _why_no_lock(self) -> str:
        open_editor = self._pages.existing("editor") is not None
        return self.tr("Close the trajectory editor first.") if open_editor else ""

    def _switch_language(self) -> None:
        self._store.change(language="en" if self._store.settings.language == "zh" else "zh")

    def _switch_full_screen(self) -> None:
        self._window.setWindowState(self._window.windowState() ^ Qt.WindowState.WindowFullScreen)

    def _switch_theme(self) -> None:
        self._store.change(theme="light" if self._store.settings.theme == "dark" else "dark")
