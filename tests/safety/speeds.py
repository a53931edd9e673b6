"""An arm that stands ready at full speed, and how fast it turns from then on."""

from __future__ import annotations

from collections.abc import Sequence

from tests.accepted import accepted
from tests.arm_rig import STEP_S, ArmRig


def ready_at(rig: ArmRig, joints_deg: Sequence[float]) -> ArmRig:
    """Enable an arm, set 100 % in the top bar, and bring it to these angles."""
    rig.ready()
    rig.controller.motion.set_speed_percent(100)
    accepted(rig.controller.motion.send_joints(joints_deg))
    rig.run(2.5)
    rig.heard()
    return rig


def fastest_deg_s(rig: ArmRig, seconds: float) -> float:
    """The highest speed of joint 1 in that time, measured at the arm."""
    most = 0.0
    for _ in range(round(seconds / STEP_S)):
        rig.step()
        most = max(most, abs(rig.firmware.mechanics.speeds_deg_s[0]))
    return most
