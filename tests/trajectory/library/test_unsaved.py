"""Unsaved states of trajectories that were never saved, or whose file somebody has removed."""

import pytest

from armui.arm.refusal_codes import RefusalCode
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.points.program import Trajectory
from tests.trajectory.library.contents import names, opened, refused, shown, trajectory


def test_a_draft_without_a_trajectory_is_listed_as_what_it_is(shelf, folder):
    shelf.save_draft("pick", trajectory(count=3, note="for the tray"))
    shelf.save(trajectory("place"))
    shelf.save_draft("place", trajectory("place", 9))

    for again in (shelf, opened(folder)):
        pick, place = again.entries()
        assert (pick.name, pick.kind, pick.count) == ("pick", "draft", 3)
        assert (pick.note, pick.check, pick.length_s, pick.damage) == (
            *("for the tray", None),
            *(None, None),
        )
        assert (place.kind, place.count) == ("points", 2)


def test_it_is_listed_when_its_trajectory_vanishes_and_no_more_when_it_is_saved(shelf, folder):
    shelf.save(trajectory())
    shelf.save_draft("pick", trajectory(count=7))
    (folder / "pick.log").unlink()
    assert [(entry.kind, entry.count) for entry in shelf.entries()] == [("draft", 7)]
    with pytest.raises(TrajectoryFileError, match="not in the library"):
        shelf.load("pick")
    shelf.save(shelf.draft("pick"), replacing="pick")
    assert [(entry.kind, entry.count) for entry in shelf.entries()] == [("points", 7)]
    assert shelf.drafts() == []


def test_it_is_read_again_when_it_changes(shelf):
    shelf.save_draft("pick", trajectory(count=3))
    assert shelf.entries()[0].count == 3
    shelf.save_draft("pick", trajectory(count=40))
    assert shelf.entries()[0].count == 40


def test_a_damaged_draft_is_listed_with_its_fault(shelf, folder):
    shelf.save_draft("pick", trajectory())
    (folder / "pick.draft").write_text("armui trajectory 1\nname: pick\n\nJ 1 2\n")
    (entry,) = shelf.entries()
    assert str(entry.damage) == "pick.draft, line 4, column 1: 2 numbers where 6 belong"


def test_it_gets_another_name(shelf, folder):
    shelf.save_draft("pick", trajectory(count=3))
    shelf.save(trajectory("place"))
    assert refused(shelf.rename, "pick", "place").code == RefusalCode.NAME_TAKEN
    assert refused(shelf.rename, "pick", "").code == RefusalCode.NAME_EMPTY
    shelf.rename("pick", "grip")
    assert names(shelf) == ["grip", "place"]
    assert shown(folder) == ["grip.draft", "place.log"]
    assert len(shelf.draft("grip").points) == 3


def test_discarded_it_can_be_brought_back(shelf):
    shelf.save_draft("pick", trajectory(count=3))
    deleted = shelf.delete(["pick"])
    assert deleted.names == ("pick",)
    assert deleted.only_draft
    assert names(shelf) == []
    assert shelf.restore(deleted) == ("pick",)
    assert len(shelf.draft("pick").points) == 3


def test_brought_back_it_belongs_to_no_other_trajectory(shelf):
    shelf.save_draft("pick", trajectory(count=3))
    deleted = shelf.delete(["pick"])
    shelf.save(trajectory(count=1))

    assert shelf.restore(deleted) == ("pick 2",)

    assert shelf.draft("pick") is None
    assert len(shelf.draft("pick 2").points) == 3


def test_a_trajectory_brought_back_gets_no_others_draft(shelf):
    shelf.save(trajectory(count=1))
    deleted = shelf.delete(["pick"])
    shelf.save_draft("pick", trajectory(count=3))

    assert shelf.restore(deleted) == ("pick 2",)

    assert [(entry.name, entry.kind, entry.count) for entry in shelf.entries()] == [
        ("pick", "draft", 3),
        ("pick 2", "points", 1),
    ]
    assert shelf.load("pick 2") == Trajectory(
        "pick 2", "", trajectory(count=1).points, shelf.load("pick 2").modified
    )


def test_its_own_draft_comes_back_with_it_under_another_name(shelf):
    shelf.save(trajectory(count=1))
    shelf.save_draft("pick", trajectory(count=5))
    deleted = shelf.delete(["pick"])
    shelf.save(trajectory(count=2))

    assert shelf.restore(deleted) == ("pick 2",)

    assert [entry.count for entry in shelf.entries()] == [2, 1]
    assert shelf.drafts() == ["pick 2"]
    assert len(shelf.draft("pick 2").points) == 5
