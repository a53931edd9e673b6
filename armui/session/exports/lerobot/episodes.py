"""Samples a log at an even rate, cuts it into episodes, and writes them as a dataset."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from armui.arm.refusal import Reason
from armui.session.exports.lerobot.dataset import EpisodeFrames, write_dataset
from armui.session.exports.lerobot.frames import GRIPPER, Cause, InstantSampler
from armui.session.exports.request import ExportError, ExportProblem
from armui.session.recording.episodes import Episode

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from numpy.typing import NDArray

    from armui.arm.refusal import Refusal
    from armui.session.exports.history import ExportFacts, History, TimeSpan
    from armui.session.exports.lerobot.frames import Instants
    from armui.session.exports.request import EpisodeOptions

NAMES: Final = (*(f"joint_{joint}.pos" for joint in range(1, 7)), "gripper.pos")
"""The names of the values: degrees and mm, as of ``lerobot_robot_armui``."""
SHORTEST_S: Final = 1.0
"""A shorter stretch is no episode."""

EPISODES_UNMARKED = Reason(
    "episodes_unmarked", "No episode is marked in it: all of it is taken as one, “{task}”."
)
EPISODE_SILENT = Reason(
    "episode_silent",
    "Left out, {begin} s to {end} s: the angles were not heard, or older than 0.1 s. What follows "
    "is an episode of its own.",
)
EPISODE_FAULT = Reason(
    "episode_fault",
    "Left out, {begin} s to {end} s: the arm told a stop or a fault. What follows is an episode of "
    "its own.",
)
EPISODE_NO_GRIPPER = Reason(
    "episode_no_gripper",
    "Left out, {begin} s to {end} s: the gripper was not heard. What follows is an episode of its "
    "own.",
)
EPISODE_SHORT = Reason(
    "episode_short", "Left out, {begin} s to {end} s: shorter than an episode of 1 s."
)
EPISODES_MORE = Reason("episodes_more", "{count} more stretches were left out.")
ACTIONS_MEASURED = Reason(
    "actions_measured",
    "In {count} of {all} frames no host had told the joints where to go: their action is where the "
    "arm was.",
)
_WHY: Final = {
    Cause.SILENT: EPISODE_SILENT,
    Cause.FAULT: EPISODE_FAULT,
    Cause.NO_GRIPPER: EPISODE_NO_GRIPPER,
}
_MOST_TOLD: Final = 20


class LeRobotDataset:
    """Writes episodes as a dataset; see `Sink`.

    Args:
        folder: The folder for the files; it exists and is empty.
        facts: The facts on the recorded arm.
        options: The rate, and the task of episodes that name none.
        marked: The episodes that are marked in the recording; those discarded are left out.

    Attributes:
        items: The number of frames.
        notes: What was left out, and why.

    Raises:
        ImportError: pyarrow is not installed.
    """

    def __init__(
        self, folder: Path, facts: ExportFacts, options: EpisodeOptions, marked: Sequence[Episode]
    ) -> None:
        import pyarrow as pa  # noqa: F401, PLC0415 - optional: said before the log is read

        self._folder, self._start_s = folder, facts.start_s
        self._fps, self._task = options.fps, options.task
        self._marked = marked
        self._sampler = InstantSampler(facts.codec, facts.start_s, options.fps)
        self.items = 0
        self.notes: list[Refusal] = []

    def write_span(self, history: History, span: TimeSpan) -> None:
        """Look at a piece of the log; see `Sink`."""
        self.items += self._sampler.take(history, span)

    def finish(self) -> None:
        """Cut the episodes, and write them.

        Raises:
            ExportError: There is none.
            OSError: The disk does not take them.
        """
        instants = self._sampler.instants()
        times_s = self._start_s + instants.numbers / self._fps
        marked = [each for each in self._marked if not each.discarded]
        if not self._marked:
            self.notes.append(EPISODES_UNMARKED(task=self._task))
            marked = [Episode(1, -np.inf)]
        episodes, left = [], []
        for each in marked:
            end_s = np.inf if each.end_s is None else each.end_s
            inside = (times_s >= each.begin_s) & (times_s <= end_s)
            for first, behind in _runs(inside, instants):
                cause = Cause(instants.causes[first])
                if cause is not Cause.NONE:
                    left.append(self._refusal(_WHY[cause], instants, first, behind - 1))
                elif behind - first < SHORTEST_S * self._fps:
                    left.append(self._refusal(EPISODE_SHORT, instants, first, behind - 1))
                else:
                    episodes.append((each.task or self._task, slice(first, behind)))
                if behind < len(inside) and inside[behind] and _is_gap(instants, behind):
                    left.append(self._refusal(EPISODE_SILENT, instants, behind - 1, behind))
        self.notes += left[:_MOST_TOLD]
        if len(left) > _MOST_TOLD:
            self.notes.append(EPISODES_MORE(count=len(left) - _MOST_TOLD))
        if not episodes:
            raise ExportError(ExportProblem.NO_EPISODE)
        self._write(instants, episodes)

    def abandon(self) -> None:
        """Do nothing: no file is held."""

    def _write(self, instants: Instants, episodes: Sequence[tuple[str, slice]]) -> None:
        places = np.concatenate([np.arange(part.start, part.stop) for _, part in episodes])
        unasked = ~np.isfinite(instants.asked[places, 0])
        if unasked.any():
            self.notes.append(ACTIONS_MEASURED(count=int(unasked.sum()), all=len(places)))
        asked = np.where(np.isfinite(instants.asked), instants.asked, instants.measured)
        gripper = bool(np.isfinite(instants.measured[places, GRIPPER]).all())
        columns = slice(None) if gripper else slice(GRIPPER)
        written = [
            EpisodeFrames(task, instants.measured[part, columns], asked[part, columns])
            for task, part in episodes
        ]
        write_dataset(self._folder, written, NAMES[columns], self._fps)
        self.items = len(places)

    def _refusal(self, reason: Reason, instants: Instants, first: int, last: int) -> Refusal:
        begin, end = instants.numbers[[first, last]] / self._fps
        return reason(begin=round(float(begin), 2), end=round(float(end), 2))


def _is_gap(instants: Instants, place: int) -> bool:
    """Return whether the instants just before this one are missing, as nothing was heard."""
    return bool(instants.numbers[place] - instants.numbers[place - 1] > 1)


def _runs(inside: NDArray[np.bool_], instants: Instants) -> list[tuple[int, int]]:
    """Return where runs of instants of one cause, without a gap, begin and end in a stretch."""
    kinds = np.where(inside, instants.causes.astype(int), -1)
    parted = (np.diff(kinds) != 0) | (np.diff(instants.numbers) > 1)
    ends = [*(np.flatnonzero(parted) + 1).tolist(), len(kinds)]
    firsts = [0, *ends[:-1]]
    return [(a, b) for a, b in zip(firsts, ends, strict=True) if a < b and kinds[a] >= 0]
