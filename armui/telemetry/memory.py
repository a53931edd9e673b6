"""Memory for the rings of samples: taken page by page as they fill, given back whole."""

from __future__ import annotations

import mmap
from typing import Any

import numpy as np
from numpy.typing import NDArray

_WORTH_PAGES = 65_536


def zeros(shape: tuple[int, ...], kind: np.dtype[Any] | str) -> NDArray[Any]:
    """An array of zeros like `numpy.zeros`, whose memory goes back to the system with it.

    The heap of the C library keeps what large arrays have freed, in pieces.
    """
    kind = np.dtype(kind)
    count = int(np.prod(shape))
    if count * kind.itemsize < _WORTH_PAGES:
        return np.zeros(shape, kind)
    return np.frombuffer(mmap.mmap(-1, count * kind.itemsize), kind, count).reshape(shape)
