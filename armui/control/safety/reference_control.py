"""Keeps which joints' reference is in doubt, and carries out the reference check (S34)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import datetime
from typing import Final, Protocol

from armui.arm.figures import JointNumber
from armui.arm.inspection_record import KEPT, InspectionEntry, ResumeEntry
from armui.arm.limits import JOINTS
from armui.arm.reference_record import ReferenceRecord
from armui.arm.refusal import Reason, Refusal
from armui.control.context import ControllerPart
from armui.control.devices.teaching_phase import TeachingPhase, phase_of
from armui.control.events import Notice
from armui.control.link.arm_key import arm_key
from armui.control.link.link_state import LinkState
from armui.control.motion.motion_context import MotionContext
from armui.control.motion.requests import joint_request
from armui.control.operating_state import OperatingState, StopState
from armui.control.operations.operation import Consent, operation
from armui.control.operations.started import Ending, Started
from armui.control.safety.feedback_freshness import any_motor_off, in_drag_teaching
from armui.control.safety.interlocks import JOINTS_UNKNOWN, MOVABLE_MODES, SPEED_ZERO, joint_list
from armui.control.safety.reference_check import ReferenceCheck
from armui.control.safety.reference_status import REFERENCE_CHECK_OPEN, ReferenceStatus
from armui.control.safety.reference_watch import AngleListener, ReferenceWatch, WatchedArm
from armui.telemetry.events import Asker, EventKind, Level

NO_DOUBT = Reason("no_doubt", "No joint's reference is in doubt.")
CHECK_NOT_OPEN = Reason("check_not_open", "The reference check is not open.")
LOOK_FIRST = Reason(
    "look_first",
    "Look at the whole arm first and say which joints stand elsewhere than the picture shows.",
)
BROUGHT_BY_HAND = Reason(
    "brought_by_hand",
    "Joint {joint} is in doubt: it may stand 85° from what it reports, so nothing drives it. Bring "
    "it to its mark by hand, with the motors off and the arm held.",
)
NO_MARK = Reason(
    "no_mark",
    "Joint {joint} has no mark, and no reference pose is taught: compare it with the picture.",
)
JOINTS_UNANSWERED = Reason(
    "joints_unanswered", "These joints are still to be answered for: {joints}."
)

REFERENCE_LEFT = Notice(
    "reference_left",
    "Joint {joint} left its place of {place}° uncommanded, enabled, and was reported at {value}°: "
    "its reference is in doubt. It may stand elsewhere than it reports from now on.",
    Level.FAULT,
    EventKind.STATUS,
    Asker.PROGRAM,
)
REFERENCE_STILL_IN_DOUBT = Notice(
    "reference_still_in_doubt",
    "Of an earlier day: the reference of joint {joints} is in doubt, and was not checked since.",
    Level.WARNING,
    EventKind.STATUS,
    Asker.PROGRAM,
)
REFERENCE_ALLOWED = Notice(
    "reference_allowed",
    "Motions are agreed to for {seconds} s, with the reference of joint {joints} in doubt",
    Level.WARNING,
    EventKind.COMMAND,
)
REFERENCE_CHECK_BEGUN = Notice(
    "reference_check_begun", "Reference check begun", Level.INFO, EventKind.COMMAND
)
REFERENCE_CHECK_LEFT = Notice(
    "reference_check_left",
    "Reference check left without a result: it counts as not done.",
    Level.WARNING,
    EventKind.RESULT,
)
REFERENCE_DRIVEN = Notice(
    "reference_driven", "Sent J{joint} to its mark at {target}°", Level.INFO, EventKind.COMMAND
)
REFERENCE_TAUGHT = Notice(
    "reference_taught", "Reference pose kept for this arm", Level.DONE, EventKind.COMMAND
)
REFERENCE_FITS = Notice(
    "reference_fits",
    "Reference check finished: all joints stand where they report.",
    Level.DONE,
    EventKind.COMMAND,
)
REFERENCE_OFF = Notice(
    "reference_off",
    "Reference check finished: joint {joints} does not stand where it reports.",
    Level.FAULT,
    EventKind.COMMAND,
)

ALLOWED_S: Final = 60.0
"""Motions may begin for this long after the operator has agreed; one under way goes on."""
_DRIVE_PERCENT: Final = 5
"""The speed at which a joint is driven to its mark while another one is in doubt."""
_STALLED_S: Final = 0.5
"""After a longer time without a look at the arm nothing is concluded, as after a silence."""


class ReferenceMemory(Protocol):
    """Keeps the record of each arm beyond the program's end."""

    def get(self, arm: str) -> ReferenceRecord | None:
        """Return the record of an arm, by its key, or ``None``."""

    def keep(self, arm: str, record: ReferenceRecord) -> Refusal | None:
        """Keep the record of an arm; return why it could not be saved, or ``None``."""


def why_not_allow(now: OperatingState) -> Refusal | None:
    """Return why there is nothing to agree to, or ``None``."""
    if now.reference.checking:
        return REFERENCE_CHECK_OPEN()
    return now.unreachable or (None if now.reference.doubtful else NO_DOUBT())


def why_not_begin(now: OperatingState) -> Refusal | None:
    """Return why no reference check may begin, or ``None``."""
    if now.reference.checking:
        return REFERENCE_CHECK_OPEN()
    return now.unreachable or now.occupied or (None if now.angles_known else JOINTS_UNKNOWN())


def why_not_drive(now: OperatingState, joint: int = 0) -> Refusal | None:
    """Return why the check may not drive a joint (1–6) to its mark, or ``None``."""
    reference = now.reference
    if not reference.checking:
        return CHECK_NOT_OPEN()
    if not reference.looked:
        return LOOK_FIRST()
    if joint in reference.by_hand:
        return BROUGHT_BY_HAND(joint=joint)
    return reference.cannot_drive or (SPEED_ZERO() if now.speed_percent == 0 else None)


def why_not_finish(now: OperatingState) -> Refusal | None:
    """Return why the check has no result yet, or ``None``."""
    if not now.reference.checking:
        return CHECK_NOT_OPEN()
    left = list(now.reference.unanswered)
    return JOINTS_UNANSWERED(joints=joint_list(left)) if left else now.unreachable


def why_not_teach_pose(now: OperatingState) -> Refusal | None:
    """Return why the pose cannot be taught as reference, or ``None``."""
    doubt = REFERENCE_CHECK_OPEN() if now.reference.checking else now.reference.why_doubtful()
    return (
        doubt or now.unreachable or now.occupied or (None if now.angles_known else JOINTS_UNKNOWN())
    )


class ReferenceControl(ControllerPart):
    """Watches the joints' reference, keeps what is in doubt, and carries out the check.

    Args:
        context: The context that the controller's parts share.
        memory: Keeps the records of arms.
        wall: Returns the local time now.

    Attributes:
        check: The check that is open, or ``None``.
        record: The record of the connected arm.
    """

    def __init__(
        self, context: MotionContext, memory: ReferenceMemory | None, wall: Callable[[], datetime]
    ) -> None:
        self._context = context
        self._memory = memory
        self._wall = wall
        self._listener = AngleListener()
        self._watch = ReferenceWatch()
        self._key: str | None = None
        self._arm: int | None = None
        self._looked_s = -math.inf
        self._allowed_until_s = -math.inf
        self._left_over_deg: tuple[float, ...] | None = None
        self._simulated: ReferenceRecord | None = None
        """The record of this device's simulated arm, which ends with the device."""
        self._slipped = ""
        self.check: ReferenceCheck | None = None
        self.record = ReferenceRecord()
        context.connection.add_listener(self._listener)

    @property
    def status(self) -> ReferenceStatus:
        """The joints in doubt and the check under way, for the interface (S34)."""
        check = self.check
        return ReferenceStatus(
            self.record.doubtful,
            self._context.clock() < self._allowed_until_s,
            check is not None,
            check is not None and check.looked,
            () if check is None else check.by_hand,
            () if check is None else check.unanswered,
            slipped=self._slipped,
        )

    @property
    def known(self) -> ReferenceRecord | None:
        """The record of the connected arm; ``None`` while it has not named itself."""
        return None if self._key is None else self.record

    # What the operator does -------------------------------------------------------------------

    @operation(
        "reference.allow", "Move with the reference in doubt", why_not_allow, consent=Consent.HELD
    )
    def allow(self, started: Started) -> None:
        """Agree to motions for a minute, though a joint's reference is in doubt."""
        self._allowed_until_s = self._context.clock() + ALLOWED_S
        started.close(Ending.SENT)
        joints = joint_list(list(self.record.doubtful))
        self._context.emit_event(
            REFERENCE_ALLOWED, started, joints=joints, seconds=round(ALLOWED_S)
        )
        self._context.refresh()

    @operation("reference.begin", "Check the reference", why_not_begin)
    def begin(self, started: Started) -> None:
        """Begin the check; until it ends nothing moves but what it drives itself."""
        self.check = ReferenceCheck(self.record.doubtful, self.record.pose_deg)
        started.close(Ending.SENT)
        self._context.emit_event(REFERENCE_CHECK_BEGUN, started)
        self._context.refresh()

    @operation(
        "reference.drive",
        "Drive a joint to its mark",
        why_not_drive,
        moves=True,
        consent=Consent.HELD,
    )
    def drive(self, started: Started, joint: JointNumber) -> Refusal | None:
        """Drive one joint that is not in doubt to its mark, slowly; the others stay.

        It goes at the operator's speed where that is lower than the check's own.
        """
        context, check = self._context, self.check
        measured_deg = context.authority.measured_deg()
        if check is None:
            return CHECK_NOT_OPEN()
        mark_deg = next(each for each in check.steps if each.joint == joint).mark_deg
        if mark_deg is None or measured_deg is None:
            return NO_MARK(joint=joint) if mark_deg is None else JOINTS_UNKNOWN()
        target_deg = list(measured_deg)
        target_deg[joint - 1] = mark_deg
        request = joint_request(
            context,
            started,
            target_deg,
            lambda: context.operating_state().speed_percent,
            most_percent=_DRIVE_PERCENT,
            why_not=lambda now: why_not_drive(now, joint),
            sent_event=(REFERENCE_DRIVEN, {"joint": joint, "target": mark_deg}),
        )
        return context.gate().send(request)

    @operation(
        "reference.finish", "Finish the reference check", why_not_finish, consent=Consent.PRESS
    )
    def finish(self, started: Started) -> Refusal | None:
        """Keep the result of the check: what fits is in doubt no more."""
        check = self.check
        if check is None:
            return CHECK_NOT_OPEN()
        off_deg, at = check.off_deg, self._now()
        self.check, self._slipped = None, ""
        self._allowed_until_s = -math.inf
        self._keep(
            replace(
                self.record,
                doubtful=tuple(off_deg),
                doubted_at=at if off_deg else self.record.doubted_at,
                checked_at=at,
                off_deg=off_deg,
            )
        )
        started.close(Ending.SENT)
        notice = REFERENCE_OFF if off_deg else REFERENCE_FITS
        self._context.emit_event(notice, started, joints=joint_list(list(off_deg)))
        self._context.refresh()
        return None

    @operation(
        "reference.teach", "Teach the reference pose", why_not_teach_pose, consent=Consent.PRESS
    )
    def teach(self, started: Started) -> Refusal | None:
        """Keep where the joints stand as the reference pose of this arm; its photo is dropped."""
        angles_deg = self._context.state().angles_deg()
        if angles_deg is None:
            return JOINTS_UNKNOWN()
        pose_deg = tuple(round(angle, 3) for angle in angles_deg)
        self._keep(replace(self.record, pose_deg=pose_deg, photo=""))
        started.close(Ending.SENT)
        self._context.emit_event(REFERENCE_TAUGHT, started)
        self._context.refresh()
        return None

    def keep_photo(self, path: str) -> None:
        """Keep the name of the file with a photo of the arm in its reference pose."""
        self._keep(replace(self.record, photo=path))

    def keep_resume(self, entry: ResumeEntry) -> None:
        """Keep with the arm by how much its feedback jumped at a resume."""
        self._slipped = entry.text or self._slipped
        self._keep(replace(self.record, resumes=(*self.record.resumes, entry)[-KEPT:]))

    def note_slip(self) -> None:
        """Stop showing what slipped at a resume: the operator has read it."""
        self._slipped = ""
        self._context.refresh()

    def keep_inspection(self, entry: InspectionEntry) -> None:
        """Keep with the arm what an inspection has measured."""
        self._keep(replace(self.record, inspections=(*self.record.inspections, entry)[-KEPT:]))

    def note_elsewhere(self, elsewhere: Sequence[int]) -> None:
        """Note which joints stand elsewhere than the picture shows; others may be driven then."""
        if self.check is not None:
            self.check.suspect(elsewhere)
            self.check.looked = True
            self._context.refresh()

    def answer(self, joint: int, off_deg: float) -> None:
        """Note by how many degrees a joint reports another angle than where it stands."""
        if self.check is not None:
            self.check.answer(joint, off_deg)
            self._context.refresh()

    def at_mark(self, joint: int) -> float | None:
        """Return how far a joint's report is from its mark, in degrees; ``None``: not known."""
        heard = self._context.state().joints_deg[joint - 1]
        steps = () if self.check is None else self.check.steps
        mark_deg = next((each.mark_deg for each in steps if each.joint == joint), None)
        return None if heard is None or mark_deg is None else heard.value - mark_deg

    def take_back(self, joint: int) -> None:
        """Forget the answer for a joint."""
        if self.check is not None:
            self.check.take_back(joint)
            self._context.refresh()

    def leave(self) -> None:
        """Close the check without a result."""
        if self.check is not None:
            self.check = None
            self._context.emit_event(REFERENCE_CHECK_LEFT)
            self._context.refresh()

    # The controller's tick --------------------------------------------------------------------

    def follow_arm(self) -> None:
        """Judge what was reported; called at each tick while a device is open."""
        context, reports = self._context, self._listener.take_reports()
        connection, now_s = context.connection, context.clock()
        if connection.device is None or connection.device.recorded is not None:
            return
        if connection.arm != self._arm:
            self._leave()
            self._arm = connection.arm
        self._remember()
        stalled, self._looked_s = now_s - self._looked_s > _STALLED_S, now_s
        now = context.operating_state()
        goes_on = now.running or now.jogging or context.authority.under_way
        if goes_on and self._allowed_until_s > now_s:
            self._allowed_until_s = max(self._allowed_until_s, now_s + _STALLED_S)
        found = self._watch.observe(self._watched(now, now_s, stalled=stalled), reports)
        for each in found:
            self._doubt(each.joint)
            figures = {"place": round(each.place_deg, 1), "value": round(each.farthest_deg, 1)}
            context.emit_event(REFERENCE_LEFT, joint=each.joint, **figures)
        if found:
            context.refresh()

    def halt(self) -> None:
        """Withdraw the agreement to motions, because of a stop."""
        self._allowed_until_s = -math.inf

    def forget_arm(self) -> None:
        """Forget the arm; its record is kept, of a simulated arm only pose and photo."""
        self._leave()
        self._simulated = None

    def _leave(self) -> None:
        self._key = self._arm = self._left_over_deg = self.check = None
        self._allowed_until_s, self._slipped = -math.inf, ""
        self.record = ReferenceRecord()
        self._watch.reset(self._context.clock())

    def places_change(self) -> None:
        """Note that the angles are about to be counted from other zeros."""
        self._watch.reset(self._context.clock())

    def _doubt(self, joint: int) -> None:
        self._allowed_until_s = -math.inf
        if self.check is not None:
            self.check.suspect([joint])
        doubtful = tuple(sorted({*self.record.doubtful, joint}))
        self._keep(replace(self.record, doubtful=doubtful, doubted_at=self._now()))

    def _remember(self) -> None:
        """Take over what is kept of the arm, once it has named itself."""
        context = self._context
        connection = context.connection
        if self._key is not None or self._arm is None:
            return
        self._key = arm_key(connection.device, connection.generation, context.state().identity)
        if self._key is None or self._memory is None:
            return
        kept, early = self._recall(self._memory, self._key), self.record.doubtful
        if kept is not None:
            doubtful = tuple(sorted({*kept.doubtful, *early}))
            self.record = replace(kept, doubtful=doubtful)
            if kept.doubtful:
                context.emit_event(REFERENCE_STILL_IN_DOUBT, joints=joint_list(list(kept.doubtful)))
        if early:
            self._keep(replace(self.record, doubted_at=self._now()))
        context.refresh()

    def _recall(self, memory: ReferenceMemory, key: str) -> ReferenceRecord | None:
        """Return the arm's kept record; of a simulated arm that has just started only its pose."""
        kept = memory.get(key)
        if not self._is_simulated:
            return kept
        return self._simulated or (None if kept is None else _lasting(kept))

    @property
    def _is_simulated(self) -> bool:
        device = self._context.connection.device
        return device is not None and device.simulated

    def _keep(self, record: ReferenceRecord) -> None:
        self.record = record
        if self._is_simulated:
            self._simulated = record
        if self._key is not None and self._memory is not None:
            lasting = _lasting(record) if self._is_simulated else record
            refusal = self._memory.keep(self._key, lasting)
            if refusal is not None:
                self._context.refuse(refusal)

    def _now(self) -> str:
        return self._wall().isoformat(timespec="seconds")

    def _watched(self, now: OperatingState, now_s: float, *, stalled: bool) -> WatchedArm:
        """Return the facts that the watch needs beside the angles."""
        context = self._context
        authority, state = context.authority, context.connection.newest
        command, status = authority.command, state.status
        under_way = authority.under_way or (authority.moves and authority.may_be_ours)
        if command is not None:
            self._left_over_deg = command.joints_deg
        moves_on = under_way and not authority.holds
        at_rest = authority.at_rest and not moves_on
        if at_rest and command is None and status is not None and status.value.reached:
            self._left_over_deg = state.angles_deg()
        return WatchedArm(
            now_s=now_s,
            exempt=stalled or self._is_exempt(now, now_s),
            commanded=moves_on,
            target_deg=self._left_over_deg,
            at_rest=at_rest,
            enabled=[
                None if each is None else (each.value.enabled, each.at_s)
                for each in state.drivers_slow
            ],
            top_speed_deg_s=[each.max_speed_deg_s for each in now.limits],
        )

    def _is_exempt(self, now: OperatingState, now_s: float) -> bool:
        """Return whether anything but our own commands may move joints, or count them anew."""
        context = self._context
        authority, state = context.authority, context.connection.newest
        other, status = authority.other, state.status
        if now.link is not LinkState.ONLINE or authority.why_silent() is not None:
            return True
        if now.stop is not StopState.RUNNING or now.busy is not None or now.altering is not None:
            return True
        if status is None or status.value.control_mode not in MOVABLE_MODES:
            return True
        led = in_drag_teaching(state) or phase_of(status.value) is not TeachingPhase.OFF
        recent = other.last_s is not None and now_s - other.last_s < _STALLED_S
        off = any_motor_off(state, now_s) is not False
        return led or other.drives or recent or off or len(now.limits) != len(JOINTS)


def _lasting(record: ReferenceRecord) -> ReferenceRecord:
    """Return the part of a simulated arm's record that is kept: the operator's pose and photo."""
    return ReferenceRecord(pose_deg=record.pose_deg, photo=record.photo)
