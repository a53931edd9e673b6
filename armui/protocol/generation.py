"""Which arm it is: the two generations of the protocol, and the family that speaks them."""

from __future__ import annotations

import enum


class PiperModel(enum.StrEnum):
    """One arm of the family; its value is the name in files and on the command line."""

    PIPER = "piper"
    PIPER_H = "piper_h"
    PIPER_L = "piper_l"
    PIPER_X = "piper_x"


class Generation(enum.IntEnum):
    """Which protocol an arm speaks: that of the manual, or that of today's firmware."""

    ONE = 1
    TWO = 2
