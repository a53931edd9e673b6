"""The rig with its company as the fuzz drives it: one clock, and every word noted."""

from __future__ import annotations

import logging
import sys
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from types import TracebackType
from typing import Final

import can
from PySide6.QtCore import QCoreApplication

import armui.bus.worker
import armui.interface.server
from armui.app import may_drive
from armui.bus.link import BusState
from armui.bus.worker import BusWorker
from armui.interface.interface import Interface
from armui.interface.server import Server
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from armui.system.failures import LOGGERS, Failure, FailureHandler, hooks
from tests.arm_rig import ArmRig, thin_out
from tests.arm_rig_bus import HostBus
from tests.company import OtherHost
from tests.safety.fuzz.breakage import Breakage
from tests.safety.fuzz.local_client import LocalClient, LockstepServer
from tests.safety.fuzz.lockstep import LockstepWorker
from tests.safety.fuzz.traffic import Sender, Traffic

STEP_S: Final = 0.02
_NEVER_MS: Final = 3_600_000
_MOST_ROUNDS: Final = 100


# one receiver a frame, and nobody changes one: a copy for each would cost a third of the time
def _itself(message: can.Message, _: object) -> can.Message:
    return message


class NotedHost(OtherHost):
    """A second host whose frames are noted."""

    def __init__(self, world: World) -> None:
        super().__init__(world)
        self._world = world

    def say(self, *lines: str) -> None:
        """Put frames on the bus, and note them."""
        for line in lines:
            identifier, _, data = line.partition("#")
            self._world.traffic.note(Sender.OTHER, Frame(int(identifier, 16), bytes.fromhex(data)))
        super().say(*lines)


class World(ArmRig):
    """A rig on which nothing but its own clock counts.

    Attributes:
        other: The second host.
        interface: The program's local interface, switched on.
        client: Somebody's script at it.
        traffic: Who said what.
        cable: Whether the adapter is plugged in.
        errors: Exceptions that were logged or reached a hook, as text.
        breakage: What fails now.
        failed: Called with each failure, before the program ends its motion.
        watch: Called after each step.
    """

    def __init__(self, channel: str, generation: Generation) -> None:
        super().__init__(channel, generation)
        # nobody asks what was heard on the bus: a queue that is never read costs copies
        self._ear.shutdown()
        thin_out(self.firmware)  # not together: a seed that found something finds it by its moments
        self.traffic = Traffic(self.firmware, lambda: self.time_s)
        self.other = NotedHost(self)
        self.cable = True
        self.errors: list[str] = []
        self.watch: Callable[[], None] = _look_away
        self._log = _Errors(self.errors)
        logging.getLogger().addHandler(self._log)
        setattr(armui.bus.worker, "BusWorker", LockstepWorker)  # noqa: B010 - mypy takes no other
        setattr(armui.interface.server, "Server", LockstepServer)  # noqa: B010 - as above
        nowhere = Path("api.sock")
        self.interface = Interface(self.controller, nowhere, lambda: self.time_s)
        self.interface.switch(on=True)
        self.client = LocalClient(self)
        self.company.append(self.client)
        self._copy = can.Message.__deepcopy__
        setattr(can.Message, "__deepcopy__", _itself)  # noqa: B010 - mypy takes no other
        self.breakage: Breakage | None = None
        self.failed: Callable[[Failure], None] = lambda _failure: None
        self._handler = FailureHandler(self._on_failure)
        self._hooks = ExitStack()
        self._hooks.enter_context(hooks())
        for name in LOGGERS:
            logging.getLogger(name).addHandler(self._handler)

    def _listen_closely(self, bus: HostBus) -> None:
        send, receive = bus.send, bus.recv

        def noted(msg: can.Message, timeout: float | None = None) -> None:
            self.traffic.note(Sender.US, Frame(msg.arbitration_id, bytes(msg.data)))
            send(msg, timeout)

        def at_once(timeout: float | None = None) -> can.Message | None:
            return receive(0)  # what there is is there

        bus.send = noted
        bus.recv = at_once
        self._host_bus = bus

    def _settle(self) -> None:
        """Until nothing is on its way any more, in either direction."""
        worker = self.controller._connection._worker
        for _ in range(_MOST_ROUNDS):
            assert worker is None or isinstance(worker, LockstepWorker)
            if worker is None or not worker.pump():
                break
        QCoreApplication.processEvents()

    def still_timers(self) -> None:
        """Keep the timers of the program from counting the wall clock's time."""
        for part in (self.controller, self.controller.jogging, self.interface):
            timer = getattr(part, "_timer", None)
            if timer is not None:
                timer.setInterval(_NEVER_MS)

    def pass_time(self, seconds: float) -> None:
        """Let time pass, a step at a time, and have the watcher look after each."""
        self.still_timers()
        for _ in range(round(seconds / STEP_S)):
            if self.breakage is None:
                self._step()
            else:
                self.breakage.during(self._step)
            self.watch()

    def _step(self) -> None:
        """A step; what fails in it fails in a slot of a timer."""
        try:
            self.step(STEP_S)
            self.interface.tick()
        except Exception as error:  # noqa: BLE001 - as Qt does, which goes on
            sys.excepthook(type(error), error, error.__traceback__)

    def _on_failure(self, failure: Failure) -> None:
        """As the program does with what nobody expected."""
        profile = sys.getprofile()
        sys.setprofile(None)  # no second failure within the first
        try:
            self.failed(failure)
            if may_drive(failure.modules):
                self.controller.on_failure()
        finally:
            sys.setprofile(profile)

    def exchange(self, firmware: Firmware, silent_s: float) -> None:
        """Another arm is plugged in where the first was, switched on just now."""
        self.powered = False
        self.pass_time(silent_s)
        self.powered = True
        thin_out(firmware)
        faults = self.node.faults.active
        for each in list(faults):
            self.node.faults.end(each)
        self.firmware, self.node = firmware, Node(firmware, self._arm_bus)
        self.traffic.listen(firmware)

    def suspend(self, seconds: float) -> None:
        """The program gets no time; the arm and the others on the bus do."""
        for _ in range(round(seconds / STEP_S)):
            self.time_s += STEP_S
            for each in self.company:
                each.step(STEP_S)
            self.node.poll(STEP_S)

    def hang(self, seconds: float) -> None:
        """The GUI thread is busy; the bus thread, the arm and the others are not."""
        for _ in range(round(seconds / STEP_S)):
            self._settle()
            self.time_s += STEP_S
            for each in self.company:
                each.step(STEP_S)
            self.node.poll(STEP_S)
            self._settle()

    def unplug_cable(self) -> None:
        """The adapter is gone."""
        if self.cable and self._host_bus is not None:
            self.cable = False
            self.unplug(can.CanOperationError("gone"))

    def plug_cable_in(self) -> None:
        """The adapter is back."""
        self.cable = True
        self.plug_in()

    @property
    def step_s(self) -> float:
        """How much time passes between two looks."""
        return STEP_S

    @property
    def hears(self) -> bool:
        """Whether the program has an open bus: what is said reaches it."""
        return self.cable and self.controller._connection._bus_state is BusState.OPEN

    def close(self) -> None:
        """End everything; harmless when a thread hangs on to the bus."""
        self._hooks.close()
        for name in LOGGERS:
            logging.getLogger(name).removeHandler(self._handler)
        logging.getLogger().removeHandler(self._log)
        self.other.close()
        self.company.remove(self.client)
        self.interface.end()
        super().close()
        setattr(armui.bus.worker, "BusWorker", BusWorker)  # noqa: B010 - mypy takes no other
        setattr(armui.interface.server, "Server", Server)  # noqa: B010 - as above
        can.Message.__deepcopy__ = self._copy


def _look_away() -> None:
    """Nobody watches."""


class _Errors(logging.Handler):
    def __init__(self, errors: list[str]) -> None:
        super().__init__(logging.ERROR)
        self._errors = errors

    def emit(self, record: logging.LogRecord) -> None:
        """Keep what was logged as an error."""
        error = record.exc_info[1] if record.exc_info else None
        trace = record.exc_info[2] if record.exc_info else None
        self._errors.append(f"{record.getMessage()}: {_line(error, trace)}")


def _line(error: BaseException | None, trace: TracebackType | None) -> str:
    """An exception and where it came from."""
    place = trace
    while place is not None and place.tb_next is not None:
        place = place.tb_next
    where = ""
    if place is not None:
        where = f" at {place.tb_frame.f_code.co_filename.rsplit('/', 1)[-1]}:{place.tb_lineno}"
    return f"{type(error).__name__}: {error}{where}"
