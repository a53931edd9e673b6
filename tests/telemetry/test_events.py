"""The log of events: bounded, followed by its revisions, repeats counted; and its lines."""

import json
import sys
import threading
from datetime import UTC, datetime, timedelta, timezone

import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.arm.device import Device
from armui.control.link.link_state import LINK_LOST
from armui.telemetry.event_json import NAME, append, from_record, to_json
from armui.telemetry.events import (
    REPEAT_S,
    REPEATS_SPAN_S,
    Asker,
    EventEntry,
    EventKind,
    EventLog,
    EventOutcome,
    Level,
)
from tests.posix import make_pipe

NOON = datetime(2026, 1, 15, 12, tzinfo=UTC)


def put(log, code="x", at_s=0.0, **more):
    return log.add(
        **{
            "at_s": at_s,
            "wall": NOON + timedelta(seconds=at_s),
            "level": Level.INFO,
            "kind": EventKind.STATUS,
            "who": Asker.ARM,
            "code": code,
            **more,
        }
    )


def test_entries_are_numbered_from_one_and_come_by_revision():
    log = EventLog()
    assert log.since(0) == (0, [])
    first, second = put(log, "a"), put(log, "b", 1.0)
    assert [first.number, second.number] == [1, 2]
    revision, new = log.since(0)
    assert [each.code for each in new] == ["a", "b"]
    assert log.since(revision) == (revision, [])
    log.change(1, ended_s=2.0)
    later, changed = log.since(revision)
    assert later > revision
    assert [(each.number, each.ended_s) for each in changed] == [(1, 2.0)]


def test_a_change_that_changes_nothing_is_none():
    log = EventLog()
    put(log, lasts=True)
    log.change(1, ended_s=3.0)
    revision = log.revision
    log.change(1, ended_s=3.0)
    assert log.revision == revision


def test_the_oldest_make_room():
    log = EventLog(most=3)
    for n in range(5):
        put(log, str(n), n)
    assert [each.number for each in log.entries()] == [3, 4, 5]
    assert (log.oldest, log.newest) == (3, 5)
    assert log.get(1) is None
    assert log.change(1, ended_s=9.0) is None
    assert [each.number for each in log.since(0)[1]] == [3, 4, 5]
    assert log.snapshot() == log.since(0)


def test_repeats_are_counted_with_the_newest_figures():
    log = EventLog()
    put(log, "speed", 0.0, repeat_key="speed", params={"percent": 10})
    put(log, "other", 1.0)
    again = put(log, "speed", 2.0, repeat_key="speed", params={"percent": 20})
    assert (again.number, again.count, again.at_s, again.last_s) == (1, 2, 0.0, 2.0)
    assert again.params == {"percent": 20}
    assert len(log.entries()) == 2


def test_what_pauses_is_listed_anew():
    log = EventLog()
    put(log, at_s=0.0, repeat_key="k")
    assert put(log, at_s=REPEAT_S, repeat_key="k").count == 2
    assert put(log, at_s=2 * REPEAT_S + 0.1, repeat_key="k").number == 2


def test_a_shorter_time_may_be_named():
    log = EventLog()
    put(log, at_s=0.0, repeat_key="k", within_s=1.0)
    assert put(log, at_s=1.0, repeat_key="k", within_s=1.0).count == 2
    assert put(log, at_s=2.5, repeat_key="k", within_s=1.0).number == 2


def test_no_line_hides_more_than_a_minute():
    log = EventLog()
    for second in range(int(REPEATS_SPAN_S) + 20):
        put(log, at_s=float(second), repeat_key="k")
    assert [each.count for each in log.entries()] == [int(REPEATS_SPAN_S) + 1, 19]


def test_what_goes_on_or_was_not_heard_to_end_is_not_begun_again():
    log = EventLog()
    put(log, at_s=0.0, repeat_key="k", lasts=True)
    assert put(log, at_s=1.0, repeat_key="k", lasts=True).number == 2
    log.change(2, ended_s=1.5, unheard=True)
    assert put(log, at_s=2.0, repeat_key="k", lasts=True).number == 3
    log.change(3, ended_s=2.5)
    again = put(log, at_s=3.0, repeat_key="k", lasts=True)
    assert (again.number, again.count, again.goes_on) == (3, 2, True)


def test_one_writes_while_others_read():
    log = EventLog(most=50)
    wrong, ready = [], threading.Event()

    def read():
        revision, seen = 0, 0
        while seen < 2000:
            revision, new = log.since(revision)
            numbers = [each.number for each in new]
            if numbers != sorted(set(numbers)):
                wrong.append(numbers)
            seen = max([seen, *numbers])
            ready.set()

    reader = threading.Thread(target=read)
    reader.start()
    ready.wait(5)
    for n in range(2000):
        put(log, str(n), n)
    reader.join(10)
    assert not reader.is_alive()
    assert wrong == []


# Its lines -----------------------------------------------------------------------------------

WHOLE = EventEntry(
    number=7,
    at_s=12.5,
    wall=datetime(2026, 1, 15, 20, 0, 1, 250_000, tzinfo=timezone(timedelta(hours=8))),
    level=Level.FAULT,
    kind=EventKind.COMMAND,
    who=Asker.RECOVERY,
    code="connect_failed",
    params={
        "device": Device("socketcan", "can0", None, options=(("fd", False),)),
        "reason": LINK_LOST(seconds=0.5),
        "joints": (1, 3),
        "name": "臂",
        "before": None,
    },
    lasts=True,
    ended_s=13.25,
    unheard=True,
    count=4,
    last_s=13.0,
    answer=EventOutcome("answered", 12.6, Level.DONE, {"index": "0x71"}),
    result=EventOutcome("enable_failed", 14.0, Level.FAULT, {"joints": "2"}),
)


def test_a_line_says_everything():
    line = to_json(WHOLE)
    assert "\n" not in line
    assert "臂" in line
    assert from_record(json.loads(line)) == WHOLE


@given(
    at_s=st.floats(0, 1e9),
    count=st.integers(1, 10**9),
    text=st.text(max_size=40),
    figure=st.floats(allow_nan=False, allow_infinity=False),
    ended=st.one_of(st.none(), st.floats(0, 1e9)),
)
def test_any_entry_comes_back(at_s, count, text, figure, ended):
    entry = EventEntry(
        *(1, round(at_s, 6), NOON, Level.WARNING, EventKind.ODDITY, Asker.PROGRAM, text),
        params={text: figure, "text": text},
        lasts=True,
        ended_s=None if ended is None else round(ended, 6),
        count=count,
    )
    assert from_record(json.loads(to_json(entry))) == entry


@pytest.mark.parametrize(
    "change",
    [
        {"number": "7"},
        {"number": True},
        {"at_s": "12"},
        {"at_s": float("nan")},
        {"wall": "noon"},
        {"wall": "2026-01-15T12:00:00"},
        {"level": "grave"},
        {"kind": "rumour"},
        {"who": "me"},
        {"code": 7},
        {"params": [1]},
        {"params": {"x": {"unknown": 1}}},
        {"params": {"device": {"device": {"nothing": 1}}}},
        {"answer": {"code": "x"}},
    ],
)
def test_an_impossible_line_is_refused(change):
    line = json.dumps({**json.loads(to_json(WHOLE)), **change})
    with pytest.raises(ValueError, match=r".+"):
        from_record(json.loads(line))


@pytest.mark.parametrize("line", ["null", "[]", "7", "{}", '"x"'])
def test_nonsense_is_refused(line):
    with pytest.raises(ValueError, match=r".+"):
        from_record(json.loads(line))


def test_a_reason_of_a_newer_program_is_kept_by_its_id():
    line = to_json(WHOLE).replace(str(LINK_LOST), "some_new_reason")
    assert str(from_record(json.loads(line)).params["reason"]).startswith("some_new_reason(")


def test_figures_that_json_has_no_word_for_become_text():
    entry = put(EventLog(), params={"torque": float("inf"), "what": object})
    params = from_record(json.loads(to_json(entry))).params
    assert params["torque"] == "inf"
    assert isinstance(params["what"], str)


def lines(folder, name=NAME):
    return (folder / name).read_text(encoding="utf-8").splitlines()


def test_the_folder_is_made_and_lines_are_added(tmp_path):
    folder = tmp_path / "a" / "b"
    append(folder, "one\n")
    append(folder, "two 臂\n")
    assert lines(folder) == ["one", "two 臂"]


def test_a_full_file_makes_room_and_the_oldest_goes(tmp_path):
    for n in range(12):
        append(tmp_path, f"{n:02d}-------\n", most_bytes=15, old_files=2)
    names = sorted(path.name for path in tmp_path.iterdir())
    assert names == ["events.1.jsonl", "events.2.jsonl"]
    assert lines(tmp_path, "events.1.jsonl") == ["10-------", "11-------"]
    assert lines(tmp_path, "events.2.jsonl") == ["08-------", "09-------"]


def test_a_line_torn_by_a_full_disk_costs_itself_alone(tmp_path):
    (tmp_path / NAME).write_bytes(b'{"number":1}\n{"numb')
    append(tmp_path, '{"number":3}\n')
    assert lines(tmp_path) == ['{"number":1}', '{"numb', '{"number":3}']


def test_text_that_is_no_unicode_is_written_all_the_same(tmp_path):
    append(tmp_path, "\udcff\n")
    assert lines(tmp_path) == ["?"]


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such pipes")
def test_a_pipe_is_not_waited_for(tmp_path):
    make_pipe(tmp_path / NAME)
    with pytest.raises(OSError, match="not a file"):
        append(tmp_path, "one\n")


def test_a_folder_that_is_a_file_is_said(tmp_path):
    (tmp_path / "logs").write_text("", "ascii")
    with pytest.raises(OSError, match=r".+"):
        append(tmp_path / "logs", "one\n")
