"""Leaves MIT, CPV or high-follow without a reset, if the firmware can do that."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.arm.quirks import exits_by_mode_word, leaves_by_mode_word
from armui.arm.refusal import Reason, Refusal
from armui.control.context import ControllerPart
from armui.control.events import Notice
from armui.control.link.link_state import LINK_LOST
from armui.control.motion.motion_command import CommandKind
from armui.control.operations.started import ARM_CHANGED, Started
from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN, JOINTS_UNKNOWN, SPEED_ZERO
from armui.control.safety.other_command import OTHER_HOST_STREAMS
from armui.protocol import commands
from armui.protocol.codes import ControlMode, MoveMode
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.control.link.arm_mark import ArmMark
    from armui.control.motion.motion_context import MotionContext

VERSION_UNANSWERED = Reason(
    "version_unanswered",
    "Nothing was sent: the arm was asked for its firmware version and has not named it within "
    "0.9 s. With an older one it would fall. Try again; if it stays so, hold the arm and use "
    "the emergency stop.",
)
VERSION_NOT_FIT = Reason(
    "version_not_fit",
    "Nothing was sent: asked for its firmware version, the arm named {versions}. With it, or "
    "with two arms on the bus, an arm would fall. Hold the arm and use the emergency stop.",
)
MODE_LEFT = Notice(
    "mode_left",
    "Told the arm to leave the other program's mode and to hold where it stands.",
    Level.DONE,
    EventKind.COMMAND,
)


_WITHIN_S: Final = 0.9
"""An action's first frame is sent within this time of its press, or not at all."""
_ASK_EVERY_S: Final = 0.4
"""The interval of the questions: one during an answer would shift its text."""
_KEEP_S: Final = 0.1
"""Frames that a full bus holds up for longer are dropped: the answer is too old then."""
_OTHERS_WITHIN_S: Final = 0.1
"""Within this time a second arm on the bus has answered the same question, too."""


@dataclass(slots=True)
class _Question:
    """The question for the version, before the arm is taken out of its mode.

    Attributes:
        mark: The arm and connection that the operator has meant.
        pauses: The number of pauses in its feedback at the press.
        pressed_s: The time of the operator's press.
        next_s: When the question is sent again.
    """

    mark: ArmMark
    pauses: int
    pressed_s: float
    next_s: float


class ModeExitCommand(ControllerPart):
    """Takes the arm out of another host's mode: a mode word, and targets at its present place.

    The mode word voids the joints' setpoints, so the targets follow it at once: until they have
    arrived the joints may give way. Older firmware lets the arm fall instead. So the version that
    was named when the arm came is not enough: it is asked for at the press, and only an answer that
    began after the press counts. Without one nothing is sent.

    Args:
        context: The context that the controller's parts share.
        speed_percent: Returns the speed shown in the window; the mode word carries it.
    """

    def __init__(self, context: MotionContext, speed_percent: Callable[[], int]) -> None:
        self._context = context
        self._speed_percent = speed_percent
        self._question: _Question | None = None

    @property
    def asking(self) -> bool:
        """True while the arm's answer is awaited."""
        return self._question is not None

    def send(self) -> Refusal | None:
        """Begin now; return ``None``, or why it cannot. A notice tells the outcome."""
        context = self._context
        context.refresh()
        refusal = self.why_not()
        if refusal is not None:
            return context.refuse(refusal)
        connection, now_s = context.connection, context.clock()
        self._question = _Question(connection.mark, connection.newest.pauses, now_s, now_s)
        self.follow_arm()
        return None

    def follow_arm(self) -> None:
        """Ask for the version, and act on the answer."""
        question, context = self._question, self._context
        if question is None:
            return
        now_s, state = context.clock(), context.connection.newest
        # Frames of two arms' answers may be mixed into one version; a date that is known must fit,
        # too.
        known = question.mark.identity
        named = [
            each
            for each in state.versions_named
            if each.began_s > question.pressed_s
            and (known is None or not known.date or known.date == each.date)
        ]
        late = now_s - question.pressed_s > _WITHIN_S
        if not question.mark.is_still(context.connection.mark) or state.pauses != question.pauses:
            self._give_up(ARM_CHANGED())
        elif named and not late:
            if now_s - named[0].began_s >= _OTHERS_WITHIN_S:
                self._act_on({each.software for each in named})
        elif late:
            self._give_up(VERSION_UNANSWERED())
        elif now_s >= question.next_s:
            question.next_s = now_s + _ASK_EVERY_S
            if not context.connection.send(commands.query_firmware(context.connection.codec)):
                self._give_up(LINK_LOST())

    def halt(self) -> None:
        """Leave the arm as it is: a stop was asked for."""
        self._question = None

    def forget_arm(self) -> None:
        """Drop the pending answer, because the arm is gone."""
        self._question = None

    def _give_up(self, reason: Refusal) -> None:
        self._question = None
        self._context.refuse(reason)

    def _act_on(self, versions: set[str]) -> None:
        """Act, if the versions named since the press are one, and that one is known to be safe."""
        context = self._context
        if len(versions) != 1 or not all(map(leaves_by_mode_word, versions)):
            named = ", ".join(sorted(versions))
            self._give_up(VERSION_NOT_FIT(versions=named))
            return
        context.refresh()
        self._question = None
        refusal = self.why_not() or self._leave()
        if refusal is not None:
            context.refuse(refusal)

    def _leave(self) -> Refusal | None:
        context = self._context
        angles_deg = context.authority.measured_deg()
        if angles_deg is None:
            return JOINTS_UNKNOWN()
        percent, codec = self._speed_percent(), context.connection.codec
        frames = commands.set_mode(
            codec,
            control_mode=ControlMode.CAN_CONTROL,
            move_mode=MoveMode.MOVE_J,
            speed_percent=percent,
        )
        context.authority.other.leave_mode(context.clock())
        sent = context.send_motion(
            CommandKind.JOINTS,
            [*frames, *commands.joint_target(codec, angles_deg)],
            passed=context.gate().ask_no_way(),  # its targets are the present angles
            started=Started("recovery.leave_mode"),
            move_mode=MoveMode.MOVE_J,
            speed_percent=percent,
            joints_deg=angles_deg,
            keep_s=_KEEP_S,
        )
        if isinstance(sent, Refusal):
            return sent
        context.emit_event(MODE_LEFT)
        return None

    def why_not(self) -> Refusal | None:
        """Return why it is refused now, or ``None``; against a stream only the stop helps."""
        authority = self._context.authority
        if (silent := authority.why_silent()) is not None:
            return silent
        other = authority.other
        if other.commands and not other.may_be_taken_over:
            return OTHER_HOST_STREAMS(frames=other.frames)
        if not exits_by_mode_word(self._context.connection.newest):
            return other.why_not()
        if not self._context.operating_state().control_certain:
            return CONTROL_OFFSET_UNKNOWN()
        return SPEED_ZERO() if self._speed_percent() <= 0 else None
