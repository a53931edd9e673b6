"""The place of the arm's base in the room, and what follows from it.

The room's frame has its Z axis up and its origin on the floor. Areas, user frames and whatever is
sent stay given in the base.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from armui.arm.models import STANDING, Rising
from armui.arm.refusal import Refusal
from armui.cell.checks import check_pose
from armui.cell.user_frames import FURTHEST_MM, NO_FRAME, UserFrame
from armui.protocol.codes import Mounting

WORLD: Final = "WORLD"
"""The name of the room's frame in the list of user frames, in every language."""
_UPS: Final = {
    Mounting.LEVEL: (0.0, 0.0, 1.0),
    Mounting.ON_THE_LEFT_SIDE: (0.0, -1.0, 0.0),
    Mounting.ON_THE_RIGHT_SIDE: (0.0, 1.0, 0.0),
    Mounting.UPSIDE_DOWN: (0.0, 0.0, -1.0),
}
"""The direction of up in the base frame, for each mounting."""
_SAME_COSINE: Final = 0.94
"""The cosine of 20°: an arm tilted by less than that still counts as mounted so."""


@dataclass(frozen=True, slots=True)
class Placement:
    """The place of the base in the room.

    Attributes:
        pose: The base in the room: X, Y, Z in mm, RX, RY, RZ in degrees; zeros if it is not placed:
            then it stands upright on the floor, and there is no frame of the room.
    """

    pose: tuple[float, ...] = NO_FRAME

    @property
    def is_set(self) -> bool:
        """True if the base is placed."""
        return any(self.pose)

    @property
    def rising(self) -> Rising:
        """The rise of each axis of the base in the room, and the height of the base in mm."""
        return _rising(self.pose) if self.is_set else STANDING

    @property
    def world(self) -> UserFrame | None:
        """The frame of the room in the base, or ``None`` if the base is not placed."""
        return UserFrame(WORLD, _inverse(self.pose)) if self.is_set else None

    @property
    def mounting(self) -> Mounting | None:
        """The mounting to tell the arm; ``None`` if none that it knows is within 20°."""
        for mounting, up in _UPS.items():
            cosine = sum(one * other for one, other in zip(self.rising, up, strict=False))
            if cosine > _SAME_COSINE:
                return mounting
        return None


def check_placement(placement: Placement) -> Refusal | None:
    """Return why the figures of a placement are not possible, or ``None``."""
    return check_pose("placement", placement.pose, FURTHEST_MM)


@lru_cache(maxsize=16)
def _rising(pose: tuple[float, ...]) -> Rising:
    from armui.kinematics.poses import pose_to_matrix  # noqa: PLC0415 - numpy

    x, y, z, height_mm = pose_to_matrix(pose)[2].tolist()
    return (x, y, z, height_mm)


@lru_cache(maxsize=16)
def _inverse(pose: tuple[float, ...]) -> tuple[float, ...]:
    # imported here, because the window starts without numpy
    import numpy as np  # noqa: PLC0415

    from armui.kinematics.poses import matrix_to_pose, pose_to_matrix  # noqa: PLC0415

    return tuple(matrix_to_pose(np.linalg.inv(pose_to_matrix(pose)).astype(np.float64)))
