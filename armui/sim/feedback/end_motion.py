"""What each joint contributes to the motion of the flange (0x481–0x486).

The protocol names the fields «speed and acceleration of the end, joint 1–6» and says no more. Here
they are the flange's speed and tangential acceleration as the joint alone would cause them: its
turning rate, and that times the distance from its axis to the flange.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import dist, radians
from typing import Final, NamedTuple

from armui.kinematics.arm_kinematics import Kinematics

_NUDGE_DEG: Final = 0.01
_MM_PER_M: Final = 1000.0


class SimulatedEndMotion(NamedTuple):
    """One joint's part in the motion of the flange, all from 0 up."""

    linear_speed_m_s: float
    angular_speed_rad_s: float
    linear_acceleration_m_s2: float
    angular_acceleration_rad_s2: float


def end_motion(
    kinematics: Kinematics,
    joints_deg: Sequence[float],
    index: int,
    speed_deg_s: float,
    acceleration_deg_s2: float,
) -> SimulatedEndMotion:
    """One joint's part in the motion of the flange.

    Args:
        kinematics: Of the arm.
        joints_deg: Where the joints are, joint 1 first.
        index: The joint, 0–5.
        speed_deg_s: How fast it turns.
        acceleration_deg_s2: How its speed changes.
    """
    speed_rad_s = abs(radians(speed_deg_s))
    acceleration_rad_s2 = abs(radians(acceleration_deg_s2))
    if not (speed_rad_s or acceleration_rad_s2):
        return SimulatedEndMotion(0.0, 0.0, 0.0, 0.0)
    lever_m = _lever_m(kinematics, joints_deg, index)
    return SimulatedEndMotion(
        speed_rad_s * lever_m, speed_rad_s, acceleration_rad_s2 * lever_m, acceleration_rad_s2
    )


def _lever_m(kinematics: Kinematics, joints_deg: Sequence[float], index: int) -> float:
    """How far the flange is from a joint's axis, by turning the joint a little both ways."""
    ends = []
    for nudge_deg in (-_NUDGE_DEG, _NUDGE_DEG):
        nudged = list(joints_deg)
        nudged[index] += nudge_deg
        ends.append(kinematics.forward(nudged)[:3])
    return dist(*ends) / (2.0 * radians(_NUDGE_DEG) * _MM_PER_M)
