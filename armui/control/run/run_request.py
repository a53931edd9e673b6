"""One press on 发送 or 检查, from reading the content to the start of the arm."""

from __future__ import annotations

import enum
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Refusal
from armui.control.operations.started import ARM_CHANGED
from armui.control.run.player import why_not_run
from armui.control.run.preflight import FINDINGS_AGAINST, Preflight
from armui.system.clock import steady_s

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.run.preflight import Checks
    from armui.control.run.runner import Runner
    from armui.trajectory.files import Content
    from armui.trajectory.library.run_options import RunOptions

_SURPRISING_S: Final = 2.0
"""If the check took longer, the operator no longer expects the arm to move."""


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
        speed_percent: Returns the operator's speed at which it would begin now.
        on_state: Called with the request in each new state.
        runs: True to run it; otherwise it is only checked.
        why_not: Returns for the content a further reason against the run.
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
        speed_percent: Callable[[], int],
        on_state: Callable[[RunRequest], object],
        runs: bool = True,
        why_not: Callable[[Content], Refusal | None] = lambda _content: None,
        clock: Callable[[], float] = steady_s,
    ) -> None:
        self._controller = controller
        self._checks = checks
        self._runner = runner
        self._read = read
        self._options_shown = options
        self._speed_percent = speed_percent
        self._on_state = on_state
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

    @property
    def asks(self) -> bool:
        """True while the operator has to agree."""
        return self.state is RequestState.ASKING

    def begin(self) -> None:
        """Begin to read the content."""
        refusal = why_not_run(self._controller.operating_state) if self.runs else None
        if refusal is not None:
            self._refuse(refusal)
            return
        self.options = self._options_shown()
        self._enter(RequestState.READING)
        self._read(self._on_read)

    def _on_read(self, content: Content | None) -> None:
        """Start the check of the content, for the arm that the button was pressed for."""
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
        if self.runs and self._restart_if_changed(checked):
            return
        late = self._clock() - self._pressed_s > _SURPRISING_S
        self.must_ask = self.runs and not checked.errors and (late or bool(checked.findings))
        self._enter(RequestState.CHECKED)
        if self.is_over:  # only a check, or `on_state` gave it up
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
            if not self._restart_if_changed(self.checked):
                self._start(self.checked)

    def _restart_if_changed(self, checked: Preflight) -> bool:
        """Begin anew if the options have changed, or refuse; return whether either happened."""
        refusal = self._why_not(checked.order.content)
        if refusal is not None:
            self._refuse(refusal)
        elif self._options_shown() != self.options:
            self.begin()  # the options now shown were not checked
        else:
            return False
        return True

    def _start(self, checked: Preflight) -> None:
        """Start the run, if the check is still valid for the arm as it is now."""
        refusal = checked.why_outdated(self._controller, self.options)
        if refusal is None:
            self._enter(RequestState.STARTING)
            refusal = self._runner.start(checked, self._speed_percent())
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
        """Change to another state, and call `on_state`.

        Raises:
            ValueError: The state may not follow the present one.
        """
        ends = {RequestState.REFUSED, RequestState.GIVEN_UP}
        if self.is_over or state not in _NEXT[self.state] | ends:
            raise ValueError(f"a run request cannot go from {self.state.name} to {state.name}")
        self.state = state
        self._on_state(self)
