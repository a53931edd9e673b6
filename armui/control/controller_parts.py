"""The parts of the controller, each created when it is first needed.

The window that a start shows needs two of them; a device needs them all, and gets them before it
is opened.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from armui.control.cell.area_guard import AreaGuard
from armui.control.cell.cell_control import CellControl
from armui.control.devices.end_reports import EndReports
from armui.control.devices.gripper import GripperControl
from armui.control.devices.joint_errors import JointErrors
from armui.control.devices.lights import Lights
from armui.control.devices.linkage import LinkageControl
from armui.control.devices.motors import Motors
from armui.control.devices.mounting import MountingControl
from armui.control.devices.teaching import TeachingControl
from armui.control.devices.zeroing import Zeroing
from armui.control.gamepad.pilot import GamepadPilot
from armui.control.link.bus_access import BusAccess
from armui.control.link.link_watch import DroppedFrames, LateFeedback
from armui.control.link.model_watch import ModelWatch
from armui.control.motion.cartesian import Cartesian
from armui.control.motion.jog_floor import JogFloor
from armui.control.motion.jogging import Jogging
from armui.control.motion.joint_motion import Motion
from armui.control.motion.motion_command import End
from armui.control.motion.planned_motion import PlannedMotion
from armui.control.operations.operation import Operations
from armui.control.parameters.arm_settings import ArmSettings
from armui.control.parameters.planning_model import planning_model, tool_capsule
from armui.control.requests.transactions import TransactionQueue
from armui.control.run.inspection import Inspection
from armui.control.run.player import Player
from armui.control.run.recorder import Recorder
from armui.control.run.replayer import Replayer
from armui.control.run.speed_override import SpeedOverride
from armui.control.safety.gate import Gate
from armui.control.safety.mode_exit import ModeExitCommand
from armui.control.safety.recovery import Recovery
from armui.control.safety.sinking_control import SinkingControl
from armui.control.sessions.episodes import Episodes
from armui.control.sessions.session_recorder import SessionRecorder

if TYPE_CHECKING:
    from collections.abc import Callable
    from datetime import datetime

    from armui.arm.refusal import Refusal
    from armui.control.context import ControllerPart
    from armui.control.event_log.collector import EventCollector
    from armui.control.motion.motion_context import MotionContext
    from armui.control.safety.gate import Background
    from armui.control.safety.reference_control import ReferenceControl, ReferenceMemory
    from armui.control.safety.resume_slips import ResumeSlips
    from armui.control.sessions.choices import SessionChoices
    from armui.telemetry.events import EventLog
    from armui.ways.rules import Rules


class ControllerParts(QObject):
    """The base class of the controller, which holds its parts.

    Signals:
        step_changed: A :class:`Step`, when the next step of recovery differs.
        noticed: A :class:`Event`.
        cell_changed: The chosen :class:`Cell` or ``None``, when it, its confirmation or the list of
            cells has changed.
    """

    step_changed = Signal(object)
    cell_changed = Signal(object)
    noticed = Signal(object)

    session_choices: Callable[[], SessionChoices] | None = None
    """Returns how and where sessions are recorded; by default as `SessionRecorder` has it."""
    reference_memory: ReferenceMemory | None = None
    """Keeps what is known of each arm's reference; by default nothing is kept."""
    _context: MotionContext
    """The context that the parts share; the controller sets it before it asks for any."""
    _background: Background | None
    """Has a thread check a long way; the controller sets it likewise."""
    _wall: Callable[[float], datetime]
    """Returns the local time of a monotonic time; the controller sets it likewise."""

    @cached_property
    def motion(self) -> Motion:
        """The part that moves the joints."""
        return Motion(self._context)

    @cached_property
    def gate(self) -> Gate:
        """The part that checks every motion."""
        return Gate(self._context, self._scene, self._background)

    def _scene(self) -> tuple[object, Callable[[], Rules]]:
        """Return the objects that the rules depend on, and a function that makes the rules."""
        now, lowest_mm = self._context.operating_state(), self.jog_floor.lowest_mm
        tool = (self.cartesian.tool, self.cartesian.tool_radius_mm)
        of = (now.limits, now.model, now.model_fit.geometry, self.cell.cell, tool, lowest_mm)

        def make() -> Rules:
            from armui.ways.rules import rules_of  # noqa: PLC0415 - numpy

            arm = planning_model(self._context.state(), now, *tool)
            arm = replace(arm, held=self.cell.held_shape, rising=self.cell.rising)
            return rules_of(arm, self.area_guard.check(), lowest_mm)

        return of, make

    @cached_property
    def jog_floor(self) -> JogFloor:
        """The part that knows how low the arm reaches, and how low a jog may take it."""
        return JogFloor(
            self._context,
            lambda: tool_capsule(self.cartesian.tool, self.cartesian.tool_radius_mm),
            lambda: self.cell.held_shape,
            lambda: self.cell.rising,
        )

    @cached_property
    def area_guard(self) -> AreaGuard:
        """The part that keeps motions out of the forbidden side of the cell's work area."""
        return AreaGuard(
            self._context,
            lambda: self.cell.cell,
            lambda: self.cartesian.tool,
            self.halt_and_hold,
        )

    @cached_property
    def cartesian(self) -> Cartesian:
        """The part that moves the tool."""
        return Cartesian(self._context, self.motion)

    @cached_property
    def cell(self) -> CellControl:
        """The part that holds the cell in force: tools, and what stands around the arm."""
        return CellControl(self._context, self.cartesian, self.cell_changed.emit)

    @cached_property
    def jogging(self) -> Jogging:
        """The part that moves joints and tool while something is held."""
        return Jogging(self._context, self.motion, self.cartesian)

    @cached_property
    def gamepad(self) -> GamepadPilot:
        """The part that jogs by gamepad and SpaceMouse, once it is switched on."""
        return GamepadPilot(
            *(self.jogging, self.cartesian),
            stop=self.emergency_stop,
            halt=self.halt_and_hold,
            mark_episode=self.episodes.mark,
            discard_episode=self.episodes.discard,
            clock=self._context.clock,
        )

    @cached_property
    def motors(self) -> Motors:
        """The part that switches the motors."""
        return Motors(self._context, end_run=self._end_run_because)

    @cached_property
    def lights(self) -> Lights:
        """The part that sets the lamps of the joints."""
        return Lights(self._context)

    @cached_property
    def player(self) -> Player:
        """The part that runs trajectories."""
        player = Player(self._context, self)
        player.note_held = self.cell.note_held
        return player

    @cached_property
    def replayer(self) -> Replayer:
        """The part that replays recordings."""
        return Replayer(self._context, self)

    @property
    def last_run(self) -> Player | Replayer:
        """The run under way, or the last one: of points, or of a recording."""
        return self.replayer if self.replayer.number > self.player.number else self.player

    @cached_property
    def speed_override(self) -> SpeedOverride:
        """The part that slows runs and replays."""
        return SpeedOverride(self._context, self.motion, (self.player, self.replayer))

    @cached_property
    def recorder(self) -> Recorder:
        """The part that records where the arm goes."""
        return Recorder(self._context, self)

    @cached_property
    def transactions(self) -> TransactionQueue:
        """The part that carries out the commands that are answered."""
        return TransactionQueue(self._context)

    @cached_property
    def settings(self) -> ArmSettings:
        """The part that reads and sets the parameters the arm keeps."""
        return ArmSettings(self._context, self.transactions, self)

    @cached_property
    def joint_errors(self) -> JointErrors:
        """The part that clears the errors of the joints' drivers."""
        return JointErrors(self._context, self.transactions)

    @cached_property
    def teaching(self) -> TeachingControl:
        """The part that commands drag teaching."""
        return TeachingControl(self._context)

    @cached_property
    def planned_motion(self) -> PlannedMotion:
        """The part that pauses, continues and clears motions."""
        return PlannedMotion(
            self._context,
            end_all=self._end_driven,
            end_gripper=self.gripper.end_travel,
            send_speed=self.motion.send_speed,
        )

    @cached_property
    def recovery(self) -> Recovery:
        """The part that finds and carries out the next step towards an arm that may be moved."""
        return Recovery(
            self._context,
            motors=self.motors,
            joint_errors=self.joint_errors,
            teaching=self.teaching,
            stop=self.emergency_stop,
            withdraw_stop=self.withdraw_stop,
            planned_motion=self.planned_motion,
            take_over=self.take_over,
            mode_exit=self.mode_exit,
            allow=lambda: self.reference.allow(),  # noqa: PLW0108 - made when it is needed
            note_slip=lambda: self.reference.note_slip(),  # noqa: PLW0108 - likewise
            come_inside=self.motion.come_inside,
            cell=self.cell,
            announce=self.step_changed.emit,
        )

    @cached_property
    def reference(self) -> ReferenceControl:
        """The part that watches the joints' reference, and carries out its check."""
        from armui.control.safety.reference_control import (  # noqa: PLC0415 - cantools
            ReferenceControl,
        )

        return ReferenceControl(
            self._context,
            self.reference_memory,
            lambda: self._wall(self._context.clock()),
        )

    @cached_property
    def inspection(self) -> Inspection:
        """The part that has each joint swing, and compares the measurements."""
        now = self._context.clock
        return Inspection(self._context, self.replayer, self.reference, lambda: self._wall(now()))

    @cached_property
    def _resume_slips(self) -> ResumeSlips:
        from armui.control.safety.resume_slips import ResumeSlips  # noqa: PLC0415 - cantools

        return ResumeSlips(self._context, self.reference, self._wall)

    @cached_property
    def sinking(self) -> SinkingControl:
        """The part that warns while the arm moves without power or without a command (S37)."""
        return SinkingControl(
            self._context,
            self.jog_floor.height_mm,
            lambda: self.cell.rising,
            self.area_guard.below,
        )

    @cached_property
    def mode_exit(self) -> ModeExitCommand:
        """The part that takes the arm out of another host's mode."""
        return ModeExitCommand(self._context, lambda: self.motion.speed_percent)

    @cached_property
    def end_reports(self) -> EndReports:
        """The part that sets the load, and switches the feedback of the end's motion."""
        return EndReports(self._context, self.transactions)

    @cached_property
    def mounting(self) -> MountingControl:
        """The part that tells the arm how it is mounted."""
        return MountingControl(self._context, lambda: self.motion.speed_percent)

    @cached_property
    def linkage(self) -> LinkageControl:
        """The part that sets the arm's role and its identifiers."""
        return LinkageControl(self._context, self.transactions)

    @cached_property
    def gripper(self) -> GripperControl:
        """The part that moves the gripper."""
        gripper = GripperControl(
            self._context,
            self.settings,
            end_run=self._end_run_because,
            table=lambda: None if self.cell.in_force is None else self.cell.in_force.gripper,
        )
        self.player.as_asked = gripper.as_asked
        for run in (self.player, self.replayer):
            run.gripper_sent.connect(gripper.note_travel)
            run.aborted.connect(gripper.end_travel)
        return gripper

    @cached_property
    def zeroing(self) -> Zeroing:
        """The part that sets the zeros of the joints."""
        return Zeroing(self._context, self.transactions, before_zeroing=self._forget_places)

    @cached_property
    def bus(self) -> BusAccess:
        """The part that gives the bus monitor access to the bus."""
        return BusAccess(self._context)

    @cached_property
    def episodes(self) -> Episodes:
        """The part that marks episodes in the log that is being written."""
        return Episodes(self._context)

    @cached_property
    def sessions(self) -> SessionRecorder:
        """The part that records what is on the bus."""
        recorder = SessionRecorder(
            self._context, self.events, self, self.cell.holding, self.episodes
        )
        if self.session_choices is not None:
            recorder.choose(self.session_choices())
        return recorder

    def on_sessions_chosen(self) -> None:
        """Take over the operator's choices for the recording of sessions."""
        if self.session_choices is not None and "sessions" in vars(self):
            self.sessions.choose(self.session_choices())

    @cached_property
    def event_collector(self) -> EventCollector:
        """The part that writes events down; created with the first part that causes events."""
        from armui.control.event_log.collector import EventCollector  # noqa: PLC0415 - cantools

        return EventCollector(self._context, self._wall, self.player, self.recovery)

    @property
    def events(self) -> EventLog:
        """The event log: commands, changes of status, faults."""
        return self.event_collector.log

    @cached_property
    def model_watch(self) -> ModelWatch:
        """The part that compares the chosen model with the arm's reports."""
        return ModelWatch(self._context)

    @cached_property
    def _dropped_frames(self) -> DroppedFrames:
        return DroppedFrames(self._context)

    @cached_property
    def _late_feedback(self) -> LateFeedback:
        return LateFeedback(self._context)

    def _all_parts(self) -> tuple[ControllerPart, ...]:
        """Return those that follow an arm, in the order in which they act; recovery is last."""
        return (
            self.motors,
            self.gate,
            self.motion,
            self.planned_motion,
            self.player,
            self.speed_override,
            self.cartesian,
            self.area_guard,
            self.cell,
            self.gripper,
            self.linkage,
            self.jogging,
            self.replayer,
            self.recorder,
            self.transactions,
            self.settings,
            self.teaching,
            self.inspection,
            self._resume_slips,
            self.reference,
            self.sinking,
            self.mode_exit,
            self._dropped_frames,
            self._late_feedback,
            self.model_watch,
            self.event_collector,
        )

    @cached_property
    def operations(self) -> Operations:
        """The operations: all that an operator can do to the arm, by id."""
        parts = (self.motors, self.joint_errors, self.zeroing, self.lights, self.gripper)
        more = (self.linkage, self.end_reports, self.mounting, self.teaching, self.settings)
        motions = (self.motion, self.cartesian, self.jogging, self.planned_motion)
        runs = (self.player, self.replayer, self.speed_override, self.recorder, self.inspection)
        rest = (self.cell, self.reference, self.episodes)
        return Operations((*parts, *more, *motions, *runs, *rest))

    # Ending activities of several parts -------------------------------------------------------

    def _end_driven(self) -> None:
        self.player.stop()
        self.replayer.stop()
        self.jogging.stop()
        self.gate.halt()

    def _end_run_because(self, reason: Refusal) -> None:
        self.player.end_run(reason)
        self.replayer.end_run(reason)

    def _forget_places(self) -> None:
        """Forget all targets: after a change of zero the same angles mean other places."""
        self._context.authority.end_command(End.ZERO_CHANGED)
        self.reference.places_change()
        self.player.drop()

    # Declared as operations of the controller itself ------------------------------------------

    def emergency_stop(self) -> None:
        """See :meth:`ArmController.emergency_stop`."""
        raise NotImplementedError

    def halt_and_hold(self) -> Refusal | None:
        """See :meth:`ArmController.halt_and_hold`."""
        raise NotImplementedError

    def withdraw_stop(self) -> None:
        """See :meth:`ArmController.withdraw_stop`."""
        raise NotImplementedError

    def take_over(self) -> Refusal | None:
        """See :meth:`ArmController.take_over`."""
        raise NotImplementedError
