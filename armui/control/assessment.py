"""Works out from the feedback what the operator can do: pure, computed anew at each tick."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

from armui.arm.device import Device
from armui.arm.limits import JointLimits, outside_list, plausible
from armui.arm.model_check import ModelFit
from armui.arm.models import model_data
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, Six, is_fresh
from armui.control.authority import Authority
from armui.control.cell.intrusion import AreaIntrusion
from armui.control.link.link_state import LinkState, why_unreachable
from armui.control.link.offsets import OffsetFollower
from armui.control.operating_state import (
    BUSY,
    RUN_UNDER_WAY,
    Busy,
    OperatingState,
    OtherHostReport,
    StopState,
)
from armui.control.run.progress import RunPhase
from armui.control.safety import interlocks
from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN, SPEED_ZERO
from armui.control.safety.reference_status import ReferenceStatus
from armui.control.safety.uncommanded_motion import UncommandedMotion
from armui.protocol.generation import Generation


@dataclass(frozen=True, slots=True)
class ActiveTasks:
    """The activities of this program that concern the arm; see :class:`OperatingState`."""

    running: bool = False
    jogging: bool = False
    recording: bool = False
    altering: str | None = None
    run_sets_lamps: bool = False
    run_phase: RunPhase = RunPhase.IDLE
    pending: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class AssessmentInputs:
    """The program's knowledge beside the arm's feedback; fields as in :class:`OperatingState`.

    Attributes:
        authority: Knows who moves the arm.
        other_host: The other host that moves the arm, as told to the operator.
        tasks: The activities of this program that concern the arm.
    """

    link: LinkState
    device: Device | None
    link_problem: Refusal | None
    stop: StopState
    stop_unconfirmed: bool
    busy: Busy | None
    speed_percent: int
    generation: Generation | None
    authority: Authority
    other_host: OtherHostReport | None = None
    tasks: ActiveTasks = field(default_factory=ActiveTasks)
    stop_lapsed: bool = False
    model_fit: ModelFit = field(default_factory=ModelFit)
    below_base_mm: int | None = None
    intrusion: AreaIntrusion | None = None
    keeps_area: bool = False
    offsets: OffsetFollower = field(default_factory=OffsetFollower)
    reference: ReferenceStatus = field(default_factory=ReferenceStatus)
    uncommanded: UncommandedMotion | None = None


def assess(state: ArmState, around: AssessmentInputs, now_s: float) -> OperatingState:
    """Return what the operator can do at monotonic time ``now_s``."""
    enabled = _fresh_enabled(state, now_s)
    tasks, authority = around.tasks, around.authority
    no_command = interlocks.why_no_command(
        why_unreachable(around.link, around.device), around.stop, around.busy
    )
    cannot_drive = _first(
        lambda: no_command,
        lambda: None if around.offsets.certain else CONTROL_OFFSET_UNKNOWN(),
        lambda: BUSY(what=tasks.altering) if tasks.altering else None,
        authority.why_not_ours,
        lambda: authority.unconfirmed_cell,
        lambda: interlocks.why_not_enabled(enabled),
        lambda: interlocks.why_not_ready(state),
    )
    held, reference = authority.why_held(), around.reference
    cannot_run = cannot_drive or reference.why_not_run()
    read = [
        heard.value if heard is not None and plausible(heard.value) else None
        for heard in state.limits
    ]
    factory_limits = model_data(around.model_fit.chosen).limits
    limits = tuple(known or factory for known, factory in zip(read, factory_limits, strict=True))
    r1, r2, r3, r4, r5, r6 = (each is not None for each in read)
    return OperatingState(
        link=around.link,
        device=around.device,
        link_problem=around.link_problem,
        stop=around.stop,
        stop_unconfirmed=around.stop_unconfirmed,
        stop_lapsed=around.stop_lapsed,
        enabled=enabled,
        busy=around.busy,
        cannot_move=_first(
            lambda: cannot_drive,
            lambda: RUN_UNDER_WAY() if tasks.running else held,
            lambda: SPEED_ZERO() if around.speed_percent == 0 else None,
            lambda: reference.why_not_move(around.speed_percent),
        ),
        cannot_run=cannot_run,
        running=tasks.running,
        run_phase=tasks.run_phase,
        jogging=tasks.jogging,
        recording=tasks.recording,
        cannot_send_motion=authority.why_not_ours() or authority.unconfirmed_cell,
        unconfirmed_cell=authority.unconfirmed_cell,
        mover=authority.mover,
        other_host=around.other_host,
        holds=authority.holds,
        held_target_deg=authority.held_target_deg,
        cancel_unheeded=authority.cancel_unheeded,
        altering=tasks.altering,
        run_sets_lamps=tasks.run_sets_lamps,
        pending=tasks.pending,
        status=None if state.status is None else state.status.value,
        angles_known=state.angles_deg() is not None,
        pose_known=state.end_pose() is not None,
        gripper_heard=state.gripper is not None and is_fresh(state.gripper.at_s, now_s),
        cannot_enable=no_command,
        limits=limits,
        limits_read=(r1, r2, r3, r4, r5, r6),
        speed_percent=around.speed_percent,
        moving=around.link is LinkState.ONLINE
        and around.stop is StopState.RUNNING
        and (bool(authority.holds) or _on_its_way(state, authority)),
        generation=around.generation,
        addressing=around.offsets.addressing,
        control_certain=around.offsets.certain,
        model_fit=around.model_fit,
        below_base_mm=around.below_base_mm,
        outside=_outside(state, limits),
        intrusion=around.intrusion,
        keeps_area=around.keeps_area,
        uncommanded=around.uncommanded,
        reference=replace(
            reference, cannot_drive=cannot_drive or (RUN_UNDER_WAY() if tasks.running else held)
        ),
        teaching_input=around.link in (LinkState.OFFLINE, LinkState.ONLINE)
        and is_fresh(state.foreign_targets_s, now_s)
        and not _controller_heard(state, now_s),
    )


def _controller_heard(state: ArmState, now_s: float) -> bool:
    """Return whether the arm's controller is heard, 0x2A1–0x2A7; drivers may go on without it."""
    heard = (state.status, *state.joints_deg, *state.pose)
    return any(each is not None and each.fresh(now_s) for each in heard)


def _on_its_way(state: ArmState, authority: Authority) -> bool:
    status = state.status
    return not authority.at_rest and status is not None and not status.value.reached


def _outside(state: ArmState, limits: Sequence[JointLimits]) -> str:
    joints_deg = state.angles_deg()
    return "" if joints_deg is None else outside_list(joints_deg, limits)


def _fresh_enabled(state: ArmState, now_s: float) -> Six[bool | None]:
    a, b, c, d, e, f = [
        driver.value.enabled if driver is not None and is_fresh(driver.at_s, now_s) else None
        for driver in state.drivers_slow
    ]
    return (a, b, c, d, e, f)


def _first(*checks: Callable[[], Refusal | None]) -> Refusal | None:
    return next((refusal for check in checks if (refusal := check()) is not None), None)
