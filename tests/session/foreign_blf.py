"""BLF files as other tools write them, object by object."""

from __future__ import annotations

import struct
import zlib

BASE = struct.Struct("<4sHHLL")
FILE_HEADER = struct.Struct("<4sLBBBBBBBBQQLL8H8H")


def obj(kind: int, body: bytes, time_ns: int = 0, version: int = 1, size: int | None = None):
    """An object with its header (1: flags, client, version, time; 2: with one more time)."""
    if version == 1:
        head = struct.pack("<LHHQ", 2, 0, 0, time_ns)
    else:
        head = struct.pack("<LBxHQQ", 2, 0, 0, time_ns, time_ns)
    header_size = BASE.size + len(head)
    whole = header_size + len(body) if size is None else size
    data = BASE.pack(b"LOBJ", header_size, version, whole, kind) + head + body
    return data + bytes(whole % 4)


def frame(arbitration_id: int, data: bytes, time_ns: int = 0, *, kind: int = 86, **more) -> bytes:
    """CAN_MESSAGE (1) or CAN_MESSAGE2 (86): channel, flags, dlc, id, data[, length, bits, …]."""
    body = struct.pack("<HBBL8s", 1, 0, more.pop("dlc", len(data)), arbitration_id, data)
    return obj(kind, body + (bytes(8) if kind == 86 else b""), time_ns, **more)


def container(data: bytes, *, packed: bool = True) -> bytes:
    """A container object."""
    inside = zlib.compress(data) if packed else data
    body = struct.pack("<H6xL4x", 2 if packed else 0, len(data)) + inside
    size = BASE.size + len(body)
    return BASE.pack(b"LOBJ", BASE.size, 1, size, 10) + body + bytes(size % 4)


def file(*parts: bytes, header_size: int = 144) -> bytes:
    """A file with its header."""
    header = FILE_HEADER.pack(
        b"LOGG", header_size, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, *[0] * 8, *[0] * 8
    )
    return header.ljust(header_size, b"\0") + b"".join(parts)
