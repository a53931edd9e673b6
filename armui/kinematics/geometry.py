"""The dimensions of an arm: its modified (Craig) DH table, and the lengths for the closed forms.

All arms of the family have a shoulder above the table, where joints 1 and 2 cross, and a bar from
it to the elbow; joints 2 and 3 are parallel. Beyond the elbow there are two kinds (`Wrist`).
"""

from __future__ import annotations

import enum
import math
from collections.abc import Iterable, Sequence
from typing import Final, NamedTuple

MIDDLES_DEG: Final = (0.0, 90.0, -85.0, 0.0, 0.0, 0.0)
"""The middles of the joints' factory ranges, the same for every arm of the family."""

JOINT_COUNT: Final = 6


class DhRow(NamedTuple):
    """One row of a modified DH table: from the frame before to the frame of a joint.

    Attributes:
        a_mm: The length along the X axis of the frame before.
        alpha_deg: The turn about it.
        d_mm: The length along the joint's own axis.
        theta_deg: The turn about it, added to the joint's angle.
    """

    a_mm: float
    alpha_deg: float
    d_mm: float
    theta_deg: float


class Wrist(enum.Enum):
    """The arrangement of joints 4–6: α and fixed θ of the DH table in degrees, joint 1 first."""

    SPHERICAL = ((0.0, -90.0, 0.0, 90.0, -90.0, 90.0), (0.0, None, None, 0.0, 0.0, 0.0))
    """The axes meet in one place; joint 4 turns about the forearm."""
    PARALLEL = ((0.0, 90.0, 0.0, 0.0, -90.0, 90.0), (180.0, None, None, None, 90.0, 0.0))
    """Joint 4 is parallel to joints 2 and 3; the axes of joints 5 and 6 meet beyond it."""


_A_OF: Final = {Wrist.SPHERICAL: {2, 3}, Wrist.PARALLEL: {2, 3, 4}}
_D_OF: Final = {Wrist.SPHERICAL: {0, 3, 5}, Wrist.PARALLEL: {0, 5}}
"""The DH rows whose a and d may differ from 0."""


class GeometryError(ValueError):
    """A DH table for which there is no closed form here."""


class Geometry(NamedTuple):
    """An arm's dimensions, made by `from_dh`.

    Attributes:
        rows: The modified DH table, joint 1 first.
        wrist: The kind of wrist.
        base_mm: The height of the shoulder above the table, where the axes of joints 1 and 2 cross.
        upper_arm_mm: From the shoulder to the elbow.
        elbow_mm: The forearm's offset from the elbow, square to it in the arm's plane; 0 with a
            parallel wrist.
        forearm_mm: Along the forearm from there to the wrist's centre; with a parallel wrist to
            the axis of joint 4.
        wrist_mm: From the axis of joint 4 to that of joint 5; 0 with a spherical wrist.
        hand_mm: From the wrist's centre, where the axes of joints 5 and 6 meet, to the flange.
        plane_zeros_deg: The degrees added to joints 2, 3 and 4 to get the angles in the arm's
            plane, as `forward` counts them; joint 4 of a spherical wrist turns about the forearm.
    """

    rows: tuple[DhRow, ...]
    wrist: Wrist
    base_mm: float
    upper_arm_mm: float
    elbow_mm: float
    forearm_mm: float
    wrist_mm: float
    hand_mm: float
    plane_zeros_deg: tuple[float, float, float]

    @classmethod
    def from_dh(cls, rows: Iterable[Sequence[float]]) -> Geometry:
        """Return the geometry of a DH table.

        Args:
            rows: Six rows of a in mm, α in degrees, d in mm, θ offset in degrees.

        Raises:
            GeometryError: The table fits no arm of this family.
        """
        table = tuple(DhRow(*map(float, row)) for row in rows)
        wrist = _kind(table)
        a, d, theta = ([row[column] for row in table] for column in (0, 2, 3))
        if wrist is Wrist.SPHERICAL:
            lengths = (a[3], d[3], 0.0)
            zeros = (theta[1], theta[2], 0.0)
        else:
            lengths = (0.0, a[3], a[4])
            zeros = (theta[1] - 180.0, theta[2], theta[3])
        return cls(table, wrist, d[0], a[2], *lengths, d[5], zeros)

    def with_zeros(self, shifts_deg: Sequence[float]) -> Geometry:
        """Return the same arm with other zeros of its joints.

        Args:
            shifts_deg: The degrees added to the θ offsets of the six joints.
        """
        return Geometry.from_dh(
            row._replace(theta_deg=row.theta_deg + shift)
            for row, shift in zip(self.rows, shifts_deg, strict=True)
        )

    @property
    def elbow_to_wrist_mm(self) -> float:
        """The length of the straight line from the elbow to the end of the forearm."""
        return math.hypot(self.elbow_mm, self.forearm_mm)


def _kind(rows: tuple[DhRow, ...]) -> Wrist:
    if len(rows) != JOINT_COUNT:
        raise GeometryError(f"a DH table of {len(rows)} rows is no arm of {JOINT_COUNT} joints")
    if not all(math.isfinite(figure) for row in rows for figure in row):
        raise GeometryError("a DH table holds something that is no number")
    for wrist in Wrist:
        alphas, thetas = wrist.value
        if all(
            row.alpha_deg == alpha
            and theta in {None, row.theta_deg}
            and (row.a_mm == 0.0 or index in _A_OF[wrist])
            and (row.d_mm == 0.0 or index in _D_OF[wrist])
            for index, (row, alpha, theta) in enumerate(zip(rows, alphas, thetas, strict=True))
        ):
            break
    else:
        raise GeometryError(f"no closed form for the DH table {[tuple(row) for row in rows]}")
    lengths = (rows[2].a_mm, rows[3].a_mm if wrist is Wrist.PARALLEL else rows[3].d_mm)
    if min(lengths) <= 0.0:
        raise GeometryError(f"upper arm and forearm of {lengths} mm: both must be longer than 0")
    return wrist
