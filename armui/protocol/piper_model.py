"""The arms of the PiPER family, which speak the same frames."""

from __future__ import annotations

import enum


class PiperModel(enum.StrEnum):
    """One arm of the family; its value is the name in files and on the command line."""

    PIPER = "piper"
    PIPER_H = "piper_h"
    PIPER_L = "piper_l"
    PIPER_X = "piper_x"
