"""A dataset of LeRobot v3.0, as pyarrow sees it: every name and type, and what is left out."""

from __future__ import annotations

import argparse
import json

import numpy as np
import pytest
from pyarrow import parquet

from armui.export.export_command import add_arguments, run
from armui.protocol.generation import Generation
from armui.session.exports.export import export_log, open_source
from armui.session.exports.lerobot.episodes import NAMES
from armui.session.exports.request import (
    EpisodeOptions,
    ExportError,
    ExportFormat,
    ExportProblem,
    ExportRequest,
)
from armui.session.recording.episodes import Episode, episode_line
from armui.sim.faults.schedule import Fault
from tests.session.recordings import START_S, frames, moving, write

FPS = 30
COUNTED = {"frame_index", "episode_index", "index", "task_index"}
STATISTICS = {"min", "max", "mean", "std", "count", "q01", "q10", "q50", "q90", "q99"}


def log_of(path, seconds=12.0, *, generation=Generation.TWO, faults=(), heard=None):
    recorded = frames(seconds, generation, faults=faults, asked=moving(generation))
    wanted = heard or (lambda _at_s, _frame: True)
    write(path, [each for each in recorded if wanted(each[0] - START_S, each[1])])
    return path


class Dataset:
    """A dataset that was written."""

    def __init__(self, folder):
        self.folder = folder
        self.info = json.loads((folder / "meta/info.json").read_text())
        self.stats = json.loads((folder / "meta/stats.json").read_text())
        self.data = parquet.ParquetFile(folder / "data/chunk-000/file-000.parquet")
        self.episodes = parquet.read_table(
            folder / "meta/episodes/chunk-000/file-000.parquet"
        ).to_pylist()
        self.tasks = parquet.read_table(folder / "meta/tasks.parquet")
        self.rows = self.data.read().to_pydict()
        self.state = np.array(self.rows["observation.state"])
        self.action = np.array(self.rows["action"])


def exported(log, **more):
    target = log.with_name("dataset")
    request = ExportRequest(log, target, ExportFormat.LEROBOT, **more)
    report = export_log(request)
    return Dataset(target), report


def said(report):
    return [note.code for note in report.notes]


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """A log of an arm that is told to move, as a dataset and as a table of each set of angles."""
    log = log_of(tmp_path_factory.mktemp("log") / "a.blf")
    found, report = exported(log, episodes=EpisodeOptions(FPS, "wave"))
    export_log(ExportRequest(log, log.with_name("a.parquet"), ExportFormat.PARQUET))
    return found, report, parquet.read_table(log.with_name("a.parquet")).to_pandas()


def test_the_files_are_those_that_lerobot_reads(whole):
    found, report, _ = whole
    assert {str(each.relative_to(found.folder)) for each in found.folder.rglob("*.*")} == {
        "meta/info.json",
        "meta/stats.json",
        "meta/tasks.parquet",
        "meta/episodes/chunk-000/file-000.parquet",
        "data/chunk-000/file-000.parquet",
    }
    count = len(found.state)
    assert report.items == count == pytest.approx(12 * FPS, abs=1)
    vector = {"dtype": "float32", "shape": [7], "names": list(NAMES)}
    plain = {name: {"dtype": "int64", "shape": [1], "names": None} for name in COUNTED}
    assert found.info == {
        "codebase_version": "v3.0",
        "fps": FPS,
        "features": {
            "observation.state": vector,
            "action": vector,
            "timestamp": {"dtype": "float32", "shape": [1], "names": None},
            **plain,
        },
        "total_episodes": 1,
        "total_frames": count,
        "total_tasks": 1,
        "chunks_size": 1000,
        "data_files_size_in_mb": 100,
        "video_files_size_in_mb": 200,
        "data_path": "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet",
        "video_path": None,
        "robot_type": "armui",
        "splits": {"train": "0:1"},
    }


def test_the_columns_have_the_types_that_lerobot_reads(whole):
    found, _, _ = whole
    types = {field.name: str(field.type) for field in found.data.schema_arrow}
    assert (
        types.pop("observation.state")
        == types.pop("action")
        == "fixed_size_list<element: float>[7]"
    )
    assert types.pop("timestamp") == "float"
    assert types == dict.fromkeys(COUNTED, "int64")
    assert found.data.metadata.num_row_groups == len(found.episodes) == 1
    assert found.data.metadata.row_group(0).column(0).compression == "SNAPPY"
    assert found.tasks.to_pandas().index.tolist() == ["wave"]
    assert found.tasks.to_pandas()["task_index"].tolist() == [0]
    (episode,) = found.episodes
    count = len(found.state)
    plain = {name: value for name, value in episode.items() if not name.startswith("stats/")}
    assert plain == {
        "episode_index": 0,
        "tasks": ["wave"],
        "length": count,
        "data/chunk_index": 0,
        "data/file_index": 0,
        "dataset_from_index": 0,
        "dataset_to_index": count,
        "meta/episodes/chunk_index": 0,
        "meta/episodes/file_index": 0,
    }
    features = {"observation.state", "action", "timestamp", *COUNTED}
    wanted = {f"stats/{name}/{what}" for name in features for what in STATISTICS}
    assert set(episode) - set(plain) == wanted
    assert set(found.stats) == features
    assert all(set(each) == STATISTICS for each in found.stats.values())
    assert found.stats["action"]["max"] == pytest.approx(found.action.max(axis=0))
    assert found.stats["observation.state"]["q50"] == pytest.approx(np.median(found.state, axis=0))
    assert found.stats["index"]["count"] == [count]


def test_each_frame_has_what_was_last_heard_then(whole):
    found, _, table = whole
    times_s = table["since_start"].to_numpy()
    names = [*(f"joint_angle.{joint}" for joint in range(1, 7)), "gripper_opening"]
    measured = table[[f"arm.{name}" for name in names]].to_numpy()
    asked = table[[f"command.{name}" for name in names]].to_numpy()
    first_s = np.ceil(times_s[0] * FPS - 1e-6) / FPS
    assert first_s < 0.1
    for frame in range(0, len(found.state), 7):
        at = np.searchsorted(times_s, first_s + frame / FPS + 1e-6, side="right") - 1
        assert found.state[frame] == pytest.approx(measured[at], abs=1e-3)
        wanted = np.where(np.isfinite(asked[at]), asked[at], measured[at])
        assert found.action[frame] == pytest.approx(wanted, abs=1e-3)
    assert found.rows["timestamp"] == pytest.approx(np.arange(len(found.state)) / FPS, abs=1e-4)
    assert np.abs(found.state[:, 0]).max() > 30.0


def test_what_no_host_asked_is_where_the_arm_was_and_that_is_said(whole):
    found, report, _ = whole
    assert said(report) == ["episodes_unmarked", "actions_measured"]
    before = found.action[: round(1.4 * FPS), :6]
    assert before == pytest.approx(found.state[: len(before), :6])
    unasked = report.notes[-1].params
    assert 1.4 * FPS <= unasked["count"] <= 1.6 * FPS
    assert unasked["all"] == len(found.state)


def test_a_silence_parts_episodes_and_is_said(tmp_path):
    def heard(at_s, frame):
        return not (4.0 < at_s < 5.5 and frame.arbitration_id == 0x2A5)

    found, report = exported(log_of(tmp_path / "a.blf", heard=heard))
    first, second = found.episodes
    assert first["length"] == pytest.approx(4.1 * FPS, abs=2)
    assert second["length"] == pytest.approx(6.5 * FPS, abs=2)
    assert second["dataset_from_index"] == first["length"]
    silent = next(each for each in report.notes if each.code == "episode_silent")
    assert silent.params["begin"] == pytest.approx(4.1, abs=0.05)
    assert silent.params["end"] == pytest.approx(5.5, abs=0.05)
    index = found.rows["frame_index"]
    assert index[first["length"] - 1 : first["length"] + 1] == [first["length"] - 1, 0]
    assert found.data.metadata.num_row_groups == 2


def test_a_fault_and_a_stop_are_in_no_episode(tmp_path):
    faults = (Fault("joint-communication", 3, 6.0, 7.0),)
    found, report = exported(log_of(tmp_path / "a.blf", 19.5, faults=faults))
    assert said(report).count("episode_fault") == 2
    assert [each.params["begin"] for each in report.notes if each.code == "episode_fault"] == [
        pytest.approx(6.0, abs=0.1),
        pytest.approx(17.0, abs=0.1),
    ]
    lengths = [each["length"] / FPS for each in found.episodes]
    assert lengths[:2] == [pytest.approx(6.0, abs=0.2), pytest.approx(10.0, abs=0.2)]


def test_generation_1_has_no_opening(tmp_path):
    found, _ = exported(log_of(tmp_path / "a.blf", generation=Generation.ONE))
    assert found.info["features"]["action"]["shape"] == [6]
    assert found.info["features"]["action"]["names"] == list(NAMES[:6])
    assert found.state.shape[1] == 6


def test_marked_episodes_alone_are_taken(tmp_path):
    log = log_of(tmp_path / "a.blf")
    marked = [
        Episode(1, START_S + 0.5, START_S + 1.9, "a try", discarded=True),
        Episode(2, START_S + 2.0, START_S + 5.0, "pick"),
        Episode(3, START_S + 6.0),
    ]

    def opened(path):
        source = open_source(path)
        source.lines = [episode_line(each) for each in marked]
        return source

    request = ExportRequest(log, tmp_path / "d", ExportFormat.LEROBOT)
    report = export_log(request, open_recording=opened)
    found = Dataset(tmp_path / "d")
    assert [each["length"] / FPS for each in found.episodes] == [
        pytest.approx(3.0, abs=0.1),
        pytest.approx(6.0, abs=0.1),
    ]
    assert [each["tasks"] for each in found.episodes] == [["pick"], ["PiPER"]]
    assert found.tasks.to_pandas().index.tolist() == ["pick", "PiPER"]
    assert "episodes_unmarked" not in said(report)


def test_a_log_whose_episodes_were_all_discarded_makes_no_dataset(tmp_path):
    log = log_of(tmp_path / "a.blf", 3.0)

    def opened(path):
        source = open_source(path)
        source.lines = [episode_line(Episode(1, START_S, START_S + 2.0, discarded=True))]
        return source

    request = ExportRequest(log, tmp_path / "d", ExportFormat.LEROBOT)
    with pytest.raises(ExportError) as error:
        export_log(request, open_recording=opened)
    assert error.value.problem is ExportProblem.NO_EPISODE


def test_too_short_a_log_makes_no_dataset(tmp_path):
    log = log_of(tmp_path / "a.blf", 0.8)
    with pytest.raises(ExportError) as error:
        exported(log)
    assert error.value.problem is ExportProblem.NO_EPISODE
    assert [each.name for each in tmp_path.iterdir()] == ["a.blf"]


def test_the_command_never_replaces_a_dataset(tmp_path, capsys):
    log = log_of(tmp_path / "a.blf", 3.0)
    parser = argparse.ArgumentParser()
    add_arguments(parser)
    words = [str(log), "--to", "lerobot", "--fps", "50", "--task", "a walk"]
    assert run(parser.parse_args(words)) == 0
    told = capsys.readouterr()
    assert " frames" in told.out
    assert "a walk" in told.err
    assert Dataset(tmp_path / "a-lerobot").info["fps"] == 50
    assert run(parser.parse_args([*words, "--force"])) == 2
    assert "never replaced" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        parser.parse_args([str(log), "--fps", "0"])
