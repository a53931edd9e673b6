"""S21: an unsaved state from before a file was saved is not put over it, and not lost either."""

import os
from dataclasses import replace
from datetime import UTC, datetime, timedelta

import pytest

from armui.protocol.codes import MoveMode
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.trajectory.editor.editor_page import EditorPage
from tests.operator.library.actions import POINT, LibraryDriver
from tests.posix import kill, of_system

OTHER = Waypoint(MoveMode.MOVE_J, (1.0, 20.0, -30.0, 0.0, 0.0, 0.0))
SAVED = Trajectory("one", points=(POINT,))
EDITED = Trajectory("one", points=(POINT, POINT))
FINAL = Trajectory("one", points=(POINT, POINT, OTHER))


def edited(folder, clock=lambda: datetime.now(UTC)):
    """A library in which a trajectory was saved, opened, edited, and its draft written."""
    library = Library(folder, clock)
    library.save(SAVED)
    library.load("one", to_edit=True)
    library.save_draft("one", EDITED)
    return library


def opened(folder):
    """What another run of the program makes of it: what is edited, and whether a draft is aside."""
    library = Library(folder)
    content = library.load("one", to_edit=True)
    assert isinstance(content, Trajectory)
    aside = library.set_aside_draft(content)
    draft = library.draft("one")
    return (content if draft is None else draft).points, aside


def kept_aside(folder):
    library = Library(folder)
    return [files.names for files in library.recently_deleted()]


def test_a_draft_of_the_file_as_it_is_comes_back(tmp_path):
    edited(tmp_path)
    assert opened(tmp_path) == (EDITED.points, False)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="kills in the manner of POSIX")
def test_a_kill_between_save_and_removal_of_the_draft(tmp_path, monkeypatch):
    child = of_system("fork")()
    if child == 0:
        library = edited(tmp_path)
        library.drop_draft = lambda _name: kill(os.getpid())
        library.save(FINAL, replacing="one")
        os._exit(0)
    assert of_system("WIFSIGNALED")(os.waitpid(child, 0)[1])
    assert Library(tmp_path).drafts() == ["one"]
    assert opened(tmp_path) == (FINAL.points, True)
    assert Library(tmp_path).drafts() == []
    # and it is not lost
    library = Library(tmp_path)
    names = library.restore(library.recently_deleted()[0])
    assert library.draft(names[0]).points == EDITED.points
    assert library.load("one").points == FINAL.points


def test_a_draft_that_says_the_same_is_just_done_with(tmp_path):
    library = edited(tmp_path)
    library.drop_draft = lambda _name: None  # killed here
    library.save(EDITED, replacing="one")
    assert opened(tmp_path) == (EDITED.points, False)
    assert Library(tmp_path).drafts() == []
    assert kept_aside(tmp_path) == []


@pytest.mark.parametrize("jump", [timedelta(days=-4000), timedelta(days=4000), timedelta(0)])
def test_clocks_that_jump_change_nothing(tmp_path, jump):
    """Neither the times of the files nor those within them are compared by which is later."""
    now = [datetime.now(UTC)]
    library = edited(tmp_path, lambda: now[0])
    now[0] += jump + timedelta(microseconds=1)
    library.drop_draft = lambda _name: None
    library.save(FINAL, replacing="one")
    for path in tmp_path.glob("one.*"):
        os.utime(path, (0, 0) if path.suffix == ".log" else None)
    assert opened(tmp_path) == (FINAL.points, True)
    # a draft written after the jump belongs to what was saved then
    library.save_draft("one", EDITED)
    assert opened(tmp_path) == (EDITED.points, False)


def test_edits_that_went_on_while_it_was_saved_come_back(tmp_path):
    library = edited(tmp_path)
    library.save(FINAL, replacing="one")
    library.save_draft("one", EDITED)
    assert opened(tmp_path) == (EDITED.points, False)


def test_what_another_program_has_saved_since_is_not_covered(tmp_path):
    mine = edited(tmp_path)
    theirs = Library(tmp_path)
    theirs.load("one", to_edit=True)
    theirs.save(FINAL, replacing="one")
    mine.save_draft("one", EDITED)  # mine goes on, and is killed
    assert opened(tmp_path) == (FINAL.points, True)


def test_a_renamed_one_keeps_its_draft(tmp_path):
    library = edited(tmp_path)
    library.rename("one", "two")
    library = Library(tmp_path)
    content = library.load("two", to_edit=True)
    assert isinstance(content, Trajectory)
    assert not library.set_aside_draft(content)
    assert library.draft("two").points == EDITED.points


def test_one_that_was_never_saved_is_offered(tmp_path):
    library = Library(tmp_path)
    library.save_draft("new", replace(EDITED, name="new"))
    assert [entry.kind for entry in Library(tmp_path).entries()] == ["draft"]
    assert Library(tmp_path).draft("new").points == EDITED.points


def test_the_editor_says_so_and_shows_what_was_saved(app_driver, monkeypatch):
    driver = LibraryDriver(app_driver, "one")
    library = Library(app_driver.library_folder)
    library.load("one", to_edit=True)
    library.save_draft("one", FINAL)
    monkeypatch.setattr(library, "drop_draft", lambda _name: None)  # killed here
    library.save(EDITED, replacing="one")
    driver.window.refresh()
    driver.window.open_trajectory("one")
    editor = app_driver.page(EditorPage)
    assert editor.document.points == EDITED.points
    assert editor.document.saved
    assert "Recently deleted" in editor._message.text()
    editor.leave()
    assert driver.names() == ["one"]
