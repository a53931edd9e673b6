"""What others do to the files: the cache notices, damage is told, nothing is lost."""

import os
from dataclasses import replace

import pytest

from armui.trajectory import files
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.files.text import NUMBER_BAD
from armui.trajectory.library.store import LIBRARY_DAMAGED, NAME_TAKEN
from tests.trajectory.library.contents import (
    damage,
    names,
    opened,
    recording,
    refused,
    shown,
    trajectory,
)

# Marks and the cache ------------------------------------------------------------------------------


def test_a_mark_lasts_until_the_file_changes(library, folder):
    library.save(trajectory())
    library.mark("pick", check="errors")
    (entry,) = opened(folder).entries()
    assert entry.check == "errors"

    (folder / "pick.log").write_bytes(files.to_bytes(trajectory(count=3), ".log"))

    (entry,) = library.entries()
    assert (entry.check, entry.count) == (None, 3)
    library.mark("pick", check="ok")
    library.save(trajectory(), replacing="pick")
    assert library.entries()[0].check is None


def test_a_listing_opens_only_what_is_new(library, folder, monkeypatch):
    library.save(trajectory())
    library.save(recording())
    read = []
    load = files.load

    def noted(path):
        read.append(path.name)
        return load(path)

    monkeypatch.setattr(files, "load", noted)
    again = opened(folder)
    assert len(again.entries()) == 2
    assert read == []
    (folder / "by hand.log").write_text("armui trajectory 1\n\nJ 0 0 0 0 0 0\n")
    assert names(again) == ["by hand", "pick", "wave"]
    assert read == ["by hand.log"]


@pytest.mark.parametrize(
    "text", ["", "{", "[]", '{"version": 1, "files": {"pick.log": [1]}}', "\0"]
)
def test_a_broken_cache_loses_nothing_but_marks(library, folder, text):
    library.save(trajectory())
    library.mark("pick", check="ok")
    (folder / ".index.json").write_text(text)
    (entry,) = opened(folder).entries()
    assert (entry.name, entry.count, entry.check) == ("pick", 2, None)


# Damage -------------------------------------------------------------------------------------------


def test_a_damaged_file_is_listed_with_its_fault_and_never_written_over(library, folder):
    library.save(trajectory("取/料", 4))
    library.save(trajectory("sound"))
    data = damage(folder, "取_料.log")

    for again in (library, opened(folder), opened(folder)):  # the last finds the fault in the cache
        entry = next(entry for entry in again.entries() if entry.name == "取/料")
        assert (entry.count, entry.check) == (0, None)
        assert entry.damage.refusal == NUMBER_BAD(value="o")
        assert str(entry.damage).startswith("取_料.log, line 7, column 7: ")
        with pytest.raises(TrajectoryFileError, match="line 7, column 7"):
            again.load("取/料")
        assert refused(again.save, trajectory("取/料")).reason == NAME_TAKEN
        assert refused(again.save, trajectory("取/料"), replacing="取/料").reason == LIBRARY_DAMAGED
        with pytest.raises(TrajectoryFileError):
            again.rename("取/料", "b")
        again.mark("取/料", check="ok")
        assert (folder / "取_料.log").read_bytes() == data
    deleted = library.delete(["取/料"])
    assert names(library) == ["sound"]
    library.restore(deleted)
    assert (folder / "取_料.log").read_bytes() == data


@pytest.mark.parametrize(
    "data", [b"", b"\xff\xff\x00", b"PK\x03\x04junk", b"armui recording 1\n\n1"]
)
@pytest.mark.parametrize("file", ["odd.log", "odd.npz"])
def test_files_of_no_sense_are_listed_as_damaged(library, folder, file, data):
    folder.mkdir()
    (folder / file).write_bytes(data)
    (entry,) = library.entries()
    assert entry.name == "odd"
    assert entry.damage.file == file


def test_a_copied_file_goes_by_its_own_name(library, folder):
    library.save(trajectory(count=1))
    (folder / "a copy.log").write_bytes((folder / "pick.log").read_bytes())
    (folder / "pick.npz").write_bytes(files.to_bytes(recording("pick"), ".npz"))

    assert names(library) == ["a copy", "pick", "pick 2"]
    copy = library.load("a copy")
    assert copy.name == "a copy"
    library.save(replace(copy, note="mine"), replacing="a copy")
    assert [entry.note for entry in opened(folder).entries()] == ["mine", "", ""]


def test_what_belongs_to_nobody_is_left_alone_and_remains_of_writes_are_not(library, folder):
    library.save(trajectory())
    (folder / "readme.txt").write_text("mine")
    (folder / "folder.log").mkdir()
    (folder / ".unseen.log").write_text("x")
    old, young = folder / ".1.unfinished", folder / ".2.unfinished"
    for path in (old, young):
        path.write_text("half a")
    os.utime(old, (1_000_000_000, 1_000_000_000))

    again = opened(folder)
    again.tidy()

    assert names(again) == ["pick"]
    assert not old.exists()
    assert young.exists()
    assert shown(folder) == ["folder.log", "pick.log", "readme.txt"]
