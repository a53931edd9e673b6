"""A note over the picture stands where the arm is not."""

from typing import Any

import pytest
from PySide6.QtWidgets import QWidget

from armui.control.events import Level
from armui.ui.picture.note_place import freest, note_places
from armui.ui.picture.picture_note import PictureNote
from armui.viewport.fitting import Box, Room
from tests.ui.fake_view import FakeView

ROOM = Room(660.0, 650.0, Box(0.0, 0.0, 240.0, 170.0), 44.0)
"""The picture of a window of 1280×800 beside a panel, with its figures."""
BASE = Box(60.0, 540.0, 180.0, 640.0)
NOTE = 240.0, 71.0


def chosen(*seen, before=0):
    places = note_places(ROOM, *NOTE)
    return places[freest(places, seen, before)]


def test_it_stands_at_the_bottom_where_nothing_is_hidden_there():
    assert chosen() == Box(14.0, 565.0, 254.0, 636.0)
    assert chosen(Box(300.0, 200.0, 500.0, 500.0)) == chosen()


@pytest.mark.parametrize("before", [0, 1, 2, 3])
def test_no_place_hides_figures_or_an_arm_that_leaves_room(before):
    place = chosen(BASE, Box(250.0, 180.0, 600.0, 560.0), before=before)
    assert not any(place.overlaps(each) for each in (BASE, ROOM.figures))


def test_it_stays_where_it_stands_while_no_other_place_is_better():
    places = note_places(ROOM, *NOTE)
    assert freest(places, (BASE,), 2) == 2
    assert freest(places, (), 3) == 3


def test_where_all_is_full_it_hides_least():
    whole = Box(0.0, 0.0, 660.0, 650.0)
    places = note_places(ROOM, *NOTE)
    assert freest(places, (whole, BASE), 0) != 0


def test_a_picture_that_is_too_small_has_it_at_the_bottom_all_the_same():
    assert len(note_places(Room(200.0, 60.0, Box(0.0, 0.0, 200.0, 60.0)), *NOTE)) == 1


def test_a_note_makes_way_for_an_arm_that_comes(qtbot, monkeypatch):
    region, note = QWidget(), PictureNote()
    view: Any = FakeView()
    qtbot.addWidget(region)
    view.setParent(region)
    region.resize(660, 650)
    view.resize(660, 650)
    note.stand_over(region, view)
    region.show()
    note.show_message("The target is out of the arm's reach.", Level.WARNING, stays=True)
    bottom = note.geometry()
    assert bottom.bottom() > 600
    around = Box(bottom.left(), bottom.top(), bottom.right(), bottom.bottom())
    monkeypatch.setattr(view, "arm_boxes", lambda: [around])
    qtbot.waitUntil(lambda: not note.geometry().intersects(bottom))
    region.resize(500, 400)
    view.resize(500, 400)
    assert region.rect().contains(note.geometry())
    note.show_message("")
    assert not note._place_timer.isActive(), "what is not seen does no work"
