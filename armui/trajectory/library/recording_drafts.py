"""Unsaved recordings, kept through a crash: a folder each, beside the library's files.

Samples are appended to a file while the arm is recorded: first a line of JSON, then eight
little-endian doubles a sample, as in `Recording`. The recording program holds a lock in the folder;
the operating system releases it when the program is killed, and the next program offers to save the
recording.
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
    """A recording that is in progress, or not saved yet.

    Args:
        folder: Its own folder; it need not exist.
        name: The name of the recording.
        taught_on: The arm it is of, as in `ModelFit.taught_on`.
        begun: The time at which it began.
    """

    def __init__(self, folder: Path, name: str, taught_on: str, begun: datetime) -> None:
        self._folder = folder
        self._presence = Presence(folder)
        header = {"name": name, "taught_on": taught_on, "begun": begun.isoformat()}
        self._header = json.dumps(header).encode() + b"\n"
        self.name = name

    def append(self, samples: Array) -> None:
        """Append samples to the file, which is created with the first ones.

        Raises:
            OSError: They cannot be written.
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
        """Delete the file, because the recording is saved or not wanted.

        Raises:
            OSError: It cannot be deleted.
        """
        self._presence.leave()
        if self._folder.is_dir():
            shutil.rmtree(self._folder)


@dataclass(frozen=True, slots=True)
class UnsavedRecording:
    """An unsaved recording of a program that was killed.

    Attributes:
        folder: Its folder.
        name: The name it was to have.
        begun: The time at which it began.
        count: The number of samples.
        taught_on: The arm it is of; "" if not known.
    """

    folder: Path
    name: str
    begun: datetime
    count: int
    taught_on: str


class RecordingDrafts:
    """The unsaved recordings in a folder.

    Args:
        folder: The folder; it need not exist.
        call: Calls the function that reads a large file.
    """

    def __init__(self, folder: Path, call: Call = call_directly) -> None:
        self._folder = folder
        self._call = call

    def begin(self, name: str, taught_on: str) -> RecordingDraft:
        """Return a draft for a new recording; nothing is written to the disk yet."""
        folder = self._folder / f"{os.getpid()}-{os.urandom(4).hex()}"
        return RecordingDraft(folder, name, taught_on, datetime.now().astimezone())

    def abandoned(self) -> list[UnsavedRecording]:
        """Return the drafts of programs that have ended, the oldest first; others are ignored.

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
        """Return the recording up to the first invalid sample.

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
        """Delete an unsaved recording.

        Raises:
            OSError: It cannot be deleted.
        """
        shutil.rmtree(unsaved.folder)


def read_samples(path: Path) -> Array:
    """Return the intact samples of a draft's file; a power cut may have left damaged ones behind.

    The disk writes blocks, not samples: the last one before an invalid sample may be torn, with
    zeros in place of its angles, so it is left out as well.

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
