"""What the figures of a lamp are called."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.ui.words.text import sentence

_LIGHTS: Final[Mapping[str, object]] = {
    "joint": QT_TRANSLATE_NOOP("LightFigure", "Joint number"),
    "lamp": QT_TRANSLATE_NOOP("LightFigure", "Lamp number"),
    "red": QT_TRANSLATE_NOOP("LightFigure", "R channel"),
    "green": QT_TRANSLATE_NOOP("LightFigure", "G channel"),
    "blue": QT_TRANSLATE_NOOP("LightFigure", "B channel"),
}


def light_figure(name: str) -> str:
    """What a figure of the light command is called: a key of ``lights.RANGES``."""
    return sentence("LightFigure", _LIGHTS.get(name, name), {})
