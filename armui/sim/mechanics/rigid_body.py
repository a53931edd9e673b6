"""The arm as six rigid links: inertia, gravity and the forces of its own motion.

Everything is computed in the base frame, for all six links at once: the places of the links, the
motion of their centres of mass with each joint, and from these the joint-space equation of motion

    (mass matrix) · (accelerations) + (bias torques) = (torques of the drivers, friction, stops).

Masses and centres of mass come from the model. Its inertia tensors cannot be used (they are not
those of the stated masses), so each link is modelled as a uniform solid cylinder along the line
from its joint to the next. The rotor of each motor adds its own inertia, multiplied by the gear.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.models import ModelData, model_data
from armui.kinematics.geometry import Geometry
from armui.protocol.generation import PiperModel

Values = npt.NDArray[np.float64]

G_M_S2: Final = 9.81
DOWN: Final = (0.0, 0.0, -1.0)
"""The direction of gravity for an arm that stands level, in its base frame."""

LINK_RADIUS_M: Final = 0.035
"""Half the thickness of the arm's links; assumed."""

SHORTEST_LINK_M: Final = 0.06
"""The length of the body of a joint whose axis meets the next one's; assumed."""

ROTOR_INERTIAS_KG_M2: Final = (0.02, 0.02, 0.02, 0.005, 0.005, 0.005)
"""The inertia that rotor and gear of each joint add to its own entry of the mass matrix; assumed.
"""

_CROSS: Final = np.array(
    [
        [[0, 0, 0], [0, 0, -1], [0, 1, 0]],
        [[0, 0, 1], [0, 0, 0], [-1, 0, 0]],
        [[0, -1, 0], [1, 0, 0], [0, 0, 0]],
    ],
    dtype=float,
).reshape(3, 9)
"""A tensor that turns a vector v into the matrix [v] with [v]·w = v × w."""


_AXES: Final = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@dataclass(frozen=True, slots=True)
class RigidLink:
    """One link and the joint that turns it.

    Attributes:
        a_mm, alpha_deg, d_mm, theta_deg: Its row of the modified DH table (Craig).
        mass_kg: Its mass.
        centre_mm: Its centre of mass in its own DH frame.
        rotor_kg_m2: Inertia of the motor's rotor at the joint.
    """

    a_mm: float
    alpha_deg: float
    d_mm: float
    theta_deg: float
    mass_kg: float
    centre_mm: tuple[float, float, float]
    rotor_kg_m2: float


class RigidBody:
    """A chain of rigid links on a base that stands still. Angles in radians, lengths in metres."""

    def __init__(self, links: Sequence[RigidLink], payload_kg: float = 0.0) -> None:
        """Creates an arm with a point mass at its flange, the origin of the last link's frame."""
        alphas = np.radians([link.alpha_deg for link in links])
        cos, sin = np.cos(alphas), np.sin(alphas)
        lengths, offsets = (
            np.array([getattr(link, name) for link in links]) / 1e3 for name in ("a_mm", "d_mm")
        )
        self._thetas = np.radians([link.theta_deg for link in links])
        self._steps = np.stack((lengths, -sin * offsets, cos * offsets), axis=1)[..., None]
        count = len(links)
        self._fixed, self._by_cos, self._by_sin = np.zeros((3, count, 3, 3))
        self._fixed[:, 1, 2], self._fixed[:, 2, 2] = -sin, cos
        self._by_cos[:, 0, 0], self._by_cos[:, 1, 1], self._by_cos[:, 2, 1] = 1.0, cos, sin
        self._by_sin[:, 0, 1], self._by_sin[:, 1, 0], self._by_sin[:, 2, 0] = -1.0, cos, sin
        self._rotors = np.array([link.rotor_kg_m2 for link in links])
        self._masses = np.array([link.mass_kg for link in links])
        self._centres = np.array([link.centre_mm for link in links])[..., None] / 1e3
        inertias = [
            _cylinder(link.mass_kg, tip) for link, tip in zip(links, self._tips(), strict=True)
        ]
        if payload_kg:
            inertias[-1] = inertias[-1] + self._hang(payload_kg)
        self._roots = np.linalg.cholesky(np.array(inertias))
        self._mass_roots = np.sqrt(self._masses)[:, None, None]
        self._moved = np.tril(np.ones((count, count)))[..., None]
        self._rows = list(
            zip(
                *(each.tolist() for each in (self._thetas, cos, sin, self._masses)),
                *(each[..., 0].tolist() for each in (self._steps, self._centres)),
                strict=True,
            )
        )

    def gravity_torques_nm(
        self, joints_rad: Iterable[float], down: Sequence[float] = DOWN
    ) -> tuple[float, ...]:
        """Return the torque with which gravity turns each joint; positive towards larger angles.

        It is computed at each step of a moving arm: 7 µs with plain floats, 50 µs with arrays.

        Args:
            joints_rad: (6,) joint angles.
            down: The direction of gravity, a unit vector in the base frame.
        """
        (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = _AXES  # the link's axes in the base frame
        x = y = z = 0.0
        joints = []
        for angle, row in zip(joints_rad, self._rows, strict=True):
            theta, cos, sin, mass_kg, (sx, sy, sz), (cx, cy, cz) = row
            x += sx * xx + sy * yx + sz * zx
            y += sx * xy + sy * yy + sz * zy
            z += sx * xz + sy * yz + sz * zz
            c, s = math.cos(angle + theta), math.sin(angle + theta)
            ux, uy, uz = cos * yx + sin * zx, cos * yy + sin * zy, cos * yz + sin * zz
            zx, zy, zz = cos * zx - sin * yx, cos * zy - sin * yy, cos * zz - sin * yz
            yx, yy, yz = c * ux - s * xx, c * uy - s * xy, c * uz - s * xz
            xx, xy, xz = c * xx + s * ux, c * xy + s * uy, c * xz + s * uz
            centre = (
                x + cx * xx + cy * yx + cz * zx,
                y + cx * xy + cy * yy + cz * zy,
                z + cx * xz + cy * yz + cz * zz,
            )
            joints.append(((zx, zy, zz), (x, y, z), mass_kg, centre))
        gx, gy, gz = (G_M_S2 * part for part in down)
        torques = []
        carried_kg = mx = my = mz = 0.0  # the mass beyond a joint, and its first moment
        for (ax, ay, az), (x, y, z), mass_kg, (cx, cy, cz) in reversed(joints):
            carried_kg += mass_kg
            mx, my, mz = mx + mass_kg * cx, my + mass_kg * cy, mz + mass_kg * cz
            rx, ry, rz = mx - carried_kg * x, my - carried_kg * y, mz - carried_kg * z
            torque_nm = ax * (ry * gz - rz * gy) + ay * (rz * gx - rx * gz)
            torques.append(torque_nm + az * (rx * gy - ry * gx))
        return tuple(reversed(torques))

    def equation(
        self, joints_rad: Values, speeds_rad_s: Values, down: Sequence[float] = DOWN
    ) -> tuple[Values, Values]:
        """Return the mass matrix, and the torques needed to keep these speeds.

        Args:
            joints_rad: (6,) joint angles.
            speeds_rad_s: (6,) joint speeds.
            down: The direction of gravity, a unit vector in the base frame.

        Returns:
            (6, 6) kg·m² and (6,) N·m: gravity, centrifugal and Coriolis torques.
        """
        axes, places, turns, steps, centres = self._place(joints_rad)
        lever = self._levers(axes, places, centres)
        roots = turns @ self._roots
        spin = np.matmul(axes[None, :, :], roots) * self._moved
        by_joint = np.concatenate((lever * self._mass_roots, spin), axis=2).transpose(1, 0, 2)
        by_joint = by_joint.reshape(len(axes), -1)
        mass_matrix = by_joint @ by_joint.T
        mass_matrix.flat[:: len(axes) + 1] += self._rotors

        own = axes * speeds_rad_s[:, None]
        omega = own.cumsum(axis=0)
        omega_before = omega - own
        change = np.matmul(_crosses(omega_before), own[..., None])[..., 0]
        alpha = change.cumsum(axis=0)
        of_omega = _crosses(omega)
        field = _crosses(alpha) + of_omega @ of_omega
        jerks = np.zeros_like(places)
        jerks[1:] = np.matmul(field[:-1], steps[1:, :, None])[..., 0]
        pulls = jerks.cumsum(axis=0)
        pulls += np.matmul(field, (centres - places)[..., None])[..., 0]
        pulls -= G_M_S2 * np.asarray(down)
        inertias = roots @ roots.transpose(0, 2, 1)
        twists = np.matmul(inertias, alpha[..., None])
        twists += of_omega @ np.matmul(inertias, omega[..., None])
        beyond = twists[::-1, :, 0].cumsum(axis=0)[::-1]
        bias = np.einsum("ija,ia->j", lever, pulls * self._masses[:, None])
        bias += (axes * beyond).sum(axis=1)
        return mass_matrix, bias

    def _place(self, joints_rad: Values) -> tuple[Values, Values, Values, Values, Values]:
        """Return axes, origins, rotations, steps from origin to origin, and centres of mass."""
        angles = (joints_rad + self._thetas)[:, None, None]
        local = self._fixed + np.cos(angles) * self._by_cos + np.sin(angles) * self._by_sin
        turns = np.empty_like(local)
        steps = np.empty_like(self._steps)
        turn = np.eye(3)
        for index, each in enumerate(local):
            steps[index] = turn @ self._steps[index]
            turns[index] = turn = turn @ each
        flat = steps[..., 0]
        places = flat.cumsum(axis=0)
        centres = places + (turns @ self._centres)[..., 0]
        return turns[:, :, 2], places, turns, flat, centres

    def _levers(self, axes: Values, places: Values, centres: Values) -> Values:
        """Return (link, joint, 3): how each centre of mass moves with each joint, in m/rad."""
        arms = (centres[:, None, :] - places[None, :, :])[..., None]
        lever: Values = np.matmul(_crosses(axes)[None], arms)[..., 0] * self._moved
        return lever

    def _tips(self) -> Values:
        """Return (6, 3) m: from each joint to the next in the link's own frame; the last is 0."""
        tips = np.zeros((len(self._steps), 3))
        tips[:-1] = self._steps[1:, :, 0]
        return tips

    def _hang(self, payload_kg: float) -> Values:
        """Adds a point mass at the flange; returns the inertia it adds about the new centre."""
        mass_kg = float(self._masses[-1])
        centre = self._centres[-1, :, 0].copy()
        whole_kg = mass_kg + payload_kg
        self._masses[-1] = whole_kg
        self._centres[-1] *= mass_kg / whole_kg
        reduced_kg = mass_kg * payload_kg / whole_kg
        added: Values = reduced_kg * (centre @ centre * np.eye(3) - np.outer(centre, centre))
        return added


def _crosses(vectors: Values) -> Values:
    """Return (n, 3, 3) matrices of the cross products with (n, 3) vectors."""
    matrices: Values = (vectors @ _CROSS).reshape(-1, 3, 3)
    return matrices


def _cylinder(mass_kg: float, tip_m: Values) -> Values:
    """Return the inertia of a solid cylinder about its own centre, lying along a line in its frame.

    One without length lies along the joint's own axis, z.
    """
    length_m = math.sqrt(float(tip_m @ tip_m))
    along = tip_m / length_m if length_m > 1e-6 else np.array((0.0, 0.0, 1.0))
    length_m = max(length_m, SHORTEST_LINK_M)
    across = mass_kg * (3.0 * LINK_RADIUS_M**2 + length_m**2) / 12.0
    axial = mass_kg * LINK_RADIUS_M**2 / 2.0
    inertia: Values = across * np.eye(3) + (axial - across) * np.outer(along, along)
    return inertia


def rigid_links(model: ModelData, geometry: Geometry) -> tuple[RigidLink, ...]:
    """Return the six moving links; the base stands still.

    Args:
        model: The model with the masses and their centres.
        geometry: The model's geometry, with the zeros that the arm's firmware counts from.
    """
    return tuple(
        RigidLink(*row, link.mass_kg, link.centre_mm, rotor_kg_m2)
        for row, link, rotor_kg_m2 in zip(
            geometry.rows, model.links[1:], ROTOR_INERTIAS_KG_M2, strict=True
        )
    )


@cache
def piper_links() -> tuple[RigidLink, ...]:
    """Return the links of the PiPER with the zeros of today's firmware."""
    model = model_data(PiperModel.PIPER)
    return rigid_links(model, model.geometry)
