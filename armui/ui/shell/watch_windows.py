"""The windows for monitoring, recording and replay; created when they are first opened."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from armui.control.sessions.session_recorder import SESSION_STARTED
from armui.ui.actions.command import Command, also
from armui.ui.actions.places import PLACES
from armui.ui.dialogs.base import ArmDialog
from armui.ui.shell.side_menu import WatchEntry
from armui.ui.watch.recordings.recording_card import RecordingMark
from armui.ui.watch.recordings.sessions_window import SessionsWindow
from armui.ui.words.text import Text
from armui.viewport.view import ArmView

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
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

_PAGES: Final = ("plots", "events", "bus")
"""The ones that are pages of the drawer; the others are windows."""

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
# fmt: on
"""Icon, name, purpose and other names of each window, row by row."""


class WatchWindows(QObject):
    """Opens these windows, and connects them with each other.

    Args:
        controller: Gives feedback and events.
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
        settings: Path,
        background: Background,
        window: QWidget,
        *,
        open_window: Opener,
        open_page: PageOpener,
        uncover: Callable[[Page], object],
        store: SettingsStore,
        robot: Callable[[], str | None] = lambda: None,
    ) -> None:
        super().__init__(window)
        self._controller = controller
        self._settings = settings
        self._background = background
        self._window = window
        self._open = open_window
        self._open_page = open_page
        self._uncover = uncover
        self._plots: PlotPage | None = None
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

    def pages(self) -> tuple[WatchEntry, ...]:
        """Return the entries that are pages of the drawer."""
        return tuple(entry for entry in self.entries() if entry.key in _PAGES)

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
        """Show the window 会话记录."""

        def make() -> ArmDialog:
            window = SessionsWindow(self._controller, self._background, self._store, self._window)
            window.open_wanted.connect(self.open_replay)
            window.other_wanted.connect(self.open_replay)
            window.export_wanted.connect(self.open_export)
            return window

        self._open("sessions", make)

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
