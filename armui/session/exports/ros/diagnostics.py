"""The status of the arm, its joints and its gripper as `diagnostic_msgs/DiagnosticArray`.

A message is written at each change of a code or a fault, and one with everything every second.
"""

from __future__ import annotations

import math
import re
from collections import defaultdict
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.arm.limits import JOINTS
from armui.protocol.codes import AT_WORK
from armui.protocol.signal_columns import bit_mask
from armui.session.exports.ros.cdr import CdrWriter
from armui.session.exports.ros.streams import TimedMessages, nanoseconds
from armui.telemetry.quantities import DRIVER_FAULTS, GRIPPER_FAULTS

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from armui.protocol.codec import Codec
    from armui.protocol.layout import MessageLayout, SignalLayout
    from armui.session.exports.history import ArmFrames, ExportFacts, History, TimeSpan

OK, WARN, ERROR, STALE = range(4)
"""Levels of a status."""
_STATUS: Final = "ArmStatus"
_GRIPPER: Final = "GripperFeedback"
_COUNTERS: Final = frozenset({"SpeedPercent", "TrajectoryPoint"})
"""Signals that change all the time, which does not count as a change."""
_SILENT: Final = "Not heard for half a second"


@dataclass(frozen=True, slots=True)
class _Part:
    """Something that has a status of its own.

    Attributes:
        name: As in the message.
        messages: The messages with its status; if the first one was heard, the part exists.
    """

    name: str
    messages: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Heard:
    """A message as last heard at some frames.

    Attributes:
        there: True if it had been heard at all.
        fresh: Whether within the last half second.
        signals: Its values.
    """

    there: list[bool]
    fresh: list[bool]
    signals: dict[str, list[float]]


class DiagnosticStream:
    """Makes the messages of the topic; see `Stream`.

    Args:
        facts: The facts on the arm.
    """

    topic = "/diagnostics"
    schema = "diagnostic_msgs/DiagnosticArray"

    def __init__(self, facts: ExportFacts) -> None:
        self._codec = facts.codec
        self._arm = facts.notes.get("arm", "")
        joints = [
            _Part(f"arm: joint {n}", (f"DriverSlow{n}", f"DriverFast{n}", _STATUS)) for n in JOINTS
        ]
        self._parts = (
            _Part("arm: status", (_STATUS,)),
            *joints,
            _Part("arm: gripper", (_GRIPPER,)),
        )
        self._second = np.iinfo(np.int64).min

    def messages(self, history: History, span: TimeSpan) -> TimedMessages | None:
        """Return the messages that a piece of the log adds; see `Stream`."""
        frames = history.frames
        affected: dict[int, set[_Part]] = defaultdict(set)
        for part in self._parts:
            for message in part.messages:
                for row in self._changes(history, message).tolist():
                    affected[row].add(part)
        for row in self._seconds(frames).tolist():
            affected[row].update(self._parts)
        if not affected:
            return None
        rows = np.array(sorted(affected), np.int64)
        times_s = frames.times_s[np.searchsorted(frames.rows, rows)]
        inside = span.holds(times_s)
        rows, times_s = rows[inside], times_s[inside]
        heard = {
            message: _heard(history, message, rows, times_s)
            for message in dict.fromkeys(name for part in self._parts for name in part.messages)
        }
        times_ns = nanoseconds(times_s).tolist()
        found = TimedMessages([], [], [])
        for place, (row, time_ns) in enumerate(zip(rows.tolist(), times_ns, strict=True)):
            parts = [each for each in self._parts if each in affected[row]]
            firsts = ((each, heard[each.messages[0]]) for each in parts)
            parts = [each for each, first in firsts if first is not None and first.there[place]]
            if parts:
                found.rows.append(row)
                found.times_ns.append(time_ns)
                found.data.append(self._array(time_ns, parts, heard, place))
        return found if found.rows else None

    # The frames at which a message is written -------------------------------------------------

    def _changes(self, history: History, message: str) -> NDArray[np.int64]:
        """Return the frames whose codes differ from those before; the first one, too."""
        samples = history.samples(message)
        if samples is None:
            return np.empty(0, np.int64)
        mask = np.uint64(bit_mask(_codes(samples.layout)))
        if not mask:
            return np.empty(0, np.int64)
        codes = samples.words & mask
        changed = np.ones(len(codes), np.bool_)
        changed[1:] = codes[1:] != codes[:-1]
        rows: NDArray[np.int64] = samples.rows[samples.old :][changed[samples.old :]]
        return rows

    def _seconds(self, frames: ArmFrames) -> NDArray[np.int64]:
        """Return the first frame of each second."""
        if not len(frames):
            return np.empty(0, np.int64)
        seconds = np.floor(frames.times_s).astype(np.int64)
        begins = seconds != np.concatenate(([self._second], seconds[:-1]))
        self._second = int(seconds[-1])
        rows: NDArray[np.int64] = frames.rows[begins]
        return rows

    # The content of a message -----------------------------------------------------------------

    def _array(
        self, time_ns: int, parts: list[_Part], heard: dict[str, _Heard | None], place: int
    ) -> bytes:
        writer = CdrWriter()
        writer.header(time_ns, "")
        writer.count(len(parts))
        for part in parts:
            told = {
                message: {name: values[place] for name, values in each.signals.items()}
                for message in part.messages
                if (each := heard[message]) is not None and each.fresh[place]
            }
            level, text = self._verdict(part, told)
            writer.int8(level)
            for words in (part.name, text, self._arm):
                writer.text(words)
            values = list(self._values(part, told))
            writer.count(len(values))
            for key, value in values:
                writer.text(key)
                writer.text(value)
        return writer.data

    def _verdict(self, part: _Part, told: dict[str, dict[str, float]]) -> tuple[int, str]:
        main = told.get(part.messages[0])
        if main is None:
            return STALE, _SILENT
        if part.messages[0] == _STATUS:
            code = int(main["Status"])
            word = self._codec.word(_STATUS, "Status", code) or f"Code {code}"
            return (OK if code in AT_WORK else ERROR), word
        is_gripper = part.messages[0] == _GRIPPER
        names = GRIPPER_FAULTS if is_gripper else DRIVER_FAULTS
        faults = [_words(name) for name in names if main.get(name) == 1]
        status = told.get(_STATUS, {})
        joint = part.name.rpartition(" ")[2]
        if not is_gripper and status.get(f"J{joint}CommunicationFault") == 1:
            faults.append("Communication fault")
        if faults:
            return ERROR, ", ".join(faults)
        if not is_gripper and status.get(f"J{joint}LimitExceeded") == 1:
            return WARN, "Beyond limit"
        return OK, "Enabled" if main["Enabled"] == 1 else "Disabled"

    def _values(self, part: _Part, told: dict[str, dict[str, float]]) -> Iterator[tuple[str, str]]:
        for message in part.messages:
            if message == _STATUS and part.messages[0] != _STATUS:
                continue
            for name, value in told.get(message, {}).items():
                if math.isnan(value):
                    continue  # multiplexed: the frame has another signal
                yield _key(self._codec, message, name), self._value(message, name, value)

    def _value(self, message: str, name: str, value: float) -> str:
        return self._codec.word(message, name, value) or f"{value:.10g}"


def _heard(
    history: History, message: str, rows: NDArray[np.int64], times_s: NDArray[np.float64]
) -> _Heard | None:
    samples = history.samples(message)
    if samples is None:
        return None
    last, fresh = samples.fresh_at(rows, times_s)
    signals = {name: samples.column(name)[last].tolist() for name in samples.layout.signals}
    return _Heard((last >= 0).tolist(), fresh.tolist(), signals)


def _codes(layout: MessageLayout) -> list[SignalLayout]:
    return [
        signal
        for name, signal in layout.signals.items()
        if signal.is_count and name not in _COUNTERS and signal.bits <= 8
    ]


def _words(name: str) -> str:
    """Return a signal's name as words: «MotorOvertemperature» as «Motor overtemperature»."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name).capitalize()


def _key(codec: Codec, message: str, name: str) -> str:
    unit = codec.unit(message, name)
    words = _words(name)
    return f"{words} [{unit}]" if unit else words
