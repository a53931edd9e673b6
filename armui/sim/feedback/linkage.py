"""The commands that a teaching-input arm sends, instead of feedback, to the arm that follows it."""

from __future__ import annotations

import math
from typing import Final

from armui.arm.limits import JOINTS
from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec
from armui.protocol.codes import ControlMode, MoveMode
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.feedback.frame_cache import FrameCache
from armui.sim.mechanics.gripper import SimulatedGripper
from armui.sim.mechanics.powered_joints import SixValues

CONTROL: Final = frozenset(
    (
        *("MotionCommand", "ModeControl", "ArcPoint", "GripperCommand", "MotorEnable"),
        *("CartesianTarget1", "CartesianTarget2", "CartesianTarget3"),
        *("JointTarget12", "JointTarget34", "JointTarget56"),
        *(f"MitControl{joint}" for joint in JOINTS),
    )
)
"""The host's commands, as opposed to its settings and questions: a teaching input obeys none."""

_FULL_SPEED_PERCENT: Final = 100
_GRIPPER_TORQUE_NM: Final = 1.0
_GRIPPER_SPEED_RAD_S: Final = math.pi


class LinkedInput:
    """The commands of a teaching input arm (0x470): 0x151, 0x155–0x157 and 0x159.

    They have the follower's identifiers: shifted by byte 3 of 0x470.
    """

    def __init__(self, generation: Generation, target_offset: int) -> None:
        self._cache = FrameCache(Codec(generation, Addressing(control_offset=target_offset)))

    def frames(self, joints_deg: SixValues, gripper: SimulatedGripper) -> list[Frame]:
        """The frames that send the follower to where this arm is."""
        cache = self._cache
        return [
            cache.frame(
                "ModeControl",
                ControlMode=ControlMode.CAN_CONTROL,
                MoveMode=MoveMode.MOVE_J,
                SpeedPercent=_FULL_SPEED_PERCENT,
            ),
            *(
                cache.frame(
                    f"JointTarget{joint}{joint + 1}",
                    **{f"J{joint}": joints_deg[joint - 1], f"J{joint + 1}": joints_deg[joint]},
                )
                for joint in JOINTS[::2]
            ),
            cache.frame(
                "GripperCommand",
                **gripper.place,
                Torque=_GRIPPER_TORQUE_NM,
                Speed=_GRIPPER_SPEED_RAD_S,
                Enable=1,
            ),
        ]
