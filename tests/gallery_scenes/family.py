"""The four arms in three poses side by side."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Final

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import QDialog, QGridLayout, QLabel

from armui.arm.models import model_data, robot_description
from armui.protocol.generation import PiperModel
from armui.viewport.camera import HOME_CAMERA
from armui.viewport.palette import DARK, LIGHT, ScenePalette
from armui.viewport.process.scene import Scene
from tests.app_driver import AppDriver

POSES: Final = {
    ("所有关节为 0°", "All joints at 0°"): (0.0,) * 6,
    ("抬起", "Raised"): (25.0, 70.0, -60.0, 20.0, 40.0, 10.0),
    ("向下伸出", "Reaching down"): (-20.0, 110.0, -75.0, 0.0, 55.0, 0.0),
}
"""What each is called in Chinese and English, and its angles."""
_CELL_PX: Final = 320
_FOCUS_M: Final = (0.17, 0.0, 0.25)
_DISTANCE_M: Final = 1.5


def family(app_driver: AppDriver) -> QDialog:
    """A table of pictures: a column for each arm, a row for each pose."""
    dialog = QDialog(app_driver.window)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    palette = DARK if app_driver.store.settings.theme == "dark" else LIGHT
    chinese = app_driver.store.settings.language == "zh"
    grid = QGridLayout(dialog)
    grid.setSpacing(8)
    for row, (zh, en) in enumerate(POSES, start=1):
        grid.addWidget(QLabel(zh if chinese else en), row, 0)
    for column, model in enumerate(PiperModel, start=1):
        name = QLabel(model_data(model).name)
        grid.addWidget(name, 0, column, Qt.AlignmentFlag.AlignCenter)
        for row, image in enumerate(_pictures(model, palette), start=1):
            cell = QLabel()
            cell.setPixmap(QPixmap.fromImage(image))
            grid.addWidget(cell, row, column)
    dialog.show()
    return dialog


@cache
def _pictures(model: PiperModel, palette: ScenePalette) -> tuple[QImage, ...]:
    """An arm in each of the poses."""
    scene = Scene(_CELL_PX, _CELL_PX, palette=palette)
    try:
        scene.load(robot_description(model))
        scene.camera = replace(HOME_CAMERA, focus_m=_FOCUS_M, distance_m=_DISTANCE_M)
        images = []
        for angles_deg in POSES.values():
            scene.set_joints(angles_deg, 40.0)
            pixels = np.ascontiguousarray(scene.render(smooth=True).top_down()[:, :, :3])
            image = QImage(
                pixels.tobytes(), _CELL_PX, _CELL_PX, 3 * _CELL_PX, QImage.Format.Format_RGB888
            )
            images.append(image.copy())
        return tuple(images)
    finally:
        scene.close()
