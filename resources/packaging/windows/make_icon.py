"""Draws the icon of the Windows programs: ``python make_icon.py TARGET.ico``."""

import sys
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QImage, QPainter
from PySide6.QtSvg import QSvgRenderer

_SIZE_PX = 256

if __name__ == "__main__":
    application = QGuiApplication([*sys.argv[:1], "-platform", "offscreen"])
    drawing = Path(__file__).resolve().parents[1] / "linux" / "armui.svg"
    image = QImage(_SIZE_PX, _SIZE_PX, QImage.Format.Format_ARGB32)
    image.fill(Qt.GlobalColor.transparent)
    painter = QPainter(image)
    QSvgRenderer(str(drawing)).render(painter)
    painter.end()
    if not image.save(sys.argv[1]):
        raise SystemExit(f"{sys.argv[1]} was not written")
