"""清除错误: a joint's error is cleared, and the arm's answer awaited (0x475 byte 5, 0x476)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Refusal
from armui.control.context import Context
from armui.control.situation import why_unreachable
from armui.protocol import commands
from armui.protocol.codes import SettingIndex

if TYPE_CHECKING:
    from armui.protocol.codec import Message

_ANSWER_S: Final = 1.0


class JointErrors:
    """Clears errors one joint after the other: the arm's answer does not say which one it is about.

    It moves nothing, so it may be done whenever the arm is online, stopped or not. The answer says
    that the arm has heard; whether the fault has gone is what the drivers' feedback says.

    Args:
        context: What the parts of the controller share.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._joint: int | None = None
        self._deadline_s = 0.0
        context.connection.answered.connect(self._on_answer)

    def clear(self, joint: int) -> Refusal | None:
        """Ask a joint (1–6) to clear its error: ``None`` if it is on its way, or why it is not."""
        refusal = why_unreachable(self._context.connection.link)
        if refusal is None and self._joint is not None:
            refusal = Refusal("busy", {"what": "clearing_error"})
        if refusal is None:
            frames = commands.clear_joint_error(self._context.connection.codec, joint)
            if not self._context.connection.send(frames):
                refusal = Refusal("link_lost")
        if refusal is not None:
            return self._context.refuse(refusal)
        self._joint = joint
        self._deadline_s = self._context.clock() + _ANSWER_S
        self._context.tell("clear_error_sent", joint=joint)
        return None

    def advance(self) -> None:
        """Say so if an answer is overdue; called regularly while a device is open."""
        if self._joint is not None and self._context.clock() >= self._deadline_s:
            self._finish("clear_error_unanswered")

    def halt(self) -> None:
        """Clearing an error moves nothing: a stop leaves it be."""

    def forget(self) -> None:
        """The device was disconnected on purpose: no answer will come."""
        self._joint = None

    def _on_answer(self, answer: Message) -> None:
        if self._joint is None or answer.name != "SettingResponse":
            return
        if answer.signals["Index"] == SettingIndex.JOINT_SETTING:
            self._finish("clear_error_answered")

    def _finish(self, code: str) -> None:
        joint, self._joint = self._joint, None
        self._context.tell(code, joint=joint)
