"""Works out from the feedback what the operator can do: pure, computed anew at each tick."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from armui.arm.limits import JointLimits, outside_list, plausible
from armui.arm.models import model_data
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, Six, is_fresh
from armui.control.authority import Authority
from armui.control.link.link_state import LinkState, why_unreachable
from armui.control.link.offsets import OffsetFollower
from armui.control.operating_state import BUSY, RUN_UNDER_WAY, OperatingState, StopState
from armui.control.safety import interlocks
from armui.control.safety.emergency_stop import is_stopped
from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN, SPEED_ZERO
from armui.protocol.codes import ControlMode


def assess(
    state: ArmState,
    known: OperatingState,
    authority: Authority,
    offsets: OffsetFollower,
    now_s: float,
) -> OperatingState:
    """Return the operating state: the actions open to the operator, and the reasons against others.

    Args:
        state: The arm as last heard.
        known: The program's own knowledge beside that; the results are filled in here.
        authority: Knows who moves the arm.
        offsets: Follows the arm's identifiers.
        now_s: Monotonic time.
    """
    enabled = _fresh_enabled(state, now_s)
    no_command = interlocks.why_no_command(
        why_unreachable(known.link, known.device), known.stop, known.busy
    )
    cannot_drive = _first(
        lambda: no_command,
        lambda: None if offsets.certain else CONTROL_OFFSET_UNKNOWN(),
        lambda: BUSY(what=known.altering) if known.altering else None,
        authority.why_not_ours,
        lambda: authority.unconfirmed_cell,
        lambda: interlocks.why_not_enabled(enabled),
        lambda: interlocks.why_not_ready(state),
    )
    held, reference = authority.why_held(), known.reference
    cannot_run = cannot_drive or reference.why_not_run()
    read = [
        heard.value if heard is not None and plausible(heard.value) else None
        for heard in state.limits
    ]
    factory_limits = model_data(known.model_fit.chosen).limits
    limits = tuple(own or factory for own, factory in zip(read, factory_limits, strict=True))
    r1, r2, r3, r4, r5, r6 = (each is not None for each in read)
    return replace(
        known,
        enabled=enabled,
        cannot_move=_first(
            lambda: cannot_drive,
            lambda: RUN_UNDER_WAY() if known.running else held,
            lambda: SPEED_ZERO() if known.speed_percent == 0 else None,
            lambda: reference.why_not_move(known.speed_percent),
        ),
        cannot_run=cannot_run,
        cannot_send_motion=authority.why_not_ours() or authority.unconfirmed_cell,
        unconfirmed_cell=authority.unconfirmed_cell,
        mover=authority.mover,
        holds=authority.holds,
        held_target_deg=authority.held_target_deg,
        cancel_unheeded=authority.cancel_unheeded,
        may_hold_another=authority.seems_to_hold_another,
        status=None if state.status is None else state.status.value,
        angles_known=state.angles_deg() is not None,
        pose_known=state.end_pose() is not None,
        gripper_heard=state.gripper is not None and is_fresh(state.gripper.at_s, now_s),
        cannot_enable=no_command,
        limits=limits,
        limits_read=(r1, r2, r3, r4, r5, r6),
        moving=known.link is LinkState.ONLINE
        and known.stop is StopState.RUNNING
        and (bool(authority.holds) or authority.about_to_move or _on_its_way(state, authority)),
        addressing=offsets.addressing,
        control_certain=offsets.certain,
        outside=_outside(state, limits),
        reference=replace(
            reference, cannot_drive=cannot_drive or (RUN_UNDER_WAY() if known.running else held)
        ),
        teaching_input=known.link in (LinkState.OFFLINE, LinkState.ONLINE)
        and is_fresh(state.foreign_targets_s, now_s)
        and not _controller_heard(state, now_s),
        becomes_input=offsets.keeps_input and known.link is LinkState.ONLINE and _role_waits(state),
    )


def _role_waits(state: ArmState) -> bool:
    """Return whether a role that the arm keeps must wait: standby brings it into force at once."""
    status = state.status
    return status is not None and (
        status.value.control_mode != ControlMode.STANDBY or is_stopped(state)
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
