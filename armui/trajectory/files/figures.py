"""Long tables of nothing but numbers, read by numpy: several times as fast as cell by cell."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from armui.trajectory.samples.recording import Array


def read_figures(lines: Sequence[str], delimiter: str | None) -> Array | None:
    """The numbers (n, columns) of lines that all hold equally many of them and nothing else.

    Args:
        lines: Without empty ones and comments.
        delimiter: Between numbers; ``None`` for blanks.

    Returns:
        The finite numbers, or ``None`` where something is different: whoever then reads the lines
        one by one can say where and what.
    """
    if not lines:
        return None
    try:
        figures = np.loadtxt(lines, delimiter=delimiter, comments=None, ndmin=2, dtype=np.float64)
    except (ValueError, OverflowError):
        return None
    return figures if np.isfinite(figures).all() else None
