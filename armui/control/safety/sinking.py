"""Watches whether an arm that nothing holds, or that nothing told to move, is measured to: pure."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JOINTS
from armui.arm.state import FRESH_FOR_S
from armui.control.safety.standstill import RestWatch
from armui.control.safety.uncommanded_motion import MotionKind, UncommandedMotion, Unheld

if TYPE_CHECKING:
    from armui.arm.state import ArmState

ALL_JOINTS: Final = tuple(JOINTS)

SHOWN_AGAIN_S: Final = 0.25
"""Figures are shown anew this often, so that they can be read."""

_MOVED_DEG: Final = 0.2
"""A joint this far from where it stood has moved: more than a limp one trembles."""
_SAGGED_DEG: Final = 1.0
"""The limit for joints under power, which sag by half a degree under a new load and then hold."""
_REST_S: Final = 0.5
"""At rest is what has stood for this long: a slow creep would pass for rest in less."""
_WINDOW_S: Final = 0.3
"""The time over which the speed is measured."""
_SHORTEST_S: Final = 0.05
"""A speed is not computed over a shorter time: noise would outweigh the motion."""
_JUMP_DEG: Final = 2.0
_JUMP_DEG_S: Final = 400.0
"""A change of angle beyond `_JUMP_DEG` and this speed is no motion: the zeros have changed."""
_BY_WEIGHT: Final = frozenset(
    {Unheld.STOPPED, Unheld.MOTORS_OFF, Unheld.JOINTS_OFF, Unheld.NOT_TOLD}
)
"""The causes with which a way down means sinking; with others a motor or a hand may lead it."""
_SOON_S: Final = 10.0
_LATER_S: Final = 60.0
"""A silence is told in steps of 1 s up to the first of these times, of 5 s up to the second, then
of 60 s."""


@dataclass(frozen=True, slots=True)
class WatchedMotion:
    """The facts about the arm that the watch needs at a moment.

    Attributes:
        state: The arm as heard.
        now_s: Monotonic time.
        cause: Why it may move without a command; ``None`` while a command moves or motors hold it.
        joints: The joints (1–6) that this is about.
        heard: True while status and angles are heard.
        counted_anew: True while its angles may be about to be counted from other zeros.
    """

    state: ArmState
    now_s: float
    cause: Unheld | None
    joints: tuple[int, ...] = ALL_JOINTS
    heard: bool = True
    counted_anew: bool = False


@dataclass(frozen=True, slots=True)
class _Sample:
    at_s: float
    joints_deg: tuple[float, ...]


class SinkingWatch:
    """Compares the measured angles with where the arm last stood.

    Two samples that came in time are compared. No motion is taken to begin across a gap in the
    feedback.

    Args:
        height_mm: Returns the height of the lowest of flange, fingertip and held object at six
            angles.
        flange_mm: Returns the place of the flange at six angles.
        weight_mm: Returns the height of the arm's weight at six angles, near enough to tell whether
            it comes down.
        below: Returns the names of what is below the arm; "" for nothing.

    Attributes:
        motion: What is seen, as it is to be shown; ``None``: held, or measured at rest.
        ended: The whole of the motion that has ended since it was taken from here, and whether it
            ended at rest; otherwise motors hold the arm, or a command moves it.
    """

    def __init__(
        self,
        height_mm: Callable[[Sequence[float]], float],
        flange_mm: Callable[[Sequence[float]], Sequence[float]],
        weight_mm: Callable[[Sequence[float]], float],
        below: Callable[[], str],
    ) -> None:
        self._height_mm = height_mm
        self._flange_mm = flange_mm
        self._weight_mm = weight_mm
        self._below = below
        self._rest = RestWatch(for_s=_REST_S)
        self.reset()

    def reset(self) -> None:
        """Forget the arm."""
        self.motion: UncommandedMotion | None = None
        self.ended: tuple[UncommandedMotion, bool] | None = None
        self._samples: deque[_Sample] = deque()
        self._arrival: tuple[int, int] | None = None
        self._cause: Unheld | None = None
        self._joints = ALL_JOINTS
        self._anchor_deg: tuple[float, ...] | None = None
        self._has_rested = False
        self._since_s: float | None = None
        self._shown_s = -math.inf
        self._unheard = False
        self._last_mm_s: int | None = None
        self._rest.reset()

    def observe(self, watched: WatchedMotion) -> None:
        """Take in the present facts and the newest angles."""
        if not watched.heard:
            self._show_unheard(watched.now_s)
            return
        # heard again: what the arm did meanwhile is not known, so the watch starts anew
        if self._unheard:
            self.reset()
        fresh = self._take_sample(watched)
        if watched.cause is None:
            self._let_rest(watched)
            return
        if self._cause is None:
            self._count_from_here()
        self._cause, self._joints = watched.cause, watched.joints
        self._judge(watched, fresh=fresh)

    # Samples ----------------------------------------------------------------------------------

    def _take_sample(self, watched: WatchedMotion) -> bool:
        """Keep the newest angles; return whether they are new and follow the last ones in time."""
        state = watched.state
        angles_deg = state.angles_deg()
        at_s = min((each.at_s for each in state.joints_deg if each is not None), default=0.0)
        samples, last = self._samples, self._samples[-1] if self._samples else None
        if angles_deg is None or (last is not None and at_s <= last.at_s):
            return False
        sample = _Sample(at_s, angles_deg)
        arrival, self._arrival = self._arrival, (state.epoch, state.pauses)
        late = last is None or arrival != self._arrival or at_s - last.at_s > FRESH_FOR_S
        if late or watched.counted_anew or _jumped(last, sample):
            samples.clear()
            if self._since_s is None:
                self._anchor_deg, self._has_rested = None, False
            elif last is not None and not late:
                self._shift_anchor(last, sample)
        samples.append(sample)
        while len(samples) > 2 and samples[1].at_s <= at_s - _WINDOW_S:
            samples.popleft()
        if self._anchor_deg is None:
            self._anchor_deg = angles_deg
        self._rest.observe(self._of_joints(watched), watched.now_s)
        return len(samples) > 1

    def _shift_anchor(self, last: _Sample, sample: _Sample) -> None:
        """Move the anchor by the jump of the angles, as they are counted from other zeros now."""
        if self._anchor_deg is not None:
            pairs = zip(self._anchor_deg, last.joints_deg, sample.joints_deg, strict=True)
            self._anchor_deg = tuple(anchor + new - old for anchor, old, new in pairs)

    def _of_joints(self, watched: WatchedMotion) -> ArmState:
        """Return the state with the joints that are not watched fixed at the anchor."""
        state, anchor_deg = watched.state, self._anchor_deg
        if anchor_deg is None or len(watched.joints) == len(JOINTS):
            return state
        a, b, c, d, e, f = (
            each if each is None or joint in watched.joints else replace(each, value=anchor)
            for joint, each, anchor in zip(JOINTS, state.joints_deg, anchor_deg, strict=True)
        )
        return state._replace(joints_deg=(a, b, c, d, e, f))

    # Evaluation -------------------------------------------------------------------------------

    def _let_rest(self, watched: WatchedMotion) -> None:
        """Make the present angles the anchor: the arm is held, or moved by a command."""
        self._end(watched.now_s, at_rest=False)
        self._cause, self._joints = None, watched.joints
        self._count_from_here()

    def _count_from_here(self) -> None:
        if self._samples:
            self._anchor_deg = self._samples[-1].joints_deg
        self._has_rested = self._rest.at_rest

    def _judge(self, watched: WatchedMotion, *, fresh: bool) -> None:
        if not self._samples or self._anchor_deg is None:
            return
        newest = self._samples[-1]
        if self._since_s is not None and self._rest.at_rest:
            self._end(watched.now_s - _REST_S, at_rest=True)
            self._count_from_here()
        if self._since_s is None:
            at_rest = self._rest.at_rest
            self._has_rested = self._has_rested or at_rest
            if fresh and not at_rest and self._turned(newest)[1] > self._threshold_deg:
                self._since_s, self._shown_s = watched.now_s, -math.inf
            elif not self._has_rested and watched.cause is not Unheld.NOT_TOLD:
                self.motion = UncommandedMotion(MotionKind.UNMEASURED, watched.cause)
            else:
                self.motion = None
        due = watched.now_s - self._shown_s >= SHOWN_AGAIN_S
        if self._since_s is not None and due and (pace := self._pace()) is not None:
            self._shown_s = watched.now_s
            self._show(newest, watched.now_s - self._since_s, pace)

    @property
    def _threshold_deg(self) -> float:
        return _SAGGED_DEG if self._cause is Unheld.NOT_TOLD else _MOVED_DEG

    def _turned(self, newest: _Sample) -> tuple[int, float]:
        """Return the joint that is furthest from where it stood, and how far in degrees."""
        anchor_deg = self._anchor_deg or newest.joints_deg
        return max(
            ((joint, abs(newest.joints_deg[joint - 1] - anchor_deg[joint - 1]))
             for joint in self._joints),
            key=lambda each: each[1],
        )  # fmt: skip

    def _show(self, newest: _Sample, since_s: float, pace: tuple[float, bool]) -> None:
        whole = self._measured(newest, since_s)
        speed_mm_s, leads_down = pace
        if self._cause is Unheld.LED:
            kind = MotionKind.LED
        elif leads_down and self._cause in _BY_WEIGHT:
            kind = MotionKind.SINKS
        else:
            kind = MotionKind.MOVES
        below = self._below() if kind is MotionKind.SINKS else ""
        self.motion = replace(whole, kind=kind, speed_mm_s=round(speed_mm_s), below=below)

    def _measured(self, newest: _Sample, since_s: float) -> UncommandedMotion:
        """Return the motion as measured from the anchor to a sample."""
        anchor_deg = self._anchor_deg or newest.joints_deg
        down_mm = self._height_mm(anchor_deg) - self._height_mm(self._alone(newest))
        joint, turned_deg = self._turned(newest)
        kind = MotionKind.MOVES if self.motion is None else self.motion.kind
        return UncommandedMotion(
            kind,
            self._cause,
            max(0, round(since_s)),
            max(0, round(down_mm)),
            joint,
            round(turned_deg, 1),
        )

    def _end(self, ended_s: float, *, at_rest: bool) -> None:
        """End the motion under way, if any, and keep its whole in :attr:`ended`."""
        if self._since_s is not None and self.motion is not None and self._samples:
            whole = self._measured(self._samples[-1], ended_s - self._since_s)
            self.ended = whole, at_rest
        self._since_s = self.motion = None

    def _pace(self) -> tuple[float, bool] | None:
        """Return the speed of the flange in mm/s, and whether the arm's weight comes down.

        ``None``: too little was measured. The hand may swing up where forearm and upper arm sink.
        """
        if len(self._samples) < 2:
            return None
        first, newest = self._samples[0], self._samples[-1]
        passed_s = newest.at_s - first.at_s
        if passed_s < _SHORTEST_S:
            return None
        before_deg, now_deg = self._alone(first), self._alone(newest)
        way_mm = math.dist(self._flange_mm(before_deg), self._flange_mm(now_deg))
        return way_mm / passed_s, self._weight_mm(now_deg) < self._weight_mm(before_deg)

    def _alone(self, sample: _Sample) -> tuple[float, ...]:
        """Return the angles with the joints that are not watched at the anchor."""
        if len(self._joints) == len(JOINTS) or self._anchor_deg is None:
            return sample.joints_deg
        return tuple(
            angle if joint in self._joints else anchor
            for joint, angle, anchor in zip(
                JOINTS, sample.joints_deg, self._anchor_deg, strict=True
            )
        )

    def _show_unheard(self, now_s: float) -> None:
        """Show an arm that is not heard as it was last measured; nothing of one never heard."""
        if not self._samples:
            return
        if not self._unheard:
            self._unheard, self._joints = True, ALL_JOINTS
            pace = self._pace()
            moved_mm_s = None if pace is None else round(pace[0]) or None
            self._last_mm_s = 0 if self._rest.at_rest else moved_mm_s
        since_s = now_s - self._samples[-1].at_s
        step_s = 1 if since_s < _SOON_S else 5 if since_s < _LATER_S else 60
        seconds = max(1, int(since_s / step_s) * step_s)
        self.motion = UncommandedMotion(
            MotionKind.UNHEARD, seconds=seconds, speed_mm_s=self._last_mm_s
        )


def _jumped(before: _Sample | None, after: _Sample) -> bool:
    if before is None:
        return False
    most_deg = _JUMP_DEG + _JUMP_DEG_S * (after.at_s - before.at_s)
    return any(
        abs(a - b) > most_deg for a, b in zip(before.joints_deg, after.joints_deg, strict=True)
    )
