"""The frames that the simulated arm sends periodically, and the time at which each is due."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Final, Protocol

from armui.arm.limits import JOINTS
from armui.arm.state import GripperFault
from armui.kinematics.poses import Pose
from armui.protocol.codec import Codec
from armui.protocol.codes import DEGREES_PER
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.condition import Alarm
from armui.sim.mechanics.powered_joints import STANDSTILL, SixValues

if TYPE_CHECKING:
    from armui.kinematics.arm_kinematics import Kinematics
    from armui.sim.condition import Condition
    from armui.sim.faults.lost_reference import LostReference
    from armui.sim.mechanics.drivers import Drivers
    from armui.sim.mechanics.gripper import SimulatedGripper
    from armui.sim.mechanics.mechanics import Mechanics


_NUDGE_DEG: Final = 0.01
_MM_PER_M: Final = 1000.0
_MOST: Final = 64
"""The frames kept of one message; moving joints never repeat theirs."""

_DEGREES_PER: Final = {**DEGREES_PER, "pulse": 360.0 / 65536.0}
"""The units with the encoder's pulses. The protocol text gives no number of pulses for a turn; this
one is assumed.
"""
_NO_ALARM: Final[Mapping[str, float]] = dict.fromkeys(Alarm, False)
_NO_GRIPPER_FAULT: Final[Mapping[str, float]] = dict.fromkeys(GripperFault, False)
_MOST_STEPS: Final = 32767
"""The most that the 16 bits of a driver's speed hold (0x251–0x256); a faster joint reports this."""


class FrameCache:
    """Keeps frames of each message; a frame is encoded only if its values differ from all of them.

    Most of an arm's 3,000 frames a second repeat the ones before them or, like the noisy supply
    voltage, one of a few. They are told apart by their values alone, which are hashed faster: a
    message's signals come in the same order each time, or are more of them.
    """

    def __init__(self, codec: Codec) -> None:
        self._codec = codec
        self._kept: dict[str, dict[tuple[float, ...], Frame]] = {}
        self._known: dict[str, frozenset[str]] = {}

    def frame(self, name: str, **signals: float) -> Frame:
        """Return the frame of a message; signals its generation does not have are left out."""
        kept = self._kept.get(name)
        if kept is None:
            kept = self._kept[name] = {}
            self._known[name] = frozenset(self._codec.signals(name))
        said = tuple(signals.values())
        frame = kept.get(said)
        if frame is None:
            known = self._known[name]
            if not signals.keys() <= known:
                signals = {signal: signals[signal] for signal in signals if signal in known}
            frame = self._codec.encode(name, **signals)
            if len(kept) == _MOST:
                kept.clear()
            kept[said] = frame
        return frame


class ReportedArm(Protocol):
    """The parts of an arm that the feedback reads, and the angles as the arm believes them."""

    condition: Condition
    drivers: Drivers
    gripper: SimulatedGripper
    kinematics: Kinematics
    lost_reference: LostReference
    mechanics: Mechanics

    @property
    def reported_deg(self) -> SixValues:
        """The joint angles as the feedback reports them, joint 1 first."""

    @property
    def ik_solution_deg(self) -> SixValues | None:
        """The joint angles of the last pose of MOVE P, as in 0x2AA–0x2AC."""


class Feedback:
    """Builds the periodic frames from the state of the arm's parts."""

    def __init__(self, codec: Codec, arm: ReportedArm) -> None:
        self._cache = FrameCache(codec)
        self._arm = arm
        self._kinematics = arm.kinematics
        self._posed_at: SixValues = ()
        self._pose = Pose(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
        self._speed_unit_deg = _DEGREES_PER[codec.unit("DriverFast1", "Speed")]
        self._most_speed = _MOST_STEPS * codec.step("DriverFast1", "Speed")
        self._position_unit_deg = _DEGREES_PER[codec.unit("DriverFast1", "Position")]
        self._first_generation = codec.generation is Generation.ONE
        frame = self._cache.frame
        self._makers: dict[str, Callable[[], Frame]] = {
            "ArmStatus": self._arm_status,
            "EndPose1": lambda: frame("EndPose1", X=self._pose.x_mm, Y=self._pose.y_mm),
            "EndPose2": lambda: frame("EndPose2", Z=self._pose.z_mm, RX=self._pose.rx_deg),
            "EndPose3": lambda: frame("EndPose3", RY=self._pose.ry_deg, RZ=self._pose.rz_deg),
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
        """Return the present frames of these messages, in their order."""
        positions = self._arm.reported_deg
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

    def _joint_feedback(self, name: str, joint: int) -> Frame:
        positions = self._arm.reported_deg
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
        index, lost = joint - 1, self._arm.lost_reference
        speed_deg_s = self._arm.mechanics.speeds_deg_s[index] + lost.speed_deg_s(index)
        speed = speed_deg_s / self._speed_unit_deg
        current_a = lost.current_a(index, self._arm.drivers.currents_a[index])
        return self._cache.frame(
            f"DriverFast{joint}",
            Speed=max(-self._most_speed, min(self._most_speed, speed)),
            Current=abs(current_a) if self._first_generation else current_a,
            Position=self._arm.reported_deg[index] / self._position_unit_deg,
        )

    def _driver_slow(self, joint: int) -> Frame:
        """Return a driver's slow feedback; only generation 1 measures the bus current in it."""
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
        """Return what a joint contributes to the motion of the flange (0x481–0x486).

        The protocol names the fields «speed and acceleration of the end, joint 1–6» and says no
        more. Here they are the flange's speed and tangential acceleration as the joint alone would
        cause them: its turning rate, and that times the distance from its axis to the flange.
        """
        index, mechanics = joint - 1, self._arm.mechanics
        speed_rad_s = abs(math.radians(mechanics.speeds_deg_s[index]))
        acceleration_rad_s2 = abs(math.radians(mechanics.accelerations_deg_s2[index]))
        lever_m = self._lever_m(index) if speed_rad_s or acceleration_rad_s2 else 0.0
        return self._cache.frame(
            f"EndMotion{joint}",
            LinearSpeed=speed_rad_s * lever_m,
            AngularSpeed=speed_rad_s,
            LinearAcceleration=acceleration_rad_s2 * lever_m,
            AngularAcceleration=acceleration_rad_s2,
        )

    def _lever_m(self, index: int) -> float:
        """Return how far, in m, the flange is from a joint's axis, by turning it a little."""
        ends = []
        for nudge_deg in (-_NUDGE_DEG, _NUDGE_DEG):
            nudged = list(self._arm.mechanics.positions_deg)
            nudged[index] += nudge_deg
            ends.append(self._kinematics.forward(nudged)[:3])
        return math.dist(*ends) / (2.0 * math.radians(_NUDGE_DEG) * _MM_PER_M)


def _gripper_bits(gripper: SimulatedGripper) -> Mapping[str, float]:
    if not gripper.errors:
        return _NO_GRIPPER_FAULT
    return {fault: fault in gripper.errors for fault in GripperFault}
