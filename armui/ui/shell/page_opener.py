"""Opens the pages and windows of :data:`armui.ui.shell.pages.PAGES`, and leads between them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject

from armui.control.sessions.session_recorder import SESSION_STARTED
from armui.ui.background import Background
from armui.ui.dialogs.online_since import OnlineSince
from armui.ui.shell.page_kinds import (
    doctor_dialog,
    event_page,
    export_dialog,
    guide_page,
    plot_page,
    replay_window,
)
from armui.ui.widgets.page import Page

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from concurrent.futures import Executor
    from pathlib import Path

    from PySide6.QtWidgets import QWidget

    from armui.arm.device import Device
    from armui.control.arm_controller import ArmController
    from armui.control.devices.joint_monitor import JointMonitor
    from armui.control.events import Event
    from armui.interface.interface import Interface
    from armui.settings import SettingsStore
    from armui.ui.dialogs.base import ArmDialog
    from armui.ui.dialogs.connect import Leaving
    from armui.ui.picture.target_drag import HandGuide
    from armui.ui.shell.drawer import Drawer
    from armui.ui.shell.page_entry import PageEntry
    from armui.ui.shell.status_bar import StatusBar
    from armui.ui.shell.trajectory_pages import TrajectoryPages
    from armui.ui.shell.workspace import Workspace
    from armui.viewport.view import ArmView

_EXAMINING: Final = ("doctor", "report", "reference")
"""The windows that examine something while they are open."""


class PageOpener(QObject):
    """Opens each page and window by its key, and creates it when it is first opened.

    Args:
        window: The main window.
        controller: Gives feedback and events.
        pages: The declarations of the pages and windows, by their keys.
        view: The 3D picture.
        joint_monitor: Gives the state of the joints.
        preferences: The operator's settings.
        background: Runs long work, and reads and writes files.
        workspace: Manages the places of pages.
        drawer: The place of the pages to watch.
        trajectories: As the attribute.
        files: Runs work that waits for the operating system.
        leave_arm_then: Leaves the arm; what is not saved asks first.
        hand: Gives access to the hand at the simulated arm of this program.
        interface: The local interface.

    Attributes:
        online: The time since the arm came online.
        trajectories: Creates the library and its pages.
    """

    def __init__(
        self,
        window: QWidget,
        controller: ArmController,
        *,
        pages: Mapping[str, PageEntry[PageOpener]],
        view: ArmView,
        joint_monitor: JointMonitor,
        preferences: SettingsStore,
        background: Background,
        workspace: Workspace,
        drawer: Drawer,
        trajectories: TrajectoryPages,
        files: Executor,
        leave_arm_then: Leaving,
        hand: Callable[[], HandGuide | None],
        interface: Interface,
    ) -> None:
        super().__init__(window)
        self.window: QWidget = window
        self.controller: ArmController = controller
        self.view: ArmView = view
        self.joint_monitor: JointMonitor = joint_monitor
        self.preferences: SettingsStore = preferences
        self.background: Background = background
        self.trajectories: TrajectoryPages = trajectories
        self.leave_arm_then: Leaving = leave_arm_then
        self.hand: Callable[[], HandGuide | None] = hand
        self.interface: Interface = interface
        self._pages = pages
        self.online = OnlineSince(controller, window)
        self._workspace, self._drawer, self._files = workspace, drawer, files
        self._windows: dict[str, ArmDialog] = {}
        self._bar: StatusBar | None = None

    def waiting(self) -> Background:
        """Return a new runner of work that waits for the operating system, for one window."""
        return Background(self._files, parent=self.window)

    # By their keys -----------------------------------------------------------------------------

    def show(self, key: str) -> None:
        """Show a page or window in front; it is created at the first time."""
        show = self._pages[key].show
        if show is None:
            self._shown(key)
        else:
            show(self)

    def existing(self, key: str) -> Page | ArmDialog | None:
        """Return a page or window if it has been created: of the editors the one used last."""
        if key == "editor":
            return self.trajectories.editor
        return self._workspace.page_of(key) or self._windows.get(key)

    def _shown(self, key: str) -> Page | ArmDialog:
        page = self._workspace.kept(key) or self._windows.get(key) or self._created(key)
        page.open()
        return page

    def _created(self, key: str) -> Page | ArmDialog:
        make = self._pages[key].make
        if make is None:
            raise KeyError(key)
        page = make(self)
        if isinstance(page, Page):
            self._workspace.keep(key, page, self._drawer)
        else:
            self._windows[key] = page
        return page

    # At something in them ----------------------------------------------------------------------

    def show_as_curves(self, keys: Sequence[str]) -> None:
        """Show quantities in the page 曲线, by their keys (`armui.telemetry.quantities`)."""
        page = self._shown("plots")
        if isinstance(page, plot_page()):
            page.add_curves(keys)

    def show_moment(self, at_s: float) -> None:
        """Show a monotonic time in the page 曲线 by its first cursor; no other page covers it."""
        page = self._shown("plots")
        if isinstance(page, Page):
            self._workspace.uncover(page)
        self.move_cursor(at_s)

    def move_cursor(self, at_s: float) -> None:
        """Move the first cursor of the curves to a monotonic time, where they are seen."""
        page = self._workspace.kept("plots")
        if page is not None and page.isVisible() and isinstance(page, plot_page()):
            page.show_moment(at_s)

    def show_events(self, number: int | None = None) -> None:
        """Show the page 事件, with one of its entries chosen."""
        page = self._shown("events")
        if isinstance(page, event_page()) and number is not None:
            page.show_entry(number)

    def open_guide(self, section: str = "") -> None:
        """Show the page 使用帮助, not covered by the window in which help was requested.

        Args:
            section: The section to show; by default the guide is as it was left.
        """
        before = self._workspace.kept("guide")
        reads = isinstance(before, guide_page()) and before.has_focus_inside
        page = self._shown("guide")
        if isinstance(page, guide_page()):
            if section:
                page.answer(section, reads=reads)
            self._workspace.uncover(page, for_now=True)

    def open_export(self, path: Path | None = None) -> None:
        """Show the window 导出, with a recording if one is given."""
        window = self._shown("export")
        if isinstance(window, export_dialog()) and path is not None:
            window.show_log(path)

    def replayed(self) -> Path | None:
        """Return the log that is open in the window 回放, or ``None``."""
        window = self._windows.get("replay")
        if window is None or not window.isVisible() or not isinstance(window, replay_window()):
            return None
        return window.log

    def open_replay(self, path: Path | None = None) -> None:
        """Show the window 回放, with a log if one is given; else the operator chooses it there."""
        window = self._shown("replay")
        if isinstance(window, replay_window()) and path is not None:
            window.open_log(path)

    def open_doctor(self, device: Device | None = None) -> None:
        """Show the faults of this computer, the bus and the arm.

        Args:
            device: The device that could not be connected; by default all devices.
        """
        window = self._windows.get("doctor") or self._created("doctor")
        if isinstance(window, doctor_dialog()):
            window.examine_device(device)

    # While the program runs --------------------------------------------------------------------

    def show_marks_in(self, bar: StatusBar) -> None:
        """Show the progress of recordings in the status bar, from the first recording on."""
        self._bar = bar
        self.controller.noticed.connect(self._on_noticed)

    def _on_noticed(self, event: Event) -> None:
        if event.notice == SESSION_STARTED and self._bar is not None:
            from armui.ui.watch.recordings.recording_card import (  # noqa: PLC0415 - for this mark
                RecordingMark,
            )

            bar, self._bar = self._bar, None
            mark = RecordingMark(self.controller.sessions, self.controller.episodes, bar)
            mark.clicked.connect(lambda: self.show("sessions"))
            bar.add_mark(mark)

    def close(self) -> None:
        """Cancel running examinations, because the program ends."""
        for key in _EXAMINING:
            if key in self._windows:
                self._windows[key].close()
