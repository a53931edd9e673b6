"""What is saved is listed, loaded and never replaced unasked; drafts beside it."""

from dataclasses import replace

import pytest

from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.store import LIBRARY_NOT_SAVED, LibraryError
from armui.trajectory.points.program import NAME_EMPTY, POINT_OUT_OF_RANGE
from tests.trajectory.library.contents import (
    NOW,
    POINT,
    damage,
    names,
    opened,
    recording,
    refused,
    shown,
    trajectory,
)


def test_a_library_not_yet_there_is_empty(library, folder):
    assert library.entries() == []
    assert library.drafts() == []
    assert not folder.exists()


def test_what_is_saved_is_listed_and_loaded(library, folder):
    library.save(trajectory(note="for the tray"))
    library.save(recording())

    assert shown(folder) == ["pick.log", "wave.npz"]
    for again in (library, opened(folder)):
        pick, wave = again.entries()
        assert (pick.name, pick.kind, pick.count, pick.length_s) == ("pick", "points", 2, None)
        assert (pick.note, pick.modified, pick.check, pick.damage) == (
            *("for the tray", NOW),
            *(None, None),
        )
        assert (wave.name, wave.kind, wave.count, wave.length_s) == ("wave", "recording", 3, 1.25)
        assert again.load("pick") == replace(trajectory(note="for the tray"), modified=NOW)
        assert again.load("wave") == replace(recording(), modified=NOW)


def test_nothing_is_replaced_unasked(library):
    library.save(trajectory(count=1))

    refusal = refused(library.save, trajectory(count=5))

    assert (refusal.code, refusal.params) == ("name_taken", {"name": "pick"})
    assert len(library.load("pick").points) == 1
    library.save(trajectory(count=5), replacing="pick")
    assert len(library.load("pick").points) == 5
    assert names(library) == ["pick"]


def test_what_replaces_another_may_bear_another_name_or_be_of_another_kind(library, folder):
    library.save(trajectory())
    library.save(trajectory("place"), replacing="pick")
    assert shown(folder) == ["place.log"]
    library.save(recording("place"), replacing="place")
    assert shown(folder) == ["place.npz"]
    library.save(recording(), replacing="gone by now")
    assert names(library) == ["place", "wave"]


def test_what_could_not_be_read_again_is_not_kept(library, folder):
    bad = replace(trajectory(), points=(POINT, replace(POINT, speed_percent=0)))
    with pytest.raises(LibraryError, match=r"row 2: point_out_of_range\(.*speed") as caught:
        library.save(bad)
    assert caught.value.row == 2
    assert refused(library.save, trajectory(" ")).reason == NAME_EMPTY
    assert refused(library.save_draft, "pick", bad).reason == POINT_OUT_OF_RANGE
    assert not folder.exists()


def test_a_folder_that_takes_nothing_says_so(tmp_path):
    (tmp_path / "file").write_text("in the way")
    library = opened(tmp_path / "file")

    refusal = refused(library.save, trajectory())

    assert refusal.reason == LIBRARY_NOT_SAVED
    assert refusal.params["name"] == "pick"
    assert refusal.params["text"]
    assert refused(library.save_draft, "pick", trajectory()).reason == LIBRARY_NOT_SAVED


# Drafts -------------------------------------------------------------------------------------------


def test_a_draft_outlives_the_program_until_the_trajectory_is_saved(library, folder):
    library.save(trajectory(count=1))
    library.save_draft("pick", trajectory(count=2))
    library.save_draft("pick", trajectory(count=3))
    library.save_draft("a/b \\ 新", trajectory(count=4))

    again = opened(folder)

    assert again.drafts() == ["a/b \\ 新", "pick"]
    assert len(again.draft("pick").points) == 3
    assert len(again.draft("a/b \\ 新").points) == 4
    assert again.draft("pick").modified == NOW
    assert len(again.load("pick").points) == 1
    assert [entry.kind for entry in again.entries()] == ["draft", "points"]
    again.save(trajectory(count=3), replacing="pick")
    again.drop_draft("a/b \\ 新")
    assert again.drafts() == []
    assert shown(folder) == ["pick.log"]


def test_a_damaged_draft_says_where(library, folder):
    library.save_draft("pick", trajectory(count=4))
    damage(folder, "pick.draft")
    assert library.drafts() == ["pick"]
    with pytest.raises(TrajectoryFileError, match="line 7, column 7"):
        library.draft("pick")
