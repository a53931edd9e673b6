"""A simulated arm and the real controller on a virtual bus, with time in the test's hand.

The firmware's clock is the only clock: the bus thread and the controller read it, so half a
second of silence takes no half second, and nothing ever sleeps.
"""

import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future
from contextlib import contextmanager
from dataclasses import replace
from typing import Protocol

import can
from can.interfaces.virtual import VirtualBus
from PySide6.QtCore import QCoreApplication, QDeadlineTimer

from armui.arm.device import Device
from armui.control.arm_controller import ArmController
from armui.control.events import Event
from armui.control.link.link_state import LinkState
from armui.protocol.codec import Codec, Message
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation, PiperModel
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.accepted import accepted
from tests.arm_rig_bus import ArmBus, HostBus

STEP_S = 0.02
TIMEOUT_MS = 5000
_STEP_NS = round(STEP_S * 1e9)
_LOSS_MS = 1000
_POLL_S = 0.0005
_REST_S = 0.1


def thin_out(firmware: Firmware) -> None:
    """Let an arm tell everything once a step at most."""
    for slot in firmware._schedule._slots:
        slot.period_ns = max(slot.period_ns, _STEP_NS)


def tell_together(firmware: Firmware) -> None:
    """Let it do so at the end of the step, all at once: it is made to move as often as it tells."""
    thin_out(firmware)
    schedule = firmware._schedule
    for slot in schedule._slots:
        slot.due_ns = -(-slot.due_ns // _STEP_NS) * _STEP_NS
    schedule.next_ns = min(slot.due_ns for slot in schedule._slots)


def at_once(work: Callable[[], object]) -> Future[object]:
    """Have the gate check a long way within the call: no real time passes here."""
    done: Future[object] = Future()
    done.set_result(work())
    return done


class Company(Protocol):
    """Somebody else on the bus."""

    def step(self, dt_s: float) -> None:
        """Let time pass."""


class ArmRig:
    """What a test holds in its hands.

    Attributes:
        firmware: The simulated arm.
        controller: The program's own controller, connected to it on request.
        events: Every notice so far.
        channel: Of the virtual bus: whoever else is on it opens the same.
        powered: Whether the arm's time passes; see `Firmware.switch_off` for its supply.
        company: Whoever else is on the bus and lives by this clock; its time passes first.
    """

    def __init__(self, channel: str, generation: Generation = Generation.TWO) -> None:
        self.channel = channel
        self.time_s = 1000.0
        self.checked_s = 0.0
        self.firmware = Firmware(generation)
        self._ear = VirtualBus(channel)
        self._arm_bus = ArmBus(channel, deaf=[self._ear])
        self.node = Node(self.firmware, self._arm_bus)
        self._repeats = True
        self.powered = True
        self.company: list[Company] = []
        self.broken: Exception | None = None
        self._untold: Exception | None = None  # nobody told it in time, and nobody will
        self._host_bus: HostBus | None = None
        self._codec = Codec(generation)
        self.device = Device("virtual", channel, None, simulated=True, generation=int(generation))
        self.controller = ArmController(
            self._open,
            [self.device],
            find=list,
            clock=lambda: self.time_s,
            wait=self._pass,
            background=self._at_once,
        )
        self.events: list[Event] = []
        self.controller.noticed.connect(self.events.append)

    def _at_once(self, work: Callable[[], object]) -> Future[object]:
        began_s = time.thread_time()
        done = at_once(work)
        self.checked_s += time.thread_time() - began_s
        return done

    @contextmanager
    def _open(self, device: Device) -> Iterator[can.BusABC]:
        if self.broken is not None:
            raise self.broken
        with HostBus(str(device.channel)) as bus:
            self._listen_closely(bus)
            yield bus

    def _listen_closely(self, bus: HostBus) -> None:
        """The program has opened its bus."""
        self._host_bus = bus

    def unplug(self, error: Exception) -> None:
        """The adapter is gone: using it, and opening it again, fails."""
        self.broken = error

        def broken(*_args, **_kwargs):
            raise error

        self._host_bus.recv = broken

    def plug_in(self) -> None:
        """The adapter is back."""
        self.broken = None

    def hold_driver(self) -> None:
        """The program's driver keeps the next frame, and whoever sends it, until `free_driver`."""
        self._host_bus.hold()

    def free_driver(self) -> None:
        """The driver lets go of the frame that it keeps."""
        self._host_bus.let_go()

    def lie(
        self,
        joints_deg: Sequence[float],
        model: PiperModel = PiperModel.PIPER,
        version: str | None = None,
    ) -> None:
        """Let an arm that is not connected yet be found at these angles, in degrees.

        Args:
            joints_deg: Joint 1 first.
            model: Which arm of the family it is.
            version: Of its firmware, by default today's.
        """
        assert self.controller.operating_state.link is LinkState.NO_DEVICE
        generation = self.firmware.generation
        if version is None:
            self.firmware = Firmware(generation, joints_deg=joints_deg, model=model)
        else:
            self.firmware = Firmware(
                generation, joints_deg=joints_deg, model=model, version=version
            )
        if not self._repeats:
            tell_together(self.firmware)
        self.node = Node(self.firmware, self._arm_bus)

    def repeat_nothing(self) -> None:
        """Have the arm tell everything once a step, and not four times at one moment of the clock.

        Half of what a test costs is feedback that says the same again. Who steps by less than
        `STEP_S`, or counts frames, leaves it as it is.
        """
        self._repeats = False
        tell_together(self.firmware)

    def connect(self, model: PiperModel = PiperModel.PIPER) -> None:
        """Connect as an operator would, and wait until the arm has been asked everything."""
        self.controller.connect_device(replace(self.device, model=model))
        self.run_until(lambda: "limits_read" in self.codes())
        self.run_until(lambda: None not in self.controller.operating_state.enabled)

    def step(self, dt_s: float = STEP_S) -> None:
        """Let time pass on both sides until each has heard what the other said."""
        self._put_off_tick()
        self._settle_what_was_said()
        self._pass(dt_s)
        self.controller.tick()
        self._put_off_tick()
        self._settle_what_was_said()

    def _put_off_tick(self) -> None:
        """Have the controller's timer tick only where nobody steps, and not by the computer's pace.

        On a busy computer it would be due in every step: most of what a test costs, for nothing.
        """
        timer = self.controller._timer
        if timer.isActive():
            timer.start()

    def _pass(self, dt_s: float) -> None:
        """Let time pass until the program has heard what the others said meanwhile."""
        self._put_off_tick()
        self.time_s += dt_s
        for each in self.company:
            each.step(dt_s)
        if self.powered:
            with self._arm_bus.together():
                self.node.poll(dt_s)
        self._settle()

    def _settle_what_was_said(self) -> None:
        """As below, where no time has passed: nothing to wait for if nobody spoke since."""
        if self._is_quiet:
            QCoreApplication.processEvents()
            if self._is_quiet:
                return
        self._settle()

    @property
    def _is_quiet(self) -> bool:
        """Whether the bus thread has seen all there is; time that passes is left to it to see."""
        bus = self._host_bus
        if bus is None or not bus.is_quiet or not self._sends_nothing or self._adrift:
            return False
        return not self.controller._connection._worker._processor._next_codecs

    @property
    def _sends_nothing(self) -> bool:
        """Whether nothing is to be sent, or the driver holds up all that is.

        The sending thread has let go of the driver then: on a busy computer it may hold it for
        longer than a stop would wait.
        """
        if self._host_bus is not None and self._host_bus.is_holding:
            return True
        connection = self.controller._connection
        worker = connection._worker
        if worker is None or not connection.idle:
            return connection.idle
        outbox = worker._outbox
        return outbox._port is None or bool(outbox._changed._waiters)

    def _settle(self) -> None:
        """Until nothing is on its way any more, in either direction."""
        began_s, drew_s = time.monotonic(), 0.0
        at_rest = False
        while not at_rest:
            # asked each time: what happens meanwhile may close the device
            if self._adrift:
                self._until_the_loss_is_told()
                return
            at_rest = self._bus_rests() and self._sends_nothing
            # large windows take seconds to be drawn on a busy computer: not the bus thread's doing
            draws_s = time.monotonic()
            self._put_off_tick()
            QCoreApplication.processEvents()
            drew_s += time.monotonic() - draws_s
            # what was heard may have been answered at once
            at_rest = at_rest and self._sends_nothing
            late = 1e3 * (time.monotonic() - began_s - drew_s) > TIMEOUT_MS
            assert at_rest or not late, "the bus thread does not come to rest"

    def _bus_rests(self) -> bool:
        """Give the bus thread the time to take in and send what there is; whether it has."""
        bus = self._host_bus
        if bus is None or not bus.is_open:
            time.sleep(_POLL_S)  # it is being opened
            return False
        return bus.rest(_REST_S)

    def _until_the_loss_is_told(self) -> None:
        """The bus thread finds out by itself that its adapter is gone."""
        deadline = QDeadlineTimer(_LOSS_MS)
        gone = {LinkState.NO_DEVICE, LinkState.LOST}
        while self.controller.operating_state.link not in gone and not deadline.hasExpired():
            QCoreApplication.processEvents()
            if self._untold is self.broken is not None:
                return
            time.sleep(_POLL_S)
        self._untold = self.broken if deadline.hasExpired() else None

    @property
    def _adrift(self) -> bool:
        """Whether there is no bus on which anything could be on its way."""
        lost = self.controller.operating_state.link in (LinkState.NO_DEVICE, LinkState.LOST)
        return lost or self.broken is not None

    def run(self, seconds: float) -> None:
        """Let so much time pass."""
        for _ in range(round(seconds / STEP_S)):
            self.step()

    def run_until(self, condition: Callable[[], bool], seconds: float = 20.0) -> None:
        """Let time pass until something is so; fails after ``seconds`` of the arm's time."""
        for _ in range(round(seconds / STEP_S)):
            if condition():
                return
            self.step()
        raise AssertionError(f"not within {seconds} s of simulated time: {self.codes()}")

    def come_to_rest(self) -> None:
        """Let a motion that has just been sent begin and end."""
        self.run(0.4)
        self.run_until(lambda: not self.controller.operating_state.moving, seconds=30.0)
        self.run(0.5)  # the program has seen it stand still

    def ready(self) -> None:
        """Connect and enable: the arm may move."""
        self.connect()
        accepted(self.controller.motors.enable())
        self.run_until(lambda: self.controller.operating_state.cannot_move is None)

    def codes(self) -> list[str]:
        """The codes of all notices so far."""
        return [event.code for event in self.events]

    def heard(self) -> list[Frame]:
        """The commands that went over the bus since the last call; the arm's own are not heard."""
        frames = []
        while (message := self._ear.recv(0)) is not None:
            decoded = self._codec.decode(Frame(message.arbitration_id, bytes(message.data)))
            if isinstance(decoded, Message) and decoded.name in _COMMANDS:
                frames.append(Frame(message.arbitration_id, bytes(message.data)))
        return frames

    def close(self) -> None:
        """End every thread and bus."""
        if self._host_bus is not None:
            self._host_bus.let_go()
        self.controller.shutdown()
        self._arm_bus.shutdown()
        self._ear.shutdown()
        # ruckig complains of planners that live until Python ends
        del self.firmware, self.node


_COMMANDS = {
    "MotionCommand",
    "ModeControl",
    "JointTarget12",
    "JointTarget34",
    "JointTarget56",
    "MotorEnable",
    "JointSetting",
    "LightControl",
    "GripperCommand",
}
