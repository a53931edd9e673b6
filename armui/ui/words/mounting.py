"""How an arm is mounted, in the operator's language."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.protocol.codes import Mounting

_MOUNTINGS: Final[Mapping[Mounting, object]] = {
    Mounting.UNCHANGED: QT_TRANSLATE_NOOP("Mounting", "Unchanged"),
    Mounting.LEVEL: QT_TRANSLATE_NOOP("Mounting", "Level"),
    Mounting.ON_THE_LEFT_SIDE: QT_TRANSLATE_NOOP("Mounting", "Left side"),
    Mounting.ON_THE_RIGHT_SIDE: QT_TRANSLATE_NOOP("Mounting", "Right side"),
    Mounting.UPSIDE_DOWN: QT_TRANSLATE_NOOP("Mounting", "Upside down"),
}


def mounting(how: Mounting) -> str:
    """How it is mounted («水平»)."""
    return QCoreApplication.translate("Mounting", str(_MOUNTINGS[how]))
