"""A progress bar without figures, hidden until it is used."""

from __future__ import annotations

from PySide6.QtWidgets import QProgressBar


def quiet_progress() -> QProgressBar:
    """Return a hidden bar without figures that keeps its place, so that nothing below it moves."""
    bar = QProgressBar(textVisible=False)
    policy = bar.sizePolicy()
    policy.setRetainSizeWhenHidden(True)
    bar.setSizePolicy(policy)
    bar.hide()
    return bar
