"""How gravity turns the joints: a plain model of the arm as three bars in a vertical plane.

Only joints 2, 3 and 5 carry weight here. It decides where an arm without power sinks to and how
much current a motor needs to hold its joint; masses are estimates that add up to a moving mass
of about 2.7 kg of the arm's 4.2 kg.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import cos, radians, sin
from typing import Final

from armui.protocol.codes import EndLoad

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
_FLANGE_M: Final = 0.091
"""From the wrist to the flange, where a payload sits."""

PAYLOADS_KG: Final = {EndLoad.EMPTY: 0.0, EndLoad.HALF: 0.75, EndLoad.FULL: 1.5}
"""What the words of 0x477 byte 4 mean; 1.5 kg is the arm's payload, half of it is half."""


@dataclass(slots=True)
class Weight:
    """The loads on the joints: zeros, payload, and pushes from outside.

    Attributes:
        zeros_deg: Where each joint has its zero, counted from the factory's.
        payload_kg: Mass at the flange.
        pushes_nm: What something outside adds to each joint's torque.
    """

    zeros_deg: Sequence[float] = field(default_factory=lambda: (0.0,) * 6)
    payload_kg: float = 0.0
    pushes_nm: tuple[float, ...] = (0.0,) * 6

    def torques_nm(self, joints_deg: Sequence[float]) -> tuple[float, ...]:
        """As `gravity_torques_nm`, for angles counted from the joints' own zeros."""
        true_deg = [angle + zero for angle, zero in zip(joints_deg, self.zeros_deg, strict=True)]
        torques_nm = gravity_torques_nm(true_deg, self.payload_kg)
        if not any(self.pushes_nm):
            return torques_nm
        return tuple(a + b for a, b in zip(torques_nm, self.pushes_nm, strict=True))


def gravity_torques_nm(joints_deg: Sequence[float], payload_kg: float = 0.0) -> tuple[float, ...]:
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
    # from the wrist out, for each metre: seen from the elbow, and from joint 5
    reach = cos(bend) * sin(elbow) + sin(bend) * cos(turn) * cos(elbow)
    reach_turned = sin(bend) * cos(elbow) + cos(bend) * cos(turn) * sin(elbow)
    hand_kg = _HAND_KG + payload_kg
    hand_kg_m = _HAND_KG * _HAND_COM_M + payload_kg * _FLANGE_M

    beyond_elbow_kg_m = (
        _FOREARM_KG * (offset_m + forearm_m / 2)
        + hand_kg * (offset_m + forearm_m)
        + hand_kg_m * reach
    )
    beyond_shoulder_kg_m = (
        _UPPER_ARM_KG * upper_m / 2 + (_FOREARM_KG + hand_kg) * upper_m + beyond_elbow_kg_m
    )
    return (
        0.0,
        _G_M_S2 * beyond_shoulder_kg_m,
        _G_M_S2 * beyond_elbow_kg_m,
        0.0,
        _G_M_S2 * hand_kg_m * reach_turned,
        0.0,
    )
