"""Interprets the frames heard on a bus. Pure: no bus, no clock."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Final, NamedTuple

from armui.arm.model_check import fitting_models
from armui.arm.models import all_models
from armui.arm.other_hosts import MOTION_IDS, OtherHosts, OtherTraffic
from armui.arm.state import ArmState, DriverSlow
from armui.arm.tracker import Tracker
from armui.doctor.facts import ArmFacts, HeardFacts, LimitFacts, OtherFrames
from armui.protocol.addressing import OFFSETS, Addressing
from armui.protocol.codec import Codec
from armui.protocol.codes import ControlMode
from armui.protocol.detect import GenerationDetector
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation

_STATUS_ID: Final = 0x2A1
_FEEDBACK_IDS: Final = range(0x2A1, 0x2A9)
_SHIFTED_IDS: Final = range(0x3A1, 0x3A9)
_LEAST: Final = 3
"""The frames of an identifier that make feedback; fewer may be strays."""
_SHOWN_IDS: Final = 8
_ANSWER_IDS: Final = frozenset({0x473, 0x47C, 0x47E, 0x4AF})
_DRIVER_FAULTS: Final = (
    ("undervoltage", "undervoltage"),
    ("motor_overtemperature", "motor overtemperature"),
    ("overcurrent", "overcurrent"),
    ("driver_overtemperature", "driver overtemperature"),
    ("driver_fault", "driver fault"),
    ("sensor_fault", "sensor fault"),
    ("collision_protection", "collision protection"),
    ("stall_protection", "stall protection"),
)


class TimedFrame(NamedTuple):
    """A data frame with an 11-bit identifier, and its time of reception in seconds."""

    at_s: float
    frame: Frame


def heard_facts(
    interface: str,
    channel: str,
    frames: Sequence[TimedFrame],
    *,
    seconds: float,
    error_frames: int = 0,
    bus_off: bool = False,
    asked: frozenset[int] = frozenset(),
) -> HeardFacts:
    """Return the facts in the frames heard on a device.

    Args:
        interface: The interface, as python-can names it.
        channel: The channel, likewise.
        frames: The frames in the order they came.
        seconds: The time of listening.
        error_frames: Error frames received meanwhile.
        bus_off: True if one of them reported bus-off.
        asked: Identifiers of the questions that were sent.
    """
    counts = Counter(each.frame.arbitration_id for each in frames)
    offsets = [offset for offset in OFFSETS if counts[_STATUS_ID + offset] >= _LEAST]
    if not offsets:
        offsets = [
            offset
            for offset in OFFSETS
            if any(counts[each + offset] >= _LEAST for each in _FEEDBACK_IDS)
        ]
    traffic = _traffic(frames, asked)
    leader = any(traffic.leads((offset,)) for offset in OFFSETS) or _targets_only(counts, offsets)
    known = MOTION_IDS | _ANSWER_IDS | asked
    return HeardFacts(
        interface=interface,
        channel=channel,
        seconds=seconds,
        frames=len(frames),
        error_frames=error_frames,
        bus_off=bus_off,
        asked=bool(asked),
        answered=_answered(frames),
        arm=_arm(frames, offsets[0], seconds) if offsets else None,
        other_offsets=tuple(offsets[1:]),
        shifted_feedback=tuple(each for each in _SHIFTED_IDS if counts[each] >= _LEAST),
        leader=leader,
        other_hosts=tuple(
            OtherFrames(each, series.count, series.rate_hz)
            for each, series in sorted(traffic.series.items())
            if each in MOTION_IDS
        ),
        unknown_ids=tuple(sorted(set(counts) - known))[:_SHOWN_IDS],
    )


def arm_facts(
    state: ArmState, codec: Codec, *, reason: str, frames_per_s: float, firmware: str | None
) -> ArmFacts:
    """Return the facts in an arm's state.

    Args:
        state: The state.
        codec: The codec that decoded it.
        reason: The reason for the codec's generation.
        frames_per_s: The frames per second on the bus.
        firmware: The version it named.
    """
    status = None if state.status is None else state.status.value
    slow = [(n, each.value) for n, each in enumerate(state.drivers_slow, 1) if each is not None]
    teaching = None if state.teaching_handle is None else state.teaching_handle.value
    return ArmFacts(
        generation=int(codec.generation),
        reason=reason,
        firmware=firmware,
        identity=_identity(state),
        feedback_offset=codec.addressing.feedback_offset,
        frames_per_s=frames_per_s,
        status_code=None if status is None else status.arm_status,
        status_word="" if status is None else _word(codec, "Status", status.arm_status),
        mode_word="" if status is None else _word(codec, "MoveMode", status.move_mode),
        teaching_input=(
            status is not None and status.control_mode == ControlMode.LINKED_TEACHING_INPUT
        ),
        joints_deg=tuple(None if each is None else each.value for each in state.joints_deg),
        pose=tuple(None if each is None else each.value for each in state.pose),
        unreachable=_numbers(() if status is None else status.communication_fault),
        beyond_limit=_numbers(() if status is None else status.limit_exceeded),
        driver_faults=tuple((joint, word) for joint, each in slow for word in _faults(each)),
        lowest_voltage=min((each.voltage_v for _joint, each in slow), default=None),
        models=_models(state, firmware),
        teaching=(
            None
            if teaching is None
            else (teaching.range_percent, teaching.stroke_limit_mm, teaching.friction)
        ),
        limits=tuple(
            LimitFacts(
                joint,
                None if limits is None else limits.value.min_deg,
                None if limits is None else limits.value.max_deg,
                None if limits is None else limits.value.max_speed_deg_s,
                None if acceleration is None else acceleration.value,
            )
            for joint, (limits, acceleration) in enumerate(
                zip(state.limits, state.accelerations_deg_s2, strict=True), 1
            )
            if limits is not None or acceleration is not None
        ),
    )


def _identity(state: ArmState) -> tuple[str, ...]:
    told = state.identity
    if told is None:
        return ()
    return tuple(each for each in (told.hardware, told.node_type, told.iso_date) if each)


def _arm(frames: Sequence[TimedFrame], offset: int, seconds: float) -> ArmFacts:
    detector = GenerationDetector()
    for at_s, frame in frames:
        detector.feed(_without_offset(frame, offset), at_s)
        if detector.certain:
            break
    verdict = detector.verdict()
    codec = Codec(verdict.generation, Addressing(feedback_offset=offset))
    tracker = Tracker(codec)
    for at_s, frame in frames:
        tracker.update(codec.decode(frame), at_s)
    state = tracker.snapshot()
    return arm_facts(
        state,
        codec,
        reason=verdict.reason,
        frames_per_s=len(frames) / seconds if seconds > 0 else 0.0,
        firmware=state.firmware if verdict.generation is Generation.TWO else None,
    )


def _models(state: ArmState, firmware: str | None) -> tuple[str, ...] | None:
    """Return the models of the family whose pose fits the angles; ``None`` if either is missing."""
    joints_deg, pose = state.angles_deg(), state.end_pose()
    if joints_deg is None or pose is None:
        return None
    fitting = fitting_models(joints_deg, pose, firmware)
    return tuple(data.name for model, data in all_models().items() if model in fitting)


def _without_offset(frame: Frame, offset: int) -> Frame:
    """Return a frame as an arm without offset would send it, for the detector of generations."""
    if frame.arbitration_id - offset in _FEEDBACK_IDS:
        return Frame(frame.arbitration_id - offset, frame.data)
    return frame


def _traffic(frames: Sequence[TimedFrame], asked: frozenset[int]) -> OtherTraffic:
    others = OtherHosts()
    for at_s, frame in frames:
        if frame.arbitration_id not in asked:
            others.note(frame.arbitration_id, frame.data, at_s)
    return others.traffic()


def _targets_only(counts: Counter[int], offsets: list[int]) -> bool:
    """Return whether there are joint targets without feedback: a teaching-input arm."""
    targets = all(counts[each] >= _LEAST for each in (0x155, 0x156, 0x157))
    return targets and not offsets


def _answered(frames: Sequence[TimedFrame]) -> bool:
    return any(
        frame.arbitration_id in _ANSWER_IDS and frame.data.rstrip(b"\0") != b"\x01"
        for _at_s, frame in frames
    )


def _word(codec: Codec, signal: str, code: int) -> str:
    return codec.word("ArmStatus", signal, code) or ""


def _numbers(flags: Sequence[bool]) -> tuple[int, ...]:
    return tuple(joint for joint, flag in enumerate(flags, 1) if flag)


def _faults(driver: DriverSlow) -> list[str]:
    return [word for name, word in _DRIVER_FAULTS if getattr(driver, name)]
