"""The connection to one device: its bus thread, its arm, and the first questions to the arm."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from itertools import count
from typing import TYPE_CHECKING, Final, TypeAlias

from PySide6.QtCore import QObject, Signal

from armui.arm.device import Device
from armui.arm.other_hosts import OtherHosts, OtherTraffic
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, common_to_generations, is_fresh
from armui.bus.link import BusReport, BusState
from armui.control.events import Notice
from armui.control.link.arm_mark import ArmMark
from armui.control.link.link_state import LinkState
from armui.control.link.offsets import OffsetFollower
from armui.protocol.addressing import Addressing
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation, PiperModel
from armui.telemetry.events import Asker, EventKind, Level

if TYPE_CHECKING:
    from armui.bus.playback.log_worker import LogWorker
    from armui.bus.press import Press
    from armui.bus.samples import SampleRing
    from armui.bus.worker import BusWorker, Opener
    from armui.control.link.handshake import Handshake
    from armui.protocol.codec import Codec
    from armui.telemetry.listener import Listener
    from armui.telemetry.store import Telemetry
    from armui.ways.passes import Pass

CONNECTED = Notice("connected", "Device open: {device}", Level.INFO, EventKind.LINK, Asker.OPERATOR)
CONNECT_FAILED = Notice("connect_failed", "Not connected. {reason}", Level.FAULT, EventKind.LINK)
DISCONNECTED = Notice(
    "disconnected", "Disconnected from {device}", Level.INFO, EventKind.LINK, Asker.OPERATOR
)
LINK_LOST_NOTICE = Notice(
    "link_lost",
    "Connection to {device} lost: the arm is not heard, and it may be moving. The program keeps "
    "trying to reconnect. {reason}",
    Level.FAULT,
    EventKind.LINK,
)
RECONNECTED = Notice("reconnected", "Connected to {device} again", Level.DONE, EventKind.LINK)
BUS_BLOCKED = Notice("bus_blocked", "{device} sends nothing. {reason}", Level.FAULT, EventKind.LINK)
BUS_UNBLOCKED = Notice(
    "bus_unblocked",
    "{device} sends again. What had waited was dropped, but for a stop.",
    Level.DONE,
    EventKind.LINK,
)
BUS_DEAF_NOTICE = Notice("bus_deaf", "Nothing is heard. {reason}", Level.FAULT, EventKind.LINK)
BUS_HEARS = Notice("bus_hears", "{device} hears frames again", Level.DONE, EventKind.LINK)


Worker: TypeAlias = "BusWorker | LogWorker"
"""The thread that stands between the program and the frames."""
MakeWorker: TypeAlias = "Callable[[Device, Codec, int, Sequence[Listener]], Worker]"
"""Makes the worker of a device from its first codec, its number and the listeners."""

LINK_BREAKS: Final = frozenset({LINK_LOST_NOTICE, RECONNECTED})
"""The notices that a device went and came back."""
_CLOSE_MS: Final = 100
"""The window waits this long for a device to be closed; a busy driver ends later by itself."""
_IS_OPEN: Final = frozenset({BusState.OPEN, BusState.BLOCKED, BusState.DEAF})
_OPEN_NOTICES: Final = {
    BusState.LOST: RECONNECTED,
    BusState.BLOCKED: BUS_UNBLOCKED,
    BusState.DEAF: BUS_HEARS,
}
"""The notice for an open bus, by its state before."""


class Connection(QObject):
    """The connection to an arm.

    Args:
        opener: Opens a device.
        clock: Monotonic time in seconds.
        parent: The parent object.
        make_worker: Makes a worker in the place of the bus thread, as for a log.

    Attributes:
        device: The device that is open or being opened.
        model: The arm's model as the operator has chosen; while no device is open, that of the last
            arm.

    Signals:
        changed: A :class:`BusReport` and the notice for it.
        answered: A decoded message that answers a command.
        arm_came: An arm has come online: another one, or one that was switched off and on, for all
            that is known. Nothing that was read before holds for it.
    """

    changed = Signal(object, object)
    answered = Signal(object)
    arm_came = Signal()

    def __init__(
        self,
        opener: Opener,
        clock: Callable[[], float],
        parent: QObject | None = None,
        make_worker: MakeWorker | None = None,
    ) -> None:
        super().__init__(parent)
        self._make_worker = make_worker or self._bus_worker
        self._telemetry: Telemetry | None = None
        self._listeners: tuple[Listener, ...] = ()
        self._opener = opener
        self._clock = clock
        self._worker: Worker | None = None
        self._ending: list[Worker] = []
        self._bus_state = BusState.CLOSED
        self._online = False
        self._last_feedback_s: float | None = None
        self._worker_numbers = count(1)
        self._worker_number = 0
        self._arms = 0
        self._by_hand = OtherHosts()
        self.device: Device | None = None
        self.model = PiperModel.PIPER
        self.problem: Refusal | None = None
        self.handshake: Handshake | None = None
        self._codec: Codec | None = None
        self.offsets = OffsetFollower()

    @property
    def telemetry(self) -> Telemetry:
        """The record of feedback and commands over time, from the first device on."""
        if self._telemetry is None:
            # numpy and cantools are loaded with the first device: the window starts without them
            from armui.telemetry.store import Telemetry  # noqa: PLC0415

            self._telemetry = Telemetry(self._clock)
        return self._telemetry

    def add_listener(self, listener: Listener) -> None:
        """Add a listener that gets every frame, also of a device that is open already."""
        self._set_listeners((*self._listeners, listener))
        listener.know_generation(self.generation)

    def remove_listener(self, listener: Listener) -> None:
        """Remove a listener; frames on their way may still reach it."""
        self._set_listeners(tuple(each for each in self._listeners if each is not listener))

    def _set_listeners(self, listeners: tuple[Listener, ...]) -> None:
        self._listeners = listeners
        if self._worker is not None:
            self._worker.set_listeners((self.telemetry, *listeners))

    @property
    def codec(self) -> Codec:
        """The codec to use now; valid only while a device is open."""
        if self._codec is None:
            raise RuntimeError("no device is open: there is nothing to speak to")
        return self._codec

    @property
    def link(self) -> LinkState:
        """The state of the link to the arm."""
        if self._bus_state is BusState.OPENING:
            return LinkState.OPENING
        if self._worker is None:
            return LinkState.NO_DEVICE
        if self._bus_state is BusState.LOST:
            return LinkState.LOST
        return LinkState.ONLINE if self._online else LinkState.OFFLINE

    @property
    def frames_dropped(self) -> int:
        """The number of frames lost before they could be read, since the device was opened."""
        return 0 if self._worker is None else self._worker.frames_dropped

    @property
    def samples(self) -> SampleRing:
        """The joint angles as they come in; valid only while a device is open."""
        if self._worker is None:
            raise RuntimeError("no device is open: nothing comes in")
        return self._worker.samples

    @property
    def idle(self) -> bool:
        """True if everything sent has been handed to the device."""
        return self._worker is None or self._worker.idle

    @property
    def arm(self) -> int | None:
        """The number of the arm that is online: it grows whenever one comes, the same or another.

        ``None`` while no arm is online.
        """
        return self._arms if self.link is LinkState.ONLINE else None

    @property
    def mark(self) -> ArmMark:
        """The arm and the connection at this moment."""
        if self._worker is None:
            return ArmMark(arms=self._arms, model=self.model)
        state, handshake = self._worker.state, self.handshake
        gone = state.silences or self._another_answers(state)
        return ArmMark(
            self._worker_number,
            self._arms,
            self.arm is not None and not gone and is_fresh(self._last_feedback_s, self._clock()),
            self.model,
            self.offsets.addressing,
            None if handshake is None else handshake.identity,
        )

    @property
    def generation(self) -> Generation | None:
        """The protocol generation of the arm, or ``None`` while it is unknown."""
        return self.handshake.generation if self.handshake is not None else None

    def expect(self) -> None:
        """Count a device as being opened that will be in a moment."""
        self._bus_state = BusState.OPENING

    def open(self, device: Device) -> None:
        """Open a device; no other may be open."""
        # python-can and cantools are loaded with the first device: the window starts without them
        from armui.protocol.codec import Codec  # noqa: PLC0415

        self.device = device
        self.model = device.model
        self.problem = None
        self._codec = Codec(Generation.TWO)
        self._by_hand = OtherHosts()
        offset = 0 if device.recorded is None else device.recorded.feedback_offset
        self.offsets = OffsetFollower(Addressing(offset))
        self._bus_state = BusState.OPENING
        self._worker_number = next(self._worker_numbers)
        listeners = (self.telemetry, *self._listeners)
        self._worker = self._make_worker(device, self._codec, self._worker_number, listeners)
        self._pass_on_generation()
        self._worker.reported.connect(self._on_report)
        self._worker.answered.connect(self.answered)
        self._worker.start()

    def _bus_worker(
        self, device: Device, codec: Codec, number: int, listeners: Sequence[Listener]
    ) -> BusWorker:
        from armui.bus.worker import BusWorker, opener_after  # noqa: PLC0415 - see open()

        # without a parent: a thread that a driver keeps from ending must not be destroyed
        return BusWorker(
            device,
            opener_after(tuple(each.released for each in self._ending), self._opener),
            codec,
            self._clock,
            listen_only=device.listen_only,
            number=number,
            listeners=listeners,
        )

    def close(self) -> None:
        """Close the device and forget the arm."""
        if self._worker is not None:
            self._worker.reported.disconnect(self._on_report)
            self._worker.answered.disconnect(self.answered)
            self._worker.finished.connect(self._on_ended)
            self._ending.append(self._worker)
            self._worker.close(_CLOSE_MS)
            self._on_ended()
        self._worker = None
        self._bus_state = BusState.CLOSED
        self._online = False
        self._last_feedback_s = None
        self.device = None
        self.problem = None
        self.handshake = None

    def wait_until_sent(self, within_s: float) -> None:
        """Wait a moment for a busy driver to send waiting frames; only at the program's end."""
        deadline_s = time.monotonic() + within_s
        while not self.idle and time.monotonic() < deadline_s:
            time.sleep(0.005)

    def end(self, within_s: float) -> bool:
        """Close the device; return whether every thread has ended within the time."""
        self.close()
        deadline_s = time.monotonic() + within_s
        for worker in tuple(self._ending):
            worker.wait(max(0, round(1e3 * (deadline_s - time.monotonic()))))
        self._on_ended()
        if self._telemetry is not None and not self._ending:
            self._telemetry.release()
        return not self._ending

    def _on_ended(self) -> None:
        """Drop the threads that have ended; Qt aborts if a running one is destroyed."""
        for worker in [one for one in self._ending if one.isFinished()]:
            worker.wait()  # the signal comes a moment before the thread has ended
            self._ending.remove(worker)
            worker.deleteLater()

    @property
    def newest(self) -> ArmState:
        """The arm's state up to this moment, newer than at the last tick; for any thread."""
        worker = self._worker
        return ArmState() if worker is None else self._understood(worker.state)

    @property
    def heard_traffic(self) -> OtherTraffic:
        """The frames that other hosts were heard to send up to this moment."""
        return OtherTraffic() if self._worker is None else self._worker.traffic

    @property
    def traffic(self) -> OtherTraffic:
        """The frames of other hosts, with those sent by hand from here, which count as such."""
        return self.heard_traffic.joined(self._by_hand.traffic())

    def note_by_hand(self, frame: Frame) -> None:
        """Note that a frame typed by the operator is about to be sent to this device."""
        self._by_hand.note(frame.arbitration_id, frame.data, self._clock())

    def send(
        self,
        frames: Sequence[Frame],
        keep_s: float | None = None,
        command: int | None = None,
        passed: Pass | None = None,
        press: Press | None = None,
    ) -> bool:
        """Queue frames as one batch; return false if no device is open or it is listen-only.

        Args:
            frames: The frames in their order.
            keep_s: A batch that could not begin within this time is dropped.
            command: The number of the command it belongs to; see :meth:`void`.
            passed: The gate's pass, without which no motion frame is sent.
            press: The press it belongs to, where frames may be sent again.
        """
        worker = self._worker
        return worker is not None and worker.send(frames, keep_s, command, passed, press)

    def holds(self, command: int) -> bool:
        """Return whether a frame of a command has not been handed to the device yet."""
        return self._worker is not None and self._worker.holds(command)

    def void(self, newest: int) -> None:
        """Drop waiting frames of commands older than this one."""
        if self._worker is not None:
            self._worker.void(newest)

    def send_urgent(self, frames: Sequence[Frame]) -> bool:
        """Send frames at once, ahead of all that waits; return whether they could be sent."""
        return self._worker is not None and self._worker.send_urgent(frames)

    def follow_arm(self, now_s: float) -> ArmState:
        """Take in and return the arm's state; called regularly while a device is open."""
        if self._worker is None:
            return ArmState()
        state = self._worker.state
        if state.silences or self._another_answers(state):
            # The arm counts as offline for at least one tick, so that everything under way ends and
            # starts from nothing (S15).
            self._start_anew(self._worker, now_s)
            return self.newest
        # A handshake clears the state of the arm; without the time kept here the arm would look
        # silent.
        self._last_feedback_s = state.last_feedback_s or self._last_feedback_s
        is_open = self._bus_state in _IS_OPEN
        online = is_open and is_fresh(self._last_feedback_s, now_s)
        came = online and not self._online
        moved = is_open and self.offsets.follow_arm(state, now_s, came=came)
        self._online = online
        if came or moved:
            self._begin_handshake(self._worker, now_s)
        if came:
            self._arms += 1
            self.arm_came.emit()
        if self.handshake is not None and online:
            self.handshake.follow_arm(self._worker.state, now_s)
            self._codec = self.handshake.codec
        self._pass_on_generation()
        return self.newest

    def _pass_on_generation(self) -> None:
        for listener in (self.telemetry, *self._listeners):
            listener.know_generation(self.generation)

    def _understood(self, state: ArmState) -> ArmState:
        """Return the state without what cannot be read before the arm's protocol is known."""
        return state if self.generation is not None else common_to_generations(state)

    def _another_answers(self, state: ArmState) -> bool:
        """Return whether an arm has said something else of itself than the one of the handshake."""
        known = None if self.handshake is None else self.handshake.identity
        return (
            known is not None and state.identity is not None and known.contradicts(state.identity)
        )

    def _start_anew(self, worker: Worker, now_s: float) -> None:
        """Forget the arm: the next feedback is that of an arm that comes."""
        self.handshake = None
        self._online = False
        self._last_feedback_s = None
        self.offsets.listen_anew(now_s)
        self._pass_on_generation()
        worker.use_codec(self.codec)

    def _begin_handshake(self, worker: Worker, now_s: float) -> None:
        from armui.control.link.handshake import Handshake  # noqa: PLC0415 - see open()

        recorded = None if self.device is None else self.device.recorded
        known = None if recorded is None else Generation(recorded.generation)
        firmware = "" if recorded is None else recorded.firmware
        self.handshake = Handshake(worker, now_s, self.offsets.addressing, known, firmware)
        self._codec = self.handshake.codec

    def _on_report(self, report: BusReport) -> None:
        if self._worker is None or report.worker != self._worker_number:
            return  # a late report of a device that was closed meanwhile
        before, self._bus_state = self._bus_state, report.state
        if report.state is BusState.OPEN:
            self.problem = None
            self.changed.emit(report, _OPEN_NOTICES.get(before, CONNECTED))
        elif report.state in {BusState.BLOCKED, BusState.DEAF}:
            self.problem = report.problem
            deaf = report.state is BusState.DEAF
            self.changed.emit(report, BUS_DEAF_NOTICE if deaf else BUS_BLOCKED)
        elif report.state is BusState.LOST:
            self.problem = report.problem
            self._start_anew(self._worker, self._clock())
            if before is not BusState.LOST:
                self.changed.emit(report, LINK_LOST_NOTICE)
        elif report.state is BusState.FAILED:
            self._fail(report)

    def _fail(self, report: BusReport) -> None:
        problem, device = report.problem, report.device
        self.close()
        self.problem = problem
        self.changed.emit(BusReport(BusState.FAILED, device, problem), CONNECT_FAILED)
