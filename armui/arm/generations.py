"""What of a state means the same in both generations of the protocol: pure.

The frames of both share identifiers and lengths. Before it is known which one an arm speaks, what
the other would read differently is not known at all.
"""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Final

from armui.arm.state import ArmState

_DIFFERENT: Final = frozenset(
    {
        "gripper",
        "drivers_fast",
        "drivers_slow",
        "limits",
        "accelerations_deg_s2",
        "end_limits",
        "collision_levels",
        "teaching_handle",
        "end_motion",
    }
)
"""Other units, other bits, or frames that only one generation has."""

_NOTHING_HEARD: Final = ArmState()
_UNKNOWN: Final = {
    field.name: getattr(_NOTHING_HEARD, field.name)
    for field in fields(ArmState)
    if field.name in _DIFFERENT
}


def common_to_generations(state: ArmState) -> ArmState:
    """The same state without what only one of the generations can explain.

    Angles, the pose, the modes of 0x2A1 and what proves that the arm is there stay.
    """
    status = state.status
    if status is not None:
        neutral = replace(
            status.value, speed_percent=None, trajectory_point=None, limit_exceeded=(False,) * 6
        )
        status = replace(status, value=neutral)
    return replace(state, status=status, **_UNKNOWN)
