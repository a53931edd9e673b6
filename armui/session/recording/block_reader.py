"""Reads single blocks of a recording of ours, without what stands before them."""

from __future__ import annotations

import struct
import zlib
from typing import TYPE_CHECKING, Final

import numpy as np
from can.io import blf

from armui.protocol.frame import FrameFlag
from armui.session.blf_logs import read_blf_log
from armui.session.frames import CLASSIC_BYTES, DamageList, FrameBatch
from armui.session.gather import Gatherer
from armui.session.recording.blf_format import MESSAGE, BlfFormat
from armui.session.recording.kinds import RecordingFormat
from armui.session.source import LogSource
from armui.session.text_formats import ASC, CANDUMP
from armui.session.text_logs import read_text_log

if TYPE_CHECKING:
    from collections.abc import Iterator

    from armui.session.frames import Channel

_HEAD: Final = blf.OBJ_HEADER_BASE_STRUCT.size
_CONTAINER: Final = blf.LOG_CONTAINER_STRUCT
_ASC_OPENING: Final = b"base hex  timestamps absolute\nno internal events logged\n"


def read_block(
    data: bytes, kind: RecordingFormat, start_s: float, damages: DamageList, channel: str
) -> list[FrameBatch]:
    """The frames of a block.

    Args:
        data: The bytes of the block.
        kind: Their format.
        start_s: Time since 1970 from which the file counts, where it does.
        damages: Where damaged places are noted.
        channel: What every frame's channel is called.

    Returns:
        Batches with log times; the first one's first frame has the number 0.
    """
    names: tuple[Channel, ...] = (channel,)
    quick = _quick_batch(data, start_s, names) if kind is RecordingFormat.BLF else None
    if quick is not None:
        return [quick]
    gatherer = Gatherer(damages)
    if kind is not RecordingFormat.BLF:
        data = _whole_lines(data, gatherer)
    found = []
    for batch in _batches(data, kind, start_s, gatherer):
        times_s = batch.times_s + start_s if kind is RecordingFormat.ASC else batch.times_s
        found.append(
            FrameBatch(
                batch.first,
                times_s,
                batch.ids,
                batch.flags,
                batch.lengths,
                batch.payloads,
                np.zeros(len(batch), np.uint8),
                names,
                batch.long_data,
            )
        )
    return found


def _whole_lines(data: bytes, gatherer: Gatherer) -> bytes:
    """Without a last line that was cut: what is left of it may look like a shorter frame."""
    end = data.rfind(b"\n") + 1
    if end < len(data):
        gatherer.note(f"byte {end} of a block", "the file breaks off in a line", 0)
    return data[:end]


def _batches(
    data: bytes, kind: RecordingFormat, start_s: float, gatherer: Gatherer
) -> Iterator[FrameBatch]:
    if kind is RecordingFormat.BLF:
        source = LogSource(BlfFormat(start_s).opening() + data)
        return read_blf_log(source, gatherer)
    if kind is RecordingFormat.ASC:
        return read_text_log(LogSource(_ASC_OPENING + data), ASC, gatherer)
    return read_text_log(LogSource(data), CANDUMP, gatherer)


def _quick_batch(data: bytes, start_s: float, names: tuple[Channel, ...]) -> FrameBatch | None:
    """A block that is one whole container of classic data frames; None if it is anything else."""
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
