"""Loses, delays and adds frames between host and arm, as a faulty cable does; no bus, no clock."""

from __future__ import annotations

import random
from collections import Counter, deque
from collections.abc import Collection, Iterable

from armui.protocol.frame import Frame

_STANDARD_IDS = 0x800
_LONGEST = 8


class FaultyLink:
    """Passes the frames to and from one arm, with the faults that are set.

    Attributes:
        off: The controller is bus-off: it neither receives nor sends.
        deaf: The host's adapter hands over nothing of what the arm sends.
        loss: Share of the frames lost in each direction, 0–1.
        latency_s: The delay of frames in each direction.
        garbage_per_s: Frames a second that nobody sent, with random identifiers and content.
        deaf_to: Arbitration IDs whose frames do not reach the arm.
        mute_on: Arbitration IDs whose frames from the arm do not reach the bus.
    """

    def __init__(self, seed: int = 0) -> None:
        self.off = False
        self.deaf = False
        self.loss = 0.0
        self.latency_s = 0.0
        self.garbage_per_s = 0.0
        self.deaf_to: set[int] = set()
        self.mute_on: set[int] = set()
        self._lost_to_arm: Counter[int] = Counter()
        self._lost_to_bus: Counter[int] = Counter()
        self._chance = random.Random(seed)  # noqa: S311 - the same seed gives the same faults
        self._coming: deque[tuple[float, Frame]] = deque()
        self._going: deque[tuple[float, Frame]] = deque()
        self._garbage_due = 0.0

    def lose_to_arm(self, arbitration_id: int, count: int = 1) -> None:
        """Loses the next frames of one identifier on their way to the arm."""
        self._lost_to_arm[arbitration_id] += count

    def lose_to_bus(self, arbitration_id: int, count: int = 1) -> None:
        """Loses the next frames of one identifier that the arm sends."""
        self._lost_to_bus[arbitration_id] += count

    def to_arm(self, frames: list[Frame], now_s: float) -> list[Frame]:
        """Return the frames that reach the arm now, from the new ones and the delayed ones."""
        if self.off:
            self._coming.clear()
            return []
        kept = self._kept(_without(frames, self.deaf_to, self._lost_to_arm))
        return self._delayed(self._coming, kept, now_s)

    def to_bus(self, frames: list[Frame], now_s: float, dt_s: float) -> tuple[list[Frame], int]:
        """Return the frames that reach the bus now, and the number of lost ones.

        Args:
            frames: The frames sent by the arm.
            now_s: The arm's time.
            dt_s: The time that has passed, for the garbage.
        """
        if self.off or self.deaf:
            lost = len(frames) + len(self._going)
            self._going.clear()
            return [], lost
        kept = self._kept(_without(frames, self.mute_on, self._lost_to_bus))
        lost = len(frames) - len(kept)
        return self._delayed(self._going, kept, now_s) + self._garbage(dt_s), lost

    def _kept(self, frames: list[Frame]) -> list[Frame]:
        if not self.loss:
            return frames
        return [frame for frame in frames if self._chance.random() >= self.loss]

    def _delayed(
        self, under_way: deque[tuple[float, Frame]], frames: Iterable[Frame], now_s: float
    ) -> list[Frame]:
        if not (self.latency_s or under_way):
            return list(frames)
        under_way.extend((now_s + self.latency_s, frame) for frame in frames)
        arrived: list[Frame] = []
        while under_way and under_way[0][0] <= now_s:
            arrived.append(under_way.popleft()[1])
        return arrived

    def _garbage(self, dt_s: float) -> list[Frame]:
        if not self.garbage_per_s:
            return []
        self._garbage_due += self.garbage_per_s * dt_s
        count = int(self._garbage_due)
        self._garbage_due -= count
        chance = self._chance
        return [
            Frame(chance.randrange(_STANDARD_IDS), chance.randbytes(chance.randint(0, _LONGEST)))
            for _ in range(count)
        ]


def _without(frames: list[Frame], never: Collection[int], lost: Counter[int]) -> list[Frame]:
    """Return the frames that are not lost; `lost` counts down the ones to lose, by identifier."""
    if not (never or lost):
        return frames
    kept: list[Frame] = []
    for frame in frames:
        arbitration_id = frame.arbitration_id
        if lost[arbitration_id] > 0:
            lost[arbitration_id] -= 1
        elif arbitration_id not in never:
            kept.append(frame)
    for arbitration_id in [each for each, count in lost.items() if count <= 0]:
        del lost[arbitration_id]
    return kept
