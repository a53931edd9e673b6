"""Lines made from templates are those that each frame would be given by itself."""

from __future__ import annotations

import json
import random

import pytest

from armui.decode import lines as lines_module
from armui.decode.lines import LineFormat
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.protocol.layout import load_database
from armui.session.reader import LogFile

DRAW = random.Random(3)
BUSES = ("can0", "can1")


def log_of(tmp_path, *lines: str):
    path = tmp_path / "run.log"
    path.write_text("".join(f"({n / 8:.6f}) {each}\n" for n, each in enumerate(lines)))
    return path


def made(path, generation: Generation, *, as_json: bool) -> tuple[list[str], list[str]]:
    """All lines of a log at once, and one by one."""
    with LogFile(path) as log:
        batches = list(log.batches())
    together, alone = (LineFormat(Codec(generation), as_json=as_json) for _ in range(2))
    return (
        [line for batch in batches for line in together.lines(batch)],
        [alone._single(batch, row) for batch in batches for row in range(len(batch))],
    )


def payload(length: int) -> str:
    """Often sparse, so that codes are legal now and then."""
    some = DRAW.choice([DRAW.randbytes, lambda n: bytes(DRAW.choice((0, 1, 2)) for _ in range(n))])
    return some(length).hex().upper()


@pytest.mark.each_value(full="both outputs in both generations")
@pytest.mark.parametrize("as_json", [False, True])
@pytest.mark.parametrize("generation", Generation)
def test_every_message_with_any_content_in_any_order(tmp_path, generation, as_json):
    ids = [message.frame_id for message in load_database(generation).messages] + [0x777, 0x4A0]
    lines = [
        f"{DRAW.choice(BUSES)} {DRAW.choice(ids):03X}#{payload(DRAW.choice((8, 8, 8, 4, 1)))}"
        for _ in range(3_000)
    ]
    together, alone = made(log_of(tmp_path, *lines), generation, as_json=as_json)
    assert together == alone
    if as_json:
        assert all(isinstance(json.loads(line), dict) for line in together)


def test_more_combinations_of_codes_than_are_kept(tmp_path, monkeypatch):
    monkeypatch.setattr(lines_module, "_MOST_TEMPLATES", 5)
    lines = [f"can0 2A1#{payload(8)}" for _ in range(200)]
    together, alone = made(log_of(tmp_path, *lines), Generation.TWO, as_json=True)
    assert together == alone


def test_another_channel_is_named(tmp_path):
    path = log_of(tmp_path, "can0 2A5#0000000000000000", "can1 2A5#0000000000000000",
                  "can1 777#AA", "can0 777#AA")  # fmt: skip
    texts, _ = made(path, Generation.TWO, as_json=False)
    assert ["[can1]" in each for each in texts] == [False, True, True, False]
    objects = [json.loads(each) for each in made(path, Generation.TWO, as_json=True)[0]]
    assert [each.get("channel") for each in objects] == [None, "can1", "can1", None]
