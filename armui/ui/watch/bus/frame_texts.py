"""A row of the statistics as the operator reads it: name, signals, what is odd about it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.control.safety.hand_frame import command_id
from armui.protocol.codec import Codec, Message
from armui.protocol.frame import Frame, FrameFlag
from armui.telemetry.bus_errors import errors_of
from armui.telemetry.quantities import quantity_key
from armui.ui.words import frames
from armui.ui.words.messages import message_name
from armui.ui.words.signals import signal_name, signal_value

if TYPE_CHECKING:
    from armui.protocol.addressing import Addressing
    from armui.protocol.firmware_version import FirmwareVersion
    from armui.protocol.generation import Generation
    from armui.telemetry.bus_senders import Sender
    from armui.telemetry.bus_statistics import FrameRow

_LEADER: Final = frozenset({0x151, 0x155, 0x156, 0x157, 0x159})
"""What a leader arm sends (0x470)."""
_NOT_OF_THE_ARM: Final = FrameFlag.EXTENDED | FrameFlag.REMOTE | FrameFlag.ERROR | FrameFlag.FD


@dataclass(frozen=True, slots=True)
class SignalText:
    """One signal of a frame, decoded.

    Attributes:
        name: What it is called.
        value: With its unit, or its word.
        key: Of the quantity it is drawn as; ``None``: it is not kept.
    """

    name: str
    value: str
    key: str | None


class FrameTexts:
    """Reads frames as the arm's protocol has them.

    Attributes:
        codec: How frames are decoded; ``None`` before the first device. A codec of its own: that of
            the bus thread remembers what comes next.
        interface: python-can's name of the back-end.
        leader: The other host is known for a leader arm (0x470).
    """

    def __init__(self) -> None:
        self.codec: Codec | None = None
        self.interface = ""
        self.leader = False
        self._words: dict[tuple[int, int], str] = {}

    def speak(self, codec: Codec | None) -> bool:
        """Read frames as another codec does; whether it differs from the one before."""
        known, wanted = _spoken(self.codec), _spoken(codec)
        if known == wanted:
            return False
        self.codec = None if wanted is None else Codec(*wanted)
        self._words.clear()
        return True

    def retranslate(self) -> None:
        """The words are other ones."""
        self._words.clear()

    def message(self, arbitration_id: int, flags: int) -> str | None:
        """The name in the DBC files of a frame's message; ``None``: it has none."""
        if flags & _NOT_OF_THE_ARM or self.codec is None:
            return None
        layout = self.codec.layout(arbitration_id)
        return None if layout is None else layout.name

    def name(self, arbitration_id: int, flags: int) -> str:
        """What a frame is called."""
        message = self.message(arbitration_id, flags)
        if message is not None:
            return message_name(message)
        return frames.frame_kind(arbitration_id, flags, self.codec)

    def words(self, row: FrameRow) -> str:
        """All that a text may be looked for in."""
        key = row.arbitration_id, row.flags
        found = self._words.get(key)
        if found is None:
            identifier = frames.frame_id(*key)
            found = f"{identifier} {self.message(*key) or ''} {self.name(*key)}"
            self._words[key] = found
        return found

    def sender(self, sender: Sender, arbitration_id: int) -> str:
        """Who sends it."""
        leads = self.leader and command_id(arbitration_id) in _LEADER
        return frames.frame_sender(sender, leader=leads)

    def signals(
        self, arbitration_id: int, flags: int, data: bytes, sender: Sender
    ) -> list[SignalText]:
        """What a frame says; nothing where it can't be read."""
        codec = self.codec
        if codec is None or flags & _NOT_OF_THE_ARM:
            return []
        layout = codec.layout(arbitration_id)
        decoded = codec.decode(Frame(arbitration_id, data))
        message = decoded if isinstance(decoded, Message) else decoded.message
        if layout is None or message is None:
            return []
        return [
            SignalText(
                signal_name(name),
                signal_value(signal, message.signals[name]),
                quantity_key(sender, layout.name, name),
            )
            for name, signal in layout.signals.items()
            if name in message.signals
        ]

    def trouble(self, row: FrameRow) -> str:
        """Why frames of a row do not follow the protocol; "" if all of them do."""
        if row.flags & FrameFlag.ERROR:
            return frames.bus_errors(errors_of(row.arbitration_id, row.data, self.interface))
        if row.invalid is None:
            return ""
        if self.codec is None or row.flags or self.codec.layout(row.arbitration_id) is None:
            return frames.frame_kind(row.arbitration_id, row.flags, self.codec)
        return frames.why_invalid(row.invalid, row.invalid_length, self.codec)


def _spoken(codec: Codec | None) -> tuple[Generation, Addressing, FirmwareVersion | None] | None:
    """What makes a codec read frames as it does."""
    return None if codec is None else (codec.generation, codec.addressing, codec.firmware)
