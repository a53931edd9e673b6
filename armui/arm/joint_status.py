"""The status of the six joints as the manual's table has it: ten items each, and the worst of all.

The items are bits of 0x261–0x266 byte 5 and of 0x2A1 byte 7 (manual 1.0.10). Bits 4 and 7 of the
first mean different things in the two generations; until it is known which one speaks, they say
nothing.
"""

from __future__ import annotations

import enum
from collections.abc import Callable, Mapping, Sequence
from datetime import datetime
from types import MappingProxyType
from typing import Final, NamedTuple

from armui.arm.limits import JOINTS
from armui.arm.state import ArmState, DriverFast, DriverSlow, Reading, Status
from armui.protocol.generation import Generation


class Item(enum.Enum):
    """A row of the table."""

    STATUS_CODE = enum.auto()
    SUPPLY_VOLTAGE = enum.auto()
    MOTOR_TEMPERATURE = enum.auto()
    DRIVER_CURRENT = enum.auto()
    DRIVER_TEMPERATURE = enum.auto()
    SENSOR = enum.auto()
    """Only in generation 1."""
    COLLISION_PROTECTION = enum.auto()
    """Only in generation 2."""
    DRIVER_FAULT = enum.auto()
    DRIVER_ENABLED = enum.auto()
    HOMED = enum.auto()
    """Only in generation 1."""
    STALL_PROTECTION = enum.auto()
    """Only in generation 2."""
    COMMUNICATION = enum.auto()


class Word(enum.Enum):
    """The state in a cell; the user interface has the manual's word for it."""

    NORMAL = enum.auto()
    TOO_LOW = enum.auto()
    TOO_HOT = enum.auto()
    OVERCURRENT = enum.auto()
    ABNORMAL = enum.auto()
    ERROR = enum.auto()
    TRIGGERED = enum.auto()
    ENABLED = enum.auto()
    DISABLED = enum.auto()
    NOT_HOMED = enum.auto()
    HOMED = enum.auto()


FAULTS: Final = frozenset(
    {Word.TOO_LOW, Word.TOO_HOT, Word.OVERCURRENT, Word.ABNORMAL, Word.ERROR, Word.TRIGGERED}
)
"""The words that name a fault."""


class StatusVerdict(enum.Enum):
    """The overall state of the six joints, the best first."""

    NORMAL = enum.auto()
    DISABLED = enum.auto()
    UNKNOWN = enum.auto()
    """Something has not been heard, or not lately, and no fault is known."""
    FAULT = enum.auto()
    OFFLINE = enum.auto()


class Worst(NamedTuple):
    """The worst state among the six joints.

    Attributes:
        verdict: The worst state.
        joints: The joints in this state, in order; empty if it concerns all of them.
    """

    verdict: StatusVerdict
    joints: tuple[int, ...] = ()


class StatusCell(NamedTuple):
    """One item of one joint.

    Attributes:
        word: The state heard last; ``None`` if none was heard, and for the status code.
        value: The figure behind it, in the unit of :data:`UNITS`; for the status code the byte.
        since: The time since which ``word`` has held, by the computer's clock.
        stale: True if the cell's content is older than half a second while other frames are heard.
    """

    word: Word | None = None
    value: float | None = None
    since: datetime | None = None
    stale: bool = False

    @property
    def fault(self) -> bool:
        """True if its word names a fault."""
        return self.word in FAULTS


UNITS: Final[Mapping[Item, str]] = MappingProxyType(
    {
        Item.SUPPLY_VOLTAGE: "V",
        Item.MOTOR_TEMPERATURE: "°C",
        Item.DRIVER_CURRENT: "A",
        Item.DRIVER_TEMPERATURE: "°C",
        Item.DRIVER_ENABLED: "°/s",
    }
)
"""The unit of the figure behind an item, for items that have one."""


_DRIVER_WORDS: Final[Mapping[Item, tuple[Callable[[DriverSlow], bool | None], Word, Word]]] = {
    Item.SUPPLY_VOLTAGE: (lambda driver: driver.undervoltage, Word.NORMAL, Word.TOO_LOW),
    Item.MOTOR_TEMPERATURE: (
        lambda driver: driver.motor_overtemperature,
        Word.NORMAL,
        Word.TOO_HOT,
    ),
    Item.DRIVER_CURRENT: (lambda driver: driver.overcurrent, Word.NORMAL, Word.OVERCURRENT),
    Item.DRIVER_TEMPERATURE: (
        lambda driver: driver.driver_overtemperature,
        Word.NORMAL,
        Word.TOO_HOT,
    ),
    Item.SENSOR: (lambda driver: driver.sensor_fault, Word.NORMAL, Word.ABNORMAL),
    Item.COLLISION_PROTECTION: (
        lambda driver: driver.collision_protection,
        Word.NORMAL,
        Word.TRIGGERED,
    ),
    Item.DRIVER_FAULT: (lambda driver: driver.driver_fault, Word.NORMAL, Word.ERROR),
    Item.DRIVER_ENABLED: (lambda driver: driver.enabled, Word.DISABLED, Word.ENABLED),
    Item.HOMED: (lambda driver: driver.homed, Word.NOT_HOMED, Word.HOMED),
    Item.STALL_PROTECTION: (lambda driver: driver.stall_protection, Word.NORMAL, Word.TRIGGERED),
}
"""The function that reads the bit behind an item, with the words for 0 and for 1."""

_SLOW_VALUES: Final[Mapping[Item, Callable[[DriverSlow], float]]] = {
    Item.STATUS_CODE: lambda driver: driver.status_code,
    Item.SUPPLY_VOLTAGE: lambda driver: driver.voltage_v,
    Item.MOTOR_TEMPERATURE: lambda driver: driver.motor_temperature_c,
    Item.DRIVER_TEMPERATURE: lambda driver: driver.driver_temperature_c,
}
_FAST_VALUES: Final[Mapping[Item, Callable[[DriverFast], float]]] = {
    Item.DRIVER_CURRENT: lambda driver: driver.current_a,
    Item.DRIVER_ENABLED: lambda driver: driver.speed_deg_s,
}

_OF_ONE_GENERATION: Final[Mapping[Item, Generation]] = {
    Item.SENSOR: Generation.ONE,
    Item.HOMED: Generation.ONE,
    Item.COLLISION_PROTECTION: Generation.TWO,
    Item.STALL_PROTECTION: Generation.TWO,
}

_ROWS: Final[Mapping[Generation, tuple[Item, ...]]] = {
    generation: tuple(
        item for item in Item if _OF_ONE_GENERATION.get(item, generation) is generation
    )
    for generation in Generation
}


def rows(generation: Generation | None) -> tuple[Item, ...]:
    """Return the ten items from top to bottom; the manual's while the generation is unknown."""
    return _ROWS[generation or Generation.ONE]


def word(state: ArmState, generation: Generation | None, item: Item, joint: int) -> Word | None:
    """Return what the arm said last of one item of one joint (1–6)."""
    if item is Item.STATUS_CODE:
        return None
    if item is Item.COMMUNICATION:
        if state.status is None:
            return None
        broken = state.status.value.communication_fault[joint - 1]
        return Word.ABNORMAL if broken else Word.NORMAL
    driver = state.drivers_slow[joint - 1]
    if driver is None or _OF_ONE_GENERATION.get(item, generation) is not generation:
        return None
    flag, when_clear, when_set = _DRIVER_WORDS[item]
    is_set = flag(driver.value)
    return None if is_set is None else when_set if is_set else when_clear


def value(state: ArmState, item: Item, joint: int) -> float | None:
    """Return the figure behind one item of one joint (1–6), in the unit of :data:`UNITS`."""
    slow, fast = state.drivers_slow[joint - 1], state.drivers_fast[joint - 1]
    if item in _SLOW_VALUES:
        return None if slow is None else _SLOW_VALUES[item](slow.value)
    if item in _FAST_VALUES:
        return None if fast is None else _FAST_VALUES[item](fast.value)
    return None


def is_stale(state: ArmState, item: Item, joint: int) -> bool:
    """Return whether the frame behind an item has stopped coming while others are still heard."""
    now_s = state.last_feedback_s
    sources: list[Reading[Status] | Reading[DriverSlow] | Reading[DriverFast] | None]
    if item is Item.COMMUNICATION:
        sources = [state.status]
    elif item in _FAST_VALUES:
        sources = [state.drivers_slow[joint - 1], state.drivers_fast[joint - 1]]
    else:
        sources = [state.drivers_slow[joint - 1]]
    return now_s is not None and any(
        source is not None and not source.fresh(now_s) for source in sources
    )


def faults(state: ArmState, generation: Generation | None) -> list[tuple[int, Item, Word]]:
    """Return every fault, ordered by joint: the joint, the item and its word."""
    return [
        (joint, item, said)
        for joint in JOINTS
        for item in rows(generation)
        if (said := word(state, generation, item, joint)) is not None and said in FAULTS
    ]


def worst(
    state: ArmState, generation: Generation | None, faulty_items: Sequence[tuple[int, Item, Word]]
) -> Worst:
    """Return the worst of the six states of an arm that is being heard.

    A fault stays until the arm reports that it is gone: a joint that falls silent with a fault
    still has it.

    Args:
        state: The arm's state.
        generation: The protocol it speaks, once known.
        faulty_items: The result of :func:`faults`.
    """
    faulty = tuple(dict.fromkeys(joint for joint, _item, _word in faulty_items))
    if faulty:
        return Worst(StatusVerdict.FAULT, faulty)
    unknown = tuple(
        joint
        for joint in JOINTS
        if state.drivers_slow[joint - 1] is None or is_stale(state, Item.STATUS_CODE, joint)
    )
    no_status = state.status is None or is_stale(state, Item.COMMUNICATION, JOINTS[0])
    if generation is None or no_status or len(unknown) == len(JOINTS):
        return Worst(StatusVerdict.UNKNOWN)
    if unknown:
        return Worst(StatusVerdict.UNKNOWN, unknown)
    off = tuple(joint for joint, on in zip(JOINTS, state.enabled(), strict=True) if not on)
    if off:
        return Worst(StatusVerdict.DISABLED, off)
    return Worst(StatusVerdict.NORMAL)


_WordKey = tuple[Generation | None, int | None, bool | None]


class JointHistory:
    """Remembers since when each word has held.

    An item that was never heard has no time. Only changes cost computing time: everything that
    decides a joint's words fits into one comparison.
    """

    def __init__(self) -> None:
        self._keys: list[_WordKey | None] = [None] * len(JOINTS)
        self._words: dict[tuple[Item, int], Word | None] = {}
        self._since: dict[tuple[Item, int], datetime] = {}

    def add_state(self, state: ArmState, generation: Generation | None, at: datetime) -> bool:
        """Process a state of the arm; return whether any word or status code has changed."""
        status = state.status
        changed = False
        for joint in JOINTS:
            driver = state.drivers_slow[joint - 1]
            key = (
                generation,
                None if driver is None else driver.value.status_code,
                None if status is None else status.value.communication_fault[joint - 1],
            )
            if key != self._keys[joint - 1]:
                self._keys[joint - 1] = key
                self._take_in(state, generation, joint, at)
                changed = True
        return changed

    def _take_in(
        self, state: ArmState, generation: Generation | None, joint: int, at: datetime
    ) -> None:
        for item in Item:
            said = word(state, generation, item, joint)
            if said is self._words.get((item, joint)):
                continue
            self._words[item, joint] = said
            if said is None:
                del self._since[item, joint]
            else:
                self._since[item, joint] = at

    def since(self, item: Item, joint: int) -> datetime | None:
        """Return the time since which an item's present word has held, or ``None``."""
        return self._since.get((item, joint))

    def cell(
        self, state: ArmState, generation: Generation | None, item: Item, joint: int
    ) -> StatusCell:
        """Return one cell of the table for the state that was added last."""
        return StatusCell(
            word=word(state, generation, item, joint),
            value=value(state, item, joint),
            since=self.since(item, joint),
            stale=is_stale(state, item, joint),
        )
