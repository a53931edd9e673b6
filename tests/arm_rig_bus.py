"""The two ends of the rig's bus: the arm's copies little, the program's says when it is done."""

from __future__ import annotations

import queue
import threading
import time
from collections import deque
from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import cast

import can
from can.interfaces.virtual import VirtualBus


class ArmBus(VirtualBus):
    """Where the arm is plugged in, and whoever else is on the bus.

    python-can copies a message deeply for each of those on the bus, and most of the work of a test
    would be that: an arm says 3,000 frames a second. Nobody on the rig changes what was received.

    Args:
        channel: Of the virtual bus.
        deaf: The buses that don't want what the arm says.
    """

    def __init__(self, channel: str, deaf: Collection[VirtualBus] = ()) -> None:
        super().__init__(channel=channel)
        self._deaf = [bus.queue for bus in deaf]
        self._kept: list[can.Message] | None = None

    def send(self, msg: can.Message, timeout: float | None = None) -> None:
        """Hand a message, which the caller no longer needs, to all who listen."""
        self._check_if_open()
        msg.timestamp = time.time()
        msg.channel = self.channel_id
        msg.is_rx = True
        if self._kept is None:
            self._hand_over([msg])
        else:
            self._kept.append(msg)

    @contextmanager
    def together(self) -> Iterator[None]:
        """What is sent meanwhile arrives at the end, at once: whoever waits is woken up once."""
        self._kept = []
        try:
            yield
        finally:
            kept, self._kept = self._kept, None
            if kept:
                self._hand_over(kept)

    def _hand_over(self, messages: Sequence[can.Message]) -> None:
        for inbox in self.channel:
            if inbox is self.queue or inbox in self._deaf:
                continue
            listener: object = inbox
            if isinstance(listener, _Inbox):
                listener.put_all(messages)
            else:
                for each in messages:
                    inbox.put(each)


class HostBus(VirtualBus):
    """Where the program is plugged in; its bus thread can be waited for, see :meth:`rest`.

    Attributes:
        is_holding: Whether the driver holds a frame, and whoever sends it; see :meth:`hold`.
    """

    def __init__(self, channel: str) -> None:
        super().__init__(channel=channel)
        self.channel.remove(self.queue)
        self._inbox = _Inbox()
        self.queue = cast("queue.Queue[can.Message]", self._inbox)  # it has what the others use
        self.channel.append(self.queue)
        self._free = threading.Event()
        self._free.set()
        self.is_holding = False

    @property
    def is_open(self) -> bool:
        """Whether it was not shut down yet."""
        return self._open

    @property
    def is_quiet(self) -> bool:
        """Whether nothing has arrived since the one who receives last found nothing."""
        return self._open and self._inbox.is_quiet

    def hold(self) -> None:
        """Have the driver keep whoever sends, whatever timeout it is given, until `let_go`."""
        self._free.clear()

    def let_go(self) -> None:
        """Let the frame that is held go out, and the others after it."""
        self.is_holding = False
        self._free.set()

    def send(self, msg: can.Message, timeout: float | None = None) -> None:
        """Hand a message to all others; the bus thread has to look what became of it."""
        if not self._free.is_set():
            self.is_holding = True
            self._free.wait()
        super().send(msg, timeout)
        self._inbox.disturb()

    # as prompt as the one above, by which the program knows whose thread may write a stop
    send.__module__ = VirtualBus.send.__module__

    def recv(self, timeout: float | None = None) -> can.Message | None:
        """The next message; see python-can."""
        self._check_if_open()
        return self._inbox.get(timeout)

    def rest(self, longest_s: float) -> bool:
        """Wait until the one who receives has taken in everything and found nothing more.

        It has been through its whole loop at least once since the call: what waited to be sent has
        been sent, and the last look at the bus was an empty one.

        Args:
            longest_s: How long to wait.

        Returns:
            Whether it came to that.
        """
        return self._inbox.rest(longest_s)


class _Inbox:
    """Messages that have arrived, in the place of the queue of python-can's virtual bus."""

    def __init__(self) -> None:
        self._messages: deque[can.Message] = deque()
        self._changed = threading.Condition()
        self._asked = 0
        self._answered = 0
        self._rested = 0
        self._looked = True
        self._arrivals = 0
        self._arrivals_at_rest = -1

    @property
    def is_quiet(self) -> bool:
        """See :attr:`HostBus.is_quiet`."""
        return self._arrivals == self._arrivals_at_rest

    def put(self, msg: can.Message, block: bool = True, timeout: float | None = None) -> None:
        """Take a message in; there is always room."""
        self.put_all([msg])

    def put_all(self, messages: Iterable[can.Message]) -> None:
        """Take some in; there is always room."""
        with self._changed:
            self._arrivals += 1
            self._messages.extend(messages)
            self._changed.notify_all()

    def disturb(self) -> None:
        """Something else has happened that the bus thread has not seen yet."""
        with self._changed:
            self._arrivals += 1

    def get(self, timeout: float | None) -> can.Message | None:
        """The next message; ``None`` when there is none in time."""
        if self._messages:
            self._looked = False
            return self._messages.popleft()
        if timeout is not None and timeout <= 0:
            return None
        with self._changed:
            if not self._messages:
                if self._answered != self._asked or not self._looked:
                    # an empty look: only after it is what came before shown
                    self._answered = self._asked
                    self._looked = True
                    return None
                self._rested = self._answered
                self._arrivals_at_rest = self._arrivals
                self._changed.notify_all()
                self._changed.wait_for(self._is_wanted, timeout)
            if not self._messages:
                return None
            self._looked = False
            return self._messages.popleft()

    def rest(self, longest_s: float) -> bool:
        """See :meth:`HostBus.rest`."""
        with self._changed:
            self._asked += 1
            asked = self._asked
            self._changed.notify_all()
            return self._changed.wait_for(lambda: self._rested >= asked, longest_s)

    def _is_wanted(self) -> bool:
        return bool(self._messages) or self._answered != self._asked
