"""Marks episodes in the log that is being written, for datasets; it sends nothing to the arm."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Signal

from armui.arm.refusal import Reason, Refusal
from armui.control.events import Notice
from armui.control.operations.operation import operation
from armui.control.operations.started import Ending, Started
from armui.control.sessions.progress import EpisodePhase
from armui.session.recording.episodes import Episode, episode_line
from armui.telemetry.events import Asker, EventKind, EventOutcome, Level

if TYPE_CHECKING:
    from armui.control.context import Context
    from armui.control.operating_state import OperatingState
    from armui.session.recording.sidecar import Line

EPISODE_NO_LOG = Reason(
    "episode_no_log", "No log is being written, in which an episode could be marked. Start a log."
)
EPISODE_UNDER_WAY = Reason("episode_under_way", "An episode is under way already. End it first.")
EPISODE_NONE = Reason("episode_none", "No episode is under way. Begin one first.")
EPISODE_NO_LAST = Reason(
    "episode_no_last",
    "There is no episode to discard: none was begun, or the last one is discarded.",
)
EPISODE_TASK_BAD = Reason(
    "episode_task_bad", "A task is one line of text, of {maximum} characters at most."
)
EPISODES_FULL = Reason(
    "episodes_full", "The log has {maximum} episodes already. Stop it and start another one."
)
EPISODE_BEGUN = Notice(
    "episode_begun", "Episode {number} begun: “{task}”", Level.INFO, EventKind.COMMAND
)
EPISODE_ENDED = Notice(
    "episode_ended", "Episode {number} ended, {seconds} s", Level.INFO, EventKind.COMMAND
)
EPISODE_CLOSED = Notice(
    "episode_closed",
    "Episode {number} was not ended: it ends with the log, after {seconds} s",
    Level.WARNING,
    EventKind.RESULT,
    Asker.PROGRAM,
)
EPISODE_DISCARDED = Notice(
    "episode_discarded", "Episode {number} discarded", Level.INFO, EventKind.COMMAND
)

LONGEST_TASK: Final = 200
_MOST: Final = 10_000
"""The most episodes of a log: a client may mark some without anybody's consent."""

_WHY_NOT_BEGIN: Final = {
    EpisodePhase.NO_LOG: EPISODE_NO_LOG,
    EpisodePhase.UNDER_WAY: EPISODE_UNDER_WAY,
}
_WHY_NOT_END: Final = {
    EpisodePhase.NO_LOG: EPISODE_NO_LOG,
    EpisodePhase.NONE: EPISODE_NONE,
    EpisodePhase.ENDED: EPISODE_NONE,
}
_WHY_NOT_DISCARD: Final = {
    EpisodePhase.NO_LOG: EPISODE_NO_LOG,
    EpisodePhase.NONE: EPISODE_NO_LAST,
}


def _why(reasons: dict[EpisodePhase, Reason], now: OperatingState) -> Refusal | None:
    reason = reasons.get(now.episode)
    return None if reason is None else reason()


def why_not_begin_episode(now: OperatingState) -> Refusal | None:
    """Return why no episode can be begun: no log is written, or one is under way."""
    return _why(_WHY_NOT_BEGIN, now)


def why_not_end_episode(now: OperatingState) -> Refusal | None:
    """Return why no episode can be ended: none is under way."""
    return _why(_WHY_NOT_END, now)


def why_not_discard_episode(now: OperatingState) -> Refusal | None:
    """Return why the last episode cannot be discarded: there is none."""
    return _why(_WHY_NOT_DISCARD, now)


class Episodes(QObject):
    """Marks the beginnings and ends of episodes in the log that is being written.

    Args:
        context: The context that the controller's parts share.

    Attributes:
        task: The task of the next episode: that of the last one, unless another is given.
        kept: The number of episodes in this log that are not discarded.

    Signals:
        changed: An episode has begun, ended or was discarded.
    """

    changed = Signal()

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = context
        self._note: Callable[[Line], object] | None = None
        self._shift_s = 0.0
        self._last: Episode | None = None
        self._started: Started | None = None
        self.task = ""
        self.kept = 0

    @property
    def phase(self) -> EpisodePhase:
        """What can be marked now."""
        if self._note is None:
            return EpisodePhase.NO_LOG
        if self._last is None or self._last.discarded:
            return EpisodePhase.NONE
        return EpisodePhase.UNDER_WAY if self._last.end_s is None else EpisodePhase.ENDED

    @property
    def under_way(self) -> Episode | None:
        """The episode under way, or ``None``."""
        return self._last if self.phase is EpisodePhase.UNDER_WAY else None

    @property
    def elapsed_s(self) -> float:
        """The time since the episode under way began; 0 without one."""
        episode = self.under_way
        return 0.0 if episode is None else self._now_s() - episode.begin_s

    # For the operator and clients -------------------------------------------------------------

    @operation("episode.begin", "Begin an episode", why_not_begin_episode, sends=False)
    def begin(self, started: Started, task: str | None = None) -> Refusal | None:
        """Mark the beginning of an episode.

        Args:
            started: The record of this command, which ends with the episode.
            task: What is done in it; without one the task of the episode before.
        """
        wanted = self.task if task is None else task.strip()
        if len(wanted) > LONGEST_TASK or not wanted.isprintable():
            return EPISODE_TASK_BAD(maximum=LONGEST_TASK)
        number = 1 if self._last is None else self._last.number + 1
        if number > _MOST:
            return EPISODES_FULL(maximum=_MOST)
        self.task, self._started = wanted, started
        self.kept += 1
        self._keep(Episode(number, self._now_s(), task=wanted))
        self._context.emit_event(EPISODE_BEGUN, started, number=number, task=wanted)
        self._show()
        return None

    @operation("episode.end", "End the episode", why_not_end_episode, sends=False)
    def end(self, started: Started) -> None:
        """Mark the end of the episode under way."""
        self._end(EPISODE_ENDED, started)
        started.close(Ending.DONE)
        self._show()

    @operation("episode.discard", "Discard the last episode", why_not_discard_episode, sends=False)
    def discard(self, started: Started) -> None:
        """Note that the last episode is not wanted; one under way ends."""
        if self.under_way is not None:
            self._end(EPISODE_ENDED)
        if self._last is not None:
            self.kept -= 1
            self._keep(replace(self._last, discarded=True))
            self._context.emit_event(EPISODE_DISCARDED, started, number=self._last.number)
        started.close(Ending.DONE)
        self._show()

    def mark(self) -> Started | Refusal:
        """Begin an episode, or end the one under way: what a single key or button does."""
        return self.begin() if self.under_way is None else self.end()

    # For the session recorder -----------------------------------------------------------------

    def begin_log(self, note: Callable[[Line], object], shift_s: float) -> None:
        """Mark in another log from now on.

        Args:
            note: Adds a line to its sidecar.
            shift_s: From the program's clock to log time.
        """
        self._note, self._shift_s, self._last, self.kept = note, shift_s, None, 0
        self._show()

    def end_log(self) -> None:
        """End the episode under way, because its log ends."""
        if self.under_way is not None:
            self._end(EPISODE_CLOSED)
        self._note = None
        self._show()

    def _end(self, notice: Notice, by: Started | None = None) -> None:
        episode, now_s = self._last, self._now_s()
        if episode is None:
            return
        self._keep(replace(episode, end_s=now_s))
        figures = {"number": episode.number, "seconds": round(now_s - episode.begin_s, 1)}
        if self._started is not None:
            outcome = EventOutcome(notice.id, self._context.clock(), Level.DONE, figures)
            self._started.close(Ending.DONE, outcome)
        self._started = None
        self._context.emit_event(notice, by, **figures)

    def _keep(self, episode: Episode) -> None:
        self._last = episode
        if self._note is not None:
            self._note(episode_line(episode))

    def _now_s(self) -> float:
        return self._context.clock() + self._shift_s

    def _show(self) -> None:
        self._context.refresh()
        self.changed.emit()
