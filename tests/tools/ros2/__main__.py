"""`armui-ros2` in a real ROS 2: ``python -m tests.tools.ros2 --python ROS/bin/python``.

ROS is an environment with ROS 2 and the node, as the node's README tells. Before a simulated arm
a stranger's node, written from ROS's documentation alone, reads and sends; another client of armui
is the operator. Takes three minutes, on a computer that does little else; prints what was measured;
the exit code is 1 if something failed.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any, Final

import armui_client

ROOT: Final = Path(__file__).resolve().parents[3]
CLIENTS: Final = ROOT / "resources" / "clients"
STRANGER: Final = Path(__file__).with_name("stranger.py")
WITHIN_S: Final = 90.0
NAMES: Final = [f"joint{number}" for number in range(1, 7)]
HOME: Final = (0.0, 40.0, -50.0, 0.0, 20.0, 0.0)
UP: Final = ((1.5, (0.0, 30.0, -10.0, 0.0, 20.0, 0.0)), (3.0, HOME))
"""From the pose in which the arm rests, the hand near the base."""
FAR: Final = (100.0, 40.0, -50.0, 0.0, 20.0, 0.0)

failed: list[str] = []


def expect(what: str, found: object, *, holds: bool) -> None:
    print(f"{'ok    ' if holds else 'FAILED'} {what}: {found}", flush=True)
    if not holds:
        failed.append(what)


def trajectory(*points: tuple[float, Sequence[float]], smooth: bool = False) -> dict[str, Any]:
    """A trajectory through six angles in degrees at times; smooth: at rest at each of them."""
    found: list[dict[str, Any]] = []
    for time_s, angles in points:
        found.append({"time": time_s, "positions": [math.radians(each) for each in angles]})
        if smooth:
            found[-1]["velocities"] = [0.0] * len(angles)
    return {"joint_names": NAMES, "points": found}


class Bench:
    """A simulated arm, the node, an operator; and strangers when they are asked."""

    def __init__(self, python: str, folder: Path) -> None:
        self.python = python
        self.socket = folder / "api.sock"
        self.log = folder / "node.log"
        self.environment = {
            **os.environ,
            "ROS_DOMAIN_ID": str(1 + os.getpid() % 100),
            "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
            "PYTHONPATH": os.pathsep.join(
                str(CLIENTS / each) for each in ("armui_client", "armui_ros2")
            ),
        }
        self.operator: armui_client.Arm
        self.node: subprocess.Popen[bytes]
        self.ended: list[tuple[float, str]] = []

    @contextmanager
    def running(self, *, grants: bool, **parameters: object) -> Iterator[Bench]:
        sim = [sys.executable, "-m", "armui", "sim", "--api-on", "--socket", str(self.socket)]
        words = [f"{name}:={json.dumps(value)}" for name, value in parameters.items()]
        node = [str(Path(self.python).with_name("armui-ros2")), "--ros-args"]
        for each in (f"socket:={self.socket}", *words):
            node += ["-p", each]
        with ExitStack() as stack:
            simulated = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
            stack.enter_context(
                process(
                    [*sim, *(["--grant"] if grants else [])],
                    env=simulated,
                    cwd=ROOT,
                    stdout=subprocess.DEVNULL,
                )
            )
            log = stack.enter_context(self.log.open("wb"))
            self.operator = stack.enter_context(self._connected())
            self.operator.is_enabled(WITHIN_S)  # the arm tells
            self.node = stack.enter_context(
                process(node, env=self.environment, stdout=log, stderr=log)
            )
            self.ended.clear()
            threading.Thread(target=self._hear, args=(self.operator,), daemon=True).start()
            yield self

    def _connected(self) -> armui_client.Arm:
        until_s = time.monotonic() + WITHIN_S
        while True:
            try:
                return armui_client.connect("the operator", path=self.socket)
            except armui_client.Disconnected:
                if time.monotonic() > until_s:
                    raise
                time.sleep(0.1)

    def _hear(self, operator: armui_client.Arm) -> None:
        try:
            for event in operator.events():
                if event.id == "lease_ended":
                    self.ended.append((time.monotonic(), event.text))
        except armui_client.Disconnected:
            pass

    def ask(self, *words: str) -> dict[str, Any]:
        """What a stranger's node finds."""
        return self.told(self.begin(*words))

    def begin(self, *words: str) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [self.python, str(STRANGER), *words],
            env={**self.environment, "PYTHONPATH": ""},
            stdout=subprocess.PIPE,
            text=True,
        )

    def logged(self, words: str) -> list[str]:
        """What the node has logged."""
        lines = self.log.read_text(encoding="utf-8", errors="replace").splitlines()
        return [line.partition("[armui]: ")[2] for line in lines if words in line]

    def told(self, stranger: subprocess.Popen[str]) -> dict[str, Any]:
        told, _ = stranger.communicate(timeout=WITHIN_S)
        if stranger.returncode:
            print(self.log.read_text(encoding="utf-8", errors="replace"))
            raise SystemExit(f"the stranger failed: {told}")
        return json.loads(told)

    def send(self, *told: dict[str, Any]) -> dict[str, Any]:
        return self.ask("send", json.dumps(told[0] if len(told) == 1 else told))

    def when_at(self, joint_1_deg: float, act: Callable[[], None]) -> float:
        """Do something once joint 1 has passed an angle; returns the angle then."""
        until_s = time.monotonic() + WITHIN_S
        while (angle := self.joint_1()) < joint_1_deg:
            if time.monotonic() > until_s:
                print(self.log.read_text(encoding="utf-8", errors="replace"))
                raise SystemExit("the arm does not move")
        act()
        return angle

    def joint_1(self) -> float:
        return self.operator.state(["joints_deg"]).joints_deg.get(1.0)[0]

    def rest(self) -> float:
        """Where joint 1 comes to rest."""
        before = self.joint_1() - 1.0
        while abs(self.joint_1() - before) > 0.01:
            before = self.joint_1()
            time.sleep(0.3)
        return before


@contextmanager
def process(words: Sequence[str], **more: Any) -> Iterator[subprocess.Popen[bytes]]:
    with subprocess.Popen(words, **more) as begun:
        try:
            yield begun
        finally:
            begun.terminate()
            try:
                begun.wait(10.0)
            except subprocess.TimeoutExpired:
                begun.kill()


def reads(bench: Bench) -> None:
    found = bench.ask("read", "5")
    expect("rate of /joint_states, Hz (50)", found["rate_hz"], holds=found["rate_hz"] > 40.0)
    expect("age when received, ms", found["age_ms"], holds=found["age_ms"]["p50"] < 50.0)
    measured = bench.operator.state().joints_deg.get()
    told = [math.degrees(found["positions"][name]) for name in NAMES]
    apart = max(abs(a - b) for a, b in zip(told, measured, strict=True))
    expect("figures beside armui's, apart by °", round(apart, 3), holds=apart < 0.05)
    fingers = {*found["fingers"]}
    expect("fingers", found["fingers"], holds=fingers == {"joint7", "joint8"})


def refused_without_lease(python: str, folder: Path) -> None:
    """Nobody grants it: the trajectory is refused after 30 s, and the joint states go on."""
    bench = Bench(python, folder)
    with bench.running(grants=False):
        found = bench.send(trajectory((2.0, HOME)))
        reason, text = found["last_trajectory_reason"], found["last_trajectory"]
        expect("without a grant", text, holds=reason == "lease_not_granted")
        rate = found["rate_hz"]
        expect("joint states meanwhile, Hz", rate, holds=rate > 40.0)
    with bench.running(grants=False, trajectories_ask_for_lease=False):
        found = bench.send(trajectory((2.0, HOME)))
        reason, text = found["last_trajectory_reason"], found["last_trajectory"]
        expect("not asked for", text, holds=reason == "lease_not_held")


def refused_with_reasons(bench: Bench) -> None:
    good = trajectory((2.0, HOME))
    other = {**good, "joint_names": [*NAMES[:5], "joint9"]}
    few = {"joint_names": NAMES[:5], "points": [{"time": 2.0, "positions": [0.0] * 5}]}
    nan = trajectory((2.0, (math.nan, *HOME[1:])))
    there = bench.operator.state().joints_deg.get()
    elsewhere = (there[0] + 20.0, *there[1:])
    for what, told, words in (
        ("an unknown joint", other, "joint9"),
        ("a missing joint", few, "joint6"),
        ("no points", trajectory(), "no points"),
        ("no number", nan, "no number"),
        ("times that go back", trajectory((2.0, HOME), (1.0, HOME)), "must increase"),
        ("beyond limits", trajectory((9.0, (170.0, *HOME[1:]))), "limits"),
        ("too fast", trajectory((0.5, FAR)), "may turn at"),
        ("begins elsewhere", trajectory((0.0, elsewhere), (3.0, HOME)), "begins with joint 1"),
    ):
        found = bench.send(told)
        text, code = found["last_trajectory"], int(found["last_trajectory_code"])
        expect(f"refused: {what}", text, holds=words in text and code < 0)


def follows(bench: Bench) -> None:
    enabled = bench.ask("call", "enable")
    expect("enabled", enabled["message"], holds=enabled["success"])
    found = bench.send(trajectory(*UP))
    expect(
        "from its rest pose", found["last_trajectory"], holds=found["last_trajectory_code"] == "0"
    )
    there = (40.0, 60.0, -70.0, 20.0, 0.0, 30.0)
    back = (-10.0, 45.0, -40.0, -20.0, 30.0, -20.0)
    told = trajectory((0.0, HOME), (1.5, there), (3.5, back), (5.0, HOME), smooth=True)
    found = bench.send(told)
    done = found["last_trajectory_code"] == "0"
    expect("followed", found["last_trajectory"], holds=done)
    if not done:
        return
    print("       node:", bench.logged("first target")[-1])
    for name in ("rate_hz", "age_ms", "moved_after_ms", "error_deg", "late_ms", "error_late_deg"):
        print(f"       {name}: {found[name]}")
    expect("error, late, °", found["error_late_deg"], holds=found["error_late_deg"]["rms"] < 2.0)
    rest = bench.operator.state().joints_deg.get()
    apart = max(abs(a - b) for a, b in zip(rest, HOME, strict=True))
    expect("ends at its goal, off by °", round(apart, 3), holds=apart < 1.0)
    other = (-30.0, *HOME[1:])
    found = bench.send(trajectory((4.0, FAR)), trajectory((3.0, other)))
    replaced = bench.logged("Replaced by a newer trajectory")
    expect("replaced by a newer one", replaced, holds=len(replaced) == 1)
    rest_deg = bench.rest()
    expect("which is followed, °", rest_deg, holds=abs(rest_deg - other[0]) < 1.0)


def ended_by_others(bench: Bench) -> None:
    for what, act in (
        ("halted by the service", lambda: bench.ask("call", "halt")),
        ("given back", lambda: bench.ask("call", "lease", "false")),
        ("the operator's halt", bench.operator.halt),
        ("the operator's stop", bench.operator.stop),
    ):
        bench.send(trajectory((2.5, HOME)))
        stranger = bench.begin("send", json.dumps(trajectory((6.0, FAR))))
        began_deg = bench.when_at(10.0, lambda act=act: act() and None)  # type: ignore[misc]
        found = bench.told(stranger)
        rest_deg = bench.rest()
        text, reason = found["last_trajectory"], found["last_trajectory_reason"]
        print(f"       joint 1: asked at {began_deg:.1f}°, at rest at {rest_deg:.1f}°")
        holds = rest_deg < 95.0 and found["last_trajectory_code"] != "0"
        expect(what, f"{text} ({reason})", holds=holds)
        lease = bench.ask("read", "1")["status"]["lease"]
        expect(f"{what}: the lease then", lease, holds=lease == "none")
    found = bench.send(trajectory((2.0, HOME)))
    expect("while stopped", found["last_trajectory"], holds=found["last_trajectory_code"] != "0")


def killed(bench: Bench) -> None:
    bench.ask("call", "enable")
    bench.send(trajectory(*UP))
    # 60 °/s is the most
    stranger = bench.begin("send", json.dumps(trajectory((100.0 / 55.0, FAR))))
    began_deg = bench.when_at(40.0, bench.node.kill)
    killed_s = time.monotonic()
    stranger.kill()
    stranger.wait()
    rest_deg = bench.rest()
    (ended_s, text) = bench.ended[-1]
    travelled = round(rest_deg - began_deg, 2)
    expect("killed at 55 °/s: travels °", travelled, holds=travelled < 40.0)
    expect(f"lease ended after {1e3 * (ended_s - killed_s):.0f} ms", text, holds=bool(text))
    with bench.operator.lease("after it") as lease:
        expect("the arm is free for another", lease.held, holds=lease.held)


def main() -> int:
    words = argparse.ArgumentParser(description=__doc__)
    words.add_argument("--python", required=True, help="the Python that has ROS 2 and armui-ros2")
    python = str(Path(words.parse_args().python).absolute())
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o700)
        refused_without_lease(python, folder)
        bench = Bench(python, folder)
        with bench.running(grants=True):
            reads(bench)
            refused_with_reasons(bench)
            follows(bench)
            ended_by_others(bench)
        with bench.running(grants=True):
            killed(bench)
    print(f"{len(failed)} failed: {', '.join(failed)}" if failed else "all held")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
