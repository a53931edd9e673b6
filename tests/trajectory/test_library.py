"""The library: what it lists, keeps, deletes and brings back, whatever others do to its files."""

from __future__ import annotations

import os
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings

from armui.protocol.codes import MoveMode
from armui.trajectory import files, library
from armui.trajectory.file_names import file_stem, folded, free_stem
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library import Library, LibraryError
from armui.trajectory.program import LONGEST_NAME, Trajectory, Waypoint, check_name
from armui.trajectory.recording import Recording
from tests.trajectory.strategies import NAME, TEXT

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


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "trajectories"


@pytest.fixture
def shelf(folder):
    return opened(folder)


def names(shelf):
    return [entry.name for entry in shelf.entries()]


def shown(folder):
    return sorted(path.name for path in folder.iterdir() if not path.name.startswith("."))


def refused(call, *arguments, **options):
    with pytest.raises(LibraryError) as caught:
        call(*arguments, **options)
    return caught.value.refusal


# Keeping ------------------------------------------------------------------------------------------


def test_a_library_not_yet_there_is_empty(shelf, folder):
    assert shelf.entries() == []
    assert shelf.drafts() == []
    assert not folder.exists()


def test_what_is_saved_is_listed_and_loaded(shelf, folder):
    shelf.save(trajectory(note="for the tray"))
    shelf.save(recording())

    assert shown(folder) == ["pick.log", "wave.npz"]
    for again in (shelf, opened(folder)):
        pick, wave = again.entries()
        assert (pick.name, pick.kind, pick.count, pick.length_s) == ("pick", "points", 2, None)
        assert (pick.note, pick.modified, pick.check, pick.damage) == (
            *("for the tray", NOW),
            *(None, None),
        )
        assert (wave.name, wave.kind, wave.count, wave.length_s) == ("wave", "recording", 3, 1.25)
        assert again.load("pick") == replace(trajectory(note="for the tray"), modified=NOW)
        assert again.load("wave") == replace(recording(), modified=NOW)


def test_nothing_is_replaced_unasked(shelf):
    shelf.save(trajectory(count=1))

    refusal = refused(shelf.save, trajectory(count=5))

    assert (refusal.code, refusal.params) == ("name_taken", {"name": "pick"})
    assert len(shelf.load("pick").points) == 1
    shelf.save(trajectory(count=5), replacing="pick")
    assert len(shelf.load("pick").points) == 5
    assert names(shelf) == ["pick"]


def test_what_replaces_another_may_bear_another_name_or_be_of_another_kind(shelf, folder):
    shelf.save(trajectory())
    shelf.save(trajectory("place"), replacing="pick")
    assert shown(folder) == ["place.log"]
    shelf.save(recording("place"), replacing="place")
    assert shown(folder) == ["place.npz"]
    shelf.save(recording(), replacing="gone by now")
    assert names(shelf) == ["place", "wave"]


def test_what_could_not_be_read_again_is_not_kept(shelf, folder):
    bad = replace(trajectory(), points=(POINT, replace(POINT, speed_percent=0)))
    with pytest.raises(LibraryError, match=r"row 2: point_out_of_range\(.*speed") as caught:
        shelf.save(bad)
    assert caught.value.row == 2
    assert refused(shelf.save, trajectory(" ")).code == "name_empty"
    assert refused(shelf.save_draft, "pick", bad).code == "point_out_of_range"
    assert not folder.exists()


def test_a_folder_that_takes_nothing_says_so(tmp_path):
    (tmp_path / "file").write_text("in the way")
    shelf = opened(tmp_path / "file")

    refusal = refused(shelf.save, trajectory())

    assert refusal.code == "library_not_saved"
    assert refusal.params["name"] == "pick"
    assert refusal.params["text"]
    assert refused(shelf.save_draft, "pick", trajectory()).code == "library_not_saved"


# Names --------------------------------------------------------------------------------------------

ODD_NAMES = [
    *("取料/放料: 第1步?", "a<b>|c\"d*e\\f", "CON", "nul.log", "com1", ".hidden", "..", "~x", "x."),
    *("ends in a space ", "🦾" * LONGEST_NAME, "Run", "run", "RUN", "é", "e\u0301", "ß", "ss"),
    *("a\u200bb", "a_b", "a/b", "a:b", "a\tb", "a.draft", "a.npz", "-rf", "ﬁ", "fi", "\u202eb"),
]  # fmt: skip


def test_every_name_finds_its_file_even_where_case_counts_nothing(shelf, folder):
    for count, name in enumerate(ODD_NAMES):
        shelf.save(trajectory(name, count))
    assert names(shelf) == sorted(ODD_NAMES)
    again = opened(folder)
    for count, name in enumerate(ODD_NAMES):
        assert len(again.load(name).points) == count
    stems = {folded(Path(file).stem) for file in shown(folder)}
    assert len(stems) == len(ODD_NAMES)


@settings(max_examples=200)
@given(TEXT | NAME)
def test_a_file_name_is_one_everywhere(name):
    stem = file_stem(name)
    assert stem
    assert len(stem.encode()) <= 125
    assert not set('<>:"/\\|?*') & set(stem)
    assert stem.isprintable()
    assert not stem.startswith((".", " ", "~"))
    assert not stem.endswith((".", " "))
    assert file_stem(stem) == stem


@pytest.mark.parametrize("device", ["con", "NUL", "lpt9", "Com1.tar"])
def test_no_file_is_called_like_a_device(device):
    assert file_stem(device) == f"_{device}"


def test_a_stem_is_numbered_until_it_is_free():
    assert free_stem("Run", {"run", "run 2"}) == "Run 3"


def test_a_free_name(shelf):
    assert shelf.free_name("pick") == "pick"
    shelf.save(trajectory())
    shelf.save_draft("pick 2", trajectory())
    assert shelf.free_name("pick") == "pick 3"
    for wish in ("", "\n", "a\nb", "\ud800x\0", "x" * 1000):
        assert check_name(shelf.free_name(wish)) is None
    assert shelf.free_name("a\nb") == "a b"


# Rename, duplicate, delete ------------------------------------------------------------------------


def test_a_trajectory_is_renamed_with_its_mark_and_its_draft(shelf, folder):
    shelf.save(trajectory())
    shelf.mark("pick", check="ok", length_s=4.5)
    shelf.save_draft("pick", trajectory(count=7))

    shelf.rename("pick", "place")

    (entry,) = shelf.entries()
    assert (entry.name, entry.check, entry.length_s) == ("place", "ok", 4.5)
    assert shown(folder) == ["place.draft", "place.log"]
    assert shelf.drafts() == ["place"]
    assert len(shelf.draft("place").points) == 7
    shelf.rename("place", "Place")
    assert shown(folder)[-1].lower() == "place.log"
    assert names(shelf) == ["Place"]
    shelf.save(trajectory())
    assert refused(shelf.rename, "pick", "Place").code == "name_taken"
    shelf.save_draft("new", trajectory())
    assert refused(shelf.rename, "pick", "new").code == "name_taken"
    assert refused(shelf.rename, "pick", "").code == "name_empty"
    shelf.rename("pick", "pick")
    assert names(shelf) == ["Place", "pick"]


def test_a_duplicate_is_the_same_under_another_name(shelf):
    shelf.save(recording())
    shelf.mark("wave", check="warnings", length_s=None)
    shelf.duplicate("wave", "wave 2")
    first, second = shelf.entries()
    assert second == replace(first, name="wave 2")
    assert shelf.load("wave 2") == replace(shelf.load("wave"), name="wave 2")
    assert refused(shelf.duplicate, "wave", "wave 2").code == "name_taken"


def test_what_is_gone_is_said_to_be(shelf):
    for call in (
        shelf.load,
        lambda name: shelf.rename(name, "b"),
        lambda n: shelf.duplicate(n, "b"),
    ):
        with pytest.raises(TrajectoryFileError, match="a: is not in the library any more"):
            call("a")
    shelf.drop_draft("a")
    shelf.mark("a", check="ok", length_s=1.0)
    assert shelf.delete(["a"]).names == ()
    assert shelf.draft("a") is None


def test_a_deletion_is_undone(shelf, folder):
    shelf.save(trajectory())
    shelf.save(recording())
    shelf.save(trajectory("stays"))
    shelf.save_draft("pick", trajectory(count=9))
    kept = shelf.load("pick")

    deleted = shelf.delete(["pick", "wave", "pick"])

    assert deleted.names == ("pick", "wave")
    assert names(shelf) == ["stays"]
    assert shelf.drafts() == []
    opened(folder).restore(deleted)
    assert names(shelf) == ["pick", "stays", "wave"]
    assert shelf.load("pick") == kept
    assert len(shelf.draft("pick").points) == 9
    assert list((folder / ".deleted").iterdir()) == []


def test_what_is_brought_back_replaces_nothing(shelf):
    shelf.save(trajectory(count=1))
    deleted = shelf.delete(["pick"])
    shelf.save(trajectory(count=2))

    shelf.restore(deleted)

    assert names(shelf) == ["pick", "pick 2"]
    assert [len(shelf.load(name).points) for name in ("pick", "pick 2")] == [2, 1]


def test_a_deletion_that_fails_half_way_deletes_nothing(shelf, folder, monkeypatch):
    shelf.save(trajectory("a"))
    shelf.save(trajectory("b"))
    move = Path.replace

    def fail_at_b(path, target):
        if path.name == "b.log":
            raise PermissionError(13, "Permission denied")
        return move(path, target)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", fail_at_b)
        refusal = refused(shelf.delete, ["a", "b"])
    assert (refusal.code, refusal.params["text"]) == ("library_not_deleted", "Permission denied")
    assert names(shelf) == ["a", "b"]


def test_the_bin_is_emptied_of_what_is_old(shelf, folder):
    shelf.save(trajectory("a"))
    shelf.save(trajectory("b"))
    old, young = shelf.delete(["a"]), shelf.delete(["b"])
    room = old.places[0][1].parent
    room.rename(room.with_name("1000000000-aa"))
    opened(folder)
    assert [path.name for path in (folder / ".deleted").iterdir()] == [
        young.places[0][1].parent.name
    ]


# Marks and the cache ------------------------------------------------------------------------------


def test_a_mark_lasts_until_the_file_changes(shelf, folder):
    shelf.save(trajectory())
    shelf.mark("pick", check="errors", length_s=12.5)
    (entry,) = opened(folder).entries()
    assert (entry.check, entry.length_s) == ("errors", 12.5)

    (folder / "pick.log").write_bytes(files.to_bytes(trajectory(count=3), ".log"))

    (entry,) = shelf.entries()
    assert (entry.check, entry.length_s, entry.count) == (None, None, 3)
    shelf.mark("pick", check="ok", length_s=1.0)
    shelf.save(trajectory(), replacing="pick")
    assert shelf.entries()[0].check is None


def test_a_listing_opens_only_what_is_new(shelf, folder, monkeypatch):
    shelf.save(trajectory())
    shelf.save(recording())
    read = []
    load = files.load
    monkeypatch.setattr(library.files, "load", lambda path: read.append(path.name) or load(path))
    again = opened(folder)
    assert len(again.entries()) == 2
    assert read == []
    (folder / "by hand.log").write_text("armui trajectory 1\n\nJ 0 0 0 0 0 0\n")
    assert names(again) == ["by hand", "pick", "wave"]
    assert read == ["by hand.log"]


@pytest.mark.parametrize(
    "text", ["", "{", "[]", '{"version": 1, "files": {"pick.log": [1]}}', "\0"]
)
def test_a_broken_cache_loses_nothing_but_marks(shelf, folder, text):
    shelf.save(trajectory())
    shelf.mark("pick", check="ok", length_s=1.0)
    (folder / ".index.json").write_text(text)
    (entry,) = opened(folder).entries()
    assert (entry.name, entry.count, entry.check) == ("pick", 2, None)


# What others do to the files ----------------------------------------------------------------------


def damage(folder, file="pick.log", row=7):
    path = folder / file
    lines = path.read_text().split("\n")
    lines[row - 1] = "J 0 0 o 0 0 0"
    path.write_text("\n".join(lines))
    return path.read_bytes()


def test_a_damaged_file_is_listed_with_its_fault_and_never_written_over(shelf, folder):
    shelf.save(trajectory("取/料", 4))
    shelf.save(trajectory("sound"))
    data = damage(folder, "取_料.log")

    for again in (shelf, opened(folder), opened(folder)):  # the last finds the fault in the cache
        entry = next(entry for entry in again.entries() if entry.name == "取/料")
        assert (entry.count, entry.check) == (0, None)
        assert str(entry.damage) == "取_料.log, line 7, column 7: “o” is no number"
        with pytest.raises(TrajectoryFileError, match="line 7, column 7"):
            again.load("取/料")
        assert refused(again.save, trajectory("取/料")).code == "name_taken"
        assert refused(again.save, trajectory("取/料"), replacing="取/料").code == "library_damaged"
        with pytest.raises(TrajectoryFileError):
            again.rename("取/料", "b")
        again.mark("取/料", check="ok", length_s=1.0)
        assert (folder / "取_料.log").read_bytes() == data
    deleted = shelf.delete(["取/料"])
    assert names(shelf) == ["sound"]
    shelf.restore(deleted)
    assert (folder / "取_料.log").read_bytes() == data


@pytest.mark.parametrize(
    "data", [b"", b"\xff\xff\x00", b"PK\x03\x04junk", b"armui recording 1\n\n1"]
)
@pytest.mark.parametrize("file", ["odd.log", "odd.npz"])
def test_files_of_no_sense_are_listed_as_damaged(shelf, folder, file, data):
    folder.mkdir()
    (folder / file).write_bytes(data)
    (entry,) = shelf.entries()
    assert entry.name == "odd"
    assert entry.damage.file == file


def test_a_copied_file_goes_by_its_own_name(shelf, folder):
    shelf.save(trajectory(count=1))
    (folder / "a copy.log").write_bytes((folder / "pick.log").read_bytes())
    (folder / "pick.npz").write_bytes(files.to_bytes(recording("pick"), ".npz"))

    assert names(shelf) == ["a copy", "pick", "pick 2"]
    copy = shelf.load("a copy")
    assert copy.name == "a copy"
    shelf.save(replace(copy, note="mine"), replacing="a copy")
    assert [entry.note for entry in opened(folder).entries()] == ["mine", "", ""]


def test_what_belongs_to_nobody_is_left_alone_and_remains_of_writes_are_not(shelf, folder):
    shelf.save(trajectory())
    (folder / "readme.txt").write_text("mine")
    (folder / "folder.log").mkdir()
    (folder / ".unseen.log").write_text("x")
    old, young = folder / ".1.unfinished", folder / ".2.unfinished"
    for path in (old, young):
        path.write_text("half a")
    os.utime(old, (1_000_000_000, 1_000_000_000))

    again = opened(folder)

    assert names(again) == ["pick"]
    assert not old.exists()
    assert young.exists()
    assert shown(folder) == ["folder.log", "pick.log", "readme.txt"]


# Drafts -------------------------------------------------------------------------------------------


def test_a_draft_outlives_the_program_until_the_trajectory_is_saved(shelf, folder):
    shelf.save(trajectory(count=1))
    shelf.save_draft("pick", trajectory(count=2))
    shelf.save_draft("pick", trajectory(count=3))
    shelf.save_draft("a/b \\ 新", trajectory(count=4))

    again = opened(folder)

    assert again.drafts() == ["a/b \\ 新", "pick"]
    assert len(again.draft("pick").points) == 3
    assert len(again.draft("a/b \\ 新").points) == 4
    assert again.draft("pick").modified == NOW
    assert len(again.load("pick").points) == 1
    assert names(again) == ["pick"]
    again.save(trajectory(count=3), replacing="pick")
    again.drop_draft("a/b \\ 新")
    assert again.drafts() == []
    assert shown(folder) == ["pick.log"]


def test_a_damaged_draft_says_where(shelf, folder):
    shelf.save_draft("pick", trajectory(count=4))
    damage(folder, "pick.draft")
    assert shelf.drafts() == ["pick"]
    with pytest.raises(TrajectoryFileError, match="line 7, column 7"):
        shelf.draft("pick")


# Import -------------------------------------------------------------------------------------------


def test_good_files_are_taken_and_bad_ones_told(tmp_path):
    good = files.to_bytes(trajectory(), ".csv")
    (tmp_path / "1.csv").write_bytes(good)
    (tmp_path / "2.log").write_text("armui trajectory 1\n\nJ 0 0 o 0 0 0\n")
    (tmp_path / "3.json").write_bytes(files.to_bytes(recording(), ".json"))

    contents, errors = files.import_files(
        [tmp_path / name for name in ("1.csv", "2.log", "3.json", "4.log")]
    )

    assert contents == [trajectory(), recording()]
    assert [error.file for error in errors] == ["2.log", "4.log"]
    assert (errors[0].line, errors[0].column) == (3, 7)
    assert str(errors[1]).startswith("4.log: cannot be read")
