"""The arm to simulate in another process, and the messages of the hand at it."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Final

from armui.protocol.generation import Generation, PiperModel

HAND: Final = struct.Struct("<24s7d")
"""No name, six angles in degrees and a speed in degrees a second, of which 0 lets go; or the name
of a fault, its joint (0 for none) and 1 if it begins, 0 if it ends.
"""
LETS_GO: Final = (b"", *(0.0,) * 7)
"""The message of a hand that has let go."""


@dataclass(frozen=True, slots=True)
class ArmChoice:
    """The kind of arm to simulate, and where it lies at first.

    Attributes:
        generation: The protocol it speaks.
        model: The model of the family.
        version: Its firmware's version (generation 2), ``None`` for today's.
        joints_deg: The angles at which it lies, joint 1 first; ``None`` for the rest pose.
    """

    generation: Generation
    model: PiperModel = PiperModel.PIPER
    version: str | None = None
    joints_deg: tuple[float, ...] | None = None
