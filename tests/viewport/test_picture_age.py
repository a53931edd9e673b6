"""The picture says its age."""

import pytest

from armui.viewport.watch import PictureAge


def test_a_picture_of_the_newest_state_is_never_old():
    age = PictureAge()
    age.wanted(1, 0.0)
    age.shown(1, 0.1)
    assert age.is_newest_shown
    assert age.age_s(100.0) == 0.0
    assert not age.looks_old(100.0)


def test_the_age_counts_from_the_first_newer_state():
    age = PictureAge()
    age.wanted(1, 0.0)
    age.shown(1, 0.0)
    for number in range(2, 12):
        age.wanted(number, 10.0 + number / 30.0)
    assert age.age_s(10.3) == pytest.approx(0.3 - 2 / 30.0)
    assert not age.looks_old(10.0 + 2 / 30.0 + 0.25)
    assert age.looks_old(10.0 + 2 / 30.0 + 0.251)


def test_a_picture_that_comes_is_as_old_as_what_it_left_out():
    age = PictureAge()
    for number in range(1, 11):
        age.wanted(number, float(number))
    age.shown(7, 10.0)
    assert not age.is_newest_shown
    assert age.age_s(10.0) == 2.0
    assert age.looks_old(10.0)
    age.shown(10, 10.1)
    assert not age.looks_old(10.1)


def test_it_does_not_flicker():
    age = PictureAge()
    age.wanted(1, 0.0)
    assert age.looks_old(0.3)
    age.wanted(2, 0.3)
    age.shown(1, 0.5)  # comes late, and the next will, too
    assert age.age_s(0.5) == pytest.approx(0.2)
    assert age.looks_old(0.5)
    age.wanted(3, 0.55)
    age.shown(2, 0.6)
    assert not age.looks_old(0.6)


def test_a_picture_that_never_comes_costs_no_memory():
    age = PictureAge()
    for number in range(1, 100_000):
        age.wanted(number, number / 30.0)
    assert len(age._newer) < 1000
    assert age.looks_old(100_000 / 30.0)
