"""An arm as it is heard, and what the operator can do with it then."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any, TypeVar

from armui.arm.device import Device
from armui.arm.state import ArmState, Reading, Six, Status
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState

T = TypeVar("T")

NOW_S = 100.0
SIX_FALSE = (False,) * 6


def status(**changes: Any) -> Status:
    """An arm under CAN control that has nothing to complain of."""
    normal = Status(
        control_mode=1,
        arm_status=0,
        move_mode=1,
        teaching=0,
        reached=True,
        speed_percent=30,
        trajectory_point=None,
        limit_exceeded=SIX_FALSE,
        communication_fault=SIX_FALSE,
    )
    return normal._replace(**changes)


def heard_six(values: Iterable[T], at_s: float = NOW_S) -> Six[Reading[T] | None]:
    """One value for each joint, heard at one time."""
    one, two, three, four, five, six = (Reading(value, at_s) for value in values)
    return one, two, three, four, five, six


def arm_state(
    angles_deg: Sequence[float] = (0.0,) * 6,
    at_s: float = NOW_S,
    sequence: int = 1,
    **status_changes: Any,
) -> ArmState:
    """An arm heard completely and just now."""
    pose = (56.128, 0.0, 213.266, 0.0, 85.0, 0.0)
    return ArmState(
        sequence=sequence,
        last_feedback_s=at_s,
        status=Reading(status(**status_changes), at_s),
        joints_deg=heard_six(angles_deg, at_s),
        pose=heard_six(pose, at_s),
    )


def operating_state(**changes: Any) -> OperatingState:
    """Online, enabled, free to move."""
    ready = OperatingState(
        link=LinkState.ONLINE,
        device=Device("virtual", "test", label="Simulated arm", simulated=True, generation=1),
        enabled=(True,) * 6,
        cannot_move=None,
        cannot_enable=None,
        limits_read=(True,) * 6,
        speed_percent=30,
    )
    return replace(ready, **changes)
