"""A hand on a jog button, and eyes on the arm: how long it takes to come to rest."""

from __future__ import annotations

import errno
from collections.abc import Callable

import can

from tests.accepted import accepted
from tests.arm_rig import ArmRig

TICK_S = 0.01
LOOK_S = 0.002
RESTED_DEG_S = 0.01
BENT_DEG = (10.0, 70.0, -60.0, 15.0, 40.0, 20.0)
"""Away from every limit and every singular pose."""
NEAR_DEG = 0.5


def bend(rig: ArmRig, angles_deg=BENT_DEG) -> None:
    """Enable an arm that lies near a comfortable pose, and bring it there."""
    rig.lie([angle - NEAR_DEG for angle in angles_deg])
    rig.ready()
    rig.controller.motion.set_speed_percent(100)
    accepted(rig.controller.motion.send_joints(angles_deg, -1000.0))
    rig.run_until(lambda: [round(a, 3) for a in rig.firmware.joints_deg] == list(angles_deg))
    rig.run(0.4)


def hold(rig: ArmRig, seconds: float) -> None:
    """Let time pass as the program's fast timer counts it."""
    for _ in range(round(seconds / TICK_S)):
        rig.step(TICK_S)


def fastest_deg_s(rig: ArmRig) -> float:
    """How fast the fastest joint turns."""
    return max(map(abs, rig.firmware.mechanics.speeds_deg_s))


def rest_s(rig: ArmRig) -> float:
    """Let only the arm's time pass until no joint has moved any more; how long that took.

    It is shorter than the half second after which a busy computer's backlog looks like silence.
    """
    last_moved_s = elapsed_s = 0.0
    places = rig.firmware.joints_deg
    while elapsed_s < 0.4:
        rig.time_s += LOOK_S
        elapsed_s += LOOK_S
        rig.node.poll(LOOK_S)
        if fastest_deg_s(rig) > RESTED_DEG_S or rig.firmware.joints_deg != places:
            last_moved_s = elapsed_s
        places = rig.firmware.joints_deg
    return last_moved_s


def release(rig: ArmRig) -> None:
    rig.controller.jogging.stop()


def hang(rig: ArmRig) -> None:
    """The program is stuck: nothing calls the controller any more."""


def pull_the_cable(rig: ArmRig) -> None:
    """Nothing gets through any more, in either direction."""
    rig.node.link.off = True


def unplug(rig: ArmRig) -> None:
    rig.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))


def end_the_program(rig: ArmRig) -> None:
    rig.controller.shutdown()


LOSSES: dict[str, Callable[[ArmRig], None]] = {
    "released": release,
    "hung": hang,
    "cable pulled": pull_the_cable,
    "unplugged": unplug,
    "ended": end_the_program,
}
