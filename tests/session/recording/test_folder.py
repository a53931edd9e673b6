"""The recordings of a folder: listed, renamed, thrown away, all of their files or none."""

from __future__ import annotations

from pathlib import Path

import pytest

from armui.session.recording.folder import BIN, list_recordings, rename, throw_away
from armui.session.recording.kinds import RecordingFormat, is_name, names_of
from armui.session.recording.recorded_session import RecordedSession
from armui.session.recording.rows import rows_of
from tests.session.recording.made import BASE, recorded, taken, writer


def names(folder):
    return sorted(path.name for path in folder.iterdir() if path.is_file())


def test_a_recording_is_listed_with_what_is_known_of_it(tmp_path):
    made = writer(tmp_path, facts={"reason": "fault"}, rotate_bytes=3000)
    events = [
        {"kind": "event", "time_s": 1.0, "mark": mark, "entry": {"number": number, "code": code}}
        for number, (mark, code) in enumerate(
            [
                ("fault", "joint_fault"),
                ("stop", "stop_sent"),
                ("fault", "joint_fault"),
                ("note", ""),
            ]
        )
    ]
    for begin in range(0, 3000, 500):
        made.write(rows_of(taken(500, BASE.steady_s + begin)), events)
    (under_way,) = list_recordings(tmp_path)
    assert not under_way.ended
    made.finish({})

    (entry,) = list_recordings(tmp_path)
    assert (entry.name, entry.path, entry.ended) == ("made", made.path, True)
    assert (entry.faults, entry.stops, entry.reason) == (2, 1, "fault")
    assert entry.begun_unix_s == BASE.unix_s
    assert entry.length_s == pytest.approx(2500 + 499 / 3000, abs=1e-5)
    assert entry.files == len([name for name in names(tmp_path) if name.endswith(".blf")])
    assert entry.files > 1
    assert entry.total_bytes == sum(path.stat().st_size for path in tmp_path.glob("*.blf"))


def test_what_was_saved_from_memory_began_with_its_first_frame(tmp_path):
    made = writer(tmp_path)
    made.write(rows_of(taken(500, BASE.steady_s - 299.0)), [])
    made.finish({})
    (entry,) = list_recordings(tmp_path)
    assert entry.begun_unix_s == pytest.approx(BASE.unix_s - 299.0, abs=0.01)


def test_a_folder_that_is_not_there_has_no_recordings(tmp_path):
    assert list_recordings(tmp_path / "nowhere") == []


def test_a_sidecar_that_says_nothing_is_named(tmp_path):
    (tmp_path / "other.armui.jsonl").write_text("no line of ours\n")
    (tmp_path / "odd.armui.jsonl").write_text('{"kind": "session", "format": ".exe"}\n')
    found = {entry.name: entry.damage for entry in list_recordings(tmp_path)}
    assert found == {"other": "other.armui.jsonl", "odd": "odd.armui.jsonl"}
    throw_away(tmp_path, "odd")
    assert [entry.name for entry in list_recordings(tmp_path)] == ["other"]


def test_a_recording_is_renamed_with_all_its_files(tmp_path):
    frames = taken(3000)
    recorded(tmp_path, frames, rotate_bytes=3000, block=500)
    before = names(tmp_path)
    rename(tmp_path, "made", "其他名称 2")
    assert names(tmp_path) == sorted(name.replace("made", "其他名称 2", 1) for name in before)
    assert RecordedSession(tmp_path / "其他名称 2.blf").frames == 3000


def test_a_name_that_is_taken_or_none_is_refused_and_nothing_moves(tmp_path):
    recorded(tmp_path, taken(10))
    (tmp_path / "other.blf").write_bytes(b"")
    before = names(tmp_path)
    with pytest.raises(FileExistsError):
        rename(tmp_path, "made", "other")
    with pytest.raises(ValueError, match="/"):
        rename(tmp_path, "made", "a/b")
    assert names(tmp_path) == before


def test_what_cannot_be_moved_stays_whole(tmp_path, monkeypatch):
    recorded(tmp_path, taken(10))
    before = names(tmp_path)
    replace, moves = Path.replace, []

    def fail_at_the_last(path, target):
        moves.append(path)
        if len(moves) == 3:
            raise OSError("the stick is gone")
        return replace(path, target)

    monkeypatch.setattr(Path, "replace", fail_at_the_last)
    with pytest.raises(OSError, match="stick"):
        throw_away(tmp_path, "made")
    assert names(tmp_path) == before


def test_a_recording_that_was_thrown_away_can_be_moved_back(tmp_path):
    recorded(tmp_path, taken(10), RecordingFormat.CANDUMP)
    before = names(tmp_path)
    place = throw_away(tmp_path, "made")
    assert place.parent == tmp_path / BIN
    assert (names(tmp_path), list_recordings(tmp_path)) == ([], [])
    assert names(place) == before
    assert RecordedSession(place / "made.log").frames == 10


@pytest.mark.parametrize(
    ("text", "good"),
    [("night run", True), ("会话 1", True), ("a.b", True), ("", False), ("a:b", False),
     ("x.", False), (" x", False), ("x.012", False), ("x" * 121, False), ("a\nb", False)],
)  # fmt: skip
def test_names(text, good):
    assert is_name(text) is good


def test_the_recording_that_a_file_belongs_to():
    assert names_of(Path("x/night.blf")) == ("night",)
    assert names_of(Path("x/night.002.blf")) == ("night", "night.002")
