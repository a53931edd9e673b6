"""末端负载: tells the arm its load, and switches the feedback of its end's motion (0x477)."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.control.context import why_not_asked
from armui.control.events import Notice
from armui.control.operating_state import OperatingState
from armui.control.operations.operation import operation
from armui.control.operations.started import Ending, Started
from armui.control.requests.pending import AnsweredPart, EndNotices
from armui.control.requests.transactions import ReadBack, Transaction
from armui.protocol import commands
from armui.protocol.codes import EndLoad, SettingIndex
from armui.telemetry.events import EventKind, Level

LOAD_WHILE_MOVING = Reason(
    "load_while_moving", "The arm is moving. Wait until it stands still, then set the end load."
)
END_FEEDBACK_GOES_ON = Reason(
    "end_feedback_goes_on", "The arm has answered, but goes on reporting. Try again."
)
LOAD_SENT = Notice("load_sent", "End load sent: {load}", Level.INFO, EventKind.COMMAND)
LOAD_ANSWERED = Notice(
    "load_answered",
    "The arm has answered the end load: {load}. It cannot be asked for it.",
    Level.DONE,
    EventKind.RESULT,
)
LOAD_FAILED = Notice(
    "load_failed", "End load not confirmed. {reason}", Level.FAULT, EventKind.RESULT
)
END_FEEDBACK_SENT = Notice(
    "end_feedback_sent", "Switching the feedback of the end's motion", Level.INFO, EventKind.COMMAND
)
END_FEEDBACK_ON = Notice(
    "end_feedback_on", "The arm reports the motion of its end.", Level.DONE, EventKind.RESULT
)
END_FEEDBACK_OFF = Notice(
    "end_feedback_off",
    "The arm no longer reports the motion of its end.",
    Level.DONE,
    EventKind.RESULT,
)
END_FEEDBACK_FAILED = Notice(
    "end_feedback_failed",
    "The feedback of the end's motion is not switched. {reason}",
    Level.FAULT,
    EventKind.RESULT,
)


_SILENT_S: Final = 0.3
"""The frames 0x481–0x486 have ended when none has come for this time."""


def why_not_switch(now: OperatingState) -> Refusal | None:
    """Return why the feedback of the end's motion may not be switched, or ``None``."""
    return why_not_asked(now) or now.why_pending("end_reports")


def why_no_load(now: OperatingState) -> Refusal | None:
    """Return why the arm may not be told a load, or ``None``."""
    return why_not_switch(now) or _why_in_use(now)


def _why_in_use(now: OperatingState) -> Refusal | None:
    return now.occupied or (LOAD_WHILE_MOVING() if now.moving else None)


class EndReports(AnsweredPart):
    """Tells the arm its load, and switches 0x481–0x486 until the frames themselves show it.

    Args:
        context: The context that the controller's parts share.
        transactions: Carries out commands that are answered.
    """

    @operation("end_load.set", "Set the end load", why_no_load)
    def set_load(self, started: Started, load: EndLoad) -> None:
        """Tell the arm that it carries nothing, half or the full payload.

        The arm answers, but the load cannot be read back: the answer is the only confirmation.
        """
        context, figures = self._context, {"load": int(load)}
        self._pending.begin(
            started,
            Transaction(
                commands.set_load(context.connection.codec, load),
                index=SettingIndex.PARAMETER_COMMAND,
                recheck=lambda: _why_in_use(context.operating_state()),
                ends_with_stop=True,
                alters="end_reports",
            ),
            (LOAD_SENT, figures),
            EndNotices(
                (LOAD_ANSWERED, figures),
                lambda refusal: (LOAD_FAILED, {"reason": refusal}),
                Ending.ANSWERED,
            ),
        )

    @operation("end_load.report", "Switch the end's motion feedback", why_not_switch)
    def switch(self, started: Started, *, on: bool) -> None:
        """Switch the feedback of the end's speed and acceleration; its frames confirm it."""
        self._pending.begin(
            started,
            Transaction(
                commands.set_end_feedback(self._context.connection.codec, on=on),
                index=SettingIndex.PARAMETER_COMMAND,
                read_back=ReadBack(
                    (), _all_came if on else _time_passed, lambda s: _against(s, on=on)
                ),
            ),
            (END_FEEDBACK_SENT, {}),
            EndNotices(
                (END_FEEDBACK_ON if on else END_FEEDBACK_OFF, {}),
                lambda refusal: (END_FEEDBACK_FAILED, {"reason": refusal}),
            ),
        )


def is_reporting(state: ArmState) -> bool:
    """Return whether all six of 0x481–0x486 arrive, measured against the arm's other feedback."""
    now_s = state.last_feedback_s
    return now_s is not None and all(
        heard is not None and now_s - heard.at_s < _SILENT_S for heard in state.end_motion
    )


def _all_came(state: ArmState, since_s: float) -> bool:
    return all(heard is not None and heard.at_s > since_s for heard in state.end_motion)


def _time_passed(state: ArmState, since_s: float) -> bool:
    return state.last_feedback_s is not None and state.last_feedback_s - since_s > _SILENT_S


def _against(state: ArmState, *, on: bool) -> Refusal | None:
    now_s = state.last_feedback_s or 0.0
    still = any(
        heard is not None and now_s - heard.at_s < _SILENT_S / 2 for heard in state.end_motion
    )
    return END_FEEDBACK_GOES_ON() if still and not on else None
