"""The line of transactions and all it needs, with time in the test's hand."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

from armui.control.link.link_state import LinkState
from armui.control.operating_state import BUSY
from armui.control.requests.transactions import ReadBack, Transaction, TransactionQueue
from armui.protocol.codes import SettingIndex
from armui.protocol.frame import Frame

BEGIN_S = 0.25
STEP_S = 0.015625
INDEX = SettingIndex.END_LIMIT_SETTING
LOWER_INDEX = int(INDEX) - 1
OTHER_INDEX = int(INDEX) + 1
NO = BUSY()


def frame(number):
    return Frame(0x475, bytes([number]))


def question(number):
    return Frame(0x472, bytes([number]))


class Signal:
    """Stands for the connection's signal."""

    def connect(self, slot) -> None:
        self.emit = slot


class Connection:
    """Stands for the way to the arm."""

    def __init__(self, program: Program) -> None:
        self._program = program
        self.answered = Signal()
        self.arm: int | None = 1
        self.link = LinkState.ONLINE
        self.works = True

    def send(self, frames, keep_s=None) -> bool:
        self._program.sent.append((self._program.now_s - BEGIN_S, tuple(frames), keep_s))
        return self.works


class Program:
    """The line of transactions and all it needs, with what came of them.

    Attributes:
        sent: When, what, and how long it may wait.
        done: Name and outcome of each order, in the order in which they ended.
        heard_s: When the value that is read back was heard last, by order.
        looks: How often the operating state was computed anew.
    """

    def __init__(self) -> None:
        self.now_s = BEGIN_S
        self.sent: list[Any] = []
        self.done: list[Any] = []
        self.heard_s: dict[str, float] = {}
        self.connection = Connection(self)
        self.looks = 0
        context = SimpleNamespace(
            connection=self.connection,
            clock=lambda: self.now_s,
            state=lambda: self.heard_s,
            refresh=self._look,
        )
        self.line = TransactionQueue(cast("Any", context))

    def _look(self) -> None:
        self.looks += 1

    def order(self, name, *numbers, **fields) -> Transaction:
        """A command of some frames, or a question without any."""
        fields.setdefault("index", INDEX)
        return Transaction(
            tuple(frame(each) for each in numbers),
            lambda refusal: self.done.append((name, refusal and refusal.reason)),
            **fields,
        )

    def reading(self, name, number=None, against=None, *, proves=True) -> ReadBack:
        """How an order is checked: by a question, and what speaks against what was read."""
        return ReadBack(
            (question(number or 1),),
            lambda _state, since_s: self.heard_s.get(name, -1.0) >= since_s,
            lambda _state: against,
            **({} if proves else {"proves": False}),
        )

    def question(self, name, number=None, against=None) -> Transaction:
        """Something that is only to be read."""
        return self.order(name, read_back=self.reading(name, number, against))

    def heard(self, name) -> None:
        """The value that an order reads is heard now."""
        self.heard_s[name] = self.now_s

    def answer(self, index=INDEX, name="SettingResponse") -> None:
        """The arm answers."""
        message = SimpleNamespace(name=name, signals={"Index": int(index)})
        self.connection.answered.emit(message)

    def wait(self, seconds) -> None:
        """Advance every 1/64 s."""
        end_s = self.now_s + seconds
        while self.now_s < end_s:
            self.now_s += STEP_S
            self.line.follow_arm()

    @property
    def frames(self) -> list[Any]:
        """What was sent, each call's frames."""
        return [frames for _, frames, _ in self.sent]
