"""Unsaved states of trajectories that were never saved, or whose file somebody has removed."""

import pytest

from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.store import NAME_TAKEN
from armui.trajectory.points.program import NAME_EMPTY, Trajectory
from tests.trajectory.library.contents import names, opened, refused, shown, trajectory


def test_a_draft_without_a_trajectory_is_listed_as_what_it_is(library, folder):
    library.save_draft("pick", trajectory(count=3, note="for the tray"))
    library.save(trajectory("place"))
    library.save_draft("place", trajectory("place", 9))

    for again in (library, opened(folder)):
        pick, place = again.entries()
        assert (pick.name, pick.kind, pick.count) == ("pick", "draft", 3)
        assert (pick.note, pick.check, pick.length_s, pick.damage) == (
            *("for the tray", None),
            *(None, None),
        )
        assert (place.kind, place.count) == ("points", 2)


def test_it_is_listed_when_its_trajectory_vanishes_and_no_more_when_it_is_saved(library, folder):
    library.save(trajectory())
    library.save_draft("pick", trajectory(count=7))
    (folder / "pick.log").unlink()
    assert [(entry.kind, entry.count) for entry in library.entries()] == [("draft", 7)]
    with pytest.raises(TrajectoryFileError, match="not in the library"):
        library.load("pick")
    library.save(library.draft("pick"), replacing="pick")
    assert [(entry.kind, entry.count) for entry in library.entries()] == [("points", 7)]
    assert library.drafts() == []


def test_it_is_read_again_when_it_changes(library):
    library.save_draft("pick", trajectory(count=3))
    assert library.entries()[0].count == 3
    library.save_draft("pick", trajectory(count=40))
    assert library.entries()[0].count == 40


def test_a_damaged_draft_is_listed_with_its_fault(library, folder):
    library.save_draft("pick", trajectory())
    (folder / "pick.draft").write_text("armui trajectory 1\nname: pick\n\nJ 1 2\n")
    (entry,) = library.entries()
    assert str(entry.damage) == "pick.draft, line 4, column 1: 2 numbers where 6 belong."


def test_it_gets_another_name(library, folder):
    library.save_draft("pick", trajectory(count=3))
    library.save(trajectory("place"))
    assert refused(library.rename, "pick", "place").reason == NAME_TAKEN
    assert refused(library.rename, "pick", "").reason == NAME_EMPTY
    library.rename("pick", "grip")
    assert names(library) == ["grip", "place"]
    assert shown(folder) == ["grip.draft", "place.log"]
    assert len(library.draft("grip").points) == 3


def test_discarded_it_can_be_brought_back(library):
    library.save_draft("pick", trajectory(count=3))
    deleted = library.delete(["pick"])
    assert deleted.names == ("pick",)
    assert deleted.only_draft
    assert names(library) == []
    assert library.restore(deleted) == ("pick",)
    assert len(library.draft("pick").points) == 3


def test_brought_back_it_belongs_to_no_other_trajectory(library):
    library.save_draft("pick", trajectory(count=3))
    deleted = library.delete(["pick"])
    library.save(trajectory(count=1))

    assert library.restore(deleted) == ("pick 2",)

    assert library.draft("pick") is None
    assert len(library.draft("pick 2").points) == 3


def test_a_trajectory_brought_back_gets_no_others_draft(library):
    library.save(trajectory(count=1))
    deleted = library.delete(["pick"])
    library.save_draft("pick", trajectory(count=3))

    assert library.restore(deleted) == ("pick 2",)

    assert [(entry.name, entry.kind, entry.count) for entry in library.entries()] == [
        ("pick", "draft", 3),
        ("pick 2", "points", 1),
    ]
    assert library.load("pick 2") == Trajectory(
        "pick 2", "", trajectory(count=1).points, library.load("pick 2").modified
    )


def test_its_own_draft_comes_back_with_it_under_another_name(library):
    library.save(trajectory(count=1))
    library.save_draft("pick", trajectory(count=5))
    deleted = library.delete(["pick"])
    library.save(trajectory(count=2))

    assert library.restore(deleted) == ("pick 2",)

    assert [entry.count for entry in library.entries()] == [2, 1]
    assert library.drafts() == ["pick 2"]
    assert len(library.draft("pick 2").points) == 5
