"""The check before a run: its input, its conditions, and its result."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Final, Protocol

from armui.arm.refusal import Reason, Refusal
from armui.cell.held_shape import held_shape
from armui.cell.parts import part_named
from armui.control.link.link_state import LinkState
from armui.control.operations.started import ARM_CHANGED
from armui.control.parameters.arm_model import arm_model, start_deg
from armui.trajectory.planning.check import Carried, CheckOutcome, CheckRequest, check, warm_up
from armui.trajectory.planning.findings import Finding, Severity
from armui.trajectory.points.program import frames_in
from armui.trajectory.samples.recording import Recording

if TYPE_CHECKING:
    from armui.arm.models import ArmModel
    from armui.cell.cell import Cell
    from armui.control.arm_controller import ArmController
    from armui.control.link.arm_mark import ArmMark
    from armui.trajectory.files import Content
    from armui.trajectory.library.run_options import RunOptions
    from armui.trajectory.library.store import Check
    from armui.trajectory.planning.planned_path import PlannedPath

LIMITS_CHANGED_SINCE_CHECK = Reason(
    "limits_changed_since_check",
    "Not run: the arm's joint limits have changed since the check. Press Run again.",
)
MODEL_CHANGED_SINCE_CHECK = Reason(
    "model_changed_since_check",
    "Not run: the arm's model or zeros have changed since the check. Press Run again.",
)
CHANGED_SINCE_CHECK = Reason(
    "changed_since_check",
    "Not run: tool, load, cell, settings or choices have changed since the check. Press Run again.",
)
MOVED_SINCE_CHECK = Reason(
    "moved_since_check",
    "Not run: the arm has moved by {value}° since it was checked. Press Run again.",
)
FINDINGS_AGAINST = Reason(
    "findings_against",
    "Not run: the check has found errors ({count}). Correct what is listed, then press Run again.",
)


Then = Callable[[Any], object]
"""Takes a result, or why there is none."""
_SAME_PLACE_DEG: Final = 0.5
"""The measured angles of an arm at rest waver by some hundredths."""


@dataclass(frozen=True, slots=True)
class CheckBasis:
    """The conditions of a check beside content and position; compared as a whole.

    Attributes:
        mark: The arm and the connection.
        arm: The arm's data for planning: limits, geometry and zeros, tool, gripper; of the user
            frames only those that the content's points name.
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
    def of(cls, controller: ArmController, options: RunOptions, content: Content) -> CheckBasis:
        """Return the present conditions for a content: frames that it does not name are none."""
        arm, altered = arm_model(controller), controller.transactions.alterations
        names = () if isinstance(content, Recording) else frames_in(content.points)
        arm = replace(arm, frames=tuple(each for each in arm.frames if each[0] in names))
        cell = controller.cell.cell
        shown_in_base = None if cell is None else replace(cell, frame="", frames=())
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
        return self.order.arm.fingerprint

    @property
    def path(self) -> PlannedPath:
        """The planned path of the arm."""
        return self.outcome.path

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The findings, errors first, then warnings of a contact, each by row."""
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
        """How long a cycle takes at the points' own speed."""
        return self.path.first_cycle_s

    @property
    def mark(self) -> Check:
        """The check mark for the content, independent of the arm's position."""
        of_content = [one.severity for one in self.findings if not one.is_of_approach]
        return "errors" if Severity.ERROR in of_content else "warnings" if of_content else "ok"

    def seen_from_elsewhere(self) -> Preflight:
        """Return it without what was found of the way to the first point."""
        holds = tuple(one for one in self.findings if not one.is_of_approach)
        return replace(self, outcome=replace(self.outcome, findings=holds))

    def why_outdated(self, controller: ArmController, options: RunOptions) -> Refusal | None:
        """Return why it is not valid for a run with these options now, or ``None``."""
        moved = self.why_moved(controller)
        return moved or self.basis.why_other(CheckBasis.of(controller, options, self.order.content))

    def why_moved(self, controller: ArmController) -> Refusal | None:
        """Return how far the arm stands from where the way to the first point was checked.

        ``None`` if it still stands there, or if it is not heard: that shows no motion.
        """
        online = controller.operating_state.link is LinkState.ONLINE
        if not online or controller.state.angles_deg() is None:
            return None
        pairs = zip(self.order.start_deg, start_deg(controller), strict=True)
        moved_deg = max(abs(there - here) for there, here in pairs)
        return MOVED_SINCE_CHECK(value=f"{moved_deg:.1f}") if moved_deg > _SAME_PLACE_DEG else None


def carried_by(controller: ArmController, content: Content) -> dict[str, Carried]:
    """Return the objects that a content's points name as held, as far as the cell has them."""
    points, cell = () if isinstance(content, Recording) else content.points, controller.cell.cell
    found = {}
    for name in {point.holds for point in points if point.holds is not None}:
        held = None if cell is None else part_named(cell.held_objects, name)
        if held is not None or not name:
            shape = None if held is None else held_shape(held)
            found[name] = Carried(shape, controller.area_guard.check_holding(name))
    return found


class Works(Protocol):
    """Runs work elsewhere; its recipient gets the result, or why there is none, in this thread."""

    def begin(self, then: Then, work: Callable[..., Any], /, *args: object) -> object:
        """Run a function of a module, possibly in another process."""

    def begin_here(self, then: Then, work: Callable[..., Any], /, *args: object) -> object:
        """Run work that waits for a disk, in a thread of this process."""

    def warm_up(self, work: Callable[[], object]) -> object:
        """Run a function of a module whose result nobody waits for."""


class Checks:
    """Runs checks one after another in the background.

    Args:
        controller: Gives the arm's state.
        background: Runs the checks.

    Attributes:
        background: Runs the checks, and other long work on points.
    """

    def __init__(self, controller: ArmController, background: Works) -> None:
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
        basis = CheckBasis.of(self._controller, options, content)
        order = CheckRequest(
            content,
            basis.arm,
            start_deg(self._controller),
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

        self.background.begin(hand_on, check, order)

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
