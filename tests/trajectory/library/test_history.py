"""Undoing what was done to the library, and the bin that outlives the program."""

import shutil
from dataclasses import replace
from datetime import UTC, datetime

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.history import (
    CHANGED_SINCE,
    Deletion,
    LibraryHistory,
    Making,
    Origin,
    Renaming,
)
from armui.trajectory.library.store import LIBRARY_NOT_RESTORED, NAME_TAKEN, Library
from tests.examples import examples
from tests.moments import now
from tests.trajectory.library.contents import locked, names, opened, recording, refused, trajectory


@pytest.fixture
def history(library):
    for name in "abc":
        library.save(trajectory(name))
    return LibraryHistory(library)


def test_deletions_are_undone_the_last_first(history, library):
    history.delete(["a", "b"])
    history.delete(["c"])
    assert history.last.names == ("c",)
    assert history.undo() == ("c",)
    assert history.last.names == ("a", "b")
    assert history.undo() == ("a", "b")
    assert names(library) == ["a", "b", "c"]
    assert history.last is None


def test_what_was_gone_already_is_no_step(history):
    assert history.delete(["x"]).names == ()
    assert history.last is None


def test_the_mark_of_the_check_comes_back_too(history, library):
    library.mark("a", check="warnings")
    history.delete(["a"])
    history.undo()
    (entry,) = [entry for entry in library.entries() if entry.name == "a"]
    assert entry.check == "warnings"


def test_a_name_is_given_back(history, library):
    history.rename("a", "z")
    history.delete(["z"])
    assert history.undo() == ("z",)
    assert isinstance(history.last, Renaming)
    assert history.last.touched == ("z",)
    assert history.undo() == ("a",)
    assert names(library) == ["a", "b", "c"]


def test_a_name_that_was_taken_meanwhile_is_not_given_back(history, library):
    history.delete(["b"])
    history.rename("a", "z")
    library.save(trajectory("a", 7))
    assert refused(history.undo).reason == NAME_TAKEN
    assert names(library) == ["a", "c", "z"]
    assert history.undo() == ("b",)  # what can never be done does not bar the way


def test_the_name_of_what_is_gone_is_not_given_back(history, library, folder):
    history.rename("a", "z")
    (folder / "z.log").unlink()
    with pytest.raises(TrajectoryFileError, match="not in the library"):
        history.undo()
    assert history.last is None


def test_what_was_made_is_taken_away_as_long_as_it_is_as_made(history, library):
    history.note_made(["a", "b"], Origin.CREATED)
    history.note_made(["c", "never there"], Origin.CREATED)
    assert isinstance(history.last, Making)
    assert history.last.touched == ("c",)
    assert history.undo() == ()
    assert names(library) == ["a", "b"]
    library._now = lambda: datetime(2027, 1, 1, tzinfo=UTC)
    library.save(trajectory("b", 9), replacing="b")
    refusal = refused(history.undo)
    assert (refusal.code, refusal.params) == ("changed_since", {"name": "b"})
    assert names(library) == ["a", "b"]
    assert history.last is None


def test_what_has_unsaved_changes_is_not_taken_away(history, library):
    history.note_made(["a"], Origin.CREATED)
    library.save_draft("a", trajectory("a", 5))
    assert refused(history.undo).reason == CHANGED_SINCE
    assert len(library.draft("a").points) == 5


def test_a_step_that_the_disk_refuses_can_be_tried_again(history, library, monkeypatch):
    history.delete(["a", "b"])
    with locked(monkeypatch, "b.log"):
        assert refused(history.undo).reason == LIBRARY_NOT_RESTORED
    assert names(library) == ["a", "c"]
    assert history.undo() == ("b",)
    assert names(library) == ["a", "b", "c"]


def test_what_is_in_the_bin_no_more_is_said_to_be(history, library, folder):
    history.delete(["a"])
    shutil.rmtree(folder / ".deleted")
    refusal = refused(history.undo)
    assert (refusal.code, refusal.params) == ("deleted_gone", {"name": "a"})
    assert history.last is None


def test_the_bin_is_seen_after_a_restart_the_last_deleted_first(history, library, folder):
    library.save(recording("取/料"))
    library.save_draft("b", trajectory("b", 9))
    library.save_draft("only", trajectory("only", 4))
    history.delete(["a", "b"])
    history.delete(["取/料", "only"])
    rooms = {one.places[0][1].parent for one in library.recently_deleted()}
    assert len(rooms) == 2

    again = opened(folder)
    found = again.recently_deleted()

    assert {one.names for one in found[:2]} == {("only",), ("取/料",)}
    assert [one.names for one in found[2:]] == [("a",), ("b",)]
    assert [file for file, _ in found[3].places] == ["b.log", "b.draft"]
    assert [one.only_draft for one in found if one.names == ("only",)] == [True]
    assert all(abs((datetime.now(UTC) - one.when).total_seconds()) < 60 for one in found)
    assert again.restore(found[3]) == ("b",)
    assert names(again) == ["b", "c"]
    assert len(again.draft("b").points) == 9
    assert len(again.recently_deleted()) == 3


def test_what_was_brought_back_from_the_bin_is_not_undone_once_more(history, library):
    history.delete(["a"])
    history.delete(["b", "c"])
    both = {one.names[0]: one for one in library.recently_deleted()}
    assert history.bring_back([both["a"], both["b"]]) == ("a", "b")
    assert isinstance(now(history.last), Deletion)
    assert history.last.names == ("c",)
    assert history.undo() == ("c",)
    assert now(history.last) is None
    assert names(library) == ["a", "b", "c"]


ACTIONS = st.lists(
    st.one_of(
        st.tuples(st.just("delete"), st.sets(st.sampled_from("abcd"), min_size=1)),
        st.tuples(st.just("rename"), st.sampled_from("abcd"), st.sampled_from("abcd")),
        st.tuples(st.just("make"), st.sampled_from("abcd")),
    ),
    max_size=8,
)


@settings(max_examples=examples(60), deadline=None)
@given(ACTIONS)
def test_all_undone_the_library_is_as_it_was(tmp_path_factory, actions):
    library = Library(tmp_path_factory.mktemp("library"))
    for count, name in enumerate("abc", 1):
        library.save(trajectory(name, count))
    before = [replace(library.load(name)) for name in names(library)]
    history = LibraryHistory(library)
    for kind, *what in actions:
        there = names(library)
        if kind == "delete":
            history.delete(sorted(*what))
        elif kind == "rename" and what[0] in there and what[1] not in there:
            history.rename(*what)
        elif kind == "make" and what[0] not in there:
            library.save(trajectory(what[0], 9))
            history.note_made(what, Origin.CREATED)
    while (last := history.last) is not None:
        history.drop_outdated(library.listing())
        assert history.last is last  # what can be undone stays
        history.undo()
    assert [library.load(name) for name in names(library)] == before
