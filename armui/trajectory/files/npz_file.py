"""`.npz`, the library's format for recordings: numpy's archive, which other programs can open.

It has two members: `samples` (n, 8) and `header`, a JSON text of the name, the note and the time.
"""

from __future__ import annotations

import io
import json
import zipfile
from typing import BinaryIO, Final

import numpy as np

from armui.arm.json_fields import FieldError, Fields
from armui.trajectory.files.errors import FILE_DAMAGED, TrajectoryFileError, broken, field_refusal
from armui.trajectory.files.model import LARGEST_BYTES, Content, parse_time, verified, verify
from armui.trajectory.samples.recording import COLUMN_COUNT, Recording

MAGIC: Final = b"PK\x03\x04"
_SAMPLES: Final = "samples.npy"
_HEADER: Final = "header.npy"


def write(recording: Recording) -> bytes:
    """Return a recording as the bytes of an archive, uncompressed.

    Raises:
        UnwritableError: The recording cannot be written.
    """
    verify(recording)
    header = json.dumps(
        {
            "name": recording.name,
            "note": recording.note,
            "modified": recording.modified.isoformat(),
            "taught_on": recording.taught_on,
        }
    )
    stream = io.BytesIO()
    np.savez(stream, header=np.array(header), samples=recording.samples)
    return stream.getvalue()


def read(data: bytes) -> Content:
    """Return the recording in an archive.

    Raises:
        TrajectoryFileError: The bytes are no such archive, or damaged.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            header = _array(_member(archive, _HEADER))
            samples = _array(_member(archive, _SAMPLES))
        fields = Fields(json.loads(str(header)))
        name, note = fields.text("name"), fields.text("note")
        taught_on = fields.text("taught_on", "")
        modified = parse_time(fields.text("modified"), 0, 0)
    except TrajectoryFileError:
        raise
    except FieldError as error:
        raise TrajectoryFileError(field_refusal(error)) from error
    except Exception as error:  # zipfile and numpy raise a dozen kinds on damaged archives
        raise broken(FILE_DAMAGED, text=str(error)) from error
    if samples.ndim != 2 or samples.shape[1] != COLUMN_COUNT or samples.dtype.kind != "f":
        raise broken(FILE_DAMAGED, text=f"samples {samples.dtype} {samples.shape}")
    return verified(Recording(name, note, samples.astype(np.float64), modified, taught_on))


def name_in(file: BinaryIO) -> str | None:
    """Return the recording's name in an archive, or ``None`` if it is damaged."""
    try:
        with zipfile.ZipFile(file) as archive:
            header = json.loads(str(_array(_member(archive, _HEADER))))
        return Fields(header).text("name") or None
    except Exception:  # noqa: BLE001 - as above: a dozen kinds
        return None


def _member(archive: zipfile.ZipFile, name: str) -> bytes:
    """Return a member's bytes, unless they claim to be more than any recording has."""
    if archive.getinfo(name).file_size > LARGEST_BYTES:
        raise broken(FILE_DAMAGED, text=f"{name} is too large")
    return archive.read(name)


def _array(data: bytes) -> np.ndarray:
    array: np.ndarray = np.lib.format.read_array(io.BytesIO(data), allow_pickle=False)
    return array
