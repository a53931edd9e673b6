"""Follows the one command of a part that is under way, from the press to its outcome.

A part says which frames are sent, what shows that they were obeyed, and what the operator is told.
That the command is under way, its record, and its end are kept here: once for commands that the
arm's feedback shows, once for those that the arm answers (0x476).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Generic, TypeVar

from armui.control.context import Context, ControllerPart
from armui.control.motion.motion_context import MotionContext
from armui.control.operations.started import Ending, ending_of
from armui.control.requests.request import NOTHING_LEFT_REPORT, Request, RequestOutcome

if TYPE_CHECKING:
    from armui.arm.refusal import Refusal
    from armui.control.operations.started import Started
    from armui.control.requests.reports import Report
    from armui.control.requests.transactions import Transaction, TransactionQueue
    from armui.protocol.codec import Message
    from armui.protocol.codes import SettingIndex

Kind = TypeVar("Kind")


@dataclass(frozen=True, slots=True)
class EndNotices:
    """The notices of a command's end, by how it ends.

    Attributes:
        done: The notice when the arm has done it.
        failed: Returns what is told when it has not, by the reason; the reason is ``None`` if the
            feedback did not show it in time. ``None`` tells nothing.
        ending: The way it ends when it is done.
        is_end: Asked when it is done: false if that is an interim result, and it goes on.
    """

    done: Report
    failed: Callable[[Refusal | None], Report | None]
    ending: Ending = Ending.DONE
    is_end: Callable[[], bool] = lambda: True


class PendingRequest(Generic[Kind]):
    """The request of a part until the arm's feedback shows it; a new one replaces it.

    Args:
        context: The context that the controller's parts share.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._kind: Kind | None = None
        self._request: Request | None = None
        self._notices: EndNotices | None = None
        self._answer: SettingIndex | None = None
        self._started: Started | None = None
        context.connection.answered.connect(self._on_answer)

    @property
    def kind(self) -> Kind | None:
        """The kind of the request that the feedback has not shown yet, or ``None``."""
        return self._kind

    @property
    def started(self) -> Started | None:
        """The record of the last request, ended or not; ``None`` if it was released."""
        return self._started

    def begin(
        self,
        kind: Kind,
        started: Started,
        request: Request,
        notices: EndNotices | None,
        *,
        sent: Report | None = None,
        answer: SettingIndex | None = None,
    ) -> None:
        """Send a request; the one before it is dropped.

        Args:
            kind: Its kind, shown by :attr:`kind`.
            started: The record of the command.
            request: The frames, and what shows that the arm has done it.
            notices: The notices at its end; ``None`` if the caller closes its record.
            sent: The notice given before its first frame, unless the part has given it itself.
            answer: The setting that an answer to it names: the answer is noted in the record.
        """
        self.drop()
        self._kind, self._started, self._request = kind, started, request
        self._notices, self._answer = notices, answer
        if sent is not None:
            notice, figures = sent
            self._context.emit_event(notice, started, **figures)
        # A receiver of the notice may have failed, which ends this request.
        if self._request is request:
            request.advance()

    def advance(self) -> RequestOutcome:
        """Follow the request in the feedback; return what has become of it, once if it ended."""
        outcome = RequestOutcome.WAITING if self._request is None else self._request.advance()
        if outcome is RequestOutcome.WAITING:
            return outcome
        self._kind = self._request = None
        notices = self._notices
        if notices is not None:
            done = outcome is RequestOutcome.DONE
            told = notices.done if done else notices.failed(None)
            if outcome is RequestOutcome.NOTHING_LEFT:
                told = NOTHING_LEFT_REPORT
            _end(self._context, self._started, notices.ending if done else Ending.FAILED, told)
        return outcome

    def drop(self) -> None:
        """Send nothing more of the request and await nothing, because something else ends it."""
        self._kind = self._request = None
        if self._started is not None:
            self._started.close(Ending.CUT_OFF)

    def release(self) -> Started | None:
        """Return the record of the request, which the caller then closes; see :meth:`drop`."""
        started, self._started = self._started, None
        self.drop()
        return started

    def _on_answer(self, answer: Message) -> None:
        """Note that the arm has answered; the answer does not show the effect."""
        index, started = self._answer, self._started
        if index is None or answer.name != "SettingResponse" or answer.signals["Index"] != index:
            return
        if started is not None and started.answer is None:
            started.answered(index, self._context.clock())


class RequestingPart(ControllerPart, Generic[Kind]):
    """A part that commands one thing at a time and follows it in the feedback.

    Args:
        context: The context that the controller's parts share.
    """

    def __init__(self, context: MotionContext) -> None:
        self._context = context
        self._pending: PendingRequest[Kind] = PendingRequest(context)

    def follow_arm(self) -> None:
        """Follow the request in the feedback until it is done or too late."""
        self._pending.advance()

    def halt(self) -> None:
        """Drop the pending request, because the arm is to stop."""
        self._drop_request()

    def forget_arm(self) -> None:
        """Drop the pending request, because the arm is gone."""
        self._drop_request()

    def _drop_request(self) -> None:
        self._pending.drop()


class PendingTransaction:
    """The command of a part until the queue of transactions has come to its end.

    The queue follows it, and drops it at a stop or with the arm; see
    :class:`armui.control.requests.transactions.TransactionQueue`.

    Args:
        context: The context that the controller's parts share.
        transactions: Carries out commands that are answered.

    Attributes:
        busy: True while a command was sent and its end is not known.
    """

    def __init__(self, context: Context, transactions: TransactionQueue) -> None:
        self._context = context
        self._transactions = transactions
        self._started: Started | None = None
        self.busy = False

    @property
    def started(self) -> Started | None:
        """The record of the last command, ended or not."""
        return self._started

    def begin(
        self, started: Started, transaction: Transaction, sent: Report, notices: EndNotices
    ) -> None:
        """Carry out a command.

        Args:
            started: Its record, which gets the arm's answer.
            transaction: The command, with neither a record nor what is called at its end.
            sent: The notice given before its first frame.
            notices: The notices at its end.
        """
        self.busy = True
        self.cut_off()
        self._started = started

        def finished(refusal: Refusal | None) -> None:
            self._finish(started, notices, refusal)

        notice, figures = sent
        self._context.emit_event(notice, started, **figures)
        self._transactions.submit(replace(transaction, finished=finished, started=started))

    def cut_off(self) -> None:
        """Close the record of the last command, because nothing more can be heard of it."""
        if self._started is not None:
            self._started.close(Ending.CUT_OFF)

    def _finish(self, started: Started, notices: EndNotices, refusal: Refusal | None) -> None:
        self.busy = False
        if refusal is not None:
            _end(self._context, started, ending_of(refusal), notices.failed(refusal))
        elif notices.is_end():
            _end(self._context, started, notices.ending, notices.done)
        else:
            notice, figures = notices.done
            self._context.report(started, notice, **figures)


def _end(context: Context, started: Started | None, ending: Ending, told: Report | None) -> None:
    """Close a record, and report its end to the operator if there is a notice for it."""
    if told is not None:
        notice, figures = told
        context.close(started, ending, notice, **figures)
    elif started is not None:
        started.close(ending)


class AnsweredPart:
    """A part that sends commands which are answered, one at a time.

    Args:
        context: The context that the controller's parts share.
        transactions: Carries out commands that are answered.
    """

    def __init__(self, context: Context, transactions: TransactionQueue) -> None:
        self._context = context
        self._pending = PendingTransaction(context, transactions)

    @property
    def busy(self) -> bool:
        """True while a command was sent and its end is not known."""
        return self._pending.busy
