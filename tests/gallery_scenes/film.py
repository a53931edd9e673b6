"""The film of the main window for README: ``python -m tests.gallery --film``."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

from PIL import Image
from PySide6.QtCore import QDeadlineTimer
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QComboBox, QWidget

from armui.control.run.progress import OVER
from armui.protocol.codes import MoveMode
from armui.setting_checks import Language
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import GripperOpening, Trajectory, Waypoint
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.viewport.camera import OrbitCamera
from tests.app_driver import AppDriver
from tests.gallery_scenes.pictures import drawn, opened, steady

FOLDER: Final = Path(__file__).resolve().parents[2] / "resources" / "pictures"
"""Where the films are."""
LANGUAGES: Final[tuple[Language, ...]] = ("zh", "en")
MOST_BYTES: Final = 1_500_000
"""Of a film: what a reader of README waits for."""
_NAMES: Final = {"zh": "取放", "en": "Pick and place"}
_NOTES: Final = {"zh": "从料盘到传送带", "en": "from the tray to the belt"}
_WINDOW_PX: Final = (1280, 800)
_SHOWN_PX: Final = (960, 600)
_FRAME_S: Final = 0.1
_QUALITY: Final = 80
_LONGEST_MS: Final = 120_000
_CAMERA: Final = OrbitCamera((0.11, 0.0, 0.31), 1.3, azimuth_deg=-70.0, elevation_deg=22.0)
"""One for the whole way: the arm moves, not the room."""
_SPEED_PERCENT: Final = 90
_LINE_PERCENT: Final = 80
_FILMED: Final = 2
"""The cycle of the run that is seen: it begins where it ends, as a film that goes round has to."""


def _points() -> tuple[Waypoint, ...]:
    """Down to a workpiece and up with it, on straight lines; over; down, and up without it."""

    def over(joint_1_deg: float) -> Waypoint:
        return Waypoint(MoveMode.MOVE_J, (joint_1_deg, 80.0, -75.0, 0.0, 65.0, 0.0))

    def line(y_mm: float, z_mm: float, **more: Any) -> Waypoint:
        turn_deg = -140.0 if y_mm > 0 else 140.0
        target = (213.09, y_mm, z_mm, 180.0, 25.0, turn_deg)
        return Waypoint(MoveMode.MOVE_L, target, speed_percent=_LINE_PERCENT, **more)

    take, leave = GripperOpening(20.0), GripperOpening(70.0)
    return (
        over(40.0),
        line(178.8, 237.0, dwell_s=0.1, gripper=take),
        line(178.8, 347.0),
        over(-40.0),
        line(-178.8, 237.0, dwell_s=0.1, gripper=leave),
        line(-178.8, 347.0),
    )


def make(language: Language, folder: Path = FOLDER) -> Path:
    """Film one cycle of a run; `prepare` has been called.

    Args:
        language: Of the window.
        folder: Where the film goes.

    Returns:
        Its file.

    Raises:
        OSError: It cannot be written, or the arm is not drawn (TimeoutError).
        Exception: Whatever went wrong in the run.
    """
    with opened(f"film-{language}", draws=True) as app_driver:
        app_driver.store.change(language=language)
        app_driver.window.resize(*_WINDOW_PX)
        _begin(app_driver, Trajectory(_NAMES[language], _NOTES[language], _points()))
        first, *others = _frames(app_driver)
    path = folder / f"window-{language}.webp"
    first.save(
        path,
        save_all=True,
        append_images=others,
        duration=round(1e3 * _FRAME_S),
        loop=0,  # for ever
        quality=_QUALITY,
    )
    return path


def _begin(app_driver: AppDriver, trajectory: Trajectory) -> None:
    """Let a trajectory run over and over, in the editor, until the filmed cycle begins."""
    app_driver.lie(trajectory.points[0].target)  # a run from elsewhere is asked about
    app_driver.ready()
    Library(app_driver.library_folder).save(trajectory)
    app_driver.window.open_library_window()
    app_driver.page(LibraryPage).open_trajectory(trajectory.name)
    page = app_driver.page(EditorPage)
    page.findChild(QComboBox, "run_cycles").setCurrentIndex(1)
    app_driver.click(page.findChild(QWidget, "run_send"))
    player = app_driver.controller.player
    app_driver.run_until(lambda: player.progress.phase not in OVER)
    app_driver.controller.motion.set_speed_percent(_SPEED_PERCENT)
    app_driver.run_until(lambda: player.progress.cycle == _FILMED, seconds=60.0)


def _frames(app_driver: AppDriver) -> Iterator[Image.Image]:
    """The filmed cycle, a picture for each tenth of a second of the arm's time."""
    app_driver.program.view._look_through(_CAMERA)
    player = app_driver.controller.player
    while player.progress.cycle == _FILMED:
        yield _small(_seen(app_driver))
        app_driver.run(_FRAME_S)


def _seen(app_driver: AppDriver) -> QImage:
    """The window with the arm as it is: on a busy computer its picture may be late, or lost."""
    view, longest = app_driver.program.view, QDeadlineTimer(_LONGEST_MS)
    while not longest.hasExpired():
        drawn(app_driver)
        seen = steady(app_driver.window)
        if view.is_current:
            return seen
    raise TimeoutError("the arm is not drawn")


def _small(grabbed: QImage) -> Image.Image:
    """The same for Pillow."""
    seen = grabbed.convertToFormat(QImage.Format.Format_RGB888)
    size = (seen.width(), seen.height())
    whole = Image.frombytes("RGB", size, bytes(seen.constBits()), "raw", "RGB", seen.bytesPerLine())
    return whole.resize(_SHOWN_PX, Image.Resampling.LANCZOS)
