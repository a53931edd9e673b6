"""Decodes each frame received on a bus or read from a log, keeps it and tells the listeners."""

from __future__ import annotations

import logging
from collections import deque
from typing import TYPE_CHECKING, Final

from armui.arm.other_hosts import OtherHosts, OtherTraffic
from armui.arm.state import ArmState
from armui.arm.tracker import Tracker
from armui.bus.notifier import Notifier
from armui.bus.samples import SampleRing
from armui.protocol.codec import InvalidFrame, InvalidFrameKind, Message
from armui.protocol.frame import FrameFlag

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame
    from armui.telemetry.listener import Listener

_LOG: Final = logging.getLogger(__name__)

ANSWERS: Final = frozenset(
    {
        "SettingResponse",
        "LimitFeedback",
        "AccelerationFeedback",
        "EndLimitFeedback",
        "CollisionFeedback",
        "TeachingFeedback",
        "DragAssistanceFeedback",
    }
)
"""Messages that answer a request: each one is delivered, none is merged with another."""

_LAST_ANGLES: Final = "JointFeedback56"
"""The last of the three frames with the joint angles."""


class FrameProcessor:
    """Processes every received frame, in the thread that reads the bus or the log.

    Args:
        codec: The protocol to begin with; see :meth:`use_codec`.
        listeners: Objects that are told of every frame.
        answered: Called with each :class:`Message` of :data:`ANSWERS`.

    Attributes:
        codec: The codec in use.
        notifier: Tells the listeners.
        samples: Every joint feedback, while somebody wants them.
    """

    def __init__(
        self, codec: Codec, listeners: Sequence[Listener], answered: Callable[[Message], object]
    ) -> None:
        self.codec = codec
        self.notifier = Notifier(listeners)
        self.samples = SampleRing()
        self._answered = answered
        self._tracker = Tracker(codec)
        self._epoch = 0
        self._next_codecs: deque[tuple[Codec, int | None]] = deque()
        self._state = ArmState()
        self._others = OtherHosts()
        self._traffic = OtherTraffic()
        self._failed_ids: set[int] = set()

    @property
    def state(self) -> ArmState:
        """The arm's state from frames heard since the last :meth:`use_codec`, for any thread."""
        state, epoch = self._state, self._epoch
        return state if state.epoch == epoch else ArmState(epoch=epoch)

    @property
    def traffic(self) -> OtherTraffic:
        """Frames heard from other hosts; may be read from any thread."""
        return self._traffic

    def use_codec(self, codec: Codec, *, forget: bool = True) -> None:
        """Decode frames with this codec from the next one on; may be called from any thread.

        Args:
            codec: The codec to use.
            forget: From this call on :attr:`state` holds nothing that was heard or decoded before
                it. If false, the codec only decodes other hosts' frames in another way: it must be
                of the same generation and addressing.
        """
        if not forget:
            self._next_codecs.append((codec, None))
            return
        self._next_codecs.append((codec, self._epoch + 1))
        self._epoch += 1

    def apply_codec(self, now_s: float) -> None:
        """Switch to the codecs that :meth:`use_codec` asked for since the last call."""
        while self._next_codecs:
            before, (self.codec, epoch) = self.codec, self._next_codecs.popleft()
            self.notifier.switch(before, self.codec, now_s)
            if epoch is not None:
                self._tracker = Tracker(self.codec, epoch)

    def process(self, frame: Frame, at_s: float, flags: int) -> None:
        """Process a frame that this program did not send; one that fails is only counted.

        Args:
            frame: Identifier and payload.
            at_s: When it was received, by the program's clock.
            flags: Its `FrameFlag` bits.
        """
        try:
            self._process(frame, at_s, flags)
        except Exception:  # noqa: BLE001 - an error of ours must not end the reading
            self._count_failed(frame)

    def _process(self, frame: Frame, at_s: float, flags: int) -> None:
        # Most frames have no flags: the first test spares them the enum arithmetic, which costs as
        # much as all else here.
        if flags and flags & FrameFlag.ERROR:
            self.notifier.error_frame()
        else:
            self._others.note(frame.arbitration_id, frame.data, at_s)
        heard = (invalid_frame(frame, flags) if flags else None) or self.codec.decode(frame)
        self._tracker.update(heard, at_s)
        self.notifier.received.append((heard, at_s, frame, flags))
        if isinstance(heard, Message):
            if self.samples.wanted and heard.name == _LAST_ANGLES:
                self.samples.put(self._tracker.snapshot(), at_s)
            if heard.name in ANSWERS:
                self._answered(heard)

    def recall(self, frames: Sequence[tuple[Frame, float, int]]) -> None:
        """Set the state to the latest frame of each kind before a place in a log.

        No listener is told, and the time between these frames and the place does not count as
        silence.

        Args:
            frames: Each with its time and flags, in the order of time.
        """
        for frame, at_s, flags in frames:
            if flags & FrameFlag.ERROR:
                continue
            try:
                self._others.note(frame.arbitration_id, frame.data, at_s)
                heard = (invalid_frame(frame, flags) if flags else None) or self.codec.decode(frame)
                self._tracker.update(heard, at_s)
            except Exception:  # noqa: BLE001 - as in `process`
                self._count_failed(frame)
        self._tracker.reset_timeouts()
        self.publish()

    def _count_failed(self, frame: Frame) -> None:
        """Count a frame as invalid whose processing failed; log the first of each identifier.

        There may be thousands a second, and logging one takes a millisecond of the bus thread.
        """
        self._tracker.count_invalid(InvalidFrameKind.VALUE_OUTSIDE_TABLE)
        if frame.arbitration_id not in self._failed_ids:
            self._failed_ids.add(frame.arbitration_id)
            _LOG.exception(
                "a frame 0x%03X cannot be taken in; it is counted as invalid", frame.arbitration_id
            )

    def reset_other_hosts(self) -> None:
        """Forget what other hosts were heard to send."""
        self._others = OtherHosts()
        self._traffic = OtherTraffic()

    def publish(self) -> None:
        """Update :attr:`state` and :attr:`traffic` from the frames processed so far."""
        self._state = self._tracker.snapshot()
        self._traffic = self._others.traffic()


def invalid_frame(frame: Frame, flags: int) -> InvalidFrame | None:
    """Return the fault of a frame that is no classic data frame with an 11-bit identifier."""
    if flags & FrameFlag.ERROR:
        detail = "the adapter reports a bus error"
    elif flags & FrameFlag.EXTENDED:
        detail = "29-bit identifier"
    elif flags & FrameFlag.REMOTE:
        detail = "remote frame"
    elif flags & FrameFlag.IMPOSSIBLE:
        detail = "its parts contradict one another"
    else:
        return None
    return InvalidFrame(InvalidFrameKind.UNKNOWN_ID, frame.arbitration_id, detail)
