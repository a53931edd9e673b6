"""What MIT costs the simulated arm: the same arm at the same rate, with and without it.

Each run is told something at 200 Hz, as hosts do, and steps 5 ms a time as the node does. Processor
time is measured, so that a busy computer counts little; what is said is the share of a core that it
takes in real time.

    python -m pytest tests/benchmarks/test_mit_cost.py -s
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable

import pytest

from armui.sim.arm_loop import PERIOD_S
from armui.sim.firmware import Firmware
from tests.sim.talk import frame, mode, ready, target
from tests.sim.test_direct_control import MIT, hold

TICKS = 200
"""One swing, measured as a whole; the least of several is taken, as the others were disturbed."""
SWINGS = 8
MORE_OF_A_CORE = 0.10
POSE = (0.0, 70.0, -70.0, 0.0, 10.0, 0.0)


def swing(tick: int) -> tuple[float, ...]:
    """All joints swing by 10° at 1 Hz."""
    shift = 10.0 * math.sin(2.0 * math.pi * tick * PERIOD_S)
    return tuple(angle + shift for angle in POSE)


def share_of_a_core(first: str, said: Callable[[tuple[float, ...]], Iterable[str]]) -> float:
    """What an arm takes that hears this at 200 Hz, in real time."""
    arm: Firmware = ready(joints_deg=POSE)
    arm.on_frame(frame(first))
    told = [[frame(line) for line in said(swing(tick))] for tick in range(TICKS)]
    used_s = []
    for _ in range(SWINGS):
        began_s = time.process_time()
        for frames in told:
            for each in frames:
                arm.on_frame(each)
            arm.step(PERIOD_S)
        used_s.append(time.process_time() - began_s)
    assert max(map(abs, arm.mechanics.speeds_deg_s)) > 1.0
    return min(used_s) / (TICKS * PERIOD_S)


@pytest.mark.parametrize(
    ("what", "gains"),
    [
        ("kp 10, kd 0.8", {}),
        ("kp 100, kd 2", {"kp": 0x333, "kd": 0xB33}),
        ("kp 500, kd 5", {"kp": 0xFFF, "kd": 0xFFF}),
    ],
)
def test_mit_at_200_hz_takes_a_tenth_of_a_core_more(what: str, gains: dict[str, int]) -> None:
    planned = share_of_a_core(mode(100), lambda pose: target(*pose))
    in_mit = share_of_a_core(MIT, lambda pose: hold(pose, **gains))
    print(
        f"\n{what}: {100 * in_mit:.1f} % of a core in MIT, {100 * planned:.1f} % with MOVE J "
        f"streamed; {100 * (in_mit - planned):+.1f} %"
    )
    assert in_mit - planned < MORE_OF_A_CORE
