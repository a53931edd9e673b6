"""The frames of some identifiers of a session, gathered in one pass through it: pure."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from armui.protocol.frame import FrameFlag
from armui.session.session import DataRows

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Mapping

    from numpy.typing import NDArray

    from armui.session.frames import Channel, FrameBatch
    from armui.session.session import Session

_IDS: Final = 0x800
_NOT_DATA: Final = FrameFlag.EXTENDED | FrameFlag.REMOTE | FrameFlag.ERROR | FrameFlag.IMPOSSIBLE
_HARDLY_S: Final = 0.05
"""So much of a time without frames is none, where only silences are looked for."""


class IdRows:
    """Keeps what it is asked for in memory: 30 bytes a frame.

    Args:
        session: What is passed through, once.
        channel: What is seen of it.
        ids: Of these every data frame is kept.
        heard: Of these so many that silences can be told: the first and last one of each twentieth
            of a second.
        is_wanted: Asked now and then; when it is not, the rest stays away.
    """

    def __init__(
        self,
        session: Session,
        channel: Channel,
        ids: Collection[int],
        heard: Collection[int],
        is_wanted: Callable[[], bool] = lambda: True,
    ) -> None:
        self._channel = channel
        self._kept = _among(ids)
        self._heard = _among(heard) & ~self._kept
        ids_found: list[NDArray[np.uint32]] = []
        pieces: list[DataRows] = []
        for batch in session.frames_between(-np.inf, np.inf):
            rows = self._rows(batch)
            if rows.size:
                ids_found.append(batch.ids[rows])
                times_s, lengths, payloads = batch.times_s, batch.lengths, batch.payloads
                pieces.append(
                    DataRows(batch.first + rows, times_s[rows], lengths[rows], payloads[rows])
                )
            if not is_wanted():
                break
        self._found: Mapping[int, DataRows] = {}
        if pieces:
            found = DataRows(*map(np.concatenate, zip(*pieces, strict=True)))
            self._found = _by_id(np.concatenate(ids_found), found)

    def data_rows(self, channel: Channel, arbitration_id: int) -> DataRows | None:
        """See `HasDataRows`; ``None`` also for what was not asked for."""
        return self._found.get(arbitration_id) if channel == self._channel else None

    def times_and_payloads(
        self, channel: Channel, arbitration_id: int
    ) -> tuple[NDArray[np.float64], NDArray[np.uint8]] | None:
        """The same as `armui.session.log_marks.LogFrames` asks for it."""
        found = self.data_rows(channel, arbitration_id)
        return None if found is None else (found.times_s, found.payloads)

    def _rows(self, batch: FrameBatch) -> NDArray[np.int64]:
        names = batch.channel_names
        if self._channel not in names:
            return np.empty(0, np.int64)
        data = (batch.flags & _NOT_DATA) == 0
        if len(names) > 1:
            data &= batch.channels == names.index(self._channel)
        rows = np.flatnonzero(data & (batch.ids < _IDS))
        ids = batch.ids[rows]
        kept = self._kept[ids]
        heard = np.flatnonzero(self._heard[ids])
        if heard.size:
            parts = np.floor(batch.times_s[rows[heard]] / _HARDLY_S)
            edges = np.flatnonzero(np.diff(parts))
            kept[heard[np.concatenate([[0], edges, edges + 1, [heard.size - 1]])]] = True
        return rows[kept]


def _among(ids: Collection[int]) -> NDArray[np.bool_]:
    table = np.zeros(_IDS, np.bool_)
    table[list(ids)] = True
    return table


def _by_id(ids: NDArray[np.uint32], rows: DataRows) -> dict[int, DataRows]:
    order = np.argsort(ids, kind="stable")
    ids, rows = ids[order], rows.of(order)
    edges = np.flatnonzero(np.diff(ids)) + 1
    begins, ends = [0, *edges.tolist()], [*edges.tolist(), ids.size]
    return {
        int(ids[begin]): rows.of(slice(begin, end)) for begin, end in zip(begins, ends, strict=True)
    }
