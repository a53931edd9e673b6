"""Watches for a joint that leaves its place uncommanded while it is enabled: pure (S34).

Such an excursion is how an arm that loses its reference shows it: afterwards the joint stands up to
85° from what it reports, and nothing in the feedback tells.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from armui.arm.arrivals import Arrivals
from armui.arm.limits import JOINTS
from armui.protocol.codec import Message
from armui.telemetry.listener import Listener, ReceivedFrame

LEFT_DEG: Final = 5.0
"""A joint measured farther than this from where it belongs has left its place."""
EXEMPT_S: Final = 1.0
"""For this long after a stop, a silence, a foreign motion and the like nothing is judged."""
_LATER_S: Final = 0.2
"""A driver's report this long after the excursion shows whether the joint was enabled."""
_UNTOLD_S: Final = 2.0
"""Without such a report within this time nothing is concluded."""
_FASTER: Final = 1.5
"""A joint that is this many times faster than its top speed does not move: it jumps."""
_MOST_WAITING: Final = 8192
"""Reports kept until they are judged: 13 s of an arm that reports at 200 Hz."""
_PAIRS: Final = {"JointFeedback12": 1, "JointFeedback34": 3, "JointFeedback56": 5}


@dataclass(frozen=True, slots=True)
class AngleReport:
    """One reported angle.

    Attributes:
        at_s: When its frame was received.
        joint: The joint (1–6).
        angle_deg: Its angle.
        in_time: False if it, or the one before it, was late in arriving: how the joint came there
            from where it was reported before is not known.
    """

    at_s: float
    joint: int
    angle_deg: float
    in_time: bool = True


class AngleListener(Listener):
    """Keeps every reported angle, so that none is missed between two looks of the controller."""

    def __init__(self) -> None:
        self._reports: deque[tuple[float, int, float, float, bool]] = deque(maxlen=_MOST_WAITING)
        self._arrivals = {first: Arrivals() for first in _PAIRS.values()}

    def on_heard(self, batch: Sequence[ReceivedFrame]) -> None:
        """Keep the angles in a batch of frames; called by the bus thread."""
        for heard, at_s, _frame, _flags in batch:
            if isinstance(heard, Message) and (first := _PAIRS.get(heard.name)) is not None:
                signals = heard.signals
                pair = signals[f"J{first}"], signals[f"J{first + 1}"]
                self._reports.append((at_s, first, *pair, self._arrivals[first].note(at_s)))

    def take_reports(self) -> list[AngleReport]:
        """Return the angles reported since the last call."""
        taken = []
        while self._reports:
            at_s, first, one, other, in_time = self._reports.popleft()
            taken.append(AngleReport(at_s, first, one, in_time))
            taken.append(AngleReport(at_s, first + 1, other, in_time))
        return taken


@dataclass(frozen=True, slots=True)
class WatchedArm:
    """The state that the watch judges the angles by.

    Attributes:
        now_s: Monotonic time.
        exempt: Something is under way, or was a moment ago, that moves joints without a command.
        commanded: A motion of ours is under way.
        target_deg: Its six target angles; ``None`` if they are not known, as of a pose.
        at_rest: The joints are measured to stand still, and no motion of ours is on its way.
        enabled: Of each joint whether its driver reports it enabled, and when it said so last.
        top_speed_deg_s: The highest speed of each joint.
    """

    now_s: float
    exempt: bool
    commanded: bool
    target_deg: Sequence[float] | None
    at_rest: bool
    enabled: Sequence[tuple[bool, float] | None]
    top_speed_deg_s: Sequence[float]


@dataclass(frozen=True, slots=True)
class Excursion:
    """A joint that left its place.

    Attributes:
        joint: The joint (1–6).
        place_deg: The angle at which it should have stayed.
        farthest_deg: The angle farthest from there that was reported.
    """

    joint: int
    place_deg: float
    farthest_deg: float


@dataclass(slots=True)
class _Suspicion:
    since_s: float
    place_deg: float
    farthest_deg: float


class _Joint:
    """The allowed range of one joint: from where it stood to every target sent since."""

    def __init__(self) -> None:
        self.between: tuple[float, float] | None = None
        self.last: tuple[float, float] | None = None
        self.suspicion: _Suspicion | None = None

    def exempt(self) -> None:
        self.between = self.last = self.suspicion = None

    def extend(self, target_deg: float | None) -> None:
        if target_deg is None:
            self.between = None
        elif self.between is not None:
            low, high = self.between
            self.between = min(low, target_deg), max(high, target_deg)

    def settle(self) -> None:
        """Take the joint's angle, clipped to its allowed range, as its new place."""
        if self.last is None or self.suspicion is not None:
            return
        angle = self.last[1]
        if self.between is not None:
            angle = min(max(angle, self.between[0]), self.between[1])
        self.between = angle, angle

    def report(self, report: AngleReport, top_speed_deg_s: float) -> None:
        at_s, angle_deg = report.at_s, report.angle_deg
        before, self.last = self.last, (at_s, angle_deg)
        if before is None or not report.in_time:
            # A first or late report is no evidence of a jump; the next one is compared with it.
            return
        place_deg = before[1]
        since_s = max(0.0, at_s - before[0])
        reach_deg = LEFT_DEG + _FASTER * top_speed_deg_s * since_s
        jumps = abs(angle_deg - before[1]) > reach_deg
        left = False
        if self.between is not None:
            low, high = self.between
            place_deg = min(max(place_deg, low), high)
            left = not low - LEFT_DEG <= angle_deg <= high + LEFT_DEG
        doubt = self.suspicion
        if doubt is not None:
            if abs(angle_deg - doubt.place_deg) > abs(doubt.farthest_deg - doubt.place_deg):
                doubt.farthest_deg = angle_deg
        elif jumps or left:
            self.suspicion = _Suspicion(at_s, place_deg, angle_deg)


class ReferenceWatch:
    """Judges the reported angles of one arm."""

    def __init__(self) -> None:
        self._exempt_until_s = -math.inf
        self._joints = {joint: _Joint() for joint in JOINTS}

    def reset(self, now_s: float) -> None:
        """Begin anew with another arm or connection."""
        self._exempt_until_s = now_s + EXEMPT_S
        for each in self._joints.values():
            each.exempt()

    def observe(self, arm: WatchedArm, reports: Sequence[AngleReport]) -> tuple[Excursion, ...]:
        """Take in what was reported; return the joints that have left their place.

        Args:
            arm: The facts about the arm beside the angles.
            reports: Every angle reported since the last call, in order.
        """
        if arm.exempt:
            self._exempt_until_s = arm.now_s + EXEMPT_S
        if arm.now_s < self._exempt_until_s:
            for each in self._joints.values():
                each.exempt()
            return ()
        if arm.commanded:
            for joint, watched in self._joints.items():
                watched.extend(None if arm.target_deg is None else arm.target_deg[joint - 1])
        for report in reports:
            top_deg_s = arm.top_speed_deg_s[report.joint - 1]
            self._joints[report.joint].report(report, top_deg_s)
        found = [self._confirm(joint, arm) for joint in JOINTS]
        if arm.at_rest:
            for watched in self._joints.values():
                watched.settle()
        return tuple(each for each in found if each is not None)

    def _confirm(self, joint: int, arm: WatchedArm) -> Excursion | None:
        """Return the excursion of a joint once a later report says that it is still enabled."""
        watched, enabled = self._joints[joint], arm.enabled[joint - 1]
        if enabled is None or not enabled[0]:
            watched.exempt()
            return None
        doubt = watched.suspicion
        if doubt is None:
            return None
        if enabled[1] - doubt.since_s < _LATER_S:
            if arm.now_s - doubt.since_s > _UNTOLD_S:
                watched.exempt()
            return None
        watched.suspicion = watched.between = None
        return Excursion(joint, doubt.place_deg, doubt.farthest_deg)
