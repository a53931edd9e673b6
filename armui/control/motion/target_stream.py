"""The setpoints of a stream of targets: this program plans the path between a client's targets.

A client's targets come at 10 to 100 Hz, and the newest counts. The setpoint follows it as a
critically damped spring would, with the time constant :data:`SETTLING_S`, within the speed and the
acceleration of each joint, and never beyond it: where no new target comes, it comes to rest there.
A setpoint leads the arm by at most ``v·τ + v²/2a``, from which the joint brakes as it goes on.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from armui.arm.limits import check_joints
from armui.arm.refusal import Reason, Refusal
from armui.control.motion.jog_pace import HORIZON_S, Pace
from armui.control.motion.jog_stream import JOG_NOT_FOLLOWING

if TYPE_CHECKING:
    from armui.arm.limits import JointLimits
    from armui.kinematics.arm_kinematics import Kinematics

STREAM_LEAPS = Reason(
    "stream_leaps",
    "To this pose joint {joint} would turn by {value}°, more than {maximum}° at once: the arm "
    "would change its posture. Send poses nearer to one another.",
)

STREAM_DEG_S: Final = 60.0
"""A streamed joint is at most this fast: from it the arm is at rest within 0.26 s."""
SETTLING_S: Final = 0.04
"""The time constant of the smoothing: a setpoint follows an even motion by twice this time."""
REST_S: Final = 0.15
"""Without a new target for this time the setpoint rests where it is."""

LEAP_DEG: Final = 30.0
"""A pose to which a joint turns further from the setpoint is refused: at 10 targets a second and
the highest speed it is 6° to the next one, and the setpoint is behind by as much again."""

_LEAST_SHARE: Final = 0.1
"""The smallest share of the lead, whatever the speed: it must span some steps of the protocol."""
_BRAKES_BY: Final = 0.9
"""The share of the acceleration with which a setpoint brakes before its target."""
_STALLED_S: Final = 0.5
"""An arm that has not followed for this time ends the stream."""
_NEAR_DEG: Final = 0.02

WhyBarred = Callable[[Sequence[float], Sequence[float], Sequence[float]], Refusal | None]
"""Returns why the setpoint may not go to the first six angles, from the second, while the arm may
lag behind by the third."""


@dataclass(eq=False, slots=True)
class TargetJog:
    """A stream of targets of the joints; the newest counts.

    Attributes:
        device: The name of the client that streams.
        target_deg: Its newest target, six angles.
        age_s: The time since that came, as far as the stream has gone on.
        refusal: Why the newest target is not followed, or ``None``.
    """

    device: str
    target_deg: tuple[float, ...]
    age_s: float = 0.0
    refusal: Refusal | None = None
    frame: None = field(default=None, init=False)

    def take(self, target_deg: Sequence[float]) -> None:
        """Follow another target from now on."""
        self.target_deg, self.age_s, self.refusal = tuple(target_deg), 0.0, None

    def rest(self) -> None:
        """Come to rest until another target comes: the newest one was refused."""
        self.age_s = REST_S


def angles_of_pose(
    kinematics: Kinematics,
    flange_pose_mm_deg: Sequence[float],
    near_deg: Sequence[float],
    limits: Sequence[JointLimits],
) -> tuple[float, ...] | Refusal:
    """Return the angles of a target that is a pose, or why it cannot be followed.

    Args:
        kinematics: The arm's kinematics.
        flange_pose_mm_deg: The pose of the flange in the base.
        near_deg: The newest setpoint.
        limits: The limits of the six joints.
    """
    from armui.arm.reach import check_pose  # noqa: PLC0415 - numpy
    from armui.kinematics.poses import Pose  # noqa: PLC0415 - numpy

    found = check_pose(kinematics, Pose(*flange_pose_mm_deg), near_deg, limits)
    if isinstance(found, Refusal):
        return found
    turns_deg = [abs(there - here) for there, here in zip(found, near_deg, strict=True)]
    most_deg = max(turns_deg)
    if most_deg > LEAP_DEG:
        joint = turns_deg.index(most_deg) + 1
        return STREAM_LEAPS(joint=joint, value=round(most_deg, 1), maximum=LEAP_DEG)
    return tuple(found)


def stream_pace(
    percent: float, limits: Sequence[JointLimits], accelerations_deg_s2: Sequence[float]
) -> Pace:
    """Return the limits of a stream at a speed percentage of each joint's highest speed.

    Args:
        percent: 0–100.
        limits: The limits of the six joints.
        accelerations_deg_s2: The highest acceleration of each; see
            :func:`armui.control.motion.jog_pace.accelerations`.
    """
    share = percent / 100.0
    tops_deg_s = [min(share * each.max_speed_deg_s, STREAM_DEG_S) for each in limits]
    least_deg_s = [_LEAST_SHARE * min(each.max_speed_deg_s, STREAM_DEG_S) for each in limits]
    led_by_deg_s = [max(pair) for pair in zip(tops_deg_s, least_deg_s, strict=True)]
    leads = zip(led_by_deg_s, accelerations_deg_s2, strict=True)
    shares = (
        100.0 * speed / each.max_speed_deg_s
        for speed, each in zip(led_by_deg_s, limits, strict=True)
    )
    return Pace(
        share=share,
        speeds_deg_s=tuple(tops_deg_s),
        leads_deg=tuple(speed * HORIZON_S + speed**2 / (2.0 * most) for speed, most in leads),
        arm_percent=min(100, math.ceil(max(shares))),
    )


class TargetStream:
    """Follows the newest target at the pace of the measured arm; pure, with no clock of its own.

    Args:
        jog: Holds the newest target.
        base_deg: The six angles at which the stream begins.
        measured_deg: Where the joints are then; the difference is their sag, and no lead.
        accelerations_deg_s2: The highest acceleration of each joint.
        limits: The limits of the six joints.
        why_barred: Checks each setpoint.

    Attributes:
        setpoint_deg: The six angles to send the arm to now.
    """

    def __init__(
        self,
        jog: TargetJog,
        base_deg: Sequence[float],
        measured_deg: Sequence[float],
        *,
        accelerations_deg_s2: Sequence[float],
        limits: Sequence[JointLimits],
        why_barred: WhyBarred,
    ) -> None:
        self._jog = jog
        self._limits = tuple(limits)
        self._why_barred = why_barred
        self._most_deg_s2 = tuple(accelerations_deg_s2)
        self._sag_deg = tuple(a - b for a, b in zip(base_deg, measured_deg, strict=True))
        self._speeds_deg_s = (0.0,) * len(self._sag_deg)
        self._stalled_s = 0.0
        self.setpoint_deg = tuple(base_deg)

    def advance_setpoint(
        self, measured_deg: Sequence[float], dt_s: float, pace: Pace
    ) -> Refusal | None:
        """Advance the setpoint for the time gone by, as far as the arm has followed.

        Args:
            measured_deg: The measured angles of the joints.
            dt_s: The time since the last call.
            pace: The present limits; see :func:`stream_pace`.

        Returns:
            ``None``, or why the stream ends. Why a target is not followed is noted in the jog, and
            the next one is followed again.
        """
        jog = self._jog
        jog.refusal = jog.refusal or check_joints(jog.target_deg, self._limits)
        jog.age_s += dt_s
        rests = jog.age_s >= REST_S or jog.refusal is not None
        goal_deg = self.setpoint_deg if rests else jog.target_deg
        ahead_deg, speeds_deg_s = self._step(goal_deg, dt_s, pace, rests=rests)
        if ahead_deg == self.setpoint_deg:
            return None  # the setpoint rests
        lag_deg = [
            ahead - sag - measured
            for ahead, sag, measured in zip(ahead_deg, self._sag_deg, measured_deg, strict=True)
        ]
        led_too_far = any(
            abs(lag) > lead and lag * (ahead - now) > 0.0
            for lag, lead, ahead, now in zip(
                lag_deg, pace.leads_deg, ahead_deg, self.setpoint_deg, strict=True
            )
        )
        barred = self._why_barred(ahead_deg, self.setpoint_deg, lag_deg)
        if led_too_far or barred is not None:
            # the setpoint waits: the arm comes nearer, and needs less room then
            self._speeds_deg_s = (0.0,) * len(ahead_deg)
            self._stalled_s += dt_s
            if barred is not None and max(map(abs, lag_deg)) < _near(pace):
                jog.refusal = barred
                self._stalled_s = 0.0
            return JOG_NOT_FOLLOWING() if self._stalled_s >= _STALLED_S else None
        self._stalled_s = 0.0
        self.setpoint_deg, self._speeds_deg_s = ahead_deg, speeds_deg_s
        return None

    def _step(
        self, goal_deg: Sequence[float], dt_s: float, pace: Pace, *, rests: bool
    ) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Return the next setpoint and its speeds; with `rests` it brakes as hard as it may."""
        places, speeds = [], []
        for now, goal, speed, top, most in zip(
            self.setpoint_deg,
            goal_deg,
            self._speeds_deg_s,
            pace.speeds_deg_s,
            self._most_deg_s2,
            strict=True,
        ):
            left = goal - now
            wish = -speed / dt_s if rests else left / SETTLING_S**2 - 2.0 * speed / SETTLING_S
            speed += max(-most, min(most, wish)) * dt_s  # noqa: PLW2901 - the speed of this step
            speed = max(-top, min(top, speed))  # noqa: PLW2901
            if not rests and speed * left > 0.0:
                # never faster than it can brake from before the target, nor beyond it
                least = min(math.sqrt(2.0 * _BRAKES_BY * most * abs(left)), abs(left) / dt_s)
                speed = math.copysign(min(abs(speed), least), speed)  # noqa: PLW2901
            places.append(now + speed * dt_s)
            speeds.append(speed)
        return tuple(places), tuple(speeds)


def _near(pace: Pace) -> float:
    """Return a lag near zero, with which only the setpoint's own way can bar it."""
    return max(_NEAR_DEG, _LEAST_SHARE * max(pace.leads_deg))
