"""夹爪控制: commands the gripper (0x159) and follows its feedback (0x2A8)."""

from __future__ import annotations

from collections.abc import Callable, Container, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Final

from armui.arm.arrivals import LATE_S
from armui.arm.figures import RangeOfArm
from armui.arm.parameters import Parameter
from armui.arm.quirks import why_not_by_firmware
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState, GripperState
from armui.control.context import GENERATION_UNKNOWN
from armui.control.devices.gripper_ranges import Figures, calibrated, check, gripper_figures
from armui.control.events import Notice
from armui.control.link.link_state import LINK_LOST
from armui.control.motion.motion_context import MotionContext
from armui.control.operating_state import RUN_UNDER_WAY, OperatingState
from armui.control.operations.operation import Consent, operation
from armui.control.operations.started import Ending, Started
from armui.control.parameters.arm_settings import SETTING_NOT_KEPT, ArmSettings
from armui.control.parameters.setting_cell import CellState
from armui.control.requests.pending import EndNotices, RequestingPart
from armui.control.requests.request import Request
from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN, OTHER_CONTROL
from armui.protocol import commands
from armui.protocol.codes import ControlMode
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.telemetry.events import EventKind, Level
from armui.trajectory.points.program import GripperOpening

if TYPE_CHECKING:
    from armui.cell.gripper_table import GripperTable
    from armui.trajectory.points.program import GripperAction

GRIPPER_SILENT = Reason(
    "gripper_silent", "No gripper is heard. If one is mounted, check its cable and its power."
)
GRIPPER_MOVES = Reason(
    "gripper_moves", "The gripper is moving. Wait until it stands still, then press again."
)
GRIPPER_NO_ZERO = Reason(
    "gripper_no_zero", "The gripper of a generation 1 arm has no command for its zero."
)
GRIPPER_RANGE_UNKNOWN = Reason(
    "gripper_range_unknown",
    "How far this gripper opens is not known: the arm has told no stroke limit. Set it in "
    "Gripper settings, or enter a target in Gripper control.",
)
RUN_LET_GO = Reason(
    "run_let_go",
    "The gripper was disabled while it ran: the arm was told to end its motion. See what it held.",
)
GRIPPER_SENT = Notice(
    "gripper_sent", "Gripper: sent to {value} {unit}", Level.INFO, EventKind.COMMAND
)
GRIPPER_THERE = Notice(
    "gripper_there", "The gripper is at {value} {unit}.", Level.DONE, EventKind.RESULT
)
GRIPPER_GRIPS = Notice(
    "gripper_grips",
    "The gripper holds something at {value} {unit}, with {torque} N·m.",
    Level.DONE,
    EventKind.RESULT,
)
GRIPPER_NOT_THERE = Notice(
    "gripper_not_there",
    "The gripper stopped at {value} {unit} instead of {target} {unit}. Check what blocks it, "
    "its errors and its power.",
    Level.FAULT,
    EventKind.RESULT,
)
GRIPPER_HELD = Notice(
    "gripper_held",
    "The gripper was told to stay where it is, at {value} {unit}.",
    Level.INFO,
    EventKind.RESULT,
)
GRIPPER_ACT_SENT = Notice("gripper_act_sent", "Gripper: {act} sent", Level.INFO, EventKind.COMMAND)
GRIPPER_ACT_DONE = Notice(
    "gripper_act_done", "Gripper: {act} done, by its own feedback.", Level.DONE, EventKind.RESULT
)
GRIPPER_ACT_FAILED = Notice(
    "gripper_act_failed",
    "Gripper: {act} has had no effect. Check its errors, its power and its cable, then try again.",
    Level.FAULT,
    EventKind.RESULT,
)


CALIBRATED_MM: Final = "mm_calibrated"
"""The unit of an opening by the gripper's table, for a sentence."""
Travel = Annotated[float, RangeOfArm("mm or °")]
Effort = Annotated[float, RangeOfArm("N·m or rad/s")]
"""A figure whose range and unit :attr:`GripperControl.figures` tells."""
_MM: Final = "mm"
_THERE: Final = 0.5
"""A gripper this close to its target, in mm or degrees, has arrived."""
_STILL: Final = 0.05
"""The gripper stands while its reported opening or angle changes by no more, mm or °."""
_STANDS_S: Final = 0.6
"""A gripper that has not moved for this time has come to its end."""
_GRIPS_NM: Final = 0.05
"""A gripper short of its target with more torque than this holds something."""

_STROKE: Final = Parameter("stroke_limit_mm")
_OBEYS: Final = frozenset({ControlMode.STANDBY, ControlMode.CAN_CONTROL})


@dataclass(slots=True)
class _Travel:
    """A motion under way.

    Attributes:
        target: The target, in mm or degrees.
        last: The last reported place.
        moved_s: When it was last seen to move, or heard again after a gap in its feedback.
        heard_s: When it was last heard.
        unit: The unit of `target` and `last`.
        effort: The torque in N·m (generation 2) or the speed in rad/s (generation 1).
        started: The record of the command; ``None`` in a run, which reports its own outcome.
    """

    target: float
    last: float
    moved_s: float
    heard_s: float
    unit: str
    effort: float
    started: Started | None = None


def why_not_gripper(
    now: OperatingState, *, moving: bool = False, letting_go: bool = False
) -> Refusal | None:
    """Return why the gripper may not be commanded, or ``None``.

    Args:
        now: The operating state.
        moving: True if the command moves the gripper or lets it hold.
        letting_go: True if the command takes its power: it may hold a finger, so a run is no reason
            against it; the run ends.
    """
    refusal = now.cannot_enable
    if refusal is None and now.generation is None:
        refusal = GENERATION_UNKNOWN()
    if refusal is None and not now.gripper_heard:
        refusal = GRIPPER_SILENT()
    if refusal is None and not now.control_certain:
        refusal = CONTROL_OFFSET_UNKNOWN()
    if refusal is None and now.running and not letting_go:
        refusal = RUN_UNDER_WAY()
    if refusal is not None or not moving:
        return refusal
    no_motion = now.cannot_send_motion or now.held
    if no_motion is not None:
        return no_motion
    mode = None if now.status is None else now.status.control_mode
    if mode is None or mode in _OBEYS:
        return None
    return OTHER_CONTROL(mode=mode)


def why_not_move_gripper(now: OperatingState) -> Refusal | None:
    """Return why the gripper may not be moved or switched on, or ``None``."""
    return why_not_gripper(now, moving=True)


def why_not_set_zero(now: OperatingState) -> Refusal | None:
    """Return why the gripper's zero may not be set; generation 1 has no frame for it."""
    refusal = why_not_gripper(now)
    if refusal is None and now.generation is not Generation.TWO:
        return GRIPPER_NO_ZERO()
    return refusal


def why_not_let_go(now: OperatingState) -> Refusal | None:
    """Return why the gripper's power may not be taken, or ``None``."""
    return why_not_gripper(now, letting_go=True)


class GripperControl(RequestingPart[str]):
    """Commands the gripper; one command at a time, a new one replaces the last.

    The frame carries target, effort and power at once. So a frame that switches the power carries
    the gripper's present place, and nothing moves unasked.

    Args:
        context: The context that the controller's parts share.
        settings: Reads the stroke that the arm allows.
        end_run: Called with the reason when the gripper is about to be disabled under a run.
        table: Returns the table that leads from the arm's openings to measured ones, if one is
            applied.

    Attributes:
        by_angle: True if the operator wants to command angles instead of openings; it takes effect
            where the firmware supports that (from S-V1.8-8).
    """

    def __init__(
        self,
        context: MotionContext,
        settings: ArmSettings,
        end_run: Callable[[Refusal], None],
        table: Callable[[], GripperTable | None] = lambda: None,
    ) -> None:
        super().__init__(context)
        self._end_run = end_run
        self._settings = settings
        self._table = table
        self._travel: _Travel | None = None
        self._gripped: _Travel | None = None
        self._to_hold: _Travel | None = None
        self._commanded_s = 0.0
        self.by_angle = False

    @property
    def reports_angle(self) -> bool:
        """True if a gripper of generation 2 is commanded by angles now."""
        return self.by_angle and self.why_no_angle() is None

    def why_no_angle(self) -> Refusal | None:
        """Return why this arm's gripper cannot be commanded by an angle, or ``None``."""
        generation = self._context.connection.generation
        if generation is None:
            return GENERATION_UNKNOWN()
        if generation is Generation.ONE:
            return SETTING_NOT_KEPT(generation=1)
        return why_not_by_firmware(self._context.state(), "has_gripper_angle")

    @property
    def figures(self) -> Figures:
        """The ranges of what the gripper can be asked for now."""
        figures = self.own_figures
        table = self._table_of(figures.travel.unit)
        return figures if table is None else calibrated(figures, table.measured_mm)

    @property
    def own_figures(self) -> Figures:
        """The ranges without the gripper's table, in the arm's own values."""
        generation, state = self._context.connection.generation, self._context.state()
        return gripper_figures(generation, state, by_angle=self.reports_angle)

    @property
    def is_calibrated(self) -> bool:
        """True if openings are those measured with callipers, by the cell's table."""
        return self._table() is not None

    def _table_of(self, unit: str) -> GripperTable | None:
        return self._table() if unit == _MM else None

    def shown(self, gripper: GripperState) -> float:
        """Return where the gripper stands, calibrated if its table is applied."""
        return self._shown(gripper.travel, gripper.unit)

    def heading(self, unit: str) -> float | None:
        """Return the gripper's target while it moves, else its place; calibrated.

        One that holds something is still being sent beyond it: that is what it holds with. ``None``
        if it is not told in this unit.
        """
        travel, heard = self._travel, self._last_feedback()
        if travel is None and heard is not None and heard.enabled:
            travel = self._gripped
        if travel is not None and travel.unit == unit:
            return self._shown(travel.target, unit)
        return self.shown(heard) if heard is not None and heard.unit == unit else None

    def calibrated_mm(self, opening_mm: float) -> float:
        """Return an opening of the arm's as callipers measure it, if its table is applied."""
        return self._shown(opening_mm, _MM)

    def _shown(self, travel: float, unit: str) -> float:
        table = self._table_of(unit)
        return travel if table is None else round(max(0.0, table.measured_mm(travel)), 3)

    def _unit_shown(self, unit: str) -> str:
        return unit if self._table_of(unit) is None else CALIBRATED_MM

    def as_asked(self, action: GripperAction | None) -> GripperAction | None:
        """Return a point's action with the opening that the arm is to be asked for."""
        table = self._table()
        if table is None or not isinstance(action, GripperOpening):
            return action
        return replace(action, opening_mm=self._asked(action.opening_mm, _MM))

    def _asked(self, travel: float, unit: str) -> float:
        """Return the opening to command, within the arm's own stroke."""
        table = self._table_of(unit)
        if table is None:
            return travel
        own = gripper_figures(self._context.connection.generation, self._context.state()).travel
        return round(min(max(table.asked_mm(travel), own.minimum), own.maximum), 3)

    def learn_stroke(self) -> None:
        """Ask once for the stroke limit of the arm (0x47E), if it can be asked."""
        connection = self._context.connection
        unread = self._settings.cell(_STROKE).state is CellState.UNREAD
        if unread and connection.generation is Generation.TWO:
            self._settings.read([_STROKE.batch])

    # What the operator wants ------------------------------------------------------------------

    @operation(
        "gripper.move", "Move the gripper", why_not_move_gripper, moves=True, shown_first=True
    )
    def move(
        self, started: Started, travel: Travel, effort: Effort, *, uncalibrated: bool = False
    ) -> Refusal | None:
        """Open or close the gripper; the same frame enables it (0x159).

        Args:
            started: The record of the command.
            travel: Opening in mm (generation 2) or angle in degrees (generation 1, or while
                `reports_angle`).
            effort: Torque in N·m (generation 2) or speed in rad/s (generation 1).
            uncalibrated: True if the opening is the arm's own, without the gripper's table.

        Returns:
            Why nothing was sent, or ``None``.
        """
        figures = self.own_figures if uncalibrated else self.figures
        refusal = check(figures.travel, travel) or check(figures.effort, effort)
        heard = self._last_feedback()
        if refusal is not None or heard is None:
            return refusal or GRIPPER_SILENT()
        by_angle = self.reports_angle
        asked = travel if uncalibrated else self._asked(travel, figures.travel.unit)
        frames = self._hold(asked, effort, by_angle=by_angle)
        passed = self._context.gate().ask_no_way()
        if not self._context.connection.send(frames, passed=passed):
            return LINK_LOST()
        self._drop_request()
        unit, now_s = figures.travel.unit, self._context.clock()
        self._commanded_s = now_s
        self._travel = _Travel(asked, heard.travel, now_s, now_s, unit, effort, started)
        told = unit if uncalibrated else self._unit_shown(unit)
        self._context.emit_event(GRIPPER_SENT, started, value=travel, unit=told)
        return None

    def why_no_end(self, *, opened: bool) -> Refusal | None:
        """Return why the gripper cannot be moved to an end of its stroke, or ``None``."""
        refusal = why_not_move_gripper(self._context.operating_state())
        if refusal is None and opened and not self.figures.stroke_read:
            return GRIPPER_RANGE_UNKNOWN()
        return refusal

    def move_to_end(self, *, opened: bool, effort: float | None = None) -> Started | Refusal:
        """Open the gripper to its stroke limit (0x47E), or close it to 0; see :meth:`move`.

        Args:
            opened: True to open it, false to close it.
            effort: Torque or speed; ``None`` for the first value of a command, 1.

        Returns:
            The record of the command, or why nothing was sent.
        """
        self._context.refresh()
        refusal = self.why_no_end(opened=opened)
        if refusal is not None:
            return self._context.refuse(refusal)
        figures = self.figures
        target = figures.travel.maximum if opened else max(0.0, figures.travel.minimum)
        return self.move(target, figures.effort.first if effort is None else effort)

    @operation("gripper.enable", "Enable the gripper", why_not_move_gripper, moves=True)
    def enable(self, started: Started, effort: Effort) -> Refusal | None:
        """Enable the gripper at its present place."""
        refusal = check(self.figures.effort, effort)
        heard = self._last_feedback()
        if refusal is not None or heard is None:
            return refusal or GRIPPER_SILENT()
        # In the unit the gripper reports, opening or angle: a number in the other one would move
        # it.
        frames = self._hold(heard.travel, effort, by_angle=heard.opening_mm is None)
        self._start(started, "enable", frames, lambda gripper: gripper.enabled)
        return None

    @operation("gripper.disable", "Disable the gripper", why_not_let_go, consent=Consent.PRESS)
    def disable(self, started: Started) -> None:
        """Disable the gripper: it lets go of what it holds. A run under way ends."""
        self._end_run(RUN_LET_GO())
        frames = commands.disable_gripper(self._context.connection.codec)
        self._start(started, "disable", frames, lambda gripper: not gripper.enabled)

    @operation("gripper.clear_error", "Clear the gripper's error", why_not_gripper)
    def clear_error(self, started: Started) -> None:
        """Clear the driver's error; the gripper stays off until it is enabled or moved."""
        frames = commands.clear_gripper_error(self._context.connection.codec)
        self._start(started, "clear", frames, lambda gripper: not gripper.faults)

    def stands_as(self, before: ArmState) -> bool:
        """Return whether the gripper still stands where it stood when its zero was asked about."""
        then, now = before.gripper, self._context.connection.newest.gripper
        if then is None or now is None or then.value.unit != now.value.unit:
            return False
        return abs(now.value.travel - then.value.travel) <= _THERE

    @operation(
        "gripper.set_zero", "Set the gripper's zero", why_not_set_zero, consent=Consent.PRESS
    )
    def set_zero(self, started: Started) -> Refusal | None:
        """Make the gripper's present place its zero (generation 2); it has no power afterwards."""
        if self._travel is not None:
            return GRIPPER_MOVES()
        frames = commands.set_gripper_zero(self._context.connection.codec)
        self._start(started, "zero", frames, lambda gripper: abs(gripper.travel) <= _THERE)
        return None

    # Carrying out -----------------------------------------------------------------------------

    def _last_feedback(self) -> GripperState | None:
        heard = self._context.state().gripper
        return None if heard is None else heard.value

    def _hold(self, travel: float, effort: float, *, by_angle: bool) -> list[Frame]:
        codec = self._context.connection.codec
        if self._context.connection.generation is Generation.ONE:
            return commands.move_gripper_angle(codec, angle_deg=travel, speed_rad_s=effort)
        if by_angle:
            return commands.move_gripper_to_angle(codec, angle_deg=travel, torque_nm=effort)
        return commands.move_gripper_opening(codec, opening_mm=travel, torque_nm=effort)

    def _start(
        self,
        started: Started,
        action: str,
        frames: Sequence[Frame],
        seen: Callable[[GripperState], bool],
    ) -> None:
        """Send a command, and repeat it until the gripper's feedback shows its effect."""
        context = self._context
        self._commanded_s = since_s = context.clock()

        def shows(state: ArmState) -> bool:
            gripper = state.gripper
            return gripper is not None and gripper.at_s > since_s and seen(gripper.value)

        self._drop_request()
        passed = context.gate().ask_no_way()
        figures = {"act": action}
        notices = EndNotices(
            (GRIPPER_ACT_DONE, figures), lambda _reason: (GRIPPER_ACT_FAILED, figures)
        )
        request = Request(context, frames, shows, passed=passed)
        sent = (GRIPPER_ACT_SENT, figures)
        self._pending.begin(action, started, request, notices, sent=sent)

    def note_travel(self, target: float, effort: float) -> None:
        """Note the target that a run sent it to, so that the run's end knows whether it moves."""
        heard = self._last_feedback()
        if heard is not None:
            self._commanded_s = now_s = self._context.clock()
            self._travel = _Travel(target, heard.travel, now_s, now_s, heard.unit, effort)
            self._to_hold = None

    # A part of the controller -----------------------------------------------------------------

    def follow_arm(self) -> None:
        """Follow the request and the motion; drop the request if another host commands."""
        if self._context.authority.other.has_commanded_gripper(self._commanded_s):
            self._drop_request()
        if self._travel is not None:
            self._follow(self._travel)
        to_hold, self._to_hold = self._to_hold, None
        if to_hold is not None:
            self._hold_here(to_hold)
        super().follow_arm()

    def _follow(self, travel: _Travel) -> None:
        feedback, now_s = self._context.state().gripper, self._context.clock()
        if feedback is None or not feedback.fresh(now_s):
            self._lose(travel)  # its arrival cannot be seen; the silence is reported elsewhere
            return
        heard = feedback.value
        if heard.unit != travel.unit:
            if now_s - travel.moved_s >= _STANDS_S:
                self._lose(travel)  # it still reports in the other unit
            return
        late = feedback.at_s - travel.heard_s > LATE_S
        travel.heard_s = max(travel.heard_s, feedback.at_s)
        if late or abs(heard.travel - travel.last) > _STILL:
            travel.last, travel.moved_s = heard.travel, feedback.at_s
        gap = abs(heard.travel - travel.target)
        stands = feedback.at_s - travel.moved_s >= _STANDS_S
        if not stands and (gap > _STILL or not heard.enabled):
            return
        there = heard.enabled and gap <= _THERE
        grips = not there and heard.enabled and abs(heard.torque_nm or 0.0) > _GRIPS_NM
        self._travel, self._gripped = None, travel if grips else None
        if travel.started is None:
            return
        value, unit = self._shown(heard.travel, travel.unit), self._unit_shown(travel.unit)
        figures: dict[str, object] = {"value": value, "unit": unit}
        ending, notice = Ending.DONE, GRIPPER_THERE
        if grips:
            notice = GRIPPER_GRIPS
            figures["torque"] = heard.torque_nm
        elif not there:
            ending, notice = Ending.FAILED, GRIPPER_NOT_THERE
            figures["target"] = self._shown(travel.target, travel.unit)
        self._context.close(travel.started, ending, notice, **figures)

    def _lose(self, travel: _Travel) -> None:
        self._travel = None
        if travel.started is not None:
            travel.started.close(Ending.FAILED)

    def carries_out(self, records: Container[Started]) -> bool:
        """Return whether the motion under way carries out one of these operations."""
        travel = self._travel
        return travel is not None and travel.started is not None and travel.started in records

    def end_travel(self) -> None:
        """End a motion of the gripper that is under way, by sending it to its present place.

        It keeps holding an object that it has gripped meanwhile.
        """
        travel = self._travel or self._to_hold  # `_to_hold` waits for a new report
        self._drop_request()
        if travel is not None:
            self._hold_here(travel)

    def _hold_here(self, travel: _Travel) -> None:
        """Send it to its present place, which its next report gives if the last one is too old."""
        context = self._context
        heard, now_s = context.connection.newest.gripper, context.clock()
        if heard is None or not heard.fresh(now_s) or context.authority.other.why_not() is not None:
            return
        if now_s - heard.at_s > LATE_S:
            self._to_hold = travel
            return
        by_angle = heard.value.opening_mm is None
        here = self._hold(heard.value.travel, travel.effort, by_angle=by_angle)
        context.connection.send(here, passed=context.gate().ask_no_way())
        value, unit = self._shown(heard.value.travel, travel.unit), self._unit_shown(travel.unit)
        context.emit_event(GRIPPER_HELD, value=value, unit=unit)

    def _drop_request(self) -> None:
        super()._drop_request()
        travel, self._travel, self._gripped = self._travel, None, None
        self._to_hold = None
        if travel is not None and travel.started is not None:
            travel.started.close(Ending.CUT_OFF)
