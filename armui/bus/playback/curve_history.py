"""Reads half an hour of a log for its curves in a thread of its own while the replay goes on."""

from __future__ import annotations

import logging
import threading
import time
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.arm.other_hosts import MOTION_IDS, OTHER_COMMAND_IDS
from armui.bus.playback.log_cursor import LogCursor
from armui.protocol.frame import FrameFlag
from armui.telemetry.listener import Listener
from armui.telemetry.series_columns import joined

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from armui.protocol.codec import Codec
    from armui.protocol.generation import Generation
    from armui.session.frames import Channel
    from armui.session.session import Session
    from armui.telemetry.listener import ReceivedFrame
    from armui.telemetry.series_columns import FrameColumns
    from armui.telemetry.store import Telemetry

# Feeds the series of a replay's curves, frame by frame or many frames at once.

COMMAND_IDS = frozenset(MOTION_IDS | OTHER_COMMAND_IDS)
"""The identifiers of commands to the arm. If the recording program has sent such a frame, it was
its own command.
"""

_COMMAND_IDS = np.array(sorted(COMMAND_IDS), np.uint32)

_LOG: Final = logging.getLogger(__name__)

FILL_ROWS: Final = 32_768
"""The number of frames added at once: a millisecond for each message."""
_TURN_S: Final = 0.004
"""The reader pauses after working this long, so that it does not hold Python's GIL."""
_LONGEST_REST_S: Final = 0.02
"""The longest pause. The thread rests as long as it has worked, so other threads get Python's lock
first.
"""


def is_own_command(arbitration_id: int, flags: int) -> bool:
    """Return whether a frame is a command that the recording program sent to the arm."""
    return arbitration_id in COMMAND_IDS and bool(flags & FrameFlag.TRANSMITTED)


class SeriesListener(Listener):
    """Feeds the telemetry of a replay, as one of its listeners.

    Args:
        telemetry: The series of the replay; nothing else writes to them.

    Attributes:
        by_columns: Frames come through :meth:`add_frames`; those passed one by one are only some of
            them, and ignored.
    """

    def __init__(self, telemetry: Telemetry) -> None:
        self.telemetry = telemetry
        self.by_columns = False

    def add_frames(self, frames: FrameColumns) -> None:
        """Add many frames at once, as columns."""
        own = ((frames.flags & FrameFlag.TRANSMITTED) != 0) & np.isin(frames.ids, _COMMAND_IDS)
        self.telemetry.on_columns(frames, own=own)

    def know_generation(self, generation: Generation | None) -> None:
        """See `armui.bus.notifier.Listener`."""
        self.telemetry.know_generation(generation)

    def on_open(self, bitrate: int | None) -> None:
        """See `armui.bus.notifier.Listener`."""
        self.telemetry.on_open(bitrate)

    def on_codec(self, codec: Codec) -> None:
        """See `armui.bus.notifier.Listener`."""
        self.telemetry.on_codec(codec)

    def on_heard(self, batch: Sequence[ReceivedFrame]) -> None:
        """See `armui.bus.notifier.Listener`."""
        if not self.by_columns:
            self.telemetry.on_heard(batch)

    def on_sent(self, batch: Sequence[ReceivedFrame]) -> None:
        """See `armui.bus.notifier.Listener`."""
        if not self.by_columns:
            self.telemetry.on_sent(batch)

    def on_error_frame(self) -> None:
        """See `armui.bus.notifier.Listener`."""
        if not self.by_columns:
            self.telemetry.on_error_frame()

    def on_look(self, now_s: float) -> None:
        """See `armui.bus.notifier.Listener`."""
        if not self.by_columns:
            self.telemetry.on_look(now_s)


def fill(
    series: SeriesListener,
    frames: LogCursor,
    begin_s: float,
    end_s: float,
    is_wanted: Callable[[float], bool],
) -> bool:
    """Add a stretch of a log to series, and return whether all of it was still wanted.

    Args:
        series: The series to fill; they may hold nothing later than `begin_s`.
        frames: A cursor in the log.
        begin_s: Log time of the beginning, in seconds.
        end_s: Log time of the end, included.
        is_wanted: Called for each piece with the log time reached; if it returns false, the rest is
            left out.
    """
    pieces: list[FrameColumns] = []
    for each in frames.columns_between(begin_s, end_s):
        if not is_wanted(float(each.times_s[0])):
            return False
        pieces.append(each)
        if sum(map(len, pieces)) >= FILL_ROWS:
            series.add_frames(joined(pieces))
            pieces = []
    if pieces:
        series.add_frames(joined(pieces))
    return True


class CurveHistory:
    """Reads a stretch of a log into series of its own, in a thread that starts at once.

    Args:
        session: The log.
        channel: The channel to read.
        telemetry: Empty series, used for this alone.
        times_s: Log times of beginning and end, the end included.
        then: Called in the thread when the reading has ended by itself.

    Attributes:
        telemetry: The series; complete when `is_whole`.
        begin_s, end_s: The times as given.
        reached_s: The log time reached so far.
        is_whole: True if it was read to the end.
        is_over: True if the reading has ended, also by an error.
    """

    def __init__(
        self,
        session: Session,
        channel: Channel,
        telemetry: Telemetry,
        times_s: tuple[float, float],
        then: Callable[[], object],
    ) -> None:
        self.telemetry = telemetry
        self.begin_s, self.end_s = times_s
        self.reached_s = self.begin_s
        self.is_whole = self.is_over = False
        self._cursor = LogCursor(session, channel)
        self._then = then
        self._wanted = True
        self._rested_s = time.monotonic()
        self._thread = threading.Thread(target=self._run, name="armui-replay-curves", daemon=True)
        self._thread.start()

    def end(self, *, wait: bool = False) -> None:
        """Stop reading; with `wait`, return only when nothing is read any more."""
        self._wanted = False
        if wait:
            self._thread.join()

    def _run(self) -> None:
        listener = SeriesListener(self.telemetry)
        try:
            self.is_whole = fill(listener, self._cursor, self.begin_s, self.end_s, self._goes_on)
        except Exception:  # noqa: BLE001 - a damaged file: the curves near the place are shown
            _LOG.exception("The curves of a log could not be read")
        self.is_over = True
        if self._wanted:
            self._then()

    def _goes_on(self, reached_s: float) -> bool:
        self.reached_s = reached_s
        worked_s = time.monotonic() - self._rested_s
        if worked_s > _TURN_S:
            time.sleep(min(worked_s, _LONGEST_REST_S))
            self._rested_s = time.monotonic()
        return self._wanted
