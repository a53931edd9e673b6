"""Commands that the arm answers with 0x476: one at a time, each followed to its end.

The answer names a kind of setting, not which one of it, so a second of the same kind must wait. It
proves nothing either: where a value can be read back, the value read decides.
"""

from __future__ import annotations

import enum
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.context import Context
from armui.protocol.codes import SettingIndex
from armui.protocol.frame import Frame

if TYPE_CHECKING:
    from armui.protocol.codec import Message

_WAIT_S: Final = 0.5
_ATTEMPTS: Final = 2
"""A frame can get lost; every one of these commands may be given twice."""


@dataclass(frozen=True, slots=True)
class ReadBack:
    """How an order is checked.

    Attributes:
        query: The question.
        heard_since: Whether the arm has answered it since a monotonic time.
        against: What speaks against the order having been taken, by what was read.
    """

    query: Sequence[Frame]
    heard_since: Callable[[ArmState, float], bool]
    against: Callable[[ArmState], Refusal | None]


@dataclass(frozen=True, slots=True)
class Order:
    """A command that is answered.

    Attributes:
        frames: What to send; nothing, if something is only to be read.
        finished: Told ``None``, it is done, or why not.
        index: What the answer names; ``None``: no answer is awaited.
        against: What speaks against it by the answer itself.
        read_back: How it is checked, where that can be.
        ends_with_stop: It must not be given again to an arm that is being stopped.
        alters: What it sets that a motion counts on, as a key of the words for what is under way;
            ``None``: nothing moves differently for it.
    """

    frames: Sequence[Frame]
    finished: Callable[[Refusal | None], None]
    index: SettingIndex | None = None
    against: Callable[[Message], Refusal | None] = lambda _answer: None
    read_back: ReadBack | None = None
    ends_with_stop: bool = False
    alters: str | None = None


class _Phase(enum.Enum):
    ANSWER = enum.auto()
    READING = enum.auto()


class OrderLine:
    """Carries out orders in the order in which they came; a part of the controller."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._waiting: deque[Order] = deque()
        self._order: Order | None = None
        self._phase = _Phase.ANSWER
        self._attempt = 0
        self._sent_s = self._deadline_s = 0.0
        self._unanswered: Refusal | None = None
        context.connection.answered.connect(self._on_answer)

    @property
    def busy(self) -> bool:
        """Whether an order is under way or waits."""
        return self._order is not None

    @property
    def altering(self) -> str | None:
        """What of the arm is being set, or waits to be, that a motion counts on."""
        under_way = [] if self._order is None else [self._order]
        altered = (order.alters for order in (*under_way, *self._waiting))
        return next((what for what in altered if what is not None), None)

    def submit(self, order: Order) -> None:
        """Take an order on; it begins when those before it have ended."""
        self._waiting.append(order)
        if self._order is None:
            self._begin_next()

    def advance(self) -> None:
        """See whether something was read, or is overdue."""
        order = self._order
        if order is None:
            return
        if self._phase is _Phase.READING and order.read_back is not None:
            state = self._context.state()
            if order.read_back.heard_since(state, self._sent_s):
                against = order.read_back.against(state)
                self._end(against and (self._unanswered or against))
                return
        if self._context.clock() >= self._deadline_s:
            self._on_overdue(order)

    def halt(self) -> None:
        """Settings move nothing: a stop leaves them be, but for those that say otherwise."""
        dropped = [order for order in self._waiting if order.ends_with_stop]
        self._waiting = deque(order for order in self._waiting if not order.ends_with_stop)
        for order in dropped:
            order.finished(Refusal("ended_by_stop"))
        if self._order is not None and self._order.ends_with_stop:
            self._end(Refusal("ended_by_stop"))

    def forget(self) -> None:
        """The arm is gone: whatever waits will not be done."""
        waiting = [self._order, *self._waiting]
        self._order = None
        self._waiting.clear()
        for order in waiting:
            if order is not None:
                order.finished(Refusal("link_lost"))

    def _begin_next(self) -> None:
        if self._order is not None or not self._waiting:
            return
        self._order = self._waiting.popleft()
        self._unanswered = None
        self._begin(_Phase.ANSWER if self._order.frames else _Phase.READING)

    def _begin(self, phase: _Phase) -> None:
        self._phase = phase
        self._attempt = 0
        self._send()

    def _send(self) -> None:
        order = self._order
        if order is None:
            return
        frames = order.frames
        if self._phase is _Phase.READING and order.read_back is not None:
            frames = order.read_back.query
        self._attempt += 1
        now_s = self._context.clock()
        if self._attempt == 1:
            self._sent_s = now_s
        self._deadline_s = now_s + _WAIT_S
        if not self._context.connection.send(frames):
            self._end(Refusal("link_lost"))
        elif self._phase is _Phase.ANSWER and order.index is None:
            self._after_answer(order)

    def _on_answer(self, answer: Message) -> None:
        order = self._order
        if order is None or self._phase is not _Phase.ANSWER or answer.name != "SettingResponse":
            return
        if answer.signals["Index"] != order.index:
            return
        against = order.against(answer)
        if against is not None:
            self._end(against)
        else:
            self._after_answer(order)

    def _after_answer(self, order: Order) -> None:
        if order.read_back is None:
            self._end(None)
        else:
            self._begin(_Phase.READING)

    def _on_overdue(self, order: Order) -> None:
        if self._attempt < _ATTEMPTS:
            self._send()
        elif self._phase is _Phase.ANSWER and order.read_back is not None:
            # what the arm holds now decides, but if it can't be read the missing answer is told
            self._unanswered = Refusal("setting_unanswered")
            self._begin(_Phase.READING)
        elif self._phase is _Phase.ANSWER:
            self._end(Refusal("setting_unanswered"))
        else:
            self._end(self._unanswered or Refusal("setting_not_read_back"))

    def _end(self, refusal: Refusal | None) -> None:
        order, self._order = self._order, None
        if order is not None:
            order.finished(refusal)
        self._begin_next()
