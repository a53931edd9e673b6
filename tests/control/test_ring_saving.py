"""When the last minutes are saved by themselves."""

from itertools import pairwise

from armui.control.sessions.ring_saving import AFTER_S, SaveAtFaults
from armui.session.session import MarkKind

KEEP_S = 300.0


def saves(events, until_s=2000):
    """When it is saved, and for what, looked at each second."""
    saving, found = SaveAtFaults(KEEP_S), []
    for now_s in range(until_s):
        for mark in events.get(now_s, ()):
            saving.happened(mark, float(now_s))
        kind = saving.take_due(float(now_s))
        if kind is not None:
            found.append((now_s, kind))
    return found


def test_a_fault_is_saved_with_what_follows_it():
    assert saves({10: [MarkKind.FAULT]}) == [(10 + AFTER_S, MarkKind.FAULT)]
    assert saves({10: [MarkKind.STOP, MarkKind.FAULT]}) == [(10 + AFTER_S, MarkKind.STOP)]


def test_what_is_neither_fault_nor_stop_saves_nothing():
    assert saves({10: [MarkKind.NOTE, MarkKind.COMMAND]}) == []


def test_faults_one_after_another_are_all_in_some_save_and_the_disk_is_not_filled():
    events = {second: [MarkKind.FAULT] for second in range(10, 1500, 3)}
    times_s = [at_s for at_s, _ in saves(events)]
    gaps_s = [later - earlier for earlier, later in pairwise(times_s)]
    assert len(times_s) == 7
    assert all(KEEP_S - 3 * AFTER_S < gap_s < KEEP_S for gap_s in gaps_s)


def test_a_wish_that_is_withdrawn_saves_nothing():
    saving = SaveAtFaults(KEEP_S)
    saving.happened(MarkKind.FAULT, 1.0)
    saving.reset()
    assert saving.take_due(100.0) is None
