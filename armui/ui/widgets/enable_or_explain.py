"""A button that can be pressed, or says why not."""

from __future__ import annotations

from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QAbstractButton


def enable_or_explain(
    button: QAbstractButton, reason: str, use: str = "", *, key: str = ""
) -> None:
    """Let a button be pressed, or switch it off with the reason in its tooltip.

    Args:
        button: What is offered.
        reason: Why it cannot be used now; empty: it can.
        use: What it does, for the tooltip of a button that can be pressed.
        key: Its shortcut, said after that.
    """
    button.setEnabled(not reason)
    if key:
        shown = QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText)
        use = f"{use} ({shown})"
    button.setToolTip(reason or use)
