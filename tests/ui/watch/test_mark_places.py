"""Where marks stand on a time line."""

from __future__ import annotations

import pytest

from armui.session.session import MarkKind, SessionMark
from armui.ui.watch.replay.mark_places import MarkPlaces

FAULT, COMMAND = MarkKind.FAULT, MarkKind.COMMAND


def mark(at_s, kind=COMMAND, **entry):
    return SessionMark(at_s, kind, entry)


def places(marks, from_s=0.0, to_s=10.0, kind=COMMAND, end_s=10.0):
    return MarkPlaces(marks, end_s).within(kind, from_s, to_s, 1000.0).tolist()


def test_a_moment_stands_where_it_was_and_what_lasts_as_long_as_it_did():
    marks = [mark(2.0), mark(4.0, FAULT, ended_s=5.0), mark(9.0, FAULT, ended_s=None)]
    assert places(marks) == [[200.0, 200.0]]
    assert places(marks, kind=FAULT) == [[400.0, 500.0], [900.0, 1000.0]]
    assert places(marks, kind=MarkKind.STOP) == []


def test_what_is_not_seen_is_left_out_and_what_is_seen_in_part_is_cut_off():
    marks = [mark(1.0, FAULT, ended_s=3.0), mark(5.0, FAULT, ended_s=6.0), mark(9.0, FAULT)]
    assert places(marks, 2.0, 4.0, FAULT) == [[0.0, 500.0]]


def test_thousands_on_one_pixel_are_one():
    marks = [mark(5.0 + number * 1e-6) for number in range(5000)]
    assert places(marks) == [[500.0, 500.0]]
    long = [mark(5.0 + number * 1e-6, FAULT, ended_s=7.0) for number in range(3)]
    brief = mark(5.0, FAULT, ended_s=5.0001)
    assert len(places([brief, *long], kind=FAULT)) == 4


def test_a_time_that_is_none_ends_nothing():
    assert places([mark(3.0, FAULT, ended_s="later")], kind=FAULT) == [[300.0, 300.0]]
    assert places([mark(3.0, FAULT, ended_s=1.0)], kind=FAULT) == [[300.0, pytest.approx(300.0)]]
