"""示教: drag teaching, the steps that end it, and the motions the arm has planned (0x150)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import chain
from typing import Final, TypeVar

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractButton, QFrame, QGridLayout, QLabel

from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.arm_controller import ArmController
from armui.control.devices.teaching import TEACHING_UNANSWERED, TeachingControl
from armui.control.devices.teaching_phase import TeachingPhase, phase_of, why_not_teach
from armui.control.events import Event, Level
from armui.control.motion.planned_motion import PlannedMotion
from armui.control.operating_state import OperatingState
from armui.control.operations.started import refusal_of
from armui.control.safety.interlocks import PASSING
from armui.control.safety.recovery_steps import UNHINDERED, Action, Step, StepKind
from armui.protocol.codes import TeachingState, TrajectoryCommand
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, ActFamily
from armui.ui.dialogs.confirm_dialog import confirm
from armui.ui.freshness import is_stale
from armui.ui.panels.panel import Panel
from armui.ui.panels.parameters.levels_panel import DragAssistanceDialog
from armui.ui.widgets.layouts import STRETCH, empty_grid, in_column, in_row, scrolled
from armui.ui.widgets.text_label import text_label
from armui.ui.words.arm import TEACHING_COMMANDS, TRAJECTORY_COMMANDS
from armui.ui.words.text import Text, Texts

_Key = TypeVar("_Key")

_BUTTON_PX: Final = 36
_COLUMNS: Final = 6

_COMMANDS: Final = (
    (TeachingState.START_RECORDING, TeachingState.STOP_RECORDING),
    (TeachingState.RUN_RECORDING, TeachingState.MOVE_TO_START),
    (TeachingState.PAUSE, TeachingState.CONTINUE, TeachingState.ABORT),
)
_PLANS: Final = (
    (TrajectoryCommand.PAUSE, TrajectoryCommand.CONTINUE, TrajectoryCommand.ABORT),
    (TrajectoryCommand.CLEAR_CURRENT, TrajectoryCommand.CLEAR_ALL),
)
_MOVES: Final = frozenset(
    {TeachingState.RUN_RECORDING, TeachingState.MOVE_TO_START, TeachingState.CONTINUE}
)
_STEPS: Final = 4
_SIGN_PX: Final = 14
_NUMBER: Final[Mapping[StepKind, int]] = {
    StepKind.RECORDING: 1,
    StepKind.REPLAYING: 1,
    StepKind.REPLAY_PAUSED: 1,
    StepKind.DRAG_MODE_WITHOUT_POWER: 1,
    StepKind.OVERSPEED: 1,
    StepKind.DRAG_MODE: 1,
    StepKind.DRAG_MODE_AT_REST: 2,
    StepKind.STOP_REQUESTED: 2,
    StepKind.STOPPED: 3,
    StepKind.STOPPED_INPUT: 3,
    StepKind.MOTORS_OFF: 4,
    StepKind.MOTORS_MIXED: 4,
}
"""The number of the step that is due. The steps are taken in the line above the panels, where the
arm's feedback leads from one to the next.
"""

_STOPPED: Final = frozenset({StepKind.STOP_REQUESTED, StepKind.STOPPED, StepKind.STOPPED_INPUT})
_OVER: Final = UNHINDERED | {
    *(StepKind.NO_DEVICE, StepKind.OPENING, StepKind.NO_MOTION),
    StepKind.OUTSIDE,  # its motors are on: the way back is no part of drag teaching
}
_PHASES: Final = Texts("TeachingPhase") | {
    TeachingPhase.OFF: "Not in drag teaching",
    TeachingPhase.IDLE: "In drag teaching, nothing under way",
    TeachingPhase.RECORDING: "Recording: lead the arm by hand",
    TeachingPhase.REPLAYING: "Moving along the recording",
    TeachingPhase.PAUSED: "Replay paused",
}
_PLAN_TITLES: Final = {
    TrajectoryCommand.PAUSE: Text("Action", "Pause the planned motion"),
    TrajectoryCommand.CONTINUE: Text("Action", "Continue the held motion"),
    TrajectoryCommand.ABORT: Text("Action", "Terminate the planned motion"),
}
"""The titles in the palette that differ from the texts on the buttons."""


class TeachingExitSteps(QFrame):
    """Four lines with the step that is due marked; hidden outside of drag teaching."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("teaching_exit_steps")
        self._leaving = False
        self._led = False
        self._stopped_early = False
        self._due = 0
        self._title = text_label(wraps=True)
        self._signs = [QLabel() for _ in range(_STEPS)]
        self._lines = [text_label(wraps=True) for _ in range(_STEPS)]
        grid = empty_grid(self, gaps=(6, 4), margins=0)
        grid.addWidget(self._title, 0, 0, 1, 2)
        for row, (sign, line) in enumerate(zip(self._signs, self._lines, strict=True), start=1):
            sign.setFixedWidth(_SIGN_PX)
            grid.addWidget(sign, row, 0, Qt.AlignmentFlag.AlignTop)
            grid.addWidget(line, row, 1)
        grid.setColumnStretch(1, 1)
        self.hide()

    @property
    def due(self) -> int:
        """The step that is due, 1–4; 0 outside of drag teaching."""
        return self._due if self._leaving else 0

    def show_step(self, phase: TeachingPhase | None, step: Step) -> None:
        """Show the arm's progress: the steps begin with drag teaching and end with a ready arm."""
        if phase is not None and phase is not TeachingPhase.OFF:
            self._leaving = True
        elif step.kind in _OVER:
            self._leaving = False
        due = _NUMBER.get(step.kind, self._due)
        if step.kind is StepKind.DRAG_MODE_AT_REST or due == 1:
            self._led = due == 2
        self._stopped_early = step.kind in _STOPPED and not self._led
        self._due = 1 if self._stopped_early else due
        self.setVisible(self._leaving)
        self._mark()

    def _mark(self) -> None:
        self._title.setText(
            self.tr(
                "Stopped before the arm was led back: that does not end drag teaching. Release it "
                "in the line above the panels, then take these steps:"
            )
            if self._stopped_early
            else self.tr("To leave drag teaching, take the steps in the line above the panels:")
        )
        for number, label in enumerate(self._lines, start=1):
            font = label.font()
            font.setBold(number == self._due)
            label.setFont(font)
            sign = "✓" if number < self._due else "▸" if number == self._due else ""
            if number < min(self._due, 3) and not self._led:
                sign = "–"  # skipped: a stop came before the arm was led back
            self._signs[number - 1].setText(sign)
            label.setText(f"{number}. {self._words()[number - 1]}")

    def _words(self) -> tuple[str, ...]:
        return (
            self.tr("End what is under way; lead every joint near its zero by hand."),
            self.tr("Hold the arm, press “{action}”: the motors only brake, the arm sinks.").format(
                action=words.step_action(Action.RESET)
            ),
            self.tr("Hold down “{action}”: the arm will drop, keep holding it.").format(
                action=words.step_action(Action.RESUME)
            ),
            self.tr("Press “{action}”.").format(action=words.step_action(Action.ENABLE)),
        )

    def retranslate_ui(self) -> None:
        """Set its texts in the operator's language."""
        self._mark()


class TeachingPanel(Panel):
    """The commands that make sense now; the others show why they do not."""

    teach = ActFamily(
        {
            command: Act(
                TEACHING_COMMANDS.entry(command),
                named=f"teaching_{command.name.lower()}",
                does=TeachingControl.command,
                arguments={"command": command},
                key=f"teaching.{command.name.lower()}",
                title=TEACHING_COMMANDS.entry(command),
                leads=command in _MOVES,
                held=command is TeachingState.CONTINUE,  # a slip must not resume a motion
                least_height_px=_BUTTON_PX,
            )
            for command in chain(*_COMMANDS)
        }
    )
    plan = ActFamily(
        {
            command: Act(
                TRAJECTORY_COMMANDS.entry(command),
                named=f"plan_{command.name.lower()}",
                does=PlannedMotion.command,
                arguments={"command": command},
                key=f"teaching.plan_{command.name.lower()}",
                title=_PLAN_TITLES.get(command, TRAJECTORY_COMMANDS.entry(command)),
                held=command is TrajectoryCommand.CONTINUE,
                least_height_px=_BUTTON_PX,
            )
            for command in chain(*_PLANS)
        }
    )
    assistance = Act(
        "Drag assistance…",
        named="drag_assistance_button",
        tip="How much each joint helps the hand; firmware from S-V1.8-1.",
        key="teaching.assistance",
        flat=True,
    )

    def __init__(self, controller: ArmController, open_backup: Callable[[], object]) -> None:
        super().__init__(controller, "teaching_message")
        self._open_backup = open_backup
        self._assistance: DragAssistanceDialog | None = None
        self._unanswered: Event | None = None
        self._withdrawn: Refusal | None = None
        """Why a question was withdrawn; shown until the next press."""
        self._shown: tuple[object, ...] | None = None
        self._state_label = QLabel()
        self._state = text_label("teaching_state", wraps=True)
        self._phase = text_label("teaching_phase", rank="muted")
        self._note = text_label(rank="muted", wraps=True)
        self._teaching_exit_steps = TeachingExitSteps()
        self._plan_label = QLabel()
        self._plan_note = text_label(rank="muted", wraps=True)
        self._lay_out()
        self._listen()
        self._controller.step_changed.connect(self._show_new)
        self.retranslate_ui()

    # -- layout -------------------------------------------------------------------------------

    def _lay_out(self) -> None:
        card = QFrame()
        state = empty_grid(gaps=(10, None))
        state.addWidget(self._state_label, 0, 0, Qt.AlignmentFlag.AlignTop)
        state.addWidget(self._state, 0, 1)
        state.addWidget(self._phase, 1, 1)
        state.setColumnStretch(1, 1)
        parts = (
            state,
            _grid(_COMMANDS, self.teach),
            self._note,
            self._teaching_exit_steps,
            6,
            self._plan_label,
            _grid(_PLANS, self.plan),
            self._plan_note,
            STRETCH,
        )
        in_column(*parts, on=card, spacing=8, margins=(16, 12, 16, 12))
        head = in_row((self._title, 1), self.assistance)
        self._stack(scrolled(card), head=head)

    # -- actions ------------------------------------------------------------------------------

    @assistance.pressed
    def _open_assistance(self) -> None:
        if self._assistance is None:
            self._assistance = DragAssistanceDialog(
                self._controller, self._open_backup, self.window()
            )
        self._assistance.open()

    @teach.pressed
    def _on_command(self, command: TeachingState) -> None:
        self._withdrawn = None
        label = TEACHING_COMMANDS.text(command)
        if command is TeachingState.START_RECORDING:
            title = words.step_question(Action.LEAD_BY_HAND)
            text = words.step_danger(Action.LEAD_BY_HAND)
        elif command in _MOVES and command is not TeachingState.CONTINUE:
            title, text = label, self._danger(command)
        else:
            self._command(command)
            return
        confirm(
            self.window(),
            self._controller,
            title=title,
            text=text,
            action_label=label,
            on_confirmed=lambda: self._command(command),
            still=lambda: self._still_asked(command),
            on_withdrawn=self._on_withdrawn,
        )

    def _still_asked(self, command: TeachingState) -> bool:
        """Return whether a question is still valid; late feedback does not withdraw it."""
        reason = why_not_teach(self._controller.operating_state, command)
        return reason is None or reason.reason in PASSING

    def _on_withdrawn(self, reason: Refusal) -> None:
        self._withdrawn = reason
        self._show_all()

    def _danger(self, command: TeachingState) -> str:
        """Return the warning before a command after which the arm moves by itself."""
        if command is TeachingState.MOVE_TO_START:
            does = self.tr("The arm will move by itself to the start of the recording it holds.")
        else:
            does = self.tr(
                "The arm will move by itself along the recording it holds, from where it stands."
            )
        return "\n".join(
            (
                does,
                self.tr(
                    "This program does not know its way, and has not checked it. Keep clear, the "
                    "emergency stop within reach."
                ),
            )
        )

    def _command(self, command: TeachingState) -> None:
        self._unanswered = None
        self._refusal = refusal_of(self._controller.teaching.command(command))
        self._show_all()

    @plan.pressed
    def _on_plan(self, plan: TrajectoryCommand) -> None:
        self._withdrawn = None
        self._unanswered = None
        self._refusal = refusal_of(self._controller.planned_motion.command(plan))
        self._show_all()

    # -- what comes from the arm --------------------------------------------------------------

    def _on_state_changed(self, _state: ArmState) -> None:
        self._show_new()

    def _on_operating_state_changed(self, operating_state: OperatingState) -> None:
        self._operating_state = operating_state
        self._refusal = None
        self._show_new()

    def _on_noticed(self, event: Event) -> None:
        if event.notice == TEACHING_UNANSWERED:
            self._unanswered = event
            self._show_all()

    def _show_new(self) -> None:
        """Update after a change only: feedback comes thirty times a second."""
        if not self.isVisible():
            return
        shown = self._facts()
        if shown != self._shown:
            if self._shown is not None and shown[0] != self._shown[0]:
                self._unanswered = None
            self._shown = shown
            self._show_all()

    def _facts(self) -> tuple[object, ...]:
        controller = self._controller
        return (
            self._phase_now(),
            None if controller.state.status is None else controller.state.status.value,
            self._operating_state,
            controller.recovery.step,
            controller.teaching.pending,
        )

    def _phase_now(self) -> TeachingPhase | None:
        """Return the phase of drag teaching, or ``None`` if it is not known."""
        state = self._controller.state
        if state.status is None or is_stale(state.status, state, self._operating_state):
            return None
        return phase_of(state.status.value)

    # -- appearance ---------------------------------------------------------------------------

    def _show_all(self) -> None:
        phase = self._phase_now()
        heard = self._controller.state.status
        known = heard is not None and phase is not None
        self._state.setText(words.teaching_now(heard.value) if heard and known else fmt.NOTHING)
        self._phase.setText(_PHASES.text(phase) if phase is not None else fmt.NOTHING)
        self.show_acts()
        self._teaching_exit_steps.show_step(phase, self._controller.recovery.step)
        self._show_message()

    @teach.tip
    def _describe(self, command: TeachingState) -> str:
        if command is TeachingState.START_RECORDING:
            return self.tr("The arm gives way to the hand and records where it is led.")
        if command in _MOVES:
            return self.tr("The arm moves: keep clear.")
        return words.teaching(command)

    @plan.tip
    def _describe_plan(self, _command: TrajectoryCommand) -> str:
        return self._plan_note.text()

    def _show_message(self) -> None:
        self._fill_message()
        self._share_room()

    def _fill_message(self) -> None:
        controller = self._controller
        unreachable = self._unless_told(self._operating_state.unreachable)
        refusal = self._refusal or unreachable or self._withdrawn
        if refusal is not None:
            self._show_outcome(refusal)
        elif controller.teaching.pending is not None:
            text = self.tr("Waiting for the arm: {command}")
            command = TEACHING_COMMANDS.text(controller.teaching.pending)
            self._message.show_message(text.format(command=command))
        elif self._unanswered is not None:
            self._message.show_message(words.event(self._unanswered), Level.FAULT)
        elif self._operating_state.holds:
            text = self.tr("A motion is held back: hold Continue, or give it up by Terminate.")
            self._message.show_message(text, Level.WARNING)
        else:
            self._message.show_message("")

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._title.setText(self.tr("Drag teaching"))
        self._state_label.setText(self.tr("Teaching state"))
        self._note.setText(
            self.tr("The teaching button on the arm works beside this panel, which follows it.")
        )
        self._plan_label.setText(self.tr("Planned trajectory"))
        self._plan_note.setText(
            self.tr("Works on motions under way. The arm does not report it: watch the arm.")
        )
        self._teaching_exit_steps.retranslate_ui()
        self._show_all()


def _grid(rows: Sequence[Sequence[_Key]], buttons: Mapping[_Key, QAbstractButton]) -> QGridLayout:
    """Return two or three buttons a row, each row as wide as the others."""
    grid = empty_grid(gaps=(8, 8))
    for number, row in enumerate(rows):
        for column, command in enumerate(row):
            span = _COLUMNS // len(row)
            grid.addWidget(buttons[command], number, column * span, 1, span)
    for column in range(_COLUMNS):
        grid.setColumnStretch(column, 1)
    return grid
