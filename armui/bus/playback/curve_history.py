"""Half an hour of a log for its curves, read by a thread of its own while the replay goes on."""

from __future__ import annotations

import logging
import threading
import time
from typing import TYPE_CHECKING, Final

from armui.bus.playback.log_cursor import LogCursor
from armui.bus.playback.series_tap import SeriesTap
from armui.telemetry.columns import joined

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.session.frames import Channel
    from armui.session.session import Session
    from armui.telemetry.columns import FrameColumns
    from armui.telemetry.store import Telemetry

_LOG: Final = logging.getLogger(__name__)

FILL_ROWS: Final = 32_768
"""So many frames are taken in at once: a millisecond for each message."""
_TURN_S: Final = 0.004
_LONGEST_REST_S: Final = 0.02
"""It rests as long as it has worked. Whoever waits for Python goes first."""


def fill(
    series: SeriesTap,
    frames: LogCursor,
    begin_s: float,
    end_s: float,
    is_wanted: Callable[[float], bool],
) -> bool:
    """Take a stretch of a log into series; whether it was wanted to its end.

    Args:
        series: Where to; nothing later than `begin_s` may be in it.
        frames: The log.
        begin_s: Log time.
        end_s: As above, included.
        is_wanted: Asked for each piece, with the log time that is reached; when it is not, the
            rest stays away.
    """
    pieces: list[FrameColumns] = []
    for each in frames.columns_between(begin_s, end_s):
        if not is_wanted(float(each.times_s[0])):
            return False
        pieces.append(each)
        if sum(map(len, pieces)) >= FILL_ROWS:
            series.take(joined(pieces))
            pieces = []
    if pieces:
        series.take(joined(pieces))
    return True


class CurveHistory:
    """Reads at once.

    Args:
        session: The log.
        channel: What is seen of it.
        telemetry: Empty series of its own.
        times_s: Log times from and to, the latter included.
        then: Called in the thread when it has ended by itself.

    Attributes:
        telemetry: Filled when `is_whole`.
        begin_s, end_s: The times as given.
        reached_s: Log time it has come to.
        is_whole: Whether it has come to the end.
        is_over: Whether it has ended, also if it could not go on.
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
        """Nobody wants it any more; with `wait` it reads no more when this returns."""
        self._wanted = False
        if wait:
            self._thread.join()

    def _run(self) -> None:
        tap = SeriesTap(self.telemetry)
        try:
            self.is_whole = fill(tap, self._cursor, self.begin_s, self.end_s, self._goes_on)
        except Exception:  # noqa: BLE001 - whatever is wrong with a file: what is near is shown
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
