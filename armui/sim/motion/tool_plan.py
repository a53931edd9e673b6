"""Plans the motion of the joints along a path of the tool, or reports why there is none."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
import numpy.typing as npt
from scipy.interpolate import CubicSpline

from armui.arm.limits import ANGLE_STEP_DEG
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.follow import follow
from armui.kinematics.pace import FINER, Demand, joint_demand, pace, tool_demand
from armui.kinematics.singularity import fine_steps, leaps
from armui.kinematics.tool_path import ToolPath
from armui.protocol.codes import ArmStatusCode
from armui.sim.mechanics.powered_joints import JOINT_COUNT, STANDSTILL, SixValues
from armui.sim.parameters.settings import ArmSettingsRecord

_ROUNDING: Final = 1e-9

Values = npt.NDArray[np.float64]

_FEWEST_STEPS: Final = 16

_LONGEST_MM: Final = 5000.0
"""A longer line or arc does not stay within reach, and need not be examined in detail."""

_REPLAY_START_1_S: Final = 4.0
"""The rate at which a replay reaches its pace: it takes at least a quarter of a second."""


class PathProfile:
    """A motion from 0 to an end, never backwards, with one acceleration up and down.

    It can be slowed, halted and continued at any time, and still stops at its end.

    Attributes:
        position: The position on the path.
        speed: The speed.
        acceleration: The acceleration.
    """

    def __init__(self, end: float, acceleration: float) -> None:
        """Starts at 0, halted.

        Args:
            end: The end, in any unit.
            acceleration: The largest change of speed per second, above 0.
        """
        self._end = end
        self._most = acceleration
        self._grain = _ROUNDING * end
        self._top_speed = 0.0
        self.position = 0.0
        self.speed = 0.0
        self.acceleration = 0.0

    @property
    def at_end(self) -> bool:
        """True if the end is reached."""
        return self.position == self._end

    @property
    def moving(self) -> bool:
        """True if it runs, or is about to."""
        return self.speed > 0.0 or (self._top_speed > 0.0 and not self.at_end)

    def run(self, top_speed: float) -> None:
        """Goes on with this speed; 0 halts."""
        self._top_speed = top_speed

    def step(self, dt_s: float) -> None:
        """Advances by `dt_s` seconds."""
        while dt_s > 0.0 and not self.at_end:
            acceleration, lasts_s = self._phase()
            part_s = min(dt_s, lasts_s)
            self.position += (self.speed + 0.5 * acceleration * part_s) * part_s
            self.speed = max(self.speed + acceleration * part_s, 0.0)
            self.acceleration = acceleration
            dt_s -= part_s
            if self.speed <= _ROUNDING * self._most and not acceleration > 0.0:
                self._stand()
                if not self._top_speed:
                    return

    def _phase(self) -> tuple[float, float]:
        """Return the present acceleration, and how long it lasts."""
        most, speed, top = self._most, self.speed, self._top_speed
        left = self._end - self.position
        if speed > top * (1.0 + _ROUNDING):
            return -most, (speed - top) / most
        spare = left - 0.5 * speed**2 / most
        if spare <= self._grain:
            return -most, speed / most
        peak = min(top, math.sqrt(most * left + 0.5 * speed**2))
        if speed < peak * (1.0 - _ROUNDING):
            return most, (peak - speed) / most
        if not top:
            return 0.0, math.inf
        return 0.0, spare / speed

    def _stand(self) -> None:
        """Stop here, or at the end if that is within rounding."""
        self.speed = self.acceleration = 0.0
        if self._end - self.position <= 2.0 * self._grain:
            self.position = self._end


class PlanningError(Exception):
    """The reason why a target or a path cannot be followed.

    Attributes:
        status: NO_SOLUTION, SINGULARITY or TARGET_BEYOND_LIMIT.
        beyond: The joints that would leave their range, joint 1 first.
    """

    def __init__(self, status: ArmStatusCode, beyond: Sequence[bool] = ()) -> None:
        super().__init__(status.name)
        self.status = status
        self.beyond = list(beyond) or [False] * JOINT_COUNT


class PathMotion:
    """The motion of six joints along a path of the tool; it can be slowed, paused and continued.

    Attributes:
        positions_deg: The joints' positions.
        speeds_deg_s: Their speeds.
        accelerations_deg_s2: Their accelerations.
        end_deg: The joint angles at the path's end.
    """

    def __init__(self, way: CubicSpline, end: float, top_speed: float, acceleration: float) -> None:
        """Starts at the beginning of the path, halted.

        Args:
            way: Joint angles in degrees over the path, from 0 to `end`.
            end: The path's length, in any unit.
            top_speed: The highest speed along it.
            acceleration: The highest acceleration along it.
        """
        self._way = way
        self._rate = way.derivative()
        self._bend = way.derivative(2)
        self._profile = PathProfile(end, acceleration)
        self._top_speed = top_speed
        self.end_deg: SixValues = tuple(way(end).tolist())
        self.positions_deg: SixValues = tuple(way(0.0).tolist())
        self.speeds_deg_s: SixValues = STANDSTILL
        self.accelerations_deg_s2: SixValues = STANDSTILL

    @property
    def at_end(self) -> bool:
        """True if the end of the path is reached."""
        return self._profile.at_end

    @property
    def moving(self) -> bool:
        """True if the joints turn, or are about to."""
        return self._profile.moving

    def run(self, share: float) -> None:
        """Goes on with a share of the highest speed; 0 brakes along the path."""
        self._profile.run(share * self._top_speed)

    def step(self, dt_s: float) -> None:
        """Advances by `dt_s` seconds."""
        profile = self._profile
        profile.step(dt_s)
        if profile.at_end:
            self.positions_deg = self.end_deg
            self.speeds_deg_s = self.accelerations_deg_s2 = STANDSTILL
            return
        rate = self._rate(profile.position)
        self.positions_deg = tuple(self._way(profile.position).tolist())
        self.speeds_deg_s = tuple((rate * profile.speed).tolist())
        bend = self._bend(profile.position) * profile.speed**2
        self.accelerations_deg_s2 = tuple((bend + rate * profile.acceleration).tolist())


def plan(
    kinematics: Kinematics, path: ToolPath, start_deg: Sequence[float], settings: ArmSettingsRecord
) -> PathMotion:
    """Return a motion along a path, as fast as the limits of joints and tool allow throughout.

    Args:
        kinematics: The arm's kinematics.
        path: The path; it begins at the flange's pose for `start_deg`.
        start_deg: The present joint angles.
        settings: The limits.

    Raises:
        PlanningError: The first place of the path that cannot be passed, and why; or a limit of 0.
    """
    if path.length_mm > _LONGEST_MM:
        raise PlanningError(ArmStatusCode.NO_SOLUTION)
    units = float(fine_steps(path.length_mm, path.angle_deg))
    steps = max(math.ceil(units), _FEWEST_STEPS)
    targets = path.poses(np.linspace(0.0, 1.0, steps + 1))
    joints = follow(kinematics.geometry, targets[None], np.array([start_deg]))[0]
    _check(joints, units / steps, settings)
    places = np.linspace(0.0, units, steps + 1)
    way = CubicSpline(places, joints)
    fine = np.linspace(0.0, units, FINER * steps + 1)
    top_speed, acceleration = _pace(
        _joint_demand(way, fine, settings),
        tool_demand(path.poses(fine / units), fine, settings.end_limits),
    )
    if not (0.0 < top_speed < math.inf and 0.0 < acceleration < math.inf):
        raise PlanningError(ArmStatusCode.NO_SOLUTION)
    return PathMotion(way, units, top_speed, acceleration)


def plan_replay(
    recording: Sequence[SixValues], sample_s: float, settings: ArmSettingsRecord
) -> PathMotion:
    """Return a motion through recorded joint angles, at their own pace where the joints can follow.

    Args:
        recording: Angles in degrees; it begins at the present ones.
        sample_s: The time between two of them.
        settings: The limits.

    Raises:
        PlanningError: Nothing is recorded, or a limit of 0.
    """
    if len(recording) < 2:
        raise PlanningError(ArmStatusCode.NO_SOLUTION)
    end = sample_s * (len(recording) - 1)
    way = CubicSpline(np.linspace(0.0, end, len(recording)), np.array(recording))
    fine = np.linspace(0.0, end, FINER * (len(recording) - 1) + 1)
    top_speed, acceleration = _pace(_joint_demand(way, fine, settings))
    top_speed = min(top_speed, 1.0)
    if not (top_speed > 0.0 and acceleration > 0.0):
        raise PlanningError(ArmStatusCode.NO_SOLUTION)
    return PathMotion(way, end, top_speed, min(acceleration, _REPLAY_START_1_S))


def _check(joints: Values, units_a_step: float, settings: ArmSettingsRecord) -> None:
    """Raises the first error along a path."""
    half_step = ANGLE_STEP_DEG / 2
    low = np.array([limits.min_deg - half_step for limits in settings.limits])
    high = np.array([limits.max_deg + half_step for limits in settings.limits])
    outside = (joints < low) | (joints > high)
    jumps = np.zeros(len(joints), dtype=bool)
    jumps[1:] = leaps(joints, units_a_step)
    bad = np.isnan(joints[:, 0]) | jumps | outside.any(axis=1)
    if not bad.any():
        return
    first = int(np.argmax(bad))
    if np.isnan(joints[first, 0]):
        raise PlanningError(ArmStatusCode.NO_SOLUTION)
    if jumps[first]:
        raise PlanningError(ArmStatusCode.SINGULARITY)
    raise PlanningError(ArmStatusCode.TARGET_BEYOND_LIMIT, outside[first].tolist())


def _joint_demand(way: CubicSpline, places: Values, settings: ArmSettingsRecord) -> Demand:
    speeds = [limits.max_speed_deg_s for limits in settings.limits]
    return joint_demand(way, places, speeds, settings.accelerations_deg_s2)


def _pace(*demands: Demand) -> tuple[float, float]:
    """Return the highest speed and acceleration along one path."""
    top_speed, acceleration = pace(demands)
    return float(top_speed[0]), float(acceleration[0])
