"""How long it takes to ask a way of the joints for zones and for the arm itself.

Beside it, in the same run, what it took before: capsules and boxes at poses 2 mm apart. Run with
`python -m pytest tests/benchmarks/test_ways_speed.py`; nothing fails for being slow.
"""

from __future__ import annotations

import itertools
import time
from dataclasses import replace

import numpy as np
import pytest

from armui.arm.models import model_data
from armui.cell.work_area import AreaBox
from armui.protocol.generation import PiperModel
from armui.ways.own_body import OwnBody
from tests.cell.areas import check_of
from tests.cell.sampled_ways import HIGH, LOW

MARGIN_MM = 10.0
KINDS = {"anywhere": (10.0, 2000.0), "near": (10.0, 40.0), "grazing": (10.0, 100.0)}
"""Where boxes are, by their gap from the way; what is grazed is kept but for 0.5 mm."""
WAYS = 6
ROUNDS = 20


def turn(random):
    start = random.uniform(LOW, HIGH) * 0.7
    end = start.copy()
    joints = random.choice(6, random.integers(1, 4), replace=False)
    end[joints] += 200.0 * random.choice((-1.0, 1.0), len(joints))
    return np.array((start, end))


def step(random):
    start = random.uniform(LOW, HIGH) * 0.7
    return np.array((start, start + random.choice((-1.0, 1.0), 6)))


def boxes_beside(random, way, count, gaps_mm):
    """Boxes whose least gap from a way is within two figures."""
    found: list[AreaBox] = []
    poses = way[0] + np.linspace(0.0, 1.0, 100)[:, None] * (way[1] - way[0])
    while len(found) < count:
        places = random.uniform((-700.0, -700.0, -100.0), (700.0, 700.0, 900.0), (60, 3))
        turns, sizes = random.uniform(-180, 180, (60, 3)), random.uniform(20, 250, (60, 3))
        some = [
            AreaBox(f"box {number}", (*place, *turned), tuple(size))
            for number, (place, turned, size) in enumerate(zip(places, turns, sizes, strict=True))
        ]
        gaps = check_of(*some).gaps(poses).min(axis=0)
        found += [box for box, gap in zip(some, gaps, strict=True) if gaps_mm[0] < gap < gaps_mm[1]]
    return [replace(box, name=f"box {number}") for number, box in enumerate(found[:count])]


def measured(capsys, title, works, rounds=ROUNDS):
    """Run each some times and print the quantiles of the thread's own time."""
    times = []
    for work, _ in itertools.product(works, range(rounds)):
        begin = time.thread_time()
        work()
        times.append(1e3 * (time.thread_time() - begin))
    middle, last = np.quantile(times, (0.5, 0.99))
    with capsys.disabled():
        print(f"\n{title}: p50 {middle:.2f} ms, p99 {last:.2f} ms", end="")


def in_steps(check, way):
    """As it was done before."""
    return check.gaps(check.finely(way))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("count", [5, 20, 100])
@pytest.mark.parametrize("motion", [turn, step])
def test_a_way_beside_boxes(motion, count, kind, capsys, benchmark):
    random = np.random.default_rng(count)
    cases = []
    for _ in range(WAYS):
        way = motion(random)
        check = check_of(*boxes_beside(random, way, count, KINDS[kind]), margin_mm=MARGIN_MM)
        least = np.full(count, MARGIN_MM)
        if kind == "grazing":
            sampled = way[0] + np.linspace(0.0, 1.0, 1000)[:, None] * (way[1] - way[0])
            least = check.gaps(sampled).min(axis=0) - 0.5
        cases.append((check, way, least))
    title = f"{motion.__name__} beside {count} boxes, {kind}"
    measured(capsys, title, [lambda c=c, w=w, k=k: c.breach(w, k) for c, w, k in cases])
    measured(
        capsys, f"{title}, in steps", [lambda c=c, w=w: in_steps(c, w) for c, w, _ in cases], 1
    )
    benchmark(lambda: [check.breach(way, least) for check, way, least in cases])


@pytest.mark.parametrize("count", [5, 20, 100])
def test_a_look_at_a_new_pose(count, capsys, benchmark):
    random = np.random.default_rng(count)
    check = check_of(*boxes_beside(random, turn(random), count, KINDS["anywhere"]))
    poses = random.uniform(LOW, HIGH, (50, 6))
    looks = [lambda pose=pose: check.nearest_entries(pose) for pose in poses]
    measured(capsys, f"look at {count} boxes", looks)
    benchmark(lambda: [look() for look in looks])


@pytest.mark.parametrize("motion", [turn, step])
def test_the_arm_against_itself(motion, capsys, benchmark):
    random = np.random.default_rng(1)
    data = model_data(PiperModel.PIPER)
    body = OwnBody(data.geometry, data.gripper.reach_mm, data.gripper.turned_deg)
    ways = [motion(random) for _ in range(30)]
    least = np.zeros(len(body.pairs))
    works = [lambda way=way: body.breach(way, least) for way in ways]
    measured(capsys, f"{motion.__name__} against itself", works)

    def degree_by_degree(way):
        poses = way[0] + np.linspace(0.0, 1.0, 201)[:, None] * (way[1] - way[0])
        return body.gaps(poses)

    before = [lambda way=way: degree_by_degree(way) for way in ways]
    measured(capsys, f"{motion.__name__} against itself, at 201 poses", before)
    benchmark(lambda: [work() for work in works])
