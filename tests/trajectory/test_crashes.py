"""A program killed while it writes, and a disk that refuses: every trajectory stays whole."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from armui.protocol.codes import MoveMode
from armui.trajectory.library.store import Library, LibraryError
from armui.trajectory.points.program import Trajectory, Waypoint
from tests.examples import examples

POINT = Waypoint(MoveMode.MOVE_J, (0.0, 10.0, -20.0, 0.0, 0.0, 0.0))
OLD = Trajectory("pick", "old", (POINT,) * 2)
NEW = Trajectory("pick", "new", (POINT,) * 5)
KILLS = examples(200)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="kills processes that it forked")
@pytest.mark.timeout(300)
def test_kills_during_writes_lose_nothing(tmp_path):
    done = subprocess.run(
        [sys.executable, "-m", "tests.trajectory.kills", str(tmp_path), str(KILLS)],
        cwd=Path(__file__).parents[2],
        env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},  # a fork takes no threads along
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.startswith(f"{KILLS} kills")


OPEN = os.open


class FullDisk:
    """Lets so many steps of writing pass, and refuses the one after them."""

    def __init__(self, monkeypatch, steps):
        self.left = steps
        for owner, name in ((os, "open"), (os, "fdopen"), (os, "fsync"), (Path, "replace")):
            monkeypatch.setattr(owner, name, self.counted(getattr(owner, name)))

    def counted(self, call):
        def step(*arguments, **options):
            if call is OPEN and not arguments[1] & (os.O_WRONLY | os.O_RDWR):
                return call(*arguments, **options)  # a full disk lets one read
            self.left -= 1
            if self.left == -1:
                raise OSError(28, "No space left on device")
            return call(*arguments, **options)

        return step


ACTIONS = {
    "save": lambda library: library.save(NEW, replacing="pick"),
    "save another": lambda library: library.save(replace(NEW, name="other")),
    "rename": lambda library: library.rename("pick", "other"),
    "duplicate": lambda library: library.duplicate("pick", "other"),
    "delete": lambda library: library.delete(["pick"]),
    "draft": lambda library: library.save_draft("pick", NEW),
}


@pytest.mark.parametrize("action", ACTIONS)
def test_a_disk_that_refuses_any_one_step_is_named_and_changes_nothing(
    tmp_path, monkeypatch, action
):
    refusals = 0
    for steps in range(40):
        folder = tmp_path / str(steps)
        library = Library(folder)
        library.save(OLD)
        before = [(entry.name, entry.count, entry.note) for entry in library.entries()]
        with monkeypatch.context() as patch:
            disk = FullDisk(patch, steps)
            error = None
            try:
                ACTIONS[action](library)
            except LibraryError as caught:
                error = caught
        if error is not None:
            refusals += 1
            assert error.refusal.params["text"] == "No space left on device"
        after = Library(folder).entries()
        assert Library(folder).drafts() == (["pick"] if action == "draft" and not error else [])
        assert all(entry.damage is None for entry in after)
        if error is not None:
            assert [(entry.name, entry.count, entry.note) for entry in after] == before
        assert list(folder.glob(".*.unfinished")) == []
        if disk.left >= 0:
            assert error is None
            break
    assert disk.left >= 0, "the disk never let it pass"
    assert refusals
