"""S21: two programs on one library: nobody's work is lost unseen, and each says who else is there.

And what was deleted outlives a clock that is set wrong.
"""

import time
from dataclasses import replace
from datetime import UTC, datetime, timedelta

import pytest
from PySide6.QtWidgets import QWidget

from armui.protocol.codes import MoveMode
from armui.protocol.generation import Generation
from armui.trajectory.library import bin as library_bin
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from tests.app_driver import AppDriver

POINT = Waypoint(MoveMode.MOVE_J, (0.0, 30.0, -30.0, 0.0, 0.0, 0.0))


def points(count):
    return Trajectory("T", points=(POINT,) * count, note=f"{count} points")


@pytest.fixture
def folder(tmp_path):
    Library(tmp_path / "trajectories").save(points(1))
    return tmp_path / "trajectories"


def test_what_another_program_saved_is_in_the_bin_and_that_is_said(folder):
    ours, others = Library(folder), Library(folder)
    loaded = ours.load("T", to_edit=True)
    others.load("T", to_edit=True)
    assert others.save(points(2), replacing="T") is False
    assert ours.save(replace(loaded, note="mine"), replacing="T") is True
    assert ours.load("T").note == "mine"
    (deleted,) = ours.recently_deleted()
    (name,) = ours.restore(deleted)
    assert len(ours.load(name).points) == 2


def test_reading_it_meanwhile_does_not_hide_the_other_s_work(folder):
    ours, others = Library(folder), Library(folder)
    ours.load("T", to_edit=True)
    others.save(points(2), replacing="T")
    ours.load("T")  # to be run or exported
    assert ours.save(points(3), replacing="T") is True


def test_alone_nothing_goes_into_the_bin(folder):
    ours = Library(folder)
    ours.load("T", to_edit=True)
    for count in (2, 3, 4):
        assert ours.save(points(count), replacing="T") is False
    ours.mark("T", check="ok")
    assert ours.save(points(5), replacing="T") is False
    assert ours.recently_deleted() == []


def library_page(app_driver):
    app_driver.window.open_library_window()
    return app_driver.page(LibraryPage)


def company(window):
    return window.findChild(QWidget, "library_shared_use").text()


def test_the_editor_says_that_it_displaced_the_other_s_points(app_driver):
    Library(app_driver.library_folder).save(points(1))
    window = library_page(app_driver)
    window.open_trajectory("T")
    Library(app_driver.library_folder).save(points(2), replacing="T")
    editor = app_driver.page(EditorPage)
    editor.document.set_note("mine", "note")
    editor.save()
    message = editor.findChild(QWidget, "editor_message").text()
    assert "Another program had changed “T”" in message
    assert "Recently deleted" in message
    editor.close()


def test_each_program_says_that_the_other_is_there(qapp, request, app_driver, tmp_path):
    Library(app_driver.library_folder).save(points(1))
    here = library_page(app_driver)
    assert not company(here)
    other = AppDriver(qapp, request.node.nodeid + "2", tmp_path / "settings.json", Generation.TWO)
    try:
        other.window.open_library_window()
        (there,) = [
            widget
            for widget in qapp.allWidgets()
            if isinstance(widget, LibraryPage) and widget is not here and widget.isVisible()
        ]
        here.refresh()
        assert "Another program has this library open" in company(here)
        assert "Another program has this library open" in company(there)
        there.close()
        other.window.close()
        here.refresh()
        assert not company(here)
    finally:
        other.close()


def test_a_killed_program_is_not_there(app_driver):
    Library(app_driver.library_folder).save(points(1))
    (app_driver.library_folder / ".program-999999-00.lock").write_text("4194303\narmui\nhost\n\n\n")
    window = library_page(app_driver)
    # the lock names another computer's process: it may live
    assert "host" in company(window)
    (app_driver.library_folder / ".program-999999-00.lock").unlink()
    window.refresh()
    assert not company(window)


class Clock(datetime):
    """Tells what it is set to."""

    at = datetime(2026, 6, 1, tzinfo=UTC)

    @classmethod
    def now(cls, tz=None):
        return cls.at.astimezone(tz)


@pytest.fixture
def clock(monkeypatch):
    monkeypatch.setattr(library_bin, "datetime", Clock)
    monkeypatch.setattr(time, "time_ns", lambda: round(Clock.at.timestamp() * 1e9))
    Clock.at = datetime(2026, 6, 1, tzinfo=UTC)
    return Clock


def started(folder):
    library = Library(folder)
    library.tidy()
    return [deleted.names for deleted in library.recently_deleted()]


@pytest.mark.parametrize("year", [2099, 2027])
def test_a_clock_set_wrong_for_a_day_empties_no_bin(folder, clock, year):
    Library(folder).delete(["T"])
    right, wrong = clock.at, datetime(year, 6, 1, tzinfo=UTC)
    clock.at = wrong
    assert started(folder) == [("T",)]
    clock.at = wrong + timedelta(days=1)
    assert started(folder) == [("T",)]
    clock.at = right + timedelta(days=1)
    assert started(folder) == [("T",)]
    clock.at = wrong + timedelta(days=2)  # wrong once more: it counts anew
    assert started(folder) == [("T",)]


def test_what_was_deleted_by_a_clock_of_long_ago_is_not_gone_at_once(folder, clock):
    right, clock.at = clock.at, datetime(1970, 1, 3, tzinfo=UTC)
    Library(folder).delete(["T"])
    clock.at = right
    assert started(folder) == [("T",)]
    (deleted,) = Library(folder).recently_deleted()
    assert Library(folder).restore(deleted) == ("T",)
    assert list((folder / ".deleted").iterdir()) == []


def test_what_was_deleted_long_ago_goes_a_week_after_it_was_found_so(folder, clock):
    Library(folder).delete(["T"])
    clock.at += timedelta(days=31)
    assert started(folder) == [("T",)]
    clock.at += timedelta(days=6)
    assert started(folder) == [("T",)]
    clock.at += timedelta(days=2)
    assert started(folder) == []
    assert list((folder / ".deleted").iterdir()) == []
