"""The actions open to the operator now, as one frozen state that every button reads."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from datetime import datetime

from armui.arm.device import Device
from armui.arm.limits import JointLimits
from armui.arm.model_check import ModelFit
from armui.arm.models import model_data
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import Six, Status
from armui.control.cell.intrusion import AreaIntrusion
from armui.control.link.link_state import NOT_CONNECTED, LinkState, why_unreachable
from armui.control.motion.motion_command import Hold, Mover, why_held
from armui.control.run.progress import RunPhase
from armui.control.safety.reference_status import ReferenceStatus
from armui.control.safety.uncommanded_motion import UncommandedMotion
from armui.control.sessions.progress import EpisodePhase
from armui.protocol.addressing import Addressing
from armui.protocol.generation import Generation, PiperModel

BUSY = Reason("busy", "Still under way: {what}. Wait until it is done.")
RUN_UNDER_WAY = Reason(
    "run_under_way",
    "A trajectory or recording is under way, be it paused or dwelling. Wait until it is done, "
    "or end the run first.",
)
JOG_UNDER_WAY = Reason("jog_under_way", "The arm is being jogged. Let go first, then press again.")


class StopState(enum.Enum):
    """The state of the emergency stop, as the arm reports it (0x2A1 byte 1)."""

    RUNNING = enum.auto()
    REQUESTED = enum.auto()
    """The stop was sent and is not confirmed yet; it is repeated until it is."""
    STOPPED = enum.auto()
    RESUMING = enum.auto()


class Busy(enum.Enum):
    """The effects that the program waits for the arm to show."""

    ENABLING = "enabling"
    DISABLING = "disabling"
    RESUMING = "resuming"
    ZEROING = "zeroing"


@dataclass(frozen=True, slots=True)
class OtherHostReport:
    """Another host that moves the arm.

    Attributes:
        frames: The identifiers of its motion frames, for a sentence.
        since: Local time of the first of them.
        rate_hz: Their rate, rounded; 0 for single frames.
        refusal: The reason it is against a motion of ours.
        may_be_taken_over: True if the operator may take the arm over now.
    """

    frames: str
    since: datetime
    rate_hz: int
    refusal: Refusal
    may_be_taken_over: bool


@dataclass(frozen=True, slots=True)
class OperatingState:
    """All that a button needs to know.

    Attributes:
        link_problem: Why the device could not be opened or was lost.
        stop_unconfirmed: A stop was asked for over half a second ago and the arm has not confirmed
            it.
        stop_lapsed: That stop is no longer sent automatically: the operator is asked.
        enabled: Each motor as reported; ``None`` where it has not been heard of late.
        cannot_move, cannot_enable: The reason against moving or enabling the arm, or ``None``.
        cannot_run: Why a trajectory cannot be run, or the one that runs cannot go on.
        running: A run or a replay is under way, be it that it dwells, waits or is paused.
        run_phase: The phase of the run, or the way the last one ended.
        jogging: A jog is held.
        recording: The program records where the arm goes.
        episode: The marks that are possible in the log being written.
        altering: The setting being changed that motions rely on, or ``None``.
        run_sets_lamps: The run under way signals by the lamps.
        pending: The parts whose last request the arm has not answered yet, by the names that
            the reason ``BUSY`` has for them.
        status: The arm's status as last heard (0x2A1), however old.
        angles_known: All six joint angles have been heard.
        pose_known: The pose of the flange has been heard.
        gripper_heard: The gripper is heard.
        limits: The limits of each joint, as read from the arm if ``limits_read``, else the
            factory's.
        speed_percent: The operator's speed: of motions, or the share of a run's own pace.
        cannot_send_motion: Why no motion frame at all may be sent: the arm is not heard, or
            somebody else moves it.
        mover: The party that moves the arm.
        other_host: Another host that moves the arm, or ``None``.
        holds: The causes that hold back a motion in the arm.
        held_target_deg: The six target angles of that motion, or ``None`` if unknown.
        cancel_unheeded: The arm was told to end its motion and does not come to rest.
        may_hold_another: The arm stands short of a target that is not this program's, and may go on
            to it.
        moving: The arm says that it has not reached its target, is not stopped, and is not
            measured to stand still: a motion cut short stays «not reached» for good. A motion
            held back counts as well, and one of ours that was sent and is not measured yet.
        generation: The protocol the arm speaks, once that is known.
        addressing: The identifier offsets in use (0x470).
        control_certain: True if the arm is known to take commands under them.
        model_fit: The chosen model, and whether the arm's reports fit it.
        reference: The state of the joints' reference.
        below_base_mm: The depth of flange or fingertip below the floor, or ``None``.
        below_lowest_mm: The depth below the least height chosen for motions, or ``None``.
        outside: The joints measured outside their limits, with their bounds, for a sentence; "" if
            none is.
        intrusion: The place where the arm is too near to its work area, or ``None``.
        keeps_area: True if a plane or a box of the work area is switched on.
        unconfirmed_cell: Why the cell kept for the adapter is not in force yet; nothing moves then.
        uncommanded: What is measured of an arm that moves though no motor holds it or nothing told
            it to, and of one that is not heard; ``None``: it is held, or measured at rest.
        teaching_input: Commands are heard and no feedback: the arm is a teaching input (0x470).
        becomes_input: The arm keeps that role and still obeys: standby or a power cycle brings it
            into force, and the release of a stop leads to standby.
    """

    link: LinkState = LinkState.NO_DEVICE
    device: Device | None = None
    link_problem: Refusal | None = None
    stop: StopState = StopState.RUNNING
    stop_unconfirmed: bool = False
    stop_lapsed: bool = False
    enabled: Six[bool | None] = (None, None, None, None, None, None)
    busy: Busy | None = None
    cannot_move: Refusal | None = field(default_factory=NOT_CONNECTED)
    cannot_run: Refusal | None = field(default_factory=NOT_CONNECTED)
    cannot_enable: Refusal | None = field(default_factory=NOT_CONNECTED)
    limits: tuple[JointLimits, ...] = field(default_factory=lambda: model_data().limits)
    limits_read: Six[bool] = (False, False, False, False, False, False)
    speed_percent: int = 0
    moving: bool = False
    running: bool = False
    run_phase: RunPhase = RunPhase.IDLE
    jogging: bool = False
    recording: bool = False
    episode: EpisodePhase = EpisodePhase.NO_LOG
    cannot_send_motion: Refusal | None = None
    mover: Mover = Mover.UNKNOWN
    other_host: OtherHostReport | None = None
    holds: frozenset[Hold] = frozenset()
    held_target_deg: tuple[float, ...] | None = None
    cancel_unheeded: bool = False
    may_hold_another: bool = False
    altering: str | None = None
    run_sets_lamps: bool = False
    pending: frozenset[str] = frozenset()
    status: Status | None = None
    angles_known: bool = False
    pose_known: bool = False
    gripper_heard: bool = False
    generation: Generation | None = None
    teaching_input: bool = False
    becomes_input: bool = False
    addressing: Addressing = field(default_factory=Addressing)
    control_certain: bool = True
    model_fit: ModelFit = field(default_factory=ModelFit)
    below_base_mm: int | None = None
    below_lowest_mm: int | None = None
    outside: str = ""
    intrusion: AreaIntrusion | None = None
    keeps_area: bool = False
    reference: ReferenceStatus = field(default_factory=ReferenceStatus)
    unconfirmed_cell: Refusal | None = None
    uncommanded: UncommandedMotion | None = None

    @property
    def unreachable(self) -> Refusal | None:
        """The reason why nothing can be sent to the arm, or ``None``."""
        return why_unreachable(self.link, self.device)

    @property
    def model(self) -> PiperModel:
        """The model of the arm as the operator has chosen."""
        return self.model_fit.chosen

    @property
    def listens_only(self) -> bool:
        """True if only an operator's stop is sent over the connection."""
        return self.device is not None and self.device.listen_only

    def why_pending(self, part: str) -> Refusal | None:
        """Return the reason that a part still awaits the arm's answer, or ``None``."""
        return BUSY(what=part) if part in self.pending else None

    @property
    def held(self) -> Refusal | None:
        """The motion held back, as a reason against another one, or ``None``."""
        return why_held(self.holds)

    @property
    def occupied(self) -> Refusal | None:
        """The reason against changing limits, zeros, identifiers, load and drivers, or ``None``.

        An activity under way was checked against them. A run that dwells, waits or is paused
        counts, too: the arm stands still then, but goes on.
        """
        if self.running:
            return RUN_UNDER_WAY()
        if self.jogging:
            return JOG_UNDER_WAY()
        if self.held is not None:
            return self.held
        if self.other_host is None or self.teaching_input:
            return None  # a teaching input sends commands itself
        return self.other_host.refusal
