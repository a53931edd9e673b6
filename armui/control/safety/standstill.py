"""Decides whether the joints stand still, by the reported angles or the drivers' speeds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from armui.arm.limits import JOINTS
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState, is_fresh
from armui.control.safety.interlocks import joint_list

JOINTS_MOVING = Reason(
    "joints_moving", "These joints are moving: {joints}. Wait until the arm stands still."
)
STILL_MOVING = Reason(
    "still_moving", "The arm is still moving. Wait until it stands still, then press again."
)
SPEED_UNKNOWN = Reason(
    "speed_unknown",
    "Whether these joints stand still is not known: {joints}. Their drivers report no speed: "
    "check the arm's power and the CAN cable.",
)


SETTLED_DEG: Final = 0.02
SETTLED_S: Final = 0.3
"""An arm whose joints have moved by at most ``SETTLED_DEG`` in this time is at rest."""

QUIET_DEG: Final = 0.03
QUIET_S: Final = 0.03
"""Together 1 °/s: above the last digit's trembling, far below any motion that matters."""

STILL_DEG_S: Final = 1.0
"""Slower than this a joint stands still: drivers report a little noise at rest."""


@dataclass(slots=True)
class _Standing:
    """The angles at which the joints stand, and whether that has lasted long enough."""

    angles_deg: Sequence[float]
    since_s: float
    rests: bool = False


class RestWatch:
    """Compares the measured angles over time.

    Joints come to rest only in angles that arrive in time: what they did in a gap is not known.
    Those that are found where they rested before the gap still rest.

    Args:
        within_deg: The most that a joint may move and still count as standing.
        for_s: The time for which it must do so.
    """

    def __init__(self, within_deg: float = SETTLED_DEG, for_s: float = SETTLED_S) -> None:
        self._within_deg = within_deg
        self._for_s = for_s
        self._standing: _Standing | None = None

    def observe(self, state: ArmState, now_s: float) -> None:
        """Take in the measured angles; angles that are not fresh are ignored."""
        angles_deg = state.angles_deg()
        # the oldest of the six angles dates the measurement
        measured_s = min((each.at_s for each in state.joints_deg if each is not None), default=None)
        if angles_deg is None or measured_s is None or not is_fresh(measured_s, now_s):
            self.reset()
            return
        standing = self._standing
        if standing is None or _apart(angles_deg, standing.angles_deg, self._within_deg):
            standing = self._standing = _Standing(angles_deg, measured_s)
        standing.rests |= state.in_time_for_s(now_s, standing.since_s) >= self._for_s

    @property
    def at_rest(self) -> bool:
        """True if no joint has moved recently."""
        return self._standing is not None and self._standing.rests

    def reset(self) -> None:
        """Forget the measured angles."""
        self._standing = None


def _apart(angles_deg: Sequence[float], others_deg: Sequence[float], within_deg: float) -> bool:
    return any(abs(a - b) > within_deg for a, b in zip(angles_deg, others_deg, strict=True))


def why_moving(state: ArmState) -> Refusal | None:
    """Return the joints measured to move, as a reason, or ``None``; silent ones are ignored."""
    moving = [
        joint
        for joint, speed in zip(JOINTS, _speeds_deg_s(state), strict=True)
        if speed is not None and abs(speed) >= STILL_DEG_S
    ]
    return JOINTS_MOVING(joints=joint_list(moving)) if moving else None


def why_not_still(state: ArmState) -> Refusal | None:
    """Return the same reason; the speed of each joint must also be known."""
    speeds = zip(JOINTS, _speeds_deg_s(state), strict=True)
    unknown = [joint for joint, speed in speeds if speed is None]
    if unknown:
        return SPEED_UNKNOWN(joints=joint_list(unknown))
    return why_moving(state)


def _speeds_deg_s(state: ArmState) -> list[float | None]:
    """Return each joint's speed; ``None``: its driver was not heard beside the feedback."""
    return [
        heard.value.speed_deg_s
        if heard is not None
        and state.last_feedback_s is not None
        and heard.fresh(state.last_feedback_s)
        else None
        for heard in state.drivers_fast
    ]
