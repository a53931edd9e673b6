"""Finds a tool's tip from poses in which it touched one fixed point, and its orientation apart.

With the rotation R and the place x of the flange in each pose, the tip t in the flange and the
fixed point p in the base fulfil R·t − p = −x. Stacked for at least four poses, that is solved by
least squares. The residual of a pose is the distance between p and where the found tip then was: it
tells how well the poses fit, not how true the tip is.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.refusal import Reason, Refusal
from armui.kinematics.poses import matrix_to_pose, pose_to_matrix

Array = npt.NDArray[np.float64]
Pose = Sequence[float]
"""Six figures of the flange in the base: X, Y, Z in mm, RX, RY, RZ in degrees."""

TOO_FEW_POSES = Reason(
    "too_few_poses", "{count} poses are taken; at least {minimum} are needed. Take another one."
)
POSES_ALIKE = Reason(
    "poses_alike",
    "The poses are too much alike: the condition is {value}, at most {maximum} is possible. The "
    "flange's {axis} axis has pointed {turned}° apart at most; turn it further, by {wanted}° or "
    "more.",
)
POSES_DO_NOT_FIT = Reason(
    "poses_do_not_fit",
    "The poses do not fit together: pose {pose} is {value} mm off, at most {maximum} mm are "
    "allowed. Take that pose again, or leave it out.",
)
POINTS_TOO_NEAR = Reason(
    "points_too_near",
    "The point is {value} mm beside the line it must be off from; at least {minimum} mm are "
    "needed. Choose a point further away.",
)

LEAST_POSES: Final = 4
MOST_POSES: Final = 12
WANTED_DEG: Final = 15.0
"""Each axis of the flange should have pointed this far apart."""
WORST_CONDITION: Final = 1000.0
"""Above this condition number the poses are too much alike to determine a tip."""
DEFAULT_LIMIT_MM: Final = 1.0
_LEAST_OFF_MM: Final = 5.0
_RANK: Final = 6
_AXES: Final = ("X", "Y", "Z")


@dataclass(frozen=True, slots=True)
class Spread:
    """The difference of the orientations of poses, in the direction in which they differ least.

    Attributes:
        axis: The flange's axis nearest to that direction: X, Y or Z.
        turned_deg: The largest angle between two of its directions in the base.
    """

    axis: str
    turned_deg: float

    @property
    def is_enough(self) -> bool:
        """True if the poses are as different as they should be."""
        return self.turned_deg >= WANTED_DEG


@dataclass(frozen=True, slots=True)
class TipFit:
    """A tip that was found.

    Attributes:
        tip_mm: The tip in the flange.
        point_mm: The fixed point in the base.
        residuals_mm: The distance of the tip from that point, by pose.
        condition: The condition number of the equations.
        spread: The differences of the orientations.
    """

    tip_mm: tuple[float, float, float]
    point_mm: tuple[float, float, float]
    residuals_mm: tuple[float, ...]
    condition: float
    spread: Spread

    @property
    def rms_mm(self) -> float:
        """The root of the mean square of the residuals."""
        return math.sqrt(sum(each**2 for each in self.residuals_mm) / len(self.residuals_mm))

    @property
    def largest_mm(self) -> float:
        """The residual of the pose that fits worst."""
        return max(self.residuals_mm)

    def refusal(self, limit_mm: float) -> Refusal | None:
        """Return why the tip may not be taken over, or ``None``.

        Args:
            limit_mm: The largest residual that is allowed.
        """
        if self.condition > WORST_CONDITION:
            shown = f"{self.condition:.0f}" if math.isfinite(self.condition) else "∞"
            return POSES_ALIKE(
                value=shown,
                maximum=round(WORST_CONDITION),
                axis=self.spread.axis,
                turned=round(self.spread.turned_deg, 1),
                wanted=round(WANTED_DEG),
            )
        if self.largest_mm > limit_mm:
            worst = self.residuals_mm.index(self.largest_mm) + 1
            return POSES_DO_NOT_FIT(pose=worst, value=self.largest_mm, maximum=limit_mm)
        return None


def find_tip(poses: Sequence[Pose]) -> TipFit | Refusal:
    """Return the tip that fits poses best, or why there are too few.

    Of poses that do not determine it the condition is infinite or large; :meth:`TipFit.refusal`
    says so.

    Args:
        poses: The flange's, with the tip at one fixed point.
    """
    if len(poses) < LEAST_POSES:
        return TOO_FEW_POSES(count=len(poses), minimum=LEAST_POSES)
    flanges = pose_to_matrix(np.array(poses, dtype=np.float64))
    turns, places = flanges[:, :3, :3], flanges[:, :3, 3]
    minus_ones = np.broadcast_to(-np.eye(3), turns.shape)
    equations = np.concatenate((turns, minus_ones), axis=2).reshape(-1, 6)
    found, _, rank, sizes = np.linalg.lstsq(equations, -places.ravel(), rcond=None)
    condition = math.inf if rank < _RANK else float(sizes[0] / sizes[-1])
    off = (equations @ found + places.ravel()).reshape(-1, 3)
    residuals = np.linalg.norm(off, axis=1)
    x, y, z, px, py, pz = found.tolist()
    return TipFit((x, y, z), (px, py, pz), tuple(residuals.tolist()), condition, spread(poses))


def spread(poses: Sequence[Pose]) -> Spread:
    """Return how different the orientations of at least one pose are."""
    turns = pose_to_matrix(np.array(poses, dtype=np.float64))[:, :3, :3]
    _, _, directions = np.linalg.svd((turns - turns.mean(axis=0)).reshape(-1, 3))
    weakest = directions[-1]
    pointed = turns @ weakest
    turned_deg = math.degrees(math.acos(float(np.clip((pointed @ pointed.T).min(), -1.0, 1.0))))
    return Spread(_AXES[int(np.argmax(np.abs(weakest)))], turned_deg)


def turned_from_deg(pose: Pose, others: Sequence[Pose]) -> float:
    """Return the angle between a pose's orientation and the nearest of others, in degrees."""
    turn = pose_to_matrix(pose)[:3, :3]
    cosines = [(np.trace(pose_to_matrix(each)[:3, :3].T @ turn) - 1.0) / 2.0 for each in others]
    return math.degrees(math.acos(float(np.clip(max(cosines, default=-1.0), -1.0, 1.0))))


def along_axis(flange: Pose, axis: int, direction: int) -> tuple[float, float, float]:
    """Return the orientation of a tool that points along an axis of the base: RX, RY, RZ in °.

    Its Z is that axis; its X is as near to the flange's X as that allows.

    Args:
        flange: The flange's pose while the tool points so.
        axis: 0–2 for X, Y, Z of the base.
        direction: 1 or −1.
    """
    turn = pose_to_matrix(flange)[:3, :3]
    forward = direction * np.eye(3)[axis]
    return _orientation(turn.T @ forward, np.array((1.0, 0.0, 0.0)))


def by_two_points(fit: TipFit, behind: Pose, aside: Pose) -> tuple[float, float, float] | Refusal:
    """Return the orientation of a tool by two more of its points: RX, RY, RZ in degrees.

    Args:
        fit: The tip, with the fixed point that all poses touch.
        behind: The flange's pose while a point of the tool's axis behind the tip, on its shank,
            touches the fixed point: from there to the tip is the tool's Z.
        aside: The flange's pose while a point on the side of the tool's X touches it.
    """
    tip = np.array(fit.tip_mm)
    shank, side = (_touching(pose, np.array(fit.point_mm)) for pose in (behind, aside))
    forward = tip - shank
    length = float(np.linalg.norm(forward))
    if length < _LEAST_OFF_MM:
        return POINTS_TOO_NEAR(value=length, minimum=_LEAST_OFF_MM)
    forward /= length
    beside = side - tip - ((side - tip) @ forward) * forward
    off = float(np.linalg.norm(beside))
    if off < _LEAST_OFF_MM:
        return POINTS_TOO_NEAR(value=off, minimum=_LEAST_OFF_MM)
    return _orientation(forward, beside)


def _touching(flange: Pose, point: Array) -> Array:
    """Return where in the flange a point of the base is."""
    matrix = pose_to_matrix(flange)
    place: Array = matrix[:3, :3].T @ (point - matrix[:3, 3])
    return place


def _orientation(forward: Array, near_x: Array) -> tuple[float, float, float]:
    """Return the orientation with a given Z, whose X is as near as possible to a direction."""
    x = near_x - (near_x @ forward) * forward
    if np.linalg.norm(x) < 1e-6:  # parallel to Z: take an X that keeps the flange's Y
        x = np.cross(np.array((0.0, 1.0, 0.0)), forward)
    x /= np.linalg.norm(x)
    matrix = np.eye(4)
    matrix[:3, :3] = np.column_stack((x, np.cross(forward, x), forward))
    *_, rx, ry, rz = matrix_to_pose(matrix)
    return rx, ry, rz
