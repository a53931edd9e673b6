"""A hand on a jog button, and eyes on the arm: how long it takes to come to rest."""

from __future__ import annotations

import errno
from collections.abc import Callable

import can

from tests.bench import Bench

TICK_S = 0.01
LOOK_S = 0.002
RESTED_DEG_S = 0.01
BENT_DEG = (10.0, 70.0, -60.0, 15.0, 40.0, 20.0)
"""Away from every limit and every singular pose."""


def bend(bench: Bench, angles_deg=BENT_DEG) -> None:
    """Enable the arm and bring it to a comfortable pose."""
    bench.ready()
    bench.controller.motion.set_speed_percent(100)
    assert bench.controller.motion.send_joints(angles_deg) is None
    bench.run_until(lambda: [round(a, 3) for a in bench.firmware.joints_deg] == list(angles_deg))
    bench.run(0.4)


def hold(bench: Bench, seconds: float) -> None:
    """Let time pass as the program's fast timer counts it."""
    for _ in range(round(seconds / TICK_S)):
        bench.step(TICK_S)


def fastest_deg_s(bench: Bench) -> float:
    """How fast the fastest joint turns."""
    return max(map(abs, bench.firmware.body.speeds_deg_s))


def rest_s(bench: Bench) -> float:
    """Let only the arm's time pass until no joint has moved any more; how long that took.

    It is shorter than the half second after which a busy computer's backlog looks like silence.
    """
    last_moved_s = elapsed_s = 0.0
    places = bench.firmware.joints_deg
    while elapsed_s < 0.4:
        bench.time_s += LOOK_S
        elapsed_s += LOOK_S
        bench.node.poll(LOOK_S)
        if fastest_deg_s(bench) > RESTED_DEG_S or bench.firmware.joints_deg != places:
            last_moved_s = elapsed_s
        places = bench.firmware.joints_deg
    return last_moved_s


def release(bench: Bench) -> None:
    bench.controller.jogging.stop()


def hang(bench: Bench) -> None:
    """The program is stuck: nothing calls the controller any more."""


def pull_the_cable(bench: Bench) -> None:
    """Nothing gets through any more, in either direction."""
    bench.node.line.off = True


def unplug(bench: Bench) -> None:
    bench.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))


def end_the_program(bench: Bench) -> None:
    bench.controller.shutdown()


LOSSES: dict[str, Callable[[Bench], None]] = {
    "released": release,
    "hung": hang,
    "cable pulled": pull_the_cable,
    "unplugged": unplug,
    "ended": end_the_program,
}
