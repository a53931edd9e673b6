"""Opens pages by their keys, takes them out and puts them back, by the palette and at the start."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

from armui.ui.actions.command import (
    Command,
    CommandSource,
    Target,
    allow,
    new_action,
    source_of,
)
from armui.ui.actions.places import MOVABLE
from armui.ui.dialogs.about_arm import AboutArmDialog
from armui.ui.dialogs.base import ArmDialog
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.watch.joint_status_page import JointStatusPage
from armui.ui.watch.recordings.sessions_page import SessionsPage
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.ui.actions.palette_items import Callback
    from armui.ui.main_window import MainWindow
    from armui.ui.shell.diagnosis_dialogs import DiagnosisDialogs
    from armui.ui.shell.drawer import Drawer
    from armui.ui.shell.trajectory_pages import TrajectoryPages
    from armui.ui.shell.watch_windows import WatchWindows
    from armui.ui.shell.workspace import Workspace
    from armui.ui.widgets.page import Page


class PageActions(QObject):
    """The actions on pages and windows, with the reasons against them.

    Args:
        window: The main window.
        workspace: Manages the places of pages.
        pages: Opens the library and its pages.
        watch: Opens the drawer's pages and the recordings.
        drawer: The drawer that is closed.
        diagnosis: Opens the windows 诊断 and «About this arm».

    Attributes:
        startup_done: True when the windows open at the last end of the program have been reopened.
    """

    commands = (
        *(
            Command(f"{key}.{act}", title)
            for key in MOVABLE
            for act, title in (
                ("take_out", Text("PageBar", "Own window")),
                ("put_back", Text("PageWindow", "Put back")),
            )
        ),
        Command("drawer.fold", Text("Drawer", "Fold away")),
    )

    def __init__(
        self,
        window: MainWindow,
        workspace: Workspace,
        pages: TrajectoryPages,
        watch: WatchWindows,
        drawer: Drawer,
        *,
        diagnosis: DiagnosisDialogs,
    ) -> None:
        super().__init__(window)
        self._window = window
        self.startup_done = False
        self._workspace = workspace
        self._pages = pages
        self._drawer = drawer
        self._diagnosis = diagnosis
        self._openers: Mapping[str, Callback] = {
            "library": pages.open_library,
            "editor": pages.open_editor,
            "recording": pages.open_recorder,
            "plots": lambda: watch.show_as_curves(()),
            "events": watch.show_events,
            "bus": watch.open_bus_monitor,
            "sessions": watch.open_sessions,
            "connect": window.open_connect_dialog,
            "settings": window.open_settings_dialog,
            "joint_status": watch.open_joint_status,
            "guide": watch.open_guide,
            "help": watch.open_help,
            "about_arm": diagnosis.open_about_arm,
            "doctor": diagnosis.open_doctor,
            "report": diagnosis.open_report,
            "reference": diagnosis.open_reference_check,
            "about": diagnosis.open_about,
        }
        does: dict[str, Callback] = {"drawer.fold": drawer.fold}
        for key in MOVABLE:
            does[f"{key}.take_out"] = partial(self._take_out, key)
            does[f"{key}.put_back"] = partial(self._put_back, key)
        self._actions = {name: new_action(self, do) for name, do in does.items()}

    def command_targets(self) -> Mapping[str, Target]:
        """Return the actions that take pages out, put them back, and close the drawer."""
        for key in MOVABLE:
            allow(self._actions[f"{key}.take_out"], self._why_no_take_out(key))
            allow(self._actions[f"{key}.put_back"], self._why_no_put_back(key))
        allow(self._actions["drawer.fold"], self._why_no_fold())
        return self._actions

    def sources(self) -> list[CommandSource]:
        """Return the commands of each page and each window."""
        # loaded when nothing else is to be done, or here
        from armui.ui.dialogs.about import AboutDialog  # noqa: PLC0415
        from armui.ui.dialogs.doctor import DoctorDialog  # noqa: PLC0415
        from armui.ui.dialogs.problem_report import ProblemReportDialog  # noqa: PLC0415
        from armui.ui.dialogs.reference_check import ReferenceDialog  # noqa: PLC0415
        from armui.ui.trajectory.editor.editor_page import EditorPage  # noqa: PLC0415
        from armui.ui.trajectory.library.library_page import LibraryPage  # noqa: PLC0415
        from armui.ui.trajectory.recording.recording_page import RecordingPage  # noqa: PLC0415
        from armui.ui.watch.bus.bus_page import BusPage  # noqa: PLC0415
        from armui.ui.watch.events.event_page import EventPage  # noqa: PLC0415
        from armui.ui.watch.plots_area import PlotPage  # noqa: PLC0415

        kinds: dict[str, type[Page | ArmDialog]] = {
            "library": LibraryPage,
            "editor": EditorPage,
            "recording": RecordingPage,
            "plots": PlotPage,
            "events": EventPage,
            "bus": BusPage,
            "sessions": SessionsPage,
            "connect": ConnectDialog,
            "settings": SettingsDialog,
            "joint_status": JointStatusPage,
            "about_arm": AboutArmDialog,
            "doctor": DoctorDialog,
            "report": ProblemReportDialog,
            "reference": ReferenceDialog,
            "about": AboutDialog,
        }
        own = (
            CommandSource(
                *(kind.commands, partial(self._made, key), self._openers[key]),
                why_not=partial(self._why_not, key),
            )
            for key, kind in kinds.items()
        )
        return [*own, source_of(self)]

    def _made(self, key: str) -> Page | ArmDialog | None:
        """Return a page or window by its key; ``None``: it has not been made yet."""
        return self._page(key) or self._window.dialog(key) or self._diagnosis.dialog(key)

    def reopen(self) -> None:
        """Open what was open when the program ended: windows, the drawer; one in each turn.

        The main window is visible and its modules are loaded by then, so that the start is not
        delayed.
        """
        left = self._workspace.next_left_open()
        if left is None:
            self._workspace.note_windows()  # what is not there any more is forgotten
            self._window.activateWindow()
            self.startup_done = True
            return
        if left.key == "editor":
            self._pages.open_editor(left.subject)
        elif left.key in MOVABLE:
            focus = self._window.focusWidget() or self._window
            self._openers[left.key]()
            focus.setFocus()  # nobody asked for the page just now
        QTimer.singleShot(0, self, self.reopen)

    def _why_not(self, place: str) -> str:
        if place == "editor" and self._pages.editor is None:
            return self.tr("Open a trajectory of the library first.")
        return ""

    def _page(self, key: str) -> Page | None:
        """The page of a kind: of several editors the one that was used last."""
        return self._pages.editor if key == "editor" else self._workspace.page_of(key)

    def _is_out(self, key: str) -> bool:
        page = self._page(key)
        return page is not None and self._workspace.is_taken_out(page)

    def _take_out(self, key: str) -> None:
        self._openers[key]()
        page = self._page(key)
        if page is not None and not self._workspace.is_taken_out(page):
            self._workspace.take_out(page)

    def _put_back(self, key: str) -> None:
        page = self._page(key)
        if page is not None:
            self._workspace.put_back(page)

    def _why_no_take_out(self, key: str) -> str:
        if self._is_out(key):
            return self.tr("It is in its own window.")
        return self._why_not(key)

    def _why_no_put_back(self, key: str) -> str:
        return "" if self._is_out(key) else self.tr("It is not in its own window.")

    def _why_no_fold(self) -> str:
        return self.tr("The drawer is folded away.") if self._drawer.isHidden() else ""
