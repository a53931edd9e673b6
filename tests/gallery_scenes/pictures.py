"""Takes the pictures of one scene: a program that has just opened, played to its state."""

from __future__ import annotations

import datetime as dt
import itertools
import multiprocessing.util
import os
import sys
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any, Final

from PySide6.QtCore import (
    QCoreApplication,
    QDeadlineTimer,
    QEvent,
    QEventLoop,
    QMessageLogContext,
    QTimer,
    QtMsgType,
    qInstallMessageHandler,
)
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication, QWidget

from armui.protocol.generation import Generation
from armui.setting_checks import Language, ThemeName
from armui.ui.shell.operation_area import OperationArea
from armui.viewport.client import PictureClient
from armui.viewport.viewpoint import ViewMode
from tests.app_driver import AppDriver
from tests.gallery_scenes import DIALOG_SCENES, WINDOW_SCENES
from tests.gallery_scenes.scene import DialogScene, Scene, close_dialogs

_NOON: Final = dt.datetime(2026, 1, 15, 12, 0)

_QUALITY: Final = 80
"""Of a PNG: how little time is taken to make the file small; nothing is lost."""
_LOOK_MS: Final = 20
_LONGEST_MS: Final = 60_000


@dataclass(frozen=True)
class Looks:
    """How each scene is shown.

    Attributes:
        languages, themes: Every pair of them.
        sizes: Of the window, in pixels.
    """

    languages: tuple[Language, ...] = ("zh", "en")
    themes: tuple[ThemeName, ...] = ("light", "dark")
    sizes: tuple[tuple[int, int], ...] = ((1280, 800), (1920, 1080))


def prepare(scale: int = 1) -> None:
    """Make Qt ready in this process, with a clock that stands still and a caret that is steady.

    Args:
        scale: Device pixels a logical pixel.
    """
    if scale != 1:
        os.environ["QT_SCALE_FACTOR"] = str(scale)
    qInstallMessageHandler(_pass_on)
    app = QApplication(sys.argv[:1])
    app.setCursorFlashTime(0)
    # kept by the module: Qt ends with the last reference
    globals()["_app"] = app
    # one process draws for all scenes: starting one takes a second
    globals()["_drawn_by"] = client = PictureClient()
    multiprocessing.util.Finalize(None, client.stop, exitpriority=100)


def take(scene: Scene | DialogScene, folder: Path, looks: Looks) -> int:
    """Play a scene on a program of its own and write its pictures.

    Args:
        scene: What to show.
        folder: Where the pictures go.
        looks: How.

    Returns:
        The number of pictures.

    Raises:
        Exception: Whatever went wrong in the scene, or in a slot of Qt meanwhile.
    """
    with opened(scene.name, draws=isinstance(scene, Scene)) as app_driver:
        if isinstance(scene, Scene):
            return _WindowPictures(app_driver, folder, looks).take(scene)
        return _take_dialog(app_driver, scene, folder, looks)


@contextmanager
def opened(name: str, *, draws: bool) -> Iterator[AppDriver]:
    """A program that has just opened, with settings and a library of its own.

    Args:
        name: Of what is shown; no other that is open has it.
        draws: Whether the arm is drawn in 3D.

    Raises:
        Exception: Whatever went wrong meanwhile in a slot of Qt.
    """
    app = QApplication.instance()
    assert isinstance(app, QApplication), "call prepare() first"
    _stop_the_clock()
    with tempfile.TemporaryDirectory() as settings, _SlotErrors() as errors:
        file = Path(settings) / "settings.json"
        pictures = globals()["_drawn_by"]
        app_driver = AppDriver(
            app, f"gallery-{name}", file, Generation.TWO, draws=draws, pictures=pictures
        )
        try:
            yield app_driver
        finally:
            app_driver.close()
            QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
        errors.raise_first()


class _WindowPictures:
    """The main window, with the arm drawn in 3D."""

    def __init__(self, app_driver: AppDriver, folder: Path, looks: Looks) -> None:
        self._driver = app_driver
        self._folder = folder
        self._looks = looks

    def take(self, scene: Scene) -> int:
        """Every picture of a scene; returns how many."""
        scene.play(self._driver)
        count = 0
        sizes = self._looks.sizes if len(self._looks.sizes) == 1 else scene.sizes
        # another theme costs more than another size
        for theme, size in itertools.product(self._looks.themes, sizes or self._looks.sizes):
            self._change(size, theme)
            for language in self._looks.languages:
                self._driver.store.change(language=language)
                look = f"{language}-{theme}"
                for name, widget in self._subjects(scene, look, size):
                    _save(steady(widget), self._folder, name)
                    count += 1
        return count

    def _subjects(
        self, scene: Scene, look: str, size: tuple[int, int]
    ) -> Iterator[tuple[str, QWidget]]:
        window = self._driver.window
        ratio = window.devicePixelRatioF()
        pixels = f"{round(size[0] * ratio)}x{round(size[1] * ratio)}"
        yield f"window-{scene.name}-{look}-{pixels}", window
        if scene.panels and size == self._looks.sizes[0]:
            for panel, widget in _panels(window).items():
                yield f"panel-{panel}-{scene.name}-{look}", widget

    def _change(self, size: tuple[int, int], theme: ThemeName) -> None:
        """Take another size and theme, and wait for the 3D picture of them."""
        self._driver.window.resize(*size)
        self._driver.store.change(theme=theme)
        view = self._driver.program.view
        _let_work()
        self._driver.window._picture.refresh()  # the ghost of a target, not when its timer says so
        if view.mode is ViewMode.FIT:
            view.fit()  # not as where the arm was seen on its way has it
        drawn(self._driver)


def _take_dialog(app_driver: AppDriver, scene: DialogScene, folder: Path, looks: Looks) -> int:
    next(window for window in WINDOW_SCENES if window.name == scene.during).play(app_driver)
    count = 0
    for theme, language in itertools.product(looks.themes, looks.languages):
        app_driver.store.change(language=language, theme=theme)
        _let_work()
        _save(steady(scene.open(app_driver)), folder, f"dialog-{scene.name}-{language}-{theme}")
        count += 1
        close_dialogs()
    return count


def every_scene() -> tuple[Scene | DialogScene, ...]:
    """All there is to be seen, the scenes of the window first."""
    return (*WINDOW_SCENES, *DIALOG_SCENES)


def _panels(window: QWidget) -> dict[str, QWidget]:
    """The panels of the operation area by their names."""
    area = window.findChild(OperationArea, "operation_area")
    return {type(panel).__name__.removesuffix("Panel").lower(): panel for panel in area.panels}


def drawn(app_driver: AppDriver) -> None:
    """Wait for the 3D picture of the present state; a computer that can't draw shows why."""
    view, longest = app_driver.program.view, QDeadlineTimer(_LONGEST_MS)
    while not (view.is_settled or view.has_given_up or longest.hasExpired()):
        _let_work()


def steady(widget: QWidget) -> QImage:
    """A picture of a widget whose layout has settled: two in a row are the same."""
    _let_work()
    last, longest = widget.grab().toImage(), QDeadlineTimer(_LONGEST_MS)
    while not longest.hasExpired():
        _let_work()
        now = widget.grab().toImage()
        if now == last:
            break
        last = now
    return last


def _save(picture: QImage, folder: Path, name: str) -> None:
    path = folder / f"{name}.png"
    if not picture.save(str(path), quality=_QUALITY):
        raise OSError(f"could not write {path}")


def _let_work() -> None:
    """Let Qt and the other threads work for a moment (QTest.qWait would keep Python's lock)."""
    loop = QEventLoop()
    QTimer.singleShot(_LOOK_MS, loop.quit)
    loop.exec()


class _StoppedClock(dt.datetime):
    """Noon of one day: two galleries show the same times."""

    @classmethod
    def now(cls, tz: dt.tzinfo | None = None) -> Any:
        return _NOON if tz is None else _NOON.astimezone(tz)


def _stop_the_clock() -> None:
    """Put the stopped clock in the place of `datetime` in every module of the program."""
    for name, module in list(sys.modules.items()):
        if name.startswith("armui.") and getattr(module, "datetime", None) is dt.datetime:
            setattr(module, "datetime", _StoppedClock)  # noqa: B010 - mypy knows no such attribute


class _SlotErrors:
    """Keeps what is raised in the slots of Qt, which PySide only prints."""

    def __init__(self) -> None:
        self._errors: list[BaseException] = []

    def __enter__(self) -> _SlotErrors:
        self._before = sys.excepthook
        sys.excepthook = self._keep
        return self

    def __exit__(self, *_reason: object) -> None:
        sys.excepthook = self._before

    def _keep(
        self, _kind: type[BaseException], error: BaseException, _trace: TracebackType | None
    ) -> None:
        self._errors.append(error)

    def raise_first(self) -> None:
        """Raise the first of them, if there is one."""
        if self._errors:
            raise self._errors[0]


def _pass_on(kind: QtMsgType, _context: QMessageLogContext, message: str) -> None:
    """Qt's messages, but for the off-screen platform's regret that it has no window manager."""
    if not message.startswith("This plugin does not support"):
        print(f"{kind.name}: {message}", file=sys.stderr)


def chosen(names: Iterable[str]) -> list[Scene | DialogScene]:
    """The scenes of these names; a window and a dialog of the same name both.

    Raises:
        ValueError: No scene has one of the names.
    """
    scenes = every_scene()
    names = list(names)
    unknown = sorted(set(names) - {scene.name for scene in scenes})
    if unknown:
        raise ValueError(f"no scene is called {', '.join(unknown)}; --list shows the names")
    return [scene for scene in scenes if not names or scene.name in names]
