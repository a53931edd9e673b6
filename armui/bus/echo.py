"""Which of the frames that come in are only an echo of what this program has sent."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    import can

_MARKS_NEIGHBOURS: Final = frozenset({"socketcan"})
"""Back-ends that mark frames of other programs on the same PC as not received.

Linux sets MSG_DONTROUTE on every frame that was sent from this computer, by whichever program, and
python-can makes ``is_rx`` false of it. Our own frames do not come back at all: python-can opens the
socket without CAN_RAW_RECV_OWN_MSGS.
"""


def is_own_echo(message: can.Message, interface: str) -> bool:
    """Whether a frame is one of ours that the adapter hands back; nobody else has said it then."""
    return not message.is_rx and interface not in _MARKS_NEIGHBOURS
