"""Python's search for garbage, kept to the thread of the windows.

Left to itself it is made by whichever thread happens to make objects, and what it finds may be what
is left of a window. As such an object ends, Qt holds a lock and waits for Python, while the thread
of the windows has Python and waits for that lock: then nothing goes on any more, the stop neither.
"""

from __future__ import annotations

import gc
from typing import Final

from PySide6.QtCore import QObject, QTimer

_LOOK_MS: Final = 500
_LOOKS: Final = 120
"""Everything that has come since the start is searched once in so many looks: once a minute."""


class GarbageSearch(QObject):
    """Searches now and then, instead of Python by itself; lives in the thread of the windows.

    Args:
        parent: It ends with this.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._looks = 0
        self._timer = QTimer(self, interval=_LOOK_MS)
        self._timer.timeout.connect(self.look)
        self._timer.start()
        gc.disable()

    def look(self) -> None:
        """Search what is new, which takes some tenths of a millisecond, or once a minute all."""
        self._looks += 1
        if self._looks < _LOOKS:
            gc.collect(1)
        else:
            self._looks = 0
            gc.collect()
