"""The keys of observations and actions, and where their values come from: no LeRobot is needed."""

from collections.abc import Mapping
from typing import Any

from armui_client import Arm

JOINTS = tuple(f"joint_{number}.pos" for number in range(1, 7))
"""The measured or wanted angles of the six joints in degrees."""
GRIPPER = "gripper.pos"
"""The opening of the gripper in mm."""
MAX_AGE_S = 0.25
"""The highest age of a measured value that is passed on."""


def keys_of(*, gripper: bool) -> tuple[str, ...]:
    """Return the keys of an arm with or without a gripper, in their order."""
    return (*JOINTS, GRIPPER) if gripper else JOINTS


def measured(arm: Arm, *, gripper: bool) -> dict[str, float]:
    """Return the measured values by their keys.

    Raises:
        armui_client.Stale: One is older than :data:`MAX_AGE_S`, or was never told.
    """
    state = arm.state(["joints_deg", "gripper_mm"])
    values = dict(zip(JOINTS, state.joints_deg.get(MAX_AGE_S), strict=True))
    return {**values, GRIPPER: state.gripper_mm.get(MAX_AGE_S)} if gripper else values


def wanted(action: Mapping[str, Any], *, gripper: bool) -> tuple[list[float], float | None]:
    """Return the six angles of an action, and the opening if there is a gripper.

    Raises:
        ValueError: A key is missing; the text names those that are wanted.
    """
    keys = keys_of(gripper=gripper)
    if missing := [key for key in keys if key not in action]:
        text = f"The action lacks {', '.join(missing)}. Wanted: {', '.join(keys)} (degrees, mm)."
        raise ValueError(text)
    return [float(action[key]) for key in JOINTS], float(action[GRIPPER]) if gripper else None
