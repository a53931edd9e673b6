"""The demands of a replay on the arm: pure, by the recording's samples."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.arm.limits import JOINTS
from armui.arm.refusal import Reason, Refusal
from armui.trajectory.samples.recording import ReplayProfile, SampleCursor, replay_profile

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.operating_state import OperatingState
    from armui.trajectory.samples.recording import Recording
    from armui.ways.way import Way

RUN_UNSAVED = Reason(
    "run_unsaved",
    "No point of “{name}” is saved, and what is not saved does not run. Open it and save it.",
)
RUN_EMPTY = Reason("run_empty", "“{name}” has no points. Add points, or choose another trajectory.")
REPLAY_TOO_FAST = Reason(
    "replay_too_fast",
    "At the recorded pace joint {joint} would turn at {value}°/s; its limit is {maximum}°/s. This "
    "replay goes at {percent} % at most.",
)
REPLAY_LAGGING = Reason(
    "replay_lagging",
    "Joint {joint} does not follow: it is {away}° behind. See what keeps it, or replay more "
    "slowly.",
)


FULL_PERCENT: Final = 100
"""The recorded pace: no replay is faster."""
_SPEED_SLACK: Final = 1.02
"""Speeds computed from samples may exceed a limit by this factor: samples carry jitter."""
_LAG_SLACK_DEG: Final = 5.0
_LAG_S: Final = 0.15
"""The lag that is always allowed: `_LAG_SLACK_DEG`, and the way of this time."""
LAG_MEMORY_S: Final = 1.0
"""The highest speed and pace within this time count for the lag that is allowed."""
_ACCELERATION_DEG_S2: Final = math.degrees(5.0)
"""The acceleration assumed while the arm has not reported its own."""


@dataclass(frozen=True)
class Replay:
    """A replay as the operator wants it.

    Attributes:
        recording: The samples.
        speed_percent: The operator's speed as it begins: the share of the recorded pace.
        cycles: The number of cycles, or :data:`armui.control.run.progress.ENDLESS`.
        profile: The profile, if it was computed before; for a long recording that takes long.
    """

    recording: Recording
    speed_percent: int = FULL_PERCENT
    cycles: int = 1
    profile: ReplayProfile | None = None

    @property
    def duration_s(self) -> float:
        """The duration of a cycle, without the approach."""
        return self.recording.duration_s

    @property
    def first_deg(self) -> tuple[float, ...]:
        """The six angles at which it begins."""
        return tuple(float(angle) for angle in self.recording.joints_deg[0])

    def way(self, begin_deg: Sequence[float], most: int = FULL_PERCENT) -> Way:
        """Return the way from six angles to the first sample, along all, and back for a cycle.

        The faster it is replayed, the further the arm may be off where it has to change its speed:
        it is checked for the highest speed that it may go at.

        Args:
            begin_deg: Where the arm stands.
            most: The highest speed, in percent of the recorded pace.
        """
        from armui.ways.way import Way  # noqa: PLC0415 - numpy

        samples = self.recording.joints_deg
        back = samples[:1] if self.cycles != 1 else samples[:0]
        there = np.vstack((np.array([begin_deg], dtype=float), samples, back))
        beside = np.zeros_like(there)
        beside[1 : len(samples) + 1] = self.known.astray_deg * (most / FULL_PERCENT) ** 2
        return Way(there, beside_deg=beside)

    @cached_property
    def known(self) -> ReplayProfile:
        """The extremes and speeds at the recorded speed."""
        return replay_profile(self.recording) if self.profile is None else self.profile

    @cached_property
    def _cursor(self) -> SampleCursor:
        return SampleCursor(self.recording)

    @cached_property
    def _cursor_behind(self) -> SampleCursor:
        """Follows the first one, :data:`LAG_MEMORY_S` behind it."""
        return SampleCursor(self.recording)

    def joints_deg_at(self, at_s: float) -> tuple[float, ...]:
        """Return the target angles, this long after the first sample of a cycle."""
        return self._cursor.joints_deg_at(at_s)

    def gripper_mm_at(self, at_s: float) -> float | None:
        """Return the target opening of the gripper, or ``None`` if none was recorded."""
        opening_mm = self._cursor.gripper_mm_at(at_s)
        return None if math.isnan(opening_mm) else opening_mm

    def braking_s(self, at_s: float, state: ArmState) -> float:
        """Return the time in which the slowest joint brakes from its recent speed."""
        speeds = self._speeds_deg_s(at_s)
        return max(
            speed / (heard.value if heard is not None else _ACCELERATION_DEG_S2)
            for speed, heard in zip(speeds, state.accelerations_deg_s2, strict=True)
        )

    def _speeds_deg_s(self, at_s: float) -> list[float]:
        """Return the highest speed of each joint in the last second."""
        last = self._cursor.index_at(at_s)
        first = self._cursor_behind.index_at(at_s - LAG_MEMORY_S)
        highest = self.known.speeds_deg_s[first : last + 1].max(axis=0)
        return [float(speed) for speed in highest]

    def lag_allowed_deg(self, at_s: float, state: ArmState, pace: float) -> tuple[float, ...]:
        """Return the lag that the arm's braking explains, in degrees, with a small margin.

        An arm that brakes late for a target that has already turned round has met no obstacle: so
        the highest speed of the last second counts. Joints arrive together: all take as long to
        brake as the slowest one.

        Args:
            at_s: The recorded time.
            state: The arm's state.
            pace: The highest pace of :data:`LAG_MEMORY_S`, 0–1: a slow replay lags less.
        """
        braking_s = pace * self.braking_s(at_s, state)
        return tuple(
            _LAG_SLACK_DEG + (_LAG_S + braking_s / 2.0) * pace * speed
            for speed in self._speeds_deg_s(at_s)
        )


def why_not(replay: Replay) -> Refusal | None:
    """Return why a recording is no replay at all: it is too short; or ``None``."""
    recording = replay.recording
    if len(recording.samples) < 2 or recording.duration_s <= 0.0:
        return RUN_EMPTY(name=recording.name)
    return None


def most_percent(replay: Replay, operating_state: OperatingState) -> tuple[int, Refusal | None]:
    """Return the highest speed that every joint's limit allows, and why not a higher one."""
    most, why = FULL_PERCENT, None
    for joint, limits, fastest in zip(
        JOINTS, operating_state.limits, replay.known.fastest_deg_s, strict=True
    ):
        if fastest <= limits.max_speed_deg_s * _SPEED_SLACK:
            continue
        percent = math.floor(100.0 * limits.max_speed_deg_s / fastest)
        if percent < most:
            most = percent
            why = REPLAY_TOO_FAST(
                joint=joint,
                value=round(fastest, 1),
                maximum=round(limits.max_speed_deg_s, 1),
                percent=percent,
            )
    return most, why


def why_behind(replay: Replay, at_s: float, state: ArmState, pace: float) -> Refusal | None:
    """Return the joint that lags too far, and by how much; see :meth:`Replay.lag_allowed_deg`."""
    measured_deg = state.angles_deg()
    if measured_deg is None:
        return None
    for joint, target, measured, allowed in zip(
        JOINTS,
        replay.joints_deg_at(at_s),
        measured_deg,
        replay.lag_allowed_deg(at_s, state, pace),
        strict=True,
    ):
        away_deg = abs(target - measured)
        if away_deg > allowed:
            return REPLAY_LAGGING(joint=joint, away=round(away_deg, 1))
    return None
