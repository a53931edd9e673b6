"""Detects from recorded traffic which generation an arm speaks."""

from __future__ import annotations

import statistics
from typing import NamedTuple

from armui.protocol.codec import Codec
from armui.protocol.firmware_version import LONGEST, VERSION_ID, find_version, is_question
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.system.sentence import Told

_CLEAR_LEAD = 20
"""The lead in frames of one generation over the other that leaves no doubt."""
_CYCLIC_IDS = (0x2A1, 0x2A5, 0x251)
_PERIOD_SAMPLES = 200
_LONGEST_PERIOD_S = 1.0
"""A longer interval was a pause, or comes from meaningless times."""
_PERIOD_BORDER_S = 0.012
"""The border between the 5 ms of generation 2's feedback and the 20 ms of generation 1's."""


class GenerationVerdict(NamedTuple):
    """The generation that the traffic indicates.

    Attributes:
        generation: The generation to decode with.
        reason: The reason, as the end of a sentence that begins "generation N, because".
    """

    generation: Generation
    reason: str


class GenerationDetector:
    """Collects evidence frame by frame, in constant memory.

    Strongest is the firmware version of 0x4AF, which only generation 2 sends. Next come frames that
    one generation would send and the other would not: unknown identifiers, codes outside its
    tables, reserved bits, other lengths. Last the period of the cyclic feedback.
    """

    def __init__(self) -> None:
        self._codecs = {generation: Codec(generation) for generation in Generation}
        self._votes = dict.fromkeys(Generation, 0)
        self._version_tail = b""
        self._version = ""
        self._last_seen_s: dict[int, float] = {}
        self._intervals_s: list[float] = []

    @property
    def certain(self) -> bool:
        """True if more frames are very unlikely to change the verdict."""
        one, two = self._votes.values()
        return bool(self._version) or abs(one - two) >= _CLEAR_LEAD

    @property
    def has_evidence(self) -> bool:
        """True if the frames so far indicate one of the generations."""
        one, two = self._votes.values()
        return bool(self._version) or one != two or bool(self._intervals_s)

    def feed(self, frame: Frame, time_s: float) -> None:
        """Adds the evidence of one data frame with an 11-bit identifier.

        Args:
            frame: The frame.
            time_s: The time of recording; only differences matter.
        """
        if frame.arbitration_id == VERSION_ID:
            self._feed_version(frame.data)
            return
        exact = [codec.generation for codec in self._codecs.values() if codec.is_exact(frame)]
        if len(exact) == 1:
            self._votes[exact[0]] += 1
        self._feed_period(frame.arbitration_id, time_s)

    def verdict(self) -> GenerationVerdict:
        """Return the generation that the frames so far indicate; generation 2 without evidence."""
        if self._version:
            why = Told("the arm named its firmware {version}", version=self._version)
            return GenerationVerdict(Generation.TWO, why)
        one, two = self._votes[Generation.ONE], self._votes[Generation.TWO]
        if one != two:
            winner = Generation.TWO if two > one else Generation.ONE
            return GenerationVerdict(
                winner,
                Told(
                    "frames that fit only this generation: {this}, only the other: {other}",
                    this=max(one, two),
                    other=min(one, two),
                ),
            )
        if self._intervals_s:
            period_s = statistics.median(self._intervals_s)
            winner = Generation.TWO if period_s < _PERIOD_BORDER_S else Generation.ONE
            why = Told("the feedback comes every {period:.1f} ms", period=period_s * 1000)
            return GenerationVerdict(winner, why)
        why = Told("nothing tells, and arms in use today speak it")
        return GenerationVerdict(Generation.TWO, why)

    def _feed_version(self, payload: bytes) -> None:
        if is_question(payload):
            return
        self._version_tail = (self._version_tail + payload)[-LONGEST - 8 :]
        self._version = find_version(self._version_tail) or self._version

    def _feed_period(self, arbitration_id: int, time_s: float) -> None:
        if arbitration_id not in _CYCLIC_IDS or len(self._intervals_s) >= _PERIOD_SAMPLES:
            return
        before_s = self._last_seen_s.get(arbitration_id)
        if before_s is not None and 0.0 < time_s - before_s < _LONGEST_PERIOD_S:
            self._intervals_s.append(time_s - before_s)
        self._last_seen_s[arbitration_id] = time_s
