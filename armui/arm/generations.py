"""What of a state means the same in both generations of the protocol: pure.

The frames of both share identifiers and lengths. Before it is known which one an arm speaks, what
the other would read differently is not known at all.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from armui.arm.state import ArmState

_ALIKE: Final = frozenset(
    {
        "epoch",
        "sequence",
        "last_feedback_s",
        "silences",
        "pauses",
        "status",
        "joints_deg",
        "pose",
        "firmware",
        "identity",
        "version_heard_s",
        "versions_named",
        "status_heard_s",
        "foreign_targets_s",
        "frames",
        "oddities",
    }
)
"""All else has other units, other bits, or frames that only one generation has."""

_NOTHING_HEARD: Final = ArmState()
_UNKNOWN: Final = {
    name: value for name, value in _NOTHING_HEARD._asdict().items() if name not in _ALIKE
}


def common_to_generations(state: ArmState) -> ArmState:
    """The same state without what only one of the generations can explain.

    Angles, the pose, the modes of 0x2A1 and what proves that the arm is there stay.
    """
    status = state.status
    if status is not None:
        neutral = status.value._replace(
            speed_percent=None, trajectory_point=None, limit_exceeded=(False,) * 6
        )
        status = replace(status, value=neutral)
    return state._replace(status=status, **_UNKNOWN)
