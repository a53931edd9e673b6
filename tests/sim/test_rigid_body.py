"""The arm's equation of motion, against virtual work and Lagrange's equations."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from armui.sim.mechanics.gravity import DOWN_BY_MOUNTING
from armui.sim.mechanics.rigid_body import ROTOR_INERTIAS_KG_M2, RigidBody, piper_links
from tests.family import FACTORY_LIMITS
from tests.sim.energy import kinetic_energy_j, potential_energy_j

poses = st.tuples(*(st.floats(j.min_deg, j.max_deg) for j in FACTORY_LIMITS)).map(np.radians)
speeds = st.tuples(*(st.floats(-3.0, 3.0) for _ in FACTORY_LIMITS)).map(np.array)
NUDGES = 1e-5 * np.eye(6)


@given(poses, st.sampled_from(list(DOWN_BY_MOUNTING.values())), st.sampled_from([0.0, 1.5]))
@settings(max_examples=30, deadline=None)
def test_gravity_is_the_slope_of_the_potential_energy(pose, down, payload_kg) -> None:
    body = RigidBody(piper_links(), payload_kg)
    slope = [
        (potential_energy_j(body, pose + each, down) - potential_energy_j(body, pose - each, down))
        / 2e-5
        for each in NUDGES
    ]
    assert body.gravity_torques_nm(pose, down) == pytest.approx(-np.array(slope), abs=1e-6)
    _, bias = body.equation(pose, np.zeros(6), down)
    assert bias == pytest.approx(np.array(slope), abs=1e-6)


@given(poses, speeds)
@settings(max_examples=30, deadline=None)
def test_the_bias_is_that_of_lagrange(pose, turning) -> None:
    """d/dt (M·v) − ½ ∂(v·M·v)/∂q + ∂V/∂q, with numeric derivatives."""
    body = RigidBody(piper_links(), 0.75)
    _, bias = body.equation(pose, turning)
    ahead, _ = body.equation(pose + 1e-5 * turning, turning)
    behind, _ = body.equation(pose - 1e-5 * turning, turning)
    kinetic = [
        (
            kinetic_energy_j(body, pose + each, turning)
            - kinetic_energy_j(body, pose - each, turning)
        )
        / 2e-5
        for each in NUDGES
    ]
    gravity = body.gravity_torques_nm(pose)
    expected = (ahead - behind) @ turning / 2e-5 - np.array(kinetic) - gravity
    assert bias == pytest.approx(expected, abs=1e-5)


@given(poses)
@settings(max_examples=30, deadline=None)
def test_the_mass_matrix_is_symmetric_and_above_the_rotors(pose) -> None:
    mass, _ = RigidBody(piper_links()).equation(pose, np.zeros(6))
    assert mass == pytest.approx(mass.T, abs=1e-12)
    assert np.linalg.eigvalsh(mass - np.diag(ROTOR_INERTIAS_KG_M2)).min() > -1e-12


def test_the_shoulder_turns_the_stretched_arm_with_the_inertia_of_its_masses() -> None:
    """Upper arm and forearm in one line, as in `test_gravity`: joint 2's own entry.

    Each link's mass times its distance² from the shoulder, and its own inertia across the line.
    """
    pose = np.radians((0, 172.22, 102.78 - 270.0, 0, 0, 0))
    mass, _ = RigidBody(piper_links()).equation(pose, np.zeros(6))
    at_points = (
        1.16 * (0.21852**2 + 0.00861**2)
        + 0.5 * ((0.28503 + 0.14808) ** 2 + (0.02198 + 0.01999 - 0.02198) ** 2)
        + 0.38 * (0.28503 + 0.25075) ** 2
        + 0.383 * (0.28503 + 0.25075 + 0.06104) ** 2
        + 0.007 * (0.28503 + 0.25075 + 0.091) ** 2
    )
    own = 1.16 * (3 * 0.035**2 + 0.28503**2) / 12 + 0.5 * (3 * 0.035**2 + 0.2517**2) / 12
    assert mass[1, 1] == pytest.approx(at_points + own + 0.02, rel=0.02)


def test_a_payload_at_the_flange_is_a_point_mass() -> None:
    """1.5 kg 0.091 m out from joint 5: m·l² more inertia."""
    pose = np.zeros(6)
    empty, loaded = (RigidBody(piper_links(), kg).equation(pose, pose)[0] for kg in (0.0, 1.5))
    assert loaded[4, 4] - empty[4, 4] == pytest.approx(1.5 * 0.091**2, rel=1e-9)
    assert loaded[5, 5] == pytest.approx(empty[5, 5], abs=1e-9)


def test_a_mounting_turns_gravity_and_nothing_else() -> None:
    body, pose = RigidBody(piper_links()), np.radians((20, 90, -60, 10, 20, 30))
    torques = {
        mounting: body.gravity_torques_nm(pose, down) for mounting, down in DOWN_BY_MOUNTING.items()
    }
    level, left, right, upside_down = torques.values()
    assert upside_down == pytest.approx(-np.array(level))
    assert left == pytest.approx(-np.array(right))
    assert level[0] == 0.0
    assert abs(left[0]) > 1.0
    assert math.dist(left, level) > 1.0
