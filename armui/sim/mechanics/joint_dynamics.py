"""The dynamics of driven joints: motors, friction, stops, and the arm's own mass.

The equation of motion is solved for the speeds at the end of each step by the trapezoidal rule,
with gains and viscous friction inside the rule: stiff gains stay stable, and no damping is added
beyond the drivers' own. Mass and gravity are computed once in `LONGEST_STEP_S`; within it the steps
are as short as the stiffest joint needs. Dry friction and stops are bounded impulses: a joint
stands still as long as the torque on it is less than they can hold.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Final

import numpy as np
import numpy.typing as npt
from scipy.linalg.lapack import dgesv

from armui.sim.mechanics.rigid_body import DOWN, RigidBody, Values

Flags = npt.NDArray[np.bool_]

LONGEST_STEP_S: Final = 0.005
_MOST_STEPS: Final = 8
_ANGLE_A_STEP_RAD: Final = 0.3
"""The largest part of an oscillation of the stiffest joint in one step, in rad."""
_DECAY_A_STEP: Final = 2.0
"""The longest step, in time constants of the most strongly damped joint."""

_ONES: Final = [np.eye(size) for size in range(7)]

_AT_STOP_RAD: Final = 1e-9
_FREE_TRIES: Final = 4
"""After so many corrections no standing joint may start to slide any more, so that they end."""
_SATURATION_TRIES: Final = 2
"""The rounds in which saturated torques are fitted to the speeds that result from them."""


@dataclass(frozen=True, slots=True)
class JointLosses:
    """The friction and limits of the joints' motion; joint 1 first, at the output of the gear.

    The maker publishes none of it: the figures are assumptions.

    Attributes:
        dry_nm: Dry friction. The gears hold a wrist that carries nothing.
        viscous_nm_s_rad: Friction that grows with the speed.
        peak_nm: The largest torque of a motor: what the protocol lets a host ask for.
        no_load_rad_s: The speed at which a motor has no torque left: twice the rated 3 rad/s.
    """

    dry_nm: Sequence[float] = (0.4, 0.4, 0.4, 0.25, 0.25, 0.25)
    viscous_nm_s_rad: Sequence[float] = (0.8, 0.8, 0.8, 0.3, 0.3, 0.3)
    peak_nm: Sequence[float] = (32.0, 32.0, 32.0, 14.0, 14.0, 14.0)
    no_load_rad_s: Sequence[float] = (6.0,) * 6


@dataclass(slots=True)
class DriverLaw:
    """The setpoints of six drivers: kp·(position − q) + kd·(speed − q̇) + torque at the output.

    Attributes:
        positions_rad, speeds_rad_s, torques_nm: Setpoints, joint 1 first.
        kp, kd: Gains in N·m/rad and N·m·s/rad; with both 0 and no torque a joint is limp.
        driven: The joints that move by this law; something else holds the others.
    """

    positions_rad: Values = field(default_factory=lambda: np.zeros(6))
    speeds_rad_s: Values = field(default_factory=lambda: np.zeros(6))
    kp: Values = field(default_factory=lambda: np.zeros(6))
    kd: Values = field(default_factory=lambda: np.zeros(6))
    torques_nm: Values = field(default_factory=lambda: np.zeros(6))
    driven: Flags = field(default_factory=lambda: np.zeros(6, dtype=bool))


class JointDynamics:
    """Six joints under the law of their drivers.

    Attributes:
        losses: The friction and limits of their motion.
        torques_nm: The drivers' torques in the last step.
    """

    def __init__(self, losses: JointLosses | None = None) -> None:
        self.losses = losses or JointLosses()
        self._viscous = np.array(self.losses.viscous_nm_s_rad, dtype=float)
        self._dry = np.array(self.losses.dry_nm, dtype=float)
        self._peak = np.array(self.losses.peak_nm, dtype=float)
        self._no_load = np.array(self.losses.no_load_rad_s, dtype=float)
        self.torques_nm: Values = np.zeros(6)

    def step(
        self,
        body: RigidBody,
        law: DriverLaw,
        joints_rad: Values,
        speeds_rad_s: Values,
        *,
        stops_rad: tuple[Values, Values],
        dt_s: float,
        down: Sequence[float] = DOWN,
        pushes_nm: Values | None = None,
    ) -> tuple[Values, Values]:
        """Return the joints' positions and speeds after a time.

        Args:
            body: The masses.
            law: The drivers' law in this time.
            joints_rad: (6,) angles in the model's frame.
            speeds_rad_s: (6,) speeds; those of joints that are not driven count as 0.
            stops_rad: The mechanical stops: lowest and highest angles, each (6,).
            dt_s: The time to advance.
            down: The direction of gravity in the base frame.
            pushes_nm: The torque added to each joint from outside.
        """
        joints = joints_rad
        speeds = np.where(law.driven, speeds_rad_s, 0.0)
        # a joint that is beyond its stop already may only come back
        stops = np.minimum(stops_rad[0], joints), np.maximum(stops_rad[1], joints)
        parts = max(math.ceil(dt_s / LONGEST_STEP_S - 1e-9), 1)
        for _ in range(parts):
            mass, bias = body.equation(joints, speeds, down)
            load = -bias if pushes_nm is None else pushes_nm - bias
            steps = self._steps(mass, law, dt_s / parts)
            interval = _Interval(mass, load, law, self._viscous, dt_s / parts / steps)
            for _ in range(steps):
                joints, speeds = self._step(interval, joints, speeds, stops)
        return joints, speeds

    def _steps(self, mass: Values, law: DriverLaw, dt_s: float) -> int:
        inertias = mass.diagonal()
        swing = math.sqrt(float((law.kp / inertias).max())) * dt_s / _ANGLE_A_STEP_RAD
        decay = float((np.abs(law.kd + self._viscous) / inertias).max()) * dt_s / _DECAY_A_STEP
        return min(max(math.ceil(max(swing, decay)), 1), _MOST_STEPS)

    def _step(
        self, interval: _Interval, joints: Values, speeds: Values, stops: tuple[Values, Values]
    ) -> tuple[Values, Values]:
        """Return joints and speeds after one step; drivers saturate at their motors' torque."""
        low, high = stops
        given = interval.torques(joints, speeds)
        for _ in range(_SATURATION_TRIES):
            signs = np.sign(given)
            room = self._peak * np.minimum(2.0 - 2.0 * signs * speeds / self._no_load, 1.0)
            over = np.abs(given) > np.maximum(room, 0.0)
            if over.any():
                interval = interval.saturated(over, signs * np.maximum(room, 0.0))
            after = self._solve(interval, joints, speeds, stops)
            mean = (speeds + after) / 2.0
            given = interval.torques(joints, mean)
            if not (np.abs(given) > self._peak).any():
                break
        self.torques_nm = given * interval.driven
        joints = joints + interval.dt_s * mean
        beyond = (joints < low) | (joints > high)
        if beyond.any():
            joints = np.minimum(np.maximum(joints, low), high)
            after = interval.hit(after, np.flatnonzero(beyond & interval.driven))
        return joints, after

    def _solve(
        self, interval: _Interval, joints: Values, speeds: Values, stops: tuple[Values, Values]
    ) -> Values:
        """Return the speeds after a step with dry friction and stops, as bounded impulses.

        Each joint either stands or slides one way. The assumption is corrected until it fits all
        joints; a joint that keeps changing stands in this step.
        """
        right = interval.right(joints, speeds)
        dry = interval.dt_s * self._dry
        at_low, at_high = joints <= stops[0] + _AT_STOP_RAD, joints >= stops[1] - _AT_STOP_RAD
        most = np.where(at_low, math.inf, dry)  # impulse that holds a joint still
        least = np.where(at_high, -math.inf, -dry)
        sliding = np.sign(speeds) * interval.driven
        sliding[(at_low & (sliding < 0)) | (at_high & (sliding > 0))] = 0.0
        may_start = interval.driven
        for attempt in range(_FREE_TRIES + len(joints)):
            moves = sliding != 0.0
            after = interval.solve(moves, right - sliding * dry)
            fits = after * sliding >= 0.0
            held = interval.matrix @ after - right
            lets_go = ~moves & may_start & ((held > most) | (held < least))
            if fits.all() and not lets_go.any():
                break
            if attempt >= _FREE_TRIES:
                may_start = np.zeros_like(may_start)
                lets_go = may_start
            sliding = np.where(lets_go, -np.sign(held), sliding * fits)
        return after


class _Interval:
    """Steps of one length in which mass, load and law stay the same."""

    def __init__(
        self, mass: Values, load: Values, law: DriverLaw, viscous: Values, dt_s: float
    ) -> None:
        self.dt_s = dt_s
        self.driven = law.driven
        self._mass = mass
        self._load = load
        self._law = law
        self._viscous = viscous
        self._constant_nm = law.torques_nm + law.kp * law.positions_rad + law.kd * law.speeds_rad_s
        quarter = dt_s / 4.0 * law.kp
        self._loss = (law.kd + viscous) / 2.0 + quarter
        self._braking = law.kd + 2.0 * quarter
        self.matrix = mass.copy()
        self.matrix.flat[:: len(mass) + 1] += dt_s * self._loss
        self._inverses: dict[bytes, Values] = {}

    def right(self, joints: Values, speeds: Values) -> Values:
        """Return the right-hand side of the rule, without friction and stops."""
        push = self._constant_nm - self._law.kp * joints + self._load - self._loss * speeds
        side: Values = self._mass @ speeds + self.dt_s * push
        return side

    def torques(self, joints: Values, mean_speeds: Values) -> Values:
        """Return the drivers' torques in a step, from its start and the mean speeds."""
        return self._constant_nm - self._law.kp * joints - self._braking * mean_speeds

    def solve(self, moves: Flags, right: Values) -> Values:
        """Return the speeds after a step of the moving joints; the others stand still."""
        pattern = moves.tobytes()
        inverse = self._inverses.get(pattern)
        if inverse is None:
            inverse = self._inverses[pattern] = _inverse_of(self.matrix, moves)
        speeds: Values = inverse @ right
        return speeds

    def saturated(self, over: Flags, torques_nm: Values) -> _Interval:
        """Return the interval with fixed torques of some drivers instead of their law."""
        law = self._law
        fixed = replace(
            law,
            kp=np.where(over, 0.0, law.kp),
            kd=np.where(over, 0.0, law.kd),
            torques_nm=np.where(over, torques_nm, law.torques_nm),
        )
        return _Interval(self._mass, self._load, fixed, self._viscous, self.dt_s)

    def hit(self, speeds: Values, hits: npt.NDArray[np.intp]) -> Values:
        """Return the speeds after joints have hit their stops: these stop, and jolt the others."""
        blows = _inverse_of(self._mass, self.driven)[:, hits]
        struck: Values = speeds - blows @ np.linalg.solve(blows[hits], speeds[hits])
        return struck


def _inverse_of(matrix: Values, rows: Flags) -> Values:
    """Return the inverse within some rows and columns, 0 elsewhere."""
    if rows.all():
        return _inverse(matrix)
    inverse = np.zeros_like(matrix)
    chosen = np.flatnonzero(rows)
    if len(chosen):
        at = np.ix_(chosen, chosen)
        inverse[at] = _inverse(matrix[at])
    return inverse


def _inverse(matrix: Values) -> Values:
    """Return the inverse of a small matrix, at a quarter of the time that numpy's takes."""
    _, _, inverse, _ = dgesv(matrix, _ONES[len(matrix)])
    return np.asarray(inverse)
