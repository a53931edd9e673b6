"""Joints under the law of their drivers: closed forms, energy, friction, stops."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from armui.sim.mechanics.joint_dynamics import DriverLaw, JointDynamics, JointLosses
from armui.sim.mechanics.rigid_body import DOWN, RigidBody, piper_links
from tests.family import FACTORY_LIMITS
from tests.sim.energy import kinetic_energy_j, potential_energy_j

TICK_S = 0.005
BODY = RigidBody(piper_links())
STOPS = (
    np.radians([each.min_deg for each in FACTORY_LIMITS]),
    np.radians([each.max_deg for each in FACTORY_LIMITS]),
)
WIDE = (np.full(6, -50.0), np.full(6, 50.0))
LOSSLESS = JointLosses((0.0,) * 6, (0.0,) * 6, (1e6,) * 6, (1e6,) * 6)
LEANING = np.radians((0.0, 60.0, -60.0, 0.0, 20.0, 0.0))


def law(driven: list[int], **values: float) -> DriverLaw:
    """The same numbers for some joints (0–5); the others stand."""
    made = DriverLaw()
    made.driven[driven] = True
    for name, value in values.items():
        getattr(made, name)[driven] = value
    return made


def step(dynamics, told, joints, speeds, stops=WIDE, dt_s=TICK_S, down=DOWN):
    """One step of the simulated arm's own length."""
    return dynamics.step(BODY, told, joints, speeds, stops_rad=stops, dt_s=dt_s, down=down)


def response(inertia: float, kp: float, kd: float, step: float) -> Callable[[float], float]:
    """The closed form of inertia·q̈ + kd·q̇ + kp·(q − step) = 0 from rest at 0."""
    root = np.roots((inertia, kd, kp)).astype(complex)
    if abs(root[0] - root[1]) < 1e-9:
        raise ValueError("critically damped: choose other gains")
    first = -step * root[1] / (root[1] - root[0])
    second = step * root[0] / (root[1] - root[0])
    return lambda t: float((step + first * np.exp(root[0] * t) + second * np.exp(root[1] * t)).real)


@pytest.mark.parametrize("index", [0, 3, 5])
@pytest.mark.parametrize(
    ("kp", "kd"), [(10.0, 0.8), (25.0, 0.3), (100.0, 2.0), (500.0, 5.0), (500.0, 1.0)]
)
def test_a_step_of_one_joint_is_the_closed_form_of_its_gains(index, kp, kd) -> None:
    """Joints that carry no weight, the others held: within 2 % of the step at every tick."""
    joints, speeds, width = LEANING.copy(), np.zeros(6), 0.2
    level = (0.0, 0.0, 0.0) if index else DOWN  # wrists without weight
    inertia = float(BODY.equation(joints, speeds)[0][index, index])
    expected = response(inertia, kp, kd, width)
    start = joints[index]
    target = law([index], positions_rad=start + width, kp=kp, kd=kd)
    dynamics = JointDynamics(LOSSLESS)
    worst = 0.0
    for tick in range(1, 201):
        joints, speeds = dynamics.step(
            BODY, target, joints, speeds, stops_rad=WIDE, dt_s=TICK_S, down=level
        )
        worst = max(worst, abs(joints[index] - start - expected(tick * TICK_S)))
        if tick * TICK_S * kd / inertia > 12.0:
            break
    assert worst < 0.02 * width
    assert np.delete(joints, index) == pytest.approx(np.delete(LEANING, index))


def test_speed_and_torque_setpoints_count_as_the_law_has_it() -> None:
    """Without kp the joint takes the speed at which kd·(v − q̇) + t balances the friction."""
    losses = JointLosses((0.1,) * 6, (0.5,) * 6)
    target = law([5], speeds_rad_s=1.0, kd=2.0, torques_nm=0.6)
    joints, speeds = np.zeros(6), np.zeros(6)
    dynamics = JointDynamics(losses)
    for _ in range(200):
        joints, speeds = step(dynamics, target, joints, speeds)
    # 2·(1 − v) + 0.6 = 0.5·v + 0.1
    assert speeds[5] == pytest.approx(2.5 / 2.5, rel=1e-3)


def test_a_falling_arm_without_losses_keeps_its_energy_nearly_and_with_them_loses_it() -> None:
    for losses, gains in ((LOSSLESS, 0.05), (JointLosses(), 1e-9)):
        joints, speeds = LEANING.copy(), np.zeros(6)
        energy = first = potential_energy_j(BODY, joints)
        dynamics, limp = JointDynamics(losses), law(list(range(6)))
        for _ in range(60):
            joints, speeds = dynamics.step(BODY, limp, joints, speeds, stops_rad=WIDE, dt_s=TICK_S)
            now = potential_energy_j(BODY, joints) + kinetic_energy_j(BODY, joints, speeds)
            assert now <= max(energy, first) + gains
            energy = now
        assert np.abs(speeds).max() > 1.0
        if losses is LOSSLESS:
            assert energy == pytest.approx(first, abs=0.1)
        else:
            assert energy < first - 0.3


def test_an_arm_let_go_falls_to_its_stops_and_stays() -> None:
    joints, speeds = LEANING.copy(), np.zeros(6)
    dynamics, limp = JointDynamics(), law(list(range(6)))
    for _ in range(800):
        joints, speeds = step(dynamics, limp, joints, speeds, stops=STOPS)
        assert (joints >= STOPS[0] - 1e-12).all()
        assert (joints <= STOPS[1] + 1e-12).all()
    assert (speeds == 0.0).all()
    assert joints[1:3] == pytest.approx([0.0, 0.0], abs=1e-9)  # folded on the base


def test_less_torque_than_the_friction_turns_nothing_and_a_little_more_does() -> None:
    for torque_nm, moves in ((0.24, False), (0.26, True)):
        joints, speeds = np.zeros(6), np.zeros(6)
        dynamics, push = JointDynamics(), law([5], torques_nm=torque_nm)
        for _ in range(100):
            joints, speeds = dynamics.step(BODY, push, joints, speeds, stops_rad=WIDE, dt_s=TICK_S)
        assert bool(joints[5] > 0.0) is moves


def test_a_driver_gives_no_more_than_its_motor_has() -> None:
    joints, speeds = np.zeros(6), np.zeros(6)
    dynamics, far = JointDynamics(), law([0], positions_rad=2.0, kp=500.0, kd=5.0)
    fastest = 0.0
    for _ in range(100):
        joints, speeds = step(dynamics, far, joints, speeds)
        assert abs(dynamics.torques_nm[0]) <= 32.0
        fastest = max(fastest, speeds[0])
    assert 4.0 < fastest < 6.0
    for _ in range(100):
        joints, speeds = step(dynamics, far, joints, speeds)
    assert joints[0] == pytest.approx(2.0, abs=0.001)


@pytest.mark.parametrize("dt_s", [0.001, 0.005, 0.02, 0.05])
def test_the_stiffest_gains_are_stable_at_any_step(dt_s) -> None:
    joints, speeds = LEANING.copy(), np.zeros(6)
    stiff = law(list(range(6)), positions_rad=0.5, kp=500.0, kd=5.0)
    stiff.positions_rad[2] = -0.5
    dynamics = JointDynamics()
    for _ in range(math.ceil(2.0 / dt_s)):
        joints, speeds = step(dynamics, stiff, joints, speeds, stops=STOPS, dt_s=dt_s)
    assert joints == pytest.approx((0.5, 0.5, -0.5, 0.5, 0.5, 0.5), abs=0.02)
    assert np.abs(speeds).max() < 1e-3


def test_nearly_nothing_in_every_field_never_makes_a_joint_faster() -> None:
    """The codes nearest to zero: kd −0.0012, torque −0.004 N·m, speed −0.011 rad/s, kp 0."""
    nearly = law(list(range(6)), speeds_rad_s=-0.01099, kd=-0.001221, torques_nm=-0.003907)
    level = (0.0, 0.0, 0.0)  # no gravity: what moves, moves by the fields alone
    joints, speeds = LEANING.copy(), np.array((1.0, -0.5, 0.5, 1.0, -1.0, 2.0))
    dynamics = JointDynamics()
    energy = kinetic_energy_j(BODY, joints, speeds)
    for _ in range(400):
        joints, speeds = dynamics.step(
            BODY, nearly, joints, speeds, stops_rad=WIDE, dt_s=TICK_S, down=level
        )
        now = kinetic_energy_j(BODY, joints, speeds)
        assert now <= energy + 1e-12
        energy = now
    assert energy == 0.0
