"""Events on the disk: the file rotates, a torn line costs itself alone."""

import os
import sys

import pytest

from armui.telemetry.event_file import NAME, append


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
    os.mkfifo(tmp_path / NAME)
    with pytest.raises(OSError, match="not a file"):
        append(tmp_path, "one\n")


def test_a_folder_that_is_a_file_is_said(tmp_path):
    (tmp_path / "logs").write_text("", "ascii")
    with pytest.raises(OSError, match=r".+"):
        append(tmp_path / "logs", "one\n")
