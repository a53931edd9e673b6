"""What was last heard of each message at any frame of a log, many frames at once.

The same that a tracker keeps frame by frame, as columns: of each message the frames of the piece
under way, and in front of them the last one of before.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.arm.state import FRESH_FOR_S
from armui.protocol.codes import MotorAction
from armui.protocol.columns import signal_column
from armui.session.exports.frames import ArmFrames, no_frames
from armui.telemetry.store import ENDS

if TYPE_CHECKING:
    from collections.abc import Collection

    from numpy.typing import NDArray

    from armui.protocol.codec import Codec
    from armui.protocol.layout import MessageLayout

_NEVER: Final = -1


@dataclass(frozen=True, slots=True)
class Samples:
    """Frames of one message, in the order of the log.

    Attributes:
        layout: What they hold.
        rows: The number of each within the log.
        times_s: As recorded.
        words: Their data, see `payload_words`.
        old: How many of them, 0 or 1, are of an earlier piece.
    """

    layout: MessageLayout
    rows: NDArray[np.int64]
    times_s: NDArray[np.float64]
    words: NDArray[np.uint64]
    old: int

    def column(self, signal: str) -> NDArray[Any]:
        """Physical values of a signal."""
        return signal_column(self.words, self.layout.signals[signal])

    def bits(self, names: tuple[str, ...]) -> NDArray[np.int64]:
        """Signals of one bit as one number, the first worth 1; what there is not counts as 0."""
        sums = np.zeros(len(self.words), np.int64)
        for place, name in enumerate(names):
            if name in self.layout.signals:
                sums |= (self.column(name) == 1).astype(np.int64) << place
        return sums

    @property
    def new_rows(self) -> NDArray[np.int64]:
        """The frames of this piece."""
        return self.rows[self.old :]

    def last_at(self, rows: NDArray[np.int64]) -> NDArray[np.intp]:
        """Which of the samples was the last one at frames of the log; -1 where there was none."""
        return np.searchsorted(self.rows, rows, side="right") - 1

    def fresh_at(
        self, rows: NDArray[np.int64], times_s: NDArray[np.float64]
    ) -> tuple[NDArray[np.intp], NDArray[np.bool_]]:
        """As `last_at`, and whether that sample was young enough to stand for the present.

        Args:
            rows: Frames of the log.
            times_s: Their times.
        """
        last = self.last_at(rows)
        fresh = (last >= 0) & (np.abs(times_s - self.times_s[last]) <= FRESH_FOR_S)
        return last, fresh


class History:
    """Takes the pieces of a log in turn.

    Args:
        codec: Speaks the generation of the recorded arm, with its identifier offsets.

    Attributes:
        codec: As above.
        frames: The newest piece.
        not_understood: Frames so far that are in no table, or of another length.
    """

    def __init__(self, codec: Codec) -> None:
        self.codec = codec
        self.frames = no_frames()
        self.not_understood = 0
        self._samples: dict[str, Samples] = {}
        self._stops = np.empty(0, np.int64)

    def take(self, frames: ArmFrames) -> None:
        """Go on to the next piece."""
        self.frames = frames
        for name, samples in self._samples.items():
            self._samples[name] = _last_of(samples)
        order = np.argsort(frames.ids, kind="stable")
        ends = np.flatnonzero(np.diff(frames.ids[order])) + 1
        for places in np.split(order, ends) if len(order) else ():
            layout = self.codec.layout(int(frames.ids[places[0]]))
            if layout is None:
                self.not_understood += len(places)
                continue
            sound = np.isin(frames.lengths[places], np.array(layout.lengths, np.uint8))
            self.not_understood += len(places) - int(np.count_nonzero(sound))
            self._add(layout, frames, places[sound])
        self._stops = np.concatenate((self._stops[-1:], self._new_stops()))

    def _add(self, layout: MessageLayout, frames: ArmFrames, places: NDArray[np.intp]) -> None:
        before = self._samples.get(layout.name)
        rows, times_s, words = frames.rows[places], frames.times_s[places], frames.words[places]
        if before is not None:
            rows = np.concatenate((before.rows, rows))
            times_s = np.concatenate((before.times_s, times_s))
            words = np.concatenate((before.words, words))
        if len(rows):
            old = 0 if before is None else 1
            self._samples[layout.name] = Samples(layout, rows, times_s, words, old)

    def _new_stops(self) -> NDArray[np.int64]:
        """Where every target that stands is ended: by a stop, an abort or disabled motors."""
        stops = []
        commands = self._samples.get("MotionCommand")
        if commands is not None:
            ended = np.zeros(len(commands.rows), np.bool_)
            for signal, codes in ENDS.items():
                ended |= np.isin(commands.column(signal), [int(code) for code in codes])
            stops.append(commands.rows[commands.old :][ended[commands.old :]])
        motors = self._samples.get("MotorEnable")
        if motors is not None:
            disabled = motors.column("Action") == MotorAction.DISABLE
            stops.append(motors.rows[motors.old :][disabled[motors.old :]])
        return np.sort(np.concatenate(stops)) if stops else np.empty(0, np.int64)

    def samples(self, message: str) -> Samples | None:
        """The frames of a message; ``None`` while none was heard."""
        return self._samples.get(message)

    def heard(self) -> Collection[Samples]:
        """The frames of every message that was heard so far."""
        return self._samples.values()

    def ended_at(
        self, rows: NDArray[np.int64], by: tuple[str, ...], *, by_stops: bool
    ) -> NDArray[np.int64]:
        """The last frame, at frames of the log, that ended a command; -1 where there was none.

        Args:
            rows: Frames of the log.
            by: The messages that end it.
            by_stops: Whether a stop, an abort and disabled motors end it, too.
        """
        others = [self._samples[name].rows for name in by if name in self._samples]
        ends = np.concatenate([[_NEVER], *others, *([self._stops] if by_stops else [])])
        ends.sort()
        last: NDArray[np.int64] = ends[np.searchsorted(ends, rows, side="right") - 1]
        return last


def _last_of(samples: Samples) -> Samples:
    return Samples(samples.layout, samples.rows[-1:], samples.times_s[-1:], samples.words[-1:], 1)
