"""Files that no reader should trust."""

import json
import struct
from pathlib import Path


def write_glb_beyond_its_vertices(path: Path) -> None:
    """A mesh whose triangle names a vertex that is not there: it ends the process that draws it."""
    vertices = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    triangle = struct.pack("<3I", 0, 1, 99_999_999)
    views = [(0, len(vertices)), (len(vertices), len(triangle))]
    description = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": 3,
                "type": "VEC3",
                "max": [1, 1, 0],
                "min": [0, 0, 0],
            },
            {"bufferView": 1, "componentType": 5125, "count": 3, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": start, "byteLength": length} for start, length in views
        ],
        "buffers": [{"byteLength": len(vertices) + len(triangle)}],
    }
    _write_glb(path, description, vertices + triangle)


def write_stl(path: Path, *, claimed: int, corners_m: tuple[float, ...] = ()) -> None:
    """A binary STL file that claims so many triangles, and has those whose corners are given."""
    triangles = len(corners_m) // 9
    body = b"".join(
        struct.pack("<12fH", 0, 0, 1, *corners_m[9 * row : 9 * row + 9], 0)
        for row in range(triangles)
    )
    path.write_bytes(bytes(80) + struct.pack("<I", claimed) + body)


def write_glb_of_zeros(path: Path, count: int) -> None:
    """A mesh of some hundred bytes that claims so many vertices, all zero: none is in the file."""
    triangle = struct.pack("<3I", 0, 1, 2)
    description = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"componentType": 5126, "count": count, "type": "VEC3"},
            {"bufferView": 0, "componentType": 5125, "count": 3, "type": "SCALAR"},
        ],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": len(triangle)}],
        "buffers": [{"byteLength": len(triangle)}],
    }
    _write_glb(path, description, triangle)


def _write_glb(path: Path, description: object, data: bytes) -> None:
    text = json.dumps(description).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(
        struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(data))
        + struct.pack("<I4s", len(text), b"JSON")
        + text
        + struct.pack("<I4s", len(data), b"BIN\0")
        + data
    )
