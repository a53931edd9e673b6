"""`python -m armui.viewport`: the 3D view alone, with an arm that moves."""

from __future__ import annotations

import math
import sys

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from armui.viewport.view import ArmView


def main() -> int:
    """Show the view until its window is closed."""
    application = QApplication(sys.argv)
    view = ArmView()
    timer = QTimer(view, interval=16)
    seconds = 0.0

    def move() -> None:
        nonlocal seconds
        seconds += 0.016
        wave = math.sin(seconds)
        view.set_joints(
            (60.0 * wave, 70.0 + 30.0 * wave, -70.0, 30.0 * wave, 40.0, 0.0), 35.0 + 35.0 * wave
        )

    timer.timeout.connect(move)
    timer.start()
    view.show()
    return application.exec()


if __name__ == "__main__":
    sys.exit(main())
