"""Notes every change of a status for the event log, in the bus thread, however brief."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from armui.arm.limits import JOINTS
from armui.arm.state import FRESH_FOR_S
from armui.protocol.codec import Message
from armui.telemetry.listener import Listener

if TYPE_CHECKING:
    from armui.protocol.codec import Codec
    from armui.protocol.generation import Generation
    from armui.telemetry.listener import ReceivedFrame

STATUS: Final = "ArmStatus"
GRIPPER: Final = "GripperFeedback"
GAP: Final = "gap"
"""The name for a silence of over half a second: afterwards another arm may report."""
RATE: Final = "rate"
"""The name for the number of status frames per second."""

RATE_SPAN_S: Final = 2.0
"""The time over which the frames are counted."""
_MOST_WAITING: Final = 5_000
"""More changes than these push out the oldest, so that memory stays bounded."""

DRIVERS: Final[Mapping[str, int]] = {f"DriverSlow{joint}": joint for joint in JOINTS}
DRIVER_FLAGS: Final = (
    *("Undervoltage", "MotorOvertemperature", "Overcurrent", "DriverOvertemperature"),
    *("DriverFault", "Enabled", "SensorFault", "CollisionProtection", "StallProtection"),
)
_STATUS_CODES: Final = ("ControlMode", "Status", "MoveMode", "TeachingState", "MotionState")
_STATUS_FLAGS: Final = tuple(
    f"J{joint}{what}" for what in ("CommunicationFault", "LimitExceeded") for joint in JOINTS
)
_GRIPPER_FLAGS: Final = (
    *("Undervoltage", "MotorOvertemperature", "Overcurrent", "DriverOvertemperature"),
    *("SensorFault", "DriverFault"),
)
WATCHED: Final[Mapping[str, tuple[str, ...]]] = {
    STATUS: (*_STATUS_CODES, *_STATUS_FLAGS),
    GRIPPER: _GRIPPER_FLAGS,
    **dict.fromkeys(DRIVERS, DRIVER_FLAGS),
}
"""The signals of each message whose changes are events."""
_COMMON: Final = WATCHED[STATUS][: len(_STATUS_CODES) + len(JOINTS)]
"""The signals of the status that both generations have."""


@dataclass(frozen=True, slots=True)
class StatusChange:
    """A status that differs from the last.

    Attributes:
        at_s: When its frame was received.
        name: The name of the message, or `GAP`, or `RATE`.
        values: The values of the signals of `WATCHED`, as far as the generation has them.
    """

    at_s: float
    name: str
    values: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class InvalidFrames:
    """Frames of one sort that could not be decoded.

    Attributes:
        sort: The name of the sort.
        arbitration_id: The identifier of the last one.
        times: The number of frames.
        first_s, last_s: The monotonic times of the first and the last.
    """

    sort: str
    arbitration_id: int
    times: int
    first_s: float
    last_s: float


class StatusListener(Listener):
    """Notes changes in the bus thread; the controller's tick takes them away.

    An arm repeats most frames, and equal bytes share one decoded message: they cost one comparison.
    """

    def __init__(self) -> None:
        self._latest: dict[str, Any] = {}
        self._values: dict[str, tuple[float | None, ...]] = {}
        self._changes: deque[StatusChange | InvalidFrames] = deque(maxlen=_MOST_WAITING)
        self._invalid: dict[str, InvalidFrames] = {}
        self._generation: Generation | None = None
        self._codec: Codec | None = None
        self._last_s: float | None = None
        self._count = 0
        self._counted_s: float | None = None

    def take_changes(self) -> list[StatusChange | InvalidFrames]:
        """Return the changes noted since the last call; called by the controller's thread."""
        changes = []
        while self._changes:
            changes.append(self._changes.popleft())
        return changes

    def know_generation(self, generation: Generation | None) -> None:
        """Take the arm's generation, by which further signals are compared from now on."""
        if generation is not self._generation:
            self._generation = generation
            self._latest = {}

    # The bus thread ---------------------------------------------------------------------------

    def on_open(self, _bitrate: int | None) -> None:
        """Forget the last status: another device was opened, or the same again."""
        self._begin_anew()
        self._last_s = None

    def on_codec(self, codec: Codec) -> None:
        """Forget the last status: the same bytes may mean something else with another codec."""
        self._codec = codec
        self._latest = {}

    def on_heard(self, batch: Sequence[ReceivedFrame]) -> None:
        """Note the changes in a batch of frames."""
        latest = self._latest
        for heard, at_s, frame, _flags in batch:
            if isinstance(heard, Message):
                message = heard
            else:
                self._note_invalid(heard.kind.name, frame.arbitration_id, at_s)
                if heard.message is None:
                    continue
                message = heard.message
            name = message.name
            if name not in WATCHED:
                continue
            if self._last_s is not None and at_s - self._last_s > FRESH_FOR_S:
                self._changes.append(StatusChange(self._last_s, GAP, {}))
                self._begin_anew()
                latest = self._latest
            self._last_s = at_s
            if name == STATUS:
                self._note_rate(at_s)
            if latest.get(name) is not heard and (name == STATUS or self._understands):
                latest[name] = heard
                self._note(name, message.signals, at_s)

    @property
    def _understands(self) -> bool:
        """True if the generation is known, so that bits which both use differently can be read."""
        codec = self._codec
        return codec is not None and codec.generation is self._generation

    def _begin_anew(self) -> None:
        self._latest = {}
        self._values.clear()
        self._counted_s = None

    def _note(self, name: str, signals: Mapping[str, float], at_s: float) -> None:
        watched = WATCHED[name]
        if name == STATUS and not self._understands:
            watched = _COMMON
        values = tuple([signals.get(each) for each in watched])
        if values != self._values.get(name):
            self._values[name] = values
            named = zip(watched, values, strict=True)
            told = {each: value for each, value in named if value is not None}
            self._changes.append(StatusChange(at_s, name, told))

    def _note_rate(self, at_s: float) -> None:
        counted_s = self._counted_s
        if counted_s is None:
            self._counted_s, self._count = at_s, 0
            return
        self._count += 1
        if at_s - counted_s >= RATE_SPAN_S:
            self._changes.append(StatusChange(at_s, RATE, {"hz": self._count / (at_s - counted_s)}))
            self._counted_s, self._count = at_s, 0

    def _note_invalid(self, kind: str, arbitration_id: int, at_s: float) -> None:
        before = self._invalid.get(kind)
        count, first_s = (0, at_s) if before is None else (before.times, before.first_s)
        self._invalid[kind] = InvalidFrames(kind, arbitration_id, count + 1, first_s, at_s)

    def on_look(self, _now_s: float) -> None:
        """Pass on the invalid frames counted so far."""
        if self._invalid:
            self._changes.extend(self._invalid.values())
            self._invalid.clear()
