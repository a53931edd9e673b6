"""One press on 发送 or 检查, from reading the content to the start of the arm."""

from __future__ import annotations

import enum
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.cell.held_shape import held_shape
from armui.cell.parts import part_named
from armui.control.operations.started import ARM_CHANGED
from armui.control.parameters.arm_model import arm_model, start_deg
from armui.system.clock import steady_s
from armui.trajectory.planning.check import Carried, CheckOutcome, CheckRequest, check, warm_up
from armui.trajectory.planning.estimate import estimate_s
from armui.trajectory.planning.findings import Finding, Severity
from armui.trajectory.points.program import frames_in
from armui.trajectory.samples.recording import Recording
from armui.ui.background import Job

if TYPE_CHECKING:
    from armui.arm.models import ArmModel
    from armui.cell.cell import Cell
    from armui.control.arm_controller import ArmController
    from armui.control.link.arm_mark import ArmMark
    from armui.trajectory.files import Content
    from armui.trajectory.library.run_options import RunOptions
    from armui.trajectory.library.store import Check
    from armui.trajectory.planning.planned_path import PlannedPath
    from armui.ui.background import Background
    from armui.ui.trajectory.running.runner import Runner

LIMITS_CHANGED_SINCE_CHECK = Reason(
    "limits_changed_since_check",
    "Not run: the arm's joint limits have changed since the check. Send again.",
)
MODEL_CHANGED_SINCE_CHECK = Reason(
    "model_changed_since_check",
    "Not run: the arm's model or zeros have changed since the check. Send again.",
)
CHANGED_SINCE_CHECK = Reason(
    "changed_since_check",
    "Not run: tool, load, cell, settings or choices have changed since the check. Send again.",
)
MOVED_SINCE_CHECK = Reason(
    "moved_since_check", "Not run: the arm has moved by {value}° since it was checked. Send again."
)
FINDINGS_AGAINST = Reason(
    "findings_against",
    "Not run: the check has found errors ({count}). Correct what is listed, then send again.",
)


_SAME_PLACE_DEG: Final = 0.5
"""The measured angles of an arm at rest waver by some hundredths."""
_SURPRISING_S: Final = 2.0
"""If the check took longer, the operator no longer expects the arm to move."""


# What is checked --------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class CheckBasis:
    """The conditions of a check beside content and position; compared as a whole.

    Attributes:
        mark: The arm and the connection.
        arm: The arm's data for planning: limits, geometry and zeros, tool, gripper.
        alterations: The number of settings that this program had made by then, loads included.
        options: The operator's options.
        cell: The cell: its work area, and what the arm carries.
        unconfirmed: Why the cell is not in force; its tool is none of the arm's then.
        lowest_mm: The least height that the operator has chosen.
    """

    mark: ArmMark
    arm: ArmModel
    alterations: int
    options: RunOptions
    cell: Cell | None
    unconfirmed: Refusal | None = None
    lowest_mm: float | None = None

    @classmethod
    def of(cls, controller: ArmController, options: RunOptions) -> CheckBasis:
        """Return the present conditions."""
        arm, altered = arm_model(controller), controller.transactions.alterations
        cell = controller.cell.cell
        shown_in_base = None if cell is None else replace(cell, frame="")  # which moves nothing
        waits = controller.cell.unconfirmed
        lowest_mm = controller.jog_floor.lowest_mm
        return cls(controller.mark, arm, altered, options, shown_in_base, waits, lowest_mm)

    def why_other(self, now: CheckBasis) -> Refusal | None:
        """Return why a check under these conditions is not valid under ``now``, or ``None``."""
        if not self.mark.is_still(now.mark):
            return ARM_CHANGED()
        if self.arm.limits != now.arm.limits:
            return LIMITS_CHANGED_SINCE_CHECK()
        if self.arm.kinematics != now.arm.kinematics:
            return MODEL_CHANGED_SINCE_CHECK()
        if replace(self, mark=now.mark) != now:
            return CHANGED_SINCE_CHECK()
        return None


@dataclass(frozen=True, slots=True)
class Preflight:
    """A completed check.

    Attributes:
        order: The input of the check.
        outcome: The result.
        basis: The conditions of the check.
    """

    order: CheckRequest
    outcome: CheckOutcome
    basis: CheckBasis

    @property
    def content(self) -> Content:
        """The recording or trajectory as it was checked, and is run."""
        return self.outcome.as_checked or self.order.content

    @property
    def fingerprint(self) -> str:
        """What of the arm it holds for: moving a frame that no point names changes nothing."""
        content = self.order.content
        frames = () if isinstance(content, Recording) else frames_in(content.points)
        return self.order.arm.fingerprint_of(frames)

    @property
    def path(self) -> PlannedPath:
        """The planned path of the arm."""
        return self.outcome.path

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The findings, errors first, then by row."""
        return self.outcome.findings

    @property
    def errors(self) -> int:
        """The number of findings that forbid a run."""
        return len(self.outcome.errors)

    @property
    def whole(self) -> bool:
        """True if all rows were checked, as opposed to a single run from a later row."""
        return not self.order.first or self.order.cycles != 1

    @property
    def length_s(self) -> float | None:
        """How long a cycle takes at the points' own speed; ``None`` if another one was checked."""
        return self.path.first_cycle_s if self.order.speed_factor == 1.0 else None

    @property
    def mark(self) -> Check:
        """The check mark for the content, independent of the arm's position."""
        of_content = [one.severity for one in self.findings if not one.is_of_approach]
        return "errors" if Severity.ERROR in of_content else "warnings" if of_content else "ok"

    def why_outdated(self, controller: ArmController, options: RunOptions) -> Refusal | None:
        """Return why it is not valid for a run with these options now, or ``None``."""
        pairs = zip(self.order.start_deg, start_deg(controller), strict=True)
        moved_deg = max(abs(there - here) for there, here in pairs)
        if moved_deg > _SAME_PLACE_DEG:
            return MOVED_SINCE_CHECK(value=f"{moved_deg:.1f}")
        return self.basis.why_other(CheckBasis.of(controller, options))


def carried_by(controller: ArmController, content: Content) -> dict[str, Carried]:
    """Return what the points of a content have the hand hold, as far as the cell knows it."""
    points, cell = () if isinstance(content, Recording) else content.points, controller.cell.cell
    found = {}
    for name in {point.holds for point in points if point.holds is not None}:
        held = None if cell is None else part_named(cell.held_objects, name)
        if held is not None or not name:
            shape = None if held is None else held_shape(held)
            found[name] = Carried(shape, controller.area_guard.check_holding(name))
    return found


class Checks:
    """Runs checks one after another in the background.

    Args:
        controller: Gives the arm's state.
        background: Runs the checks.

    Attributes:
        background: Runs the checks, and other long work on points.
    """

    def __init__(self, controller: ArmController, background: Background) -> None:
        self._controller = controller
        self.background = background

    def get_ready(self) -> None:
        """Load the modules of checks in advance."""
        self.background.warm_up(warm_up)

    def begin(
        self, content: Content, options: RunOptions, then: Callable[[Preflight | Refusal], object]
    ) -> None:
        """Check a content for a run from the arm's present position.

        Args:
            content: The content to run.
            options: The options of the run.
            then: Receives the :class:`Preflight`, or why there is none, in this thread.
        """
        basis = CheckBasis.of(self._controller, options)
        order = CheckRequest(
            content,
            basis.arm,
            start_deg(self._controller),
            options.speed_factor,
            options.first,
            options.cycles,
            self._controller.area_guard.check(),
            basis.lowest_mm,
            carried_by(self._controller, content),
        )

        def hand_on(outcome: CheckOutcome | Refusal) -> None:
            if isinstance(outcome, Refusal):
                then(outcome)
            else:
                then(Preflight(order, outcome, basis))

        self.background.begin(Job(hand_on), check, order)

    @property
    def arm(self) -> ArmModel:
        """The arm as a plan sees it now."""
        return arm_model(self._controller)

    @property
    def stands_at_deg(self) -> tuple[float, ...] | None:
        """The joint angles of an arm at rest, to a degree; ``None`` if they are not known."""
        now, state = self._controller.operating_state, self._controller.state
        angles_deg = None if now.moving or now.unreachable else state.angles_deg()
        return None if angles_deg is None else tuple(float(round(each)) for each in angles_deg)

    def estimate(
        self,
        content: Content,
        options: RunOptions,
        then: Callable[[float | Refusal | None], object],
    ) -> Job[float | None]:
        """Work out how long something will take, see `estimate_s`; told in this thread.

        Returns:
            What is waited for; it may not be wanted any more.
        """
        job: Job[float | None] = Job(then)
        self.background.begin(job, estimate_s, content, self.arm, options, self.stands_at_deg)
        return job


# From the press to the run ----------------------------------------------------------------------


class RequestState(enum.Enum):
    """The progress of a request."""

    PRESSED = enum.auto()
    READING = enum.auto()
    CHECKING = enum.auto()
    CHECKED = enum.auto()
    """The check is done; a request for a check alone ends here."""
    ASKING = enum.auto()
    """The operator has to agree to the findings, or to a motion so long after the press."""
    STARTING = enum.auto()
    UNDER_WAY = enum.auto()
    REFUSED = enum.auto()
    GIVEN_UP = enum.auto()


_NEXT: Final[Mapping[RequestState, frozenset[RequestState]]] = {
    RequestState.PRESSED: frozenset({RequestState.READING}),
    RequestState.READING: frozenset({RequestState.CHECKING}),
    RequestState.CHECKING: frozenset({RequestState.READING, RequestState.CHECKED}),
    RequestState.CHECKED: frozenset({RequestState.ASKING, RequestState.STARTING}),
    RequestState.ASKING: frozenset({RequestState.READING, RequestState.STARTING}),
    RequestState.STARTING: frozenset({RequestState.UNDER_WAY}),
    RequestState.UNDER_WAY: frozenset(),
    RequestState.REFUSED: frozenset(),
    RequestState.GIVEN_UP: frozenset(),
}
"""The states that may follow each state, beside `REFUSED` and `GIVEN_UP`, which may follow any that
is not final.
"""


class RunRequest:
    """One press; the methods are in the order of its progress.

    Each checks the state first, so that an answer after the cancelling changes nothing. If the
    options change before the arm starts, the request reads and checks again.

    Args:
        controller: Gives the arm's state, and whether it may run something.
        checks: Checks the content.
        runner: Runs the checked content.
        read: Passes on the content when it is read; ``None`` if there is none, which it reports
            itself.
        options: Returns the options as shown now.
        told: Called with the request in each new state.
        runs: True to run it; otherwise it is only checked.
        why_not: Returns for a content's name a further reason against the run.
        clock: Monotonic time in seconds.

    Attributes:
        state: The progress.
        options: The options of the check and the run.
        name: The content's name; "" before it is read.
        checked: The check; ``None`` before.
        must_ask: True if the operator has to agree before the arm moves; with errors that is not
            possible.
        refusal: The reason for a refusal; ``None`` otherwise.
    """

    def __init__(
        self,
        controller: ArmController,
        checks: Checks,
        runner: Runner,
        *,
        read: Callable[[Callable[[Content | None], object]], object],
        options: Callable[[], RunOptions],
        told: Callable[[RunRequest], object],
        runs: bool = True,
        why_not: Callable[[str], Refusal | None] = lambda _name: None,
        clock: Callable[[], float] = steady_s,
    ) -> None:
        self._controller = controller
        self._checks = checks
        self._runner = runner
        self._read = read
        self._options_shown = options
        self._told = told
        self._why_not = why_not
        self._clock = clock
        self._mark = controller.mark
        self._pressed_s = clock()
        self.runs = runs
        self.state = RequestState.PRESSED
        self.options = options()
        self.name = ""
        self.checked: Preflight | None = None
        self.must_ask = False
        self.refusal: Refusal | None = None

    @property
    def is_over(self) -> bool:
        """True once the request has ended."""
        checked = self.state is RequestState.CHECKED and not self.runs
        return checked or not _NEXT[self.state]

    @property
    def is_busy(self) -> bool:
        """True while something is read or checked."""
        return self.state in {RequestState.READING, RequestState.CHECKING}

    def begin(self) -> None:
        """Begin to read the content."""
        refusal = self._controller.operating_state.cannot_run if self.runs else None
        if refusal is not None:
            self._refuse(refusal)
            return
        self.options = self._options_shown()
        self._enter(RequestState.READING)
        self._read(self._on_read)

    def _on_read(self, content: Content | None) -> None:
        """Have it checked, for the arm that the button was pressed for."""
        if self.state is not RequestState.READING:
            return
        if content is None:
            self.give_up()
        elif self.runs and not self._mark.is_still(self._controller.mark):
            self._refuse(ARM_CHANGED())
        else:
            self.name = content.name
            self._enter(RequestState.CHECKING)
            self._checks.begin(content, self.options, self._on_checked)

    def _on_checked(self, checked: Preflight | Refusal) -> None:
        """Run it at once, unless the operator has to be asked."""
        if self.state is not RequestState.CHECKING:
            return
        if isinstance(checked, Refusal):
            self._refuse(checked)
            return
        self.checked = checked
        if self.runs and self._goes_otherwise():
            return
        late = self._clock() - self._pressed_s > _SURPRISING_S
        self.must_ask = self.runs and not checked.errors and (late or bool(checked.findings))
        self._enter(RequestState.CHECKED)
        if self.is_over:  # only checked, or given up by whoever was told
            return
        if checked.errors:
            self._refuse(FINDINGS_AGAINST(count=checked.errors))
        elif self.must_ask:
            self._enter(RequestState.ASKING)
        else:
            self._start(checked)

    def accept(self) -> None:
        """Start the run, because the operator agrees."""
        if self.state is RequestState.ASKING and self.checked is not None:
            self._pressed_s = self._clock()
            if not self._goes_otherwise():
                self._start(self.checked)

    def _goes_otherwise(self) -> bool:
        """Begin anew if the choices were turned meanwhile; refuse what is not to be run at all."""
        refusal = self._why_not(self.name)
        if refusal is not None:
            self._refuse(refusal)
        elif self._options_shown() != self.options:
            self.begin()  # what is shown has not been checked
        else:
            return False
        return True

    def _start(self, checked: Preflight) -> None:
        """Let the arm set out, if the check still says something of it."""
        refusal = checked.why_outdated(self._controller, self.options)
        if refusal is None:
            self._enter(RequestState.STARTING)
            refusal = self._runner.start(checked)
        if refusal is not None:
            self._refuse(refusal)
        else:
            self._enter(RequestState.UNDER_WAY)

    def give_up(self) -> None:
        """Cancel the request; a run that has started is ended by other means."""
        if not self.is_over and self.state is not RequestState.STARTING:
            self._enter(RequestState.GIVEN_UP)

    def _refuse(self, refusal: Refusal) -> None:
        self.refusal = refusal
        self._enter(RequestState.REFUSED)

    def _enter(self, state: RequestState) -> None:
        """Go on to another state, and tell so.

        Raises:
            ValueError: It does not follow the present one.
        """
        ends = {RequestState.REFUSED, RequestState.GIVEN_UP}
        if self.is_over or state not in _NEXT[self.state] | ends:
            raise ValueError(f"a run request cannot go from {self.state.name} to {state.name}")
        self.state = state
        self._told(self)
