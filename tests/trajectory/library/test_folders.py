"""Sub-folders of the library: made, renamed, deleted; trajectories moved, deleted, brought back."""

import errno
import json
import os
import shutil
from pathlib import Path

import pytest

from armui.trajectory.files import to_bytes
from armui.trajectory.library import stored_files
from armui.trajectory.library.folders import (
    FOLDER_GONE,
    FOLDER_NAME_UNUSABLE,
    FOLDER_NAMELESS,
    FOLDER_NOT_EMPTY,
    FOLDER_TAKEN,
)
from armui.trajectory.library.history import LibraryHistory
from armui.trajectory.library.importing import import_files
from armui.trajectory.library.run_options import RunOptions
from tests.trajectory.library.contents import locked, names, opened, refused, shown, trajectory


def places(library):
    return {entry.name: entry.folder for entry in library.entries()}


@pytest.fixture
def cell(library, folder):
    """Two folders, and a trajectory in the first that was checked."""
    library.create_folder("cell")
    library.create_folder("line")
    library.save(trajectory())
    library.mark("pick", check="ok")
    library.move(["pick"], "cell")
    return library


def test_a_moved_trajectory_keeps_its_name_its_mark_and_its_draft(cell, folder):
    cell.save_draft("pick", trajectory(count=7))
    assert cell.move(["pick"], "line") == ("pick",)
    for library in (cell, opened(folder)):
        (entry,) = library.entries()
        assert (entry.name, entry.folder) == ("pick", "line")
        assert entry.check == "ok"
    assert shown(folder / "line") == ["pick.log"]
    assert shown(folder) == ["cell", "line", "pick.draft"]
    assert len(cell.draft("pick").points) == 7
    assert cell.move(["pick", "unknown"], "") == ("pick",)
    assert places(cell) == {"pick": ""}


def test_what_is_saved_renamed_or_copied_stays_in_its_folder(cell):
    cell.save(trajectory(count=3), replacing="pick")
    cell.rename("pick", "place")
    cell.duplicate("place", "place 2")
    assert places(cell) == {"place": "cell", "place 2": "cell"}


def test_what_is_new_goes_to_the_folder_that_is_shown(cell, folder, tmp_path):
    file = tmp_path / "new.log"
    file.write_bytes(to_bytes(trajectory("import"), ".log"))
    cell.new_in = "line"
    cell.create("made")
    import_files(folder, [file], "line")
    shutil.rmtree(folder / "cell")
    cell.new_in = "cell"  # gone meanwhile: it is kept all the same
    cell.create("kept")
    assert places(cell) == {"made": "line", "import": "line", "kept": ""}


def test_names_are_one_for_all_folders(cell):
    assert refused(cell.create, "pick").code == "name_taken"
    assert cell.free_name("pick") == "pick 2"


def test_a_deleted_trajectory_goes_back_to_its_folder(cell, folder):
    cell.rename_folder("cell", "Cell")
    cell.delete(["pick"])
    cell.delete_folder("Cell")
    (deleted,) = opened(folder).recently_deleted()
    assert deleted.folder == "Cell"
    cell.restore(deleted)
    assert places(cell) == {"pick": "Cell"}
    assert list((folder / ".deleted").iterdir()) == []


def test_files_of_one_name_are_both_in_the_bin(cell, folder):
    shutil.copy(folder / "cell" / "pick.log", folder / "line" / "pick.log")
    both = names(cell)
    assert both == ["pick", "pick (line)"]
    deleted = cell.delete(both)
    cell.restore(deleted)
    assert sorted(places(cell).values()) == ["cell", "line"]


def test_nothing_is_replaced_by_a_move(cell, folder):
    shutil.copy(folder / "cell" / "pick.log", folder / "line" / "pick.log")
    before = (folder / "line" / "pick.log").read_bytes()
    assert cell.move(["pick"], "line") == ("pick 2 (line)",)
    assert shown(folder / "line") == ["pick 2.log", "pick.log"]
    assert (folder / "line" / "pick.log").read_bytes() == before
    assert names(cell) == ["pick", "pick 2 (line)"]


def test_a_move_that_fails_half_way_moves_nothing(library, folder, monkeypatch):
    library.create_folder("cell")
    library.save(trajectory("a"))
    library.save(trajectory("b"))
    with locked(monkeypatch, "b.log"):
        refusal = refused(library.move, ["a", "b"], "cell")
    assert (refusal.code, refusal.params["text"]) == ("folder_not_changed", "Permission denied")
    assert places(library) == {"a": "", "b": ""}


@pytest.mark.parametrize("name", ["a/b", "..", ".deleted", "con", "x ", "a:b"])
def test_what_is_no_folder_s_name_is_refused(library, folder, name):
    assert refused(library.create_folder, name).reason == FOLDER_NAME_UNUSABLE
    assert not folder.exists()


def test_names_of_folders_are_taken_once(cell, folder):
    assert refused(cell.create_folder, "").reason == FOLDER_NAMELESS
    assert refused(cell.create_folder, "CELL").reason == FOLDER_TAKEN
    assert refused(cell.rename_folder, "cell", "Line").reason == FOLDER_TAKEN
    cell.rename_folder("cell", "weld")
    cell.rename_folder("weld", "weld")
    assert cell.listing().folders == ("line", "weld")
    (entry,) = opened(folder).entries()
    assert (entry.folder, entry.check) == ("weld", "ok")


def test_only_an_empty_folder_is_deleted(cell, folder):
    refusal = refused(cell.delete_folder, "cell")
    assert refusal.reason == FOLDER_NOT_EMPTY
    assert refusal.params["held"] == "pick.log"
    cell.delete_folder("line")
    assert cell.listing().folders == ("cell",)
    assert refused(cell.delete_folder, "line").reason == FOLDER_GONE
    assert refused(cell.rename_folder, "line", "new").reason == FOLDER_GONE
    assert refused(cell.move, ["pick"], "line").reason == FOLDER_GONE
    assert places(cell) == {"pick": "cell"}


def test_a_move_is_undone(cell):
    cell.save(trajectory("top"))
    history = LibraryHistory(cell)
    history.move(["pick", "top"], "line")
    assert places(cell) == {"pick": "line", "top": "line"}
    history.drop_outdated(cell.listing())
    assert set(history.undo()) == {"pick", "top"}
    assert places(cell) == {"pick": "cell", "top": ""}
    history.move(["pick"], "line")
    cell.move(["pick"], "")
    history.drop_outdated(cell.listing())
    assert history.last is None


def test_an_index_from_before_there_were_folders_is_read(library, folder):
    library.save(trajectory())
    library.mark("pick", check="ok")
    index = json.loads((folder / ".index.json").read_text())
    assert (index["version"], list(index["files"])) == (3, ["pick.log"])
    index["files"]["pick.log"][3]["length_s"] = 4.5  # once as checked, from where the arm stood
    (folder / ".index.json").write_text(json.dumps(index))
    (entry,) = opened(folder).entries()
    assert (entry.check, entry.length_s) == ("ok", None)


def test_an_entry_that_does_not_tell_frames_is_read_anew(library, folder):
    """A mark that an older program made may be of points in a frame that has moved since."""
    library.save(trajectory())
    library.mark("pick", check="ok")
    index = json.loads((folder / ".index.json").read_text())
    del index["files"]["pick.log"][3]["frames"]
    (folder / ".index.json").write_text(json.dumps(index))
    (entry,) = opened(folder).entries()
    assert (entry.name, entry.check, entry.frames) == ("pick", None, ())


@pytest.mark.parametrize("factor", [0.5, 1.0, 2])
def test_the_speed_that_a_run_once_had_is_read_and_is_written_as_full(library, folder, factor):
    library.save(trajectory())
    library.note_run("pick", RunOptions(cycles=3, step_by_step=True))
    path = folder / ".index.json"
    index = json.loads(path.read_text())
    index["files"]["pick.log"][3]["ran_with"]["speed_factor"] = factor
    path.write_text(json.dumps(index))
    old = opened(folder)
    (entry,) = old.entries()
    assert entry.ran_with == RunOptions(cycles=3, step_by_step=True)
    old.save(trajectory("other"))
    kept = json.loads(path.read_text())["files"]["pick.log"][3]["ran_with"]
    assert kept == {"cycles": 3, "first": 0, "step_by_step": True, "speed_factor": 1}
    assert opened(folder).entries()[1].ran_with == entry.ran_with


def test_what_old_deletions_held_in_folders_is_removed_in_time(cell, folder):
    (_, place) = cell.delete(["pick"]).places[0]
    room = place.parent.parent
    room = room.rename(room.with_name("1000000000-aa"))
    (room / ".due").write_text("2002-01-01T00:00:00+00:00")
    opened(folder).tidy()
    assert not room.exists()


@pytest.mark.parametrize("number", [errno.EACCES, errno.EIO, errno.ESTALE, errno.ENOTCONN])
def test_a_folder_that_cannot_be_read_hides_no_other(cell, folder, monkeypatch, number):
    cell.save(trajectory("top"))
    look = stored_files._files

    def refuse(path):
        if path.name == "cell":
            raise OSError(number, os.strerror(number))
        return look(path)

    with monkeypatch.context() as patch:
        patch.setattr(stored_files, "_files", refuse)
        seen = cell.listing()
    assert (seen.folders, seen.closed) == (("cell", "line"), ("cell",))
    assert [entry.name for entry in seen.entries] == ["top"]
    assert {entry.name: entry.check for entry in cell.entries()}["pick"] == "ok"


@pytest.mark.parametrize("number", [errno.EIO, errno.ESTALE])
def test_a_folder_that_cannot_even_be_looked_at_is_no_lost_one(cell, monkeypatch, number):
    cell.save(trajectory("top"))
    look_at, look = Path.lstat, stored_files._files

    def refuse(path):
        if path.name == "cell":
            raise OSError(number, os.strerror(number))
        return look_at(path)

    def refuse_files(path):
        refuse(path)
        return look(path)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "lstat", refuse)
        patch.setattr(stored_files, "_files", refuse_files)
        seen = cell.listing()
    assert (seen.folders, seen.closed) == (("cell", "line"), ("cell",))
    assert [entry.name for entry in seen.entries] == ["top"]
    assert {entry.name: entry.check for entry in cell.entries()}["pick"] == "ok"


def test_a_folder_that_goes_while_it_is_read_is_none(cell, folder, monkeypatch):
    look = stored_files._files

    def race(path):
        if path.name == "line":
            path.rmdir()
        return look(path)

    monkeypatch.setattr(stored_files, "_files", race)
    seen = cell.listing()
    assert (seen.folders, seen.closed) == (("cell",), ())


@pytest.mark.parametrize("where", ["", "cell"])
def test_a_file_that_cannot_be_looked_at_hides_no_other(cell, folder, monkeypatch, where):
    """As one on a share that is gone."""
    cell.save(trajectory("top"))
    (folder / where / "lost.log").write_bytes(b"")
    look_at = Path.stat

    def refuse(path, **more):
        if path.name == "lost.log":
            raise OSError(errno.ESTALE, os.strerror(errno.ESTALE))
        return look_at(path, **more)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "stat", refuse)
        found = {entry.name: entry for entry in cell.entries()}
    assert found.keys() == {"lost", "pick", "top"}
    assert found["lost"].damage is not None
    assert found["pick"].check == "ok"


@pytest.mark.skipif(not hasattr(os, "symlink"), reason="no links here")
@pytest.mark.parametrize("where", ["", "cell"])
def test_a_link_that_leads_in_a_circle_hides_no_other(cell, folder, where):
    place = folder / where / "round.log"
    place.symlink_to(place)
    found = {entry.name: entry for entry in cell.entries()}
    assert found.keys() == {"pick", "round"}
    assert found["round"].damage is not None
