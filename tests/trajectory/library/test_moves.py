"""Renamed, duplicated, deleted and brought back."""

from dataclasses import replace
from pathlib import Path

import pytest

from armui.arm.refusal_codes import RefusalCode
from armui.trajectory.files import TrajectoryFileError
from tests.trajectory.library.contents import names, opened, recording, refused, shown, trajectory


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
    assert refused(shelf.rename, "pick", "Place").code == RefusalCode.NAME_TAKEN
    shelf.save_draft("new", trajectory())
    assert refused(shelf.rename, "pick", "new").code == RefusalCode.NAME_TAKEN
    assert refused(shelf.rename, "pick", "").code == RefusalCode.NAME_EMPTY
    shelf.rename("pick", "pick")
    assert names(shelf) == ["Place", "new", "pick"]


def test_a_duplicate_is_the_same_under_another_name(shelf):
    shelf.save(recording())
    shelf.mark("wave", check="warnings", length_s=None)
    shelf.duplicate("wave", "wave 2")
    first, second = shelf.entries()
    assert second == replace(first, name="wave 2")
    assert shelf.load("wave 2") == replace(shelf.load("wave"), name="wave 2")
    assert refused(shelf.duplicate, "wave", "wave 2").code == RefusalCode.NAME_TAKEN


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
    room = room.rename(room.with_name("1000000000-aa"))
    (room / ".due").write_text("2002-01-01T00:00:00+00:00")  # when it was first found too old
    opened(folder).tidy()
    assert [path.name for path in (folder / ".deleted").iterdir()] == [
        young.places[0][1].parent.name
    ]
