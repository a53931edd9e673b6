"""The role beside another arm (0x470): when it takes effect, and what a leader sends."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JOINTS
from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec
from armui.protocol.codes import ControlMode, LeaderZero, LinkageRole, MoveMode
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.feedback import FrameCache
from armui.sim.mechanics.gripper import SimulatedGripper
from armui.sim.mechanics.powered_joints import STANDSTILL, SixValues
from armui.sim.parameters.settings import LinkageSettings

if TYPE_CHECKING:
    from armui.sim.condition import Condition
    from armui.sim.mechanics.mechanics import HandGuiding, Mechanics
    from armui.sim.parameters.flash import Flash
    from armui.sim.parameters.settings import ArmSettingsRecord


CONTROL: Final = frozenset(
    (
        *("MotionCommand", "ModeControl", "ArcPoint", "GripperCommand", "MotorEnable"),
        *("CartesianTarget1", "CartesianTarget2", "CartesianTarget3"),
        *("JointTarget12", "JointTarget34", "JointTarget56"),
        *(f"MitControl{joint}" for joint in JOINTS),
    )
)
"""The host's commands, as opposed to settings and questions; a teaching input obeys none of them.
"""

_FULL_SPEED_PERCENT: Final = 100
_GRIPPER_TORQUE_NM: Final = 1.0
_GRIPPER_SPEED_RAD_S: Final = math.pi

_TO_ZERO_SHARE: Final = 0.2
"""The share of the joints' highest speeds with which a leader moves to its zero."""


class LinkedInput:
    """The commands of a teaching input arm (0x470): 0x151, 0x155–0x157 and 0x159.

    They have the follower's identifiers: shifted by byte 3 of 0x470.
    """

    def __init__(self, generation: Generation, target_offset: int) -> None:
        self._cache = FrameCache(Codec(generation, Addressing(control_offset=target_offset)))

    def frames(self, joints_deg: SixValues, gripper: SimulatedGripper) -> list[Frame]:
        """Return the frames that send the follower to this arm's position."""
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


@dataclass(eq=False, repr=False)
class ArmRole:
    """Makes an arm a teaching input or a motion output.

    Attributes:
        generation: The protocol it speaks.
        mechanics: Its joints, which give way as a teaching input.
        condition: Its modes.
        settings: The values it keeps; the role is one.
        hand: The hand that leads it.
        flash: The storage of its settings.
        drop_targets: Drops the arm's targets.
        speak: Switches to the identifiers in the settings.
        leader: The frames of a teaching input; None while the arm is none.
    """

    generation: Generation
    mechanics: Mechanics
    condition: Condition
    settings: ArmSettingsRecord
    hand: HandGuiding
    flash: Flash
    drop_targets: Callable[[], None]
    speak: Callable[[], None]
    _waits: bool = field(default=False, init=False)
    _is_quiet: bool = field(default=False, init=False)
    leader: LinkedInput | None = field(default=None, init=False)

    def take_effect(self) -> None:
        """Applies the stored setting: the identifiers and the role."""
        linkage = self.settings.linkage
        self._waits = self._is_quiet = False
        self.speak()
        if linkage.role is LinkageRole.TEACHING_INPUT:
            self.drop_targets()
            self.leader = LinkedInput(self.generation, linkage.target_offset)
            self.condition.control_mode = ControlMode.LINKED_TEACHING_INPUT
            self.mechanics.give_way(self.hand)
        elif self.leader is not None:
            self.leader = None
            self.condition.control_mode = ControlMode.STANDBY
            self.mechanics.hold()

    def set(self, linkage: LinkageSettings) -> None:
        """Stores a setting.

        It takes effect at once in standby or as a teaching input, else as soon as in standby.
        """
        self.settings.linkage = linkage
        self.flash.save(self.settings)
        self._waits = True
        standby = self.condition.control_mode is ControlMode.STANDBY
        if self.leader is not None or (standby and not self.condition.stopped):
            self.take_effect()

    def mode_entered(self) -> None:
        """Applies a waiting setting when the arm has entered standby."""
        if self._waits and self.condition.control_mode is ControlMode.STANDBY:
            self.take_effect()

    def zero(self, command: LeaderZero) -> None:
        """Obeys 0x191 as a leader.

        The arm moves to its zero by itself, with the follower or without, or gives way to the hand
        again. Its speed is assumed; no answer is known.
        """
        if self.leader is None:
            return
        if command is LeaderZero.LEADER_AND_FOLLOWER:
            self._is_quiet = False
            self.mechanics.give_way(self.hand)
            return
        self._is_quiet = command is LeaderZero.LEADER_TO_ZERO
        settings = self.settings
        self.mechanics.hold()
        self.mechanics.move_to(
            STANDSTILL,
            [_TO_ZERO_SHARE * limits.max_speed_deg_s for limits in settings.limits],
            settings.accelerations_deg_s2,
        )

    def leader_frames(self, gripper: SimulatedGripper) -> list[Frame]:
        """Return the frames that a leader now sends to its follower."""
        if self.leader is None or self._is_quiet:
            return []
        return self.leader.frames(self.mechanics.positions_deg, gripper)
