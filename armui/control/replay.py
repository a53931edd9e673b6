"""What a replay of a recording asks of the arm: pure, on the recording's samples."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.arm.limits import JOINTS, check_joint
from armui.arm.refusal import Refusal

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.situation import Situation
    from armui.trajectory.recording import Array, Recording

_SPEED_OVER_S: Final = 0.1
"""Speeds are taken over so long: samples carry the bus's jitter."""
_SPEED_SLACK: Final = 1.02
_LAG_SLACK_DEG: Final = 5.0
_LAG_S: Final = 0.15
_LAG_MEMORY_S: Final = 1.0
_ACCELERATION_DEG_S2: Final = math.degrees(5.0)
"""Taken where the arm has not told its own."""


@dataclass(frozen=True)
class Replay:
    """What the operator wants to have replayed.

    Attributes:
        recording: The samples.
        factor: On the recorded speed.
        laps: How often; :data:`armui.control.run.ENDLESS` until it is ended.
    """

    recording: Recording
    factor: float = 1.0
    laps: int = 1

    @property
    def duration_s(self) -> float:
        """How long a lap takes, without the approach."""
        return self.recording.duration_s / self.factor

    @property
    def first_deg(self) -> tuple[float, ...]:
        """Where it begins."""
        return tuple(float(angle) for angle in self.recording.joints_deg[0])

    @cached_property
    def _times_s(self) -> Array:
        times: Array = self.recording.times_s - self.recording.times_s[0]
        return times

    @cached_property
    def speeds_deg_s(self) -> Array:
        """(n, 6) how fast each joint is asked to turn at each sample."""
        before, after = self._times_s - _SPEED_OVER_S / 2, self._times_s + _SPEED_OVER_S / 2
        spans = np.clip(after, 0, self._times_s[-1]) - np.clip(before, 0, self._times_s[-1])
        ways = np.column_stack(
            [
                np.interp(after, self._times_s, angles) - np.interp(before, self._times_s, angles)
                for angles in self.recording.joints_deg.T
            ]
        )
        speeds: Array = np.abs(ways) / np.maximum(spans, 1e-9)[:, None] * self.factor
        return speeds

    def joints_deg_at(self, at_s: float) -> tuple[float, ...]:
        """Where the joints shall be, so long after the first sample of a lap."""
        recorded_s = at_s * self.factor
        return tuple(
            float(np.interp(recorded_s, self._times_s, angles))
            for angles in self.recording.joints_deg.T
        )

    def gripper_mm_at(self, at_s: float) -> float | None:
        """How far open the gripper shall be, ``None`` where that was not recorded."""
        index = int(np.searchsorted(self._times_s, at_s * self.factor, side="right")) - 1
        opening_mm = float(self.recording.gripper_mm[max(0, index)])
        return None if math.isnan(opening_mm) else opening_mm

    def lag_allowed_deg(self, at_s: float, state: ArmState) -> tuple[float, ...]:
        """How far an arm that follows may be behind: what its own braking explains, and a bit.

        An arm that brakes late for a target that has turned round already is no obstacle's work:
        the fastest of the last second counts.
        """
        recorded_s = at_s * self.factor
        last = int(np.searchsorted(self._times_s, recorded_s, side="right"))
        first = int(np.searchsorted(self._times_s, recorded_s - _LAG_MEMORY_S * self.factor))
        speeds = self.speeds_deg_s[min(first, last - 1) : last].max(axis=0)
        return tuple(
            _LAG_SLACK_DEG
            + _LAG_S * float(speed)
            + float(speed) ** 2
            / (2.0 * (heard.value if heard is not None else _ACCELERATION_DEG_S2))
            for speed, heard in zip(speeds, state.accelerations_deg_s2, strict=True)
        )


def why_not(replay: Replay, situation: Situation) -> Refusal | None:
    """What speaks against a replay: too little of it, limits, speeds the joints cannot do."""
    recording = replay.recording
    if len(recording.samples) < 2 or recording.duration_s <= 0.0:
        return Refusal("run_empty", {"name": recording.name})
    for joint, limits, angles, speeds in zip(
        JOINTS,
        situation.limits,
        recording.joints_deg.T,
        replay.speeds_deg_s.T,
        strict=True,
    ):
        for angle_deg in (float(angles.min()), float(angles.max())):
            refusal = check_joint(joint, angle_deg, limits)
            if refusal is not None:
                return refusal
        fastest = float(speeds.max())
        if fastest > limits.max_speed_deg_s * _SPEED_SLACK:
            best = replay.factor * limits.max_speed_deg_s / fastest
            return Refusal(
                "replay_too_fast",
                {
                    "joint": joint,
                    "value": round(fastest, 1),
                    "maximum": round(limits.max_speed_deg_s, 1),
                    "percent": math.floor(best * 100.0),
                },
            )
    return None


def why_behind(replay: Replay, at_s: float, state: ArmState) -> Refusal | None:
    """Whether an arm does not follow: ``None``, or which joint is how far behind."""
    measured_deg = state.angles_deg()
    if measured_deg is None:
        return None
    for joint, target, measured, allowed in zip(
        JOINTS,
        replay.joints_deg_at(at_s),
        measured_deg,
        replay.lag_allowed_deg(at_s, state),
        strict=True,
    ):
        away_deg = abs(target - measured)
        if away_deg > allowed:
            return Refusal("replay_lagging", {"joint": joint, "away": round(away_deg, 1)})
    return None
