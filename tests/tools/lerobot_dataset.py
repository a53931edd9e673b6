"""Reads a dataset with the real LeRobot, by the interpreter of its environment::

    PATH/python tests/tools/lerobot_dataset.py FOLDER

Every frame that `LeRobotDataset` gives is compared with the file; so are episodes, tasks and rate.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pyarrow.parquet as pq


def main(folder: Path) -> int:
    """Compare; returns the number of frames that differ."""
    from lerobot.datasets import LeRobotDataset  # noqa: PLC0415 - 5 GB, in an environment of its own

    info = json.loads((folder / "meta/info.json").read_text())
    file = folder / info["data_path"].format(chunk_index=0, file_index=0)
    table = pq.read_table(file).to_pydict()
    read = LeRobotDataset("local/exported", root=folder)
    print(f"{read.num_episodes} episodes, {read.num_frames} frames at {read.fps} Hz")
    print(read.features)
    assert (read.num_episodes, read.num_frames) == (info["total_episodes"], len(table["index"]))
    differ = 0
    for place in range(read.num_frames):
        frame = read[place]
        same = all(
            frame[name].tolist() == table[name][place]
            for name in ("observation.state", "action", "frame_index", "episode_index", "index")
        )
        differ += not same
    print(f"tasks: {sorted({read[place]['task'] for place in (0, read.num_frames - 1)})}")
    print(f"statistics of {sorted(read.meta.stats)}")
    print(f"{differ} of {read.num_frames} frames differ")
    return differ


if __name__ == "__main__":
    sys.exit(min(1, main(Path(sys.argv[1]))))
