"""Of the main window: the keys that count in every window, and what they open."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QApplication, QDialog, QWidget

from armui.control.run.speed_override import STEP_PERCENT
from armui.control.safety.recovery_steps import StepKind
from armui.ui.actions.commands_button import CommandsButton
from armui.ui.actions.keys import listen_for
from armui.ui.shell.first_steps import FirstSteps

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.settings import SettingsStore
    from armui.ui.actions.offer import Doing, Doings
    from armui.ui.background import Background
    from armui.ui.main_window import MainWindow
    from armui.ui.picture.picture_work import PictureWork
    from armui.ui.shell.diagnosis_dialogs import DiagnosisDialogs
    from armui.ui.shell.page_actions import PageActions
    from armui.ui.shell.recovery_line import RecoveryLine
    from armui.ui.shell.watch_windows import WatchWindows
    from armui.ui.shell.work_area import RunPlace


_IN_THE_RUN_STRIP: Final = frozenset({StepKind.RUN_PAUSED, StepKind.RUN_WAITS})
"""The steps that the line above the panels has no button for."""


class WindowActions(QObject):
    """Opens the command palette, the list of shortcuts and the guide, from every window.

    Args:
        window: The main window.
        controller: Who stops, and knows why something cannot be done.
        store: The operator's settings.
        background: Where files are read.
    """

    def __init__(
        self,
        window: MainWindow,
        controller: ArmController,
        store: SettingsStore,
        background: Background,
    ) -> None:
        super().__init__(window)
        self._window = window
        self._controller = controller
        self._store = store
        self._background = background
        self._doings: dict[str, Doing] = {}
        self._opened: dict[str, QDialog] = {}
        self._pages: PageActions | None = None
        FirstSteps(window, controller, store)
        self._button = CommandsButton()
        self._button.clicked.connect(self.open_palette)
        openers: dict[str, Doing] = {
            "palette": self.open_palette,
            "guide": self.open_guide,
            "shortcuts": self.open_shortcuts,
            "faster": self._go_faster,
        }
        everywhere = Qt.ShortcutContext.ApplicationShortcut
        for name, act in openers.items():
            listen_for(f"everywhere.{name}", window, act, everywhere).setAutoRepeat(False)

    def lead_to(
        self,
        show_panel: Callable[[str], object],
        ask_to_resume: Callable[[], object],
        recovery: RecoveryLine,
        run: RunPlace,
    ) -> None:
        """Take in what the parts of the window do.

        Args:
            show_panel: Goes to a panel, by its key.
            ask_to_resume: Asks whether to end the emergency stop.
            recovery: Takes the next step.
            run: Goes on with a run that pauses or waits.
        """
        self._show_panel, self._ask_to_resume = show_panel, ask_to_resume
        self._recovery, self._run = recovery, run

    def offer(
        self,
        diagnosis: DiagnosisDialogs,
        watch: WatchWindows,
        picture: PictureWork,
        pages: PageActions,
    ) -> CommandsButton:
        """Offer what these windows do and no button in the main window; the palette's button."""
        self._doings |= {
            "window.diagnosis": diagnosis.open_doctor,
            "window.about_arm": diagnosis.open_about_arm,
            "window.export": watch.open_export,
            "replay.open": watch.open_replay,
            **picture.doings(),
        }
        self._pages = pages
        return self._button

    # -- windows ------------------------------------------------------------------------------

    def open_palette(self) -> None:
        """Show the command palette."""

        def make() -> QDialog:
            from armui.ui.actions.offer import Offers  # noqa: PLC0415 - faster start
            from armui.ui.actions.palette import CommandPalette  # noqa: PLC0415 - as above

            openers = {} if self._pages is None else self._pages.openers()
            offers = Offers(
                *(self._window, self._controller, self._all_doings(), openers, self._show_panel)
            )
            return CommandPalette(self._controller, offers, self._background, self._window)

        self._open("palette", make)

    def open_shortcuts(self) -> None:
        """Show the list of all shortcuts."""

        def make() -> QDialog:
            from armui.ui.actions.shortcut_list import ShortcutList  # noqa: PLC0415 - faster start

            return ShortcutList(self._controller, self._window)

        self._open("shortcuts", make)

    def open_guide(self) -> None:
        """Show the user guide at the place where the operator is."""
        from armui.ui.guide.guide_window import GuideWindow  # noqa: PLC0415 - faster start
        from armui.ui.guide.place import section_of  # noqa: PLC0415 - as above

        if isinstance(QApplication.activeWindow(), GuideWindow):
            return
        section = section_of(self._window)
        window = self._open(
            "guide", lambda: GuideWindow(self._controller, self._background, self._window)
        )
        if isinstance(window, GuideWindow):
            window.show_section(section)

    def _open(self, name: str, make: Callable[[], QDialog]) -> QDialog:
        if name not in self._opened:
            self._opened[name] = make()
        self._opened[name].open()
        return self._opened[name]

    # -- what has no button -------------------------------------------------------------------

    def _all_doings(self) -> Doings:
        """By name: what does it, and why that is not possible now."""
        own: dict[str, tuple[Doing, Callable[[], str]]] = {
            "everywhere.stop": (self._controller.emergency_stop, _always),
            "everywhere.halt": (self._controller.halt_and_hold, _always),
            "everywhere.slower": (self._go_slower, _always),
            "everywhere.faster": (self._go_faster, _always),
            "everywhere.guide": (self.open_guide, _always),
            "everywhere.shortcuts": (self.open_shortcuts, _always),
            "window.resume": (self._ask_to_resume, _always),
            "window.next_step": (self._take_step, self._why_no_step),
            "window.language": (self._switch_language, _always),
            "window.theme": (self._switch_theme, _always),
            "window.close": (self._window.close, _always),
            "window.backup": (self._window.open_backup_dialog, _always),
        }
        simple = {name: (do, _always) for name, do in self._doings.items()}
        return {**simple, **own, **({} if self._pages is None else self._pages.doings())}

    def _step_button(self) -> QWidget | None:
        in_strip = self._controller.recovery.step.kind in _IN_THE_RUN_STRIP
        return self._run.go_on_button if in_strip else self._recovery.step_button

    def _take_step(self) -> None:
        from armui.ui.actions.offer import lead_to, use  # noqa: PLC0415 - faster start

        button = self._step_button()
        if button is not None and button is self._run.go_on_button:
            lead_to(button)  # it sets the arm moving: with a press of its own
        elif button is not None:
            use(button)

    def _why_no_step(self) -> str:
        button = self._step_button()
        if button is None:
            return self.tr("There is no next step now.")
        return "" if button.isEnabled() else button.toolTip()

    def _go_slower(self) -> None:
        self._controller.speed_override.step(-STEP_PERCENT)

    def _go_faster(self) -> None:
        self._controller.speed_override.step(STEP_PERCENT)

    def _switch_language(self) -> None:
        self._store.change(language="en" if self._store.settings.language == "zh" else "zh")

    def _switch_theme(self) -> None:
        self._store.change(theme="light" if self._store.settings.theme == "dark" else "dark")


def _always() -> str:
    return ""
