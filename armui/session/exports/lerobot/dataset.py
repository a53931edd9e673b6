"""Writes episodes as a dataset of LeRobot v3.0: Parquet and JSON, in the folders that it reads."""

from __future__ import annotations

import json
import os
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, BinaryIO, Final, NamedTuple

import numpy as np

from armui.system.atomic import sync_folder
from armui.system.files import open_file

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from pathlib import Path

    from numpy.typing import NDArray

    Array = NDArray[Any]

STATE: Final = "observation.state"
ACTION: Final = "action"
ROBOT: Final = "armui"
"""The type of robot whose keys these are: ``lerobot_robot_armui``."""

_DATA: Final = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
_EPISODES: Final = "meta/episodes/chunk-000/file-000.parquet"
_QUANTILES: Final = (1, 10, 50, 90, 99)
_COUNTED: Final = ("frame_index", "episode_index", "index", "task_index")


class EpisodeFrames(NamedTuple):
    """An episode at an even rate.

    Attributes:
        task: What was done, in words.
        state: (n, k) where the arm was.
        action: (n, k) what it was asked.
    """

    task: str
    state: Array
    action: Array


def write_dataset(
    folder: Path, episodes: Sequence[EpisodeFrames], names: Sequence[str], fps: int
) -> None:
    """Write a dataset into an empty folder.

    Args:
        folder: The folder; it exists.
        episodes: At least one.
        names: The names of the k values.
        fps: Frames a second.

    Raises:
        ImportError: pyarrow is not installed.
        OSError: The disk does not take it.
    """
    import pyarrow as pa  # noqa: PLC0415 - optional
    from pyarrow import parquet  # noqa: PLC0415 - optional

    tasks = list(dict.fromkeys(each.task for each in episodes))
    vector = pa.list_(pa.float32(), len(names))
    columns = {STATE: vector, ACTION: vector, "timestamp": pa.float32()}
    schema = pa.schema([*columns.items(), *((name, pa.int64()) for name in _COUNTED)])
    data = folder / _DATA.format(chunk_index=0, file_index=0)
    for each in (data, folder / _EPISODES):
        each.parent.mkdir(parents=True)
    rows, first = [], 0
    together: list[dict[str, Array]] = []
    with _written(data) as file, parquet.ParquetWriter(file, schema) as writer:
        for number, episode in enumerate(episodes):
            values = _values(episode, number, first, tasks.index(episode.task), fps)
            together.append(values)
            writer.write_table(_table(pa, schema, values))
            first += len(episode.state)
            rows.append(_row(number, episode, first, _stats(values)))
    with _written(folder / _EPISODES) as file:
        parquet.write_table(pa.Table.from_pylist(rows), file)
    with _written(folder / "meta/tasks.parquet") as file:
        parquet.write_table(_tasks(pa, tasks), file)
    whole = {name: np.concatenate([each[name] for each in together]) for name in schema.names}
    _write_json(folder / "meta/stats.json", _stats(whole))
    _write_json(folder / "meta/info.json", _info(episodes, tasks, names, fps))
    for each in {data.parent, data.parents[1], (folder / _EPISODES).parent, folder / "meta"}:
        sync_folder(each)


def _values(
    episode: EpisodeFrames, number: int, first: int, task: int, fps: int
) -> dict[str, Array]:
    count = len(episode.state)
    frames = np.arange(count)
    return {
        STATE: episode.state.astype(np.float32),
        ACTION: episode.action.astype(np.float32),
        "timestamp": (frames / fps).astype(np.float32),
        "frame_index": frames,
        "episode_index": np.full(count, number),
        "index": first + frames,
        "task_index": np.full(count, task),
    }


def _table(pa: Any, schema: Any, values: dict[str, Array]) -> Any:
    arrays = []
    for field in schema:
        array = values[field.name]
        if array.ndim > 1:
            flat = pa.array(array.ravel(), pa.float32())
            arrays.append(pa.FixedSizeListArray.from_arrays(flat, array.shape[1]))
        else:
            arrays.append(pa.array(array, field.type))
    return pa.Table.from_arrays(arrays, schema=schema)


def _row(number: int, episode: EpisodeFrames, end: int, stats: dict[str, Any]) -> dict[str, Any]:
    """Return the entry of an episode in ``meta/episodes``."""
    return {
        "episode_index": number,
        "tasks": [episode.task],
        "length": len(episode.state),
        "data/chunk_index": 0,
        "data/file_index": 0,
        "dataset_from_index": end - len(episode.state),
        "dataset_to_index": end,
        **{
            f"stats/{name}/{what}": told
            for name, each in stats.items()
            for what, told in each.items()
        },
        "meta/episodes/chunk_index": 0,
        "meta/episodes/file_index": 0,
    }


def _stats(values: dict[str, Array]) -> dict[str, dict[str, list[Any]]]:
    """Return for each column its statistics, a figure for each of its values."""
    found = {}
    for name, array in values.items():
        table = array.reshape(len(array), -1).astype(np.float64)
        told = {
            "min": table.min(axis=0),
            "max": table.max(axis=0),
            "mean": table.mean(axis=0),
            "std": table.std(axis=0),
        }
        quantiles = np.percentile(table, _QUANTILES, axis=0)
        told |= {f"q{each:02d}": row for each, row in zip(_QUANTILES, quantiles, strict=True)}
        found[name] = {what: each.tolist() for what, each in told.items()}
        found[name]["count"] = [len(table)]
    return found


def _tasks(pa: Any, tasks: Sequence[str]) -> Any:
    """Return the table of tasks; pandas reads their words as the index."""
    number = {"name": "task_index", "pandas_type": "int64", "numpy_type": "int64"}
    words = {"name": "task", "pandas_type": "unicode", "numpy_type": "object"}
    columns = [{**each, "field_name": each["name"], "metadata": None} for each in (number, words)]
    told = {"index_columns": ["task"], "column_indexes": [], "columns": columns}
    fields = [("task_index", pa.int64()), ("task", pa.string())]
    schema = pa.schema(fields, {"pandas": json.dumps({**told, "pandas_version": "2.3.3"})})
    return pa.Table.from_arrays([list(range(len(tasks))), list(tasks)], schema=schema)


def _info(
    episodes: Sequence[EpisodeFrames], tasks: Sequence[str], names: Sequence[str], fps: int
) -> dict[str, Any]:
    vector: dict[str, Any] = {"dtype": "float32", "shape": [len(names)], "names": list(names)}
    features = {STATE: vector, ACTION: vector}
    features["timestamp"] = {"dtype": "float32", "shape": [1], "names": None}
    features |= {name: {"dtype": "int64", "shape": [1], "names": None} for name in _COUNTED}
    return {
        "codebase_version": "v3.0",
        "fps": fps,
        "features": features,
        "total_episodes": len(episodes),
        "total_frames": sum(len(each.state) for each in episodes),
        "total_tasks": len(tasks),
        "chunks_size": 1000,
        "data_files_size_in_mb": 100,
        "video_files_size_in_mb": 200,
        "data_path": _DATA,
        "video_path": None,
        "robot_type": ROBOT,
        "splits": {"train": f"0:{len(episodes)}"},
    }


def _write_json(path: Path, told: dict[str, Any]) -> None:
    with _written(path) as file:
        file.write(json.dumps(told, indent=4, allow_nan=False).encode())


@contextmanager
def _written(path: Path) -> Iterator[BinaryIO]:
    """Yield a file to write, and sync it to the disk afterwards."""
    with open_file(path, "wb") as file:
        yield file
        file.flush()
        os.fsync(file.fileno())
