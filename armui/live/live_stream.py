"""The live stream, on the program's side: takes frames as a recording does, and hands them on.

The bus thread leaves its batches and goes on; a thread of the stream's own takes them to the
process that serves the viewers. Whatever that process or a viewer does, only this thread waits.
"""

from __future__ import annotations

import multiprocessing
import socket
import threading
import time
from collections import deque
from contextlib import suppress
from dataclasses import replace
from datetime import datetime
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Qt, Signal

from armui.arm.models import model_data
from armui.control.events import Event
from armui.interface.messages import english
from armui.live.messages import LIVE_ENDED, LIVE_NOT_SERVED, LiveArm, LiveState, LiveView
from armui.session.recording.lane import FrameLane
from armui.system.helper_process import OURS
from armui.telemetry.events import Level
from armui.telemetry.listener import Listener

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState
    from armui.protocol.codec import Codec
    from armui.protocol.generation import Generation
    from armui.session.recording.rows import RecordedFrame

_MOST_WAITING: Final = 4_096
"""Half a second of a full bus: older frames are of no use to a viewer."""
_MOST_EVENTS: Final = 256
_WATCHED_S: Final = 0.02
_UNWATCHED_S: Final = 0.25
"""The intervals at which frames are passed on, with a viewer and without one."""
_END_S: Final = 1.0
_LEVELS: Final = {Level.INFO: 20, Level.DONE: 20, Level.WARNING: 30, Level.FAULT: 40}
"""The levels of events as rcl_interfaces/Log has them."""


class LiveFrames(Listener):
    """The frames since the last change of codec, with that codec, so that no other decodes them.

    Attributes:
        newest: The codec, and its frames.
        generation: The protocol that the arm was found to speak.
        dropped: The number of frames dropped because they were not taken in time.
    """

    def __init__(self) -> None:
        self.newest: tuple[Codec | None, FrameLane] = (None, FrameLane(_MOST_WAITING))
        self.generation: Generation | None = None
        self._dropped_before = 0

    @property
    def dropped(self) -> int:
        """The number of frames dropped because they were not taken in time."""
        return self._dropped_before + self.newest[1].dropped

    def know_generation(self, generation: Generation | None) -> None:
        """Set the protocol that the arm was found to speak."""
        self.generation = generation

    def on_codec(self, codec: Codec) -> None:
        """Begin anew with another codec."""
        self._dropped_before = self.dropped
        self.newest = (codec, FrameLane(_MOST_WAITING))

    def on_heard(self, batch: Sequence[RecordedFrame]) -> None:
        """Add frames that others sent."""
        self.newest[1].on_heard(batch)

    def on_sent(self, batch: Sequence[RecordedFrame]) -> None:
        """Add frames that this program sent."""
        self.newest[1].on_sent(batch)


class LiveSender(threading.Thread):
    """Starts the process, passes it frames and events, and ends with it.

    Args:
        address: Host and port.
        frames: The frames.
        arm: The facts on the arm besides its codec.
        shift_s: The shift from the frames' times to seconds since 1970.
        on_state: Called in this thread with each :class:`LiveState`.

    Attributes:
        arm: The facts on the arm besides its codec.
        events: The events to be sent: time in ns, level, text.
    """

    def __init__(
        self,
        address: tuple[str, int],
        frames: LiveFrames,
        arm: LiveArm,
        shift_s: float,
        on_state: Callable[[LiveSender, LiveState], object],
    ) -> None:
        super().__init__(name="armui-live", daemon=True)
        self._address, self._frames, self._shift_s = address, frames, shift_s
        self._on_state = on_state
        self.arm = arm
        self.events: deque[tuple[int, int, str]] = deque(maxlen=_MOST_EVENTS)
        self._lock = threading.Lock()
        self._ends = False
        self._process: multiprocessing.process.BaseProcess | None = None

    def end(self) -> None:
        """End the process at once; the thread ends by that."""
        with self._lock:
            self._ends = True
            if self._process is not None:
                self._process.kill()

    def run(self) -> None:
        """Serve until :meth:`end`."""
        try:
            with suppress(OSError, EOFError):  # the process has ended
                self._serve()
            if not self._ends:
                self._on_state(self, LiveState(problem=LIVE_ENDED()))
        finally:
            self.end()
            if self._process is not None:
                self._process.join(_END_S)

    def _serve(self) -> None:
        # Imported here, so that the window starts without numpy and cantools.
        from armui.live.server import serve  # noqa: PLC0415
        from armui.session.recording.rows import in_order, rows_of  # noqa: PLC0415

        context = multiprocessing.get_context("spawn")  # a fork would inherit Qt and its threads
        ours, theirs = context.Pipe()
        process = context.Process(
            target=serve, args=(theirs, *self._address, self.arm), name=f"{OURS}live", daemon=True
        )
        with ours:
            with theirs, self._lock:
                if self._ends:
                    return
                process.start()
                self._process = process
            state = LiveState()
            arm, dropped = self.arm, 0
            while state.problem is None:
                if ours.poll(_WATCHED_S if state.watched else _UNWATCHED_S):
                    state = ours.recv()
                    self._on_state(self, state)
                elif dropped != self._frames.dropped:
                    dropped = self._frames.dropped
                    self._on_state(self, state)
                if not state.on:
                    continue
                codec, lane = self._frames.newest
                parts = None  # ``None`` until the arm's generation is known
                if codec is not None and codec.generation is self._frames.generation:
                    parts = codec.generation, codec.addressing, codec.firmware
                if arm != (arm := replace(self.arm, codec=parts)):
                    ours.send(arm)
                if taken := lane.take_frames():
                    ours.send(in_order(rows_of(taken)).shifted(self._shift_s).table)
                while self.events:
                    ours.send(self.events.popleft())
        self._ends = True


class LiveStream(QObject):
    """The live stream of one program.

    Args:
        controller: Has the frames, the events and the model.
        clock: Monotonic time in seconds, the controller's.

    Signals:
        changed: A :class:`LiveView`, when it differs.
    """

    changed = Signal(object)
    _state_changed = Signal(object, object)

    def __init__(
        self, controller: ArmController, clock: Callable[[], float], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._controller = controller
        self._clock = clock
        self._wanted: tuple[bool, int, bool] = (False, 0, False)
        self._sender: LiveSender | None = None
        self._frames = LiveFrames()
        self.view = LiveView()
        # The sender emits this signal in its own thread, which is no thread of Qt's.
        self._state_changed.connect(self._on_state_changed, Qt.ConnectionType.QueuedConnection)
        controller.operating_state_changed.connect(self._on_operating_state)
        controller.noticed.connect(self._on_noticed)

    def switch(self, *, on: bool, port: int, for_others: bool) -> None:
        """Start or stop serving; a stream with other settings is ended first.

        Args:
            on: True to serve it.
            port: The port.
            for_others: True to serve other computers, too.
        """
        wanted = on, port, for_others
        if wanted == self._wanted:
            return
        self.end(0.0)
        self._wanted = wanted
        if on:
            self._frames = LiveFrames()
            self._controller.bus.add_listener(self._frames)
            host = "0.0.0.0" if for_others else "127.0.0.1"  # noqa: S104 - the operator's choice
            shift_s = time.time() - self._clock()
            arm = _arm_of(self._controller.operating_state)
            self._sender = LiveSender(
                (host, port), self._frames, arm, shift_s, self._state_changed.emit
            )
            self._sender.start()
        self._show(LiveState())

    def end(self, within_s: float = _END_S) -> bool:
        """Serve it no more; return whether its thread has ended within the time."""
        sender, self._sender = self._sender, None
        self._wanted = (False, 0, False)
        if sender is None:
            return True
        self._controller.bus.remove_listener(self._frames)
        sender.end()
        sender.join(within_s)
        return not sender.is_alive()

    def _on_state_changed(self, sender: LiveSender, state: LiveState) -> None:
        if sender is not self._sender:
            return  # it was switched off meanwhile
        self._show(state)
        if state.problem is not None:
            self._controller.bus.remove_listener(self._frames)
            now, figures = datetime.now().astimezone(), {"reason": state.problem}
            self._controller.noticed.emit(Event(now, LIVE_NOT_SERVED, figures))

    def _show(self, state: LiveState) -> None:
        _on, port, for_others = self._wanted
        host = (own_address() if for_others else "127.0.0.1") if state.on else ""
        view = LiveView(state, f"{host}:{port}", for_others, self._frames.dropped)
        if view != self.view:
            self.view = view
            self.changed.emit(view)

    def _on_operating_state(self, now: OperatingState) -> None:
        if self._sender is not None:
            self._sender.arm = _arm_of(now)

    def _on_noticed(self, event: Event) -> None:
        if self._sender is not None and not event.notice.streams:
            text = english(event.notice.source, event.params)
            time_ns = int(event.at.timestamp() * 1e6) * 1_000
            self._sender.events.append((time_ns, _LEVELS[event.level], text))


def _arm_of(now: OperatingState) -> LiveArm:
    data = model_data(now.model)
    simulated = now.device is not None and now.device.simulated
    name = f"{data.name}, simulated" if simulated else data.name
    return LiveArm(name, now.model_fit.geometry, data.gripper.turned_deg)


def own_address() -> str:
    """Return this computer's address in its network, or its name; nothing is sent."""
    with suppress(OSError), socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asked:
        asked.connect(("192.0.2.1", 9))  # an address for documentation (RFC 5737)
        address: str = asked.getsockname()[0]
        return address
    return socket.gethostname()
