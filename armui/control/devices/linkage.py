"""联动控制: the arm's role beside another arm, and its identifier offsets (0x470)."""

from __future__ import annotations

from functools import partial
from typing import Final

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.control.context import Context, ControllerPart
from armui.control.events import EventCode
from armui.control.operating_state import LinkState, why_only_heard, why_unreachable
from armui.control.requests.transactions import Transaction, TransactionQueue
from armui.protocol import commands
from armui.protocol.addressing import OFFSETS, Addressing
from armui.protocol.codes import LinkageRole, SettingIndex

_NO_OFFSET: Final = Addressing()


class LinkageControl(ControllerPart):
    """Sets role and offsets, and tells when the arm is heard under them.

    0x470 has no identifier of its own arm: every arm on the bus obeys it. It is answered by 0x476,
    which does not shift; it cannot be read back. So what counts is where the feedback comes from.

    Args:
        context: What the parts of the controller share.
        transactions: Carries out commands that are answered.
    """

    def __init__(self, context: Context, transactions: TransactionQueue) -> None:
        self._context = context
        self._transactions = transactions
        self._busy = False
        self._used = _NO_OFFSET
        self._was_known = True

    def set(
        self,
        role: LinkageRole,
        *,
        feedback_offset: int = 0,
        control_offset: int = 0,
        target_offset: int = 0,
    ) -> Refusal | None:
        """Make the arm a teaching input or a motion output.

        An arm that is silent is asked too: a teaching input sends no feedback.

        Args:
            role: What it becomes.
            feedback_offset: Added to 0x2A1–0x2A8.
            control_offset: Added to 0x150–0x15F.
            target_offset: Added to the commands that a teaching input sends.

        Returns:
            ``None`` if it is on its way, or why nothing was sent.
        """
        context = self._context
        context.refresh()
        refusal = self.why_not()
        for name, offset in (
            ("feedback_offset", feedback_offset),
            ("control_offset", control_offset),
            ("target_offset", target_offset),
        ):
            if refusal is None and offset not in OFFSETS:
                refusal = Refusal(
                    RefusalCode.OFFSET_NOT_POSSIBLE, {"offset": name, "value": offset}
                )
        if refusal is not None:
            return context.refuse(refusal)
        self._busy = True
        frames = commands.set_linkage(
            context.connection.codec,
            role,
            feedback_offset=feedback_offset,
            control_offset=control_offset,
            target_offset=target_offset,
        )
        # from the first frame on the arm may have moved, answered or not
        context.connection.offsets.request(
            Addressing(feedback_offset, control_offset),
            context.clock(),
            ends_input=context.operating_state().teaching_input,
        )
        context.tell(EventCode.LINKAGE_SENT)
        self._transactions.submit(
            Transaction(
                frames,
                partial(self._on_finished, role),
                SettingIndex.LINKAGE_SETTING,
                recheck=self._why_in_use,
                alters="linkage",
            )
        )
        return None

    def release(self) -> Refusal | None:
        """The way back: a motion output arm without offsets (0xFC)."""
        return self.set(LinkageRole.MOTION_OUTPUT)

    def why_not(self) -> Refusal | None:
        """The reason against a setting now, or ``None``: it may be made."""
        context = self._context
        link = context.connection.link
        if (refusal := why_only_heard(context.operating_state().device)) is not None:
            return refusal
        if link is not LinkState.OFFLINE and (refusal := why_unreachable(link)) is not None:
            return refusal
        if self._busy:
            return Refusal(RefusalCode.BUSY, {"what": "linkage"})
        return self._why_in_use()

    def _why_in_use(self) -> Refusal | None:
        """What the arm does that a change of its identifiers would cut off."""
        operating_state = self._context.operating_state()
        if operating_state.occupied is not None:
            return operating_state.occupied
        return Refusal(RefusalCode.LINKAGE_WHILE_MOVING) if operating_state.moving else None

    def _on_finished(self, role: LinkageRole, refusal: Refusal | None) -> None:
        self._busy = False
        if refusal is not None:
            self._context.tell(EventCode.LINKAGE_FAILED, reason=refusal)
            return
        self._context.connection.offsets.answered(self._context.clock())
        if role is LinkageRole.TEACHING_INPUT:
            self._context.tell(EventCode.LINKAGE_ANSWERED_INPUT)
        else:
            self._context.tell(EventCode.LINKAGE_ANSWERED)

    # A part of the controller -----------------------------------------------------------------

    def advance(self) -> None:
        """Tell when the arm is heard under other identifiers."""
        offsets = self._context.connection.offsets
        if (offsets.addressing, offsets.control_known) == (self._used, self._was_known):
            return
        self._used, self._was_known = offsets.addressing, offsets.control_known
        feedback = f"0x{0x2A1 + self._used.feedback_offset:03X}"
        if not offsets.control_known:
            self._context.tell(EventCode.LINKAGE_FOUND, feedback=feedback)
            return
        command = f"0x{0x150 + self._used.control_offset:03X}"
        self._context.tell(EventCode.LINKAGE_IN_USE, feedback=feedback, control=command)

    def forget(self) -> None:
        """The next device begins without offsets."""
        self._used, self._was_known = _NO_OFFSET, True
