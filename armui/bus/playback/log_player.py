"""Plays a log the way live frames go: at any speed, or frame by frame. No Qt."""

from __future__ import annotations

import math
import threading
import time
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.bus.frame_processor import FrameProcessor
from armui.bus.playback.curve_history import CurveHistory, SeriesListener, fill, is_own_command
from armui.bus.playback.log_cursor import LogCursor, ReplayedFrame
from armui.protocol.frame import Frame
from armui.protocol.signal_columns import bit_mask, payload_words
from armui.telemetry.series import KEPT_S
from armui.telemetry.series_columns import NOT_OF_THE_ARM, joined
from armui.telemetry.store import Telemetry

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from armui.bus.playback.log_cursor import LogClock
    from armui.protocol.codec import Codec, Message
    from armui.session.frames import Channel
    from armui.session.session import Session
    from armui.telemetry.listener import Listener
    from armui.telemetry.series_columns import FrameColumns

# Selects the frames that must be processed one by one when a log is played fast.

_IDS: Final = 0x800
"""The number of standard identifiers: 11 bits."""
_MEASURED: Final = frozenset(
    {f"JointFeedback{pair}" for pair in (12, 34, 56)}
    | {f"EndPose{part}" for part in (1, 2, 3)}
    | {f"{kind}{joint}" for kind in ("DriverFast", "EndMotion") for joint in range(1, 7)}
)
"""Messages with measured positions: only the last one of a slice counts."""
_TOLD: Final = frozenset(
    {"ArmStatus", "GripperFeedback", *(f"DriverSlow{joint}" for joint in range(1, 7))}
)
"""Messages with faults beside figures: each change of a fault or mode counts."""

ONE_BY_ONE_UP_TO: Final = 4.0
"""The highest speed at which every frame is processed; above it, only those that tell something
new.
"""
_SLICE_S: Final = 0.2
"""The longest slice in log time: shorter than what counts as silence."""
_AT_ONCE: Final = 256
"""The number of frames processed before other threads may take the lock."""
FILLED_S: Final = 120.0
"""The stretch of the log before a place that its curves show at once."""
_SETTLE_S: Final = 0.08
"""Curves are drawn a dozen times a second; frames played fast are added to them as often."""


class Folding:
    """Picks the frames of a slice with new content; those left out are repeated later in it.

    Args:
        codec: The codec of the frames.
    """

    def __init__(self, codec: Codec) -> None:
        self._is_folded: NDArray[np.bool_] = np.zeros(_IDS, np.bool_)
        self._masks: dict[int, np.uint64] = {}
        self._last: dict[int, int] = {}
        for wire_id, layout in codec.layouts.items():
            if layout.name not in _MEASURED | _TOLD:
                continue
            self._is_folded[wire_id] = True
            if layout.name in _TOLD:
                codes = [each for each in layout.signals.values() if not each.unit]
                self._masks[wire_id] = np.uint64(bit_mask(codes))

    def rows(self, frames: FrameColumns) -> NDArray[np.int64]:
        """Return the rows to be processed, in order.

        The first row is always one of them: its distance from the frame before decides whether
        there was a silence.
        """
        ordinary = (frames.flags & NOT_OF_THE_ARM) == 0
        folded = ordinary & self._is_folded[np.minimum(frames.ids, _IDS - 1)]
        folded &= frames.ids < _IDS
        keep = ~folded
        if keep.size:
            keep[0] = True
        rows = np.flatnonzero(folded)
        order = rows[np.argsort(frames.ids[rows], kind="stable")]
        edges = np.flatnonzero(np.diff(frames.ids[order])) + 1
        for same in np.split(order, edges) if order.size else ():
            keep[same[-1]] = True
            wire_id = int(frames.ids[same[0]])
            mask = self._masks.get(wire_id)
            if mask is not None:
                codes = payload_words(frames.payloads[same]) & mask
                before = np.uint64(self._last.get(wire_id, int(codes[0])))
                keep[same[np.diff(codes, prepend=before) != 0]] = True
                self._last[wire_id] = int(codes[-1])
        return np.flatnonzero(keep)


class LogPlayer:
    """Plays a log in one thread; others may hold it up with `lock` for a moment.

    Args:
        session: The log.
        channel: The channel to play.
        clock: The clock, set to the log time that is reached.
        codec: The protocol to begin with.
        listeners: Objects that are told of every frame; curves are filled at once around a place.
        answered: As for `FrameProcessor`.

    Attributes:
        lock: Held while frames are processed.
        processor: Processes the frames.
        last: The frame that was processed last.
        played: The number of frames passed since the last :meth:`enter`.
        curves_from_s: The curves are complete from this log time on.
    """

    def __init__(
        self,
        session: Session,
        channel: Channel,
        clock: LogClock,
        *,
        codec: Codec,
        listeners: Sequence[Listener],
        answered: Callable[[Message], object],
    ) -> None:
        self._session = session
        self._channel = channel
        self._clock = clock
        self._cursor = LogCursor(session, channel)
        self._look_up = LogCursor(session, channel)
        self._series: dict[int, SeriesListener] = {}
        self.lock = threading.RLock()
        self.processor = FrameProcessor(codec, self._for_log(listeners), answered)
        self._folding: Folding | None = None
        self._recalled: Sequence[ReplayedFrame] = ()
        self._at_entry = True
        self._waiting: list[FrameColumns] = []
        self._settled_s = 0.0
        self.last: ReplayedFrame | None = None
        self.played = 0
        self.curves_from_s = math.inf

    def _for_log(self, listeners: Sequence[Listener]) -> list[Listener]:
        """Return the same listeners; the series of the curves takes many frames at once."""
        found: list[Listener] = []
        for listener in listeners:
            if isinstance(listener, Telemetry):
                listener = self._series.setdefault(id(listener), SeriesListener(listener))  # noqa: PLW2901
            found.append(listener)
        return found

    def set_listeners(self, listeners: Sequence[Listener]) -> None:
        """Replace the listeners that are told of every frame."""
        self.processor.notifier.set_listeners(self._for_log(listeners))

    def use_codec(self, codec: Codec, *, forget: bool = True) -> None:
        """Change the codec, and forget what was heard if that is wanted; for any thread.

        If nothing was played since :meth:`enter`, the state from before this place is read again
        with the new codec.
        """
        with self.lock:
            self.processor.use_codec(codec, forget=forget)
            if self._at_entry and forget:
                self._take_codec()
                self.processor.recall([each[:3] for each in self._recalled])

    def _take_codec(self) -> None:
        before = self.processor.codec
        self.processor.apply_codec(self._clock())
        if self.processor.codec is not before:
            self._folding = None

    # Going to another place -------------------------------------------------------------------

    def look_up(self, at_s: float) -> list[ReplayedFrame]:
        """Return the latest frame of each kind before a place; this may read from the disk."""
        return self._look_up.snapshot(at_s)

    def enter(self, at_s: float, recalled: Sequence[ReplayedFrame]) -> None:
        """Go to another place with the frames that :meth:`look_up` found; this takes no time.

        Args:
            at_s: Log time; the frames of this time count as played.
            recalled: The frames that :meth:`look_up` returned.
        """
        with self.lock:
            self._cursor.go_behind(at_s)
            self._recalled, self._at_entry = recalled, True
            self._folding = None
            self.processor.reset_other_hosts()
            self._waiting = []
            self.last = recalled[-1] if recalled else None
            self.played = 0
            self.curves_from_s = math.inf
            self._clock.set(at_s)
            for listener in self._series.values():
                listener.telemetry.release()

    def fill(self, is_wanted: Callable[[], bool]) -> None:
        """Fill the curves with the two minutes before this place.

        Args:
            is_wanted: Called now and then; if it returns false, the rest is left out.
        """
        end_s = self._clock()
        begin_s = max(self._session.start_s, end_s - FILLED_S)
        for listener in self._series.values():
            if not fill(listener, self._look_up, begin_s, end_s, lambda _at_s: is_wanted()):
                return
        self.curves_from_s = begin_s

    def read_history(self, then: Callable[[], object]) -> CurveHistory | None:
        """Start reading more of the log before this place, as far back as curves are kept.

        Args:
            then: Called in another thread when everything is read: see :meth:`take_history`.

        Returns:
            The reader, or ``None`` if the curves show everything already.
        """
        end_s = self._clock()
        begin_s = max(self._session.start_s, end_s - KEPT_S)
        listener = next(iter(self._series.values()), None)
        if listener is None or begin_s >= self.curves_from_s:
            return None
        empty = listener.telemetry.alike()
        return CurveHistory(self._session, self._channel, empty, (begin_s, end_s), then)

    def take_history(self, history: CurveHistory, is_wanted: Callable[[], bool]) -> None:
        """Show in the curves the history that was read, and the frames played meanwhile.

        Args:
            history: A reader that has come to its end.
            is_wanted: Returns false once the replay is at another place.
        """
        self.settle()
        listener, end_s = SeriesListener(history.telemetry), self._clock()
        behind_s = math.nextafter(history.end_s, math.inf)
        if not fill(listener, self._look_up, behind_s, end_s, lambda _at_s: is_wanted()):
            return
        with self.lock:
            if is_wanted():
                next(iter(self._series.values())).telemetry.adopt(history.telemetry)
                self.curves_from_s = history.begin_s

    def settle(self) -> None:
        """Add the frames that were played fast to the curves."""
        pieces, self._waiting = self._waiting, []
        if pieces:
            frames = joined(pieces)
            for listener in self._series.values():
                listener.add_frames(frames)
        self._settled_s = time.monotonic()

    # Playing ----------------------------------------------------------------------------------

    def play(self, until_s: float, speed: float, is_wanted: Callable[[], bool]) -> None:
        """Process the frames up to a time, and move the clock there.

        Args:
            until_s: Log time of the end.
            speed: Above `ONE_BY_ONE_UP_TO` not every frame is processed.
            is_wanted: Called after each slice; if it returns false, the rest is left.
        """
        if speed <= ONE_BY_ONE_UP_TO:
            self.settle()
            self._go_by_columns(wanted=False)
        at_s = self._clock()
        while at_s < until_s:
            at_s = min(at_s + _SLICE_S, until_s)
            if speed > ONE_BY_ONE_UP_TO:
                self._play_slice(at_s)
            elif not self._play_frames(at_s, is_wanted):
                return
            if not is_wanted():
                return

    def _play_frames(self, until_s: float, is_wanted: Callable[[], bool]) -> bool:
        while True:
            frames = self._cursor.frames_until(until_s, _AT_ONCE)
            with self.lock:
                if not is_wanted():
                    return False
                for frame in frames:
                    self._process_frame(frame)
                self._flush(until_s if len(frames) < _AT_ONCE else frames[-1].at_s)
            if len(frames) < _AT_ONCE:
                return True

    def _play_slice(self, until_s: float) -> None:
        if time.monotonic() - self._settled_s > _SETTLE_S:
            self.settle()
        self._go_by_columns(wanted=True)
        frames = self._cursor.columns_until(until_s)
        with self.lock:
            if len(frames):
                self._take_slice(frames)
            self._flush(until_s)

    def _go_by_columns(self, *, wanted: bool) -> None:
        for listener in self._series.values():
            listener.by_columns = wanted

    def _take_slice(self, frames: FrameColumns) -> None:
        self._take_codec()
        before = self.played
        self._waiting.append(frames)
        folding = self._folding
        if folding is None:
            folding = self._folding = Folding(self.processor.codec)
        for row in folding.rows(frames).tolist():
            data = frames.payloads[row, : frames.lengths[row]].tobytes()
            frame = Frame(int(frames.ids[row]), data)
            self._process_frame(
                ReplayedFrame(frame, float(frames.times_s[row]), int(frames.flags[row]))
            )
        self.played = before + len(frames)

    def step(self) -> ReplayedFrame | None:
        """Process the next frame alone and return it; ``None`` at the end."""
        self.settle()
        self._go_by_columns(wanted=False)
        frame = self._cursor.next_frame()
        if frame is not None:
            with self.lock:
                self._process_frame(frame)
                self._flush(max(frame.at_s, self._clock()))
        return frame

    def before(self) -> float | None:
        """Return the log time just before this place, or ``None`` at the beginning."""
        at_s = self.last.at_s if self.last is not None else self._clock()
        width_s = 0.01
        while True:
            begin_s, end_s = at_s - width_s, math.nextafter(at_s, -math.inf)
            times_s = [
                float(frames.times_s[frames.times_s < at_s][-1])
                for frames in self._look_up.columns_between(begin_s, end_s)
                if (frames.times_s < at_s).any()
            ]
            if times_s:
                return times_s[-1]
            if begin_s < self._session.start_s:
                return None
            width_s *= 8

    def _process_frame(self, timed: ReplayedFrame) -> None:
        self._take_codec()
        self._at_entry = False
        self.last = timed
        self.played += 1
        frame, at_s, flags = timed.frame, timed.at_s, timed.flags
        if is_own_command(frame.arbitration_id, flags):
            self.processor.notifier.sent.append((frame, at_s))
        else:
            self.processor.process(frame, at_s, flags)

    def _flush(self, at_s: float) -> None:
        self.processor.notifier.flush(self.processor.codec, at_s)
        self.processor.publish()
        self._clock.set(at_s)
