"""Renamed, duplicated, deleted and brought back."""

from dataclasses import replace

import pytest

from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.store import NAME_TAKEN
from armui.trajectory.points.program import NAME_EMPTY
from tests.trajectory.library.contents import (
    locked,
    names,
    opened,
    recording,
    refused,
    shown,
    trajectory,
)


def test_a_trajectory_is_renamed_with_its_mark_and_its_draft(library, folder):
    library.save(trajectory())
    library.mark("pick", check="ok")
    library.save_draft("pick", trajectory(count=7))

    library.rename("pick", "place")

    (entry,) = library.entries()
    assert (entry.name, entry.check) == ("place", "ok")
    assert shown(folder) == ["place.draft", "place.log"]
    assert library.drafts() == ["place"]
    assert len(library.draft("place").points) == 7
    library.rename("place", "Place")
    assert shown(folder)[-1].lower() == "place.log"
    assert names(library) == ["Place"]
    library.save(trajectory())
    assert refused(library.rename, "pick", "Place").reason == NAME_TAKEN
    library.save_draft("new", trajectory())
    assert refused(library.rename, "pick", "new").reason == NAME_TAKEN
    assert refused(library.rename, "pick", "").reason == NAME_EMPTY
    library.rename("pick", "pick")
    assert names(library) == ["Place", "new", "pick"]


def test_a_duplicate_is_the_same_under_another_name(library):
    library.save(recording())
    library.mark("wave", check="warnings")
    library.duplicate("wave", "wave 2")
    first, second = library.entries()
    assert second == replace(first, name="wave 2")
    assert library.load("wave 2") == replace(library.load("wave"), name="wave 2")
    assert refused(library.duplicate, "wave", "wave 2").reason == NAME_TAKEN


def test_what_is_gone_is_said_to_be(library):
    for call in (
        library.load,
        lambda name: library.rename(name, "b"),
        lambda n: library.duplicate(n, "b"),
    ):
        with pytest.raises(TrajectoryFileError, match="a: It is not in the library any more"):
            call("a")
    library.drop_draft("a")
    library.mark("a", check="ok")
    assert library.delete(["a"]).names == ()
    assert library.draft("a") is None


def test_a_deletion_is_undone(library, folder):
    library.save(trajectory())
    library.save(recording())
    library.save(trajectory("stays"))
    library.save_draft("pick", trajectory(count=9))
    kept = library.load("pick")

    deleted = library.delete(["pick", "wave", "pick"])

    assert deleted.names == ("pick", "wave")
    assert names(library) == ["stays"]
    assert library.drafts() == []
    opened(folder).restore(deleted)
    assert names(library) == ["pick", "stays", "wave"]
    assert library.load("pick") == kept
    assert len(library.draft("pick").points) == 9
    assert list((folder / ".deleted").iterdir()) == []


def test_what_is_brought_back_replaces_nothing(library):
    library.save(trajectory(count=1))
    deleted = library.delete(["pick"])
    library.save(trajectory(count=2))

    library.restore(deleted)

    assert names(library) == ["pick", "pick 2"]
    assert [len(library.load(name).points) for name in ("pick", "pick 2")] == [2, 1]


def test_a_deletion_that_fails_half_way_deletes_nothing(library, folder, monkeypatch):
    library.save(trajectory("a"))
    library.save(trajectory("b"))
    with locked(monkeypatch, "b.log"):
        refusal = refused(library.delete, ["a", "b"])
    assert (refusal.code, refusal.params["text"]) == ("library_not_deleted", "Permission denied")
    assert names(library) == ["a", "b"]


def test_the_bin_is_emptied_of_what_is_old(library, folder):
    library.save(trajectory("a"))
    library.save(trajectory("b"))
    old, young = library.delete(["a"]), library.delete(["b"])
    room = old.places[0][1].parent
    room = room.rename(room.with_name("1000000000-aa"))
    (room / ".due").write_text("2002-01-01T00:00:00+00:00")  # when it was first found too old
    opened(folder).tidy()
    assert [path.name for path in (folder / ".deleted").iterdir()] == [
        young.places[0][1].parent.name
    ]
