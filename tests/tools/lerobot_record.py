"""Records and replays with the real LeRobot: ``python -m tests.tools.lerobot_record --python P``.

LeRobot and the clients are installed into an environment of theirs before, 5 GB (Python 3.12)::

    pip install 'lerobot[dataset]==0.6.1' resources/clients/armui_client \
        resources/clients/lerobot_robot_armui resources/clients/lerobot_teleoperator_armui

One simulated arm is led by a sine, LeRobot has another one follow it, records that, and replays it.
Told are the rate kept, the age of observations, and what was asked beside what the arm did.
"""

from __future__ import annotations

import argparse
import math
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq

import armui_client

MID = (0.0, 40.0, -50.0, 0.0, 20.0, 0.0)
AMPLITUDE_DEG = 15.0
PERIOD_S = 4.0
FPS = 30
_STARTS_S = 30.0


@contextmanager
def simulated_arm(path: Path) -> Iterator[None]:
    """A simulated arm, its interface at a path, whose operator grants everything; it is enabled."""
    command = [sys.executable, "-m", "armui", "sim", "--api-on", "--grant", "--socket", str(path)]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    try:
        until_s = time.monotonic() + _STARTS_S
        while not path.exists() and time.monotonic() < until_s:
            time.sleep(0.1)
        with armui_client.connect("ready", path=path) as arm:
            ready(arm)
        yield
    finally:
        process.send_signal(signal.SIGINT)
        process.wait(10.0)


def ready(arm: armui_client.Arm) -> None:
    """Enable the arm, and have it stand in the middle."""
    with arm.lease("ready"):
        if not arm.is_enabled():
            arm.enable()
        arm.set_speed(50)
        arm.move_joints(MID)
        arm.gripper(30.0)
        arm.set_speed(100)


@contextmanager
def led(path: Path) -> Iterator[None]:
    """The arm at a path is led by a sine meanwhile, its gripper too."""
    over = threading.Event()

    def lead() -> None:
        with armui_client.connect("leader", path=path) as arm, arm.lease("a sine"):
            began_s = time.monotonic()
            stream = arm.stream(50.0, raises=False)
            while not over.is_set():
                turn = math.sin(math.tau * (time.monotonic() - began_s) / PERIOD_S)
                stream.target([each + AMPLITUDE_DEG * turn for each in MID])
                arm.gripper(30.0 + 10.0 * turn, wait=False)
            stream.end()

    thread = threading.Thread(target=lead)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


def ages_s(path: Path, duration_s: float) -> list[float]:
    """Return the ages of angles read at LeRobot's rate."""
    found = []
    with armui_client.connect("ages", path=path) as arm:
        until_s = time.monotonic() + duration_s
        while time.monotonic() < until_s:
            age_s = arm.state(["joints_deg"]).joints_deg.age_s
            found += [] if age_s is None else [age_s]
            time.sleep(1.0 / FPS)
    return found


def told(name: str, values: Sequence[float], unit: str) -> None:
    """Print the median, the 99th percentile and the largest of some figures."""
    p50, p99, most = np.percentile(values, (50, 99, 100))
    print(f"{name}: p50 {p50:.2f}, p99 {p99:.2f}, most {most:.2f} {unit}")


def behind(asked: np.ndarray, measured: np.ndarray) -> tuple[int, np.ndarray]:
    """Return by how many frames the measured angles are behind, and how far off they are then."""
    best: tuple[float, int, np.ndarray] | None = None
    for lag in range(15):
        off = np.abs(measured[lag:] - asked[: len(asked) - lag]).max(axis=1)
        if best is None or off.mean() < best[0]:
            best = float(off.mean()), lag, off
    assert best is not None
    return best[1], best[2]


def frames_of(dataset: Path) -> tuple[np.ndarray, np.ndarray]:
    """Return the actions and the observations of a dataset, six angles each."""
    files = sorted((dataset / "data").rglob("*.parquet"))
    tables = [pq.read_table(each) for each in files]
    columns = [[row for table in tables for row in table[name].to_pylist()] for name in NAMES]
    asked, measured = (np.array(column)[:, : len(MID)] for column in columns)
    return asked, measured


NAMES = ("action", "observation.state")


def main() -> int:
    """Record, replay, tell; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--python", type=Path, required=True, help="of LeRobot's environment")
    parser.add_argument("--seconds", type=int, default=60, help="that are recorded")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        home = Path(folder)
        follower, leader, dataset = home / "follower.sock", home / "leader.sock", home / "dataset"
        environment = {**os.environ, "HF_HUB_OFFLINE": "1", "HF_HOME": str(home / "hf")}
        environment.pop("PYTHONPATH", None)

        def run(program: str, *arguments: str) -> str:
            """Run a program of LeRobot's; return what it says."""
            robot = ("type=armui", f"socket={follower}", "max_speed_percent=100")
            command = [
                str(options.python.with_name(program)),
                *(f"--robot.{each}" for each in robot),
                *("--dataset.repo_id=local/sine", f"--dataset.root={dataset}"),
                *("--play_sounds=false", *arguments),
            ]
            done = subprocess.run(
                command, env=environment, check=False, text=True, capture_output=True
            )
            words = done.stdout + done.stderr
            if done.returncode:
                raise SystemExit(f"{program} ended with {done.returncode}:\n{words[-4000:]}")
            return words

        with simulated_arm(follower), simulated_arm(leader):
            with led(leader):
                words = run(
                    "lerobot-record",
                    *("--teleop.type=armui", f"--teleop.socket={leader}"),
                    *("--dataset.num_episodes=1", "--dataset.single_task=a sine"),
                    *(f"--dataset.episode_time_s={options.seconds}", f"--dataset.fps={FPS}"),
                    *("--dataset.reset_time_s=0", "--dataset.push_to_hub=false"),
                )
                found = ages_s(follower, 5.0)
            asked, measured = frames_of(dataset)
            print(f"recorded: {len(asked)} frames in {options.seconds} s at {FPS} Hz, of which")
            print(f"  slower than asked: {words.count('running slower')}")
            print(f"  not followed: {words.count('armui does not follow')}")
            told("age of the angles", [1e3 * each for each in found], "ms")
            lag, off = behind(asked, measured)
            print(f"the arm is {lag} frames ({1e3 * lag / FPS:.0f} ms) behind what was asked;")
            told("  it is off then by", list(off), "degrees")
            with armui_client.connect("ready", path=follower) as arm:
                ready(arm)
                driven: list[tuple[float, ...]] = []
                over = threading.Event()

                def watch() -> None:
                    for state in arm.subscribe(FPS, ["joints_deg"]):
                        if over.is_set():
                            return
                        driven.append(state.joints_deg.get())

                watching = threading.Thread(target=watch)
                watching.start()
                words = run("lerobot-replay", "--dataset.episode=0")
                over.set()
                watching.join()
                enabled = arm.is_enabled()
        print(f"replayed: not followed {words.count('armui does not follow')}")
        path, wanted = np.array(driven), np.array(asked)
        off = np.array([np.abs(path - each).max(axis=1).min() for each in wanted])
        told("  the arm came to each recorded action by", list(off), "degrees")
        print(f"after LeRobot has disconnected the motors are {'on' if enabled else 'OFF'}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
