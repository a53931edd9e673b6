"""联动控制: sets the arm's role beside another arm, and its identifier offsets (0x470)."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Final

from armui.arm.figures import OneOf
from armui.arm.refusal import Reason, Refusal
from armui.control.context import Context, ControllerPart
from armui.control.events import Notice
from armui.control.link.link_state import LinkState, why_only_heard, why_unreachable
from armui.control.operating_state import OperatingState
from armui.control.operations.operation import Consent, operation
from armui.control.operations.started import Ending, Started
from armui.control.requests.pending import AnsweredPart, EndNotices
from armui.control.requests.transactions import Transaction, TransactionQueue
from armui.protocol import commands
from armui.protocol.addressing import OFFSETS, Addressing
from armui.protocol.codes import LinkageRole, SettingIndex
from armui.telemetry.events import EventKind, Level

LINKAGE_WHILE_MOVING = Reason(
    "linkage_while_moving", "The arm is moving. Wait until it stands still, then set the linkage."
)
OFFSET_NOT_POSSIBLE = Reason(
    "offset_not_possible", "An offset of {value} is not possible. Choose 0x00, 0x10 or 0x20."
)
LINKAGE_SENT = Notice("linkage_sent", "Linkage setting sent", Level.INFO, EventKind.COMMAND)
LINKAGE_ANSWERED = Notice(
    "linkage_answered",
    "The arm has acknowledged the linkage setting. It takes effect in standby, or after a "
    "power cycle.",
    Level.INFO,
    EventKind.RESULT,
)
LINKAGE_FAILED = Notice(
    "linkage_failed", "Linkage setting not confirmed. {reason}", Level.FAULT, EventKind.RESULT
)
LINKAGE_IN_USE = Notice(
    "linkage_in_use",
    "Identifiers in use: feedback from {feedback}, commands from {control}.",
    Level.DONE,
    EventKind.LINK,
)
LINKAGE_FOUND = Notice(
    "linkage_found",
    "An arm is heard with its feedback from {feedback}. On which identifiers it takes "
    "commands is not known: set them under Linkage control.",
    Level.WARNING,
    EventKind.LINK,
)


Offset = Annotated[int, OneOf(OFFSETS, OFFSET_NOT_POSSIBLE)]
"""An offset of identifiers."""

_NO_OFFSET: Final = Addressing()


def why_not_link(now: OperatingState) -> Refusal | None:
    """Return why role and offsets may not be set; an arm that is silent may be told."""
    if (refusal := why_only_heard(now.device)) is not None:
        return refusal
    if now.link is not LinkState.OFFLINE and (refusal := why_unreachable(now.link)) is not None:
        return refusal
    return now.why_pending("linkage") or _why_in_use(now)


def _why_in_use(now: OperatingState) -> Refusal | None:
    """Return the activity that a change of the arm's identifiers would cut off, as a reason."""
    return now.occupied or (LINKAGE_WHILE_MOVING() if now.moving else None)


class LinkageControl(AnsweredPart, ControllerPart):
    """Sets role and offsets, and tells the operator when the arm is heard under them.

    0x470 has no identifier of its own arm: every arm on the bus obeys it. It is answered by 0x476,
    which does not shift; it cannot be read back. So only the identifiers of the feedback confirm
    it.

    Args:
        context: The context that the controller's parts share.
        transactions: Carries out commands that are answered.
    """

    def __init__(self, context: Context, transactions: TransactionQueue) -> None:
        super().__init__(context, transactions)
        self._used = _NO_OFFSET
        self._was_known = True

    @operation(
        "linkage.set", "Set linkage role and ID offsets", why_not_link, consent=Consent.PRESS
    )
    def set(
        self,
        started: Started,
        role: LinkageRole,
        *,
        feedback_offset: Offset = 0,
        control_offset: Offset = 0,
        target_offset: Offset = 0,
    ) -> None:
        """Make the arm a teaching input or a motion output.

        An arm that is silent is asked too: a teaching input sends no feedback.

        Args:
            started: The record of the command.
            role: The new role.
            feedback_offset: The offset of the feedback, 0x2A1–0x2A8.
            control_offset: The offset of the commands, 0x150–0x15F.
            target_offset: The offset of the commands that a teaching input sends.
        """
        context = self._context
        frames = commands.set_linkage(
            context.connection.codec,
            role,
            feedback_offset=feedback_offset,
            control_offset=control_offset,
            target_offset=target_offset,
        )
        # From the first frame on the arm may use the new identifiers, whether it answers or not.
        context.connection.offsets.request(
            Addressing(feedback_offset, control_offset),
            context.clock(),
            ends_input=context.operating_state().teaching_input,
        )
        self._pending.begin(
            started,
            Transaction(
                frames,
                index=SettingIndex.LINKAGE_SETTING,
                recheck=lambda: _why_in_use(context.operating_state()),
                alters="linkage",
            ),
            (LINKAGE_SENT, {}),
            EndNotices(
                (LINKAGE_ANSWERED, {}),
                lambda refusal: (LINKAGE_FAILED, {"reason": refusal}),
                Ending.ANSWERED,
                partial(self._note_answer, role),
            ),
        )
        context.refresh()

    def release(self) -> Started | Refusal:
        """Make the arm a motion output arm without offsets again (0xFC)."""
        return self.set(LinkageRole.MOTION_OUTPUT)

    def _note_answer(self, role: LinkageRole) -> bool:
        """Note the answer; return whether the offsets asked for are in use already."""
        offsets = self._context.connection.offsets
        offsets.answered(self._context.clock())
        offsets.keeps_input = role is LinkageRole.TEACHING_INPUT
        return offsets.requested is None

    # A part of the controller -----------------------------------------------------------------

    def follow_arm(self) -> None:
        """Tell the operator when the arm is heard under other identifiers."""
        offsets = self._context.connection.offsets
        if self._context.operating_state().teaching_input:
            offsets.keeps_input = False  # in force: now the feedback shows the role
        if (offsets.addressing, offsets.control_known) == (self._used, self._was_known):
            return
        self._used, self._was_known = offsets.addressing, offsets.control_known
        feedback = f"0x{0x2A1 + self._used.feedback_offset:03X}"
        if not offsets.control_known:
            self._context.emit_event(LINKAGE_FOUND, feedback=feedback)
            return
        command = f"0x{0x150 + self._used.control_offset:03X}"
        self._context.close(
            self._pending.started, Ending.DONE, LINKAGE_IN_USE, feedback=feedback, control=command
        )

    def forget_arm(self) -> None:
        """Forget the offsets: the next device begins without any."""
        self._pending.cut_off()
        self._used, self._was_known = _NO_OFFSET, True
