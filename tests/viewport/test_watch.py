"""When a process counts as stuck, when it is started again, and how old the picture is."""

import pytest

from armui.viewport.messages import PictureBusy, PicturePhase
from armui.viewport.watch import PictureAge, Restarts, is_stuck


@pytest.mark.parametrize(
    ("cpu_s", "late_s", "busy_for_s", "stuck"),
    [
        (0.01, 0.0, 0.9, False),  # it may still come
        (0.01, 0.0, 1.0, True),  # sleeps beside a free processor
        (0.10, 0.0, 1.2, False),  # gets a little of a processor, and uses it
        (0.01, 0.1, 1.2, False),  # is woken late: others have the processor
        (0.01, 0.1, 3.0, True),  # even so it would have got more
        (0.10, 0.1, 3.0, False),
        (2.0, 0.0, 2.0, True),  # spins
        (0.5, 0.1, 20.0, True),  # whatever the reason
    ],
)
def test_drawing(cpu_s, late_s, busy_for_s, stuck):
    assert is_stuck(PictureBusy(PicturePhase.DRAWING, cpu_s, late_s), busy_for_s) is stuck


def test_loading_may_take_longer():
    assert not is_stuck(PictureBusy(PicturePhase.LOADING, 10.0, 0.0), 12.0)
    assert is_stuck(PictureBusy(PicturePhase.LOADING, 0.0, 0.0), 20.0)


def test_three_losses_in_a_minute_are_too_many():
    restarts = Restarts()
    assert restarts.lost(0.0)
    assert restarts.lost(1.0)
    assert not restarts.lost(59.0)


def test_losses_long_ago_do_not_count():
    restarts = Restarts()
    assert restarts.lost(0.0)
    assert restarts.lost(30.0)
    assert restarts.lost(61.0)
    assert not restarts.lost(89.0)


def test_a_picture_of_the_newest_state_is_never_old():
    age = PictureAge()
    age.wanted(1, 0.0)
    age.shown(1, 0.1)
    assert age.is_newest_shown
    assert age.age_s(100.0) == 0.0
    assert not age.is_stale(100.0)


def test_the_age_counts_from_the_first_newer_state():
    age = PictureAge()
    age.wanted(1, 0.0)
    age.shown(1, 0.0)
    for number in range(2, 12):
        age.wanted(number, 10.0 + number / 30.0)
    assert age.age_s(10.3) == pytest.approx(0.3 - 2 / 30.0)
    assert not age.is_stale(10.0 + 2 / 30.0 + 0.25)
    assert age.is_stale(10.0 + 2 / 30.0 + 0.251)


def test_a_picture_that_comes_is_as_old_as_what_it_left_out():
    age = PictureAge()
    for number in range(1, 11):
        age.wanted(number, float(number))
    age.shown(7, 10.0)
    assert not age.is_newest_shown
    assert age.age_s(10.0) == 2.0
    assert age.is_stale(10.0)
    age.shown(10, 10.1)
    assert not age.is_stale(10.1)


def test_it_does_not_flicker():
    age = PictureAge()
    age.wanted(1, 0.0)
    assert age.is_stale(0.3)
    age.wanted(2, 0.3)
    age.shown(1, 0.5)  # comes late, and the next will, too
    assert age.age_s(0.5) == pytest.approx(0.2)
    assert age.is_stale(0.5)
    age.wanted(3, 0.55)
    age.shown(2, 0.6)
    assert not age.is_stale(0.6)


def test_a_picture_that_never_comes_costs_no_memory():
    age = PictureAge()
    for number in range(1, 100_000):
        age.wanted(number, number / 30.0)
    assert len(age._newer) < 1000
    assert age.is_stale(100_000 / 30.0)
