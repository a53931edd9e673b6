"""末端负载: what the arm is told it carries, and the feedback of its end's motion (0x477)."""

from __future__ import annotations

from functools import partial
from typing import Final

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.arm.state import ArmState
from armui.control.context import Context
from armui.control.events import EventCode
from armui.control.requests.transactions import ReadBack, Transaction, TransactionQueue
from armui.protocol import commands
from armui.protocol.codes import EndLoad, SettingIndex

_SILENT_S: Final = 0.3
"""After so long without one, the frames 0x481–0x486 have ended."""


class EndReports:
    """Tells the arm its load, and switches 0x481–0x486 until the frames themselves show it.

    Args:
        context: What the parts of the controller share.
        transactions: Carries out commands that are answered.
    """

    def __init__(self, context: Context, transactions: TransactionQueue) -> None:
        self._context = context
        self._transactions = transactions
        self._busy = False

    def set_load(self, load: EndLoad) -> Refusal | None:
        """Tell the arm that it carries nothing, half or the full payload.

        The arm answers and cannot be asked for it: the answer is all there is to know.
        """
        context = self._context
        context.refresh()
        refusal = self._why_not() or self.why_no_load()
        if refusal is not None:
            return context.refuse(refusal)
        self._busy = True
        context.tell(EventCode.LOAD_SENT, load=int(load))
        self._transactions.submit(
            Transaction(
                commands.set_load(context.connection.codec, load),
                partial(self._after_load, load),
                SettingIndex.PARAMETER_COMMAND,
                recheck=self.why_no_load,
                ends_with_stop=True,
                alters="end_reports",
            )
        )
        return None

    def why_no_load(self) -> Refusal | None:
        """The reason that lies in what the arm is doing against telling it a load."""
        operating_state = self._context.operating_state()
        if operating_state.occupied is not None:
            return operating_state.occupied
        return Refusal(RefusalCode.LOAD_WHILE_MOVING) if operating_state.moving else None

    def switch(self, *, on: bool) -> Refusal | None:
        """Switch the feedback of the end's speed and acceleration; the frames decide."""
        context = self._context
        refusal = self._why_not()
        if refusal is not None:
            return context.refuse(refusal)
        self._busy = True
        context.tell(EventCode.END_FEEDBACK_SENT)
        self._transactions.submit(
            Transaction(
                commands.set_end_feedback(context.connection.codec, on=on),
                partial(self._after_switch, on),
                SettingIndex.PARAMETER_COMMAND,
                read_back=ReadBack(
                    (), _all_came if on else _time_passed, lambda s: _against(s, on=on)
                ),
            )
        )
        return None

    def _why_not(self) -> Refusal | None:
        busy = Refusal(RefusalCode.BUSY, {"what": "end_reports"}) if self._busy else None
        return self._context.why_unknown() or busy

    def _after_load(self, load: EndLoad, refusal: Refusal | None) -> None:
        self._busy = False
        if refusal is None:
            self._context.tell(EventCode.LOAD_ANSWERED, load=int(load))
        else:
            self._context.tell(EventCode.LOAD_FAILED, reason=refusal)

    def _after_switch(self, on: bool, refusal: Refusal | None) -> None:
        self._busy = False
        if refusal is not None:
            self._context.tell(EventCode.END_FEEDBACK_FAILED, reason=refusal)
        else:
            self._context.tell(EventCode.END_FEEDBACK_ON if on else EventCode.END_FEEDBACK_OFF)


def is_reporting(state: ArmState) -> bool:
    """Whether all six of 0x481–0x486 arrive, measured against the arm's other feedback."""
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
    return Refusal(RefusalCode.END_FEEDBACK_GOES_ON) if still and not on else None
