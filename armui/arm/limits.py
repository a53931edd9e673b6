"""The limits of each joint, and checks that return the reason against a target.

Arms in use may hold limits other than the factory's in `urdf/<model>/model.json`: the values read
from the arm (0x473, 0x47C) take precedence.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final, NamedTuple

from armui.arm.refusal import Reason, Refusal

JOINT_NOT_A_NUMBER = Reason(
    "joint_not_a_number",
    "Joint {joint}: “{value}” is not an angle. Enter a number of degrees, for example 12.5.",
)
JOINTS_OUTSIDE = Reason(
    "joints_outside",
    "Outside the limits: {joints}. Until all are inside the arm takes only a run, or a target with "
    "all joints inside. Hold Move inside in the line above the panels.",
)
JOINT_OUT_OF_LIMITS = Reason(
    "joint_out_of_limits",
    "Joint {joint}: {value}° is beyond its limits of {minimum}° to {maximum}°. Enter an angle "
    "within them.",
)


JOINTS: Final = range(1, 7)
"""The numbers of the six joints, in rising order."""

ANGLE_STEP_DEG: Final = 0.001
"""The resolution of an angle on the bus."""

SAG_DEG: Final = 0.5
"""A joint measured no further than this beyond a limit sags under load, or trembles."""

_FASTEST_DEG_S: Final = 3600.0
"""A speed far above any joint of this arm, far below 0xFFFF in either generation's unit."""

LIFTED: Final = 4
LIFTED_DEG: Final = 15.0
"""The hand of an arm at rest lies on its base; with the joint at this place turned back to this
angle it is clear."""


class JointLimits(NamedTuple):
    """The limits of one joint.

    Attributes:
        min_deg, max_deg: Range of the joint angle.
        max_speed_deg_s: Highest joint speed.
    """

    min_deg: float
    max_deg: float
    max_speed_deg_s: float


def plausible(limits: JointLimits) -> bool:
    """Return whether limits read from an arm can be true; a corrupted flash answers with 0xFFFF."""
    return limits.min_deg < limits.max_deg and 0 < limits.max_speed_deg_s < _FASTEST_DEG_S


def check_joint(joint: int, angle_deg: float, limits: JointLimits) -> Refusal | None:
    """Return why a joint may not be sent to an angle, or ``None`` if it may."""
    if not math.isfinite(angle_deg):
        return JOINT_NOT_A_NUMBER(joint=joint, value=angle_deg)
    half_step = ANGLE_STEP_DEG / 2
    if not limits.min_deg - half_step <= angle_deg <= limits.max_deg + half_step:
        return JOINT_OUT_OF_LIMITS(
            joint=joint, value=angle_deg, minimum=limits.min_deg, maximum=limits.max_deg
        )
    return None


def check_joints(joints_deg: Sequence[float], limits: Sequence[JointLimits]) -> Refusal | None:
    """Return why the arm may not be sent to six angles, or ``None`` if it may."""
    for joint, angle_deg, limit in zip(JOINTS, joints_deg, limits, strict=True):
        refusal = check_joint(joint, angle_deg, limit)
        if refusal is not None:
            return refusal
    return None


def clipped(angle_deg: float, limits: JointLimits) -> float:
    """Return an angle, or the limit that it is beyond."""
    return min(max(angle_deg, limits.min_deg), limits.max_deg)


def settled(joints_deg: Sequence[float], limits: Sequence[JointLimits]) -> tuple[float, ...]:
    """Return six angles with those that only sag beyond a limit brought to it."""
    return tuple(
        inside if abs((inside := clipped(angle, each)) - angle) <= SAG_DEG else angle
        for angle, each in zip(joints_deg, limits, strict=True)
    )


def outside_limits(joints_deg: Sequence[float], limits: Sequence[JointLimits]) -> tuple[int, ...]:
    """Return the joints (1–6) that stand beyond their limits by more than sag."""
    return tuple(
        joint
        for joint, angle, each in zip(JOINTS, joints_deg, limits, strict=True)
        if abs(clipped(angle, each) - angle) > SAG_DEG
    )


def may_lie(joints_deg: Sequence[float], limits: Sequence[JointLimits]) -> bool:
    """Return whether an arm may lie as when switched on: outside, or with its hand on its base."""
    return bool(outside_limits(joints_deg, limits)) or joints_deg[LIFTED] > LIFTED_DEG


def outside_list(joints_deg: Sequence[float], limits: Sequence[JointLimits]) -> str:
    """Return the joints outside their limits with the limit passed, as ``J2 -2.0° < 0°``."""
    found = []
    for joint in outside_limits(joints_deg, limits):
        angle, limit = joints_deg[joint - 1], clipped(joints_deg[joint - 1], limits[joint - 1])
        found.append(f"J{joint} {angle:.1f}° {'<' if angle < limit else '>'} {limit:g}°")
    return ", ".join(found)
