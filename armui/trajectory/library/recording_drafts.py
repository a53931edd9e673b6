"""Recordings that are not saved, kept through a crash: a folder each, beside the library's files.

A file of samples grows as the arm is recorded: a line of JSON first, then eight little-endian
doubles a sample, as in `Recording`. Whoever records holds a lock in the folder; the operating
system lets go of it when the program is killed, and the next one offers what it finds.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Final

import numpy as np

from armui.arm.json_fields import FieldError, Fields
from armui.system.files import open_file, read_file
from armui.system.presence import Presence
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.files.model import LARGEST_BYTES, parse_time
from armui.trajectory.library.stored_files import Call, call_directly
from armui.trajectory.samples.recording import COLUMN_COUNT, Array, Recording, check_samples

_SAMPLES: Final = "samples"
_LONGEST_HEADER: Final = 4096
_FIGURE: Final = np.dtype("<f8")
_ROW_BYTES: Final = COLUMN_COUNT * _FIGURE.itemsize
_LARGE_BYTES: Final = 1 << 20


class RecordingDraft:
    """A recording that is under way, or not saved yet.

    Args:
        folder: Of its own; it need not exist.
        name: What the recording will be called.
        taught_on: The arm it is of, as `ModelFit.taught_on` tells.
        begun: When it was begun.
    """

    def __init__(self, folder: Path, name: str, taught_on: str, begun: datetime) -> None:
        self._folder = folder
        self._presence = Presence(folder)
        header = {"name": name, "taught_on": taught_on, "begun": begun.isoformat()}
        self._header = json.dumps(header).encode() + b"\n"
        self.name = name

    def append(self, samples: Array) -> None:
        """Append samples to the file; the first ones make it.

        Raises:
            OSError: The disk does not take them.
        """
        path = self._folder / _SAMPLES
        data = samples.astype(_FIGURE).tobytes()
        if not self._folder.is_dir():
            self._folder.mkdir(parents=True)
            with contextlib.suppress(OSError):  # some network disks know no locks
                self._presence.enter()
            data = self._header + data
        with open_file(path, "ab") as file:
            file.write(data)

    def drop(self) -> None:
        """Remove the file: the recording is saved, or not wanted.

        Raises:
            OSError: It cannot be removed.
        """
        self._presence.leave()
        if self._folder.is_dir():
            shutil.rmtree(self._folder)


@dataclass(frozen=True, slots=True)
class UnsavedRecording:
    """A recording that a killed program has left.

    Attributes:
        folder: Where it is kept.
        name: What it was to be called.
        begun: When it was begun.
        count: How many samples there are.
        taught_on: The arm it is of; "": not known.
    """

    folder: Path
    name: str
    begun: datetime
    count: int
    taught_on: str


class RecordingDrafts:
    """The unsaved recordings in a folder.

    Args:
        folder: It need not exist.
        call: Where large files are read.
    """

    def __init__(self, folder: Path, call: Call = call_directly) -> None:
        self._folder = folder
        self._call = call

    def begin(self, name: str, taught_on: str) -> RecordingDraft:
        """Return a draft of what is recorded from now on; it touches no disk yet."""
        folder = self._folder / f"{os.getpid()}-{os.urandom(4).hex()}"
        return RecordingDraft(folder, name, taught_on, datetime.now().astimezone())

    def abandoned(self) -> list[UnsavedRecording]:
        """Return those whose program is gone, the oldest first; what is none of ours is left out.

        Raises:
            OSError: The folder cannot be read.
        """
        return sorted(self._abandoned(), key=lambda one: one.begun)

    def _abandoned(self) -> Iterator[UnsavedRecording]:
        for folder in self._folder.glob("*-*"):
            path = folder / _SAMPLES
            if not path.is_file() or Presence(folder).others():
                continue
            with contextlib.suppress(OSError, ValueError, FieldError, TrajectoryFileError):
                with open_file(path) as file:
                    line = file.readline(_LONGEST_HEADER)
                fields = Fields(json.loads(line))
                count = (path.stat().st_size - len(line)) // _ROW_BYTES
                begun = parse_time(fields.text("begun"), 0, 0)
                if count > 0:
                    yield UnsavedRecording(
                        folder, fields.text("name"), begun, count, fields.text("taught_on", "")
                    )

    def load(self, unsaved: UnsavedRecording) -> Recording:
        """Return what was recorded, up to the first sample that cannot be.

        Raises:
            OSError: It cannot be read.
        """
        path = unsaved.folder / _SAMPLES
        call = self._call if path.stat().st_size >= _LARGE_BYTES else call_directly
        samples: Array = call(read_samples, path)
        return Recording(
            unsaved.name, samples=samples, modified=unsaved.begun, taught_on=unsaved.taught_on
        )

    def drop(self, unsaved: UnsavedRecording) -> None:
        """Remove one.

        Raises:
            OSError: It cannot be removed.
        """
        shutil.rmtree(unsaved.folder)


def read_samples(path: Path) -> Array:
    """Return the whole samples of a draft's file; a power cut may have left others behind them.

    The disk knows blocks and no samples: the last one before what cannot be may be torn, with
    zeros in the place of its angles, so it is left out as well.

    Raises:
        OSError: It cannot be read, or is larger than any file of ours.
    """
    data = read_file(path, LARGEST_BYTES)
    begin = data.index(b"\n") + 1
    count = (len(data) - begin) // _ROW_BYTES
    figures = np.frombuffer(data, _FIGURE, count * COLUMN_COUNT, begin)
    samples = figures.astype(np.float64).reshape(count, COLUMN_COUNT)
    fault = check_samples(samples)
    return samples if fault is None else samples[: max(0, fault[0] - 2)]
