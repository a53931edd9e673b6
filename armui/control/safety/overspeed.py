"""Watches whether a motion of ours is measured to be faster than shown: pure."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JointLimits, plausible
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.kinematics.poses import apart

if TYPE_CHECKING:
    from armui.arm.models import ArmModel
    from armui.kinematics.arm_kinematics import Kinematics

TOO_FAST = Reason(
    "too_fast",
    "Look for the reason, and begin the next one slowly. Joint {joint} moves at {value}°/s. "
    "{percent} % was told, that is {maximum}°/s at most; above {limit}°/s a motion is ended.",
)
TOOL_TOO_FAST = Reason(
    "tool_too_fast",
    "Look for the reason, and begin the next one slowly. The tool moves at {value} mm/s. "
    "{percent} % was told, that is {maximum} mm/s at most on this path; above {limit} mm/s a "
    "motion is ended.",
)
TOOL_TURNS_TOO_FAST = Reason(
    "tool_turns_too_fast",
    "Look for the reason, and begin the next one slowly. The tool turns at {value}°/s. "
    "{percent} % was told, that is {maximum}°/s at most on this path; above {limit}°/s a motion "
    "is ended.",
)


_TOO_FAST: Final = 1.5
"""A measured speed above this multiple of the shown speed ends the motion (S12)."""
_SLACK_DEG_S: Final = 2.0
"""The speed that the last digit's noise and the bus's jitter can feign."""
_SLACK_MM_S: Final = 3.0
_TOOL_SLACK_DEG_S: Final = 2.0
"""The same for the flange, at the end of the arm."""
_UNKNOWN_RAMP_S: Final = 1.0
"""The braking time assumed for a tool whose pace on its path is not known."""
_TAKEN_UP_S: Final = 0.2
"""A new percentage shows in the measured speed after this time."""
_FOR_S: Final = 0.1
"""The time that speeds are measured over (S12)."""
_HALF_S: Final = 0.05
_BRAKING: Final = 0.95
"""A joint whose speed falls to this share within 0.05 s is braking to its new speed."""


@dataclass(frozen=True, slots=True)
class ToolPace:
    """The greatest speed of the flange along a line or an arc at 100 %.

    Attributes:
        kinematics: The kinematics of the measured arm.
        linear_mm_s: The speed of its position.
        angular_deg_s: The speed of its turning.
        ramp_s: The braking time from this speed to rest.
    """

    kinematics: Kinematics
    linear_mm_s: float
    angular_deg_s: float
    ramp_s: float

    def slowed_within_s(self, percent: float) -> float:
        """Return the longest time in which the tool slows down by a percentage."""
        return self.ramp_s * percent / 100.0 + _TAKEN_UP_S


@dataclass(frozen=True, slots=True)
class _Sample:
    at_s: float
    joints_deg: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class _SpeedChange:
    """The speeds of the joints at a change of the speed that was set.

    Attributes:
        at_s: The time of the change.
        measured_deg_s: The speed of each joint then.
        allowed_deg_s: The highest speed each was allowed until then.
    """

    at_s: float
    measured_deg_s: Sequence[float]
    allowed_deg_s: Sequence[float]

    def allowed_now_deg_s(
        self, at_s: float, accelerations_deg_s2: Sequence[float]
    ) -> tuple[float, ...]:
        """Return how fast each joint may still be: it speeds up until the change is taken up.

        From then on it slows down by its acceleration; what is measured lags behind by half of
        the time it is measured over.
        """
        since_s = at_s - self.at_s
        faster_s = _FOR_S / 2 + min(since_s, _TAKEN_UP_S)
        slower_s = max(0.0, since_s - _TAKEN_UP_S)
        return tuple(
            min(allowed, measured + acceleration * faster_s) - acceleration * slower_s
            for measured, allowed, acceleration in zip(
                self.measured_deg_s, self.allowed_deg_s, accelerations_deg_s2, strict=True
            )
        )


class OverspeedWatch:
    """Measures the speeds of joints and tool over the last tenth of a second."""

    def __init__(self) -> None:
        self._samples: deque[_Sample] = deque()
        self._change: _SpeedChange | None = None
        self._allowed_deg_s: Sequence[float] = ()

    def change_speed(self) -> None:
        """Note that another speed is shown from now on.

        Joints that turn go over to it from the speed they are measured at, by their acceleration:
        a joint of 30 °/s² takes more than five seconds from its highest speed to rest.
        """
        samples = self._samples
        if len(samples) > 1 and samples[-1].at_s - samples[0].at_s >= _HALF_S:
            measured_deg_s = _speeds_deg_s(samples[0], samples[-1])
            self._change = _SpeedChange(samples[-1].at_s, measured_deg_s, self._allowed_deg_s)
        samples.clear()

    def observe(
        self,
        state: ArmState,
        percent: int | None,
        factory: Sequence[JointLimits],
        accelerations_deg_s2: Sequence[float],
        pace: ToolPace | None = None,
    ) -> Refusal | None:
        """Compare the measured speeds with the one shown.

        Args:
            state: The arm as heard.
            percent: The speed shown for the motion under way, of its highest; ``None``: there is
                nothing to compare with.
            factory: The factory limits of the model, for unread ones.
            accelerations_deg_s2: The accelerations with which the six joints slow down.
            pace: The tool's speed at 100 %, for a line or an arc.

        Returns:
            The joint that is too fast, or the tool, as a reason, or ``None``.
        """
        angles_deg, last = state.angles_deg(), state.joints_deg[-1]
        if percent is None or angles_deg is None or last is None:
            self._samples.clear()
            self._change = None
            return None
        shown_deg_s = _shown_deg_s(state, percent, factory)
        allowed_deg_s = tuple(_TOO_FAST * shown for shown in shown_deg_s)
        if self._change is not None:
            still_deg_s = self._change.allowed_now_deg_s(last.at_s, accelerations_deg_s2)
            allowed_deg_s = tuple(map(max, allowed_deg_s, still_deg_s))
        self._allowed_deg_s = allowed_deg_s
        samples = self._samples
        if not samples or last.at_s > samples[-1].at_s:
            samples.append(_Sample(last.at_s, angles_deg))
        # No speed can be computed across a gap, or from reports that were held up and came in a
        # burst.
        while samples and samples[0].at_s < state.in_time_since_s:
            samples.popleft()
        if not samples:
            return None
        while len(samples) > 2 and samples[1].at_s <= last.at_s - _FOR_S:
            samples.popleft()
        first, newest = samples[0], samples[-1]
        if newest.at_s - first.at_s < _FOR_S:
            return None
        middle = next(each for each in samples if each.at_s >= newest.at_s - _HALF_S)
        window = _Window(first, middle, newest)
        refusal = _joint_too_fast(window, percent, shown_deg_s, allowed_deg_s)
        if refusal is None and pace is not None:
            refusal = _tool_too_fast(window, percent, pace)
        return refusal


@dataclass(frozen=True, slots=True)
class _Window:
    """Three measurements: a tenth of a second ago, half of that ago, and the last one."""

    first: _Sample
    middle: _Sample
    newest: _Sample


def tool_pace(
    way: Sequence[Sequence[float]], start_deg: Sequence[float] | None, arm: ArmModel
) -> ToolPace:
    """Return the speed of the arm's flange along a line or an arc at 100 %.

    Args:
        way: Poses of the flange: the end of a line, or start, middle and end of an arc.
        start_deg: The angles of the joints at rest; ``None`` if they move, so that the beginning of
            the path is unknown. Then only the limits of the tool give its pace; before they are
            heard only the joints can be compared.
        arm: The arm.
    """
    limits = arm.end_limits
    most = ToolPace(arm.kinematics, math.inf, math.inf, _UNKNOWN_RAMP_S)
    if limits is not None:
        angular_deg_s = math.degrees(limits.max_angular_speed_rad_s)
        linear_mm_s = 1e3 * limits.max_linear_speed_m_s
        most = replace(most, linear_mm_s=linear_mm_s, angular_deg_s=angular_deg_s)
    if start_deg is None:
        return most
    from armui.trajectory.planning.planning import single_pace  # noqa: PLC0415 - numpy, scipy

    planned = single_pace(way, start_deg, arm)
    return most if planned is None else ToolPace(arm.kinematics, *planned)


def _shown_deg_s(
    state: ArmState, percent: int, factory: Sequence[JointLimits]
) -> tuple[float, ...]:
    """Return the speed of each joint, in °/s, that the shown percentage allows."""
    highest = (
        limits.value if limits is not None and plausible(limits.value) else stands_in
        for limits, stands_in in zip(state.limits, factory, strict=True)
    )
    return tuple(each.max_speed_deg_s * percent / 100.0 for each in highest)


def _joint_too_fast(
    window: _Window, percent: int, shown_deg_s: Sequence[float], allowed_deg_s: Sequence[float]
) -> Refusal | None:
    speeds = _speeds_deg_s(window.first, window.newest)
    before = _speeds_deg_s(window.first, window.middle)
    after = _speeds_deg_s(window.middle, window.newest)
    for index, (shown, allowed) in enumerate(zip(shown_deg_s, allowed_deg_s, strict=True)):
        limit = allowed + _SLACK_DEG_S
        if speeds[index] > limit and after[index] >= _BRAKING * before[index]:
            figures = _figures(percent, speeds[index], shown, limit)
            return TOO_FAST(joint=index + 1, **figures)
    return None


def _tool_too_fast(window: _Window, percent: int, pace: ToolPace) -> Refusal | None:
    speeds = _tool_speeds(window.first, window.newest, pace)
    before = _tool_speeds(window.first, window.middle, pace)
    after = _tool_speeds(window.middle, window.newest, pace)
    for index, (code, highest, slack) in enumerate(
        (
            (TOOL_TOO_FAST, pace.linear_mm_s, _SLACK_MM_S),
            (TOOL_TURNS_TOO_FAST, pace.angular_deg_s, _TOOL_SLACK_DEG_S),
        )
    ):
        shown = percent / 100.0 * highest
        limit = _TOO_FAST * shown + slack
        if speeds[index] > limit and after[index] >= _BRAKING * before[index]:
            return Refusal(code, _figures(percent, speeds[index], shown, limit))
    return None


def _figures(percent: int, value: float, maximum: float, limit: float) -> dict[str, float]:
    figures = {"value": value, "maximum": maximum, "limit": limit}
    return {"percent": percent} | {name: round(each, 1) for name, each in figures.items()}


def _tool_speeds(first: _Sample, last: _Sample, pace: ToolPace) -> tuple[float, float]:
    """Return the flange's speeds in mm/s and °/s between two measurements."""
    span_s = last.at_s - first.at_s
    if span_s <= 0.0:
        return math.inf, math.inf
    poses = (pace.kinematics.forward(each.joints_deg) for each in (first, last))
    off_mm, off_deg = apart(*poses)
    return off_mm / span_s, off_deg / span_s


def _speeds_deg_s(first: _Sample, last: _Sample) -> Sequence[float]:
    span_s = last.at_s - first.at_s
    if span_s <= 0.0:
        return [math.inf] * len(first.joints_deg)
    return [abs(b - a) / span_s for a, b in zip(first.joints_deg, last.joints_deg, strict=True)]
