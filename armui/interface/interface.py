"""The local interface: carries out the calls of clients in the window's thread (S29, S30).

Every operation passes the same checks as a press: it is called by its id, and every motion passes
the gate. The operator grants the lease and each consent by a held press, and ends both at any time.
"""

from __future__ import annotations

import errno
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from armui.arm.figures import check_figure
from armui.arm.limits import check_joints
from armui.arm.refusal import Refusal
from armui.control.events import Event, Notice
from armui.control.motion.motion_command import Mover
from armui.control.motion.target_stream import TargetJog, angles_of_pose
from armui.control.operating_state import StopState
from armui.control.operations.operation import Consent
from armui.control.operations.started import Ending, Started
from armui.control.safety.gate import AGREED
from armui.control.safety.interlocks import JOINTS_UNKNOWN
from armui.interface import answers, reasons
from armui.interface.interface_view import Consented, InterfaceView
from armui.interface.lease import (
    GRANT_WITHIN_S,
    LEASE_ARM_CHANGED,
    LEASE_CLIENT_GONE,
    LEASE_DECLINED,
    LEASE_FAULT,
    LEASE_MOVES_NOTHING,
    LEASE_OPERATOR_MOVED,
    LEASE_OTHER_HOST,
    LEASE_PROGRAM_ENDS,
    LEASE_RELEASED,
    LEASE_STOPPED,
    LEASE_TAKEN_BACK,
    LEASE_TOO_FAST,
    Ask,
    Lease,
    Lessor,
    fault_of,
)
from armui.interface.messages import (
    Call,
    CallError,
    Code,
    Json,
    ended,
    english,
    figures,
    plain,
    plain_outcome,
    refused,
)
from armui.interface.methods import METHODS, read
from armui.interface.plain_forms import UNLEASED, WITHOUT, asks, taken

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.link.arm_mark import ArmMark
    from armui.control.operating_state import OperatingState
    from armui.control.operations.operation import BoundOperation, Operation
    from armui.control.run.preflight import Works
    from armui.control.run.run_request import RunRequest
    from armui.interface.server import ClientSession, Server, Target
    from armui.interface.trajectories import Trajectories
    from armui.telemetry.events import EventOutcome
    from armui.trajectory.library.store import Library
    from armui.trajectory.planning.findings import Finding

_TICK_MS: Final = 33
_RUN: Final = "run.start"
_OF_LIBRARY: Final = ("trajectory.list", "trajectory.get", "trajectory.check", "trajectory.plan")
_OTHERS: Final = frozenset({Mover.OTHER_HOST, Mover.LEADER, Mover.HAND})
_MOST_MOVING: Final = 64
"""The number of a lease's newest operations that are kept; older ones only until they end. So the
motion under way and the one that waits are always among them."""
_LONGEST_TEXT: Final = 200


@dataclass(frozen=True, slots=True)
class Shelf:
    """The library for clients.

    Attributes:
        works: Runs their checks, and reads its files.
        library: Makes it, once the first client asks.
    """

    works: Works
    library: Callable[[], Library]


@dataclass(slots=True)
class _Waiting:
    session: ClientSession
    call: Call
    bound: BoundOperation | None = None
    consented: Consented | None = None


@dataclass(slots=True)
class _Followed:
    session: ClientSession
    started: Started
    sent: tuple[object, ...] = field(default=())


class Interface(QObject):
    """The local interface of one program.

    Args:
        controller: Carries everything out.
        path: The socket.
        clock: Monotonic time in seconds, the controller's.
        grants_itself: True if there is no operator: everything is granted without a question. Only
            for a simulated arm on a bus of its own.
        shelf: The library; without one its methods fail.

    Signals:
        changed: A :class:`InterfaceView`, when it differs.
    """

    changed = Signal(object)
    _opened = Signal(object, object)
    _called = Signal(object, object)
    _target_came = Signal()
    _gone = Signal(object)

    def __init__(
        self,
        controller: ArmController,
        path: Path,
        clock: Callable[[], float],
        *,
        grants_itself: bool = False,
        shelf: Shelf | None = None,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._controller = controller
        self._path = path
        self._clock = clock
        self._grants_itself = grants_itself
        self._shelf = shelf
        self._server: Server | None = None
        self._serves = False
        self._lessor = Lessor()
        self._asking: _Waiting | None = None
        self._consent: _Waiting | None = None
        self._followed: list[_Followed] = []
        self._holder: ClientSession | None = None
        self._mark: ArmMark | None = None
        self._began: tuple[StopState, int | None] | None = None
        self._last_stream: Started | None = None
        self._most_percent = 0
        self._slowed = False
        self._moving: list[Started] = []
        self._calling = False
        self._doing: Started | None = None
        self._problem: Refusal | None = None
        self._view = InterfaceView()
        self._trajectories: Trajectories | None = None
        self._run: tuple[_Waiting, RunRequest] | None = None
        self._methods: Mapping[str, Callable[..., object]] = {
            "hello": lambda waiting, **_: answers.hello(controller, waiting.session.client.number),
            "stop": self._stop,
            "halt": self._halt,
            "operations.list": lambda _waiting: answers.operations(controller),
            "kinematics.fk": lambda _waiting, **named: answers.forward(controller, **named),
            "kinematics.ik": lambda _waiting, **named: answers.inverse(controller, **named),
            "lease.request": self._ask,
            "lease.release": self._release,
            "stream.end": self._stream_ends,
            **{each: partial(self._ask_library, each) for each in _OF_LIBRARY},
            "trajectory.run": self._run_trajectory,
            "trajectory.stop": self._end_motion,
        }
        queued = Qt.ConnectionType.QueuedConnection
        self._opened.connect(self._on_opened, queued)
        self._called.connect(self._on_call, queued)
        self._target_came.connect(self._on_target, queued)
        self._gone.connect(self._on_gone, queued)
        controller.noticed.connect(self._on_noticed)
        controller.operation_begun.connect(self._on_begun)
        controller.all_motion_ended.connect(self._on_all_motion_ended)
        controller.state_changed.connect(self.tick)
        controller.operating_state_changed.connect(self.tick)
        self._timer = QTimer(self, interval=_TICK_MS)
        self._timer.timeout.connect(self.tick)

    @property
    def view(self) -> InterfaceView:
        """What the window shows of the interface now."""
        return self._view

    def seconds_since(self, at_s: float) -> float:
        """Return how long ago a monotonic time was."""
        return self._clock() - at_s

    # By the operator --------------------------------------------------------------------------

    def switch(self, *, on: bool) -> None:
        """Serve the socket, or close it and end every lease."""
        if not on:
            self.end()
        elif self._server is None:
            self._problem = self._open()
        self._show()

    def _open(self) -> Refusal | None:
        system: str = sys.platform  # as a str, so that mypy checks the code for every system
        if system != "linux":
            return reasons.INTERFACE_NOT_HERE()
        from armui.interface.server import Server  # noqa: PLC0415 - asyncio

        server = self._server = Server(
            self._path,
            lambda: self._controller.newest,
            on_opened=lambda error: self._opened.emit(server, error),
            on_call=self._called.emit,
            on_target=self._target_came.emit,
            on_gone=self._gone.emit,
            clock=self._clock,
        )
        server.start()
        return None

    def _on_opened(self, server: Server, error: OSError | None) -> None:
        if server is not self._server:
            return  # the interface was switched off meanwhile
        if error is None:
            self._serves = True
            self._timer.start()
        else:
            self._server = None
            taken = error.errno == errno.EADDRINUSE
            path, text = str(self._path), str(error)
            self._problem = (
                reasons.INTERFACE_TAKEN(path=path)
                if taken
                else (reasons.INTERFACE_NOT_OPENED(path=path, text=text))
            )
        self._show()

    def end(self) -> bool:
        """Close the socket and end every lease; return whether the server's thread has ended."""
        server, self._server = self._server, None
        self._problem, self._serves = None, False
        self._timer.stop()
        self._end_lease(LEASE_PROGRAM_ENDS())
        self._give_up_asking(LEASE_PROGRAM_ENDS())
        self._followed.clear()
        return server is None or server.stop()

    def grant(self, max_speed_percent: int, *, for_session: bool = False) -> None:
        """Grant the arm to the client that asks for it; the operator has held the button."""
        lease = self._lessor.grant(max_speed_percent, self._clock(), for_session=for_session)
        if lease is not None:
            self._granted(lease)

    def _granted(self, lease: Lease) -> None:
        waiting, self._asking = self._asking, None
        now = self._controller.operating_state
        self._mark = self._controller.mark
        self._began = now.stop, fault_of(now.status)
        self._most_percent, self._slowed = lease.max_speed_percent, False
        self._cap_speed(lease)
        self._emit_event(
            reasons.LEASE_GRANTED, client=str(lease.ask.client), percent=lease.max_speed_percent
        )
        if waiting is not None:
            self._holder = waiting.session
            value = {"lease": lease.number, "max_speed_percent": lease.max_speed_percent}
            self._answer(waiting, value)
        self._show()

    def decline(self) -> None:
        """Refuse the arm to the client that asks for it."""
        self._give_up_asking(LEASE_DECLINED())

    def take_back(self) -> None:
        """End the lease: the arm is the operator's again, and its motion ends."""
        self._end_lease(LEASE_TAKEN_BACK())

    def consent(self, *, given: bool) -> None:
        """Let the client do what it asks for, or refuse it, as the operator has answered."""
        if not given:
            self._refuse_consent(LEASE_DECLINED())
            return
        waiting, self._consent = self._consent, None
        if waiting is None or waiting.consented is None:
            return
        told = waiting.consented
        self._emit_event(reasons.CONSENT_GRANTED, client=str(told.client), operation=told.title)
        if self._run is not None and self._run[0] is waiting:
            self._run[1].accept()
        elif waiting.bound is not None:
            self._begin(waiting.session, waiting.call, waiting.bound)
        self._show()

    def _refuse_consent(self, reason: Refusal) -> None:
        """Answer the call that waits for the operator's consent with a refusal, and drop it."""
        waiting = self._consent
        if self._run is not None and self._run[0] is waiting:
            self._give_up_run(reason)
        elif waiting is not None:
            self._answer(waiting, refused(reason))
        self._show()

    # From the server's thread -----------------------------------------------------------------

    def _on_gone(self, session: ClientSession) -> None:
        self._followed = [each for each in self._followed if each.session is not session]
        if self._asking is not None and self._asking.session is session:
            self._give_up_asking(LEASE_CLIENT_GONE())
        held = self._lessor.held
        if held is not None and held.ask.client.number == session.client.number:
            self._end_lease(LEASE_CLIENT_GONE())
        self._lessor.take_back(session.client)
        self._show()

    def _on_call(self, session: ClientSession, call: Call) -> None:
        waiting = _Waiting(session, call)
        try:
            value = self._carry_out(waiting)
        except CallError as wrong:
            self._answer(waiting, wrong)
        except Exception:
            self._answer(waiting, CallError(Code.INTERNAL, "The program failed at this call."))
            raise
        else:
            if value is not None:
                self._answer(waiting, value)
        self._show()

    def _carry_out(self, waiting: _Waiting) -> object:
        """Carry out a call; return the answer, or ``None`` if it follows later."""
        call = waiting.call
        own = self._methods.get(call.method)
        if own is not None:
            if METHODS[call.method].leased:
                self._lease_of(waiting)
            return own(waiting, **read(call.method, call.params))
        bound = self._controller.operations.get(call.method)
        if bound is None or call.method in WITHOUT:
            why = f" {WITHOUT[call.method]}." if call.method in WITHOUT else ""
            raise CallError(Code.METHOD, f"There is no method “{call.method}”.{why}")
        return self._operation(waiting, bound)

    def _stop(self, _waiting: _Waiting) -> Json:
        self._controller.emergency_stop()
        return {}

    def _halt(self, _waiting: _Waiting) -> Json:
        refusal = self._controller.halt_and_hold()
        if refusal is not None:
            raise refused(refusal)
        return {}

    def _release(self, _waiting: _Waiting) -> Json:
        self._end_lease(LEASE_RELEASED())
        return {}

    def _stream_ends(self, _waiting: _Waiting) -> Json:
        self._end_stream()
        return {}

    # The lease --------------------------------------------------------------------------------

    def _ask(self, waiting: _Waiting, *, purpose: str, moves: bool, max_speed_percent: int) -> None:
        purpose = "".join(each for each in purpose if each.isprintable())[:_LONGEST_TEXT]
        client = waiting.session.client
        refusal = self._why_no_lease() or self._lessor.ask(
            Ask(client, purpose, moves, max_speed_percent, self._clock())
        )
        if refusal is not None:
            raise refused(refusal)
        self._emit_event(reasons.LEASE_ASKED, client=str(client), purpose=purpose)
        self._asking = waiting
        if self._lessor.held is not None:
            self._granted(self._lessor.held)
        elif self._grants_itself:
            self.grant(max_speed_percent)

    def _why_no_lease(self) -> Refusal | None:
        """Return why no client can be granted the arm now, or ``None``."""
        now, self._began = self._controller.operating_state, None
        return now.unreachable or self._why_over(now, self._controller.mark)

    def _lease_of(self, waiting: _Waiting) -> Lease:
        found = self._lessor.lease_of(waiting.session.client, waiting.call.params.get("lease"))
        if isinstance(found, Refusal):
            raise refused(found)
        return found

    def _give_up_asking(self, reason: Refusal) -> None:
        ask, waiting = self._lessor.decline(), self._asking
        self._asking = None
        if ask is not None:
            self._emit_event(reasons.LEASE_REFUSED, client=str(ask.client), reason=reason)
        if waiting is not None:
            self._answer(waiting, refused(reason))
        self._show()

    def _end_lease(self, reason: Refusal) -> None:
        """End the lease and all that depends on it, and halt the client's motion with power on."""
        lease = self._lessor.end()
        if lease is None:
            return
        if reason.reason != LEASE_RELEASED:
            # a grant for the whole session ends, too: the operator has to decide again
            self._lessor.take_back(lease.ask.client)
        self._end_stream()
        self._doing = None
        # the stop has ended every motion; else only the client's own ends, not the operator's
        if reason.reason != LEASE_STOPPED:
            self._controller.end_motion_of(self._moving)
        self._moving.clear()
        self._emit_event(reasons.LEASE_ENDED, client=str(lease.ask.client), reason=reason)
        if self._server is not None:
            params = {"lease": lease.number, "state": "ended", "reason": plain(reason)}
            if self._holder is not None:
                self._server.send_notification("lease", params, self._holder)
            self._holder = None
        self._refuse_consent(reason)  # last, so that the client first reads that the lease ended
        self._give_up_run(reason)
        self._show()

    def _cap_speed(self, lease: Lease) -> None:
        """Lower the operator's speed to the granted one if it is higher."""
        if self._controller.motion.speed_percent > lease.max_speed_percent:
            self._calling = True
            try:
                self._controller.motion.set_speed_percent(lease.max_speed_percent)
            finally:
                self._calling = False

    # Operations -------------------------------------------------------------------------------

    def _operation(self, waiting: _Waiting, bound: BoundOperation) -> object:
        operation = bound.operation
        lease = None if operation.id in UNLEASED else self._lease_of(waiting)
        if operation.moves and lease is not None and not lease.ask.moves:
            raise refused(LEASE_MOVES_NOTHING())
        taken(bound.carry_out, waiting.call.params)  # raises if malformed: nobody is asked
        if operation.id == "motion.set_speed" and lease is not None:
            percent = waiting.call.params["percent"]
            if self._slowed:  # the operator has set a speed: the client may only go slower
                his = self._controller.motion.speed_percent
                self._most_percent, self._slowed = min(lease.max_speed_percent, his), False
            if percent > self._most_percent:
                raise refused(LEASE_TOO_FAST(value=percent, maximum=self._most_percent))
        client = waiting.session.client
        self._emit_event(reasons.CLIENT_ASKS, client=str(client), operation=operation.title)
        height_mm = waiting.call.params.get("agreed_mm", 0.0)
        agrees = height_mm != 0.0 and check_figure("agreed_mm", height_mm, AGREED) is None
        # only the operator can agree that a motion goes below the floor
        if (asks(operation) or agrees) and not self._grants_itself:
            if self._consent is not None:
                raise refused(reasons.CONSENT_BUSY())
            waiting.bound = bound
            given = {name: each for name, each in waiting.call.params.items() if name != "lease"}
            self._ask_consent(waiting, operation, given)
            return None
        self._begin(waiting.session, waiting.call, bound)
        return None

    def _ask_consent(
        self,
        waiting: _Waiting,
        operation: Operation,
        given: Mapping[str, object],
        findings: tuple[Finding, ...] = (),
    ) -> None:
        """Ask the operator to let the client do something."""
        client, now_s = waiting.session.client, self._clock()
        waiting.consented = Consented(client, operation.id, operation.title, given, now_s, findings)
        self._consent = waiting

    def _by_client(self, act: Callable[[], Any], *, moves: bool = True) -> Any:
        """Call a function for a client: `_on_begun` must not take it for the operator's act."""
        lease = self._lessor.held
        if moves:
            if lease is not None:
                self._cap_speed(lease)
            self._end_stream()
        self._calling = True
        try:
            return act()
        finally:
            self._calling = False

    def _begin(self, session: ClientSession, call: Call, bound: BoundOperation) -> None:
        waiting = _Waiting(session, call)
        try:
            positional, named = taken(bound.carry_out, call.params)
        except CallError as wrong:
            self._answer(waiting, wrong)
            return
        act = partial(bound.carry_out, *positional, **named)
        operation = bound.operation
        # the gripper moves independently of the joints, so that it does not end the stream
        moves = operation.moves and not operation.id.startswith("gripper.")
        begun = self._by_client(act, moves=moves)
        if isinstance(begun, Refusal):
            self._answer(waiting, refused(begun))
        elif isinstance(begun, Started):
            self._answer(waiting, {"number": begun.number})
            self._follow_outcome(session, begun)
        else:
            self._answer(waiting, {"number": None})

    def _follow_outcome(self, session: ClientSession, started: Started) -> None:
        self._followed.append(_Followed(session, started))
        if started.operation not in UNLEASED:  # marks in the log are not ended with the lease
            kept = self._moving[-_MOST_MOVING:]
            going = [each for each in self._moving[:-_MOST_MOVING] if each.ending is None]
            self._moving = [*going, *kept, started]
            self._doing = started

    def _on_begun(self, name: str) -> None:
        """End the lease when the operator moves the arm, or does what needs his consent."""
        held = self._lessor.held
        if self._calling or held is None:
            return
        self._slowed = self._slowed or name == "motion.set_speed"
        operation = self._controller.operations[name].operation
        if operation.moves or operation.consent is not Consent.NONE:
            self._end_lease(LEASE_OPERATOR_MOVED(operation=operation.title))

    def _on_all_motion_ended(self) -> None:
        if self._lessor.held is not None:
            self._end_lease(LEASE_STOPPED())
        if self._lessor.asked is not None:
            self._give_up_asking(LEASE_STOPPED())

    # The library ------------------------------------------------------------------------------

    def _library(self) -> Trajectories:
        if self._shelf is None:
            raise CallError(Code.METHOD, "No library is offered here.")
        if self._trajectories is None:
            from armui.interface import trajectories  # noqa: PLC0415 - numpy, scipy

            controller, clock = self._controller, self._clock
            runner = trajectories.ClientRunner(controller, self._by_client, self)
            self._trajectories = trajectories.Trajectories(
                *(controller, self._shelf.works, self._shelf.library(), runner, clock)
            )
        return self._trajectories

    def _ask_library(self, method: str, waiting: _Waiting, **named: Any) -> None:
        def answer(value: object) -> None:
            self._answer(waiting, refused(value) if isinstance(value, Refusal) else value)

        self._library().ask(method, waiting.session.client.number, answer, **named)

    def _run_trajectory(self, waiting: _Waiting, *, name: str, cycles: int, first_row: int) -> None:
        """Have a trajectory checked and run; the operator is asked as before a run of his own."""
        if not self._lease_of(waiting).ask.moves:
            raise refused(LEASE_MOVES_NOTHING())
        if self._run is not None:
            raise refused(reasons.CONSENT_BUSY())
        title = self._controller.operations[_RUN].operation.title
        self._emit_event(reasons.CLIENT_ASKS, client=str(waiting.session.client), operation=title)
        request = self._library().run(
            *(name, cycles, first_row), partial(self._on_run, waiting), self._give_up_run
        )
        self._run = waiting, request
        self._end_stream()  # as with any motion of the client, the stream ends first
        request.begin()

    def _on_run(self, waiting: _Waiting, request: RunRequest) -> None:
        """Answer a run when it has begun or is refused; ask the operator where he must agree."""
        if self._run is None or self._run[1] is not request:
            return
        begun, checked = self._library().runner.begun, request.checked
        if request.asks and self._grants_itself:
            request.accept()
        elif request.asks and self._consent is not None:
            self._give_up_run(reasons.CONSENT_BUSY())
        elif request.asks and checked is not None:
            operation = self._controller.operations[_RUN].operation
            self._ask_consent(waiting, operation, {"name": request.name}, checked.findings)
        elif request.refusal is not None:
            self._give_up_run(request.refusal)
        elif request.is_over and begun is not None:
            self._answer(waiting, {"number": begun.number})
            self._follow_outcome(waiting.session, begun)
        self._show()

    def _give_up_run(self, reason: Refusal) -> None:
        """Refuse the run that has not begun yet."""
        if self._run is not None:
            waiting, request = self._run
            self._answer(waiting, refused(reason))
            request.give_up()

    def _end_motion(self, _waiting: _Waiting) -> Json:
        self._give_up_run(reasons.RUN_CALLED_OFF())
        self._end_stream()
        self._controller.end_motion_of(self._moving)
        return {}

    # The stream -------------------------------------------------------------------------------

    def _on_target(self) -> None:
        server = self._server
        target = None if server is None else server.take_target()
        if server is None or target is None:
            return
        refusal = self._follow(target)
        value: Json | CallError = {}
        if refusal is not None:
            value = refused(refusal) if isinstance(refusal, Refusal) else ended(refusal)
        server.answer_target(target, value)

    def _follow(self, target: Target) -> Refusal | EventOutcome | None:
        """Have the arm follow a target; return why not, or why the target before was not followed.

        If the stream has ended by itself, its reason is returned; the next target begins another.
        """
        lease = self._lessor.lease_of(target.session.client, target.lease)
        if isinstance(lease, Refusal):
            return lease
        if not lease.ask.moves:
            return LEASE_MOVES_NOTHING()
        jogging = self._controller.jogging
        streamed, joints_deg = jogging.streamed, self._angles_of(target)
        if isinstance(joints_deg, Refusal):
            if streamed is not None:
                streamed.rest()
            return joints_deg
        refusal = check_joints(joints_deg, self._controller.operating_state.limits)
        if streamed is not None:
            before = streamed.refusal
            streamed.take(joints_deg)
            jogging.tick()
            return refusal or before or streamed.refusal
        if refusal is not None:
            return refusal
        last, self._last_stream = self._last_stream, None
        if last is not None and last.ending not in {None, Ending.DONE} and last.result is not None:
            reason = last.result.params.get("reason")
            return reason if isinstance(reason, Refusal) else last.result
        self._cap_speed(lease)
        begun = self._by_client(
            lambda: jogging.start(TargetJog(str(target.session.client), joints_deg)), moves=False
        )
        if isinstance(begun, Refusal):
            return begun
        self._last_stream = begun
        self._follow_outcome(target.session, begun)
        return None

    def _angles_of(self, target: Target) -> tuple[float, ...] | Refusal:
        """Return the angles of a target, or why its pose cannot be followed."""
        if target.joints_deg is not None or target.flange_pose_mm_deg is None:
            return target.joints_deg or ()
        controller = self._controller
        near_deg = controller.jogging.setpoint_deg or controller.state.angles_deg()
        if near_deg is None:
            return JOINTS_UNKNOWN()
        limits, kinematics = controller.operating_state.limits, controller.cartesian.kinematics()
        return angles_of_pose(kinematics, target.flange_pose_mm_deg, near_deg, limits)

    def _end_stream(self) -> None:
        self._last_stream = None
        if self._controller.jogging.streamed is not None:
            self._controller.jogging.stop()

    # Over time --------------------------------------------------------------------------------

    def tick(self, _state: object = None) -> None:
        """End the lease if there is a reason by now, and report the progress of operations."""
        if self._server is None:
            return
        now_s, now = self._clock(), self._controller.operating_state
        if self._holder is not None:
            self._lessor.note_activity(self._holder.client, self._holder.heard_s)
        over = self._lessor.why_over(now_s)
        if self._lessor.asked is not None:
            over = over or self._why_no_lease()
            if over is not None:
                self._give_up_asking(over)
        if self._lessor.held is not None:
            over = over or self._why_over(now, self._mark)
            if over is not None:
                self._end_lease(over)
            else:
                self._cap_speed(self._lessor.held)
        consent = self._consent
        told = None if consent is None else consent.consented
        if told is not None and now_s - told.since_s > GRANT_WITHIN_S:
            self._refuse_consent(reasons.CONSENT_NOT_GIVEN(seconds=round(GRANT_WITHIN_S)))
        self._send_outcomes()
        self._show()

    def _why_over(self, now: OperatingState, mark: ArmMark | None) -> Refusal | None:
        """Return why no client may have the arm now, or ``None``.

        A stop or fault at the time of the grant does not end the lease: it is to be recovered from.
        """
        if mark is None or now.unreachable or not mark.is_still(self._controller.mark):
            return LEASE_ARM_CHANGED()
        if now.other_host is not None:
            return now.other_host.refusal
        if now.mover in _OTHERS:
            return LEASE_OTHER_HOST()
        stop, fault = self._began or (now.stop, fault_of(now.status))
        if now.stop is not stop and now.stop in {StopState.REQUESTED, StopState.STOPPED}:
            return LEASE_STOPPED()
        if fault_of(now.status) not in {None, fault}:
            return LEASE_FAULT()
        self._began = now.stop, fault_of(now.status)
        return None

    def _send_outcomes(self) -> None:
        """Report to each client each change in the progress of its operations, and how they end."""
        server = self._server
        if server is None:
            return
        for each in list(self._followed):
            started = each.started
            found = (started.ending, started.answer, started.result)
            if found == each.sent:
                continue
            each.sent = found
            result = started.result
            ending = started.ending
            params: Json = {
                "number": started.number,
                "operation": started.operation,
                "state": "under_way" if ending is None else ending.name.lower(),
                "answered": started.answer is not None,
            }
            if result is not None:
                params["result"] = plain_outcome(result)
            server.send_notification("operation", params, each.session)
            if ending is not None:
                self._followed.remove(each)
                if self._doing is started:
                    self._doing = None

    def _on_noticed(self, event: Event) -> None:
        if self._server is not None and not event.notice.streams:
            params = {
                "at": event.at.isoformat(timespec="milliseconds"),
                "id": event.code,
                "level": event.level.name.lower(),
                "text": english(event.notice.source, event.params),
                "figures": figures(event.params),
            }
            self._server.send_notification("event", params)

    def _emit_event(self, notice: Notice, **params: object) -> None:
        self._controller.noticed.emit(Event(datetime.now().astimezone(), notice, params))

    def _answer(self, waiting: _Waiting, value: object | CallError) -> None:
        if self._run is not None and self._run[0] is waiting:
            self._run = None
        if self._consent is waiting:
            self._consent = None
        if self._server is not None:
            self._server.answer(waiting.session, waiting.call, value)

    def _show(self) -> None:
        server, doing = self._server, self._doing
        view = InterfaceView(
            on=self._serves,
            problem=self._problem,
            path=str(self._path),
            clients=() if server is None else tuple(server.clients),
            asked=self._lessor.asked,
            lease=self._lessor.held,
            doing="" if doing is None or doing.ending is not None else doing.operation,
            consent=None if self._consent is None else self._consent.consented,
        )
        if view != self._view:
            self._view = view
            self.changed.emit(view)
