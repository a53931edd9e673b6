"""The one gate: every motion of this program passes it, or its frames reach no bus (safety S35).

A part that moves the arm tells the gate what it wants as a :class:`MotionRequest`, or asks it about
a way. The gate asks who moves the arm now, has an arm that moves otherwise brake first, asks the
rules in force about the whole way (:mod:`armui.ways`), and sends. What takes longer than a moment
is worked out in a thread, and counts only while nothing it depends on has changed.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Container, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Any, Final

from armui.arm.figures import Range
from armui.arm.limits import may_lie
from armui.arm.models import model_data
from armui.arm.refusal import Reason, Refusal
from armui.control.context import COMMAND_OVER, REFUSED, Context, ControllerPart
from armui.control.events import Notice
from armui.control.motion.abort import abort_motion
from armui.control.motion.jog_pace import accelerations
from armui.control.motion.motion_command import CommandKind, End, MotionCommand, Mover
from armui.control.operations.outcome_events import close_and_emit
from armui.control.operations.started import Ending, Started
from armui.control.safety.momentum import FLUENT_DEG, Momentum, momentum
from armui.control.safety.standstill import QUIET_DEG, QUIET_S, RestWatch
from armui.telemetry.events import EventKind, Level
from armui.ways.passes import Pass

# The rules bring numpy along. They are loaded with the first arm: the window starts without them.
if TYPE_CHECKING:
    from armui.control.operating_state import OperatingState
    from armui.kinematics.poses import Matrix
    from armui.protocol.codes import MoveMode
    from armui.protocol.frame import Frame
    from armui.ways.law import Judgement, Marks
    from armui.ways.rules import Rules
    from armui.ways.swings import Swing
    from armui.ways.way import Way

NOT_IN_TIME = Reason(
    "not_in_time",
    "Nothing was sent: a second after the press the arm did not rest yet, or its way was still "
    "being checked. Press again.",
)
BEGAN_ELSEWHERE = Reason(
    "began_elsewhere",
    "Nothing was sent: while its way was checked the arm moved, or what it was checked against has "
    "changed. Press again.",
)
WAY_UNKNOWN = Reason(
    "way_unknown",
    "Nobody knows which way the arm would take, and a work area or a lowest height is in force. "
    "Switch its planes and boxes off under Cell, or the height under Settings, first.",
)
LEADS_BELOW = Reason(
    "leads_below",
    "The arm would come some {value} mm below the floor. Go there only if nothing is there. With a "
    "lowest height chosen under Settings this is not asked each time.",
)
CHECKING = Notice("checking", "Checking the way…", Level.INFO, EventKind.COMMAND, streams=True)

_WITHIN_S: Final = 0.95
"""What could not be sent within this time of its press is dropped: a second, less a tick (S14)."""
_ANNOUNCED_AFTER_S: Final = 0.05
"""A motion that waits for its check for longer than this is told the operator."""
_SAME_DEG: Final = 0.2
"""A check counts for an arm measured this near to where the checked way begins."""
_AT_ONCE: Final = 400.0
"""A way is checked in the call if its turn in degrees times what it is checked against is less."""
_SET_ANEW: Final = frozenset({Mover.HAND, Mover.OTHER_HOST, Mover.LEADER, Mover.GRAVITY})
"""Movers that may take the arm outside; how far outside it is, is then noted anew."""

AGREED: Final = Range(-5000.0, 0.0, "mm")
Agreed = Annotated[float, AGREED]
"""The height over the floor down to which the operator has agreed that a motion goes."""
Plan = Callable[[Sequence[float]], "Way | Refusal"]
"""Returns the way from six angles at which the arm rests, or why there is none."""
Background = Callable[[Callable[[], Any]], "Future[Any]"]
"""Has a thread work something out."""


def _nothing(_: object) -> None:
    """Do nothing with the command that was sent."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MotionRequest:
    """A motion that a part wants.

    Attributes:
        started: The record of its operation.
        kind, move_mode, most_percent: As in :meth:`Context.send_motion`.
        speed_percent: Returns its speed, in %: asked as it leaves, as it may have been lowered
            since the press.
        plan: Returns its way.
        frames: Returns the targets and the mode word in order for that speed, or why there are
            none.
        why_not: Returns what speaks against it beside its way, from the operating state.
        joints_deg, tool, leads_away, tool_way, keep_s: As in :meth:`Context.send_motion`.
        agreed_mm: The height over the floor down to which the operator has agreed to go, where no
            lowest one is chosen; ``None`` if that is not asked.
        sent_event: The notice, with its figures, that the operator is told once it is sent.
        sent: Called with the command once it is sent.
        refused: Called with the reason if it is refused after :meth:`Gate.send` has returned.
    """

    started: Started
    kind: CommandKind
    move_mode: MoveMode
    speed_percent: Callable[[], int]
    plan: Plan
    frames: Callable[[int], Sequence[Frame] | Refusal]
    why_not: Callable[[OperatingState], Refusal | None]
    joints_deg: Sequence[float] | None = None
    tool: Matrix | None = None
    leads_away: bool = False
    tool_way: Sequence[Sequence[float]] = ()
    keep_s: float | None = None
    most_percent: int = 100
    agreed_mm: float | None = None
    sent_event: tuple[Notice, Mapping[str, object]] | None = None
    sent: Callable[[MotionCommand], object] = _nothing
    refused: Callable[[Refusal], object] | None = None


@dataclass(slots=True)
class _Pending:
    """A motion that waits for the arm to rest, or for the answer of its check.

    Attributes:
        since_s: The time of the press.
        revision: The authority's revision at the press; the motion is void once it differs.
        job: The check in its thread; ``None`` while the arm does not rest.
        rules: The rules it is checked against.
        announced: True once the operator was notified that it is being checked.
    """

    request: MotionRequest
    since_s: float
    revision: int
    job: Future[tuple[Judgement, Way]] | None = None
    rules: Rules | None = None
    announced: bool = False


class StreamCheck:
    """Checks the setpoints of a jog; one check is valid within the free space that it found.

    Args:
        gate: Knows the rules in force.
    """

    def __init__(self, gate: Gate) -> None:
        self._gate = gate
        self._rules: Rules | None = None
        self._room_mm = 0.0

    def why_not(
        self, ahead_deg: Sequence[float], now_deg: Sequence[float], lag_deg: Sequence[float] = ()
    ) -> Refusal | None:
        """Return why the setpoint may not go on from six angles to others, or ``None``.

        Args:
            ahead_deg: The next setpoint.
            now_deg: The present one.
            lag_deg: How far each joint may lag behind the next setpoint; empty for almost no lag.
        """
        rules = self._gate.rules()
        if rules is None:
            return None
        if rules is not self._rules:
            self._rules, self._room_mm = rules, 0.0
        travel_mm = rules.travel_mm(ahead_deg, now_deg)
        lag_mm = rules.travel_mm(lag_deg, (0.0,) * len(lag_deg)) if lag_deg else 0.0
        if travel_mm + lag_mm < self._room_mm and rules.within_limits(ahead_deg):
            self._room_mm -= travel_mm
            return None
        from armui.ways.way import lagging_way, straight_way  # noqa: PLC0415 - numpy

        way = (
            lagging_way(now_deg, ahead_deg, lag_deg)
            if lag_deg
            else straight_way(now_deg, ahead_deg)
        )
        answer = self._gate.ask(way)
        self._room_mm = 0.0 if isinstance(answer, Refusal) else rules.room_mm(ahead_deg)
        return answer if isinstance(answer, Refusal) else None


class Gate(ControllerPart):
    """Checks every motion, and hands out the passes without which no motion frame is sent.

    Args:
        context: The context that the controller's parts share.
        scene: Returns what the rules depend on, and a function that makes them; the same objects
            as long as nothing has changed.
        background: Has a thread work something out; by default one of the gate's own.
    """

    def __init__(
        self,
        context: Context,
        scene: Callable[[], tuple[object, Callable[[], Rules]]],
        background: Background | None = None,
    ) -> None:
        self._context = context
        self._scene = scene
        self._background = background
        self._threads: ThreadPoolExecutor | None = None
        self._of: object = None
        self._rules: Rules | None = None
        self._marks: Marks = {}
        self._rest = RestWatch(QUIET_DEG, QUIET_S)
        self._pending: _Pending | None = None

    # Rules --------------------------------------------------------------------------------------

    def rules(self) -> Rules | None:
        """Return the rules in force; ``None`` while no arm is connected."""
        if self._context.connection.device is None:
            return None
        of, make = self._scene()
        if self._rules is None or of != self._of:
            self._of, self._rules, self._marks = of, make(), {}
        return self._rules

    # Checks -------------------------------------------------------------------------------------

    def judge(self, way: Way) -> Refusal | None:
        """Return why a way may not be driven now, or ``None``; nothing is sent, or noted."""
        rules = self.rules()
        return None if rules is None else _judge(way, rules, self._marks).refusal

    def judge_target(self, joints_deg: Sequence[float]) -> Refusal | None:
        """Return why no motion may end at six angles, or the question before it, or ``None``.

        Its way is judged when it is sent.
        """
        rules, measured_deg = self.rules(), self._context.authority.measured_deg()
        if rules is None or measured_deg is None:
            return None
        from armui.ways.law import judge_end  # noqa: PLC0415 - numpy
        from armui.ways.way import straight_way  # noqa: PLC0415 - numpy

        way = straight_way(measured_deg, joints_deg)
        return judge_end(way, rules.every, self._marks) or _leads_below(way, rules, 0.0)

    def ask(self, way: Way) -> Pass | Refusal:
        """Return the pass for a way, or why it may not be driven."""
        rules = self.rules()
        if rules is None:
            return Pass(way)
        judged = _judge(way, rules, self._marks)
        return judged.refusal or self._let_through(judged, way)

    def ask_on(self, command: MotionCommand | None) -> Pass | Refusal:
        """Return the pass for the rest of a motion that was held back, or why it may not continue.

        Args:
            command: Our command; ``None`` if its target is not known any more.
        """
        begin_deg = self._context.authority.measured_deg()
        if command is None or command.way is None or begin_deg is None:
            return self.ask_unknown()
        from armui.ways.way import rest_of  # noqa: PLC0415 - numpy

        return self.ask(rest_of(command.way, begin_deg))

    def ask_unknown(self) -> Pass | Refusal:
        """Return the pass for a motion of unknown way, or why it may not begin."""
        rules, now = self.rules(), self._context.operating_state()
        bounded = now.keeps_area or (rules is not None and rules.are_bounded)
        return WAY_UNKNOWN() if bounded else Pass()

    def passed(self, command: MotionCommand) -> Pass:
        """Return the pass that a command of ours was sent with."""
        return Pass(command.way, self.rules())

    def ask_within(self, passed: Pass | None) -> Pass | Refusal:
        """Return the pass for the next setpoint of a stream whose whole way was passed.

        Args:
            passed: The pass of its way; ``None`` if it has none.
        """
        if passed is None or passed.rules is not self.rules():
            return BEGAN_ELSEWHERE()
        return passed

    def ask_held(self) -> Pass:
        """Return the pass for a frame typed by hand, whose way is unchecked: its button is held."""
        return Pass()

    def ask_no_way(self) -> Pass:
        """Return the pass for frames that move no joint: a speed, a mounting, the gripper.

        The rules enclose the gripper at every opening, so that it needs no way of its own.
        """
        return Pass()

    def ways_inside(self) -> tuple[tuple[float, ...], ...]:
        """Return the targets that bring an arm that lies outside its limits inside, in turn."""
        measured_deg = self._context.authority.measured_deg()
        limits = self._context.operating_state().limits
        if measured_deg is None or not may_lie(measured_deg, limits):
            return ()
        rules = self.rules()
        if rules is None:
            return ()
        from armui.ways.inside import ways_inside  # noqa: PLC0415 - numpy

        return ways_inside(measured_deg, rules)

    def stream(self) -> StreamCheck:
        """Return the object that checks the setpoints of a new jog."""
        return StreamCheck(self)

    def _let_through(self, judged: Judgement, way: Way) -> Pass:
        self._marks = judged.marks
        return Pass(way)

    def room_to_swing(
        self, begin_deg: Sequence[float], amplitude_deg: float
    ) -> Future[tuple[Swing, ...]] | None:
        """Start a thread that finds how far each joint may swing; nothing is sent or noted.

        Args:
            begin_deg: Where the arm rests.
            amplitude_deg: How far each is to swing to either side.
        """
        rules, marks = self.rules(), self._marks
        if rules is None:
            return None
        from armui.ways.swings import swings  # noqa: PLC0415 - numpy

        return self._in_background(lambda: swings(begin_deg, amplitude_deg, rules, marks))

    # Sending ------------------------------------------------------------------------------------

    def send(self, request: MotionRequest) -> Refusal | None:
        """Check a motion and send it, at once or within a second; another one that waits is void.

        Returns:
            Why nothing was sent, or ``None``; if it is refused later, its record is closed.
        """
        self._drop(Ending.CUT_OFF)
        context = self._context
        now = context.refresh()
        refusal = request.why_not(now) or context.why_no_motion()
        measured_deg = context.authority.measured_deg()
        if refusal is not None or measured_deg is None:
            return refusal or context.authority.why_unmeasured()
        planned = self._planned(request, measured_deg)
        if isinstance(planned, Refusal):
            return planned
        state, now_s = context.connection.newest, context.clock()
        self._rest.observe(state, now_s)
        motion = momentum(state, self._accelerations(), now_s)
        if motion is None and not self._rest.at_rest:
            return self._brake_first(request, measured_deg)
        way = planned if motion is None else self._fluent(planned, motion)
        if way is None:
            return self._brake_first(request, measured_deg, motion)
        rules = self.rules()
        # Only a short check is made here, in the thread of the window; a longer one gets a thread
        # of its own and an answer that counts for a second (S35).
        if rules is None or _is_short(way, rules):
            passed = self.ask(way)
            if not isinstance(passed, Refusal):
                return self._send(request, passed)
            if not any(way.spread_deg):
                return passed
        if rules is None or any(way.spread_deg):
            return self._brake_first(request, measured_deg, motion)
        pending = self._wait_for(request)
        self._begin_check(pending, rules, planned)
        return self._follow(pending)

    def _planned(self, request: MotionRequest, begin_deg: Sequence[float]) -> Way | Refusal:
        """Return the way of a motion, or the reason against it or the question that comes first."""
        way, rules = request.plan(begin_deg), self.rules()
        if isinstance(way, Refusal) or rules is None or request.agreed_mm is None:
            return way
        low = _leads_below(way, rules, request.agreed_mm)
        # A motion that is refused anyway is not asked about.
        return way if low is None else self._why_not(way) or low

    def _fluent(self, way: Way, motion: Momentum) -> Way | None:
        """Return the way from the present motion without braking first; ``None``: it must brake."""
        first, *_, last = way.joints_deg.tolist()
        astray_deg = motion.astray_deg([b - a for a, b in zip(first, last, strict=True)])
        if not max(astray_deg) <= FLUENT_DEG:
            return None
        return replace(way, spread_deg=astray_deg)

    def _brake_first(
        self, request: MotionRequest, measured_deg: Sequence[float], motion: Momentum | None = None
    ) -> Refusal | None:
        """End the arm's present motion; the new one is sent once the arm rests.

        It is checked first from where the arm is expected to rest: a motion that would be refused
        does not end the present one.
        """
        begin_deg = measured_deg
        if motion is not None:
            limits = self._context.operating_state().limits
            begin_deg = motion.stops_at(measured_deg, limits)
        planned = self._planned(request, begin_deg)
        refusal = planned if isinstance(planned, Refusal) else self._why_not(planned)
        if refusal is not None:
            return refusal
        if not self._context.authority.is_ending:
            abort_motion(self._context, End.REPLACED)
        self._rest.reset()
        self._wait_for(request)
        return None

    def _why_not(self, way: Way) -> Refusal | None:
        """Return why a way could not be driven, as far as that is known at once."""
        rules = self.rules()
        if rules is None:
            return None
        if _is_short(way, rules):
            return _judge(way, rules, self._marks).refusal
        from armui.ways.law import judge_end  # noqa: PLC0415 - numpy

        return judge_end(way, rules.every, self._marks)

    def _wait_for(self, request: MotionRequest) -> _Pending:
        context = self._context
        self._pending = _Pending(request, context.clock(), context.authority.revision)
        return self._pending

    def _begin_check(self, pending: _Pending, rules: Rules, way: Way) -> None:
        marks = self._marks
        pending.rules = rules
        pending.job = self._in_background(lambda: (_judge(way, rules, marks), way))

    def _in_background(self, work: Callable[[], Any]) -> Future[Any]:
        if self._background is not None:
            return self._background(work)
        if self._threads is None:
            self._threads = ThreadPoolExecutor(2, "armui-gate")
        return self._threads.submit(work)

    def _send(self, request: MotionRequest, passed: Pass) -> Refusal | None:
        percent = min(request.speed_percent(), request.most_percent)
        frames = request.frames(percent)
        if isinstance(frames, Refusal):
            return frames
        sent = self._context.send_motion(
            request.kind,
            frames,
            passed=passed,
            started=request.started,
            move_mode=request.move_mode,
            speed_percent=percent,
            most_percent=request.most_percent,
            joints_deg=request.joints_deg,
            tool=request.tool,
            leads_away=request.leads_away,
            way=request.tool_way,
            keep_s=request.keep_s,
        )
        if isinstance(sent, Refusal):
            return sent
        request.sent(sent)
        if request.sent_event is not None:
            notice, figures = request.sent_event
            self._context.emit_event(notice, request.started, **figures)
        return None

    # The controller's tick ------------------------------------------------------------------

    def follow_arm(self) -> None:
        """Advance the motion that waits, and note whether somebody else has moved the arm."""
        context = self._context
        self._rest.observe(context.connection.newest, context.clock())
        authority = context.authority
        if authority.mover in _SET_ANEW or authority.why_silent() is not None:
            self._marks = {}
        pending = self._pending
        if pending is None:
            return
        refusal = self._follow(pending)
        if refusal is not None:
            self._refuse(pending.request, refusal)

    def _follow(self, pending: _Pending) -> Refusal | None:
        """Advance the motion that waits; return why it is refused, or ``None``."""
        context, request = self._context, pending.request
        now_s = context.clock()
        # Another command, a stop or a cancel has come since the press: what waited is void (S10).
        if context.authority.revision != pending.revision:
            if request.refused is not None:  # else a run would wait for it forever
                self._pending = None
                return COMMAND_OVER()
            self._drop(Ending.CUT_OFF)
            return None
        refusal = request.why_not(context.operating_state()) or context.why_no_motion()
        if refusal is None and now_s - pending.since_s > _WITHIN_S:
            refusal = NOT_IN_TIME()
        if refusal is None and pending.job is None:
            refusal = self._check_at_rest(pending)
        if refusal is None and pending.job is not None and pending.job.done():
            return self._take_answer(pending, pending.job)
        if refusal is not None:
            self._pending = None
            return refusal
        if not pending.announced and now_s - pending.since_s >= _ANNOUNCED_AFTER_S:
            pending.announced = True
            context.emit_event(CHECKING)
        return None

    def _check_at_rest(self, pending: _Pending) -> Refusal | None:
        """Begin the check of a motion that waits for the arm, if it rests now."""
        begin_deg = self._context.authority.measured_deg()
        rules = self.rules()
        if not self._rest.at_rest or begin_deg is None or rules is None:
            return None
        way = self._planned(pending.request, begin_deg)
        if isinstance(way, Refusal):
            return way
        self._begin_check(pending, rules, way)
        return None

    def _take_answer(self, pending: _Pending, job: Future[tuple[Judgement, Way]]) -> Refusal | None:
        """Take the answer of a check: send, or return why not."""
        self._pending = None
        judged, way = job.result()
        if judged.refusal is not None:
            return judged.refusal
        measured_deg = self._context.authority.measured_deg()
        if measured_deg is None:
            return self._context.authority.why_unmeasured()
        away_deg = max(abs(a - b) for a, b in zip(measured_deg, judged.begin_deg, strict=True))
        # The answer counts only for the rules and the place that were checked (S35).
        if self.rules() is not pending.rules or away_deg > _SAME_DEG:
            return BEGAN_ELSEWHERE()
        return self._send(pending.request, self._let_through(judged, way))

    def _refuse(self, request: MotionRequest, refusal: Refusal) -> None:
        if request.refused is not None:
            request.started.close(Ending.REFUSED)
            request.refused(refusal)
            return
        context = self._context
        close_and_emit(
            context.emit_event,
            context.clock(),
            request.started,
            Ending.REFUSED,
            REFUSED,
            reason=refusal,
        )

    def _drop(self, ending: Ending) -> None:
        pending, self._pending = self._pending, None
        if pending is not None:
            pending.request.started.close(ending)

    def _accelerations(self) -> tuple[float, ...]:
        now = self._context.operating_state()
        heard = self._context.connection.newest.accelerations_deg_s2
        return accelerations(heard, model_data(now.model).accelerations_deg_s2)

    def drop_of(self, records: Container[Started]) -> None:
        """Drop what waits if it carries out one of these operations."""
        if self._pending is not None and self._pending.request.started in records:
            self._drop(Ending.CUT_OFF)

    def drop_single(self) -> None:
        """Drop the motion that waits by a press of its own; a run goes on with what waits of it.

        Another press voids the last one, even if it is refused. Beside a run it always is, and the
        run would wait for ever for what is dropped here.
        """
        if self._pending is not None and self._pending.request.kind is not CommandKind.RUN:
            self._drop(Ending.CUT_OFF)

    def halt(self) -> None:
        """Drop what waits: the arm is to stop, or to halt."""
        self._drop(Ending.CUT_OFF)

    def forget_arm(self) -> None:
        """Drop what waits, and forget where the arm was found: another one may come."""
        self._drop(Ending.CUT_OFF)
        self._rest.reset()
        self._of = self._rules = None
        self._marks = {}

    def end(self) -> None:
        """End the gate's threads; what they work out counts no more."""
        if self._threads is not None:
            self._threads.shutdown(wait=False, cancel_futures=True)
            self._threads = None


def _is_short(way: Way, rules: Rules) -> bool:
    """Return whether the check of a way is short; true for NaN, too, which it refuses."""
    return not rules.effort(way) > _AT_ONCE


def _judge(way: Way, rules: Rules, marks: Marks) -> Judgement:
    from armui.ways.law import judge  # noqa: PLC0415 - numpy

    return judge(rules.ramped(way), rules.every, marks)


def _leads_below(way: Way, rules: Rules, agreed_mm: float) -> Refusal | None:
    lowest_mm = rules.lowest_mm(way, agreed_mm)
    return None if lowest_mm is None else LEADS_BELOW(value=math.ceil(0.5 - lowest_mm))
