"""The rows of a table: one for each set of joint angles, everything else as last heard then."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from armui.session.exports.columns import TIME_BASE

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from armui.session.exports.history import History
    from armui.session.exports.sink import TimeSpan


class RowTimes(NamedTuple):
    """Where the rows of a piece of a log are.

    Attributes:
        rows: Numbers of their frames within the log.
        times_s: As recorded.
    """

    rows: NDArray[np.int64]
    times_s: NDArray[np.float64]


def table_rows(history: History, span: TimeSpan, message: str = TIME_BASE) -> RowTimes | None:
    """The rows that the newest piece of a log adds; ``None`` if it adds none.

    Args:
        history: Has taken the piece.
        span: What lies outside is left out.
        message: Whose frames make rows.
    """
    samples = history.samples(message)
    if samples is None:
        return None
    times_s = samples.times_s[samples.old :]
    inside = span.holds(times_s)
    if not inside.any():
        return None
    return RowTimes(samples.new_rows[inside], times_s[inside])
