"""Who said what on the bus, and which frame made the simulated arm do what."""

from __future__ import annotations

import enum
import weakref
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

from armui.protocol.frame import Frame
from armui.sim.firmware import Firmware

_KEPT_S: Final = 1.0
_OFFSETS: Final = (0x00, 0x10, 0x20)
_STARTS_TEACHING: Final = frozenset({1, 3, 5, 7})


class Sender(enum.Enum):
    """Who says something to the arm."""

    US = "armui"
    OTHER = "the other host"
    NOBODY = "nobody"


@dataclass(frozen=True, slots=True)
class Said:
    """A frame on the bus.

    Attributes:
        after: What the operator had asked for when it was said, and what had ended that.
        to_arm: Whether it is for this arm, as the arm listened when it was said.
    """

    at_s: float
    sender: Sender
    frame: Frame
    after: Any = None
    to_arm: bool = True


@dataclass(frozen=True, slots=True)
class Started:
    """A frame that set the arm in motion or sent it elsewhere.

    Attributes:
        said: The frame.
        was_moving: Whether the arm moved before.
        before_deg: Where the arm was on its way to.
        goal_deg: Where it is on its way to now.
        here_deg: Where it reported to be: in an excursion of its reference no program knows better.
    """

    said: Said
    was_moving: bool
    before_deg: tuple[float, ...]
    goal_deg: tuple[float, ...]
    here_deg: tuple[float, ...]


def base_id(arbitration_id: int) -> int:
    """The identifier without the offset of 0x470: 0x165 is 0x155."""
    for offset in _OFFSETS:
        if 0x150 <= arbitration_id - offset <= 0x15F:
            return arbitration_id - offset
    return arbitration_id


def is_motion(frame: Frame) -> bool:
    """Whether a frame is a motion frame as safety.md has it: it starts or continues a motion."""
    identifier, data = base_id(frame.arbitration_id), frame.data
    if identifier == 0x150:
        return len(data) > 2 and not data[0] and (data[1] == 2 or data[2] in _STARTS_TEACHING)
    if identifier == 0x159:
        return len(data) > 6 and bool(data[6] & 1)
    return identifier == 0x151 or 0x152 <= identifier <= 0x15F or 0x181 <= identifier <= 0x187


class Traffic:
    """Knows of each frame the arm hears who said it, and notes what the arm begins at it.

    Args:
        firmware: The arm; its `on_frame` is watched.
        clock: The rig's time.

    Attributes:
        asked: What the operator has asked for last, asked at each frame.
        said: Every frame of a host.
        started: What the arm has begun since somebody looked.
    """

    def __init__(self, firmware: Firmware, clock: Callable[[], float]) -> None:
        self._clock = clock
        self.asked: Callable[[], Any] = lambda: None
        self._pending: deque[Said] = deque()
        self.said: list[Said] = []
        self.started: list[Started] = []
        self.listen(firmware)

    def listen(self, firmware: Firmware) -> None:
        """Watch an arm, in the place of the one before."""
        # the firmware holds this; a reference back would keep both beyond the run
        self._on_frame = weakref.WeakMethod(firmware.on_frame)
        self._firmware = weakref.ref(firmware)
        firmware.on_frame = self.on_frame
        self._pending.clear()

    def note(self, sender: Sender, frame: Frame) -> None:
        """A frame is on the bus."""
        arm = self._firmware()
        assert arm is not None
        offset = frame.arbitration_id - base_id(frame.arbitration_id)
        to_arm = offset == arm.addressing.control_offset
        said = Said(self._clock(), sender, frame, self.asked(), to_arm)
        self._pending.append(said)
        self.said.append(said)

    def on_frame(self, frame: Frame) -> list[Frame]:
        """Have the arm hear a frame, and see what it makes of it."""
        arm, on_frame = self._firmware(), self._on_frame()
        assert arm is not None
        assert on_frame is not None
        said = self._sender_of(frame)
        executor = arm._moves._executor
        before, order = _pursued(arm), executor._order
        moving, here = arm.mechanics.moving and before is not None, arm.reported_deg
        answers = on_frame(frame)
        goal = _pursued(arm)
        if goal is not None and arm.mechanics.moving and (not moving or executor._order != order):
            self.started.append(Started(said, moving, before or here, goal, here))
        return answers

    def _sender_of(self, frame: Frame) -> Said:
        now_s = self._clock()
        while self._pending and now_s - self._pending[0].at_s > _KEPT_S:
            self._pending.popleft()
        for place, said in enumerate(self._pending):
            if said.frame == frame:
                # the bus keeps the order: what was said before and has not come got lost, and an
                # equal frame that comes later is not that one
                for _ in range(place + 1):
                    self._pending.popleft()
                return said
        return Said(now_s, Sender.NOBODY, frame)


def _pursued(arm: Firmware) -> tuple[float, ...] | None:
    """Where the arm is on its way to, or None: nowhere."""
    executor = arm._moves._executor
    return executor.targets_deg if executor._legs and not executor.paused else None
