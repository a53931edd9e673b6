"""How gravity turns the joints: a plain model of the arm as three bars in a vertical plane.

Only joints 2, 3 and 5 carry weight here. It decides where an arm without power sinks to and how
much current a motor needs to hold its joint; masses are estimates that add up to a moving mass
of about 2.7 kg of the arm's 4.2 kg.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, radians, sin
from typing import Final

_G_M_S2: Final = 9.81

_UPPER_ARM_M: Final = 0.28503
_ELBOW_OFFSET_M: Final = -0.02198
_FOREARM_M: Final = 0.25075
_HAND_COM_M: Final = 0.06
_SHOULDER_ZERO_DEG: Final = -172.22
_ELBOW_ZERO_DEG: Final = -102.78

_UPPER_ARM_KG: Final = 1.2
_FOREARM_KG: Final = 0.9
_HAND_KG: Final = 0.6


def gravity_torques_nm(joints_deg: Sequence[float]) -> tuple[float, ...]:
    """The torque with which gravity drives each joint, in N·m; positive towards larger angles.

    In the plane of the arm a joint's torque is weight times horizontal lever arm. The angles are
    those of the DH table: the upper arm points along (cos, −sin), the forearm along (sin, cos).
    """
    _, q2, q3, q4, q5, _ = joints_deg
    shoulder = radians(q2 + _SHOULDER_ZERO_DEG)
    elbow = shoulder + radians(q3 + _ELBOW_ZERO_DEG)
    turn, bend = radians(q4), radians(q5)

    upper_m = _UPPER_ARM_M * cos(shoulder)
    offset_m = _ELBOW_OFFSET_M * cos(elbow)
    forearm_m = _FOREARM_M * sin(elbow)
    hand_m = _HAND_COM_M * (cos(bend) * sin(elbow) + sin(bend) * cos(turn) * cos(elbow))
    hand_lever_m = _HAND_COM_M * (sin(bend) * cos(elbow) + cos(bend) * cos(turn) * sin(elbow))

    beyond_elbow_kg_m = _FOREARM_KG * (offset_m + forearm_m / 2) + _HAND_KG * (
        offset_m + forearm_m + hand_m
    )
    beyond_shoulder_kg_m = (
        _UPPER_ARM_KG * upper_m / 2 + (_FOREARM_KG + _HAND_KG) * upper_m + beyond_elbow_kg_m
    )
    return (
        0.0,
        _G_M_S2 * beyond_shoulder_kg_m,
        _G_M_S2 * beyond_elbow_kg_m,
        0.0,
        _G_M_S2 * _HAND_KG * hand_lever_m,
        0.0,
    )
