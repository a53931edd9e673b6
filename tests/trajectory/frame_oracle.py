"""An oracle for poses in frames: scipy's rotations, and none of the program's own."""

from collections.abc import Sequence

import numpy as np
from scipy.spatial.transform import Rotation


def turn(pose: Sequence[float]) -> Rotation:
    """The rotation of a pose: Rz(rz)·Ry(ry)·Rx(rx)."""
    return Rotation.from_euler("xyz", pose[3:], degrees=True)


def carried(frame: Sequence[float], pose: Sequence[float]) -> tuple[float, ...]:
    """A pose in a frame as a pose in the base."""
    place = turn(frame).apply(pose[:3]) + frame[:3]
    return (*place, *(turn(frame) * turn(pose)).as_euler("xyz", degrees=True))


def within(frame: Sequence[float], pose: Sequence[float]) -> tuple[float, ...]:
    """A pose in the base as a pose in a frame."""
    back = turn(frame).inv()
    place = back.apply(np.subtract(pose[:3], frame[:3]))
    return (*place, *(back * turn(pose)).as_euler("xyz", degrees=True))


def apart(one: Sequence[float], other: Sequence[float]) -> tuple[float, float]:
    """How far two poses are apart, in mm and degrees."""
    off = (turn(one).inv() * turn(other)).magnitude()
    return float(np.linalg.norm(np.subtract(one[:3], other[:3]))), float(np.degrees(off))
