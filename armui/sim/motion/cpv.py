"""CPV control (MOVE CPV, from S-V1.8-1): each joint separately, by position or speed.

Frames 0x181–0x186 write and read a joint's target and parameters; a read is answered under the same
identifier. The maker does not publish everything; assumed are the factory values, that joint limits
bound the targets, that the loop gains change nothing (the profile is followed exactly), and that
zero learning leaves the zero where it is.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from typing import Final

from armui.arm.limits import JOINTS, JointLimits
from armui.protocol.codec import Codec
from armui.protocol.codes import CpvAction, CpvKind, MoveMode
from armui.protocol.firmware_version import FirmwareQuirks
from armui.protocol.frame import Frame
from armui.sim.condition import Condition
from armui.sim.mechanics.mechanics import Mechanics
from armui.sim.mechanics.powered_joints import JOINT_COUNT, SixValues
from armui.sim.parameters.settings import ArmSettingsRecord

NAMES: Final = (*(f"CpvControl{joint}" for joint in JOINTS), "CpvGripper")
"""The names of the frames 0x181–0x187."""

_SIGNALS: Final = {
    CpvKind.POSITION_TARGET: "PositionTarget",
    CpvKind.SPEED_TARGET: "SpeedTarget",
    CpvKind.ACCELERATION: "Acceleration",
    CpvKind.DECELERATION: "Deceleration",
    CpvKind.PROFILE_SPEED: "ProfileSpeed",
    CpvKind.POSITION_KP: "PositionKp",
    CpvKind.SPEED_KP: "SpeedKp",
    CpvKind.SPEED_KI: "SpeedKi",
    CpvKind.ZERO_LEARNING: "ZeroLearning",
}
_FACTORY: Final = {
    CpvKind.POSITION_TARGET: 0.0,
    CpvKind.SPEED_TARGET: 0.0,
    CpvKind.ACCELERATION: 5.0,
    CpvKind.DECELERATION: 5.0,
    CpvKind.PROFILE_SPEED: 3.0,
    CpvKind.POSITION_KP: 10.0,
    CpvKind.SPEED_KP: 1.0,
    CpvKind.SPEED_KI: 0.1,
}
"""The factory values, assumed, in the units of the frames; speed and acceleration are the joints'
rated ones.
"""
_POSITIVE: Final = (CpvKind.ACCELERATION, CpvKind.DECELERATION, CpvKind.PROFILE_SPEED)
_LEAST: Final = 0.01


class JointProfile:
    """The motion of one joint to a position, or at a speed; angles in degrees.

    Attributes:
        angle: The joint's angle.
        speed: Its speed in °/s.
        acceleration: Its acceleration in °/s².
    """

    def __init__(self, angle: float) -> None:
        self.angle = angle
        self.speed = 0.0
        self.acceleration = 0.0
        self._goal: float | None = None
        self._wanted_speed = 0.0

    @property
    def moving(self) -> bool:
        """True if the joint turns or is about to."""
        if self._goal is not None:
            return self.speed != 0.0 or self.angle != self._goal
        return self.speed != 0.0 or self._wanted_speed != 0.0

    def go_to(self, goal: float) -> None:
        """Moves to a position."""
        self._goal = goal

    def turn(self, speed: float) -> None:
        """Turns at a speed; 0 halts."""
        self._goal, self._wanted_speed = None, speed

    def step(
        self, dt_s: float, top: float, speeding_up: float, slowing: float, limits: JointLimits
    ) -> None:
        """Advances in time.

        Args:
            dt_s: The time to advance.
            top: The highest speed on the way to a position.
            speeding_up: Highest acceleration.
            slowing: Highest deceleration.
            limits: The joint's limits: it stops in time before them; a joint beyond one may come
                back.
        """
        low, high = min(limits.min_deg, self.angle), max(limits.max_deg, self.angle)
        if self._goal is not None:
            wanted = self._approach(self._goal, top, slowing, dt_s)
        else:
            end = high if self._wanted_speed > 0.0 else low
            most = abs(self._approach(end, abs(self._wanted_speed), slowing, dt_s))
            wanted = math.copysign(min(abs(self._wanted_speed), most), self._wanted_speed)
        faster = abs(wanted) > abs(self.speed) and wanted * self.speed >= 0.0
        change = (speeding_up if faster else slowing) * dt_s
        before = self.speed
        self.speed += min(max(wanted - self.speed, -change), change)
        there = self.angle + (before + self.speed) / 2.0 * dt_s
        goal = self._goal
        if goal is not None and abs(goal - there) < 1e-3 and abs(self.speed) <= change:
            there, self.speed = goal, 0.0
        elif not low <= there <= high:
            there, self.speed = min(max(there, low), high), 0.0
            self._wanted_speed = 0.0
        self.acceleration = (self.speed - before) / dt_s
        self.angle = there

    def _approach(self, goal: float, top: float, slowing: float, dt_s: float) -> float:
        """Return the highest speed after this step from which it can still stop at the goal."""
        way = goal - self.angle
        # The way left after this step, gone at the mean of both speeds, must suffice for braking.
        left = max(abs(way) - math.copysign(self.speed, self.speed * way) * dt_s / 2.0, 0.0)
        reach = slowing * dt_s / 2.0
        speed = math.sqrt(reach * reach + 2.0 * slowing * left) - reach
        return math.copysign(min(speed, top), way)


class CpvMotion:
    """The CPV motion of all six joints; `Mechanics` runs it like any other path."""

    def __init__(self, settings: ArmSettingsRecord) -> None:
        self._settings = settings
        self.values = [dict(_FACTORY) for _ in JOINTS]
        self._joints = [JointProfile(0.0) for _ in JOINTS]

    @property
    def positions_deg(self) -> SixValues:
        """The angles that the CPV profiles have reached, joint 1 first."""
        return tuple(each.angle for each in self._joints)

    @property
    def speeds_deg_s(self) -> SixValues:
        """The speeds of the CPV profiles, joint 1 first."""
        return tuple(each.speed for each in self._joints)

    @property
    def accelerations_deg_s2(self) -> SixValues:
        """The accelerations of the CPV profiles, joint 1 first."""
        return tuple(each.acceleration for each in self._joints)

    @property
    def moving(self) -> bool:
        """True if a joint turns or is about to."""
        return any(each.moving for each in self._joints)

    def start_from(self, positions_deg: Sequence[float]) -> None:
        """Sets the positions to which something else has brought the joints."""
        self._joints = [JointProfile(angle) for angle in positions_deg]

    def go_to(self, index: int, angle_deg: float) -> None:
        """Moves one joint (0–5) to an angle, clipped to its limits."""
        limits = self._settings.limits[index]
        self._joints[index].go_to(min(max(angle_deg, limits.min_deg), limits.max_deg))

    def turn(self, index: int, speed_rad_s: float) -> None:
        """Turns one joint (0–5) at a speed."""
        self._joints[index].turn(math.degrees(speed_rad_s))

    def run(self, share: float) -> None:
        """Brakes all joints if the share is 0; other shares change nothing."""
        if share == 0.0:
            for each in self._joints:
                each.turn(0.0)

    def step(self, dt_s: float) -> None:
        """Advances by `dt_s` seconds."""
        for joint, values, limits in zip(
            self._joints, self.values, self._settings.limits, strict=True
        ):
            top, speeding_up, slowing = (
                math.degrees(max(values[kind], _LEAST))
                for kind in (
                    CpvKind.PROFILE_SPEED,
                    CpvKind.ACCELERATION,
                    CpvKind.DECELERATION,
                )
            )
            if joint.moving and dt_s > 0.0:
                joint.step(dt_s, top, speeding_up, slowing, limits)
            else:
                joint.acceleration = 0.0


class CpvControl:
    """Receives the frames of CPV and has them carried out.

    The first position written to a joint after CPV was entered takes effect only when it is sent a
    second time. The signs of the targets are those of the firmware and the model, even where they
    are wrong.
    """

    def __init__(
        self,
        mechanics: Mechanics,
        condition: Condition,
        settings: ArmSettingsRecord,
        quirks: FirmwareQuirks,
        unsupported: Counter[str],
    ) -> None:
        """Controls one arm.

        Args:
            mechanics: Its joints.
            condition: Its modes.
            settings: The arm's settings.
            quirks: The firmware's behaviour.
            unsupported: Counts commands that the arm understands but does not carry out.
        """
        self._mechanics = mechanics
        self._condition = condition
        self._quirks = quirks
        self._motion = CpvMotion(settings)
        self._primed = [False] * JOINT_COUNT
        self._in_cpv = False
        self._unsupported = unsupported
        self._asked: list[tuple[int, CpvKind]] = []

    def mode_changed(self) -> None:
        """Handles a mode word whose modes are in the condition already."""
        condition = self._condition
        was_in_cpv, self._in_cpv = self._in_cpv, condition.obeys(MoveMode.MOVE_CPV)
        if self._in_cpv and not was_in_cpv:
            self._primed = [False] * JOINT_COUNT
        elif was_in_cpv and not self._in_cpv and self._mechanics.follows(self._motion):
            self._motion.run(0.0)

    def take_frame(self, name: str, signals: dict[str, float]) -> bool:
        """Handles a frame of CPV; returns whether this firmware knows it."""
        if name not in NAMES or not self._quirks.has_cpv:
            return False
        action, kind = signals["Action"], CpvKind(int(signals["Kind"]))
        if kind is CpvKind.ZERO_LEARNING:
            self._unsupported["zero learning"] += 1
        elif action == CpvAction.WRITE:
            self._write(NAMES.index(name), kind, signals[_SIGNALS[kind]])
        elif action == CpvAction.READ:
            self._asked.append((NAMES.index(name), kind))
        return True

    def answers(self, codec: Codec) -> list[Frame]:
        """Return the answers to the parameters read since the last call."""
        asked, self._asked = self._asked, []
        return [
            codec.encode(
                NAMES[index],
                Action=CpvAction.ANSWER,
                Kind=kind,
                **{_SIGNALS[kind]: self._motion.values[index][kind]},
            )
            for index, kind in asked
        ]

    def _write(self, index: int, kind: CpvKind, value: float) -> None:
        if kind in _POSITIVE and value <= 0.0:
            return
        self._motion.values[index][kind] = value
        if kind not in (CpvKind.POSITION_TARGET, CpvKind.SPEED_TARGET) or not self._may_move:
            return
        if kind is CpvKind.POSITION_TARGET and not self._primed[index]:
            self._primed[index] = True
            return
        motion = self._motion
        if not self._mechanics.follows(motion):
            motion.start_from(self._mechanics.setpoints_deg)
        if kind is CpvKind.POSITION_TARGET:
            motion.go_to(index, self._quirks.cpv_position_signs[index] * value)
        else:
            motion.turn(index, self._quirks.cpv_speed_signs[index] * value)
        self._mechanics.follow_path(motion)

    @property
    def _may_move(self) -> bool:
        condition = self._condition
        able = condition.may_move and all(self._mechanics.powered)
        return able and condition.obeys(MoveMode.MOVE_CPV)
