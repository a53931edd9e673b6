"""The faults that can be injected, by name.

On the command line they are written NAME[:VALUE]@START[-END].
"""

from __future__ import annotations

import enum
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import Final

from armui.sim.condition import Alarm
from armui.sim.faults.faulty_link import FaultyLink
from armui.sim.firmware import Firmware
from armui.sim.mechanics.drivers import SUPPLY_V

_ANY_PUSH_NM: Final = 40.0
"""More torque than any collision level explains."""

_LOW_SUPPLY_V: Final = 18.0
_SLIP_DEG: Final = 5.0

_SYNTAX: Final = re.compile(
    r"(?P<name>[a-z-]+)(:(?P<value>[0-9.]+))?@(?P<start>[0-9.]+)(-(?P<end>[0-9.]+))?"
)


class FaultParameter(enum.Enum):
    """The meaning of a fault's number: its name, and its smallest and largest value."""

    NONE = "nothing", 0.0, 0.0
    JOINT = "joint", 1.0, 6.0
    SHARE = "share of the frames", 0.0, 1.0
    SECONDS = "seconds", 0.0, 60.0
    PER_SECOND = "frames a second", 0.0, 10_000.0

    def __init__(self, meaning: str, least: float, most: float) -> None:
        self.meaning = meaning
        self.least = least
        self.most = most


@dataclass(frozen=True, slots=True)
class Broken:
    """The arm and the link that a fault acts on."""

    arm: Firmware
    link: FaultyLink


@dataclass(frozen=True, slots=True)
class FaultKind:
    """One kind of fault.

    Attributes:
        purpose: A description of the effect.
        parameter: The meaning of its number.
        default: The number when none is given.
        switch: Starts the fault with its number, or ends it.
    """

    purpose: str
    parameter: FaultParameter
    default: float
    switch: Callable[[Broken, float, bool], None]


def _line(attribute: str, on: Broken, value: float, present: bool) -> None:
    setattr(on.link, attribute, value if present else 0.0)


def _weaken_supply(on: Broken, _value: float, present: bool) -> None:
    on.arm.drivers.supply_v = _LOW_SUPPLY_V if present else SUPPLY_V


def _deafen(on: Broken, _value: float, present: bool) -> None:
    on.link.deaf = present


def _switch_off(on: Broken, _value: float, present: bool) -> None:
    on.link.off = present


def _cut_power(on: Broken, _value: float, present: bool) -> None:
    (on.arm.switch_off if present else on.arm.switch_on)()


def _stop_feedback(on: Broken, _value: float, present: bool) -> None:
    on.arm.feedback_stopped = present


def _arm_fault(purpose: str, switch: Callable[[Firmware, int, bool], None]) -> FaultKind:
    return FaultKind(
        purpose,
        FaultParameter.JOINT,
        1.0,
        lambda on, joint, present: switch(on.arm, int(joint), present),
    )


def _alarm(purpose: str, alarm: Alarm) -> FaultKind:
    return _arm_fault(
        purpose,
        lambda arm, joint, on: arm.protection.set_alarm(joint - 1, alarm, present=on),
    )


FAULTS: Final[dict[str, FaultKind]] = {
    "joint-communication": _arm_fault(
        "the controller loses the connection to a joint",
        lambda arm, joint, present: arm.set_communication_fault(joint, present=present),
    ),
    "motor-overtemperature": _arm_fault(
        "a motor is too hot",
        lambda arm, joint, present: arm.drivers.overheat_motor(joint - 1, on=present),
    ),
    "driver-overtemperature": _arm_fault(
        "a driver is too hot",
        lambda arm, joint, present: arm.drivers.overheat_driver(joint - 1, on=present),
    ),
    "undervoltage": FaultKind("the supply gives 18 V", FaultParameter.NONE, 0.0, _weaken_supply),
    "power-off": FaultKind(
        "the supply is off; at the end the arm starts anew", FaultParameter.NONE, 0.0, _cut_power
    ),
    "overcurrent": _alarm(
        "a driver sees too much current and switches its motor off", Alarm.OVERCURRENT
    ),
    "sensor-error": _alarm("a joint's encoder fails", Alarm.SENSOR),
    "driver-error": _alarm("a driver fails and switches its motor off", Alarm.DRIVER),
    "stall": _arm_fault(
        "something keeps a joint from turning",
        lambda arm, joint, present: arm.protection.block(joint - 1, blocked=present),
    ),
    "collision": _arm_fault(
        f"something pushes at a joint with {_ANY_PUSH_NM:.0f} N·m",
        lambda arm, joint, present: arm.protection.push(
            joint - 1, _ANY_PUSH_NM if present else 0.0
        ),
    ),
    "stiff-joint": _arm_fault(
        "a joint turns stiffly: it stays behind, and needs more current",
        lambda arm, joint, present: arm.mechanics.stiffen(joint - 1, stiff=present),
    ),
    "hot-joint": _arm_fault(
        "a joint is 25 °C warmer than its work explains, which raises no alarm",
        lambda arm, joint, present: arm.drivers.run_hot(joint - 1, on=present),
    ),
    "slip": FaultKind(
        f"a joint slips by {_SLIP_DEG:g}°; its feedback shows it at the next 0x150 resume",
        FaultParameter.JOINT,
        5.0,
        lambda on, joint, present: on.arm.slip(int(joint), _SLIP_DEG) if present else None,
    ),
    "lost-reference": FaultKind(
        "a joint reports an excursion of 60° and its return, and stands as far off from then on; "
        "0x150 resume mends it",
        FaultParameter.JOINT,
        5.0,
        lambda on, joint, present: on.arm.lost_reference.begin(int(joint) - 1) if present else None,
    ),
    "corrupt-limits": _arm_fault(
        "a joint's limits read 0xFFFF until they are reset; does not mend by itself",
        lambda arm, joint, present: arm.corrupt_limits(joint) if present else None,
    ),
    "feedback-stopped": FaultKind(
        "the arm answers but no longer tells how it is", FaultParameter.NONE, 0.0, _stop_feedback
    ),
    "bus-off": FaultKind(
        "the controller neither hears nor says anything", FaultParameter.NONE, 0.0, _switch_off
    ),
    "deaf-adapter": FaultKind(
        "the host's adapter sends, but hands over nothing that it hears",
        FaultParameter.NONE,
        0.0,
        _deafen,
    ),
    "garbage": FaultKind(
        "frames of any identifier and content on the bus",
        FaultParameter.PER_SECOND,
        100.0,
        partial(_line, "garbage_per_s"),
    ),
    "lost-frames": FaultKind(
        "frames get lost, both ways", FaultParameter.SHARE, 0.1, partial(_line, "loss")
    ),
    "latency": FaultKind(
        "frames arrive later, both ways", FaultParameter.SECONDS, 0.05, partial(_line, "latency_s")
    ),
}
"""Every fault there is, by name."""


class FaultError(ValueError):
    """A fault that cannot be injected; the text names the reason and the alternatives."""


@dataclass(frozen=True, slots=True)
class Fault:
    """A fault with its number, its start and its end.

    Attributes:
        name: A key of `FAULTS`.
        value: Its number: joint, share, seconds or frames a second.
        start_s, end_s: When it begins and ends, in the arm's time; no end when None.
    """

    name: str
    value: float
    start_s: float = 0.0
    end_s: float | None = None


def fault(
    name: str, value: float | None = None, *, start_s: float = 0.0, end_s: float | None = None
) -> Fault:
    """Return a fault after checking its name, number and times.

    Args:
        name: A key of `FAULTS`.
        value: Its number; the kind's own when None.
        start_s: When it begins.
        end_s: When it ends; never when None.

    Raises:
        FaultError: No such fault, or a number it cannot have, or an end before its start.
    """
    kind = FAULTS.get(name)
    if kind is None:
        raise FaultError(f"no fault is called {name!r}; there are {', '.join(FAULTS)}")
    parameter = kind.parameter
    if value is None:
        value = kind.default
    elif parameter is FaultParameter.NONE:
        raise FaultError(f"{name} takes no number; leave out :{value:g}")
    if not parameter.least <= value <= parameter.most:
        raise FaultError(
            f"{name}: the {parameter.meaning} is {value:g}; "
            f"give {parameter.least:g} to {parameter.most:g}"
        )
    if parameter is FaultParameter.JOINT and value != int(value):
        raise FaultError(f"{name}: the joint is {value:g}; give a whole number")
    if end_s is not None and end_s <= start_s:
        raise FaultError(f"{name} ends at {end_s:g} s, which is not after {start_s:g} s")
    return Fault(name, value, start_s, end_s)


def read_fault(text: str) -> Fault:
    """Return a fault from `NAME[:VALUE]@START[-END]`, seconds after the arm was switched on.

    Raises:
        FaultError: The text has another form, or as for `fault`.
    """
    match = _SYNTAX.fullmatch(text)
    if match is None:
        raise FaultError(f"{text!r} is no fault; write NAME@SECONDS or NAME:VALUE@SECONDS-SECONDS")
    try:
        value, start_s, end_s = (
            None if match[part] is None else float(match[part])
            for part in ("value", "start", "end")
        )
    except ValueError:
        raise FaultError(f"{text!r} holds something that is no number") from None
    return fault(match["name"], value, start_s=start_s or 0.0, end_s=end_s)


class Faults:
    """Starts and ends faults of one arm.

    Attributes:
        active: The active faults, in the order of their beginning.
    """

    def __init__(self, arm: Firmware, link: FaultyLink, planned: Iterable[Fault] = ()) -> None:
        self._on = Broken(arm, link)
        self._planned = sorted(planned, key=lambda each: each.start_s)
        self.active: list[Fault] = []

    def start(self, each: Fault) -> None:
        """Starts a fault now; one that is active already goes on."""
        if each not in self.active:
            self.active.append(each)
            FAULTS[each.name].switch(self._on, each.value, True)

    def end(self, each: Fault) -> None:
        """Ends a fault; does nothing if it is not active."""
        if each in self.active:
            self.active.remove(each)
            FAULTS[each.name].switch(self._on, each.value, False)

    def at(self, now_s: float) -> None:
        """Starts and ends the faults planned up to now."""
        while self._planned and self._planned[0].start_s <= now_s:
            self.start(self._planned.pop(0))
        for each in [each for each in self.active if each.end_s is not None]:
            if each.end_s is not None and each.end_s <= now_s:
                self.end(each)
