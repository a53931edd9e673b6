"""Trajectories that fill the library in pictures."""

from typing import Any

import numpy as np

from armui.protocol.codes import MoveMode
from armui.trajectory.points.program import GripperOpening, LightAction, Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording


def _joints(*angles_deg: float, **more: Any) -> Waypoint:
    return Waypoint(MoveMode.MOVE_J, angles_deg, **more)


_PICK = (
    _joints(20.0, 60.0, -50.0, 10.0, 20.0, 15.0, speed_percent=60, note="above the tray"),
    Waypoint(MoveMode.MOVE_P, (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)),
    Waypoint(
        MoveMode.MOVE_L,
        (300.0, 0.0, 200.0, 0.0, 85.0, 0.0),
        speed_percent=10,
        dwell_s=0.5,
        gripper=GripperOpening(35.0),
        note="take it",
    ),
    Waypoint(MoveMode.MOVE_L, (300.0, 0.0, 250.0, 0.0, 85.0, 0.0), speed_percent=20),
    Waypoint(
        MoveMode.MOVE_C,
        (300.0, 100.0, 250.0, 0.0, 85.0, 0.0),
        (320.0, 50.0, 250.0, 0.0, 85.0, 0.0),
        light=LightAction(1, 255, 128, 0),
        note="round the pillar",
    ),
    _joints(-15.0, 50.0, -40.0, -10.0, 30.0, -20.0, dwell_s=1.5, gripper=GripperOpening(70.0)),
)
_AWAY = Waypoint(MoveMode.MOVE_P, (900.0, 0.0, 200.0, 0.0, 85.0, 0.0), note="too far")


def _waves() -> np.ndarray:
    times_s = np.arange(0.0, 12.0, 0.01)[:, None]
    swing = 15.0 * np.sin(times_s * np.arange(1, 7) / 3.0)
    middle = np.array([0.0, 60.0, -60.0, 0.0, 20.0, 0.0])
    return np.hstack([times_s, middle + swing, np.full_like(times_s, 30.0)])


SAMPLES = (
    Trajectory("Pick and place", "from the tray to the belt", _PICK),
    Trajectory("Warm up", "every joint through its range", _PICK[:1] * 24),
    Trajectory("Out of reach", "for a picture of a failed check", (*_PICK[:2], _AWAY, _PICK[0])),
    Recording("By hand", "led once along the seam", _waves()),
)
"""Two for work, one that cannot be, and a recording."""
