"""Records the frames that other hosts on the bus send: their identifiers, times and rates.

A frame that this program did not send and that no arm sends as feedback comes from another host, or
from a leader arm (0x470). The bus thread passes raw frames, so that frames no codec understands
count as well.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Final

from armui.protocol.addressing import OFFSETS

_MOTION_BASE: Final = range(0x150, 0x160)
_SPEEDS_AND_POSITIONS: Final = range(0x181, 0x188)
_CHANGES: Final = (0x470, 0x471, 0x475)
MOTION_IDS: Final = frozenset(
    {base + offset for base in _MOTION_BASE for offset in OFFSETS}
    | {*_SPEEDS_AND_POSITIONS, *_CHANGES}
)
"""Frames that move an arm, switch its motors, or change settings that its motions depend on."""

_ANSWER: Final = 0x61
"""0x181–0x187 byte 0, 'a': the arm answers with the identifier it was asked with."""

OTHER_COMMAND_IDS: Final = frozenset(
    {0x121, 0x191, 0x422, 0x472, 0x474, 0x477, 0x479, 0x47A, 0x47D, 0x487}
)
"""Lamps, questions and settings: they are shown, and forbid nothing."""

_MODE: Final = 0x151
_MIT: Final = range(0x15A, 0x160)
_LEADER: Final = (0x151, 0x155, 0x156, 0x157, 0x159)
"""The frames a teaching-input arm sends, in lockstep (0x470)."""

_FORGOTTEN_S: Final = 2.0
"""A longer pause between frames of one identifier begins a new series."""
_LEADER_RATE_HZ: Final = 20.0
"""A leader arm sends its commands evenly and at least so often; another host need not."""
_LOCKSTEP: Final = 3
"""The counts of a leader's identifiers may differ by this much: one cycle under way, frames lost.
"""

_NOTHING: Final[Mapping[int, FrameSeries]] = MappingProxyType({})


def is_arms_answer(arbitration_id: int, data: bytes) -> bool:
    """Return whether a frame with a command's identifier is the arm's own answer (CPV)."""
    return arbitration_id in _SPEEDS_AND_POSITIONS and data[:1] == bytes((_ANSWER,))


@dataclass(frozen=True, slots=True)
class FrameSeries:
    """Frames of one identifier that another host sends.

    Attributes:
        arbitration_id: The identifier on the wire.
        count: The number of frames without a pause of more than two seconds.
        since_s, last_s: Monotonic time of the first and the last of them.
        data: The last payload.
    """

    arbitration_id: int
    count: int
    since_s: float
    last_s: float
    data: bytes

    @property
    def rate_hz(self) -> float:
        """The frames per second; 0 for a single frame."""
        span_s = self.last_s - self.since_s
        return (self.count - 1) / span_s if span_s > 0.0 else 0.0

    def joined(self, more: FrameSeries) -> FrameSeries:
        """Return this series merged with another one of the same identifier."""
        newer, older = (more, self) if more.last_s >= self.last_s else (self, more)
        if newer.since_s - older.last_s > _FORGOTTEN_S:
            return newer
        since_s = min(self.since_s, more.since_s)
        count = self.count + more.count
        return FrameSeries(self.arbitration_id, count, since_s, newer.last_s, newer.data)


@dataclass(frozen=True, slots=True)
class OtherTraffic:
    """A frozen snapshot of the frames that other hosts were heard to send.

    Attributes:
        series: The series by identifier on the wire.
    """

    series: Mapping[int, FrameSeries] = field(default_factory=lambda: _NOTHING)

    def motion(self, offsets: tuple[int, ...]) -> tuple[FrameSeries, ...]:
        """Return the motion commands to an arm with these control offsets, by identifier.

        0x470 sets the offsets.
        """
        mine = {base + offset for base in _MOTION_BASE for offset in offsets}
        mine.update(_SPEEDS_AND_POSITIONS, _CHANGES)
        return tuple(self.series[each] for each in sorted(self.series) if each in mine)

    def mode_word(self, offsets: tuple[int, ...]) -> FrameSeries | None:
        """Return the newest 0x151 of another host."""
        return self._newest(_MODE + offset for offset in offsets)

    def mit_frames(self, offsets: tuple[int, ...]) -> FrameSeries | None:
        """Return the newest joint setpoint in MIT mode (0x15A–0x15F) of another host."""
        return self._newest(base + offset for base in _MIT for offset in offsets)

    def cpv_frames(self) -> FrameSeries | None:
        """Return the newest setpoint in CPV mode (0x181–0x187) of another host."""
        return self._newest(_SPEEDS_AND_POSITIONS)

    def leads(self, offsets: tuple[int, ...]) -> bool:
        """Return whether these are frames of a leader arm (0x470), or of a program like one.

        A leader sends 0x151, its joint angles and its gripper in lockstep, and nothing else.
        """
        for offset in offsets:
            wanted = {each + offset for each in _LEADER}
            series = self.motion((offset,))
            counts = [each.count for each in series]
            if {each.arbitration_id for each in series} != wanted:
                continue
            even = max(counts) - min(counts) <= _LOCKSTEP
            if even and min(each.rate_hz for each in series) >= _LEADER_RATE_HZ:
                return True
        return False

    def joined(self, more: OtherTraffic) -> OtherTraffic:
        """Return this and other traffic merged, as if one host had sent both."""
        if not more.series:
            return self
        series = dict(self.series)
        for arbitration_id, each in more.series.items():
            known = series.get(arbitration_id)
            series[arbitration_id] = each if known is None else known.joined(each)
        return OtherTraffic(MappingProxyType(series))

    def _newest(self, identifiers: Iterable[int]) -> FrameSeries | None:
        known = [self.series[each] for each in identifiers if each in self.series]
        return max(known, key=lambda each: each.last_s, default=None)


class OtherHosts:
    """Counts the frames of other hosts; used by the bus thread, its snapshots by any thread."""

    def __init__(self) -> None:
        self._series: dict[int, FrameSeries] = {}
        self._traffic = OtherTraffic()
        self._changed = False

    def note(self, arbitration_id: int, data: bytes, at_s: float) -> None:
        """Count a frame that this program did not send, received at a monotonic time."""
        if arbitration_id not in MOTION_IDS and arbitration_id not in OTHER_COMMAND_IDS:
            return
        if is_arms_answer(arbitration_id, data):
            return
        before = self._series.get(arbitration_id)
        if before is None or at_s - before.last_s > _FORGOTTEN_S:
            series = FrameSeries(arbitration_id, 1, at_s, at_s, data)
        else:
            series = FrameSeries(arbitration_id, before.count + 1, before.since_s, at_s, data)
        self._series[arbitration_id] = series
        self._changed = True

    def traffic(self) -> OtherTraffic:
        """Return the traffic up to now; the same object as before if nothing new was heard."""
        if self._changed:
            self._changed = False
            self._traffic = OtherTraffic(MappingProxyType(dict(self._series)))
        return self._traffic
