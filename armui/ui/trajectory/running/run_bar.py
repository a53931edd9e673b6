"""发送: the options of a run; every trajectory is checked before it is sent."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

from PySide6.QtCore import QObject, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QCheckBox, QLabel, QSpinBox, QWidget

from armui.arm.refusal import Reason, Refusal
from armui.control.arm_controller import ArmController
from armui.control.operating_state import OperatingState, StopState
from armui.control.operations.operation import operation_of
from armui.control.run.player import Player, why_not_run
from armui.control.run.preflight import Checks
from armui.control.run.progress import ENDLESS, Progress, capped_percent, sent_percent
from armui.control.run.replay import FULL_PERCENT
from armui.control.run.run_request import RequestState, RunRequest
from armui.control.run.runner import Runner, ended_early
from armui.trajectory.files import Content
from armui.trajectory.library.run_options import (
    FIRST_RUN_PERCENT,
    MOST_CYCLES,
    RunOptions,
    begin_percent,
)
from armui.trajectory.library.store import IndexEntry
from armui.trajectory.planning.timing import APPROACH_PERCENT
from armui.trajectory.points.program import SpeedsFrom, Trajectory, Waypoint
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.command import Command, Target, also, of_place
from armui.ui.actions.keys import keys_of, listen_for
from armui.ui.dialogs.confirm_dialog import ASKED_OTHERWISE
from armui.ui.theme import colors_of
from armui.ui.trajectory.running.run_estimate import RunEstimate, estimate_tip
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import (
    drop_down,
    enable_or_explain,
    named,
    push_button,
    show_primary,
    spin_box,
)
from armui.ui.widgets.flow import in_flow, pair
from armui.ui.widgets.layouts import fill, in_column, in_row
from armui.ui.widgets.text_label import ElidedLabel, text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

POINTS_CHANGED_SINCE_RUN = Reason(
    "points_changed_since_run",
    "The points have been changed since that run began: it cannot go on from a row of theirs. "
    "Choose “From row” and press Run.",
)

_ONCE, _TIMES, _LOOP = range(3)
_SPIN_PX: Final = 34
_SEND_SIZE: Final = QSize(150, 42)
"""The least size of 发送: running is what the program is for."""
_SEND_KEY: Final = keys_of("editor.send")


@dataclass(frozen=True, slots=True)
class _Started:
    """A run that was begun here.

    Attributes:
        name: The name of the trajectory.
        cycles: The chosen number of cycles.
        left: The cycles that are left.
        what: The content shown at the start, for comparison with the present one.
    """

    name: str
    cycles: int
    left: int
    what: object


class RunChoices(QObject):
    """The run options of each trajectory, shared by all pages that show and run it.

    Signals:
        changed: The name of a trajectory whose options have changed, or which has run.
        asking: The name of the trajectory that waits for confirmation; "" if none does.
    """

    changed = Signal(str)
    asking = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._options: dict[str, RunOptions] = {}
        self._ran: set[str] = set()
        self._asks: RunRequest | None = None

    def show_request(self, request: RunRequest) -> None:
        """Process the state of a request: whether it waits for the operator."""
        if request.state is RequestState.ASKING:
            self._asks = request
            self.asking.emit(request.name)
        elif request is self._asks:
            self._asks = None
            self.asking.emit("")

    def of(self, name: str) -> RunOptions:
        """Return the options of a trajectory."""
        return self._options.get(name, RunOptions())

    def has_run(self, name: str) -> bool:
        """Return whether a trajectory is known to have run."""
        return name in self._ran

    def choose(self, name: str, options: RunOptions) -> None:
        """Store the operator's options."""
        if name and options != self.of(name):
            self._options[name] = options
            self.changed.emit(name)

    def note_run(self, name: str) -> None:
        """Note that a trajectory runs."""
        self._ran.add(name)
        self.changed.emit(name)

    def follow(self, entries: Sequence[IndexEntry], is_open: Callable[[str], bool]) -> None:
        """Take over the options stored in the library, for each trajectory when it is first seen.

        Later only the operator changes them, no other program.

        Args:
            entries: All entries; options of others are dropped.
            is_open: Returns whether a trajectory is open in an editor, saved or not.
        """
        kept = {entry.name for entry in entries}
        for name in self._options.keys() | self._ran:
            if name not in kept and not is_open(name):
                self._options.pop(name, None)
                self._ran.discard(name)
        for entry in entries:
            self._options.setdefault(entry.name, entry.ran_with or self.of(entry.name))
            if entry.ran_with is not None and entry.name not in self._ran:
                self.note_run(entry.name)


def run_commands(place: str) -> tuple[Command, ...]:
    """Return the commands of the bar in a place."""
    commands = (
        Command(
            "send", Text("RunBar", "Run"), operation_of(Player.start), synonyms=also("send start")
        ),
        Command("cycles", Text("RunBar", "Number of runs")),
        Command("first", Text("RunBar", "From row")),
        Command("steps", Text("RunBar", "Step by step")),
    )
    return of_place(place, commands)


class RunBar(Translated, QWidget):
    """Runs its page's trajectory; the :class:`RunStrip` shows the progress.

    Args:
        controller: Runs the trajectory.
        checks: Checks it before.
        choices: The run options, shared by all pages.
        content: Passes on the content to run when it is read; ``None`` if there is none, which it
            reports itself.
        quietly: Passes on the same without reporting; its duration is estimated from it.
        beside: Buttons that stand before 发送.

    Signals:
        checked: A :class:`Preflight` and, if the operator has to agree to the run, a function that
            begins it; else ``None``.
        withdrawn: The question to the operator no longer applies.
        refused: A :class:`Refusal`.
        obstacle_gone: The reason of the last refusal does not hold any more.
        progressed: A :class:`Progress`.
        started: The name of the started trajectory, and its :class:`RunOptions`.
    """

    checked = Signal(object, object)
    withdrawn = Signal()
    refused = Signal(object)
    obstacle_gone = Signal()
    progressed = Signal(object)
    started = Signal(str, object)

    def __init__(
        self,
        controller: ArmController,
        checks: Checks,
        choices: RunChoices,
        content: Callable[[Callable[[Content | None], object]], object],
        quietly: Callable[[Callable[[Content | None], object]], object],
        *,
        beside: Iterable[QWidget] = (),
    ) -> None:
        super().__init__()
        self._controller = controller
        self._beside = tuple(beside)
        self._estimate = RunEstimate(checks, quietly, self._options, self._begins_at, self)
        self._what: object = None
        self._obstacle: Refusal | None = None
        self._checks = checks
        self._shared = choices
        self._content = content
        self._name = ""
        self._speeds: Sequence[SpeedsFrom] = ()
        self._request: RunRequest | None = None
        self._recording = self._unsaved = False
        self._nothing: Refusal | None = None
        self._is_secondary = False
        self._runner = Runner(controller, self)
        self._again: _Started | None = None
        self._make_widgets()
        self._lay_out()
        self._recolor()
        self._send.clicked.connect(self.send)
        self._call_off.clicked.connect(lambda _checked=False: self.drop_check())
        self._resume.clicked.connect(self.resume)
        self._cycles.currentIndexChanged.connect(self._on_chosen)
        for spin in (self._times, self._first):
            spin.valueChanged.connect(self._on_chosen)
        self._steps.toggled.connect(self._on_chosen)
        choices.changed.connect(self._on_shared)
        self._estimate.changed.connect(self._show_effective)
        self._runner.progressed.connect(self._on_progress)
        controller.operating_state_changed.connect(self._on_operating_state)
        controller.all_motion_ended.connect(self._on_all_motion_ended)
        self.retranslate_ui()

    def _make_widgets(self) -> None:
        self._send = push_button("run_send", primary=True, on_enter=False)
        self._send.setProperty("large", True)
        self._send.setMinimumSize(_SEND_SIZE)
        self._call_off = push_button("run_call_off", on_enter=False)
        self._state = text_label("run_checking", rank="muted")
        self._resume = push_button("run_resume", on_enter=False)
        self._cycles = drop_down("run_cycles")
        self._cycles.addItems(["", "", ""])
        self._times = _spin("run_times", MOST_CYCLES, 3)
        self._first = _spin("run_first", 1, 1)
        self._first_label = QLabel()
        self._steps = named("run_steps", QCheckBox())
        self._effective = named("run_effective", ElidedLabel("muted"))
        self._effective.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._choices = (self._cycles, self._times, self._first, self._steps)

    def _lay_out(self) -> None:
        self._from_row = pair(self._first_label, self._first)
        options = in_flow(
            *(self._cycles, self._times, self._from_row, self._steps),
            spacing_px=8,
        )
        # always one line, so that 发送 and the jog buttons above never move
        told = in_row((self._effective, 1), self._state, self._call_off, spacing=8, margins=0)
        # at the left end: no other button moves under the pointer when it disappears
        fill(told, self._resume, *self._beside, self._send)
        in_column(options, told, on=self, spacing=8, margins=0)

    def command_targets(self, place: str) -> Mapping[str, Target]:
        """Return what carries out each command, by the command's name in a place."""
        return {
            f"{place}.send": self._send,
            f"{place}.cycles": self._cycles,
            f"{place}.first": self._first,
            f"{place}.steps": self._steps,
        }

    # What the operator wants ------------------------------------------------------------------

    def listen(self, page: QWidget) -> None:
        """Connect the key of 发送 anywhere in its page; a held key presses once."""
        listen_for("editor.send", page, self._send.click).setAutoRepeat(False)

    def show_content(
        self,
        name: str,
        count: int,
        *,
        speeds: Sequence[SpeedsFrom] = (),
        recording: bool = False,
        nothing: Refusal | None = None,
        state: object = None,
        unsaved: bool = False,
    ) -> None:
        """Fit the choices to the content to run.

        Args:
            name: Its name; "" without content.
            count: The number of its points.
            speeds: The lowest and highest speed percentage of its points from each row on.
            recording: True for a recording, which has no points.
            nothing: The reason why there is nothing to run.
            state: A value that changes whenever the points do.
            unsaved: True if it has unsaved changes, which do not run.
        """
        self._name, self._speeds = name, speeds
        self._what = (name, count, tuple(speeds), recording, state)
        self._recording, self._nothing, self._unsaved = recording, nothing, unsaved
        # a row lowered by the new maximum is not the operator's choice
        with QSignalBlocker(self._first):
            self._first.setMaximum(max(1, count))
        self._on_shared(name)
        for widget in (self._from_row, self._steps):
            widget.setVisible(not recording)
        self._show_usable()

    def renew_estimate(self) -> None:
        """Estimate the time again, because the content has changed under the same name."""
        self._estimate.renew()
        self._follow_estimate()

    def _follow_estimate(self) -> None:
        wanted = self.isVisible() and bool(self._name) and self._nothing is None
        wanted = wanted and not self._steps.isChecked()
        wanted = wanted and self._controller.operating_state.speed_percent > 0
        self._estimate.follow(self._what, wanted=wanted)

    def _options(self) -> RunOptions:
        recording = self._recording
        cycles = {_ONCE: 1, _TIMES: self._times.value(), _LOOP: ENDLESS}
        return RunOptions(
            cycles[self._cycles.currentIndex()],
            0 if recording else self._first.value() - 1,
            not recording and self._steps.isChecked(),
        )

    def _begins_at(self) -> int:
        """Return the speed percentage at which a run would begin now."""
        seen = self._runner.running or self._shared.has_run(self._name)
        return begin_percent(self._controller.operating_state.speed_percent, seen=seen)

    def _on_chosen(self, *_: object) -> None:
        self._shared.choose(self._name, self._options())
        self._show_usable()

    def _on_shared(self, name: str) -> None:
        """Show what was chosen for the trajectory, on whichever page."""
        if not name or name != self._name:
            return
        wanted = self._shared.of(name)
        if wanted != self._options():
            # what is only shown must not be stored as a new choice
            blocked = [QSignalBlocker(widget) for widget in self._choices]
            often = {1: _ONCE, ENDLESS: _LOOP}.get(wanted.cycles, _TIMES)
            self._cycles.setCurrentIndex(often)
            if often == _TIMES:
                self._times.setValue(wanted.cycles)
            self._first.setValue(wanted.first + 1)
            self._steps.setChecked(wanted.step_by_step)
            del blocked
        self._show_usable()

    def _show_effective(self) -> None:
        """Show how long a run takes, at 100 % and at the operator's speed."""
        percent = self._begins_at()
        texts = self._times_texts(percent)
        if self._recording:
            tip = self.tr("The recorded pace × the speed at the top, here {percent} %.")
            lines = [tip.format(percent=percent)]
            tip = self.tr("The first sample is approached at {percent} %.")
            lines.append(tip.format(percent=capped_percent(APPROACH_PERCENT, percent)))
        else:
            # a repeated run goes through all rows
            row = self._first.value() if self._cycles.currentIndex() == _ONCE else 1
            low, high = (sent_percent(one, percent) for one in self._range_from(row))
            figures = f"{low} %" if low == high else f"{low}–{high} %"
            tip = self.tr("The speed of each row × that at the top: {percent} from row {row} on.")
            lines = [tip.format(percent=figures, row=row)]
        if not self._shared.has_run(self._name):
            first = self.tr("first run: lowered to {percent} %")
            lowered = percent < self._controller.operating_state.speed_percent
            texts.append(first.format(percent=percent) if lowered else self.tr("first run"))
            begin = self.tr(
                "“{name}” is not known to have run: the speed at the top is lowered to {percent} % "
                "as it begins."
            )
            lines.append(begin.format(name=self._name, percent=FIRST_RUN_PERCENT))
        if self._unsaved:
            texts.append(self.tr("without its unsaved changes"))
        lines.append(self._time_tip())
        known = bool(self._name) and (self._recording or bool(self._speeds))
        tip = "\n".join(filter(None, lines))
        self._effective.show_text(" · ".join(texts) if known else "", tip if known else "")

    def _times_texts(self, percent: int) -> list[str]:
        """Return how long it takes: estimates, or as it was checked; empty if it is not known."""
        estimate = self._estimate
        if estimate.seconds is None or self._steps.isChecked() or percent == 0:
            return []  # a run waits at 0 %: its time is unlimited
        full = fmt.duration(estimate.seconds)
        texts = [full if estimate.is_checked else f"≈ {full}"]
        if estimate.from_here:  # the list shows the time without the way to row 1
            texts = [self.tr("from here {time}").format(time=texts[0])]
        if self._cycles.currentIndex() == _LOOP:
            texts = [self.tr("{time} a run").format(time=texts[0])]
        if percent != FULL_PERCENT and estimate.slowed_s is not None:
            text = self.tr("at {percent} % ≈ {time}")
            texts.append(text.format(percent=percent, time=fmt.duration(estimate.slowed_s)))
        return texts

    def _time_tip(self) -> str:
        estimate = self._estimate
        if self._steps.isChecked():
            return self.tr("Step by step it takes as long as the operator.")
        if estimate.is_checked or estimate.is_asked or self._nothing or not self.isVisible():
            return ""
        return estimate_tip(known=estimate.seconds is not None, from_here=estimate.from_here)

    def _range_from(self, row: int) -> tuple[int, int]:
        """Return the lowest and highest speed percentage of the points from a row on, from 1."""
        before = [one for one in self._speeds if one.row < row]
        return before[-1][1:] if before else (1, 1)

    # Requests ---------------------------------------------------------------------------------

    def show_secondary(self, wanted: bool) -> None:
        """Set whether running is not the main action of the page."""
        self._is_secondary = wanted
        self._show_usable()

    def check(self) -> None:
        """Check the content without running it; :attr:`checked` has the result."""
        self._begin(self._options, runs=False)

    def send(self) -> None:
        """Check the content, then run it; what nobody has seen run begins slowly."""
        self._begin(self._options)

    def resume(self) -> None:
        """Continue a run where it ended."""
        self._begin(self._options_to_resume, self._why_not_resume)

    def _begin(
        self,
        options: Callable[[], RunOptions],
        why_not: Callable[[Content], Refusal | None] = lambda _content: None,
        *,
        runs: bool = True,
    ) -> None:
        self._give_up()
        self._request = RunRequest(
            *(self._controller, self._checks, self._runner),
            read=self._content,
            options=options,
            speed_percent=self._begins_at,
            on_state=self._on_request,
            runs=runs,
            why_not=why_not,
        )
        self._request.begin()

    def _on_request(self, request: RunRequest) -> None:
        """Show how far a request has come."""
        if request is not self._request:
            return
        self._shared.show_request(request)
        self._show_usable()
        checked = request.checked
        if request.state is RequestState.CHECKED and checked is not None:
            self._estimate.take(checked)
            self.checked.emit(checked, request.accept if request.must_ask else None)
        elif request.state is RequestState.REFUSED:
            self._obstacle = request.refusal if self._is_told(request.refusal) else None
            self.refused.emit(request.refusal)
        elif request.state is RequestState.GIVEN_UP and request.must_ask:
            self.withdrawn.emit()
        elif request.state is RequestState.UNDER_WAY and checked is not None:
            cycles = self._options().cycles
            self._again = _Started(*(request.name, cycles, request.options.cycles, self._what))
            self._shared.note_run(request.name)
            self.started.emit(request.name, self._options())

    def drop_check(self, but: str = "") -> None:
        """Cancel a request that no longer applies, or is not wanted.

        Args:
            but: The name of the trajectory whose check may go on.
        """
        if self._request is not None and not (but and self._request.name in {"", but}):
            self._give_up()

    def _give_up(self) -> None:
        if self._request is not None:
            self._request.give_up()

    @property
    def is_checking(self) -> bool:
        """True while something is read or checked."""
        return self._request is not None and self._request.is_busy

    def _options_to_resume(self) -> RunOptions:
        """Return the options from where the run ended, with the cycles left unless changed."""
        options, again = self._options(), self._again
        if again is not None and again.cycles == options.cycles:
            options = replace(options, cycles=again.left)
        return replace(options, first=self._runner.progress.index)

    def _may_resume(self, name: str) -> bool:
        """Return whether the last run was begun here, and can go on with the same points."""
        progress, again = self._runner.progress, self._again
        if again is None or again.what != self._what:
            return False
        points = progress.count > 0  # a recording can only be replayed from its beginning
        return points and again.name == progress.name == name and ended_early(progress)

    def _why_not_resume(self, content: Content) -> Refusal | None:
        if not self._may_resume(content.name):
            return ASKED_OTHERWISE()
        same = isinstance(content, Trajectory) and self.goes_by(content.points)
        return None if same else POINTS_CHANGED_SINCE_RUN()

    @property
    def progress(self) -> Progress:
        """The progress of the run under way, or of the last one."""
        return self._runner.progress

    def goes_by(self, points: Sequence[Waypoint]) -> bool:
        """Return whether the run under way, or the last one, is of exactly these points."""
        return self._runner.goes_by(points)

    # Progress ---------------------------------------------------------------------------------

    def _on_progress(self, progress: Progress) -> None:
        if ended_early(progress) and self._again is not None:
            left = ENDLESS if progress.cycles == ENDLESS else progress.cycles - progress.cycle + 1
            self._again = replace(self._again, left=left)
        if self.isVisible():
            self._show_usable()
        self.progressed.emit(progress)

    def _on_all_motion_ended(self) -> None:
        """Drop a run that is about to begin: a stop or halt is meant for it as well."""
        if self._request is not None and self._request.runs:
            self._request.give_up()

    def _on_operating_state(self, operating_state: OperatingState) -> None:
        if operating_state.stop is not StopState.RUNNING:
            self._on_all_motion_ended()
        if self._obstacle is not None and not self._is_told(self._obstacle):
            self._obstacle = None
            self.obstacle_gone.emit()
        if self.isVisible():
            self._show_usable()

    def _is_told(self, reason: Refusal | None) -> bool:
        """Return whether the arm's state still gives a reason against a run."""
        now = why_not_run(self._controller.operating_state)
        return now is not None and reason is not None and now.reason == reason.reason

    def _why_not(self) -> str:
        """Return why nothing can be sent now; "" if it can."""
        if self._nothing is not None:
            return words.refusal(self._nothing)
        if self._runner.running:
            return self.tr("A run is under way.")
        return words.why_not(why_not_run(self._controller.operating_state))

    def _show_usable(self, *_: object) -> None:
        progress, checking = self._runner.progress, self.is_checking
        why_not = self._why_not()
        for choice in self._choices:  # they do not apply to the run under way
            choice.setEnabled(not self._runner.running)
        self._follow_estimate()
        self._show_effective()
        self._times.setVisible(self._cycles.currentIndex() == _TIMES)
        reason = self.tr("Checking…") if checking else why_not
        enable_or_explain(self._send, reason, self.tr("Checks it and runs it"), key=_SEND_KEY)
        # the question has its own primary button
        asks = self._request is not None and self._request.asks
        show_primary(self._send, wanted=not (self._is_secondary or asks))
        self._recolor()
        self._state.setText(self.tr("Checking…") if checking else "")
        self._state.setVisible(checking)
        self._call_off.setVisible(checking)
        free = not (self._runner.running or checking)
        self._resume.setVisible(free and self._may_resume(self._name))
        enable_or_explain(self._resume, why_not)
        self._resume.setText(self.tr("Continue from row {row}").format(row=progress.index + 1))

    # Texts ------------------------------------------------------------------------------------

    def _recolor(self) -> None:
        colors = colors_of(self)
        usable = colors.on_accent if self._send.property("primary") else colors.text
        self._send.setIcon(icons.icon("play", usable if self._send.isEnabled() else colors.faint))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._send.setText(self.tr("Run"))
        self._call_off.setText(self.tr("Cancel"))
        for place, text in enumerate((self.tr("Once"), self.tr("Times"), self.tr("Loop"))):
            self._cycles.setItemText(place, text)
        self._cycles.setAccessibleName(self.tr("Number of runs"))
        self._times.setAccessibleName(self.tr("Number of runs"))
        self._first_label.setText(self.tr("From row"))
        self._first.setAccessibleName(self._first_label.text())
        self._steps.setText(self.tr("Step by step"))
        self._show_usable()

    def showEvent(self, event: QShowEvent) -> None:
        """Update the choices, which were not updated while the page was hidden."""
        self._show_usable()
        super().showEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:
        """Cancel a check: nothing may start from a hidden page."""
        if self.is_checking:
            self._give_up()
        super().hideEvent(event)
        self._follow_estimate()


def _spin(name: str, most: int, value: int) -> QSpinBox:
    spin = named(name, spin_box(1, most))
    spin.setValue(value)
    spin.setFixedHeight(_SPIN_PX)
    return spin
