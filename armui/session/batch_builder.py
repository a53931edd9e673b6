"""Converts messages of python-can's readers into batches of columns, and notes contradictions."""

from __future__ import annotations

import math
from dataclasses import replace
from operator import attrgetter
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.arm.refusal import Reason
from armui.protocol.frame import FrameFlag
from armui.session.frames import (
    CLASSIC_BYTES,
    LATEST_S,
    MOST_BYTES,
    Channel,
    Damage,
    DamageList,
    FrameBatch,
)
from armui.system.sentence import Told

if TYPE_CHECKING:
    from collections.abc import Callable

    import can
    from numpy.typing import NDArray

_TOP_STANDARD_ID = 0x7FF
_TOP_EXTENDED_ID = 0x1FFFFFFF
_TOP_ID = 0xFFFFFFFF
_MOST_CHANNELS = 255
FURTHER_CHANNELS: Final = "further channels"
"""The common name of all channels beyond the 255th."""
_EARLIEST_DATE_S: Final = 5e8
"""No log is from before 1985: a unit of time that leads there is not the log's."""
_SMALLER_UNITS: Final = {"ms": 1e3, "µs": 1e6, "ns": 1e9, "ps": 1e12}
LOG_NO_TIMES = Reason(
    "log_no_times",
    "The log has no times: its frames stand 1 ms apart in their order. No time in it is measured, "
    "nor any speed.",
)
LOG_PAUSES_ADDED = Reason(
    "log_pauses_added", "Its times are those since the frame before: they were added up."
)
LOG_SMALLER_UNIT = Reason("log_smaller_unit", "Its times are in {unit}, and read as such.")
LOG_LAST_LINE_TORN = Reason(
    "log_last_line_torn", "Its last line breaks off and is left out, as where a recorder is ended."
)
_CERTAIN_STEPS: Final = 256
"""After so many steps, of which most go forward, times are certain not to be pauses."""
MESSAGE_FLAGS: Final = (
    ("is_extended_id", FrameFlag.EXTENDED),
    ("is_remote_frame", FrameFlag.REMOTE),
    ("is_error_frame", FrameFlag.ERROR),
    ("is_fd", FrameFlag.FD),
    ("bitrate_switch", FrameFlag.BITRATE_SWITCH),
    ("error_state_indicator", FrameFlag.ERROR_STATE),
)
"""The attributes of python-can's messages, with the flag each stands for."""
_columns = attrgetter(
    "timestamp",
    "arbitration_id",
    "data",
    "dlc",
    "channel",
    "is_rx",
    *(name for name, _ in MESSAGE_FLAGS),
)


class BatchBuilder:
    """Turns messages into batches and keeps count of frames and channels.

    Attributes:
        frames: The number of frames so far.
        damages: The list of contradictions.
        header_seen: True if the file begins as a log does: it is one, even if no frame follows.
        pauses: True if the times are those since the frame before; ``None`` if they may be.
    """

    def __init__(self, damages: DamageList) -> None:
        self.frames = 0
        self.header_seen = False
        self.damages = damages
        self._channels: dict[Channel, int] = {}
        self.pauses: bool | None = False
        self._steps = self._not_forward = 0
        self._before_s: dict[int, float] = {}
        self._per_second: float | None = None
        self._last_s = 0.0

    def batch(self, messages: list[can.Message], place: Callable[[int], str]) -> FrameBatch:
        """Return the batch of some messages; those that are no frames are left out and noted.

        Args:
            messages: The messages of a reader.
            place: Returns the place of the message with an index, for the notes.
        """
        try:
            batch = self._columns(messages)
            sound = batch is not None and bool(np.isfinite(batch.times_s).all())
        except (TypeError, ValueError, OverflowError, AttributeError):
            batch, sound = None, False
        if batch is None or not sound:
            kept = [
                index for index, each in enumerate(messages) if self._usable(each, index, place)
            ]
            batch = self._columns([messages[index] for index in kept])
            places = kept
        else:
            places = list(range(len(messages))) if batch.flags.max(initial=0) >= 128 else []
        for row in np.flatnonzero(batch.flags & FrameFlag.IMPOSSIBLE).tolist():
            self.note(place(places[row]), _contradiction(batch, row), row, frame_given=True)
        return self.count(batch)

    def note(self, place: str, reason: str, rows_before: int, *, frame_given: bool = False) -> None:
        """Note a damaged place at a row, counted from the frames so far."""
        self.damages.add(Damage(place, reason, self.frames + rows_before, frame_given))

    def _columns(self, messages: list[can.Message]) -> FrameBatch:
        count = len(messages)
        columns: Any = zip(*map(_columns, messages), strict=True) if count else ((),) * 12
        times_s, ids, data, dlcs, channels, received, *marks = columns
        id_column = np.array(ids, np.int64)
        if count and not 0 <= id_column.min() <= id_column.max() <= _TOP_ID:
            raise ValueError("identifiers of more than 32 bits")
        flags = np.zeros(count, np.uint8)
        for (_name, flag), values in zip(MESSAGE_FLAGS, marks, strict=True):
            if True in values:
                flags |= np.where(np.array(values, bool), flag, 0).astype(np.uint8)
        if False in received:
            flags |= np.where(np.array(received, bool), 0, FrameFlag.TRANSMITTED).astype(np.uint8)
        sizes = np.array(list(map(len, data)), np.int64)
        if count and sizes.max() > MOST_BYTES:
            raise ValueError("more data than any frame holds")
        flags |= _impossible(id_column, flags, sizes, np.array(dlcs, np.int64))
        return FrameBatch(
            first=self.frames,
            times_s=np.array(times_s, np.float64),
            ids=id_column.astype(np.uint32),
            flags=flags,
            lengths=_lengths(flags, sizes, dlcs),
            payloads=_payloads(data, sizes),
            channels=self.channel_column(channels),
            channel_names=self.channel_names,
            long_data={
                row: bytes(data[row]) for row in np.flatnonzero(sizes > CLASSIC_BYTES).tolist()
            },
        )

    @property
    def channel_names(self) -> tuple[Channel, ...]:
        """The channels met so far, in the order of the indices in batches."""
        return tuple(self._channels)

    def count(self, batch: FrameBatch) -> FrameBatch:
        """Count a batch made elsewhere, and return it with valid times."""
        if len(batch):
            if self.pauses is None:
                self._look_for_pauses(batch)
            if self.pauses:
                self.damages.remark(LOG_PAUSES_ADDED())
                batch = replace(batch, times_s=self._last_s + np.cumsum(batch.times_s))
            batch = self._with_times(batch)
            self._last_s = float(batch.times_s[-1])
        self.frames += len(batch)
        return batch

    def _look_for_pauses(self, batch: FrameBatch) -> None:
        """Find out whether times count from the frame before or from the beginning.

        The latter grow on each channel; of the former about half are not larger than the one
        before.
        """
        for channel in np.unique(batch.channels).tolist():
            own = batch.times_s[batch.channels == channel]
            steps = np.diff(own, prepend=self._before_s.get(channel, -np.inf))
            self._before_s[channel] = float(own[-1])
            self._steps += int(np.isfinite(steps).sum())
            self._not_forward += int((steps <= 0.0).sum())
        if self._not_forward and 5 * self._not_forward >= self._steps:
            self.pauses = True
        elif self._steps >= _CERTAIN_STEPS:
            self.pauses = False

    def _with_times(self, batch: FrameBatch) -> FrameBatch:
        """Return the batch with times in seconds, none beyond `LATEST_S`.

        Times in ms, µs or ns since 1970 become seconds. Where there is still none that could be,
        the frame is given that of the frame before it, and noted.
        """
        if self._per_second is None:
            self._per_second = self._unit(batch.times_s)
        times_s = batch.times_s
        if self._per_second != 1.0:
            times_s = times_s / self._per_second
        odd = ~(np.abs(times_s) <= LATEST_S)
        if odd.any():
            # the index of the last row up to each with a valid time; -1 if there is none in this
            # batch
            last = np.maximum.accumulate(np.where(odd, -1, np.arange(len(batch))))
            times_s = np.where(last < 0, self._last_s, times_s[last])
            for row in np.flatnonzero(odd).tolist():
                if self.damages.full:
                    self.damages.count += 1
                else:
                    place = Told("frame {frame}", frame=self.frames + row + 1)
                    reason = Told("its time is none that a log can have")
                    self.note(place, reason, row, frame_given=True)
        return batch if times_s is batch.times_s else replace(batch, times_s=times_s)

    def _unit(self, times_s: NDArray[np.float64]) -> float:
        """Return the log's units of time per second; units smaller than a second are noted."""
        middle = float(np.sort(times_s)[times_s.size // 2])
        for unit, per_second in _SMALLER_UNITS.items() if middle > LATEST_S else ():
            if _EARLIEST_DATE_S < middle / per_second <= LATEST_S:
                self.damages.remark(LOG_SMALLER_UNIT(unit=unit))
                return per_second
        return 1.0

    def channel_column(self, channels: tuple[Channel, ...]) -> NDArray[np.uint8]:
        """Return the indices of channels; those beyond the 255th share one, which is noted."""
        known = self._channels
        for channel in dict.fromkeys(channels):
            if channel in known:
                continue
            if len(known) < _MOST_CHANNELS:
                known[channel] = len(known)
            elif FURTHER_CHANNELS not in known:
                known[FURTHER_CHANNELS] = _MOST_CHANNELS
                reason = Told(
                    "more than {most} channels; the others are read as one", most=_MOST_CHANNELS
                )
                self.note(Told("channel {channel}", channel=channel), reason, 0)
        further = known.get(FURTHER_CHANNELS, 0)
        return np.array([known.get(channel, further) for channel in channels], np.uint8)

    def _usable(self, message: can.Message, index: int, place: Callable[[int], str]) -> bool:
        """Return whether a message has an identifier, data and a time at all."""
        try:
            self._columns([message])
            known = math.isfinite(message.timestamp)
            reason = Told("") if known else Told("its time is no number")
        except (TypeError, ValueError, OverflowError, AttributeError) as error:
            reason = Told(str(error)) if str(error) else Told("its parts are no numbers")
        if reason:
            self.note(place(index), reason, index)
        return not reason


def _impossible(
    ids: NDArray[np.int64],
    flags: NDArray[np.uint8],
    sizes: NDArray[np.int64],
    dlcs: NDArray[np.int64],
) -> NDArray[np.uint8]:
    """Return the flag IMPOSSIBLE for every row whose parts contradict one another.

    A classic frame may carry a length code of 9 to 15; its data are 8 bytes then (ISO 11898-1),
    and readers tell that code, or the number of bytes that it would mean in CAN FD.
    """
    extended = (flags & FrameFlag.EXTENDED) != 0
    fd = (flags & FrameFlag.FD) != 0
    remote = (flags & FrameFlag.REMOTE) != 0
    error = (flags & FrameFlag.ERROR) != 0
    bad_id = ids > np.where(extended, _TOP_EXTENDED_ID, _TOP_STANDARD_ID)
    most = np.where(fd, MOST_BYTES, CLASSIC_BYTES)
    long_code = (sizes == CLASSIC_BYTES) & (dlcs > CLASSIC_BYTES) & (dlcs <= MOST_BYTES)
    bad_size = ((sizes != dlcs) & ~long_code & ~fd & ~remote) | (sizes > most)
    bad_dlc = (dlcs < 0) | (dlcs > MOST_BYTES)
    bad = (bad_id | bad_size | bad_dlc) & ~error
    return np.where(bad, np.uint8(FrameFlag.IMPOSSIBLE), np.uint8(0))


def _contradiction(batch: FrameBatch, row: int) -> str:
    """Return what is wrong with a frame that is marked as impossible."""
    arbitration_id, flags = int(batch.ids[row]), int(batch.flags[row])
    bits, top = (29, _TOP_EXTENDED_ID) if flags & FrameFlag.EXTENDED else (11, _TOP_STANDARD_ID)
    if arbitration_id > top:
        return Told(
            "identifier 0x{can_id:X} in a frame whose identifiers have {bits} bits",
            can_id=arbitration_id,
            bits=bits,
        )
    return Told(
        "0x{can_id:03X} with {count} bytes of data, but another length",
        can_id=arbitration_id,
        count=int(batch.lengths[row]),
    )


def _lengths(
    flags: NDArray[np.uint8], sizes: NDArray[np.int64], dlcs: tuple[int, ...]
) -> NDArray[np.uint8]:
    remote = (flags & FrameFlag.REMOTE) != 0
    if remote.any():
        sizes = np.where(remote, np.clip(np.array(dlcs, np.int64), 0, MOST_BYTES), sizes)
    return sizes.astype(np.uint8)


def _payloads(data: tuple[bytearray, ...], sizes: NDArray[np.int64]) -> NDArray[np.uint8]:
    joined = (
        b"".join(data)
        if (sizes == CLASSIC_BYTES).all()
        else b"".join([each[:CLASSIC_BYTES].ljust(CLASSIC_BYTES, b"\0") for each in data])
    )
    return np.frombuffer(joined, np.uint8).reshape(-1, CLASSIC_BYTES)
