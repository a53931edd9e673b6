"""The joint inspection: each joint in turn swings a little, as a replay, and is measured by it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from datetime import datetime
from typing import TYPE_CHECKING, Annotated, Final

from armui.arm.figures import Range
from armui.arm.inspection_record import InspectionEntry, JointFigures, JointFinding, findings
from armui.arm.limits import JOINTS, JOINTS_OUTSIDE, outside_list
from armui.arm.refusal import Reason, Refusal
from armui.control.context import ControllerPart
from armui.control.events import Notice
from armui.control.motion.abort import RUN_STOPPED
from armui.control.motion.motion_context import MotionContext
from armui.control.operations.operation import Consent, operation
from armui.control.operations.started import Started
from armui.control.run.player import why_not_run
from armui.control.run.progress import OVER, RunPhase
from armui.control.run.replay import Replay
from armui.control.safety.interlocks import joint_list
from armui.protocol.generation import Generation
from armui.telemetry.events import Asker, EventKind, Level

if TYPE_CHECKING:
    from concurrent.futures import Future

    from armui.control.run.replayer import Replayer
    from armui.control.safety.reference_control import ReferenceControl
    from armui.telemetry.swing_figures import Curve
    from armui.trajectory.samples.swing_samples import SwingTimes
    from armui.ways.swings import Swing

INSPECTION_NOT_READY = Reason(
    "inspection_not_ready",
    "How far each joint may swing is not worked out yet for where the arm stands. Wait a moment, "
    "with the arm at rest.",
)
INSPECTION_NO_ROOM = Reason(
    "inspection_no_room",
    "No joint may swing over 10° here. Bring the arm to a place with room around it.",
)
SWING_TOO_SHORT = Reason("swing_too_short", "It may swing over less than 10° here.")
SWING_NOT_HEARD = Reason(
    "swing_not_heard", "Too little of its swing was heard, or the speed was changed meanwhile."
)
SWING_NOT_DONE = Reason("swing_not_done", "The inspection ended before its turn was over.")

INSPECTED = Notice(
    "inspected",
    "Joint inspection finished: nothing stands out.",
    Level.DONE,
    EventKind.RESULT,
    Asker.RUN,
)
INSPECTED_STANDS_OUT = Notice(
    "inspected_stands_out",
    "Joint inspection finished: joint {joints} stands out. The report says by what.",
    Level.WARNING,
    EventKind.RESULT,
    Asker.RUN,
)
INSPECTION_INCOMPLETE = Notice(
    "inspection_incomplete",
    "Joint inspection over; joint {joints} was not measured. The report says why.",
    Level.WARNING,
    EventKind.RESULT,
    Asker.RUN,
)

AMPLITUDE: Final = Range(10.0, 30.0, "°")
USUAL_DEG: Final = 20.0
_SAME_DEG: Final = 0.5
"""Room that was looked at counts for an arm that stands this near to where it was."""


@dataclass(frozen=True, slots=True)
class SwingPlan:
    """How far each joint may swing where the arm stands.

    Attributes:
        begin_deg: The six angles at which the arm stands.
        amplitude_deg: The wanted swing of each joint to either side.
        rules: The gate's rules then; with other rules the plan is void.
        swings: The possible swings of the six joints.
    """

    begin_deg: tuple[float, ...]
    amplitude_deg: float
    rules: object
    swings: tuple[Swing, ...]


@dataclass(frozen=True, slots=True)
class InspectionReport:
    """What an inspection has found.

    Attributes:
        entry: The figures, as they are kept.
        plan: The swings that were planned.
        findings: The notable deviations.
        unmeasured: The joints (1–6) that were not measured, each with why.
        curves: The commanded and measured curves of the joints that swung.
        earlier: The inspections of this arm that it was compared with.
        ended: Why it ended early; ``None`` if it did not.
    """

    entry: InspectionEntry
    plan: SwingPlan
    findings: tuple[JointFinding, ...]
    unmeasured: Mapping[int, Refusal]
    curves: Mapping[int, Mapping[str, Curve]]
    earlier: tuple[InspectionEntry, ...]
    ended: Refusal | None


@dataclass(slots=True)
class _Going:
    """An inspection under way.

    Attributes:
        times: When each joint swings, in the recorded time; those to come.
        lasts_s: The recorded time in all.
        begun_s: The time at which the first of them began; ``None`` before.
    """

    plan: SwingPlan
    speed_deg_s: float
    times: list[SwingTimes]
    lasts_s: float
    begun_s: float | None = None
    figures: dict[int, JointFigures | None] = field(default_factory=dict)
    curves: dict[int, Mapping[str, Curve]] = field(default_factory=dict)


class Inspection(ControllerPart):
    """Finds the room for the swings, has them replayed, measures each, and judges.

    Args:
        context: The context that the controller's parts share.
        replayer: Moves the arm, through the gate.
        reference: Keeps what was found of this arm.
        wall: Returns the local time now.

    Attributes:
        name: The name of the run, in the operator's language.
        plan: The room for the swings; ``None`` while it is not known.
        report: The result of the last inspection of this arm; ``None`` before.
    """

    def __init__(
        self,
        context: MotionContext,
        replayer: Replayer,
        reference: ReferenceControl,
        wall: Callable[[], datetime],
    ) -> None:
        self._context = context
        self._replayer = replayer
        self._reference = reference
        self._wall = wall
        self._requested_deg: float | None = None
        self._asked: tuple[tuple[float, ...], float, object] | None = None
        self._job: Future[tuple[Swing, ...]] | None = None
        self._going: _Going | None = None
        self.name = "Joint inspection"
        self.plan: SwingPlan | None = None
        self.report: InspectionReport | None = None

    @property
    def joint(self) -> int | None:
        """The joint (1–6) whose turn it is; ``None`` if no inspection is under way."""
        going = self._going
        return None if going is None or not going.times else going.times[0].joint

    @property
    def measured(self) -> Mapping[int, JointFigures | None]:
        """What was measured so far of the inspection under way, by joint."""
        return {} if self._going is None else self._going.figures

    def why_not_ready(self) -> Refusal | None:
        """Return why no inspection can begin where the arm stands, or ``None``."""
        context = self._context
        measured_deg = context.authority.measured_deg()
        if measured_deg is not None and context.gate().ways_inside():
            limits = context.operating_state().limits
            return JOINTS_OUTSIDE(joints=outside_list(measured_deg, limits))
        plan = self.plan
        if plan is None or plan.amplitude_deg != self._requested_deg or not self._holds(plan):
            return INSPECTION_NOT_READY()
        return None if any(each.possible for each in plan.swings) else INSPECTION_NO_ROOM()

    # What the operator does -------------------------------------------------------------------

    def set_amplitude(self, amplitude_deg: float | None) -> None:
        """Find out how far each joint may swing, and do so anew wherever the arm goes.

        Args:
            amplitude_deg: To either side; ``None`` to look no more.
        """
        self._requested_deg = amplitude_deg

    @operation(
        "inspection.start",
        "Inspect the joints",
        why_not_run,
        moves=True,
        consent=Consent.HELD,
        shown_first=True,
    )
    def start(self, started: Started, amplitude_deg: Annotated[float, AMPLITUDE]) -> Refusal | None:
        """Have each joint swing in turn, as a replay: it goes through the gate, as all others do.

        The swings are those that were found beforehand, see :meth:`set_amplitude`.
        """
        self.set_amplitude(amplitude_deg)
        refusal, plan = self.why_not_ready(), self.plan
        if refusal is not None or plan is None:
            return refusal
        from armui.trajectory.samples.swing_samples import swing_recording  # noqa: PLC0415 - numpy

        percent = self._context.operating_state().speed_percent
        possible = [each for each in plan.swings if each.possible]
        recording, times, speed_deg_s = swing_recording(
            self.name, plan.begin_deg, possible, percent / 100.0
        )
        refusal = self._replayer.begin(started, Replay(recording, percent))
        if refusal is None:
            self._going = _Going(plan, speed_deg_s, list(times), recording.duration_s)
        return refusal

    # The controller's tick --------------------------------------------------------------------

    def follow_arm(self) -> None:
        """Measure the swings that are over, or continue the search for room."""
        if self._going is not None:
            self._follow(self._going)
        elif self._requested_deg is not None:
            self._plan_swings(self._requested_deg)

    def forget_arm(self) -> None:
        """End the inspection and forget its results: another arm may come."""
        if self._going is not None:
            self._finish(self._going)
        self.plan = self._job = self._asked = None

    def _plan_swings(self, amplitude_deg: float) -> None:
        context, job = self._context, self._job
        if job is not None and job.done() and self._asked is not None:
            begin_deg, amplitude, rules = self._asked
            self._job, self.plan = None, SwingPlan(begin_deg, amplitude, rules, job.result())
        measured_deg = context.authority.measured_deg()
        if self._job is not None or measured_deg is None or not context.authority.at_rest:
            return
        plan = self.plan
        if plan is None or plan.amplitude_deg != amplitude_deg or not self._holds(plan):
            gate = context.gate()
            begin_deg = tuple(round(each, 3) for each in measured_deg)
            self._asked = begin_deg, amplitude_deg, gate.rules()
            self._job = gate.room_to_swing(begin_deg, amplitude_deg)

    def _holds(self, plan: SwingPlan) -> bool:
        """Return whether the arm still stands where its room was looked for, in the same rules."""
        measured_deg = self._context.authority.measured_deg()
        if measured_deg is None or plan.rules is not self._context.gate().rules():
            return False
        pairs = zip(measured_deg, plan.begin_deg, strict=True)
        return max(abs(here - there) for here, there in pairs) <= _SAME_DEG

    def _follow(self, going: _Going) -> None:
        now_s, progress = self._context.clock(), self._replayer.progress
        done = self._replayer.phase is RunPhase.DONE
        at_s = going.lasts_s if done else progress.done * going.lasts_s
        if going.begun_s is None and at_s > 0.0:
            going.begun_s = now_s
        while going.times and going.begun_s is not None and at_s >= going.times[0].end_s - 1e-6:
            self._measure(going, going.times.pop(0).joint, going.begun_s, now_s)
            going.begun_s = now_s
        if self._replayer.phase in OVER:
            self._finish(going)

    def _measure(self, going: _Going, joint: int, begin_s: float, end_s: float) -> None:
        from armui.telemetry.swing_figures import curves_of, figures_of  # noqa: PLC0415 - numpy

        connection = self._context.connection
        curves = curves_of(connection.telemetry, joint, begin_s, end_s)
        signed = connection.generation is not Generation.ONE
        going.curves[joint] = curves
        going.figures[joint] = figures_of(curves, going.speed_deg_s, signed=signed)

    def _finish(self, going: _Going) -> None:
        """Evaluate the measurements, keep them, and report them; unmeasured joints are named."""
        self._going = None
        ended = None
        if going.times:
            ended = self._replayer.progress.refusal or RUN_STOPPED()
        joints = tuple(going.figures.get(joint) for joint in JOINTS)
        at = self._wall().isoformat(timespec="seconds")
        entry = InspectionEntry(at, going.speed_deg_s, joints)
        earlier = self._reference.record.inspections
        found = findings(entry, earlier)
        swings = dict(zip(JOINTS, going.plan.swings, strict=True))
        unmeasured = {
            joint: self._why_not_measured(swings[joint], heard=joint in going.figures)
            for joint, figures in zip(JOINTS, joints, strict=True)
            if figures is None
        }
        self.report = InspectionReport(
            entry, going.plan, found, unmeasured, going.curves, earlier, ended
        )
        if any(joints):
            self._reference.keep_inspection(entry)
        if found:
            striking = joint_list(sorted({each.joint for each in found}))
            self._context.emit_event(INSPECTED_STANDS_OUT, joints=striking)
        if unmeasured:
            self._context.emit_event(INSPECTION_INCOMPLETE, joints=joint_list(sorted(unmeasured)))
        elif not found:
            self._context.emit_event(INSPECTED)

    @staticmethod
    def _why_not_measured(swing: Swing, *, heard: bool) -> Refusal:
        if not swing.possible:
            return swing.shortened or SWING_TOO_SHORT()
        return SWING_NOT_HEARD() if heard else SWING_NOT_DONE()
