"""Pictures of the whole program: ``python -m tests.gallery DIR``; needs no display.

Writes a PNG of the main window in every state, of each panel and of each dialog, in both languages
and both themes, the window in two sizes. The program is the real one, the arm the simulated one;
its clock stands still while a picture is taken.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import (
    QDeadlineTimer,
    QEventLoop,
    QMessageLogContext,
    QTimer,
    QtMsgType,
    qInstallMessageHandler,
)
from PySide6.QtGui import QFontDatabase, QPixmap
from PySide6.QtWidgets import QApplication, QWidget

from armui.protocol.generation import Generation
from armui.ui.operation_area import OperationArea
from tests.desk import Desk
from tests.gallery_scenes import DIALOG_SCENES, WINDOW_SCENES
from tests.gallery_scenes.scene import close_dialogs

LANGUAGES = ("zh", "en")
THEMES = ("light", "dark")
SIZES = ((1280, 800), (1920, 1080))

_AT_REST_MS = 300
_LOOK_MS = 50
_LONGEST_MS = 20_000


class Gallery:
    """Takes the pictures.

    Args:
        desk: The program.
        folder: Where the pictures go.
    """

    def __init__(self, desk: Desk, folder: Path) -> None:
        self._desk = desk
        self._folder = folder
        self.count = 0
        self._drawn = False
        desk.program.view.first_frame_shown.connect(self._on_drawn)

    def run(self) -> None:
        """Take every picture."""
        self._wait_for_3d()
        for scene in WINDOW_SCENES:
            scene.play(self._desk)
            self._take_window(scene.name)
            if scene.name == "moving":
                self._take_panels(scene.name)
            for dialog in DIALOG_SCENES:
                if dialog.during == scene.name:
                    for look in self._looks():
                        opened = dialog.open(self._desk)
                        _let_work()
                        self._save(opened.grab(), f"dialog-{dialog.name}-{look}")
                        close_dialogs()

    def _on_drawn(self) -> None:
        self._drawn = True

    def _wait_for_3d(self) -> None:
        """Until the arm is on the screen; a computer that can't draw it shows why."""
        longest = QDeadlineTimer(_LONGEST_MS)
        while not (self._drawn or longest.hasExpired()):
            _let_work()

    def _looks(self) -> Iterator[str]:
        """Switch through languages and themes, while the program runs."""
        for language in LANGUAGES:
            for theme in THEMES:
                self._desk.store.change(language=language, theme=theme)
                QApplication.processEvents()
                yield f"{language}-{theme}"

    def _take_window(self, name: str) -> None:
        window = self._desk.window
        for size in SIZES:
            window.resize(*size)
            for look in self._looks():
                picture = _at_rest(window)
                self._save(picture, f"window-{name}-{look}-{size[0]}x{size[1]}")
        window.resize(*SIZES[0])

    def _take_panels(self, name: str) -> None:
        for look in self._looks():
            for panel, widget in _panels(self._desk.window).items():
                self._save(_at_rest(widget), f"panel-{panel}-{name}-{look}")

    def _save(self, picture: QPixmap, name: str) -> None:
        path = self._folder / f"{name}.png"
        if not picture.save(str(path)):
            raise OSError(f"could not write {path}")
        self.count += 1


def _let_work() -> None:
    """Let Qt and the other threads work for a moment (QTest.qWait would keep Python's lock)."""
    loop = QEventLoop()
    QTimer.singleShot(_LOOK_MS, loop.quit)
    loop.exec()


def _at_rest(widget: QWidget) -> QPixmap:
    """A picture of a widget once it no longer changes: the 3D view draws in another thread."""
    last = widget.grab()
    longest, unchanged = QDeadlineTimer(_LONGEST_MS), QDeadlineTimer(_AT_REST_MS)
    while not (unchanged.hasExpired() or longest.hasExpired()):
        _let_work()
        now = widget.grab()
        if now.toImage() != last.toImage():
            last, unchanged = now, QDeadlineTimer(_AT_REST_MS)
    return last


def _panels(window: QWidget) -> dict[str, QWidget]:
    """The panels of the operation area by their names."""
    area = window.findChild(OperationArea, "operation_area")
    return {type(panel).__name__.removesuffix("Panel").lower(): panel for panel in area.panels}


def _pass_on(kind: QtMsgType, context: QMessageLogContext, message: str) -> None:
    """Qt's messages, but for the off-screen platform's regret that it has no window manager."""
    if not message.startswith("This plugin does not support"):
        print(f"{kind.name}: {message}", file=sys.stderr)


def _warn_about_fonts() -> None:
    if not QFontDatabase.families(QFontDatabase.WritingSystem.SimplifiedChinese):
        print(
            "gallery: no font with Chinese characters is installed; on Debian: "
            "apt install fonts-noto-cjk",
            file=sys.stderr,
        )


def main() -> int:
    """Read the command line and take the pictures; the exit code."""
    parser = argparse.ArgumentParser(prog="python -m tests.gallery", description=__doc__)
    parser.add_argument("folder", type=Path, metavar="DIR", help="where the pictures go")
    folder = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    qInstallMessageHandler(_pass_on)
    app = QApplication(sys.argv[:1])
    _warn_about_fonts()
    with tempfile.TemporaryDirectory() as settings:
        desk = Desk(app, "gallery", Path(settings) / "settings.json", Generation.TWO, draws=True)
        gallery = Gallery(desk, folder)
        try:
            gallery.run()
        finally:
            desk.close()
    print(f"{gallery.count} pictures in {folder}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
