"""Carries out the operator's actions: each is checked, sent and followed in the feedback.

The controller lives in the GUI thread. It never blocks: each tick of its timer takes in what the
bus thread has received, and advances whatever is under way.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Container, Sequence
from datetime import datetime
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from armui.arm.device import Device
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.bus.link import BusReport
from armui.control.assessment_inputs import Assessor
from armui.control.authority import Authority
from armui.control.authority_watch import AuthorityWatch
from armui.control.controller_parts import ControllerParts
from armui.control.events import Event, Notice
from armui.control.link.connection import (
    CONNECT_FAILED,
    DISCONNECTED,
    LINK_BREAKS,
    LINK_LOST_NOTICE,
    Connection,
)
from armui.control.link.device_finder import DeviceFinder
from armui.control.link.link_watch import LinkWatch
from armui.control.motion.abort import abort_motion, clearing_frames
from armui.control.motion.motion_command import End
from armui.control.motion.motion_context import MotionContext
from armui.control.motion_end import MotionEnd
from armui.control.operating_state import Busy, OperatingState
from armui.control.parts import Parts
from armui.control.safety.emergency_stop import is_stopped
from armui.control.safety.stopping import Stopping
from armui.protocol.codes import TrajectoryCommand
from armui.system.clock import steady_s, wall_clock
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from armui.bus.worker import Opener
    from armui.control.link.arm_mark import ArmMark
    from armui.control.link.connection import LINK_BREAKS, MakeWorker
    from armui.control.operations.started import Started
    from armui.control.safety.gate import Background
    from armui.telemetry.store import Telemetry

RUN_LEFT = Reason(
    "run_left",
    "The device was disconnected while it ran: the arm was told before to end its motion.",
)
SYSTEM_ENDS = Reason(
    "system_ends",
    "The computer was about to sleep, or to end this program: the arm was told before to end "
    "its motion.",
)
QUESTION_WITHDRAWN = Notice(
    "question_withdrawn", "“{question}” was withdrawn. {reason}", Level.WARNING, EventKind.COMMAND
)


_TICK_MS: Final = 33
"""The period of the timer that takes in the feedback and advances everything under way."""
_SENT_WITHIN_S: Final = 0.15
"""At its end the program waits this long for queued frames, such as an abort, to be sent."""
_END_S: Final = 1.0
"""At its end the program waits this long for the device to be closed, and for a search."""


class ArmController(ControllerParts):
    """The interface of the windows to the arm.

    Every operation returns at once: its :class:`Started` if it is under way, or a :class:`Refusal`
    if nothing was sent. That record and the signals tell its outcome.

    Args:
        opener: Opens a device; see :data:`armui.bus.worker.Opener`.
        simulated: The simulated arms, which are listed with the devices found.
        find: The search for devices.
        clock: Monotonic time in seconds.
        wall: Returns the local time of a monotonic time; by default by this computer's clock.
        make_worker: Makes what stands in the place of the bus thread, as for a log.
        wait: Lets seconds pass, at the end of the program.
        background: Has a thread check a long way; by default one of the gate's own.

    Signals:
        state_changed: An :class:`ArmState`, at most 30 times a second, when something was heard.
        operating_state_changed: A :class:`OperatingState`, when it differs.
        devices_found: A list of :class:`Device`, the answer to :meth:`search_devices`.
        searching_changed: True if a search is under way, else false.
        operation_begun: The id of an operation that begins, whoever asked for it.
        all_motion_ended: The operator has stopped or halted the arm, or a failure or the system has
            ended every motion: a motion that was about to begin must not begin any more.
    """

    state_changed = Signal(object)
    operating_state_changed = Signal(object)
    devices_found = Signal(object)
    searching_changed = Signal(bool)
    operation_begun = Signal(str)
    all_motion_ended = Signal()

    def __init__(
        self,
        opener: Opener,
        simulated: Sequence[Device] = (),
        find: Callable[[], list[Device]] | None = None,
        clock: Callable[[], float] = steady_s,
        parent: QObject | None = None,
        *,
        wall: Callable[[float], datetime] | None = None,
        make_worker: MakeWorker | None = None,
        wait: Callable[[float], object] = time.sleep,
        background: Background | None = None,
    ) -> None:
        super().__init__(parent)
        # Connected first: other receivers of the signal look up the log entry that this slot makes.
        self.noticed.connect(self._on_noticed)
        self._replays = make_worker is not None
        self._background = background
        self._clock, self._wall, self._wait = clock, wall or wall_clock(clock), wait
        self._finder = DeviceFinder(simulated, find, self)
        self._finder.found.connect(self.devices_found)
        self._finder.searching_changed.connect(self.searching_changed)
        self._connection = Connection(opener, clock, self, make_worker)
        self._connection.changed.connect(self._on_connection)
        self._connection.arm_came.connect(self._on_arm_came)
        self._stop = Stopping(self._connection, self._emit_event, clock, lambda: self._parts.halt())  # noqa: PLW0108
        authority = self._authority = Authority()
        self._watch = AuthorityWatch(
            authority, self._connection, self._emit_event, self._end_too_fast
        )
        self._assessor = Assessor(
            *(self, self._connection, self._stop, self._watch, clock),
            state=lambda: self._state,
            announce=self.operating_state_changed.emit,
        )
        self._refresh = self._assessor.refresh
        self._context = MotionContext(
            self._connection,
            self._emit_event,
            clock,
            lambda: self._state,
            self._assessor.read,
            self._assessor.refresh,
            self._assessor.observe,
            authority,
            self.operation_begun.emit,
            lambda: self.gate,
        )
        self._parts = Parts(self._emit_event, self._on_part_failed)
        self._motion_end = MotionEnd(
            self, self._context, lambda: self._stop.emergency_stop.requested
        )
        self._link_watch = LinkWatch(self._connection, self._emit_event)
        self._was_stopped = self._lets_finish = False
        self._state = ArmState()
        self._timer = QTimer(self, interval=_TICK_MS, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self.tick)

    @property
    def state(self) -> ArmState:
        """The arm's state at the last tick."""
        return self._state

    @property
    def newest(self) -> ArmState:
        """The arm's state up to this moment; may be read from any thread."""
        return self._connection.newest

    @property
    def telemetry(self) -> Telemetry:
        """The record of feedback and commands over time."""
        return self._connection.telemetry

    @property
    def operating_state(self) -> OperatingState:
        """The actions that are open to the operator now, and the reasons against the others."""
        return self._assessor.read()

    @property
    def mark(self) -> ArmMark:
        """The arm and the connection at this moment, to be kept with a question, press or check."""
        return self._connection.mark

    def report_withdrawn(self, question: str, reason: Refusal) -> None:
        """Tell the operator that a question, or a held button, no longer counts.

        Args:
            question: Its title in the operator's language.
            reason: Why it no longer counts.
        """
        self._emit_event(QUESTION_WITHDRAWN, question=question, reason=reason)

    # Devices ----------------------------------------------------------------------------------

    def search_devices(self) -> None:
        """Search for devices; :attr:`devices_found` gives the result."""
        self._finder.start()

    @staticmethod
    def interfaces() -> list[str]:
        """Return the back-ends that python-can has on this computer."""
        from armui.bus.adapters import interfaces  # noqa: PLC0415 - loaded when asked for

        return interfaces()

    def expect_device(self) -> None:
        """Show that a device is about to be connected: loading what that needs takes a while."""
        self._connection.expect()
        self._refresh()

    def connect_device(self, device: Device) -> None:
        """Leave the present device, if any, and open this one."""
        self.disconnect_device()
        self._stop.on_connecting(device)
        self.cartesian.prepare()
        self._parts.set_parts(self._all_parts(), last=self.recovery)
        self.cell.begin_device(device)
        if not self._replays:
            self.sessions  # noqa: B018 - creates it: it keeps every frame from the first on
        self._connection.open(device)
        self._timer.start()
        self._refresh()
        self.recovery.follow_arm()

    def disconnect_device(self) -> None:
        """End the motions that this program drives, and close the device; the arm keeps its power.

        A run, a replay, a jog and a motion paused from here end where the arm is. A single motion
        the arm has been sent on goes to its target.
        """
        device = self._connection.device
        if device is None:
            return
        self._end_run_because(RUN_LEFT())
        if self._authority.holds:
            abort_motion(self._context)
        self._forget_arm()
        self._connection.close()
        self.cell.end_device()
        self._timer.stop()
        self._state = ArmState()
        self._emit_event(DISCONNECTED, device=device)
        self.state_changed.emit(self._state)
        self._refresh()
        self.recovery.follow_arm()

    def let_motion_finish(self) -> None:
        """Let a single motion go on to its target after the program's end, as was chosen."""
        self._lets_finish = True

    def shutdown(self) -> bool:
        """End the motion, close the device as :meth:`disconnect_device` does, end every thread.

        Returns:
            True if all threads have ended within two seconds; a driver may hold one up.
        """
        self._motion_end.end_motion(RUN_LEFT, single=not self._lets_finish)
        self._motion_end.await_rest(self.tick, self._wait)
        self._connection.wait_until_sent(_SENT_WITHIN_S)
        self.disconnect_device()
        closed = self._connection.end(_END_S)
        # Parts are created at first use, so only those in `vars` exist; the others have nothing to
        # end.
        written = "sessions" not in vars(self) or self.sessions.end()
        unread = "gamepad" not in vars(self) or self.gamepad.end()
        self.gate.end()
        return all((written, unread, self._finder.end(_END_S), closed))

    def emergency_stop(self) -> None:
        """Stop the arm at once: past every other frame, whatever else is under way (0x150)."""
        self._stop.stop()
        self._parts.attempt("Assessor", self._refresh)
        self.all_motion_ended.emit()

    def withdraw_stop(self) -> None:
        """Withdraw a stop that the arm has not confirmed."""
        self._stop.withdraw()
        self._refresh()

    def halt_and_hold(self) -> Refusal | None:
        """End any motion with power on: the joints hold where they come to rest (0x150)."""
        refusal = self._stop.halt(self._end_all_motion)
        self._parts.attempt("Assessor", self._refresh)
        self.all_motion_ended.emit()
        return refusal

    def stop_again_when_undone(self, on: bool) -> None:
        """Set whether a stop that another host undoes is sent again automatically."""
        self._stop.stop_again = on

    def begin(self, name: str, *arguments: Any, **named: Any) -> Started | Refusal | None:
        """Carry out an operation by its id, for a client that follows its outcome.

        Args:
            name: The id, a key of :attr:`operations`.
            *arguments: The positional arguments of its method.
            **named: The keyword arguments of its method.

        Returns:
            The record of the command, or why it was refused; ``None`` where nothing began: an
            operation that only reads (``settings.read``), a value that is set already, a run that
            takes its next step.

        Raises:
            KeyError: No operation has the id.
        """
        answer: Started | Refusal | None = self.operations[name].carry_out(*arguments, **named)
        return answer

    def _emit_event(
        self, notice: Notice, started: Started | None = None, /, **params: object
    ) -> None:
        self.noticed.emit(Event(self._wall(self._clock()), notice, params, started))

    def _on_noticed(self, event: Event) -> None:
        self.event_collector.on_noticed(event)

    def tick(self) -> None:
        """Take in the feedback and advance what is under way; the controller's timer calls it."""
        now_s = self._clock()
        before = self._state
        attempt = self._parts.attempt  # whatever fails, a stop is repeated, and motion ended
        attempt("Connection", lambda: self._hear(now_s))
        attempt("Stopping", lambda: self._follow_stop(now_s))
        attempt("AuthorityWatch", lambda: self._watch.follow_arm(now_s))
        attempt("Assessor", self._assessor.assess)
        self._parts.follow_arm()
        attempt("LinkWatch", lambda: self._link_watch.follow_handshake(self._state))
        attempt("Assessor", self._assessor.assess, step="2")  # parts have acted meanwhile
        self._parts.follow_arm_last()
        attempt("MotionEnd", lambda: self._motion_end.retry_end(now_s))
        self._authority.failed = self._motion_end.stuck or not self._parts.in_order
        if self._state is not before:
            self.state_changed.emit(self._state)

    def _hear(self, now_s: float) -> None:
        self._state = self._connection.follow_arm(now_s)
        self._link_watch.follow_online(now_s)

    def on_failure(self) -> None:
        """End every motion of this program, because a part of the program has failed."""
        if not self._motion_end.busy:
            self._motion_end.end_motion()
            # The call that failed may still go on to begin a motion: end it once more afterwards
            # (S23).
            QTimer.singleShot(0, self, self._motion_end.end_motion)
            self.all_motion_ended.emit()

    def end_motion_of(self, records: Container[Started]) -> None:
        """End the motion, with power on, and drop what waits, that carry out these operations.

        A gripper that is on its way by one of them ends where it is.
        """
        ends_gripper = self.gripper.carries_out(records)
        for run in (self.player, self.replayer):
            if run.carries_out(records):
                ends_gripper = True
                refusal = self.operating_state.cannot_run
                run.stop() if refusal is None else run.end_run(refusal)
        if ends_gripper:
            self.gripper.end_travel()
        self.gate.drop_of(records)
        if self._authority.carries_out(records):
            abort_motion(self._context)

    def end_all_motion(self) -> None:
        """End every motion of this program, because the system is about to end it or to sleep."""
        self._motion_end.end_motion(SYSTEM_ENDS)
        self.all_motion_ended.emit()

    def abort_from_any_thread(self) -> bool:
        """Tell the arm to end a motion of ours, also while the window's thread is held up.

        Returns:
            True if there is a motion that is not known to have ended.
        """
        return self._motion_end.abort_from_any_thread()

    def _on_part_failed(self) -> None:
        self._authority.failed = True
        if not self._motion_end.busy:
            self._motion_end.end_motion()
            self.all_motion_ended.emit()

    def _follow_stop(self, now_s: float) -> None:
        resuming = self.motors.busy is Busy.RESUMING
        self._stop.follow_arm(self._state, now_s, resuming=resuming, still=self._authority.at_rest)
        stopped = is_stopped(self._state)
        if stopped and not self._was_stopped:
            self._parts.halt()
        self._was_stopped = stopped

    def take_over(self) -> Refusal | None:
        """Take the arm over from another host that pauses; return ``None``, or why not."""
        refusal = self._watch.take_over(self._clock())
        if refusal is not None:
            return self._context.refuse(refusal)
        self._refresh()
        return None

    def _end_too_fast(self, reason: Refusal) -> None:
        self._end_run_because(reason)
        self.jogging.stop()
        abort_motion(self._context)

    def _on_connection(self, report: BusReport, notice: Notice) -> None:
        if notice == LINK_LOST_NOTICE:
            self._parts.forget_arm()
        elif notice == CONNECT_FAILED:
            self._timer.stop()
            self._forget_arm()
        # Going to another place of a replayed log breaks the link, too; that is no loss to report.
        if report.device.recorded is None or notice not in LINK_BREAKS:
            self._emit_event(notice, device=report.device, reason=report.problem)
        self._refresh()
        self.recovery.follow_arm()

    def _on_arm_came(self) -> None:
        """Forget what was read and saved before: it may have been another arm's."""
        self._link_watch.arm_came()
        self.cell.arm_came()
        self._authority.end_command(End.SILENT)
        self.settings.forget_arm()
        self.model_watch.forget_arm()

    def _forget_arm(self) -> None:
        self._parts.forget_arm()
        self._authority.end_command(End.FORGOTTEN)
        self._watch.reset(self._clock())
        self._link_watch.reset()
        self._was_stopped = False

    def end_motion(self, *, single: bool = False) -> None:
        """End the motions that this program drives: the arm comes to rest and stays powered.

        That is a run, a replay, a jog or a motion paused from here.

        Args:
            single: True to end a single motion of this program, too.
        """
        self._end_driven()
        if single and self._authority.may_be_ours:
            abort_motion(self._context)
        if self._authority.holds:
            self.planned_motion.command(TrajectoryCommand.ABORT)
        self._refresh()

    def _end_all_motion(self) -> None:
        """End the activity of every part after a halt, and drop the targets that may come back."""
        self._end_driven()
        if frames := clearing_frames(self._context):
            self._connection.send_urgent(frames)
        self._authority.cancelled(self._clock())
        for part in (self.motion, self.planned_motion, self.speed_override, self.mode_exit):
            part.halt()
        self.teaching.drop_replay()
        self.gripper.end_travel()
