"""Samples a log at an even rate: the measured joints and gripper, and their commands."""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np

from armui.protocol.codes import ArmStatusCode
from armui.session.exports.export_columns import TableColumns, table_rows

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.protocol.codec import Codec
    from armui.session.exports.export_columns import RecordColumns, RowTimes
    from armui.session.exports.history import History, TimeSpan

    Array = NDArray[np.float64]

MAX_AGE_S: Final = 0.1
"""The greatest age of a measured value at an instant."""
_EARLY: Final = 1e-4
"""The share of a period by which a frame may be later than its instant."""
GRIPPER: Final = 6
"""The place of the gripper's opening behind the six angles."""

_VALUES: Final = (*(f"joint_angle.{joint}" for joint in range(1, 7)), "gripper_opening")
_STATUS: Final = "arm.arm_status"
_NO_FAULT: Final = (
    ArmStatusCode.NORMAL,
    ArmStatusCode.TEACHING_RECORDING,
    ArmStatusCode.TEACHING_RUNNING,
    ArmStatusCode.TEACHING_PAUSED,
)


class Cause(enum.IntEnum):
    """Why an instant is in no episode."""

    NONE = 0
    SILENT = 1
    """Not all angles were heard within :data:`MAX_AGE_S`."""
    FAULT = 2
    """The arm told a stop or a fault."""
    NO_GRIPPER = 3
    """The gripper was not heard, though it is at other times."""


class Instants(NamedTuple):
    """A log at an even rate; while nothing was heard for longer than `MAX_AGE_S`, there is none.

    Attributes:
        numbers: (n,) periods from the first frame of the log on.
        measured: (n, 7) six angles in degrees and the opening in mm; NaN: not heard.
        asked: (n, 7) the same as commanded by any host; NaN: no such command held.
        causes: (n,) :class:`Cause`.
    """

    numbers: NDArray[np.int64]
    measured: Array
    asked: Array
    causes: NDArray[np.int8]


class InstantSampler:
    """Samples a log at an even rate, piece by piece; its memory grows with the instants only.

    Args:
        codec: A codec of the arm's generation.
        start_s: The time of the first instant.
        fps: Instants a second.
    """

    def __init__(self, codec: Codec, start_s: float, fps: int) -> None:
        self._start_s = start_s
        self._fps = fps
        self._records = _Wanted(codec)
        self._last: Array | None = None
        self._pieces: list[Instants] = []

    def take(self, history: History, span: TimeSpan) -> int:
        """Take in what a piece of the log adds; return the number of new instants."""
        rows = table_rows(history, span)
        if rows is None:
            return 0
        told = self._records.told(history, rows)
        told = told if self._last is None else np.vstack((self._last, told))
        # after the clock was set back, rows are skipped until its former time is reached
        told = told[told[:, 0] >= np.maximum.accumulate(told[:, 0])]
        self._last = told[-1:]
        return self._add(told[:-1], told[1:, 0])

    def instants(self) -> Instants:
        """Return all of them; where the gripper is heard at all, it counts."""
        if self._last is not None:
            self._add(self._last, np.nextafter(self._last[:, 0], np.inf))
        found = Instants(*(np.concatenate(column) for column in zip(*self._pieces, strict=True)))
        heard = np.isfinite(found.measured[:, GRIPPER])
        if heard.any():
            found.causes[~heard & (found.causes == Cause.NONE)] = Cause.NO_GRIPPER
        return found

    def _add(self, told: Array, until_s: Array) -> int:
        """Add the instants at which each row is the last one heard, and not too old."""
        firsts = self._numbers(told[:, 0])
        counts = self._numbers(np.minimum(until_s, told[:, 0] + MAX_AGE_S)) - firsts
        which = np.repeat(np.arange(len(told)), counts)
        numbers = firsts[which] + np.arange(len(which)) - (np.cumsum(counts) - counts)[which]
        at, behind = told[which], 2 + len(_VALUES)
        self._pieces.append(
            Instants(numbers, at[:, 2:behind], at[:, behind:], at[:, 1].astype(np.int8))
        )
        return len(which)

    def _numbers(self, times_s: Array) -> NDArray[np.int64]:
        """Return the number of the first instant at or after each time."""
        return np.ceil((times_s - self._start_s) * self._fps - _EARLY).astype(np.int64)


class _Wanted:
    """The columns that a dataset needs: measured values, commands, and the status."""

    def __init__(self, codec: Codec) -> None:
        records = TableColumns(codec).records
        self._measured = _places(records, "arm")
        self._asked = _places(records, "command")
        (self._status,) = [each for each in records if each.message == "ArmStatus"]

    def told(self, history: History, rows: RowTimes) -> Array:
        """Return for each row its time, its cause, what was measured and what was asked."""
        measured = _values(history, rows, self._measured, MAX_AGE_S)
        asked = _values(history, rows, self._asked, np.inf)
        # a command for only some of the joints counts as none
        asked[~np.isfinite(asked[:, :GRIPPER]).all(axis=1), :GRIPPER] = np.nan
        silent = ~np.isfinite(measured[:, :GRIPPER]).all(axis=1)
        faults = np.where(self._faulty(history, rows), Cause.FAULT, Cause.NONE)
        causes = np.where(silent, Cause.SILENT, faults)
        return np.column_stack((rows.times_s, causes, measured, asked))

    def _faulty(self, history: History, rows: RowTimes) -> NDArray[np.bool_]:
        told = self._status.told_at(history, rows.rows, rows.times_s)
        if told is None:
            return np.zeros(len(rows.rows), np.bool_)
        samples, which = told
        column = next(each for each in self._status.columns if each.name == _STATUS)
        faulty: NDArray[np.bool_] = ~np.isin(column.values(samples)[which], _NO_FAULT)
        return faulty & (which >= 0)


def _places(
    records: tuple[RecordColumns, ...], source: str
) -> list[tuple[RecordColumns, int, int]]:
    """Return for each wanted value its message, its column there, and its place in the result."""
    names = [f"{source}.{value}" for value in _VALUES]
    return [
        (record, place, names.index(column.name))
        for record in records
        for place, column in enumerate(record.columns)
        if column.name in names
    ]


def _values(
    history: History, rows: RowTimes, places: list[tuple[RecordColumns, int, int]], max_age_s: float
) -> Array:
    """Return (n, 7) the values held at each row; NaN where none did, or an older one."""
    found = np.full((len(rows.rows), len(_VALUES)), np.nan)
    for record, place, into in places:
        told = record.told_at(history, rows.rows, rows.times_s)
        if told is None:
            continue
        samples, which = told
        held = (which >= 0) & (rows.times_s - samples.times_s[which] <= max_age_s)
        found[held, into] = record.columns[place].values(samples)[which[held]]
    return found
