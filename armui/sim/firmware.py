"""The simulated arm's controller: takes frames, advances in time, returns the frames it sends.

It has no clock, no thread and no bus: a host calls `on_frame` and `step`. Its behaviour follows the
protocol text and what is known of the maker's firmware.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Sequence
from typing import Final

from armui.arm.state import JointNumber
from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec, InvalidFrame, InvalidFrameKind
from armui.protocol.codes import (
    ALL_JOINTS,
    MOVE_UNCHANGED,
    ControlMode,
    LeaderZero,
    LinkageRole,
    MotorAction,
    Mounting,
    MoveMode,
    SettingIndex,
    SilenceMode,
    StopCommand,
)
from armui.protocol.firmware_version import RECOMMENDED, FirmwareBug
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation, PiperModel
from armui.sim.arm_role import CONTROL, ArmRole
from armui.sim.arm_type import ArmType
from armui.sim.condition import Condition
from armui.sim.faults.bugs import FirmwareBugs
from armui.sim.faults.lost_reference import LostReference
from armui.sim.faults.protection import Protection
from armui.sim.feedback import Feedback
from armui.sim.feedback_schedule import FeedbackSchedule
from armui.sim.mechanics.drivers import Drivers
from armui.sim.mechanics.gravity import Weight
from armui.sim.mechanics.gripper import SimulatedGripper
from armui.sim.mechanics.mechanics import HandGuiding, Mechanics
from armui.sim.mechanics.powered_joints import JOINT_COUNT, SixValues
from armui.sim.mechanics.unpowered_joints import UnpoweredJoints
from armui.sim.motion.moves import MotionCommandHandler, Moves
from armui.sim.motion.teaching import SimulatedTeaching
from armui.sim.parameters.flash import Flash, MemoryFlash
from armui.sim.parameters.parameter_server import ParameterServer, Signals, version_frames
from armui.sim.parameters.settings import LinkageSettings
from armui.sim.parameters.settings_applier import SettingsApplier

_NS_PER_S: Final = 1_000_000_000
_ALL_INDICES: Final = range(JOINT_COUNT)
_MOST_SLIP_DEG: Final = 90.0


class Firmware:
    """A simulated arm.

    Attributes:
        generation: The protocol it speaks.
        type: The arm's type: model and firmware version.
        kinematics: The kinematics of its version's geometry.
        condition: Modes, flags and faults, as reported in 0x2A1.
        mechanics: Joints and motors.
        drivers: The measurements of the motor drivers.
        gripper: The gripper.
        hand_guiding: A hand that moves joints which give way.
        teaching: Drag teaching and its recording.
        settings: The values the arm keeps.
        flash: The storage of these values.
        protection: The protection that watches the drivers.
        settings_applier: Applies the settings to the parts.
        bugs: Known bugs of firmware versions that it has.
        lost_reference: The fault by which a joint loses its reference.
        silent: True if the bus silence of 0x422 is in force.
        feedback_stopped: True if the arm, by a fault, sends no periodic feedback.
        drivers_tell: True if 0x251–0x266 continue while it is a teaching input, as on some arms.
        ignored: The number of frames not understood, by kind.
        unsupported: The number of frames asking for functions it lacks: transfer of trajectories,
            zero learning.
    """

    def __init__(
        self,
        generation: Generation,
        *,
        seed: int = 0,
        joints_deg: Sequence[float] = (0.0,) * JOINT_COUNT,
        version: str | None = None,
        model: PiperModel = PiperModel.PIPER,
        flash: Flash | None = None,
        bugs: frozenset[FirmwareBug] = frozenset(),
    ) -> None:
        """Creates an arm that was just switched on: motors off, standby, supported where it lies.

        Args:
            generation: The protocol it speaks.
            seed: The seed of the noise; the same seed and calls give the same frames.
            joints_deg: The joint angles at the start, joint 1 first, counted from the factory's
                zeros. A joint may lie outside its limits.
            version: The firmware's version, as ``S-V1.8-9`` (generation 2); today's with None.
            model: The model of the family.
            flash: The storage of its settings; without it they end with this object.
            bugs: Known bugs that it has.
        """
        self.generation = generation
        self.type = ArmType.of(model, version or str(RECOMMENDED))
        self.flash: Flash = flash or MemoryFlash()
        self.settings = self.flash.load(model)
        self.condition = Condition()
        zeros_deg = self.settings.zeros_deg
        self.mechanics = Mechanics(
            (float(angle) - zero for angle, zero in zip(joints_deg, zeros_deg, strict=True)),
            Weight(self.type.links),
        )
        self.drivers = Drivers(seed, self.type.nm_per_ampere)
        self.gripper = SimulatedGripper(generation, self.settings)
        self.ignored: Counter[InvalidFrameKind] = Counter()
        self.unsupported: Counter[str] = Counter()
        self.kinematics = Kinematics(self.type.geometry)
        self.silent = False
        self._off = False
        self._now_ns = 0
        self._schedule = FeedbackSchedule(generation)
        self.hand_guiding = HandGuiding()
        self.teaching = SimulatedTeaching(
            self.mechanics, self.condition, self.settings, self.hand_guiding
        )
        self._moves = Moves(
            self.mechanics,
            self.condition,
            self.settings,
            self.kinematics,
            self.type,
            unsupported=self.unsupported,
        )
        self.protection = Protection(
            self.mechanics, self.drivers, self.condition, self.settings, self._moves.abort_motion
        )
        self.feedback_stopped = False
        self.drivers_tell = False
        self.settings_applier = SettingsApplier(
            self.settings,
            self.mechanics,
            self.condition,
            self._schedule,
            self.type,
            found_deg=joints_deg,
            flash=self.flash,
            drop_targets=self._moves.drop_targets,
        )
        self.lost_reference = LostReference(self.settings_applier)
        self._linkage = ArmRole(
            *(generation, self.mechanics, self.condition, self.settings),
            hand=self.hand_guiding,
            flash=self.flash,
            drop_targets=self._moves.drop_targets,
            speak=self._speak,
        )
        self._motion_commands = MotionCommandHandler(
            *(generation, self.mechanics, self.condition, self.teaching),
            moves=self._moves,
            unsupported=self.unsupported,
            enter=self._enter,
        )
        self._linkage.take_effect()
        self.bugs = FirmwareBugs(
            *(bugs, self.mechanics, self.condition, self.settings, self.settings_applier),
            lost=self.lost_reference,
            lead=self._linkage.set,
            corrupt_limits=self.corrupt_limits,
        )
        self._handlers: dict[str, Callable[[Signals], list[Frame]]] = {
            "MotionCommand": self._motion_command,
            "ModeControl": self._mode_control,
            "GripperCommand": self._gripper_command,
            "LinkageSetting": self._linkage_setting,
            "LeaderZero": self._leader_zero,
            "MotorEnable": self._motor_enable,
            "BusSilence": self._bus_silence,
            "FirmwareVersion": lambda asked: version_frames(
                self._codec, asked, self.type.version, self.type.model.model
            ),
        }

    @property
    def joints_deg(self) -> SixValues:
        """The true angles of the joints; the feedback may differ: see `reported_deg`."""
        return self.mechanics.positions_deg

    @property
    def reported_deg(self) -> SixValues:
        """The joint angles as the feedback reports them; in an excursion they are wrong."""
        return self.lost_reference.reported_deg(self.mechanics.positions_deg)

    @property
    def true_joints_deg(self) -> SixValues:
        """The true joint angles, counted from the factory's zeros; no frame reports them."""
        return tuple(self.mechanics.weight.true_deg(self.mechanics.positions_deg))

    @property
    def enabled(self) -> tuple[bool, ...]:
        """For each motor, true if it has power."""
        return self.mechanics.powered

    @property
    def targets_deg(self) -> SixValues:
        """The last joint targets that were accepted."""
        return self._moves.targets_deg

    @property
    def ik_solution_deg(self) -> SixValues | None:
        """The joint angles of the last pose of MOVE P, as in 0x2AA–0x2AC."""
        return self._moves.ik_solution_deg if self.type.quirks.has_ik_solution else None

    @property
    def leads(self) -> bool:
        """True if it is a teaching input: it sends commands and obeys none."""
        return self._linkage.leader is not None

    @property
    def time_s(self) -> float:
        """The time for which the arm has been on."""
        return self._now_ns / _NS_PER_S

    @property
    def addressing(self) -> Addressing:
        """The identifier offsets in force."""
        return self._codec.addressing

    def on_frame(self, frame: Frame) -> list[Frame]:
        """Obeys or answers a frame at once.

        Args:
            frame: Any frame on the bus; unknown ones are counted and ignored.

        Returns:
            The answers, in order.
        """
        if self._off:
            return []
        message = self._codec.decode(frame)
        if isinstance(message, InvalidFrame):
            self.ignored[message.kind] += 1
            return []
        if self.leads and message.name in CONTROL:
            return []  # a teaching input obeys the hand alone
        name, signals = message
        handler = self._handlers.get(name)
        if handler is not None:
            answers = handler(signals)
        elif self._moves.take_frame(name, signals):
            answers = self._moves.cpv.answers(self._codec)
        else:
            answers = self._parameter_server.handle(name, signals) or []
            self.bugs.setting_taken(name)
        return [] if self._quiet else answers

    def step(self, dt_s: float) -> list[Frame]:
        """Advances in time, and returns the feedback that is due.

        Args:
            dt_s: The time to advance, 0 or more.

        Returns:
            The feedback due in that time, in order.

        Raises:
            ValueError: The time is negative.
        """
        if not 0.0 <= dt_s < math.inf:
            raise ValueError(f"dt_s is {dt_s}; give a time from 0 up")
        end_ns = self._now_ns + round(dt_s * _NS_PER_S)
        frames: list[Frame] = []
        while self._schedule.next_ns <= end_ns:
            self._advance(self._schedule.next_ns)
            self._schedule.ik_solution = self.ik_solution_deg is not None
            names = self._schedule.pop()
            self.protection.watch(names, self._schedule.periods_ns)
            if not (self._quiet or self.feedback_stopped or self._off):
                frames += self._periodic(names)
        self._advance(end_ns)
        return frames

    @property
    def _quiet(self) -> bool:
        return self.silent or self.bugs.silent

    def set_communication_fault(self, joint: int, *, present: bool) -> None:
        """Breaks or restores the connection between the controller and a joint (1–6)."""
        self.condition.communication_fault[joint - 1] = present
        if present:
            self._moves.abort_motion()

    def power_cycle(self) -> None:
        """Switches the power off and on again: see `switch_off` and `switch_on`."""
        self.switch_off()
        self.switch_on()

    @property
    def is_on(self) -> bool:
        """True if the arm has power."""
        return not self._off

    def switch_off(self) -> None:
        """Switches the power off: the arm drops, and neither receives nor sends."""
        self._off = True
        self._motion_commands.drop_work()
        self.teaching.entered = False
        self.teaching.recording.clear()
        self.mechanics.power_off(_ALL_INDICES, UnpoweredJoints.FREE)
        self.gripper.release()

    def switch_on(self) -> None:
        """Switches the power on: standby, motors off; only what the flash holds is kept."""
        self._off = False
        self.settings_applier.restart()
        self.condition.start_anew()
        self.silent = False
        self._linkage.take_effect()
        self.bugs.switched_on()

    def corrupt_limits(self, joint: int) -> None:
        """Makes a joint's (1–6) limits read back as 0xFFFF, as from a worn flash."""
        self._parameter_server.corrupt_limits(joint - 1)

    def slip(self, joint: int, angle_deg: float) -> None:
        """Turns a joint (1–6) by an angle towards its middle, without its encoder counting.

        0x150 resume shows it.
        """
        stop, now_deg = self.settings_applier.stops[joint - 1], self.reported_deg[joint - 1]
        step_deg = math.copysign(angle_deg, (stop.min_deg + stop.max_deg) / 2.0 - now_deg)
        self.settings_applier.slip(joint - 1, step_deg, most_deg=_MOST_SLIP_DEG)

    def _advance(self, to_ns: int) -> None:
        dt_s = (to_ns - self._now_ns) / _NS_PER_S
        if dt_s <= 0.0:
            return
        self._now_ns = to_ns
        self.mechanics.step(dt_s, self.settings_applier.stops)
        self.teaching.time_passed(dt_s)
        self.gripper.step(dt_s)
        if self.mechanics.gives_way and self.hand_guiding.gripper_to is not None:
            self.gripper.lead_to(self.hand_guiding.gripper_to)
        self._moves.time_passed()
        self.bugs.time_passed(dt_s)
        self.lost_reference.step(dt_s)

    def _periodic(self, names: list[str]) -> list[Frame]:
        """Return the frames due under these names; a teaching input sends its commands instead."""
        if not self.leads:
            return self.bugs.distorted(names, self._feedback.frames(names))
        drivers = [name for name in names if self.drivers_tell and name.startswith("Driver")]
        told = self._linkage.leader_frames(self.gripper) if "ArmStatus" in names else []
        return told + self._feedback.frames(drivers)

    def _speak(self) -> None:
        """Takes over the identifiers that the settings ask for."""
        addressing = self.settings_applier.addressing
        self._codec = Codec(self.generation, addressing, self.type.quirks.version)
        self._parameter_server = ParameterServer(self._codec, self.settings, self.settings_applier)
        self._feedback = Feedback(self._codec, self)

    def _motion_command(self, signals: Signals) -> list[Frame]:
        if signals["EmergencyStop"] == StopCommand.RESUME:
            self.bugs.reset()
            self.lost_reference.mend()
        if not self._motion_commands.obey(signals):
            return []
        # the trajectory point of 0x476 is 0: no transferred trajectory is under way
        return [self._parameter_server.answer(SettingIndex.MOTION_COMMAND)]

    def _mode_control(self, signals: Signals) -> list[Frame]:
        if self.condition.stopped or (self.teaching.entered and not self._mode_word_ends_teaching):
            return []
        if self.teaching.entered:
            self.teaching.leave()
        condition, control_mode = self.condition, ControlMode(int(signals["ControlMode"]))
        condition.speed_percent = int(signals["SpeedPercent"])
        self.settings_applier.mount(Mounting(int(signals.get("Mounting", Mounting.UNCHANGED))))
        if signals["MoveMode"] != MOVE_UNCHANGED:
            condition.move_mode = MoveMode(int(signals["MoveMode"]))
        elif control_mode is condition.control_mode:
            self._moves.speed_changed()
            return []
        was_direct = condition.direct
        self._enter(control_mode)
        self._moves.mode_word(signals)
        self.bugs.mode_word(was_direct=was_direct)
        return []

    @property
    def _mode_word_ends_teaching(self) -> bool:
        return self.generation is Generation.TWO and self.type.quirks.exits_by_mode_word

    def _enter(self, control_mode: ControlMode) -> None:
        self.condition.control_mode = control_mode
        self._linkage.mode_entered()

    def _motor_enable(self, signals: Signals) -> list[Frame]:
        joint = int(signals["Joint"])
        indices = _ALL_INDICES if joint == ALL_JOINTS else (JointNumber(joint) - 1,)
        if self.condition.stopped:
            pass  # the motors stay off and damped until the stop is resumed
        elif signals["Action"] == MotorAction.ENABLE:
            self._moves.power_on(i for i in indices if self.protection.may_power(i))
        else:
            self._motion_commands.drop_work()
            self._moves.abort_motion()
            self.mechanics.power_off(indices, UnpoweredJoints.FREE)
            if joint == ALL_JOINTS and self.type.quirks.disable_frees_gripper:
                self.gripper.release()
        return [self._parameter_server.answer(SettingIndex.MOTOR_ENABLE)]

    def _gripper_command(self, signals: Signals) -> list[Frame]:
        if not self.condition.stopped:
            self.gripper.command(signals, knows_angles=self._codec.quirks.has_gripper_angle)
        return []

    def _linkage_setting(self, signals: Signals) -> list[Frame]:
        answer = self._parameter_server.answer(SettingIndex.LINKAGE_SETTING)
        role = LinkageRole(int(signals["Role"])) or self.settings.linkage.role
        self.bugs.role_set(role)
        self._linkage.set(
            LinkageSettings(
                role,
                int(signals["FeedbackOffset"]),
                int(signals["ControlOffset"]),
                int(signals["TargetOffset"]),
            )
        )
        return [answer]

    def _leader_zero(self, signals: Signals) -> list[Frame]:
        if self.type.quirks.has_leader_zero:
            self._linkage.zero(LeaderZero(int(signals["Command"])))
        return []

    def _bus_silence(self, signals: Signals) -> list[Frame]:
        self.silent = signals["Mode"] != SilenceMode.LEAVE_SILENCE
        return []
