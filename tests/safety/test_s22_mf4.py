"""S22: what an .mf4 holds costs itself at most: asammdf reads it in a process of its own.

Damaged files had asammdf go round in circles for good, and end its process by a segmentation fault.
"""

from __future__ import annotations

import argparse
import math
import os
import random
from collections import defaultdict
from pathlib import Path

import can
import pytest

from armui import decode, export
from armui.arm.refusal import Refusal
from armui.protocol.generation import Generation
from armui.session import mf4_process
from armui.session.foreign.indexing import index_or_reason
from armui.session.frames import LATEST_S, NotALogError
from armui.session.reader import LogFile
from armui.session.recording.folder import list_recordings
from tests.examples import sample
from tests.posix import kill
from tests.session.indexed import open_indexed
from tests.session.recording.made import recorded, taken
from tests.session.recordings import START_S, frames, greeting

pytest.importorskip("asammdf", reason="asammdf is not installed")
pytestmark = pytest.mark.timeout(150)


def written(path: Path, times=lambda at_s, _row: at_s, channel=lambda _row: 1) -> Path:
    """Half a second of an arm that greets."""
    writer = can.MF4Writer(path)
    for row, (at_s, frame) in enumerate(frames(0.5, asked=greeting(Generation.TWO))):
        message = can.Message(
            timestamp=times(at_s, row),
            arbitration_id=frame.arbitration_id,
            data=frame.data,
            is_extended_id=False,
            channel=channel(row),
        )
        writer.on_message_received(message)
    writer.stop()
    return path


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    return written(tmp_path_factory.mktemp("mf4") / "whole.mf4").read_bytes()


@pytest.fixture(autouse=True)
def soon(monkeypatch):
    monkeypatch.setattr(mf4_process, "_ANSWERS_WITHIN_S", 15.0)


def blocks_of(data: bytes) -> dict[str, list[int]]:
    """Where the blocks of each kind begin."""
    found = defaultdict(list)
    for place in range(0, len(data) - 4, 8):
        if data[place : place + 2] == b"##":
            found[data[place + 2 : place + 4].decode()].append(place)
    return found


def with_number(data: bytes, place: int, number: int, size: int = 8) -> bytes:
    return data[:place] + number.to_bytes(size, "little") + data[place + size :]


def behind_links(data: bytes, block: int) -> int:
    """Where a block's own data begin."""
    return block + 24 + 8 * int.from_bytes(data[block + 16 : block + 24], "little")


def circles(data):
    """The first link of a block of each kind leads to that block itself."""
    for kind, (first, *_others) in blocks_of(data).items():
        yield f"{kind} in a circle", with_number(data, first + 24, first)


def claims(data):
    """Far more frames than there are, or far longer ones, or further off."""
    for group in blocks_of(data)["CG"]:
        for power in (20, 40, 62):
            yield f"2^{power} frames", with_number(data, behind_links(data, group) + 8, 2**power)
        for size in (0, 1, 2**16, 2**32 - 1):
            yield (
                f"frames of {size} bytes",
                with_number(data, behind_links(data, group) + 24, size, 4),
            )
    for channel in blocks_of(data)["CN"][:4]:
        for offset in (58_880, 2**31, 2**32 - 1):
            yield (
                f"values {offset} bytes further",
                with_number(data, behind_links(data, channel) + 4, offset, 4),
            )


def cut_off(data):
    for number in range(40):
        yield f"cut off {number}", data[: len(data) * number // 40]


def flipped(data):
    rng = random.Random(23)
    for number in range(100):
        changed = bytearray(data)
        for _ in range(rng.choice([1, 2, 8, 50])):
            changed[rng.randrange(len(data))] = rng.randrange(256)
        yield f"flipped {number}", bytes(changed)


def crossed(data):
    """Links that lead to another block."""
    rng = random.Random(24)
    places = [place for kind in blocks_of(data).values() for place in kind]
    for number in range(60):
        block = rng.choice(places)
        links = (behind_links(data, block) - block - 24) // 8
        if 0 < links < 100:
            link = block + 24 + 8 * rng.randrange(links)
            yield f"crossed {number}", with_number(data, link, rng.choice(places))


@pytest.mark.parametrize("kind", [circles, claims, cut_off, flipped, crossed])
def test_a_damaged_file_is_read_as_far_as_it_goes_or_named_with_a_reason(kind, whole, tmp_path):
    path, reasons = tmp_path / "bad.mf4", list[str]()
    for name, data in sample(kind(whole), 3, kind.__name__):
        path.write_bytes(data)
        print(name)
        try:
            with LogFile(path) as log:
                for batch in log.batches():
                    assert len(batch)
        except NotALogError as error:
            reasons.append(str(error))
    assert all(reasons)


HANGS, DIES = "hangs", "dies"


@pytest.mark.parametrize("what", [HANGS, DIES])
def test_every_reader_of_it_says_so_and_goes_on(what, whole, tmp_path, capsys, monkeypatch):
    if what == HANGS:
        path = tmp_path / "bad.mf4"
        path.write_bytes(dict(circles(whole))["DG in a circle"])
        monkeypatch.setattr(mf4_process, "_ANSWERS_WITHIN_S", 4.0)
        reason = "asammdf reads nothing more within 4 s"
    else:
        path = recorded(tmp_path / "other", taken(20)).rename(tmp_path / "bad.mf4")
        monkeypatch.setattr(mf4_process, "_read", ended_without_a_word)
        reason = "asammdf ends without a word when it reads on"
    folder = tmp_path / "columns"
    folder.mkdir()
    refusal = index_or_reason(path, folder)
    assert isinstance(refusal, Refusal)
    assert refusal.params == {"name": "bad.mf4", "text": reason}

    for command, words in (
        (decode, [str(path)]),
        (export, [str(path), "-o", str(tmp_path / "a.csv")]),
    ):
        parser = argparse.ArgumentParser()
        command.add_arguments(parser)
        assert command.run(parser.parse_args(words)) == 2
        said = capsys.readouterr().err
        assert "bad.mf4" in said
        assert reason in said

    recorded(tmp_path, taken(20))
    assert [entry.damage for entry in list_recordings(tmp_path)] == [""]


def ended_without_a_word(_path, _its):
    """As a segmentation fault ends a process."""
    kill(os.getpid())


ODD_TIMES = {
    "not a number": math.nan,
    "infinite": math.inf,
    "negative": -2 * START_S,
    "1e308": 1e308,
    "decreasing": None,
}


@pytest.mark.parametrize("name", ODD_TIMES)
def test_strange_times(name, tmp_path):
    odd = ODD_TIMES[name]
    if odd is None:
        path = written(tmp_path / "a.mf4", lambda at_s, _row: 2 * START_S - at_s)
    else:
        path = written(
            tmp_path / "a.mf4", lambda at_s, row: odd if row and row % 100 == 0 else at_s
        )
    session = open_indexed(path)
    assert -LATEST_S <= session.start_s <= session.end_s <= LATEST_S
    assert session.frames > 1000
    session.close()


def test_hundreds_of_channels_and_none_at_all(tmp_path):
    session = open_indexed(written(tmp_path / "many.mf4", channel=lambda row: row % 250))
    assert len(session.channels) == 250
    session.close()
    empty = tmp_path / "empty.mf4"
    can.MF4Writer(empty).stop()
    refusal = index_or_reason(empty, tmp_path)
    assert isinstance(refusal, Refusal)
    assert refusal.code == "replay_empty"
