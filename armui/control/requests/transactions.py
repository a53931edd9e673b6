"""Commands that the arm answers with 0x476: one at a time, each followed to its end.

The answer names a kind of setting, not which one of it, so a second of the same kind must wait. It
proves nothing either: where a value can be read back, the value read decides.

A command never waits for a question: one that is being read is set aside. A command that cannot
begin within a second of the operator's press is dropped, and what was checked then is checked again
before each frame (safety S14).
"""

from __future__ import annotations

import enum
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.context import Context, ControllerPart
from armui.control.link.link_state import LINK_LOST, why_unreachable
from armui.control.operations.started import (
    ARM_CHANGED,
    ENDED_BY_STOP,
    ORDER_TOO_LATE,
    SETTING_NOT_READ_BACK,
    SETTING_UNANSWERED,
)
from armui.protocol.codes import SettingIndex
from armui.protocol.frame import Frame

if TYPE_CHECKING:
    from armui.control.operations.started import Started
    from armui.protocol.codec import Message

_WAIT_S: Final = 0.5
"""An answer or a value read back is awaited this long before the frames are sent again."""
_ATTEMPTS: Final = 2
"""The most times to send: a frame can be lost, and most of these may be repeated."""
_WITHIN_S: Final = 1.0
"""A command is sent within this time of the press, or not at all."""
_KEEP_S: Final = 0.5
"""A frame may wait in the program for this time, unless a time limit comes first."""


@dataclass(frozen=True, slots=True)
class ReadBack:
    """The check of a transaction by reading back.

    Attributes:
        query: The question.
        heard_since: Returns whether the arm has answered it since a monotonic time.
        against: Returns why the setting has not been taken, by the values read, or ``None``.
        proves: True if reading the wanted values proves that they were taken: not if the arm held
            them before.
    """

    query: Sequence[Frame]
    heard_since: Callable[[ArmState, float], bool]
    against: Callable[[ArmState], Refusal | None]
    proves: bool = True


@dataclass(frozen=True, slots=True)
class Transaction:
    """A command that the arm answers.

    Attributes:
        frames: The frames to send; empty if something is only to be read.
        finished: Called at the end with ``None``, or with the reason of its failure.
        index: The setting that the answer names; ``None`` if no answer is awaited.
        against: Returns why it has failed by the answer itself, or ``None``.
        read_back: The check by reading back, where that is possible.
        recheck: Asked before each sending of the frames, by the newest operating state: the
            reason against it now, or ``None``.
        attempts: The most times to send the frames while no answer comes.
        ends_with_stop: True if it must not be repeated to an arm that is being stopped.
        alters: The setting it changes that motions rely on, by its key in the words for activities;
            ``None`` if motions do not depend on it.
        started: The record of the command that it carries out, which gets the arm's answer.
    """

    frames: Sequence[Frame]
    finished: Callable[[Refusal | None], None] = lambda _refusal: None
    index: SettingIndex | None = None
    against: Callable[[Message], Refusal | None] = lambda _answer: None
    read_back: ReadBack | None = None
    recheck: Callable[[], Refusal | None] = lambda: None
    attempts: int = _ATTEMPTS
    ends_with_stop: bool = False
    alters: str | None = None
    started: Started | None = None


class _Phase(enum.Enum):
    ANSWER = enum.auto()
    READING = enum.auto()


@dataclass(eq=False, slots=True)
class _Task:
    """A transaction and how far it has come.

    Attributes:
        arm: Which arm was online when it was submitted; ``None``: none was.
        begin_by_s: It is dropped if it has not begun by then; ``None`` for a further step of an
            action that has begun, and for a question.
        send_by_s: No frame that commands is sent later.
        sent_s: When the first frame of this phase was sent; infinite before.
        unanswered: The reason to tell if the value cannot be read back either.
    """

    transaction: Transaction
    arm: int | None
    begin_by_s: float | None
    phase: _Phase
    attempt: int = 0
    send_by_s: float = 0.0
    sent_s: float = inf
    deadline_s: float = 0.0
    unanswered: Refusal | None = None


class TransactionQueue(ControllerPart):
    """Carries out transactions one after the other.

    Commands go in the order in which they came, the first step of an action before the further
    steps of an older one, and every command before every question.

    Attributes:
        alterations: The number of changes to settings that motions rely on; a check made before the
            last change no longer holds.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._commands: deque[_Task] = deque()
        self._readings: deque[_Task] = deque()
        self._task: _Task | None = None
        self.alterations = 0
        context.connection.answered.connect(self._on_answer)

    @property
    def altering(self) -> str | None:
        """The setting being changed, or waiting to be, that motions rely on, or ``None``."""
        altered = (task.transaction.alters for task in self._all())
        return next((what for what in altered if what is not None), None)

    def submit(self, *transactions: Transaction) -> None:
        """Queue the transactions of one action.

        Its first command begins within a second or is dropped; the others follow it.
        """
        now_s = self._context.clock()
        arm = self._context.connection.arm
        begin_by_s: float | None = now_s + _WITHIN_S
        for transaction in transactions:
            if transaction.frames:
                self._commands.append(_Task(transaction, arm, begin_by_s, _Phase.ANSWER))
                begin_by_s = None
            else:
                self._readings.append(_Task(transaction, arm, None, _Phase.READING))
        self._set_reading_aside()
        self._begin_next()

    def follow_arm(self) -> None:
        """Follow the answers and readings under way, and end those overdue."""
        self._drop_late()
        task = self._task
        if task is None:
            return
        read_back = task.transaction.read_back
        if task.phase is _Phase.READING and read_back is not None:
            state = self._context.state()
            if read_back.heard_since(state, task.sent_s):
                against = read_back.against(state)
                if against is not None or not read_back.proves:
                    against = task.unanswered or against
                self._end(against)
                return
        if self._context.clock() >= task.deadline_s:
            self._on_overdue(task)

    def halt(self) -> None:
        """Drop the transactions that end with a stop; settings move nothing and stay."""
        self._drop(lambda task: task.transaction.ends_with_stop, ENDED_BY_STOP())
        if self._task is not None and self._task.transaction.ends_with_stop:
            self._end(ENDED_BY_STOP())

    def forget_arm(self) -> None:
        """Drop everything that waits, because the arm is gone."""
        tasks = self._all()
        self._task = None
        self._commands.clear()
        self._readings.clear()
        for task in tasks:
            task.transaction.finished(LINK_LOST())

    def _all(self) -> list[_Task]:
        under_way = [] if self._task is None else [self._task]
        return [*under_way, *self._commands, *self._readings]

    def _drop_late(self) -> None:
        now_s = self._context.clock()
        self._drop(
            lambda task: task.begin_by_s is not None and now_s >= task.begin_by_s,
            ORDER_TOO_LATE(),
        )

    def _drop(self, is_dropped: Callable[[_Task], bool], reason: Refusal) -> None:
        dropped = [task for task in (*self._commands, *self._readings) if is_dropped(task)]
        self._commands = deque(task for task in self._commands if not is_dropped(task))
        self._readings = deque(task for task in self._readings if not is_dropped(task))
        for task in dropped:
            task.transaction.finished(reason)

    def _set_reading_aside(self) -> None:
        """Interrupt a reading for a new action; the question is asked again afterwards."""
        task = self._task
        new = any(waiting.begin_by_s is not None for waiting in self._commands)
        if new and task is not None and task.phase is _Phase.READING:
            self._readings.appendleft(task)
            self._task = None

    def _begin_next(self) -> None:
        if self._task is not None:
            return
        self._drop_late()
        new = next((task for task in self._commands if task.begin_by_s is not None), None)
        if new is not None:
            self._commands.remove(new)
            self._task = new
        elif self._commands or self._readings:
            self._task = (self._commands or self._readings).popleft()
        else:
            return
        if self._task.phase is _Phase.ANSWER:
            begun_s = self._context.clock()
            self._task.send_by_s = self._task.begin_by_s or begun_s + _WITHIN_S
            self._task.begin_by_s = None
        self._begin(self._task, self._task.phase)

    def _begin(self, task: _Task, phase: _Phase) -> None:
        task.phase = phase
        task.attempt = 0
        self._send(task)

    def _send(self, task: _Task) -> None:
        transaction, connection = task.transaction, self._context.connection
        now_s = self._context.clock()
        if task.phase is _Phase.READING:
            refusal = None if connection.arm is None else self._why_another_arm(task)
            frames = () if transaction.read_back is None else transaction.read_back.query
            keep_s = _KEEP_S
        else:
            self._context.refresh()
            refusal = self._why_another_arm(task) or transaction.recheck()
            frames = transaction.frames
            keep_s = min(_KEEP_S, task.send_by_s - now_s)
        if refusal is not None:
            self._end(refusal)
            return
        task.attempt += 1
        if task.attempt == 1:
            task.sent_s = now_s
            self.alterations += task.phase is _Phase.ANSWER and transaction.alters is not None
        task.deadline_s = now_s + _WAIT_S
        if not connection.send(frames, keep_s):
            self._end(LINK_LOST())
        elif task.phase is _Phase.ANSWER and transaction.index is None:
            self._after_answer(task)

    def _why_another_arm(self, task: _Task) -> Refusal | None:
        """Return why the connected arm is not the one the command was meant for, or ``None``."""
        connection = self._context.connection
        if task.arm is None or task.arm == connection.arm:
            return None
        return why_unreachable(connection.link) or ARM_CHANGED()

    def _on_answer(self, answer: Message) -> None:
        task = self._task
        if task is None or task.phase is not _Phase.ANSWER or answer.name != "SettingResponse":
            return
        if answer.signals["Index"] != task.transaction.index:
            return
        if task.transaction.started is not None:
            task.transaction.started.answered(int(answer.signals["Index"]), self._context.clock())
        against = task.transaction.against(answer)
        if against is not None:
            self._end(against)
        else:
            self._after_answer(task)

    def _after_answer(self, task: _Task) -> None:
        if task.transaction.read_back is None:
            self._end(None)
        else:
            self._begin(task, _Phase.READING)

    def _on_overdue(self, task: _Task) -> None:
        reading = task.phase is _Phase.READING
        in_time = reading or self._context.clock() < task.send_by_s
        if task.attempt < (_ATTEMPTS if reading else task.transaction.attempts) and in_time:
            self._send(task)
        elif not reading and task.transaction.read_back is not None:
            # Without an answer the value now in the arm decides; if it cannot be read, the missing
            # answer is told.
            task.unanswered = SETTING_UNANSWERED()
            self._begin(task, _Phase.READING)
        elif not reading:
            self._end(SETTING_UNANSWERED())
        else:
            self._end(task.unanswered or SETTING_NOT_READ_BACK())

    def _end(self, refusal: Refusal | None) -> None:
        task, self._task = self._task, None
        if task is not None:
            task.transaction.finished(refusal)
        self._begin_next()
