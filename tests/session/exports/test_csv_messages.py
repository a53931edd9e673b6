"""A folder with a CSV file for each message, as pandas sees it, beside the codec frame by frame."""

from __future__ import annotations

import os
from collections import defaultdict
from pathlib import Path
from typing import Any

import pandas as pd
import pytest

from armui.export.process import ExportProcess
from armui.protocol.codec import Codec, Message
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.session.exports.export import export_log
from armui.session.exports.request import (
    ArmOptions,
    ExportError,
    ExportFormat,
    ExportProblem,
    ExportReport,
    ExportRequest,
    default_target,
)
from armui.system.atomic import WholeFolder
from tests.session.exports.logs import START_S, candump, session

KIND = ExportFormat.CSV_MESSAGES


def export(log: Path, **more: Any) -> ExportReport:
    return export_log(ExportRequest(log, default_target(log, KIND), KIND, **more))


def files(folder: Path) -> dict[str, pd.DataFrame]:
    return {
        path.stem.partition("_")[2]: pd.read_csv(path, encoding="utf-8-sig")
        for path in folder.iterdir()
    }


@pytest.mark.parametrize("generation", list(Generation))
def test_every_frame_stands_in_the_file_of_its_message(tmp_path, generation):
    frames = session(0.6, generation)
    log = candump(tmp_path / "run.log", frames)
    report = export(log, wishes=ArmOptions(generation))

    codec, expected = Codec(generation), defaultdict(list)
    for at_s, frame in frames:
        said = codec.decode(frame)
        if isinstance(said, Message):
            expected[said.name].append((at_s, said.signals))
    found = files(tmp_path / "run-messages")
    assert found.keys() == expected.keys()
    assert report.items == sum(map(len, expected.values())) > 400
    for name, rows in expected.items():
        table = found[name]
        assert table["time [s]"].tolist() == pytest.approx([at_s for at_s, _ in rows], abs=1e-6)
        assert table["since_start [s]"].iloc[0] == pytest.approx(rows[0][0] - START_S, abs=1e-6)
        by_name = {title.partition(" [")[0]: title for title in table.columns}
        for signal, value in rows[-1][1].items():
            assert table[by_name[signal]].iloc[-1] == pytest.approx(float(value)), (name, signal)


def test_names_titles_and_figures_are_those_of_the_protocol(tmp_path):
    angles = Frame(0x2A5, bytes.fromhex("00002EE0FFFE9E7C"))  # 12° and -90.5°, in 0.001°
    log = candump(tmp_path / "run.log", [(1.0, angles), (1.25, angles)])
    export(log, wishes=ArmOptions(Generation.TWO))
    text = (tmp_path / "run-messages" / "2A5_JointFeedback12.csv").read_bytes()
    assert text.startswith(b"\xef\xbb\xbftime [s],since_start [s],J1 [")
    assert text.splitlines()[1:] == [
        b"1.000000,0.000000,12.0,-90.5", b"1.250000,0.250000,12.0,-90.5",
    ]  # fmt: skip


def test_a_stretch_of_time_and_a_log_of_many_pieces(tmp_path):
    frames = [(number / 1000, Frame(0x2A5, bytes(8))) for number in range(80_000)]
    report = export(candump(tmp_path / "run.log", frames), begin_s=30.0, end_s=70.0)
    table = files(tmp_path / "run-messages")["JointFeedback12"]
    assert report.items == len(table) == 40_001
    assert table["time [s]"].iloc[[0, -1]].tolist() == [30.0, 70.0]
    assert (table["time [s]"].diff().dropna() > 0).all()


def test_a_folder_that_is_there_is_replaced_only_if_asked_and_if_it_is_an_export(tmp_path):
    log = candump(tmp_path / "run.log", session(0.1))
    export(log)
    folder = tmp_path / "run-messages"
    before = sorted(each.name for each in folder.iterdir())
    with pytest.raises(ExportError) as caught:
        export(log)
    assert caught.value.problem is ExportProblem.EXISTS
    (folder / "old.csv").write_text("")
    export(log, replace=True)
    assert sorted(each.name for each in folder.iterdir()) == before

    (folder / "thesis.txt").write_text("mine")
    with pytest.raises(ExportError) as caught:
        export(log, replace=True)
    assert caught.value.problem is ExportProblem.CANNOT_WRITE
    assert "thesis.txt" in caught.value.detail
    assert (folder / "thesis.txt").read_text() == "mine"
    assert sorted(each.name for each in tmp_path.iterdir()) == ["run-messages", "run.log"]


def test_a_folder_that_cannot_take_its_name_leaves_the_old_one(tmp_path, monkeypatch):
    log = candump(tmp_path / "run.log", session(0.1))
    export(log)
    moved = Path.replace

    def replace(path, target):
        if target.name == "run-messages" and path.joinpath("new").exists():
            raise OSError("no")
        return moved(path, target)

    whole = WholeFolder(tmp_path / "run-messages", ".csv", replace=True)
    (whole.unfinished / "new").write_text("")
    monkeypatch.setattr(Path, "replace", replace)
    with whole, pytest.raises(OSError, match="no"):
        whole.finish()
    assert (tmp_path / "run-messages" / "2A1_ArmStatus.csv").exists()
    assert sorted(each.name for each in tmp_path.iterdir()) == ["run-messages", "run.log"]


def test_a_killed_export_leaves_no_folder(tmp_path):
    log = candump(tmp_path / "run.log", session(0.1))
    process = ExportProcess.__new__(ExportProcess)
    process._unfinished = tmp_path / ".0123.unfinished"
    process._unfinished.mkdir()
    (process._unfinished / "2A1_ArmStatus.csv").write_text("half")
    process._remove_unfinished()
    assert list(tmp_path.iterdir()) == [log]

    forgotten = tmp_path / ".4567.unfinished"
    forgotten.mkdir()
    os.utime(forgotten, (1.0, 1.0))
    export(log)
    assert not forgotten.exists()


@pytest.mark.parametrize(
    ("name", "kind", "target"),
    [
        ("a.blf", KIND, "a-messages"),
        ("a.log.gz", KIND, "a-messages"),
        ("a-messages", ExportFormat.CSV, "a.csv"),
        ("a-messages", ExportFormat.MCAP, "a.mcap"),
    ],
)
def test_the_target_s_name(name, kind, target):
    assert default_target(Path("/x") / name, kind) == Path("/x") / target
