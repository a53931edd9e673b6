"""What is put into a library, and what it then shows."""

from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from armui.protocol.codes import MoveMode
from armui.trajectory.library.store import Library, LibraryError
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording

NOW = datetime(2026, 3, 4, 5, 6, 7, tzinfo=UTC)
POINT = Waypoint(MoveMode.MOVE_J, (0.0, 10.0, -20.0, 0.0, 0.0, 0.0))


def trajectory(name="pick", count=2, note=""):
    return Trajectory(name, note, (POINT,) * count)


def recording(name="wave"):
    samples = np.zeros((3, 8))
    samples[:, 0] = 0.0, 0.5, 1.25
    return Recording(name, samples=samples)


def opened(folder):
    return Library(folder, lambda: NOW)


def names(library):
    return [entry.name for entry in library.entries()]


def shown(folder):
    return sorted(path.name for path in folder.iterdir() if not path.name.startswith("."))


def refused(call, *arguments, **options):
    with pytest.raises(LibraryError) as caught:
        call(*arguments, **options)
    return caught.value.refusal


def damage(folder, file="pick.log", row=7):
    path = folder / file
    lines = path.read_text().split("\n")
    lines[row - 1] = "J 0 0 o 0 0 0"
    path.write_text("\n".join(lines))
    return path.read_bytes()


@contextmanager
def locked(monkeypatch, name):
    """A file of the library that the system lets nobody move."""
    move = Path.replace

    def refuse(path, target):
        if path.name == name:
            raise PermissionError(13, "Permission denied")
        return move(path, target)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", refuse)
        yield
