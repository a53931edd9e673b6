"""The real LeRobot drives the arm: ``python -m tests.tools.lerobot_rollout --python P``.

Of its policy nothing is asked but targets: it is one of LeRobot's own that needs no images, with
chance weights, and wanders about a place 20° beside where the arm was found. Once it ends by its
time, and LeRobot drives the arm home; once the operator halts the arm meanwhile, and LeRobot's way
home is refused. See `lerobot_record` for the environment.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import numpy as np

import armui_client
from tests.tools.lerobot_record import FPS, MID, ready, simulated_arm

AWAY_DEG = 20.0
WANDER = 2.0
GRIPPER_MM = 30.0
DURATION_S = 8
_STARTS_S = 60.0

POLICY = """
import sys
import torch
from lerobot.configs.types import FeatureType, PolicyFeature
from lerobot.policies.factory import get_policy_class, make_policy_config, make_pre_post_processors

middle, around = eval(sys.argv[2]), float(sys.argv[3])
size = (len(middle),)
torch.manual_seed(3)
config = make_policy_config(
    "gaussian_actor",
    input_features={"observation.state": PolicyFeature(FeatureType.STATE, size)},
    output_features={"action": PolicyFeature(FeatureType.ACTION, size)},
    device="cpu",
    push_to_hub=False,
)
policy = get_policy_class("gaussian_actor")(config)
policy.save_pretrained(sys.argv[1])
ends = {"min": torch.tensor(middle) - around, "max": torch.tensor(middle) + around}
stats = {"observation.state": ends, "action": ends}
for each in make_pre_post_processors(config, dataset_stats=stats):
    each.save_pretrained(sys.argv[1])
"""


def rolled_out(python: Path, policy: Path, socket: Path, *, halted_after_s: float | None) -> str:
    """Run LeRobot's program; have the operator halt the arm; return what it says."""
    command = [
        str(python.with_name("lerobot-rollout")),
        *("--strategy.type=base", f"--policy.path={policy}", "--device=cpu"),
        *("--robot.type=armui", f"--robot.socket={socket}", "--robot.max_speed_percent=100"),
        *(f"--fps={FPS}", f"--duration={DURATION_S}", "--task=wander", "--play_sounds=false"),
    ]
    environment = {**os.environ, "HF_HUB_OFFLINE": "1"}
    environment.pop("PYTHONPATH", None)
    process = subprocess.Popen(
        command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    if halted_after_s is not None:
        with armui_client.connect("the operator", path=socket) as operator:
            until_s = time.monotonic() + _STARTS_S
            while abs(operator.state().joints_deg.get()[0] - MID[0]) < AWAY_DEG / 2:
                assert time.monotonic() < until_s, "the policy does not begin"
                time.sleep(0.05)
            time.sleep(halted_after_s)
            operator.halt()
    words, _ = process.communicate(timeout=120.0)
    return words


def main() -> int:
    """Roll out twice, tell; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--python", type=Path, required=True, help="of LeRobot's environment")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        home = Path(folder)
        socket, policy = home / "api.sock", home / "policy"
        middle = (MID[0] + AWAY_DEG, *MID[1:], GRIPPER_MM)
        subprocess.run(
            [options.python, "-c", POLICY, policy, repr(middle), str(WANDER)], check=True
        )
        with simulated_arm(socket):
            for halted_after_s in (None, 1.0):
                with armui_client.connect("ready", path=socket) as arm:
                    ready(arm)
                    driven: list[tuple[float, ...]] = []
                    over = threading.Event()

                    def watch(
                        arm: armui_client.Arm = arm,
                        over: threading.Event = over,
                        driven: list[tuple[float, ...]] = driven,
                    ) -> None:
                        for state in arm.subscribe(50, ["joints_deg"]):
                            if over.is_set():
                                return
                            driven.append(state.joints_deg.get())

                    watching = threading.Thread(target=watch)
                    watching.start()
                    words = rolled_out(
                        options.python, policy, socket, halted_after_s=halted_after_s
                    )
                    time.sleep(0.5)
                    over.set()
                    watching.join()
                path = np.array(driven)
                first_deg, last_deg, most_deg = path[0, 0], path[-1, 0], path[:, 0].max()
                print("halted" if halted_after_s else "ended by its time", end=": ")
                print(f"J1 {first_deg:.2f}° -> {most_deg:.2f}° -> {last_deg:.2f}°;", end=" ")
                warned = [each for each in words.splitlines() if "WARN" in each or "rror" in each]
                print(f"{len(warned)} warnings")
                for each in warned[:6]:
                    print("   ", each[:200])
                if halted_after_s is None:
                    assert abs(last_deg - first_deg) < 1.0, "it was not driven home"
                else:
                    rests = path[-20:, 0]
                    assert last_deg > AWAY_DEG / 2, "it was driven home after the halt"
                    assert rests.max() - rests.min() < 0.1
    print("all held")
    return 0


if __name__ == "__main__":
    sys.exit(main())
