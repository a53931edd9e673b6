"""Turns the arm's reports into events: pure; the same frames give the same events, live or not."""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.arm.joint_status import Item, Word
from armui.arm.limits import JOINTS, plausible
from armui.arm.state import GripperFault
from armui.control.event_log import status_listener as h
from armui.control.event_log.observed import EventChange, EventPhase, Observed
from armui.control.event_log.status_listener import InvalidFrames, StatusChange
from armui.protocol.codes import TARGET_REFUSALS, ArmStatusCode
from armui.telemetry.events import Asker, EventKind, Level

if TYPE_CHECKING:
    from armui.arm.other_hosts import OtherTraffic
    from armui.arm.state import ArmState

CONTROL_MODE = Observed("control_mode", "Control mode: {before} → {mode}")
MOVE_MODE = Observed("move_mode", "Motion mode: {before} → {mode}")
ARM_STATUS = Observed("arm_status", "Arm status: {status}")
TEACHING = Observed("teaching", "Drag teaching: {before} → {state}")
MOTION = Observed("motion", "Target not reached", streams=True)
MOTORS_ON = Observed("motors_on", "Motors enabled: {joints}")
MOTORS_OFF = Observed("motors_off", "Motors disabled: {joints}")
JOINT_FAULT = Observed("joint_fault", "J{joint} {item}: {word}")
BEYOND_LIMIT = Observed("beyond_limit", "J{joint} beyond its angle limit")
GRIPPER_FAULT = Observed("gripper_fault", "Gripper: {fault}")
LIMITS_UNUSABLE = Observed(
    "limits_unusable", "J{joint}: the limits stored in the arm cannot be true"
)
OTHER_FRAMES = Observed("other_frames", "Another host sends {id}")
INVALID_FRAMES = Observed("invalid_frames", "Frames not understood: {kind} (last {id})")
FEWER_FRAMES = Observed(
    "fewer_frames", "Fewer status frames from the arm: {share} % less than before"
)

DRIVER_FAULTS: Final[Mapping[str, tuple[Item, Word]]] = {
    "Undervoltage": (Item.SUPPLY_VOLTAGE, Word.TOO_LOW),
    "MotorOvertemperature": (Item.MOTOR_TEMPERATURE, Word.TOO_HOT),
    "Overcurrent": (Item.DRIVER_CURRENT, Word.OVERCURRENT),
    "DriverOvertemperature": (Item.DRIVER_TEMPERATURE, Word.TOO_HOT),
    "DriverFault": (Item.DRIVER_FAULT, Word.ERROR),
    "SensorFault": (Item.SENSOR, Word.ABNORMAL),
    "CollisionProtection": (Item.COLLISION_PROTECTION, Word.TRIGGERED),
    "StallProtection": (Item.STALL_PROTECTION, Word.TRIGGERED),
}
"""The row of the table 关节状态 and the word for each fault bit of a driver."""

STATUS_LEVELS: Final[Mapping[int, Level]] = {
    ArmStatusCode.TEACHING_RECORDING: Level.INFO,
    ArmStatusCode.TEACHING_RUNNING: Level.INFO,
    ArmStatusCode.TEACHING_PAUSED: Level.INFO,
    **dict.fromkeys(TARGET_REFUSALS, Level.WARNING),
    ArmStatusCode.OVERSPEED_WHILE_TEACHING: Level.WARNING,
}
"""The severity of each status; any code not named here is a fault."""

_MODES: Final = (
    ("ControlMode", CONTROL_MODE, "mode", None),
    ("MoveMode", MOVE_MODE, "mode", 0),
    ("TeachingState", TEACHING, "state", 0),
)
"""For each mode: the signal, the event, the figure, and the first value not worth an event."""

_TOGETHER_S: Final = 0.3
"""Drivers report one after the other: reports within this time belong to one switching."""
_QUIET_S: Final = 2.0
"""Frames that pause for longer than this have ended."""
_TOLD_AGAIN_S: Final = 10.0
"""A lasting event is reported again once its count has doubled, or after this time."""
_FEWER: Final = 0.95
_AS_BEFORE: Final = 0.975
"""Shares of the best rate: below the first, fewer frames come; above the second, all again."""


@dataclass(slots=True)
class _Series:
    """A series of frames of one kind, counted as one event.

    Attributes:
        count: The number of frames.
        last_s: The time of the last one.
        told: The count that was last reported.
        told_s: The time of that report.
        since_s: The time of the first one.
    """

    count: int
    last_s: float
    told: int
    told_s: float
    since_s: float


class EventObserver:
    """Keeps the lasting events and reports their changes."""

    def __init__(self) -> None:
        self._modes: dict[str, float] = {}
        self._going_on: dict[Hashable, float] = {}
        self._enabled: dict[int, bool] = {}
        self._switched: tuple[bool, float, tuple[int, ...]] | None = None
        self._series: dict[Hashable, _Series] = {}
        self._best_hz = 0.0
        self._last_hz: float | None = None
        self._limits: tuple[object, ...] = ()
        self._traffic: OtherTraffic | None = None
        self._over_s: dict[int, float] = {}
        self._forgot_s = -math.inf
        self._silent_since_s: float | None = None

    def observe(
        self,
        noted: Sequence[StatusChange | InvalidFrames],
        state: ArmState,
        traffic: OtherTraffic,
        now_s: float,
    ) -> list[EventChange]:
        """Take in everything noted since the last call, and return the changes of events.

        Args:
            noted: The changes noted by :class:`StatusListener`.
            state: The arm as heard.
            traffic: The frames that other hosts were heard to send.
            now_s: Monotonic time.
        """
        changes: list[EventChange] = []
        for each in noted:
            if isinstance(each, InvalidFrames):
                changes += self._on_invalid(each)
            else:
                changes += self._on_heard(each)
        changes += self._on_limits(state)
        changes += self._on_traffic(traffic)
        if self._series:
            changes += self._end_series(now_s)
        return changes

    def forget(self, now_s: float) -> list[EventChange]:
        """Return the ends of all lasting events as not heard, because the arm is gone."""
        ended = [EventChange(EventPhase.ENDED, key, now_s, unheard=True) for key in self._going_on]
        self._going_on.clear()
        self._modes.clear()
        self._enabled.clear()
        self._switched = None
        self._best_hz, self._last_hz = 0.0, None
        self._limits = ()
        self._forgot_s, self._silent_since_s = now_s, None
        return ended

    # The arm's reports ------------------------------------------------------------------------

    def _on_heard(self, heard: StatusChange) -> Iterator[EventChange]:
        if heard.name == h.STATUS:
            yield from self._on_status(heard.values, heard.at_s)
        elif heard.name in h.DRIVERS:
            yield from self._on_driver(h.DRIVERS[heard.name], heard.values, heard.at_s)
        elif heard.name == h.GRIPPER:
            for fault in GripperFault:
                if fault.value in heard.values:
                    key, figures = ("gripper", fault), {"fault": fault.value}
                    change = _fault(key, heard.at_s, GRIPPER_FAULT, figures)
                    yield from self._follow(change, on=heard.values[fault.value] == 1)
        elif heard.name == h.GAP:
            yield from self._on_gap(heard.at_s)
        elif heard.name == h.RATE:
            yield from self._on_rate(heard.values["hz"], heard.at_s)

    def _on_gap(self, at_s: float) -> Iterator[EventChange]:
        """End everything but the status, which has lasted if it is the same after the gap."""
        lasting = {key: since_s for key, since_s in self._going_on.items() if _is_status(key)}
        ended = self.forget(at_s)
        yield from (each for each in ended if each.key not in lasting)
        self._going_on.update(lasting)
        self._silent_since_s = at_s

    def _on_status(self, values: Mapping[str, float], at_s: float) -> Iterator[EventChange]:
        for signal, observed, figure, plain in _MODES:
            mode, before = values[signal], self._modes.get(signal)
            if mode != before:
                self._modes[signal] = mode
                if before is not None or mode != plain:
                    codes = {figure: int(mode), "before": None if before is None else int(before)}
                    yield EventChange(EventPhase.HAPPENED, observed, at_s, observed, params=codes)
        status = int(values["Status"])
        for key in [key for key in self._going_on if _is_status(key, status)]:
            del self._going_on[key]
            silent_s = self._silent_since_s
            ended_s = at_s if silent_s is None else silent_s
            yield EventChange(EventPhase.ENDED, key, ended_s, unheard=silent_s is not None)
        self._silent_since_s = None
        if status != ArmStatusCode.NORMAL:
            level = STATUS_LEVELS.get(status, Level.FAULT)
            change = _fault(("status", status), at_s, ARM_STATUS, {"status": status}, level)
            yield from self._follow(change, on=True)
        motion = EventChange(EventPhase.BEGAN, "motion", at_s, MOTION)
        yield from self._follow(motion, on=values["MotionState"] != 0)
        for joint in JOINTS:
            broken = _joint_fault(joint, Item.COMMUNICATION, Word.ABNORMAL, at_s)
            yield from self._follow(broken, on=values.get(f"J{joint}CommunicationFault") == 1)
            beyond = _fault(
                ("beyond", joint),
                at_s,
                BEYOND_LIMIT,
                {"joint": joint},
                Level.WARNING,
            )
            yield from self._follow(beyond, on=values.get(f"J{joint}LimitExceeded") == 1)

    def _on_driver(
        self, joint: int, values: Mapping[str, float], at_s: float
    ) -> Iterator[EventChange]:
        for flag, (item, word) in DRIVER_FAULTS.items():
            if flag in values:
                fault = _joint_fault(joint, item, word, at_s)
                yield from self._follow(fault, on=values[flag] == 1)
        on = values["Enabled"] == 1
        if self._enabled.get(joint) is not on:
            self._enabled[joint] = on
            yield self._switch(joint, at_s, on=on)

    def _switch(self, joint: int, at_s: float, *, on: bool) -> EventChange:
        """Return the change of a motor that is switched; motors switched in a row are one event."""
        before = self._switched
        observed = MOTORS_ON if on else MOTORS_OFF
        if before is not None and before[0] is on and at_s - before[1] <= _TOGETHER_S:
            joints = tuple(sorted({*before[2], joint}))
            self._switched = on, before[1], joints
            return EventChange(EventPhase.GREW, "switched", at_s, params={"joints": joints})
        self._switched = on, at_s, (joint,)
        return EventChange(
            EventPhase.HAPPENED, "switched", at_s, observed, params={"joints": (joint,)}
        )

    def _on_rate(self, hz: float, at_s: float) -> Iterator[EventChange]:
        before_hz, self._last_hz = self._last_hz, hz
        if before_hz is None:
            return
        # After a pause of the computer frames come in a burst, which looks like a high rate: the
        # lower of two counts.
        self._best_hz = max(self._best_hz, min(before_hz, hz))
        share = (before_hz + hz) / 2 / self._best_hz
        going_on = "rate" in self._going_on
        if share < (_AS_BEFORE if going_on else _FEWER):
            missing = round(100 * (1.0 - share))
            figures = {"share": missing}
            change = _frames("rate", at_s, FEWER_FRAMES, figures)
            yield from self._follow(change, on=True)
        elif going_on:
            yield from self._end("rate", at_s)

    def _on_limits(self, state: ArmState) -> Iterator[EventChange]:
        if state.limits == self._limits:
            return
        self._limits = state.limits
        for joint, limits in enumerate(state.limits, start=1):
            if limits is not None and limits.at_s > self._forgot_s:
                unusable = _fault(
                    ("limits", joint),
                    limits.at_s,
                    LIMITS_UNUSABLE,
                    {"joint": joint},
                    Level.WARNING,
                )
                yield from self._follow(unusable, on=not plausible(limits.value))

    def _follow(self, change: EventChange, *, on: bool) -> Iterator[EventChange]:
        """Yield the beginning or the end of the event that a change is about, if that is new."""
        if on is (change.key in self._going_on):
            return
        if on:
            self._going_on[change.key] = change.at_s
            yield change
        else:
            yield from self._end(change.key, change.at_s)

    def _end(self, key: Hashable, at_s: float) -> Iterator[EventChange]:
        del self._going_on[key]
        yield EventChange(EventPhase.ENDED, key, at_s)

    # Series of frames -------------------------------------------------------------------------

    def _on_invalid(self, frames: InvalidFrames) -> Iterator[EventChange]:
        key = ("invalid", frames.sort)
        figures = {"kind": frames.sort, "id": f"0x{frames.arbitration_id:03X}"}
        begun = _frames(key, frames.first_s, INVALID_FRAMES, figures, count=frames.times)
        known = self._series.get(key)
        if known is not None and frames.first_s - known.last_s > _QUIET_S:
            yield self._ended(key, known)
            known = None
        count = frames.times if known is None else known.count + frames.times
        yield from self._grow(begun, count, frames.last_s)

    def _on_traffic(self, traffic: OtherTraffic) -> Iterator[EventChange]:
        if traffic is self._traffic:
            return
        self._traffic = traffic
        for arbitration_id, series in traffic.series.items():
            key = ("other", arbitration_id)
            known = self._series.get(key)
            if known is not None and known.since_s != series.since_s:
                yield self._ended(key, known)
                known = None
            if known is None and series.since_s <= self._over_s.get(arbitration_id, -math.inf):
                continue
            self._over_s[arbitration_id] = series.since_s if known is None else known.since_s
            begun = _frames(
                key,
                series.since_s,
                OTHER_FRAMES,
                {"id": f"0x{arbitration_id:03X}"},
                count=series.count,
            )
            if known is None or known.count != series.count:
                yield from self._grow(begun, series.count, series.last_s)

    def _grow(self, begun: EventChange, count: int, last_s: float) -> Iterator[EventChange]:
        """Yield the beginning of a series, and its count when that has doubled or is due."""
        known = self._series.get(begun.key)
        if known is None:
            self._series[begun.key] = _Series(count, last_s, count, last_s, begun.at_s)
            yield begun
            return
        known.count, known.last_s = count, last_s
        if count >= 2 * known.told or last_s - known.told_s >= _TOLD_AGAIN_S:
            known.told, known.told_s = count, last_s
            yield EventChange(EventPhase.GREW, begun.key, last_s, params=begun.params, count=count)

    def _end_series(self, now_s: float) -> Iterator[EventChange]:
        for key, known in list(self._series.items()):
            if now_s - known.last_s > _QUIET_S:
                yield self._ended(key, known)

    def _ended(self, key: Hashable, known: _Series) -> EventChange:
        del self._series[key]
        return EventChange(EventPhase.ENDED, key, known.last_s, count=known.count)


def _fault(
    key: Hashable,
    at_s: float,
    observed: Observed,
    params: Mapping[str, object],
    level: Level = Level.FAULT,
) -> EventChange:
    kind = EventKind.STATUS if level is Level.INFO else EventKind.FAULT
    return EventChange(EventPhase.BEGAN, key, at_s, observed, kind, Asker.ARM, level, params)


def _joint_fault(joint: int, item: Item, word: Word, at_s: float) -> EventChange:
    figures = {"joint": joint, "item": item.name, "word": word.name}
    return _fault((item, joint), at_s, JOINT_FAULT, figures)


def _frames(
    key: Hashable, at_s: float, observed: Observed, params: Mapping[str, object], *, count: int = 1
) -> EventChange:
    other = observed is OTHER_FRAMES
    level = Level.INFO if other else Level.WARNING
    kind = EventKind.OTHER_HOST if other else EventKind.ODDITY
    who = Asker.OTHER_HOST if other else Asker.ARM
    return EventChange(EventPhase.BEGAN, key, at_s, observed, kind, who, level, params, count)


def _is_status(key: Hashable, other_than: int = ArmStatusCode.NORMAL) -> bool:
    return isinstance(key, tuple) and key[0] == "status" and key[1] != other_than
