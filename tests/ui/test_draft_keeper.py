"""When the editor's unsaved changes are written."""

from dataclasses import replace

from armui.protocol.codes import MoveMode
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.background import Background
from armui.ui.trajectory.editor.document import Document, DraftKeeper
from armui.ui.trajectory.library.library_work import LibraryWork
from tests.app_driver import AtOnce, Slow


def work_on(library, files, owner):
    return LibraryWork(library, Background(files, parent=owner), owner)


POINT = Waypoint(MoveMode.MOVE_J, (0.0,) * 6)


def test_a_draft_waits_for_a_pause_in_the_edits(qtbot, tmp_path):
    library = Library(tmp_path)
    trajectory = Trajectory("Test", points=(POINT,))
    library.save(trajectory)
    document = Document(trajectory)
    keeper = DraftKeeper(document, work_on(library, AtOnce(), document))
    for speed in (10, 20, 30):
        document.edit((replace(POINT, speed_percent=speed + 1),), "edit")
        assert keeper._timer.isActive()
        assert keeper._timer.remainingTime() > 500
    assert library.drafts() == []
    qtbot.waitUntil(lambda: library.drafts() == ["Test"])
    keeper.write_draft()


def test_what_is_edited_while_a_draft_is_written_follows(qapp, tmp_path):
    library, files = Library(tmp_path), Slow()
    document = Document(Trajectory("Test", points=(POINT,) * 2000))
    keeper = DraftKeeper(document, work_on(library, files, document))
    document.edit(document.points[1:], "edit")
    keeper._write_behind()
    document.edit(document.points[1:], "edit")
    keeper._write_behind()
    assert len(files.waiting) == 1
    assert keeper._timer.isActive()
    files.work()
    assert len(library.draft("Test").points) == 1999
    keeper._write_behind()
    files.work()
    assert len(library.draft("Test").points) == 1998
    keeper.drop_draft()
    files.work()


def test_no_draft_comes_after_it_was_given_up(qapp, tmp_path):
    library, files = Library(tmp_path), Slow()
    document = Document(Trajectory("Test", points=(POINT,) * 2000))
    keeper = DraftKeeper(document, work_on(library, files, document))
    document.edit(document.points[1:], "edit")
    keeper._write_behind()
    keeper.drop_draft()
    files.work()
    assert library.drafts() == []
    assert not keeper._timer.isActive()


def test_the_disk_s_refusal_is_told(qtbot, tmp_path):
    (tmp_path / "file").touch()
    document = Document(Trajectory("Test", points=(POINT,)))
    keeper = DraftKeeper(document, work_on(Library(tmp_path / "file"), AtOnce(), document))
    document.edit((), "edit")
    with qtbot.waitSignal(keeper.failed) as failed:
        keeper._write_behind()
    assert "Test" in failed.args[0]
