"""Marks: what lasts has an end, and next fault finds each of them."""

from __future__ import annotations

from armui.session.session import MarkKind, SessionMark
from armui.ui.watch.replay.log_time import has_date, moment
from armui.ui.watch.replay.mark_places import MarkSearch, end_of
from armui.ui.watch.replay.time_line import mark_text
from tests.bus.playback.logs import log_with


def mark(at_s: float, kind: MarkKind = MarkKind.FAULT, **entry: object) -> SessionMark:
    return SessionMark(at_s, kind, entry)


def test_next_fault_passes_commands_and_other_channels():
    marks = (
        mark(1.0, MarkKind.COMMAND, channel=1),
        mark(2.0, channel=1),
        mark(3.0, channel=2),
        mark(4.0, MarkKind.STOP, channel=1),
    )
    search = MarkSearch(marks, 1)

    assert search.next_trouble(0.0) == marks[1]
    assert search.next_trouble(2.0) == marks[3]
    assert search.next_trouble(4.0) is None
    assert search.trouble_before(4.0) == marks[1]
    assert search.trouble_before(2.0) is None
    assert search.marks == (marks[0], marks[1], marks[3])


def test_what_lasts_has_an_end_and_a_moment_has_none():
    assert end_of(mark(1.0, ended_s=2.5), 9.0) == 2.5
    assert end_of(mark(1.0, ended_s=None), 9.0) == 9.0
    assert end_of(mark(1.0), 9.0) is None
    assert end_of(mark(1.0, MarkKind.COMMAND, ended_s=None), 9.0) is None
    assert end_of(mark(1.79e9, ended_s=4711.0), 1.8e9) is None


def test_a_latched_fault_goes_on_to_the_end(tmp_path):
    session = log_with(tmp_path, "overcurrent")
    told = {mark_text(each): end_of(each, session.end_s) for each in session.marks}

    assert told["Arm: J1 Driver current: Overcurrent"] == session.end_s
    assert told["Other host: Motors: enable sent"] is None
    session.close()


def test_silence_is_marked_with_its_end(tmp_path):
    session = log_with(tmp_path, "bus-off", seconds=2.4)
    silent = [each for each in session.marks if each.entry["code"] == "silent"]

    # off from 1.1 s to 1.4 s: shorter than what counts as silence
    assert silent == []
    session.close()


def test_times_no_calendar_has_are_no_harm():
    assert moment(12.5) == "00:00:12.500"
    assert not has_date(12.5)
    assert moment(1e18)
    assert moment(-1e18)
