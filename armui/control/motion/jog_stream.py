"""The setpoints of one jog: each a little further along its path, none far ahead of the arm."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.control.motion.jog_path import JOG_OUT_OF_REACH

if TYPE_CHECKING:
    from armui.control.motion.jog_pace import Pace
    from armui.control.motion.jog_path import JogPath

JOG_NOT_FOLLOWING = Reason(
    "jog_not_following",
    "The arm does not follow. Check that nothing blocks it and what its status says.",
)
JOG_SINGULAR = Reason(
    "jog_singular",
    "The arm is at a singular pose: joint {joint} would have to turn far too fast. Jog "
    "another way, or turn joint 5 away from 0° under Motion control.",
)


_TRIES: Final = 3
"""The most times that a step is shortened until it keeps the limits of speed and lead."""
_LEAST_SHARE: Final = 0.05
"""The pose is singular if a joint would have to turn over twenty times its jog speed."""
_STRETCHES: Final = (2, 3)
"""The joints that stretch the arm."""
_SMALL_DEG: Final = 1e-9
_CLOSE: Final = 1e-9
"""A path is at its end with less than this left, in mm or degrees."""
_STALLED_S: Final = 0.5
"""A jog whose arm has not followed for this time ends."""


class JogStream:
    """Follows a path at the pace of the measured arm; pure, with no clock of its own.

    Args:
        way: The path.
        base_deg: The six angles at which the path begins.
        measured_deg: Where the joints are then. What lies between the two is the joints' sag
            under load, and no lead.
        why_barred: Returns why the setpoint may not go from the second six angles to the first.

    Attributes:
        setpoint_deg: The six angles to send the arm to now.
    """

    def __init__(
        self,
        way: JogPath,
        base_deg: Sequence[float],
        measured_deg: Sequence[float],
        why_barred: Callable[[Sequence[float], Sequence[float]], Refusal | None] = lambda *_: None,
    ) -> None:
        self._why_barred = why_barred
        self.setpoint_deg = tuple(base_deg)
        self._way = way
        self._sag_deg = tuple(a - b for a, b in zip(base_deg, measured_deg, strict=True))
        self._gone = 0.0
        self._stalled_s = 0.0

    def follow_path(self, way: JogPath) -> None:
        """Continue along another path, which begins at the present setpoint."""
        self._way = way
        self._gone = 0.0

    def advance_setpoint(
        self, measured_deg: Sequence[float], dt_s: float, pace: Pace
    ) -> Refusal | None:
        """Advance the setpoint for the time gone by, as far as the arm has followed.

        Args:
            measured_deg: The measured angles of the joints.
            dt_s: The time since the last call.
            pace: The present limits.

        Returns:
            ``None``, or why it goes no further; the setpoint then stays where it may be.
        """
        room = self._way.room() - self._gone
        if room <= _CLOSE:
            return self._way.why_no_further()
        before = self._gone
        way = min(self._way.speed(pace) * dt_s, room)
        reason = self._advance_by(way, measured_deg, dt_s, pace)
        self._stalled_s = 0.0 if self._gone > before else self._stalled_s + dt_s
        if reason is None and self._stalled_s >= _STALLED_S:
            return JOG_NOT_FOLLOWING()
        return reason

    def _advance_by(
        self, way: float, measured_deg: Sequence[float], dt_s: float, pace: Pace
    ) -> Refusal | None:
        for _ in range(_TRIES):
            ahead_deg = self._way.joints_at(self._gone + way, self.setpoint_deg)
            if isinstance(ahead_deg, Refusal):
                return ahead_deg
            joint, share = self._share_by_speed(ahead_deg, dt_s, pace)
            if share < _LEAST_SHARE:
                return _why_too_fast(joint)
            share = min(share, self._share_by_lead(ahead_deg, measured_deg, pace))
            if share >= 1.0:
                barred = self._why_barred(ahead_deg, self.setpoint_deg)
                if barred is not None:
                    return barred
                self._gone += way
                self.setpoint_deg = ahead_deg
                return None
            # On a curved path the joints do not turn in proportion to the distance: a shortened
            # step may still be too long.
            way *= 0.98 * share
            if way <= _CLOSE:
                return None
        return None

    def _share_by_speed(
        self, ahead_deg: Sequence[float], dt_s: float, pace: Pace
    ) -> tuple[int, float]:
        """Return the joint that holds the step up most, and the share it can do in time."""
        worst, least = 1, math.inf
        steps = zip(ahead_deg, self.setpoint_deg, pace.speeds_deg_s, strict=True)
        for joint, (ahead, now, speed) in enumerate(steps, start=1):
            step = abs(ahead - now)
            if step > _SMALL_DEG and (share := speed * dt_s / step) < least:
                worst, least = joint, share
        return worst, least * (1.0 + 1e-6)

    def _share_by_lead(
        self, ahead_deg: Sequence[float], measured_deg: Sequence[float], pace: Pace
    ) -> float:
        """Return the share of the step that leaves every joint within its lead."""
        least = math.inf
        for ahead, now, measured, sag, lead in zip(
            ahead_deg, self.setpoint_deg, measured_deg, self._sag_deg, pace.leads_deg, strict=True
        ):
            step = ahead - now
            if abs(step) > _SMALL_DEG:
                in_front = math.copysign(1.0, step) * (now - sag - measured)
                least = min(least, max(0.0, lead - in_front) / abs(step))
        return least


def _why_too_fast(joint: int) -> Refusal:
    """Return the reason for the operator where a joint would have to turn too fast to follow."""
    if joint in _STRETCHES:
        return JOG_OUT_OF_REACH()
    return JOG_SINGULAR(joint=joint)
