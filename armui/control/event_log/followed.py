"""Commands that are under way: which answer, which end belongs to which of them; pure."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from armui.control.event_log.commands import SETTINGS, CommandRule
from armui.control.events import EventCode

if TYPE_CHECKING:
    from armui.telemetry.events import EventEntry

_ANSWER_WITHIN_S: Final = 3.0
_MOST: Final = 64
_INTERIM: Final = frozenset(
    {
        *(EventCode.STOP_UNCONFIRMED, EventCode.STOP_LAPSED),
        *(EventCode.LINKAGE_ANSWERED, EventCode.LINKAGE_ANSWERED_INPUT),
    }
)
"""What is not the last word on a command."""


@dataclass(frozen=True, slots=True)
class Followed:
    """A command that something is still expected of.

    Attributes:
        number: Of its entry.
        code: Of its notice.
        rule: How it is followed.
        sent_s: Monotonic time.
        params: The figures of its notice.
        motion: The number of the motion command, where it is one and was sent.
    """

    number: int
    code: str
    rule: CommandRule
    sent_s: float
    params: Mapping[str, object]
    motion: int | None = None


class FollowedCommands:
    """The newest commands that wait for an answer or their end."""

    def __init__(self) -> None:
        self._ending: list[Followed] = []
        self._unanswered: list[Followed] = []

    def begin(self, rule: CommandRule, entry: EventEntry, motion: int | None) -> None:
        """A command was given.

        Args:
            rule: How it is followed.
            entry: In the log.
            motion: The number of the authority's command, where it moves the arm.
        """
        followed = Followed(entry.number, entry.code, rule, entry.newest_s, entry.params, motion)
        self._ending = [each for each in self._ending if each.number != entry.number]
        if rule.ends or rule.moves:
            self._ending = [*self._ending[-_MOST:], followed]
        if rule.answer is not None or entry.code == EventCode.SETTINGS_SENT:
            self._unanswered = [*self._unanswered[-_MOST:], followed]

    def on_notice(self, code: EventCode, params: Mapping[str, object]) -> Followed | None:
        """The command that a notice tells the end of, the newest first."""
        for followed in reversed(self._ending):
            rule = followed.rule
            if code not in rule.ends:
                continue
            if rule.same is not None and params.get(rule.same) != followed.params.get(rule.same):
                continue
            if code not in _INTERIM:
                self._ending.remove(followed)
            return followed
        return None

    def on_answer(self, index: int, now_s: float) -> Followed | None:
        """The command that an answer of the arm is about, the oldest first."""
        self._unanswered = [
            each for each in self._unanswered if now_s - each.sent_s <= _ANSWER_WITHIN_S
        ]
        for followed in self._unanswered:
            if followed.code == EventCode.SETTINGS_SENT:
                if index in SETTINGS:
                    return followed  # one frame after the other is answered
            elif followed.rule.answer == index:
                self._unanswered.remove(followed)
                return followed
        return None

    def motions(self) -> list[Followed]:
        """The motions that are under way."""
        return [each for each in self._ending if each.rule.moves]

    def set_out(self, followed: Followed, motion: int) -> None:
        """What a held button has begun has been sent, as this motion command."""
        self._ending[self._ending.index(followed)] = replace(followed, motion=motion)

    def end(self, followed: Followed) -> None:
        """Its end is known."""
        if followed in self._ending:
            self._ending.remove(followed)

    def forget(self) -> None:
        """No answer will come."""
        self._ending.clear()
        self._unanswered.clear()
