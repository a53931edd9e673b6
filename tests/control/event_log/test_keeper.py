"""The events on the disk: nothing lost by a full disk, nobody waits for a slow one."""

from __future__ import annotations

import json
from concurrent.futures import Future

import pytest

from armui.control.event_log import keeper as module
from armui.control.event_log.keeper import EventKeeper
from armui.telemetry.event_json import NAME, from_record, to_json
from tests.accepted import accepted
from tests.app_driver import AtOnce, Slow


class Full(AtOnce):
    """A disk that is full for a while."""

    def __init__(self):
        self.full = True
        self.asked = 0

    def submit(self, fn, /, *args, **kwargs):
        self.asked += 1
        if self.full:
            failed: Future[None] = Future()
            failed.set_exception(OSError(28, "No space left on device"))
            return failed
        return super().submit(fn, *args, **kwargs)


@pytest.fixture
def keep(rig, tmp_path):
    """Makes a keeper over an executor, its timer stopped: the test looks."""

    def make(files):
        keeper = EventKeeper(rig.controller.event_collector, tmp_path / "logs", files)
        keeper._timer.stop()
        return keeper

    return make


def kept(tmp_path):
    """The last line of each number."""
    text = (tmp_path / "logs" / NAME).read_text(encoding="utf-8")
    entries = [from_record(json.loads(line)) for line in text.splitlines()]
    return {each.number: each for each in entries}, len(entries)


def test_everything_is_written_and_what_changes_is_written_again(rig, keep, tmp_path):
    keeper = keep(AtOnce())
    rig.ready()
    keeper.keep()
    entries, lines = kept(tmp_path)
    assert lines == len(entries) == rig.controller.events.newest
    keeper.keep()
    assert kept(tmp_path)[1] == lines
    accepted(rig.controller.motion.send_joints((20.0, 0, 0, 0, 0, 0)))
    rig.run(0.1)
    keeper.keep()
    assert any(each.goes_on for each in kept(tmp_path)[0].values())
    rig.run(2.0)
    keeper.keep()
    entries, lines = kept(tmp_path)
    assert lines > len(entries)
    written = [to_json(entries[number]) for number in sorted(entries)]
    assert written == [to_json(each) for each in rig.controller.events.entries()]


def test_each_line_names_its_run(rig, keep, tmp_path):
    for _ in range(2):
        keeper = keep(AtOnce())
        keeper._run += str(id(keeper))
        rig.connect()
        keeper.close()
        rig.controller.disconnect_device()
    lines = (tmp_path / "logs" / NAME).read_text(encoding="utf-8").splitlines()
    assert len({json.loads(line)["run"] for line in lines}) == 2


def test_a_full_disk_is_said_once_tried_again_and_nothing_is_lost(rig, keep, tmp_path):
    files = Full()
    keeper = keep(files)
    rig.ready()
    for _ in range(25):
        keeper.keep()
    assert files.asked == 1
    told = [each for each in rig.controller.events.entries() if each.code == "not_kept"]
    assert [each.params for each in told] == [{"text": "No space left on device"}]
    assert told[0].count == 1
    for _ in range(40):
        keeper.keep()
    assert files.asked == 3
    assert [each.count for each in rig.controller.events.entries() if each.code == "not_kept"] == [
        1
    ]
    files.full = False
    for _ in range(40):
        keeper.keep()
    assert sorted(kept(tmp_path)[0]) == list(range(1, rig.controller.events.newest + 1))


def test_a_folder_that_cannot_be_written_hurts_nobody(rig, keep, tmp_path):
    (tmp_path / "logs").write_text("in the way", "ascii")
    keeper = keep(AtOnce())
    rig.ready()
    keeper.keep()
    rig.run(0.5)
    assert "not_kept" in [each.code for each in rig.controller.events.entries()]
    keeper.close()
    assert (tmp_path / "logs").read_text("ascii") == "in the way"


def test_a_disk_that_hangs_gets_one_piece_of_work_and_is_said(rig, keep, tmp_path):
    files = Slow()
    keeper = keep(files)
    rig.ready()
    for _ in range(20):
        keeper.keep()
        rig.step()
    assert len(files.waiting) == 1
    codes = [each.code for each in rig.controller.events.entries()]
    assert "not_kept" not in codes
    for _ in range(15):
        keeper.keep()
    (told,) = [each for each in rig.controller.events.entries() if each.code == "not_kept"]
    assert told.params == {}
    files.work()
    for _ in range(40):
        keeper.keep()
        files.work()
    assert sorted(kept(tmp_path)[0]) == list(range(1, rig.controller.events.newest + 1))


def test_at_the_end_the_rest_is_written_behind_what_is_under_way(rig, keep, tmp_path):
    files = Slow()
    keeper = keep(files)
    rig.ready()
    keeper.keep()
    rig.controller.disconnect_device()
    keeper.close()
    files.work()
    entries, _lines = kept(tmp_path)
    assert list(entries.values())[-1].code == "disconnected"


def test_a_second_without_events_asks_nothing_of_the_disk(rig, keep, monkeypatch):
    keeper = keep(AtOnce())
    rig.ready()
    keeper.keep()
    monkeypatch.setattr(module, "write", None)  # calling it would fail
    for _ in range(5):
        rig.run(0.1)
        keeper.keep()
    assert "not_kept" not in [each.code for each in rig.controller.events.entries()]
