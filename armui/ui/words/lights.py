"""What the figures of a lamp are called."""

from __future__ import annotations

from typing import Final

from armui.ui.words.text import Texts

_LIGHTS: Final = Texts("LightFigure") | {
    "joint": "Joint number",
    "lamp": "Lamp number",
    "red": "R channel",
    "green": "G channel",
    "blue": "B channel",
}


def light_figure(name: str) -> str:
    """What a figure of the light command is called: a key of ``lights.RANGES``."""
    return _LIGHTS.word(name)
