"""The four arms in three poses side by side: ``python -m tests.family_picture FILE``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Final

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QGuiApplication, QImage, QPainter

from armui.arm.models import all_models, robot_description
from armui.viewport.palette import LIGHT
from armui.viewport.process.scene import Scene

POSES: Final = {
    "all joints at 0": (0.0,) * 6,
    "raised": (25.0, 70.0, -60.0, 20.0, 40.0, 10.0),
    "reaching down": (-20.0, 110.0, -75.0, 0.0, 55.0, 0.0),
}
_CELL_PX: Final = 420
_HEAD_PX: Final = 34


def draw(path: Path) -> None:
    """Write the picture."""
    app = QGuiApplication(sys.argv[:1])
    models = all_models()
    image = QImage(
        _CELL_PX * len(models), _HEAD_PX + _CELL_PX * len(POSES), QImage.Format.Format_RGB32
    )
    image.fill(QColor(LIGHT.background))
    painter = QPainter(image)
    painter.setPen(QColor(LIGHT.text))
    painter.setFont(QFont(app.font().family(), 13))
    for column, (model, data) in enumerate(models.items()):
        head = QRectF(column * _CELL_PX, 0, _CELL_PX, _HEAD_PX)
        painter.drawText(head, Qt.AlignmentFlag.AlignCenter, data.name)
        scene = Scene(_CELL_PX, _CELL_PX)
        scene.load(robot_description(model))
        for row, angles_deg in enumerate(POSES.values()):
            scene.set_joints(angles_deg, 40.0)
            pixels = np.ascontiguousarray(scene.render(smooth=True).top_down()[:, :, :3])
            cell = QImage(
                pixels.tobytes(), _CELL_PX, _CELL_PX, 3 * _CELL_PX, QImage.Format.Format_RGB888
            )
            painter.drawImage(QPointF(column * _CELL_PX, _HEAD_PX + row * _CELL_PX), cell)
        scene.close()
    painter.end()
    image.save(str(path))


if __name__ == "__main__":
    draw(Path(sys.argv[1]))
