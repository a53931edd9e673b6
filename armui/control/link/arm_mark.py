"""The arm and the connection that something was shown, asked or checked for."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from armui.protocol.addressing import Addressing
from armui.protocol.generation import PiperModel

if TYPE_CHECKING:
    from armui.protocol.firmware_version import ArmIdentity


@dataclass(frozen=True, slots=True)
class ArmMark:
    """What tells one arm on one connection from another, as far as it was heard.

    A question, a check and a press keep the mark of their moment and are carried out only while
    :meth:`is_still` holds: another arm, or the same one after a silence, is another one.

    Attributes:
        connection: The number of the open device; 0 for none.
        arms: How many arms have come on this program's connections.
        heard: Whether the last of them is heard.
        model: As what it was chosen.
        addressing: The identifier offsets in use.
        identity: What it has said of itself; ``None`` while it has not.
    """

    connection: int = 0
    arms: int = 0
    heard: bool = False
    model: PiperModel = PiperModel.PIPER
    addressing: Addressing = field(default_factory=Addressing)
    identity: ArmIdentity | None = None

    def is_still(self, now: ArmMark) -> bool:
        """Return whether ``now`` is the same arm on the same connection; it may have said more."""
        before, after = self.identity, now.identity
        told_otherwise = before is not None and (after is None or before.contradicts(after))
        same = replace(self, identity=None) == replace(now, identity=None)
        return same and not told_otherwise
