"""Makes the periodic feedback frames."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JOINTS
from armui.arm.state import GripperFault
from armui.kinematics.poses import Pose
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.protocol.layout import DEGREES_PER
from armui.sim.faults.alarms import Alarm
from armui.sim.feedback.end_motion import end_motion
from armui.sim.feedback.frame_cache import FrameCache
from armui.sim.mechanics.powered_joints import STANDSTILL, SixValues

if TYPE_CHECKING:
    from armui.sim.firmware import Firmware
    from armui.sim.mechanics.gripper import SimulatedGripper

_DEGREES_PER: Final = {**DEGREES_PER, "pulse": 360.0 / 65536.0}
"""With the encoder's pulses; the protocol text gives no number of them a turn, this is assumed."""
_NO_ALARM: Final[Mapping[str, float]] = dict.fromkeys(Alarm, False)
_NO_GRIPPER_FAULT: Final[Mapping[str, float]] = dict.fromkeys(GripperFault, False)


class Feedback:
    """Makes the periodic frames from the state of the arm's parts."""

    def __init__(self, codec: Codec, arm: Firmware) -> None:
        self._cache = FrameCache(codec)
        self._arm = arm
        self._kinematics = arm.kinematics
        self._posed_at: SixValues = ()
        self._pose = Pose(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
        self._speed_unit_deg = _DEGREES_PER[codec.unit("DriverFast1", "Speed")]
        self._position_unit_deg = _DEGREES_PER[codec.unit("DriverFast1", "Position")]
        self._first_generation = codec.generation is Generation.ONE
        self._makers: dict[str, Callable[[], Frame]] = {
            "ArmStatus": self._arm_status,
            "EndPose1": self._end_pose_1,
            "EndPose2": self._end_pose_2,
            "EndPose3": self._end_pose_3,
            "GripperFeedback": self._gripper,
        }
        for joint in (1, 3, 5):
            name = f"JointFeedback{joint}{joint + 1}"
            self._makers[name] = partial(self._joint_feedback, name, joint)
            name = f"IkSolution{joint}{joint + 1}"
            self._makers[name] = partial(self._ik_solution, name, joint)
        for joint in JOINTS:
            self._makers[f"DriverFast{joint}"] = partial(self._driver_fast, joint)
            self._makers[f"DriverSlow{joint}"] = partial(self._driver_slow, joint)
            self._makers[f"EndMotion{joint}"] = partial(self._end_motion, joint)

    def frames(self, names: Iterable[str]) -> list[Frame]:
        """The messages of these names, in their order, as of now."""
        positions = self._arm.mechanics.positions_deg
        if positions != self._posed_at:
            self._posed_at = positions
            self._pose = self._kinematics.forward(positions)
        makers = self._makers
        return [makers[name]() for name in names]

    def _arm_status(self) -> Frame:
        condition = self._arm.condition
        flags: dict[str, float] = {}
        for joint, beyond, fault in zip(
            JOINTS, condition.beyond_limit, condition.communication_fault, strict=True
        ):
            flags[f"J{joint}LimitExceeded"] = beyond
            flags[f"J{joint}CommunicationFault"] = fault
        return self._cache.frame(
            "ArmStatus",
            ControlMode=condition.control_mode,
            Status=condition.status,
            MoveMode=condition.move_mode,
            TeachingState=condition.teaching_state,
            MotionState=condition.motion_state,
            SpeedPercent=condition.speed_percent,
            **flags,
        )

    def _end_pose_1(self) -> Frame:
        return self._cache.frame("EndPose1", X=self._pose.x_mm, Y=self._pose.y_mm)

    def _end_pose_2(self) -> Frame:
        return self._cache.frame("EndPose2", Z=self._pose.z_mm, RX=self._pose.rx_deg)

    def _end_pose_3(self) -> Frame:
        return self._cache.frame("EndPose3", RY=self._pose.ry_deg, RZ=self._pose.rz_deg)

    def _joint_feedback(self, name: str, joint: int) -> Frame:
        positions = self._arm.mechanics.positions_deg
        signals = {f"J{joint}": positions[joint - 1], f"J{joint + 1}": positions[joint]}
        return self._cache.frame(name, **signals)

    def _ik_solution(self, name: str, joint: int) -> Frame:
        solution = self._arm.ik_solution_deg or STANDSTILL
        signals = {f"J{joint}": solution[joint - 1], f"J{joint + 1}": solution[joint]}
        return self._cache.frame(name, **signals)

    def _gripper(self) -> Frame:
        gripper = self._arm.gripper
        return self._cache.frame(
            "GripperFeedback",
            **gripper.place,
            Speed=math.radians(abs(gripper.speed)),
            Torque=gripper.torque_nm,
            Enabled=gripper.enabled,
            Homed=1,
            **_gripper_bits(gripper),
        )

    def _driver_fast(self, joint: int) -> Frame:
        index, mechanics = joint - 1, self._arm.mechanics
        current_a = self._arm.drivers.currents_a[index]
        return self._cache.frame(
            f"DriverFast{joint}",
            Speed=mechanics.speeds_deg_s[index] / self._speed_unit_deg,
            Current=abs(current_a) if self._first_generation else current_a,
            Position=mechanics.positions_deg[index] / self._position_unit_deg,
        )

    def _driver_slow(self, joint: int) -> Frame:
        """Only generation 1 measures the bus current; the 1.5 kg arm of today reports 0."""
        index, drivers = joint - 1, self._arm.drivers
        return self._cache.frame(
            f"DriverSlow{joint}",
            Voltage=drivers.voltage_v(),
            DriverTemperature=round(drivers.driver_temperatures_c[index]),
            MotorTemperature=round(drivers.motor_temperatures_c[index]),
            Enabled=self._arm.mechanics.powered[index],
            Homed=1,
            **self._alarm_bits(index),
            BusCurrent=drivers.bus_current_a(index) if self._first_generation else 0.0,
        )

    def _alarm_bits(self, index: int) -> Mapping[str, float]:
        alarms = self._arm.condition.alarms.of(index)
        if not alarms:
            return _NO_ALARM
        bits: dict[str, float] = {alarm: alarm in alarms for alarm in Alarm}
        if Alarm.SENSOR in alarms and not self._first_generation:
            bits[Alarm.DRIVER] = True
        return bits

    def _end_motion(self, joint: int) -> Frame:
        index, mechanics = joint - 1, self._arm.mechanics
        part = end_motion(
            self._kinematics,
            mechanics.positions_deg,
            index,
            mechanics.speeds_deg_s[index],
            mechanics.accelerations_deg_s2[index],
        )
        return self._cache.frame(
            f"EndMotion{joint}",
            LinearSpeed=part.linear_speed_m_s,
            AngularSpeed=part.angular_speed_rad_s,
            LinearAcceleration=part.linear_acceleration_m_s2,
            AngularAcceleration=part.angular_acceleration_rad_s2,
        )


def _gripper_bits(gripper: SimulatedGripper) -> Mapping[str, float]:
    if not gripper.errors:
        return _NO_GRIPPER_FAULT
    return {fault: fault in gripper.errors for fault in GripperFault}
