"""What frames on the bus are called, who sends them, and what is odd about one."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.control.safety.hand_frame import is_upgrade
from armui.protocol.codec import InvalidFrameKind
from armui.protocol.frame import FrameFlag
from armui.telemetry.bus_errors import BusError
from armui.telemetry.bus_senders import Sender
from armui.ui.words.signals import signal_name
from armui.ui.words.text import Texts, sentence

if TYPE_CHECKING:
    from armui.protocol.codec import Codec, InvalidFrame

_SENDERS: Final = Texts("Sender") | {
    Sender.ARM: "arm",
    Sender.OWN: "this program",
    Sender.OTHER: "another host",
    Sender.OTHER_ARM: "another arm",
    Sender.ADAPTER: "adapter",
    Sender.UNKNOWN: "not known",
}

_ERRORS: Final = Texts("BusError") | {
    BusError.SEND_TIMEOUT: "a frame could not be sent in time",
    BusError.ARBITRATION_LOST: (
        "arbitration lost: a frame of higher rank came first, which is normal"
    ),
    BusError.CONTROLLER: "the adapter's CAN controller reports",
    BusError.RECEIVE_OVERFLOW: (
        "the adapter has lost frames: too slow for this bus, or its USB port is"
    ),
    BusError.SEND_OVERFLOW: "the adapter has lost frames to be sent",
    BusError.MANY_ERRORS: "many errors: check the cable and both terminating resistors (120 Ω)",
    BusError.ERROR_PASSIVE: (
        "error passive: check CAN_H and CAN_L, both terminating resistors and the bit rate"
    ),
    BusError.ERROR_ACTIVE: "the errors have become few again",
    BusError.PROTOCOL: "disturbed frame: check the cable, its shield, and the bit rate",
    BusError.TRANSCEIVER: "transceiver: check CAN_H and CAN_L for a short or an open line",
    BusError.NO_ACKNOWLEDGE: (
        "nobody acknowledges: check the arm's power, the cable and the bit rate"
    ),
    BusError.BUS_OFF: (
        "bus off: too many errors, the adapter takes no part. Check the cable, both terminating "
        "resistors (120 Ω) and the bit rate, then connect again"
    ),
    BusError.BUS_ERROR: "error on the bus: check the cable",
    BusError.RESTARTED: "the adapter takes part again",
}


def frame_sender(sender: Sender, *, leader: bool = False) -> str:
    """Who sends a frame.

    Args:
        sender: By its identifier.
        leader: The other host is known for a leader arm (0x470).
    """
    if leader and sender is Sender.OTHER:
        return QCoreApplication.translate("Sender", "leader arm")
    return _SENDERS.text(sender)


def frame_id(arbitration_id: int, flags: int) -> str:
    """An identifier as it is written: three figures, eight for one of 29 bits."""
    kind = flags & (FrameFlag.EXTENDED | FrameFlag.ERROR)
    return f"0x{arbitration_id:0{8 if kind == FrameFlag.EXTENDED else 3}X}"


def frame_kind(arbitration_id: int, flags: int, codec: Codec | None) -> str:
    """What a frame is that no message of the protocol has."""
    if flags & FrameFlag.ERROR:
        return QCoreApplication.translate("FrameKind", "Error frame of the adapter")
    if flags & FrameFlag.REMOTE:
        return QCoreApplication.translate("FrameKind", "Remote frame: a question without data")
    if flags & FrameFlag.FD:
        return QCoreApplication.translate("FrameKind", "CAN FD frame: the arm speaks classic CAN")
    if flags & FrameFlag.EXTENDED:
        return QCoreApplication.translate("FrameKind", "29-bit identifier: the arm knows none")
    if is_upgrade(arbitration_id):
        return QCoreApplication.translate("FrameKind", "Firmware upgrade: not documented")
    if codec is not None and codec.addressing.from_wire(arbitration_id) is None:
        return QCoreApplication.translate("FrameKind", "Of an arm with other identifiers (0x470)")
    return QCoreApplication.translate("FrameKind", "Unknown: not in the tables of this arm")


def bus_errors(errors: tuple[BusError, ...]) -> str:
    """What an error frame says, with what to do about it."""
    if not errors:
        return QCoreApplication.translate("BusError", "the adapter tells no more")
    return "; ".join(_ERRORS.text(e) for e in errors)


def why_invalid(invalid: InvalidFrame, length: int, codec: Codec) -> str:
    """What is wrong with a frame that has a message's identifier.

    Args:
        invalid: As the codec found it.
        length: Of its payload.
        codec: Who found it.
    """
    layout = codec.layout(invalid.arbitration_id)
    if layout is None:
        return frame_kind(invalid.arbitration_id, 0, codec)
    if invalid.kind is InvalidFrameKind.WRONG_LENGTH:
        source = QT_TRANSLATE_NOOP("InvalidFrame", "{count} bytes instead of {wanted}")
        wanted = " / ".join(str(each) for each in layout.lengths)
        return sentence("InvalidFrame", source, {"count": length, "wanted": wanted})
    if invalid.message is None:
        return QCoreApplication.translate("InvalidFrame", "it names a joint that no arm has")
    values = invalid.message.signals
    odd = [
        f"{signal_name(name)} = {values[name]:.10g}"
        for name, legal in layout.checked
        if name in values
        if round(layout.signals[name].to_steps(values[name])) not in legal
    ]
    source = QT_TRANSLATE_NOOP("InvalidFrame", "outside its table: {signals}")
    return sentence("InvalidFrame", source, {"signals": ", ".join(odd)})
