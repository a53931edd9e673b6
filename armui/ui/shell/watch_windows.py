"""The windows that watch, remember and replay; made when they are first opened."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final, Protocol, runtime_checkable

from PySide6.QtCore import QT_TRANSLATE_NOOP, QObject
from PySide6.QtWidgets import QDialog, QWidget

from armui.control.events import EventCode
from armui.ui.shell.watch_menu import WatchEntry

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.events import Event
    from armui.settings import SettingsStore
    from armui.ui.background import Background
    from armui.ui.shell.status_bar import StatusBar


@runtime_checkable
class _ShowsMoment(Protocol):
    def isVisible(self) -> bool: ...  # noqa: N802 - Qt's
    def show_moment(self, at_s: float) -> None: ...


Opener = Callable[[str, Callable[[], QDialog]], QDialog]
"""Shows a dialog by its name, and makes it at the first time."""

# fmt: off
_BUTTONS: Final = (
    ("plots", QT_TRANSLATE_NOOP("WatchMenu", "Curves"),
     QT_TRANSLATE_NOOP(
         "WatchMenu",
         "What was heard and commanded in the last half hour. The right button on any figure "
         "shows it here.")),
    ("events", QT_TRANSLATE_NOOP("WatchMenu", "Events"),
     QT_TRANSLATE_NOOP(
         "WatchMenu",
         "What happened: every command and what became of it, every change of the arm's status, "
         "every fault with its beginning and its end.")),
    ("bus", QT_TRANSLATE_NOOP("WatchMenu", "Bus"),
     QT_TRANSLATE_NOOP(
         "WatchMenu",
         "Every frame on the CAN bus: what it says, how often it comes, who sends it.")),
    ("sessions", QT_TRANSLATE_NOOP("WatchMenu", "Record"),
     QT_TRANSLATE_NOOP(
         "WatchMenu",
         "Record everything on the bus, save what just happened, replay what was recorded, here or "
         "by another program.")),
)
# fmt: on
"""Icon, name and purpose of each window, row by row."""


class WatchWindows(QObject):
    """Opens them, and what one shows at the wish of another.

    Args:
        controller: Who knows what was heard and done.
        settings: The file of the operator's settings.
        background: Where what takes long is done, and files are read and written.
        window: The main window.
        open_window: How it shows a dialog.
        store: The operator's settings.
        robot: The operator's own robot description; ``None``: the program's.
    """

    def __init__(
        self,
        controller: ArmController,
        settings: Path,
        background: Background,
        window: QWidget,
        open_window: Opener,
        *,
        store: SettingsStore,
        robot: Callable[[], str | None] = lambda: None,
    ) -> None:
        super().__init__(window)
        self._controller = controller
        self._settings = settings
        self._background = background
        self._window = window
        self._open = open_window
        self._store = store
        self._robot = robot
        self._bar: StatusBar | None = None

    def entries(self) -> tuple[WatchEntry, ...]:
        """The buttons below the menu."""
        openers: dict[str, Callable[[], object]] = {
            "plots": lambda: self.show_as_curves(()),
            "events": self.show_events,
            "bus": self.open_bus_monitor,
            "sessions": self.open_sessions,
        }
        return tuple(
            WatchEntry(key, str(title), str(tip), openers[key]) for key, title, tip in _BUTTONS
        )

    def show_as_curves(self, keys: Sequence[str]) -> None:
        """Show quantities in the window 曲线, by their keys (`armui.telemetry.quantities`)."""
        from armui.ui.watch.plot_window import PlotWindow  # noqa: PLC0415 - pyqtgraph, numpy

        def make() -> QDialog:
            return PlotWindow(self._controller, self._background, self._settings, self._window)

        window = self._open("plots", make)
        if isinstance(window, PlotWindow):
            window.add_curves(keys)

    def open_export(self, path: Path | None = None) -> None:
        """Show the window 导出, with a recording if one is given."""
        from armui.ui.watch.export_dialog import ExportDialog  # noqa: PLC0415 - faster start

        window = self._open("export", lambda: ExportDialog(self._controller, self._window))
        if isinstance(window, ExportDialog) and path is not None:
            window.show_log(path)

    def show_events(self, number: int | None = None) -> None:
        """Show the window 事件, with one of its entries chosen."""
        from armui.ui.watch.events.event_window import EventWindow  # noqa: PLC0415 - faster start

        def make() -> QDialog:
            window = EventWindow(self._controller, self._background, self._window)
            window.moment_chosen.connect(self._move_cursor)
            window.moment_wanted.connect(self.show_moment)
            return window

        window = self._open("events", make)
        if isinstance(window, EventWindow) and number is not None:
            window.show_entry(number)

    def show_moment(self, at_s: float) -> None:
        """Show the window 曲线, its first cursor at a monotonic time."""
        self.show_as_curves(())
        self._move_cursor(at_s)

    def _move_cursor(self, at_s: float) -> None:
        """In the curves, where they are seen."""
        for plots in self._window.findChildren(QDialog, "plot_window"):
            if isinstance(plots, _ShowsMoment) and plots.isVisible():
                plots.show_moment(at_s)

    def open_bus_monitor(self) -> None:
        """Show the window 总线."""

        def make() -> QDialog:
            from armui.ui.watch.bus.bus_window import BusWindow  # noqa: PLC0415 - numpy, cantools

            return BusWindow(self._controller, self._window)

        self._open("bus", make)

    def open_sessions(self) -> None:
        """Show the window 会话记录."""
        from armui.ui.watch.recordings.sessions_window import SessionsWindow  # noqa: PLC0415 - faster start

        def make() -> QDialog:
            window = SessionsWindow(self._controller, self._background, self._store, self._window)
            window.open_wanted.connect(self.open_replay)
            window.other_wanted.connect(self.open_replay)
            window.export_wanted.connect(self.open_export)
            return window

        self._open("sessions", make)

    def show_marks_in(self, bar: StatusBar) -> None:
        """Have the status bar show what goes on of them; made with the first recording."""
        self._bar = bar
        self._controller.noticed.connect(self._on_noticed)

    def _on_noticed(self, event: Event) -> None:
        if event.code == EventCode.SESSION_STARTED and self._bar is not None:
            from armui.ui.watch.recordings.recording_mark import RecordingMark  # noqa: PLC0415 - as above

            bar, self._bar = self._bar, None
            mark = RecordingMark(self._controller.sessions, bar)
            mark.clicked.connect(self.open_sessions)
            bar.add_mark(mark)

    def open_replay(self, path: Path | None = None) -> None:
        """Show a log in the window 回放; without one the operator chooses there.

        Args:
            path: The log.
        """
        from armui.ui.watch.replay.replay_window import ReplayWindow  # noqa: PLC0415 - numpy
        from armui.viewport.view import ArmView  # noqa: PLC0415 - with the first log

        def make_view() -> ArmView:
            own = self._robot()
            return ArmView(Path(own) if own else None)

        def make() -> QDialog:
            from armui.session.recording.recorded_session import RecordedSession  # noqa: PLC0415 - as above

            return ReplayWindow(
                self._controller,
                self._background,
                make_view,
                self._window,
                open_own=RecordedSession,
                urdf_path=self._robot(),
            )

        window = self._open("replay", make)
        if isinstance(window, ReplayWindow) and path is not None:
            window.open_log(path)
