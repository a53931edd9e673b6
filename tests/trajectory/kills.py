"""Kills processes at random moments while they write into a library, and looks what is left.

    python -m tests.trajectory.kills FOLDER COUNT

Ends with 0 if after each kill every trajectory was whole: what it was before, or what was being
written. Prints how many kills met a write under way.
"""

from __future__ import annotations

import os
import random
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

from armui.protocol.codes import MoveMode
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from tests.posix import kill, of_system

STAYS = "never touched"
POINT = Waypoint(MoveMode.MOVE_J, (0.0, 10.0, -20.0, 0.0, 0.0, 0.0))


def points(name: str, version: int) -> Trajectory:
    """A trajectory in which every point bears the number of its version."""
    count = 20 + version % 7
    return Trajectory(name, str(version), (replace(POINT, note=str(version)),) * count)


def samples(name: str, version: int) -> Recording:
    """A recording in which every sample does."""
    values = np.full((200 + version % 7, 8), float(version % 100))
    return Recording(name, str(version), values)


def write_without_end(library: Library, version: int) -> None:
    """Saves, renames, deletes and drafts until it is killed."""
    while True:
        library.save(points("points", version), replacing="points")
        library.save(samples("samples", version), replacing="samples")
        library.save_draft("points", points("points", version))
        library.rename("moves", "moved")
        library.rename("moved", "moves")
        library.restore(library.delete(["deleted"]))
        version += 1


def whole(library: Library, folder: Path) -> int:
    """The newest version that was written, if everything is whole.

    Raises:
        AssertionError: Something is damaged, mixed or gone.
    """
    entries = {entry.name: entry for entry in library.entries()}
    damaged = [str(entry.damage) for entry in entries.values() if entry.damage is not None]
    assert not damaged, damaged
    for deleted in (folder / ".deleted").glob("*/*.log"):  # killed between deletion and undo
        deleted.rename(folder / deleted.name)
        entries["deleted"] = entries[STAYS]
    assert entries.keys() >= {STAYS, "points", "samples", "deleted"}, entries
    assert ("moves" in entries) != ("moved" in entries), entries
    if "moved" in entries:
        library.rename("moved", "moves")
    program, recording = library.load("points"), library.load("samples")
    assert isinstance(program, Trajectory)
    assert isinstance(recording, Recording)
    version = int(program.note)
    assert program.points == points("points", version).points
    expected = samples("samples", int(recording.note))
    assert np.array_equal(recording.samples, expected.samples)
    draft = library.draft("points")
    assert draft is None or draft.points == points("points", int(draft.note)).points
    assert library.load(STAYS).note == "7"
    assert entries["points"].count == len(program.points)
    return version


def kill_once(folder: Path, version: int, after_s: float) -> None:
    """Lets a process of its own write for a while, then kills it as a power cut would."""
    ready, begun = os.pipe()
    child = of_system("fork")()
    if child == 0:
        try:
            library = Library(folder)
            os.write(begun, b"!")
            write_without_end(library, version)
        finally:
            os._exit(1)
    os.read(ready, 1)
    time.sleep(after_s)
    kill(child)
    _, status = os.waitpid(child, 0)
    os.close(ready)
    os.close(begun)
    assert of_system("WIFSIGNALED")(status), "the writer ended by itself"


def main(folder: Path, count: int) -> int:
    """Kill so many times."""
    chance = random.Random(5)
    library = Library(folder)
    for content in (points("points", 0), samples("samples", 0), points(STAYS, 7)):
        library.save(content)
    for name in ("moves", "deleted"):
        library.save(points(name, 0))
    under_way = version = 0
    for _ in range(count):
        kill_once(folder, version + 1, chance.uniform(0.0, 0.005))
        remains = list(folder.glob(".*.unfinished"))
        under_way += bool(remains)
        for path in remains:
            path.unlink()
        version = whole(Library(folder), folder)
    print(f"{count} kills, {under_way} in the middle of a write, {version} versions written")
    return 0 if under_way else 1


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), int(sys.argv[2])))
