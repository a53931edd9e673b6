"""The thread that plays a log in place of the one that owns a bus. It cannot send."""

from __future__ import annotations

import math
import threading
import time
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QThread, Signal

from armui.bus.link import BusReport, BusState
from armui.bus.playback.log_player import LogPlayer

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.arm.device import Device
    from armui.arm.other_hosts import OtherTraffic
    from armui.arm.state import ArmState
    from armui.bus.playback.curve_history import CurveHistory
    from armui.bus.playback.log_cursor import LogClock, ReplayedFrame
    from armui.bus.press import Press
    from armui.bus.samples import SampleRing
    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame
    from armui.session.frames import Channel
    from armui.session.session import Session
    from armui.telemetry.listener import Listener
    from armui.ways.passes import Pass

SLOWEST, FASTEST = 0.1, 20.0
_TURN_S: Final = 0.01
"""The pause between two looks at the clock."""
_END_MS: Final = 10_000
"""The longest time that the end of the program waits for the thread."""
_LONGEST_TURN_S: Final = 0.25
"""The most that a turn may count: after the computer slept or was busy the log goes on where it
was.
"""


class LogWorker(QThread):
    """Plays a log behind the interface of `BusWorker`; everything to be sent is refused.

    Args:
        device: The device that stands for the log.
        codec: The protocol to begin with.
        session: The log; the thread is the only one that reads it.
        channel: The channel to play.
        clock: The clock, set to the log time that is reached.
        number: The number of this thread in its reports.
        listeners: Objects that are told of every frame.

    Attributes:
        samples: Every joint feedback, while they are wanted.
        speed: Seconds of log time for each second.
        released: Set once the log is read no more.

    Signals:
        reported: A :class:`BusReport`, whenever the log begins or goes on elsewhere.
        answered: A :class:`Message` that answers something.
        found: A place that was asked for has been looked up; its number. :meth:`enter` goes there.
        moved: The replay has stepped, or stopped by itself at the end.
        failed: The log cannot be read any more, with the reason.
    """

    reported = Signal(object)
    answered = Signal(object)
    found = Signal(int)
    moved = Signal()
    failed = Signal(str)

    def __init__(
        self,
        device: Device,
        codec: Codec,
        session: Session,
        channel: Channel,
        clock: LogClock,
        *,
        number: int = 0,
        listeners: Sequence[Listener] = (),
    ) -> None:
        super().__init__()
        self.setObjectName(f"replay {device.name}")
        self._device = device
        self._number = number
        self._session = session
        self._clock = clock
        self._player = LogPlayer(
            session, channel, clock, codec=codec, listeners=listeners, answered=self.answered.emit
        )
        self.samples: SampleRing = self._player.processor.samples
        self.speed = 1.0
        self.released = threading.Event()
        self._wake = threading.Condition()
        self._closing = self._playing = self._filling = self._travelling = False
        self._steps = 0
        self._wanted: tuple[int, float | None] | None = None
        self._asked = 0
        self._at_hand: tuple[int, float, list[ReplayedFrame]] | None = None
        self._history: CurveHistory | None = None
        self._wants_history = self._history_due = False

    # As a bus worker --------------------------------------------------------------------------

    @property
    def idle(self) -> bool:
        """Always true: nothing ever waits to be sent."""
        return True

    @property
    def state(self) -> ArmState:
        """The arm's state; see `BusWorker.state`."""
        return self._player.processor.state

    @property
    def traffic(self) -> OtherTraffic:
        """Frames heard from hosts."""
        return self._player.processor.traffic

    @property
    def frames_dropped(self) -> int:
        """Always 0: a log drops nothing."""
        return 0

    def send(
        self,
        frames: Sequence[Frame],  # noqa: ARG002 - as a bus worker
        keep_s: float | None = None,  # noqa: ARG002
        command: int | None = None,  # noqa: ARG002
        passed: Pass | None = None,  # noqa: ARG002
        press: Press | None = None,  # noqa: ARG002
    ) -> bool:
        """Return false: nothing can be sent to a log."""
        return False

    def holds(self, command: int) -> bool:  # noqa: ARG002 - as a bus worker
        """Return false: nothing ever waits to be sent."""
        return False

    def void(self, newest: int) -> None:
        """Do nothing: no frame waits."""

    def send_urgent(self, frames: Sequence[Frame]) -> bool:  # noqa: ARG002 - as a bus worker
        """Return false: nothing can be sent to a log."""
        return False

    def set_listeners(self, listeners: Sequence[Listener]) -> None:
        """Replace the listeners that are told of every frame."""
        self._player.set_listeners(listeners)

    def use_codec(self, codec: Codec, *, forget: bool = True) -> None:
        """Change the codec; see `LogPlayer.use_codec`."""
        self._player.use_codec(codec, forget=forget)

    def close(self, within_ms: int) -> bool:
        """End the thread, and return whether it has ended within the time in milliseconds."""
        with self._wake:
            self._closing = True
            self._wake.notify()
        return self.wait(within_ms)

    def end_in_time(self) -> None:
        """End the thread before Qt destroys it, which would abort the program."""
        self.close(_END_MS)

    # Control of the replay; any thread --------------------------------------------------------

    @property
    def is_playing(self) -> bool:
        """True while the log plays."""
        return self._playing

    @property
    def last(self) -> ReplayedFrame | None:
        """The frame that was processed last."""
        return self._player.last

    def play(self, *, on: bool) -> None:
        """Play the log, or pause it."""
        with self._wake:
            self._playing = on
            self._wake.notify()

    def step(self) -> None:
        """Pause, and process one more frame."""
        with self._wake:
            self._playing = False
            self._steps += 1
            self._wake.notify()

    def ask_for(self, at_s: float | None) -> int:
        """Have a place looked up; ``None`` means the moment before the present one.

        Returns:
            The number with which :attr:`found` will be emitted.
        """
        with self._wake:
            self._asked += 1
            self._travelling = True
            self._wanted = self._asked, at_s
            self._steps = 0
            self._drop_history()
            self._wake.notify()
            return self._asked

    def enter(self, number: int) -> bool:
        """Go to the place that was looked up last, and return whether it is still the one wanted.

        The reports are emitted by the calling thread: slots connected in it have run when this
        returns.
        """
        at_hand = self._at_hand
        if at_hand is None or at_hand[0] != number or number != self._asked:
            return False
        self._player.enter(at_hand[1], at_hand[2])
        self._report(BusState.LOST)
        self._report(BusState.OPEN)
        with self._wake:
            self._filling = self._travelling = False
            self._wake.notify()
        return True

    def fill_curves(self) -> None:
        """Fill the curves with the stretch before this place."""
        with self._wake:
            self._filling = True
            self._wake.notify()

    def want_history(self, *, on: bool) -> None:
        """Set whether the curves shall show all that they can hold; reading it takes seconds."""
        if on != self._wants_history:
            with self._wake:
                self._wants_history = self._history_due = on
                self._wake.notify()

    @property
    def history(self) -> CurveHistory | None:
        """The reader of the curves' history, if one is at work."""
        return self._history

    @property
    def lacks_curves(self) -> bool:
        """True if the curves lack what led to this place, and will not get it by themselves."""
        return not self._filling and math.isinf(self.curves_from_s)

    @property
    def curves_from_s(self) -> float:
        """The curves are complete from this log time on."""
        return self._player.curves_from_s

    def _drop_history(self) -> None:
        """Stop reading the curves of the former place, which would delay going to the next one."""
        with self._wake:
            history, self._history, self._history_due = self._history, None, False
        if history is not None:
            history.end()

    # The thread -------------------------------------------------------------------------------

    def run(self) -> None:
        """Play until :meth:`close`."""
        self._report(BusState.OPENING)
        processor = self._player.processor
        with self._player.lock:
            processor.notifier.open(processor.codec, None)
        self._report(BusState.OPEN)
        try:
            self._run()
        except Exception as error:  # noqa: BLE001 - any error of a damaged file is reported
            self.failed.emit(str(error) or type(error).__name__)
        history, self._history = self._history, None
        if history is not None:
            history.end(wait=True)
        self._report(BusState.CLOSED)
        self.released.set()

    def _run(self) -> None:
        looked_s = time.monotonic()
        while True:
            if not self._playing:
                self._player.settle()
            with self._wake:
                if not (self._closing or self._is_something_to_do()):
                    plays = self._playing and not self._travelling
                    self._wake.wait(_TURN_S if plays else None)
                if self._closing:
                    return
                wanted, self._wanted = self._wanted, None
                steps = 0
                if not (self._travelling or self._filling):
                    steps, self._steps = self._steps, 0
            if wanted is not None:
                self._look_up(*wanted)
            # Nothing is played until the controller has taken over the place that was looked up
            # (`enter`).
            now_s = time.monotonic()
            if self._travelling or not self._go_on(steps, min(now_s - looked_s, _LONGEST_TURN_S)):
                now_s = time.monotonic()
            looked_s = now_s

    def _is_something_to_do(self) -> bool:
        here = not self._travelling and (
            self._filling or self._steps > 0 or self._is_history_to_do()
        )
        return self._wanted is not None or here

    def _go_on(self, steps: int, passed_s: float) -> bool:
        """Do the work due at the present place; return whether the log was played."""
        if self._is_history_to_do():
            self._see_to_history()
        if self._filling:
            self._fill()
        elif steps:
            for _ in range(steps):
                self._player.step()
            self.moved.emit()
        elif self._playing:
            self._play(passed_s)
            return True
        return False

    def _look_up(self, number: int, at_s: float | None) -> None:
        if at_s is None:
            at_s = self._player.before()
        if at_s is None:
            at_s = self._session.start_s
        at_s = min(max(at_s, self._session.start_s), self._session.end_s)
        self._at_hand = number, at_s, self._player.look_up(at_s)
        self.found.emit(number)

    def _fill(self) -> None:
        asked = self._asked
        self._player.fill(lambda: not self._closing and self._asked == asked)
        with self._wake:
            if self._asked == asked:
                self._filling = False
                self._history_due = self._wants_history
        self.moved.emit()

    def _is_history_to_do(self) -> bool:
        history = self._history
        if history is not None:
            return history.is_over
        return self._history_due and math.isfinite(self.curves_from_s)

    def _see_to_history(self) -> None:
        """Start reading the history once the near curves are shown; show it when it is read."""
        asked = self._asked
        with self._wake:
            history, self._history_due = self._history, False
        if history is None:
            begun = self._player.read_history(self._on_history)
            with self._wake:
                if self._asked == asked:
                    self._history = begun
            if begun is not None and self._history is not begun:
                begun.end()
        else:
            if history.is_whole:
                self._player.take_history(
                    history, lambda: self._asked == asked and not self._closing
                )
            with self._wake:
                if self._history is history:
                    self._history = None
        self.moved.emit()

    def _on_history(self) -> None:
        with self._wake:
            self._wake.notify()

    def _play(self, passed_s: float) -> None:
        asked = self._asked
        end_s = self._session.end_s
        until_s = min(self._clock() + passed_s * self.speed, end_s)
        self._player.play(
            until_s,
            self.speed,
            lambda: self._playing and not self._closing and self._asked == asked,
        )
        if self._clock() >= end_s and self._asked == asked:
            self._playing = False
            self.moved.emit()

    def _report(self, state: BusState) -> None:
        self.reported.emit(BusReport(state, self._device, None, self._number))
