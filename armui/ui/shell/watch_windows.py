"""The pages of the drawer, and the windows for replay and export; created when first opened."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final, Protocol

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from armui.control.sessions.session_recorder import SESSION_STARTED
from armui.ui.actions.command import Command, also
from armui.ui.actions.places import PLACES
from armui.ui.dialogs.base import ArmDialog
from armui.ui.guide.guide_page import GuidePage
from armui.ui.guide.help_page import HelpPage
from armui.ui.shell.drawer import DrawerEntry
from armui.ui.shell.side_menu import WatchEntry
from armui.ui.watch.joint_status_page import JointStatusPage
from armui.ui.watch.recordings.recording_card import RecordingMark
from armui.ui.watch.recordings.sessions_page import SessionsPage
from armui.ui.words.text import Text
from armui.viewport.view import ArmView

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.devices.joint_monitor import JointMonitor
    from armui.control.events import Event
    from armui.settings import SettingsStore
    from armui.ui.background import Background
    from armui.ui.shell.status_bar import StatusBar
    from armui.ui.watch.plots_area import PlotPage
    from armui.ui.widgets.page import Page


Opener = Callable[[str, Callable[[], ArmDialog]], ArmDialog]
"""Shows a dialog by its name, creating it the first time."""

PageOpener = Callable[[str, Callable[[], "Page"]], "Page"]
"""Shows a page by its name, creating it the first time."""


class Uncover(Protocol):
    """Brings a page in front of the windows that lie over it."""

    def __call__(self, page: Page, *, for_now: bool = False) -> object:
        """Give it a window, for now or from now on, if one lies over it."""


# fmt: off
_BUTTONS: Final = (
    ("plots", Text("WatchMenu", "Curves"),
     Text("WatchMenu",
          "Feedback and commands of the last half hour. Right-click any figure to show it here."),
     also("chart graph plot scope 图表 示波器")),
    ("events", Text("WatchMenu", "Events"),
     Text("WatchMenu",
          "What happened: every command and its result, every change of the arm's status, "
          "every fault with its beginning and end."),
     also("log messages alarms 日志 报警 消息")),
    ("bus", Text("WatchMenu", "Bus"),
     Text("WatchMenu",
          "Every frame on the CAN bus: what it says, how often it comes, who sends it."),
     also("can frames monitor sniffer 报文 帧")),
    ("sessions", Text("WatchMenu", "Record"),
     Text("WatchMenu",
          "Record everything on the bus, save what just happened, replay what was recorded, here "
          "or by another program."),
     also("logs history 日志 录制")),
)
_TABS: Final = (
    ("joint_status", Text("JointStatusPage", "Joint status"),
     Text("WatchMenu", "What each joint says of itself: temperature, current, voltage, faults.")),
    ("guide", Text("WatchMenu", "Guide"),
     Text("WatchMenu", "How to use the program; F1 opens it at the place where you are.")),
    ("help", Text("WatchMenu", "Help"),
     Text("WatchMenu", "Mouse, keys and figures of the 3D picture.")),
)
# fmt: on
"""Key, title and purpose of the pages of the drawer; those of the buttons have other names, too."""


class WatchWindows(QObject):
    """Opens these windows, and connects them with each other.

    Args:
        controller: Gives feedback and events.
        joint_monitor: Gives the state of the joints.
        settings: The file of the operator's settings.
        background: Runs long work, and reads and writes files.
        window: The main window.
        open_window: Shows a dialog.
        open_page: Shows a page of the drawer.
        uncover: Brings a page in front of windows that cover it.
        store: The operator's settings.
        robot: The operator's own robot description; ``None`` for the program's.
    """

    def __init__(
        self,
        controller: ArmController,
        joint_monitor: JointMonitor,
        settings: Path,
        background: Background,
        window: QWidget,
        *,
        open_window: Opener,
        open_page: PageOpener,
        uncover: Uncover,
        store: SettingsStore,
        robot: Callable[[], str | None] = lambda: None,
    ) -> None:
        super().__init__(window)
        self._controller = controller
        self._joint_monitor = joint_monitor
        self._settings = settings
        self._background = background
        self._window = window
        self._open = open_window
        self._open_page = open_page
        self._uncover = uncover
        self._plots: PlotPage | None = None
        self._guide: GuidePage | None = None
        self._store = store
        self._robot = robot
        self._bar: StatusBar | None = None

    def entries(self) -> tuple[WatchEntry, ...]:
        """Return the buttons below the menu."""
        openers: dict[str, Callable[[], object]] = {
            "plots": lambda: self.show_as_curves(()),
            "events": self.show_events,
            "bus": self.open_bus_monitor,
            "sessions": self.open_sessions,
        }
        return tuple(
            WatchEntry(
                *(key, title, tip, openers[key]),
                Command(f"{key}.open", PLACES[key], synonyms=synonyms),
            )
            for key, title, tip, synonyms in _BUTTONS
        )

    def pages(self) -> tuple[DrawerEntry, ...]:
        """Return the pages of the drawer: those with a button below the menu, and the others."""
        openers: dict[str, Callable[[], object]] = {
            "joint_status": self.open_joint_status,
            "guide": self.open_guide,
            "help": self.open_help,
        }
        buttons = [
            DrawerEntry(each.key, each.title, each.tip, each.open_page) for each in self.entries()
        ]
        others = [DrawerEntry(key, title, tip, openers[key]) for key, title, tip in _TABS]
        return (*buttons, *others)

    def show_as_curves(self, keys: Sequence[str]) -> None:
        """Show quantities in the page 曲线, by their keys (`armui.telemetry.quantities`)."""
        from armui.ui.watch.plots_area import PlotPage  # noqa: PLC0415 - pyqtgraph, numpy

        def make() -> Page:
            self._plots = PlotPage(self._controller, self._background, self._settings)
            return self._plots

        self._open_page("plots", make)
        if self._plots is not None:
            self._plots.add_curves(keys)

    def open_export(self, path: Path | None = None) -> None:
        """Show the window 导出, with a recording if one is given."""
        from armui.ui.watch.export_dialog import ExportDialog  # noqa: PLC0415 - cantools

        window = self._open("export", lambda: ExportDialog(self._controller, self._window))
        if isinstance(window, ExportDialog) and path is not None:
            window.show_log(path)

    def show_events(self, number: int | None = None) -> None:
        """Show the page 事件, with one of its entries chosen."""
        from armui.ui.watch.events.event_page import EventPage  # noqa: PLC0415 - cantools

        def make() -> Page:
            page = EventPage(self._controller, self._background)
            page.moment_chosen.connect(self._move_cursor)
            page.moment_wanted.connect(self.show_moment)
            return page

        page = self._open_page("events", make)
        if isinstance(page, EventPage) and number is not None:
            page.show_entry(number)

    def show_moment(self, at_s: float) -> None:
        """Show a monotonic time in the page 曲线 by its first cursor; no other page covers it."""
        self.show_as_curves(())
        if self._plots is not None:
            self._uncover(self._plots)
        self._move_cursor(at_s)

    def _move_cursor(self, at_s: float) -> None:
        """In the curves, where they are seen."""
        if self._plots is not None and self._plots.isVisible():
            self._plots.show_moment(at_s)

    def open_bus_monitor(self) -> None:
        """Show the page 总线."""

        def make() -> Page:
            from armui.ui.watch.bus.bus_page import BusPage  # noqa: PLC0415 - numpy, cantools

            return BusPage(self._controller)

        self._open_page("bus", make)

    def open_sessions(self) -> None:
        """Show the page 会话记录."""

        def make() -> Page:
            page = SessionsPage(self._controller, self._background, self._store)
            page.open_wanted.connect(self.open_replay)
            page.other_wanted.connect(self.open_replay)
            page.export_wanted.connect(self.open_export)
            return page

        self._open_page("sessions", make)

    def open_joint_status(self) -> None:
        """Show the page 关节状态 (manual 1.0.10)."""
        self._open_page(
            "joint_status", lambda: JointStatusPage(self._controller, self._joint_monitor)
        )

    def open_guide(self, section: str = "") -> None:
        """Show the page 使用指南; the window it was asked for in does not cover it.

        Args:
            section: The section to show; by default the guide is as it was left.
        """
        reads = self._guide is not None and self._guide.has_focus_inside

        def make() -> Page:
            self._guide = GuidePage(self._background)
            return self._guide

        self._open_page("guide", make)
        if self._guide is not None:
            if section:
                self._guide.answer(section, reads=reads)
            self._uncover(self._guide, for_now=True)

    def open_help(self) -> None:
        """Show the page 使用帮助: how the 3D picture is used."""
        self._open_page("help", HelpPage)

    def show_marks_in(self, bar: StatusBar) -> None:
        """Show the progress of recordings in the status bar, from the first recording on."""
        self._bar = bar
        self._controller.noticed.connect(self._on_noticed)

    def _on_noticed(self, event: Event) -> None:
        if event.notice == SESSION_STARTED and self._bar is not None:
            bar, self._bar = self._bar, None
            mark = RecordingMark(self._controller.sessions, bar)
            mark.clicked.connect(self.open_sessions)
            bar.add_mark(mark)

    def open_replay(self, path: Path | None = None) -> None:
        """Show a log in the window 回放; without one the operator chooses it there.

        Args:
            path: The log.
        """
        from armui.ui.watch.replay.replay_window import ReplayWindow  # noqa: PLC0415 - numpy

        def make_view() -> ArmView:
            own = self._robot()
            return ArmView(Path(own) if own else None)

        def make() -> ArmDialog:
            from armui.session.recording.recorded_session import RecordedSession  # noqa: PLC0415 - as above

            window = ReplayWindow(
                self._controller,
                self._background,
                make_view,
                self._window,
                open_own=RecordedSession,
                urdf_path=self._robot(),
            )
            window.export_wanted.connect(self.open_export)
            return window

        window = self._open("replay", make)
        if isinstance(window, ReplayWindow) and path is not None:
            window.open_log(path)
