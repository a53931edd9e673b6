"""Joint angles as they arrive, for recording without gaps: a bounded ring between two threads."""

from __future__ import annotations

from collections import deque
from typing import Final, NamedTuple

from armui.arm.state import ArmState

CAPACITY: Final = 4096
"""Twenty seconds at 200 Hz; the GUI thread empties it thirty times a second."""


class Sample(NamedTuple):
    """The joint angles and the gripper's opening at one time.

    Attributes:
        at_s: Monotonic time of reception.
        joints_deg: Six joint angles.
        gripper_mm: The gripper's opening; ``None`` if the arm reports none.
    """

    at_s: float
    joints_deg: tuple[float, ...]
    gripper_mm: float | None


class SampleRing:
    """Filled by the bus thread while samples are wanted, emptied by the GUI thread.

    Attributes:
        wanted: True if samples are kept.
        dropped: The number of samples lost because nobody took them.
    """

    def __init__(self) -> None:
        self._samples: deque[Sample] = deque(maxlen=CAPACITY)
        self.wanted = False
        self.dropped = 0

    def put(self, state: ArmState, at_s: float) -> None:
        """Add a sample, if all six angles are known."""
        joints_deg = state.angles_deg()
        if joints_deg is None:
            return
        gripper = state.gripper
        if len(self._samples) == self._samples.maxlen:
            self.dropped += 1
        opening_mm = None if gripper is None else gripper.value.opening_mm
        self._samples.append(Sample(at_s, joints_deg, opening_mm))

    def take_samples(self) -> list[Sample]:
        """Return the samples since the last call, and remove them."""
        taken = []
        while self._samples:
            taken.append(self._samples.popleft())
        return taken
