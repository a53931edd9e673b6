"""The mark of the arm and the connection for which something was shown, asked or checked."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from armui.protocol.addressing import Addressing
from armui.protocol.generation import PiperModel

if TYPE_CHECKING:
    from armui.protocol.firmware_version import ArmIdentity


@dataclass(frozen=True, slots=True)
class ArmMark:
    """The facts that distinguish one arm on one connection from another.

    A question, a check and a press keep the mark of their moment and are carried out only while
    :meth:`is_still` holds: another arm, or the same one after a silence, has another mark.

    Attributes:
        connection: The number of the open device, or 0.
        arms: The number of arms that have come online so far.
        heard: True if the last of them is heard.
        model: The model that the operator has chosen.
        addressing: The identifier offsets in use.
        identity: The identity the arm has reported, or ``None``.
    """

    connection: int = 0
    arms: int = 0
    heard: bool = False
    model: PiperModel = PiperModel.PIPER
    addressing: Addressing = field(default_factory=Addressing)
    identity: ArmIdentity | None = None

    def is_still(self, now: ArmMark) -> bool:
        """Return whether ``now`` is the same arm on the same connection; it may know more of it."""
        before, after = self.identity, now.identity
        told_otherwise = before is not None and (after is None or before.contradicts(after))
        same = replace(self, identity=None) == replace(now, identity=None)
        return same and not told_otherwise
