"""The arms of the PiPER family, which speak the same frames."""

from __future__ import annotations

import enum
from typing import Final


class PiperModel(enum.StrEnum):
    """One arm of the family; its value is the name in files and on the command line."""

    PIPER = "piper"
    PIPER_H = "piper_h"
    PIPER_L = "piper_l"
    PIPER_X = "piper_x"


_MOST: Final = 1000
_LONGEST_NAME: Final = 4096


def are_models(value: object) -> bool:
    """Whether a value, read from a file, says of arms by name which models they are."""
    return (
        isinstance(value, dict)
        and len(value) <= _MOST
        and all(isinstance(name, str) and len(name) <= _LONGEST_NAME for name in value)
        and all(model in list(PiperModel) for model in value.values())
    )
