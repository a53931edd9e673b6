"""Python's garbage collection, restricted to the GUI thread.

By default it runs in whichever thread happens to create objects, and may destroy the remains of a
window there. Then Qt holds a lock and waits for Python, while the GUI thread holds Python's lock
and waits for Qt's: a deadlock, in which even the stop does not work.
"""

from __future__ import annotations

import gc
from typing import Final

from PySide6.QtCore import QObject, QTimer

_LOOK_MS: Final = 500
"""The period of the search for new garbage, in place of Python's count of new objects."""
_LOOKS: Final = 120
"""The number of searches after which all objects are searched: about once a minute."""


class GarbageSearch(QObject):
    """Collects garbage periodically in place of Python's own collection; lives in the GUI thread.

    Args:
        parent: The object with which it ends.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._looks = 0
        self._timer = QTimer(self, interval=_LOOK_MS)
        self._timer.timeout.connect(self.collect)
        self._timer.start()
        gc.disable()

    def collect(self) -> None:
        """Search new objects, which takes some tenths of a millisecond, or every minute all."""
        self._looks += 1
        if self._looks < _LOOKS:
            gc.collect(1)
        else:
            self._looks = 0
            gc.collect()
