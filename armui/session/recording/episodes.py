"""The episodes that were marked in a recording, as lines of its sidecar.

An episode has a line of the kind ``episode`` when it begins, and another one of the same number
whenever something becomes known of it: its end, or that it was discarded. The last one counts. One
without an end goes on to the end of the recording, as after a killed program.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from armui.session.recording.sidecar import number_in, text_in
from armui.session.session import MarkKind, SessionMark

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from armui.session.recording.sidecar import Line

KIND: Final = "episode"


@dataclass(frozen=True, slots=True)
class Episode:
    """A part of a recording that shows a task once.

    Attributes:
        number: Its number in the recording, from 1.
        begin_s: Log time of its beginning.
        end_s: Log time of its end; ``None`` if it has none of its own.
        task: What is done in it, in the operator's words.
        discarded: True if the operator does not want it.
    """

    number: int
    begin_s: float
    end_s: float | None = None
    task: str = ""
    discarded: bool = False


def episode_line(episode: Episode) -> Line:
    """Return the sidecar's line of an episode."""
    return {
        "kind": KIND,
        "episode": episode.number,
        "begin_s": episode.begin_s,
        "end_s": episode.end_s,
        "task": episode.task,
        "discarded": episode.discarded,
    }


def episodes_of(lines: Iterable[Mapping[str, Any]]) -> list[Episode]:
    """Return the episodes in the lines of a sidecar, in the order of time, without damaged ones."""
    found: dict[int, Episode] = {}
    for line in lines:
        number, begin_s = line.get("episode"), number_in(line, "begin_s")
        if line["kind"] != KIND or not isinstance(number, int) or begin_s is None:
            continue
        end_s = number_in(line, "end_s")
        if end_s is not None and end_s < begin_s:
            continue
        task, discarded = text_in(line, "task"), line.get("discarded") is True
        found[number] = Episode(number, begin_s, end_s, task, discarded)
    return sorted(found.values(), key=lambda each: each.begin_s)


def episode_marks(lines: Iterable[Mapping[str, Any]]) -> list[SessionMark]:
    """Return the episodes in the lines of a sidecar as marks of a time line."""
    return [
        SessionMark(
            each.begin_s,
            MarkKind.DISCARDED if each.discarded else MarkKind.EPISODE,
            {
                "code": KIND,
                "episode": each.number,
                "task": each.task,
                "discarded": each.discarded,
                "ended_s": each.end_s,
            },
        )
        for each in episodes_of(lines)
    ]
