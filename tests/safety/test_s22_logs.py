"""S22: no log and no recording freezes or ends anything, whatever times, channels or words it has.

The replay's window, its index, `armui decode`, `armui export`, and the list of recordings.
"""

from __future__ import annotations

import argparse
import base64
import json
import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import can
import pytest
from PySide6.QtCore import Qt

from armui import decode, export
from armui.protocol.generation import Generation
from armui.session.batch_builder import FURTHER_CHANNELS
from armui.session.exports.export import export_log
from armui.session.exports.request import (
    ArmOptions,
    ExportCancelledError,
    ExportFormat,
    ExportRequest,
)
from armui.session.frames import LATEST_S, NotALogError
from armui.session.log_model import told_firmware, told_model
from armui.session.reader import LogFile
from armui.session.recording import index_file, sidecar
from armui.session.recording.counted import counts_in
from armui.session.recording.folder import list_recordings, rename, throw_away
from armui.session.recording.kinds import RecordingFormat
from armui.session.recording.recorded_session import RecordedSession
from armui.session.survey import survey
from armui.system.clock import in_calendar_s, local_time
from armui.ui import format as fmt
from armui.ui.watch.recordings.recording_card import moment_text
from armui.ui.watch.recordings.sessions_page import SessionColumn, SessionsPage
from armui.ui.watch.replay.log_time import moment
from armui.ui.watch.replay.time_line import mark_text
from tests.bus.playback.logs import Player
from tests.operator.replay_actions import Replay
from tests.session.indexed import open_indexed
from tests.session.recording.made import recorded, taken
from tests.session.recordings import START_S, frames, greeting

STRANGE_TIMES = {
    **{
        f"x 1e{power}": (10.0**power, 0.0) for power in (-9, -6, -3, 3, 4, 6, 8, 9, 10, 12, 15, 100)
    },
    "negative": (1.0, -2 * START_S),
    "negative µs": (1e6, -2e6 * START_S),
    "all the same": (0.0, 1.0),
    "all at 1e308": (0.0, 1e308),
    "up to 1e308": (1e308 / START_S, 0.0),
    "in the year 33,000": (1.0, 1e12),
    "just before the end": (1.0, LATEST_S - START_S - 1.0),
}


@pytest.fixture(scope="module")
def some():
    """Two seconds of an arm that greets."""
    return list(frames(2.0, asked=greeting(Generation.TWO)))


def candump(path: Path, said, times=lambda at_s: at_s, channel=lambda row: "can0") -> Path:
    path.write_text(
        "".join(
            f"({times(at_s):.6f}) {channel(row)} {frame.arbitration_id:03X}"
            f"#{frame.data.hex().upper()}\n"
            for row, (at_s, frame) in enumerate(said)
        )
    )
    return path


def as_csv(path: Path, said, times) -> Path:
    """As python-can writes it, also times before 1970."""
    rows = [
        f"{times(at_s)!r},{frame.arbitration_id:#x},0,0,0,{len(frame.data)},"
        f"{base64.b64encode(frame.data).decode()}"
        for at_s, frame in said
    ]
    path.write_text("\n".join(["timestamp,arbitration_id,extended,remote,error,dlc,data", *rows]))
    return path


def decoded(capsys, log: Path) -> list[str]:
    parser = argparse.ArgumentParser()
    decode.add_arguments(parser)
    decode.run(parser.parse_args([str(log)]))
    output = capsys.readouterr()
    assert " inf " not in output.err
    return output.out.splitlines()


def exported(log: Path, target: Path, *words: str) -> bool:
    parser = argparse.ArgumentParser()
    export.add_arguments(parser)
    export.run(parser.parse_args([str(log), "-o", str(target), *words]))
    return target.exists()


@pytest.mark.parametrize("name", STRANGE_TIMES)
def test_strange_times_are_indexed_surveyed_played_decoded_and_exported(
    name, some, tmp_path, capsys
):
    times, offset = STRANGE_TIMES[name]
    log = as_csv(tmp_path / "strange.csv", some, lambda at_s: at_s * times + offset)

    session = open_indexed(log)
    assert session.frames == len(some)
    assert -LATEST_S <= session.start_s <= session.end_s <= LATEST_S
    (found,) = survey(session)
    assert found.firmware == "S-V1.8-9"
    moment(session.start_s), fmt.clock(session.end_s - session.start_s, 3)
    for mark in session.marks:
        assert mark_text(mark)
    for speed in (1.0, 20.0):
        player = Player(session)
        player.go_to(session.start_s)
        player.play_to(min(session.end_s, session.start_s + 5.0), speed)
        player.player.before()
    start_s = session.start_s
    session.close()

    assert len(decoded(capsys, log)) == len(some)
    for kind in ("csv", "mcap", "parquet"):
        # a ROS time stamp has 31 bits of seconds since 1970: what fits in none is refused, and said
        fits = kind != "mcap" or 0.0 <= start_s < 2**31
        assert exported(log, tmp_path / f"a.{kind}") is fits


@pytest.mark.parametrize(("unit", "per_second"), [("ms", 1e3), ("µs", 1e6), ("ns", 1e9)])
def test_times_in_a_smaller_unit_are_read_as_such_and_it_is_said(unit, per_second, some, tmp_path):
    session = open_indexed(candump(tmp_path / "a.log", some, lambda at_s: at_s * per_second))
    assert session.start_s == pytest.approx(START_S, abs=1e-3)
    assert session.end_s == pytest.approx(some[-1][0], abs=1e-3)
    assert session.damages == ()
    assert [(each.code, each.params) for each in session.notes] == [
        ("log_smaller_unit", {"unit": unit})
    ]
    session.close()


def test_one_time_that_is_none_costs_itself(some, tmp_path):
    said = [(1e308 if row in {7, 900} else at_s, frame) for row, (at_s, frame) in enumerate(some)]
    session = open_indexed(candump(tmp_path / "a.log", said))
    assert session.frames == len(some)
    assert session.start_s == some[0][0]
    assert session.end_s == pytest.approx(some[-1][0], abs=1e-5)
    assert [each.place for each in session.damages] == ["frame 8", "frame 901"]
    session.close()


@pytest.mark.parametrize("together", [1, 2])
def test_a_clock_that_is_set_back_again_and_again_stays_in_the_calendar(together, some, tmp_path):
    """Each time all that follows was moved up by as much: to the year 4500 and on."""
    said = [
        (-2 * START_S if row % 100 < together else at_s, frame)
        for row, (at_s, frame) in enumerate(some)
    ]
    session = open_indexed(as_csv(tmp_path / "a.csv", said, float))
    assert session.frames == len(some)
    assert -LATEST_S <= session.start_s <= session.end_s <= LATEST_S
    if together == 1:  # each costs itself
        assert session.end_s == pytest.approx(some[-1][0], abs=1e-5)
    session.close()


@pytest.mark.parametrize("name", ["x 1e6", "x 1e12", "all at 1e308", "up to 1e308", "negative µs"])
def test_the_window_of_such_a_replay_opens_plays_and_closes(
    name, some, tmp_path, app_driver, monkeypatch
):
    """It ended with the whole program: closing raised within Qt's destructor."""
    times, offset = STRANGE_TIMES[name]
    replay = Replay(app_driver, monkeypatch)
    replay.open(as_csv(tmp_path / "a.csv", some, lambda at_s: at_s * times + offset))
    assert replay.view is not None
    replay.replay.play(on=True)
    app_driver.run(0.2)
    for share in (0.0, 0.5, 1.0):
        session = replay.replay.session
        replay.replay.go_to(session.start_s + share * (session.end_s - session.start_s))
        replay.arrive()
    replay.key(Qt.Key.Key_N)
    replay.window.close()
    app_driver.wait(lambda: replay.window.view is None)


@pytest.mark.parametrize("at_s", [math.nan, math.inf, -math.inf, 1e308, -1e308, 1.7e15, -1.0])
def test_no_time_is_more_than_a_calendar_has(at_s):
    assert local_time(at_s) is None
    assert 0.0 <= in_calendar_s(at_s) <= LATEST_S
    assert moment_text(at_s) == "—"
    assert moment(at_s)


@pytest.mark.parametrize("suffix", [".log", ".csv"])
def test_a_large_text_is_looked_up_from_often(suffix, some, tmp_path):
    """How far it is, and whether anybody still wants it: every half megabyte at most.

    300 MB take a minute; a process that reads 2 MB/s looks up four times a second.
    """
    if suffix == ".log":
        path = candump(tmp_path / "a.log", some * 10)
    else:
        path = as_csv(tmp_path / "a.csv", some * 10, float)
    with LogFile(path) as log:
        places = [0, *(log.position for _batch in log.batches())]
    assert places[-1] == path.stat().st_size > 2e6
    assert max(b - a for a, b in pairwise(places)) <= 2**19
    asked: list[bool] = []

    def is_wanted() -> bool:
        asked.append(True)
        return len(asked) < 3

    wishes = ArmOptions(None, None, None, None)
    target = tmp_path / "b.csv"
    request = ExportRequest(path, target, ExportFormat.CSV, 0.0, math.inf, wishes)
    with pytest.raises(ExportCancelledError):
        export_log(request, is_wanted=is_wanted)
    assert len(asked) == 3
    assert [each.name for each in tmp_path.iterdir()] == [path.name]


# --- channels -----------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", [".log", ".asc"])
def test_more_channels_than_can_be_told_apart_share_the_last(suffix, some, tmp_path, capsys):
    """The log was lost with a bare ValueError."""
    path = tmp_path / f"many{suffix}"
    if suffix == ".log":
        candump(path, some, channel=lambda row: f"can{row % 700}")
    else:
        with can.Logger(path) as logger:
            for row, (at_s, frame) in enumerate(some):
                logger(
                    can.Message(
                        timestamp=at_s, arbitration_id=frame.arbitration_id, data=frame.data,
                        is_extended_id=False, channel=row % 700,
                    )
                )  # fmt: skip
    session = open_indexed(path)
    assert session.frames == len(some)
    assert len(session.channels) == 256
    assert session.channels[-1] == FURTHER_CHANNELS
    assert len(survey(session)) == 256
    (said,) = session.damages
    assert said.reason == "more than 255 channels; the others are read as one"
    assert sum(map(len, session.frames_between(-math.inf, math.inf))) == len(some)
    session.close()
    assert len(decoded(capsys, path)) == len(some)
    assert exported(path, tmp_path / "a.csv", "--channel", FURTHER_CHANNELS)


# --- sidecars -----------------------------------------------------------------------------------

ODD = [None, True, "", "x", [], {}, [[1]], {"a": 1}, 1e308, -1e308, 10**400, float("nan"),
       float("inf"), 0, -1, 2**70, "9" * 5000]  # fmt: skip
WHOLE: list[dict[str, Any]] = [
    {"kind": "session", "version": 1, "program": "armui", "format": RecordingFormat.BLF.value,
     "channel": "can0", "unix_s": 1.78e9, "steady_s": 1000.0, "reason": "operator"},
    {"kind": "arm", "time_s": 1.78e9, "model": "piper", "firmware": "S-V1.8-9"},
    {"kind": "file", "number": 1, "start_s": 1.78e9},
    {"kind": "event", "time_s": 1.78e9, "mark": "fault", "entry": {
        "number": 1, "wall": "2026-06-01T00:00:00+00:00", "at_s": 1000.0, "level": "fault",
        "kind": "fault", "who": "arm", "code": "joint_fault", "lasts": True, "ended_s": 1001.0,
        "last_s": 1000.5, "count": 2, "answer": {"code": "x", "at_s": 1.0, "level": "info"}}},
    {"kind": "lost", "time_s": 1.78e9, "count": 3},
    {"kind": "clock", "time_s": 1.78e9, "by_s": 2.0},
    {"kind": "counted", "faults": 1, "stops": 1},
    {"kind": "end", "failure": "", "frames": 3},
]  # fmt: skip


def without(line, field):
    return {name: value for name, value in line.items() if name != field}


def bad_sidecars():
    """Each field of each line of another type, far too large, none, or missing."""
    for place, line in enumerate(WHOLE):
        for field in line:
            for odd in ODD:
                yield [*WHOLE[:place], {**line, field: odd}, *WHOLE[place + 1 :]]
            yield [*WHOLE[:place], without(line, field), *WHOLE[place + 1 :]]
    entry = WHOLE[3]["entry"]
    walls = ("9999-12-31T23:59:59+00:00", "0001-01-01T00:00:00+00:00")
    for field in entry:
        for odd in (*ODD, *(walls if field == "wall" else ())):
            yield [*WHOLE[:3], {**WHOLE[3], "entry": {**entry, field: odd}}, *WHOLE[4:]]
        yield [*WHOLE[:3], {**WHOLE[3], "entry": without(entry, field)}, *WHOLE[4:]]


def as_file(lines) -> bytes:
    return "".join(json.dumps(line) + "\n" for line in lines).encode()


def test_each_bad_sidecar_costs_itself_and_is_named(tmp_path):
    """One with `"unix_s": null` emptied the list without a word."""
    path = recorded(tmp_path, taken(20))
    name = path.stem
    (tmp_path / f"good{sidecar.SUFFIX}").write_bytes(as_file(WHOLE))
    count = 0
    for lines in bad_sidecars():
        (tmp_path / f"{name}{sidecar.SUFFIX}").write_bytes(as_file(lines))
        found = {entry.name: entry for entry in list_recordings(tmp_path)}
        assert found.keys() == {"good", name}
        entry = found[name]
        assert entry.path == path
        moment_text(entry.begun_unix_s), fmt.duration(entry.length_s)
        try:
            session = RecordedSession(path)
        except NotALogError:
            assert entry.damage
        else:
            for mark in session.marks:
                assert mark_text(mark)
            told_model(session.lines), told_firmware(session.lines), counts_in(session.lines)
            session.close()
        count += 1
    assert count > 700


@pytest.mark.parametrize(
    "data",
    [b"", b"\n", b"\0" * 4096, b"[]\n", b"{}\n", b'{"kind": 7}\n', b"\xff\xfe\n", b"[" * 9999],
)
def test_a_sidecar_that_is_none_is_named_renamed_and_thrown_away(tmp_path, data):
    path = recorded(tmp_path, taken(20))
    (tmp_path / f"{path.stem}{sidecar.SUFFIX}").write_bytes(data)
    (entry,) = list_recordings(tmp_path)
    assert (entry.name, entry.path, entry.damage != "") == (path.stem, path, True)
    rename(tmp_path, entry.name, "another")
    (entry,) = list_recordings(tmp_path)
    assert (entry.name, entry.path) == ("another", tmp_path / "another.blf")
    throw_away(tmp_path, "another")
    assert list_recordings(tmp_path) == []


@pytest.mark.parametrize("field", ["first_s", "last_s", "file_start_s"])
@pytest.mark.parametrize("odd", [math.nan, math.inf, -1e308, 1e308])
def test_an_index_whose_times_are_none_is_none(tmp_path, field, odd):
    path = recorded(tmp_path, taken(20))
    index = tmp_path / f"{path.stem}{index_file.SUFFIX}"
    (block,) = index_file.read_blocks(index.read_bytes())
    fields = {name: getattr(block, name) for name in block.__slots__} | {field: odd}
    index.write_bytes(index_file.MAGIC + index_file.Block(**fields).record())
    (entry,) = list_recordings(tmp_path)
    assert entry.length_s is None
    assert fmt.duration(entry.length_s) == "—"
    session = RecordedSession(path)
    assert -LATEST_S <= session.start_s <= session.end_s <= LATEST_S
    assert session.frames == 20  # read as what a killed program leaves
    session.close()


def test_the_window_names_the_bad_one_beside_the_others(app_driver, tmp_path):
    folder = tmp_path / "sessions"
    folder.mkdir()
    for name, lines in (("one", WHOLE), ("two", [{**WHOLE[0], "unix_s": None}]), ("three", [])):
        (folder / f"{name}{sidecar.SUFFIX}").write_bytes(as_file(lines))
    app_driver.store.change(session_folder=str(folder))
    app_driver.click("sessions_button")
    window = app_driver.page(SessionsPage)
    model = window.table.model()
    app_driver.wait(lambda: model.rowCount() == 3)
    states = {
        model.index(row, SessionColumn.NAME).data(): (
            model.index(row, SessionColumn.BEGUN).data(),
            model.index(row, SessionColumn.STATE).data(),
        )
        for row in range(3)
    }
    assert states["one"][1] == "empty"
    assert states["two"][0] == "—"
    assert states["three"][1] == "its description file cannot be read: three.armui.jsonl"
