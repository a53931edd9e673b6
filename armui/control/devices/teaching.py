"""示教: commands drag teaching and follows it until the arm reports it (0x150)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.devices.teaching_phase import DRIVES, TeachingPhase, phase_of, why_not_teach
from armui.control.events import Notice
from armui.control.motion.motion_context import drop_waiting
from armui.control.operations.operation import operation
from armui.control.operations.started import Started
from armui.control.requests.pending import EndNotices, RequestingPart
from armui.control.requests.request import Request
from armui.protocol import commands
from armui.protocol.codes import TeachingState
from armui.telemetry.events import EventKind, Level

TEACHING_SENT = Notice("teaching_sent", "Sent: {command}", Level.INFO, EventKind.COMMAND)
TEACHING_DONE = Notice(
    "teaching_done", "The arm has confirmed: {command}", Level.DONE, EventKind.RESULT
)
TEACHING_UNANSWERED = Notice(
    "teaching_unanswered",
    "The arm did not follow within 1.5 s: {command}. Look at its status; if it has no "
    "recording, record first.",
    Level.FAULT,
    EventKind.RESULT,
)

_ANSWER_S: Final = 1.5
"""The arm must show within this time that it has obeyed a command which sets it going."""

_LEADS_TO: Final[Mapping[TeachingState, frozenset[TeachingPhase]]] = {
    TeachingState.START_RECORDING: frozenset({TeachingPhase.RECORDING}),
    TeachingState.STOP_RECORDING: frozenset({TeachingPhase.IDLE, TeachingPhase.OFF}),
    TeachingState.RUN_RECORDING: frozenset({TeachingPhase.REPLAYING}),
    TeachingState.PAUSE: frozenset({TeachingPhase.PAUSED}),
    TeachingState.CONTINUE: frozenset({TeachingPhase.REPLAYING}),
    TeachingState.ABORT: frozenset({TeachingPhase.IDLE, TeachingPhase.OFF}),
    TeachingState.MOVE_TO_START: frozenset({TeachingPhase.REPLAYING}),
}

_ENDS_SOMETHING: Final = frozenset(
    {TeachingState.STOP_RECORDING, TeachingState.PAUSE, TeachingState.ABORT}
)
"""The commands sent again while the arm does not show them. A command that sets the arm going is
sent once: it must not start late, when nobody expects it any more.
"""


class TeachingControl(RequestingPart[TeachingState]):
    """Commands drag teaching, one command at a time.

    Args:
        context: The context that the controller's parts share.
    """

    @property
    def pending(self) -> TeachingState | None:
        """The command that the feedback has not shown yet, or ``None``."""
        return self._pending.kind

    @operation(
        "teaching.command",
        "Command drag teaching",
        why_not_teach,
        moves=True,
        first=drop_waiting,
    )
    def command(self, started: Started, command: TeachingState) -> Refusal | None:
        """Give a command of 0x150 byte 2."""
        context = self._context
        passed = context.gate().ask_unknown() if command in DRIVES else None
        if isinstance(passed, Refusal):
            return passed
        self._drop_request()
        figures = {"command": int(command)}
        context.emit_event(TEACHING_SENT, started, **figures)
        frames = commands.teaching_command(context.connection.codec, command)
        request = (
            Request(context, frames, _shows(command), ends=True)
            if command in _ENDS_SOMETHING
            else Request(context, frames, _shows(command), _ANSWER_S, 1, passed)
        )
        if command in DRIVES:
            context.authority.replay_told(context.clock())
        notices = EndNotices(
            (TEACHING_DONE, figures), lambda _reason: (TEACHING_UNANSWERED, figures)
        )
        self._pending.begin(command, started, request, notices)
        context.refresh()
        return None

    def drop_replay(self) -> None:
        """Await no replay and repeat no pause, because the arm was told to end its replay."""
        if self.pending is TeachingState.PAUSE or self.pending in DRIVES:
            self._drop_request()


def _shows(command: TeachingState) -> Callable[[ArmState], bool]:
    def seen(state: ArmState) -> bool:
        return state.status is not None and phase_of(state.status.value) in _LEADS_TO[command]

    return seen
