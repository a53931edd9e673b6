"""The two generations of the protocol, and the models of the family that speak them."""

from __future__ import annotations

import enum


class PiperModel(enum.StrEnum):
    """One model of the family; its value is its name in files and on the command line."""

    PIPER = "piper"
    PIPER_H = "piper_h"
    PIPER_L = "piper_l"
    PIPER_X = "piper_x"


class Generation(enum.IntEnum):
    """The protocol an arm speaks: that of the manual, or that of today's firmware."""

    ONE = 1
    TWO = 2
