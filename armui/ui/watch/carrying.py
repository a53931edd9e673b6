"""Quantities on their way into a plot, by the mouse."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QMimeData, Qt
from PySide6.QtGui import QDrag

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

MIME: Final = "application/x-armui-quantities"
"""Keys of quantities, one a line; a plot they are taken from stands behind a tab."""


def mime_of(keys: Sequence[str], plot: int | None = None) -> QMimeData:
    """Quantities on their way into a plot."""
    data = QMimeData()
    text = "\n".join(keys) if plot is None else "\n".join(f"{key}\t{plot}" for key in keys)
    data.setData(MIME, text.encode())
    return data


def from_mime(data: QMimeData) -> tuple[list[str], int | None]:
    """Which quantities come, and from which plot; none of what is anything else."""
    if not data.hasFormat(MIME):
        return [], None
    lines = bytes(data.data(MIME).data()).decode("utf-8", "replace").splitlines()
    parts = [line.partition("\t") for line in lines]
    plots = {plot for _key, _tab, plot in parts}
    plot = next(iter(plots)) if len(plots) == 1 else ""
    return [key for key, _tab, _plot in parts], int(plot) if plot.isdecimal() else None


def carry_away(source: QWidget, keys: Sequence[str], plot: int | None = None) -> None:
    """Let the operator drop quantities somewhere; returns when they are dropped."""
    drag = QDrag(source)
    drag.setMimeData(mime_of(keys, plot))
    drag.exec(Qt.DropAction.MoveAction if plot is not None else Qt.DropAction.CopyAction)
