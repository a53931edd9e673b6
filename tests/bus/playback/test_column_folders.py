"""Folders that killed programs left are removed, and no others."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import pytest

from armui.system.scratch import make_folder, remove_leftovers

HOUR_S, MONTH_S = 3600.0, 30 * 86_400.0


@pytest.fixture(autouse=True)
def _own_place(tmp_path, monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))


@pytest.fixture(scope="module")
def ended():
    """The number of a process that lives no more."""
    process = subprocess.Popen([sys.executable, "-c", ""])
    process.wait()
    return process.pid


def folder(place, name, age_s):
    made = place / name
    made.mkdir()
    (made / "times_s.column").write_bytes(bytes(800))
    at_s = time.time() - age_s
    os.utime(made, (at_s, at_s))
    return made


def test_what_a_living_program_uses_stays(tmp_path):
    ours = make_folder("replay")
    old = folder(tmp_path, f"armui-replay-{os.getpid()}-abcd", HOUR_S)

    assert remove_leftovers() == 0
    assert ours.path.is_dir()
    assert old.is_dir()


def test_what_a_killed_program_left_is_removed(tmp_path, ended):
    left = folder(tmp_path, f"armui-replay-{ended}-abcd", HOUR_S)
    worked = folder(tmp_path, f"armui-work-{ended}-abcd", HOUR_S)
    nameless = folder(tmp_path, "armui-replay-abcd1234", MONTH_S)

    assert remove_leftovers() == 3
    assert not left.exists()
    assert not worked.exists()
    assert not nameless.exists()


def test_a_held_lock_says_that_a_program_lives_whatever_its_number(tmp_path, ended):
    """In a container another program's number says nothing, and numbers are given anew."""
    held = folder(tmp_path, f"armui-work-{ended}-held", MONTH_S)
    reused = folder(tmp_path, f"armui-work-{os.getpid()}-reused", HOUR_S)
    (reused / "in-use.lock").touch()
    os.utime(reused, (time.time() - HOUR_S,) * 2)
    hold = "import sys, filelock; lock = filelock.FileLock(sys.argv[1]); lock.acquire()"
    holder = subprocess.Popen(
        [
            sys.executable,
            "-c",
            f"{hold}; print(flush=True); sys.stdin.read()",
            str(held / "in-use.lock"),
        ],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
    )
    with holder:
        assert holder.stdout.readline() == b"\n"
        os.utime(held, (time.time() - MONTH_S,) * 2)
        assert remove_leftovers() == 1
        assert held.is_dir()
        assert not reused.exists()
        holder.kill()
        holder.wait()
    os.utime(held, (time.time() - MONTH_S,) * 2)
    assert remove_leftovers() == 1
    assert list(tmp_path.iterdir()) == []


def test_the_lock_goes_with_its_folder(tmp_path):
    ours = make_folder("work")
    assert [each.name for each in ours.path.iterdir()] == ["in-use.lock"]
    os.utime(ours.path, (time.time() - MONTH_S,) * 2)
    assert remove_leftovers() == 0
    (ours.path / "times_s.column").touch()
    (ours.path / "more").mkdir()
    ours.remove()
    assert list(tmp_path.iterdir()) == []
    ours.remove()


def test_a_folder_that_nobody_uses_any_more_is_not_locked(tmp_path):
    ours = make_folder("work")
    path = ours.path
    os.utime(path, (time.time() - MONTH_S,) * 2)
    del ours
    assert remove_leftovers() == 1


def test_what_cannot_be_removed_yet_stays_locked(tmp_path, monkeypatch):
    """Windows removes no file that is open."""
    ours = make_folder("replay")
    (ours.path / "times_s.column").touch()
    with monkeypatch.context() as patch:

        def refuse(_path):
            raise PermissionError(13, "it is open")

        patch.setattr(Path, "unlink", refuse)
        ours.remove()
    os.utime(ours.path, (time.time() - MONTH_S,) * 2)
    assert remove_leftovers() == 0
    assert (ours.path / "times_s.column").exists()
    ours.remove()
    assert list(tmp_path.iterdir()) == []


def test_what_is_young_or_not_ours_stays(tmp_path, ended):
    stay = [
        folder(tmp_path, f"armui-replay-{ended}-young", 5.0),
        folder(tmp_path, "armui-replay-abcd1234", HOUR_S),
        folder(tmp_path, "armui-replay-my own notes", MONTH_S),
        folder(tmp_path, f"other-{ended}-abcd", MONTH_S),
    ]
    target = folder(tmp_path, "kept", MONTH_S)
    link = tmp_path / f"armui-replay-{ended}-link"
    link.symlink_to(target)
    (tmp_path / f"armui-replay-{ended}-file").write_bytes(b"")

    assert remove_leftovers() == 0
    assert all(each.is_dir() for each in (*stay, target))
