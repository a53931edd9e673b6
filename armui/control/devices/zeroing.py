"""零点设置: makes a joint's present place its zero (0x475 byte 1, 0x476 byte 1).

The joint's limits are counted from its zero: with a wrong zero the arm runs into its stops. So it
is done only to an arm that stands still, and what the arm answers is checked against its angles.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Final

from armui.arm.figures import JointOrAll
from armui.arm.limits import JOINTS
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.control.devices import teaching_phase
from armui.control.events import Notice
from armui.control.operating_state import BUSY
from armui.control.operations.operation import Consent, operation
from armui.control.operations.started import Started
from armui.control.requests.pending import AnsweredPart, EndNotices
from armui.control.requests.transactions import ReadBack, Transaction, TransactionQueue
from armui.control.safety.interlocks import JOINTS_UNKNOWN, joint_list, why_no_command
from armui.control.safety.standstill import why_not_still
from armui.protocol import commands
from armui.protocol.codes import ALL_JOINTS, SettingIndex
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.control.context import Context
    from armui.control.operating_state import OperatingState
    from armui.protocol.codec import Message

ZERO_NOT_SET = Reason(
    "zero_not_set",
    "The arm answered that it did not set the zero of these joints: {joints}. Let the arm "
    "stand still, clear its errors, then try again.",
)
ZERO_MOVED = Reason(
    "zero_moved",
    "Joint {joints} does not stand where it stood at the press: no zero was sent. Try again "
    "where it shall be.",
)
ZERO_NOT_TAKEN = Reason(
    "zero_not_taken",
    "The arm answered that the zero is set, but these joints do not read 0°: {joints}. Do not "
    "move the arm before the zero is set anew.",
)
ZERO_SENT = Notice(
    "zero_sent", "Zero setting sent to all six joints", Level.INFO, EventKind.COMMAND
)
ZERO_SENT_JOINT = Notice(
    "zero_sent_joint", "Zero setting sent to joint {joint}", Level.INFO, EventKind.COMMAND
)
ZERO_SET = Notice(
    "zero_set",
    "The arm has set the zeros of all six joints; their angles now read 0.",
    Level.DONE,
    EventKind.RESULT,
)
ZERO_SET_JOINT = Notice(
    "zero_set_joint",
    "The arm has set the zero of joint {joint}; its angle now reads 0.",
    Level.DONE,
    EventKind.RESULT,
)
ZERO_FAILED = Notice("zero_failed", "Zero setting failed. {reason}", Level.FAULT, EventKind.RESULT)

ZEROING_ENDED: Final = frozenset({ZERO_SET, ZERO_SET_JOINT, ZERO_FAILED})
"""After these notices angles may count from another zero: earlier positions no longer hold."""

_AT_ZERO_DEG: Final = 0.5
"""A joint reported this near to 0 has taken up its new zero."""
_SAME_PLACE_DEG: Final = 0.5
"""A joint that has moved less than this since the press still stands where it was put."""
_LONGEST_S: Final = 0.3
"""The angles must show the new zero within this time; just after the answer they may be old."""


def why_not_zero(now: OperatingState) -> Refusal | None:
    """Return why no zero may be set, as far as it lies in what is under way, or ``None``.

    Whatever was planned, recorded or paused with the old zero would continue with the new one.
    """
    refusal = now.cannot_enable or now.occupied
    if refusal is None and now.recording:
        refusal = BUSY(what="recording")
    if refusal is not None or now.status is None:
        return refusal
    return teaching_phase.why_under_way(teaching_phase.phase_of(now.status))


class Zeroing(AnsweredPart):
    """Sets zeros, one transaction at a time.

    Args:
        context: The context that the controller's parts share.
        transactions: Carries out commands that are answered.
        before_zeroing: Called just before the zero changes: setpoints become void.
    """

    def __init__(
        self, context: Context, transactions: TransactionQueue, before_zeroing: Callable[[], None]
    ) -> None:
        super().__init__(context, transactions)
        self._before_zeroing = before_zeroing

    def stands_as(self, before: ArmState, joint: int = ALL_JOINTS) -> bool:
        """Return whether a joint (1–6, 7 all) still stands where it stood at the question."""
        joints = JOINTS if joint == ALL_JOINTS else (joint,)
        return _why_elsewhere(joints, before, self._context.connection.newest) is None

    @operation("joints.set_zero", "Set zeros", why_not_zero, consent=Consent.PRESS)
    def set_zero(self, started: Started, joint: JointOrAll = ALL_JOINTS) -> Refusal | None:
        """Make the present position of a joint, or of each, its zero."""
        context = self._context
        state = context.state()
        joints = JOINTS if joint == ALL_JOINTS else (joint,)
        refusal = why_not_still(state) or context.why_moving() or self._why_unheard(joints)
        if refusal is not None:
            return refusal
        self._before_zeroing()
        every = joint == ALL_JOINTS
        self._pending.begin(
            started,
            Transaction(
                commands.set_joint_zero(context.connection.codec, joint),
                index=SettingIndex.JOINT_SETTING,
                against=partial(_against_answer, joint_list(list(joints))),
                read_back=ReadBack(
                    (),
                    partial(_shown, joints),
                    partial(_not_at_zero, joints),
                    proves=bool(_off_zero(joints, state)),
                ),
                recheck=partial(self._why_not_any_more, joints, state),
                # Never repeated (S14): a second command would set the zero wherever the joint
                # stands by then.
                attempts=1,
                ends_with_stop=True,
                alters="zeroing",
            ),
            (ZERO_SENT if every else ZERO_SENT_JOINT, {"joint": joint}),
            EndNotices(
                (ZERO_SET, {}) if every else (ZERO_SET_JOINT, {"joint": joint}),
                lambda refusal: (ZERO_FAILED, {"reason": refusal}),
            ),
        )
        context.refresh()
        return None

    def _why_unheard(self, joints: Sequence[int]) -> Refusal | None:
        """Return a reason if the angles are not heard: the new zero could not be verified then."""
        state, now_s = self._context.state(), self._context.clock()
        heard = [state.joints_deg[joint - 1] for joint in joints]
        known = all(each is not None and each.fresh(now_s) for each in heard)
        return None if known else JOINTS_UNKNOWN()

    def _why_not_any_more(self, joints: Sequence[int], pressed: ArmState) -> Refusal | None:
        """Return what has come up since the press: a stop, a motion, or a joint that has moved."""
        operating_state, state = self._context.operating_state(), self._context.state()
        refusal = why_no_command(operating_state.unreachable, operating_state.stop, None)
        refusal = refusal or operating_state.occupied or why_not_still(state)
        refusal = refusal or self._context.why_moving()
        return refusal or self._why_unheard(joints) or _why_elsewhere(joints, pressed, state)


def _against_answer(joints: str, answer: Message) -> Refusal | None:
    if answer.signals["ZeroSet"] == 1:
        return None
    return ZERO_NOT_SET(joints=joints)


def _why_elsewhere(joints: Sequence[int], before: ArmState, now: ArmState) -> Refusal | None:
    """Return the joints that do not stand where they stood, as a reason."""
    moved = [
        joint
        for joint in joints
        if (old := before.joints_deg[joint - 1]) is None
        or (new := now.joints_deg[joint - 1]) is None
        or abs(new.value - old.value) > _SAME_PLACE_DEG
    ]
    return ZERO_MOVED(joints=joint_list(moved)) if moved else None


def _off_zero(joints: Sequence[int], state: ArmState) -> list[int]:
    angles = {joint: state.joints_deg[joint - 1] for joint in joints}
    return [
        joint for joint, heard in angles.items() if heard is None or abs(heard.value) > _AT_ZERO_DEG
    ]


def _shown(joints: Sequence[int], state: ArmState, since_s: float) -> bool:
    """Return whether the angles can be judged: they are at the new zero, or have had time to be."""
    heard = [state.joints_deg[joint - 1] for joint in joints]
    times = [each.at_s for each in heard if each is not None and each.at_s > since_s]
    if len(times) < len(joints):
        return False
    return not _off_zero(joints, state) or min(times) - since_s > _LONGEST_S


def _not_at_zero(joints: Sequence[int], state: ArmState) -> Refusal | None:
    off = _off_zero(joints, state)
    return ZERO_NOT_TAKEN(joints=joint_list(off)) if off else None
