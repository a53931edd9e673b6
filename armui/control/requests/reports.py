"""The events told when a request has ended, as codes and figures: pure."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from armui.arm.limits import plausible
from armui.arm.state import ArmState
from armui.control.events import EventCode
from armui.control.operating_state import Busy
from armui.control.safety.interlocks import joint_list
from armui.protocol.generation import Generation

Report = tuple[EventCode, Mapping[str, object]]
"""The code of a notice and its figures."""


def numbered(angles_deg: Sequence[float]) -> dict[str, float]:
    """Return six angles as figures of a sentence: ``j1`` … ``j6``."""
    return {f"j{number}": angle for number, angle in enumerate(angles_deg, start=1)}


def on_handshake(state: ArmState, generation: Generation | None) -> Iterator[Report]:
    """Return what an arm has answered to the first questions."""
    yield (
        EventCode.GENERATION,
        {"generation": int(generation or 0), "firmware": state.firmware or ""},
    )
    missing = state.joints_without_limits()
    if missing:
        yield EventCode.LIMITS_MISSING, {"joints": joint_list(missing)}
    else:
        yield EventCode.LIMITS_READ, {}
    for joint, limits in enumerate(state.limits, start=1):
        if limits is not None and not plausible(limits.value):
            yield EventCode.LIMITS_CORRUPT, {"joint": joint}


def on_motors(busy: Busy, state: ArmState, joints: Sequence[int], *, done: bool) -> Report:
    """Return how switching motors, or recovering from a stop, ended."""
    if busy is Busy.RESUMING:
        return (EventCode.RESUMED if done else EventCode.RESUME_FAILED), {}
    wanted = busy is Busy.ENABLING
    if done and len(joints) > 1:
        return (EventCode.ENABLED if wanted else EventCode.DISABLED), {}
    if done:
        code = EventCode.ENABLED_JOINT if wanted else EventCode.DISABLED_JOINT
        return code, {"joint": joints[0]}
    enabled = state.enabled()
    left = [joint for joint in joints if enabled[joint - 1] is not wanted]
    return (EventCode.ENABLE_FAILED if wanted else EventCode.DISABLE_FAILED), {
        "joints": joint_list(left)
    }
