"""A button that can be pressed, or says why not."""

from __future__ import annotations

from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QAbstractButton


def offer(button: QAbstractButton, hindrance: str, use: str = "", *, key: str = "") -> None:
    """Let a button be pressed, or switch it off with the reason in its tooltip.

    Args:
        button: What is offered.
        hindrance: Why it cannot be used now; empty: it can.
        use: What it does, for the tooltip of a button that can be pressed.
        key: Its shortcut, said after that.
    """
    button.setEnabled(not hindrance)
    if key:
        shown = QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText)
        use = f"{use} ({shown})"
    button.setToolTip(hindrance or use)
