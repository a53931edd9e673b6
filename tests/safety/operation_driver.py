"""Who carries out operations for the tests of every operation, and on which arm.

A driver is what an operator, or a program in his place, has in his hands. Today there is one: the
controller behind the window. A client of an interface, or two arms, is another class of the same
shape and one more line in `DRIVERS`; the questions stay the same.
"""

from __future__ import annotations

import logging
import math
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from types import CodeType, FrameType
from typing import Any, Protocol

import can

from armui.app import may_drive
from armui.arm.refusal import Refusal
from armui.control.events import Event
from armui.control.operating_state import OperatingState
from armui.control.operations.operation import Operation
from armui.control.operations.started import Started
from armui.protocol.frame import Frame
from armui.sim.firmware import Firmware
from armui.system.failures import LOGGERS, Failure, FailureHandler, hooks
from tests.arm_rig import ArmRig
from tests.arm_rig_bus import HostBus
from tests.company import OtherHost
from tests.safety.fuzz.traffic import base_id, is_motion

Answer = Started | Refusal | None

_TARGETS = frozenset({*range(0x152, 0x159), *range(0x15A, 0x160), *range(0x181, 0x188)})
_STOPS = (0x150, 0x160, 0x170)
_HERE_MM = 1.0
_STEP_S = 0.04
_STEP_NS = round(_STEP_S * 1e9)


@dataclass(frozen=True, slots=True)
class Sent:
    """A frame of the program that has left for the bus.

    Attributes:
        at_s: The arm's time.
        frame: The frame.
        moving: Whether a joint of the arm moved then.
        gripper_mm: How far the gripper was open then.
    """

    at_s: float
    frame: Frame
    moving: bool
    gripper_mm: float

    @property
    def identifier(self) -> int:
        """Its identifier without the offset of 0x470."""
        return base_id(self.frame.arbitration_id)

    @property
    def is_motion(self) -> bool:
        """Whether it starts or continues a motion, as the promises have it."""
        return is_motion(self.frame)

    @property
    def is_target(self) -> bool:
        """Whether it says where the arm is to go."""
        return self.identifier in _TARGETS

    @property
    def percent(self) -> int | None:
        """The speed percentage of a 0x151; ``None``: it is no 0x151."""
        return self.frame.data[2] if self.identifier == 0x151 else None

    @property
    def is_stop(self) -> bool:
        """Whether it is the emergency stop."""
        return self.frame.arbitration_id in _STOPS and self.frame.data[0] == 1

    @property
    def is_halt(self) -> bool:
        """Whether it ends a motion with power on: 0x150 byte 1 = 6."""
        return self.identifier == 0x150 and self.frame.data[1] == 6

    @property
    def drives(self) -> bool:
        """Whether it may move an arm whose motion has been ended.

        The operator's speed may be restored in an arm at rest, and a gripper be told to hold on
        where it is.
        """
        if self.identifier == 0x151:
            return self.moving
        if self.identifier == 0x159:
            asked_mm = int.from_bytes(self.frame.data[:4], "big", signed=True) / 1000
            return self.is_motion and abs(asked_mm - self.gripper_mm) > _HERE_MM
        return self.is_motion

    def __str__(self) -> str:
        data = self.frame.data.hex().upper()
        return f"{self.frame.arbitration_id:03X}#{data} at {self.at_s:.2f} s"


class Driver(Protocol):
    """Carries out operations on a simulated arm, and does to both what a question needs.

    Attributes:
        operations: What can be carried out, by id.
        arm: The simulated arm: what is really so.
        frames: What the program has sent so far, oldest first.
        refusals: Each reason that was told, oldest first.
        failures: Each exception nobody expected that was told.
        time_s: The arm's time.
    """

    operations: Mapping[str, Operation]
    arm: Firmware
    frames: list[Sent]
    refusals: list[Refusal]
    failures: list[Failure]
    time_s: float

    @property
    def now(self) -> OperatingState:
        """What the program takes for so."""

    def connect(self, joints_deg: Sequence[float], version: str | None = None) -> None:
        """Connect to an arm that stands at these angles, and have its motors on."""

    def begin(self, name: str, *arguments: Any, **named: Any) -> Answer:
        """Carry out an operation by its id, as the window does: what fails is told."""

    def let_go(self) -> None:
        """Let go of what is held."""

    def stop(self) -> None:
        """Press the emergency stop."""

    def halt(self) -> Refusal | None:
        """Press halt and hold."""

    def leave_mode(self) -> Refusal | None:
        """Take the arm out of another host's MIT, CPV or high-follow."""

    def set_floor(self, lowest_mm: int | None) -> None:
        """Choose the least height of the fingertip."""

    def look_at_arm(self, answers: Mapping[int, float]) -> None:
        """Say in the reference check that the arm looks right, and how far these joints are off."""

    def look_for_room(self, amplitude_deg: float) -> None:
        """Find out how far each joint may swing, and wait until that is known."""

    def check_in_threads(self) -> None:
        """Have long ways checked in a thread, as in the program."""

    def unconfirm_cell(self) -> None:
        """Have the cell to be confirmed again, as after another connection."""

    def begin_log(self) -> None:
        """Have a log written, in which episodes can be marked."""

    def run(self, seconds: float) -> None:
        """Let time pass."""

    def run_until(self, condition: Callable[[], bool], seconds: float = 20.0) -> None:
        """Let time pass until something is so; fails if it does not come."""

    def other_says(self, *lines: str) -> None:
        """Have another host say frames, ID#DATA each."""

    def silence(self, *identifiers: int) -> None:
        """Have the arm say these no more, and everything else."""

    def hold_up(self) -> None:
        """Have the CAN driver keep the frame that is sent next, and all behind it."""

    def free(self) -> None:
        """Have it let go of them."""

    def module_of(self, name: str) -> str:
        """Return the module of the part that carries out an operation."""

    def failing(self, fault: Midway) -> Any:
        """A context in which a part of the program fails as told, or only notes its way."""

    def close(self) -> None:
        """End everything."""


class Midway:
    """Has a part of the program fail in the middle of its way: at a call of one of its functions.

    First it notes which functions of the part run, in their order; then it fails at one of them.

    Args:
        module: Of the part.
    """

    def __init__(self, module: str) -> None:
        self._module = module
        self.calls: list[CodeType] = []
        self._fails: tuple[CodeType, int] | None = None

    def at(self, share: float) -> Midway:
        """Return one that fails so far along the way that was noted, 0–1."""
        index = min(int(share * len(self.calls)), len(self.calls) - 1)
        code = self.calls[index]
        other = Midway(self._module)
        other._fails = code, self.calls[: index + 1].count(code)
        return other

    def profile(self, frame: FrameType, event: str, _argument: object) -> None:
        """Note a call, or fail at it; for `sys.setprofile`."""
        if event != "call" or frame.f_globals.get("__name__") != self._module:
            return
        code = frame.f_code
        if code.co_name.startswith(("<", "__")):
            return
        self.calls.append(code)
        if self._fails is not None and self._fails == (code, self.calls.count(code)):
            raise ArithmeticError(f"made to fail in {code.co_qualname}")


def _tell_rarely(arm: Firmware) -> None:
    """Have an arm tell everything at the end of each step: half of what a test costs is feedback.

    It is no older then than what a program takes for new of an arm that moves.
    """
    schedule = arm._schedule
    for slot in schedule._slots:
        slot.period_ns = max(slot.period_ns, _STEP_NS)
        slot.due_ns = -(-slot.due_ns // _STEP_NS) * _STEP_NS
    schedule.next_ns = min(slot.due_ns for slot in schedule._slots)


class ControllerDriver(ArmRig):
    """The controller behind the window, as the window calls it."""

    def __init__(self, channel: str) -> None:
        super().__init__(channel)
        self.frames: list[Sent] = []
        self.refusals: list[Refusal] = []
        self.failures: list[Failure] = []
        self._fault: Midway | None = None
        self._closed = False
        self._other: OtherHost | None = None
        self.controller.noticed.connect(self._on_noticed)
        self._handler = FailureHandler(self._on_failure)
        self._hooks = ExitStack()
        self._hooks.enter_context(hooks())
        for name in LOGGERS:
            logging.getLogger(name).addHandler(self._handler)
        self.operations = {
            name: bound.operation for name, bound in self.controller.operations.items()
        }

    @property
    def arm(self) -> Firmware:
        """The simulated arm."""
        return self.firmware

    @property
    def now(self) -> OperatingState:
        """What the program takes for so."""
        return self.controller.operating_state

    def _listen_closely(self, bus: HostBus) -> None:
        super()._listen_closely(bus)
        send = bus.send

        def noted(msg: can.Message, timeout: float | None = None) -> None:
            send(msg, timeout)
            arm = self.firmware
            frame = Frame(msg.arbitration_id, bytes(msg.data))
            self.frames.append(Sent(self.time_s, frame, arm.mechanics.moving, arm.gripper.travel))

        noted.__module__ = send.__module__  # as prompt as that one
        bus.send = noted

    def connect(  # type: ignore[override]
        self, joints_deg: Sequence[float], version: str | None = None
    ) -> None:
        """Connect to an arm that stands at these angles, and have its motors on."""
        self.lie(joints_deg, version=version)
        _tell_rarely(self.firmware)
        super().connect()
        self.begin("motors.enable")
        self.run_until(lambda: set(self.now.enabled) == {True})

    def step(self, dt_s: float = _STEP_S) -> None:
        """Let a step's time pass."""
        super().step(dt_s)

    def run(self, seconds: float) -> None:
        """Let time pass, in whole steps."""
        for _ in range(math.ceil(seconds / _STEP_S - 1e-6)):
            self.step()

    def begin(self, name: str, *arguments: Any, **named: Any) -> Answer:
        """Carry out an operation by its id, as a slot of the window does.

        What leaves at once has left: whether a press that follows it at the same moment overtakes
        it is no matter of chance.
        """
        answer: Answer = self._as_a_slot(lambda: self.controller.begin(name, *arguments, **named))
        self._settle_what_was_said()
        return answer

    def _as_a_slot(self, act: Callable[[], Any]) -> Any:
        """What fails in a slot of Qt reaches the hook for what nobody expected."""
        try:
            if self._fault is None:
                return act()
            sys.setprofile(self._fault.profile)
            try:
                return act()
            finally:
                sys.setprofile(None)
        except Exception as error:  # noqa: BLE001 - as Qt does, which goes on
            sys.excepthook(type(error), error, error.__traceback__)
            return None

    def let_go(self) -> None:
        """Let go of what is held."""
        self.controller.jogging.stop()

    def stop(self) -> None:
        """Press the emergency stop."""
        self.controller.emergency_stop()

    def halt(self) -> Refusal | None:
        """Press halt and hold."""
        return self.controller.halt_and_hold()

    def leave_mode(self) -> Refusal | None:
        """Take the arm out of another host's mode."""
        answer: Refusal | None = self._as_a_slot(self.controller.mode_exit.send)
        return answer

    def set_floor(self, lowest_mm: int | None) -> None:
        """Choose the least height of the fingertip."""
        self.controller.jog_floor.lowest_mm = lowest_mm

    def look_at_arm(self, answers: Mapping[int, float]) -> None:
        """Answer the reference check."""
        self.controller.reference.note_elsewhere(())
        for joint, off_deg in answers.items():
            self.controller.reference.answer(joint, off_deg)

    def look_for_room(self, amplitude_deg: float) -> None:
        """Wait until the inspection knows it."""
        inspection = self.controller.inspection
        inspection.set_amplitude(amplitude_deg)
        self.run_until(lambda: inspection.plan is not None)

    def check_in_threads(self) -> None:
        self.controller.gate._background = None

    def begin_log(self) -> None:
        lines: list[object] = []
        self.controller.episodes.begin_log(lines.append, 0.0)

    def unconfirm_cell(self) -> None:
        """Have the cell to be confirmed again."""
        self.controller.cell.forget_arm()

    def other_says(self, *lines: str) -> None:
        """Have another host say frames."""
        if self._other is None:
            self._other = OtherHost(self)
        self._other.say(*lines)

    def silence(self, *identifiers: int) -> None:
        """Have the arm say these no more, and everything else."""
        self.node.link.mute_on.clear()
        self.node.link.mute_on.update(identifiers)

    def hold_up(self) -> None:
        """Have the CAN driver keep what is sent next."""
        self.hold_driver()

    def free(self) -> None:
        """Have it let go."""
        if self._host_bus is not None:
            self.free_driver()

    def module_of(self, name: str) -> str:
        """Return the module of the part that carries out an operation."""
        return str(self.controller.operations[name].carry_out.__module__)

    @contextmanager
    def failing(self, fault: Midway) -> Iterator[Midway]:
        """Have a part fail, or note its way, in what is begun meanwhile."""
        self._fault = fault
        try:
            yield fault
        finally:
            self._fault = None

    def _on_noticed(self, event: Event) -> None:
        for value in event.params.values():
            if isinstance(value, Refusal):
                self.refusals.append(value)

    def _on_failure(self, failure: Failure) -> None:
        """As the program does with what nobody expected."""
        self.failures.append(failure)
        if may_drive(failure.modules):
            self.controller.on_failure()

    def close(self) -> None:
        """End every thread and bus, and take the hooks away."""
        if self._closed:
            return
        self._closed = True
        self._hooks.close()
        for name in LOGGERS:
            logging.getLogger(name).removeHandler(self._handler)
        if self._other is not None:
            self._other.close()
        super().close()


DRIVERS: Mapping[str, Callable[[str], Any]] = {"controller": ControllerDriver}
"""Each driver, made with the channel of its virtual bus."""
