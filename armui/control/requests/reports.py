"""The notices and figures told at the end of a request: pure."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from armui.arm.limits import plausible
from armui.arm.state import ArmState
from armui.control.events import Notice
from armui.control.operating_state import Busy
from armui.control.safety.interlocks import joint_list
from armui.protocol.generation import Generation
from armui.telemetry.events import EventKind, Level

RESUMED = Notice(
    "resumed",
    "The emergency stop is over. Enable the motors to go on.",
    Level.DONE,
    EventKind.RESULT,
)
RESUME_FAILED = Notice(
    "resume_failed",
    "The arm stays in emergency stop. Check it, then hold Release again.",
    Level.FAULT,
    EventKind.RESULT,
)
RESUME_UNHEARD = Notice(
    "resume_unheard",
    "Release was sent, and the arm's status was not heard after it: whether the stop is over is "
    "not known. Look at the line above the panels.",
    Level.WARNING,
    EventKind.RESULT,
)
ENABLED = Notice("enabled", "All six motors are enabled.", Level.DONE, EventKind.RESULT)
ENABLE_FAILED = Notice(
    "enable_failed",
    "These joints did not enable: {joints}. Press Enable again; if that fails, check their "
    "drivers and the arm's power.",
    Level.FAULT,
    EventKind.RESULT,
)
ENABLED_JOINT = Notice("enabled_joint", "Joint {joint} is enabled.", Level.DONE, EventKind.RESULT)
DISABLED_JOINT = Notice(
    "disabled_joint", "Joint {joint} is disabled.", Level.DONE, EventKind.RESULT
)
DISABLED = Notice("disabled", "All six motors are disabled.", Level.DONE, EventKind.RESULT)
DISABLE_FAILED = Notice(
    "disable_failed",
    "These joints did not disable: {joints}. Press Disable again, or use the emergency stop.",
    Level.FAULT,
    EventKind.RESULT,
)
ONLINE = Notice("online", "The arm is online.", Level.DONE, EventKind.LINK)
OFFLINE_NOTICE = Notice(
    "offline",
    "The arm is offline: nothing is heard from it, and it may still be moving. Check its power, "
    "the CAN cable and the bit rate.",
    Level.WARNING,
    EventKind.LINK,
)
GENERATION = Notice(
    "generation",
    "The arm speaks protocol generation {generation}. Firmware: {firmware}",
    Level.INFO,
    EventKind.STATUS,
)
LIMITS_READ = Notice("limits_read", "Joint limits read from the arm", Level.INFO, EventKind.STATUS)
LIMITS_MISSING = Notice(
    "limits_missing",
    "The arm did not tell the limits of these joints: {joints}. The factory limits hold; "
    "connect again to ask once more.",
    Level.WARNING,
    EventKind.STATUS,
)
LIMITS_CORRUPT = Notice(
    "limits_corrupt",
    "Joint {joint}: the limits stored in the arm cannot be true. The factory limits hold; set "
    "the joint's limits anew.",
    Level.WARNING,
    EventKind.STATUS,
)

Report = tuple[Notice, Mapping[str, object]]
"""A notice and its figures."""


def numbered(angles_deg: Sequence[float]) -> dict[str, float]:
    """Return six angles as the figures ``j1`` … ``j6`` of a sentence."""
    return {f"j{number}": angle for number, angle in enumerate(angles_deg, start=1)}


def on_handshake(state: ArmState, generation: Generation | None) -> Iterator[Report]:
    """Yield the reports of an arm's answers to the first questions."""
    yield (
        GENERATION,
        {"generation": int(generation or 0), "firmware": state.firmware or ""},
    )
    missing = state.joints_without_limits()
    if missing:
        yield LIMITS_MISSING, {"joints": joint_list(missing)}
    else:
        yield LIMITS_READ, {}
    for joint, limits in enumerate(state.limits, start=1):
        if limits is not None and not plausible(limits.value):
            yield LIMITS_CORRUPT, {"joint": joint}


def on_motors_done(busy: Busy, joints: Sequence[int]) -> Report:
    """Return the report of motors that were switched, or of a stop that was recovered from."""
    if busy is Busy.RESUMING:
        return RESUMED, {}
    wanted = busy is Busy.ENABLING
    if len(joints) > 1:
        return (ENABLED if wanted else DISABLED), {}
    return (ENABLED_JOINT if wanted else DISABLED_JOINT), {"joint": joints[0]}


def on_motors_failed(busy: Busy, state: ArmState, joints: Sequence[int], now_s: float) -> Report:
    """Return the report of motors that did not switch, or of an arm that stays stopped."""
    if busy is Busy.RESUMING:
        heard = state.status is not None and state.status.fresh(now_s)
        return (RESUME_FAILED if heard else RESUME_UNHEARD), {}
    wanted = busy is Busy.ENABLING
    enabled = state.enabled()
    left = [joint for joint in joints if enabled[joint - 1] is not wanted]
    return (ENABLE_FAILED if wanted else DISABLE_FAILED), {"joints": joint_list(left)}
