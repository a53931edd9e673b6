"""A recording of ours, opened at once by the index beside it."""

from __future__ import annotations

import bisect
import struct
import threading
import zlib
from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np
from can.io import blf

from armui.protocol.frame import FrameFlag
from armui.session.batch_builder import BatchBuilder
from armui.session.blf_logs import read_blf_log
from armui.session.frames import (
    CLASSIC_BYTES,
    Channel,
    Damage,
    DamageList,
    FrameBatch,
    NotALogError,
)
from armui.session.recording import index_file, sidecar
from armui.session.recording.counted import counts_in, counts_of, is_over, keep
from armui.session.recording.episodes import episode_marks
from armui.session.recording.formats import MESSAGE, BlfFormat
from armui.session.recording.index_file import Block
from armui.session.recording.kinds import RecordingFormat, file_name, names_of
from armui.session.recording.rows import ROW
from armui.session.session import REMEMBERED, REMEMBERED_IDS, SessionMark
from armui.session.source import LogSource
from armui.session.text_logs import ASC, CANDUMP, read_text_log
from armui.system.files import error_text, open_file, read_file
from armui.system.sentence import Told

# Reads single blocks of our own recordings, without reading the file before them.

_HEAD: Final = blf.OBJ_HEADER_BASE_STRUCT.size
_CONTAINER: Final = blf.LOG_CONTAINER_STRUCT
_ASC_OPENING: Final = b"base hex  timestamps absolute\nno internal events logged\n"

_LONGEST_TAIL: Final = 4_000_000
"""More bytes than a killed program leaves without index: the index belongs to another recording."""
_REMEMBERED: Final = np.array(sorted(REMEMBERED_IDS), np.uint32)
_SLACK_S: Final = 2e-6
"""Formats round their times; blocks are chosen a little more widely."""

_LONGEST_OPENING: Final = 4_096


def read_block(
    data: bytes, kind: RecordingFormat, start_s: float, damages: DamageList, channel: str
) -> list[FrameBatch]:
    """Return the frames of a block.

    Args:
        data: The bytes of the block.
        kind: Their format.
        start_s: The time since 1970 from which the file counts, if it does.
        damages: The list for damaged places.
        channel: The channel's name for every frame.

    Returns:
        Batches with log times; the first one's first frame has the number 0.
    """
    names: tuple[Channel, ...] = (channel,)
    quick = _quick_batch(data, start_s, names) if kind is RecordingFormat.BLF else None
    if quick is not None:
        return [quick]
    builder = BatchBuilder(damages)
    if kind is not RecordingFormat.BLF:
        data = _whole_lines(data, builder)
    found = []
    for batch in _batches(data, kind, start_s, builder):
        times_s = batch.times_s + start_s if kind is RecordingFormat.ASC else batch.times_s
        channels = np.zeros(len(batch), np.uint8)
        found.append(replace(batch, times_s=times_s, channels=channels, channel_names=names))
    return found


def _whole_lines(data: bytes, builder: BatchBuilder) -> bytes:
    """Drop a last line that was cut: what is left of it may look like a shorter frame."""
    end = data.rfind(b"\n") + 1
    if end < len(data):
        place = Told("byte {byte} of a block", byte=end)
        builder.note(place, Told("the file breaks off in a line"), 0)
    return data[:end]


def _batches(
    data: bytes, kind: RecordingFormat, start_s: float, builder: BatchBuilder
) -> Iterator[FrameBatch]:
    if kind is RecordingFormat.BLF:
        source = LogSource(BlfFormat(start_s).opening() + data)
        return read_blf_log(source, builder)
    if kind is RecordingFormat.ASC:
        return read_text_log(LogSource(_ASC_OPENING + data), ASC, builder)
    return read_text_log(LogSource(data), CANDUMP, builder)


def _quick_batch(data: bytes, start_s: float, names: tuple[Channel, ...]) -> FrameBatch | None:
    """Return a block that is one container of classic data frames; None: it is not."""
    try:
        sign, _head, _version, size, kind = blf.OBJ_HEADER_BASE_STRUCT.unpack_from(data)
        method, unpacked = _CONTAINER.unpack_from(data, _HEAD)
        if sign != b"LOBJ" or kind != blf.LOG_CONTAINER or not size <= len(data) <= size + 3:
            return None
        if method != blf.ZLIB_DEFLATE or unpacked % MESSAGE.itemsize:
            return None
        unpacker = zlib.decompressobj()
        objects = unpacker.decompress(data[_HEAD + _CONTAINER.size : size], unpacked + 1)
    except (struct.error, zlib.error):
        return None
    if len(objects) != unpacked or not unpacker.eof:
        return None
    table = np.frombuffer(objects, MESSAGE)
    whole = (
        (table["signature"] == b"LOBJ").all()
        and (table["size"] == MESSAGE.itemsize).all()
        and (table["kind"] == blf.CAN_MESSAGE).all()
        and (table["length"] <= CLASSIC_BYTES).all()
        and (table["header_version"] == 1).all()
        and (table["time_flags"] == blf.TIME_ONE_NANS).all()
    )
    if not whole:
        return None
    ids = table["id"]
    flags = np.where(ids & blf.CAN_MSG_EXT, FrameFlag.EXTENDED, 0)
    flags |= np.where(table["flags"] & blf.DIR, FrameFlag.TRANSMITTED, 0)
    flags |= np.where(table["flags"] & blf.REMOTE_FLAG, FrameFlag.REMOTE, 0)
    past_end = np.arange(CLASSIC_BYTES) >= table["length"][:, None]
    return FrameBatch(
        first=0,
        times_s=table["time"] * 1e-9 + start_s,
        ids=(ids & 0x1FFFFFFF).astype(np.uint32),
        flags=flags.astype(np.uint8),
        lengths=np.ascontiguousarray(table["length"]),
        payloads=np.where(past_end, np.uint8(0), table["data"]),
        channels=np.zeros(len(table), np.uint8),
        channel_names=names,
    )


class RecordedSession:
    """A `Session` made of our own files.

    Args:
        path: Any file of the recording.

    Attributes:
        name: Its name.
        lines: The sidecar's lines: the content, its source, and how it ended.
        damages, damage_count: As of a `Session`.

    Raises:
        NotALogError: It has no index of ours beside it, or one that does not belong to it.
    """

    reversed_times: Final = 0

    def __init__(self, path: Path) -> None:
        self._folder = path.parent
        self.name, self.lines, kind = _sidecar_of(path)
        first = self.lines[0]
        self._kind = kind
        self._channel = sidecar.text_in(first, "channel", "can")
        self._damages = DamageList()
        self._turn = threading.Lock()
        self._cut_off: dict[int, list[FrameBatch]] = {}
        try:
            index = read_file(self._folder / f"{self.name}{index_file.SUFFIX}")
            self._blocks = self._present(list(index_file.read_blocks(index)))
            self._read_tail()
        except OSError as error:
            raise NotALogError(error_text(error)) from error
        self._starts_s = [block.first_s for block in self._blocks]
        marks = [*sidecar.marks_of(self.lines), *episode_marks(self.lines)]
        self.marks: Sequence[SessionMark] = sorted(marks, key=lambda mark: mark.at_s)

    @property
    def start_s(self) -> float:
        """Log time of the first frame, since 1970."""
        return self._blocks[0].first_s if self._blocks else 0.0

    @property
    def end_s(self) -> float:
        """Log time of the last frame."""
        return self._blocks[-1].last_s if self._blocks else 0.0

    @property
    def frames(self) -> int:
        """The number of frames."""
        return self._blocks[-1].first + self._blocks[-1].frames if self._blocks else 0

    @property
    def channels(self) -> tuple[Channel, ...]:
        """The single channel that was recorded."""
        return (self._channel,) if self._blocks else ()

    @property
    def damages(self) -> Sequence[Damage]:
        """The damaged places met so far."""
        return self._damages.since(0)

    @property
    def damage_count(self) -> int:
        """The number of all damaged places."""
        return self._damages.count

    @property
    def facts(self) -> Mapping[str, Any]:
        """The first line of its sidecar."""
        return self.lines[0]

    @property
    def lacks_counts(self) -> bool:
        """True if its faults and stops have not been counted yet."""
        return counts_in(self.lines) is None

    def keep_counts(self, marks: Sequence[SessionMark]) -> None:
        """Store the numbers of faults and stops in the sidecar."""
        counts = counts_of(marks)
        self.lines.append({"kind": "counted", **counts._asdict()})
        if is_over(self._folder, self.name, self.lines):
            keep(self._folder, self.name, counts)

    def frames_between(self, t0_s: float, t1_s: float) -> Iterator[FrameBatch]:
        """Yield the frames with t0_s <= time < t1_s, in the order of time."""
        place = max(bisect.bisect_right(self._starts_s, t0_s) - 1, 0)
        while place > 0 and self._blocks[place - 1].last_s >= t0_s - _SLACK_S:
            place -= 1
        for block in self._blocks[place:]:
            if block.first_s - _SLACK_S >= t1_s:
                break
            if block.last_s + _SLACK_S < t0_s:
                continue
            for batch in self._read(block):
                begin = int(batch.times_s.searchsorted(t0_s))
                end = int(batch.times_s.searchsorted(t1_s))
                if begin < end:
                    yield _part(batch, begin, end, block.first)

    def snapshot_at(self, t_s: float) -> FrameBatch:
        """Return the last frame of each identifier at or before a time, in the order of time."""
        place = bisect.bisect_right(self._starts_s, t_s + _SLACK_S) - 1
        parts: list[FrameBatch] = []
        while place >= 0:
            block = self._blocks[place]
            if block.standing is not None and block.last_s + _SLACK_S < t_s:
                parts.append(_batch(block.standing, (self._channel,), {}))
                break
            parts += reversed(self._read(block))
            place -= 1
        return _last_of_each(parts[::-1], t_s, (self._channel,))

    def close(self) -> None:
        """Release the memory."""
        self._blocks, self._starts_s, self._cut_off = [], [], {}

    def _path(self, number: int) -> Path:
        return self._folder / file_name(self.name, number, self._kind.value)

    def _read(self, block: Block) -> list[FrameBatch]:
        tail = self._cut_off.get(block.byte) if block.size == 0 else None
        if tail is not None:
            return tail
        try:
            with open_file(self._path(block.file)) as stream:
                stream.seek(block.byte)
                data = stream.read(block.size)
        except OSError as error:
            place = Told("byte {byte}", byte=block.byte)
            self._damages.add(Damage(place, error_text(error), block.first))
            return []
        with self._turn:
            return read_block(data, self._kind, block.file_start_s, self._damages, self._channel)

    def _present(self, blocks: list[Block]) -> list[Block]:
        """Return the blocks whose bytes are there."""
        sizes: dict[int, int] = {}
        found = []
        for block in blocks:
            if block.file not in sizes:
                path = self._path(block.file)
                sizes[block.file] = path.stat().st_size if path.exists() else 0
            if block.byte + block.size <= sizes[block.file]:
                found.append(block)
            else:
                place = Told("byte {byte}", byte=block.byte)
                reason = Told("the file breaks off before it")
                self._damages.add(Damage(place, reason, block.first))
        return found

    def _read_tail(self) -> None:
        """Index the blocks that a killed program had written and not indexed yet.

        Raises:
            NotALogError: The tail is longer than a killed program can have left.
        """
        last = self._blocks[-1] if self._blocks else None
        number = 1 if last is None else last.file
        byte = 0 if last is None else last.byte + last.size
        while (path := self._path(number)).exists():
            with open_file(path) as stream:
                if byte == 0:
                    byte = _opening_size(stream.read(_LONGEST_OPENING), self._kind)
                stream.seek(byte)
                data = stream.read(_LONGEST_TAIL + 1)
            if len(data) > _LONGEST_TAIL:
                raise NotALogError(Told("the index beside it does not belong to it"))
            self._take_tail(data, number)
            number, byte = number + 1, 0

    def _start_of(self, number: int) -> float:
        """Return the log time from which a file counts that the index does not know of."""
        for line in self.lines:
            start_s = sidecar.number_in(line, "start_s")
            if start_s is not None and line["kind"] == "file" and line.get("number") == number:
                return start_s
        return 0.0

    def _take_tail(self, data: bytes, number: int) -> None:
        if not data.strip(b"\0") or data.startswith(b"End TriggerBlock"):
            return
        last = self._blocks[-1] if self._blocks else None
        known = last is not None and last.file == number
        start_s = last.file_start_s if last is not None and known else self._start_of(number)
        found = read_block(data, self._kind, start_s, self._damages, self._channel)
        batches = [batch for batch in found if len(batch)]
        if not batches:
            return
        first = 0 if last is None else last.first + last.frames
        total = sum(map(len, batches))
        first_s, last_s = float(batches[0].times_s[0]), float(batches[-1].times_s[-1])
        block = Block(number, -number, 0, first, total, first_s, last_s, start_s)
        self._cut_off[block.byte] = batches
        self._blocks.append(block)


def _opening_size(beginning: bytes, kind: RecordingFormat) -> int:
    """Return the size in bytes of the file's beginning, in front of the first block."""
    if kind is RecordingFormat.BLF:
        return int.from_bytes(beginning[4:8], "little") if beginning[:4] == b"LOGG" else 0
    if kind is RecordingFormat.ASC:
        mark = b"internal events logged\n"
        return beginning.find(mark) + len(mark) if mark in beginning else 0
    return 0


def _sidecar_of(path: Path) -> tuple[str, list[dict[str, Any]], RecordingFormat]:
    """Return the name, lines and format of the recording that a file belongs to.

    Raises:
        NotALogError: It belongs to none.
    """
    name = path.name
    for suffix in (sidecar.SUFFIX, index_file.SUFFIX):
        if name.endswith(suffix):
            names: tuple[str, ...] = (name.removesuffix(suffix),)
            break
    else:
        names = names_of(path)
    for each in names:
        try:
            data = read_file(path.parent / f"{each}{sidecar.SUFFIX}")
        except OSError:
            continue
        lines = sidecar.read_lines(data)
        kind = sidecar.format_in(lines[0]) if lines and lines[0]["kind"] == "session" else None
        if kind is not None:
            return each, lines, kind
    raise NotALogError(Told("no log of this program: there is no sidecar beside it"))


def _part(batch: FrameBatch, begin: int, end: int, first: int) -> FrameBatch:
    if begin == 0 and end == len(batch):
        return replace(batch, first=first + batch.first)
    return FrameBatch(
        first=first + batch.first + begin,
        times_s=batch.times_s[begin:end],
        ids=batch.ids[begin:end],
        flags=batch.flags[begin:end],
        lengths=batch.lengths[begin:end],
        payloads=batch.payloads[begin:end],
        channels=batch.channels[begin:end],
        channel_names=batch.channel_names,
        long_data={
            row - begin: data for row, data in batch.long_data.items() if begin <= row < end
        },
    )


def _last_of_each(
    batches: Sequence[FrameBatch], t_s: float, names: tuple[Channel, ...]
) -> FrameBatch:
    """Return the last frames of each identifier up to a moment, of batches in order of time."""
    rows: dict[tuple[int, int], deque[tuple[FrameBatch, int]]] = {}
    key_flags = int(FrameFlag.EXTENDED | FrameFlag.TRANSMITTED)
    for batch in batches:
        end = int(batch.times_s.searchsorted(t_s, "right"))
        good = np.flatnonzero(batch.flags[:end] & (FrameFlag.ERROR | FrameFlag.IMPOSSIBLE) == 0)
        ids, marks = batch.ids[good], batch.flags[good] & key_flags
        keys = ids.astype(np.uint64) << 8 | marks
        _found, places = np.unique(keys[::-1], return_index=True)
        wanted = np.isin(ids, _REMEMBERED)
        wanted[len(good) - 1 - places] = True
        for place in np.flatnonzero(wanted).tolist():
            arbitration_id = int(ids[place])
            most = REMEMBERED if arbitration_id in REMEMBERED_IDS else 1
            kept = rows.setdefault((arbitration_id, int(marks[place])), deque(maxlen=most))
            kept.append((batch, int(good[place])))
    ordered = sorted(
        (found for kept in rows.values() for found in kept),
        key=lambda found: float(found[0].times_s[found[1]]),
    )
    return _picked(ordered, names)


def _picked(found: Sequence[tuple[FrameBatch, int]], names: tuple[Channel, ...]) -> FrameBatch:
    """Return single frames of several batches as one batch."""
    table = np.zeros(len(found), ROW)
    long_data = {}
    for place, (batch, row) in enumerate(found):
        table[place] = (
            batch.times_s[row],
            batch.ids[row],
            batch.flags[row],
            batch.lengths[row],
            batch.payloads[row],
        )
        if row in batch.long_data:
            long_data[place] = batch.long_data[row]
    return _batch(table, names, long_data)


def _batch(table: Any, names: tuple[Channel, ...], long_data: Mapping[int, bytes]) -> FrameBatch:
    return FrameBatch(
        first=0,
        times_s=table["time_s"],
        ids=table["id"],
        flags=table["flags"],
        lengths=table["length"],
        payloads=table["data"],
        channels=np.zeros(len(table), np.uint8),
        channel_names=names,
        long_data=long_data,
    )
