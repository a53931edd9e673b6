"""The windows that watch, remember and replay; made when they are first opened."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP
from PySide6.QtWidgets import QDialog, QWidget

from armui.ui.shell.watch_menu import WatchEntry

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.ui.background import Background

Opener = Callable[[str, Callable[[], QDialog]], QDialog]
"""Shows a dialog by its name, and makes it at the first time."""

# fmt: off
_BUTTONS: Final = (
    ("plots", QT_TRANSLATE_NOOP("WatchMenu", "Curves"),
     QT_TRANSLATE_NOOP(
         "WatchMenu",
         "What was heard and commanded in the last half hour. The right button on any figure "
         "shows it here.")),
    ("replay", QT_TRANSLATE_NOOP("WatchMenu", "Replay"),
     QT_TRANSLATE_NOOP(
         "WatchMenu",
         "Shows a recording, of this program or of another one, as if it were live.")),
)
# fmt: on
"""Icon, name and purpose of each window, row by row."""


class WatchWindows:
    """Opens them, and what one shows at the wish of another.

    Args:
        controller: Who knows what was heard and done.
        settings: The file of the operator's settings.
        background: Where what takes long is done, and files are read and written.
        window: The main window.
        open_window: How it shows a dialog.
        robot: The robot description that is shown; ``None``: the program's own.
    """

    def __init__(
        self,
        controller: ArmController,
        settings: Path,
        background: Background,
        window: QWidget,
        open_window: Opener,
        *,
        robot: Callable[[], Path | None] = lambda: None,
    ) -> None:
        self._controller = controller
        self._settings = settings
        self._background = background
        self._window = window
        self._open = open_window
        self._robot = robot

    def entries(self) -> tuple[WatchEntry, ...]:
        """The buttons below the menu."""
        openers: dict[str, Callable[[], object]] = {
            "plots": lambda: self.show_as_curves(()),
            "replay": self.open_replay,
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

    def open_replay(self, path: Path | None = None) -> None:
        """Show a log in the window 回放; without one the operator chooses there.

        Args:
            path: The log.
        """
        from armui.ui.watch.replay.replay_window import ReplayWindow  # noqa: PLC0415 - numpy
        from armui.viewport.view import ArmView  # noqa: PLC0415 - with the first log

        def make_view() -> ArmView:
            return ArmView(self._robot())

        def make() -> QDialog:
            return ReplayWindow(self._controller, self._background, make_view, self._window)

        window = self._open("replay", make)
        if isinstance(window, ReplayWindow) and path is not None:
            window.open_log(path)
