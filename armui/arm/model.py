"""What a plan has to know of the arm it is made for."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from typing import TYPE_CHECKING

from armui.arm.limits import JointLimits

if TYPE_CHECKING:
    from armui.arm.state import EndLimits
    from armui.kinematics.arm_kinematics import Kinematics


@dataclass(frozen=True, slots=True)
class ArmModel:
    """An arm as a plan sees it.

    Attributes:
        limits: Of the six joints, as read from the arm.
        accelerations_deg_s2: The highest of the six joints.
        end_limits: Of the tool; ``None`` while the arm has not told them.
        kinematics: Of its geometry.
        tool_mm: How far the gripper reaches beyond the flange.
        stroke_mm: How far the gripper opens; ``None`` if that is not known.
        gripper_turned_deg: How the gripper is mounted, about the flange's Z axis.
        kind: The model and its zeros; "": nothing is said of trajectories of other arms.
    """

    limits: tuple[JointLimits, ...]
    accelerations_deg_s2: tuple[float, ...]
    end_limits: EndLimits | None
    kinematics: Kinematics
    tool_mm: float
    stroke_mm: float | None = None
    gripper_turned_deg: float = 0.0
    kind: str = ""

    @property
    def fingerprint(self) -> str:
        """A short text that is another for another arm: what was planned for one holds for it."""
        return hashlib.sha256(repr(self).encode()).hexdigest()[:16]
