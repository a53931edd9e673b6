"""A bare button in a program of its own, with any program's priority: a stop is held against it.

``python -m tests.benchmarks.bare_button PRESSES`` prints a line when it stands, waits for one,
presses, and prints how long each press took to its handler, in ms.
"""

from __future__ import annotations

import random
import sys
import threading
import time

from PySide6.QtCore import QEvent, QObject, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QPushButton, QWidget

RELEASE = QEvent.Type.MouseButtonRelease


def press_event(widget: QWidget, kind: QEvent.Type) -> QMouseEvent:
    """A press or release in the middle of a widget."""
    center = QPointF(widget.rect().center())
    buttons = Qt.MouseButton.LeftButton
    return QMouseEvent(
        kind, center, widget.mapToGlobal(center), buttons, buttons, Qt.KeyboardModifier.NoModifier
    )


class Mouse(threading.Thread):
    """Presses buttons in turn at random moments; waits after each until it has had its effect.

    Args:
        buttons: What it presses.
        presses: How often, each.

    Attributes:
        pressed_s: The moments, by button.
        seen: To be set by the effect.
    """

    def __init__(self, buttons: tuple[QPushButton, ...], presses: int) -> None:
        super().__init__(name="mouse")
        self._buttons = buttons
        self._presses = presses
        self._random = random.Random(4)
        self.pressed_s: dict[QObject, list[float]] = {button: [] for button in buttons}
        self.seen = threading.Event()

    def run(self) -> None:
        for number in range(self._presses * len(self._buttons)):
            button = self._buttons[number % len(self._buttons)]
            threading.Event().wait(self._random.uniform(0.02, 0.05))
            self.seen.clear()
            press = press_event(button, QEvent.Type.MouseButtonPress)
            self.pressed_s[button].append(time.time())
            QApplication.postEvent(button, press)
            self.seen.wait(5)
            QApplication.postEvent(button, press_event(button, RELEASE))
        QApplication.exit(0)  # quit() would ask: the arm is moving


def handled_ms(app: QApplication, presses: int) -> list[float]:
    """Press a button that does nothing; how long each press took to its handler."""
    handled_s: list[float] = []
    button = QPushButton("bare")
    mouse = Mouse((button,), presses)
    button.pressed.connect(lambda: handled_s.append(time.time()))
    button.pressed.connect(mouse.seen.set)
    button.show()
    mouse.start()
    app.exec()
    mouse.join()
    return [
        1e3 * (end - begin) for end, begin in zip(handled_s, mouse.pressed_s[button], strict=True)
    ]


if __name__ == "__main__":
    app = QApplication([])
    print("ready", flush=True)
    sys.stdin.readline()
    print(*handled_ms(app, int(sys.argv[1])), flush=True)
