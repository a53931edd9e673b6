"""How an arm is mounted, in the operator's language."""

from __future__ import annotations

from typing import Final

from armui.protocol.codes import Mounting
from armui.ui.words.text import Texts

_MOUNTINGS: Final = Texts("Mounting") | {
    Mounting.UNCHANGED: "Unchanged",
    Mounting.LEVEL: "Level",
    Mounting.ON_THE_LEFT_SIDE: "Left side",
    Mounting.ON_THE_RIGHT_SIDE: "Right side",
    Mounting.UPSIDE_DOWN: "Upside down",
}


def mounting(how: Mounting) -> str:
    """How it is mounted («水平»)."""
    return _MOUNTINGS.text(how)
