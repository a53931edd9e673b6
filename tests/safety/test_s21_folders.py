"""S2, S21, S22: folders of the library that others change, that lead elsewhere, that hang."""

import contextlib
import os
import shutil
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import pytest

from armui.trajectory.library.folders import FOLDER_GONE
from armui.trajectory.library.store import Library, LibraryError
from armui.trajectory.points.program import Trajectory
from armui.ui.background import Background
from armui.ui.trajectory.library.library_work import LibraryWork
from tests.app_driver import AtOnce, Slow
from tests.operator.library.actions import POINT
from tests.posix import make_pipe


def points(count, name="T"):
    return Trajectory(name, points=(POINT,) * count)


def places(library):
    return {entry.name: entry.folder for entry in library.entries()}


@pytest.fixture
def folder(tmp_path):
    library = Library(tmp_path / "trajectories")
    library.create_folder("cell")
    library.save(points(1))
    library.move(["T"], "cell")
    return library.folder


def test_what_is_edited_here_is_saved_where_the_other_moved_it(folder):
    ours, others = Library(folder), Library(folder)
    loaded = ours.load("T", to_edit=True)
    others.create_folder("line")
    others.move(["T"], "line")
    assert ours.save(replace(loaded, note="mine"), replacing="T") is False
    assert places(others) == {"T": "line"}
    assert others.load("T").note == "mine"


def test_what_another_program_saved_in_a_folder_is_in_the_bin(folder):
    ours, others = Library(folder), Library(folder)
    loaded = ours.load("T", to_edit=True)
    others.save(points(2), replacing="T")
    assert ours.save(replace(loaded, note="mine"), replacing="T") is True
    (deleted,) = ours.recently_deleted()
    (name,) = ours.restore(deleted)
    assert len(ours.load(name).points) == 2
    assert places(ours) == {"T": "cell", name: "cell"}


def test_a_folder_renamed_while_its_trajectory_is_edited_loses_nothing(folder):
    ours = Library(folder)
    loaded = ours.load("T", to_edit=True)
    (folder / "cell").rename(folder / "welding")
    ours.save(replace(loaded, note="mine"), replacing="T")
    assert places(ours) == {"T": "welding"}


def test_a_folder_deleted_while_its_trajectory_is_edited_loses_nothing(folder):
    ours = Library(folder)
    loaded = ours.load("T", to_edit=True)
    shutil.rmtree(folder / "cell")
    ours.save(replace(loaded, note="mine"), replacing="T")
    assert places(ours) == {"T": ""}
    assert ours.load("T").note == "mine"


def test_two_files_of_one_name_are_both_listed_and_both_kept(folder):
    library = Library(folder)
    library.create_folder("line")
    shutil.copy(folder / "cell" / "T.log", folder / "line" / "T.log")
    assert places(library) == {"T": "cell", "T (line)": "line"}
    library.save(points(3, "T (line)"), replacing="T (line)")
    assert [len(library.load(name).points) for name in ("T", "T (line)")] == [1, 3]


@pytest.mark.skipif(not hasattr(os, "symlink"), reason="no links here")
def test_a_link_that_leads_outside_is_not_followed(folder, tmp_path):
    outside = tmp_path / "outside"
    Library(outside).save(points(5, "foreign"))
    (folder / "link").symlink_to(outside, target_is_directory=True)
    library = Library(folder)
    assert library.listing().folders == ("cell",)
    assert places(library) == {"T": "cell"}
    with pytest.raises(LibraryError) as caught:
        library.move(["T"], "link")
    assert caught.value.refusal.reason == FOLDER_GONE
    library.new_in = "link"
    library.create("new")
    for change in (lambda: library.delete_folder("link"), lambda: library.create_folder("link")):
        with pytest.raises(LibraryError):
            change()
    assert places(library) == {"T": "cell", "new": ""}
    assert sorted(path.name for path in outside.glob("[!.]*")) == ["foreign.log"]


def test_a_link_in_the_place_of_a_deleted_folder_gets_nothing_back(folder, tmp_path):
    library = Library(folder)
    deleted = library.delete(["T"])
    library.delete_folder("cell")
    (tmp_path / "outside").mkdir()
    (folder / "cell").symlink_to(tmp_path / "outside", target_is_directory=True)
    assert library.restore(deleted) == ("T",)
    assert places(library) == {"T": ""}
    assert list((tmp_path / "outside").iterdir()) == []


@pytest.mark.timeout(30)
@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_a_pipe_in_a_folder_holds_nobody_up(folder):
    make_pipe(folder / "cell" / "pipe.log")
    make_pipe(folder / "pipe")
    assert Library(folder).listing().folders == ("cell",)
    assert places(Library(folder)) == {"T": "cell"}


def test_no_window_waits_for_a_folder_on_a_share_that_hangs(qapp, folder):
    slow = Slow()
    work = LibraryWork(Library(folder), Background(AtOnce(), slow), qapp)
    done: list[object] = []
    work.do(lambda: work.library.move(["T"], ""), done.append)
    work.do(lambda: work.library.delete_folder("cell"), done.append)
    assert done == []
    assert places(Library(folder)) == {"T": "cell"}
    slow.work()
    assert places(Library(folder)) == {"T": ""}


def test_two_programs_that_move_the_same_at_once_keep_it(folder):
    Library(folder).create_folder("line")

    def move(target):
        library = Library(folder)
        for _ in range(20):
            with contextlib.suppress(LibraryError):  # the other one was faster
                library.move(["T"], target)

    with ThreadPoolExecutor(2) as pool:
        list(pool.map(move, ["cell", "line"]))
    assert [path.name for path in folder.rglob("*.log")] == ["T.log"]
