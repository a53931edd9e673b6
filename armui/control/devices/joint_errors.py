"""清除错误: clears the errors of the joints' drivers and awaits the arm's answer (0x475)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.arm.figures import JointOrAll
from armui.arm.refusal import Refusal
from armui.control.events import Notice
from armui.control.operating_state import BUSY, OperatingState
from armui.control.operations.operation import operation
from armui.control.operations.started import SETTING_UNANSWERED, Ending, Started
from armui.control.requests.pending import AnsweredPart, EndNotices
from armui.control.requests.transactions import Transaction
from armui.protocol import commands
from armui.protocol.codes import SettingIndex
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from armui.control.requests.reports import Report

CLEAR_ERROR_SENT = Notice(
    "clear_error_sent", "Clear error sent to joint {joint}", Level.INFO, EventKind.COMMAND
)
CLEAR_ERROR_ANSWERED = Notice(
    "clear_error_answered",
    "Joint {joint}: the arm has confirmed the command to clear the error. Where a fault is "
    "still shown, remove its cause, then clear it again.",
    Level.DONE,
    EventKind.RESULT,
)
CLEAR_ERROR_UNANSWERED = Notice(
    "clear_error_unanswered",
    "Joint {joint}: the arm did not confirm within a second the command to clear the error. "
    "Try again; if it stays silent, check the CAN cable.",
    Level.FAULT,
    EventKind.RESULT,
)


def why_not_clear(now: OperatingState) -> Refusal | None:
    """Return why the drivers' errors may not be cleared, or ``None``; one may follow another."""
    return now.unreachable or now.occupied


class JointErrors(AnsweredPart):
    """Clears errors one at a time, because the arm's answer does not name the joint.

    It moves nothing, so it may be done whenever the arm is online, stopped or not; only a run that
    is under way is not given back drivers that it was not started with. The answer says that the
    arm has heard; whether the fault has gone is what the drivers' feedback says.

    Args:
        context: The context that the controller's parts share.
        transactions: Carries out commands that are answered.
    """

    @operation("joints.clear_error", "Clear errors of the drivers", why_not_clear)
    def clear(self, started: Started, joint: JointOrAll) -> Refusal | None:
        """Ask a joint, or all, to clear its error."""
        if self.busy:
            return BUSY(what="clearing_error")
        context, figures = self._context, {"joint": joint}

        def failed(refusal: Refusal | None) -> Report | None:
            unanswered = refusal is not None and refusal.reason == SETTING_UNANSWERED
            return (CLEAR_ERROR_UNANSWERED, figures) if unanswered else None

        self._pending.begin(
            started,
            Transaction(
                commands.clear_joint_error(context.connection.codec, joint),
                index=SettingIndex.JOINT_SETTING,
                recheck=lambda: why_not_clear(context.operating_state()),
                alters="clearing_error",
            ),
            (CLEAR_ERROR_SENT, figures),
            EndNotices((CLEAR_ERROR_ANSWERED, figures), failed, Ending.ANSWERED),
        )
        return None
