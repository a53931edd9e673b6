"""Whether a motion of ours is measured to be faster than the window shows: pure."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from typing import Final, NamedTuple

from armui.arm.limits import JointLimits, plausible
from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.arm.state import ArmState

_TOO_FAST: Final = 1.5
_SLACK_DEG_S: Final = 2.0
"""What the trembling of the last digit and the bus's jitter can look like."""
_FOR_S: Final = 0.1
_HALF_S: Final = 0.05
_BRAKING: Final = 0.95
"""A joint that gets slower is on its way to the speed it was told."""


class _Sample(NamedTuple):
    at_s: float
    joints_deg: tuple[float, ...]


class OverspeedWatch:
    """Measures the joints' speeds over the last tenth of a second."""

    def __init__(self) -> None:
        self._samples: deque[_Sample] = deque()

    def restart(self) -> None:
        """Another speed is shown from now on."""
        self._samples.clear()

    def observe(
        self, state: ArmState, percent: int | None, factory: Sequence[JointLimits]
    ) -> Refusal | None:
        """Take in what is measured.

        Args:
            state: The arm as heard.
            percent: The speed shown for the motion under way, of each joint's highest; ``None``:
                there is nothing to compare with.
            factory: Of the arm's model: they stand in where the arm has told none.

        Returns:
            Which joint is too fast, or ``None``.
        """
        angles_deg, last = state.angles_deg(), state.joints_deg[-1]
        if percent is None or angles_deg is None or last is None:
            self._samples.clear()
            return None
        samples = self._samples
        if not samples or last.at_s > samples[-1].at_s:
            samples.append(_Sample(last.at_s, angles_deg))
        while len(samples) > 2 and samples[1].at_s <= last.at_s - _FOR_S:
            samples.popleft()
        if samples[-1].at_s - samples[0].at_s < _FOR_S:
            return None
        return self._judge(state, percent, factory)

    def _judge(
        self, state: ArmState, percent: int, factory: Sequence[JointLimits]
    ) -> Refusal | None:
        first, newest = self._samples[0], self._samples[-1]
        middle = next(each for each in self._samples if each.at_s >= newest.at_s - _HALF_S)
        speeds = _speeds_deg_s(first, newest)
        before, after = _speeds_deg_s(first, middle), _speeds_deg_s(middle, newest)
        for index, (limits, stands_in) in enumerate(zip(state.limits, factory, strict=True)):
            known = limits is not None and plausible(limits.value)
            highest = limits.value if limits is not None and known else stands_in
            shown_deg_s = highest.max_speed_deg_s * percent / 100.0
            too_fast = speeds[index] > _TOO_FAST * shown_deg_s + _SLACK_DEG_S
            if too_fast and after[index] >= _BRAKING * before[index]:
                return Refusal(
                    RefusalCode.TOO_FAST,
                    {
                        "joint": index + 1,
                        "value": round(speeds[index], 1),
                        "maximum": round(shown_deg_s, 1),
                    },
                )
        return None


def _speeds_deg_s(first: _Sample, last: _Sample) -> Sequence[float]:
    span_s = last.at_s - first.at_s
    if span_s <= 0.0:
        return [math.inf] * len(first.joints_deg)
    return [abs(b - a) / span_s for a, b in zip(first.joints_deg, last.joints_deg, strict=True)]
